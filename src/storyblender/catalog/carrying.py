"""How things are carried, as one may tell from their size and their grips."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3

TWO_HANDED = 0.37
"""Metres; things wider and deeper than this are carried with both hands."""


def two_handed(dimensions: Vec3, anchors: Sequence[Anchor]) -> bool:
    """Tell whether a thing is carried with both hands: wide and deep, or long and without a grip.

    Args:
        dimensions: Width, depth, height in metres.
        anchors: Of the thing; grips and handles matter.
    """
    width, depth, _ = dimensions
    gripped = any(anchor.kind in ("grip", "handle") for anchor in anchors)
    return min(width, depth) > TWO_HANDED or (max(width, depth) > 1.4 * TWO_HANDED and not gripped)
