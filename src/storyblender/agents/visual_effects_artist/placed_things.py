"""Placed objects as the Animator sees them: their outline, tops and seats. Pure."""

from __future__ import annotations

import math
from dataclasses import dataclass

from storyblender.geometry.paths import Footprint, Vec2
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3

UNDERFOOT, OVERHEAD = 0.12, 2.0
"""Metres: lower things are stepped over, higher ones walked under."""
TOPS, ROOMY = (0.32, 1.4), 0.25
"""Metres: heights of tops on which things are put down, and how far across such a top is at least."""
SAT_ON = (0.26, 0.48)
"""Metres to the side of the middle of a seat's edge, and behind it, that are sat on."""


@dataclass(frozen=True)
class Thing:
    """A placed object.

    Attributes:
        node_id: Instance.
        asset_id: Asset.
        location: Bottom centre.
        yaw: Radians.
        size: Width, depth, height.
        anchors: In its own frame.
    """

    node_id: str
    asset_id: str
    location: Vec3
    yaw: float
    size: Vec3
    anchors: tuple[Anchor, ...]

    @property
    def solid(self) -> bool:
        """People walk around it."""
        return self.location[2] < OVERHEAD and self.location[2] + self.size[2] > UNDERFOOT and self.size[2] > UNDERFOOT

    @property
    def footprint(self) -> Footprint:
        """Its outline on the floor."""
        return Footprint(self.location[:2], self.size[:2], self.yaw, name=self.node_id)

    def rim(self, place: Vec2) -> Vec2:
        """Return the point of the outline that is nearest to a place, in metres in the set."""
        lx, ly = self.local(place)
        half = self.size[0] / 2, self.size[1] / 2
        x, y = max(-half[0], min(half[0], lx)), max(-half[1], min(half[1], ly))
        if abs(x) < half[0] and abs(y) < half[1]:
            y = -half[1]
        return self.world((x, y, 0.0))[:2]

    def world(self, point: Vec3) -> Vec3:
        """Return a point of its own frame in the world."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        x, y, z = point
        ox, oy, oz = self.location
        return ox + cos * x - sin * y, oy + sin * x + cos * y, oz + z

    def local(self, point: Vec2) -> Vec2:
        """Return a world point of the floor in its own frame."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        x, y = point[0] - self.location[0], point[1] - self.location[1]
        return cos * x + sin * y, cos * y - sin * x

    def of_kind(self, *kinds: str) -> list[Anchor]:
        """Return its anchors of some kinds."""
        return [anchor for anchor in self.anchors if anchor.kind in kinds]


@dataclass(frozen=True)
class SeatPlace:
    """A place for one sitter (or one sleeper).

    Attributes:
        node_id: Of the furniture.
        anchor: Name of the anchor.
        edge: Middle of the front edge, world.
        yaw: Radians.
    """

    node_id: str
    anchor: str
    edge: Vec2
    yaw: float

    def before(self, scale: float) -> Vec2:
        """Return where one stands before sitting down."""
        return self.edge[0] + 0.18 * scale * math.sin(self.yaw), self.edge[1] - 0.18 * scale * math.cos(self.yaw)

    def takes(self, spot: Vec3) -> bool:
        """Tell whether who sits here sits on what lies there."""
        sin, cos = math.sin(self.yaw), math.cos(self.yaw)
        x, y = spot[0] - self.edge[0], spot[1] - self.edge[1]
        aside, behind = abs(x * cos + y * sin), y * cos - x * sin
        return TOPS[0] < spot[2] < TOPS[1] and aside < SAT_ON[0] and 0 < behind < SAT_ON[1]


def has_room_on_top(thing: Thing) -> bool:
    """Tell whether something can be put on a thing: not in a flowerpot, not on a wardrobe."""
    top = next(iter(thing.of_kind("top")), None)
    return top is not None and min(top.size) > ROOMY and TOPS[0] < thing.location[2] + top.location[2] < TOPS[1]


def is_seat(thing: Thing) -> bool:
    """Tell whether the first of a thing's tops is what one sits or lies on."""
    top = thing.of_kind("top")[0].location[2]
    return any(seat.location[2] > top - UNDERFOOT for seat in thing.of_kind("seat", "bed"))
