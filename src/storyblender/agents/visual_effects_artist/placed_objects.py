"""Placed objects as the Animator sees them: their outline, tops and seats."""

from __future__ import annotations

import math
from dataclasses import dataclass

from storyblender.geometry.paths import Footprint, Vec2
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec3

UNDERFOOT, OVERHEAD = 0.12, 2.0
"""Metres: lower things are stepped over, higher ones walked under."""
TOPS, ROOMY = (0.32, 1.4), 0.25
"""Metres: lowest and highest top on which props are put down; least width and depth of such a top."""
SITTER_AREA = (0.26, 0.48)
"""Metres that a sitter takes to each side of the middle of a seat's edge, and behind it."""


@dataclass(frozen=True)
class PlacedObject:
    """A placed object; world units are metres in the set, its own frame has its front at -Y.

    Attributes:
        node_id: Node id of this placement.
        asset_id: Its asset.
        location: World position of its bottom centre.
        yaw: Radians, counter-clockwise.
        size: Width, depth and height in metres.
        anchors: Seats, tops, grips, doors, in its own frame.
    """

    node_id: str
    asset_id: str
    location: Vec3
    yaw: float
    size: Vec3
    anchors: tuple[Anchor, ...]

    @property
    def solid(self) -> bool:
        """Whether people walk around it, not over or under it."""
        return self.location[2] < OVERHEAD and self.location[2] + self.size[2] > UNDERFOOT and self.size[2] > UNDERFOOT

    @property
    def footprint(self) -> Footprint:
        """Its outline on the floor."""
        return Footprint(self.location[:2], self.size[:2], self.yaw, name=self.node_id)

    def nearest_edge(self, place: Vec2) -> Vec2:
        """Return the world floor point of its outline that is nearest to a world floor point."""
        lx, ly = self.to_local(place)
        half = self.size[0] / 2, self.size[1] / 2
        x, y = max(-half[0], min(half[0], lx)), max(-half[1], min(half[1], ly))
        if abs(x) < half[0] and abs(y) < half[1]:
            y = -half[1]
        return self.to_world((x, y, 0.0))[:2]

    def to_world(self, point: Vec3) -> Vec3:
        """Return a point of its own frame in the world."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        x, y, z = point
        ox, oy, oz = self.location
        return ox + cos * x - sin * y, oy + sin * x + cos * y, oz + z

    def to_local(self, point: Vec2) -> Vec2:
        """Return a world floor point in its own frame."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        x, y = point[0] - self.location[0], point[1] - self.location[1]
        return cos * x + sin * y, cos * y - sin * x

    def anchors_of(self, *kinds: str) -> list[Anchor]:
        """Return its anchors of these kinds, such as ``seat`` or ``top``."""
        return [anchor for anchor in self.anchors if anchor.kind in kinds]


@dataclass(frozen=True)
class SeatPlace:
    """A place for one sitter or one sleeper.

    Attributes:
        node_id: Node id of the furniture.
        anchor: Name of its anchor.
        edge: Middle of the front edge, world metres.
        yaw: Radians that the sitter faces.
    """

    node_id: str
    anchor: str
    edge: Vec2
    yaw: float

    def standing_spot(self, scale: float) -> Vec2:
        """Return the floor point in front of the seat for a person of a scale (stature over 1.7 m)."""
        return self.edge[0] + 0.18 * scale * math.sin(self.yaw), self.edge[1] - 0.18 * scale * math.cos(self.yaw)

    def is_blocked_by(self, spot: Vec3) -> bool:
        """Tell whether a prop at a world position lies where a person would sit."""
        sin, cos = math.sin(self.yaw), math.cos(self.yaw)
        x, y = spot[0] - self.edge[0], spot[1] - self.edge[1]
        aside, behind = abs(x * cos + y * sin), y * cos - x * sin
        return TOPS[0] < spot[2] < TOPS[1] and aside < SITTER_AREA[0] and 0 < behind < SITTER_AREA[1]


def has_room_on_top(thing: PlacedObject) -> bool:
    """Tell whether props can be put on an object: not into a flowerpot, not on a wardrobe."""
    top = next(iter(thing.anchors_of("top")), None)
    return top is not None and min(top.size) > ROOMY and TOPS[0] < thing.location[2] + top.location[2] < TOPS[1]


def is_put_on(thing: PlacedObject) -> bool:
    """Tell whether a prop that is said to be on an object can lie on its top: not on a tree or up on a mast."""
    top = next(iter(thing.anchors_of("top")), None)
    return thing.location[2] + (top.location[2] if top is not None else thing.size[2]) < (OVERHEAD if top else TOPS[1])


def has_seat_as_top(thing: PlacedObject) -> bool:
    """Tell whether the first top of an object is also its seat or bed."""
    top = thing.anchors_of("top")[0].location[2]
    return any(seat.location[2] > top - UNDERFOOT for seat in thing.anchors_of("seat", "bed"))
