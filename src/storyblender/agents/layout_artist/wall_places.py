"""Where things hang on the walls or stand with their back to one."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.layout_artist.layout_stage import Stage
from storyblender.agents.layout_artist.layout_things import size_of
from storyblender.catalog.set_plan import Wall
from storyblender.geometry.boxes import Box, footprint_gap, wrap_angle, yaw_along

_LONG = 2.0
"""Times its width: what is deeper hangs along the wall, as a rifle does."""
_EYE = 1.5
"""Metres: the middle of what hangs on a wall."""


def hang(
    stage: Stage,
    asset_id: str,
    near: tuple[float, float] | None = None,
    lowest: float = 0.0,
    height: float | None = None,
) -> bool:
    """Hang a thing on a wall, above what stands before it; False where no wall has room.

    Args:
        stage: Changed.
        asset_id: The thing.
        near: Floor point it is wanted at; the middle of the set if not given.
        lowest: Metres above the floor that it stays clear of.
        height: Metres above the floor of its lower edge, if the script says so; less under a low ceiling.
    """
    width, depth, tall = size_of(stage.measure(asset_id))
    wish = near or stage.middle
    best: tuple[float, Box] | None = None
    along, out = (depth, width) if depth > _LONG * width else (width, depth)
    for wall, x, y, facing_in, dislike in _wall_places(stage, along, out / 2 + 0.005):
        yaw = facing_in if along == width else facing_in + math.pi / 2
        z = 0.0 if tall > 1.4 else max(_EYE - tall / 2, lowest)
        if height is not None:
            z = max(0.0, min(height, wall.base + wall.height - tall))
        box = Box(x, y, z, width, depth, tall, yaw)
        if box.top > wall.base + wall.height:
            continue
        taken = sum(
            footprint_gap(box, thing.box)[0] < 0.05 and thing.box.top > z - 0.02 and thing.box.z < box.top
            for thing in stage.things.values()
        )
        cost = dislike + 3 * taken + 0.2 * math.dist((x, y), wish)
        if best is None or cost < best[0] - 1e-9:
            best = (cost, box)
    if best is None or best[0] >= 3:
        return False
    stage.stand(asset_id, best[1], floats=True, fixed=True)
    return True


def stand_against(stage: Stage, asset_id: str, near: tuple[float, float] | None = None) -> bool:
    """Stand a large thing with its back to a wall that has room for it; False where none has.

    Args:
        stage: Changed.
        asset_id: The thing.
        near: Floor point it is wanted at; the middle of the set if not given.
    """
    width, depth, _ = size_of(stage.measure(asset_id))
    best: tuple[float, Box] | None = None
    middle, pull = (stage.middle, 0.15) if near is None else (near, 1.0)
    for _, x, y, yaw, dislike in _wall_places(stage, width, depth / 2 + 0.02):
        box = stage.box(asset_id, x, y, 0.0, yaw)
        if any(footprint_gap(box, thing.box)[0] < 0.03 and thing.box.top > 0.05 for thing in stage.things.values()):
            continue
        cost = dislike + pull * math.dist((x, y), middle)
        if best is None or cost < best[0] - 1e-9:
            best = (cost, box)
    if best is None:
        return False
    stage.stand(asset_id, best[1])
    return True


def _wall_places(stage: Stage, width: float, reach: float) -> list[tuple[Wall, float, float, float, float]]:
    """Return (wall, x, y, yaw, dislike) along the walls: the back wall first, openings and the camera's wall out."""
    places = []
    for wall in stage.view.plan.walls:
        length = math.dist(wall.start, wall.end)
        ux, uy = (wall.end[0] - wall.start[0]) / length, (wall.end[1] - wall.start[1]) / length
        inward = (-uy, ux)
        yaw = yaw_along(*inward)
        if abs(wrap_angle(yaw)) > math.radians(135):
            continue
        for along in np.arange(width / 2 + 0.05, length - width / 2, 0.15):
            holes = any(hole.x - width / 2 - 0.1 < along < hole.x + hole.width + width / 2 + 0.1
                        for hole in wall.openings)  # fmt: skip
            if not holes:
                x = wall.start[0] + ux * along + inward[0] * reach
                y = wall.start[1] + uy * along + inward[1] * reach
                places.append((wall, float(x), float(y), yaw, abs(wrap_angle(yaw)) / 2))
    return places
