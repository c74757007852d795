"""Measures built geometry: hashes, tops, views."""
