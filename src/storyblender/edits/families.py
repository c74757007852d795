"""What each kind of edit does to the graph: the item as it is then, and what of the crew's work is stale."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from typing import Any, Final

from storyblender.edits.asset_edits import asset_effects
from storyblender.edits.cut_edits import omit_effects, reorder_effects, restore_effects
from storyblender.edits.effect import Effect, refuse_locked, shot_names
from storyblender.edits.lock_edits import lock_effects, unlock_effects
from storyblender.edits.note_edits import approve_effects, note_effects
from storyblender.edits.place_edits import blocking_effects, place_effects
from storyblender.edits.scene_edits import layout_effects, light_effects, set_effects
from storyblender.edits.take_edits import take_effects
from storyblender.edits.targets import person_or_thing, shots_named
from storyblender.errors import InputError
from storyblender.memory.base import shot_name
from storyblender.memory.edits import (
    ApproveEdit,
    AssetEdit,
    BlockingEdit,
    CameraEdit,
    DurationEdit,
    Edit,
    LayoutEdit,
    LightEdit,
    LockEdit,
    NoteEdit,
    OmitEdit,
    PlaceEdit,
    ReorderEdit,
    RestoreEdit,
    SetEdit,
    TakeEdit,
    UnlockEdit,
)
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import CameraDecision, CameraInstruction, CameraState
from storyblender.memory.vocabulary import ShotKind

_PEOPLE_IN = {"two_shot": 2, "group": 3, "single": 1, "reaction": 1, "ots": 1, "insert": 1}
"""Subjects that a kind of picture has at least."""


def effects_of(graph: ContinuityMemoryGraph, edit: Edit) -> list[Effect]:
    """Return what an edit does, item by item.

    Args:
        graph: As it is.
        edit: Any.

    Raises:
        InputError: It names what does not exist, what is locked, or what cannot be.
    """
    return _FAMILIES[type(edit)](graph, edit)


def _camera(graph: ContinuityMemoryGraph, edit: CameraEdit) -> list[Effect]:
    [shot] = shots_named(graph, [edit.shot])
    name = shot_name(shot.scene_id, shot.shot_id)
    decision = _with_ids(graph, edit.decision)
    if not decision.words:
        raise InputError(f"nothing is decided about the camera of {name}", mend="give a size, an angle, a lens ...")
    refuse_locked(shot, "camera")
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
    return [Effect(shot.model_copy(update=update), name, decision.words, frozenset({"camera"}), (name,))]


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


def _duration(graph: ContinuityMemoryGraph, edit: DurationEdit) -> list[Effect]:
    [shot] = shots_named(graph, [edit.shot])
    name, fps = shot_name(shot.scene_id, shot.shot_id), graph.format.fps
    refuse_locked(shot, "duration")
    frames = edit.frames or max(1, round((edit.seconds or 0.0) * fps))
    if shot.camera is not None and len(shot.camera.poses) > 1:
        refuse_locked(shot, "camera")
    update = {
        "duration": frames,
        "decided_duration": frames,
        "camera": shot.camera and retimed(shot.camera, shot.duration, frames),
        "frame": None,
        "stale": ("motion",),
    }
    scene = shot_names(graph, shot.scene_id)
    words = f"length {frames} frames ({frames / fps:.3g} s)"
    return [Effect(shot.model_copy(update=update), name, words, frozenset({"duration"}), scene)]


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


_FAMILIES: Final[dict[type[Edit], Callable[[ContinuityMemoryGraph, Any], list[Effect]]]] = {
    CameraEdit: _camera,
    DurationEdit: _duration,
    LightEdit: light_effects,
    SetEdit: set_effects,
    LayoutEdit: layout_effects,
    PlaceEdit: place_effects,
    BlockingEdit: blocking_effects,
    AssetEdit: asset_effects,
    TakeEdit: take_effects,
    NoteEdit: note_effects,
    ApproveEdit: approve_effects,
    OmitEdit: omit_effects,
    RestoreEdit: restore_effects,
    ReorderEdit: reorder_effects,
    LockEdit: lock_effects,
    UnlockEdit: unlock_effects,
}
