"""Talking and the sounds of feeling: gesture beats, mouth, face."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from storyblender.blender.motion.channel import clamp, ease_out
from storyblender.blender.motion.clips.gaze import look_at_subject, mood
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_chest, by_head
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, other
from storyblender.blender.motion.stage import Beat, Stage


@dataclass(frozen=True)
class Manner:
    """How somebody talks.

    Attributes:
        size: Of the gestures.
        period: Seconds from one to the next, before chance.
        lean: Degrees of bent trunk.
        chops: Raises a finger and strikes with it; otherwise shows open palms.
        mouth: How wide it opens.
        rate: Syllables per second.
    """

    size: float
    period: float
    lean: float
    chops: bool = False
    mouth: float = 0.75
    rate: float = 2.3


MANNERS: dict[str, Manner] = {
    "neutral": Manner(0.55, 0.72, 0),
    "happy": Manner(0.9, 0.55, -2),
    "sad": Manner(0.3, 0.9, 8, mouth=0.55, rate=2.0),
    "angry": Manner(1.0, 0.42, 9, True, 1.0, 3.1),
    "afraid": Manner(0.4, 0.5, -4, mouth=0.6, rate=3.0),
    "tender": Manner(0.3, 1.0, 4, mouth=0.55, rate=2.0),
}


@clip("talk")
def talk(stage: Stage, who: Performer, beat: Beat) -> float:
    """Speak to the target for the beat's duration, with gestures of the free hands."""
    return _speak(stage, who, beat, MANNERS[beat.mood])


@clip("whisper")
def whisper(stage: Stage, who: Performer, beat: Beat) -> float:
    """Speak low, leaning in, hands quiet."""
    return _speak(stage, who, beat, Manner(0.0, 1.2, 10, mouth=0.35, rate=2.6))


@clip("shout")
def shout(stage: Stage, who: Performer, beat: Beat) -> float:
    """Speak with all one has."""
    return _speak(stage, who, beat, Manner(1.0, 0.5, 6, True, 1.0, 2.2))


def _speak(stage: Stage, who: Performer, beat: Beat, manner: Manner) -> float:
    t, end = beat.start, beat.start + (beat.duration or 2.5)
    rng = np.random.default_rng(beat.seed)
    if beat.target is not None:
        look_at_subject(stage, who, t, beat)
    mood(who, t, beat.mood)
    who.speeches.append((t, end, manner.mouth, manner.rate))
    who.accent.set(t, 0.4, (manner.lean, 0, 0))
    who.nod.set(t, 0.3, (-3, 0, 0))
    hands = [side for side in SIDES if side not in who.held and who.free[side] <= t + 0.2]
    lead = next((side for side in (beat.side, other(beat.side)) if side in hands), None)
    gesturing = lead is not None and manner.size > 0 and end - t > 1.2 and who.posture not in ("lie", "asleep")
    if gesturing:
        who.lean_after.set(t, 0, 0.0)
    room = _room(stage, who, beat)
    stroke = t + 0.15
    while stroke < end - 0.5:
        swing = rng.uniform(-6, 6) * manner.size
        if gesturing and lead is not None:
            active = lead if len(hands) < 2 or rng.random() < 0.75 else other(lead)
            for side in hands:
                _gesture(who, side, stroke, manner, side == active, side == lead, room, rng)
        depth = rng.uniform(3, 7) * manner.size + 2
        who.nod.set(stroke + 0.4 * manner.period, 0.14, (depth, rng.uniform(-4, 4) * manner.size, 0.8 * swing))
        who.nod.set(stroke + 0.75 * manner.period, 0.25, (0, rng.uniform(-2, 2), 0))
        push = 5 if manner.chops else 0
        who.accent.set(stroke + 0.4 * manner.period, 0.25, (manner.lean + push, 0, swing))
        if push:
            who.accent.set(stroke + 0.9 * manner.period, 0.25, (manner.lean, 0, 0.6 * swing))
        stroke += manner.period * rng.uniform(1.05, 1.7)
    if gesturing:
        for side in hands:
            who.hands[side].set(end - 0.3, 0.5, who.home[side])
        who.lean_after.set(end + 0.3, 0, 1.0)
    who.accent.set(end - 0.2, 0.5, (0, 0, 0))
    who.nod.set(end - 0.2, 0.3, (0, 0, 0))
    if beat.mood != "neutral":
        mood(who, end, "neutral", 0.8)
    return end


