"""Embraces: hugging and kissing."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import Floats, TargetOf, clamp
from storyblender.blender.motion.clips.gaze import look_at, show_expression, show_mood
from storyblender.blender.motion.clips.locomotion import shuffle_to
from storyblender.blender.motion.clips.pairs import meet, partner_of, reserve_hands
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_chest, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, sign

CLOSING = 0.9
"""Seconds in which arms open and close."""
HOLDING = 1.2
"""Seconds of an embrace without a duration."""
LIPS = Vector((0, -0.028, -0.065))
"""From the middle of the eyes to the lips in metres, times the scale."""
APART = 0.004
"""Metres between lips that touch."""
TILT = 18.0
"""Degrees both heads tilt to their right in a kiss, so that the noses pass."""
IN_THE_WAY = 0.25
"""Metres; a hand with a longer prop does not embrace."""
DEEPEST = 0.10
"""Metres, times the scale, by which the taller one's knees may bend for a kiss."""


@dataclass(frozen=True)
class Embrace:
    """The seconds of an embrace.

    Attributes:
        start: The arms open.
        closed: They are closed.
        apart: They let go.
        end: They hang again.
    """

    start: float
    closed: float
    apart: float
    end: float


@clip("hug", "body", "hands", "head")
def hug(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Embrace the target; step back to the mark afterwards, if there is one. Return the end in seconds."""
    partner = partner_of(cue)
    return cue.start if partner is None else embrace(stage, who, partner, cue).end


@clip("kiss", "body", "hands", "head")
def kiss(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Embrace and kiss: heads tilt, trunks and knees bring the lips together. Return the end in seconds."""
    partner = partner_of(cue)
    if partner is None:
        return cue.start
    held = embrace(stage, who, partner, cue)
    down = 60 * clamp(who.measures.eye_height - partner.measures.eye_height, -0.2, 0.2)
    for one, pitch in ((who, down), (partner, -down)):
        one.nod.remove_from(held.start)
        one.nod.set(held.start + 0.3, CLOSING, (pitch, TILT, 0))
        one.nod.set(held.apart - 0.2, 0.6, (0, 0, 0))
    if who.posture == partner.posture == "stand":
        _bring_lips_together(who, partner, held)
    return held.end


def embrace(stage: MotionStage, who: Performer, partner: Performer, cue: StagedCue) -> Embrace:
    """Bring two people together in an embrace: the taller over the shoulders and bent, the shorter around the ribs.

    Args:
        stage: The stage of the shot.
        who: The person who walks.
        partner: The person embraced.
        cue: Gives start, duration and the mark to step back to.
    """
    distance = who.measures.front + partner.measures.front + 0.035 * (who.scale + partner.scale) / 2
    t = meet(stage, who, partner, cue, distance, 0.03)
    closed = t + 1.2 * CLOSING
    apart = max(closed + HOLDING, cue.start + (cue.duration or 0.0))
    reserve_hands(partner, ("L", "R"), t, apart + 1.0)
    partner.free["body"] = max(partner.free["body"], apart + 1.0)
    taller = who if who.measures.shoulder_height >= partner.measures.shoulder_height else partner
    difference = abs(who.measures.shoulder_height - partner.measures.shoulder_height)
    for one, two in ((who, partner), (partner, who)):
        _close_arms(stage, one, two, one is taller, difference, t, apart)
        look_at(one, apart + 0.2, stage.look_point(two))
    end = apart + 1.0
    if cue.mark is not None and who.posture == "stand":
        end = shuffle_to(who, apart + 0.5, Vector(cue.mark.location).xy)
    return Embrace(t, closed, apart, end)


def _close_arms(
    stage: MotionStage, who: Performer, other: Performer, over: bool, difference: float, t: float, apart: float
) -> None:
    """Embrace ``other`` with both free arms, ``over`` their shoulders or around the ribs, until ``apart`` seconds."""
    k = who.scale
    bend = 24 * clamp(difference / 0.5) if over else 0.0
    who.accent.set(t, CLOSING, (3 + bend, -5, 0))
    who.accent.set(apart, 0.7, (0, 0, 0))
    who.nod.set(t + 0.2, CLOSING, (6 if over else -10 * clamp(difference / 0.3), -10, -12))
    who.nod.set(apart, 0.7, (0, 0, 0))
    if who.posture == "stand":
        height = who.standing_height
        low = height - (0.01 + 0.05 * bend / 24) * k
        who.hips.set(t, CLOSING, (-0.025 * k, 0.03 * k * (1 + bend / 12), low, 0.5 * bend, 0, 0))
        who.hips.set(apart, 0.7, (0, 0, height, 0, 0, 0))
    show_mood(who, t, "tender")
    show_expression(who, t + CLOSING, 0.3, smile=0.5, blink=0.9, brow_up=0.1)
    show_mood(who, apart, "tender")
    who.gaze.set(t, 0.4, who.ahead)
    for side in SIDES:
        held = stage.props.get(who.held.get(side, ""))
        if held is not None and max(held.size) > IN_THE_WAY:
            continue
        opened, closed = _open_arms(who, side, over), _around(who, other, side, over)
        who.hands[side].set(t, 0.6 * CLOSING, opened)
        who.hands[side].set(t + 0.5 * CLOSING, 0.7 * CLOSING, closed)
        who.hands[side].set(apart, 0.35, opened)
        who.hands[side].set(apart + 0.3, 0.7, who.home[side])
        stage.following_hands.append((who, side, t, apart + 0.2))


def _open_arms(who: Performer, side: str, over: bool) -> TargetOf:
    """Return the target of an arm that opens for an embrace."""
    return by_chest(
        who, side, (0.22, 0.80, -0.10 if over else -0.38), (-0.15, 1, 0.1), (-1, 0, 0), pole=(1, -0.2, -0.4),
        curl=(6, 8, 0),
    )  # fmt: skip


def _around(who: Performer, other: Performer, side: str, over: bool) -> TargetOf:
    """Return the target of a palm on the other's back: around the ribs, or over the shoulders."""
    s, k = sign(side), other.scale
    height = ((0.10 if side == "R" else -0.02) if over else (-0.10 if side == "R" else -0.02)) * k
    back = other.measures.chest_back + 0.014 * k - other.bones.head["upper_chest"].y
    offset = Vector(((-0.02 if over else 0.06) * k * s, back, height + 0.05 * k))

    def target(t: float) -> Floats:
        inward = who.facing @ Vector((-s, 0, 0)) + Vector((0, 0, -0.1 if over else 0.35))
        elbow = who.facing @ Vector((s, -0.15, 0.25 if over else -0.25))
        palm, normal = other.point("upper_chest", offset), other.direction("upper_chest", Vector((0, -1, 0)))
        return hand(palm, inward, normal, elbow, (6, 8, 0))

    return target


def _lips(who: Performer) -> Vector:
    """Return the world point of the lips, in the current pose."""
    return who.point("head", who.eye_offset + LIPS * who.scale)


def _bring_lips_together(who: Performer, partner: Performer, held: Embrace) -> None:
    """Bend trunks, shift hips and bend the taller one's knees until the lips meet, by posing both repeatedly."""
    pair = (who, partner)
    moves = {each.asset_id: np.zeros(3) for each in pair}
    start, at = held.closed - 0.6, held.closed + 0.2
    for one in pair:
        _follow(one, moves[one.asset_id], start)
        one.lean_after.set(held.start, 0, 0.0)
        one.lean_after.set(held.apart, 0, 1.0)
    for _ in range(10):
        for one in pair:
            one.pose_trunk(at)
            one.pose_head(at)
        gap = _lips(partner) - _lips(who)
        for one, way in ((who, 1.0), (partner, -1.0)):
            left, ahead, up = (one.facing_inverse @ gap) * Vector((way, -way, way))
            bend, aside, low = moves[one.asset_id]
            bend += math.degrees(0.4 * (ahead - APART) / (one.measures.eye_height - one.measures.hip_height))
            moves[one.asset_id][:] = (
                clamp(bend, -14, 20),
                aside + 0.4 * left,
                clamp(low - 0.8 * up, 0, DEEPEST * one.scale),
            )


def _follow(who: Performer, move: Floats, start: float) -> None:
    """Apply ``move`` from ``start`` seconds on: degrees of bend, metres to the left, metres down."""
    height = who.standing_height - 0.01 * who.scale
    who.accent.set(start, 0.7, lambda now: (move[0], 0, 0))
    who.hips.set(start, 0.7, lambda now: (move[1], 0, height - move[2], 0, 0, 0))
