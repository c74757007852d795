"""Places things in, under or outside others and on walls: in the tub, under the bed, on the sill, on the wall."""

from __future__ import annotations

import math

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import anchors_of, size_of
from storyblender.agents.layout_artist.wall_places import hang, stand_against
from storyblender.catalog.hollows import place_inside
from storyblender.catalog.props import PROPS
from storyblender.geometry.boxes import Box, wrap_angle, yaw_along
from storyblender.geometry.relations import LayoutThing, may_overlap_anchor
from storyblender.memory.base import Vec2
from storyblender.memory.scene_context import Spot

_TREES = frozenset({"tree", "pine", "palm_tree", "dead_tree"})
_FORK, _TRUNK = 0.36, 0.012
"""Heights of the fork of a tree, and of the radius of its trunk there, as shares of its height."""
_TALL = 1.3
"""Metres from which nothing is put down on a thing without a level top; it is lifted up there."""
_TURNED = math.radians(60)
"""Most that what is up in a tree is turned away from the audience."""
_ASIDE = 1.0
"""Metres from a door or window within which what is next to it has its back to the wall."""
_ON_SEAT = 1.0
"""Metres: smaller things are put on a seat of a vehicle."""
_LARGE, _OUTSIDE = 0.4, 2.0
"""Share of a room's width from which a thing is too large for it; its metres beyond a window or door."""
_SILL = 0.12
"""Metres of a thing's depth that stand on a sill."""


def place_in_hollow(stage: LayoutStage, asset_id: str, anchor: LayoutThing) -> bool:
    """Place a thing in a hollow one, or on a seat of a vehicle with doors; return whether there was room.

    Args:
        stage: The stage; changed.
        asset_id: The thing.
        anchor: The hollow thing or the vehicle.
    """
    measure = stage.measure(stage.assets[anchor.name])
    riders = [thing for thing in stage.things.values() if thing.anchor == anchor.name and may_overlap_anchor(thing)]
    size, base = size_of(stage.measure(asset_id)), anchor.box
    seats = anchors_of(measure, "seat") if anchors_of(measure, "door") else []
    place = place_inside(stage.view.props.get(measure.asset_id), size_of(measure), size, len(riders))
    if seats and max(size) < _ON_SEAT:
        x, y, z = seats[-1 - len(riders) % len(seats)].location
        place = (x, y + size[1] / 2, z)
    if place is None:
        return False
    key = stage.view.props.get(asset_id, "")
    alive = key in PROPS and PROPS[key].category == "animal"  # it looks out
    yaw = base.yaw + (math.pi / 2 if size[1] > size[0] and base.width > base.depth and not alive else 0.0)
    x, y = base.to_world(*place[:2])
    stage.place(asset_id, stage.box(asset_id, x, y, base.z + place[2], yaw), anchor=anchor.name)
    return True


def place_high(stage: LayoutStage, asset_id: str, spot: Spot, anchor: LayoutThing) -> bool:
    """Place a thing up in a tree or on something tall without a level top: a pole, a roof; return whether it is one.

    In a tree it is at the trunk, under the crown, on the side of whom it faces, else of the audience.

    Args:
        stage: The stage; changed.
        asset_id: The thing.
        spot: Its spot in the script.
        anchor: The tree, or what else it is on.
    """
    base, size = anchor.box, size_of(stage.measure(asset_id))
    tree = stage.view.props.get(stage.assets[anchor.name]) in _TREES
    inside = spot.relation in ("in", "inside") or (spot.relation in ("on", "at", "against") and spot.height is not None)
    if anchor.walks or not ((tree and inside) or (spot.relation == "on" and base.height > _TALL)):
        return False
    if not tree:
        z = base.top if spot.height is None else min(spot.height, base.top)
        stage.place(asset_id, stage.box(asset_id, base.x, base.y, z, base.yaw), anchor=anchor.name, floats=True)
        return True
    seen_by = stage.find(spot.facing)
    yaw = yaw_along(seen_by.box.x - base.x, seen_by.box.y - base.y) if seen_by is not None else 0.0
    yaw = max(-_TURNED, min(_TURNED, wrap_angle(yaw)))
    z = base.z + _FORK * base.height if spot.height is None else spot.height
    z = min(z, base.top - size[2])
    away = size[1] / 2 + _TRUNK * base.height
    x, y = base.x + away * math.sin(yaw), base.y - away * math.cos(yaw)
    stage.place(asset_id, stage.box(asset_id, x, y, z, yaw), anchor=anchor.name, floats=True, fixed=True)
    return True


