"""The Concept Artist: every asset becomes canonical geometry (paper, section 3.3)."""
