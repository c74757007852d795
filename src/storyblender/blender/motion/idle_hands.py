"""Idle poses of the free hands of a standing person; each person has one habit."""

from __future__ import annotations

from mathutils import Vector

from storyblender.blender.motion.channel import Floats, TargetOf, clamp, smooth
from storyblender.blender.motion.hands import Triple, blend_hands, hand, hanging, shoulder_rest
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import sign
from storyblender.memory.base import content_hash

HABITS = ("hanging", "folded", "hanging", "behind", "clasped", "hanging", "folded", "behind")
"""Habits of free hands, chosen by asset id: at the sides, folded low in front, behind, clasped at the waist."""
CHILD = 0.85
"""Scale (stature over 1.7 m) up to which a person counts as a child."""
LOOSE: Triple = (26, 32, 4)
"""Curl of fingers that hold nothing, degrees."""


def habit_of(who: Performer) -> str:
    """Return the habit of a person's idle hands, a word of ``HABITS`` chosen by asset id; children let them hang."""
    return HABITS[int(content_hash(who.asset_id), 16) % len(HABITS)] if who.scale > CHILD else "hanging"


def idle_hand(who: Performer, side: str) -> TargetOf:
    """Return the target of a standing person's free hand: their habit at rest, hanging at the side while walking.

    Args:
        who: The person.
        side: ``L`` or ``R``.
    """
    swinging, habit = hanging(who, side), habit_of(who)
    if habit == "hanging":
        return swinging
    resting = _resting(who, side, habit)

    def target(t: float) -> Floats:
        swing, _, gait = who.gait_at(t)
        if gait is None:
            return resting(t)
        return blend_hands(resting(t), swinging(t), smooth(clamp(2 * swing)))

    return target


def _resting(who: Performer, side: str, habit: str) -> TargetOf:
    """Return the target of one of two hands that rest on each other in the middle of the body."""
    s, m, k = sign(side), who.measures, who.scale
    over = 1.0 if side == "R" else 0.0
    if habit == "behind":
        place = Vector((-0.015 * s, m.buttocks_back + 0.035 + 0.03 * over, -0.86 * m.arm))
        fingers, palm, pole = Vector((-s, -0.1, -0.35)), Vector((0, 1, 0.2)), Vector((0.8 * s, 0.8, 0.1))
    elif habit == "folded":
        place = Vector((0.02 * s * k, -(m.front + 0.035 + 0.03 * over), -0.90 * m.arm))
        fingers, palm, pole = Vector((-0.8 * s, -0.1, -0.6)), Vector((-0.2 * s, 1, -0.1)), Vector((0.9 * s, 0.4, -0.2))
    else:
        place = Vector((0.02 * s * k, -(m.front + 0.045 + 0.03 * over), -0.66 * m.arm))
        fingers, palm, pole = Vector((-s, -0.25, 0.05)), Vector((-0.1 * s, 1, 0.25)), Vector((0.9 * s, 0.3, -0.5))

    def target(t: float) -> Floats:
        middle = (shoulder_rest(who, "L") + shoulder_rest(who, "R")) / 2
        turn = who.facing
        spot = Vector((middle.x, m.hip_y, middle.z)) + place
        return hand(who.to_world(spot), turn @ fingers, turn @ palm, turn @ pole, LOOSE)

    return target
