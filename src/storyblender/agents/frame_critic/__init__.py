"""The Frame Critic: does a finished frame show what the lines of its shot say?"""
