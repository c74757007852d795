"""Set piece builders: trenches, and what grows under glass: earth walls with sandbags, wire, benches of plants."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, view_outside
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.catalog.materials import hex_color

_SKY = hex_color("#b9d0e6")


@piece("trench_wall")
def trench_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the wall of a trench along x that faces -Y: planks and posts, sandbags above, land behind. Parameters:
    length, height, seed."""
    length, height, rng = spec.number("length", 8.0), spec.number("height", 1.75), spec.rng
    builder.box(finish("mud"), (0, 2.1, height / 2 - 0.02), (length, 4.0, height))
    for z in np.arange(0.12, height - 0.1, 0.24):
        builder.box(finish("planks_gray"), (0, 0.05, float(z)), (length, 0.06, 0.2 + float(rng.uniform(-0.02, 0.02))))
    for x in np.arange(-length / 2 + 0.4, length / 2, 1.6):
        builder.cylinder(finish("wood_gray"), (float(x), 0.0, 0), (float(x), 0.02, height + 0.1), 0.06, segments=8)
    for row in range(3):
        start = -length / 2 + (0.3 if row % 2 else 0.0)
        for x in np.arange(start, length / 2, 0.58):
            builder.cushion(
                finish("canvas"), (float(x), 0.2 + 0.06 * row, height + 0.09 + 0.17 * row), (0.6, 0.36, 0.21),
                softness=0.5, rotation=(0, 0, float(rng.uniform(-9, 9))),
            )  # fmt: skip


@piece("barbed_wire")
def barbed_wire(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Run coils of wire along x between leaning posts. Parameters: length."""
    length, iron = spec.number("length", 5.0), finish("iron")
    for x, lean in ((-length / 2, 0.12), (0.0, -0.1), (length / 2, 0.06)):
        builder.cylinder(finish("wood_gray"), (x, 0, -0.1), (x + lean, 0.05, 1.1), 0.05, segments=7)
    turns = np.linspace(0, length * 2 * math.pi * 1.2, int(length * 22))
    coil = np.c_[np.linspace(-length / 2, length / 2, len(turns)), 0.4 * np.cos(turns), 0.48 + 0.4 * np.sin(turns)]
    builder.tube(iron, coil, 0.009, segments=4)


@piece("plant_bench")
def plant_bench(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a slatted bench of pots along x. Parameters: length, variant."""
    length, wood = spec.number("length", 4.0), finish("wood_gray")
    for y in np.linspace(-0.32, 0.32, 6):
        builder.box(wood, (0, float(y), 0.78), (length, 0.09, 0.03))
    for x in np.linspace(-length / 2 + 0.1, length / 2 - 0.1, max(2, round(length / 1.4))):
        for y in (-0.3, 0.3):
            builder.box(wood, (float(x), y, 0.38), (0.07, 0.07, 0.76))
    for x in np.arange(-length / 2 + 0.2, length / 2 - 0.1, 0.3):
        for y in (-0.18, 0.17):
            _pot(builder, spec, float(x + spec.rng.uniform(-0.04, 0.04)), y)


def _pot(builder: MeshBuilder, spec: PieceSpec, x: float, y: float) -> None:
    """Add a flower pot with its plant at ``x``, ``y``."""
    wide, rng = float(spec.rng.uniform(0.08, 0.12)), spec.rng
    profile = [(wide * 0.7, 0), (wide, wide * 1.6), (wide * 1.12, wide * 1.6), (wide * 1.1, wide * 1.9)]
    builder.lathe(finish("clay"), profile, origin=(x, y, 0.795), segments=12)
    foot, tall = 0.795 + wide * 1.8, float(rng.uniform(0.16, 0.5))
    leaf = finish(str(rng.choice(("hedge", "leaf", "grass_lush"))))
    for turn in np.arange(0, 2 * math.pi, 0.7):
        reach, up = float(rng.uniform(0.06, 0.2)), float(rng.uniform(0.5, 1.0)) * tall
        root = np.array((x, y, foot))
        tip = root + np.array((reach * math.cos(turn), reach * math.sin(turn), up))
        side = np.array((-math.sin(turn), math.cos(turn), 0.0)) * 0.035
        middle = root * 0.45 + tip * 0.55 + (0, 0, 0.05)
        builder.polygon(leaf, [root, middle - side, tip, middle + side])
        builder.polygon(leaf, [root, middle + side, tip, middle - side])
    if rng.random() < 0.45:
        bloom = finish(str(rng.choice(("paint_red", "paint_yellow", "paint_white", "velvet_red"))))
        for _ in range(3):
            dx, dy = (float(value) for value in rng.uniform(-0.08, 0.08, 2))
            builder.sphere(bloom, (x + dx, y + dy, foot + tall), 0.035, segments=8, rings=5)


@piece("glass_roof")
def glass_roof(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build half a glass roof that rises towards -Y from z = ``eave`` at y = 0. Parameters: length, run, eave, rise."""
    length, run = spec.number("length", 6.0), spec.number("run", 3.0)
    eave, rise, white = spec.number("eave", 2.4), spec.number("rise", 1.2), finish("paint_white")
    slope, reach, half = math.degrees(math.atan2(rise, run)), math.hypot(run, rise), spec.number("length", 6.0) / 2
    sky = view_outside("skylight", _SKY, spec.scene)
    with builder.at((0, 0, eave), (-slope, 0, 0)):
        builder.quad(sky, (half, 0, 0.02), (half, -reach, 0.02), (-half, -reach, 0.02), (-half, 0, 0.02))
        for x in np.linspace(-half, half, max(3, round(length / 0.8))):
            builder.box(white, (float(x), -reach / 2, -0.02), (0.05, reach, 0.09))
        for share in (0.0, 0.33, 0.66, 1.0):
            builder.box(white, (0, -reach * share, -0.02), (length, 0.06, 0.08))
