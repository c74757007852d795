"""Clothed, rigged people from MakeHuman CC0 data."""
