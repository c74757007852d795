"""What each kind of edit does to the graph: the item as it is then, and what of the crew's work is stale."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from storyblender.edits.targets import Target, person_or_thing, shots_named, target_named
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.edits import CameraEdit, DurationEdit, Edit, LockEdit, UnlockEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Item
from storyblender.memory.locks import SCENE_LOCKS, SHOT_LOCKS, LockName, ShotLock
from storyblender.memory.scene_context import SceneContext
from storyblender.memory.shot_context import CameraDecision, CameraInstruction, CameraState, ShotContext
from storyblender.memory.vocabulary import ShotKind

_PEOPLE_IN = {"two_shot": 2, "group": 3, "single": 1, "reaction": 1, "ots": 1, "insert": 1}
"""Subjects that a kind of picture has at least."""


@dataclass(frozen=True)
class Effect:
    """What one edit comes to.

    Attributes:
        item: The item of the graph as it is then.
        name: Of the item, for people.
        words: What was done to it.
        aspects: What of it was touched, such as ``camera``: two edits of one item may touch different things.
        stale: Shots whose frames show something else now.
    """

    item: Item
    name: str
    words: str
    aspects: frozenset[str]
    stale: tuple[str, ...] = ()


def effect_of(graph: ContinuityMemoryGraph, edit: Edit) -> Effect:
    """Return what an edit does.

    Args:
        graph: As it is.
        edit: Any.

    Raises:
        InputError: It names what does not exist, what is locked, or what cannot be.
    """
    match edit:
        case CameraEdit():
            return _camera(graph, edit)
        case DurationEdit():
            return _duration(graph, edit)
        case LockEdit():
            return _lock(graph, edit)
        case UnlockEdit():
            return _unlock(graph, edit)


def _camera(graph: ContinuityMemoryGraph, edit: CameraEdit) -> Effect:
    [shot] = shots_named(graph, [edit.shot])
    name = shot_name(shot.scene_id, shot.shot_id)
    decision = _with_ids(graph, edit.decision)
    if not decision.words:
        raise InputError(f"nothing is decided about the camera of {name}", mend="give a size, an angle, a lens ...")
    _refuse_locked(shot, "camera", name)
    retake = shot.camera_retake.decision if shot.camera_retake else CameraDecision()
    people = {asset.asset_id for asset in graph.assets if asset.asset_type == "character"}
    decision = _with_kind(decision, shot.camera_instruction, people)
    whole = (shot.camera_decision or retake).then(decision)
    instruction = decision.applied(shot.camera_instruction)
    if decision.kind or decision.focus_on_ids:
        _refuse_impossible(instruction.kind, instruction.focus_on_ids, instruction.over_id, instruction.pov_id)
    shown = [each for each in decision.focus_on_ids or () if each in people and each not in shot.in_frame]
    update = {
        "camera_instruction": instruction,
        "camera_decision": whole,
        "camera_retake": None,
        "camera": None,
        "lights": (),
        "in_frame": (*shot.in_frame, *shown),
    }
    return Effect(shot.model_copy(update=update), name, decision.words, frozenset({"camera"}), (name,))


def _with_kind(decision: CameraDecision, now: CameraInstruction, people: Collection[str]) -> CameraDecision:
    """Return a decision about whom a picture shows with the kind of picture that holds them, if it names none.

    Args:
        decision: Of a person, with ids.
        now: The camera as it is wanted now; its kind is kept where it has as many people.
        people: Ids of all characters.
    """
    shown = decision.focus_on_ids
    if decision.kind is not None or shown is None:
        return decision
    count = sum(each in people for each in shown)
    fits = {"two_shot": count == 2, "group": count > 2, "insert": not count, "ots": False, "pov": False,
        "single": count == 1, "reaction": count == 1}  # fmt: skip
    if fits.get(now.kind, True):
        return decision
    kind: ShotKind = "group" if count > 2 else "two_shot" if count == 2 else "single" if count else "insert"
    return decision.model_copy(update={"kind": kind})


def _with_ids(graph: ContinuityMemoryGraph, decision: CameraDecision) -> CameraDecision:
    """Return a decision with ids in place of names."""
    given = {field: getattr(decision, field) for field in ("over_id", "pov_id", "focus", "focus_to")}
    update: dict[str, object] = {field: person_or_thing(graph, name) for field, name in given.items() if name}
    if decision.focus_on_ids:
        update["focus_on_ids"] = tuple(person_or_thing(graph, name) for name in decision.focus_on_ids)
    return decision.model_copy(update=update)


def _refuse_impossible(kind: str, focus: Sequence[str], over: str | None, pov: str | None) -> None:
    """Refuse a kind of picture without the people that it needs."""
    if len(focus) < _PEOPLE_IN.get(kind, 0):
        count = _PEOPLE_IN[kind]
        raise InputError(f"a picture of the kind {kind} has {count} or more in focus", mend="name them with --on")
    if kind == "ots" and over is None:
        raise InputError("an over-the-shoulder picture needs whose shoulder", mend="name them with --over")
    if kind == "pov" and pov is None:
        raise InputError("a point of view needs whose eyes", mend="name them with --pov")


def _duration(graph: ContinuityMemoryGraph, edit: DurationEdit) -> Effect:
    [shot] = shots_named(graph, [edit.shot])
    name, fps = shot_name(shot.scene_id, shot.shot_id), graph.format.fps
    _refuse_locked(shot, "duration", name)
    frames = edit.frames or max(1, round((edit.seconds or 0.0) * fps))
    if shot.camera is not None and len(shot.camera.poses) > 1:
        _refuse_locked(shot, "camera", name)
    update = {
        "duration": frames,
        "decided_duration": frames,
        "camera": shot.camera and retimed(shot.camera, shot.duration, frames),
        "frame": None,
        "stale": ("motion",),
    }
    scene = tuple(shot_name(each.scene_id, each.shot_id) for each in graph.shots_of(shot.scene_id))
    words = f"length {frames} frames ({frames / fps:.3g} s)"
    return Effect(shot.model_copy(update=update), name, words, frozenset({"duration"}), scene)


def retimed(camera: CameraState, before: int, after: int) -> CameraState:
    """Return a camera whose move, and whose rack focus, end with a shot of another length.

    Args:
        camera: As it is.
        before: Frames of the shot as it was.
        after: Frames of the shot now.
    """
    share = max(after - 1, 1) / max(before - 1, 1)
    keys = {
        field: tuple(key.model_copy(update={"frame": round(key.frame * share)}) for key in getattr(camera, field))
        for field in ("poses", "focus")
    }
    return camera.model_copy(update=keys)


def _lock(graph: ContinuityMemoryGraph, edit: LockEdit) -> Effect:
    item, name, parts = _parts(graph, edit)
    if isinstance(item, Asset):
        return Effect(item.model_copy(update={"locked": True}), name, "locked", frozenset({"asset"}))
    there = tuple(part for part in parts if _is_there(item, part))
    missing = [part for part in edit.parts or parts[: not there] if part not in there]
    if missing:
        raise InputError(f"{name} has no {missing[0]} yet that could be locked", mend="run `storyblender render` first")
    parts = there
    locked = tuple(dict.fromkeys([*item.locked, *parts]))
    words = f"{', '.join(parts)} locked"
    return Effect(item.model_copy(update={"locked": locked}), name, words, frozenset(parts))


def _is_there(item: ShotContext | SceneContext, part: LockName) -> bool:
    """Return whether a part of a shot or scene is made; where nobody is on stage there is no blocking to wait for."""
    if part == "blocking" and isinstance(item, ShotContext) and not item.on_stage:
        return True
    fields: dict[str, tuple[str, ...]] = {**SHOT_LOCKS, **SCENE_LOCKS}
    return bool(getattr(item, fields[part][0]))


def _unlock(graph: ContinuityMemoryGraph, edit: UnlockEdit) -> Effect:
    item, name, parts = _parts(graph, edit)
    if isinstance(item, Asset):
        return Effect(item.model_copy(update={"locked": False}), name, "unlocked", frozenset({"asset"}))
    update: dict[str, object] = {"locked": tuple(part for part in item.locked if part not in parts)}
    if isinstance(item, ShotContext):
        update |= {"camera_decision": None} if "camera" in parts else {}
        update |= {"decided_duration": None} if "duration" in parts else {}
    words = f"{', '.join(parts)} unlocked"
    return Effect(item.model_copy(update=update), name, words, frozenset(parts))


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


def _refuse_locked(shot: ShotContext, part: ShotLock, name: str) -> None:
    if part in shot.locked:
        raise InputError(f"the {part} of {name} is locked", mend="unlock it first")
