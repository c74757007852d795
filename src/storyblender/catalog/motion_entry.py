"""Data model of one motion of the catalogue."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from storyblender.memory.vocabulary import Posture

Reach = Literal["self", "person", "thing", "place"]
"""Target of a motion besides the actor: none, another person, an object, or a destination."""
UPRIGHT: tuple[Posture, ...] = ("stand",)
AWAKE: tuple[Posture, ...] = ("stand", "sit", "kneel", "crouch", "lean")


@dataclass(frozen=True)
class Motion:
    """One motion.

    Attributes:
        key: Name of the clip.
        name: Display name.
        tags: Synonyms.
        seconds: Natural duration at a stature of 1.7 m, without the walk to it; the usual one for stretching motions.
        directs: Motions of the Director's vocabulary that this clip plays.
        speed: Metres per second of motions that travel.
        stretches: Whether a cue may set its duration.
        before: Postures it can start from, empty for any; the actor leaves other postures first.
        after: Posture it ends in; None keeps the one before.
        reach: Kind of target that the actor must be near.
        distance: Metres to the other person for ``reach`` person, or to the object.
        hands: Number of hands it needs.
        lasts: Whether it continues during talking and looking until another cue needs the hands.
        telling: Share of the duration at which a still frame shows it best: on landing, or at its extreme.
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
