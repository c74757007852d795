"""Taking props out of bags, boxes and clothes."""

from __future__ import annotations

import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import LONG_AGO, Floats, TargetOf
from storyblender.blender.motion.clips.gaze import look_at
from storyblender.blender.motion.clips.handling import bend_to_reach, straighten_up, take_in_hand
from storyblender.blender.motion.hands import Triple, by_chest, chest_yaw, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import UP, other, rigid_matrix, sign
from storyblender.blender.motion.staged_props import StagedProp, carrying_hand

ChestPose = tuple[Triple, Triple, Triple]
"""Palm from the shoulder in arm lengths, finger direction, palm normal: (outwards, forwards, up) each."""
_BREAST: tuple[ChestPose, ChestPose, ChestPose] = (
    ((-0.22, 0.36, -0.30), (-0.9, 0.2, 0.1), (-0.2, -1, 0)),
    ((-0.42, 0.23, -0.28), (-0.95, -0.15, -0.1), (-0.1, -1, 0)),
    ((-0.05, 0.50, -0.32), (-0.7, 0.7, 0.1), (-0.7, -0.7, 0)),
)
_HIP: tuple[ChestPose, ChestPose, ChestPose] = (
    ((0.20, -0.10, -0.80), (-0.2, -0.3, -0.9), (-1, 0.1, 0)),
    ((0.06, -0.24, -0.86), (-0.5, -0.3, -0.8), (-0.7, 0.7, 0)),
    ((0.24, 0.12, -0.72), (0, 0.4, -0.9), (-1, 0, 0)),
)
"""Three poses of the hand: before the place, in it, and out of it again."""
RAISED = 0.26
"""Metres, times the scale, of a raised bag's opening below the breast."""


def open_held_bag(stage: MotionStage, who: Performer, cue: StagedCue, bag: StagedProp) -> float:
    """Hold a bag in front and open it with the other hand; return the end in seconds.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives the start.
        bag: The bag, in one of their hands.
    """
    t, side = cue.start, _holding(who, bag)
    free = other(side)
    _raise(stage, who, side, bag, t)
    if free not in who.held:
        who.hands[free].set(t + 0.35, 0.5, _at_opening(who, free, bag, 0.02))
        who.hands[free].set(t + 0.95, 0.6, _at_opening(who, free, bag, 0.14))
        who.hands[free].set(t + 1.8, 0.6, who.home[free])
    return _lower(who, side, bag, t + 1.7)


def take_from_bag(stage: MotionStage, who: Performer, cue: StagedCue, prop: StagedProp, bag: StagedProp) -> float:
    """Take a prop, hidden until then, out of a held bag or a standing box; return the end in seconds.

    Without a free hand nothing happens, and the stage reports it.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives the start, and the hand for a box that stands.
        prop: What they take out.
        bag: The bag or box, in their hand or standing.
    """
    t, side, held = cue.start, _holding(who, bag), bag.holder is who
    free = other(side) if held else cue.side
    if free in who.held:
        stage.report("unreachable", who, cue, f"{who.asset_id} has no free hand for {prop.asset_id}")
        return t
    prop.follow(0.1 * LONG_AGO, lambda _: bag.matrix @ Matrix.Translation((0, 0, 0.2 * bag.size.z)), 0.0)
    bent = 0.0 if held else bend_to_reach(who, t, 0.6, bag.matrix @ Vector((0, 0, bag.size.z)))
    if held:
        _raise(stage, who, side, bag, t)
    else:
        look_at(who, t, stage.look_point(bag))
    who.hands[free].set(t + 0.2, 0.5, _at_opening(who, free, bag, 0.08))
    who.hands[free].set(t + 0.7, 0.3, _at_opening(who, free, bag, -0.10))
    stage.expect_contact(who, free, t + 1.0, cue)
    take_in_hand(stage, who, free, prop, t + 1.05, 0.2)
    who.hands[free].set(t + 1.1, 0.35, _at_opening(who, free, bag, 0.14))
    who.hands[free].set(t + 1.5, 0.6, carrying_hand(who, free, prop))
    if bent:
        straighten_up(who, t + 1.3, 0.7)
    return _lower(who, side, bag, t + 1.7) if held else t + 2.2


