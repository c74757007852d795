"""Far off, a fine repeated pattern (courses of brick, floorboards, tiles) would beat with the pixels: it fades there.

Textures are read without mipmaps, so a joint thinner than a pixel shows here and not there, and the eye sees waves.
What the eye would see is the mean of the pattern.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from storyblender.look.gbuffer import View

_WHOLE = 8.0
"""Pixels of the buffer that one repeat covers where it begins to fade."""
_GONE = 3.0
"""Pixels of the buffer that one repeat covers where it has faded."""
_LEFT = 0.12
"""Contrast that stays: a brick wall is never quite a painted one."""
_STEEPEST = 0.12
"""Least cosine between a surface and the eye that counts; beyond it everything has faded anyway."""


def fade_repeats(
    albedo: NDArray[np.float16],
    material: NDArray[np.uint16],
    depth: NDArray[np.float32],
    normal: NDArray[np.float16],
    view: View,
    repeats: NDArray[np.float32],
    means: NDArray[np.float32],
) -> None:
    """Turn the albedo, in place, to the mean of its material where the pattern is too fine for the pixels.

    Args:
        albedo: (h, w, 3).
        material: (h, w) index into the last two.
        depth: (h, w) metres.
        normal: (h, w, 3) world, unit.
        view: The camera, of this size.
        repeats: (materials,) metres of the pattern's repeat, 0 for none.
        means: (materials, 3) mean albedo.
    """
    focus = view.pixels_per_metre
    first = np.where(repeats > 0, repeats * np.float32(focus / _WHOLE * np.sqrt(_STEEPEST)), np.float32(np.inf))
    at = np.flatnonzero(depth > first[material])
    if not len(at):
        return
    rows, columns = np.divmod(at, view.width)
    made, away = material.take(at), depth.take(at)
    # A repeat covers fewer pixels the more its surface is turned away: by the root, as one direction keeps its size.
    toward = cosine(normal.reshape(-1, 3)[at].astype(np.float32), rows, columns, view)
    covered = repeats[made] * np.float32(focus) / away * np.sqrt(np.maximum(toward, np.float32(_STEEPEST)))
    kept = _LEFT + (1 - _LEFT) * np.clip((covered - _GONE) / (_WHOLE - _GONE), 0, 1)
    flat = albedo.reshape(-1, 3)
    mean = means[made]
    flat[at] = mean + (flat[at] - mean) * kept[:, None]


def cosine(
    normal: NDArray[np.float32], rows: NDArray[np.intp], columns: NDArray[np.intp], view: View
) -> NDArray[np.float32]:
    """Return how much surfaces with (n, 3) normals face the eye, at these pixels."""
    x, y = view.slopes()
    right, up, back = (normal @ axis for axis in view.axes.T.astype(np.float32))
    across, climb = x[columns], y[rows]
    return np.abs(right * across + up * climb - back) / np.sqrt(across * across + climb * climb + 1)
