"""Smoke of a scene as puffs of air: its objects only say where it is and how large."""

from __future__ import annotations

import math
from collections.abc import Iterable

import bpy
import numpy as np
from mathutils import Vector

from storyblender.look.smoke import Puff
from storyblender.memory.base import Color

_PUFFS = 18
"""Puffs of one column of smoke."""
_TURN = 2.4
"""Radians from puff to puff: the golden angle spreads them evenly."""


def puffs_of(objects: Iterable[bpy.types.Object]) -> list[Puff]:
    """Return the puffs that show smoke as air.

    Args:
        objects: Smoke of the scene, as it is seen.
    """
    return [puff for obj in objects for puff in _puffs(obj)]


def _puffs(obj: bpy.types.Object) -> list[Puff]:
    """Return the puffs that fill an object's box, rising and spreading."""
    corners = np.array([obj.matrix_world @ Vector(corner) for corner in obj.bound_box])
    low, size = corners.min(axis=0), np.ptp(corners, axis=0)
    width = float(max(size[:2].min(), 0.1))
    found: list[Puff] = []
    for step in range(_PUFFS):
        up = (step + 0.5) / _PUFFS
        reach, angle = 0.08 + 0.26 * up, _TURN * step
        middle = low + size / 2
        x = middle[0] + reach * size[0] * math.cos(angle)
        y = middle[1] + reach * size[1] * math.sin(angle)
        found.append(Puff((float(x), float(y), float(low[2] + up * size[2])), width * (0.3 + 0.3 * up), _color(obj)))
    return found


def _color(obj: bpy.types.Object) -> Color:
    red, green, blue, _ = obj.data.materials[0].diffuse_color
    return (red, green, blue)
