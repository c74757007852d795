"""The form of an act: key poses in time, one row of data for a motion that needs no code of its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from storyblender.catalog.motion_entry import Motion, Reach
from storyblender.memory.vocabulary import Posture

Triple = tuple[float, float, float]
Frame = Literal[
    "chest", "upright", "head", "work", "ground", "their_head", "their_chest", "their_shoulder", "their_hand"
]  # fmt: skip
Gaze = Literal["target", "ahead", "down", "up", "left", "right", "back", "away", "hands", "around"]
HOME_SECONDS = 0.6
"""In which everything goes back at the end of an act."""


@dataclass(frozen=True)
class HandPose:
    """Where a hand is and how it is held. Triples are outwards (to the hand's own side), forwards, up.

    Attributes:
        at: The palm's centre. From the shoulder in arm lengths for ``chest`` and ``upright``; metres of somebody of
            1.7 m from between the eyes for ``head``, from what is worked on for ``work``, from between the feet for
            ``ground``, from a part of the other person for ``their_...``; these three in one's own axes.
        fingers: Where the fingers point.
        palm: Where the palm looks.
        elbow: Where the elbow points.
        curl: Degrees of forefinger, other fingers and thumb.
        frame: What it is measured from. ``chest`` bends with the trunk, ``upright`` does not.
        tool: Where the top and the front of a thing in the hand point; None holds it as the hand is held.
    """

    at: Triple
    fingers: Triple = (0.0, 1.0, 0.0)
    palm: Triple = (-1.0, 0.0, 0.0)
    elbow: Triple = (0.5, -0.5, -0.85)
    curl: Triple = (18.0, 25.0, 0.0)
    frame: Frame = "chest"
    tool: tuple[Triple, Triple] | None = None


@dataclass(frozen=True)
class FootPose:
    """Where a foot is: aside, ahead and up of its place in standing, metres of somebody of 1.7 m, and its pitch.

    ``pitch`` is in degrees, toes up above 0.
    """

    aside: float = 0.0
    ahead: float = 0.0
    up: float = 0.0
    pitch: float = 0.0


@dataclass(frozen=True)
class Key:
    """One key pose. What is None stays as it was.

    Attributes:
        seconds: To get there.
        stay: Seconds to remain.
        lead: The hand that acts.
        far: The other hand.
        spine: Degrees the trunk bends forwards, to the acting hand's side, turns to it.
        hips: Metres of somebody of 1.7 m to the acting hand's side, ahead and up, and degrees of forward pitch.
        nod: Degrees of the head: down, to the acting hand's side, turned to it.
        face: An expression.
        gaze: Where to look.
        lead_foot: The foot on the acting hand's side.
        far_foot: The other foot.
    """

    seconds: float
    stay: float = 0.0
    lead: HandPose | None = None
    far: HandPose | None = None
    spine: Triple | None = None
    hips: tuple[float, float, float, float] | None = None
    nod: Triple | None = None
    face: str | None = None
    gaze: Gaze | None = None
    lead_foot: FootPose | None = None
    far_foot: FootPose | None = None


@dataclass(frozen=True)
class Act:
    """A motion made of key poses.

    Attributes:
        key: Name of the motion.
        name: For people.
        tags: Other words for it.
        keys: In order.
        again: Index of the key from which the keys are repeated until the end of a stretching act; None plays them once
            and stays in the last.
        stretches: Whether a cue may give it another length.
        told: Index of the key that a still picture shows, as soon as it is reached; None takes the last.
        reach: What it needs to be near to.
        distance: Metres from the other person, or from the thing.
        before: Postures it can start from.
        directs: Other motions of the Director that it plays.
        partner: Key poses of the other person meanwhile.
        second: Metres along a tool from the acting hand to where the other hand holds it; None leaves that hand free.
        stays: What it shows lasts after it, until the hands are needed.
    """

    key: str
    name: str
    tags: tuple[str, ...]
    keys: tuple[Key, ...]
    again: int | None = None
    stretches: bool = False
    told: int | None = None
    reach: Reach = "self"
    distance: float = 0.0
    before: tuple[Posture, ...] = ()
    directs: tuple[str, ...] = ()
    partner: tuple[Key, ...] = ()
    second: float | None = None
    stays: bool = False

    @property
    def hands(self) -> int:
        """How many hands it needs."""
        lead = any(key.lead is not None for key in self.keys)
        far = self.second is not None or any(key.far is not None for key in self.keys)
        return int(lead) + int(far)

    @property
    def bodily(self) -> bool:
        """Whether hips and feet tell it."""
        return any(key.hips or key.lead_foot or key.far_foot for key in self.keys)

    @property
    def once(self) -> float:
        """Seconds of all keys, played once."""
        return sum(key.seconds + key.stay for key in self.keys)

    @property
    def seconds(self) -> float:
        """Natural length."""
        return self.once + (0.0 if self.stays else HOME_SECONDS)

    @property
    def telling(self) -> float:
        """Share of its length at which the telling key has just been reached."""
        until = len(self.keys) if self.told is None else self.told + 1
        shown = self.keys[until - 1]
        reached = sum(key.seconds + key.stay for key in self.keys[:until]) - shown.stay
        return min(0.97, (reached + 0.4 * shown.stay) / self.seconds)

    @property
    def motion(self) -> Motion:
        """The entry of the catalogue of motions."""
        return Motion(
            key=self.key,
            name=self.name,
            tags=self.tags,
            seconds=round(self.seconds, 2),
            directs=(self.key, *self.directs),
            stretches=self.stretches,
            before=self.before,
            reach=self.reach,
            distance=self.distance,
            hands=self.hands,
            lasts=self.stretches or self.stays,
            telling=round(self.telling, 3),
        )