def _room(stage: Stage, who: Performer, beat: Beat) -> float:
    """Return the share of a full gesture there is room for before the listener."""
    if beat.target is None:
        return 1.0
    gap = (stage.ground_of(beat.target) - who.position).length
    return clamp((gap - 0.35) / (1.25 * who.m.arm), 0.55, 1.0)


def _gesture(
    who: Performer,
    side: str,
    t: float,
    manner: Manner,
    active: bool,
    lead: bool,
    room: float,
    rng: np.random.Generator,
) -> None:
    """One gesture: a preparation of half a period, then a fast stroke."""
    period = manner.period
    raised = rng.uniform(0, 0.20) * manner.size * (1.0 if active else 0.45)
    out = rng.uniform(-0.08, 0.16) * manner.size
    if manner.chops and not lead:  # fist on the hip
        fist = by_chest(
            who, side, (0.16, 0.10, -0.80), (-0.35, 0.75, -0.55), (-1, -0.1, -0.2), pole=(1, -0.35, -0.2),
            curl=(60, 70, 20),
        )  # fmt: skip
        who.hands[side].set(t, 0.6 * period, fist)
        return
    if manner.chops:
        finger = (2, 80, 25)
        ready = by_chest(
            who,
            side,
            (-0.02 + 0.5 * out, 0.62 * room, 0.22 + raised),
            (-0.1, 0.75, 0.75),
            (-0.75, 0.3, -0.5),
            curl=finger,
        )
        struck = by_chest(who, side, (-0.10 + 0.5 * out, room, -0.12), (-0.12, 1, -0.05), (-0.7, 0, -0.7), curl=finger)
        who.hands[side].set(t, 0.45 * period, ready)
        who.hands[side].set(t + 0.5 * period, 0.13, struck, ease=ease_out)
        return
    ready = by_chest(
        who,
        side,
        (-0.02 + out, 0.50, -0.42 + raised),
        (-0.3, 0.9, 0.25 + raised),
        (-0.55, -0.1, 0.85),
        curl=(10, 18, 0),
    )
    shown = by_chest(
        who, side, (0.06 + out, 0.56, -0.50 + 0.5 * raised), (-0.15, 1, 0), (-0.45, -0.1, 0.9), curl=(14, 22, 0)
    )
    who.hands[side].set(t, 0.5 * period, ready)
    who.hands[side].set(t + 0.55 * period, 0.16, shown, ease=ease_out)


@clip("laugh", "head")
def laugh(stage: Stage, who: Performer, beat: Beat) -> float:
    """Laugh: head back, shoulders shaking."""
    t, end = beat.start, beat.start + (beat.duration or 2.0)
    if beat.target is not None:
        look_at_subject(stage, who, t, beat)
    who.face.set(t, 0.25, (0.75, 1, 0.35, 0.2, 0))
    who.nod.set(t, 0.3, (-14, 3, 0))
    who.accent.set(t, 0.3, (-6, 0, 0))
    while t < end - 0.5:
        who.accent.set(t + 0.3, 0.11, (-1, 0, 0))
        who.accent.set(t + 0.42, 0.11, (-6, 0, 0))
        t += 0.24
    who.face.set(end - 0.3, 0.4, (0, 0.5, 0, 0, 0))
    who.nod.set(end - 0.3, 0.4, (0, 0, 0))
    who.accent.set(end - 0.2, 0.4, (0, 0, 0))
    return end


@clip("cry", "head", "hands")
def cry(stage: Stage, who: Performer, beat: Beat) -> float:
    """Weep into the free hands, trunk bent and trembling."""
    t, end = beat.start, beat.start + (beat.duration or 3.0)
    who.face.set(t, 0.4, (0.2, 0, 0.75, 0.8, 0.3))
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
    who.face.set(end - 0.3, 0.6, (0, 0, 0.2, 0.6, 0.2))
    who.lean_after.set(end, 0, 1.0)
    return end
