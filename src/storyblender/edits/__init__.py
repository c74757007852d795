"""Edits: data that becomes one commit, checked against the graph, and can be taken back."""
