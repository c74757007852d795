"""Keeps the camera in the room: what of a picture lies beyond the walls, and lenses that fit the floor there is.

A wild wall may be taken away so that the camera steps back a little. Whoever looks past the edge of the set from
there sees the black outside, which no viewfinder can tell from a dark wall: it is computed from the plan.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace

import numpy as np

from storyblender.agents.layout_artist.camera_brief import TIGHT
from storyblender.catalog.set_plan import SetPlan, Wall
from storyblender.geometry.orbit import Floats, Orbit

_RAYS = (24, 14)
"""Columns and rows of the rays that stand for a picture."""
_BEFORE_WALL, _BEHIND_WALL = 0.35, 0.3
"""Metres: room for the camera before a wall that stays; how far it may step behind one that goes."""
_WIDEST = {"EWS": 18.0, "WS": 18.0, "FS": 20.0, "MWS": 22.0, "MS": 27.0, "MCU": 35.0}
"""mm by shot size: what the lens may be widened to where the room is short; tighter sizes keep theirs."""


def outside(plan: SetPlan, camera: Orbit, hidden: Collection[str]) -> float:
    """Return the share of the picture that shows what lies beyond an indoor set; 0 outdoors.

    A ray sees the outside if it never meets the room, if it meets the back of a wall first, or if it leaves the room
    where a wall is taken away.
    """
    if not plan.indoor:
        return 0.0
    eye, rays = camera.position, _rays(camera)
    size, top = plan.size, _height(plan)
    low, high = np.array([size.x_negative, size.y_negative, 0.0]), np.array([size.x, size.y, top])
    steps = np.where(np.abs(rays) < 1e-9, 1e-9, rays)
    near, far = (low - eye) / steps, (high - eye) / steps
    enter, leave = np.minimum(near, far).max(1), np.maximum(near, far).min(1)
    out = leave <= np.maximum(enter, 0.0)
    for wall in plan.walls:
        crossed, inward = _crossed(wall, eye, rays)
        out |= crossed & (~inward if wall.node_id in hidden else inward)
    return float(out.mean())


def fitted(plan: SetPlan | None, camera: Orbit, size: str, several: bool = False) -> Orbit:
    """Return the camera brought into the room with a wider lens, so that what is at its pivot keeps its size.

    Where the widest lens of the shot size (for several people, of a master) is not wide enough, the camera stays as far
    outside as it must.
    """
    if plan is None or not plan.indoor:
        return camera
    reach = reach_back(plan, camera)
    if reach >= camera.distance:
        return camera
    widest = _WIDEST["WS"] if several and size not in TIGHT else _WIDEST.get(size, camera.lens)
    lens = min(camera.lens, max(camera.lens * reach / camera.distance, widest))
    return replace(camera, lens=lens, distance=camera.distance * lens / camera.lens)


def walked_in(plan: SetPlan | None, camera: Orbit, most: float = 0.0) -> Orbit:
    """Return the camera moved along its axis into the room, whatever that does to sizes.

    Args:
        plan: The set.
        camera: Where it would like to be.
        most: Share of its distance that it keeps at least.
    """
    if plan is None or not plan.indoor:
        return camera
    return replace(camera, distance=min(camera.distance, max(reach_back(plan, camera), most * camera.distance)))


def reach_back(plan: SetPlan, camera: Orbit) -> float:
    """Return how far from its pivot the camera may stand in the direction it is in, metres."""
    pivot, back = np.asarray(camera.pivot), camera.axes[:, 2]
    size = plan.size
    wild = all(wall.wild for wall in plan.walls)
    spare = -_BEHIND_WALL if wild else _BEFORE_WALL
    limits = [
        (size.x_negative + spare, size.x - spare),
        (size.y_negative + spare, size.y - spare),
        (0.3, _height(plan) - 0.25),
    ]
    reach = math.inf
    for at, way, (low, high) in zip(pivot, back, limits, strict=True):
        if abs(way) > 1e-6:
            reach = min(reach, ((high if way > 0 else low) - float(at)) / float(way))
    return max(reach, 0.6)


def _height(plan: SetPlan) -> float:
    ceilings = [slab.z for slab in plan.slabs if slab.role == "ceiling"]
    return max([*ceilings, *(wall.base + wall.height for wall in plan.walls)], default=3.0)


def _rays(camera: Orbit) -> Floats:
    columns, rows = _RAYS
    x = ((np.arange(columns) + 0.5) / columns - 0.5) * 2 * camera.tangent * camera.aspect
    y = (0.5 - (np.arange(rows) + 0.5) / rows) * 2 * camera.tangent
    across, up = (grid.ravel() for grid in np.meshgrid(x, y))
    return np.stack([across, up, -np.ones(len(across))], 1) @ camera.axes.T


def _crossed(wall: Wall, eye: Floats, rays: Floats) -> tuple[np.ndarray, np.ndarray]:
    """Return which rays meet a wall where it is solid, and which of them come from behind it."""
    start, end = np.asarray(wall.start), np.asarray(wall.end)
    length = float(np.hypot(*(end - start)))
    along = (end - start) / length
    inward = np.array([-along[1], along[0]])
    off, speed = float((eye[:2] - start) @ inward), rays[:, :2] @ inward
    share = np.where(np.abs(speed) > 1e-9, -off / np.where(np.abs(speed) > 1e-9, speed, 1.0), -1.0)
    x = (eye[:2] - start) @ along + share * (rays[:, :2] @ along)
    z = eye[2] + share * rays[:, 2]
    met = (share > 0) & (x > 0) & (x < length) & (z > wall.base) & (z < wall.base + wall.height)
    for hole in wall.openings:
        met &= ~((x > hole.x) & (x < hole.x + hole.width) & (z > hole.sill) & (z < hole.sill + hole.height))
    return met, speed > 0
