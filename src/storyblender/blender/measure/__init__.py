"""Measures built geometry and scenes: hashes, tops, collisions, faces, camera views."""
