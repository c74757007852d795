"""Set piece builders: shop and trade: stocked shelves, barber stations, washing machines, post boxes, vault doors."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.ordinary_worn import dress_form_of
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece

_STOCK: dict[str, tuple[str, ...]] = {
    "boxes": ("#d8d4c8", "#7f9cb0", "#c9b878", "#9fb59a", "#b0746a"),
    "bottles": ("#6b3a1f", "#2f4a3a", "#a8702a", "#57606a", "#c9c4b4"),
    "bread": ("#b5793a", "#8f5626", "#c99a5a"),
    "cloth": ("#6b3a3a", "#2f4a5f", "#57604a", "#8a7a5a", "#3a3a40"),
    "files": ("#8a7a5a", "#6b5a40", "#a89a78", "#5f6a6f"),
    "parcels": ("#a8834f", "#b8935c", "#977343", "#c9c0a8"),
}


@piece("stock_shelf")
def stock_shelf(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build stocked shelves on a wall at y = 0. Parameters: length, height, kind (boxes, bottles, bread, cloth, files,
    parcels), color, seed."""
    length, height, kind = spec.number("length", 2.4), spec.number("height", 2.1), spec.word("kind", "boxes")
    frame, palette = spec.paint("color", "#8a6a45"), _STOCK[kind]
    builder.box(frame, (0, -0.015, height / 2), (length, 0.03, height))
    for x in np.linspace(-length / 2, length / 2, max(2, round(length / 1.1) + 1)):
        builder.box(frame, (float(x), -0.17, height / 2), (0.035, 0.34, height))
    rows = max(3, round(height / 0.36))
    for row in range(rows + 1):
        z = max(0.06, row * height / rows - 0.015)
        builder.box(frame, (0, -0.17, z), (length, 0.34, 0.03))
        if row == rows:
            break
        at, room = -length / 2 + 0.05, height / rows - 0.07
        while at < length / 2 - 0.12:
            skin = painted(palette[int(spec.rng.integers(len(palette)))])
            wide = float(spec.rng.uniform(0.07, 0.2))
            tall = room * float(spec.rng.uniform(0.55, 0.98))
            x, foot = at + wide / 2, z + 0.015
            if kind == "bottles":
                r = wide * 0.3
                profile = [(r, 0), (r, tall * 0.6), (r * 0.4, tall * 0.75), (r * 0.4, tall)]
                builder.lathe(skin, profile, origin=(x, -0.18, foot), segments=8)
            elif kind == "bread":
                builder.cushion(skin, (x, -0.18, foot + tall * 0.3), (wide * 1.1, 0.26, tall * 0.6), softness=0.8)
            elif kind == "cloth":
                builder.box(skin, (x, -0.18, foot + tall * 0.35), (wide, 0.28, tall * 0.7), bevel=0.02)
            else:
                builder.box(skin, (x, -0.18, foot + tall / 2), (wide - 0.008, 0.24, tall))
                if kind == "files":
                    builder.box(finish("paint_cream"), (x, -0.302, foot + tall * 0.7), (wide * 0.6, 0.006, tall * 0.2))
            at += wide + float(spec.rng.uniform(0.0, 0.03))


