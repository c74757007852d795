"""Everything that an edit, an agent or a language model can name, each with a sentence: one source for all of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Final, TypeAlias

from storyblender.agents.layout_artist.camera_operator import FIX_WORDS, OPERATION_WORDS
from storyblender.catalog.motions import MOTIONS, motion_words
from storyblender.catalog.registry import Entry
from storyblender.catalog.sets import SETS
from storyblender.geometry.framing import ELEVATION
from storyblender.memory.edits import EDITS
from storyblender.memory.shot_sizes import SIZES
from storyblender.memory.vocabulary import CameraDirection, Movement, ShotKind

Words: TypeAlias = dict[str, str]
"""A sentence for every word."""

KINDS: Final[dict[ShotKind, str]] = {
    "establishing": "the place, with the people in it",
    "action": "what the lines do, as wide as it needs",
    "two_shot": "two people together",
    "group": "three people or more together",
    "ots": "one person over the shoulder of another (over_id)",
    "single": "one person",
    "reaction": "the face of one person who listens or sees",
    "insert": "a thing, or a hand, and little else",
    "pov": "what a person (pov_id) sees; they are not in the picture",
}
"""Kinds of pictures."""
MOVES: Final[dict[Movement, str]] = {
    "static": "the camera stands still",
    "pan": "turns on the spot to the left or right, or with a person who walks",
    "tilt": "turns on the spot up or down",
    "orbit": "goes around the subject",
    "push in": "comes nearer",
    "pull out": "goes back",
    "truck": "slides to the left or right",
    "pedestal": "goes up or down",
    "zoom in": "gets a longer lens from where it stands",
    "zoom out": "gets a wider lens from where it stands",
    "track": "travels with a person who walks, or along the scene",
}
"""What a camera does during a shot."""
WAYS: Final[dict[CameraDirection, str]] = {
    "left": "to the left of the picture", "right": "to the right of the picture",
    "up": "of a tilt, a pedestal or an orbit", "down": "of a tilt, a pedestal or an orbit",
}  # fmt: skip
"""Where a move goes."""


def vocabulary(own_motions: Mapping[str, str] | None = None) -> dict[str, Any]:
    """Return every word that can be named, with a sentence: edits and their fields, cameras, operations, catalogues.

    Args:
        own_motions: The user's clips, by the key that edits have for them, with what each shows.
    """
    sizes = {size: f"{row.words}: a head fills {row.head:.0%} of the height, a thing {row.fill:.0%}"
             for size, row in SIZES.items()}  # fmt: skip
    camera = {"kind": KINDS, "size": sizes, "angle": _angles(), "movement": MOVES, "direction": WAYS}
    return {
        "edits": _edits(),
        "camera": camera,
        "camera_operations": OPERATION_WORDS,
        "critic_fixes": FIX_WORDS,
        "motions": {key: motion_words(key) for key in MOTIONS},
        "own_motions": dict(own_motions or {}),
        "sets": {kit.key: kit.description or kit.name for kit in SETS.values()},
    }


def _angles() -> Words:
    def told(angle: str, degrees: float) -> str:
        leans = ", and the horizon leans" if angle == "dutch" else ""
        return f"the camera is {abs(degrees):.0f} degrees {'above' if degrees >= 0 else 'below'} the eyes{leans}"

    return {angle: told(angle, degrees) for angle, degrees in ELEVATION.items()}


def _edits() -> dict[str, Any]:
    """Return the kinds of edits: what each does, and its fields, as their schema says them."""
    schema = EDITS.json_schema()
    kinds = schema["items"]["discriminator"]["mapping"]
    defs = {f"#/$defs/{name}": each for name, each in schema["$defs"].items()}
    return {
        kind: {"does": " ".join(defs[ref]["description"].split()), "fields": dict(_fields(defs[ref], defs))}
        for kind, ref in kinds.items()
    }


def _fields(model: Mapping[str, Any], defs: Mapping[str, Mapping[str, Any]]) -> Iterator[tuple[str, str]]:
    """Yield the fields of a model with what they say; those of a decision as ``decision.size``."""
    for name, field in model["properties"].items():
        yield name, " ".join(field.get("description", "").split())
        if name == "decision":
            inner = defs[field["$ref"]]
            yield from ((f"{name}.{each}", words) for each, words in _fields(inner, defs))


def _entries(entries: Iterable[Entry]) -> Iterator[tuple[str, str]]:
    """Yield the entries of a catalogue with their names and the other words for them."""
    for entry in entries:
        yield entry.key, f"{entry.name} ({', '.join(entry.tags)})" if entry.tags else entry.name
