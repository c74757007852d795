"""Hands and props: holding, picking up, putting down, dropping."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Channel, Floats, TargetOf, clamp
from storyblender.blender.motion.clips.gaze import look_at
from storyblender.blender.motion.clips.locomotion import travel, turn_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.motion_stage import PADDING, MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.plan import StageFurniture
from storyblender.blender.motion.skeleton import SIDES, facing_yaw, other, sign
from storyblender.blender.motion.staged_props import (
    SETTLE,
    Grip,
    StagedProp,
    carrying_hand,
    gripping_hand,
    upright_matrix,
)
from storyblender.geometry.paths import clearance

ARM_AND_LEAN = 1.45
"""Arm lengths on the floor within reach of a standing person who leans."""
REACH_OF_HAND = 0.4
"""Share of the hand that adds to the arm's length, because the palm reaches the place, not the wrist."""
LEAF, PALM = 0.03, 0.018
"""Metres: largest thickness of papers and booklets; distance from the middle of a palm to what it holds."""
KNEE = 0.35
"""Metres; a person squats deeply for what is lower."""
TURN_IN_HAND = 0.6
"""Seconds in which a prop taken from behind turns to how it is carried."""


def prop_of(cue: StagedCue) -> StagedProp | None:
    """Return the prop that a cue handles, or None."""
    return cue.prop or (cue.target if isinstance(cue.target, StagedProp) else None)


def approach(stage: MotionStage, who: Performer, cue: StagedCue, place: Vector, reach: float) -> float:
    """Walk to within reach of a point and face it; return the second of arrival.

    Seated, kneeling and lying people stay.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives the start and, if it has one, the duration of the walk; a failure is reported on it.
        place: World point, metres.
        reach: Metres on the floor.
    """
    toward = place.xy - who.position
    if who.posture in ("sit", "lie", "asleep", "kneel"):
        return cue.start
    if toward.length > reach:
        spot = _standing_spot(stage, who, place, 0.8 * reach)
        if spot is None:
            stage.report("unreachable", who, cue, f"{who.asset_id} finds no place to stand", toward.length - reach)
            return cue.start
        yaw = math.atan2(place.x - spot.x, -(place.y - spot.y))
        return travel(stage, who, cue, (spot.x, spot.y), yaw)
    aside = abs((facing_yaw(toward) - who.yaw + math.pi) % (2 * math.pi) - math.pi)
    if toward.length > 0.2 and aside > math.radians(60):
        return turn_to(who, cue.start, facing_yaw(toward))
    return cue.start


def _standing_spot(stage: MotionStage, who: Performer, place: Vector, reach: float) -> Vector | None:
    """Return the free position (x, y) around a point that is nearest to the person; None if there is none."""
    around = [
        place.xy + Vector((math.sin(a), math.cos(a))) * r
        for r in (0.75 * reach, 0.9 * reach, 1.05 * reach, 1.2 * reach)
        for a in np.linspace(0, 2 * math.pi, 16, endpoint=False)
    ]
    free = clearance(np.array(around), stage.footprints(who)) > who.measures.radius + 0.5 * PADDING
    spots = [spot for spot, is_free in zip(around, free, strict=True) if is_free]
    spots.sort(key=lambda spot: (spot - who.position).length)
    return next((s for s in spots if stage.path_to(who, (s.x, s.y)) is not None), None)


def take_in_hand(
    stage: MotionStage, who: Performer, side: str, prop: StagedProp, t: float, settle: float = SETTLE
) -> None:
    """Let a prop follow a hand, and note the person as its holder.

    Args:
        stage: The stage of the shot.
        who: The person.
        side: ``L`` or ``R``.
        prop: What they hold from then on; a two-handed one takes both hands.
        t: Second at which it begins to follow the hand.
        settle: Seconds of blending from its former movement.
    """
    release_prop(stage, prop)
    prop.hold(t, who, side, prop.grip(side), settle)
    for hand in SIDES if prop.two_handed else (side,):
        who.held[hand] = prop.asset_id


