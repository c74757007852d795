"""Places for cars: marked bays, low stores behind car parks, petrol pumps and the roof over them."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("parking_bays")
def parking_bays(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Paint bays side by side along x. Parameters: length, depth of a bay, width of a bay."""
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
