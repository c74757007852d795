"""Set piece builders: shop and cafe: menu boards, glass counters, espresso machines, serving walls, jukeboxes."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece

_GOODS: dict[str, tuple[str, ...]] = {
    "bread": ("#b5793a", "#8f5626", "#c99a5a", "#a56a30"),
    "cakes": ("#e3b7b2", "#6b3a22", "#f0e2c4", "#b03a3a", "#d8a24a"),
    "meat": ("#a33b34", "#c26a5c", "#7d2a24", "#d9a08c"),
    "fish": ("#8fa0a8", "#c8cdd0", "#b9785c", "#6f8088"),
    "jewels": ("#d8b24a", "#cfd4d8", "#7a3b9a", "#2f6fae"),
    "fruit": ("#b8322a", "#d88a22", "#7fa03a", "#e0c23a"),
}


@piece("menu_board")
def menu_board(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang menu boards with prices on a wall at y = 0, lower edge at z = 0. Parameters: width, height, boards,
    color."""
    width, height, boards = spec.number("width", 2.4), spec.number("height", 0.9), int(spec.number("boards", 3))
    each = width / boards
    for index in range(boards):
        x = (index + 0.5) * each - width / 2
        builder.box(finish("wood_dark"), (x, -0.02, height / 2), (each - 0.04, 0.04, height), bevel=0.008)
        builder.box(spec.paint("color", "#1f2624"), (x, -0.045, height / 2), (each - 0.12, 0.012, height - 0.08))
        builder.box(finish("paint_yellow"), (x, -0.055, height - 0.12), (each * 0.5, 0.006, 0.05))
        for line in range(int((height - 0.28) / 0.085)):
            z, wide = height - 0.24 - 0.085 * line, float(spec.rng.uniform(0.25, 0.5)) * each
            builder.box(finish("paint_cream"), (x - each * 0.42 + wide / 2, -0.055, z), (wide, 0.006, 0.022))
            builder.box(finish("paint_cream"), (x + each * 0.34, -0.055, z), (each * 0.12, 0.006, 0.022))


