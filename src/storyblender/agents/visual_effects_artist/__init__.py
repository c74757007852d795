"""The Visual Effects Artist: set, dressing, light and motion (paper, section 3.4)."""
