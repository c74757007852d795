"""Shots that a person split, joined or added, found again with their words in a plan of a changed script."""

from __future__ import annotations

from collections.abc import Mapping

from storyblender.memory.base import ADDED_FROM, SHOT_STEP, shot_number, staged_id
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import replace
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.kept_cut import ShotKey


def with_coverage(
    old: ContinuityMemoryGraph, plan: ContinuityMemoryGraph, matched: Mapping[ShotKey, ShotKey]
) -> tuple[ContinuityMemoryGraph, dict[ShotKey, ShotKey]]:
    """Return a plan with what a person split, joined and added, and which old shot each new one is.

    What was split or added stays with the words of its staged shot, what was joined with those of both shots.

    Args:
        old: The graph as it is.
        plan: The new plan.
        matched: Old shots by new ones, by their words; those that a person added are not among them yet.
    """
    present = {past: new for new, past in matched.items()}
    whole = dict(matched)
    for shot in old.shots:
        found = present.get((shot.scene_id, staged_id(shot.shot_id)))
        if shot.covers is not None and found is not None:
            new = _again(shot, found, plan, plan.format.fps / old.format.fps)
            if new is not None:
                plan = replace(plan, new)
                whole[new.scene_id, new.shot_id] = shot.scene_id, shot.shot_id
        elif shot.joined and found is not None:
            before = present.get(_before(old, (shot.scene_id, shot.shot_id)))
            plan = replace(plan, plan.shot(*found).model_copy(update={"joined": _before(plan, found) == before}))
    return plan, whole


def _before(graph: ContinuityMemoryGraph, key: ShotKey) -> ShotKey:
    """Return the staged shot before one in its scene; zeros where it is the first."""
    ids = [shot.shot_id for shot in graph.staged_shots_of(key[0])]
    index = ids.index(key[1])
    return (key[0], ids[index - 1]) if index else (0, 0)


def _again(past: ShotContext, found: ShotKey, plan: ContinuityMemoryGraph, rate: float) -> ShotContext | None:
    """Return a shot that a person split off or added, on the staged shot with the same words in a new plan.

    Args:
        past: As it was.
        found: The staged shot.
        plan: The new plan; where the people of the shot are not in it there is no such shot.
        rate: Frames a second now, over those of the old plan.
    """
    camera = past.camera_instruction
    wanted = {*past.in_frame, camera.focus, camera.focus_to} - {None}
    if past.covers is None or not wanted <= {asset.asset_id for asset in plan.assets}:
        return None
    number = shot_number(past.shot_id) % SHOT_STEP + SHOT_STEP * found[1]
    locked = past.locked if rate == 1 else ()
    update: dict[str, object] = {
        "scene_id": found[0],
        "shot_id": ADDED_FROM + number,
        "covers": past.covers.model_copy(update={"start": round(past.covers.start * rate)}),
        "duration": max(1, round(past.duration * rate)),
        "decided_duration": past.decided_duration and max(1, round(past.decided_duration * rate)),
        "frame": None,
        "lights": (),
        "locked": locked,
        "approved": past.approved if rate == 1 else None,
        "takes": past.takes_to_set_anew,
    }
    return past.model_copy(update=update | ({} if "camera" in locked else {"camera": None}))
