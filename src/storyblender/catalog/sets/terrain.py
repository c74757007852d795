"""Rolling ground around a flat stage: one height function for kits that plant on it and for its skin."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray


def ground_height(
    x: ArrayLike, y: ArrayLike, *, flat: float, relief: float, rise: float = 0.0, seed: int = 0
) -> NDArray[np.float64]:
    """Return the height of the ground in metres.

    Args:
        x: World x in metres, any shape.
        y: World y in metres, same shape.
        flat: Radius about the origin that stays level, where people act.
        relief: Height of the swells away from it.
        rise: Metres that the ground gains per metre beyond the flat, a bowl around the stage.
        seed: Another seed, another lie of the land.
    """
    px, py = np.asarray(x, float), np.asarray(y, float)
    phase = 1.7 * seed
    distance = np.hypot(px, py)
    away = np.clip((distance - flat) / 9.0, 0.0, 1.0)
    swell = (
        np.sin(px * 0.13 + phase) * np.cos(py * 0.11 - phase)
        + 0.5 * np.sin(px * 0.31 - py * 0.23 + 2 * phase)
        + 0.25 * np.sin(px * 0.57 + py * 0.63 + 3 * phase)
    )
    return away**2 * (relief * (0.5 + 0.5 * swell) + rise * np.maximum(distance - flat, 0.0))
