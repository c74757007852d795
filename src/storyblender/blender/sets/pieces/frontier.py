"""Set piece builders: the wooden fronts of a frontier town, taller than the houses behind them."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece

_EAVE = 3.3
"""Metres up to the porch roof."""
_PORCH = 2.2
"""Metres that the porch is deep."""


@piece("false_front")
def false_front(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a wooden house at y = 0 facing -Y with a porch over the boardwalk. Parameters: width, height, material,
    doors (swinging ones, as a saloon has), seed."""
    width, height = spec.number("width", 8.0), spec.number("height", 5.4)
    wall, trim = (
        spec.finish("material", "planks_gray"),
        finish("paint_cream" if spec.rng.random() < 0.4 else "wood_dark"),
    )
    builder.box(wall, (0, 0.1, height / 2), (width - 0.12, 0.2, height))
    builder.box(wall, (0, 3.2, (_EAVE + 0.3) / 2), (width - 0.3, 6.0, _EAVE + 0.3))
    builder.box(trim, (0, -0.05, height), (width, 0.3, 0.16))
    for step in (0.22, 0.42):
        builder.box(trim, (0, -0.02, height + 0.6 * step), (width * (0.62 - step * 0.5), 0.2, 0.4 * step))
    builder.box(trim, (0, -0.06, height - 0.85), (width * 0.66, 0.06, 0.75))
    builder.box(finish("wood_dark"), (0, -0.085, height - 0.85), (width * 0.6, 0.04, 0.6))
    _openings(builder, trim, width, saloon=spec.flag("doors"))
    _porch(builder, trim, width)


def _openings(builder: MeshBuilder, trim: MaterialRef, width: float, *, saloon: bool) -> None:
    """Add the door in the middle and a window at either side."""
    builder.box(finish("plaster_soot"), (0, -0.02, 1.1), (1.2, 0.06, 2.2))
    for x in (-0.65, 0.65):
        builder.box(trim, (x, -0.05, 1.1), (0.1, 0.1, 2.2))
    builder.box(trim, (0, -0.05, 2.25), (1.4, 0.1, 0.12))
    if saloon:
        for x in (-1, 1):
            builder.box(finish("wood"), (x * 0.29, -0.08, 1.05), (0.54, 0.05, 1.0), bevel=0.01)
            for z in np.arange(0.7, 1.45, 0.12):
                builder.box(finish("wood_dark"), (x * 0.29, -0.11, float(z)), (0.42, 0.02, 0.03))
    else:
        builder.box(finish("wood"), (0, -0.06, 1.05), (1.15, 0.05, 2.1))
    for x in (-width * 0.31, width * 0.31):
        builder.box(finish("glass_dark"), (x, -0.03, 1.5), (1.1, 0.06, 1.3))
        for dx in (-0.58, 0.0, 0.58):
            builder.box(trim, (x + dx, -0.06, 1.5), (0.07, 0.08, 1.36))
        for z in (0.84, 1.5, 2.16):
            builder.box(trim, (x, -0.06, z), (1.22, 0.08, 0.07))


def _porch(builder: MeshBuilder, trim: MaterialRef, width: float) -> None:
    """Add the roof over the boardwalk on its posts."""
    builder.box(
        finish("shingles"), (0, -_PORCH / 2, _EAVE - 0.1), (width - 0.1, _PORCH + 0.3, 0.08), rotation=(8, 0, 0)
    )
    for x in np.linspace(-width / 2 + 0.2, width / 2 - 0.2, 4):
        builder.box(trim, (float(x), -_PORCH + 0.1, (_EAVE - 0.25) / 2), (0.13, 0.13, _EAVE - 0.25))
    builder.box(trim, (0, -_PORCH + 0.1, _EAVE - 0.35), (width - 0.2, 0.1, 0.16))


@piece("hitching_rail")
def hitching_rail(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a rail along x to tie horses to. Parameters: length."""
    length, wood = spec.number("length", 3.0), finish("wood_gray")
    builder.cylinder(wood, (-length / 2, 0, 1.05), (length / 2, 0, 1.05), 0.055, segments=10)
    for x in (-length / 2 + 0.15, 0.0, length / 2 - 0.15):
        builder.cylinder(wood, (x, 0, 0), (x, 0, 1.12), 0.06, segments=10)
