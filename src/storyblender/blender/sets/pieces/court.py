"""Set piece builders: parts of a courtroom: the judge's bench, panelled boxes for jury, witness and dock."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


def _panelled(builder: MeshBuilder, width: float, height: float) -> None:
    """Add a panelled front along x at y = 0 that faces -Y, with plinth and cornice."""
    wood, dark = finish("wood"), finish("wood_dark")
    builder.box(wood, (0, 0, height / 2), (width, 0.08, height))
    count = max(1, round(width / 0.7))
    for index in range(count):
        x = width * ((index + 0.5) / count - 0.5)
        builder.box(dark, (x, -0.045, height * 0.52), (width / count - 0.16, 0.02, height * 0.62), bevel=0.008)
        builder.box(wood, (x, -0.058, height * 0.52), (width / count - 0.28, 0.012, height * 0.5), bevel=0.005)
    builder.box(dark, (0, -0.02, 0.08), (width + 0.04, 0.14, 0.16), bevel=0.012)
    builder.box(dark, (0, -0.02, height), (width + 0.08, 0.2, 0.07), bevel=0.014)


@piece("judges_bench")
def judges_bench(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the bench a judge sits behind, with wings, facing -Y. Parameters: width."""
    width, high = spec.number("width", 3.2), 1.12
    with builder.at((0, -0.3, 0)):
        _panelled(builder, width * 0.5, high + 0.14)
    for side in (-1, 1):
        with builder.at((side * width * 0.375, -0.24, 0)):
            _panelled(builder, width * 0.25, high)
        with builder.at((side * width / 2, 0.06, 0), (0, 0, 90 * side)):
            _panelled(builder, 0.6, high)
    builder.box(finish("wood_dark"), (0, -0.02, high - 0.14), (width - 0.1, 0.56, 0.05))
    builder.box(finish("brass"), (0, -0.37, high - 0.36), (0.44, 0.02, 0.12), bevel=0.006)
    builder.cylinder(finish("wood_red"), (0.42, -0.05, high - 0.1), (0.42, -0.05, high - 0.06), 0.07, segments=16)


@piece("court_box")
def court_box(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a box that is open behind, facing -Y: for jury, witness or accused. Parameters: width, depth, rail."""
    width, depth, high = spec.number("width", 1.2), spec.number("depth", 1.1), 0.92
    with builder.at((0, -depth / 2, 0)):
        _panelled(builder, width, high)
    for side in (-1, 1):
        with builder.at((side * width / 2, 0, 0), (0, 0, 90 * side)):
            _panelled(builder, depth, high)
    if spec.flag("rail"):  # the dock is fenced to the chest
        brass = finish("brass")
        front = [(-width / 2, depth / 2), (-width / 2, -depth / 2), (width / 2, -depth / 2), (width / 2, depth / 2)]
        builder.tube(brass, [(x, y, high + 0.2) for x, y in front], 0.018, segments=8)
        for x in np.linspace(-width / 2, width / 2, 6):
            builder.cylinder(brass, (float(x), -depth / 2, high), (float(x), -depth / 2, high + 0.2), 0.01, segments=6)


@piece("court_rail")
def court_rail(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a balustrade along x. Parameters: length."""
    length, wood = spec.number("length", 3.0), finish("wood")
    builder.box(finish("wood_dark"), (0, 0, 0.88), (length, 0.14, 0.06), bevel=0.012)
    builder.box(wood, (0, 0, 0.1), (length, 0.1, 0.1))
    for x in np.linspace(-length / 2 + 0.08, length / 2 - 0.08, max(2, round(length / 0.2))):
        profile = [(0.022, 0.14), (0.04, 0.3), (0.024, 0.5), (0.036, 0.7), (0.022, 0.86)]
        builder.lathe(wood, profile, origin=(float(x), 0, 0), segments=10)
    for x in (-length / 2, length / 2):
        builder.box(wood, (x, 0, 0.48), (0.12, 0.12, 0.96), bevel=0.012)


@piece("court_seal")
def court_seal(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a seal with scales on a wall at y = 0, its middle at z = 0."""
    gold, dark = finish("gold"), finish("paint_blue")
    for radius, skin, out in ((0.52, gold, 0.05), (0.47, dark, 0.058), (0.3, gold, 0.066), (0.28, dark, 0.072)):
        builder.lathe(skin, [(radius, 0), (radius, out)], axis=(0, -1, 0), segments=36)
    builder.box(gold, (0, -0.08, 0), (0.025, 0.02, 0.34))
    builder.box(gold, (0, -0.08, 0.14), (0.34, 0.02, 0.025))
    for side in (-1, 1):
        builder.lathe(gold, [(0.075, 0.0), (0.02, -0.05)], origin=(side * 0.15, -0.08, 0.02), segments=14)
        for lean in (-0.06, 0.06):
            builder.cylinder(gold, (side * 0.15, -0.08, 0.14), (side * 0.15 + lean, -0.08, 0.02), 0.006, segments=5)
