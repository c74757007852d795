"""Bearing of people: facial expressions, gaze, lasting activities, grips on things, and tethers."""
