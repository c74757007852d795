"""Sitting down, and standing up from any posture."""

from __future__ import annotations

import math

import numpy as np
from mathutils import Vector

from storyblender.blender.motion.channel import smoothstep
from storyblender.blender.motion.clips.locomotion import step_to, travel, turn_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.clips.tabletop import find_table_before, hand_places_on, seated_bend, seated_hand
from storyblender.blender.motion.hands import on_thigh
from storyblender.blender.motion.idle_hands import idle_hand
from storyblender.blender.motion.motion_stage import MotionStage, Seat, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, other, sign
from storyblender.blender.motion.staged_props import carrying_hand
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import BEFORE_SEAT
from storyblender.memory.shot_context import Mark

OFF_THE_FLOOR = ("hang", "upside_down", "float", "ride", "crawl")
"""Postures in which the feet carry no weight."""
ASIDE = 0.12
"""Metres; a person farther from the position before a seat reaches or leaves it sideways."""
STATURE = 1.7
"""Metres of a person of scale 1."""
HAT, SINKS = 0.06, 0.12
"""Metres kept free over a head under a roof; most metres by which a sitter slouches into the seat for that."""
FLOOR_SEAT = 0.30
"""Metres; on lower seats the legs are stretched out."""


def feet_before_seat(who: Performer, seat: Seat) -> Vector:
    """Return the position (world x, y in metres) of a sitter's feet, in front of the seat's edge."""
    return seat.edge + seat.before * (BEFORE_SEAT * who.scale)


def seat_of_cue(stage: MotionStage, who: Performer, cue: StagedCue) -> Seat | None:
    """Return the seat of a cue's mark or target; a seat on the floor where the mark names no support; else None.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives mark and target.
    """
    support = cue.mark.support_id if cue.mark else None
    seat = stage.find_seat(support, cue.mark)
    if seat is None and cue.target is not None:
        named = getattr(cue.target, "asset_id", None)
        seat = stage.find_seat(named, cue.mark)
    if seat is None and cue.mark is not None and not support:
        x, y, z = cue.mark.location
        return Seat(Vector((x, y)), z + 0.02, 0.5, math.radians(cue.mark.yaw))
    return seat


def return_hands(stage: MotionStage, who: Performer, t: float, duration: float) -> None:
    """Bring both hands back to rest, or to carrying what they hold.

    Args:
        stage: The stage of the shot.
        who: The person.
        t: Second at which the hands begin to move.
        duration: Seconds.
    """
    for side in SIDES:
        held = who.held.get(side)
        target = carrying_hand(who, side, stage.props[held]) if held in stage.props else who.home[side]
        who.hands[side].set(t, duration, target)


