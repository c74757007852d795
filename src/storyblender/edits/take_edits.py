"""Takes: versions that a person keeps beside each other, one of which the film shows; here those of a camera."""

from __future__ import annotations

from storyblender.edits.decision_takes import blocking_take_effects, layout_take_effects
from storyblender.edits.effect import Effect, name_of, refuse_locked
from storyblender.edits.targets import shots_named
from storyblender.errors import InputError
from storyblender.memory.edits import TakeEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.shot_context import TAKE_FIELDS, ShotContext


def take_effects(graph: ContinuityMemoryGraph, edit: TakeEdit) -> list[Effect]:
    """Return what keeping, choosing or dropping a take does to its shot or scene. Raises InputError."""
    if edit.of != "camera":
        return (blocking_take_effects if edit.of == "blocking" else layout_take_effects)(graph, edit)
    [shot] = shots_named(graph, [edit.shot])
    name = name_of(shot)
    if edit.action == "keep":
        words, update = f"take {shot.take} kept, take {_next(shot)} begun", _kept(shot, name)
    else:
        words, update = f"take {edit.number} {'chosen' if edit.action == 'choose' else 'dropped'}", _other(shot, edit)
    stale = (name,) if edit.action == "choose" else ()
    return [Effect(shot.model_copy(update=update), name, words, frozenset({"camera"}), stale)]


def _next(shot: ShotContext) -> int:
    return max(shot.take, *(take.number for take in shot.takes), 0) + 1


def _kept(shot: ShotContext, name: str) -> dict[str, object]:
    """Return the update of a shot whose camera is put by; the next take begins with the same one."""
    if shot.camera is None:
        raise InputError(f"{name} has no camera yet that could be kept", mend="run `storyblender render` first")
    return {"take": _next(shot), "takes": (*shot.takes, shot.as_take)}


def _other(shot: ShotContext, edit: TakeEdit) -> dict[str, object]:
    """Return the update of a shot whose other take is chosen, or dropped."""
    name = name_of(shot)
    known = {take.number: take for take in shot.takes}
    if edit.number == shot.take:
        mend = "choose another one first" if edit.action == "drop" else "it needs no choosing"
        raise InputError(f"take {edit.number} of {name} is the one that the film shows", mend=mend)
    if edit.number not in known:
        numbers = ", ".join(map(str, sorted({*known, shot.take})))
        raise InputError(f"{name} has no take {edit.number}", mend=f"it has: {numbers}")
    chosen = known.pop(edit.number)
    if edit.action == "drop":
        return {"takes": tuple(known.values())}
    refuse_locked(shot, "camera")
    known[shot.take] = shot.as_take
    takes = tuple(known[number] for number in sorted(known))
    return {**{field: getattr(chosen, field) for field in TAKE_FIELDS}, "take": chosen.number, "takes": takes}