def release_prop(stage: MotionStage, prop: StagedProp) -> None:
    """Note that the prop is no longer held."""
    for person in stage.people.values():
        person.held = {side: held for side, held in person.held.items() if held != prop.asset_id}


def bend_to_reach(who: Performer, t: float, duration: float, place: Vector) -> float:
    """Bend a standing person to reach a low or far point; return the depth 0..1, 0 if not needed.

    Args:
        who: The person.
        t: Second at which they begin to bend.
        duration: Seconds.
        place: World point, metres.
    """
    m, k = who.measures, who.scale
    if who.posture != "stand":
        return 0.0
    low = clamp((m.shoulder_height - place.z - 0.80 * m.arm) / (0.55 * k))
    sink, bend = _squat(who, place.z, low)
    away = (place.xy - who.position).length - 0.10 * k

    def falls_short(depth: float) -> bool:
        """Return whether the point is out of reach at a share of the full bend."""
        ahead, height = _shoulders(who, sink, bend * depth)
        return math.hypot(away - 0.10 * k * (1 - depth) - ahead, place.z - height) > m.arm + REACH_OF_HAND * m.hand

    depth = low
    while depth < 1 and falls_short(depth):
        depth = min(1.0, depth + 0.05)
    if depth <= 0:
        return 0.0
    hips = (bend - 25) * depth
    who.hips.set(t, duration, (0, 0.10 * k * depth, who.standing_height - sink, hips, 0, 0))
    who.spine.set(t, duration, (42 * depth, 0, 0))
    return depth


def _squat(who: Performer, height: float, low: float) -> tuple[float, float]:
    """Return metres the hips sink and degrees the trunk bends to reach ``height``; ``low`` is the depth, 0..1."""
    floor = clamp(1 - height / KNEE)
    return (0.42 + 0.26 * floor) * who.measures.hip_height * low * low, 47 + 28 * floor


def _shoulders(who: Performer, sink: float, bend: float) -> tuple[float, float]:
    """Return how far ahead of the feet and how high the shoulders are (metres) after sinking and bending."""
    trunk, angle = who.measures.shoulder_height - who.measures.hip_height, math.radians(bend)
    return trunk * math.sin(angle) - 0.10 * who.scale, who.measures.hip_height - sink + trunk * math.cos(angle)


def near_grip(who: Performer, prop: StagedProp, side: str) -> Grip:
    """Return the grip of a hand on a prop that lies there, approached from the person's side.

    Args:
        who: The person.
        prop: What they reach for.
        side: ``L`` or ``R``.
    """
    grip = grip_from_above(prop, prop.grip(side))
    ahead = Vector((*(prop.matrix.translation.xy - who.position), 0.0))
    turned = prop.matrix.to_3x3() @ grip.fingers
    if turned.dot(ahead) >= 0:
        return grip
    return prop.grip(other(side)).opposite() if prop.two_handed else grip.opposite()


def grip_from_above(prop: StagedProp, grip: Grip) -> Grip:
    """Return the grip on a prop that lies down: papers are taken from above, not with a palm below them."""
    if prop.size.z > LEAF or grip.normal.z < 0.7:
        return grip
    x, y, _ = grip.palm
    palm = Vector((0.4 * x, y, prop.size.z + PALM))
    return Grip(palm, Vector((grip.fingers.x, grip.fingers.y, -0.15)), Vector((0, 0, -1)), (22, 28, 14))


def straighten_up(who: Performer, t: float, duration: float) -> None:
    """Stand straight again after ``bend_to_reach``, from ``t`` seconds on in ``duration`` seconds."""
    who.hips.set(t, duration, (0, 0, who.standing_height, 0, 0, 0))
    who.spine.set(t, duration, (0, 0, 0))


