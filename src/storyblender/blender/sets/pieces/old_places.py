"""Set piece builders: castles, ruins, villages and farms: walls with battlements, towers, broken arches, barns."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece

_WARES = {
    "fruit": ("#b8322a", "#d88a22", "#7fa03a", "#e0c23a"),
    "cloth": ("#6b3a7a", "#2f6f8a", "#b0564a", "#c9a24a"),
    "pots": ("#8a5a34", "#6b4a30", "#a8703f", "#57606a"),
}


@piece("castle_wall")
def castle_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a wall with battlements along x that faces -Y at y = 0. Parameters: length, height, gate (with an arch and
    portcullis in its middle)."""
    length, height, stone = spec.number("length", 20), spec.number("height", 7), finish("stone")
    gate = 3.4 if spec.flag("gate") else 0.0
    for side in (-1, 1):
        wide = (length - gate) / 2
        builder.box(stone, (side * (gate + wide) / 2, 0.9, height / 2), (wide, 1.8, height))
    if gate:
        builder.box(stone, (0, 0.9, (4.0 + height) / 2), (gate, 1.8, height - 4.0))
        for k in range(10):
            t = math.pi * (k + 0.5) / 10
            x, z = 1.75 * math.cos(t), 2.4 + 1.75 * math.sin(t)
            builder.box(finish("stone_light"), (x, -0.05, z), (0.34, 0.3, 0.5), rotation=(0, 90 - math.degrees(t), 0))
        builder.box(finish("plaster_soot"), (0, 1.7, 2.0), (gate, 0.1, 4.0))
        for x in np.arange(-1.5, 1.6, 0.38):
            builder.box(finish("iron"), (float(x), 0.5, 2.9), (0.06, 0.06, 2.2))
        for z in np.arange(2.0, 4.0, 0.45):
            builder.box(finish("iron"), (0, 0.5, float(z)), (gate, 0.05, 0.05))
    for x in np.arange(-length / 2 + 0.5, length / 2, 1.5):
        builder.box(stone, (float(x), 0.2, height + 0.4), (0.85, 0.42, 0.8))
    builder.box(finish("stone_light"), (0, 0.2, height - 0.06), (length, 0.6, 0.14))
    for x in np.arange(-length / 2 + 2.5, length / 2 - 1, 4.5):
        if abs(x) > gate:
            builder.box(finish("plaster_soot"), (float(x), -0.005, height * 0.6), (0.14, 0.03, 1.0))


