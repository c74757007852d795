"""Set piece builders: fixed parts of rooms: ceiling lights, boards, drapes, banners, torches, altars."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.joinery import folded_cloth
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.tags import Surface


@piece("ceiling_light")
def ceiling_light(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a light under the ceiling (z = 0 is the ceiling). Parameters: modern (a tube) or not (a globe)."""
    if spec.flag("modern"):
        builder.box(finish("metal_grey"), (0, 0, -0.03), (1.24, 0.3, 0.06), bevel=0.01)
        builder.box(finish("lamp_cool"), (0, 0, -0.065), (1.16, 0.22, 0.02))
    else:
        builder.lathe(finish("brass"), [(0.1, 0), (0.09, -0.03), (0.03, -0.05), (0.03, -0.1)], caps=False)
        builder.sphere(finish("lampshade"), (0, 0, -0.2), 0.13, segments=18, rings=10)


@piece("bed_rail_light")
def bed_rail_light(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the light and rail over a hospital bed, on a wall at y = 0."""
    builder.box(finish("metal_grey"), (0, -0.03, 0), (1.5, 0.06, 0.16), bevel=0.01)
    builder.box(finish("lamp_warm"), (0, -0.07, 0.03), (0.7, 0.04, 0.06))
    for x in (-0.6, -0.45, 0.5, 0.62):
        builder.cylinder(finish("chrome"), (x, -0.06, -0.02), (x, -0.1, -0.02), 0.02, segments=10)


@piece("chain")
def chain(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a chain from z = 0. Parameters: length."""
    length = max(0.1, spec.number("length", 0.5))
    builder.cylinder(finish("iron"), (0, 0, -length), (0, 0, 0), 0.012, segments=6)
    for z in np.arange(-length + 0.03, 0, 0.07):
        builder.sphere(finish("iron"), (0, 0, float(z)), 0.02, segments=8, rings=5)


@piece("dark_mirror")
def dark_mirror(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a one-way mirror on a wall at y = 0. Parameters: width, height."""
    width, height = spec.number("width", 2.0), spec.number("height", 1.0)
    builder.box(finish("glass_dark"), (0, -0.012, height / 2), (width, 0.02, height))
    frame = finish("metal_grey")
    for z in (0, height):
        builder.box(frame, (0, -0.02, z), (width + 0.1, 0.05, 0.05))
    for x in (-width / 2, width / 2):
        builder.box(frame, (x, -0.02, height / 2), (0.05, 0.05, height))


@piece("pipes")
def pipes(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Run pipes along x at y = 0, or up a wall. Parameters: length, vertical."""
    length, iron = spec.number("length", 4), finish("rust")
    if spec.flag("vertical"):
        builder.cylinder(iron, (0, 0, 0.1), (0, 0, length), 0.05, segments=10)
        for z in np.arange(1.0, length, 2.2):
            builder.box(finish("iron"), (0, 0, float(z)), (0.14, 0.14, 0.04))
        return
    for index, radius in enumerate((0.055, 0.035)):
        y, z = -0.05 - 0.02 * index, -0.16 * index
        builder.cylinder(iron, (-length / 2, y, z), (length / 2, y, z), radius, segments=10)
    for x in np.arange(-length / 2 + 0.4, length / 2, 1.6):
        builder.box(finish("iron"), (float(x), 0, -0.06), (0.05, 0.14, 0.34))


@piece("drape", Surface.CLOTH)
def drape(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a stage drape along x from ``height`` to the floor. Parameters: width, height, color."""
    width, height = spec.number("width", 4), spec.number("height", 4)
    folded_cloth(builder, spec.paint("color", "#741a22"), -width / 2, width / 2, 0, 0.03, height, depth=0.09)


@piece("valance", Surface.CLOTH)
def valance(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a short cloth over a stage, its lower edge at z = 0. Parameters: width, height, color."""
    width, height = spec.number("width", 6), spec.number("height", 0.8)
    cloth = spec.paint("color", "#741a22")
    folded_cloth(builder, cloth, -width / 2, width / 2, 0, 0, height, depth=0.07)
    builder.box(finish("brass"), (0, -0.08, 0.02), (width, 0.02, 0.05))


@piece("footlight")
def footlight(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build one footlight that shines to +Y."""
    builder.lathe(finish("iron"), [(0.09, -0.1), (0.13, 0.06)], origin=(0, 0, 0.12), axis=(0, 1, 0.5))
    builder.sphere(finish("lamp_warm"), (0, 0.05, 0.14), 0.05, segments=10, rings=6)


@piece("banner", Surface.CLOTH)
def banner(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a banner down from z = 0 on a wall at y = 0. Parameters: width, length, color."""
    width, length, cloth = spec.number("width", 0.9), spec.number("length", 2.4), spec.paint("color", "#7a1d20")
    half = width / 2
    rows = [(-half, half, 0.0), (-half, half, -length * 0.45), (-half, half, -length * 0.85)]
    for (a0, b0, z0), (a1, b1, z1) in pairwise(rows):
        builder.quad(cloth, (a1, -0.05, z1), (b1, -0.05, z1), (b0, -0.05, z0), (a0, -0.05, z0))
    z = -length * 0.85
    builder.polygon(
        cloth,
        [(-half, -0.05, z), (-half, -0.05, -length), (0, -0.05, z - 0.02), (half, -0.05, -length), (half, -0.05, z)],
    )
    gold = finish("gold")
    builder.cylinder(gold, (-half - 0.1, -0.05, 0.02), (half + 0.1, -0.05, 0.02), 0.025, segments=8)
    profile = [(width * 0.26, 0), (width * 0.26, 0.008)]
    builder.lathe(gold, profile, origin=(0, -0.055, -length * 0.4), axis=(0, -1, 0), segments=24)
    builder.lathe(
        cloth, [(width * 0.2, 0), (width * 0.2, 0.012)], origin=(0, -0.056, -length * 0.4), axis=(0, -1, 0), segments=24
    )
    builder.box(gold, (0, -0.062, -length * 0.4), (width * 0.09, 0.012, width * 0.34))
    builder.box(gold, (0, -0.062, -length * 0.38), (width * 0.28, 0.012, width * 0.09))


@piece("luggage_rack")
def luggage_rack(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a rack along x on a wall at y = 0. Parameters: length."""
    length, brass = spec.number("length", 6), finish("brass")
    for y in (-0.05, -0.2, -0.35):
        builder.cylinder(brass, (-length / 2, y + 0.2, 0), (length / 2, y + 0.2, 0), 0.012, segments=8)
    for x in np.linspace(-length / 2 + 0.2, length / 2 - 0.2, max(2, round(length / 1.2))):
        builder.tube(brass, [(x, 0.2, -0.15), (x, -0.15, 0), (x, -0.17, 0.08)], 0.012)
    for x, wide, finish_key in (
        (-length * 0.33, 0.6, "leather"),
        (length * 0.05, 0.5, "paint_green"),
        (length * 0.3, 0.66, "wood"),
    ):
        builder.box(finish(finish_key), (x, 0.02, 0.14), (wide, 0.32, 0.24), bevel=0.03)


@piece("straw", Surface.NO_INK)
def straw(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Scatter straw on the floor."""
    for _ in range(60):
        x, y, angle = spec.rng.uniform(-0.8, 0.8), spec.rng.uniform(-0.5, 0.5), spec.rng.uniform(0, math.pi)
        dx, dy = 0.14 * math.cos(angle), 0.14 * math.sin(angle)
        builder.quad(
            finish("thatch"),
            (x - dx, y - dy, 0.01),
            (x + dy * 0.05, y - dx * 0.05, 0.01),
            (x + dx, y + dy, 0.02),
            (x - dy * 0.05, y + dx * 0.05, 0.01),
        )
