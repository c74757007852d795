"""Parametric props: one builder a key of ``catalog.props``."""
