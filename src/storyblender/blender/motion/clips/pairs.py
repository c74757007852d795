"""Motions of two people: meeting, giving, taking, shaking hands, touching, hitting."""

from __future__ import annotations

import math
from dataclasses import replace

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats, TargetOf, clamp, ease_out
from storyblender.blender.motion.clips.containers import draw_from_clothes, take_from_bag
from storyblender.blender.motion.clips.gaze import look_at, show_mood
from storyblender.blender.motion.clips.handling import pick_up, prop_of, release_prop, take_in_hand
from storyblender.blender.motion.clips.locomotion import shuffle_to, step_to, travel, turn_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.clips.work import press
from storyblender.blender.motion.hands import by_chest, hand
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import facing_yaw, sign
from storyblender.blender.motion.staged_props import Grip, StagedProp, carrying_hand, gripping_hand, upright_matrix
from storyblender.catalog.carrying import hand_towards

SEATED = ("sit", "lie", "asleep")
SHUFFLE = 0.45
"""Metres; shorter distances are stepped without turning."""
BY_KNEES = 1.1
"""Metres within which a kneeling person stays where they are."""
BEHIND_FEET = 0.4
"""Metres, times the scale, from the feet of a seated person back to their breast."""
BEFORE_SITTER = 0.45
"""Least metres between a standing person and the feet of a seated one."""


def partner_of(cue: StagedCue) -> Performer | None:
    """Return the other person of a cue, or None."""
    return cue.target if isinstance(cue.target, Performer) else None


def meet(
    stage: MotionStage, who: Performer, partner: Performer, cue: StagedCue, distance: float, slack: float = 0.25
) -> float:
    """Bring two people face to face; return the end in seconds.

    Args:
        stage: The stage of the shot.
        who: The person who walks, unless seated.
        partner: The person met.
        cue: Gives the start and, if it has one, the duration of the walk.
        distance: Metres between the two; more before a seated partner.
        slack: Metres by which the distance may differ without a step.
    """
    t = max(cue.start, *(partner.free[part] for part in ("L", "R")))
    gap = (partner.position - who.position).length
    if partner.posture in ("lie", "asleep") or (who.posture in ("kneel", "crouch") and gap < BY_KNEES):
        return t
    if partner.posture in SEATED and distance < BEFORE_SITTER:
        distance, slack = BEFORE_SITTER, max(slack, 0.2)
    if who.posture not in SEATED and (gap > distance + slack or gap < distance - slack):
        away = (who.position - partner.position).normalized()
        if partner.posture in SEATED:  # to the front of a seat, not to its side
            ahead = partner.forward
            away = (ahead + away * 0.8).normalized() if away.dot(ahead) > -0.2 else ahead
        spot = partner.position + away * distance
        if (spot - who.position).length < SHUFFLE:
            return shuffle_to(who, turn_to(who, t, math.atan2(-away.x, away.y)), spot)
        t = max(t, travel(stage, who, cue, (spot.x, spot.y), skip=(partner.asset_id,), partner=partner))
    ends = [t]
    for one, two in ((who, partner), (partner, who)):
        toward = two.position - two.forward * (BEHIND_FEET * two.scale * (two.posture == "sit")) - one.position
        if one.posture not in SEATED and toward.length > 0.05:
            ends.append(turn_to(one, max(one.free["body"], t - 0.6), facing_yaw(toward)))
    return max(ends)


def free_hand(who: Performer, preferred: str = "R") -> str | None:
    """Return a hand that holds nothing, ``preferred`` (``L`` or ``R``) first; None if both are full."""
    return next((side for side in (preferred, "L" if preferred == "R" else "R") if side not in who.held), None)


def reserve_hands(who: Performer, sides: tuple[str, ...], start: float, end: float) -> None:
    """Keep a person's hands for a motion with another person, and cancel what was planned for them.

    Args:
        who: The person.
        sides: ``L``, ``R`` or both.
        start: Second from which planned keys are removed.
        end: Second until which no other cue may use them.
    """
    for side in sides:
        who.hands[side].remove_from(start)
        who.free[side] = max(who.free[side], end)


