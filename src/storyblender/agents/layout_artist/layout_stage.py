"""The stage while a scene is laid out: what stands on it, and where there is room."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from storyblender.agents.layout_artist.layout_things import (
    assign_surfaces,
    mass_of,
    room_of,
    size_of,
    thing_of,
    walls_of,
)
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.catalog.fixtures import Fixture, fixtures_called
from storyblender.catalog.props.prop_families import family_of, props_named
from storyblender.geometry.boxes import Box
from storyblender.geometry.lanes import blocks_walkers
from storyblender.geometry.paths import Footprint, clearance
from storyblender.geometry.relations import LayoutThing
from storyblender.memory.base import content_hash
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import LayoutObject

_GRID = 0.2
"""Metres between the places tried."""
_SEEN, _BEHIND = 0.55, 5.5
"""Metres of height from which a thing is visible behind people; metres behind them up to which it is."""
_RAYS = np.linspace(-28.0, 28.0, 9)
"""Degrees to either side of the audience's viewing direction in which the background is sampled."""
_GOLDEN = math.radians(137.5)
"""Angle from one staging's middle to the next."""
_EDGE = 0.3
"""Metres kept from the border of the playing area."""


class LayoutStage:
    """Placed things by name, and questions about the room between them. Floor points are in metres in the set.

    Args:
        view: The scene; its dressed furniture and what an earlier scene left in the place stand already.

    Attributes:
        room: The playing area.
        walls: Walls and solid parts of the set.
        things: Placed things by name, which is their node id.
        assets: Asset id of each placed thing, by name.
    """

    def __init__(self, view: SpatialPlannerView) -> None:
        self.view = view
        self.room = room_of(view.plan.size)
        self.walls = walls_of(view.plan)
        self.things: dict[str, LayoutThing] = {}
        self.assets: dict[str, str] = {}
        self._dressed: NDArray[np.float64] | None = None
        for item in view.dressed:
            self.add_object(item, fixed=True)
        for item in self._objects_left_by_earlier_scene():
            self.add_object(item, fixed=True)

    def _objects_left_by_earlier_scene(self) -> list[LayoutObject]:
        """Return the objects of the earlier scene in this place that the scene names, if what they lie on is there."""
        objects = self.view.reference.objects if self.view.reference is not None else ()
        wanted = {*self.view.pending, *self.view.setup.asset_ids}
        asked = [
            item
            for item in objects
            if item.asset_id in wanted
            and item.node_id not in self.things
            and self.measure(item.asset_id).asset_type == "object"
        ]
        names = {*self.things, *(item.node_id for item in asked)}
        while lost := [item for item in asked if item.anchor_asset_id not in {None, *names}]:
            asked = [item for item in asked if item not in lost]
            names -= {item.node_id for item in lost}
        return asked

    def add_object(self, item: LayoutObject, fixed: bool) -> None:
        """Place an object of a layout; one whose asset has no measure is left out.

        Args:
            item: Location in world metres, rotation in degrees.
            fixed: Keep the solver from moving it; things that hang are never moved.
        """
        thing = thing_of(item, self.view.measures, self.view.plan, self.view.placements)
        if thing is not None:
            thing.fixed = fixed or thing.floats
            self.add(thing, item.asset_id)
            assign_surfaces([thing, *self.things.values()], self.assets, self.view.measures)

    def add(self, thing: LayoutThing, asset_id: str) -> None:
        """Add a thing, in place of any of the same name.

        Args:
            thing: Its name is its node_id; its box is in world metres.
            asset_id: The asset that it shows.
        """
        self.things[thing.name], self.assets[thing.name] = thing, asset_id
        self._dressed = None

    def place(self, asset_id: str, box: Box, **asked: object) -> None:
        """Place a thing of the script; its asset_id becomes its name.

        Args:
            asset_id: The thing.
            box: Where it stands, world metres.
            **asked: Further fields of its ``LayoutThing``, such as ``anchor`` or ``fixed``.
        """
        mass = mass_of((box.width, box.depth, box.height))
        self.add(LayoutThing(asset_id, box, mass=mass, **asked), asset_id)  # pyright: ignore[reportArgumentType]

    def pick(self, what: str, count: int) -> int:
        """Return which of some equally good places to take, the best one first: another one in another staging.

        Args:
            what: What is placed, or what at: the same gets the same place throughout a staging.
            count: How many places there are.
        """
        if not self.view.staging or count < 2:
            return 0
        return int(content_hash("staging", self.view.staging, what)[:8], 16) % count

    @property
    def middle(self) -> tuple[float, float]:
        """Floor point in the middle: the set's mark for it, else the middle of the playing area."""
        mark = next((mark for mark in self.view.plan.marks if "centre" in mark.tags), None)
        if mark is not None:
            return mark.location[0], mark.location[1]
        return (self.room.x_min + self.room.x_max) / 2, (self.room.y_min + self.room.y_max) / 2

    @property
    def acting_place(self) -> tuple[float, float]:
        """Floor point where people act whom nothing places: the middle.

        In another staging it is elsewhere, each further one a golden angle around the middle, nearer or farther.
        """
        x, y = self.middle
        if not self.view.staging:
            return x, y
        angle, share = self.view.staging * _GOLDEN, 0.35 + 0.2 * (self.view.staging % 3)
        x += math.cos(angle) * share * (self.room.x_max - self.room.x_min) / 2
        y += math.sin(angle) * share * (self.room.y_max - self.room.y_min) / 2
        spare_x, spare_y = ((high - low) / 5 for low, high in self._extents)
        (x_min, x_max), (y_min, y_max) = self._extents
        return min(max(x, x_min + spare_x), x_max - spare_x), min(max(y, y_min + spare_y), y_max - spare_y)

    @property
    def _extents(self) -> tuple[tuple[float, float], tuple[float, float]]:
        return (self.room.x_min, self.room.x_max), (self.room.y_min, self.room.y_max)

    def measure(self, asset_id: str) -> AssetMeasure:
        """Return an asset's measure; that of a cube of 0.4 m if it is unknown."""
        known = self.view.measures.get(asset_id)
        return known or AssetMeasure(asset_id=asset_id, digest="", geometry_hash="", dimensions=(0.4, 0.4, 0.4))

    def find(self, asset_id: str | None, near: tuple[float, float] = (0.0, 0.0)) -> LayoutThing | None:
        """Return the thing with that name, else the thing that shows the asset and is nearest to a floor point.

        Args:
            asset_id: A node_id or an asset_id; None finds nothing.
            near: Floor point, metres.
        """
        if asset_id is None:
            return None
        if asset_id in self.things:
            return self.things[asset_id]
        shown = [thing for name, thing in self.things.items() if self.assets[name] == asset_id]
        return min(shown, key=lambda thing: math.dist((thing.box.x, thing.box.y), near), default=None)

    def find_anchor(self, asset_id: str | None, near: tuple[float, float] | None = None) -> LayoutThing | None:
        """Return the thing for an anchor id: the thing itself, a related prop, or a part of the set; else None.

        Args:
            asset_id: A node_id, an asset_id or a name of a part of the set; None finds nothing.
            near: Floor point, metres; the nearest of several is returned. None takes ``middle``.
        """
        asked, near = near, near or self.middle
        thing = self.find(asset_id, near)
        if thing is not None or asset_id is None or asset_id in self.view.pending:
            return thing
        prop = self.view.props.get(asset_id)
        kin = family_of(prop) if prop is not None else props_named(asset_id)
        alike = [thing for name, thing in self.things.items() if self.view.props.get(self.assets[name]) in kin]
        if alike:
            return min(alike, key=lambda thing: math.dist((thing.box.x, thing.box.y), near))
        fixture = self.find_fixture(asset_id, asked)
        return LayoutThing(fixture.name, fixture.box, fixed=True, floats=True) if fixture is not None else None

    def find_fixture(self, name: str | None, near: tuple[float, float] | None = None) -> Fixture | None:
        """Return the part of the set with a name; None if the set has none.

        Args:
            name: An id or words, such as ``doorway`` or ``the back wall``; None finds nothing.
            near: Floor point, metres; the nearest of equal matches is returned. None takes ``middle``.
        """
        found = fixtures_called(self.view.plan, name)
        middle = near or self.middle
        sure = [fixture for fixture in found if fixture.kind == found[0].kind and fixture.tags == found[0].tags]
        if self.view.staging and near is None:  # of several windows another one
            alike = [{tag for tag in fixture.tags if not tag.isdigit()} for fixture in found]
            sure = [fixture for fixture, tags in zip(found, alike, strict=True) if tags == alike[0]]
        sure.sort(key=lambda each: math.dist((each.box.x, each.box.y), middle))
        return sure[self.pick(str(name), len(sure)) if near is None else 0] if sure else None

    def box(self, asset_id: str, x: float, y: float, z: float = 0.0, yaw: float = 0.0) -> Box:
        """Return the box of an asset at a place in the set.

        Args:
            asset_id: The asset; without a measure it counts as a cube of 0.4 m.
            x: Metres, of its middle.
            y: Metres, of its middle.
            z: Metres, of its lower face.
            yaw: Radians, counter-clockwise; 0 faces -Y.
        """
        return Box(x, y, z, *size_of(self.measure(asset_id)), yaw)

    def free_spot(
        self,
        near: tuple[float, float],
        radius: float,
        suits: Callable[[float, float], float] = lambda x, y: 0.0,
    ) -> tuple[float, float]:
        """Return the floor point nearest to a wish with free floor around it.

        Args:
            near: Wished floor point.
            radius: Metres to be free.
            suits: Returns the penalty of a floor point, in metres.
        """
        x0, x1, y0, y1 = self.room
        edge = min(_EDGE, (x1 - x0) / 4, (y1 - y0) / 4)
        xs = np.arange(x0 + edge, x1 - edge + 1e-6, _GRID)
        ys = np.arange(y0 + edge, y1 - edge + 1e-6, _GRID)
        points = np.array([near, *((x, y) for x in xs for y in ys)])
        points[0] = np.clip(points[0], (x0 + edge, y0 + edge), (x1 - edge, y1 - edge))
        cost = np.hypot(*(points - near).T) + 4 * np.maximum(radius - self.clearance(points), 0)
        cost += np.array([suits(float(x), float(y)) for x, y in points])
        x, y = points[int(np.argmin(np.round(cost, 6)))]
        return float(x), float(y)

    def backdrop(self, x: float, y: float) -> float:
        """Return the share of the view behind a floor point, from the audience, that the set fills: 0 for a bare wall.

        Args:
            x: Metres across the set.
            y: Metres into the depth of the set.
        """
        if self._dressed is None:
            solid = [thing.box for thing in self.things.values() if not thing.walks and thing.box.top > _SEEN]
            found = fixtures_called(self.view.plan, "window") + fixtures_called(self.view.plan, "door")
            boxes = [*solid, *(fixture.box for fixture in found)]
            self._dressed = np.array([(box.x, box.y, max(box.width, box.depth) / 2) for box in boxes]).reshape(-1, 3)
        ahead = self._dressed[:, 1] - y
        near = self._dressed[(ahead > 0.5) & (ahead < _BEHIND)]
        if not len(near):
            return 0.0
        middle = np.degrees(np.arctan2(near[:, 0] - x, near[:, 1] - y))
        half = np.degrees(np.arctan2(near[:, 2], near[:, 1] - y)) + 3.0
        hit = np.abs(_RAYS[:, None] - middle) <= half
        return float(hit.any(axis=1).mean())

    def clearance(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return (n,) metres from each of (n, 2) floor points to the nearest obstacle or person."""
        solid = [thing for thing in (*self.things.values(), *self.walls) if thing.walks or blocks_walkers(thing)]
        footprints = [
            Footprint((thing.box.x, thing.box.y), (thing.box.width, thing.box.depth), thing.box.yaw) for thing in solid
        ]
        return clearance(points, footprints)
