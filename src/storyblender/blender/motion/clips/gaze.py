"""Looking, listening, nodding: what head and eyes do."""

from __future__ import annotations

import math

from mathutils import Vector

from storyblender.blender.motion.channel import Target
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_head
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.stage import Beat, PointOf, Stage
from storyblender.catalog.expressions import EXPRESSIONS, OF_MOOD, values_of


def look_at(who: Performer, t: float, point: Target, duration: float = 0.4) -> float:
    """Look at a point from ``t`` on: eyes lead the head, and a blink hides the jump."""
    who.eyes.set(t, 0.08, point)
    who.gaze.set(t + 0.06, duration, point)
    who.blinks.append(t + 0.05)
    return t + duration


def show(who: Performer, t: float, duration: float, **units: float) -> None:
    """Set a facial expression from units of ``FACE``; no units restore the person's expression in this shot."""
    who.face.set(t, duration, values_of(units or EXPRESSIONS[who.expression]))


def mood(who: Performer, t: float, name: str, duration: float = 0.3) -> None:
    """Show a mood or an expression; ``neutral`` restores the person's expression in this shot."""
    expression = next((face for each, face in OF_MOOD.items() if each == name), name)
    show(who, t, duration, **EXPRESSIONS[expression])


def look_at_subject(stage: Stage, who: Performer, t: float, beat: Beat) -> float:
    """Look at the beat's target, or at its prop, or ahead."""
    subject = beat.target or beat.prop
    if subject is None:
        return look_at(who, t, who.ahead)
    return look_at(who, t, stage.point_of(subject))


@clip("idle")
def idle(stage: Stage, who: Performer, beat: Beat) -> float:
    """Stay as one is, alive."""
    if beat.target is not None:
        look_at_subject(stage, who, beat.start, beat)
    return beat.start + (beat.duration or 1.0)


@clip("face")
def face(stage: Stage, who: Performer, beat: Beat) -> float:
    """Set the base expression for the rest of the shot; the face returns to it after other expressions."""
    who.expression = beat.expression
    mood(who, beat.start, "neutral")
    return beat.start + 0.3


@clip("look")
def look(stage: Stage, who: Performer, beat: Beat) -> float:
    """Look at the target, or at the point of the mark; the trunk turns along for targets far to the side."""
    mood(who, beat.start, beat.mood)
    if beat.target is None and beat.mark is not None:
        return look_at(who, beat.start, beat.mark.location)
    return look_at_subject(stage, who, beat.start, beat)


@clip("listen")
def listen(stage: Stage, who: Performer, beat: Beat) -> float:
    """Look at whom one listens to, head a little aside, with a small nod now and then."""
    end = beat.start + (beat.duration or 2.0)
    look_at_subject(stage, who, beat.start, beat)
    tilt = -4.0 if beat.seed % 2 else 4.0
    who.nod.set(beat.start + 0.2, 0.6, (2, tilt, 0))
    t = beat.start + 0.9 + 0.3 * (beat.seed % 3)
    while t < end - 0.6:
        who.nod.set(t, 0.18, (7, tilt, 0))
        who.nod.set(t + 0.2, 0.3, (2, tilt, 0))
        t += 1.7 + 0.35 * (beat.seed % 4)
    who.nod.set(end - 0.3, 0.4, (0, 0, 0))
    return end


@clip("look_around", "head")
def look_around(stage: Stage, who: Performer, beat: Beat) -> float:
    """Scan the room: left, right, and where it all comes together."""
    t = beat.start
    for degrees, hold in ((55, 0.75), (-55, 0.85), (20, 0.5)):
        look_at(who, t, aside(who, degrees))
        who.accent.set(t + 0.1, 0.5, (0, 0, 0.2 * degrees))
        t += hold
    look_at(who, t, who.ahead)
    who.accent.set(t, 0.5, (0, 0, 0))
    return t + 0.4


@clip("peek", "head")
def peek(stage: Stage, who: Performer, beat: Beat) -> float:
    """Bend aside to see around something."""
    t, side = beat.start, 1 if beat.seed % 2 else -1
    look_at_subject(stage, who, t, beat)
    who.accent.set(t, 0.6, (12, 16 * side, 0))
    who.accent.set(t + 1.6, 0.5, (0, 0, 0))
    return t + 2.1


@clip("nod", "head")
def nod(stage: Stage, who: Performer, beat: Beat) -> float:
    """Nod twice."""
    t = beat.start
    if beat.target is not None:
        look_at_subject(stage, who, t, beat)
    for size in (16, 11):
        who.nod.set(t, 0.17, (size, 0, 0))
        who.nod.set(t + 0.18, 0.2, (-3, 0, 0))
        t += 0.4
    who.nod.set(t, 0.25, (0, 0, 0))
    return t + 0.25


@clip("shake_head", "head")
def shake_head(stage: Stage, who: Performer, beat: Beat) -> float:
    """Shake the head: no."""
    t = beat.start
    if beat.target is not None:
        look_at_subject(stage, who, t, beat)
    for yaw in (20, -20, 16, -12):
        who.nod.set(t, 0.2, (2, 0, yaw))
        t += 0.19
    who.nod.set(t, 0.28, (0, 0, 0))
    return t + 0.28


@clip("think", "head", "hand")
def think(stage: Stage, who: Performer, beat: Beat) -> float:
    """Look up and aside, a hand at the chin."""
    t, end = beat.start, beat.start + (beat.duration or 2.4)
    look_at(who, t, aside(who, 25, 1.3))
    who.nod.set(t, 0.5, (3, 6, 0))
    if who.is_free(beat.side):
        chin = by_head(
            who, beat.side, (-0.055, 0.085, -0.125), (-0.45, -0.35, 0.85), (0.1, -1, -0.1), pole=(0.35, 0.35, -1),
            curl=(35, 75, 0),
        )  # fmt: skip
        who.hands[beat.side].set(t, 0.8, chin)
        who.hands[beat.side].set(end - 0.5, 0.6, who.home[beat.side])
    who.nod.set(end - 0.4, 0.4, (0, 0, 0))
    return end


def aside(who: Performer, degrees: float, height: float = 0.95) -> PointOf:
    """Return a point far away, turned from straight ahead."""

    def point(t: float) -> Vector:
        x, y, yaw = who.root(t)
        turned = yaw + math.radians(degrees)
        level = float(who.level(t))
        return Vector((x + 5 * math.sin(turned), y - 5 * math.cos(turned), level + who.m.eye_height * height))

    return point
