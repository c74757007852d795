"""Down to the floor and onto beds: kneeling, crouching, lying, falling."""

from __future__ import annotations

import math

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf
from storyblender.blender.motion.clips.gaze import look_at, show_expression, show_mood
from storyblender.blender.motion.clips.locomotion import step_to, travel
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.clips.seat import go_to_seat, lower_onto_seat, return_hands, seat_of_cue, stand_up
from storyblender.blender.motion.hands import beside_body, by_chest, hand, on_knee
from storyblender.blender.motion.measures import TUCKED
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, facing_yaw, other, sign
from storyblender.blender.motion.staged_props import upright_matrix
from storyblender.geometry.boxes import shortest_turn


def go_to_mark(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Go to the cue's mark, if it has one; before the shot starts, stand there. Return the second of arrival.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives the mark, the start and, if it has one, the duration of the walk.
    """
    if cue.mark is None:
        return cue.start
    x, y, _ = cue.mark.location
    yaw = math.radians(cue.mark.yaw)
    if cue.start < 0:
        who.place_at_start(x, y, yaw, cue.mark.location[2])
        return cue.start
    return travel(stage, who, cue, (x, y), yaw)


@clip("kneel", "body", "hands")
def kneel(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Kneel on one knee, the other foot flat in front. Return the end in seconds."""
    t = go_to_mark(stage, who, cue)
    m, k = who.measures, who.scale
    knee, front = cue.side, other(cue.side)
    whole = 1.0 * math.sqrt(k)
    forward, left = who.forward, who.left
    spot = who.position + forward * (0.62 * m.shin + 0.06 * k)
    step_to(who, front, t, 0.5 * whole, who.plant(front, spot, who.yaw, width=1.15, splay=6), 0.05 * k)
    down = who.position + left * (sign(knee) * 0.10 * k) + forward * (0.10 * k)
    foot = down - forward * m.kneeling_shin
    pose = who.plant(knee, foot, who.yaw)
    pose[:3], pose[4:6] = (foot.x, foot.y, m.tucked), TUCKED
    who.feet[knee].set(t + 0.40 * whole, 0.6 * whole, pose, bump=(0, 0, 0.03))
    who.hips.set(t + 0.10 * whole, 0.9 * whole, (0, -0.02 * k, m.knee + 0.97 * m.thigh, 4, 0, 0))
    who.pinned.set(t + 0.6 * whole, 0.3 * whole, 1.0)
    who.spine.set(t, 0.6 * whole, (16, 0, 0))
    who.spine.set(t + 0.6 * whole, 0.4, (8, 0, 0))
    who.home[front] = on_knee(who, front)
    return_hands(stage, who, t + 0.3 * whole, 0.7 * whole)
    who.posture = "kneel"
    return t + whole + 0.1


@clip("crouch", "body", "hands")
def crouch(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Squat with knees apart, arms on them. Return the end in seconds."""
    t = go_to_mark(stage, who, cue)
    m, k = who.measures, who.scale
    whole = 0.8 * math.sqrt(k)
    for index, side in enumerate(SIDES):
        behind = 0.16 * k if side == cue.side else -0.04 * k
        pose = who.plant(side, who.position, who.yaw, width=1.35, splay=18, back=behind)
        if side == cue.side:
            pose[:3], pose[4], pose[5] = who.rolled_ankle(side, pose, pose[3], -38), -38, 38
        step_to(who, side, t + 0.15 * index * whole, 0.5 * whole, pose, 0.03 * k)
        who.home[side] = by_chest(
            who, side, (-0.05, 0.75, -0.62), (-0.5, 0.8, -0.3), (-0.3, 0, -1), curl=(22, 30, 0), upright=True
        )
    who.hips.set(t, whole, (0, 0.10 * k, 0.52 * m.leg + m.ankle, 14, 0, 0))
    who.pinned.set(t + 0.6 * whole, 0.3 * whole, 1.0)
    who.spine.set(t, whole, (22, 0, 0))
    who.lean_after.set(t, 0, 0.0)
    return_hands(stage, who, t + 0.2 * whole, 0.8 * whole)
    who.posture = "crouch"
    return t + whole + 0.1


@clip("hide", "body", "hands")
def hide(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Go to cover and crouch there, afraid. Return the end in seconds."""
    show_mood(who, cue.start, "afraid")
    return crouch(stage, who, cue)


@clip("lie_down", "body", "hands")
def lie_down(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Lie down on the bed of the mark, by way of sitting on its edge, or on the floor. Return the end in seconds."""
    support = (cue.mark.support_id if cue.mark else None) or getattr(cue.target, "asset_id", None)
    furniture = stage.find_furniture(support)
    bed = stage.find_anchor(furniture, ("bed",), cue.mark) if furniture is not None else None
    if furniture is None or bed is None:
        return _lie_on_floor(stage, who, cue)
    world = Matrix(furniture.world.tolist())
    feet = (world.to_3x3() @ Vector(bed.direction)).xy.normalized()
    middle = world @ Vector(bed.location)
    seat = seat_of_cue(stage, who, cue)
    t = cue.start
    if seat is not None and who.posture != "sit":
        reached = go_to_seat(stage, who, cue, seat)
        if reached is None:
            return t
        t = lower_onto_seat(stage, who, seat, reached)
    head = middle.xy - feet * (bed.size[1] / 2 - 0.10)
    who.support = support or ""
    who.bedside = seat
    return recline(stage, who, t, head, feet, middle.z)


def _lie_on_floor(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Sit down on the ground and lie back; return the end in seconds."""
    t = go_to_mark(stage, who, cue)
    if t < 0:
        t = min(t, -8.0)
    toward = who.forward
    if who.posture == "stand":
        crouch(stage, who, StagedCue(t, side=cue.side, frame=cue.frame, seed=cue.seed))
        t += 0.8
    tall = who.measures.eye_height - who.measures.hip_height + 0.20 * who.scale
    who.support = ""
    return recline(stage, who, t, who.position - toward * tall, toward, 0.0)


def recline(
    stage: MotionStage, who: Performer, t: float, head: Vector, feet: Vector, height: float, rise: float = 8
) -> float:
    """Swing the legs up and lower the back; return the end in seconds.

    Args:
        stage: The stage.
        who: A person who sits or crouches.
        t: Second at which they begin.
        head: Where the crown of the head goes, on the floor plan.
        feet: Unit vector from head to feet, on the floor plan.
        height: Of the surface, metres.
        rise: Degrees by which the back stays raised, for a pillow.
    """
    m, k = who.measures, who.scale
    whole = 2.2
    yaw = facing_yaw(feet)
    turn = shortest_turn(who.yaw, yaw)
    hips = head + feet * (m.eye_height - m.hip_height + 0.22 * k)
    lying = height + max(0.86 * m.buttocks_back, 0.085 * k)
    who.root.set(t, 0.62 * whole, (hips.x, hips.y, who.yaw + turn))
    who.hips.set(t, 0.45 * whole, (0, -m.hip_y, height + m.seat_drop, -20, 0, 0))
    who.spine.set(t, 0.45 * whole, (10, 0, 0))
    who.hips.set(t + 0.36 * whole, 0.6 * whole, (0, -m.hip_y, lying, -84 + 0.5 * rise, 0, 0))
    who.spine.set(t + 0.4 * whole, 0.6 * whole, (0.5 * rise + 3, 0, 0))
    who.pinned.set(t, 0.3, 1.0)
    who.life.set(t, 0.5, 0.25)
    who.lean_after.set(t, 0, 0.0)

    def over_the_feet(now: float) -> tuple[float, float, float]:
        """Return a world point above the feet to look at."""
        return tuple(who.point("upper_chest", (0, -1.2 * k, 0.75 * k)))

    look_at(who, t + 0.3 * whole, over_the_feet, 0.6)
    who.nod.set(t + 0.5 * whole, 0.6, (12, 0, 0))
    aside = Vector((-feet.y, feet.x))
    for side in SIDES:
        bent = side == "R"
        lead = 0.0 if (turn > 0) == (side == "L") else 0.18
        ankle = hips + feet * (m.leg * (0.80 if bent else 0.985)) + aside * (sign(side) * 0.085 * k)
        pose = who.plant(side, (0, 0), yaw)
        pose[:3] = ankle.x, ankle.y, height + (m.ankle if bent else 0.060 * k)
        pose[4] = 0 if bent else 62
        pose[6:9] = 0.05 * sign(side) * aside.x, 0.05 * sign(side) * aside.y, 1
        start = np.array(who.feet[side](t), float)
        pose[3] = start[3] + turn
        middle = start.copy()
        middle[:2] = start[:2] * 0.55 + np.array(ankle) * 0.45
        middle[2], middle[3], middle[4] = height + 0.26 * k, start[3] + 0.5 * turn, 20
        middle[6:9] = 0.3 * start[6] + 0.5 * feet.x, 0.3 * start[7] + 0.5 * feet.y, 0.9
        who.feet[side].set(t + lead, 0.40 * whole, middle)
        who.feet[side].set(t + lead + 0.30 * whole, 0.42 * whole, pose)
        who.home[side] = beside_body(who, side, height)
        if side not in who.held:
            who.hands[side].set(t + 0.05, 0.5, _propping(who, side, height))
    return_hands(stage, who, t + 0.62 * whole, 0.4 * whole)
    who.position, who.yaw, who.posture = hips, who.yaw + turn, "lie"
    return t + whole + 0.1


def _propping(who: Performer, side: str, height: float) -> TargetOf:
    """Return the target of a hand that props up a reclining person."""
    s, k = sign(side), who.scale

    def target(t: float) -> Floats:
        spot = who.to_world(Vector((s * 0.26 * k, 0.22 * k + who.measures.hip_y, 0)))
        spot.z = height + 0.03
        turn = who.facing
        return hand(
            spot, turn @ Vector((s * 0.4, 0.8, 0)), Vector((0, 0, -1)), turn @ Vector((s * 0.6, 1, 0.2)), (4, 4, 0)
        )

    return target


@clip("sleep", "body", "hands", "head")
def sleep(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Close the eyes, the head sinking; lie down first if there is a bed. Return the end in seconds."""
    t = cue.start
    if who.posture in ("stand", "lean") and (cue.mark is not None or cue.target is not None):
        t = lie_down(stage, who, cue)
    who.look_freely(t)
    show_expression(who, t + 0.1, 0.7, blink=1)
    who.nod.set(t + 0.1, 0.9, (26 if who.posture == "sit" else 8, 8, 14))
    who.life.set(t, 0.5, 0.3)
    return t + 1.0


@clip("wake", "head")
def wake(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Open the eyes and raise the head. Return the end in seconds."""
    t = cue.start
    show_mood(who, t, "tired", 0.35)
    who.nod.set(t + 0.1, 0.5, (-6, 0, 0))
    show_expression(who, t + 0.7, 0.5)
    who.nod.set(t + 0.7, 0.5, (0, 0, 0))
    return t + 1.2


@clip("get_up", "body", "hands")
def get_up(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Get up from bed or floor. Return the end in seconds."""
    return stand_up(stage, who, cue.start)


@clip("fall", "body", "hands", "head")
def fall(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Collapse backwards: knees, body, head. Return the end in seconds."""
    t, m, k = cue.start, who.measures, who.scale
    if t < 0:
        return _lie_on_floor(stage, who, cue)
    x, y = who.position
    show_mood(who, t, "afraid", 0.2)
    who.look_freely(t)
    who.accent.set(t, 0.3, (-8, 6, 10))
    who.hips.set(t, 0.4, (0.05 * k, 0.10 * k, 0.62 * m.hip_height, -4, 4, 0))
    who.hips.set(t + 0.3, 0.42, (0.06 * k, 0.34 * k, 0.20 * k, -34, 0, 0), ease=lambda w: w * w)
    who.hips.set(t + 0.72, 0.4, (0.06 * k, 0.40 * k, 0.115 * k, -80, 6, 0), ease=lambda w: w * (2 - w))
    who.spine.set(t + 0.2, 0.5, (26, 0, 0))
    who.spine.set(t + 0.66, 0.4, (2, 5, 8))
    who.accent.set(t + 0.5, 0.4, (0, 0, 0))
    who.pinned.set(t + 0.2, 0.3, 1.0)
    who.life.set(t, 0.3, 0.0)
    who.lean_after.set(t, 0, 0.0)
    who.nod.set(t, 0.4, (18, 0, 0))
    who.nod.set(t + 1.0, 0.3, (-4, 6, 24))
    for prop in [stage.props[held] for held in who.held.values() if held in stage.props]:
        landing = who.position + who.forward * 0.5
        prop.stand(t + 0.7, upright_matrix(Vector((*landing, 0)), who.yaw))
    who.held = {}
    for side in SIDES:
        pose = who.plant(side, (x, y), who.yaw, width=1.5, splay=20, back=-0.16 * k if side == "L" else 0.02 * k)
        step_to(who, side, t + 0.15, 0.35, pose, 0.02 * k)
        last = pose.copy()
        ahead = who.forward * ((0.52 if side == "L" else 0.24) * k)
        last[:2] += ahead
        last[2], last[4] = (0.07 * k, 58) if side == "L" else (m.ankle, 0)
        last[6:9] = (*(who.forward * 0.4), 1.0)
        who.feet[side].set(t + 0.6, 0.5, last)
        flung = by_chest(
            who, side, (0.55, 0.25, 0.05), (0.9, 0.2, 0.2), (0, 0.6, -0.6), pole=(0.6, -0.8, -0.3), curl=(20, 26, 0)
        )
        who.home[side] = beside_body(who, side, 0.0)
        who.hands[side].set(t + 0.05, 0.45, flung)
        who.hands[side].set(t + 0.7, 0.5, _flung_out(who, side))
    show_expression(who, t + 1.0, 0.4, mouth_open=0.25, blink=1)
    who.posture, who.support = "lie", ""
    return t + 1.4


def _flung_out(who: Performer, side: str) -> TargetOf:
    """Return the target of an arm flung out on the floor."""
    s, k = sign(side), who.scale

    def target(t: float) -> Floats:
        shoulder = who.point(f"upper_arm.{side}")
        out = who.facing @ Vector((s * 0.9, 0.25 if side == "R" else -0.35, 0))
        palm = shoulder + out * (0.92 * who.measures.arm)
        palm.z = 0.04 * k
        return hand(palm, out, Vector((0, 0, 1 if side == "R" else -1)), who.facing @ Vector((0, 1, 0.3)), (28, 34, 5))

    return target
