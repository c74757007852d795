"""Set piece builders: apartment and garage pieces: kitchen units, tool walls, sectional doors."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("kitchenette")
def kitchenette(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build kitchen units on a wall at y = 0: cupboards, hob, sink, tiles, wall cupboards. Parameters: length, color,
    top."""
    length, front, metal = spec.number("length", 2.8), spec.paint("color", "#c8c4b6"), finish("chrome")
    builder.box(front, (0, -0.3, 0.48), (length, 0.56, 0.78))
    builder.box(finish("paint_black"), (0, -0.28, 0.05), (length, 0.5, 0.1))
    builder.box(spec.finish("top", "wood_light"), (0, -0.31, 0.9), (length + 0.02, 0.62, 0.05), bevel=0.006)
    builder.box(finish("wall_tile"), (0, -0.012, 1.2), (length, 0.024, 0.56))
    builder.box(front, (0, -0.17, 1.83), (length, 0.34, 0.7))
    count = max(3, round(length / 0.6))
    for index in range(count):
        x = length * ((index + 0.5) / count - 0.5)
        for y, z, tall in ((-0.585, 0.48, 0.74), (-0.345, 1.83, 0.66)):
            builder.box(front, (x, y, z), (length / count - 0.025, 0.018, tall), bevel=0.004)
            builder.box(metal, (x, y - 0.02, z + (0.3 if z < 1 else -0.27)), (0.12, 0.02, 0.014))
    hob, sink = -length * 0.3, length * 0.2
    builder.box(finish("paint_black"), (hob, -0.31, 0.93), (0.56, 0.48, 0.012))
    for dx in (-0.14, 0.14):
        for dy in (-0.11, 0.11):
            builder.cylinder(finish("iron"), (hob + dx, -0.31 + dy, 0.935), (hob + dx, -0.31 + dy, 0.945), 0.085)
    profile = [(0.1, 0), (0.12, 0.13), (0.125, 0.13)]
    builder.lathe(finish("steel"), profile, origin=(hob - 0.14, -0.2, 0.945), segments=16)
    builder.box(finish("steel"), (sink, -0.31, 0.925), (0.5, 0.42, 0.012))
    builder.box(finish("paint_grey"), (sink, -0.31, 0.93), (0.4, 0.32, 0.008))
    builder.tube(metal, [(sink, -0.08, 0.92), (sink, -0.08, 1.2), (sink, -0.16, 1.26), (sink, -0.24, 1.2)], 0.016)
    for index, skin in enumerate(("paint_red", "paint_yellow", "clay")):
        x = length * 0.4 - 0.12 * index
        builder.lathe(finish(skin), [(0.045, 0), (0.05, 0.14), (0.03, 0.16)], origin=(x, -0.14, 0.925), segments=12)


@piece("tool_wall")
def tool_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a board of tools on a wall at y = 0, lower edge at z = 0. Parameters: width, height, seed."""
    width, height = spec.number("width", 2.4), spec.number("height", 1.0)
    builder.box(spec.paint("color", "#8a6d45"), (0, -0.015, height / 2), (width, 0.03, height))
    steel, grips = finish("steel"), ("paint_red", "wood", "paint_yellow", "paint_black")
    for x in np.arange(-width / 2 + 0.12, width / 2 - 0.05, 0.17):
        for z in (height * 0.3, height * 0.78):
            kind, tall = int(spec.rng.integers(4)), float(spec.rng.uniform(0.2, 0.34))
            grip = finish(grips[int(spec.rng.integers(4))])
            at = float(x)
            if kind == 0:  # hammer
                builder.cylinder(grip, (at, -0.05, z - tall / 2), (at, -0.05, z + tall / 2), 0.014, segments=6)
                builder.box(steel, (at, -0.05, z + tall / 2), (0.13, 0.04, 0.04))
            elif kind == 1:  # wrench
                builder.box(steel, (at, -0.045, z), (0.026, 0.012, tall))
                for end in (-0.5, 0.5):
                    builder.cylinder(steel, (at, -0.04, z + end * tall), (at, -0.055, z + end * tall), 0.03, segments=8)
            elif kind == 2:  # screwdriver
                builder.cylinder(grip, (at, -0.05, z), (at, -0.05, z + 0.12), 0.02, segments=8)
                builder.cylinder(steel, (at, -0.05, z - 0.16), (at, -0.05, z), 0.007, segments=6)
            else:  # saw
                builder.polygon(
                    steel, [(at - 0.02, -0.04, z - 0.2), (at + 0.05, -0.04, z - 0.2), (at + 0.07, -0.04, z + 0.14),
                            (at - 0.06, -0.04, z + 0.14)],
                )  # fmt: skip
                builder.box(grip, (at, -0.05, z + 0.18), (0.13, 0.03, 0.1), bevel=0.01)


@piece("garage_door")
def garage_door(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a shut sectional door on a wall at y = 0, with its rails. Parameters: width, height, color."""
    width, height = spec.number("width", 2.6), spec.number("height", 2.2)
    skin, metal = spec.paint("color", "#c9c6bb"), finish("metal_grey")
    rows = 4
    for row in range(rows):
        z = (row + 0.5) * height / rows
        builder.box(skin, (0, -0.04, z), (width, 0.05, height / rows - 0.015), bevel=0.006)
        for column in range(4):
            x = (column + 0.5) * width / 4 - width / 2
            if row == 2:
                builder.box(spec.pane("pane_pale"), (x, -0.068, z), (width / 4 - 0.16, 0.01, height / rows - 0.22))
            else:
                builder.box(
                    finish("paint_white"), (x, -0.068, z), (width / 4 - 0.12, 0.012, height / rows - 0.16), bevel=0.005
                )
    for x in (-width / 2 - 0.06, width / 2 + 0.06):
        builder.box(metal, (x, -0.08, height / 2), (0.07, 0.14, height + 0.1))
        builder.tube(metal, [(x, -0.08, height), (x, -0.25, height + 0.16), (x, -1.6, height + 0.2)], 0.025, segments=6)
    builder.box(finish("paint_red"), (0, -0.09, 0.75), (0.16, 0.05, 0.04))


