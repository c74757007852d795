"""Lines of sight on the floor plan: what boxes hide from an eye."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from storyblender.geometry.boxes import Box


def find_hidden(boxes: Sequence[Box], eye: ArrayLike, points: ArrayLike, spare: float = 0.0) -> NDArray[np.bool_]:
    """Return (n,) whether each of (n, 3) world points is behind a box, as seen from the eye.

    Args:
        boxes: Boxes that may stand in the way.
        eye: (3,) world metres.
        points: (n, 3) world metres.
        spare: Metres before each point that do not count: what it sits on or leans at does not hide it.
    """
    start, ends = np.asarray(eye, float), np.atleast_2d(np.asarray(points, float))
    if not boxes:
        return np.zeros(len(ends), bool)
    ways = ends - start
    far = 1.0 - spare / np.maximum(np.linalg.norm(ways, axis=1), 2 * spare + 1e-9)
    cos, sin = (np.array([getattr(box, name) for box in boxes])[:, None] for name in ("cos", "sin"))
    middle = np.array([(box.x, box.y, box.z + box.height / 2) for box in boxes])[:, None]
    half = np.array([(box.width, box.depth, box.height) for box in boxes])[:, None] / 2
    local, steps = _to_box_frames(start - middle, cos, sin), _to_box_frames(ways[None], cos, sin)
    steps = np.where(np.abs(steps) < 1e-9, 1e-9, steps)
    one, other = (-half - local) / steps, (half - local) / steps
    enter, leave = np.minimum(one, other).max(2), np.maximum(one, other).min(2)
    return (np.maximum(enter, 0.0) < np.minimum(leave, far)).any(0)


def _to_box_frames(
    ways: NDArray[np.float64], cos: NDArray[np.float64], sin: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return (boxes, n, 3) ways in the frames of the boxes."""
    x, y = ways[..., 0], ways[..., 1]
    return np.stack([cos * x + sin * y, cos * y - sin * x, np.broadcast_to(ways[..., 2], (cos * x).shape)], 2)
