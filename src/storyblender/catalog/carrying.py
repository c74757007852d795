"""How a thing is carried, from its size, its grips and what it is: one hand, two hands, on the body."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3
from storyblender.memory.vocabulary import BodyPlace, Grip, Hand

TWO_HANDED = 0.37
"""Metres: a thing wider and deeper than this is carried with both hands."""
ON_THE_LEFT = 0.35
"""Metres to the left of a person from which the left hand takes what is offered."""

_WORN_ON: dict[str, BodyPlace] = {
    **dict.fromkeys(("hat", "crown", "helmet", "bucket", "pot", "cardboard_box"), "head"),
    **dict.fromkeys(("glasses", "mask"), "face"), "headset": "ears",
    **dict.fromkeys(("necklace", "medal", "whistle", "rope", "photo_camera", "binoculars", "stethoscope"), "neck"),
    **dict.fromkeys(("id_card", "badge", "flower", "name_badge", "envelope", "letter"), "chest"),
    **dict.fromkeys(("backpack", "guitar", "shield", "bow", "accordion"), "back"),
    **dict.fromkeys(("bag", "sack", "briefcase", "gun", "sword", "knife", "walkie_talkie", "handcuffs", "flashlight",
                     "hammer", "key", "key_ring"), "hip"),
    **dict.fromkeys(("towel", "cloth", "blanket", "rifle", "spear", "climbing_rope", "parrot", "axe"), "shoulder"),
}  # fmt: skip
"""Prop key -> where it is worn. Other worn things are garments, which the person's clothes show."""
_PLACES: dict[Grip, BodyPlace] = {"under_arm": "under_arm", "shoulder": "shoulder", "lap": "lap", "mouth": "mouth"}
ON_BODY: frozenset[Grip] = frozenset((*_PLACES, "worn"))
"""Ways to carry that leave both hands free."""


def body_place_of(grip: Grip | None, key: str | None) -> BodyPlace | None:
    """Return where on the body a thing is carried; None for a thing in a hand, or one that is not seen.

    Args:
        grip: How it is carried.
        key: Prop key of the thing.
    """
    if grip == "worn":
        return _WORN_ON.get(key or "")
    return _PLACES.get(grip) if grip is not None else None


def two_handed(dimensions: Vec3, anchors: Sequence[Anchor]) -> bool:
    """Return whether a thing is carried with both hands: wide and deep, or long and without a grip.

    Args:
        dimensions: Width, depth, height in metres.
        anchors: Anchors of the thing; grips and handles count.
    """
    width, depth, _ = dimensions
    gripped = any(anchor.kind in ("grip", "handle") for anchor in anchors)
    return min(width, depth) > TWO_HANDED or (max(width, depth) > 1.4 * TWO_HANDED and not gripped)


def hand_towards(
    place: tuple[float, float], yaw: float, point: tuple[float, float], on_the_left: float = ON_THE_LEFT
) -> Hand:
    """Return the hand that reaches for a point: the left for what is on the left, else the right.

    Args:
        place: Where the person stands on the floor, metres.
        yaw: Where the person faces, radians.
        point: Where the thing, or the person who offers it, is on the floor.
        on_the_left: Metres to the left from which the left hand is used.
    """
    leftwards = (point[0] - place[0]) * math.cos(yaw) + (point[1] - place[1]) * math.sin(yaw)
    return "L" if leftwards > on_the_left else "R"
