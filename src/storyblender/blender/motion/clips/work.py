"""Hands at work on the set: doors, pushing, pressing, typing, playing, wiping, digging."""

from __future__ import annotations

import math
from collections.abc import Callable

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf
from storyblender.blender.motion.clips.containers import open_held_bag
from storyblender.blender.motion.clips.gaze import look_at, look_at_subject
from storyblender.blender.motion.clips.handling import approach, bend_to_reach, prop_of, straighten_up
from storyblender.blender.motion.clips.locomotion import step_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_chest, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageFurniture
from storyblender.blender.motion.skeleton import SIDES, UP, other, rigid_matrix, sign
from storyblender.blender.motion.staged_props import StagedProp, carrying_hand

HAND_IN = 0.25
"""Metres from the side of a thing to the spot on its top that a hand works on."""
WORKING = 1.2
"""Arm lengths on the floor from a person to what their hands work on."""
Offset = Callable[[float], Vector]
"""Seconds -> offset of a hand in the person's frame, metres: left, forwards, up."""


def working_point(stage: MotionStage, who: Performer, cue: StagedCue) -> tuple[Vector, float | None]:
    """Return the world point (metres) that a cue's hand works on, and the height there if it is on a top, else None.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives target, prop and mark; without them it is a point before the person.
    """
    subject = cue.target or cue.prop
    if isinstance(subject, StagedProp) and subject.holder is not who:
        return subject.matrix @ Vector((0, 0, subject.size.z)), None
    if isinstance(subject, StageFurniture):
        world = Matrix(subject.world.tolist())
        anchor = stage.find_anchor(subject, ("handle",), None)
        if anchor is not None:
            return world @ Vector(anchor.location), None
        top, box = stage.find_anchor(subject, ("top",), None), _on_box(who, world, subject)
        spot = _on_top(who, world, Vector(top.location), top.size) if top is not None else box
        within = max(WORKING * who.measures.arm, (box.xy - who.position).length + HAND_IN)  # not a bench inside a boat
        return (spot, spot.z) if top is not None and (spot.xy - who.position).length <= within else (box, None)
    if cue.mark is not None:
        return Vector(cue.mark.location) + UP * (0.62 * who.measures.shoulder_height), None
    return Vector((*(who.position + who.forward * 0.55 * who.scale), 0.72 * who.measures.shoulder_height)), None


def _on_top(who: Performer, world: Matrix, centre: Vector, size: tuple[float, float]) -> Vector:
    """Return the point of a top that is nearest to the person, a hand's breadth in."""
    local = world.inverted() @ Vector((*who.position, 0))
    spot = centre.copy()
    for axis in (0, 1):
        half = max(0.0, size[axis] / 2 - 0.14)
        spot[axis] += max(-half, min(half, local[axis] - centre[axis]))
    return world @ spot


def _on_box(who: Performer, world: Matrix, subject: StageFurniture) -> Vector:
    """Return the point of a box that is nearest to the person, at chest height."""
    local = world.inverted() @ Vector((*who.position, 0))
    width, depth, height = subject.dimensions
    spot = Vector((max(-width / 2, min(width / 2, local.x)), max(-depth / 2, min(depth / 2, local.y)), 0))
    spot.z = min(0.75 * who.measures.shoulder_height, 0.9 * height)
    return world @ spot


def work_with_hand(
    who: Performer,
    side: str,
    t: float,
    end: float,
    place: Vector,
    move: Offset,
    *,
    palm: Vector,
    curl: tuple[float, float, float],
) -> None:
    """Keep a hand at a place with a movement on top, then return it to rest.

    Args:
        who: The person.
        side: ``L`` or ``R``.
        t: Second at which it sets out.
        end: Second at which it returns.
        place: World point.
        move: Offset (left, forwards, up) in metres, by seconds since ``t``.
        palm: Direction out of the palm, in the person's frame.
        curl: Degrees of index finger, other fingers and thumb.
    """

    def target(now: float) -> Floats:
        aside, ahead, up = move(now - t)
        turn = who.facing
        spot = place + turn @ Vector((aside, -ahead, up))
        toward = turn @ Vector((-sign(side) * 0.2, -1, -0.15))
        return hand(spot, toward, turn @ palm, turn @ Vector((sign(side) * 0.7, 0.4, -0.7)), curl)

    who.hands[side].set(t, 0.6, target)
    who.hands[side].set(end - 0.1, 0.7, who.home[side])


