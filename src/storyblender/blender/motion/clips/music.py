"""Playing instruments, and typing: hands on keys or strings."""

from __future__ import annotations

import math

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats
from storyblender.blender.motion.clips.gaze import look_at
from storyblender.blender.motion.clips.handling import take_in_hand
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.clips.using import table_height
from storyblender.blender.motion.hands import chest_yaw, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageFurniture
from storyblender.blender.motion.skeleton import SIDES, sign
from storyblender.blender.motion.staged_props import StagedProp, carrying_hand

STRINGED = 0.45
"""Metres; a taller carried prop counts as a stringed instrument when it is played."""
NECK_RAISED = math.radians(18)
"""Radians by which the neck points upwards."""
STRUMS = 2.2
"""Strokes a second."""


def strum(stage: MotionStage, who: Performer, cue: StagedCue, prop: StagedProp) -> float:
    """Play a string instrument whose own frame is upright, strings to the front; return the end in seconds.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives start and duration.
        prop: The instrument; taken in hand if they do not hold it.
    """
    t, end, k = cue.start, cue.start + (cue.duration or 3.0), who.scale
    tall, deep = prop.size.z, prop.size.y
    if prop.holder is not who:
        take_in_hand(stage, who, "R", prop, t)

    def body() -> Matrix:
        """Return the instrument's matrix: strings away from the chest, the neck to the left and a little up."""
        turn = who.facing @ Matrix.Rotation(chest_yaw(who), 3, "Z")
        neck = Vector((math.cos(NECK_RAISED), 0, math.sin(NECK_RAISED)))
        back = Vector((0, 1, 0))
        matrix = (turn @ Matrix((back.cross(neck), back, neck)).transposed()).to_4x4()
        belly = who.point("hips") + turn @ Vector((-0.10 * k, -(who.measures.front + deep / 2), 0.16 * k))
        matrix.translation = belly - matrix.to_3x3() @ Vector((0, 0, 0.25 * tall))
        return matrix

    def fretting(now: float) -> Floats:
        matrix = body()
        turn = matrix.to_3x3()
        slide = 0.03 * math.sin(1.3 * (now - t))
        place = matrix @ Vector((0.015, 0.02, (0.64 + slide) * tall))
        elbow = who.facing @ Vector((0.6, 0.3, -0.8))
        return hand(place, turn @ Vector((-0.8, -0.5, -0.1)), turn @ Vector((-0.3, -1, 0)), elbow, (68, 70, 25))

    def stroking(now: float) -> Floats:
        matrix = body()
        turn = matrix.to_3x3()
        stroke = 0.035 * k * math.sin(2 * math.pi * STRUMS * (now - t))
        place = matrix @ Vector((stroke, -deep / 2 - 0.02, 0.3 * tall))
        elbow = who.facing @ Vector((-0.9, 0.2, -0.3))
        return hand(place, turn @ Vector((0.45, -0.1, 0.9)), turn @ Vector((0, 1, 0)), elbow, (25, 30, 15))

    who.lean_after.set(t, 0, 0.0)
    who.hands["L"].set(t, 0.6, fretting)
    who.hands["R"].set(t, 0.6, stroking)
    prop.follow(t, lambda _: body(), 0.6)
    look_at(who, t, lambda now: tuple(body() @ Vector((0, 0, 0.6 * tall))))
    if end < stage.seconds - 0.3:
        prop.hold(end, who, "R", prop.grip("R"), 0.6)
        for side in SIDES:
            who.hands[side].set(end, 0.6, carrying_hand(who, side, prop) if side == "R" else who.home[side])
        who.lean_after.set(end + 0.6, 0, 1.0)
        look_at(who, end, who.ahead)
    return end


def _over_keys(stage: MotionStage, who: Performer, cue: StagedCue, rate: float, spread: float, lift: float) -> float:
    """Play a keyboard at ``rate`` strokes a second, hands wandering ``spread`` and rising ``lift`` metres.

    The target is the instrument; None for the table before the player. Return the end in seconds.
    """
    k, t = who.scale, cue.start
    end = t + (cue.duration or 3.0)
    height = table_height(stage, who) + 0.05 * k
    if isinstance(cue.target, StageFurniture):
        height = _key_height(stage, cue.target, height)
    ahead = 0.36 * k

    def target(now: float, side: str) -> Floats:
        s, u = sign(side), now - t
        wander = spread * k * math.sin(0.9 * u + (0.0 if side == "L" else 1.7))
        strike = lift * max(0.0, math.sin(2 * math.pi * rate * u + (0 if side == "L" else 2.1)))
        spot = who.point("hips") + who.facing @ Vector((s * 0.15 * k + wander, -ahead, 0))
        spot.z = height + strike
        tap = 22 + 14 * math.sin(2 * math.pi * rate * u + (0 if side == "L" else 2.1))
        toward = who.facing @ Vector((-s * 0.12, -1, -0.1))
        elbow = who.facing @ Vector((s * 0.7, 0.5, -0.7))
        return hand(spot, toward, Vector((0, 0, -1)), elbow, (tap, 46 - tap, 5))

    who.lean_after.set(t, 0, 0.0)
    for side in SIDES:
        if side not in who.held:
            who.hands[side].set(t, 0.6, lambda now, side=side: target(now, side))
            if end < stage.seconds - 0.3:
                who.hands[side].set(end, 0.6, who.home[side])
    look_at(who, t, lambda now: tuple(target(now, "L")[:3] * 0.5 + target(now, "R")[:3] * 0.5))
    if end < stage.seconds - 0.3:
        who.lean_after.set(end + 0.6, 0, 1.0)
        look_at(who, end, who.ahead)
    return end


def _key_height(stage: MotionStage, instrument: StageFurniture, default: float) -> float:
    """Return the height of an instrument's keys in metres, ``default`` if it has no handle anchor."""
    handle = stage.find_anchor(instrument, ("handle",), None)
    if handle is None:
        return default
    return (Matrix(instrument.world.tolist()) @ Vector(handle.location)).z + 0.03


@clip("type", "hands", "head")
def type_(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Type on the table in front. Return the end in seconds."""
    return _over_keys(stage, who, cue, 4.0, 0.012, 0.006)


@clip("play_guitar", "hands", "head")
def play_guitar(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Strum the instrument in hand, at hand or on the back; without one, the air. Return the end in seconds."""
    return play_piano(stage, who, cue)


@clip("play_piano", "hands", "head")
def play_piano(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Play a keyboard, or the strings of a carried instrument, the trunk swaying. Return the end in seconds."""
    carried_one = cue.prop or stage.props.get(who.held.get(cue.side, ""))
    t, end = cue.start, cue.start + (cue.duration or 3.0)
    sway = 1
    while t < end - 1.0:
        who.accent.set(t, 1.0, (5 if sway > 0 else 1, 4 * sway, 5 * sway))
        t, sway = t + 1.05, -sway
    who.accent.set(end - 0.4, 0.6, (0, 0, 0))
    if carried_one is not None and carried_one.size.z > STRINGED:
        return strum(stage, who, cue, carried_one)
    return _over_keys(stage, who, cue, 2.2, 0.10, 0.03)
