"""The Layout Artist: sizes, places and cameras (paper, section 3.4)."""
