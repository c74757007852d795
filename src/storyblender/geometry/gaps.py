"""Empty room between the people of a picture."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

MAX_FACE_GAP = 7.5
"""Heads between two neighbours from which the middle of a picture of them is empty."""


def widest_face_gap(faces: Sequence[tuple[float, float]], aspect: float) -> float:
    """Return the widest gap between neighbouring faces of a picture, in heights of the largest head.

    Args:
        faces: Screen x of each face, and the height of its head as a share of the picture's.
        aspect: Width of the picture by its height.
    """
    across = sorted(x for x, _ in faces)
    largest = max((head for _, head in faces), default=0.0)
    gap = max((right - left for left, right in pairwise(across)), default=0.0)
    return gap * aspect / largest if largest > 0 else 0.0
