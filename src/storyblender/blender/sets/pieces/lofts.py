"""Set piece builders: sloping roofs from below: rafters and boards, a skylight, the canvas of a tent."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, view_outside
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.catalog.materials import hex_color

_SKY = hex_color("#b9d0e6")


@piece("roof_slope")
def roof_slope(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build half a roof that rises towards -Y from z = ``eave`` at y = 0; its gutter runs along x.

    Parameters: length, run, eave, rise, material, rafters (0 for none), skylight.
    """
    length, run = spec.number("length", 6.0), spec.number("run", 3.0)
    eave, rise = spec.number("eave", 1.1), spec.number("rise", 2.0)
    slope, reach, skin = math.degrees(math.atan2(rise, run)), math.hypot(run, rise), spec.finish("material", "boards")
    with builder.at((0, 0, eave), (-slope, 0, 0)):  # -Y is up the slope, the room below
        half, hole = length / 2, 0.5 if spec.flag("skylight") else 0.0
        low, high = -reach * 0.42, -reach * 0.72
        for left, right, near, far in (
            (-half, -hole, 0.0, -reach), (hole, half, 0.0, -reach), (-hole, hole, 0.0, low),
            (-hole, hole, high, -reach),
        ):  # fmt: skip
            if right - left > 0.01:
                builder.quad(skin, (right, near, 0), (right, far, 0), (left, far, 0), (left, near, 0))
                builder.quad(skin, (left, near, 0.05), (left, far, 0.05), (right, far, 0.05), (right, near, 0.05))
        beam = finish("wood_dark")
        for x in np.linspace(-half + 0.1, half - 0.1, int(spec.number("rafters", 0))):
            if abs(x) > hole + 0.05:
                builder.box(beam, (float(x), -reach / 2, -0.07), (0.1, reach, 0.14))
        if spec.flag("rafters"):
            for share in (0.36, 0.8):
                builder.box(beam, (0, -reach * share, -0.1), (length, 0.12, 0.14))
        if hole:
            _skylight(builder, spec, hole, low, high)


def _skylight(builder: MeshBuilder, spec: PieceSpec, half: float, low: float, high: float) -> None:
    """Add a window in a roof, in the slope's frame, from ``low`` to ``high`` along y; ``half`` is half its width."""
    frame = finish("paint_white")
    middle, tall = (low + high) / 2, low - high
    sky = view_outside("skylight", _SKY, spec.scene)
    builder.quad(sky, (half, low, 0.03), (half, high, 0.03), (-half, high, 0.03), (-half, low, 0.03))
    for x in (-half, 0, half):
        builder.box(frame, (x, middle, -0.01), (0.06, tall + 0.06, 0.1))
    for y in (low, middle, high):
        builder.box(frame, (0, y, -0.01), (2 * half + 0.06, 0.06, 0.1))


