"""Set piece builders: clinic and office pieces: exam couches, wall charts, bed curtains, medicine cabinets, copiers."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.joinery import folded_cloth
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.tags import Surface


@piece("bed_curtain", Surface.CLOTH)
def bed_curtain(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a curtain along x on its rail, as between hospital beds. Parameters: width, height, color."""
    width, height = spec.number("width", 2.0), spec.number("height", 2.1)
    builder.cylinder(finish("chrome"), (-width / 2 - 0.1, 0, height + 0.02), (width / 2 + 0.1, 0, height + 0.02), 0.015)
    folded_cloth(builder, spec.paint("color", "#8fb3b0"), -width / 2, width / 2, 0, 0.3, height, depth=0.05)


@piece("exam_couch")
def exam_couch(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an examination couch along y with a sheet of paper on it, its head at +Y."""
    pad, steel = spec.paint("color", "#3f6b66"), finish("steel")
    builder.rounded_box(pad, (0, -0.3, 0.66), (0.64, 1.3, 0.12), 0.04)
    builder.rounded_box(pad, (0, 0.62, 0.76), (0.64, 0.62, 0.12), 0.04, rotation=(28, 0, 0))
    builder.box(finish("paint_white"), (0, -0.3, 0.725), (0.44, 1.3, 0.008))
    for x in (-0.26, 0.26):
        for y in (-0.8, 0.55):
            builder.cylinder(steel, (x, y, 0), (x, y, 0.62), 0.02, segments=8)
        builder.cylinder(steel, (x, -0.8, 0.25), (x, 0.55, 0.25), 0.015, segments=6)


@piece("eye_chart")
def eye_chart(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang an eye chart on a wall at y = 0, lower edge at z = 0."""
    builder.box(finish("paint_white"), (0, -0.012, 0.45), (0.6, 0.024, 0.9))
    for row in range(7):
        size = 0.13 * 0.76**row
        z, count = 0.8 - 0.36 * (1 - 0.76**row) * 2.05, row + 1
        for index in range(count):
            x = (index - (count - 1) / 2) * size * 1.7
            if abs(x) < 0.27:
                builder.box(finish("paint_black"), (x, -0.027, z), (size * 0.9, 0.004, size * 0.3))
                builder.box(finish("paint_black"), (x - size * 0.3, -0.027, z), (size * 0.25, 0.004, size))


@piece("anatomy_chart")
def anatomy_chart(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang an anatomy chart on a wall at y = 0, lower edge at z = 0."""
    builder.box(finish("paint_cream"), (0, -0.012, 0.55), (0.7, 0.024, 1.1))
    red, bone = painted("#a8473c"), painted("#d8c8a8")
    builder.sphere(red, (0, -0.02, 0.93), 0.055, scale=(1, 0.2, 1.25), segments=12, rings=7)
    builder.box(red, (0, -0.027, 0.7), (0.2, 0.006, 0.3), taper=1.0)
    for side in (-1, 1):
        builder.box(red, (side * 0.15, -0.027, 0.68), (0.05, 0.006, 0.34), rotation=(0, side * 10, 0))
        builder.box(red, (side * 0.055, -0.027, 0.34), (0.08, 0.006, 0.44))
    for index in range(4):
        builder.box(bone, (0, -0.033, 0.62 + 0.055 * index), (0.15, 0.004, 0.015))
    for z in np.arange(0.2, 1.0, 0.12):
        for side in (-1, 1):
            builder.box(finish("paint_black"), (side * 0.28, -0.027, float(z)), (0.08, 0.004, 0.012))


@piece("medicine_cabinet")
def medicine_cabinet(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a white cabinet of bottles and boxes behind glass, its back at y = 0."""
    white = finish("paint_white")
    builder.box(white, (0, -0.2, 0.42), (0.95, 0.4, 0.84), bevel=0.008)
    builder.box(white, (0, -0.03, 1.36), (0.95, 0.06, 1.0))
    for x in (-0.46, 0.0, 0.46):
        builder.box(white, (x, -0.17, 1.36), (0.03, 0.32, 1.0))
    for z in (0.87, 1.18, 1.5, 1.86):
        builder.box(white, (0, -0.17, z), (0.95, 0.33, 0.025))
    for z in (0.885, 1.195, 1.515):
        for x in np.arange(-0.4, 0.42, 0.085):
            tall = float(spec.rng.uniform(0.1, 0.2))
            skin = finish(
                str(spec.rng.choice(("glass_amber", "paint_blue", "paint_white", "paint_green", "paint_red")))
            )
            if abs(x) > 0.04:
                builder.box(skin, (float(x), -0.2, z + tall / 2), (0.06, 0.06, tall))
    for x in (-0.24, 0.24):
        builder.box(finish("chrome"), (x * 0.3, -0.42, 0.5), (0.02, 0.03, 0.16))


@piece("desk_screen")
def desk_screen(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a low partition along x behind a desk. Parameters: width, height, color."""
    width, height = spec.number("width", 1.6), spec.number("height", 1.2)
    builder.box(spec.paint("color", "#7f929c"), (0, 0, height / 2 + 0.05), (width, 0.04, height - 0.1))
    for z in (height, 0.1):
        builder.box(finish("metal_grey"), (0, 0, z), (width, 0.05, 0.03))
    for x in (-width / 2, width / 2):
        builder.box(finish("metal_grey"), (x, 0, height / 2), (0.03, 0.05, height))


@piece("copier")
def copier(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an office copier, its back at y = 0."""
    body = finish("paint_cream")
    builder.box(body, (0, -0.33, 0.5), (0.64, 0.62, 1.0), bevel=0.02)
    builder.box(finish("paint_grey"), (0, -0.33, 1.05), (0.66, 0.58, 0.1), bevel=0.02)
    builder.box(finish("paint_black"), (0.18, -0.6, 1.03), (0.24, 0.14, 0.02), rotation=(20, 0, 0))
    for z in (0.2, 0.42, 0.64):
        builder.box(finish("paint_grey"), (0, -0.645, z), (0.56, 0.02, 0.17), bevel=0.006)
    builder.box(finish("paint_white"), (-0.4, -0.33, 0.8), (0.26, 0.36, 0.02))


@piece("head_panel")
def head_panel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a padded panel behind a bed on a wall at y = 0. Parameters: width, height, color."""
    width, height, cloth = spec.number("width", 3.4), spec.number("height", 1.2), spec.paint("color", "#6d5548")
    count = max(3, round(width / 0.45))
    for index in range(count):
        x = (index + 0.5) * width / count - width / 2
        builder.rounded_box(cloth, (x, -0.03, height / 2 + 0.1), (width / count - 0.012, 0.06, height - 0.1), 0.025)
    builder.box(finish("wood_dark"), (0, -0.035, height + 0.07), (width + 0.04, 0.07, 0.03))


@piece("tyre_stack")
def tyre_stack(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a stack of tyres. Parameters: count."""
    ring = [(0.2, 0.02), (0.3, 0.0), (0.33, 0.05), (0.33, 0.15), (0.3, 0.2), (0.2, 0.18), (0.2, 0.02)]
    for index in range(int(spec.number("count", 4))):
        x, y = (float(value) for value in spec.rng.uniform(-0.025, 0.025, 2))
        builder.lathe(finish("rubber"), ring, origin=(x, y, 0.2 * index), segments=20, caps=False)
