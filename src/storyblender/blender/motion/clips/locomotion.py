"""Travelling and turning: walk, run, sneak, stagger, turn."""

from __future__ import annotations

import math

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import Floats, clamp, smooth
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.footsteps import (
    HURRY,
    RUN,
    SNEAK,
    STAGGER,
    TURN_FIRST,
    WALK,
    FootstepPlan,
    TravelStyle,
    WalkPath,
)
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import facing_yaw, other
from storyblender.catalog.motions import TURN_STEP, TURN_STEP_SECONDS
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2, find_waiting_time

NEAR = 0.06
"""Metres; a nearer mark counts as reached."""


def step_to(who: Performer, side: str, t: float, duration: float, pose: Floats, lift: float | None = None) -> float:
    """Move one foot in an arc to a target; return the second at which it is down.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        t: Second at which the foot leaves the floor.
        duration: Seconds in the air.
        pose: (9,) foot target to reach, see ``Performer.plant``.
        lift: Height of the arc in metres; None for the usual one.
    """
    start, goal = np.array(who.feet[side](t), float), np.array(pose, float)
    turn = shortest_turn(start[3], goal[3])
    height = 0.04 * who.scale if lift is None else lift

    def target(now: float) -> Floats:
        w = clamp((now - t) / duration)
        e = smooth(w)
        values = start * (1 - e) + goal * e
        values[3] = start[3] + turn * e
        values[2] += height * math.sin(math.pi * w)
        values[4] -= 12 * math.sin(math.pi * w) * (1 - w)
        return values

    who.feet[side].set(t, 0, target)
    return t + duration


def shuffle_to(who: Performer, t: float, place: Vector) -> float:
    """Step to a near ``place`` (world x, y, metres) without turning, from ``t`` seconds on; return the end."""
    way = place - who.position
    lead = "R" if way.dot(who.left) < 0 else "L"
    who.root.set(t + 0.1, 0.75, (place.x, place.y, who.yaw))
    for side, after in ((lead, 0.1), (other(lead), 0.48)):
        step_to(who, side, t + after, 0.36, who.plant(side, place, who.yaw))
    who.position = place.copy()
    return t + 0.85


