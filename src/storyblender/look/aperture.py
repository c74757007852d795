"""Aperture masks for POV shots, drawn over the picture: binoculars, scope, keyhole, viewfinder, gap."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from storyblender.look.lens_blur import diffused
from storyblender.memory.vocabulary import Aperture

Pixels = NDArray[np.uint8]
Shape = NDArray[np.float32]
_Field = Callable[[Shape, Shape, float], Shape]

_DARK = 0.04
"""Display brightness (0 to 1) of the area outside the opening."""
_SOFT = 0.012
"""Width of the soft edge of the opening, in picture heights."""
_LINE = 0.003
"""Half the width of a reticle or viewfinder line, in picture heights."""


def look_through(pixels: Pixels, through: Aperture | None, soft_focus: bool = False) -> Pixels:
    """Return a picture as seen through an optical device or opening; unchanged for None.

    Args:
        pixels: (h, w, 3) display values.
        through: The device or opening.
        soft_focus: Whether a diffusion filter is before the lens.
    """
    pixels = diffused(pixels) if soft_focus else pixels
    if through is None:
        return pixels
    height, width = pixels.shape[:2]
    aspect = width / height
    y, x = np.mgrid[0:height, 0:width].astype(np.float32)
    x, y = (x + 0.5 - width / 2) / height, (y + 0.5 - height / 2) / height
    inside = _OPENINGS[through](x, y, aspect) if through in _OPENINGS else np.ones_like(x)
    picture = pixels.astype(np.float32) * inside[..., None] + 255 * _DARK * (1 - inside[..., None])
    if through in _LINES:
        lines = _LINES[through](x, y, aspect)[..., None]
        ink = 20.0 if through == "scope" else 240.0
        picture = picture * (1 - lines) + ink * lines
    return np.clip(np.rint(picture), 0, 255).astype(np.uint8)


def _open(distance: Shape) -> Shape:
    """Return the mask of an outline, 1 inside and 0 outside.

    Args:
        distance: Signed distance to the outline in picture heights, negative inside.
    """
    return np.clip(0.5 - distance / _SOFT, 0, 1).astype(np.float32)


def _circle(x: Shape, y: Shape, at: tuple[float, float], radius: float) -> Shape:
    return np.hypot(x - at[0], y - at[1]) - radius


def _binoculars(x: Shape, y: Shape, _: float) -> Shape:
    return _open(np.minimum(_circle(x, y, (-0.31, 0.0), 0.45), _circle(x, y, (0.31, 0.0), 0.45)))


def _tube(x: Shape, y: Shape, _: float) -> Shape:
    return _open(_circle(x, y, (0.0, 0.0), 0.46))


def _keyhole(x: Shape, y: Shape, _: float) -> Shape:
    shaft = np.maximum(np.abs(x) - 0.13 - 0.14 * (y + 0.05), np.abs(y - 0.2) - 0.26)
    return _open(np.minimum(_circle(x, y, (0.0, -0.17), 0.27), shaft))


def _gap(x: Shape, _: Shape, __: float) -> Shape:
    return _open(np.abs(x) - 0.27)


def _slats(_: Shape, y: Shape, __: float) -> Shape:
    return _open(np.abs(np.mod(y, 0.14) - 0.07) - 0.05)


def _panes(x: Shape, y: Shape, aspect: float) -> Shape:
    rim = np.maximum(np.abs(x) - aspect / 2 + 0.05, np.abs(y) - 0.45)
    return _open(np.maximum(rim, 0.014 - np.minimum(np.abs(x), np.abs(y + 0.12))))


def _bars(x: Shape, _: Shape, __: float) -> Shape:
    return _open(0.02 - np.abs(np.mod(x + 0.15, 0.3) - 0.15))


def _line(y: Shape) -> float:
    """Return half the width of a line in picture heights, so that the line is at least one pixel wide."""
    return max(_LINE, 0.55 * float(y[1, 0] - y[0, 0]))


def _cross(x: Shape, y: Shape, _: float) -> Shape:
    return (np.minimum(np.abs(x), np.abs(y)) < _line(y)).astype(np.float32) * (np.hypot(x, y) < 0.46)


def _brackets(x: Shape, y: Shape, aspect: float) -> Shape:
    right, low, line = aspect / 2 - 0.08, 0.42, _line(y)
    edge = (np.abs(np.abs(x) - right) < line) & (np.abs(y) > low - 0.1) & (np.abs(y) < low)
    edge |= (np.abs(np.abs(y) - low) < line) & (np.abs(x) > right - 0.1) & (np.abs(x) < right)
    edge |= (np.minimum(np.abs(x), np.abs(y)) < line) & (np.maximum(np.abs(x), np.abs(y)) < 0.04)
    return edge.astype(np.float32)


_OPENINGS: dict[Aperture, _Field] = {
    "binoculars": _binoculars,
    "keyhole": _keyhole,
    "scope": _tube,
    "tube": _tube,
    "slats": _slats,
    "bars": _bars,
    "panes": _panes,
    "gap": _gap,
}
_LINES: dict[Aperture, _Field] = {"scope": _cross, "viewfinder": _brackets}