@clip("give", "body", "hand", "head")
def give(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Hand a prop over: meet, hold it out at chest height, let go when the other has it. Return the end in seconds."""
    partner, prop = partner_of(cue), prop_of(cue)
    prop = prop or stage.props.get(who.held.get(cue.side, ""))
    if partner is None or prop is None:
        return cue.start
    start = cue.start
    if prop.holder is not who:
        start = pick_up(stage, who, cue)
    return _hand_over(stage, who, partner, prop, cue, start)


@clip("take", "body", "hand", "head")
def take(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Take a prop from a person, from the own clothes, from a bag, or from its place. Return the end in seconds."""
    prop = prop_of(cue)
    partner = partner_of(cue) or (prop.holder if prop else None)
    if prop is None:
        return cue.start
    if prop.holder is who:
        return cue.start
    if cue.target is who:
        return draw_from_clothes(stage, who, cue, prop)
    if isinstance(cue.target, StagedProp) and cue.target.holder in (who, None):
        return take_from_bag(stage, who, cue, prop, cue.target)
    if partner is None or prop.holder is not partner:
        return pick_up(stage, who, cue)
    return _hand_over(stage, partner, who, prop, cue, cue.start, mover=who)


def _hand_over(
    stage: MotionStage,
    giver: Performer,
    taker: Performer,
    prop: StagedProp,
    cue: StagedCue,
    start: float,
    mover: Performer | None = None,
) -> float:
    """Pass a prop from giver to taker after ``start`` seconds, ``mover`` walking; return the end in seconds."""
    mover = mover or giver
    reach = 0.72 * (giver.measures.arm + taker.measures.arm)
    t = meet(stage, mover, taker if mover is giver else giver, replace(cue, start=start), reach)
    side = giver.hand_holding(prop.asset_id) or "R"
    other_side = free_hand(taker, hand_towards(taker.position.to_tuple(), taker.yaw, giver.position.to_tuple()))
    if other_side is None:
        stage.report("unreachable", taker, cue, f"{taker.asset_id} has no free hand for {prop.asset_id}")
        return t
    grip, far = prop.grip(side), prop.grip(other_side).opposite()
    look_at(giver, t, stage.look_point(prop))
    look_at(taker, t + 0.1, stage.look_point(prop))
    offered = _offered(giver, taker, side, grip)
    reaching, touch = 0.9, t + 0.35 + 0.9 * 0.85 + 0.05
    reserve_hands(taker, (other_side,), t, touch + 1.1)
    reserve_hands(giver, (side,), t, touch + 1.1)
    giver.hands[side].set(t, reaching, offered)
    giver.accent.set(t, reaching, (7, 0, -8 * sign(side)))
    taker.hands[other_side].set(t + 0.35, 0.85 * reaching, gripping_hand(taker, other_side, prop, far, opening=0.5))
    taker.accent.set(t + 0.35, 0.8 * reaching, (6, 0, 0))
    taker.hands[other_side].set(touch - 0.05, 0.15, gripping_hand(taker, other_side, prop, far))
    stage.following_hands.append((taker, other_side, t + 0.3, touch + 0.199))
    stage.expect_contact(taker, other_side, touch, cue)
    prop.hold(touch + 0.2, taker, other_side, far, 0.1)
    giver.hands[side].set(touch + 0.2, 0.15, lambda now: _open_hand(offered, now))
    release_prop(stage, prop)
    giver.hands[side].set(touch + 0.3, 0.8, giver.home[side])
    giver.accent.set(touch + 0.3, 0.6, (0, 0, 0))
    take_in_hand(stage, taker, other_side, prop, touch + 0.45, 0.6)
    taker.hands[other_side].set(touch + 0.25, 0.8, carrying_hand(taker, other_side, prop))
    taker.accent.set(touch + 0.4, 0.6, (0, 0, 0))
    look_at(giver, touch + 0.5, stage.look_point(taker))
    look_at(taker, touch + 1.3, stage.look_point(giver))
    return touch + 1.1


def _open_hand(target: TargetOf, t: float) -> Floats:
    """Return a hand target at ``t`` seconds with nearly stretched fingers."""
    values = target(t)
    values[12:15] *= 0.2
    return values


def _offered(giver: Performer, taker: Performer, side: str, grip: Grip) -> TargetOf:
    """Return the target of a giver's hand: between both people, at the lower of the two chests."""

    def target(t: float) -> Floats:
        share = giver.measures.arm / (giver.measures.arm + taker.measures.arm)
        a, b = giver.breast_point(), taker.breast_point()
        middle = a.lerp(b, share)
        low = min(giver.breast_point().z, taker.breast_point().z)
        middle.z = 0.86 * low + 0.04 * max(0.0, giver.measures.shoulder_height - taker.measures.shoulder_height)
        toward = b - a
        matrix = upright_matrix(middle, facing_yaw(toward)) @ Matrix.Translation(-grip.palm)
        return grip.hand_target(matrix, giver.facing @ Vector((sign(side) * 0.5, 0.4, -0.85)))

    return target


@clip("shake_hands", "body", "hand", "head")
def shake_hands(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Shake the target's right hand three times. Return the end in seconds."""
    partner = partner_of(cue)
    if partner is None:
        return cue.start
    bellies = sum(max(0.0, each.measures.belly_front - 0.15 * each.scale) for each in (who, partner))
    t = meet(stage, who, partner, cue, 0.66 * (who.measures.arm + partner.measures.arm) + bellies, 0.12)
    clasped, shaken = t + 0.7, t + 0.7 + 3 / 2.2

    def middle(now: float) -> Vector:
        between = (who.point("upper_arm.R") + partner.point("upper_arm.R")) / 2
        up = 0.030 * math.sin(2 * math.pi * 2.2 * (now - clasped)) if clasped < now < shaken else 0.0
        between.z = 0.72 * min(who.breast_point().z, partner.breast_point().z) + up
        return between

    reserve_hands(partner, ("R",), t, shaken + 0.8)
    for one, two in ((who, partner), (partner, who)):
        if "R" in one.held:
            stage.report("unreachable", one, cue, f"{one.asset_id} has no free right hand")
            continue

        def target(now: float, one: Performer = one, two: Performer = two) -> Floats:
            along = Vector((*(two.place - one.place).xy, 0)).normalized()
            right = Vector((along.y, -along.x, 0))
            palm = middle(now) - along * (0.012 * one.scale) + right * (0.016 * one.scale)
            return hand(
                palm, along + Vector((0, 0, -0.12)), -right, one.facing @ Vector((-0.5, 0.6, -0.8)), (38, 48, -12)
            )

        one.hands["R"].set(t, 0.7, target, bump=(0, 0, -0.04))
        one.hands["R"].set(shaken + 0.1, 0.7, one.home["R"])
        one.accent.set(t, 0.7, (5, 0, 6))
        one.accent.set(shaken, 0.6, (0, 0, 0))
        stage.following_hands.append((one, "R", t, shaken + 0.1))
        look_at(one, t, stage.look_point(two))
        show_mood(one, t, "tender")
    return shaken + 0.8


@clip("touch", "body", "hand", "head")
def touch(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Lay a hand on the target's shoulder, or on a prop. Return the end in seconds."""
    partner = partner_of(cue)
    if partner is None:
        return press(stage, who, cue)
    t = meet(stage, who, partner, cue, 0.80 * who.measures.arm + 0.15, 0.15)
    side = cue.side
    near = _nearer_shoulder(who, partner)
    mark = Vector((-0.02 * sign(near), 0, 0.055)) * partner.scale
    stay = clamp((cue.duration or 2.4) - 1.4, 0.6, 6)

    def target(now: float) -> Floats:
        palm = partner.point(f"upper_arm.{near}", mark)
        along = palm - who.point(f"upper_arm.{side}")
        along.z *= 0.2
        return hand(palm, along, Vector((0, 0, -1)), who.facing @ Vector((sign(side) * 0.6, 0.3, -0.8)), (8, 12, 0))

    def above(now: float) -> Floats:
        values = target(now)
        values[2] += 0.07 * who.scale
        return values

    who.hands[side].set(t, 0.56, above)
    who.hands[side].set(t + 0.5, 0.3, target)
    who.hands[side].set(t + 0.8 + stay, 0.7, who.home[side])
    stage.following_hands.append((who, side, t, t + 0.8 + stay))
    stage.expect_contact(who, side, t + 0.8, cue)
    look_at(who, t, stage.look_point(partner))
    show_mood(who, t, "tender" if cue.mood == "neutral" else cue.mood)
    return t + 1.5 + stay


def _nearer_shoulder(who: Performer, partner: Performer) -> str:
    """Return the side of the partner's shoulder that is nearer."""
    return "L" if (who.position - partner.position).dot(partner.left) > 0 else "R"


@clip("hit", "body", "hand", "head")
def hit(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Strike the target's face; their head gives way. Return the end in seconds."""
    partner = partner_of(cue)
    if partner is None:
        return cue.start
    side = cue.side
    t = meet(stage, who, partner, cue, 0.95 * who.measures.arm, 0.15)
    show_mood(who, t, "angry")
    look_at(who, t, stage.look_point(partner))
    spot = _cheek(who, partner, side)
    back = by_chest(
        who, side, (0.55, 0.25, 0.10), (0.2, 0.9, 0.2), (-0.2, 0.3, -1), pole=(1, -0.3, -0.2), curl=(80, 88, 35)
    )
    who.hands[side].set(t, 0.35, back)
    who.accent.set(t, 0.35, (-3, 0, -28 * sign(side)))
    who.hands[side].set(t + 0.35, 0.14, spot, ease=ease_out)
    who.accent.set(t + 0.35, 0.16, (10, 0, 24 * sign(side)))
    stage.following_hands.append((who, side, t + 0.3, t + 0.5))
    partner.nod.set(t + 0.47, 0.1, (-6, 0, -30 * sign(side)))
    partner.accent.set(t + 0.47, 0.15, (-10, 0, -14 * sign(side)))
    show_mood(partner, t + 0.47, "afraid", 0.1)
    partner.nod.set(t + 0.75, 0.6, (8, 0, 0))
    partner.accent.set(t + 0.75, 0.7, (4, 0, 0))
    if partner.posture == "stand":
        behind = partner.position - partner.forward * (0.2 * partner.scale)
        step_to(partner, "L", t + 0.5, 0.3, partner.plant("L", behind, partner.yaw))
        step_to(partner, "L", t + 1.2, 0.35, partner.plant("L", partner.position, partner.yaw))
    who.hands[side].set(t + 0.6, 0.6, who.home[side])
    who.accent.set(t + 0.6, 0.5, (0, 0, 0))
    partner.accent.set(t + 1.5, 0.6, (0, 0, 0))
    partner.nod.set(t + 1.5, 0.5, (0, 0, 0))
    return t + 1.5


def _cheek(who: Performer, partner: Performer, side: str) -> TargetOf:
    """Return the target of a fist at the partner's cheek."""

    def target(t: float) -> Floats:
        face_point = partner.point("head", Vector((-sign(side) * 0.02, -0.09, 0.02)) * partner.scale)
        along = (face_point - who.point(f"upper_arm.{side}")).normalized()
        palm = face_point - along * (0.05 * who.scale)
        return hand(palm, along, Vector((0, 0, -1)), who.facing @ Vector((sign(side), 0.2, -0.2)), (80, 88, 35))

    return target
