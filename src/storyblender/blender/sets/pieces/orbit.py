"""Set piece builders: what is seen outside a ship in space: modules, handrails, wings of cells, dishes, a planet."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("hull_rail")
def hull_rail(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Run a low handrail along x on short posts. Parameters: length."""
    length, yellow = spec.number("length", 6.0), finish("paint_yellow")
    builder.cylinder(yellow, (-length / 2, 0, 0.28), (length / 2, 0, 0.28), 0.022, segments=8)
    for x in np.linspace(-length / 2, length / 2, max(2, round(length / 1.1))):
        builder.cylinder(yellow, (float(x), 0, 0), (float(x), 0, 0.28), 0.018, segments=8)
        builder.box(finish("metal_grey"), (float(x), 0, 0.01), (0.12, 0.12, 0.02))


@piece("hull_module")
def hull_module(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a round module along y, its hatch at -Y, on the hull. Parameters: radius, length."""
    r, length, shell = spec.number("radius", 1.8), spec.number("length", 4.0), finish("paint_white")
    half, middle = length / 2, r * 0.86
    builder.lathe(
        shell, [(r * 0.62, -half), (r, -half + 0.45), (r, half - 0.45), (r * 0.62, half)],
        origin=(0, 0, middle), axis=(0, 1, 0), segments=28,
    )  # fmt: skip
    for y in np.linspace(-half + 0.5, half - 0.5, 4):
        builder.lathe(finish("metal_grey"), [(r * 1.015, -0.05), (r * 1.015, 0.05)], origin=(0, float(y), middle),
                      axis=(0, 1, 0), segments=28, caps=False)  # fmt: skip
    builder.cylinder(finish("metal_grey"), (0, -half - 0.12, middle), (0, -half + 0.1, middle), r * 0.52, segments=24)
    builder.cylinder(finish("paint_black"), (0, -half - 0.14, middle), (0, -half - 0.1, middle), r * 0.44, segments=24)
    builder.cylinder(finish("lamp_cool"), (0, -half - 0.16, middle), (0, -half - 0.13, middle), r * 0.12, segments=16)


@piece("solar_wing")
def solar_wing(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a wing of solar cells along y on its boom. Parameters: length, width."""
    length, width = spec.number("length", 12.0), spec.number("width", 3.2)
    cell, frame = finish("cell_blue"), finish("gold")
    builder.cylinder(finish("metal_grey"), (0, -length / 2 - 1.2, 0), (0, length / 2, 0), 0.07, segments=8)
    count = max(2, round(length / 1.3))
    with builder.at(rotation=(0, -32, 0)):
        for side in (-1, 1):
            for index in range(count):
                y = -length / 2 + length * (index + 0.5) / count
                builder.box(cell, (side * (width / 4 + 0.1), y, 0), (width / 2, length / count - 0.08, 0.03))
            for x in (0.1, width / 2 + 0.1):
                builder.box(frame, (side * x, 0, 0.02), (0.04, length, 0.03))


@piece("dish")
def dish(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an antenna dish on its mast, aimed up and to -X. Parameters: radius."""
    r, white = spec.number("radius", 0.9), finish("paint_white")
    builder.cylinder(finish("metal_grey"), (0, 0, 0), (0, 0, 1.0), 0.06, segments=10)
    profile = [(0.03, 0.0), (r * 0.55, r * 0.1), (r, r * 0.34), (r * 0.97, r * 0.36), (r * 0.5, r * 0.13)]
    axis = (-0.6, -0.2, 0.77)
    builder.lathe(white, profile, origin=(0, 0, 1.02), axis=axis, segments=26)
    tip = tuple(0.6 * r * way for way in axis)
    builder.cylinder(finish("metal_grey"), (0, 0, 1.02), (tip[0], tip[1], 1.02 + tip[2]), 0.02, segments=8)


@piece("planet")
def planet(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a blue planet about the origin: seas, land in patches, bands of cloud. Parameters: radius."""
    r = spec.number("radius", 30.0)
    builder.sphere(finish("sea_blue"), (0, 0, 0), r, segments=64, rings=40)
    rng = spec.rng
    for skin, count, low, high, up in (("land_green", 26, 0.1, 0.3, 0.0), ("cloud_white", 46, 0.06, 0.2, 0.004)):
        for _ in range(count):
            turn, tilt = float(rng.uniform(0, math.tau)), float(np.arcsin(rng.uniform(-0.9, 0.9)))
            _patch(builder, skin, r * (1.0015 + up), turn, tilt, float(rng.uniform(low, high)), rng)


def _patch(
    builder: MeshBuilder, skin: str, r: float, turn: float, tilt: float, reach: float, rng: np.random.Generator
) -> None:
    """Lay a ragged patch on a sphere: a fan of rings about its middle; ``reach`` in radians."""
    around = np.linspace(0, math.tau, 22, endpoint=False)
    ragged = 1 + 0.3 * np.sin(2 * around + rng.uniform(0, 6)) + 0.22 * np.sin(5 * around + rng.uniform(0, 6))
    middle = np.array([math.cos(tilt) * math.cos(turn), math.cos(tilt) * math.sin(turn), math.sin(tilt)])
    east = np.array([-math.sin(turn), math.cos(turn), 0.0])
    north = np.cross(middle, east)
    rings = []
    for share in (0.02, 0.35, 0.7, 1.0):
        way = share * reach * ragged
        flat = np.outer(1.7 * way * np.cos(around), east) + np.outer(way * np.sin(around), north)
        points = middle + flat
        rings.append(r * points / np.linalg.norm(points, axis=1, keepdims=True))
    vertices = np.vstack(rings)
    count = len(around)
    faces = [
        (k * count + i, (k + 1) * count + i, (k + 1) * count + (i + 1) % count, k * count + (i + 1) % count)
        for k in range(len(rings) - 1)
        for i in range(count)
    ]
    builder.add(finish(skin), vertices, faces)
