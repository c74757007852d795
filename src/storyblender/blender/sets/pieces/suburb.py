"""Set piece builders: detached houses, fences, playground equipment, bus shelters and washing lines."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("detached_house")
def detached_house(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a house with a gable roof that faces -Y, its front at y = 0.

    Parameters: width, depth, floors, material or color, roof, garage (a wing with a door at its right), door (color),
    thatch, seed.
    """
    width, depth, floors = spec.number("width", 9.0), spec.number("depth", 7.0), int(spec.number("floors", 2))
    wall = spec.finish("material", "wall_tile") if "material" in spec.params else spec.paint("color", "#c9c3b2")
    thatch = spec.flag("thatch")
    roof, trim = spec.finish("roof", "roof_slate" if not thatch else "thatch"), finish("paint_white")
    if thatch:
        trim = finish("wood_dark")
    high = 2.7 * floors + 0.3
    builder.box(wall, (0, depth / 2, high / 2), (width, depth, high))
    _gable_roof(builder, roof, wall, (0.0, depth / 2, high), (width, depth), 1.05 if thatch else 0.72)
    builder.box(finish("brick_red"), (width * 0.28, depth * 0.6, high + depth * 0.42), (0.7, 0.7, depth * 0.5))
    door = -width * 0.18
    builder.box(trim, (door, -0.02, 1.1), (1.24, 0.1, 2.25))
    builder.box(spec.paint("door", "#6b2a22"), (door, -0.07, 1.05), (0.98, 0.06, 2.05))
    builder.sphere(finish("brass"), (door + 0.38, -0.13, 1.0), 0.035, segments=8, rings=5)
    builder.box(finish("stone_light"), (door, -0.5, 0.07), (1.8, 1.0, 0.14))
    if not thatch:
        builder.box(roof, (door, -0.55, 2.55), (2.1, 1.3, 0.1), rotation=(8, 0, 0))
        for x in (-0.9, 0.9):
            builder.box(trim, (door + x, -1.1, 1.25), (0.1, 0.1, 2.5))
    for floor in range(floors):
        for x in np.linspace(-width / 2 + 1.1, width / 2 - 1.1, max(2, round(width / 2.6))):
            if floor or abs(x - door) > 1.2:
                _window(builder, spec, float(x), 0.95 + 2.7 * floor, trim, shutters=not thatch and floors > 1)
    if spec.flag("garage"):
        x, wide = width / 2 + 1.8, 3.6
        builder.box(wall, (x, depth / 2 + 0.4, 1.4), (wide, depth - 0.8, 2.8))
        _gable_roof(builder, roof, wall, (x, depth / 2 + 0.4, 2.8), (wide, depth - 0.8), 0.5)
        for row in range(4):
            builder.box(trim, (x, 0.37, 0.3 + 0.55 * row), (2.7, 0.06, 0.52), bevel=0.01)


def _gable_roof(
    builder: MeshBuilder,
    roof: MaterialRef,
    wall: MaterialRef,
    middle: tuple[float, float, float],
    size: tuple[float, float],
    pitch: float,
) -> None:
    """Add a roof with its ridge along x; ``pitch`` is its rise over half the depth."""
    x, y, z = middle
    width, depth = size
    rise, slope = depth / 2 * pitch, math.degrees(math.atan(pitch))
    reach = math.hypot(depth / 2, rise) + 0.55
    for side in (-1, 1):
        centre = (x, y + side * (depth / 4 + 0.15), z + rise / 2 - 0.08)
        builder.box(roof, centre, (width + 0.7, reach, 0.16), rotation=(-side * slope, 0, 0))
        end = x + side * width / 2
        points = [(end, y - depth / 2, z), (end, y + depth / 2, z), (end, y, z + rise)]
        builder.polygon(wall, points if side > 0 else points[::-1])


