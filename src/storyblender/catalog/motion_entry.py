"""What the catalogue says about one motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from storyblender.memory.vocabulary import Posture

Reach = Literal["self", "person", "thing", "place"]
"""What a motion is about, besides the one who moves: nobody, another person, a thing, a place to go to."""
UPRIGHT: tuple[Posture, ...] = ("stand",)
AWAKE: tuple[Posture, ...] = ("stand", "sit", "kneel", "crouch", "lean")


@dataclass(frozen=True)
class Motion:
    """One motion.

    Attributes:
        key: Name of the clip.
        name: For people.
        tags: Other words for it.
        seconds: Natural length for a stature of 1.7 m, without any way to go; for stretching motions the usual length.
        directs: The Director's motions that this clip plays, beside the one of its own name.
        speed: Metres per second of motions that travel.
        stretches: Its length may be chosen by the cue's duration.
        before: Postures it can start from; empty for any. Others are left first.
        after: Posture it ends in; None keeps the one before.
        reach: What it needs to be near to.
        distance: Metres to keep from the other person for ``reach`` person; to stand from a thing.
        hands: Number of hands it needs.
        lasts: Goes on while one talks and looks about, until the hands are needed for something else.
        telling: Share of its length at which a still picture of it is drawn: when it has landed, or at its extreme.
    """

    key: str
    name: str
    tags: tuple[str, ...]
    seconds: float
    directs: tuple[str, ...] = ()
    speed: float | None = None
    stretches: bool = False
    before: tuple[Posture, ...] = ()
    after: Posture | None = None
    reach: Reach = "self"
    distance: float = 0.0
    hands: int = 0
    lasts: bool = False
    telling: float = 0.5
