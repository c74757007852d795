"""Props in use: drinking, eating, smoking, telephoning, reading."""

from __future__ import annotations

import math

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Channel, Floats
from storyblender.blender.motion.clips.gaze import look_at
from storyblender.blender.motion.clips.handling import pick_up, prop_of, release_prop
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_head, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES, about, rigid_matrix, sign
from storyblender.blender.motion.staged_props import MatrixOf, StagedProp, carrying_hand


@clip("drink", "hand", "head")
def drink(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Bring the held cup to the mouth, tilt it, lower it. Return the end in seconds."""
    return _to_mouth(stage, who, cue, tilt=42, height_share=1.0, hold=1.15)


@clip("eat", "hand", "head")
def eat(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Bring what is held, or the fingers, to the mouth, and chew. Return the end in seconds."""
    end = _to_mouth(stage, who, cue, tilt=8, height_share=0.6, hold=0.5)
    who.speeches.append((end - 0.6, end + 1.4, 0.25, 1.4))
    return end


@clip("smoke", "hand", "head")
def smoke(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Bring a cigarette to the lips and breathe out. Return the end in seconds."""
    return _to_mouth(stage, who, cue, tilt=0, height_share=0.5, hold=0.9)


def _to_mouth(
    stage: MotionStage, who: Performer, cue: StagedCue, tilt: float, height_share: float, hold: float
) -> float:
    """Bring what is held, or the hand, to the mouth for ``hold`` seconds and back; return the end in seconds.

    The prop is tilted by degrees; ``height_share`` is the share of its height that touches the mouth.
    """
    t, side, k = cue.start, cue.side, who.scale
    prop = prop_of(cue)
    if prop is not None and prop.holder is not who:
        t = pick_up(stage, who, cue)
    held = stage.props.get(who.held.get(side, ""))
    if held is None:
        mouth = by_head(
            who, side, (-0.035, 0.105, -0.085), (-0.75, -0.2, 0.5), (-0.1, -1, 0.1), pole=(0.7, 0.1, -0.8),
            curl=(45, 60, 20),
        )  # fmt: skip
        who.hands[side].set(t, 0.7, mouth)
        who.hands[side].set(t + 0.7 + hold, 0.7, who.home[side])
        return t + 1.4 + hold
    grip = held.grip(side)
    tilting = Channel(0.0)
    tilting.set(t + 0.75, 0.4, tilt)
    tilting.set(t + 0.55 + hold, 0.4, 0.0)
    rim = Vector((0, 0, held.size.z * height_share))

    def target(now: float) -> Floats:
        turn = who.facing @ who.bones.orient["head"] @ about("X", -float(tilting(now)))
        jaw = who.point("jaw", (0, -0.118 * k, -0.052 * k))
        matrix = rigid_matrix(turn, jaw - turn @ (rim + Vector((0, -held.size.y * 0.35, 0))))
        return grip.hand_target(matrix, who.facing @ Vector((sign(side) * 0.8, -0.1, -0.6)))

    ahead = Vector((*who.forward, 0)) * (0.08 * k)
    who.hands[side].set(t, 0.8, target, bump=ahead)
    who.nod.set(t + 0.8, 0.4, (-0.33 * tilt, 0, 0))
    who.nod.set(t + 0.6 + hold, 0.4, (0, 0, 0))
    who.hands[side].set(t + 0.9 + hold, 0.8, carrying_hand(who, side, held), bump=ahead)
    return t + 1.7 + hold


@clip("phone", "hand", "head")
def phone(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Hold a telephone, or a hand, to the ear for the cue's duration. Return the end in seconds."""
    t, side = cue.start, cue.side
    prop = prop_of(cue)
    if prop is not None and prop.holder is not who:
        t = pick_up(stage, who, cue)
    end = max(t + 1.4, cue.start + (cue.duration or 2.5))
    ear = by_head(
        who, side, (0.088, -0.045, -0.03), (-0.05, 0.18, 0.95), (-1, 0.1, 0.05), pole=(0.6, 0.25, -1), curl=(62, 72, 25)
    )
    who.hands[side].set(t, 0.7, ear, bump=Vector((*who.forward, 0)) * (0.10 * who.scale))
    held = stage.props.get(who.held.get(side, ""))
    if held is not None:
        held.follow(t + 0.25, _at_ear(who, side, held), 0.45)
    who.nod.set(t + 0.3, 0.4, (4, 5 * sign(side), 0))
    if cue.duration is not None and end < stage.seconds - 0.2:
        who.nod.set(end - 0.6, 0.4, (0, 0, 0))
        home = carrying_hand(who, side, held) if held is not None else who.home[side]
        who.hands[side].set(end - 0.7, 0.7, home)
        if held is not None:
            held.hold(end - 0.5, who, side, held.grip(side), 0.45)
    return end


def _at_ear(who: Performer, side: str, prop: StagedProp) -> MatrixOf:
    """Return the function from seconds to the matrix of a telephone in a hand at the ear."""

    def matrix(t: float) -> Matrix:
        axes, palm = who.hand_matrix(side)
        along, out = Vector(axes.col[0]), Vector(axes.col[1])
        longest = max(range(3), key=lambda i: prop.size[i])
        columns = [Vector((0, 0, 0))] * 3
        columns[longest] = along
        rest = [i for i in range(3) if i != longest]
        columns[rest[0]], columns[rest[1]] = out, along.cross(out)
        turn = Matrix(columns).transposed()
        if turn.determinant() < 0:
            columns[rest[1]] = -columns[rest[1]]
            turn = Matrix(columns).transposed()
        return rigid_matrix(turn, palm + out * 0.02 - turn @ Vector((0, 0, prop.size.z / 2)))

    return matrix


@clip("read", "hands", "head")
def read(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Hold a book or a letter before the chest in both hands and read it. Return the end in seconds."""
    t, k = cue.start, who.scale
    prop = prop_of(cue)
    if prop is not None and prop.holder is not who and (prop.matrix.translation.xy - who.position).length < 1.3:
        t = pick_up(stage, who, cue)
    end = max(t + 1.5, cue.start + (cue.duration or 3.0))
    lying = who.posture in ("lie", "asleep")

    def page(now: float) -> Matrix:
        ahead, up = (-0.36 * k, 0.21 * k) if lying else (-0.34 * k, -0.06 * k)
        place = who.point("upper_chest", (0, ahead, up))
        eyes = who.eyes_point()
        normal = (eyes - place).normalized()
        across = who.direction("upper_chest", Vector((1, 0, 0)))
        across = (across - normal * across.dot(normal)).normalized()
        return rigid_matrix(Matrix((across, normal.cross(across), normal)).transposed(), place)

    width = min(0.16, max(0.05, 0.5 * max(prop.size.x, prop.size.y))) if prop is not None else 0.11
    who.lean_after.set(t - 0.5, 0, 0.0)
    for side in SIDES:
        s = sign(side)

        def target(now: float, s: int = s) -> Floats:
            matrix = page(now)
            turn = matrix.to_3x3()
            return hand(
                matrix @ Vector((s * 0.9 * width, -0.05, -0.03)), turn @ Vector((-s * 0.35, 0.9, 0)),
                turn @ Vector((0, 0, 1)), who.direction("upper_chest", Vector((s * 0.8, 0, -0.7))), (10, 12, -35),
            )  # fmt: skip

        if who.held.get(side, prop.asset_id if prop else None) == (prop.asset_id if prop else None):
            who.hands[side].set(t, 0.9, target)
    if prop is not None:
        release_prop(stage, prop)
        who.held[cue.side] = prop.asset_id
        prop.holder = who
        flat = prop.size.z < 0.5 * min(prop.size.x, prop.size.y)
        prop.follow(t + 0.4, lambda now: page(now) if flat else page(now) @ upright_sheet(prop), 0.5)

    def text(now: float) -> tuple[float, ...]:
        return tuple(page(now).translation)

    look_at(who, t + 0.3, text, 0.5)
    return end


def upright_sheet(prop: StagedProp) -> Matrix:
    """Return the rotation of a prop modelled standing (front -Y) that faces its front out of the page."""
    return Matrix.Rotation(-math.pi / 2, 4, "X") @ Matrix.Translation((0, 0, -prop.size.z / 2))


def table_height(stage: MotionStage, who: Performer) -> float:
    """Return the height of the nearest top before a person, else of the lap, metres."""
    spot = who.position + who.forward * (0.35 * who.scale)
    best, height = 0.9, None
    for furniture in stage.plan.furniture.values():
        for anchor in furniture.anchors:
            if anchor.kind != "top":
                continue
            world = Matrix(furniture.world.tolist()) @ Vector(anchor.location)
            reach = max(0.0, (world.xy - spot).length - 0.5 * max(anchor.size))
            if reach < best and 0.45 < world.z < 1.3:
                best, height = reach, world.z
    if height is not None:
        return height
    return 0.5 * who.scale if who.posture == "sit" else 0.62 * who.measures.shoulder_height


def return_hands(stage: MotionStage, who: Performer, end: float) -> float:
    """Return the hands to rest at ``end``, if the shot goes on after it; return ``end``."""
    if end < stage.seconds - 0.3:
        for side in SIDES:
            held = stage.props.get(who.held.get(side, ""))
            who.hands[side].set(end - 0.1, 0.7, carrying_hand(who, side, held) if held else who.home[side])
        who.accent.set(end, 0.5, (0, 0, 0))
        who.lean_after.set(end + 0.6, 0, 1.0)
    return end
