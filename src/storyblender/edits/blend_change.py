"""One thing that a person changed in a story's .blend."""

from __future__ import annotations

from typing import Literal

from storyblender.memory.base import Frozen
from storyblender.memory.blend_values import NodeValues
from storyblender.memory.edits import Edit

ChangeKind = Literal[
    "moved", "turned", "scaled", "deleted", "duplicated", "added", "renamed", "camera", "lens", "aperture",
    "lamp", "material", "reshaped", "cut", "marker", "strip", "keys added", "keys retimed", "posed", "unknown",
]  # fmt: skip


class BlendChange(Frozen):
    """One thing that is otherwise in the file than it was compiled."""

    kind: ChangeKind
    """What was done."""
    scene: str = ""
    """Such as ``SC010``; empty for a material."""
    subject: str
    """Node id of a thing, person or lamp, name of a shot or of a material."""
    words: str
    """What was done, as a person reads it."""
    before: NodeValues | None = None
    """The object as it was compiled."""
    after: NodeValues | None = None
    """As it is."""
    compiled: str = ""
    """What it was, in short, where the words do not tell."""
    saved: str = ""
    """What it is."""
    edits: tuple[Edit, ...] = ()
    """What makes the change, where that does not depend on the project as it is."""
    lengths: dict[str, int] = {}
    """Frames of the shots that a moved marker makes longer or shorter, by name."""
