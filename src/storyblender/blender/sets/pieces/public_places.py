"""Set piece builders: parts of lifts, cabins, museums, pools and stadiums."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.tags import Surface

_SHIRTS = ("paint_red", "paint_blue", "paint_white", "paint_yellow", "paint_green", "paint_black", "paint_grey")


@piece("lift_panel")
def lift_panel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the buttons of a lift on a wall at y = 0, with the floor it is at above. Parameters: floors."""
    builder.box(finish("chrome"), (0, -0.012, 0.3), (0.26, 0.024, 0.72), bevel=0.006)
    for index in range(int(spec.number("floors", 10))):
        x, z = -0.05 + 0.1 * (index % 2), 0.04 + 0.085 * (index // 2)
        skin = finish("lamp_warm" if index == 3 else "paint_white")
        builder.cylinder(skin, (x, -0.02, z), (x, -0.036, z), 0.026, segments=14)
    builder.box(finish("paint_black"), (0, -0.018, 0.74), (0.26, 0.03, 0.12), bevel=0.006)
    builder.box(finish("lamp_warm"), (0, -0.036, 0.74), (0.06, 0.006, 0.08))


@piece("grab_rail")
def grab_rail(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a rail along x before a wall at y = 0. Parameters: length, modern."""
    half, metal = spec.number("length", 2.0) / 2, finish("chrome" if spec.flag("modern") else "brass")
    builder.cylinder(metal, (-half, -0.07, 0), (half, -0.07, 0), 0.02, segments=10)
    for x in (-half + 0.1, half - 0.1):
        builder.cylinder(metal, (x, 0, 0), (x, -0.07, 0), 0.014, segments=8)


@piece("lift_mirror")
def lift_mirror(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a dark mirror in a frame on a wall at y = 0, its lower edge at z = 0. Parameters: width, height."""
    width, height = spec.number("width", 1.6), spec.number("height", 1.1)
    builder.box(finish("chrome"), (0, -0.008, height / 2), (width + 0.06, 0.016, height + 0.06))
    builder.box(finish("frosted"), (0, -0.018, height / 2), (width, 0.006, height))


@piece("overhead_bin")
def overhead_bin(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang the luggage bins of an aeroplane along x from a wall at y = 0, their top at z = 0. Parameters: length."""
    length, white = spec.number("length", 6.0), finish("paint_white")
    section = [(-0.02, 0.0), (-0.62, 0.0), (-0.66, -0.16), (-0.5, -0.38), (-0.02, -0.42)]
    builder.loft(white, [np.array([(x, y, z) for y, z in section]) for x in (-length / 2, length / 2)])
    for x in np.arange(-length / 2 + 0.5, length / 2, 1.0):
        builder.box(finish("paint_grey"), (float(x), -0.6, -0.24), (0.012, 0.14, 0.24), rotation=(-36, 0, 0))
        builder.box(finish("lamp_warm"), (float(x) + 0.5, -0.3, -0.412), (0.1, 0.06, 0.01))


@piece("hand_rail")
def hand_rail(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a rail with straps along x at z = 0 from a ceiling ``drop`` above. Parameters: length, drop."""
    length, drop, steel = spec.number("length", 6.0), spec.number("drop", 0.4), finish("chrome")
    builder.cylinder(steel, (-length / 2, 0, 0), (length / 2, 0, 0), 0.018, segments=10)
    for x in np.linspace(-length / 2 + 0.1, length / 2 - 0.1, 4):
        builder.cylinder(steel, (float(x), 0, 0), (float(x), 0, drop), 0.014, segments=8)
    for x in np.arange(-length / 2 + 0.4, length / 2 - 0.2, 0.6):
        builder.box(finish("paint_black"), (float(x), 0, -0.09), (0.03, 0.01, 0.16))
        builder.box(finish("paint_yellow"), (float(x), 0, -0.2), (0.12, 0.02, 0.08), bevel=0.008)


@piece("glass_case")
def glass_case(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a museum's case: a plinth, an exhibit, the edges of its glass. Parameters: variant."""
    dark, brass = finish("wood_dark"), finish("brass")
    builder.box(dark, (0, 0, 0.42), (1.2, 0.65, 0.84), bevel=0.01)
    builder.box(finish("velvet_red"), (0, 0, 0.85), (1.12, 0.57, 0.03))
    if int(spec.number("variant", 0)) % 4:
        builder.lathe(finish("gold"), [(0.07, 0), (0.05, 0.03), (0.13, 0.16), (0.1, 0.3), (0.06, 0.34), (0.1, 0.4)],
                      origin=(0, 0, 0.865), segments=20)  # fmt: skip
    else:
        builder.lathe(finish("clay"), [(0.1, 0), (0.19, 0.16), (0.08, 0.34), (0.12, 0.38)], origin=(-0.2, 0, 0.865))
        builder.sphere(finish("marble"), (0.25, 0, 1.0), 0.13, scale=(0.8, 0.95, 1.1))
    for x in (-0.59, 0.59):
        for y in (-0.31, 0.31):
            builder.box(brass, (x, y, 1.16), (0.02, 0.02, 0.64))
    for z in (0.86, 1.48):
        for y in (-0.31, 0.31):
            builder.box(brass, (0, y, z), (1.2, 0.02, 0.02))
        for x in (-0.59, 0.59):
            builder.box(brass, (x, 0, z), (0.02, 0.64, 0.02))


@piece("barrier_rope")
def barrier_rope(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build brass posts with a red rope between them along x. Parameters: length."""
    length, brass = spec.number("length", 5.0), finish("brass")
    count = max(2, round(length / 1.5) + 1)
    posts = [float(x) for x in np.linspace(-length / 2, length / 2, count)]
    for x in posts:
        builder.lathe(brass, [(0.14, 0), (0.13, 0.03), (0.025, 0.05), (0.022, 0.82), (0.04, 0.86), (0.01, 0.9)],
                      origin=(x, 0, 0), segments=14)  # fmt: skip
    for left, right in pairwise(posts):
        share = np.linspace(0, 1, 9)
        rope = np.c_[left + (right - left) * share, np.zeros(9), 0.8 - 0.9 * share * (1 - share)]
        builder.tube(finish("velvet_red"), rope, 0.02, segments=7)


@piece("pool_rim")
def pool_rim(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the edge of a pool about the origin, its lane lines and ladders. Parameters: width, depth, lanes."""
    width, depth, stone = spec.number("width", 12.0), spec.number("depth", 6.0), finish("stone_light")
    for y in (-depth / 2, depth / 2):
        builder.box(stone, (0, y, 0.02), (width + 0.5, 0.34, 0.06), bevel=0.012)
    for x in (-width / 2, width / 2):
        builder.box(stone, (x, 0, 0.02), (0.34, depth, 0.06), bevel=0.012)
    lanes = int(spec.number("lanes", 4))
    for index in range(1, lanes):
        y = depth * (index / lanes - 0.5)
        for number, x in enumerate(np.arange(-width / 2 + 0.4, width / 2 - 0.2, 0.5)):
            builder.sphere(finish("paint_red" if number % 4 < 2 else "paint_white"), (float(x), y, 0.04), 0.06,
                           scale=(2.2, 1, 1), segments=8, rings=5)  # fmt: skip
    for x in (-width * 0.32, width * 0.32):
        for off in (-0.25, 0.25):
            rail = [(x + off, -depth / 2 - 0.45, 0.0), (x + off, -depth / 2 - 0.42, 0.75),
                    (x + off, -depth / 2 + 0.1, 0.8), (x + off, -depth / 2 + 0.22, 0.0)]  # fmt: skip
            builder.tube(finish("chrome"), rail, 0.022, segments=8)


@piece("diving_board")
def diving_board(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a low diving board that reaches out to -Y, with its steps."""
    steel = finish("chrome")
    builder.box(finish("paint_white"), (0, -0.9, 1.0), (0.5, 3.2, 0.06), bevel=0.01)
    for x in (-0.28, 0.28):
        builder.tube(steel, [(x, 0.9, 0), (x, 0.6, 1.0), (x, 0.5, 1.8), (x, -0.4, 1.8), (x, -0.4, 1.0)], 0.025)
        builder.cylinder(steel, (x, -0.3, 0), (x, -0.3, 1.0), 0.05, segments=10)
    for z in (0.3, 0.6, 0.9):
        builder.box(steel, (0, 0.9 - 0.3 * z, z), (0.5, 0.16, 0.03))


@piece("goal")
def goal(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a football goal that opens to -Y."""
    white, half, high = finish("paint_white"), 3.66, 2.44
    builder.tube(white, [(-half, 0, 0), (-half, 0, high), (half, 0, high), (half, 0, 0)], 0.06, segments=10)
    for x in np.linspace(-half, half, 25):
        builder.tube(white, [(float(x), 0, high), (float(x), 1.2, 0.9), (float(x), 1.7, 0)], 0.008, segments=4)
    for y, z in ((0.4, 1.95), (0.9, 1.3), (1.35, 0.6), (1.6, 0.2)):
        builder.cylinder(white, (-half, y, z), (half, y, z), 0.008, segments=4)


@piece("stands", Surface.NO_INK)
def stands(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build rows of seats that rise towards +Y along x, with a crowd, a wall before and a roof. Parameters: length,
    seed."""
    length, rows = spec.number("length", 40.0), 9
    builder.box(finish("concrete_light"), (0, -0.3, 0.6), (length, 0.3, 1.2))
    builder.box(finish("paint_blue"), (0, -0.47, 0.7), (length, 0.03, 0.7))
    crowd: dict[str, list[tuple[float, float, float]]] = {key: [] for key in _SHIRTS}
    for row in range(rows):
        y, z = 0.9 * row, 0.8 + 0.5 * row
        builder.box(finish("concrete"), (0, y + 0.3, z - 0.4), (length, 0.95, 0.9))
        for x in np.arange(-length / 2 + 0.4, length / 2 - 0.3, 0.62):
            if spec.rng.random() < 0.82:
                key = _SHIRTS[int(spec.rng.integers(len(_SHIRTS)))]
                crowd[key].append(
                    (float(x + spec.rng.uniform(-0.1, 0.1)), y + 0.2, z + float(spec.rng.uniform(0, 0.2)))
                )
    for key, places in crowd.items():
        for x, y, z in places:
            builder.box(finish(key), (x, y, z + 0.3), (0.4, 0.26, 0.56))
            builder.box(finish("clay"), (x, y, z + 0.7), (0.18, 0.18, 0.22))
    high = 0.8 + 0.5 * rows
    builder.box(finish("metal_grey"), (0, 0.9 * rows - 1.6, high + 3.0), (length, 7.0, 0.3), rotation=(4, 0, 0))
    builder.box(finish("concrete_dark"), (0, 0.9 * rows + 0.6, (high + 3.0) / 2), (length, 0.4, high + 3.0))
    for x in np.arange(-length / 2 + 1, length / 2, 8.0):
        builder.box(finish("metal_grey"), (float(x), 0.9 * rows, (high + 3.0) / 2), (0.25, 0.25, high + 3.0))
