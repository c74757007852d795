"""Notes on shots, and the approval of a shot."""

from __future__ import annotations

from storyblender.edits.effect import Effect, name_of
from storyblender.edits.targets import shots_named
from storyblender.errors import InputError
from storyblender.memory.edits import ApproveEdit, NoteEdit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.locks import SHOT_LOCKS
from storyblender.memory.notes import MOST_NOTES, Note
from storyblender.memory.shot_context import ShotContext

_DONE = {"resolve": "resolved", "reopen": "reopened", "remove": "removed"}


def note_effects(graph: ContinuityMemoryGraph, edit: NoteEdit) -> list[Effect]:
    """Return what adding, resolving, reopening or removing a note does to its shot. Raises InputError."""
    [shot] = shots_named(graph, [edit.shot])
    name = name_of(shot)
    if edit.action == "add":
        number = max((note.number for note in shot.notes), default=0) + 1
        if number > MOST_NOTES:
            raise InputError(f"{name} has {MOST_NOTES} notes already", mend="remove some that are resolved")
        note = Note(number=number, text=(edit.text or "").strip(), author=edit.author.strip())
        return [_effect(shot, (*shot.notes, note), f"note {number}: “{note.words}”")]
    number = edit.number
    if number not in {note.number for note in shot.notes}:
        numbers = ", ".join(str(note.number) for note in shot.notes)
        raise InputError(f"{name} has no note {number}", mend=f"it has: {numbers}" if numbers else "it has none")
    resolved = edit.action == "resolve"
    notes = tuple(
        note if note.number != number else note.model_copy(update={"resolved": resolved})
        for note in shot.notes
        if note.number != number or edit.action != "remove"
    )
    if notes == shot.notes:
        raise InputError(f"note {number} of {name} is {'resolved' if resolved else 'open'} already")
    return [_effect(shot, notes, f"note {number} {_DONE[edit.action]}")]


def _effect(shot: ShotContext, notes: tuple[Note, ...], words: str) -> Effect:
    return Effect(shot.model_copy(update={"notes": notes}), name_of(shot), words, frozenset({"notes"}))


def approve_effects(graph: ContinuityMemoryGraph, edit: ApproveEdit) -> list[Effect]:
    """Return what approving a shot, or withdrawing the approval, does to it. Raises InputError."""
    [shot] = shots_named(graph, [edit.shot])
    name = name_of(shot)
    if edit.approved == (shot.approved is not None):
        raise InputError(f"{name} is {'approved already' if edit.approved else 'not approved'}")
    if edit.approved:
        update = {"approved": shot.locked, "locked": tuple(SHOT_LOCKS)}
    else:
        update = {"approved": None, "locked": shot.approved}
    words = "approved" if edit.approved else "approval withdrawn"
    return [Effect(shot.model_copy(update=update), name, words, frozenset({"approval", *SHOT_LOCKS}))]
