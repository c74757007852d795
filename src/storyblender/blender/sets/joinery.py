"""What fills a hole in a wall: casings, sills, sashes, bars, blinds, curtains, and door leaves on their hinges.

Frame of an opening: its lower left corner on the room face; +X along the wall, the room at +Y.
"""

from __future__ import annotations

import math
from itertools import pairwise

import bpy
import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.catalog.set_plan import Opening

CASING = 0.075
LEAF = 0.045

_SASHES = {"sash": (1, 1), "grid": (2, 3), "shop": (3, 1), "blinds": (1, 1), "curtains": (1, 1), "frosted": (0, 1)}
"""Mullions across and up, by window style."""


def dress_opening(
    builder: MeshBuilder, opening: Opening, thickness: float, *, trim: bpy.types.Material, wall: bpy.types.Material
) -> None:
    """Add the fixed joinery of an opening to its wall.

    Args:
        builder: The wall's builder, already at the opening's lower left corner.
        opening: The hole.
        thickness: Of the wall.
        trim: Material of casings and sashes.
        wall: Material of the wall, for the spandrels of arched heads.
    """
    width, height, kind, style = opening.width, opening.height, opening.kind, opening.style
    arched = kind == "arch" or style in ("arched", "stained")
    if arched:
        _spandrels(builder, wall, width, height, thickness)
    if kind == "gap" or style == "mouth":
        return
    if not arched and style not in ("bars", "rubber", "bus"):
        for x in (-CASING / 2, width + CASING / 2):
            builder.box(trim, (x, 0.02, height / 2), (CASING, 0.06, height + 0.001))
        builder.box(trim, (width / 2, 0.02, height + CASING / 2), (width + 2.4 * CASING, 0.07, CASING))
    if kind == "window":
        _window(builder, opening, thickness, trim)


def door_leaf(opening: Opening, width: float, *, clear: bool, mirrored: bool = False) -> bpy.types.Mesh:
    """Build a door leaf that hangs on its origin, runs along +X (or -X) and shuts flush with the room face.

    Args:
        opening: The door.
        width: Of this leaf.
        clear: Leave the glass out, where there is something to see outside.
        mirrored: Hang it on the other jamb.
    """
    builder = MeshBuilder(f"{opening.name}_leaf")
    with builder.at(scale=(-1.0 if mirrored else 1.0, 1.0, 1.0)):
        _leaf(builder, opening.style, width, opening.height, clear=clear)
    return builder.mesh()


def _leaf(builder: MeshBuilder, style: str, width: float, height: float, *, clear: bool) -> None:
    """Add a door leaf of a style, from its hinge at the origin along +X."""
    middle, y = width / 2, -0.06
    if style in ("cell", "paper", "bus"):
        {"cell": _barred_leaf, "paper": _paper_leaf, "bus": _folding_leaf}[style](builder, width, height)
        return
    if style == "lift":
        builder.box(finish("steel"), (middle, y, height / 2), (width - 0.01, LEAF, height))
        builder.box(finish("metal_grey"), (middle, y + 0.025, height / 2), (width - 0.16, 0.006, height - 0.2))
        return
    wood = finish({"plank": "wood", "double": "wood_dark", "glass": "wood"}.get(style, "wood"))
    panel = finish("wood_dark" if style != "double" else "wood")
    brass = finish("brass")
    if style == "glass":
        stile = 0.11
        for x in (stile / 2, width - stile / 2):
            builder.box(wood, (x, y, height / 2), (stile, LEAF, height))
        for z, tall in ((height - stile / 2, stile), (0.98, 0.12)):
            builder.box(wood, (middle, y, z), (width, LEAF, tall))
        builder.box(wood, (middle, y, 0.46), (width, LEAF, 0.92))
        if not clear:
            builder.box(finish("frosted"), (middle, y, (height + 0.98) / 2), (width - stile, 0.012, height - 1.1))
    elif style == "plank":
        count = max(3, round(width / 0.16))
        for index in range(count):
            x = width * (index + 0.5) / count
            builder.box(wood, (x, y, height / 2), (width / count - 0.008, LEAF, height), bevel=0.006)
        for z in (height * 0.2, height * 0.8):
            builder.box(panel, (middle, y + 0.04, z), (width - 0.04, 0.03, 0.12))
            builder.box(finish("iron"), (width * 0.3, y + 0.06, z), (width * 0.55, 0.012, 0.05))
    else:
        builder.box(wood, (middle, y, height / 2), (width, LEAF, height))
        for z, tall in ((height * 0.27, height * 0.36), (height * 0.72, height * 0.38)):
            for x in (width * 0.29, width * 0.71):
                builder.box(panel, (x, y + 0.025, z), (width * 0.3, 0.012, tall), bevel=0.005)
    for side in (0.05, -0.05):
        builder.sphere(brass, (width - 0.075, y + side + 0.01 * np.sign(side), 1.0), 0.03, segments=10, rings=6)
    builder.box(brass, (width - 0.075, y + 0.026, 1.0), (0.05, 0.008, 0.16))


