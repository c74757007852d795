"""A made-up frame: a floor, a back wall and one box with a face on it, as a G-buffer. Pure numpy."""

from __future__ import annotations

import numpy as np

from storyblender.look.gbuffer import FAR, GBuffer, View
from storyblender.look.surface import Surface

FLOOR, WALL, PERSON = 1, 2, 3
HEAD = (0.0, 4.0, 1.6)


def view(width: int = 96, height: int = 54) -> View:
    """Stand at the origin, eyes at 1.6 m, look along +Y."""
    axes = np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])
    return View(np.array([0.0, 0.0, 1.6]), axes, width, height, 0.5, 0.5 * height / width)


def gbuffer(width: int = 96, height: int = 54, floor: Surface = Surface.SET) -> GBuffer:
    """Trace the frame by hand: wall at y = 8 up to 3 m, floor at z = 0, a person 0.8 m wide at y = 4, sky above."""
    camera = view(width, height)
    rays = camera.rays().astype(np.float64)
    shape = (height, width)
    ids, surface = np.zeros(shape, np.uint16), np.zeros(shape, np.uint8)
    depth, normal = np.full(shape, FAR, np.float32), np.zeros((*shape, 3), np.float16)
    albedo, material = np.zeros((*shape, 3), np.float16), np.zeros(shape, np.uint16)

    def paint(hit, at, gid, kind, facing, color):
        ids[hit], surface[hit], material[hit] = gid, kind, gid
        depth[hit] = at[hit] if isinstance(at, np.ndarray) else at
        normal[hit], albedo[hit] = facing, color

    at_wall = camera.eye + rays * 8.0
    paint(at_wall[..., 2] < 3.0, 8.0, WALL, Surface.SET, (0, -1, 0), (0.5, 0.45, 0.4))
    with np.errstate(divide="ignore"):
        to_floor = np.where(rays[..., 2] < 0, -1.6 / rays[..., 2], np.inf)
    paint(to_floor < 8.0, to_floor, FLOOR, floor, (0, 0, 1), (0.3, 0.3, 0.3))
    at_person = camera.eye + rays * 4.0
    body = (np.abs(at_person[..., 0]) < 0.4) & (at_person[..., 2] < 1.8) & (at_person[..., 2] > 0)
    paint(body, 4.0, PERSON, Surface.CLOTH, (0, -1, 0), (0.2, 0.05, 0.05))
    offset = at_person - np.array(HEAD)
    face = (offset**2).sum(axis=2) < 0.14**2
    paint(face, 4.0, PERSON, Surface.SKIN, (0, -1, 0), (0.6, 0.4, 0.3))
    glow, none, all_of = np.zeros((4, 3), np.float32), np.zeros(4, np.float32), np.ones(4, np.float32)
    return GBuffer(camera, ids, surface, material, depth, normal, albedo, glow, none, all_of, 0.3 * all_of)
