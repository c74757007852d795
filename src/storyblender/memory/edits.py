"""Edits as data: one typed union for all that make them (command line, page, agent, another program)."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, TypeAdapter, model_validator

from storyblender.memory.base import Described, Frames
from storyblender.memory.locks import LockName
from storyblender.memory.shot_context import CameraDecision

_Name = Annotated[str, Field(min_length=1, max_length=64)]


class CameraEdit(Described):
    """Decides about the camera of a shot; what is left out stays as it is, or is the crew's to choose."""

    kind: Literal["camera"] = "camera"
    """Which edit this is."""
    shot: _Name
    """Such as ``SC010_SH020``."""
    decision: CameraDecision
    """Any of its fields; those left out stay as they are."""


class DurationEdit(Described):
    """Gives a shot a length, in frames or in seconds; the crew fits its motions to it."""

    kind: Literal["duration"] = "duration"
    """Which edit this is."""
    shot: _Name
    """Such as ``SC010_SH020``."""
    frames: Annotated[Frames, Field(ge=1)] | None = None
    """Length in frames; or give seconds."""
    seconds: float | None = Field(default=None, gt=0, le=3600)
    """Length in seconds; or give frames."""

    @model_validator(mode="after")
    def _has_one_unit(self) -> Self:
        if (self.frames is None) == (self.seconds is None):
            raise ValueError("a length is given in frames or in seconds")
        return self


class LockEdit(Described):
    """Keeps parts of a shot, of a scene or of an asset as they are, against the crew and against further edits."""

    kind: Literal["lock"] = "lock"
    """Which edit this is."""
    target: _Name
    """A shot such as ``SC010_SH020``, a scene such as ``SC010``, or an asset's id."""
    parts: tuple[LockName, ...] = ()
    """Camera, blocking, duration of a shot; layout, light, set of a scene; the asset. All of them if empty."""


class UnlockEdit(Described):
    """Lifts locks, and gives back to the crew what a person decided about these parts."""

    kind: Literal["unlock"] = "unlock"
    """Which edit this is."""
    target: _Name
    """As for a lock."""
    parts: tuple[LockName, ...] = ()
    """As for a lock."""


Edit = Annotated[CameraEdit | DurationEdit | LockEdit | UnlockEdit, Field(discriminator="kind")]
EDITS: TypeAdapter[tuple[Edit, ...]] = TypeAdapter(tuple[Edit, ...])
"""Reads a batch of edits from JSON."""
