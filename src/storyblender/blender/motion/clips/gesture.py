"""Signs made with arms and trunk: pointing, waving, shrugging, saluting, clapping, praying, bowing."""

from __future__ import annotations

from mathutils import Vector

from storyblender.blender.motion.channel import Floats
from storyblender.blender.motion.clips.gaze import look_at, look_at_subject, look_at_target, show_expression, show_mood
from storyblender.blender.motion.clips.handling import prop_of, release_prop
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_chest, by_head, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, UP, other, sign
from storyblender.blender.motion.staged_props import StagedProp

RING = 0.06
"""Metres; smaller props are put on a finger."""


@clip("point", "hand", "head")
def point(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Point at the target with the forefinger. Return the end in seconds."""
    t, side = cue.start, cue.side
    stay = max(0.8, (cue.duration or 2.0) - 1.2)
    goal = stage.look_point(cue.target) if cue.target is not None else who.ahead
    look_at_subject(stage, who, t, cue)

    def target(now: float) -> Floats:
        shoulder = who.point(f"upper_arm.{side}")
        along = (Vector(goal(now)) - shoulder).normalized()
        palm = shoulder + along * (1.12 * who.measures.arm)
        inward = who.facing @ Vector((-sign(side), 0, -0.5))
        return hand(palm, along, inward, who.facing @ Vector((sign(side) * 0.5, 0.2, -0.9)), (2, 84, 28))

    who.lean_after.set(t, 0, 0.0)
    who.hands[side].set(t, 0.5, target, bump=UP * 0.05)
    who.accent.set(t, 0.5, (2, 0, 8 * sign(side)))
    who.hands[side].set(t + 0.5 + stay, 0.7, who.home[side])
    who.accent.set(t + 0.5 + stay, 0.6, (0, 0, 0))
    who.lean_after.set(t + 1.3 + stay, 0, 1.0)
    return t + 1.2 + stay


@clip("wave", "hand", "head")
def wave(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Wave beside the head. Return the end in seconds."""
    t, side = cue.start, cue.side
    look_at_subject(stage, who, t, cue)
    show_mood(who, t, "happy" if cue.mood == "neutral" else cue.mood)
    raised = [
        by_chest(
            who, side, (0.45 + out, 0.30, 0.50), (lean, 0.15, 1), (-0.1, 1, 0), pole=(0.8, -0.1, -0.8), curl=(3, 4, 0)
        )
        for out, lean in ((-0.10, -0.35), (0.14, 0.45))
    ]
    who.hands[side].set(t, 0.45, raised[1])
    t += 0.45
    for _ in range(3):
        who.hands[side].set(t, 0.2, raised[0])
        who.hands[side].set(t + 0.2, 0.2, raised[1])
        t += 0.4
    who.hands[side].set(t, 0.6, who.home[side])
    return t + 0.6


@clip("shrug", "hands", "head")
def shrug(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Raise shoulders and palms. Return the end in seconds."""
    t = cue.start
    look_at_target(stage, who, t, cue)
    for side in SIDES:
        if side not in who.held:
            shown = by_chest(
                who,
                side,
                (0.42, 0.42, -0.40),
                (0.65, 0.75, 0.1),
                (-0.1, 0.1, 1),
                pole=(0.7, -0.4, -0.7),
                curl=(8, 12, 0),
            )
            who.hands[side].set(t, 0.4, shown)
            who.hands[side].set(t + 0.95, 0.6, who.home[side])
    who.nod.set(t, 0.35, (-4, 10, 0))
    show_expression(who, t, 0.3, brow_up=0.9)
    who.nod.set(t + 0.95, 0.5, (0, 0, 0))
    show_mood(who, t + 1.0, "neutral")
    return t + 1.55


@clip("salute", "hand", "head")
def salute(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Stand straight, a hand to the temple. Return the end in seconds."""
    t, side = cue.start, cue.side
    look_at_subject(stage, who, t, cue)
    temple = by_head(
        who,
        side,
        (0.085, 0.055, 0.035),
        (-0.75, 0.25, 0.55),
        (-0.35, 0.45, -0.8),
        pole=(1, 0.15, -0.25),
        curl=(2, 3, 0),
    )
    who.hands[side].set(t, 0.4, temple)
    who.accent.set(t, 0.4, (-3, 0, 0))
    stay = max(0.9, (cue.duration or 1.9) - 1.0)
    who.hands[side].set(t + 0.4 + stay, 0.5, who.home[side])
    who.accent.set(t + 0.4 + stay, 0.5, (0, 0, 0))
    return t + 0.9 + stay


@clip("clap", "hands", "head")
def clap(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Applaud. Return the end in seconds."""
    t, end = cue.start, cue.start + (cue.duration or 2.2)
    look_at_subject(stage, who, t, cue)
    show_mood(who, t, "happy")
    for side in SIDES:
        far = by_chest(who, side, (-0.16, 0.62, -0.30), (-0.3, 0.85, 0.5), (-1, 0.1, 0), curl=(4, 6, 0))
        near = by_chest(who, side, (-0.315, 0.64, -0.28), (-0.3, 0.85, 0.5), (-1, 0.1, 0), curl=(4, 6, 0))
        who.hands[side].set(t, 0.4, far)
        now = t + 0.4
        while now < end - 0.5:
            who.hands[side].set(now, 0.11, near)
            who.hands[side].set(now + 0.12, 0.13, far)
            now += 0.26
        who.hands[side].set(end - 0.2, 0.6, who.home[side])
    return end + 0.3


@clip("pray", "hands", "head")
def pray(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Pray: palms together before the chest, head bowed. Return the end in seconds."""
    t, end = cue.start, cue.start + (cue.duration or 3.0)
    for side in SIDES:
        folded = by_chest(who, side, (-0.335, 0.50, -0.15), (-0.05, 0.55, 0.85), (-1, 0, 0), curl=(2, 3, 0))
        who.hands[side].set(t, 0.7, folded)
        who.hands[side].set(end - 0.5, 0.7, who.home[side])
    who.look_freely(t)
    who.nod.set(t + 0.1, 0.7, (24, 0, 0))
    show_expression(who, t, 0.4, blink=1, brow_up=0.2)
    who.nod.set(end - 0.5, 0.6, (0, 0, 0))
    show_mood(who, end - 0.4, "neutral")
    return end


@clip("bow", "body", "head")
def bow(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Bow from the hips. Return the end in seconds."""
    t, k = cue.start, who.scale
    who.look_freely(t)
    who.hips.set(t, 0.7, (0, 0.07 * k, who.standing_height - 0.01 * k, 22, 0, 0))
    who.spine.set(t, 0.7, (26, 0, 0))
    who.nod.set(t, 0.6, (10, 0, 0))
    who.hips.set(t + 1.1, 0.8, (0, 0, who.standing_height, 0, 0, 0))
    who.spine.set(t + 1.1, 0.8, (0, 0, 0))
    who.nod.set(t + 1.1, 0.7, (0, 0, 0))
    return t + 1.9


@clip("dress", "hands")
def dress(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Pull a garment over the shoulders or off them; put a ring on a finger. Return the end in seconds."""
    t, prop = cue.start, prop_of(cue)
    if prop is not None and prop.holder is who and max(prop.size) < RING:
        return _put_on_finger(stage, who, cue, prop)
    for side in SIDES:
        low = by_chest(who, side, (0.05, 0.28, -0.55), (-0.6, 0.6, 0.2), (-0.5, -1, 0), curl=(60, 66, 20))
        high = by_chest(who, side, (0.02, 0.22, 0.05), (-0.3, -0.2, 0.9), (-0.2, -1, -0.3), curl=(60, 66, 20))
        who.hands[side].set(t, 0.6, low)
        who.hands[side].set(t + 0.6, 0.6, high)
        who.hands[side].set(t + 1.25, 0.5, low)
        who.hands[side].set(t + 1.8, 0.6, who.home[side])
    who.nod.set(t, 0.5, (14, 0, 0))
    who.nod.set(t + 1.6, 0.5, (0, 0, 0))
    return t + 2.4


def _put_on_finger(stage: MotionStage, who: Performer, cue: StagedCue, ring: StagedProp) -> float:
    """Push a ring on a finger of the other hand, before the chest; return the end in seconds."""
    t, side = cue.start, who.hand_holding(ring.asset_id) or cue.side
    far = other(side)
    offered = by_chest(who, far, (-0.16, 0.50, -0.40), (-0.9, 0.35, 0.15), (0, -0.5, -0.8), curl=(4, 8, 0))
    who.hands[far].set(t, 0.6, offered)
    for start, inward in ((0.1, -0.06), (0.8, -0.24)):
        pushing = by_chest(who, side, (inward, 0.52, -0.40), (-0.95, 0.2, 0.05), (-0.1, -0.6, -0.8), curl=(48, 56, 24))
        who.hands[side].set(t + start, 0.6, pushing)
    ring.hold(t + 1.4, who, far, ring.grip(far), 0.2)
    release_prop(stage, ring)
    look_at(who, t, stage.look_point(ring))
    for each in SIDES:
        who.hands[each].set(t + 1.8, 0.6, who.home[each])
    look_at(who, t + 1.9, who.ahead)
    return t + 2.4


@clip("kick", "body")
def kick(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Kick with one foot at what is in front. Return the end in seconds."""
    t, k, foot = cue.start, who.scale, cue.side
    behind = who.plant(foot, (who.position - who.forward * 0.28 * k), who.yaw)
    behind[2], behind[4] = behind[2] + 0.14 * k, -50
    struck = who.plant(foot, (who.position + who.forward * 0.52 * k), who.yaw)
    struck[2], struck[4] = struck[2] + 0.30 * k, -12
    who.feet[foot].set(t, 0.35, behind)
    who.feet[foot].set(t + 0.35, 0.16, struck)
    who.feet[foot].set(t + 0.6, 0.4, who.plant(foot, who.position, who.yaw))
    who.hips.set(t, 0.3, (-0.06 * k * sign(foot), 0.02, who.standing_height - 0.04 * k, -6, 0, 0))
    who.hips.set(t + 0.6, 0.5, (0, 0, who.standing_height, 0, 0, 0))
    return t + 1.1
