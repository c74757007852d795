"""Data model of an act: timed key poses, for a motion that needs no code of its own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from storyblender.catalog.motion_entry import Motion, Reach
from storyblender.memory.vocabulary import Posture

Triple = tuple[float, float, float]
Frame = Literal[
    "chest", "upright", "head", "work", "ground", "planted", "their_head", "their_chest", "their_shoulder", "their_hand"
]  # fmt: skip
Gaze = Literal["target", "ahead", "down", "up", "left", "right", "back", "away", "hands", "around"]
HOME_SECONDS = 0.6
"""Seconds that the body takes to return to its rest pose at the end of an act."""


@dataclass(frozen=True)
class HandPose:
    """Position and orientation of a hand. Triples are outwards (to the hand's own side), forwards, up.

    Attributes:
        at: Palm centre. In arm lengths from the shoulder for ``chest`` and ``upright``; in metres at a stature of
            1.7 m from between the eyes for ``head``, from the work piece for ``work``, from between the feet for
            ``ground``, from the grip of the held tool where it stands between the feet for ``planted``, from a part
            of the other person for ``their_...``; the last four in the actor's own axes.
        fingers: Direction of the fingers.
        palm: Direction that the palm faces.
        elbow: Direction of the elbow.
        curl: Curl in degrees of the forefinger, the other fingers and the thumb.
        frame: Reference frame of ``at``. ``chest`` bends with the trunk, ``upright`` does not.
        tool: Directions of the top and the front of the held tool; None lets it follow the hand.
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
    """Offset of a foot from its standing place, outwards, forwards and up, in metres at 1.7 m, and its pitch.

    ``pitch`` is in degrees, toes up above 0.
    """

    aside: float = 0.0
    ahead: float = 0.0
    up: float = 0.0
    pitch: float = 0.0


@dataclass(frozen=True)
class Key:
    """One key pose. Parts that are None stay as they were.

    Attributes:
        seconds: Seconds to reach the pose.
        stay: Seconds to hold the pose.
        lead: Pose of the acting hand.
        far: Pose of the other hand.
        spine: Degrees that the trunk bends forwards, bends to the acting hand's side, and turns to that side.
        hips: Hip offset to the acting hand's side, forwards and up, in metres at 1.7 m, and forward pitch in degrees.
        nod: Degrees that the head tilts down, tilts to the acting hand's side, and turns to that side.
        face: Name of an expression.
        gaze: Gaze target.
        lead_foot: Pose of the foot on the acting hand's side.
        far_foot: Pose of the other foot.
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
        name: Display name.
        tags: Synonyms.
        keys: Key poses in order.
        again: Index of the first key of the loop that fills a stretching act; None plays the keys once and holds the
            last.
        stretches: Whether a cue may set another duration.
        still_key: Index of the key that a still frame shows, at the moment it is reached; None takes the last.
        reach: Kind of target that the actor must be near.
        distance: Metres from the other person or the object.
        before: Postures it can start from.
        directs: Further motions of the Director's vocabulary that this act plays.
        partner: Simultaneous key poses of the other person.
        second: Metres along the tool from the acting hand to the grip of the other hand; None leaves that hand free.
        stays: Whether the last pose is held after the act until the hands are needed.
    """

    key: str
    name: str
    tags: tuple[str, ...]
    keys: tuple[Key, ...]
    again: int | None = None
    stretches: bool = False
    still_key: int | None = None
    reach: Reach = "self"
    distance: float = 0.0
    before: tuple[Posture, ...] = ()
    directs: tuple[str, ...] = ()
    partner: tuple[Key, ...] = ()
    second: float | None = None
    stays: bool = False

    @property
    def hands(self) -> int:
        """Number of hands that the act needs."""
        lead = any(key.lead is not None for key in self.keys)
        far = self.second is not None or any(key.far is not None for key in self.keys)
        return int(lead) + int(far)

    @property
    def bodily(self) -> bool:
        """Whether the act moves the hips or feet."""
        return any(key.hips or key.lead_foot or key.far_foot for key in self.keys)

    @property
    def once(self) -> float:
        """Duration of all keys played once, in seconds."""
        return sum(key.seconds + key.stay for key in self.keys)

    @property
    def seconds(self) -> float:
        """Natural duration in seconds."""
        return self.once + (0.0 if self.stays else HOME_SECONDS)

    @property
    def telling(self) -> float:
        """Share of the duration at which the key for the still frame has just been reached."""
        until = len(self.keys) if self.still_key is None else self.still_key + 1
        shown = self.keys[until - 1]
        reached = sum(key.seconds + key.stay for key in self.keys[:until]) - shown.stay
        return min(0.97, (reached + 0.4 * shown.stay) / self.seconds)

    @property
    def motion(self) -> Motion:
        """Entry of the act in the motion catalogue."""
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