@piece("barber_station")
def barber_station(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a barber station on a wall at y = 0: mirror, lamps, shelf with bottles, drawers."""
    builder.box(finish("wood_dark"), (0, -0.02, 1.55), (1.15, 0.04, 1.25), bevel=0.01)
    builder.box(finish("frosted"), (0, -0.045, 1.55), (0.98, 0.01, 1.08))
    builder.box(finish("marble"), (0, -0.2, 0.88), (1.2, 0.4, 0.05), bevel=0.008)
    builder.box(finish("wood_dark"), (0, -0.18, 0.68), (1.1, 0.34, 0.34))
    for x in (-0.27, 0.27):
        builder.box(finish("wood"), (x, -0.355, 0.68), (0.5, 0.02, 0.28), bevel=0.006)
        builder.sphere(finish("brass"), (x, -0.38, 0.68), 0.018, segments=8, rings=5)
    for x in (-0.66, 0.66):
        builder.sphere(finish("lampshade"), (x, -0.1, 1.9), 0.09, segments=12, rings=8)
        builder.cylinder(finish("brass"), (x, 0, 1.78), (x, -0.1, 1.82), 0.015, segments=6)
    for index, x in enumerate((-0.45, -0.33, -0.2, 0.3, 0.42)):
        skin = finish(("glass_amber", "paint_green", "paint_blue", "paint_white", "glass_amber")[index])
        profile = [(0.035, 0), (0.04, 0.12), (0.014, 0.15), (0.014, 0.2)]
        builder.lathe(skin, profile, origin=(x, -0.14, 0.905), segments=10)


@piece("barber_chair")
def barber_chair(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a barber's chair that faces -Y."""
    pad, chrome = spec.paint("color", "#7a1f1c"), finish("chrome")
    builder.lathe(chrome, [(0.32, 0), (0.3, 0.04), (0.08, 0.08), (0.06, 0.4)], segments=20)
    builder.rounded_box(pad, (0, 0, 0.5), (0.54, 0.54, 0.16), 0.06)
    builder.rounded_box(pad, (0, 0.27, 0.88), (0.52, 0.13, 0.66), 0.06, rotation=(-8, 0, 0))
    builder.rounded_box(pad, (0, 0.34, 1.3), (0.28, 0.1, 0.16), 0.05)
    for x in (-0.31, 0.31):
        builder.tube(chrome, [(x, 0.24, 0.5), (x, 0.22, 0.72), (x, -0.22, 0.72), (x, -0.24, 0.48)], 0.025)
        builder.rounded_box(pad, (x, 0, 0.75), (0.09, 0.4, 0.05), 0.02)
    builder.box(chrome, (0, -0.5, 0.24), (0.4, 0.22, 0.03), rotation=(-14, 0, 0))
    builder.tube(chrome, [(0, -0.25, 0.42), (0, -0.46, 0.25)], 0.03)


@piece("washer_row")
def washer_row(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a row of washing machines along x that face -Y, backs at y = 0. Parameters:
    length, stacked (two machines high, as dryers)."""
    length, high = spec.number("length", 4.2), 2 if spec.flag("stacked") else 1
    count = max(1, round(length / 0.7))
    for index in range(count):
        for level in range(high):
            with builder.at(((index + 0.5) * length / count - length / 2, -0.35, 0.92 * level)):
                builder.box(finish("paint_white"), (0, 0, 0.46), (length / count - 0.03, 0.68, 0.9), bevel=0.015)
                builder.box(finish("metal_grey"), (0, -0.345, 0.82), (length / count - 0.08, 0.012, 0.13))
                builder.box(finish("paint_black"), (0.12, -0.355, 0.82), (0.16, 0.01, 0.06))
                builder.cylinder(finish("chrome"), (0, -0.33, 0.42), (0, -0.37, 0.42), 0.25, segments=22)
                builder.cylinder(finish("glass_dark"), (0, -0.365, 0.42), (0, -0.385, 0.42), 0.19, segments=20)
                if (index + level) % 3 == 0:
                    builder.cylinder(painted("#8a5a4a"), (0, -0.386, 0.38), (0, -0.388, 0.38), 0.13, segments=12)


@piece("parcel_counter")
def parcel_counter(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build rows of numbered post boxes on a wall at y = 0, lower edge at z = 0. Parameters: width, height."""
    width, height, brass = spec.number("width", 2.0), spec.number("height", 1.2), finish("brass")
    builder.box(finish("wood_dark"), (0, -0.05, height / 2), (width, 0.1, height))
    columns, rows = max(3, round(width / 0.2)), max(3, round(height / 0.2))
    for column in range(columns):
        for row in range(rows):
            x, z = ((column + 0.5) / columns - 0.5) * width, (row + 0.5) * height / rows
            builder.box(brass, (x, -0.105, z), (width / columns - 0.02, 0.012, height / rows - 0.02))
            builder.box(finish("paint_black"), (x, -0.114, z + 0.02), (0.05, 0.006, 0.03))
            builder.cylinder(finish("iron"), (x, -0.112, z - 0.04), (x, -0.122, z - 0.04), 0.012, segments=6)


@piece("vault_door")
def vault_door(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the round steel door of a vault on a wall at y = 0."""
    steel, dark = finish("steel"), finish("metal_grey")
    builder.box(dark, (0, -0.06, 1.25), (2.3, 0.12, 2.5), bevel=0.02)
    builder.cylinder(steel, (0, -0.1, 1.25), (0, -0.34, 1.25), 0.98, segments=32)
    builder.cylinder(dark, (0, -0.34, 1.25), (0, -0.37, 1.25), 0.8, segments=30)
    for t in np.linspace(0, 2 * math.pi, 13)[:-1]:
        x, z = 0.88 * math.cos(t), 1.25 + 0.88 * math.sin(t)
        builder.cylinder(finish("brass"), (x, -0.33, z), (x, -0.37, z), 0.045, segments=8)
    ring = [(0.36 * math.cos(t), -0.52, 1.25 + 0.36 * math.sin(t)) for t in np.linspace(0, 2 * math.pi, 21)[:-1]]
    builder.tube(finish("brass"), ring, 0.025, segments=6, closed=True)
    for t in np.arange(0, math.pi, math.pi / 3):
        x, z = 0.36 * math.cos(t), 0.36 * math.sin(t)
        builder.cylinder(finish("brass"), (-x, -0.52, 1.25 - z), (x, -0.52, 1.25 + z), 0.018, segments=6)
    builder.cylinder(steel, (0, -0.36, 1.25), (0, -0.54, 1.25), 0.07, segments=12)
    for z in (0.6, 1.9):
        builder.box(steel, (-1.08, -0.2, z), (0.24, 0.2, 0.34), bevel=0.03)


@piece("writing_stand")
def writing_stand(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a sloping writing stand with pens on chains, its back to +Y."""
    builder.box(finish("wood_dark"), (0, 0.1, 0.55), (1.3, 0.3, 1.1))
    builder.box(finish("wood"), (0, 0, 1.13), (1.4, 0.56, 0.05), rotation=(12, 0, 0), bevel=0.01)
    for x in (-0.4, 0.1, 0.45):
        builder.box(finish("paint_white"), (x, -0.02, 1.16), (0.2, 0.28, 0.004), rotation=(12, 0, 8))
        builder.cylinder(finish("paint_black"), (x + 0.15, -0.08, 1.15), (x + 0.17, 0.06, 1.19), 0.006, segments=5)


@piece("pharmacy_cross")
def pharmacy_cross(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a green cross with a pale edge on a wall at y = 0."""
    for key, size, y in (("paint_white", 0.46, -0.03), ("paint_green", 0.4, -0.06)):
        builder.box(finish(key), (0, y, 0.25), (size, 0.04, size / 3), bevel=0.006)
        builder.box(finish(key), (0, y, 0.25), (size / 3, 0.04, size), bevel=0.006)


@piece("barber_pole")
def barber_pole(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a striped barber's pole on a wall at y = 0, lower edge at z = 0."""
    for index in range(14):
        skin = finish(("paint_white", "paint_red", "paint_white", "paint_blue")[index % 4])
        builder.cylinder(skin, (0, -0.15, 0.08 + 0.05 * index), (0.0, -0.15, 0.13 + 0.05 * index), 0.08, segments=14)
    for z in (0.04, 0.82):
        builder.sphere(finish("brass"), (0, -0.15, z), 0.1, segments=12, rings=7)
        builder.box(finish("brass"), (0, -0.07, z), (0.05, 0.14, 0.05))


@piece("brick_oven")
def brick_oven(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bakery brick oven with a lit opening, its back at y = 0."""
    brick = finish("brick_red")
    builder.box(brick, (0, -0.45, 0.45), (1.9, 0.9, 0.9))
    builder.box(finish("stone_light"), (0, -0.5, 0.93), (2.0, 1.0, 0.08), bevel=0.01)
    for side in (-1, 1):
        builder.box(brick, (side * 0.7, -0.4, 1.4), (0.5, 0.8, 0.9))
    builder.box(brick, (0, -0.4, 1.95), (1.9, 0.8, 0.7))
    builder.box(finish("plaster_soot"), (0, -0.25, 1.3), (0.9, 0.5, 0.66))
    builder.box(finish("pane_warm"), (0, -0.51, 1.1), (0.7, 0.02, 0.2))
    for x in (-0.2, 0.0, 0.2):
        builder.lathe(finish("flame"), [(0.08, 0), (0.06, 0.12), (0.01, 0.26)], origin=(x, -0.55, 1.0), segments=8)
    for k in range(7):
        t = math.pi * (k + 0.5) / 7
        x, z = 0.5 * math.cos(t), 1.42 + 0.3 * math.sin(t)
        builder.box(finish("stone_light"), (x, -0.82, z), (0.16, 0.06, 0.22), rotation=(0, 90 - math.degrees(t), 0))
    builder.cylinder(finish("wood_light"), (0.85, -0.92, 0.0), (0.78, -0.88, 2.0), 0.02, segments=6)


@piece("dress_form")
def dress_form(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a dress form on a stand with a half-finished coat, facing -Y. Parameters: color."""
    dress_form_of(builder, spec.paint("color", "#2f3a4a"), finish("wood_dark"), finish("linen"))
    for side in (-1, 1):
        builder.box(finish("paint_cream"), (side * 0.05, -0.135, 1.33), (0.02, 0.012, 0.2), rotation=(0, side * 20, 0))


@piece("vet_table")
def vet_table(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a steel veterinary examination table with a lamp above."""
    steel = finish("steel")
    builder.box(steel, (0, 0, 0.88), (1.4, 0.65, 0.05), bevel=0.01)
    builder.box(steel, (0, 0, 0.45), (0.3, 0.3, 0.84))
    builder.box(steel, (0, 0, 0.03), (0.9, 0.5, 0.06), bevel=0.01)
    builder.tube(finish("paint_white"), [(0.9, 0.3, 0), (0.9, 0.3, 1.9), (0.6, 0.2, 2.05), (0.3, 0.1, 1.95)], 0.025)
    builder.lathe(finish("paint_white"), [(0.06, 0.1), (0.2, 0.0)], origin=(0.26, 0.1, 1.86), segments=18, caps=False)
    builder.cylinder(finish("lamp_cool"), (0.26, 0.1, 1.87), (0.26, 0.1, 1.88), 0.15, segments=16)


@piece("cage_wall")
def cage_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build three rows of cages on a wall at y = 0. Parameters: length."""
    length, steel = spec.number("length", 3.0), finish("metal_grey")
    count = max(2, round(length / 0.8))
    for x in np.linspace(-length / 2, length / 2, count + 1):
        builder.box(steel, (float(x), -0.3, 0.9), (0.03, 0.6, 1.8))
    for z in (0.06, 0.6, 1.2, 1.8):
        builder.box(steel, (0, -0.3, z), (length, 0.6, 0.03))
    for x in np.arange(-length / 2 + 0.08, length / 2, 0.08):
        builder.cylinder(steel, (float(x), -0.6, 0.06), (float(x), -0.6, 1.8), 0.006, segments=4, caps=False)
    for column in range(count):
        x = (column + 0.5) * length / count - length / 2
        for z in (0.09, 0.63, 1.23):
            if spec.rng.random() < 0.6:
                builder.cushion(painted("#7a5a4a"), (x, -0.3, z + 0.05), (length / count * 0.7, 0.4, 0.1), softness=0.7)


@piece("shackles")
def shackles(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang two chains with shackles on a wall at y = 0, from z = 0 down."""
    iron = finish("iron")
    for x in (-0.35, 0.35):
        builder.cylinder(iron, (x, 0, 0), (x, -0.06, 0), 0.07, segments=10)
        for link in range(7):
            turn = (0, 0, 90) if link % 2 else (0, 0, 0)
            center = (x * (1 - 0.02 * link), -0.05, -0.06 - 0.075 * link)
            builder.box(iron, center, (0.05, 0.018, 0.075), rotation=turn, bevel=0.006)
        ring = [
            (x * 0.86 + 0.055 * math.cos(t), -0.05 + 0.055 * math.sin(t), -0.62) for t in np.linspace(0, 6.28, 13)[:-1]
        ]
        builder.tube(iron, ring, 0.014, segments=5, closed=True)
