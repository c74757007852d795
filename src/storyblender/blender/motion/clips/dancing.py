"""Dancing: alone, from side to side, or in couples, turning."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import Channel, Floats, TargetOf, clamp, smoothstep
from storyblender.blender.motion.clips.gaze import look_at, show_mood
from storyblender.blender.motion.clips.locomotion import step_to
from storyblender.blender.motion.clips.pairs import meet, partner_of, reserve_hands
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import blend_hands, by_chest, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, other, sign
from storyblender.geometry.paths import clearance

PULSE = 0.52
"""Seconds of a step."""
BETWEEN = 0.16
"""Metres, times the scale, between the bodies of a couple."""
ROUND = 8.0
"""Seconds of a full turn of a couple."""
ROCKING, SWING = math.radians(18), 4.0
"""Radians and seconds of a couple's turns to and fro, where there is no time or room for full turns."""
Place = Callable[[float], tuple[float, float, float]]


@clip("dance", "body", "hands", "head")
def dance(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Dance with the target if they stand, else alone. Return the end in seconds."""
    partner = partner_of(cue)
    if partner is None or partner.posture != "stand":
        return _alone(who, cue)
    k = 0.5 * (who.scale + partner.scale)
    t = meet(stage, who, partner, cue, who.measures.front + partner.measures.front + BETWEEN * k, 0.05)
    end = t + max(2.0, cue.duration or 4.0)
    reserve_hands(partner, ("L", "R"), t, end + 0.8)
    partner.free["body"] = max(partner.free["body"], end + 0.8)
    lead, follow = (
        (who, partner) if who.measures.shoulder_height >= partner.measures.shoulder_height else (partner, who)
    )
    turned = _turned(stage, lead, follow, t, end)
    middle = (lead.position + follow.position) / 2
    for one, two, first in ((lead, follow, "L"), (follow, lead, "R")):
        _go_round(one, _around(one, middle, turned), t, end, first)
        one.yaw += turned(end)
        look_at(one, t, stage.look_point(two))
        show_mood(one, t, "tender" if cue.mood == "neutral" else cue.mood)
    for one, side, target in (
        (lead, "R", _on_back(lead, follow)),
        (follow, "L", _on_shoulder(follow, lead)),
        (lead, "L", _clasped(lead, follow, lead)),
        (follow, "R", _clasped(lead, follow, follow)),
    ):
        one.hands[side].set(t, 0.7, target)
        one.hands[side].set(end, 0.7, one.home[side])
        stage.following_hands.append((one, side, t, end + 0.3))
    return end + 0.7


def _turned(stage: MotionStage, lead: Performer, follow: Performer, t: float, end: float) -> Callable[[float], float]:
    """Return the angle of a couple by seconds, radians: full turns where there is room, else to and fro."""
    middle, arm = (lead.position + follow.position) / 2, (lead.position - follow.position).length / 2
    circle = [(middle.x + arm * math.sin(a), middle.y + arm * math.cos(a)) for a in np.linspace(0, 2 * math.pi, 12)]
    others = stage.footprints(lead, (follow.asset_id,))
    room = float(clearance(np.array(circle), others).min()) > 0.9 * max(lead.measures.radius, follow.measures.radius)
    rounds = round((end - t) / ROUND) if room else 0
    if rounds:
        return lambda now: 2 * math.pi * rounds * smoothstep(clamp((now - t) / (end - t)))
    swings = max(1, round((end - t) / SWING))
    return lambda now: ROCKING * math.sin(2 * math.pi * swings * clamp((now - t) / (end - t)))


def _around(who: Performer, middle: Vector, turned: Callable[[float], float]) -> Place:
    """Return x, y and yaw of a dancer around ``middle`` by seconds."""
    arm, yaw = who.position - middle, who.yaw

    def place(now: float) -> tuple[float, float, float]:
        angle = turned(now)
        cos, sin = math.cos(angle), math.sin(angle)
        return middle.x + cos * arm.x - sin * arm.y, middle.y + sin * arm.x + cos * arm.y, yaw + angle

    return place


def _go_round(who: Performer, place: Place, t: float, end: float, first: str) -> None:
    """Follow ``place`` in small steps from ``t`` to ``end`` seconds, the trunk rising and falling."""
    pulse, k, stand = PULSE, who.scale, who.standing_height
    who.root.set(t, 0, place)
    who.hips.set(
        t, 0.4, lambda now: (0, 0, stand - (0.022 + 0.014 * math.cos(2 * math.pi * (now - t) / pulse)) * k, 0, 0, 0)
    )
    side, now = first, t
    while now < end - 0.4 * pulse:
        x, y, yaw = place(min(end, now + 1.4 * pulse))
        step_to(who, side, now, 0.8 * pulse, who.plant(side, (x, y), yaw, width=0.85), 0.025 * k)
        side, now = other(side), now + pulse
    x, y, yaw = place(end)
    for index in range(2):
        step_to(who, side, now + 0.3 * index, 0.3, who.plant(side, (x, y), yaw), 0.02 * k)
        side = other(side)
    who.hips.set(end, 0.6, (0, 0, stand, 0, 0, 0))


def _on_back(who: Performer, partner: Performer) -> TargetOf:
    """Return the target of the leading right hand, on the partner's shoulder blade."""
    k = partner.scale
    back = partner.measures.chest_back + 0.014 * k - partner.bones.head["upper_chest"].y

    def target(t: float) -> Floats:
        palm = partner.point("upper_chest", (0.07 * k, back, -0.02 * k))
        fingers = partner.direction("upper_chest", Vector((-1, 0, 0.25)))
        elbow = who.facing @ Vector((-1, 0.1, -0.35))
        return hand(palm, fingers, partner.direction("upper_chest", Vector((0, -1, 0))), elbow, (8, 10, 0))

    return target


def _on_shoulder(who: Performer, partner: Performer) -> TargetOf:
    """Return the target of the following left hand, on the partner's right shoulder."""
    k = partner.scale

    def target(t: float) -> Floats:
        palm = partner.point("upper_arm.R", (-0.01 * k, 0.02 * k, 0.06 * k))
        forward = who.facing @ Vector((0.1, -1, 0))
        return hand(palm, forward, Vector((0, 0, -1)), who.facing @ Vector((0.9, 0.2, -0.5)), (14, 18, 0))

    return target


def _clasped(lead: Performer, follow: Performer, who: Performer) -> TargetOf:
    """Return the target of a dancer's clasped hand, held out to the leader's left at shoulder height."""
    side = "L" if who is lead else "R"

    def target(t: float) -> Floats:
        between = (lead.point("upper_arm.L") + follow.point("upper_arm.R")) / 2
        out = lead.facing @ Vector((1, 0, 0))
        toward = who.facing @ Vector((0, -1, 0))
        palm = between + out * (0.62 * min(lead.measures.arm, follow.measures.arm)) - toward * (0.014 * who.scale)
        palm.z -= 0.04 * who.scale
        elbow = who.facing @ Vector((sign(side) * 0.4, 0.4, -0.9))
        return hand(palm, out * 0.5 + Vector((0, 0, 0.8)), toward, elbow, (34, 40, 10))

    return target


def _alone(who: Performer, cue: StagedCue) -> float:
    """Step from side to side in rhythm, arms swinging; return the end in seconds."""
    t, k = cue.start, who.scale
    end = t + max(2.0, cue.duration or 4.0)
    x, y = who.position
    way, pulse = 1, 0.52
    show_mood(who, t, "happy")
    for side in SIDES:
        who.hands[side].set(t, 0.5, _swing(who, side, t, pulse))
    while t < end - 2 * pulse:
        shift = who.left * (0.10 * k * way)
        side = "L" if way > 0 else "R"
        step_to(who, side, t, 0.8 * pulse, who.plant(side, (x + shift.x, y + shift.y), who.yaw, width=1.2, splay=14))
        who.hips.set(t, pulse, (0.07 * k * way, 0, who.standing_height - 0.03 * k, 0, 4 * way, 8 * way))
        who.accent.set(t, pulse, (2, -6 * way, -9 * way))
        who.nod.set(t, pulse, (3 * way, 4 * way, 0))
        t, way = t + pulse, -way
    for side in SIDES:
        step_to(who, side, t + (0 if side == "L" else 0.3), 0.3, who.plant(side, (x, y), who.yaw))
        who.hands[side].set(t, 0.7, who.home[side])
    who.hips.set(t, 0.6, (0, 0, who.standing_height, 0, 0, 0))
    who.accent.set(t, 0.6, (0, 0, 0))
    who.nod.set(t, 0.5, (0, 0, 0))
    return t + 0.7


def _swing(who: Performer, side: str, start: float, pulse: float) -> Channel:
    """Return the targets of an arm that swings with the steps."""
    low = by_chest(who, side, (0.10, 0.45, -0.42), (-0.4, 0.8, 0.3), (-0.9, 0, -0.4), curl=(40, 48, 10))
    high = by_chest(who, side, (0.30, 0.50, -0.05), (-0.3, 0.6, 0.7), (-0.9, 0.2, -0.2), curl=(30, 36, 10))
    channel = Channel(low, blend_hands)
    for index in range(int(60 / pulse)):
        up = (index % 2 == 0) == (side == "L")
        channel.set(start + index * pulse, pulse, high if up else low)
    return channel
