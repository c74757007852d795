"""Postures without the feet on the floor: hanging, upside down, floating, riding, on all fours."""

from __future__ import annotations

import math

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import LONG_AGO
from storyblender.blender.motion.clips.crawling import CYCLE, DOWN, CrawlPath, get_on_all_fours
from storyblender.blender.motion.clips.floor import go_to_mark
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.clips.seat import return_hands
from storyblender.blender.motion.footsteps import WalkPath
from storyblender.blender.motion.hands import by_chest, fixed_hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageFurniture
from storyblender.blender.motion.skeleton import SIDES, facing_yaw, sign
from storyblender.blender.motion.staged_props import StagedProp

CLEAR = 0.35
"""Default height of the feet above the floor in metres, at a stature of 1.7 m."""
BACK, SADDLE = (0.66, 0.07), (0.82, 0.15)
"""Seat position on a mount without a seat anchor, on an animal's back and behind handlebars: share of its height,
and share of its length behind its centre."""
GRIP = (58.0, 64.0, 24.0)


@clip("hang", "body", "hands")
def hang(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Hang by both hands, feet off the ground. Return the end in seconds."""
    t, k = go_to_mark(stage, who, cue), who.scale
    _raise(who, t, CLEAR)
    _held_up(who, t, "hang")
    who.hips.set(t, 0.6, (0, 0, who.standing_height, 0, 0, 0))
    who.nod.set(t, 0.6, (-12, 0, 0))
    for side, ahead, up in (("L", 0.02, 0.08), ("R", -0.05, 0.03)):
        foot = who.plant(side, who.position + who.forward * (ahead * k), who.yaw, width=0.7)
        foot[2], foot[4] = foot[2] + up * k, -48
        who.feet[side].set(t, 0.6, foot)
        who.home[side] = by_chest(
            who, side, (0.04, 0.10, 0.97), (0, 0.2, 1), (-0.2, 1, 0), pole=(0.6, 0.4, -0.3), curl=GRIP, upright=True
        )
    return_hands(stage, who, t, 0.6)
    return t + 0.7


@clip("upside_down", "body", "hands")
def upside_down(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Hang upside down by the feet, arms dangling. Return the end in seconds."""
    t, m, k = go_to_mark(stage, who, cue), who.measures, who.scale
    height = 1.42 * k
    _held_up(who, t, "upside_down")
    who.hips.set(t, 1.6, (0, 0, height, 0, 180, 0))
    for side in SIDES:
        foot = who.plant(side, who.position, who.yaw, width=0.5)
        foot[2], foot[4], foot[6:9] = height + 1.78 * m.leg, 95, (*who.forward, 0)
        who.feet[side].set(t, 1.6, foot)
        who.home[side] = by_chest(
            who, side, (0.10, 0.12, 0.93), (0, 0.05, 1), (-1, 0, 0), pole=(0.9, -0.4, 0.1), curl=(14, 20, 0)
        )
    return_hands(stage, who, t, 1.6)
    return t + 1.7


@clip("float", "body", "hands")
def float_(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Float with the body tilted forward, legs trailing, arms spread. Return the end in seconds."""
    t, m, k = go_to_mark(stage, who, cue), who.measures, who.scale
    _raise(who, t, CLEAR)
    _held_up(who, t, "float")
    who.hips.set(t, 0.8, (0, 0, who.standing_height, 30, 0, 0))
    who.nod.set(t, 0.8, (-20, 0, 0))
    for side, back, up in (("L", 0.50, 0.20), ("R", 0.36, 0.12)):
        foot = who.plant(side, who.position - who.forward * (back * k), who.yaw, width=1.3)
        foot[2], foot[4] = m.ankle + up * k, -55
        who.feet[side].set(t, 0.8, foot)
        who.home[side] = by_chest(
            who, side, (0.62, 0.42, -0.12), (0.8, 0.5, 0.1), (-0.1, 0, -1), pole=(0.3, -0.5, -0.8), curl=(6, 10, 0)
        )
    return_hands(stage, who, t, 0.8)
    return t + 0.9


@clip("ride", "body", "hands")
def ride(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Ride the mark's support or the target: astride, feet at its sides, hands in front. Return the end in seconds."""
    t, m, k = cue.start, who.measures, who.scale
    mount = stage.find_subject(cue.mark.support_id if cue.mark else None) or cue.target
    height, place, yaw = _saddle(who, mount)
    bars = _handlebars(mount)
    if cue.start < 0:
        who.place_at_start(place.x, place.y, yaw)
    else:
        who.root.set(t, 0.8, (place.x, place.y, yaw))
        who.position, who.yaw = place.copy(), yaw
    who.level.set(t if t >= 0 else LONG_AGO, 0.8, 0.0)
    who.ground = 0.0
    _held_up(who, t, "ride")
    hips = height + 0.75 * m.seat_drop
    who.hips.set(t, 0.8, (0, 0, hips, 6, 0, 0))
    who.seated.set(t, 0.8, 0.6)
    for side in SIDES:
        spot = place + who.forward * (0.16 * k)
        foot = who.plant(side, spot, yaw, width=3.0, splay=14)
        foot[2] = max(m.ankle + 0.10 * k, hips - 0.80 * m.leg)
        who.feet[side].set(t, 0.8, foot)
        who.home[side] = by_chest(
            who,
            side,
            (-0.08, 0.72, -0.52),
            (-0.2, 1, 0),
            (-0.4, 0, -0.9),
            pole=(0.7, -0.1, -0.7),
            curl=GRIP,
            upright=True,
        )
        if side in bars:
            left = Vector((math.cos(yaw), math.sin(yaw), 0)) * sign(side)
            ahead = Vector((*who.forward, 0))
            who.home[side] = fixed_hand(bars[side], ahead, Vector((0, 0, -1)), left * 0.8 - Vector((0, 0, 0.6)), GRIP)
    if bars:
        who.spine.set(t, 0.8, (18, 0, 0))
    return_hands(stage, who, t, 0.8)
    return t + 0.9


@clip("on_all_fours", "body", "hands")
def on_all_fours(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Get down on hands and knees. Return the end in seconds."""
    t = go_to_mark(stage, who, cue)
    x, y = who.position
    ahead = who.position + who.forward * 0.01
    way = WalkPath([(x, y), (ahead.x, ahead.y)])
    get_on_all_fours(who, CrawlPath(way, who.yaw - way.heading(0), t + DOWN, CYCLE), t)
    who.posture = "crawl"
    return t + DOWN


def _saddle(who: Performer, mount: object) -> tuple[float, Vector, float]:
    """Return height, position and yaw of the seat of a mount, in metres and radians; a default without a mount."""
    if not isinstance(mount, StageFurniture | StagedProp):
        return who.ground + 0.55 * who.measures.hip_height, who.position.copy(), who.yaw
    furniture = isinstance(mount, StageFurniture)
    world = Matrix(mount.world.tolist()) if furniture else mount.matrix
    size = mount.dimensions if furniture else tuple(mount.size)
    seat = next((each for each in mount.anchors if each.kind == "seat"), None) if furniture else None
    up, behind = SADDLE if _handlebars(mount) else BACK
    local = Vector(seat.location) if seat is not None else Vector((0, behind * size[1], up * size[2]))
    there = world @ local
    forward = world.to_3x3() @ Vector((0, -1, 0))
    return there.z, there.xy, facing_yaw(forward)


def _handlebars(mount: object) -> dict[str, Vector]:
    """Return the world positions of the handlebar grips by hand; empty without handlebars."""
    if isinstance(mount, StageFurniture):
        world, anchors = Matrix(mount.world.tolist()), [each for each in mount.anchors if each.kind == "grip"]
    elif isinstance(mount, StagedProp):
        world, anchors = mount.matrix, list(mount.anchors.values())
    else:
        return {}
    places = [Vector(each.location) for each in anchors]
    ends = {"L": max(places, key=lambda each: each.x), "R": min(places, key=lambda each: each.x)} if places else {}
    apart = bool(ends) and ends["L"].x - ends["R"].x > 0.25
    return {side: world @ place for side, place in ends.items()} if apart else {}


def _raise(who: Performer, t: float, height: float) -> None:
    """Lift the whole body by ``height`` metres times the scale, unless the mark already gives a height."""
    if who.ground <= 0.05:
        who.ground = height * who.scale
        who.level.set(t if t >= 0 else LONG_AGO, 0.6, who.ground)


def _held_up(who: Performer, t: float, posture: str) -> None:
    """Hold the body up without contact to the floor, and set its posture."""
    who.pinned.set(t, 0.3, 1.0)
    who.life.set(t, 0.3, 0.2)
    who.lean_after.set(t, 0, 0.0)
    who.posture = posture