def draw_from_clothes(stage: MotionStage, who: Performer, cue: StagedCue, prop: StagedProp) -> float:
    """Take a prop, hidden until then, out of a jacket's breast, else from behind the hip; return the end in seconds.

    Args:
        stage: The stage of the shot.
        who: The person.
        cue: Gives the start and the hand.
        prop: What they take out.
    """
    t, side = cue.start, cue.side
    breast = stage.plan.people[who.asset_id].jacket
    bone, ways = ("upper_chest", _BREAST) if breast else ("hips", _HIP)

    def hidden(now: float) -> Matrix:
        matrix = who.facing.to_4x4() @ _on_edge(prop)
        matrix.translation = who.point(bone) - matrix.to_3x3() @ Vector((0, 0, 0.5 * prop.size.z))
        return matrix

    prop.follow(0.1 * LONG_AGO, hidden, 0.0)
    before, inside, out = (by_chest(who, side, *way, curl=(30, 34, 12)) for way in ways)
    who.hands[side].set(t, 0.5, before)
    who.hands[side].set(t + 0.5, 0.3, inside)
    if breast:
        look_at(who, t + 0.3, lambda now: tuple(who.point("upper_chest", (0, -0.3, 0))))
    take_in_hand(stage, who, side, prop, t + 1.0, 0.15)
    who.hands[side].set(t + 1.0, 0.45, out)
    who.hands[side].set(t + 1.45, 0.6, carrying_hand(who, side, prop))
    look_at(who, t + 1.3, who.ahead)
    return t + 2.1


def _on_edge(prop: StagedProp) -> Matrix:
    """Return the rotation that puts the longest side of a prop upright and the shortest to the front."""
    thin, _, long = sorted(range(3), key=lambda axis: prop.size[axis])
    up, ahead = Vector(np.eye(3)[long]), Vector(np.eye(3)[thin])
    return Matrix((up.cross(ahead), ahead, up)).to_4x4()


def _holding(who: Performer, bag: StagedProp) -> str:
    """Return the hand that holds a bag; ``R`` if none does."""
    return next((side for side, held in who.held.items() if held == bag.asset_id), "R")


def _raise(stage: MotionStage, who: Performer, side: str, bag: StagedProp, t: float) -> None:
    """Hold a bag up in front and look at it."""
    grip = bag.grip(side)

    def before_one(now: float) -> Floats:
        turn = who.facing @ Matrix.Rotation(chest_yaw(who), 3, "Z")
        ahead = who.measures.front + 0.5 * bag.size.y + 0.14 * who.scale
        opening = who.point("upper_chest") + turn @ Vector((0, -ahead, -RAISED * who.scale))
        return grip.hand_target(
            rigid_matrix(turn, opening - UP * bag.size.z), turn @ Vector((sign(side) * 0.8, 0.5, -0.5))
        )

    who.hands[side].set(t, 0.6, before_one)
    look_at(who, t, stage.look_point(bag))


def _lower(who: Performer, side: str, bag: StagedProp, t: float) -> float:
    """Lower a bag again and look ahead; return the end in seconds."""
    who.hands[side].set(t, 0.7, carrying_hand(who, side, bag))
    look_at(who, t + 0.2, who.ahead)
    return t + 0.6


def _at_opening(who: Performer, side: str, bag: StagedProp, above: float) -> TargetOf:
    """Return the target of a hand ``above`` metres over the opening of a bag, fingers down."""
    s, k = sign(side), who.scale

    def target(now: float) -> Floats:
        turn = bag.matrix.to_3x3()
        spot = bag.matrix @ Vector((s * 0.2 * bag.size.x, 0, bag.size.z + above * k))
        elbow = who.facing @ Vector((s * 0.9, 0.3, 0.1))
        return hand(spot, turn @ Vector((-s * 0.3, -0.2, -1)), turn @ Vector((-s, 0, 0.2)), elbow, (30, 36, 15))

    return target
