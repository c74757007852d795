"""Depth of field of a thin lens (Ray, Applied Photographic Optics, chapter 22). Lengths in metres, lenses in mm."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

SHARP = 0.05
"""Diameter in mm, on a sensor 36 mm wide, of a blur that still counts as sharp: 1.3 pixels of a board's 960."""
F_NUMBERS = (1.4, 2.0, 2.8, 4.0, 5.6, 8.0, 11.0, 16.0)
"""Full stops, as they are engraved on a lens."""


@dataclass(frozen=True)
class Lens:
    """A lens as it is set.

    Attributes:
        length: Focal length, mm.
        f_number: Focal length / diameter of the aperture.
        focus: Depth of the plane that is sharp, metres from the optical centre.
        sensor_width: mm.
    """

    length: float
    f_number: float
    focus: float
    sensor_width: float = 36.0

    def blur_circle(self, depth: NDArray[np.floating]) -> NDArray[np.float32]:
        """Return the diameter of the circle of confusion as a share of the sensor's width, negative before the focus.

        With focal length f, f-number N, focus s and depth d: c = f^2 / (N (s - f)) * (d - s) / d.

        Args:
            depth: Metres along the optical axis, any shape; infinity is allowed.
        """
        length = self.length / 1000
        focus = max(self.focus, 2 * length)
        most = length**2 / (self.f_number * (focus - length))
        share = 1 - focus / np.maximum(np.asarray(depth, np.float32), np.float32(length))
        return (share * np.float32(most / (self.sensor_width / 1000))).astype(np.float32)


def stopped_down(lens: Lens, depths: Sequence[float]) -> Lens | None:
    """Return the lens with the smallest full stop not below its own at which all depths are sharp; None without one.

    Args:
        lens: As it is set; its own f-number is kept where that will do.
        depths: Metres along the optical axis, of what has to be sharp.
    """
    limit = SHARP / 36.0
    for f_number in (lens.f_number, *(stop for stop in F_NUMBERS if stop > lens.f_number)):
        stopped = Lens(lens.length, f_number, lens.focus, lens.sensor_width)
        if not len(depths) or float(np.abs(stopped.blur_circle(np.array(depths))).max()) <= limit:
            return stopped
    return None
