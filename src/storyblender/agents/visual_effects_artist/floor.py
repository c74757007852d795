"""The floor of a scene as the Animator sees it: what stands where, where there is room, where one can sit. Pure."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.agents.visual_effects_artist.placed_things import (
    TOPS,
    SeatPlace,
    Thing,
    has_room_on_top,
    is_seat,
)
from storyblender.catalog.bystanders import BYSTANDER
from storyblender.catalog.footprints import piece_boxes, wall_boxes
from storyblender.catalog.openings import OpeningPlace, openings_of
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.kin import kin_of, meant_by
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box
from storyblender.geometry.paths import (
    SQUEEZE_RADIUS,
    Footprint,
    Vec2,
    clearance,
    find_path,
    find_seat_access,
    path_length,
)
from storyblender.geometry.seating import list_seats
from storyblender.memory.asset_sheet import Anchor, Asset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Layout

BODY = 0.24
"""Metres, times stature over 1.7: the disc a standing person takes."""
PADDING = 0.10
DETOUR = 1.0
"""Metres farther than straight that somebody goes for the best place at a thing."""
BACK = 0.6
"""Metres that somebody goes round a thing to work at it in profile."""
PERSONAL = 0.55
"""Metres between two people who have nothing to do with each other."""
WAY_OUT, OFF_STAGE = 4.0, 0.3
"""Metres that somebody walks on towards what stands off stage, in the open and under a roof."""


class Floor:
    """Everything that does not move during the scene.

    Args:
        layout: Placed objects; people in it are left out.
        assets: With their canonical sizes and anchors.
        plan: Walls, solid pieces, marks.
    """

    def __init__(self, layout: Layout, assets: Sequence[Asset], plan: SetPlan) -> None:
        by_id = {asset.asset_id: asset for asset in assets}
        self.things: dict[str, Thing] = {}
        for item in layout.objects:
            asset = by_id.get(item.asset_id)
            if asset is None or asset.asset_type != "object":
                continue
            canonical = asset.canonical
            size = canonical.dimensions if canonical else (0.4, 0.4, 0.4)
            anchors = canonical.anchors if canonical else ()
            yaw = math.radians(item.rotation[2])
            self.things[item.node_id] = Thing(item.node_id, item.asset_id, item.location, yaw, size, anchors)
        self.sat_on = {item.anchor_asset_id for item in layout.objects if item.node_id.startswith(BYSTANDER)}
        size = layout.scene_size
        self.bounds = (size.x_negative, size.y_negative, size.x, size.y)
        self.open_air = not plan.indoor
        self.marks, self.plan = plan.marks, plan
        self.cast = {asset.asset_id for asset in assets if asset.asset_type == "character"}
        made = ((asset.asset_id, asset.canonical) for asset in assets)
        self.kinds = {name: each.key for name, each in made if each is not None and each.source == "catalog"}
        self.openings = [_opening(place) for wall in plan.walls for place in openings_of(wall)]
        self.set_boxes = [_footprint(wall.node_id, box) for wall in plan.walls for box in wall_boxes(wall)]
        self.set_boxes += [_footprint(piece.node_id, box) for piece in plan.pieces for box in piece_boxes(piece)]

    def thing(self, name: str | None, near: Vec2 | None = None) -> Thing | None:
        """Return a placed object by node id or asset id, or a door or window of the set by its kind.

        Args:
            name: Id.
            near: Where to look first if there are several; None takes the first.
        """
        if not name or name in self.things:
            return self.things.get(name or "")
        kind = _OPENING_WORDS.get(name.rsplit("_", 1)[-1])
        found = [thing for thing in self.things.values() if thing.asset_id == name]
        found = found or [each for each in self.openings if kind in (each.asset_id, each.node_id)]
        if near is not None:
            found.sort(key=lambda thing: round(math.dist(thing.location[:2], near), 3))
        return found[0] if found else self._alike(name)

    def _alike(self, name: str) -> Thing | None:
        """Return the thing that stands for a large thing without a place of its own: ``counter`` means the bar."""
        if name in self.cast:  # Ivy may be a character
            return None
        key = self.kinds.get(name)
        kin = kin_of(key) if key is not None else meant_by(name)
        large = any(PROPS[prop].placement == "floor" for prop in kin if prop in PROPS)
        middle = (self.bounds[0] + self.bounds[2]) / 2, (self.bounds[1] + self.bounds[3]) / 2
        found = [t for t in self.things.values() if large and self.kinds.get(t.asset_id) in kin]
        return min(found, key=lambda thing: math.dist(thing.location[:2], middle), default=None)

    def mark_of(self, name: str | None) -> Vec2 | None:
        """Return the place of the set that has a name: stairs, an altar."""
        word = (name or "").rsplit("_", 1)[-1]
        found = (mark for mark in self.marks if word and (mark.name == word or word in mark.tags))
        return next((mark.location[:2] for mark in found), None)

    def obstacles(self, skip: Iterable[str] = ()) -> list[Footprint]:
        """Return everything solid but the things in ``skip`` (node ids or asset ids)."""
        left_out = set(skip)
        solid = [t.footprint for t in self.things.values() if t.solid and not {t.node_id, t.asset_id} & left_out]
        return solid + self.set_boxes

    def room_at(self, point: Vec2, skip: Iterable[str] = ()) -> float:
        """Return the distance to the nearest obstacle, negative inside one."""
        return float(clearance(np.array([point]), self.obstacles(skip))[0])

    def inside(self, point: Vec2, margin: float = 0.0) -> bool:
        """Tell whether a point is within the playing area."""
        x0, y0, x1, y1 = self.bounds
        return x0 + margin <= point[0] <= x1 - margin and y0 + margin <= point[1] <= y1 - margin

    @property
    def beyond(self) -> float:
        """Metres from the playing area that people may end a way."""
        return WAY_OUT if self.open_air else OFF_STAGE

    def path(self, start: Vec2, goal: Vec2, scale: float, people: Sequence[Vec2] = ()) -> list[Vec2] | None:
        """Return the way for a person of scale ``scale`` past furniture and people who stand."""
        others = [Footprint(point, (0.0, 0.0), 0.0, 0.8 * BODY) for point in people]
        obstacles = [box for box in self.obstacles() if float(clearance(np.array([start]), [box])[0]) > -0.02]
        boxes = obstacles + others
        wide = find_path(start, goal, boxes, self.bounds, BODY * scale + PADDING)
        return wide or find_path(start, goal, boxes, self.bounds, SQUEEZE_RADIUS * scale)

    def free_near(
        self,
        wish: Vec2,
        scale: float,
        people: Sequence[Vec2] = (),
        *,
        room: float | None = None,
        apart: float = PERSONAL,
    ) -> Vec2:
        """Return the spot nearest to a wish where a person fits; the wish itself where nothing is better."""
        need = BODY * scale + 0.04 if room is None else room
        x0, y0, x1, y1 = self.bounds
        wish = (max(x0 + 0.2, min(x1 - 0.2, wish[0])), max(y0 + 0.2, min(y1 - 0.2, wish[1])))
        rings = [(0.0, 0.0)]
        for radius in np.arange(0.15, 2.6, 0.15):
            count = max(8, int(2 * math.pi * radius / 0.2))
            turns = np.linspace(0, 2 * math.pi, count, endpoint=False)
            rings += [(float(radius * math.sin(a)), float(-radius * math.cos(a))) for a in turns]
        points: NDArray[np.float64] = np.array([(wish[0] + dx, wish[1] + dy) for dx, dy in rings])
        fits = clearance(points, self.obstacles()) >= need
        for person in people:
            fits &= np.hypot(*(points - person).T) >= apart
        fits &= np.array([self.inside((p[0], p[1]), 0.15) for p in points])
        found = np.flatnonzero(fits)
        best = points[found[0]] if len(found) else points[0]
        return float(best[0]), float(best[1])

    def spot_at(self, point: Vec2, start: Vec2, scale: float, people: Sequence[Vec2], reach: float) -> Vec2 | None:
        """Return the free spot around a point, within reach of it, that is easiest to come to and to reach from."""
        around = [
            (point[0] + r * math.sin(a), point[1] - r * math.cos(a))
            for r in (0.75 * reach, 0.9 * reach, 1.05 * reach, 1.2 * reach)
            for a in np.linspace(0, 2 * math.pi, 16, endpoint=False)
        ]
        room = clearance(np.array(around), self.obstacles())
        fitting = [
            spot
            for spot, free in zip(around, room, strict=True)
            if free > BODY * scale + 0.02 and self.inside(spot) and all(math.dist(spot, p) > 0.45 for p in people)
        ]
        fitting.sort(key=lambda s: math.dist(s, start) + 3.0 * math.dist(s, point) + BACK * _back_turned(s, point))
        best: tuple[float, Vec2] | None = None
        for spot in fitting[:24]:
            way = self.path(start, spot, scale)
            detour = math.inf if way is None else path_length(way) - math.dist(start, spot)
            if detour < DETOUR:
                return spot
            best = min(best or (math.inf, spot), (detour, spot))
        return best[1] if best is not None and best[0] < math.inf else None

    def seats(self, name: str | None, *, asked: bool = False, on_top: bool = False) -> list[SeatPlace]:
        """Return the places to sit on a thing; wide seats hold several people.

        Args:
            name: Node id or asset id.
            asked: Whether the script says that somebody sits on it, even if it is no seat.
            on_top: Whether it says that they sit on top of it, however high or narrow it is.
        """
        thing = self.thing(name)
        if thing is None or thing.node_id in self.sat_on:
            return []
        places: list[SeatPlace] = []
        for anchor in list_seats(thing.anchors, thing.size, asked=asked, on_top=on_top):
            x, y, z = anchor.location
            dx, dy, _ = anchor.direction
            yaw = thing.yaw + math.atan2(dx, -dy)
            count = max(1, int((anchor.size[0] + 0.15) / 0.62))
            right = (-dy, dx)
            for index in range(count):
                slide = (index - (count - 1) / 2) * 0.6
                edge = thing.world((x + right[0] * slide, y + right[1] * slide, z))
                places.append(SeatPlace(thing.node_id, anchor.name, edge[:2], yaw))
        return places

    def free_seats(self, name: str | None, taken: Sequence[Vec2]) -> list[SeatPlace]:
        """Return the seats of a thing, or of the whole set, on which nobody is.

        Args:
            name: Node id or asset id of what the script says one sits on; what lies on a table is not sat on.
            taken: Edges of the seats of those who sit.
        """
        named = [t for t in self.things.values() if name in (None, t.node_id, t.asset_id)]
        named = [t for t in named if t.location[2] <= TOPS[0] or t.of_kind("seat", "bed")]
        seats = [seat for t in named for seat in self.seats(t.node_id, asked=name is not None)]
        return [seat for seat in seats if all(math.dist(seat.edge, spot) > 0.4 for spot in taken)]

    def access(self, seat: SeatPlace, scale: float) -> Vec2:
        """Return where one stands before sitting down: in front, or beside a seat at a table."""
        thing = self.things[seat.node_id]
        return find_seat_access(seat.edge, seat.yaw, thing.size[0], scale, self.obstacles(), seat.node_id)

    def beds(self, name: str | None) -> list[tuple[SeatPlace, float]]:
        """Return each long edge of a bed as a place to sit before lying down, and the yaw from head to feet."""
        thing = self.thing(name)
        if thing is None:
            return []
        places: list[tuple[SeatPlace, float]] = []
        for anchor in thing.of_kind("bed"):
            x, y, z = anchor.location
            dx, dy, _ = anchor.direction
            half = (anchor.size[0] or 0.9) / 2
            for side in (1, -1):
                edge = thing.world((x - dy * half * side, y + dx * half * side, z))
                out = math.atan2(-dy * side, -dx * side)
                yaw = thing.yaw + out
                places.append((SeatPlace(thing.node_id, anchor.name, edge[:2], yaw), thing.yaw + math.atan2(dx, -dy)))
        return places

    def top_of(self, thing: Thing, near: Vec2) -> Vec3:
        """Return the point on a thing's top that is nearest to somebody, a hand's breadth in from the edge."""
        anchor = next(iter(thing.of_kind("top")), None)
        x, y, z = anchor.location if anchor else (0.0, 0.0, thing.size[2])
        half = [max(0.0, (anchor.size[i] if anchor else thing.size[i]) / 2 - 0.13) for i in (0, 1)]
        lx, ly = thing.local(near)
        spot = (x + max(-half[0], min(half[0], lx - x)), y + max(-half[1], min(half[1], ly - y)), z)
        return thing.world(spot)

    def on_top(self, thing: Thing, point: Vec2) -> Vec3 | None:
        """Return the point of a thing's top that is under a point of the floor plan; None where there is no top."""
        x, y = thing.local(point)
        for top in thing.of_kind("top"):
            if abs(x - top.location[0]) <= top.size[0] / 2 and abs(y - top.location[1]) <= top.size[1] / 2:
                return thing.world((x, y, top.location[2]))
        return None

    def nearest_top(self, point: Vec2, within: float, highest: float = TOPS[1]) -> Thing | None:
        """Return the nearest thing with a top to put something on; what is sat on is none where there is another.

        Args:
            point: From where.
            within: Metres.
            highest: Metres above the floor that a hand comes to.
        """
        tops = [t for t in self.things.values() if has_room_on_top(t) and self.top_of(t, point)[2] < highest]
        away = {t.node_id: math.dist(self.top_of(t, point)[:2], point) for t in tops}
        near = [t for t in tops if away[t.node_id] < within]
        return min(near, key=lambda t: (is_seat(t), away[t.node_id]), default=None)


def _back_turned(spot: Vec2, point: Vec2) -> float:
    """Return 1 where who works at a point turns their back to the audience at -Y, 0 where they show a profile."""
    return max(0.0, (point[1] - spot[1]) / max(math.dist(spot, point), 0.01))


def facing(start: Vec2, goal: Vec2) -> float:
    """Return the yaw, radians, that faces from one point to another."""
    return math.atan2(goal[0] - start[0], start[1] - goal[1])


_OPENING_WORDS = {
    **dict.fromkeys(("door", "doors", "doorway", "entrance", "exit", "threshold"), "door"),
    **dict.fromkeys(("window", "windows", "windowsill", "sill"), "window"),
}


def _opening(place: OpeningPlace) -> Thing:
    """A door or window as a thing one can go to."""
    kind = place.opening.kind
    handles = (Anchor(kind="handle", location=place.handle),) if kind == "door" else ()
    return Thing(place.opening.name, kind, place.location, place.yaw, place.size, handles)


def _footprint(name: str, box: Box) -> Footprint:
    return Footprint((box.x, box.y), (box.width, box.depth), box.yaw, name=name)
