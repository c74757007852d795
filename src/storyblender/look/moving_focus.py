"""Depth of field for moving frames: only what differs from the last frame is blurred again, and what that reaches."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.look.lens_blur import blurred
from storyblender.look.optics import Lens
from storyblender.look.raster import Image, Window

_SAME = 0.15
"""Change of a radius in pixels that nobody sees."""
_GRID = 4
"""Pixels of the coarsest picture that a disc is laid over: parts begin on it, so that they fit the whole."""


class MovingFocus:
    """Blurs the frames of one shot, one after the other.

    Args:
        height: Pixels.
        width: Pixels.
    """

    def __init__(self, height: int, width: int) -> None:
        self._sharp = np.zeros((height, width, 3), np.float32)
        self._lens: Lens | None = None

    def differs(self, lens: Lens | None) -> bool:
        """Return whether a lens shows the last frame otherwise than it was shown."""
        if lens is None or self._lens is None:
            return lens != self._lens
        sky = np.array([np.inf])
        change = float(np.abs(lens.blur_circle(sky) - self._lens.blur_circle(sky))[0])
        return change * self._sharp.shape[1] / 2 > _SAME

    def blurred(
        self, parts: Sequence[tuple[Window, Image]], rim: int, depth: NDArray[np.float32], lens: Lens
    ) -> list[tuple[Window, Image]]:
        """Return the parts of the frame that are not as in the last one, as the lens sees them.

        Args:
            parts: What differs, sharp and linear: windows and (h, w, 3).
            rim: Pixels at a part's edge that do not count, inside the picture.
            depth: (h, w) of the whole frame, metres along the optical axis.
            lens: As it is set at this frame.
        """
        height, width = self._sharp.shape[:2]
        everything = Window(0, 0, height, width)
        radius = lens.blur_circle(depth) * np.float32(width / 2)
        reach = math.ceil(float(np.abs(radius).max())) + 1
        changed: list[Window] = []
        for window, picture in parts:
            inner = window.inner(rim, height, width)
            self._sharp[inner.cut] = picture[inner.within(window).cut]
            changed.append(inner.grown(reach + rim, height, width))
        if self.differs(lens):
            self._lens, changed = lens, [everything]
        return [(window, self._part(window, radius, 2 * reach)) for window in changed]

    def _part(self, window: Window, radius: Image, reach: int) -> Image:
        """Return a part of the blurred frame; what lies up to ``reach`` pixels round it bears on it."""
        height, width = radius.shape
        outer = window.grown(reach + _GRID, height, width)
        outer = Window(outer.top // _GRID * _GRID, outer.left // _GRID * _GRID, outer.bottom, outer.right)
        return blurred(self._sharp[outer.cut], radius[outer.cut])[window.within(outer).cut]
