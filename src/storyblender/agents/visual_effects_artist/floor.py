"""The floor of a scene as the Animator sees it: obstacles, free places, seats, beds and tops."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.agents.visual_effects_artist.placed_objects import (
    TOPS,
    PlacedObject,
    SeatPlace,
    has_room_on_top,
    has_seat_as_top,
)
from storyblender.catalog.bystanders import BYSTANDER
from storyblender.catalog.footprints import piece_boxes, wall_boxes
from storyblender.catalog.openings import OpeningPlace, openings_of
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_families import family_of, props_named
from storyblender.catalog.props.prop_names import props_of
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
"""Radius in metres, times stature over 1.7, of the disc that a standing person takes."""
PADDING = 0.10
"""Metres of room beside a walking person, where there is enough."""
DETOUR = 1.0
"""Most metres of detour to the best place at a thing."""
BACK = 0.6
"""Metres of detour that are worth working at a thing in profile instead of with the back to the audience."""
PERSONAL = 0.55
"""Metres between two people who have nothing to do with each other."""
WALK_ON_OUTDOORS, OFF_STAGE = 4.0, 0.3
"""Metres that people walk beyond the playing area towards a thing off stage, outdoors and under a roof."""


class Floor:
    """Everything in a scene that does not move. Floor points are in metres in the set.

    Args:
        layout: Placed objects; people in it are left out.
        assets: Assets with their canonical sizes and anchors.
        plan: Walls, solid pieces, marks.
    """

    def __init__(self, layout: Layout, assets: Sequence[Asset], plan: SetPlan) -> None:
        by_id = {asset.asset_id: asset for asset in assets}
        self.things: dict[str, PlacedObject] = {}
        for item in layout.objects:
            asset = by_id.get(item.asset_id)
            if asset is None or asset.asset_type != "object":
                continue
            canonical = asset.canonical
            size = canonical.dimensions if canonical else (0.4, 0.4, 0.4)
            anchors = canonical.anchors if canonical else ()
            yaw = math.radians(item.rotation[2])
            self.things[item.node_id] = PlacedObject(item.node_id, item.asset_id, item.location, yaw, size, anchors)
        self.sat_on = {item.anchor_asset_id for item in layout.objects if item.node_id.startswith(BYSTANDER)}
        size = layout.scene_size
        self.bounds = (size.x_negative, size.y_negative, size.x, size.y)
        self.open_air = not plan.indoor
        self.marks, self.plan = plan.marks, plan
        self.cast = {asset.asset_id for asset in assets if asset.asset_type == "character"}
        self.kinds = props_of(assets)
        self.openings = [_opening_object(place) for wall in plan.walls for place in openings_of(wall)]
        self.set_boxes = [_footprint(wall.node_id, box) for wall in plan.walls for box in wall_boxes(wall)]
        self.set_boxes += [_footprint(piece.node_id, box) for piece in plan.pieces for box in piece_boxes(piece)]

    def thing(self, name: str | None, near: Vec2 | None = None) -> PlacedObject | None:
        """Return a placed object by node id or asset id, or a door or window of the set by its kind; None if unknown.

        Args:
            name: Id.
            near: Floor point to take the nearest of several; None takes the first.
        """
        if not name or name in self.things:
            return self.things.get(name or "")
        kind = _OPENING_WORDS.get(name.rsplit("_", 1)[-1])
        found = [thing for thing in self.things.values() if thing.asset_id == name]
        found = found or [each for each in self.openings if kind in (each.asset_id, each.node_id)]
        if near is not None:
            found.sort(key=lambda thing: round(math.dist(thing.location[:2], near), 3))
        return found[0] if found else self._find_substitute(name)

    def _find_substitute(self, name: str) -> PlacedObject | None:
        """Return the placed object that takes the role of a large thing without a place: ``counter`` is the bar."""
        if name in self.cast:  # Ivy may be a character
            return None
        key = self.kinds.get(name)
        kin = family_of(key) if key is not None else props_named(name)
        large = any(PROPS[prop].placement == "floor" for prop in kin if prop in PROPS)
        middle = self.middle()
        found = [t for t in self.things.values() if large and self.kinds.get(t.asset_id) in kin]
        return min(found, key=lambda thing: math.dist(thing.location[:2], middle), default=None)

    def mark_of(self, name: str | None) -> Vec2 | None:
        """Return the floor point of the set mark with a name or tag, such as stairs or an altar; None if unknown."""
        word = (name or "").rsplit("_", 1)[-1]
        found = (mark for mark in self.marks if word and (mark.name == word or word in mark.tags))
        return next((mark.location[:2] for mark in found), None)

    def enter_marks(self) -> list[Vec2]:
        """Return the floor points at which people enter the set."""
        return [mark.location[:2] for mark in self.marks if "enter" in mark.tags]

    def exit_marks(self) -> list[Vec2]:
        """Return the floor points at which people leave the set."""
        return [mark.location[:2] for mark in self.marks if "exit" in mark.tags] or self.enter_marks()

    def middle(self) -> Vec2:
        """Return the middle of the playing area."""
        x0, y0, x1, y1 = self.bounds
        return (x0 + x1) / 2, (y0 + y1) / 2

    def obstacles(self, skip: Iterable[str] = ()) -> list[Footprint]:
        """Return the outlines of everything solid but the things in ``skip`` (node ids or asset ids)."""
        left_out = set(skip)
        solid = [t.footprint for t in self.things.values() if t.solid and not {t.node_id, t.asset_id} & left_out]
        return solid + self.set_boxes

    def room_at(self, point: Vec2, skip: Iterable[str] = ()) -> float:
        """Return the metres from a point to the nearest obstacle, negative inside one; ``skip`` as in `obstacles`."""
        return float(clearance(np.array([point]), self.obstacles(skip))[0])

    def inside(self, point: Vec2, margin: float = 0.0) -> bool:
        """Tell whether a point is within the playing area, at least ``margin`` metres from its edge."""
        x0, y0, x1, y1 = self.bounds
        return x0 + margin <= point[0] <= x1 - margin and y0 + margin <= point[1] <= y1 - margin

    @property
    def walk_on_distance(self) -> float:
        """Metres beyond the playing area at which people may end a walk."""
        return WALK_ON_OUTDOORS if self.open_air else OFF_STAGE

    def path(self, start: Vec2, goal: Vec2, scale: float, people: Sequence[Vec2] = ()) -> list[Vec2] | None:
        """Return the way of a walk as floor points, past furniture and people; None if there is none.

        Args:
            start: First floor point.
            goal: Last floor point.
            scale: Stature of the walker over 1.7 m.
            people: Floor points of people who stand in the way.
        """
        others = [Footprint(point, (0.0, 0.0), 0.0, 0.8 * BODY) for point in people]
        obstacles = [box for box in self.obstacles() if float(clearance(np.array([start]), [box])[0]) > -0.02]
        boxes = obstacles + others
        wide = find_path(start, goal, boxes, self.bounds, BODY * scale + PADDING)
        return wide or find_path(start, goal, boxes, self.bounds, SQUEEZE_RADIUS * scale)

    def free_spot(
        self,
        wish: Vec2,
        scale: float,
        people: Sequence[Vec2] = (),
        *,
        room: float | None = None,
        apart: float = PERSONAL,
    ) -> Vec2:
        """Return the floor point nearest to a wish at which a person fits; the wish itself if there is none.

        Args:
            wish: Wished floor point.
            scale: Stature over 1.7 m.
            people: Floor points of other people.
            room: Least metres to obstacles; None for a standing body.
            apart: Least metres to other people.
        """
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

    def spot_around(self, point: Vec2, start: Vec2, scale: float, people: Sequence[Vec2], reach: float) -> Vec2 | None:
        """Return the free floor point near a point that is easiest to walk to and to reach from; None if none is free.

        Args:
            point: Floor point to be reached.
            start: Floor point of the person.
            scale: Stature over 1.7 m.
            people: Floor points of other people.
            reach: Metres of the arm.
        """
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
        fitting.sort(
            key=lambda s: math.dist(s, start) + 3.0 * math.dist(s, point) + BACK * _share_back_turned(s, point)
        )
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
            asked: Whether the script seats a person on it, even if it is no seat.
            on_top: Whether the script seats them on top of it, however high or narrow it is.
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
                edge = thing.to_world((x + right[0] * slide, y + right[1] * slide, z))
                places.append(SeatPlace(thing.node_id, anchor.name, edge[:2], yaw))
        return places

    def free_seats(self, name: str | None, taken: Sequence[Vec2]) -> list[SeatPlace]:
        """Return the seats of a thing, or of the whole set, that nobody sits on.

        Args:
            name: Node id or asset id of the thing; None for the whole set. A thing that lies on a table has no seat.
            taken: Seat edges of the people who sit.
        """
        named = [t for t in self.things.values() if name in (None, t.node_id, t.asset_id)]
        named = [t for t in named if t.location[2] <= TOPS[0] or t.anchors_of("seat", "bed")]
        seats = [seat for t in named for seat in self.seats(t.node_id, asked=name is not None)]
        return [seat for seat in seats if all(math.dist(seat.edge, spot) > 0.4 for spot in taken)]

    def seat_access(self, seat: SeatPlace, scale: float) -> Vec2:
        """Return the floor point from which a person sits down: in front, or beside a seat at a table.

        Args:
            seat: A seat of a thing on the floor.
            scale: Stature of the person over 1.7 m.
        """
        thing = self.things[seat.node_id]
        return find_seat_access(seat.edge, seat.yaw, thing.size[0], scale, self.obstacles(), seat.node_id)

    def bed_edges(self, name: str | None) -> list[tuple[SeatPlace, float]]:
        """Return each long edge of a bed as a seat to lie down from, and the yaw (radians) from head to feet."""
        thing = self.thing(name)
        if thing is None:
            return []
        places: list[tuple[SeatPlace, float]] = []
        for anchor in thing.anchors_of("bed"):
            x, y, z = anchor.location
            dx, dy, _ = anchor.direction
            half = (anchor.size[0] or 0.9) / 2
            for side in (1, -1):
                edge = thing.to_world((x - dy * half * side, y + dx * half * side, z))
                out = math.atan2(-dy * side, -dx * side)
                yaw = thing.yaw + out
                places.append((SeatPlace(thing.node_id, anchor.name, edge[:2], yaw), thing.yaw + math.atan2(dx, -dy)))
        return places

    def nearest_point_on_top(self, thing: PlacedObject, near: Vec2) -> Vec3:
        """Return the world point on a thing's top that is nearest to a floor point, 0.13 m in from the edge."""
        anchor = next(iter(thing.anchors_of("top")), None)
        x, y, z = anchor.location if anchor else (0.0, 0.0, thing.size[2])
        half = [max(0.0, (anchor.size[i] if anchor else thing.size[i]) / 2 - 0.13) for i in (0, 1)]
        lx, ly = thing.to_local(near)
        spot = (x + max(-half[0], min(half[0], lx - x)), y + max(-half[1], min(half[1], ly - y)), z)
        return thing.to_world(spot)

    def point_on_top(self, thing: PlacedObject, point: Vec2) -> Vec3 | None:
        """Return the world point of a thing's top above a floor point; None if no top is there."""
        x, y = thing.to_local(point)
        for top in thing.anchors_of("top"):
            if abs(x - top.location[0]) <= top.size[0] / 2 and abs(y - top.location[1]) <= top.size[1] / 2:
                return thing.to_world((x, y, top.location[2]))
        return None

    def nearest_top(self, point: Vec2, within: float, highest: float = TOPS[1]) -> PlacedObject | None:
        """Return the nearest thing with a top for props; one whose top is a seat only if there is no other.

        Args:
            point: Floor point of the person.
            within: Most metres to the top.
            highest: Most metres of the top above the floor.
        """
        tops = [
            t for t in self.things.values() if has_room_on_top(t) and self.nearest_point_on_top(t, point)[2] < highest
        ]
        away = {t.node_id: math.dist(self.nearest_point_on_top(t, point)[:2], point) for t in tops}
        near = [t for t in tops if away[t.node_id] < within]
        return min(near, key=lambda t: (has_seat_as_top(t), away[t.node_id]), default=None)


def _share_back_turned(spot: Vec2, point: Vec2) -> float:
    """Return 1 if a person at ``spot`` who works at ``point`` turns their back to the audience, 0 from profile on."""
    return max(0.0, (point[1] - spot[1]) / max(math.dist(spot, point), 0.01))


def facing(start: Vec2, goal: Vec2) -> float:
    """Return the yaw (radians, counter-clockwise) from one floor point to another; 0 is -Y, towards the audience."""
    return math.atan2(goal[0] - start[0], start[1] - goal[1])


_OPENING_WORDS = {
    **dict.fromkeys(("door", "doors", "doorway", "entrance", "exit", "threshold"), "door"),
    **dict.fromkeys(("window", "windows", "windowsill", "sill"), "window"),
}


def _opening_object(place: OpeningPlace) -> PlacedObject:
    """Return a door or window as a placed object to walk to."""
    kind = place.opening.kind
    handles = (Anchor(kind="handle", location=place.handle),) if kind == "door" else ()
    return PlacedObject(place.opening.name, kind, place.location, place.yaw, place.size, handles)


def _footprint(name: str, box: Box) -> Footprint:
    return Footprint((box.x, box.y), (box.width, box.depth), box.yaw, name=name)
