"""Guns: aiming and firing."""

from __future__ import annotations

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats
from storyblender.blender.motion.clips.gaze import look_at_subject, show_mood
from storyblender.blender.motion.clips.handling import prop_of, take_in_hand
from storyblender.blender.motion.clips.locomotion import step_to, turn_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import UP, facing_yaw, other, sign

LONG_GUN = 0.6
"""Metres; longer guns are shouldered."""


@clip("aim", "body", "hands", "head")
def aim(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Aim a gun at the target with both hands, in a wide stance. Return the end in seconds."""
    t, k, side = cue.start, who.scale, cue.side
    far = other(side)
    prop = prop_of(cue) or stage.props.get(who.held.get(side, ""))
    if prop is not None and prop.holder is not who:
        take_in_hand(stage, who, side, prop, t)
    if cue.target is not None and who.posture == "stand":
        toward = stage.floor_position(cue.target) - who.position
        t = turn_to(who, t, facing_yaw(toward) - sign(side) * 0.12)
    look_at_subject(stage, who, t, cue)
    goal = stage.look_point(cue.target) if cue.target is not None else who.ahead

    def muzzle(now: float) -> Matrix:
        root = who.breast_point() + UP * (0.035 * k)
        along = (Vector(goal(now)) - UP * (0.15 * k) - root).normalized()
        across = UP.cross(along).normalized() * -1
        matrix = Matrix((-across, -along, (-across).cross(-along))).transposed().to_4x4()
        if long:  # the butt at the shoulder
            root = root.lerp(who.point(f"upper_arm.{side}"), 0.7)
        matrix.translation = root + along * ((0.52 if long else 0.94) * who.measures.arm)
        return matrix

    long = prop is not None and prop.size.y > LONG_GUN
    grip = prop.grip(side) if prop is not None else None

    def firing(now: float) -> Floats:
        matrix = muzzle(now)
        pole = who.facing @ Vector((sign(side) * 0.7, 0.1, -0.8))
        if grip is not None:
            matrix = matrix @ Matrix.Translation(-grip.palm)
            return grip.hand_target(matrix, pole)
        turn = matrix.to_3x3()
        along = turn @ Vector((0, -1, 0))
        return hand(matrix.translation, along, turn @ Vector((-sign(side), 0, 0)), pole, (4, 88, 20))

    def steadying(now: float) -> Floats:
        matrix = muzzle(now)
        turn, s = matrix.to_3x3(), sign(far)
        palm = matrix @ (
            Vector((s * 0.02, -0.62 * who.measures.arm, -0.02)) if long else Vector((s * 0.03, 0.02, -0.035))
        )
        fingers, normal = turn @ Vector((-s * 0.5, -1, 0.05)), turn @ Vector((-s, 0.1, 0.35))
        return hand(palm, fingers, normal, who.facing @ Vector((s * 0.7, 0.1, -0.8)), (78, 80, 20))

    ahead = Vector((*who.forward, 0)) * 0.10 + UP * 0.04
    who.hands[side].set(t, 0.55, firing, bump=ahead)
    if far not in who.held:
        who.hands[far].set(t + 0.1, 0.6, steadying)
    who.accent.set(t, 0.5, (5, 0, 0))
    show_mood(who, t, "angry" if cue.mood == "neutral" else cue.mood)
    if who.posture == "stand":
        wide_stance(who, t, far)
    who.life.set(t, 0.4, 0.3)
    return t + 0.75


def wide_stance(who: Performer, t: float, lead: str) -> None:
    """Put the foot ``lead`` (``L`` or ``R``) forward and the other back, knees soft, from ``t`` seconds on."""
    k = who.scale
    for side, ahead, splay, delay in ((lead, 0.16, 10, 0.0), (other(lead), -0.14, 24, 0.3)):
        spot = who.position + who.forward * (ahead * k)
        step_to(who, side, t + delay, 0.35, who.plant(side, spot, who.yaw, width=1.25, splay=splay))
    who.hips.set(t, 0.6, (0, 0, who.standing_height - 0.05 * k, 0, 0, 0))


@clip("shoot", "body", "hands", "head")
def shoot(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Aim and fire once; the arms kick back. Return the end in seconds."""
    t = aim(stage, who, cue)
    who.accent.set(t + 0.15, 0.06, (-6, 0, 0))
    who.accent.set(t + 0.22, 0.35, (5, 0, 0))
    who.blinks.append(t + 0.14)
    return t + 0.7
