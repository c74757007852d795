"""How people carry themselves: facial expressions, gaze, lasting activities, grips on things, and tethers."""