def place_outside(stage: LayoutStage, asset_id: str, spot: Spot, anchor: LayoutThing) -> bool:
    """Place a thing behind a window or door outdoors, if it is too large for the room or its distance is given.

    Args:
        stage: The stage; changed.
        asset_id: The thing.
        spot: Its spot in the script.
        anchor: The window or the door.

    Returns:
        Whether it was placed.
    """
    fixture = stage.find_fixture(spot.anchor_id) if anchor.name not in stage.things else None
    opening = fixture.kind if fixture is not None else stage.view.props.get(stage.assets.get(anchor.name, ""))
    size, base = size_of(stage.measure(asset_id)), anchor.box
    x_min, x_max, y_min, y_max = stage.room
    large = max(size[:2]) > _LARGE * min(x_max - x_min, y_max - y_min)
    if opening not in ("window", "door") or not stage.view.plan.indoor or not (large or spot.distance):
        return False
    x, y = base.to_world(0.0, base.depth / 2 + (_OUTSIDE if spot.distance is None else spot.distance) + size[1] / 2)
    stage.place(asset_id, stage.box(asset_id, x, y, 0.0, base.yaw), floats=True, fixed=True)
    return True


def box_under(stage: LayoutStage, asset_id: str, anchor: LayoutThing, peeps: bool) -> Box:
    """Return the box of a thing under another: where that one stands, or on the floor if it hangs.

    Args:
        stage: What stands in the set; not changed.
        asset_id: The lower thing.
        anchor: The upper one.
        peeps: Let a quarter of its depth stand out in front, if it is smaller than the upper one; else it is in the
            middle.
    """
    base, (width, depth, _) = anchor.box, size_of(stage.measure(asset_id))
    ahead = max(0.0, base.depth / 2 - depth / 4) if peeps and depth < base.depth and width < base.width else 0.0
    x, y = base.to_world(0.0, -ahead)
    return stage.box(asset_id, x, y, 0.0 if anchor.floats else base.z, base.yaw)


def place_at_wall(
    stage: LayoutStage, asset_id: str, spot: Spot, near: Vec2 | None, part: LayoutThing | None = None
) -> bool:
    """Hang a thing on a wall or place its back to one, as its spot says; return whether it was placed.

    Args:
        stage: The stage; changed.
        asset_id: The thing.
        spot: Its spot; the anchor is a part of the set or nothing.
        near: Wished floor point; None for the middle of the set.
        part: The anchor; None if there is none.
    """
    fixture = stage.find_fixture(spot.anchor_id) if part is not None else None
    if part is not None and fixture is not None and fixture.kind == "window" and spot.relation == "on":
        box, (_, depth, height) = part.box, size_of(stage.measure(asset_id))
        if height < box.height:
            x, y = box.to_world(0.0, min(depth, _SILL) - depth / 2)
            stage.place(asset_id, stage.box(asset_id, x, y, box.z, box.yaw), floats=True, fixed=True)
            return True
    if spot.height is not None or (fixture is not None and fixture.kind == "wall" and spot.relation == "on"):
        return hang(stage, asset_id, near=near, height=spot.height)
    walls = part is not None and fixture is not None and fixture.kind != "mark"
    opening = fixture is not None and fixture.kind in ("door", "window")
    backed = (
        {"against"}
        | ({"at"} if walls else set())
        | ({"next_to"} if opening and (spot.distance or 0.0) < _ASIDE else set())
    )
    return spot.relation in backed and stand_against(stage, asset_id, near=near)
