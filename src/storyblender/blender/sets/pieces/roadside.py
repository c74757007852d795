"""Set piece builders: roadside pieces: parking bays, stores, petrol pumps, canopies, road signs, telegraph poles."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("parking_bays")
def parking_bays(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Paint parking bays side by side along x. Parameters: length, depth of a bay, width of a bay."""
    length, depth, width = spec.number("length", 40), spec.number("depth", 5), spec.number("width", 2.6)
    white = finish("paint_cream")
    for x in np.arange(-length / 2, length / 2 + 0.01, width):
        left, right, half = float(x) - 0.06, float(x) + 0.06, depth / 2
        builder.quad(white, (left, -half, 0.012), (right, -half, 0.012), (right, half, 0.012), (left, half, 0.012))


@piece("big_box_store")
def big_box_store(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a low store that faces -Y with a lit glass front and a sign. Parameters: width, height, color."""
    width, height = spec.number("width", 30), spec.number("height", 6.0)
    wall, sign = finish("plaster_cream"), spec.paint("color", "#9a2b22")
    builder.box(wall, (0, 6, height / 2), (width, 12, height))
    builder.box(sign, (0, -0.15, height - 0.9), (width, 0.3, 1.0))
    builder.box(finish("stone_light"), (0, -0.05, height + 0.1), (width + 0.3, 12.3, 0.25))
    front = width * 0.56
    builder.box(finish("glass_dark"), (0, -0.02, 1.7), (front, 0.08, 3.2))
    for index in range(int(front / 1.6)):
        x = -front / 2 + 1.6 * (index + 0.5)
        builder.box(spec.pane("pane_warm" if index % 3 else "pane_pale"), (x, -0.07, 1.65), (1.48, 0.02, 3.0))
    for x in np.arange(-front / 2, front / 2 + 0.1, 1.6):
        builder.box(finish("metal_grey"), (float(x), -0.1, 1.7), (0.08, 0.1, 3.3))
    builder.box(finish("metal_grey"), (0, -1.2, 3.45), (front + 1, 2.4, 0.22))
    builder.box(finish("paint_white"), (0, -0.32, height - 0.9), (width * 0.3, 0.06, 0.62))
    at = -width * 0.13
    while at < width * 0.12:
        wide = float(spec.rng.uniform(0.3, 0.55))
        builder.box(sign, (at + wide / 2, -0.36, height - 0.9), (wide, 0.04, 0.4))
        at += wide + 0.14


@piece("bay_sign")
def bay_sign(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the number of a parking bay on a wall at y = 0. Parameters: seed."""
    builder.box(finish("paint_blue"), (0, -0.01, 0), (0.44, 0.02, 0.34), bevel=0.006)
    for x in (-0.09, 0.07):
        wide = float(spec.rng.uniform(0.05, 0.1))
        builder.box(finish("paint_white"), (x, -0.025, 0), (wide, 0.01, 0.2))


@piece("petrol_pump")
def petrol_pump(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a petrol pump with its hose, facing -Y. Parameters: color, old (with a globe on top)."""
    body, white = spec.paint("color", "#a3241d"), finish("paint_white")
    builder.box(finish("concrete_light"), (0, 0, 0.08), (1.5, 0.9, 0.16), bevel=0.02)
    builder.box(body, (0, 0, 0.85), (0.7, 0.5, 1.4), bevel=0.04)
    builder.box(white, (0, 0, 1.62), (0.74, 0.54, 0.24), bevel=0.03)
    for side in (-1, 1):
        builder.box(finish("paint_black"), (0, side * 0.255, 1.25), (0.5, 0.02, 0.36))
        builder.box(white, (0, side * 0.268, 1.29), (0.4, 0.01, 0.1))
        builder.box(finish("paint_yellow"), (0, side * 0.268, 1.15), (0.3, 0.01, 0.06))
    path = [(0.36, 0, 1.3), (0.52, 0, 1.0), (0.5, 0, 0.5), (0.42, 0, 0.6), (0.4, 0, 1.0)]
    builder.tube(finish("rubber"), path, 0.022)
    builder.box(finish("paint_black"), (0.4, 0, 1.05), (0.08, 0.06, 0.3), bevel=0.01)
    if spec.flag("old"):
        builder.cylinder(white, (0, 0.07, 1.95), (0, -0.07, 1.95), 0.24, segments=24)
        builder.cylinder(body, (0, -0.072, 1.95), (0, -0.078, 1.95), 0.15, segments=20)


@piece("canopy_roof")
def canopy_roof(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the lit canopy of a filling station on four posts, centred on the origin. Parameters: width, depth,
    height, color."""
    width, depth, height = spec.number("width", 10), spec.number("depth", 6), spec.number("height", 4.6)
    builder.box(finish("paint_white"), (0, 0, height + 0.3), (width, depth, 0.6), bevel=0.03)
    for y in (-depth / 2, depth / 2):
        builder.box(spec.paint("color", "#a3241d"), (0, y * 1.004, height + 0.3), (width + 0.04, 0.05, 0.34))
    for x in (-width * 0.34, width * 0.34):
        for y in (-depth * 0.3, depth * 0.3):
            builder.box(finish("metal_grey"), (x, y, height / 2), (0.26, 0.26, height))
        for y in (-depth * 0.16, depth * 0.16):
            builder.box(spec.pane("pane_pale"), (x * 0.6, y, height - 0.012), (1.4, 0.5, 0.02))


@piece("price_sign")
def price_sign(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the tall sign of a filling station that faces -Y. Parameters: height, color."""
    height, body = spec.number("height", 6.5), spec.paint("color", "#a3241d")
    for x in (-0.8, 0.8):
        builder.box(finish("metal_grey"), (x, 0, height / 2 - 0.5), (0.16, 0.16, height - 1))
    builder.box(body, (0, 0, height - 0.6), (2.3, 0.3, 1.3), bevel=0.04)
    builder.cylinder(finish("paint_white"), (0, -0.16, height - 0.6), (0, -0.19, height - 0.6), 0.45, segments=26)
    builder.cylinder(finish("paint_yellow"), (0, -0.19, height - 0.6), (0, -0.2, height - 0.6), 0.3, segments=5)
    for row in range(3):
        z = height - 1.65 - 0.62 * row
        builder.box(finish("paint_black"), (0, -0.02, z), (2.0, 0.2, 0.54), bevel=0.01)
        for x in (-0.3, 0.05, 0.4, 0.75):
            builder.box(spec.pane("pane_amber"), (x, -0.13, z), (float(spec.rng.uniform(0.1, 0.2)), 0.01, 0.32))


@piece("guard_rail")
def guard_rail(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a crash barrier along x, the road at -Y. Parameters: length."""
    length, metal = spec.number("length", 60), finish("metal_grey")
    for z in (0.52, 0.68):
        builder.cylinder(metal, (-length / 2, -0.06, z), (length / 2, -0.06, z), 0.075, segments=6)
    builder.box(metal, (0, -0.02, 0.6), (length, 0.03, 0.26))
    for x in np.arange(-length / 2 + 1, length / 2, 2.5):
        builder.box(metal, (float(x), 0.06, 0.36), (0.1, 0.1, 0.72))


@piece("pole_line")
def pole_line(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Run telegraph poles with sagging wires along x. Parameters: length, step, height."""
    length, step, height = spec.number("length", 120), spec.number("step", 24), spec.number("height", 7.5)
    wood, wire = finish("wood_gray"), finish("iron")
    xs = np.arange(-length / 2, length / 2 + 0.1, step)
    for x in xs:
        builder.cylinder(wood, (float(x), 0, -0.3), (float(x), 0, height), 0.14, 0.1, segments=8)
        for z in (height - 0.4, height - 1.0):
            builder.box(wood, (float(x), 0, z), (0.12, 1.7, 0.12))
            for y in (-0.75, -0.4, 0.4, 0.75):
                builder.cylinder(
                    finish("glass_green"), (float(x), y, z + 0.06), (float(x), y, z + 0.17), 0.03, segments=6
                )
    for x in xs[:-1]:
        for y in (-0.75, 0.75):
            sag = [(float(x) + step * t, y, height - 0.24 - 2.2 * t * (1 - t)) for t in np.linspace(0, 1, 7)]
            builder.tube(wire, sag, 0.012, segments=3)


@piece("road_board")
def road_board(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a large green road sign with white lines that faces -Y. Parameters: width, color."""
    width, white = spec.number("width", 3.4), finish("paint_white")
    for x in (-width * 0.32, width * 0.32):
        builder.box(finish("metal_grey"), (x, 0.08, 1.7), (0.1, 0.1, 3.4))
    builder.box(spec.paint("color", "#1f5a3a"), (0, 0, 2.7), (width, 0.08, 1.5), bevel=0.02)
    for x, z, wide in ((-0.3, 3.1, 0.5), (-0.2, 2.7, 0.62), (-0.35, 2.3, 0.42)):
        builder.box(white, (x, -0.045, z), (width * wide, 0.01, 0.17))
        builder.box(white, (width * 0.38, -0.045, z), (0.22, 0.01, 0.17))


@piece("billboard")
def billboard(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a billboard on posts that faces -Y. Parameters: width, height."""
    width, height = spec.number("width", 9.0), spec.number("height", 3.6)
    for x in (-width * 0.36, 0.0, width * 0.36):
        builder.box(finish("metal_grey"), (x, 0.2, 2.2), (0.24, 0.24, 4.4))
    builder.box(finish("paint_grey"), (0, 0.05, 3.2 + height / 2), (width, 0.2, height))
    builder.box(finish("paint_cream"), (0, -0.06, 3.2 + height / 2), (width - 0.3, 0.02, height - 0.3))
    builder.box(finish("paint_blue"), (width * 0.18, -0.075, 3.2 + height * 0.5), (width * 0.5, 0.01, height * 0.62))
    start, end = (-width * 0.28, -0.07, 3.2 + height / 2), (-width * 0.28, -0.085, 3.2 + height / 2)
    builder.cylinder(finish("paint_yellow"), start, end, height * 0.3, segments=28)
    for z in (0.62, 0.4):
        builder.box(
            finish("paint_white"), (width * 0.18, -0.085, 3.2 + height * z), (width * 0.38, 0.01, height * 0.11)
        )


@piece("station_shop")
def station_shop(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the shop of a filling station that faces -Y, its front at y = 0. Parameters: width, color."""
    width, metal = spec.number("width", 9.0), finish("metal_grey")
    builder.box(finish("plaster_cream"), (0, 3, 1.7), (width, 6, 3.4))
    builder.box(spec.paint("color", "#a3241d"), (0, -0.1, 3.25), (width + 0.3, 0.5, 0.6), bevel=0.02)
    builder.box(finish("paint_white"), (0, -0.37, 3.25), (width * 0.34, 0.03, 0.34))
    for x in np.linspace(-width / 2 + 0.9, width / 2 - 0.9, max(3, round(width / 1.7))):
        builder.box(spec.pane("pane_warm"), (float(x), -0.03, 1.45), (1.45, 0.04, 2.3))
        builder.box(metal, (float(x), -0.06, 1.05), (1.5, 0.05, 0.06))
    for x in np.linspace(-width / 2 + 0.1, width / 2 - 0.1, max(4, round(width / 1.7) + 1)):
        builder.box(metal, (float(x), -0.05, 1.45), (0.1, 0.08, 2.7))
    builder.box(finish("paint_black"), (0.0, -0.07, 1.05), (1.0, 0.03, 2.1))
    builder.box(spec.pane("pane_pale"), (0.0, -0.09, 1.2), (0.8, 0.02, 1.6))
    for x, skin in ((-width * 0.38, "paint_white"), (-width * 0.38 + 0.9, "paint_red")):
        builder.box(finish(skin), (x, -0.45, 0.9), (0.8, 0.6, 1.8), bevel=0.03)
        builder.box(spec.pane("pane_pale"), (x, -0.76, 1.1), (0.6, 0.02, 1.1))
