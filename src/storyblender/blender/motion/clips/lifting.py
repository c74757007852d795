"""Lifting a small person into the air, and putting them down."""

from __future__ import annotations

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import Floats, TargetOf, clamp
from storyblender.blender.motion.clips.gaze import look_at, show_mood
from storyblender.blender.motion.clips.pairs import meet, partner_of, reserve_hands
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, sign

APART = 0.40
"""Metres, times the scale, between the two people."""
RAISED = 0.7
"""Seconds of the way up, and again of the way down."""


@clip("lift", "body", "hands", "head")
def lift(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Lift the target by the arms to eye level, and put them down. Return the end in seconds."""
    partner = partner_of(cue)
    if partner is None or partner.posture != "stand":
        return cue.start
    k = who.scale
    t = meet(stage, who, partner, cue, APART * k, 0.05)
    up = t + 0.6
    down = up + RAISED + clamp((cue.duration or 3.0) - 2.2, 0.8, 4.0)
    end = down + RAISED + 0.5
    height = max(0.12 * k, who.measures.eye_height - partner.measures.eye_height)
    reserve_hands(partner, ("L", "R"), t, end)
    partner.free["body"] = max(partner.free["body"], end)
    stand, low = who.standing_height, clamp(1.0 - partner.scale / k)
    who.hips.set(t, 0.55, (0, 0.10 * k * low, stand - 0.5 * k * low, 24 * low, 0, 0))
    who.spine.set(t, 0.55, (34 * low, 0, 0))
    who.hips.set(up, RAISED, (0, -0.02 * k, stand - 0.01 * k, -3, 0, 0))
    who.spine.set(up, RAISED, (-4, 0, 0))
    who.hips.set(down, RAISED, (0, 0.08 * k * low, stand - 0.4 * k * low, 20 * low, 0, 0))
    who.spine.set(down, RAISED, (28 * low, 0, 0))
    who.hips.set(down + RAISED, 0.6, (0, 0, stand, 0, 0, 0))
    who.spine.set(down + RAISED, 0.6, (0, 0, 0))
    _carry(partner, up, down, height)
    for side in SIDES:
        for one, target in ((who, _ribs(who, partner, side)), (partner, _shoulder(partner, who, side))):
            one.hands[side].set(t + 0.1, 0.45, target)
            one.hands[side].set(down + RAISED, 0.6, one.home[side])
            stage.following_hands.append((one, side, t + 0.1, down + RAISED + 0.3))
    for one, two in ((who, partner), (partner, who)):
        look_at(one, t, stage.look_point(two))
        show_mood(one, up, "happy")
    return end


def _carry(who: Performer, up: float, down: float, height: float) -> None:
    """Raise a person by ``height`` metres at ``up`` seconds and lower them at ``down``, the feet hanging."""
    stand = who.standing_height
    who.hips.set(up, RAISED, (0, 0, stand + height, 4, 0, 0))
    who.hips.set(down, RAISED, (0, 0, stand, 0, 0, 0))
    who.life.set(up, RAISED, 0.4)
    who.life.set(down, RAISED, 1.0)
    for side in SIDES:
        planted = np.array(who.feet[side](up), float)
        hanging = planted.copy()
        hanging[2] += height + 0.02 * who.scale
        hanging[4], hanging[5] = -32, 0
        who.feet[side].set(up, RAISED, hanging)
        who.feet[side].set(down, RAISED, planted)


def _ribs(who: Performer, other: Performer, side: str) -> TargetOf:
    """Return the target of a palm at the other's ribs, under the arm."""
    s, k = sign(side), other.scale

    def target(t: float) -> Floats:
        palm = other.point("upper_chest", (-s * 0.155 * k, 0.0, -0.03 * k))
        inward = other.direction("upper_chest", Vector((s, 0, 0)))
        return hand(palm, Vector((*who.forward, 0.25)), inward, who.facing @ Vector((s * 0.7, 0.2, -0.7)), (14, 18, 10))

    return target


def _shoulder(who: Performer, other: Performer, side: str) -> TargetOf:
    """Return the target of a palm on the other's upper arm."""
    s, k = sign(side), other.scale

    def target(t: float) -> Floats:
        far = "R" if side == "L" else "L"
        palm = other.point(f"upper_arm.{far}", (0.02 * s * k, -0.03 * k, 0.05 * k))
        return hand(
            palm,
            Vector((*who.forward, 0.1)),
            Vector((0, 0, -1)),
            who.facing @ Vector((s * 0.8, 0.2, -0.4)),
            (14, 18, 0),
        )

    return target
