"""Leaning on bars and walls."""

from __future__ import annotations

import math

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats
from storyblender.blender.motion.clips.floor import go_to_mark
from storyblender.blender.motion.clips.handling import approach
from storyblender.blender.motion.clips.locomotion import step_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.clips.seat import return_hands
from storyblender.blender.motion.hands import by_chest, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, other, sign


@clip("lean", "body", "hands")
def lean(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Lean on a bar or a rail with both forearms, or with the back against a wall. Return the end in seconds."""
    support = (cue.mark.support_id if cue.mark else None) or getattr(cue.target, "asset_id", None)
    furniture = stage.find_furniture(support)
    anchor = stage.find_anchor(furniture, ("lean",), cue.mark) if furniture is not None else None
    if anchor is None and furniture is not None and 0.8 < furniture.dimensions[2] < 1.35:
        anchor = stage.find_anchor(furniture, ("top",), cue.mark)
    t = go_to_mark(stage, who, cue) if cue.mark is not None or cue.start < 0 else cue.start
    if furniture is None or anchor is None:
        return _lean_back(stage, who, t)
    world = Matrix(furniture.world.tolist())
    height = (world @ Vector(anchor.location)).z
    if cue.mark is None and cue.start >= 0:
        t = approach(stage, who, cue, world @ Vector(anchor.location), 0.5 * who.scale)
    edge = _edge_distance(who, world, furniture.dimensions)
    who.support = support or ""
    return _lean_on(stage, who, t, height, edge, cue.side)


def _edge_distance(who: Performer, world: Matrix, size: tuple[float, float, float]) -> float:
    """Return the metres from a person to the edge of the box ahead."""
    origin = world.inverted() @ Vector((*who.position, 0.5))
    ahead = world.inverted().to_3x3() @ Vector((*who.forward, 0))
    best = 0.35 * who.scale
    for axis in (0, 1):
        if abs(ahead[axis]) > 0.3:
            near = (-math.copysign(size[axis] / 2, ahead[axis]) - origin[axis]) / ahead[axis]
            if 0 < near < 1.2:
                best = near
    return min(best, 0.45 * who.scale)


def _lean_on(stage: MotionStage, who: Performer, t: float, height: float, edge: float, side: str) -> float:
    """Rest the forearms on a top, ``edge`` metres ahead, with the least lean; return the end in seconds."""
    m, k = who.measures, who.scale
    top, torso, whole = height + 0.035 * k, m.shoulder_height - m.hip_height, 0.9
    degrees = 28
    for degrees in range(4, 30, 2):
        above = m.hip_height - 0.05 * k + torso * math.cos(math.radians(0.8 * degrees)) - top
        if 0 < above < 0.97 * m.upper_arm:
            break
    who.hips.set(t, whole, (0, 0.05 * k, m.hip_height - 0.05 * k, 0.4 * degrees, 0, 0))
    who.spine.set(t, whole, (0.65 * degrees, 0, 0))
    who.lean_after.set(t, 0, 0.0)
    who.life.set(t, 0.4, 0.4)
    behind = other(side)
    spot = who.position - who.forward * (0.20 * k)
    step_to(who, behind, t + 0.1, 0.35, who.plant(behind, spot, who.yaw, width=0.5, splay=10))
    for each in SIDES:
        inward = -0.03 * k if each == side else 0.02 * k
        ahead = edge + (0.15 if each == side else 0.18) * k

        def target(now: float, s: int = sign(each), inward: float = inward, ahead: float = ahead) -> Floats:
            palm = who.to_world(Vector((s * inward, -ahead, top - 0.012 * k)))
            turn = who.facing
            return hand(
                palm,
                turn @ Vector((-s * 0.85, -0.35, 0)),
                Vector((0, 0, -1)),
                turn @ Vector((s, 0.25, -0.35)),
                (14, 20, 0),
            )

        who.home[each] = target
    return_hands(stage, who, t + 0.15, whole)
    who.posture = "lean"
    return t + 1.1


def _lean_back(stage: MotionStage, who: Performer, t: float) -> float:
    """Back against a wall: hips forward, one knee bent, arms folded low."""
    k = who.scale
    who.hips.set(t, 0.9, (0, -0.10 * k, who.standing_height - 0.03 * k, -9, 0, 0))
    who.spine.set(t, 0.9, (3, 0, 0))
    spot = who.position + who.forward * (0.12 * k)
    for index, side in enumerate(SIDES):
        pose = who.plant(side, spot, who.yaw, width=0.9 if side == "L" else 0.4, splay=12)
        step_to(who, side, t + 0.1 + 0.25 * index, 0.35, pose)
        low = (-0.30, 0.42, -0.52) if side == "R" else (-0.26, 0.46, -0.46)
        who.home[side] = by_chest(who, side, low, (-1, 0.15, 0.1), (0, -1, 0.2), pole=(0.9, -0.3, -0.6))
    who.lean_after.set(t, 0, 0.0)
    return_hands(stage, who, t + 0.1, 0.9)
    who.posture = "lean"
    return t + 1.1
