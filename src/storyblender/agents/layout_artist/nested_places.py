"""Places of things that are in, under or fixed to others: in the tub, under the bed, on the sill, up on the wall."""

from __future__ import annotations

import math

from storyblender.agents.layout_artist.layout_stage import Stage
from storyblender.agents.layout_artist.layout_things import anchors_of, size_of
from storyblender.agents.layout_artist.wall_places import hang, stand_against
from storyblender.catalog.hollows import place_inside
from storyblender.geometry.boxes import Box
from storyblender.geometry.relations import Thing, may_overlap_anchor
from storyblender.memory.base import Vec2
from storyblender.memory.scene_context import Spot

_ON_SEAT = 1.0
"""Metres: what is smaller is put on a seat of a vehicle."""
_LARGE, _OUTSIDE = 0.4, 2.0
"""Share of a room's width from which a thing is too large to stand in it; metres beyond a window that it is then."""
_SILL = 0.12
"""Metres that a sill holds of a thing."""


def put_in(stage: Stage, asset_id: str, anchor: Thing) -> bool:
    """Put a thing into what is hollow, or on a seat of a vehicle that has doors; return whether it was possible."""
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
    yaw = base.yaw + (math.pi / 2 if size[1] > size[0] and base.width > base.depth else 0.0)
    x, y = base.to_world(*place[:2])
    stage.stand(asset_id, stage.box(asset_id, x, y, base.z + place[2], yaw), anchor=anchor.name)
    return True


def put_outside(stage: Stage, asset_id: str, spot: Spot, anchor: Thing) -> bool:
    """Stand what is told to be behind a window or a door of a room outside, beyond the wall; return whether it was."""
    fixture = stage.fixture(spot.anchor_id) if anchor.name not in stage.things else None
    opening = fixture.kind if fixture is not None else stage.view.props.get(stage.assets.get(anchor.name, ""))
    size, base = size_of(stage.measure(asset_id)), anchor.box
    x_min, x_max, y_min, y_max = stage.room
    large = max(size[:2]) > _LARGE * min(x_max - x_min, y_max - y_min)
    if opening not in ("window", "door") or not stage.view.plan.indoor or not (large or spot.distance):
        return False
    x, y = base.to_world(0.0, base.depth / 2 + (_OUTSIDE if spot.distance is None else spot.distance) + size[1] / 2)
    stage.stand(asset_id, stage.box(asset_id, x, y, 0.0, base.yaw), floats=True, fixed=True)
    return True


def under(stage: Stage, asset_id: str, base: Box, peeps: bool) -> Box:
    """Return the place of a thing under another: in its middle, or with a quarter of it out in front."""
    width, depth, _ = size_of(stage.measure(asset_id))
    ahead = max(0.0, base.depth / 2 - depth / 4) if peeps and depth < base.depth and width < base.width else 0.0
    x, y = base.to_world(0.0, -ahead)
    return stage.box(asset_id, x, y, base.z, base.yaw)


def at_wall(stage: Stage, asset_id: str, spot: Spot, near: Vec2 | None, part: Thing | None = None) -> bool:
    """Hang a thing up on a wall or stand it with its back to one, as its spot says; return whether it was possible.

    Args:
        stage: Changed.
        asset_id: The thing.
        spot: The spot; its anchor is a part of the set or nothing.
        near: The floor point that it is wanted at.
        part: The anchor.
    """
    fixture = stage.fixture(spot.anchor_id) if part is not None else None
    if part is not None and fixture is not None and fixture.kind == "window" and spot.relation == "on":
        box, (_, depth, height) = part.box, size_of(stage.measure(asset_id))
        if height < box.height:
            x, y = box.to_world(0.0, min(depth, _SILL) - depth / 2)
            stage.stand(asset_id, stage.box(asset_id, x, y, box.z, box.yaw), floats=True, fixed=True)
            return True
    if spot.height is not None or (fixture is not None and fixture.kind == "wall" and spot.relation == "on"):
        return hang(stage, asset_id, near=near, height=spot.height)
    return spot.relation in ("against", "at" if part is not None else "") and stand_against(stage, asset_id, near=near)