@piece("collar_beam")
def collar_beam(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a tie beam along x at z = 0 with a post up from its middle. Parameters: length, post."""
    length, post, wood = spec.number("length", 4.0), spec.number("post", 0.8), finish("wood_dark")
    builder.box(wood, (0, 0, 0), (length, 0.16, 0.18), bevel=0.015)
    builder.box(wood, (0, 0, post / 2), (0.14, 0.14, post), bevel=0.012)
    for side in (-1, 1):
        builder.box(wood, (side * post * 0.3, 0, post * 0.36), (0.09, 0.1, post * 0.8), rotation=(0, -40 * side, 0))


@piece("floor_hatch")
def floor_hatch(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an open hatch in the floor with its ladder's head and its lid laid back towards +Y."""
    wood, dark = finish("wood"), finish("boards_dark")
    builder.box(finish("paint_black"), (0, 0, 0.004), (0.9, 0.9, 0.008))
    for x, y, wide, deep in ((-0.5, 0, 0.1, 1.1), (0.5, 0, 0.1, 1.1), (0, -0.5, 1.1, 0.1), (0, 0.5, 1.1, 0.1)):
        builder.box(wood, (x, y, 0.03), (wide, deep, 0.06))
    builder.box(dark, (0, 0.72, 0.46), (0.9, 0.05, 0.9), rotation=(-18, 0, 0))
    for x in (-0.22, 0.22):
        builder.cylinder(wood, (x, -0.3, 0), (x, -0.42, 0.85), 0.028, segments=8)
    for z in (0.2, 0.5):
        builder.cylinder(wood, (-0.22, -0.3 - 0.14 * z, z), (0.22, -0.3 - 0.14 * z, z), 0.02, segments=8)


@piece("tent_pole")
def tent_pole(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the poles of a ridge tent: a ridge along x at ``height`` and its post at +X; one at the other end would
    stand before the camera. Parameters: length, height."""
    length, height, wood = spec.number("length", 4.0), spec.number("height", 2.6), finish("wood_light")
    builder.cylinder(wood, (-length / 2, 0, height), (length / 2, 0, height), 0.035, segments=10)
    x = length / 2 - 0.12
    builder.cylinder(wood, (x, 0, 0), (x, 0, height), 0.04, segments=10)
    builder.tube(finish("canvas"), [(x, 0.05, height - 0.3), (x * 0.97, 0.06, height - 0.34)], 0.05, segments=8)


@piece("cave_wall")
def cave_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a rough rock wall along x that stands at y = 0 and leans over the room at -Y. Parameters: length, height,
    vault (metres it comes over), mouth (width of a hole in its middle), seed."""
    length, height, vault = spec.number("length", 8.0), spec.number("height", 3.2), spec.number("vault", 1.2)
    mouth, stone = spec.number("mouth", 0.0), finish("cave_rock")
    xs, zs = np.linspace(-length / 2, length / 2, max(14, int(length / 0.32))), np.linspace(0, 1, 12)
    grid_x, grid_z = np.meshgrid(xs, zs)
    bumps = sum(
        spec.rng.uniform(0.4, 1.0) * np.sin(grid_x * fx + spec.rng.uniform(0, 6.3)) * np.sin(grid_z * fz + phase)
        for fx, fz, phase in ((0.9, 2.2, 0.4), (1.9, 4.1, 1.3), (3.7, 6.0, 2.2), (6.5, 9.0, 0.9))
    )
    rough = spec.rng.normal(0, 0.05, grid_x.shape)
    out = 0.3 + 0.13 * bumps + rough + 0.28 * (1 - grid_z) ** 3 + vault * grid_z**3
    points = np.stack([grid_x, -np.maximum(out, 0.05), grid_z * (height + 0.1) - 0.02], -1)
    if mouth:  # the rock draws back from the hole
        half = mouth / 2 * np.sqrt(np.clip(1 - (grid_z / 0.82) ** 2, 0, 1))
        side = np.where(grid_x < 0, -1.0, 1.0)
        inside = np.abs(grid_x) < half
        points[..., 0] = np.where(inside, side * half, points[..., 0])
    columns = len(xs)
    faces = [
        (r * columns + c, r * columns + c + 1, (r + 1) * columns + c + 1, (r + 1) * columns + c)
        for r in range(len(zs) - 1)
        for c in range(columns - 1)
        if not mouth or abs((xs[c] + xs[c + 1]) / 2) > mouth / 2 * math.sqrt(max(0.0, 1 - ((zs[r] + 0.02) / 0.82) ** 2))
    ]
    builder.add(stone, points.reshape(-1, 3), faces)


@piece("stalactites")
def stalactites(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang cones of rock down from z = 0 about the origin. Parameters: reach, count, seed."""
    reach = spec.number("reach", 1.0)
    for _ in range(int(spec.number("count", 7))):
        x, y = (float(value) for value in spec.rng.uniform(-reach, reach, 2))
        long, thick = float(spec.rng.uniform(0.25, 0.9)), float(spec.rng.uniform(0.08, 0.2))
        profile = [(thick * 1.6, 0.1), (thick, -0.08), (thick * 0.45, -long * 0.5), (0.012, -long)]
        builder.lathe(finish("cave_rock"), profile, origin=(x, y, 0), segments=9)