_LOADS = {
    "books": ("paint_red", "paint_green", "dado_brown", "paint_black", "paint_yellow", "clay"),
    "jars": ("clay", "glass_green", "paint_yellow", "plaster_cream", "paint_red"),
    "bottles": ("glass_green", "dado_brown", "paint_black", "plaster_cream"),
    "boxes": ("cardboard", "wood_light", "paint_grey", "dado_brown"),
    "plates": ("plaster_cream", "paint_blue", "plaster_cream"),
    "trinkets": ("clay", "brass", "paint_green", "plaster_cream", "paint_red"),
}
"""What stands on shelves -> its colours."""


@piece("wall_shelf")
def wall_shelf(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build two loaded boards on a wall at y = 0, the lower at z = 0. Parameters: length, load, seed."""
    length, load = spec.number("length", 0.9), spec.word("load", "books")
    skins = [finish(name) for name in _LOADS[load]]
    for z in (0.0, 0.34):
        builder.box(finish("wood"), (0, -0.1, z), (length, 0.2, 0.025), bevel=0.004)
        for x in (-length / 2 + 0.08, length / 2 - 0.08):
            builder.box(finish("wood_dark"), (x, -0.09, z - 0.06), (0.025, 0.16, 0.1))
        at = -length / 2 + 0.04
        while at < length / 2 - 0.1:
            wide, tall = _ON_SHELF[load]
            width, height = (float(spec.rng.uniform(*span)) for span in (wide, tall))
            width = min(width, length / 2 - 0.03 - at)
            skin = skins[int(spec.rng.integers(len(skins)))]
            if load in ("books", "boxes"):
                builder.box(skin, (at + width / 2, -0.11, z + 0.0125 + height / 2), (width * 0.94, 0.15, height))
            elif load == "plates":
                disc = (at + width / 2, -0.05, z + 0.0125 + width / 2)
                builder.cylinder(skin, disc, (disc[0], -0.065, disc[2]), width * 0.48, segments=16)
            else:
                radius = width * 0.42
                neck = 0.35 if load == "bottles" else 0.8
                rings = [(radius, 0), (radius, height * 0.6), (radius * neck, height * 0.8), (radius * neck, height)]
                builder.lathe(skin, rings, origin=(at + width / 2, -0.1, z + 0.0125), segments=10)
            at += width + float(spec.rng.choice([0.0, 0.01, 0.12], p=[0.55, 0.3, 0.15]))


_ON_SHELF = {
    "books": ((0.025, 0.06), (0.17, 0.25)), "jars": ((0.1, 0.14), (0.12, 0.2)), "bottles": ((0.07, 0.11), (0.16, 0.28)),
    "boxes": ((0.14, 0.3), (0.1, 0.24)), "plates": ((0.2, 0.26), (0.2, 0.26)), "trinkets": ((0.08, 0.16), (0.08, 0.22)),
}  # fmt: skip
"""Widths and heights of what stands on shelves, least and most metres."""
