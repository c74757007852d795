"""Off the ground: jumping, and getting over or up obstacles."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, clamp, smoothstep
from storyblender.blender.motion.clips.handling import approach
from storyblender.blender.motion.clips.locomotion import travel, turn_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_chest, fixed_hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageFurniture
from storyblender.blender.motion.skeleton import SIDES, facing_yaw, other, sign

HANDS_FREE = 0.55
"""Metres, times the scale; lower obstacles are leapt without a hand on them."""
SEATED_OVER = 0.40
"""Metres, times the scale, of the hip joints above an obstacle."""
STRAIGHT = 3.5
"""Metres; a farther mark is approached first."""
AIR = 0.57
"""Seconds off the ground of a jump on the spot."""
RUNG = 0.28
"""Metres, times the scale, between the holds of a climb."""


@clip("jump", "body", "hands")
def jump(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Jump over the target to the mark behind it, on the spot, or forward to a near mark. Return the end in seconds."""
    if cue.mark is not None and isinstance(cue.target, StageFurniture):
        return _get_over(stage, who, cue, cue.target, 0.70)
    t, k = cue.start, who.scale
    goal = Vector(cue.mark.location).xy if cue.mark else who.position.copy()
    if (goal - who.position).length > 1.6 * k:
        t = travel(stage, who, cue, tuple(who.position.lerp(goal, 0.6)))
        goal = who.position.lerp(goal, min(1.0, 1.2 * k / max(0.01, (goal - who.position).length)))
    _swing_arms(who, t + 0.35, AIR)
    down = _fly(who, t + 0.35, goal, AIR, 0.28 * k, 0.04 * k, 0.0)
    return _land(who, down)


