"""Places for things that hang on walls or stand with their back to one."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import size_of
from storyblender.catalog.set_plan import Wall
from storyblender.geometry.boxes import Box, footprint_gap, wrap_angle, yaw_along

_LONG = 2.0
"""Depth over width from which a thing hangs along the wall, such as a rifle."""
_EYE = 1.5
"""Metres above the floor of the middle of a thing on a wall."""


def hang(
    stage: LayoutStage,
    asset_id: str,
    near: tuple[float, float] | None = None,
    lowest: float = 0.0,
    height: float | None = None,
) -> bool:
    """Hang a thing on a wall, above what stands in front of it; return False if no wall has room.

    Args:
        stage: The stage; changed.
        asset_id: The thing.
        near: Wished floor point; None for the middle of the set.
        lowest: Least metres of its lower edge above the floor.
        height: Metres of its lower edge above the floor in the script; less under a low ceiling, None if not given.
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
    stage.place(asset_id, best[1], floats=True, fixed=True)
    return True


def stand_against(stage: LayoutStage, asset_id: str, near: tuple[float, float] | None = None) -> bool:
    """Place a large thing with its back to a wall; return False if no wall has room.

    Args:
        stage: The stage; changed.
        asset_id: The thing.
        near: Wished floor point; None for the middle of the set.
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
    stage.place(asset_id, best[1])
    return True


def _wall_places(stage: LayoutStage, width: float, reach: float) -> list[tuple[Wall, float, float, float, float]]:
    """Return (wall, x, y, yaw, penalty) along the walls: back walls first, without openings and the camera's wall."""
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