@piece("round_tower")
def round_tower(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a round tower with battlements or a roof. Parameters: radius, height, roof (a cone of tiles)."""
    radius, height, stone = spec.number("radius", 2.6), spec.number("height", 11), finish("stone")
    outline = [
        (radius * 1.06, -0.1), (radius, 1.0), (radius, height), (radius * 1.12, height + 0.5),
        (radius * 1.12, height + 1.2),
    ]  # fmt: skip
    builder.lathe(stone, outline, segments=26)
    if spec.flag("roof"):
        profile = [(radius * 1.3, height + 1.1), (radius * 0.55, height + radius * 1.6), (0.02, height + radius * 2.6)]
        builder.lathe(finish("roof_slate"), profile, segments=24, caps=False)
    else:
        for t in np.arange(0, 2 * math.pi, 0.5):
            x, y = radius * 1.02 * math.cos(t), radius * 1.02 * math.sin(t)
            builder.box(stone, (x, y, height + 1.55), (0.7, 0.4, 0.75), rotation=(0, 0, math.degrees(t) + 90))
    for z in np.arange(2.6, height, 2.8):
        builder.box(finish("plaster_soot"), (0, -radius, float(z)), (0.22, 0.1, 1.0))


@piece("ruin_arch")
def ruin_arch(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a broken stone arch across x. Parameters: width, height, seed."""
    width, height, rng = spec.number("width", 3.4), spec.number("height", 4.4), spec.rng
    stone, radius = finish("stone_light"), spec.number("width", 3.4) / 2
    for side, tall in ((-1, height - radius), (1, height - radius)):
        z = 0.0
        while z < tall:
            high = float(rng.uniform(0.4, 0.6))
            wide = float(rng.uniform(0.72, 0.86))
            builder.box(stone, (side * (radius + 0.36), 0, z + high / 2), (wide, wide, high - 0.02), bevel=0.03)
            z += high
    for k in range(11):
        t = math.pi * (k + 0.5) / 11
        if k in (7, 8):  # fallen
            continue
        x, z = (radius + 0.36) * math.cos(t), height - radius + (radius + 0.36) * math.sin(t)
        builder.box(stone, (x, 0, z), (0.62, 0.74, 0.58), rotation=(0, 90 - math.degrees(t), 0), bevel=0.03)
    for _ in range(5):
        x, y, size = (
            float(v) for v in (rng.uniform(-width * 0.7, width * 0.7), rng.uniform(-1.3, 1.0), rng.uniform(0.25, 0.55))
        )
        center = (x, y, size * 0.32)
        builder.box(
            stone, center, (size, size * 0.8, size * 0.7), rotation=(8, -12, float(rng.uniform(0, 90))), bevel=0.03
        )


@piece("ruin_wall")
def ruin_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a wall along x broken off unevenly, with a window. Parameters: length, height, material, seed."""
    length, height, rng = spec.number("length", 6), spec.number("height", 4), spec.rng
    stone, step, top = spec.finish("material", "stone_light"), 0.7, height * 0.8
    for x in np.arange(-length / 2 + step / 2, length / 2, step):
        top = float(np.clip(top + rng.uniform(-0.7, 0.7), height * 0.35, height))
        hole = abs(float(x) - length * 0.12) < 0.55 and top > 2.6
        if hole:
            builder.box(stone, (float(x), 0, 0.55), (step, 0.6, 1.1))
            builder.box(stone, (float(x), 0, (2.4 + top) / 2), (step, 0.6, top - 2.4))
        else:
            builder.box(stone, (float(x), 0, top / 2), (step + 0.005, 0.6, top))
    for _ in range(7):
        x, size = float(rng.uniform(-length / 2, length / 2)), float(rng.uniform(0.2, 0.5))
        builder.box(
            stone, (x, -0.7 - size, size * 0.3), (size, size * 0.8, size * 0.7), rotation=(6, 10, x * 50), bevel=0.02
        )
    for x in np.arange(-length / 2, length / 2, 0.45):
        center = (float(x), -0.28, float(rng.uniform(0.1, height * 0.5)))
        builder.sphere(finish("hedge"), center, float(rng.uniform(0.12, 0.3)), scale=(1, 0.4, 1.3), segments=8, rings=5)


@piece("broken_column")
def broken_column(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a fluted column, whole or broken off. Parameters: height, whole, fallen."""
    height, stone = spec.number("height", 3.2), finish("stone_light")
    if spec.flag("fallen"):
        for index in range(3):
            start, end = (index * 1.15 - 1.6, 0.1 * index, 0.36), (index * 1.15 - 0.55, 0.14 * index, 0.36)
            builder.cylinder(stone, start, end, 0.36, segments=14)
        return
    builder.box(stone, (0, 0, 0.15), (1.1, 1.1, 0.3), bevel=0.03)
    builder.lathe(stone, [(0.48, 0.3), (0.48, 0.42), (0.4, 0.5), (0.35, height)], segments=14)
    if spec.flag("whole"):
        builder.lathe(stone, [(0.36, height), (0.56, height + 0.3)], segments=14)
        builder.box(stone, (0, 0, height + 0.42), (1.15, 1.15, 0.26), bevel=0.02)
    else:
        builder.box(stone, (0.08, 0.02, height + 0.04), (0.5, 0.46, 0.22), rotation=(14, -20, 30))


@piece("barn_house")
def barn_house(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a large barn with a hipped roof that faces -Y, its front at y = 0. Parameters: width, depth, color."""
    width, depth, wall = spec.number("width", 10), spec.number("depth", 14), spec.paint("color", "#7d2a22")
    half, eave, knee, top = width / 2, 4.0, 6.4, 7.8
    shape = [(-half, 0), (half, 0), (half, eave), (half * 0.62, knee), (0, top), (-half * 0.62, knee), (-half, eave)]
    for y, order in ((0.0, 1), (depth, -1)):
        builder.polygon(wall, [(x, y, z) for x, z in shape][::order])
    for (x0, z0), (x1, z1) in zip(shape[1:], [*shape[2:], shape[0]], strict=True):
        skin = wall if max(z0, z1) <= eave else finish("roof_slate")
        lift = 0.0 if skin is wall else 0.06
        builder.quad(
            skin,
            (x0, -0.3 if lift else 0, z0 + lift),
            (x0, depth, z0 + lift),
            (x1, depth, z1 + lift),
            (x1, -0.3 if lift else 0, z1 + lift),
        )
    white = finish("paint_white")
    for x in np.arange(-half + 0.3, half, 0.3):
        high = eave + (top - eave) * 0.8 * (1 - abs(float(x)) / half)
        builder.box(wall, (float(x), -0.012, high / 2), (0.02, 0.03, high))
    for x in (-0.95, 0.95):
        builder.box(finish("wood_red"), (x, -0.06, 1.6), (1.85, 0.08, 3.2))
        for z in (0.12, 1.6, 3.1):
            builder.box(white, (x, -0.11, z), (1.85, 0.04, 0.16))
        for side in (-1, 1):
            builder.box(white, (x, -0.105, 0.86 + 1.48 * (side > 0)), (2.2, 0.04, 0.13), rotation=(0, side * 38, 0))
            builder.box(white, (x + side * 0.86, -0.11, 1.6), (0.14, 0.04, 3.2))
    builder.box(finish("plaster_soot"), (0, -0.04, 5.2), (1.5, 0.06, 1.5))
    for x, z, size in (
        (-0.8, 5.2, (0.14, 0.1, 1.7)),
        (0.8, 5.2, (0.14, 0.1, 1.7)),
        (0, 4.4, (1.7, 0.1, 0.14)),
        (0, 6.0, (1.7, 0.1, 0.14)),
    ):
        builder.box(white, (x, -0.08, z), size)


@piece("silo")
def silo(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a grain silo. Parameters: height."""
    height = spec.number("height", 11)
    profile = [(2.0, 0), (2.0, height), (1.4, height + 1.0), (0.05, height + 1.6)]
    builder.lathe(finish("metal_grey"), profile, segments=24)
    for z in np.arange(0.8, height, 0.9):
        builder.lathe(finish("iron"), [(2.02, 0), (2.02, 0.06)], origin=(0, 0, float(z)), segments=24, caps=False)
    for x in (-0.2, 0.2):
        builder.cylinder(finish("iron"), (x, -2.12, 0.3), (x, -2.12, height), 0.025, segments=5)


@piece("windmill")
def windmill(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a windmill with four sails that faces -Y."""
    builder.lathe(finish("limewash"), [(2.9, 0), (2.0, 8.0)], segments=20)
    builder.lathe(finish("wood_dark"), [(2.2, 8.0), (2.1, 8.6), (1.2, 9.8), (0.05, 10.2)], segments=20)
    builder.box(finish("wood_dark"), (0, -2.78, 1.05), (1.0, 0.2, 2.1))
    for z in (3.6, 6.0):
        builder.box(finish("glass_dark"), (0, -2.45 + 0.1 * (z - 3.6), z), (0.6, 0.2, 0.9))
    builder.cylinder(finish("wood_dark"), (0, -1.5, 8.6), (0, -3.0, 8.6), 0.22, segments=10)
    for k in range(4):
        with builder.at((0, -2.9, 8.6), (0, 90 * k + 25, 0)):
            builder.box(finish("wood_dark"), (0, 0, 3.1), (0.14, 0.12, 6.2))
            for z in np.arange(1.4, 6.2, 0.5):
                builder.box(finish("wood_gray"), (0.55, 0, float(z)), (1.2, 0.05, 0.05))
            builder.quad(finish("canvas"), (0.1, 0.02, 1.4), (1.15, 0.02, 1.4), (1.15, 0.02, 6.1), (0.1, 0.02, 6.1))
            builder.quad(finish("canvas"), (1.15, 0.03, 1.4), (0.1, 0.03, 1.4), (0.1, 0.03, 6.1), (1.15, 0.03, 6.1))


@piece("awning_stall")
def awning_stall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a market stall with a striped awning that faces -Y. Parameters: width, color, goods, seed."""
    width, post = spec.number("width", 2.6), finish("wood_gray")
    stripes = spec.paint("color", "#8a2f2a"), finish("paint_cream")
    for x in (-width / 2, width / 2):
        for y, high in ((-0.7, 2.2), (0.7, 2.7)):
            builder.cylinder(post, (x, y, 0), (x, y, high), 0.04, segments=7)
    count = max(5, round(width / 0.35))
    for index in range(count):
        x0, x1 = width * (index / count - 0.5) * 1.08, width * ((index + 1) / count - 0.5) * 1.08
        skin = stripes[index % 2]
        for order in (1, -1):
            lift = 0.0 if order > 0 else -0.01
            builder.polygon(
                skin,
                [(x0, -1.05, 2.1 + lift), (x1, -1.05, 2.1 + lift), (x1, 0.75, 2.75 + lift), (x0, 0.75, 2.75 + lift)][
                    ::order
                ],
            )
            builder.polygon(
                skin,
                [(x0, -1.05 + lift, 1.86), (x1, -1.05 + lift, 1.86), (x1, -1.05 + lift, 2.1), (x0, -1.05 + lift, 2.1)][
                    ::order
                ],
            )
    builder.box(finish("planks_gray"), (0, -0.1, 0.8), (width - 0.1, 1.1, 0.06))
    builder.box(finish("boards_grey"), (0, -0.62, 0.42), (width - 0.1, 0.04, 0.74))
    palette = _WARES[spec.word("goods", "fruit")]
    for x in np.arange(-width / 2 + 0.3, width / 2 - 0.2, 0.5):
        skin = painted(palette[int(spec.rng.integers(4))])
        builder.box(finish("wood_light"), (float(x), -0.3, 0.9), (0.44, 0.42, 0.16), rotation=(12, 0, 0))
        for dx in (-0.12, 0.0, 0.12):
            for dy in (-0.12, 0.02):
                builder.sphere(skin, (float(x) + dx, -0.28 + dy, 1.0), 0.07, segments=8, rings=5)
        builder.box(painted(palette[int(spec.rng.integers(4))]), (float(x), 0.22, 0.96), (0.36, 0.3, 0.24), bevel=0.03)


@piece("church_tower")
def church_tower(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a village church: nave along x, tower with a spire."""
    stone, slate = finish("stone_sand"), finish("roof_slate")
    builder.box(stone, (5.5, 0, 2.6), (11, 7, 5.2))
    for side in (-1, 1):
        builder.box(slate, (5.6, side * 1.85, 6.6), (11.4, 4.9, 0.2), rotation=(-side * 40, 0, 0))
    for x in (2.5, 5.5, 8.5):
        builder.box(finish("glass_dark"), (x, -3.52, 2.8), (0.9, 0.08, 2.4))
    builder.box(stone, (-2, 0, 6), (4.4, 4.4, 12))
    builder.box(finish("stone_light"), (-2, 0, 12), (4.8, 4.8, 0.3))
    builder.cylinder(slate, (-2, 0, 12.1), (-2, 0, 19), 3.0, 0.05, segments=4)
    builder.box(finish("glass_dark"), (-2, -2.22, 9.6), (1.2, 0.06, 1.9))
    builder.cylinder(finish("paint_cream"), (-2, -2.2, 7.2), (-2, -2.26, 7.2), 0.8, segments=20)


@piece("stone_steps")
def stone_steps(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a flight of stone steps that rises towards +X. Parameters: width, height."""
    width, height, stone = spec.number("width", 2.0), spec.number("height", 2.6), finish("stone")
    count = max(3, round(height / 0.2))
    for index in range(count):
        high = (index + 1) * height / count
        builder.box(stone, (0.34 * index, 0, high / 2), (0.36, width, high))


@piece("station_house")
def station_house(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a small wooden railway station that faces -Y with a roof over the platform. Parameters: width."""
    width, trim = spec.number("width", 10), finish("paint_green")
    builder.box(finish("wall_planks"), (0, 2.4, 1.7), (width, 4.8, 3.4))
    builder.box(finish("brick_red"), (0, 2.38, 0.4), (width + 0.06, 4.84, 0.8))
    for side in (-1, 1):
        builder.box(
            finish("roof_slate"), (0, 2.4 + side * 1.6, 4.5), (width + 1.2, 4.1, 0.14), rotation=(-side * 36, 0, 0)
        )
    builder.box(finish("roof_slate"), (0, -1.0, 3.1), (width + 0.6, 2.3, 0.1), rotation=(7, 0, 0))
    for x in np.arange(-width / 2 - 0.1, width / 2 + 0.3, 0.32):
        builder.box(trim, (float(x), -2.1, 2.86), (0.2, 0.03, 0.26))
    for x in np.linspace(-width / 2 + 0.3, width / 2 - 0.3, 4):
        builder.box(trim, (float(x), -0.05, 1.7), (0.14, 0.12, 3.3))
    builder.box(trim, (0, -0.03, 1.15), (1.2, 0.08, 2.3))
    builder.box(spec.pane("pane_warm"), (0, -0.08, 1.65), (0.8, 0.02, 0.9))
    for x in (-width * 0.32, width * 0.32):
        builder.box(finish("paint_white"), (x, -0.03, 1.65), (1.7, 0.08, 1.5))
        builder.box(spec.pane("pane_warm"), (x, -0.08, 1.65), (1.5, 0.02, 1.3))
        for dx in (-0.4, 0.0, 0.4):
            builder.box(finish("paint_white"), (x + dx, -0.1, 1.65), (0.05, 0.02, 1.3))
    builder.cylinder(finish("paint_white"), (width * 0.16, -0.02, 2.6), (width * 0.16, -0.12, 2.6), 0.3, segments=20)
    builder.box(finish("paint_black"), (width * 0.16, -0.13, 2.68), (0.03, 0.01, 0.2))
    builder.box(finish("brick_red"), (width * 0.3, 2.4, 5.9), (0.7, 0.7, 1.6))


@piece("name_board")
def name_board(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the name board of a station on two posts, facing -Y. Parameters: width."""
    width = spec.number("width", 2.4)
    for x in (-width / 2, width / 2):
        builder.box(finish("paint_white"), (x, 0, 1.1), (0.1, 0.1, 2.2))
    builder.box(finish("paint_blue"), (0, 0, 1.8), (width, 0.06, 0.5), bevel=0.01)
    at = -width * 0.36
    while at < width * 0.34:
        wide = float(spec.rng.uniform(0.08, 0.15))
        builder.box(finish("paint_white"), (at + wide / 2, -0.035, 1.8), (wide, 0.01, 0.24))
        at += wide + 0.07


@piece("rail_signal")
def rail_signal(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a semaphore railway signal."""
    builder.box(finish("paint_white"), (0, 0, 2.9), (0.2, 0.2, 5.8))
    builder.box(finish("paint_red"), (0.7, -0.12, 5.4), (1.3, 0.05, 0.26))
    builder.box(finish("paint_white"), (1.1, -0.15, 5.4), (0.14, 0.02, 0.26))
    builder.sphere(finish("paint_red"), (-0.2, -0.14, 5.4), 0.11, segments=10, rings=6)
    for z in np.arange(0.5, 5.2, 0.35):
        builder.box(finish("iron"), (0, 0.14, float(z)), (0.36, 0.03, 0.03))


@piece("quay_kerb")
def quay_kerb(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the white edge of a low platform along x, the track at -Y. Parameters: length."""
    length = spec.number("length", 80)
    builder.box(finish("stone_light"), (0, 0.1, -0.02), (length, 0.5, 0.09))
    builder.box(finish("paint_white"), (0, 0.2, 0.028), (length, 0.1, 0.004))


@piece("glass_rail")
def glass_rail(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a railing of thin bars on posts along x, as on a modern roof. Parameters: length."""
    length, metal = spec.number("length", 10), finish("steel")
    for x in np.linspace(-length / 2, length / 2, max(2, round(length / 1.4) + 1)):
        builder.box(metal, (float(x), 0, 0.55), (0.05, 0.05, 1.1))
    for z in (0.25, 0.5, 0.75):
        builder.cylinder(metal, (-length / 2, 0, z), (length / 2, 0, z), 0.01, segments=5)
    builder.box(finish("wood"), (0, 0, 1.1), (length, 0.12, 0.05), bevel=0.01)


@piece("plank_pile")
def plank_pile(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Pile planks and steel pipes along x."""
    for row in range(4):
        for column in range(5):
            x = float(spec.rng.uniform(-0.1, 0.1))
            builder.box(finish("planks"), (x, -0.45 + 0.2 * column, 0.14 + 0.07 * row), (2.8, 0.18, 0.055))
    for y in (-0.3, 0.3):
        builder.box(finish("wood_gray"), (0, y, 0.05), (0.1, 0.3, 0.1))
    for index in range(5):
        builder.cylinder(
            finish("rust"), (-1.5, 0.75 + 0.09 * index, 0.06), (1.5, 0.75 + 0.09 * index, 0.06), 0.045, segments=8
        )


@piece("millstones")
def millstones(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a pair of millstones in their casing with a hopper, a shaft to the ceiling and its gear. Parameters:
    height."""
    height, wood, stone = spec.number("height", 3.4), finish("wood"), finish("stone_light")
    builder.lathe(finish("boards_dark"), [(0.95, 0), (0.95, 0.5)], segments=24)
    builder.cylinder(stone, (0, 0, 0.5), (0, 0, 0.7), 0.8, segments=28)
    builder.cylinder(stone, (0, 0, 0.72), (0, 0, 0.94), 0.8, segments=28)
    builder.lathe(wood, [(0.12, 1.3), (0.46, 1.9), (0.5, 1.9)], segments=4, caps=False)
    for x in (-0.6, 0.6):
        for y in (-0.6, 0.6):
            builder.box(wood, (x, y, 1.2), (0.08, 0.08, 1.4))
    builder.cylinder(wood, (0, 0, 0.9), (0, 0, height), 0.1, segments=8)
    builder.cylinder(wood, (0, 0, 2.35), (0, 0, 2.5), 0.75, segments=24)
    for t in np.linspace(0, 2 * math.pi, 21)[:-1]:
        builder.box(finish("wood_dark"), (0.78 * math.cos(t), 0.78 * math.sin(t), 2.42), (0.08, 0.08, 0.2))
    builder.box(finish("linen"), (0.75, -0.75, 0.3), (0.4, 0.4, 0.6), bevel=0.1)