def _barred_leaf(builder: MeshBuilder, width: float, height: float) -> None:
    """Add the barred door of a cell."""
    middle, y = width / 2, -0.06
    iron = finish("iron")
    for x in np.linspace(0.04, width - 0.04, max(3, round(width / 0.13))):
        builder.cylinder(iron, (x, y, 0.02), (x, y, height - 0.02), 0.014, segments=8)
    for z in (0.05, height * 0.5, height - 0.05):
        builder.box(iron, (middle, y, z), (width, 0.03, 0.05))
    builder.box(iron, (width - 0.12, y, height * 0.48), (0.16, 0.07, 0.2))


def _paper_leaf(builder: MeshBuilder, width: float, height: float) -> None:
    """Add a sliding paper screen."""
    with builder.at((0, -0.06, 0.0)):
        _lattice(builder, width, height)


def _folding_leaf(builder: MeshBuilder, width: float, height: float) -> None:
    """Add the two narrow panes of a bus door in their rubber."""
    rubber, y = finish("rubber"), -0.06
    for x in (0.03, width / 2 - 0.025, width / 2 + 0.025, width - 0.03):
        builder.box(rubber, (x, y, height / 2), (0.045, 0.04, height))
    for z in (0.04, height * 0.4, height - 0.04):
        builder.box(rubber, (width / 2, y, z), (width, 0.04, 0.07))
    builder.box(finish("metal_grey"), (width / 2, y, height * 0.2), (width - 0.08, 0.02, height * 0.36))
    builder.cylinder(finish("chrome"), (width * 0.6, y + 0.05, 0.8), (width * 0.6, y + 0.05, 1.5), 0.014, segments=8)


def _lattice(builder: MeshBuilder, width: float, height: float) -> None:
    """Add paper behind thin bars of wood, about the plane y = 0."""
    wood = finish("wood_dark")
    builder.box(finish("paper"), (width / 2, -0.012, height / 2), (width, 0.006, height))
    for x in np.linspace(0, width, max(3, round(width / 0.24)) + 1):
        builder.box(wood, (float(x), 0, height / 2), (0.02, 0.022, height))
    for z in np.linspace(0, height, max(4, round(height / 0.3)) + 1):
        builder.box(wood, (width / 2, 0, float(z)), (width, 0.022, 0.02))
    for x in (0.0, width / 2, width):
        builder.box(wood, (x, 0.006, height / 2), (0.05, 0.034, height))


def _window(builder: MeshBuilder, opening: Opening, thickness: float, trim: bpy.types.Material) -> None:
    """Add glass, sashes and what hangs before a window."""
    width, height, style, y = opening.width, opening.height, opening.style, -thickness * 0.55
    if style == "bars":
        for x in np.linspace(0, width, max(3, round(width / 0.14)) + 1)[1:-1]:
            builder.cylinder(finish("iron"), (x, y, 0), (x, y, height), 0.013, segments=8)
        return
    if style == "rubber":
        _gasket(builder, width, height)
        return
    if style == "paper":
        with builder.at((0, y, 0)):
            _lattice(builder, width, height)
        return
    builder.box(trim, (width / 2, 0.035, -0.025), (width + 3.2 * CASING, 0.16, 0.05))
    if style in ("arched", "stained"):
        _leading(builder, width, height, y, stained=style == "stained")
        return
    across, up = _SASHES.get(style, (1, 1))
    for x in (0.02, width - 0.02):
        builder.box(trim, (x, y, height / 2), (0.045, 0.05, height))
    for z in (0.025, height - 0.025):
        builder.box(trim, (width / 2, y, z), (width, 0.05, 0.05))
    for index in range(1, across + 1):
        builder.box(trim, (width * index / (across + 1), y, height / 2), (0.032, 0.04, height))
    for index in range(1, up + 1):
        z = height * (0.76 if style == "shop" else index / (up + 1))
        builder.box(trim, (width / 2, y, z), (width, 0.04, 0.032))
    if style == "frosted":
        builder.box(finish("frosted"), (width / 2, y - 0.01, height / 2), (width, 0.008, height))
    elif style == "blinds":
        _blinds(builder, width, height)
    elif style == "curtains":
        _curtains(builder, width, height, opening.sill)


def _gasket(builder: MeshBuilder, width: float, height: float) -> None:
    """Add the black frame about the one pane of a vehicle's window."""
    for x in (0.0, width):
        builder.box(finish("rubber"), (x, 0.004, height / 2), (0.05, 0.03, height + 0.05), bevel=0.01)
    for z in (0.0, height):
        builder.box(finish("rubber"), (width / 2, 0.004, z), (width + 0.05, 0.03, 0.05), bevel=0.01)


