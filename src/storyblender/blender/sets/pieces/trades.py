"""What shops are known by: stocked shelves, places at the barber's, washing machines, post boxes."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
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
                builder.lathe(
                    skin,
                    [(r, 0), (r, tall * 0.6), (r * 0.4, tall * 0.75), (r * 0.4, tall)],
                    origin=(x, -0.18, foot),
                    segments=8,
                )
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
    """Build a barber's place on a wall at y = 0: mirror, lamps, shelf with bottles, drawers."""
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
        builder.lathe(
            skin, [(0.035, 0), (0.04, 0.12), (0.014, 0.15), (0.014, 0.2)], origin=(x, -0.14, 0.905), segments=10
        )


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
    """Build a row of washing machines along x that face -Y, backs at y = 0; two high as dryers. Parameters: length,
    stacked."""
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