@clip("hold", "hand")
def hold(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Hold the prop; pick it up first if it is within reach. Return the end in seconds."""
    prop = prop_of(cue)
    if prop is None:
        return cue.start
    if prop.holder is who:
        return cue.start + (cue.duration or 0.5)
    if cue.start >= 0 and (prop.matrix.translation.xy - who.position).length < 1.2 * who.scale:
        return pick_up(stage, who, cue)
    take_in_hand(stage, who, cue.side, prop, cue.start)
    for side in SIDES if prop.two_handed else (cue.side,):
        who.hands[side].set(cue.start, 0.4, carrying_hand(who, side, prop))
    return cue.start + 0.4


@clip("pick_up", "body", "hand", "head")
def pick_up(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Reach for the prop with an open hand, close it, lift it to where it is carried. Return the end in seconds."""
    prop = prop_of(cue)
    if prop is None or prop.holder is who:
        return cue.start
    place = prop.matrix.translation
    t = approach(stage, who, cue, place, ARM_AND_LEAN * who.measures.arm)
    look_at(who, t, stage.look_point(prop))
    whole = 0.8
    sides = SIDES if prop.two_handed else (cue.side,)
    grips = {side: near_grip(who, prop, side) for side in sides}
    bent = bend_to_reach(who, t, whole, prop.matrix @ grips[sides[0]].palm)
    contact = t + 0.1 + whole + 0.3 * bent
    for side, grip in grips.items():
        hover = gripping_hand(who, side, prop, grip, opening=0.3, lift=0.06 * who.scale)
        who.hands[side].set(t + 0.1, 0.75 * (contact - t), hover)
        who.hands[side].set(contact - 0.35, 0.33, gripping_hand(who, side, prop, grip, opening=0.5))
        who.hands[side].set(contact, 0.15, gripping_hand(who, side, prop, grip))
        stage.following_hands.append((who, side, t, contact + 0.16))
        stage.expect_contact(who, side, contact + 0.1, cue)
    turned = grips[sides[0]] != prop.grip(sides[0])
    take_in_hand(stage, who, cue.side, prop, contact + 0.15, TURN_IN_HAND if turned else SETTLE)
    for side in sides:
        who.hands[side].set(contact + 0.16, whole, carrying_hand(who, side, prop))
    if bent:
        straighten_up(who, contact + 0.16, whole)
    look_at(who, contact + 0.5, who.ahead)
    return contact + 0.16 + whole


@clip("put_down", "body", "hand", "head")
def put_down(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Put the held prop down at the mark, else on the target's top, else on the floor. Return the end in seconds."""
    prop = prop_of(cue)
    side = who.hand_holding(prop.asset_id) if prop is not None else None
    if prop is None or side is None:
        return cue.start
    matrix = _resting_place(stage, who, cue, prop)
    t = approach(stage, who, cue, matrix.translation, ARM_AND_LEAN * who.measures.arm)
    look_at(who, t, tuple(matrix.translation))
    sides = SIDES if prop.two_handed else (side,)
    whole = 0.8
    grips = {hand: grip_from_above(prop, prop.grip(hand)) for hand in sides}
    bent = bend_to_reach(who, t, whole, matrix @ grips[side].palm)
    down = t + whole + 0.3 * bent
    release_prop(stage, prop)
    if grips[side] != prop.grip(side):
        prop.hold(t, who, side, grips[side], 0.7 * (down - t))
    for hand, grip in grips.items():
        put = _placing(who, grip, hand, matrix)
        who.hands[hand].set(t, down - t, put, bump=(0, 0, 0.05 * who.scale))
        who.hands[hand].set(down + 0.05, 0.2, _placing(who, grip, hand, matrix, opening=0.3, lift=0.03 * who.scale))
        who.hands[hand].set(down + 0.2, 0.7, who.home[hand])
        stage.expect_contact(who, hand, down, cue)
    prop.stand(down + 0.04, matrix)
    if bent:
        straighten_up(who, down + 0.2, 0.7)
    look_at(who, down + 0.2, who.ahead)
    return down + 0.9


def _placing(
    who: Performer, grip: Grip, side: str, matrix: Matrix, opening: float = 1.0, lift: float = 0.0
) -> TargetOf:
    """Return the target of a hand that puts a prop down at ``matrix``, fingers opened and palm lifted."""

    def target(t: float) -> Floats:
        values = grip.hand_target(matrix, who.facing @ Vector((sign(side) * 0.5, 0.4, -0.85)))
        values[2] += lift
        values[12:15] *= opening
        return values

    return target


def _resting_place(stage: MotionStage, who: Performer, cue: StagedCue, prop: StagedProp) -> Matrix:
    """Return the world matrix at which a prop is put down."""
    if cue.mark is not None:
        return upright_matrix(Vector(cue.mark.location), math.radians(cue.mark.yaw))
    ahead = who.position + who.forward * (0.42 * who.scale)
    if isinstance(cue.target, StageFurniture):
        top = stage.find_anchor(cue.target, ("top",), None)
        world = Matrix(cue.target.world.tolist())
        local = Vector(top.location) if top else Vector((0, 0, cue.target.dimensions[2]))
        half = [max(0.0, (top.size[i] if top else cue.target.dimensions[i]) / 2 - 0.12) for i in (0, 1)]
        wish = world.inverted() @ Vector((*ahead, 0))
        for axis in (0, 1):
            local[axis] += max(-half[axis], min(half[axis], wish[axis] - local[axis]))
        return upright_matrix(world @ local, who.yaw)
    return upright_matrix(Vector((*ahead, 0)), who.yaw)


@clip("drop", "hand")
def drop(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Let the held prop fall to the floor. Return the end in seconds."""
    prop = prop_of(cue)
    side = who.hand_holding(prop.asset_id) if prop is not None else None
    if prop is None or side is None:
        return cue.start
    landing = Vector((*(who.position + who.forward * 0.35), 0.0))
    fall = Flight(prop, cue.start + 0.15, lambda: landing, 0.0, 0.45)
    release_prop(stage, prop)
    prop.holder = None
    prop.follow(cue.start + 0.15, fall, 0.0)
    who.hands[side].set(cue.start, 0.2, _opened(who.hands[side]))
    who.hands[side].set(cue.start + 0.4, 0.6, who.home[side])
    return cue.start + 1.0


class Flight:
    """A prop in the air, on a parabola from where it is when released; a function from seconds to its world matrix.

    Args:
        prop: The prop.
        start: Second at which it is released.
        goal: Returns the world point where it lands, in the current pose.
        height: Metres of the arc above the straight line.
        seconds: Duration of the flight.
    """

    def __init__(
        self, prop: StagedProp, start: float, goal: Callable[[], Vector], height: float, seconds: float
    ) -> None:
        self.prop, self.start, self.goal, self.height, self.seconds = prop, start, goal, height, seconds
        self.origin: Matrix | None = None

    @property
    def end(self) -> float:
        """Second at which it lands."""
        return self.start + self.seconds

    def __call__(self, t: float) -> Matrix:
        """Return the world matrix at ``t`` seconds."""
        if self.origin is None or t <= self.start:
            self.origin = self.prop.matrix.copy()
        w = clamp((t - self.start) / self.seconds)
        start, landing = self.origin.translation, self.goal()
        place = start.lerp(landing, w)
        if landing.z < 0.1:
            place.z = start.z + (landing.z - start.z) * w * w
        place.z += 4 * self.height * w * (1 - w)
        return upright_matrix(place, self.origin.to_euler().z + 2.5 * w * (self.height > 0))


def _opened(channel: Channel) -> TargetOf:
    """Return the present target of a hand with its fingers open."""
    before = Channel(channel.keys[-1].target)

    def target(t: float) -> Floats:
        values = np.array(before(t), float)
        values[12:15] = (4, 6, -10)
        return values

    return target