@clip("sit", "body", "hands")
def sit(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Sit down on the seat of the mark or target, walking to it first. Return the end in seconds."""
    seat = seat_of_cue(stage, who, cue)
    if seat is None:
        stage.report("no_support", who, cue, f"{who.asset_id} has nothing to sit on")
        return cue.start
    t = cue.start
    t = go_to_seat(stage, who, cue, seat)
    if t is None:
        return cue.start
    who.support = cue.mark.support_id or "" if cue.mark else ""
    return lower_onto_seat(stage, who, seat, t)


def go_to_seat(stage: MotionStage, who: Performer, cue: StagedCue, seat: Seat) -> float | None:
    """Walk to a seat and turn the back to it, or be there before the shot; return the end, None without a path.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives the start, before 0 if they sit at the beginning of the shot, and the duration of the walk.
        seat: Where they will sit.
    """
    if cue.start < 0:
        before = feet_before_seat(who, seat)
        who.place_at_start(before.x, before.y, seat.yaw)
        return cue.start
    place = stage.seat_access(who, seat)
    t = turn_to(who, travel(stage, who, cue, (place.x, place.y), seat.yaw), seat.yaw)
    return t if (who.position - place).length < 0.15 else None


def lower_onto_seat(stage: MotionStage, who: Performer, seat: Seat, t: float) -> float:
    """Sit down from the position before a seat; return the end in seconds.

    Args:
        stage: The stage of the shot.
        who: The person, standing before the seat with the back to it.
        seat: Where they sit down.
        t: Second at which they begin.
    """
    m, k = who.measures, who.scale
    forward = who.forward
    depth = min(0.80 * m.thigh, max(0.08, seat.depth - m.seat_back - 0.02))
    before = feet_before_seat(who, seat)
    back = depth - (seat.edge - before).dot(forward)
    dy, height = back - m.hip_y, seat.height + m.seat_drop
    sunk, bent = _under_a_roof(who, seat)
    height -= sunk
    whole = 1.15 * math.sqrt(k)
    if (who.position - before).length > ASIDE:
        t = _slide(who, t, before, (0, 0.55 * dy, 0.84 * m.hip_height, 24, 0, 0))
    half_way = (0, 0.42 * dy, 0.60 * m.hip_height + 0.40 * height, 30, 0, 0)
    who.hips.set(t, 0.5 * whole, half_way, ease=smoothstep)
    who.spine.set(t, 0.5 * whole, (16, 0, 0))
    who.hips.set(t + 0.38 * whole, 0.62 * whole, (0, dy, height, -4, 0, 0))
    hips = who.position - forward * back
    table = find_table_before(stage, who, hips, seat.height)
    who.table = hand_places_on(who, hips, table)
    who.spine.set(t + 0.5 * whole, 0.6 * whole, (seated_bend(who, table) + bent, 0, 0))
    who.pinned.set(t, 0.9 * whole, 1.0)
    who.life.set(t, whole, 0.5)
    who.seated.set(t + 0.25 * whole, 0.70 * whole, 1.0)
    for side in SIDES:
        _seat_foot(who, side, t, whole, height, hips, forward)
        who.home[side] = seated_hand(stage, who, side)
    return_hands(stage, who, t + 0.15 * whole, 0.8 * whole)
    who.posture = "sit"
    return t + 1.1 * whole


def _under_a_roof(who: Performer, seat: Seat) -> tuple[float, float]:
    """Return how a tall person fits under the roof over a seat: metres sunk into it, degrees bent forward."""
    if seat.headroom is None:
        return 0.0, 0.0
    trunk = who.scale * STATURE - who.measures.hip_height
    over = who.measures.seat_drop + trunk + HAT - seat.headroom
    sunk = min(max(over, 0.0), SINKS)
    left = max(over - sunk, 0.0)
    return sunk, math.degrees(math.acos(max(1.0 - left / trunk, 0.5)))


def _slide(who: Performer, t: float, place: Vector, hips: tuple[float, ...]) -> float:
    """Move sideways between chair and table, half up, to ``place`` (x, y); return the end in seconds."""
    k = who.scale
    way = place - who.position
    lead = "R" if way.dot(who.left) < 0 else "L"
    who.hips.set(t, 0.5, hips)
    who.spine.set(t, 0.5, (16, 0, 0))
    who.root.set(t + 0.1, 0.75, (place.x, place.y, who.yaw))
    step_to(who, lead, t + 0.1, 0.36, who.plant(lead, place, who.yaw), 0.04 * k)
    rear = other(lead)
    step_to(who, rear, t + 0.48, 0.36, who.plant(rear, place, who.yaw), 0.04 * k)
    who.position = place
    return t + 0.75


def _seat_foot(who: Performer, side: str, t: float, whole: float, height: float, hips: Vector, forward: Vector) -> None:
    """Place a seated person's foot: hanging from a high seat, stretched out on a low one, else flat on the floor."""
    m, k = who.measures, who.scale
    if height - m.ankle > m.shin + 0.02 * k + 0.05:
        knee = hips + forward * (0.97 * m.thigh - 0.02) + who.left * (sign(side) * 0.09 * k)
        pose = who.plant(side, (0, 0), who.yaw)
        pose[:3], pose[4] = (knee.x, knee.y, height - 0.995 * m.shin), -18
        who.feet[side].set(t + 0.55 * whole, 0.4 * whole, pose)
        return
    if height < FLOOR_SEAT:
        reach = math.sqrt(max(0.01, (0.72 * m.leg) ** 2 - (height - m.ankle) ** 2))
        spot = hips + forward * (reach + m.foot_y)
        step_to(who, side, t + whole * (0.3 if side == "R" else 0.5), 0.4, who.plant(side, spot, who.yaw), 0.05 * k)
        return
    spot = who.position + forward * (0.05 * k)
    pose = who.plant(side, spot, who.yaw, width=1.05, splay=9)
    step_to(who, side, t + whole * (0.62 if side == "R" else 0.80), 0.3, pose, 0.02 * k)


@clip("rise", "body", "hands")
def rise(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Stand up from any posture. Return the end in seconds."""
    return stand_up(stage, who, cue.start)


def stand_up(stage: MotionStage, who: Performer, t: float) -> float:
    """Stand up from the planned posture from ``t`` seconds on; return the end, ``t`` itself for a standing person."""
    if who.posture == "stand":
        return t
    if who.posture in ("lie", "asleep"):
        t = _sit_up(stage, who, t)
    if who.posture == "sit":
        seat = stage.find_seat(who.support, _here(who)) if who.support else None
        return _leave_seat(stage, who, t, stage.seat_access(who, seat) if seat else who.position)
    return _straighten(stage, who, t)


def _leave_seat(stage: MotionStage, who: Performer, t: float, place: Vector) -> float:
    """Stand up in front of the seat, or beside it at ``place`` if there is no room; return the end in seconds."""
    k = who.scale
    whole = 1.1 * math.sqrt(k)
    now = who.hips(t)
    if (who.position - place).length > ASIDE:
        t = _slide(who, t, place, (0, 0.75 * now[1], 0.80 * who.standing_height, 24, 0, 0))
        now = who.hips(t)
    x, y = who.position
    for side in SIDES:
        pose = who.plant(side, (x, y), who.yaw, back=0.04 * k)
        step_to(who, side, t + (0 if side == "L" else 0.12), 0.25, pose, 0.015 * k)
    who.spine.set(t, 0.4 * whole, (22, 0, 0))
    who.hips.set(t, 0.4 * whole, (0, 0.85 * now[1], now[2] + 0.01, 26, 0, 0))
    who.hips.set(t + 0.36 * whole, 0.64 * whole, (0, 0, who.standing_height, 0, 0, 0))
    who.spine.set(t + 0.45 * whole, 0.6 * whole, (0, 0, 0))
    who.seated.set(t + 0.1 * whole, 0.6 * whole, 0.0)
    _release(stage, who, t, whole)
    end = t + whole + 0.1
    for index, side in enumerate(SIDES):
        step_to(who, side, end - 0.1 + 0.3 * index, 0.28, who.plant(side, (x, y), who.yaw), 0.02 * k)
    return end + 0.5


def _straighten(stage: MotionStage, who: Performer, t: float) -> float:
    """Stand up from kneeling, crouching, leaning or all fours, or get down from hanging or riding; return the end."""
    k, x, y = who.scale, *who.position
    whole = 0.9 * math.sqrt(k)
    low = who.hips(t)[2] < 0.75 * who.standing_height
    if who.posture in OFF_THE_FLOOR:
        who.level.set(t, 0.6 * whole, 0.0)
        who.seated.set(t, 0.6 * whole, 0.0)
        who.nod.set(t, whole, (0, 0, 0))
        who.ground = 0.0
    if low:
        who.spine.set(t, 0.4 * whole, (18, 0, 0))
    for index, side in enumerate(SIDES):
        step_to(who, side, t + 0.35 * whole * index + 0.1, 0.45 * whole, who.plant(side, (x, y), who.yaw), 0.03 * k)
    who.hips.set(t + 0.15 * whole, 0.85 * whole, (0, 0, who.standing_height, 0, 0, 0))
    who.spine.set(t + 0.4 * whole, 0.7 * whole, (0, 0, 0))
    _release(stage, who, t, whole)
    return t + 1.15 * whole


def _release(stage: MotionStage, who: Performer, t: float, whole: float) -> None:
    """Return pelvis, sway, trunk and hands to standing, over ``whole`` seconds."""
    who.pinned.set(t + 0.5 * whole, 0.4 * whole, 0.0)
    who.life.set(t + whole, 0.5, 1.0)
    who.lean_after.set(t + whole, 0, 1.0)
    who.table = {}
    for side in SIDES:
        who.home[side] = idle_hand(who, side)
    return_hands(stage, who, t + 0.3 * whole, 0.7 * whole)
    who.posture, who.support = "stand", ""


def _sit_up(stage: MotionStage, who: Performer, t: float) -> float:
    """Sit up from lying: on a bed to its edge, on the floor to a crouch; return the end in seconds."""
    k = who.scale
    whole = 1.6 * math.sqrt(k)
    seat = who.bedside if isinstance(who.bedside, Seat) else None
    who.look_freely(t + 0.3)
    if seat is None:
        x, y = who.position
        who.hips.set(t, 0.5 * whole, (0, 0.10 * k, 0.20 * k, -20, 0, 0))
        who.spine.set(t, 0.5 * whole, (24, 0, 0))
        who.hips.set(t + 0.45 * whole, 0.5 * whole, (0, 0, 0.45 * who.measures.leg, 12, 0, 0))
        for index, side in enumerate(SIDES):
            pose = who.plant(side, (x, y), who.yaw, width=1.3, back=-0.12 * k)
            step_to(who, side, t + 0.3 * whole + 0.15 * index, 0.45 * whole, pose, 0.08 * k)
        who.posture = "crouch"
        return t + whole
    before = feet_before_seat(who, seat)
    back = min(0.80 * who.measures.thigh, 0.5 * seat.depth) - (seat.edge - before).dot(_forward(seat.yaw))
    turn = shortest_turn(who.yaw, seat.yaw)
    who.root.set(t + 0.3 * whole, 0.6 * whole, (before.x, before.y, who.yaw + turn))
    who.hips.set(t, 0.5 * whole, (0, -who.measures.hip_y, seat.height + who.measures.seat_drop, -25, 0, 0))
    who.spine.set(t, 0.5 * whole, (22, 0, 0))
    who.hips.set(
        t + 0.4 * whole, 0.5 * whole, (0, back - who.measures.hip_y, seat.height + who.measures.seat_drop, -4, 0, 0)
    )
    who.spine.set(t + 0.6 * whole, 0.4 * whole, (6, 0, 0))
    for index, side in enumerate(SIDES):
        raised = np.array(who.feet[side](t), float)
        middle = who.plant(side, before, seat.yaw)
        middle[:2] = 0.5 * (raised[:2] + middle[:2])
        middle[2], middle[8] = seat.height + 0.18 * k, 0.8
        who.feet[side].set(t + 0.2 * whole + 0.08 * index, 0.4 * whole, middle)
        landed = who.plant(side, before, seat.yaw)
        who.feet[side].set(t + 0.5 * whole + 0.08 * index, 0.4 * whole, landed)
        who.home[side] = on_thigh(who, side)
    return_hands(stage, who, t + 0.5 * whole, 0.5 * whole)
    who.position, who.yaw, who.posture = before, who.yaw + turn, "sit"
    return t + whole


def _here(who: Performer) -> Mark:
    """Return a mark at the person's planned position."""
    return Mark(asset_id=who.asset_id, location=(who.position.x, who.position.y, 0.0), yaw=math.degrees(who.yaw))


def _forward(yaw: float) -> Vector:
    """Return the unit vector (x, y) of a yaw in radians."""
    return Vector((math.sin(yaw), -math.cos(yaw)))
