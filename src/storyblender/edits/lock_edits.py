"""Locks: what a person keeps as it is, and what they give back to the crew."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from storyblender.edits.effect import Effect, name_of, refuse_locked, scene_effect, scenes_of_place, shot_names
from storyblender.edits.look_edits import look_given_back
from storyblender.edits.targets import Target, target_named
from storyblender.edits.thing_edits import given_back
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.edits import LockEdit, UnlockEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.locks import SCENE_LOCKS, SHOT_LOCKS, LockName, SceneLock
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import ShotContext


def lock_effects(graph: ContinuityMemoryGraph, edit: LockEdit) -> list[Effect]:
    """Return what a lock does. Raises InputError."""
    item, name, parts = _parts(graph, edit)
    if isinstance(item, Asset):
        return [Effect(item.model_copy(update={"locked": True}), name, "locked", frozenset({"asset"}))]
    there = tuple(part for part in parts if _is_there(item, part))
    missing = [part for part in edit.parts or parts[: not there] if part not in there]
    if missing:
        raise InputError(f"{name} has no {missing[0]} yet that could be locked", mend="run `storyblender render` first")
    parts = there
    locked = tuple(dict.fromkeys([*item.locked, *parts]))
    words = f"{', '.join(parts)} locked"
    return [Effect(item.model_copy(update={"locked": locked}), name, words, frozenset(parts))]


def _is_there(item: ShotContext | SceneContext, part: LockName) -> bool:
    """Return whether a part of a shot or scene is made; where nobody is on stage there is no blocking to wait for."""
    if part == "blocking" and isinstance(item, ShotContext) and not item.on_stage:
        return True
    fields: dict[str, tuple[str, ...]] = {**SHOT_LOCKS, **SCENE_LOCKS}
    return bool(getattr(item, fields[part][0]))


def unlock_effects(graph: ContinuityMemoryGraph, edit: UnlockEdit) -> list[Effect]:
    """Return what an unlock does: a lock comes off, and decisions stay; where there is none, they are given back.

    What is given back of light, set, staging and models the crew makes anew.

    Args:
        graph: As it is.
        edit: The unlock.

    Raises:
        InputError: It names what does not exist.
    """
    item, name, parts = _parts(graph, edit)
    words = f"{', '.join(parts)} unlocked"
    if isinstance(item, Asset):
        return look_given_back(graph, item) if item.asset_type == "character" else given_back(graph, item)
    if isinstance(item, SceneContext):
        return list(_scene_unlocked(graph, item, parts, words))
    if item.approved is not None:
        raise InputError(f"{name} is approved", mend="withdraw the approval first")
    update: dict[str, object] = {"locked": tuple(part for part in item.locked if part not in parts)}
    if set(item.locked) & set(parts):
        return [Effect(item.model_copy(update=update), name, words, frozenset(parts))]
    update |= {"camera_decision": None} if "camera" in parts else {}
    update |= {"decided_duration": None} if "duration" in parts else {}
    freed = "blocking" in parts and (item.blocking_decision is not None or bool(item.motion_by_hand))
    update |= {"blocking_decision": None, "motion_by_hand": {}, "stale": ("motion",)} if freed else {}
    stale = shot_names(graph, item.scene_id) if freed else ()
    return [Effect(item.model_copy(update=update), name, words, frozenset(parts), stale)]


def _scene_unlocked(
    graph: ContinuityMemoryGraph, scene: SceneContext, parts: Sequence[LockName], words: str
) -> Iterator[Effect]:
    """Yield a scene without its locks; of one without any, what was decided is given back, a set in all its scenes."""
    if set(scene.locked) & set(parts):
        kept = tuple(part for part in scene.locked if part not in parts)
        yield Effect(scene.model_copy(update={"locked": kept}), name_of(scene), words, frozenset(parts))
        return
    place = scenes_of_place(graph, scene) if "set" in parts and scene.set_decision is not None else (scene,)
    for each in place:
        own = each is scene
        update: dict[str, Any] = {"locked": tuple(part for part in each.locked if part not in parts or not own)}
        decided: list[SceneLock] = [
            part for part in SCENE_LOCKS if part in parts and getattr(each, f"{part}_decision") is not None
        ]
        decided = decided if own else [part for part in decided if part == "set"]
        if not own:
            refuse_locked(each, "set")
        update |= {f"{part}_decision": None for part in decided}
        if each.layout_decision is not None and "layout" in decided:
            added, removed = each.layout_decision.added or (), each.layout_decision.removed or ()
            ids = tuple(asset_id for asset_id in each.setup.asset_ids if asset_id not in added)
            scenery = tuple(asset_id for asset_id in each.setup.scenery if asset_id not in removed)
            update["setup"] = each.setup.model_copy(update={"asset_ids": ids, "scenery": scenery})
        if decided:
            effect = scene_effect(graph, each, words, decided[0], decided, **update)
        else:
            effect = Effect(each.model_copy(update=update), name_of(each), words, frozenset())
        yield replace(effect, aspects=frozenset(parts if own else ("set",)))


def _parts(graph: ContinuityMemoryGraph, edit: LockEdit | UnlockEdit) -> tuple[Target, str, tuple[LockName, ...]]:
    """Return what is locked or unlocked, its name, and which parts of it."""
    item = target_named(graph, edit.target)
    known: tuple[LockName, ...] = ("asset",)
    match item:
        case ShotContext():
            what, name, known = "shot", shot_name(item.scene_id, item.shot_id), tuple(SHOT_LOCKS)
        case SceneContext():
            what, name, known = "scene", scene_name(item.scene_id), tuple(SCENE_LOCKS)
        case Asset():
            what, name = "asset", item.asset_id
    for part in edit.parts:
        if part not in known:
            raise InputError(f"{name} is a {what} and has no {part} to lock", mend=f"it has: {', '.join(known)}")
    return item, name, edit.parts or known
