"""Crawling on hands and knees: down, along a path, and up again."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import Floats, clamp, smooth, smoothstep
from storyblender.blender.motion.clips.locomotion import NEAR, find_goal, step_to, turn_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.clips.seat import return_hands
from storyblender.blender.motion.footsteps import TURN_FIRST, WalkPath
from storyblender.blender.motion.hands import hand
from storyblender.blender.motion.measures import TUCKED
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, sign
from storyblender.geometry.boxes import shortest_turn

SPEED = 0.55
"""Metres per second at scale 1."""
CYCLE = 1.1
"""Seconds of a cycle, in which every limb moves once: a hand with the opposite knee."""
DOWN, UP = 0.9, 1.0
"""Seconds to get on all fours, and to stand up again."""
KNEES_BACK, HANDS_AHEAD = 0.30, 0.24
"""Metres, times the scale, from the middle of the body on the floor."""
FLAT = 78.0
"""Degrees the pelvis is pitched forward."""

ON_THE_FLOOR = (-4, -6, -12)
"""Curl of a hand that bears weight, degrees: stretched flat, the thumb out of the floor."""


@dataclass(frozen=True)
class CrawlPath:
    """The movement of a body on all fours.

    Attributes:
        way: Path on the floor.
        base_yaw: Radians added to the path's headings.
        start: Second at which it sets out.
        seconds: Duration.
    """

    way: WalkPath
    base_yaw: float
    start: float
    seconds: float

    def root(self, t: float) -> tuple[float, float, float]:
        """Return x, y and yaw of the body at ``t`` seconds."""
        return self.at(self.way.length * smoothstep(clamp((t - self.start) / self.seconds)))

    def at(self, gone: float) -> tuple[float, float, float]:
        """Return x, y and yaw of the body after ``gone`` metres."""
        place = self.way.place(gone)
        return place.x, place.y, self.way.heading(gone) + self.base_yaw

    def limb(self, t: float, phase: float, ahead: float, aside: float) -> tuple[Vector, float, float]:
        """Return position (world x, y) and yaw (radians) of a limb, and how far it is lifted, 0..1.

        Args:
            t: Seconds.
            phase: Place of the limb in the cycle, 0..1.
            ahead: Metres from the body's middle forwards.
            aside: Metres from the body's middle to the left.
        """
        turns = (t - self.start) / CYCLE + phase
        swing = turns - math.floor(turns)
        last, after = (self._put_down(math.floor(turns) + step, phase, ahead, aside) for step in (-1, 0))
        share = smooth(clamp(2 * swing))
        spot = last[0].lerp(after[0], share)
        moved = (after[0] - last[0]).length
        return spot, last[1] + (after[1] - last[1]) * share, math.sin(math.pi * clamp(2 * swing)) * clamp(8 * moved)

    def _put_down(self, turn: int, phase: float, ahead: float, aside: float) -> tuple[Vector, float]:
        """Return where a limb is put down in a cycle, and its yaw: below the body in the middle of its rest."""
        x, y, yaw = self.root(self.start + (turn + 0.75 - phase) * CYCLE)
        forward, left = Vector((math.sin(yaw), -math.cos(yaw))), Vector((math.cos(yaw), math.sin(yaw)))
        return Vector((x, y)) + forward * ahead + left * aside, yaw


@clip("crawl", "body", "hands")
def crawl(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Get down on hands and knees, crawl to the mark and stand up there. Return the end in seconds."""
    goal, yaw = find_goal(stage, who, cue)
    if math.dist(who.position, goal) < NEAR:
        return cue.start
    points = stage.path_to(who, goal, via=cue.via)
    if points is None:
        stage.report("no_path", who, cue, f"{who.asset_id} finds no way to ({goal[0]:.2f}, {goal[1]:.2f})")
        return cue.start
    way, t = WalkPath(points), cue.start
    if abs(shortest_turn(who.yaw, way.heading(0))) > TURN_FIRST:
        t = turn_to(who, t, way.heading(0))
    base_yaw = who.yaw + shortest_turn(who.yaw, way.heading(0)) - way.heading(0)
    path = CrawlPath(way, base_yaw, t + DOWN, max(CYCLE, way.length / (SPEED * math.sqrt(who.scale))))
    end = path.start + path.seconds
    who.root.set(t, 0.5 * DOWN, path.root)
    get_on_all_fours(who, path, t)
    x, y, who.yaw = path.at(way.length)
    who.position = Vector((x, y))
    end = _get_up(stage, who, end)
    return end if yaw is None else turn_to(who, end, yaw)


