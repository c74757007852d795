"""Set piece builders: parts of streets, bridges and roofs: columns, arcades, parapets, railings, fences, hedges."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.tags import Surface
from storyblender.catalog.arcades import arch_radius, piers


@piece("column")
def column(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a column. Parameters: height, width, material, style (round, gothic, post, girder, square)."""
    height, width, skin = spec.number("height", 3.5), spec.number("width", 0.5), spec.finish("material", "stone")
    style = spec.word("style", "round")
    if style == "post":
        builder.box(skin, (0, 0, height / 2), (width, width, height), bevel=0.02)
        for side in (-1, 1):
            builder.box(skin, (side * 0.4, 0, height - 0.42), (0.14, 0.12, 1.1), rotation=(0, 45 * side, 0))
    elif style == "square":
        builder.box(skin, (0, 0, height / 2), (width, width, height), bevel=0.02)
        for z in (0.35, 1.15):
            band = finish("paint_yellow" if z < 1 else "paint_black")
            builder.box(band, (0, 0, z), (width + 0.01, width + 0.01, 0.3))
    elif style == "girder":
        for y in (-width / 2, width / 2):
            builder.box(skin, (0, y, height / 2), (width, 0.025, height))
        builder.box(skin, (0, 0, height / 2), (0.025, width, height))
        builder.box(finish("concrete"), (0, 0, 0.2), (width + 0.15, width + 0.15, 0.4), bevel=0.02)
    else:
        radius = width / 2
        builder.box(skin, (0, 0, 0.14), (width * 1.35, width * 1.35, 0.28), bevel=0.03)
        builder.box(skin, (0, 0, height - 0.14), (width * 1.4, width * 1.4, 0.28), bevel=0.03)
        profile = [
            (radius * 1.2, 0.28), (radius * 1.2, 0.36), (radius, 0.46), (radius * 0.9, height - 0.55),
            (radius * 1.2, height - 0.4), (radius * 1.3, height - 0.28),
        ]  # fmt: skip
        builder.lathe(skin, profile, segments=8 if style == "gothic" else 22)
        if style == "gothic":
            for k in range(4):
                x, y = radius * math.cos(math.pi * (k + 0.5) / 2), radius * math.sin(math.pi * (k + 0.5) / 2)
                builder.cylinder(skin, (x, y, 0.4), (x * 0.92, y * 0.92, height - 0.4), radius * 0.32, segments=10)


