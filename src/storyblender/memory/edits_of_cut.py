"""Edits of the cut as data: takes, notes, approval, and shots that are omitted, moved, split, joined and added."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from storyblender.memory.base import Described, EditName, Frames
from storyblender.memory.notes import MOST_NOTES, NoteAuthor, NoteText
from storyblender.memory.shot_context import CameraDecision


class TakeEdit(Described):
    """Keeps camera, blocking or layout as a take and goes on with the next, chooses a take, or drops one."""

    kind: Literal["take"] = "take"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``; for a layout the scene, such as ``SC010``, or one of its shots."""
    of: Literal["camera", "blocking", "layout"] = "camera"
    """Of what: the camera of the shot, where people are and what they do in it, or where all is in its scene."""
    action: Literal["keep", "choose", "drop"] = "keep"
    """What is done."""
    number: int | None = Field(default=None, ge=1, le=999)
    """Of the take to choose or drop."""

    @model_validator(mode="after")
    def _has_number(self) -> Self:
        if (self.number is None) != (self.action == "keep"):
            raise ValueError("a take that is kept gets its number; one that is chosen or dropped is named by it")
        return self


class NoteEdit(Described):
    """Writes a note on a shot, marks one as done, or takes one away."""

    kind: Literal["note"] = "note"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``."""
    action: Literal["add", "resolve", "reopen", "remove"] = "add"
    """What is done."""
    text: NoteText | None = None
    """Words of the note that is added."""
    author: NoteAuthor = ""
    """Who writes it."""
    number: int | None = Field(default=None, ge=1, le=MOST_NOTES)
    """Of the note that is resolved, reopened or removed."""

    @model_validator(mode="after")
    def _is_whole(self) -> Self:
        if self.action == "add" and (self.text is None or not self.text.strip() or self.number is not None):
            raise ValueError("a note that is added takes its text, and gets its number")
        if self.action != "add" and (self.number is None or self.text is not None):
            raise ValueError(f"to {self.action} a note takes its number")
        return self


class OmitEdit(Described):
    """Leaves a shot or a scene out of the film, board and timeline; its number stays, and nothing of it is lost."""

    kind: Literal["omit"] = "omit"
    """Which edit this is."""
    target: EditName
    """A shot such as ``SC010_SH020``, or a scene such as ``SC010``."""


class RestoreEdit(Described):
    """Brings a shot or a scene back that was omitted."""

    kind: Literal["restore"] = "restore"
    """Which edit this is."""
    target: EditName
    """As for omitting."""


class ReorderEdit(Described):
    """Moves a shot to another place in its scene, or a scene in the film; names stay as they are."""

    kind: Literal["reorder"] = "reorder"
    """Which edit this is."""
    target: EditName
    """A shot such as ``SC010_SH020``, or a scene such as ``SC010``."""
    before: EditName | None = None
    """The shot or scene that follows it then; or give after."""
    after: EditName | None = None
    """The shot or scene that it follows then; or give before."""

    @model_validator(mode="after")
    def _has_one_place(self) -> Self:
        if (self.before is None) == (self.after is None):
            raise ValueError("a new place is before something or after something")
        return self


class SplitEdit(Described):
    """Splits a shot in two where a line begins or at a time; the second gets a number between and the same camera."""

    kind: Literal["split"] = "split"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``."""
    line: int | None = Field(default=None, ge=2)
    """Number of the line of the shot that the second one begins with, counted from 1; or give frames or seconds."""
    frames: Annotated[Frames, Field(ge=1)] | None = None
    """First frame of the second one, counted from the start of the shot."""
    seconds: float | None = Field(default=None, gt=0, le=3600)
    """The same in seconds."""

    @model_validator(mode="after")
    def _has_one_place(self) -> Self:
        if sum(each is not None for each in (self.line, self.frames, self.seconds)) != 1:
            raise ValueError("a shot is split at a line, or at a time in frames or in seconds")
        return self


class JoinEdit(Described):
    """Joins two neighbours of one scene: the first goes on for the time of the second, with its own camera."""

    kind: Literal["join"] = "join"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``."""
    other: EditName
    """The shot after it, or before it."""


class AddShotEdit(Described):
    """Adds a shot after another one: a further camera on the same moment, such as an insert or a reaction."""

    kind: Literal["add_shot"] = "add_shot"
    """Which edit this is."""
    shot: EditName
    """The shot that it follows, such as ``SC010_SH020``."""
    decision: CameraDecision
    """Its camera; what is left out is as in that shot, or is the crew's to choose."""
    at: float | None = Field(default=None, ge=0, le=3600)
    """Seconds from the start of that shot at which it begins; left out, the moment of its frame is in the middle."""
    seconds: float | None = Field(default=None, gt=0, le=3600)
    """Its length; left out, 2 seconds, or what is left of the scene."""


class ApproveEdit(Described):
    """Approves a shot whose frame shows it as it is, and locks all of it; or withdraws that, and earlier locks stay."""

    kind: Literal["approve"] = "approve"
    """Which edit this is."""
    shot: EditName
    """Such as ``SC010_SH020``."""
    approved: bool = True
    """False withdraws the approval."""