@clip("climb", "body", "hands")
def climb(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Climb over the target to the mark behind it, or up the target. Return the end in seconds."""
    if cue.mark is not None and isinstance(cue.target, StageFurniture):
        return _get_over(stage, who, cue, cue.target, 1.5)
    return _climb_up(stage, who, cue)


def _get_over(stage: MotionStage, who: Performer, cue: StagedCue, thing: StageFurniture, air: float) -> float:
    """Swing across a piece of furniture, a hand on it if it is high, in ``air`` seconds; return the end in seconds."""
    k = who.scale
    assert cue.mark is not None, "the mark is behind the thing"
    goal = Vector(cue.mark.location).xy
    way = goal - who.position
    t = cue.start
    if way.length > STRAIGHT:
        near = goal - way.normalized() * (0.8 * STRAIGHT)
        t, way = travel(stage, who, cue, tuple(near)), goal - near
    t = turn_to(who, t, facing_yaw(way))
    top = float(thing.world[2, 3]) + thing.dimensions[2]
    air = air * math.sqrt(k) + 0.12 * way.length
    if top > HANDS_FREE * k:
        hold = _nearest_on_top(who, thing, top)
        side = Vector((*who.left, 0))
        for hand in SIDES:
            palm = hold + side * (sign(hand) * 0.17 * k)
            elbow = Vector((*(-who.forward), 0)) + side * (sign(hand) * 0.6)
            down = Vector((0, 0, -1))
            who.hands[hand].set(t, 0.4, fixed_hand(palm, Vector((*who.forward, -0.2)), down, elbow, (20, 24, 10)))
            who.hands[hand].set(t + 0.35 + 0.5 * air, 0.35, who.home[hand])
    else:
        _swing_arms(who, t + 0.35, air)
    rise = max(0.22 * k, top + SEATED_OVER * k - who.standing_height)
    return _land(who, _fly(who, t + 0.35, goal, air, rise, top + 0.10 * k, 0.22))


def _nearest_on_top(who: Performer, thing: StageFurniture, top: float) -> Vector:
    """Return the point on a box's upper face nearest to a person, a palm's breadth in."""
    world = Matrix(thing.world.tolist())
    local = world.inverted() @ Vector((*who.position, 0))
    half = [max(0.0, size / 2 - 0.05) for size in thing.dimensions[:2]]
    spot = world @ Vector((*(max(-h, min(h, v)) for h, v in zip(half, local.xy, strict=True)), 0))
    spot.z = top + 0.02
    return spot


def _fly(who: Performer, off: float, goal: Vector, air: float, rise: float, lift: float, stride: float) -> float:
    """Crouch, leave the ground and land; return the second of landing.

    Args:
        who: A standing person.
        off: Second at which the crouch is deepest.
        goal: Landing position (x, y).
        air: Seconds from the crouch to the landing.
        rise: Metres by which the hips rise.
        lift: Metres by which the feet are lifted.
        stride: Share of the time by which the second foot follows the first.
    """
    k, stand = who.scale, who.standing_height
    who.hips.set(off - 0.35, 0.35, (0, 0.05 * k, stand - 0.24 * k, 20, 0, 0))
    who.spine.set(off - 0.35, 0.35, (22, 0, 0))
    who.spine.set(off, 0.3 * air, (10 if stride else -4, 0, 0))
    start = who.position.copy()

    def share(now: float) -> float:
        return clamp((now - off) / air)

    def root(now: float) -> tuple[float, float, float]:
        place = start.lerp(goal, smoothstep(share(now)))
        return place.x, place.y, who.yaw

    def hips(now: float) -> tuple[float, ...]:
        w = share(now)
        return (0, 0, stand - 0.24 * k * (1 - min(1.0, 4 * w)) + rise * math.sin(math.pi * w) ** 0.8, 8, 0, 0)

    who.root.set(off, 0, root)
    who.hips.set(off, 0.2 * air, hips)
    for index, side in enumerate(SIDES):
        lifted = np.array(who.feet[side](off), float)
        landed = who.plant(side, goal, who.yaw, width=1.1)
        span = (stride * index + 0.04, 1 - stride * (1 - index))
        who.feet[side].set(off, 0, _foot_in_flight(share, span, lifted, landed, lift + 0.28 * k * (not stride)))
    who.position = goal
    return off + air


def _swing_arms(who: Performer, off: float, air: float) -> None:
    """Swing the free arms back, then up and forward as the feet leave the ground at ``off`` seconds."""
    for side in SIDES:
        if who.is_free(side):
            back = by_chest(who, side, (0.15, -0.40, -0.75), (0.1, -0.6, -0.8), (-1, 0, 0), upright=True)
            ahead = by_chest(who, side, (0.40, 0.62, 0.28), (0.3, 0.8, 0.5), (-0.3, 0.2, -0.9), upright=True)
            who.hands[side].set(off - 0.33, 0.3, back)
            who.hands[side].set(off, 0.35 * air, ahead)
            who.hands[side].set(off + air, 0.5, who.home[side])


def _foot_in_flight(
    share: Callable[[float], float], span: tuple[float, float], lifted: Floats, landed: Floats, lift: float
) -> Callable[[float], Floats]:
    """Return the foot's target during a leap, by seconds.

    Args:
        share: Share of the leap (0..1) by time in seconds.
        span: Shares of the leap at which the foot leaves the ground and lands.
        lifted: Values of the foot's channel on leaving the ground.
        landed: Values of the foot's channel on landing.
        lift: Height added at the middle of the flight, metres.
    """

    def foot(now: float) -> Floats:
        w = clamp((share(now) - span[0]) / (span[1] - span[0]))
        pose = lifted * (1 - smoothstep(w)) + landed * smoothstep(w)
        pose[2] += lift * math.sin(math.pi * w) ** 0.7
        pose[4] = -35 * math.sin(math.pi * w)
        return pose

    return foot


def _land(who: Performer, down: float) -> float:
    """Absorb a landing at ``down`` seconds and stand; return the end in seconds."""
    k, stand = who.scale, who.standing_height
    who.hips.set(down, 0.14, (0, 0.04 * k, stand - 0.16 * k, 14, 0, 0))
    who.spine.set(down, 0.16, (16, 0, 0))
    who.hips.set(down + 0.2, 0.5, (0, 0, stand, 0, 0, 0))
    who.spine.set(down + 0.2, 0.5, (0, 0, 0))
    return down + 0.6


def _climb_up(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Climb a ladder or a wall hand over hand; come down again if the shot goes on. Return the end in seconds."""
    t, k = cue.start, who.scale
    height = 3 * RUNG * k
    if isinstance(cue.target, StageFurniture):
        place = Vector((*stage.floor_position(cue.target), who.measures.shoulder_height))
        t = approach(stage, who, cue, place, 0.9 * who.measures.arm)
        height = float(cue.target.world[2, 3]) + cue.target.dimensions[2] - 1.1 * who.measures.shoulder_height
    end = t + max(2.0, cue.duration or 3.0)
    pulse = 0.55
    rungs = max(1, min(int(height / (RUNG * k)), int((end - t) / pulse)))
    stays = end > stage.seconds - 1.0
    levels = [*range(1, rungs + 1), *(() if stays else range(rungs - 1, -1, -1))]
    for index, level in enumerate(levels):
        t = _pull(who, t, pulse, SIDES[index % 2], level * RUNG * k)
    for side in () if stays else SIDES:
        who.feet[side].set(t, 0.4, who.plant(side, who.position, who.yaw))
        who.hands[side].set(t, 0.7, who.home[side])
    return t + (0.0 if stays else 0.7)


def _pull(who: Performer, t: float, pulse: float, side: str, level: float) -> float:
    """Climb one hold up or down, until the body is at ``level`` metres; return the end in seconds."""
    k = who.scale
    for each, high in ((side, 0.70), (other(side), 0.15)):
        rung = by_chest(
            who,
            each,
            (-0.05, 0.50, high),
            (0, 0.35, 0.9),
            (0, 1, 0),
            pole=(0.7, -0.1, -0.7),
            curl=(70, 78, 25),
            upright=True,
        )
        who.hands[each].set(t, 0.9 * pulse, rung)
    who.hips.set(t, pulse, (0, 0, who.standing_height + level - 0.06 * k, 4, 0, 0))
    for foot, above in ((other(side), RUNG * k), (side, 0.0)):
        hold = who.plant(foot, who.position + who.forward * (0.10 * k), who.yaw)
        hold[2] += max(0.0, level - RUNG * k + above)
        who.feet[foot].set(t, 0.9 * pulse, hold)
    return t + pulse
