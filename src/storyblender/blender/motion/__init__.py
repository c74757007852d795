"""The motion solver: marks and cues in, keyframes out."""
