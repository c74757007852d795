"""What is printed on a poster: a picture of few flat shapes over lines of type."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder

DESIGNS = 4
Outline = Sequence[tuple[float, float]] | np.ndarray
_INK = 0.001
"""Metres that a colour lies above what is printed before it."""


class Inks(NamedTuple):
    """Materials of a print: its picture's ground, the large shape, and the small one with the type."""

    ground: MaterialRef
    shape: MaterialRef
    accent: MaterialRef


def print_sheet(b: MeshBuilder, inks: Inks, width: float, height: float, y: float, design: int) -> None:
    """Print a sheet that faces -Y and stands on z = 0.

    Args:
        b: Receives the print.
        inks: Materials.
        width: Metres.
        height: Metres.
        y: Of the sheet's front.
        design: 0 to ``DESIGNS`` - 1: a mountain, a sun over the sea, a head and shoulders, a bottle in a disc.
    """
    layer = iter(y - _INK * step for step in range(1, 12))

    def area(ink: MaterialRef, outline: Outline) -> None:
        at = next(layer)
        b.polygon(ink, [(float(x) * width, at, float(z) * height) for x, z in outline])

    area(inks.ground, _box(0.0, 0.64, 0.9, 0.64))
    if design == 0:
        area(inks.accent, _disc(-0.22, 0.82, 0.09, width / height))
        area(
            inks.shape,
            [(-0.45, 0.36), (0.45, 0.36), (0.45, 0.5), (0.12, 0.86), (-0.14, 0.56), (-0.24, 0.64), (-0.45, 0.44)],
        )
    elif design == 1:
        area(inks.accent, _disc(0.0, 0.66, 0.24, width / height))
        for row in range(3):
            area(inks.shape, _box(0.0, 0.36 + 0.1 * row, 0.9, 0.035))
    elif design == 2:
        area(inks.shape, [(-0.34, 0.33), (0.34, 0.33), (0.3, 0.5), (0.1, 0.58), (-0.1, 0.58), (-0.3, 0.5)])
        area(inks.shape, _disc(0.0, 0.7, 0.17, width / height))
        area(inks.accent, _box(0.0, 0.815, 0.5, 0.025))
    else:
        area(inks.accent, _disc(0.0, 0.63, 0.36, width / height))
        area(
            inks.shape,
            [
                (-0.1, 0.4),
                (0.1, 0.4),
                (0.1, 0.66),
                (0.035, 0.72),
                (0.035, 0.86),
                (-0.035, 0.86),
                (-0.035, 0.72),
                (-0.1, 0.66),
            ],
        )
    for row, wide in enumerate((0.8, 0.58, 0.66)):
        area(inks.accent if row == 0 else inks.ground, _box(0.0, 0.25 - 0.075 * row, wide, 0.06 if row == 0 else 0.025))


def _box(x: float, z: float, width: float, height: float) -> np.ndarray:
    return np.array([(x + sx * width / 2, z + sz * height / 2) for sx, sz in ((-1, -1), (1, -1), (1, 1), (-1, 1))])


def _disc(x: float, z: float, radius: float, aspect: float) -> np.ndarray:
    """Return a circle that is round on a sheet of an aspect; its radius is in widths, in heights on a wide sheet."""
    angle = np.linspace(0, 2 * np.pi, 28, endpoint=False)
    across = radius * min(1.0, 0.75 / aspect)
    return np.stack([x + across * np.cos(angle), z + across * aspect * np.sin(angle)], axis=1)