def _blinds(builder: MeshBuilder, width: float, height: float) -> None:
    """Add half-open slats before a window."""
    slat = finish("paint_cream")
    builder.box(slat, (width / 2, 0.07, height + 0.02), (width + 0.06, 0.06, 0.06))
    for index in range(int(height * 0.62 / 0.065)):
        z = height - 0.05 - 0.065 * index
        builder.box(slat, (width / 2, 0.07, z), (width, 0.055, 0.004), rotation=(-35, 0, 0))
    for x in (width * 0.2, width * 0.8):
        builder.cylinder(slat, (x, 0.07, height), (x, 0.07, height * 0.38), 0.004, segments=5)


def _curtains(builder: MeshBuilder, width: float, height: float, sill: float) -> None:
    """Add a rod and two drawn-back curtains that reach below the sill."""
    cloth, rod = finish("cloth_cream"), finish("brass")
    top = height + 0.16
    builder.cylinder(rod, (-0.35, 0.11, top), (width + 0.35, 0.11, top), 0.014, segments=8)
    for x in (-0.35, width + 0.35):
        builder.sphere(rod, (x, 0.11, top), 0.03, segments=10, rings=6)
    foot = max(-sill + 0.04, -0.35)
    for start, end in ((-0.32, width * 0.16), (width * 0.84, width + 0.32)):
        folded_cloth(builder, cloth, start, end, 0.11, foot, top - 0.01, depth=0.04)


def folded_cloth(
    builder: MeshBuilder,
    cloth: bpy.types.Material,
    start: float,
    end: float,
    y: float,
    bottom: float,
    top: float,
    *,
    depth: float,
) -> None:
    """Hang a cloth in even folds along X.

    Args:
        builder: Receives the cloth.
        cloth: Material.
        start: X of one end, metres.
        end: X of the other.
        y: Middle of the folds.
        bottom: Z of the hem.
        top: Z of the upper edge.
        depth: Of the folds along Y.
    """
    count = max(9, round((end - start) / 0.05)) | 1
    xs = np.linspace(start, end, count)
    rings = []
    for z, swing in ((top, 0.55), ((top + bottom) / 2, 0.9), (bottom, 1.1)):
        ys = y + depth * swing * np.cos(np.arange(count) * math.pi * 0.5)
        rings.append(np.c_[xs, ys, np.full(count, z)])
    builder.loft(cloth, rings, closed=False)
    builder.loft(cloth, [ring - (0, 0.006, 0) for ring in rings[::-1]], closed=False)


def _arch(width: float, height: float, segments: int = 12) -> list[tuple[float, float]]:
    """Return (x, z) points of a half ellipse from the left foot of an arch to the right."""
    radius = width / 2
    spring = max(height - radius, height * 0.3)
    rise = height - spring
    return [
        (radius - radius * math.cos(math.pi * k / segments), spring + rise * math.sin(math.pi * k / segments))
        for k in range(segments + 1)
    ]


def _spandrels(builder: MeshBuilder, skin: bpy.types.Material, width: float, height: float, thickness: float) -> None:
    """Fill the corners between an arch and the rectangular hole it stands in."""
    curve = _arch(width, height)
    for (x0, z0), (x1, z1) in pairwise(curve):
        builder.quad(skin, (x1, 0, z1), (x0, 0, z0), (x0, 0, height), (x1, 0, height))
        builder.quad(
            skin, (x0, -thickness, z0), (x1, -thickness, z1), (x1, -thickness, height), (x0, -thickness, height)
        )
        builder.quad(skin, (x0, 0, z0), (x1, 0, z1), (x1, -thickness, z1), (x0, -thickness, z0))


def _leading(builder: MeshBuilder, width: float, height: float, y: float, *, stained: bool) -> None:
    """Add the lead bars of a church window, with coloured panes if ``stained``."""
    iron = finish("iron")
    builder.cylinder(iron, (width / 2, y, 0), (width / 2, y, height - 0.02), 0.016, segments=6)
    for index in range(1, max(2, int(height / 0.5))):
        z = height * index / max(2, int(height / 0.5))
        builder.cylinder(iron, (0.02, y, z), (width - 0.02, y, z), 0.011, segments=6)
    if stained:
        colors = ("paint_red", "paint_blue", "paint_yellow", "paint_green")
        rows = max(3, int(height / 0.45))
        for row in range(rows):
            for column in range(2):
                z0, z1 = height * row / rows, height * (row + 1) / rows
                x0, x1 = width * column / 2, width * (column + 1) / 2
                pick = finish(colors[(row * 2 + column * 3 + row // 2) % len(colors)])
                builder.quad(pick, (x1, y - 0.02, z0), (x0, y - 0.02, z0), (x0, y - 0.02, z1), (x1, y - 0.02, z1))
