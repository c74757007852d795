"""Carried string instruments: held across the body, one hand on the neck, one at the strings."""

from __future__ import annotations

import math

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats
from storyblender.blender.motion.clips.gaze import look_at
from storyblender.blender.motion.clips.handling import take_in_hand
from storyblender.blender.motion.hands import chest_yaw, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES
from storyblender.blender.motion.staged_props import StagedProp, carrying_hand

NECK_RAISED = math.radians(18)
"""Radians by which the neck points upwards."""
STRUMS = 2.2
"""Strokes a second."""


def strum(stage: MotionStage, who: Performer, cue: StagedCue, prop: StagedProp) -> float:
    """Play a string instrument whose own frame is upright, strings to the front; return the end in seconds."""
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
