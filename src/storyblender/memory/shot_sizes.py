"""The one table of shot sizes: what each of the eight means to the Director, the camera, its critics and the lists."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

ShotSize = Literal["EWS", "WS", "FS", "MWS", "MS", "MCU", "CU", "ECU"]


@dataclass(frozen=True)
class SizeStandard:
    """What a shot size means (notes of the director; Arijon, Grammar of the Film Language; Katz, Shot by Shot).

    Attributes:
        words: As people say it.
        lens: Default focal length in mm on a 36 mm wide sensor; a lens kit may replace it.
        widest: Shortest focal length in mm that the lens may be widened to where the room is short; inf keeps it.
        f_number: Aperture; tight shots part the face from its background, in wider ones everything is sharp unless the
            script or a person says otherwise.
        head: Head height (crown to chin) as a share of the picture's height. A head is 0.13 of a body: FS holds the
            body with a little air, MS cuts at the waist, CU at the shoulders.
        crown: Where the top of the head goes, as a share of the picture's height from the top.
        off_face: Degrees from full face at which a single is taken.
        fill: Share of the picture's height or width that a thing fills.
        fill_large: Likewise, of a thing of more than a metre, such as a truck; None where it is as ``fill``.
        reach: Metres from the first subject within which others stay in the picture; farther ones would make all of
            them tiny.
    """

    words: str
    lens: float
    widest: float
    f_number: float
    head: float
    crown: float
    off_face: float = 40.0
    fill: float = 0.2
    fill_large: float | None = None
    reach: float = math.inf

    @property
    def band(self) -> tuple[float, float]:
        """Head heights that still read as this size."""
        return self.head / 1.28, self.head * 1.28


SIZES: dict[ShotSize, SizeStandard] = {
    "EWS": SizeStandard("extreme wide shot", 24, 18, 8.0, 0.030, 0.42, fill_large=0.25),
    "WS": SizeStandard("wide shot", 28, 18, 8.0, 0.062, 0.26, fill_large=0.5),
    "FS": SizeStandard("full shot", 35, 20, 5.6, 0.108, 0.08, fill_large=0.7, reach=4.0),
    "MWS": SizeStandard("medium wide shot", 40, 22, 4.0, 0.150, 0.09, fill_large=0.8, reach=3.0),
    "MS": SizeStandard("medium shot", 50, 27, 4.0, 0.210, 0.10, 36.0, 0.3, reach=2.6),
    "MCU": SizeStandard("medium close-up", 65, 35, 4.0, 0.310, 0.09, 34.0, 0.42),
    "CU": SizeStandard("close-up", 85, math.inf, 4.0, 0.450, 0.06, 30.0, 0.55),
    "ECU": SizeStandard("extreme close-up", 100, math.inf, 5.6, 0.750, -0.12, 24.0, 0.75),
}
"""From the widest to the tightest."""
SHOT_SIZES: tuple[ShotSize, ...] = tuple(SIZES)
"""In that order; cutting rules count steps in it."""
WHOLE: tuple[ShotSize, ...] = ("EWS", "WS", "FS")
"""Sizes that show bodies from head to feet, and the place: people who happen to be there may be seen."""
TIGHT: tuple[ShotSize, ...] = ("MCU", "CU", "ECU")
"""Sizes that hold one face."""
