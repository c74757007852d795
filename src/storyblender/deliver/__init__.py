"""Deliverables: board, shot list, timeline, animatic, page."""
