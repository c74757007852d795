"""What is sewn onto clothes: buttons, pockets, ties."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from storyblender.blender.people.cloth import Bolt, one
from storyblender.blender.people.figure import Figure
from storyblender.blender.people.sheet import Sheet, join, rigid
from storyblender.blender.people.under import Under
from storyblender.catalog.garments import Buttons

Floats = NDArray[np.float64]


def build_buttons(cut: Buttons, figure: Figure, under: Under) -> list[Bolt]:
    """Sew a row of round buttons to the front."""
    k = figure.k
    discs: list[Sheet] = []
    for z in np.linspace(figure.height(cut.top), figure.height(cut.bottom), cut.count):
        spot = under.front(cut.offset * k, float(z))
        if spot is None:
            continue
        across = np.cross(spot.normal, (0, 0, 1))
        across /= np.linalg.norm(across)
        up = np.cross(across, spot.normal)
        turns = [2 * math.pi * step / 8 for step in range(8)]
        ring = [spot.location + (across * math.cos(a) + up * math.sin(a)) * cut.radius * k for a in turns]
        points = [spot.location + spot.normal * 0.004 * k, *(point + spot.normal * 0.002 * k for point in ring)]
        discs.append(rigid(np.array(points), [(0, 1 + (i + 1) % 8, 1 + i) for i in range(8)], spot.weights))
    return one(cut, join(discs)) if discs else []
