"""Accepted layouts with errors put into them by seed: things turned, on the wrong side, in each other, in the air.

Before that every thing without a place beside another gets one in the paper's words, as its Spatial Planner would have
written it: the nearest other thing as its anchor, on which side of it, touching or not, and which way it faces.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from benchmarks.staged_scenes import StagedScene

from storyblender.agents.layout_artist.layout_things import layout_violations, thing_of
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.geometry.boxes import footprint_gap, vertical_gap, wrap_angle
from storyblender.geometry.relations import (
    BEARING,
    BEARING_TOLERANCE,
    CONTACT_DISTANCE,
    DIRECTION_TOLERANCE,
    DIRECTION_TURN,
    LayoutThing,
    bearing_error,
    may_overlap_anchor,
    wanted_yaw,
)
from storyblender.memory.scene_context import Layout, LayoutObject

_SURE = math.radians(5)
"""Radians from the edge of a sector within which nothing is written down: it would hold by luck."""
_NEAR = 4.0
"""Metres within which one thing is an anchor of another."""
_SHARE = 0.6
"""Share of the things that get an error."""


@dataclass(frozen=True)
class CorruptedLayout:
    """A layout with errors.

    Attributes:
        name: Script, scene and seed.
        view: The scene.
        sound: The layout before, in the paper's words; no fault is in it.
        layout: The layout with errors.
        seed: Its seed.
    """

    name: str
    view: SpatialPlannerView
    sound: Layout
    layout: Layout
    seed: int


def corrupted_layouts(scenes: Sequence[StagedScene], count: int, first: int = 0) -> list[CorruptedLayout]:
    """Return layouts with errors, of all scenes in turn that have something to corrupt.

    Args:
        scenes: Staged scenes.
        count: How many.
        first: The first seed.
    """
    sound = [(scene, worded(scene.layout, scene.view)) for scene in scenes if free_things(scene.layout, scene.view)]
    found: list[CorruptedLayout] = []
    for number in range(count):
        scene, layout = sound[number % len(sound)]
        seed = first + number
        broken = corrupted(layout, scene.view, seed)
        found.append(CorruptedLayout(f"{scene.name} {seed}", scene.view, layout, broken, seed))
    return found


def free_things(layout: Layout, view: SpatialPlannerView) -> list[LayoutObject]:
    """Return the objects of a layout that the Spatial Planner places: neither dressing of the set nor hung."""
    standing = {item.node_id for item in view.dressed}
    return [item for item in layout.objects if item.node_id not in standing and not item.fixed]


def worded(layout: Layout, view: SpatialPlannerView) -> Layout:
    """Return a layout whose things have a place beside another in the paper's words; it stays as valid as it was."""
    things = {item.node_id: thing for item in layout.objects if (thing := thing_of(item, view.measures, view.plan))}
    free = {item.node_id for item in free_things(layout, view)}
    said = tuple(
        _said(item, things[item.node_id], things) if item.node_id in free and item.node_id in things else item
        for item in layout.objects
    )
    return layout.model_copy(update={"objects": said})


def _said(item: LayoutObject, thing: LayoutThing, things: Mapping[str, LayoutThing]) -> LayoutObject:
    """Return an object with the anchor, the side, the contact and the direction that hold where it stands."""
    if may_overlap_anchor(thing) or thing.relationship == "on_top_of" or thing.box.z > CONTACT_DISTANCE:
        return item
    near = things.get(thing.anchor) if thing.anchor is not None else _nearest(thing, things)
    if near is None or math.dist((near.box.x, near.box.y), (thing.box.x, thing.box.y)) < CONTACT_DISTANCE:
        return item
    box, base, said = thing.box, near.box, dict[str, object]()
    side = min(BEARING, key=lambda name: abs(bearing_error(box, base, name)))
    if thing.relationship is None and abs(bearing_error(box, base, side)) < BEARING_TOLERANCE - _SURE:
        gap = footprint_gap(box, base)[0]
        touches = gap < CONTACT_DISTANCE and vertical_gap(box, base) < 0
        said |= {"relationship": side, "contact": True if touches else False if gap > 2 * CONTACT_DISTANCE else None}
    off = {name: abs(wrap_angle(box.yaw - wanted_yaw(box, base, name))) for name in DIRECTION_TURN}
    turned = min(off, key=lambda name: off[name])
    if thing.direction is None and off[turned] < DIRECTION_TOLERANCE - _SURE:
        said |= {"direction": turned}
    return item.model_copy(update={"anchor_asset_id": near.name, **said}) if said else item


def _nearest(thing: LayoutThing, things: Mapping[str, LayoutThing]) -> LayoutThing | None:
    """Return the nearest other thing on the floor, if there is one near."""
    others = [
        each for each in things.values() if each is not thing and each.box.z < CONTACT_DISTANCE and not each.floats
    ]
    near = min(others, key=lambda each: footprint_gap(thing.box, each.box)[0], default=None)
    return near if near is not None and footprint_gap(thing.box, near.box)[0] < _NEAR else None


