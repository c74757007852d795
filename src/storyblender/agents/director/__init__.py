"""The Director: script in, skeleton of the Continuity Memory Graph out (paper, section 3.2)."""