def get_on_all_fours(who: Performer, path: CrawlPath, t: float) -> None:
    """Put knees, then hands on the floor from ``t`` seconds on; from then on they follow ``path``."""
    m, k = who.measures, who.scale
    on_knees = m.knee + 0.97 * m.thigh

    def hips(now: float) -> tuple[float, ...]:
        roll = math.sin(2 * math.pi * (now - path.start) / CYCLE) * clamp(now - path.start)
        return 0.012 * k * roll, KNEES_BACK * k - m.hip_y, on_knees, FLAT, 3 * roll, 0

    who.hips.set(t, 0.55 * DOWN, (0, 0.12 * k, 0.75 * m.hip_height, 45, 0, 0))
    who.hips.set(t + 0.3 * DOWN, 0.7 * DOWN, hips)
    who.spine.set(t, DOWN, (8, 0, 0))
    who.nod.set(t + 0.3 * DOWN, 0.7 * DOWN, (-20, 0, 0))
    who.pinned.set(t + 0.3 * DOWN, 0.5 * DOWN, 1.0)
    who.lean_after.set(t, 0, 0.0)
    for side in SIDES:
        who.feet[side].set(t + (0.1 if side == "L" else 0.3) * DOWN, 0.6 * DOWN, _knee(who, path, side))
        if side not in who.held:
            who.hands[side].set(t + 0.25 * DOWN, 0.75 * DOWN, _palm(who, path, side))


def _get_up(stage: MotionStage, who: Performer, t: float) -> float:
    """Stand up from all fours from ``t`` seconds on; return the end."""
    stand = who.standing_height
    who.hips.set(t, 0.5 * UP, (0, 0.10 * who.scale, 0.62 * stand, 40, 0, 0))
    who.hips.set(t + 0.4 * UP, 0.6 * UP, (0, 0, stand, 0, 0, 0))
    who.spine.set(t + 0.2 * UP, 0.8 * UP, (0, 0, 0))
    who.nod.set(t, UP, (0, 0, 0))
    who.pinned.set(t + 0.4 * UP, 0.4 * UP, 0.0)
    who.lean_after.set(t + UP, 0, 1.0)
    for index, side in enumerate(SIDES):
        plant = who.plant(side, who.position, who.yaw)
        step_to(who, side, t + 0.3 * index * UP, 0.5 * UP, plant, 0.08 * who.scale)
    return_hands(stage, who, t + 0.1 * UP, 0.7 * UP)
    return t + 1.1 * UP


def _knee(who: Performer, path: CrawlPath, side: str) -> Callable[[float], Floats]:
    """Return the target of the foot behind a knee on the floor."""
    m, k = who.measures, who.scale

    def target(t: float) -> Floats:
        spot, yaw, lifted = path.limb(t, 0.0 if side == "L" else 0.5, -KNEES_BACK * k, sign(side) * 0.10 * k)
        forward = Vector((math.sin(yaw), -math.cos(yaw)))
        foot = spot - forward * m.kneeling_shin
        toes = yaw + m.toe_out[side]
        return np.array([*foot, m.tucked + 0.03 * k * lifted, toes, *TUCKED, *(forward * 0.8), -0.6])

    return target


def _palm(who: Performer, path: CrawlPath, side: str) -> Callable[[float], Floats]:
    """Return the target of a palm on the floor, or on its way to the next place."""
    k, s = who.scale, sign(side)

    def target(t: float) -> Floats:
        spot, yaw, lifted = path.limb(t, 0.5 if side == "L" else 0.0, HANDS_AHEAD * k, s * 0.18 * k)
        forward, left = Vector((math.sin(yaw), -math.cos(yaw), 0)), Vector((math.cos(yaw), math.sin(yaw), 0))
        palm = Vector((*spot, (0.022 + 0.07 * lifted) * k))
        return hand(palm, forward, Vector((0, 0, -1)), left * (0.6 * s) - forward * 0.8, ON_THE_FLOOR)

    return target