def _window(builder: MeshBuilder, spec: PieceSpec, x: float, sill: float, trim: MaterialRef, *, shutters: bool) -> None:
    """Add a window of a house, with shutters if wanted, its middle at ``x``."""
    glass = spec.pane("pane_warm") if spec.rng.random() < 0.5 else finish("glass_dark")
    builder.box(trim, (x, -0.02, sill + 0.65), (1.2, 0.08, 1.45))
    builder.box(glass, (x, -0.065, sill + 0.65), (1.0, 0.02, 1.25))
    builder.box(trim, (x, -0.08, sill + 0.65), (0.05, 0.02, 1.25))
    builder.box(trim, (x, -0.08, sill + 0.75), (1.0, 0.02, 0.05))
    if shutters:
        for side in (-1, 1):
            builder.box(spec.paint("shutters", "#3c5247"), (x + side * 0.78, -0.03, sill + 0.65), (0.34, 0.05, 1.4))


@piece("picket_fence")
def picket_fence(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a picket fence along x. Parameters: length, height, color."""
    length, height, skin = spec.number("length", 6.0), spec.number("height", 1.0), spec.paint("color", "#d9d5ca")
    for z in (0.28, height - 0.25):
        builder.box(skin, (0, 0.03, z), (length, 0.04, 0.08))
    for x in np.arange(-length / 2 + 0.07, length / 2, 0.15):
        at = float(x)
        outline = [
            (at - 0.04, 0.04), (at + 0.04, 0.04), (at + 0.04, height - 0.06), (at, height), (at - 0.04, height - 0.06),
        ]  # fmt: skip
        builder.polygon(skin, [(px, -0.01, pz) for px, pz in outline])
        builder.polygon(skin, [(px, 0.012, pz) for px, pz in outline[::-1]])


@piece("board_fence")
def board_fence(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a tall fence of boards along x. Parameters: length, height, material."""
    length, height, skin = spec.number("length", 8.0), spec.number("height", 1.8), spec.finish("material", "boards")
    step = 0.19 if length < 20 else 0.38
    for x in np.arange(-length / 2 + step / 2, length / 2, step):
        tall = height + float(spec.rng.uniform(-0.02, 0.02))
        builder.box(skin, (float(x), 0, tall / 2), (step - 0.015, 0.025, tall))
    for z in (0.35, height - 0.3):
        builder.box(skin, (0, 0.035, z), (length, 0.05, 0.09))
    for x in np.arange(-length / 2, length / 2 + 0.1, 2.4):
        builder.box(finish("wood_gray"), (float(x), 0.05, height / 2 + 0.05), (0.11, 0.11, height + 0.1))


@piece("chain_fence")
def chain_fence(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a chain-link fence along x on posts. Parameters: length, height."""
    length, height, metal = spec.number("length", 10.0), spec.number("height", 2.0), finish("metal_grey")
    for x in np.arange(-length / 2, length / 2 + 0.1, 2.5):
        builder.cylinder(metal, (float(x), 0, 0), (float(x), 0, height + 0.05), 0.035, segments=8)
    for z in (0.06, height):
        builder.cylinder(metal, (-length / 2, 0, z), (length / 2, 0, z), 0.02, segments=6)
    step, rise = (0.3, height - 0.06) if length < 24 else (0.5, height - 0.06)
    for x in np.arange(-length / 2, length / 2 - 0.05, step):
        for a, b in ((0.06, height), (height, 0.06)):
            end = min(float(x) + rise, length / 2)
            share = (end - float(x)) / rise
            builder.cylinder(metal, (float(x), 0, a), (end, 0, a + (b - a) * share), 0.006, segments=3, caps=False)


@piece("slide")
def slide(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a playground slide that runs down towards +X."""
    red, steel = painted("#b8352a"), finish("steel")
    for y in (-0.26, 0.26):
        builder.cylinder(red, (-1.5, y, 0), (-1.1, y, 2.7), 0.03, segments=8)
        builder.cylinder(red, (-0.5, y, 0), (-0.6, y, 2.7), 0.03, segments=8)
    for z in np.arange(0.25, 1.75, 0.26):
        builder.cylinder(
            steel, (-1.5 + 0.148 * z, -0.26, float(z)), (-1.5 + 0.148 * z, 0.26, float(z)), 0.02, segments=6
        )
    builder.box(painted("#c9a227"), (-0.85, 0, 1.8), (0.7, 0.58, 0.06))
    path = [(-0.55, 1.8), (0.3, 1.25), (1.2, 0.6), (1.7, 0.32), (2.1, 0.28)]
    for (x0, z0), (x1, z1) in pairwise(path):
        builder.quad(steel, (x0, -0.25, z0), (x1, -0.25, z1), (x1, 0.25, z1), (x0, 0.25, z0))
        builder.quad(
            steel, (x0, 0.25, z0 - 0.02), (x1, 0.25, z1 - 0.02), (x1, -0.25, z1 - 0.02), (x0, -0.25, z0 - 0.02)
        )
    for y in (-0.27, 0.27):
        builder.tube(red, [(x, y, z + 0.12) for x, z in path], 0.035, segments=6)
    builder.cylinder(red, (2.0, 0, 0), (2.0, 0, 0.28), 0.035, segments=8)


@piece("seesaw")
def seesaw(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a see-saw along x."""
    builder.box(finish("metal_grey"), (0, 0, 0.25), (0.16, 0.3, 0.5))
    builder.box(painted("#c9a227"), (0, 0, 0.52), (3.2, 0.24, 0.06), rotation=(0, 9, 0))
    for x, z in ((-1.25, 0.78), (1.25, 0.38)):
        builder.tube(
            painted("#2f5a8a"), [(x, -0.14, z - 0.1), (x, -0.14, z + 0.2), (x, 0.14, z + 0.2), (x, 0.14, z - 0.1)], 0.02
        )


@piece("climbing_frame")
def climbing_frame(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a climbing frame of bars, three metres wide."""
    for index, x in enumerate(np.linspace(-1.5, 1.5, 4)):
        skin = painted(("#2f5a8a", "#b8352a", "#c9a227", "#3c7a4a")[index])
        for y in (-0.8, 0.0, 0.8):
            builder.cylinder(skin, (float(x), y, 0), (float(x), y, 2.2), 0.03, segments=8)
        for z in (0.75, 1.5, 2.2):
            builder.cylinder(skin, (float(x), -0.8, z), (float(x), 0.8, z), 0.025, segments=6)
    for y in (-0.8, 0.0, 0.8):
        for z in (0.75, 1.5, 2.2):
            builder.cylinder(painted("#2f5a8a"), (-1.5, y, z), (1.5, y, z), 0.025, segments=6)


@piece("bus_shelter")
def bus_shelter(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bus shelter that opens to -Y: glass back, roof, bench, a timetable and an advertisement. Parameters:
    length."""
    length, metal = spec.number("length", 3.6), finish("metal_grey")
    for x in np.linspace(-length / 2, length / 2, 4):
        builder.box(metal, (float(x), 0.55, 1.2), (0.07, 0.07, 2.4))
    builder.box(metal, (0, 0.1, 2.45), (length + 0.3, 1.4, 0.1), bevel=0.02)
    for z in (0.35, 1.25, 2.1):
        builder.box(metal, (0, 0.55, z), (length, 0.05, 0.05))
    builder.box(finish("frosted"), (0, 0.57, 0.8), (length, 0.01, 0.86))
    builder.box(finish("wood"), (-0.3, 0.3, 0.46), (length * 0.7, 0.36, 0.05), bevel=0.01)
    for x in (-0.3 - length * 0.3, -0.3 + length * 0.3):
        builder.box(metal, (x, 0.3, 0.22), (0.06, 0.3, 0.44))
    side = length / 2
    builder.box(metal, (side, 0.1, 1.25), (0.12, 1.0, 1.9), bevel=0.01)
    builder.box(spec.pane("pane_pale"), (side - 0.065, 0.1, 1.28), (0.01, 0.86, 1.6))
    builder.box(painted("#a8473c"), (side - 0.072, 0.1, 1.1), (0.006, 0.7, 0.8))
    builder.box(painted("#33506b"), (side - 0.072, 0.1, 1.75), (0.006, 0.6, 0.3))
    builder.box(finish("paint_white"), (-side + 0.4, 0.52, 1.45), (0.5, 0.02, 0.7))
    for z in np.arange(1.2, 1.75, 0.08):
        builder.box(finish("paint_black"), (-side + 0.4, 0.508, float(z)), (0.4, 0.006, 0.02))


@piece("washing_line")
def washing_line(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Stretch a washing line along x between two posts. Parameters: length, seed."""
    length = spec.number("length", 4.5)
    for x in (-length / 2, length / 2):
        builder.cylinder(finish("wood_gray"), (x, 0, 0), (x, 0, 2.0), 0.05, segments=8)
    builder.tube(finish("canvas"), [(-length / 2, 0, 1.9), (0, 0, 1.74), (length / 2, 0, 1.9)], 0.008, segments=4)
    at = -length / 2 + 0.4
    colors = ("#d8d4c8", "#7f9cb0", "#b0564a", "#c9b878", "#5f7a5a")
    while at < length / 2 - 0.7:
        wide, tall = float(spec.rng.uniform(0.35, 0.9)), float(spec.rng.uniform(0.45, 1.0))
        top = 1.76 + 0.14 * (2 * (at + wide / 2) / length) ** 2
        skin = painted(colors[int(spec.rng.integers(5))])
        for depth, order in ((-0.006, 1), (0.006, -1)):
            points = [
                (at + wide * x, depth + y, top - tall * z)
                for x, y, z in ((0, 0, 0), (0, 0.05, 1), (1, 0.03, 1), (1, 0, 0))
            ]
            builder.polygon(skin, points[::order])
        at += wide + 0.16


@piece("court_lines")
def court_lines(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Paint the lines of a sports court, centred on the origin. Parameters: width, depth."""
    half, deep, white = spec.number("width", 9) / 2, spec.number("depth", 6) / 2, finish("paint_cream")
    for a, b in (((-half, -deep), (half, -deep)), ((-half, deep), (half, deep)), ((-half, -deep), (-half, deep)),
                 ((half, -deep), (half, deep)), ((0.0, -deep), (0.0, deep))):  # fmt: skip
        middle, wide = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 0.008), abs(b[0] - a[0]) + 0.06
        builder.box(white, middle, (wide, abs(b[1] - a[1]) + 0.06, 0.006))
    ring = [(1.2 * math.cos(t), 1.2 * math.sin(t), 0.01) for t in np.linspace(0, 2 * math.pi, 28)[:-1]]
    builder.tube(white, ring, 0.025, segments=4, closed=True)


@piece("hoop_post")
def hoop_post(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a basketball hoop on a post, its ring at -Y."""
    metal = finish("metal_grey")
    builder.tube(metal, [(0, 0.9, 0), (0, 0.9, 2.6), (0, 0.5, 3.2), (0, 0.1, 3.3)], 0.07)
    builder.box(finish("paint_white"), (0, 0.05, 3.4), (1.5, 0.05, 1.0))
    builder.box(painted("#b8352a"), (0, 0.015, 3.25), (0.5, 0.02, 0.36))
    builder.box(finish("paint_white"), (0, 0.008, 3.25), (0.42, 0.02, 0.28))
    ring = [(0.24 * math.cos(t), -0.28 + 0.24 * math.sin(t), 3.05) for t in np.linspace(0, 2 * math.pi, 20)[:-1]]
    builder.tube(painted("#c9602a"), ring, 0.018, segments=6, closed=True)


@piece("tree_ring")
def tree_ring(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a round bench of stone around a tree."""
    profile = [(0.85, 0), (0.85, 0.38), (0.92, 0.4), (0.92, 0.45), (0.45, 0.45), (0.45, 0.0)]
    builder.lathe(finish("stone_light"), profile, segments=28, caps=False)
    builder.lathe(finish("dirt"), [(0.46, 0.3), (0.01, 0.36)], segments=20, caps=False)