@piece("arcade")
def arcade(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a wall of round arches along x. Parameters: width, height, arches, depth, material, trim."""
    width, height, depth = spec.number("width", 10), spec.number("height", 3.5), spec.number("depth", 0.32)
    count, skin, trim = (
        int(spec.number("arches", 3)),
        spec.finish("material", "plaster"),
        spec.finish("trim", "paint_cream"),
    )
    bay = width / count
    radius = arch_radius(width, height, count)
    spring = height - radius - 0.55
    left = -width / 2
    for x0, x1 in piers(width, height, count):
        builder.box(skin, ((x0 + x1) / 2, 0, height / 2), (x1 - x0, depth, height))
        builder.box(trim, ((x0 + x1) / 2, 0, 0.08), (x1 - x0 + 0.04, depth + 0.04, 0.16))
        builder.box(trim, ((x0 + x1) / 2, 0, spring - 0.04), (x1 - x0 + 0.06, depth + 0.06, 0.08))
    for index in range(count):
        middle = left + bay * (index + 0.5)
        curve = [
            (middle - radius * math.cos(math.pi * k / 16), spring + radius * math.sin(math.pi * k / 16))
            for k in range(17)
        ]
        for (x0, z0), (x1, z1) in pairwise(curve):
            f, b = -depth / 2, depth / 2
            builder.quad(skin, (x0, f, z0), (x1, f, z1), (x1, f, height), (x0, f, height))
            builder.quad(skin, (x1, b, z1), (x0, b, z0), (x0, b, height), (x1, b, height))
            builder.quad(skin, (x0, b, z0), (x1, b, z1), (x1, f, z1), (x0, f, z0))
        ring = [(x + (x - middle) * 0.05, -depth / 2 - 0.015, z + (z - spring) * 0.05) for x, z in curve]
        builder.tube(trim, ring, 0.045, segments=6)


@piece("parapet")
def parapet(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a low wall with a coping along x. Parameters: length, height, material."""
    length, height = spec.number("length", 6), spec.number("height", 1.0)
    builder.box(spec.finish("material", "brick"), (0, 0, height / 2), (length, 0.3, height))
    builder.box(finish("stone_light"), (0, 0, height + 0.05), (length + 0.06, 0.42, 0.1), bevel=0.015)


@piece("railing")
def railing(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a metal railing along x. Parameters: length, height, material."""
    length, height, metal = spec.number("length", 6), spec.number("height", 1.05), spec.finish("material", "iron")
    builder.box(metal, (0, 0, height), (length, 0.07, 0.06), bevel=0.012)
    builder.box(metal, (0, 0, 0.12), (length, 0.04, 0.04))
    builder.box(metal, (0, 0, height - 0.16), (length, 0.03, 0.03))
    step = 0.16 if length < 30 else 0.28
    for x in np.arange(-length / 2 + step / 2, length / 2, step):
        builder.box(metal, (x, 0, height / 2), (0.022, 0.022, height - 0.02))
    for x in np.arange(-length / 2, length / 2 + 0.1, max(2.0, length / max(1, round(length / 2.4)))):
        builder.box(metal, (x, 0, height / 2 + 0.04), (0.08, 0.08, height + 0.1), bevel=0.01)


@piece("bulwark")
def bulwark(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the planked side of a ship along x. Parameters: length, height, material."""
    length, height = spec.number("length", 6), spec.number("height", 1.0)
    builder.box(finish("boards_dark"), (0, 0, height / 2), (length, 0.1, height))
    builder.box(spec.finish("material", "wood_dark"), (0, 0, height + 0.05), (length + 0.05, 0.26, 0.09), bevel=0.02)
    for x in np.linspace(-length / 2 + 0.3, length / 2 - 0.3, max(2, int(length / 1.3))):
        for side in (-1, 1):
            builder.box(finish("wood_dark"), (x, side * 0.09, height / 2), (0.12, 0.1, height))
    builder.box(finish("boards_dark"), (0, 0, -0.9), (length, 0.16, 1.8))


@piece("fence")
def fence(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build one bay of a rail fence along x. Parameters: width."""
    width, wood = spec.number("width", 2.0), finish("wood_gray")
    for x in (-width / 2, width / 2):
        builder.box(wood, (x, 0, 0.55), (0.11, 0.11, 1.3), bevel=0.015)
    for z, tilt in ((0.45, 0.6), (0.85, -0.5), (1.1, 0.3)):
        builder.box(wood, (0, -0.06, z), (width, 0.045, 0.1), rotation=(0, tilt, 0), bevel=0.008)


@piece("hedge", Surface.FOLIAGE)
def hedge(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a clipped hedge along x with an uneven skin. Parameters: width, height."""
    width, height = spec.number("width", 2.6), spec.number("height", 1.0)
    count, leaf = max(6, int(width / 0.18)), spec.leaf("hedge")
    xs, rings = np.linspace(-width / 2 - 0.05, width / 2 + 0.05, count), []
    outline = [
        (-0.36, 0), (-0.38, 0.35), (-0.37, 0.75), (-0.28, 0.97), (0, 1.0), (0.28, 0.97), (0.37, 0.75), (0.38, 0.35),
        (0.36, 0),
    ]  # fmt: skip
    for x in xs:
        wobble = spec.rng.uniform(-0.035, 0.035, (len(outline), 2))
        rings.append([(x, y + dy, z * height + dz * (z > 0)) for (y, z), (dy, dz) in zip(outline, wobble, strict=True)])
    builder.loft(leaf, rings)


@piece("kerb")
def kerb(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a kerb of stones along x. Parameters: length."""
    length = spec.number("length", 80)
    builder.box(finish("stone_light"), (0, -0.08, 0.02), (length, 0.16, 0.04))
    builder.box(finish("asphalt"), (0, -0.28, 0.003), (length, 0.24, 0.004))


@piece("road_marking")
def road_marking(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Paint a broken line along x. Parameters: length."""
    length, white = spec.number("length", 80), finish("paint_cream")
    for x in np.arange(-length / 2, length / 2, 4.0):
        builder.quad(white, (x, -0.07, 0.006), (x + 1.8, -0.07, 0.006), (x + 1.8, 0.07, 0.006), (x, 0.07, 0.006))


@piece("runway_paint")
def runway_paint(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Paint an unbroken line along x. Parameters: length, color."""
    half = spec.number("length", 100) / 2
    builder.quad(
        spec.paint("color", "#d9d5ca"),
        (-half, -0.1, 0.006),
        (half, -0.1, 0.006),
        (half, 0.1, 0.006),
        (-half, 0.1, 0.006),
    )


@piece("puddle", Surface.WET)
def puddle(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lay a puddle of uneven outline."""
    angle = np.linspace(0, 2 * math.pi, 28, endpoint=False)
    radius = 0.8 * (1 + 0.22 * np.sin(3 * angle) + 0.1 * np.sin(5 * angle + 1))
    outline = np.c_[radius * np.cos(angle), 0.6 * radius * np.sin(angle), np.full(28, 0.006)]
    builder.polygon(finish("glass_dark"), outline)


@piece("pier")
def pier(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a pier that carries a bridge. Parameters: depth, material."""
    depth, stone = spec.number("depth", 6), spec.finish("material", "stone")
    builder.box(stone, (0, 0, 2.9), (2.2, depth, 5.8), taper=0.9)
    builder.box(stone, (0, 0, 5.4), (3.4, depth + 0.2, 0.9), taper=1.3)


@piece("chimney")
def chimney(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a brick chimney with two pots. Parameters: height."""
    height, brick = spec.number("height", 1.8), finish("brick_brown")
    builder.box(brick, (0, 0, height / 2), (0.9, 0.6, height))
    builder.box(brick, (0, 0, height - 0.12), (1.02, 0.72, 0.16))
    for x in (-0.22, 0.22):
        outline = [(0.14, height), (0.13, height + 0.4), (0.16, height + 0.45)]
        builder.lathe(finish("tile_terracotta"), outline, segments=14)
        with builder.at((x, 0, 0)):
            profile = [(0.15, height), (0.12, height + 0.42), (0.15, height + 0.46)]
            builder.lathe(finish("tile_terracotta"), profile, segments=14)


@piece("vent")
def vent(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a box with a turning cowl, on a roof or a deck."""
    metal = finish("metal_grey")
    builder.box(metal, (0, 0, 0.3), (0.75, 0.75, 0.6), bevel=0.02)
    builder.lathe(metal, [(0.22, 0.6), (0.22, 0.85), (0.34, 0.95), (0.36, 1.1), (0.2, 1.3), (0.02, 1.36)], segments=16)


@piece("water_tank")
def water_tank(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a wooden water tank on iron legs."""
    iron, wood = finish("iron"), finish("boards_grey")
    for x in (-0.85, 0.85):
        for y in (-0.85, 0.85):
            builder.cylinder(iron, (x, y, 0), (x * 0.9, y * 0.9, 2.1), 0.06, segments=8)
    for side in (-1, 1):
        builder.cylinder(iron, (-0.85, side * 0.85, 0.3), (0.85, side * 0.8, 1.8), 0.03, segments=6)
        builder.cylinder(iron, (side * 0.85, -0.85, 0.3), (side * 0.8, 0.85, 1.8), 0.03, segments=6)
    builder.lathe(wood, [(1.2, 2.1), (1.2, 4.6)], segments=20)
    for z in (2.3, 3.0, 3.7, 4.4):
        builder.lathe(iron, [(1.2, z), (1.23, z + 0.02), (1.23, z + 0.06), (1.2, z + 0.08)], segments=20, caps=False)
    builder.lathe(finish("roof_slate"), [(1.34, 4.6), (0.05, 5.6)], segments=20)


@piece("stair_house")
def stair_house(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the little house over a roof's stairs, its door at -Y."""
    brick = finish("brick_brown")
    builder.box(brick, (0, 0, 1.25), (2.6, 2.6, 2.5))
    builder.box(finish("concrete"), (0, -0.05, 2.56), (2.9, 2.9, 0.12))
    builder.box(finish("metal_green"), (0, -1.31, 1.0), (0.95, 0.06, 2.0))
    builder.box(finish("paint_grey"), (0, -1.3, 2.05), (1.12, 0.08, 0.1))
    builder.sphere(finish("brass"), (0.36, -1.37, 1.0), 0.035, segments=10, rings=6)
    builder.lathe(finish("iron"), [(0.03, 0.1), (0.13, 0.0)], origin=(0, -1.45, 2.35), caps=False)
    builder.sphere(finish("lamp_warm"), (0, -1.45, 2.33), 0.06, segments=10, rings=6)


@piece("shed")
def shed(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a shed of corrugated sheet with a wide door at -Y. Parameters: width, depth, height."""
    width, depth, height = spec.number("width", 8), spec.number("depth", 6), spec.number("height", 4.2)
    tin, half = finish("sheet_metal"), width / 2
    builder.box(tin, (0, 0, height * 0.4), (width, depth, height * 0.8))
    roof = [(-half - 0.3, height * 0.78), (0, height), (half + 0.3, height * 0.78)]
    for (x0, z0), (x1, z1) in pairwise(roof):
        y = depth / 2 + 0.3
        builder.quad(tin, (x0, -y, z0), (x1, -y, z1), (x1, y, z1), (x0, y, z0))
    for y in (-depth / 2, depth / 2):
        builder.polygon(tin, [(-half, y, height * 0.8), (half, y, height * 0.8), (0, y, height)])
    builder.box(finish("boards_dark"), (0, -depth / 2 - 0.04, 1.3), (2.6, 0.06, 2.6))
    builder.box(finish("iron"), (0, -depth / 2 - 0.08, 2.66), (4.4, 0.06, 0.1))
    builder.box(spec.pane("pane_warm"), (half * 0.68, -depth / 2 - 0.02, 1.7), (1.0, 0.05, 0.8))
    builder.lathe(finish("iron"), [(0.04, 0.12), (0.2, 0.0)], origin=(0, -depth / 2 - 0.4, 3.2), caps=False)
    builder.sphere(finish("lamp_warm"), (0, -depth / 2 - 0.4, 3.17), 0.08, segments=10, rings=6)
