"""Gestures of speech: a vocabulary of hand gestures, and phrases with their gestures, stresses and rests."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from storyblender.blender.motion.channel import TargetOf, ease_out
from storyblender.blender.motion.hands import Triple, by_chest
from storyblender.blender.motion.performer import Performer

LOW: Triple = (0.02, 0.34, -0.56)
"""Place of small gestures, before the belly: outwards, forwards, up from the shoulder in arm lengths."""
OVER_TABLE = 0.10
"""Arm lengths by which a seated person gestures higher."""
PREPARED, STRUCK = 0.36, 0.17
"""Seconds to raise a hand, and of the stroke that carries the stress."""
ONE_HANDED = 0.68
"""Share of the gestures that one hand makes, unless they need both."""


@dataclass(frozen=True)
class GesturePose:
    """A hand in a gesture; vectors are (outwards, forwards, up) in the chest's frame.

    Attributes:
        at: Palm from the shoulder, in arm lengths.
        fingers: Direction of the fingers.
        palm: Direction out of the palm.
        curl: Degrees of index finger, other fingers and thumb.
    """

    at: Triple
    fingers: Triple
    palm: Triple
    curl: Triple = (12, 20, 0)


@dataclass(frozen=True)
class Gesture:
    """A gesture: the hand is raised and strikes on the stress.

    Attributes:
        ready: Pose before the stroke.
        shown: Pose after it.
        both: Whether both hands always make it.
        alone: Whether only one hand ever makes it.
    """

    ready: GesturePose
    shown: GesturePose
    both: bool = False
    alone: bool = False


GESTURES: dict[str, Gesture] = {
    "offer": Gesture(
        GesturePose((0.00, 0.44, -0.40), (-0.25, 0.9, 0.35), (-0.4, -0.1, 0.9)),
        GesturePose((0.03, 0.64, -0.44), (-0.15, 1, 0.05), (-0.35, 0.0, 0.9)),
    ),
    "open": Gesture(
        GesturePose((-0.06, 0.44, -0.42), (-0.3, 0.9, 0.2), (-0.6, -0.1, 0.8)),
        GesturePose((0.24, 0.50, -0.46), (0.25, 0.95, 0.05), (-0.25, 0.1, 0.95)),
        both=True,
    ),
    "self": Gesture(
        GesturePose((-0.10, 0.40, -0.36), (-0.7, 0.6, 0.4), (-0.4, -0.9, 0.1)),
        GesturePose((-0.24, 0.27, -0.22), (-0.95, 0.15, 0.25), (0.0, -1, 0.1), (14, 18, 0)),
        alone=True,
    ),
    "stress": Gesture(
        GesturePose((-0.06, 0.50, -0.20), (-0.15, 0.8, 0.55), (-0.85, 0.1, -0.35), (48, 34, 26)),
        GesturePose((-0.05, 0.58, -0.36), (-0.15, 0.95, 0.1), (-0.85, 0.1, -0.4), (48, 34, 26)),
    ),
    "toss": Gesture(
        GesturePose((-0.08, 0.40, -0.46), (-0.4, 0.8, 0.2), (-0.5, -0.3, 0.8)),
        GesturePose((0.26, 0.42, -0.28), (0.4, 0.75, 0.5), (-0.1, 0.45, 0.85), (8, 12, 0)),
    ),
    "weigh": Gesture(
        GesturePose((-0.02, 0.46, -0.32), (-0.2, 0.95, 0.1), (-0.2, 0.1, -0.95), (10, 14, 0)),
        GesturePose((0.12, 0.52, -0.40), (0.05, 1, 0.05), (-0.1, 0.1, -1), (8, 10, 0)),
    ),
    "finger": Gesture(
        GesturePose((-0.01, 0.58, 0.18), (-0.1, 0.75, 0.75), (-0.75, 0.3, -0.5), (2, 80, 25)),
        GesturePose((-0.08, 0.92, -0.12), (-0.12, 1, -0.05), (-0.7, 0, -0.7), (2, 80, 25)),
        alone=True,
    ),
    "chop": Gesture(
        GesturePose((0.00, 0.52, -0.08), (-0.1, 0.85, 0.5), (-0.95, 0, -0.2), (4, 6, 0)),
        GesturePose((-0.02, 0.68, -0.38), (-0.1, 1, -0.2), (-0.95, 0, -0.3), (4, 6, 0)),
    ),
}
"""Gestures by name."""
REST = "rest"
"""Stands for no gesture: the hands rest during a phrase."""


@dataclass(frozen=True)
class SpokenPhrase:
    """Words on one breath.

    Attributes:
        start: Seconds.
        end: Seconds.
        gesture: Key of ``GESTURES``, or ``REST``.
        both: Whether both hands make it.
        stresses: Seconds of the stresses.
    """

    start: float
    end: float
    gesture: str
    both: bool
    stresses: tuple[float, ...]


def phrases(
    start: float, end: float, shares: Mapping[str, float], pace: float, rng: np.random.Generator
) -> list[SpokenPhrase]:
    """Divide a speech into phrases; no gesture comes twice in a row, not even after a rest.

    Args:
        start: Seconds.
        end: Seconds.
        shares: Frequency of each gesture, and of resting hands.
        pace: Mean seconds of a phrase.
        rng: Random generator.
    """
    found: list[SpokenPhrase] = []
    t, last, gestured = start, "", ""
    while t < end - 0.6:
        length = pace * rng.uniform(0.75, 1.35)
        until = end if t + length > end - 0.8 else t + length
        names = [name for name in shares if name not in (last, gestured, "" if found else REST)] or list(shares)
        weights = np.array([shares[name] for name in names])
        last = str(rng.choice(names, p=weights / weights.sum()))
        gestured = gestured if last == REST else last
        shape, chance = GESTURES.get(last), rng.random()
        both = shape is not None and (shape.both or (not shape.alone and chance > ONE_HANDED))
        first = t + PREPARED + rng.uniform(0.05, 0.2)
        later = np.arange(first + rng.uniform(0.5, 0.75), until - 0.35, rng.uniform(0.55, 0.8))
        found.append(SpokenPhrase(t, until, last, both, (first, *later.tolist())))
        t = until
    return found


def gesticulate(
    who: Performer,
    hands: list[str],
    lead: str,
    spoken: list[SpokenPhrase],
    size: float,
    room: float,
    rng: np.random.Generator,
) -> None:
    """Set the gestures of phrases on a speaker's free hands; hands without a gesture return to rest.

    Args:
        who: The speaker.
        hands: Free hands.
        lead: The hand that makes most gestures.
        spoken: The phrases.
        size: Size of the gestures, 0..1.
        room: Share of a full gesture that fits before the listener.
        rng: Random generator, for small differences.
    """
    away: set[str] = set()
    for phrase in spoken:
        active: list[str] = []
        if phrase.gesture != REST:
            one = lead if lead in hands and rng.random() < 0.75 else hands[-1] if lead == hands[0] else hands[0]
            active = hands if phrase.both else [one]
        for side in sorted(away - set(active)):
            who.hands[side].set(phrase.start, 0.6, who.home[side])
        for side in active:
            shape, shift = GESTURES[phrase.gesture], rng.normal(0, 0.025, 3)
            ready, shown = (_hand(who, side, pose, size, room, shift) for pose in (shape.ready, shape.shown))
            who.hands[side].set(phrase.start, PREPARED, ready)
            for index, stress in enumerate(phrase.stresses):
                if index:  # the hand goes half back, and strikes again
                    who.hands[side].set(stress - 0.3, 0.26, _between(who, side, shape, size, room, shift))
                who.hands[side].set(stress, STRUCK, shown, ease=ease_out)
        away = set(active)


def _between(who: Performer, side: str, shape: Gesture, size: float, room: float, shift: np.ndarray) -> TargetOf:
    """Return the target halfway between a gesture's two poses."""
    at = tuple(0.5 * (a + b) for a, b in zip(shape.ready.at, shape.shown.at, strict=True))
    pose = GesturePose((at[0], at[1], at[2]), shape.shown.fingers, shape.shown.palm, shape.shown.curl)
    return _hand(who, side, pose, size, room, shift)


def _hand(who: Performer, side: str, pose: GesturePose, size: float, room: float, shift: np.ndarray) -> TargetOf:
    """Return the target of a gesture's pose: smaller towards the belly, nearer where there is little room."""
    share = 0.45 + 0.55 * size
    out, ahead, up = (low + (full - low) * share for low, full in zip(LOW, pose.at, strict=True))
    over = OVER_TABLE if who.posture == "sit" else 0.0
    at = (out + float(shift[0]), min(ahead, ahead * room + 0.1) + float(shift[1]), up + over + float(shift[2]))
    return by_chest(who, side, at, pose.fingers, pose.palm, curl=pose.curl)
