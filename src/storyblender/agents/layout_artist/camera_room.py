"""Keeps the camera in the room: what of a picture is beyond the walls, and lenses that fit the room.

A hidden wild wall lets the camera step back, but then it may look past the edge of the set into black, which no
viewfinder can tell from a dark wall: it is computed from the plan.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace

import numpy as np

from storyblender.catalog.set_plan import SetPlan, Wall
from storyblender.geometry.orbit import Floats, Orbit
from storyblender.memory.shot_sizes import SIZES, ShotSize

_RAYS = (24, 14)
"""Columns and rows of the rays sampled over a picture."""
BEFORE_WALL, _BEHIND_WALL = 0.35, 0.3
"""Metres between the camera and a wall that stays; metres it may be behind one that is hidden."""
VOID = 0.015
"""Share of the picture that may show nothing, such as the edge of a window."""


def share_outside(plan: SetPlan, camera: Orbit, hidden: Collection[str]) -> float:
    """Return the share of the picture that is beyond an indoor set; 0 outdoors.

    A ray is outside if it misses the room, meets the back of a wall first, or leaves the room through a hidden wall.

    Args:
        plan: The set.
        camera: The camera.
        hidden: node_ids that are hidden.
    """
    if not plan.indoor:
        return 0.0
    eye, ways = camera.position, rays(camera, *_RAYS)
    size, top = plan.size, _room_height(plan)
    low, high = np.array([size.x_negative, size.y_negative, 0.0]), np.array([size.x, size.y, top])
    steps = np.where(np.abs(ways) < 1e-9, 1e-9, ways)
    near, far = (low - eye) / steps, (high - eye) / steps
    enter, leave = np.minimum(near, far).max(1), np.maximum(near, far).min(1)
    out = leave <= np.maximum(enter, 0.0)
    for wall in plan.walls:
        crossed, inward = _rays_through_wall(wall, eye, ways)
        out |= crossed & (~inward if wall.node_id in hidden else inward)
    return float(out.mean())


def void_points(share: float) -> float:
    """Return the critic's points, 0 to 5, for a share of the picture that shows nothing."""
    return min(0.8 + 16 * share, 5.0) if share > VOID else 0.0


def fit_lens_to_room(plan: SetPlan | None, camera: Orbit, size: ShotSize) -> Orbit:
    """Return the camera moved into the room with a wider lens, so that its subject keeps its size.

    If the widest lens of the shot size is not wide enough, the camera stays outside.

    Args:
        plan: The set; None on an empty stage.
        camera: The camera as composed.
        size: Shot size, for the widest lens.
    """
    reach = reach_back(plan, camera) if plan is not None and plan.indoor else camera.distance
    if reach >= camera.distance:
        return camera
    lens = min(camera.lens, max(camera.lens * reach / camera.distance, SIZES[size].widest))
    return replace(camera, lens=lens, distance=camera.distance * lens / camera.lens)


def move_into_room(plan: SetPlan | None, camera: Orbit) -> Orbit:
    """Return the camera moved along its axis into the room, whatever that does to sizes.

    Args:
        plan: The set; None on an empty stage, where the camera stays.
        camera: As composed; only its distance from the pivot changes.
    """
    if plan is None or not plan.indoor:
        return camera
    return replace(camera, distance=min(camera.distance, reach_back(plan, camera)))


def reach_back(plan: SetPlan, camera: Orbit, spare: float | None = None) -> float:
    """Return how many metres from its pivot the camera may stand in its direction.

    Args:
        plan: The set.
        camera: Its pivot and its direction.
        spare: Metres it stays in front of the walls; None lets it step behind wild ones.
    """
    pivot, back = np.asarray(camera.pivot), camera.axes[:, 2]
    size = plan.size
    if spare is None:
        spare = -_BEHIND_WALL if all(wall.wild for wall in plan.walls) else BEFORE_WALL
    limits = [
        (size.x_negative + spare, size.x - spare),
        (size.y_negative + spare, size.y - spare),
        (0.3, _room_height(plan) - 0.25),
    ]
    reach = math.inf
    for at, way, (low, high) in zip(pivot, back, limits, strict=True):
        if abs(way) > 1e-6:
            reach = min(reach, ((high if way > 0 else low) - float(at)) / float(way))
    return max(reach, 0.6)


def _room_height(plan: SetPlan) -> float:
    """Return the height of the set in metres."""
    ceilings = [slab.z for slab in plan.slabs if slab.role == "ceiling"]
    return max([*ceilings, *(wall.base + wall.height for wall in plan.walls)], default=3.0)


def rays(camera: Orbit, columns: int, rows: int) -> Floats:
    """Return (columns * rows, 3) world vectors through the picture, row by row, one metre deep.

    Args:
        camera: Its position is where the vectors start.
        columns: Number of rays across the picture, one in the middle of each column.
        rows: Number of rays down the picture, the top row first.
    """
    x = ((np.arange(columns) + 0.5) / columns - 0.5) * 2 * camera.tangent * camera.aspect
    y = (0.5 - (np.arange(rows) + 0.5) / rows) * 2 * camera.tangent
    across, up = (grid.ravel() for grid in np.meshgrid(x, y))
    return np.stack([across, up, -np.ones(len(across))], 1) @ camera.axes.T


def wall_frame(wall: Wall) -> tuple[Floats, Floats, Floats, float]:
    """Return a wall's start on the floor, the unit vectors along it and into the room, and its length in metres."""
    start, end = np.asarray(wall.start), np.asarray(wall.end)
    length = float(np.hypot(*(end - start)))
    along = (end - start) / length
    return start, along, np.array([-along[1], along[0]]), length


def _rays_through_wall(wall: Wall, eye: Floats, ways: Floats) -> tuple[np.ndarray, np.ndarray]:
    """Return (n,) which of (n, 3) rays meet a wall where it is solid, and which of them come from behind it."""
    start, along, inward, length = wall_frame(wall)
    off, speed = float((eye[:2] - start) @ inward), ways[:, :2] @ inward
    share = np.where(np.abs(speed) > 1e-9, -off / np.where(np.abs(speed) > 1e-9, speed, 1.0), -1.0)
    x = (eye[:2] - start) @ along + share * (ways[:, :2] @ along)
    z = eye[2] + share * ways[:, 2]
    met = (share > 0) & (x > 0) & (x < length) & (z > wall.base) & (z < wall.base + wall.height)
    for hole in wall.openings:
        met &= ~((x > hole.x) & (x < hole.x + hole.width) & (z > hole.sill) & (z < hole.sill + hole.height))
    return met, speed > 0
