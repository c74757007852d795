"""Throwing and catching."""

from __future__ import annotations

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import Floats
from storyblender.blender.motion.clips.gaze import look_at, look_at_subject
from storyblender.blender.motion.clips.handling import Flight, pick_up, prop_of, release_prop, take_in_hand
from storyblender.blender.motion.clips.locomotion import turn_to
from storyblender.blender.motion.clips.registry import clip
from storyblender.blender.motion.hands import by_chest
from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import facing_yaw, sign
from storyblender.blender.motion.staged_props import carrying_hand

SPEED = 6.0
"""Metres per second of a thrown prop."""
ARC = 0.35
"""Metres a throw rises above the straight line."""


@clip("throw", "body", "hand")
def throw(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Throw the held prop towards the target in an arc. Return the end in seconds."""
    prop = prop_of(cue)
    side = who.hand_holding(prop.asset_id) if prop is not None else None
    if prop is None or side is None:
        return cue.start
    aim = stage.floor_position(cue.target) if cue.target else who.position + who.forward * 3
    toward = aim - who.position
    t = turn_to(who, cue.start, facing_yaw(toward))
    look_at_subject(stage, who, t, cue)
    back = by_chest(who, side, (0.35, -0.25, 0.35), (0.2, -0.3, 0.9), (0, 1, 0.2), pole=(0.9, -0.3, -0.2))
    forth = by_chest(who, side, (-0.05, 0.95, 0.15), (-0.1, 0.9, 0.1), (0, 0.2, -1), curl=(5, 8, 0))
    who.hands[side].set(t, 0.5, back)
    who.accent.set(t, 0.5, (-6, 0, -22 * sign(side)))
    who.hands[side].set(t + 0.5, 0.18, forth)
    who.accent.set(t + 0.5, 0.2, (14, 0, 18 * sign(side)))
    release_prop(stage, prop)
    prop.holder = None
    landing = Vector((*aim, 0.0))
    prop.flight = Flight(prop, t + 0.62, lambda: landing, ARC, max(0.45, toward.length / SPEED))
    prop.follow(t + 0.62, prop.flight, 0.0)
    who.hands[side].set(t + 0.9, 0.7, who.home[side])
    who.accent.set(t + 0.9, 0.6, (0, 0, 0))
    return t + 1.6


@clip("catch", "body", "hand", "head")
def catch(stage: MotionStage, who: Performer, cue: StagedCue) -> float:
    """Catch a prop in flight with one hand; pick up one that lies there. Return the end in seconds."""
    prop, side = prop_of(cue), cue.side
    flight = prop.flight if prop is not None else None
    if prop is None or not isinstance(flight, Flight) or flight.end < cue.start:
        return pick_up(stage, who, cue)
    t, s, k = min(cue.start, flight.start), sign(side), who.scale
    grip = prop.grip(side)

    def meeting() -> Matrix:
        """Return the matrix of the caught prop: before the breast, upright, as the hand holds it."""
        place = who.point("upper_chest", (s * 0.10 * k, -0.62 * who.measures.arm, -0.02 * k))
        return Matrix.Translation(place) @ who.facing.to_4x4() @ Matrix.Translation(-grip.palm)

    def reaching(now: float) -> Floats:
        values = grip.hand_target(meeting(), who.facing @ Vector((s * 0.6, 0.3, -0.8)))
        values[12:15] *= 0.3
        return values

    def closing(now: float) -> Floats:
        return grip.hand_target(meeting(), who.facing @ Vector((s * 0.6, 0.3, -0.8)))

    flight.goal = lambda: meeting().translation
    look_at(who, t, stage.look_point(prop))
    who.hands[side].set(max(t, flight.end - 0.75), 0.55, reaching)
    who.hands[side].set(flight.end, 0.12, closing)
    who.accent.set(flight.end - 0.4, 0.4, (6, 0, 0))
    take_in_hand(stage, who, side, prop, flight.end, 0.15)
    who.hands[side].set(flight.end + 0.2, 0.7, carrying_hand(who, side, prop))
    who.accent.set(flight.end + 0.1, 0.6, (0, 0, 0))
    look_at(who, flight.end + 0.6, who.ahead)
    return flight.end + 0.9
