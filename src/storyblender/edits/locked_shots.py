"""Shots in which a person locked where people stand: what they show or use is not moved."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

import numpy as np

from storyblender.agents.layout_artist.placed_by_hand import Stand
from storyblender.edits.effect import name_of, refuse_locked
from storyblender.errors import InputError
from storyblender.geometry.boxes import Box, corners
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import Film, project
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.scene_context import Layout, SceneContext
from storyblender.memory.shot_context import ShotContext

_NEAREST = 0.05
"""Metres before the camera from which something can be seen."""


def refuse_shown_in_locked(
    graph: ContinuityMemoryGraph, scene: SceneContext, stand: Stand, node_ids: Collection[str], *layouts: Layout
) -> None:
    """Refuse to move or scale things in a scene whose layout is locked, or that a locked shot of it shows or uses.

    Args:
        graph: The story.
        scene: The scene.
        stand: Its set, and what things measure.
        node_ids: Of the things.
        layouts: The layout as it is, and as it would be.

    Raises:
        InputError: With the shot, and what to do first.
    """
    refuse_locked(scene, "layout")
    items = [each for each in layouts[0].objects if each.node_id in node_ids and not stand.is_person(each)]
    boxes = [*_boxes(layouts, stand, {each.node_id for each in items})]
    for shot in graph.shots_of(scene.scene_id):
        if "blocking" not in shot.locked:
            continue
        used = next((each.node_id for each in items if {each.node_id, each.asset_id} & _used(shot)), None)
        shown = next((node_id for node_id, box in boxes if _shows(shot, node_id, box, graph.format.aspect)), None)
        if used is not None or shown is not None:
            name, approved = name_of(shot), shot.approved is not None
            how = f"{used} is used in {name}" if used is not None else f"{shown} is seen in {name}, or would be there"
            mend = f"withdraw the approval of {name} first" if approved else f"unlock {name} first"
            raise InputError(f"{how}, and {name} {'is approved' if approved else 'has its blocking locked'}", mend=mend)


def _boxes(layouts: Iterable[Layout], stand: Stand, node_ids: Collection[str]) -> Iterator[tuple[str, Box]]:
    """Yield the things with their boxes in each layout."""
    for layout in layouts:
        for item in layout.objects:
            if item.node_id in node_ids and (thing := stand.thing(item)) is not None:
                yield item.node_id, thing.box


def _used(shot: ShotContext) -> set[str | None]:
    """Return the ids of what people of a shot sit, lie or lean on, hold, take or turn to."""
    marks = [mark for each in shot.blocking for mark in (each.start, each.end)]
    marks += [cue.mark for cue in shot.cues if cue.mark is not None]
    held: set[str | None] = {prop for mark in marks for _, prop in mark.held}
    cued = {name for cue in shot.cues for name in (cue.target_id, cue.prop_id)}
    return held | cued | {mark.support_id for mark in marks}


def _shows(shot: ShotContext, node_id: str, box: Box, aspect: float) -> bool:
    """Return whether a box is in the picture of a shot at its start, at the moment of its frame or at its end."""
    state = shot.camera or shot.former_camera
    if state is None or node_id in state.hidden_node_ids:
        return False
    film = Film(state.sensor_width, aspect)
    for frame in {0, shot.frame or 0, shot.duration - 1}:
        points, depths = project(camera_at(state, frame, film), corners(box))
        seen = points[depths > _NEAREST]
        if len(seen) and np.all(seen.max(axis=0) > 0) and np.all(seen.min(axis=0) < 1):
            return True
    return False
