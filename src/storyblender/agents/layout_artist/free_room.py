"""How much room there is beside a thing, on it, and elsewhere: what a planner has to know to place what did not fit."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

import numpy as np

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import size_of, tops_of
from storyblender.geometry.boxes import Box, distance_to_point, footprint_gap, penetration
from storyblender.geometry.lanes import blocks_walkers
from storyblender.geometry.relations import LayoutThing

_SIDES = {"left_of": (-1, 0), "right_of": (1, 0), "in_front_of": (0, -1), "behind": (0, 1)}
"""Directions on the floor as the audience sees them."""
_STEP, _FAR = 0.1, 3.0
"""Metres between the depths that are tried beside a thing; more than the second is not told."""
_GRID = 0.25
"""Metres between the floor points that are tried elsewhere."""
_PLACES = 3
"""Most places elsewhere that are told."""
_TOUCHING = 0.02
"""Metres that footprints may share."""


def room_told(stage: LayoutStage, asset_id: str, anchor: LayoutThing, relation: str) -> str:
    """Return what room something needs, what there is where it was to go, and where it fits.

    Args:
        stage: With everything that stands; the thing itself does not count.
        asset_id: The person or thing that found no room.
        anchor: What it was to be placed by.
        relation: How.
    """
    width, depth, height = size_of(stage.measure(asset_id))
    if relation == "on" and anchor.name in stage.things:
        return f"{asset_id} needs {width:.1f} x {depth:.1f} m; {_top_told(stage, asset_id, anchor)}"
    if relation in ("in", "inside", "under"):
        size = f"{anchor.box.width:.1f} x {anchor.box.depth:.1f} x {anchor.box.height:.1f} m"
        return f"{asset_id} is {width:.1f} x {depth:.1f} x {height:.1f} m, {anchor.name} is {size}"
    solid = _solid(stage, asset_id, anchor)
    beside = ", ".join(_beside(stage, anchor, (width, depth), solid))
    needs = f"{asset_id} needs {width:.1f} x {depth:.1f} m of floor; free at {anchor.name}: {beside}"
    places = [*_places(stage, anchor, (width, depth), [anchor, *solid])]
    return f"{needs}; it fits {', or '.join(places)}" if places else f"{needs}; it fits nowhere else on the floor"


def _solid(stage: LayoutStage, asset_id: str, anchor: LayoutThing) -> list[LayoutThing]:
    """Return people, things and walls that stand on the floor, without the thing, what is in it, and its anchor."""
    mine = {name for name in stage.things if name == asset_id or stage.assets[name] == asset_id} | {anchor.name}
    things = (thing for name, thing in stage.things.items() if name not in mine and thing.anchor not in mine)
    return [thing for thing in (*things, *stage.walls) if thing.walks or blocks_walkers(thing)]


def _top_told(stage: LayoutStage, asset_id: str, anchor: LayoutThing) -> str:
    """Return how large the surfaces of a thing are, and what is on them."""
    tops = tops_of(stage.measure(stage.assets[anchor.name]))
    sizes = " and ".join(f"{top.surface.width:.1f} x {top.surface.depth:.1f} m" for top in tops)
    on_it = [
        name
        for name, thing in stage.things.items()
        if thing.anchor == anchor.name
        and thing.relationship == "on_top_of"
        and asset_id not in (name, stage.assets[name])
    ]
    return f"the top of {anchor.name} is {sizes}" + (f", with {', '.join(on_it)} on it" if on_it else "")


def _beside(
    stage: LayoutStage, anchor: LayoutThing, size: tuple[float, float], solid: Sequence[LayoutThing]
) -> Iterator[str]:
    """Yield for each side of a thing how deep the floor is free, and what is there then."""
    for side, axis in _SIDES.items():
        free, blocker = _depth(stage, anchor, size, axis, solid)
        yield f"{side} {free:.1f} m up to {blocker}" if blocker else f"{side} {_FAR:.0f} m and more"


def _depth(
    stage: LayoutStage,
    anchor: LayoutThing,
    size: tuple[float, float],
    axis: tuple[int, int],
    solid: Sequence[LayoutThing],
) -> tuple[float, str]:
    """Return how far the floor is free from the edge of a thing, metres, and what ends it; empty if nothing does."""
    x, y = axis
    start = anchor.box.reach(axis)
    for step in range(1, round(_FAR / _STEP) + 1):
        reach = step * _STEP
        far = start + reach / 2
        strip = (reach, size[1]) if x else (size[0], reach)
        box = Box(anchor.box.x + x * far, anchor.box.y + y * far, 0.05, *strip, 1.0)
        ends = _blocker(stage, box, solid)
        if ends:
            return reach - _STEP, ends
    return _FAR, ""


def _blocker(stage: LayoutStage, box: Box, solid: Sequence[LayoutThing]) -> str:
    """Return the name of what stands in a box or of the edge that it crosses; empty if it is free."""
    hit = next((each for each in solid if penetration(box, each.box)[0] > _TOUCHING), None)
    if hit is not None:
        return "the wall" if hit.name.startswith("wall") else hit.name
    x0, x1, y0, y1 = stage.room
    inside = x0 <= box.x - box.width / 2 and box.x + box.width / 2 <= x1
    inside = inside and y0 <= box.y - box.depth / 2 and box.y + box.depth / 2 <= y1
    return "" if inside else "the edge of the room"


def _places(
    stage: LayoutStage, anchor: LayoutThing, size: tuple[float, float], solid: Sequence[LayoutThing]
) -> Iterator[str]:
    """Yield places where a footprint fits, the nearest to a thing first, each by another neighbour."""
    x0, x1, y0, y1 = stage.room
    grid = itertools.product(np.arange(x0, x1, _GRID).tolist(), np.arange(y0, y1, _GRID).tolist())
    points = sorted(grid, key=lambda point: (round(distance_to_point(anchor.box, *point), 3), point))
    neighbours = [each for each in (anchor, *stage.things.values()) if each in solid and not each.walks]
    told: set[str] = set()
    for x, y in points:
        box = Box(x, y, 0.05, *size, 1.0)
        if not neighbours or _blocker(stage, box, solid):
            continue
        gap, near = min(((footprint_gap(box, each.box)[0], each) for each in neighbours), key=lambda pair: pair[0])
        if near.name in told:
            continue
        told.add(near.name)
        yield f"{max(gap, 0.0):.1f} m {_side(x - near.box.x, y - near.box.y)} {near.name}"
        if len(told) == _PLACES:
            return


def _side(x: float, y: float) -> str:
    """Return the side on which a floor vector points, as the audience sees it."""
    length = math.hypot(x, y) or 1.0
    return max(_SIDES, key=lambda side: (x * _SIDES[side][0] + y * _SIDES[side][1]) / length)
