"""Travel of animals that are props: they turn into the path, bob along it and turn to the final facing."""

from __future__ import annotations

import math

from mathutils import Matrix, Vector

from storyblender.blender.motion.channel import clamp, smooth
from storyblender.blender.motion.skeleton import facing_yaw
from storyblender.blender.motion.staged_props import StagedProp, upright_matrix
from storyblender.memory.shot_context import Mark

TURNING = 0.22
"""Share of the duration spent turning at the start, and again at the end."""
STRIDE, BOB = 0.7, 0.05
"""Step length and bob height, per metre of the animal's length."""


def move_animal(animal: StagedProp, start: float, seconds: float, mark: Mark) -> None:
    """Move an animal to a mark.

    Args:
        animal: The prop.
        start: Second of the shot at which it sets off.
        seconds: Duration of the move.
        mark: Final position and facing.
    """
    first = animal.evaluate(start)
    here, goal = first.translation.copy(), Vector(mark.location)
    yaw, last = first.to_euler().z, math.radians(mark.yaw)
    way = (goal - here).length
    ahead = facing_yaw(goal - here) if way > 0.1 else last
    size = max(animal.size.x, animal.size.y)
    steps = max(1, round(way / max(0.08, STRIDE * size))) if way > 0.1 else 0

    def at(t: float) -> Matrix:
        share = clamp((t - start) / max(seconds, 1e-3))
        going = smooth(clamp((share - TURNING / 2) / (1 - TURNING)))
        place = here.lerp(goal, going)
        place.z += BOB * size * abs(math.sin(math.pi * steps * going))
        turn = _turned(yaw, ahead, smooth(clamp(share / TURNING)))
        turn = _turned(turn, last, smooth(clamp((share - 1 + TURNING) / TURNING)))
        return upright_matrix(place, turn)

    animal.follow(start, at, 0.0)


def _turned(start: float, end: float, share: float) -> float:
    """Return the yaw at ``share`` (0 to 1) between two yaws in radians, along the shorter arc."""
    return start + ((end - start + math.pi) % math.tau - math.pi) * share
