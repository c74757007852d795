"""Talking, laughing, crying: gestures, mouth movement and face."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from storyblender.blender.motion.channel import clamp
from storyblender.blender.motion.clips.gaze import look_at_subject, look_at_target, point_aside, show_mood
from storyblender.blender.motion.clips.phrasing import REST, SpokenPhrase, gesticulate, phrases
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_chest, by_head
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, other

LONG_LAUGH = 1.4
"""Seconds; in a shorter laugh no hand has time to move."""
LOOKS_AWAY = 0.45
"""Probability that a speaker looks aside before a phrase."""


@dataclass(frozen=True)
class Manner:
    """A way of talking.

    Attributes:
        size: Size of the gestures, 0..1.
        pace: Mean seconds of a phrase.
        lean: Degrees by which the trunk is bent.
        shares: Frequency of each gesture, and of resting hands.
        mouth: Opening of the mouth, 0..1.
        rate: Syllables per second.
    """

    size: float
    pace: float
    lean: float
    shares: Mapping[str, float]
    mouth: float = 0.75
    rate: float = 2.3


QUIET_HANDS: Mapping[str, float] = {REST: 1.0}
"""Shares of a speech without gestures."""
MANNERS: dict[str, Manner] = {
    "neutral": Manner(
        0.7, 1.9, 0, {REST: 2.2, "offer": 2.5, "open": 1.2, "stress": 1.6, "toss": 1.2, "weigh": 1.4, "self": 0.8}
    ),
    "happy": Manner(1.0, 1.6, -2, {REST: 0.8, "open": 2.5, "offer": 2, "toss": 2, "self": 1.2, "weigh": 1}),
    "sad": Manner(0.35, 2.4, 7, {REST: 3.0, "offer": 1.4, "self": 1.6, "weigh": 1}, mouth=0.55, rate=2.0),
    "angry": Manner(
        1.0, 1.35, 8, {REST: 0.6, "finger": 2.6, "chop": 2.2, "open": 1.4, "toss": 1.2, "self": 0.8}, 1.0, 3.1
    ),
    "afraid": Manner(0.5, 1.4, -4, {REST: 1.8, "weigh": 1.6, "self": 1.8, "open": 1.2}, mouth=0.6, rate=3.0),
    "tender": Manner(0.4, 2.3, 4, {REST: 2.6, "offer": 2, "self": 1.8, "weigh": 0.8}, mouth=0.55, rate=2.0),
}


@clip("talk")
def talk(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Speak to the target for the cue's duration, with gestures of the free hands. Return the end in seconds."""
    return _speak(stage, who, cue, MANNERS[cue.mood])