def corrupted(layout: Layout, view: SpatialPlannerView, seed: int) -> Layout:
    """Return a layout with errors in more than half of its things, at least in one; none is without a fault.

    Args:
        layout: A layout without a fault.
        view: The scene.
        seed: Of the random draws.
    """
    rng = np.random.default_rng(seed)
    free = [item.node_id for item in free_things(layout, view)]
    while True:
        chosen = [name for name in free if rng.random() < _SHARE] or [free[int(rng.integers(len(free)))]]
        broken = layout
        for name in chosen:
            broken = _ERRORS[int(rng.integers(len(_ERRORS)))](broken, name, rng)
        if layout_violations(broken, view.measures, view.plan):
            return broken


def put(layout: Layout, name: str, location: Sequence[float], yaw: float | None = None) -> Layout:
    """Return a layout with one thing elsewhere, and what stands or sits on it with it.

    Args:
        layout: The layout.
        name: node_id of the thing.
        location: Its new place, metres.
        yaw: Its new yaw in degrees; None keeps it.
    """
    item = item_of(layout, name)
    x, y, z = (round(float(value), 3) for value in location)
    move = (x - item.location[0], y - item.location[1], z - item.location[2])
    turned = item.rotation if yaw is None else (*item.rotation[:2], round(wrap_degrees(yaw), 1))
    moved = item.model_copy(update={"location": (x, y, z), "rotation": turned})
    carried = {each.node_id for each in layout.objects if each.anchor_asset_id == name and is_carried(each)}
    objects = (
        moved if each.node_id == name else _shifted(each, move) if each.node_id in carried else each
        for each in layout.objects
    )
    return layout.model_copy(update={"objects": tuple(objects)})


def _shifted(item: LayoutObject, move: Sequence[float]) -> LayoutObject:
    location = tuple(round(value + step, 3) for value, step in zip(item.location, move, strict=True))
    return item.model_copy(update={"location": location})


def is_carried(item: LayoutObject) -> bool:
    """Return whether an object stands on its anchor, sits on it or is in it."""
    return item.relationship == "on_top_of" or (item.relationship is None and item.direction is None)


def item_of(layout: Layout, name: str) -> LayoutObject:
    """Return the object of a layout with a node_id."""
    return next(item for item in layout.objects if item.node_id == name)


def wrap_degrees(angle: float) -> float:
    """Return an angle in degrees brought into -180..180."""
    return (angle + 180.0) % 360.0 - 180.0


def _turn(layout: Layout, name: str, rng: np.random.Generator) -> Layout:
    """Turn a thing by a quarter, a half, or at random."""
    item = item_of(layout, name)
    by = float(rng.choice((90, -90, 180, rng.uniform(-180, 180))))
    return put(layout, name, item.location, item.rotation[2] + by)


def _to_other_side(layout: Layout, name: str, rng: np.random.Generator) -> Layout:
    """Put a thing on the other side of its anchor; one without an anchor is pushed into another thing."""
    item = item_of(layout, name)
    anchor = next((each for each in layout.objects if each.node_id == item.anchor_asset_id), None)
    if anchor is None or is_carried(item):
        return _into_another(layout, name, rng)
    x, y = (2 * there - here for there, here in zip(anchor.location[:2], item.location[:2], strict=True))
    return put(layout, name, (x, y, item.location[2]))


def _into_another(layout: Layout, name: str, rng: np.random.Generator) -> Layout:
    """Push a thing into another one."""
    item = item_of(layout, name)
    others = [each for each in layout.objects if each.node_id not in (name, item.anchor_asset_id)]
    if not others:
        return _lift(layout, name, rng)
    other = others[int(rng.integers(len(others)))]
    x, y = np.asarray(other.location[:2]) + rng.uniform(-0.3, 0.3, 2)
    return put(layout, name, (x, y, item.location[2]))


def _lift(layout: Layout, name: str, rng: np.random.Generator) -> Layout:
    """Lift a thing into the air, or sink it into what it stands on."""
    x, y, z = item_of(layout, name).location
    return put(layout, name, (x, y, z + float(rng.choice((rng.uniform(0.1, 1.0), -rng.uniform(0.1, 0.5))))))


def _through_wall(layout: Layout, name: str, rng: np.random.Generator) -> Layout:
    """Push a thing through the border of the playing area."""
    item, size = item_of(layout, name), layout.scene_size
    x, y, z = item.location
    out = float(rng.uniform(-0.2, 1.0))
    x, y = [(size.x + out, y), (size.x_negative - out, y), (x, size.y + out), (x, size.y_negative - out)][
        int(rng.integers(4))
    ]
    return put(layout, name, (x, y, z))


_ERRORS: tuple[Callable[[Layout, str, np.random.Generator], Layout], ...] = (
    _turn, _to_other_side, _into_another, _lift, _through_wall,
)  # fmt: skip
