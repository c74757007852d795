"""Finds the unit of an imported model: by its file, by the usual size of such a thing, and by which units are usual.

A model in metres, centimetres, millimetres or inches is left in its own proportions and its own size. Only where no
unit is likely it becomes as large as such a thing usually is. Pure numpy.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from storyblender.memory.asset_sheet import AssetDimension, Certainty
from storyblender.memory.base import Vec3

Floats = NDArray[np.float64]

UNITS: tuple[tuple[str, float, float], ...] = (
    ("metres", 1.0, 0.42),
    ("centimetres", 0.01, 0.42),
    ("millimetres", 0.001, 0.06),
    ("inches", 0.0254, 0.02),
)
"""Name, metres, and how likely a file is in it that does not say so."""
_NO_UNIT = 0.1
"""How likely a file is in none of them."""
_SCALES = np.linspace(np.log(1e-5), np.log(1e3), 1800)
"""Natural logarithms of the scales among which a file without a unit may be."""
PLAUSIBLE_RATIO = 2.5
"""Largest ratio of a thing's size to the usual one, either way, at which a file known to be in metres is left alone."""
ESTIMATE_RATIO = 1.5
"""Largest ratio between the size that a unit gives and an estimated size at which the unit is taken."""
FIRM, LOOSE = (0.17, 0.4), (0.45, 0.6)
"""Spread of the logarithm of size, above the usual and below it."""
BEYOND = (0.2, 0.3)
"""The same beyond the span of a thing of which it is known."""
_LIKELY = (0.8, 1.6)
"""Metres of the largest extent of a thing of which nothing is known, and the spread of its logarithm."""


@dataclass(frozen=True)
class UsualSize:
    """How large such a thing usually is.

    Attributes:
        size: Width, depth and height in metres.
        firm: Whether things of this kind hardly differ in size, above all in height, because people use them.
        span: How many times larger, or smaller, such a thing may be as well: a cactus on a sill and one in a desert.
    """

    size: Vec3
    firm: bool = False
    span: float = 1.0

    def offsets(self, extent: Floats) -> tuple[float, float, float]:
        """Return the logarithm of the scale that gives an extent this size, and its spread below and above.

        Args:
            extent: (3,) width, depth and height in any unit; width and depth may be exchanged.
        """
        weights = np.array((0.2, 0.2, 0.6)) if self.firm else np.full(3, 1 / 3)
        usual, found = (np.log(np.maximum([*sorted(each[:2]), each[2]], 1e-9)) for each in (self.size, extent))
        differences = usual - found
        near = np.abs(differences - np.median(differences)) < 1.0  # a thin side says nothing of the others
        middle = float(np.average(differences[near], weights=weights[near]))
        larger, smaller = FIRM if self.firm else LOOSE if self.span == 1.0 else BEYOND
        doubt = 0.5 * float(differences.std())  # of what has other proportions it is not sure that it is such a thing
        return middle, float(np.hypot(larger, doubt)), float(np.hypot(smaller, doubt))


def find_scale(
    extent: Floats,
    usual: UsualSize | None,
    dimension: AssetDimension | None = None,
    *,
    certainty: Certainty = "usual",
    unit: float | None = None,
) -> tuple[float, str]:
    """Return the scale from a model's unit to metres, and the reason for it; the reason is empty where the scale is 1.

    Args:
        extent: (3,) width, depth, height in the file's units.
        usual: How large such a thing usually is, if known.
        dimension: One measure of the thing in metres, if known.
        certainty: Of that measure. One that is told overrides the size of the file; one that is estimated chooses the
            unit, and counts itself only where no unit gives nearly that size.
        unit: Metres of the unit that the file or its format states, if any.
    """
    wanted = _wanted(extent, dimension)
    if certainty == "told" and wanted is not None:
        return wanted, "" if abs(wanted - 1) < 0.02 else "its size was given"
    if certainty == "estimated" and wanted is not None:
        return _near_unit(wanted, unit)
    goal = (wanted if usual is None else float(np.exp(usual.offsets(extent)[0]))) if wanted or usual else None
    if unit is not None and (goal is None or 1 / PLAUSIBLE_RATIO <= goal / unit <= PLAUSIBLE_RATIO):
        return unit, "" if unit == 1 else "its file says its unit"
    names, units, shares = zip(*UNITS, strict=True)
    scores = np.log(shares) + _fit(extent, np.log(units), usual, wanted)
    best = int(scores.argmax())
    if goal is not None:
        loose = np.log(_NO_UNIT * np.exp(_fit(extent, _SCALES, usual, wanted)).mean())
        if loose > scores[best]:
            return goal, "it is far from the usual size of such a thing"
    return units[best], "" if units[best] == 1 else f"it is taken to be in {names[best]}"


def _near_unit(wanted: float, unit: float | None) -> tuple[float, str]:
    """Return the scale of the unit nearest to an estimated scale, or that scale where none is near; and the reason."""
    units = [(f"it is taken to be in {name}", metres) for name, metres, _ in UNITS]
    units += [("its file says its unit", unit)] if unit is not None else []
    reason, scale = min(units, key=lambda each: abs(np.log(each[1] / wanted)))
    if max(scale / wanted, wanted / scale) > ESTIMATE_RATIO:
        return wanted, "by its picture it is so large"
    return scale, "" if scale == 1 else reason


def _fit(extent: Floats, scales: Floats, usual: UsualSize | None, wanted: float | None) -> Floats:
    """Return the logarithms of how likely scales, as logarithms, are by the size that they give, per unit of them."""
    span = 0.0
    if usual is not None:
        middle, larger, smaller = usual.offsets(extent)
        span = float(np.log(usual.span))
    elif wanted is not None:
        middle, larger, smaller = float(np.log(wanted)), 0.4, 0.5
    else:
        middle, larger, smaller = float(np.log(_LIKELY[0] / max(extent.max(), 1e-9))), *(_LIKELY[1],) * 2
    off = scales - middle
    beyond = np.maximum(np.abs(off) - span, 0.0)
    return -0.5 * (beyond / np.where(off > 0, larger, smaller)) ** 2 - float(np.log(0.5 * (larger + smaller) + span))


def _wanted(extent: Floats, dimension: AssetDimension | None) -> float | None:
    """Return the scale that gives a dimension; of width and depth the larger stands for either."""
    if dimension is None:
        return None
    if dimension.height is not None:
        return dimension.height / max(float(extent[2]), 1e-9)
    side = dimension.width if dimension.width is not None else dimension.depth
    return None if side is None else side / max(float(extent[:2].max()), 1e-9)