@clip("whisper")
def whisper(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Whisper, leaning in, hands quiet. Return the end in seconds."""
    return _speak(stage, who, cue, Manner(0.0, 1.8, 10, QUIET_HANDS, mouth=0.35, rate=2.6))


@clip("shout")
def shout(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Shout with large gestures. Return the end in seconds."""
    return _speak(stage, who, cue, Manner(1.0, 1.3, 6, MANNERS["angry"].shares, 1.0, 2.2))


def _speak(stage: MotionStage, who: Performer, cue: StagedCue, manner: Manner) -> float:
    """Speak in a manner for the cue's duration; return the end in seconds."""
    t, end = cue.start, cue.start + (cue.duration or 2.5)
    rng = np.random.default_rng(cue.seed)
    look_at_target(stage, who, t, cue)
    show_mood(who, t, cue.mood)
    who.speeches.append((t, end, manner.mouth, manner.rate))
    who.accent.set(t, 0.4, (manner.lean, 0, 0))
    who.nod.set(t, 0.3, (-3, 0, 0))
    spoken = phrases(t + 0.15, end - 0.2, manner.shares, manner.pace, rng)
    hands = [side for side in SIDES if who.is_free(side) and who.free[side] <= t + 0.2]
    if hands and manner.size > 0 and end - t > 1.2 and who.posture not in ("lie", "asleep"):
        who.lean_after.set(t, 0, 0.0)
        gesticulate(who, hands, cue.side, spoken, manner.size, _room(stage, who, cue), rng)
        for side in hands:
            who.hands[side].set(end - 0.3, 0.6, who.home[side])
        who.lean_after.set(end + 0.3, 0, 1.0)
    for phrase in spoken:
        _stress(who, phrase, manner, rng)
    if cue.target is not None and cue.mood != "angry":
        _look_away(stage, who, cue, spoken[1:], rng)
    who.accent.set(end - 0.2, 0.5, (0, 0, 0))
    who.nod.set(end - 0.2, 0.3, (0, 0, 0))
    if cue.mood != "neutral":
        show_mood(who, end, "neutral", 0.8)
    return end


def _stress(who: Performer, phrase: SpokenPhrase, manner: Manner, rng: np.random.Generator) -> None:
    """Move head and trunk with a phrase: one way of holding the head, a nod on every stress."""
    turned, tilted = rng.uniform(-5, 5) * manner.size, rng.uniform(-5, 5)
    push = 4.0 if manner.size == 1.0 else 1.5
    for stress in phrase.stresses:
        depth = rng.uniform(3, 7) * manner.size + 2
        who.nod.set(stress - 0.05, 0.15, (depth, tilted, turned))
        who.nod.set(stress + 0.18, 0.3, (0, 0.7 * tilted, 0.5 * turned))
        who.accent.set(stress - 0.06, 0.24, (manner.lean + push, 0, turned))
        who.accent.set(stress + 0.3, 0.4, (manner.lean, 0, 0.6 * turned))


def _look_away(
    stage: MotionStage, who: Performer, cue: StagedCue, spoken: list[SpokenPhrase], rng: np.random.Generator
) -> None:
    """Look aside for a moment before some phrases, and back at the listener."""
    for phrase in spoken:
        if rng.random() < LOOKS_AWAY:
            who.eyes.set(
                phrase.start - 0.1, 0.1, point_aside(who, float(rng.choice((-28, -18, 18, 28))), rng.uniform(0.8, 1.1))
            )
            who.blinks.append(phrase.start - 0.05)
            look_at_subject(stage, who, phrase.start + 0.45, cue)


def _room(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Return the share of a full gesture that fits before the listener."""
    if cue.target is None:
        return 1.0
    gap = (stage.floor_position(cue.target) - who.position).length
    return clamp((gap - 0.35) / (1.25 * who.measures.arm), 0.55, 1.0)


@clip("laugh", "head")
def laugh(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Laugh: head back, then doubled up over a hand on the belly, shoulders shaking. Return the end in seconds."""
    t, end = cue.start, cue.start + (cue.duration or 2.0)
    look_at_target(stage, who, t, cue)
    side = next((each for each in (cue.side, other(cue.side)) if who.is_free(each) and who.free[each] <= t), None)
    doubled = t + max(0.7, 0.45 * (end - t))
    if side is not None and end - t > LONG_LAUGH and who.posture in ("stand", "sit"):
        belly = by_chest(
            who, side, (-0.24, 0.30, -0.52), (-0.95, 0.1, 0.1), (0.1, -1, 0.1), pole=(0.9, 0.1, -0.4), curl=(14, 20, 0)
        )
        who.hands[side].set(t + 0.2, 0.5, belly)
        who.hands[side].set(end - 0.3, 0.6, who.home[side])
    show_mood(who, t, "laugh")
    who.nod.set(t, 0.3, (-16, 4, 0))
    who.nod.set(doubled, 0.35, (8, -3, 0))
    who.accent.set(t, 0.3, (-7, 0, 0))
    beats = np.arange(t + 0.3, end - 0.3, 0.24)
    for now in beats.tolist():
        bend = -7 if now < doubled else 15
        who.accent.set(now, 0.11, (bend + 4, 0, 0))
        who.accent.set(now + 0.12, 0.12 if now < doubled else 0.2, (bend, 0, 0))
    show_mood(who, end - 0.3, "smile", 0.4)
    who.nod.set(end - 0.3, 0.4, (0, 0, 0))
    who.accent.set(end - 0.2, 0.45, (0, 0, 0))
    return end


@clip("cry", "head", "hands")
def cry(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Cry into the free hands, trunk bent and trembling. Return the end in seconds."""
    t, end = cue.start, cue.start + (cue.duration or 3.0)
    show_mood(who, t, "cry", 0.4)
    who.look_freely(t)
    who.nod.set(t + 0.1, 0.7, (22, 0, 0))
    who.accent.set(t, 0.7, (14, 0, 0))
    who.lean_after.set(t, 0, 0.0)
    free = [side for side in SIDES if side not in who.held]
    for side in free:
        face = by_head(
            who,
            side,
            (-0.012, 0.115, -0.045),
            (-0.35, 0.15, 0.9),
            (-0.15, -1, 0),
            pole=(0.45, 0.3, -1),
            curl=(10, 14, 0),
        )
        who.hands[side].set(t + 0.1, 0.8, face)
    tremble = t + 0.9
    while tremble < end - 0.8:
        who.accent.set(tremble, 0.13, (17, 0, 0))
        who.accent.set(tremble + 0.15, 0.18, (13, 0, 0))
        tremble += 0.37
    for side in free:
        who.hands[side].set(end - 0.6, 0.7, who.home[side])
    who.nod.set(end - 0.5, 0.6, (6, 0, 0))
    who.accent.set(end - 0.5, 0.6, (4, 0, 0))
    show_mood(who, end - 0.3, "sad", 0.6)
    who.lean_after.set(end, 0, 1.0)
    return end
