"""Edits of a shot's camera, and of its length."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from storyblender.edits.effect import Effect, name_of, refuse_far, refuse_locked, shot_names
from storyblender.edits.targets import person_or_thing, shots_named
from storyblender.errors import InputError
from storyblender.geometry.camera_path import retimed
from storyblender.memory.coverage import filmed, is_beside, room_for
from storyblender.memory.edits import CameraEdit, DurationEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import CameraDecision, CameraInstruction, ShotContext
from storyblender.memory.vocabulary import ShotKind

_PEOPLE_IN = {"two_shot": 2, "group": 3, "single": 1, "reaction": 1, "ots": 1, "insert": 1}
"""Subjects that a kind of picture has at least."""


def camera_effects(graph: ContinuityMemoryGraph, edit: CameraEdit) -> list[Effect]:
    """Return what a decision about the camera of a shot does to it. Raises InputError."""
    [shot] = shots_named(graph, [edit.shot])
    name = name_of(shot)
    refuse_locked(shot, "camera")
    item, words = with_decided_camera(graph, shot, edit.decision)
    return [Effect(item, name, words, frozenset({"camera"}), (name,))]


def with_decided_camera(
    graph: ContinuityMemoryGraph, shot: ShotContext, decision: CameraDecision
) -> tuple[ShotContext, str]:
    """Return a shot whose camera is to be set as a person decided, and the decision in words.

    Args:
        graph: The story.
        shot: Of one of its scenes; it need not be in the graph.
        decision: People and things may be called by their names.

    Raises:
        InputError: Nothing is decided, or the picture cannot be.
    """
    decision = _with_ids(graph, decision)
    if not decision.words:
        mend = "give a size, an angle, a lens ..."
        raise InputError(f"nothing is decided about the camera of {name_of(shot)}", mend=mend)
    for place in (decision.placed.start, decision.placed.end) if decision.placed is not None else ():
        if place is not None:
            refuse_far(place.location, graph.scene(shot.scene_id))
    retake = shot.camera_retake.decision if shot.camera_retake else CameraDecision()
    people = {asset.asset_id for asset in graph.assets if asset.asset_type == "character"}
    decision = _with_partner(decision, shot, people)
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
        "former_camera": None,
        "lights": (),
        "in_frame": (*shot.in_frame, *shown),
    }
    return shot.model_copy(update=update), decision.words


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


def _with_partner(decision: CameraDecision, shot: ShotContext, people: Collection[str]) -> CameraDecision:
    """Return a decision about a picture over a shoulder with its subject: if it names none, another person than theirs.

    Args:
        decision: Of a person, with ids.
        shot: As it is.
        people: Ids of all characters.

    Raises:
        InputError: No other character is in the scene.
    """
    behind, now = decision.over_id, shot.camera_instruction.focus_on_ids
    if behind is None or decision.focus_on_ids or (now and behind not in now):
        return decision
    others = [each for each in (*now, *shot.in_frame, *shot.on_stage) if each in people and each != behind]
    if not others:
        mend = "name what it shows with --on"
        raise InputError(f"there is nobody but {behind} for {name_of(shot)} to show", mend=mend)
    return decision.model_copy(update={"focus_on_ids": (others[0],)})


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


def duration_effects(graph: ContinuityMemoryGraph, edit: DurationEdit) -> list[Effect]:
    """Return what another length does to a shot; the crew fits its motions to it. Raises InputError."""
    [shot] = shots_named(graph, [edit.shot])
    name, fps = name_of(shot), graph.format.fps
    refuse_fixed_length(graph, shot)
    frames = edit.frames or max(1, round((edit.seconds or 0.0) * fps))
    beside = is_beside(shot)
    if beside and frames > (room := room_for(graph, shot)):
        raise InputError(f"{name} has {room} frames until its scene ends", mend=f"give it {room / fps:.3g} s or less")
    update = {
        "duration": frames,
        "decided_duration": frames,
        "camera": shot.camera and retimed(shot.camera, shot.duration, frames),
        "frame": None,
        "stale": () if beside else ("motion",),
    }
    stale = (name,) if beside else shot_names(graph, shot.scene_id)
    words = f"length {frames} frames ({frames / fps:.3g} s)"
    return [Effect(shot.model_copy(update=update), name, words, frozenset({"duration"}), stale)]


def refuse_fixed_length(graph: ContinuityMemoryGraph, shot: ShotContext) -> None:
    """Refuse another length for a shot whose length cannot be changed, whatever it would be.

    Args:
        graph: The story.
        shot: Of the graph.

    Raises:
        InputError: It is locked or approved, its camera moves and is locked, or it is a part of what is staged.
    """
    refuse_locked(shot, "duration")
    if shot.camera is not None and len(shot.camera.poses) > 1:
        refuse_locked(shot, "camera")
    if not is_beside(shot) and filmed(graph, shot) is not shot:
        what = f"{name_of(shot)} is split or joined, and as long as what it shows of the staged scene"
        raise InputError(what, mend="split it elsewhere, or join its parts first")
