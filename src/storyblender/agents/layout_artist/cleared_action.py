"""Dressing that was added to a set gives way where, once the scene is laid out, it stands across the action."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Iterator

import numpy as np

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.geometry.boxes import Box, distance_to_point, footprint_gap
from storyblender.memory.base import Vec2
from storyblender.memory.scene_context import Layout

ADDED = "set_added_"
"""How the node_ids of props begin that a set gets beyond its plan."""
_WAY = 0.35
"""Metres on either side of a line of the action that stay free."""
_AROUND = 0.6
"""Metres around people and large things of the script that stay free."""
_LARGE = 0.9
"""Metres across from which a thing of the script is one that people go around."""
_STEP = 0.15
"""Metres between the points of a line that are looked at."""


def clear_action(view: SpatialPlannerView, layout: Layout, placed: Collection[str] = ()) -> Layout:
    """Return a layout without added dressing between people and what they talk to, look at or act on, or close to it.

    Args:
        view: The scene.
        layout: Its layout.
        placed: Node ids of things that a person placed; they stay.
    """
    added = {item.node_id for item in layout.objects if item.node_id.startswith(ADDED)}.difference(placed)
    if not added:
        return layout
    stage = LayoutStage(view)
    for item in layout.objects:
        if item.node_id not in stage.things:
            stage.add_object(item, fixed=item.fixed)
    lines, ours = [*_lines(stage)], [*_ours(stage)]
    standing = {name: thing.box for name, thing in stage.things.items() if name in added and thing.box.z < _AROUND}
    gone = {
        name
        for name, box in standing.items()
        if any(footprint_gap(box, other)[0] < _AROUND for other in ours) or any(_is_across(box, line) for line in lines)
    }
    kept = tuple(item for item in layout.objects if item.node_id not in gone and item.anchor_asset_id not in gone)
    return layout.model_copy(update={"objects": kept})


def _ours(stage: LayoutStage) -> Iterator[Box]:
    """Yield the boxes of the people and of the large things of the script."""
    for name, thing in stage.things.items():
        scripted = stage.assets[name] in stage.view.setup.asset_ids
        if thing.walks or (scripted and min(thing.box.width, thing.box.depth) > _LARGE):
            yield thing.box


def _lines(stage: LayoutStage) -> Iterator[tuple[Vec2, Vec2]]:
    """Yield the lines on the floor between people who talk, and from people to what they look at or act on."""
    people = [thing for thing in stage.things.values() if thing.walks]
    by_asset = {stage.assets[thing.name]: thing for thing in people}
    for group in stage.view.groups:
        there = [by_asset[each] for each in group if each in by_asset]
        yield from (((a.box.x, a.box.y), (b.box.x, b.box.y)) for a, b in itertools.combinations(there, 2))
    watched = [(state.asset_id, state.looking_at) for state in stage.view.states]
    watched += [(each, target) for target in stage.view.targets for each in by_asset]
    for person, target in watched:
        thing = stage.find(target)
        if person in by_asset and thing is not None and thing is not by_asset[person]:
            box = by_asset[person].box
            yield (box.x, box.y), (thing.box.x, thing.box.y)


def _is_across(box: Box, line: tuple[Vec2, Vec2]) -> bool:
    """Return whether a box stands on a line, or close to it."""
    count = max(2, math.ceil(math.dist(*line) / _STEP))
    return any(distance_to_point(box, float(x), float(y)) < _WAY for x, y in np.linspace(*line, count))
