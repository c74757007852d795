"""The pages of a script: its scenes and its sentences."""
