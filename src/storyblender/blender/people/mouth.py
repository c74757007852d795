"""The inside of the mouth, painted: a dark hollow with a band of upper teeth instead of a white block.

Little light gets past the lips, and light computed at a quarter of the picture's size cannot show it; so shade is
paint.
"""

from __future__ import annotations

import numpy as np

from storyblender.blender.people.face import base_tree
from storyblender.blender.people.pack import BodyPack
from storyblender.geometry.solids import Floats

HOLLOW = (0.030, 0.009, 0.008)
"""Colour of the throat, scene-linear."""
TONGUE = (0.15, 0.045, 0.04)
TOOTH = (0.47, 0.44, 0.38)
_LOWER = 0.22
"""Brightness of the lower row: the lip shades it, and two bright rows read as one block."""
_BACK, _FRONT = 1.05, 1.48
"""Depth of the last and of the first tooth on the base mesh, decimetres."""
_SHALLOW, _DEEP = 0.01, 0.06
"""Decimetres behind the visible surface at which the shade begins and is full."""


def mouth_depth(pack: BodyPack, base: Floats) -> Floats:
    """Return how far inside the mouth points of the base mesh lie, (V,): 0 on the face and lips, 1 behind the lips.

    Args:
        pack: The body data.
        base: (V, 3) positions on the base mesh, decimetres.
    """
    tree, _ = base_tree(pack)
    inside = np.zeros(len(base))
    near = (np.abs(base[:, 0]) < 0.36) & (np.abs(base[:, 1] - 6.6) < 0.26) & (base[:, 2] > 0.5)
    for vertex in np.flatnonzero(near):
        x, y, depth = base[vertex].tolist()
        hit = tree.ray_cast((x, y, 5.0), (0.0, 0.0, -1.0))[0]
        if hit is not None:
            inside[vertex] = np.interp(hit.z - depth, (_SHALLOW, _DEEP), (0, 1))
    return inside


def paint_teeth(base: Floats) -> Floats:
    """Return the colours (V, 3) of teeth at base mesh points, lower row first: light upper front, rest in shade."""
    light = np.interp(base[:, 2], (_BACK, _FRONT), (0.1, 1.0))
    light[: len(base) // 2] *= _LOWER
    return light[:, None] * np.array(TOOTH)
