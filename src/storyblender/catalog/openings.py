"""Doors and windows of a plan as things in the room: where they are, how they face, where their handle is. Pure."""

from __future__ import annotations

import math
from dataclasses import dataclass

from storyblender.catalog.set_plan import Opening, Wall
from storyblender.memory.base import Vec3

PAIR = 1.25
"""Metres; wider doors have two leaves, which meet in the middle."""
HANDLE_HEIGHT = 1.0


@dataclass(frozen=True)
class OpeningPlace:
    """A hole in a wall in the world.

    Attributes:
        opening: What it is.
        location: Bottom centre, on the room's face of the wall.
        yaw: Radians; its front, -Y, looks into the room.
        size: Width, thickness of the wall, height.
    """

    opening: Opening
    location: Vec3
    yaw: float
    size: Vec3

    @property
    def handle(self) -> Vec3:
        """Return where a door's leaf is grasped, in the opening's own frame: away from its hinge."""
        width = self.size[0]
        pair = self.opening.style == "double" or width > PAIR
        return (0.06 if pair else 0.08 - width / 2, -0.05, min(HANDLE_HEIGHT, 0.5 * self.size[2]))


def openings_of(wall: Wall) -> list[OpeningPlace]:
    """Return the openings of a wall, in its order."""
    (x0, y0), (x1, y1) = wall.start, wall.end
    length = math.hypot(x1 - x0, y1 - y0)
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    return [
        OpeningPlace(
            opening,
            (x0 + ux * (opening.x + opening.width / 2), y0 + uy * (opening.x + opening.width / 2), opening.sill),
            math.atan2(-uy, -ux),
            (opening.width, wall.thickness, opening.height),
        )
        for opening in wall.openings
    ]