@piece("display_counter")
def display_counter(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a glass display counter along x, the customer side at -Y. Parameters: length, goods, color, seed."""
    length, goods = spec.number("length", 2.0), _GOODS[spec.word("goods", "cakes")]
    body = spec.paint("color", "#5d3a22")
    builder.box(body, (0, 0.05, 0.22), (length, 0.6, 0.44))
    builder.box(finish("paint_black"), (0, 0.05, 0.05), (length - 0.06, 0.54, 0.1))
    builder.box(finish("stone_light"), (0, 0.08, 1.13), (length + 0.02, 0.5, 0.04), bevel=0.006)
    builder.box(body, (0, 0.33, 0.78), (length, 0.04, 0.68))
    for side in (-1, 1):
        builder.box(finish("chrome"), (side * (length / 2 - 0.02), 0.05, 0.78), (0.03, 0.58, 0.68))
    for z, depth in ((0.46, 0.56), (0.78, 0.4)):
        builder.box(finish("paint_white"), (0, 0.08, z), (length - 0.08, depth, 0.02))
        for x in np.arange(-length / 2 + 0.16, length / 2 - 0.1, 0.21):
            for y in (-0.05, 0.12):
                size = float(spec.rng.uniform(0.045, 0.075))
                skin = painted(goods[int(spec.rng.integers(len(goods)))])
                builder.sphere(skin, (float(x), y, z + 0.04), size, scale=(1.25, 1, 0.75), segments=10, rings=6)
    builder.box(finish("lamp_warm"), (0, -0.12, 1.1), (length - 0.1, 0.03, 0.015))
    builder.box(finish("chrome"), (0, -0.22, 0.46), (length, 0.02, 0.03))


@piece("coffee_machine")
def coffee_machine(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a large espresso machine with cups on top, its front at -Y."""
    steel, black = finish("steel"), finish("paint_black")
    builder.box(spec.paint("color", "#7a1f1c"), (0, 0, 0.3), (0.86, 0.42, 0.28), bevel=0.03)
    builder.box(steel, (0, -0.02, 0.08), (0.9, 0.48, 0.1), bevel=0.01)
    builder.box(steel, (0, 0.02, 0.46), (0.9, 0.46, 0.05), bevel=0.01)
    for x in (-0.24, 0.24):
        builder.cylinder(steel, (x, -0.2, 0.2), (x, -0.2, 0.28), 0.045, segments=12)
        builder.cylinder(black, (x, -0.24, 0.2), (x, -0.4, 0.18), 0.018, segments=8)
    for x in np.arange(-0.36, 0.4, 0.12):
        for y in (-0.1, 0.06):
            builder.lathe(finish("porcelain"), [(0.03, 0), (0.042, 0.06)], origin=(float(x), y, 0.49), segments=10)


@piece("serving_wall")
def serving_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the wall behind a diner's counter at y = 0: hatch to the kitchen, steel shelf, plates, mixer. Parameters:
    length."""
    length, steel = spec.number("length", 5.0), finish("steel")
    builder.box(steel, (0, -0.24, 0.9), (length, 0.46, 0.05), bevel=0.006)
    builder.box(finish("paint_white"), (0, -0.22, 0.44), (length, 0.4, 0.86))
    builder.box(finish("wall_tile"), (0, -0.015, 1.15), (length, 0.03, 0.5))
    for z in (1.12, 1.9):
        builder.box(steel, (-length * 0.12, -0.06, z), (length * 0.42, 0.14, 0.05))
    builder.box(finish("pane_warm"), (-length * 0.12, -0.02, 1.5), (length * 0.4, 0.03, 0.72))
    for x in np.linspace(-length * 0.28, length * 0.04, 5):
        builder.box(finish("paint_white"), (float(x), -0.07, 1.78), (0.09, 0.012, 0.14))
        builder.lathe(finish("porcelain"), [(0.07, 0), (0.13, 0.02)], origin=(float(x), -0.09, 1.15), segments=14)
    for x in np.arange(length * 0.16, length / 2 - 0.15, 0.3):
        for row in range(2):
            builder.lathe(finish("glass"), [(0.04, 0), (0.05, 0.13)], origin=(float(x), -0.14, 1.3 + 0.36 * row))
            builder.lathe(
                finish("porcelain"), [(0.06, 0), (0.07, 0.08)], origin=(float(x) + 0.14, -0.14, 1.3 + 0.36 * row)
            )
    for row in range(2):
        builder.box(steel, (length * 0.32, -0.13, 1.28 + 0.36 * row), (length * 0.34, 0.24, 0.025))
    for x in (-length * 0.42, length * 0.2):
        builder.lathe(steel, [(0.13, 0), (0.13, 0.34), (0.1, 0.42), (0.02, 0.44)], origin=(x, -0.26, 0.93), segments=16)
        builder.cylinder(finish("paint_black"), (x, -0.4, 1.02), (x, -0.45, 1.0), 0.015, segments=6)


@piece("jukebox")
def jukebox(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a jukebox with a lit arch, its back at y = 0, facing -Y."""
    arch = [(-0.42, 0.0), (0.42, 0.0), (0.42, 1.0)]
    arch += [(0.42 * np.cos(t), 1.0 + 0.42 * np.sin(t)) for t in np.linspace(0.2, np.pi - 0.2, 9)] + [(-0.42, 1.0)]
    with builder.at((0, 0, 0), (90, 0, 0)):
        builder.extrude(finish("wood_red"), arch, 0.5)
    for radius, key in ((0.37, "pane_warm"), (0.29, "paint_red"), (0.24, "pane_cool")):
        y = -0.51 - 0.1 * (0.4 - radius)
        arc = [(-radius * np.cos(t), y, 1.0 + radius * np.sin(t)) for t in np.linspace(0, np.pi, 9)]
        builder.tube(finish(key), [(-radius, y, 0.3), *arc, (radius, y, 0.3)], 0.035, segments=6)
    builder.box(finish("pane_cool"), (0, -0.51, 1.05), (0.4, 0.02, 0.34))
    builder.box(finish("chrome"), (0, -0.52, 0.78), (0.46, 0.05, 0.1), bevel=0.01)
    for x in np.linspace(-0.2, 0.2, 7):
        builder.box(finish("brass"), (float(x), -0.51, 0.45), (0.03, 0.02, 0.5))


@piece("teller_counter")
def teller_counter(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bank counter along x with teller windows, the customer side at -Y. Parameters: length, windows."""
    length, count = spec.number("length", 5.0), int(spec.number("windows", 3))
    builder.box(finish("wood_dark"), (0, 0, 0.54), (length, 0.6, 1.08))
    builder.box(finish("marble"), (0, -0.04, 1.1), (length + 0.06, 0.76, 0.06), bevel=0.01)
    each = length / count
    for index in range(count):
        x = (index + 0.5) * each - length / 2
        builder.box(finish("wood"), (x, -0.31, 0.55), (each - 0.2, 0.03, 0.8), bevel=0.01)
        builder.box(finish("brass"), (x, 0.02, 2.06), (each, 0.05, 0.06))
        builder.box(finish("brass"), (x, 0.0, 2.24), (0.44, 0.05, 0.26), bevel=0.01)
        builder.box(finish("paint_black"), (x, -0.03, 2.24), (0.34, 0.02, 0.16))
        for dx in (-each / 2, -0.3, 0.3):
            builder.box(finish("brass"), (x + dx, 0.02, 1.6), (0.035, 0.035, 0.95))
        for dx in np.arange(-0.24, 0.25, 0.08):
            builder.cylinder(finish("brass"), (x + dx, 0.02, 1.45), (x + dx, 0.02, 2.05), 0.008, segments=6)
    builder.box(finish("brass"), (length / 2, 0.02, 1.6), (0.035, 0.035, 0.95))
