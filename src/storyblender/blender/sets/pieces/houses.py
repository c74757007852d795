"""Set piece builders: the front of a wooden house with its porch: clapboards, door, windows, gable, posts."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece

_BOARD = 0.16
"""Metres that a clapboard shows."""


@piece("house_front")
def house_front(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the front of a house at y = 0 facing -Y: a ground floor and a gable. Parameters: width, color, door (x)."""
    width, paint, trim = spec.number("width", 10.0), spec.paint("color", "#b9bdb2"), finish("paint_white")
    high, peak, door = 3.1, 6.4, spec.number("door", 0.0)
    builder.box(paint, (0, 0.1, high / 2), (width, 0.2, high))
    gable = [(-width / 2, high), (width / 2, high), (0, peak)]
    builder.polygon(paint, [(x, 0.0, z) for x, z in gable])
    for z in np.arange(_BOARD, peak - 0.3, _BOARD):
        half = width / 2 if z < high else width / 2 * (peak - z) / (peak - high)
        builder.box(paint, (0, -0.012, float(z)), (2 * half, 0.03, 0.018))
    for side in (-1, 1):
        builder.box(trim, (side * (width / 2 - 0.06), -0.03, high / 2), (0.14, 0.08, high))
        slope = float(np.degrees(np.arctan2(peak - high, width / 2)))
        long = float(np.hypot(width / 2, peak - high)) + 0.7
        at = (side * (width / 4 + 0.12), -0.2, (high + peak) / 2 + 0.02)
        builder.box(finish("roof_slate"), at, (long, 0.9, 0.12), rotation=(0, side * slope, 0))
    _door(builder, spec, door, trim)
    for x in (-width * 0.3, width * 0.3):
        _window(builder, spec, x, 0.85, 1.1, 1.5, trim)
    _window(builder, spec, 0.0, high + 0.75, 0.9, 1.3, trim)


def _door(builder: MeshBuilder, spec: PieceSpec, x: float, trim: MaterialRef) -> None:
    """Add the front door with its casing at ``x``."""
    wood, panel = spec.paint("door_color", "#5b2a22"), finish("wood_dark")
    builder.box(trim, (x, -0.03, 1.12), (1.24, 0.1, 2.24))
    builder.box(wood, (x, -0.085, 1.03), (0.95, 0.03, 2.06))
    for z, tall in ((0.42, 0.5), (1.06, 0.5)):
        for off in (-0.2, 0.2):
            builder.box(panel, (x + off, -0.102, z), (0.3, 0.012, tall), bevel=0.005)
    builder.box(spec.pane("pane_warm"), (x, -0.103, 1.68), (0.66, 0.01, 0.5))
    builder.box(wood, (x, -0.108, 1.68), (0.03, 0.012, 0.5))
    builder.sphere(finish("brass"), (x + 0.38, -0.13, 1.02), 0.035, segments=10, rings=6)
    builder.box(finish("rust"), (x, -0.5, 0.012), (0.9, 0.5, 0.02))


def _window(
    builder: MeshBuilder, spec: PieceSpec, x: float, sill: float, wide: float, tall: float, trim: MaterialRef
) -> None:
    """Add a window with its casing, its middle at ``x``."""
    builder.box(trim, (x, -0.03, sill + tall / 2), (wide + 0.2, 0.08, tall + 0.2))
    builder.box(spec.pane("pane_warm"), (x, -0.075, sill + tall / 2), (wide, 0.01, tall))
    builder.box(trim, (x, -0.085, sill + tall / 2), (0.04, 0.02, tall))
    builder.box(trim, (x, -0.085, sill + tall / 2), (wide, 0.02, 0.05))
    builder.box(trim, (x, -0.1, sill - 0.1), (wide + 0.3, 0.16, 0.05))
    for side in (-1, 1):
        builder.box(finish("paint_green"), (x + side * (wide / 2 + 0.3), -0.04, sill + tall / 2), (0.36, 0.05, tall))


@piece("porch_roof")
def porch_roof(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a porch's roof that falls towards -Y, posts, and rails but for the steps. Parameters: width, depth, steps
    (x of their middle)."""
    width, depth, steps = spec.number("width", 9.0), spec.number("depth", 3.0), spec.number("steps", 0.0)
    white, front, way = finish("paint_white"), -spec.number("depth", 3.0), 0.75
    builder.box(finish("roof_slate"), (0, front / 2 - 0.1, 2.92), (width + 0.5, depth + 0.5, 0.1), rotation=(7, 0, 0))
    builder.box(white, (0, front / 2, 2.68), (width, depth, 0.04))
    builder.box(white, (0, front, 2.62), (width, 0.16, 0.2))
    count = max(3, round(width / 2.2))
    posts = [width * (index / count - 0.5) for index in range(count + 1)]
    posts = [x for x in posts if abs(x - steps) > way + 0.3] + [steps - way, steps + way]
    for x in posts:
        builder.box(white, (x, front, 1.28), (0.13, 0.13, 2.56), bevel=0.012)
        builder.box(white, (x, front, 2.5), (0.22, 0.2, 0.06), bevel=0.01)
    for left, right in ((-width / 2, steps - way), (steps + way, width / 2)):
        if right - left > 0.3:
            _rail(builder, white, (left + right) / 2, front, right - left)
    for side in (-1, 1):
        with builder.at((side * width / 2, front / 2, 0), (0, 0, 90)):
            _rail(builder, white, 0.0, 0.0, depth)
    for index in range(3):
        z = -0.15 * (index + 1)
        builder.box(finish("boards_grey"), (steps, front - 0.2 - 0.3 * index, z - 0.03), (2 * way - 0.1, 0.34, 0.06))
        builder.box(white, (steps, front - 0.08 - 0.3 * index, z + 0.03), (2 * way - 0.1, 0.03, 0.14))
    builder.box(white, (0, front - 0.02, -0.2), (width, 0.05, 0.36))


def _rail(builder: MeshBuilder, paint: MaterialRef, x: float, y: float, length: float) -> None:
    """Add a porch rail with balusters along X, its middle at ``x``."""
    for z, tall in ((0.86, 0.06), (0.16, 0.05)):
        builder.box(paint, (x, y, z), (length, 0.08, tall))
    for at in np.arange(x - length / 2 + 0.1, x + length / 2, 0.16):
        builder.box(paint, (float(at), y, 0.5), (0.035, 0.035, 0.7))
