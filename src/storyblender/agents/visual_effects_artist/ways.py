"""Points and facings on the ways that people walk. Pure.

Places are in metres in the set; yaws are in radians, counter-clockwise, and 0 faces the audience at -Y.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2

CHEAT = math.radians(20)
"""Radians that bodies turn from a partner towards the audience, so that faces read; the head makes up for it."""


def point_on_line(start: Vec2, goal: Vec2, length: float) -> Vec2:
    """Return the point on the straight line from ``start`` to ``goal`` at ``length`` metres from the start."""
    share = length / max(math.dist(start, goal), 1e-6)
    return start[0] + share * (goal[0] - start[0]), start[1] + share * (goal[1] - start[1])


def turn_towards_audience(yaw: float) -> float:
    """Return a yaw turned towards yaw 0, the audience, by at most ``CHEAT`` radians."""
    away = shortest_turn(yaw, 0.0)
    return yaw + max(-CHEAT, min(CHEAT, away))


def shorten_way(way: Sequence[Vec2], length: float) -> list[Vec2]:
    """Return the first ``length`` metres of a way, which is a polyline in metres in the set."""
    kept = [way[0]]
    for a, b in itertools.pairwise(way):
        step = math.dist(a, b)
        if step >= length:
            w = length / max(1e-9, step)
            return [*kept, (a[0] + (b[0] - a[0]) * w, a[1] + (b[1] - a[1]) * w)]
        kept.append(b)
        length -= step
    return kept
