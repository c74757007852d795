"""Room on the floor to lie, kneel or fall: such a body is longer than the disc of a standing person."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.geometry.paths import Vec2, clearance
from storyblender.memory.vocabulary import Posture

SPANS: dict[Posture, tuple[float, float]] = {"lie": (-0.9, 0.85), "asleep": (-0.9, 0.85), "kneel": (-0.3, 0.42)}
"""Metres, times stature over 1.7, that a body reaches behind its hips and ahead of them."""
HALF_WIDTHS = {"lie": 0.2, "asleep": 0.2, "kneel": 0.14}
"""Metres, times stature over 1.7, from the middle of a body to its side."""
APART = 0.5
"""Metres from a lying person to others and to seats."""
METRES_PER_RADIAN = 0.35
"""Metres of displacement that cost as much as turning by one radian."""
_STEP, _FARTHEST, _TURNS = 0.2, 1.8, 16


def find_room_on_floor(
    floor: Floor, posture: Posture, place: Vec2, yaw: float, scale: float, others: Sequence[Vec2] = ()
) -> tuple[Vec2, float]:
    """Return the place of the hips and the yaw, nearest to the wished ones, at which a body touches nothing.

    Args:
        floor: Everything on the floor.
        posture: Lying with the feet ahead, or kneeling; any other posture is left where it is.
        place: Wished floor point in metres.
        yaw: Wished yaw in radians.
        scale: Stature over 1.7 m.
        others: Floor points of other people.
    """
    if posture not in SPANS:
        return place, yaw
    near = [*others, *_seat_fronts(floor, scale)] if posture != "kneel" else []
    wish = np.array([place], dtype=float)
    if _find_fitting(floor, posture, wish, np.array([yaw]), scale, near)[0, 0]:
        return place, yaw
    around: NDArray[np.float64] = np.add(wish, _grid_in_disc(_FARTHEST, _STEP))
    turns = np.linspace(-math.pi, math.pi, _TURNS, endpoint=False)
    fits = _find_fitting(floor, posture, around, yaw + turns, scale, near)
    cost = np.hypot(*(around - wish).T)[:, None] + METRES_PER_RADIAN * np.abs(turns)
    best = int(np.argmin(np.where(fits, np.round(cost, 6), math.inf)))
    if not fits.flat[best]:
        return place, yaw
    x, y = around[best // _TURNS]
    return (float(x), float(y)), float(yaw + turns[best % _TURNS])


def _grid_in_disc(radius: float, step: float) -> list[Vec2]:
    """Return the points of a grid within a radius of its middle."""
    count = int(radius / step)
    steps = [index * step for index in range(-count, count + 1)]
    return [(dx, dy) for dx in steps for dy in steps if math.hypot(dx, dy) <= radius]


def _find_fitting(
    floor: Floor,
    posture: Posture,
    places: NDArray[np.float64],
    yaws: NDArray[np.float64],
    scale: float,
    near: list[Vec2],
) -> NDArray[np.bool_]:
    """Return (places, yaws) whether a body is clear of things, the walls and the points ``near``."""
    behind, ahead = SPANS[posture]
    along = scale * np.linspace(behind, ahead, 8)
    forward = np.stack([np.sin(yaws), -np.cos(yaws)], axis=1)
    points = places[:, None, None, :] + forward[None, :, None, :] * along[None, None, :, None]
    flat = points.reshape(-1, 2)
    x0, y0, x1, y1 = floor.bounds
    free = clearance(flat, floor.obstacles()) >= HALF_WIDTHS[posture] * scale
    free &= (flat >= (x0, y0)).all(axis=1) & (flat <= (x1, y1)).all(axis=1)
    for other in near:
        free &= np.hypot(*(flat - other).T) >= APART
    return free.reshape(points.shape[:3]).all(axis=2)


def _seat_fronts(floor: Floor, scale: float) -> list[Vec2]:
    """Return the floor points in front of all seats."""
    return [seat.standing_spot(scale) for name in floor.things for seat in floor.seats(name)]
