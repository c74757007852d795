"""Far off, a picture on a wall is finer than the pixels: what is seen is a coarser copy of it, and in the end its mean.

Textures are read without mipmaps, so a whole picture would swarm there, and beat with the pixels.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from storyblender.look.fading import cosine
from storyblender.look.gbuffer import View

HALVINGS = (2, 4)
"""How many times each coarser copy of a picture is halved."""
_EARLY = 0.5
"""Halvings before a copy would have one pixel for each of the frame: a little softness shows less than swarming."""
_GONE = 7.0
"""Halvings at which only the mean is seen."""
_STEEPEST = 0.08
"""Least cosine between a surface and the eye that counts."""


def halvings(
    texels: NDArray[np.float32],
    depth: NDArray[np.float32],
    normal: NDArray[np.float32],
    rows: NDArray[np.intp],
    columns: NDArray[np.intp],
    view: View,
) -> NDArray[np.float32]:
    """Return how many times the pictures at these pixels are to be halved; at most 0 where they are seen whole.

    Args:
        texels: (n,) of each picture, to the metre.
        depth: (n,) metres.
        normal: (n, 3) world, unit.
        rows: (n,) of the pixels.
        columns: (n,) of the pixels.
        view: The camera, of this size.
    """
    toward = np.maximum(cosine(normal, rows, columns, view), np.float32(_STEEPEST))
    return np.log2(texels * depth / (view.pixels_per_metre * np.sqrt(toward))) + np.float32(_EARLY)


def shares(wanted: NDArray[np.float32]) -> list[NDArray[np.float32]]:
    """Return the (n,) share of the whole picture, of each of its coarser copies, and of its mean; they sum to one.

    Args:
        wanted: (n,) halvings.
    """
    places = (0.0, *map(float, HALVINGS), _GONE)
    found = [np.zeros_like(wanted) for _ in places]
    held = np.clip(wanted, 0, _GONE)
    for index, (low, high) in enumerate(pairwise(places)):
        here = (held >= low) & ((held < high) | (high == _GONE))
        part = (held - low) / np.float32(high - low)
        found[index][here], found[index + 1][here] = (1 - part)[here], part[here]
    return found
