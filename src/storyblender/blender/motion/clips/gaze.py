"""Looking, listening, nodding: clips of head and eyes."""

from __future__ import annotations

import math

from mathutils import Vector

from storyblender.blender.motion.channel import Target
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_head
from storyblender.blender.motion.motion_stage import MotionStage, PointOf, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.catalog.expressions import EXPRESSIONS, OF_MOOD, values_of


def look_at(who: Performer, t: float, point: Target, duration: float = 0.4) -> float:
    """Look at a point: eyes, a blink, then the head; return the end in seconds.

    Args:
        who: The person.
        t: Second at which the eyes move.
        point: World point in metres, or a function from seconds to it.
        duration: Seconds in which the head follows.
    """
    who.eyes.set(t, 0.08, point)
    who.gaze.set(t + 0.06, duration, point)
    who.blinks.append(t + 0.05)
    return t + duration


def show_expression(who: Performer, t: float, duration: float, **units: float) -> None:
    """Blend to amounts of ``FACE`` units; without any, to the person's base expression.

    Args:
        who: The person.
        t: Second at which the blend begins.
        duration: Seconds of the blend.
        **units: Amounts of ``FACE`` units, 0..1.
    """
    who.face.set(t, duration, values_of(units or EXPRESSIONS[who.expression]))


def show_mood(who: Performer, t: float, name: str, duration: float = 0.3) -> None:
    """Blend to the face of a mood or an expression.

    Args:
        who: The person.
        t: Second at which the blend begins.
        name: A mood or a key of ``EXPRESSIONS``; ``neutral`` is the person's base expression.
        duration: Seconds of the blend.
    """
    expression = next((face for each, face in OF_MOOD.items() if each == name), name)
    show_expression(who, t, duration, **EXPRESSIONS[expression])


def look_at_subject(stage: MotionStage, who: Performer, t: float, cue: StagedCue) -> float:
    """Look at the cue's target, else at its prop, else ahead; return the end in seconds.

    Args:
        stage: The stage of the shot.
        who: The person.
        t: Second at which the eyes move.
        cue: Gives target and prop.
    """
    subject = cue.target or cue.prop
    if subject is None:
        return look_at(who, t, who.ahead)
    return look_at(who, t, stage.look_point(subject))


def look_at_target(stage: MotionStage, who: Performer, t: float, cue: StagedCue) -> None:
    """Look at the cue's target, if it has one.

    Args:
        stage: The stage of the shot.
        who: The person.
        t: Second at which the eyes move.
        cue: Gives the target.
    """
    if cue.target is not None:
        look_at(who, t, stage.look_point(cue.target))


@clip("idle")
@clip("stand")
def idle(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Stand or sit still, with idle life. Return the end in seconds."""
    look_at_target(stage, who, cue.start, cue)
    return cue.start + (cue.duration or 1.0)


@clip("face")
def face(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Set the base expression for the rest of the shot; other expressions return to it. Return the end in seconds."""
    who.expression = cue.expression
    show_mood(who, cue.start, "neutral")
    return cue.start + 0.3


@clip("look")
def look(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Look at the target or the mark's point; the trunk turns along if it is far aside. Return the end in seconds."""
    show_mood(who, cue.start, cue.mood)
    if cue.target is None and cue.mark is not None:
        return look_at(who, cue.start, cue.mark.location)
    return look_at_subject(stage, who, cue.start, cue)


@clip("listen")
def listen(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Look at the speaker, head tilted, with small nods. Return the end in seconds."""
    end = cue.start + (cue.duration or 2.0)
    look_at_subject(stage, who, cue.start, cue)
    tilt = -4.0 if cue.seed % 2 else 4.0
    who.nod.set(cue.start + 0.2, 0.6, (2, tilt, 0))
    t = cue.start + 0.9 + 0.3 * (cue.seed % 3)
    while t < end - 0.6:
        who.nod.set(t, 0.18, (7, tilt, 0))
        who.nod.set(t + 0.2, 0.3, (2, tilt, 0))
        t += 1.7 + 0.35 * (cue.seed % 4)
    who.nod.set(end - 0.3, 0.4, (0, 0, 0))
    return end


@clip("look_around", "head")
def look_around(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Look left, right and ahead. Return the end in seconds."""
    t = cue.start
    for degrees, hold in ((55, 0.75), (-55, 0.85), (20, 0.5)):
        look_at(who, t, point_aside(who, degrees))
        who.accent.set(t + 0.1, 0.5, (0, 0, 0.2 * degrees))
        t += hold
    look_at(who, t, who.ahead)
    who.accent.set(t, 0.5, (0, 0, 0))
    return t + 0.4


@clip("peek", "head")
def peek(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Bend aside to see around something. Return the end in seconds."""
    t, side = cue.start, 1 if cue.seed % 2 else -1
    look_at_subject(stage, who, t, cue)
    who.accent.set(t, 0.6, (12, 16 * side, 0))
    who.accent.set(t + 1.6, 0.5, (0, 0, 0))
    return t + 2.1


@clip("nod", "head")
def nod(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Nod twice. Return the end in seconds."""
    t = cue.start
    look_at_target(stage, who, t, cue)
    for size in (16, 11):
        who.nod.set(t, 0.17, (size, 0, 0))
        who.nod.set(t + 0.18, 0.2, (-3, 0, 0))
        t += 0.4
    who.nod.set(t, 0.25, (0, 0, 0))
    return t + 0.25


@clip("shake_head", "head")
def shake_head(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Shake the head. Return the end in seconds."""
    t = cue.start
    look_at_target(stage, who, t, cue)
    for yaw in (20, -20, 16, -12):
        who.nod.set(t, 0.2, (2, 0, yaw))
        t += 0.19
    who.nod.set(t, 0.28, (0, 0, 0))
    return t + 0.28


@clip("think", "head", "hand")
def think(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Look up and aside, a hand at the chin. Return the end in seconds."""
    t, end = cue.start, cue.start + (cue.duration or 2.4)
    look_at(who, t, point_aside(who, 25, 1.3))
    who.nod.set(t, 0.5, (3, 6, 0))
    if who.is_free(cue.side):
        chin = by_head(
            who, cue.side, (-0.055, 0.085, -0.125), (-0.45, -0.35, 0.85), (0.1, -1, -0.1), pole=(0.35, 0.35, -1),
            curl=(35, 75, 0),
        )  # fmt: skip
        who.hands[cue.side].set(t, 0.8, chin)
        who.hands[cue.side].set(end - 0.5, 0.6, who.home[cue.side])
    who.nod.set(end - 0.4, 0.4, (0, 0, 0))
    return end


def point_aside(who: Performer, degrees: float, height: float = 0.95) -> PointOf:
    """Return a function from seconds to the world point 5 m away, aside of where the person faces.

    Args:
        who: The person.
        degrees: Turn to the left, from straight ahead.
        height: Share of the eyes' height above the ground.
    """

    def point(t: float) -> Vector:
        x, y, yaw = who.root(t)
        turned = yaw + math.radians(degrees)
        level = float(who.level(t))
        return Vector((x + 5 * math.sin(turned), y - 5 * math.cos(turned), level + who.measures.eye_height * height))

    return point