def turn_to(who: Performer, t: float, yaw: float) -> float:
    """Turn on the spot to a world yaw in radians with footsteps, from ``t`` seconds on; return the end in seconds."""
    turn = shortest_turn(who.yaw, yaw)
    x, y = who.position
    if abs(turn) < math.radians(12):
        if abs(turn) > 1e-3:
            who.root.set(t, 0.3, (x, y, who.yaw + turn))
            who.yaw += turn
        return t
    count = max(1, math.ceil(abs(turn) / math.radians(TURN_STEP)))
    pulse = TURN_STEP_SECONDS * math.sqrt(who.scale)
    length = 2 * count * pulse + 0.1
    who.root.set(t, 0.95 * length, (x, y, who.yaw + turn))
    lead = "L" if turn > 0 else "R"
    for index in range(2 * count):
        side = lead if index % 2 == 0 else other(lead)
        reached = who.yaw + turn * (index // 2 + 1) / count
        step_to(who, side, t + index * pulse, 0.95 * pulse, who.plant(side, (x, y), reached), 0.035 * who.scale)
    who.yaw += turn
    return t + length


def travel(
    stage: MotionStage,
    who: Performer,
    cue: StagedCue,
    goal: Vec2,
    end_yaw: float | None = None,
    *,
    style: TravelStyle = WALK,
    skip: tuple[str, ...] = (),
    partner: Performer | None = None,
) -> float:
    """Walk around obstacles to a goal: wait for people who cross, turn, walk, turn; return the second of arrival.

    Without a path the person stays, and the stage reports it.

    Args:
        stage: The stage.
        who: The walker.
        cue: Gives the start and, if it has one, the duration.
        goal: x and y, metres.
        end_yaw: Facing at the end in radians; None keeps the heading.
        style: Speed and gait.
        skip: Obstacles to ignore, by node id or asset id.
        partner: The person walked to; not avoided as an obstacle.
    """
    here = (who.position.x, who.position.y)
    if math.dist(here, goal) < NEAR:
        return cue.start if end_yaw is None else turn_to(who, cue.start, end_yaw)
    points = stage.path_to(who, goal, skip, cue.via)
    if points is None:
        stage.report("no_path", who, cue, f"{who.asset_id} finds no way to ({goal[0]:.2f}, {goal[1]:.2f})")
        return cue.start
    way = WalkPath(points)
    t = cue.start
    first = way.heading(0)
    turning = abs(shortest_turn(who.yaw, first)) > TURN_FIRST
    if cue.duration is not None:
        seconds = max(0.5, cue.duration - (0.7 if turning else 0.0))
        style = style.slowed(way.length / max(0.3, seconds - 0.5), who.scale)
    trial = FootstepPlan(who, 0.0, way, style, end_yaw)
    lead = 0.6 if turning else 0.0
    others = stage.tracks_of_others(who, partner, goal)
    wait, gap = find_waiting_time(lambda u: trial.root(u)[:2], trial.duration, t + lead, others)
    if gap < -0.12:
        stage.report("crossing", who, cue, f"{who.asset_id} walks through another person by {-gap:.2f} m", -gap)
    t += wait
    if turning:
        t = turn_to(who, t, first)
    t = FootstepPlan(who, t, way, style, end_yaw).perform()
    return t if end_yaw is None else turn_to(who, t, end_yaw)


def find_goal(stage: MotionStage, who: Performer, cue: StagedCue) -> tuple[Vec2, float | None]:
    """Return the goal of a travelling cue: its mark, else an arm's length before its target.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives mark and target; without both the goal is 2 m ahead.

    Returns:
        World x and y in metres; final yaw in radians, None to keep the heading.
    """
    if cue.mark is not None:
        return (cue.mark.location[0], cue.mark.location[1]), math.radians(cue.mark.yaw)
    if cue.target is not None:
        place = stage.floor_position(cue.target)
        toward = place - who.position
        keep = 1.1 if isinstance(cue.target, Performer) else 0.75
        stop = place - toward.normalized() * min(keep, toward.length)
        return (stop.x, stop.y), facing_yaw(toward)
    ahead = who.position + who.forward * 2.0
    return (ahead.x, ahead.y), None


@clip("walk", "body")
def walk(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Walk to the mark. Return the end in seconds."""
    goal, yaw = find_goal(stage, who, cue)
    return travel(stage, who, cue, goal, yaw)


@clip("run", "body")
def run(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Run to the mark; short distances are walked briskly. Return the end in seconds."""
    goal, yaw = find_goal(stage, who, cue)
    far = math.dist(who.position, goal) > 2.2 * who.scale
    return travel(stage, who, cue, goal, yaw, style=RUN if far else WALK.slowed(1.8, 1.0))


@clip("hurry", "body")
def hurry(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Walk fast to the mark, with long steps. Return the end in seconds."""
    goal, yaw = find_goal(stage, who, cue)
    return travel(stage, who, cue, goal, yaw, style=HURRY)


@clip("sneak", "body")
def sneak(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Sneak to the mark, bent and slow. Return the end in seconds."""
    goal, yaw = find_goal(stage, who, cue)
    return travel(stage, who, cue, goal, yaw, style=SNEAK)


@clip("stagger", "body")
def stagger(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Stagger to the mark: wide steps, the trunk rolling from side to side. Return the end in seconds."""
    goal, yaw = find_goal(stage, who, cue)
    end = travel(stage, who, cue, goal, yaw, style=STAGGER)
    t, roll = cue.start, 1
    while t < end - 0.6:
        who.accent.set(t, 0.55, (6 * (roll > 0), 9 * roll, 4 * roll))
        t, roll = t + 0.6, -roll
    who.accent.set(end - 0.4, 0.6, (0, 0, 0))
    return end


@clip("turn", "body")
def turn(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Turn on the spot to the mark's yaw, else to the target, else by half a turn. Return the end in seconds."""
    if cue.mark is not None:
        yaw = math.radians(cue.mark.yaw)
    elif cue.target is not None:
        toward = stage.floor_position(cue.target) - who.position
        yaw = facing_yaw(toward)
    else:
        yaw = who.yaw + math.pi
    return turn_to(who, cue.start, yaw)