def _ease_in(u: float, start: float, length: float) -> float:
    """Return 0..1 eased over ``length`` seconds from ``start`` on."""
    w = min(1.0, max(0.0, (u - start) / length))
    return w * w * (3 - 2 * w)


@clip("open", "body", "hand", "head")
def open_(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Open a door or a lid by its handle; a bag in the hands is opened there. Return the end in seconds."""
    bag = prop_of(cue)
    if bag is not None and bag.holder is who:
        return open_held_bag(stage, who, cue, bag)
    return _handle(stage, who, cue, 0.30)


@clip("close", "body", "hand", "head")
def close(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Push a door or a lid shut. Return the end in seconds."""
    return _handle(stage, who, cue, -0.18)


def _handle(stage: MotionStage, who: Performer, cue: StagedCue, pull: float) -> float:
    """Move the handle of a door or lid by ``pull`` metres towards the person; return the end in seconds."""
    place, surface = working_point(stage, who, cue)
    t = approach(stage, who, cue, place, WORKING * who.measures.arm)
    place, surface = working_point(stage, who, cue)
    curl = (68, 75, 25) if pull > 0 else (12, 14, 0)
    look_at(who, t, tuple(place))
    lift = surface is not None
    if isinstance(cue.target, StageFurniture) and cue.target.asset_id == "door":
        pull = -pull  # doors of sets swing out of the room

    def move(u: float) -> Vector:
        way = pull * _ease_in(u, 0.9, 0.8)
        return Vector((0, 0, abs(way))) if lift else Vector((0.15 * way * sign(cue.side), -way, 0.0))

    bent = bend_to_reach(who, t, 0.6, place)
    end = t + 2.1
    work_with_hand(who, cue.side, t, end, place, move, palm=Vector((0, -0.6, -0.8)), curl=curl)
    stage.expect_contact(who, cue.side, t + 0.75, cue)
    stage.grasps[who.asset_id, cue.frame] = t + 0.9
    who.accent.set(t + 0.9, 0.8, (-4 if pull > 0 else 6, 0, 0))
    who.accent.set(end - 0.2, 0.5, (0, 0, 0))
    if bent:
        straighten_up(who, end - 0.3, 0.7)
    look_at(who, end - 0.2, who.ahead)
    return end + 0.3


@clip("knock", "body", "hand", "head")
def knock(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Knock three times with the knuckles at head height. Return the end in seconds."""
    place, _ = working_point(stage, who, cue)
    t = approach(stage, who, cue, place, WORKING * who.measures.arm)
    place = place + who.facing_at(t) @ Vector((-0.12 * sign(cue.side), 0.06, 0))
    place.z = 0.97 * who.measures.shoulder_height
    look_at(who, t, tuple(place))

    def move(u: float) -> Vector:
        rap = abs(math.sin(math.pi * 2.6 * (u - 0.7))) if 0.7 < u < 1.85 else 0.0
        return Vector((0, -0.09 * rap, 0.0))

    work_with_hand(who, cue.side, t, t + 2.0, place, move, palm=Vector((0, -0.9, -0.3)), curl=(80, 88, 30))
    stage.expect_contact(who, cue.side, t + 0.69, cue)
    return t + 2.5


@clip("press", "body", "hand", "head")
def press(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Press something with the forefinger; a held prop is struck or switched on. Return the end in seconds."""
    held = prop_of(cue)
    if held is not None and held.holder is who:
        return _strike(stage, who, cue, held)
    place, _ = working_point(stage, who, cue)
    t = approach(stage, who, cue, place, WORKING * who.measures.arm)
    look_at(who, t, tuple(place))
    back = 0.085 * who.scale
    bent = bend_to_reach(who, t, 0.6, place)

    def move(u: float) -> Vector:
        return Vector((0, -back + 0.02 * math.sin(math.pi * min(1, max(0, (u - 0.75) / 0.3))), 0.0))

    work_with_hand(who, cue.side, t, t + 1.5, place, move, palm=Vector((0, 0.1, -1)), curl=(4, 80, 25))
    stage.expect_contact(who, cue.side, t + 0.8, cue)
    if bent:
        straighten_up(who, t + 1.4, 0.6)
    return t + 2.0


def _strike(stage: MotionStage, who: Performer, cue: StagedCue, held: StagedProp) -> float:
    """Bring both hands together and flick a held match, lighter or torch; return the end in seconds."""
    t, side = cue.start, who.hand_holding(held.asset_id) or "R"
    grip, free = held.grip(side), other(side)

    def before_one(away: float) -> TargetOf:
        def target(now: float) -> Floats:
            turn, k = who.facing, who.scale
            place = who.point("upper_chest", (sign(side) * (0.05 + away) * k, -0.34 * k, -0.14 * k))
            return grip.hand_target(rigid_matrix(turn, place), turn @ Vector((sign(side) * 0.8, 0.3, -0.6)))

        return target

    who.hands[side].set(t, 0.6, before_one(0.0))
    who.hands[side].set(t + 0.75, 0.16, before_one(0.10))
    who.hands[side].set(t + 1.6, 0.6, carrying_hand(who, side, held))
    if free not in who.held:
        at = (-0.30, 0.46, -0.28)
        who.hands[free].set(t, 0.6, by_chest(who, free, at, (-0.8, 0.5, 0.1), (-0.3, -0.2, 0.9), curl=(45, 60, 20)))
        who.hands[free].set(t + 1.5, 0.6, who.home[free])
    look_at(who, t, stage.look_point(held))
    look_at(who, t + 1.6, who.ahead)
    return t + 2.1


@clip("push", "body", "hands", "head")
def push(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Push a prop or a person with both palms, one foot back. Return the end in seconds."""
    return _shove(stage, who, cue, 1)


@clip("pull", "body", "hands", "head")
def pull(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Pull with both hands, leaning back. Return the end in seconds."""
    return _shove(stage, who, cue, -1)


def _shove(stage: MotionStage, who: Performer, cue: StagedCue, way: int) -> float:
    """Push (``way`` 1) or pull (-1) with both hands; return the end in seconds."""
    k = who.scale
    partner = cue.target if isinstance(cue.target, Performer) else None
    place = partner.point_above_place(0.95) if partner else working_point(stage, who, cue)[0]
    t = approach(stage, who, cue, place, WORKING * who.measures.arm)
    place = partner.point_above_place(0.95) if partner else working_point(stage, who, cue)[0]
    place = place.copy()
    place.z = (
        min(place.z, 0.85 * who.measures.shoulder_height) if not partner else 0.92 * partner.measures.shoulder_height
    )
    look_at_subject(stage, who, t, cue)
    end = t + (cue.duration or 2.4)
    for side in SIDES:
        reach = 0.10 * k * way

        def move(u: float, side: str = side, reach: float = reach) -> Vector:
            return Vector((sign(side) * 0.13 * k, reach * _ease_in(u, 0.6, 0.9), 0))

        palm = Vector((0, -1, 0.1)) if way > 0 else Vector((0, 0.2, -1))
        work_with_hand(who, side, t, end, place, move, palm=palm, curl=(6, 8, 0) if way > 0 else (70, 78, 25))
    lead = other(cue.side)
    back = who.position - who.forward * (0.34 * k)
    step_to(who, lead, t + 0.1, 0.4, who.plant(lead, back, who.yaw, splay=18))
    who.hips.set(t + 0.3, 0.7, (0, -0.05 * k * way, who.standing_height - 0.10 * k, 8 * way, 0, 0))
    who.spine.set(t + 0.3, 0.7, (16 * way, 0, 0))
    who.hips.set(end - 0.2, 0.7, (0, 0, who.standing_height, 0, 0, 0))
    who.spine.set(end - 0.2, 0.7, (0, 0, 0))
    step_to(who, lead, end, 0.4, who.plant(lead, who.position, who.yaw))
    if partner is not None and way > 0:
        partner.accent.set(t + 0.9, 0.25, (-14, 0, 6))
        behind = partner.position - partner.forward * (0.3 * partner.scale)
        step_to(partner, "R", t + 0.95, 0.3, partner.plant("R", behind, partner.yaw))
        partner.accent.set(t + 1.5, 0.6, (0, 0, 0))
        step_to(partner, "R", t + 1.6, 0.4, partner.plant("R", partner.position, partner.yaw))
    return end + 0.5


def _labour(
    stage: MotionStage, who: Performer, cue: StagedCue, move: Callable[[float, str], Vector], sides: str, bend: float
) -> float:
    """Work with the hands of ``sides`` on a surface or prop, the trunk bent by degrees; return the end in seconds.

    ``move`` gives the offset of a hand by seconds and side; see ``work_with_hand``.
    """
    place, _ = working_point(stage, who, cue)
    t = approach(stage, who, cue, place, WORKING * who.measures.arm)
    place, _ = working_point(stage, who, cue)
    end = t + max(1.2, cue.duration or 2.6)
    bent = bend_to_reach(who, t, 0.7, place)
    look_at(who, t, tuple(place))
    who.accent.set(t, 0.6, (bend, 0, 0))
    for side in sides:
        held = stage.props.get(who.held.get(side, ""))
        above = place + UP * (0.035 * who.scale + (0.5 * held.size.z if held else 0.0))
        spread = Vector((sign(side) * (0.10 if len(sides) > 1 else 0.0) * who.scale, 0, 0))
        work_with_hand(
            who, side, t, end, above + who.facing_at(t) @ spread, lambda u, side=side: move(u, side),
            palm=Vector((0, -0.15, -1)), curl=(50, 56, 20) if held else (14, 18, 0),
        )  # fmt: skip
    who.accent.set(end - 0.2, 0.5, (0, 0, 0))
    if bent:
        straighten_up(who, end - 0.2, 0.7)
    return end + 0.5


@clip("wipe", "body", "hand", "head")
def wipe(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Wipe, polish or stir in small circles on a surface. Return the end in seconds."""

    def circle(u: float, side: str) -> Vector:
        return Vector((0.09 * math.cos(5 * u), 0.06 * math.sin(5 * u), 0))

    return _labour(stage, who, cue, circle, cue.side, 6)


@clip("work", "body", "hands", "head")
def work(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Hammer, dig or chop: one hand strikes, the other steadies. Return the end in seconds."""

    def strike(u: float, side: str) -> Vector:
        if side != cue.side:
            return Vector((0, 0, 0))
        return Vector((0, -0.05, 1.0)) * (0.22 * max(0.0, math.sin(2 * math.pi * 1.1 * u)) ** 1.5)

    return _labour(stage, who, cue, strike, cue.side + other(cue.side), 10)


@clip("search", "body", "hands", "head")
def search(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Rummage: both hands move things about. Return the end in seconds."""

    def rummage(u: float, side: str) -> Vector:
        phase = 0.0 if side == "L" else 1.9
        return Vector(
            (0.08 * math.sin(3.1 * u + phase), 0.07 * math.sin(2.3 * u + 2 * phase), 0.04 * math.sin(4 * u) ** 2)
        )

    return _labour(stage, who, cue, rummage, "LR", 10)


@clip("pour", "hand", "head")
def pour(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Tilt a held prop over a place in front, and right it again. Return the end in seconds."""
    t, side, k = cue.start, cue.side, who.scale
    held = stage.props.get(who.held.get(side, ""))
    raised: TargetOf = by_chest(
        who, side, (-0.25, 0.62, -0.30), (-0.9, 0.5, -0.1), (-0.2, 0.4, -0.9), curl=(50, 55, 25)
    )
    if held is not None:
        grip = held.grip(side)

        def tilted(now: float) -> Floats:
            turn = who.facing @ Matrix.Rotation(-sign(side) * math.radians(75), 3, "Y")
            place = who.point("upper_chest") + who.facing @ Vector((sign(side) * 0.10, -0.42, -0.10)) * k
            return grip.hand_target(rigid_matrix(turn, place), who.facing @ Vector((sign(side) * 0.9, 0.1, 0.1)))

        raised = tilted
    who.hands[side].set(t, 0.8, raised)
    look_at(who, t, lambda now: tuple(who.point("upper_chest", (0, -0.5 * k, -0.3 * k))))
    who.hands[side].set(t + 2.0, 0.8, carrying_hand(who, side, held) if held else who.home[side])
    return t + 2.8
