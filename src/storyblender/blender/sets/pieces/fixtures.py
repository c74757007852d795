"""Set piece builders: what is built into halls and technical rooms: stairs, screens, hoops, wall bars."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("stairs")
def stairs(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a flight about the origin that rises along +X. Parameters: height, width, run, material, iron, hatch."""
    with builder.at((-spec.number("run", 4.2) / 2, 0, 0)):
        _flight(builder, spec)


def _flight(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Add a flight of stairs with its rail."""
    height, width, run = spec.number("height", 2.6), spec.number("width", 0.95), spec.number("run", 4.2)
    tread, rail = spec.finish("material", "boards_dark"), finish("iron" if spec.flag("iron") else "wood_dark")
    count = max(2, round(height / 0.18))
    rise, step = height / count, run / count
    for index in range(count):
        x, z = (index + 0.5) * step, (index + 1) * rise
        builder.box(tread, (x, 0, z - 0.025), (step + 0.03, width, 0.05))
        if not spec.flag("iron"):  # iron treads are open to the light behind them
            builder.box(tread, (x + step / 2, 0, z - rise / 2), (0.02, width, rise))
    slope = math.degrees(math.atan2(height, run))
    length = math.hypot(height, run)
    for side in (-1, 1):
        y = side * width / 2
        builder.box(rail, (run / 2, y, height / 2 - 0.06), (length, 0.05, 0.26), rotation=(0, -slope, 0))
        builder.tube(rail, [(0.05, y, 0.98), (run, y, height + 0.92)], 0.03, segments=8)
        for index in range(0, count + 1, 3):
            x, z = index * step, index * rise
            builder.cylinder(rail, (x + 0.05, y, z), (x + 0.05, y, z + 0.97), 0.02, segments=6)
    if spec.flag("hatch"):  # the floor above is open where the flight goes through it
        builder.box(finish("paint_black"), (run - 0.7, 0, height - 0.012), (1.6, width + 0.1, 0.02))
        for y in (-width / 2 - 0.08, width / 2 + 0.08):
            builder.box(rail, (run - 0.7, y, height - 0.05), (1.7, 0.1, 0.1))
        for x in (run - 1.55, run + 0.1):
            builder.box(rail, (x, 0, height - 0.05), (0.1, width + 0.26, 0.1))


@piece("landing")
def landing(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a landing about the origin on its wall below, open to -X. Parameters: width, depth, height, material."""
    width, depth, height = spec.number("width", 1.2), spec.number("depth", 1.2), spec.number("height", 1.6)
    tread = spec.finish("material", "boards_dark")
    builder.box(tread, (0, 0, height - 0.06), (width, depth, 0.12))
    builder.box(finish("plaster_grey"), (0, -depth / 2 + 0.05, height / 2), (width, 0.1, height))
    builder.box(finish("plaster_grey"), (-width / 2 + 0.05, 0, height / 2), (0.1, depth, height - 0.2))


@piece("viewscreen")
def viewscreen(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the frame of a great screen on a wall at y = 0, its lower edge at z = 0. Parameters: width, height."""
    width, height = spec.number("width", 5.0), spec.number("height", 1.9)
    frame, trim = finish("metal_grey"), finish("paint_black")
    for z in (-0.09, height + 0.09):
        builder.box(frame, (0, -0.09, z), (width + 0.4, 0.18, 0.2), bevel=0.03)
    for x in (-width / 2 - 0.1, width / 2 + 0.1):
        builder.box(frame, (x, -0.09, height / 2), (0.2, 0.18, height + 0.36), bevel=0.03)
    for x in (-width / 6, width / 6):
        builder.box(trim, (x, -0.06, height / 2), (0.05, 0.08, height))
    for x in np.arange(-width / 2 + 0.2, width / 2, 0.5):
        builder.box(finish("lamp_cool"), (float(x), -0.19, -0.1), (0.18, 0.01, 0.03))


@piece("ship_rib")
def ship_rib(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a rib across the corridor of a ship in space, lit along its edges. Parameters: width, height."""
    half, height, shell = spec.number("width", 2.8) / 2, spec.number("height", 2.6), finish("paint_white")
    for side in (-1, 1):
        builder.box(shell, (side * (half - 0.08), 0, height / 2), (0.16, 0.42, height), bevel=0.03)
        builder.box(shell, (side * (half - 0.3), 0, height - 0.3), (0.16, 0.4, 0.75), rotation=(0, -45 * side, 0))
        builder.box(finish("lamp_cool"), (side * (half - 0.165), -0.12, height * 0.45), (0.012, 0.05, height * 0.6))
        builder.box(finish("paint_yellow"), (side * (half - 0.165), 0.1, 0.3), (0.012, 0.12, 0.4))
    builder.box(shell, (0, 0, height - 0.08), (2 * half, 0.42, 0.16), bevel=0.03)


@piece("screen_wall")
def screen_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a rack of lit screens on a wall at y = 0 from z = 0 up. Parameters: width, height, columns, rows."""
    width, height = spec.number("width", 4.5), spec.number("height", 1.8)
    columns, rows = int(spec.number("columns", 4)), int(spec.number("rows", 2))
    builder.box(finish("metal_grey"), (0, -0.06, height / 2), (width, 0.12, height), bevel=0.02)
    wide, tall = width / columns, height / rows
    for column in range(columns):
        for row in range(rows):
            x, z = (column + 0.5) * wide - width / 2, (row + 0.5) * tall
            builder.box(finish("paint_black"), (x, -0.125, z), (wide - 0.08, 0.02, tall - 0.08))
            builder.box(finish("glass_dark"), (x, -0.137, z), (wide - 0.16, 0.01, tall - 0.16))
            for line in range(4):
                share = float(spec.rng.uniform(0.2, 0.85))
                key = ("lamp_cool", "lamp_warm", "paint_green")[int(spec.rng.integers(3))]
                left = x - (wide - 0.22) / 2
                at = z + (tall - 0.28) * (0.375 - 0.25 * line)
                builder.box(
                    finish(key), (left + share * (wide - 0.22) / 2, -0.145, at), (share * (wide - 0.22), 0.006, 0.025)
                )


@piece("basketball_hoop")
def basketball_hoop(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a backboard with its ring and net on a wall at y = 0, facing -Y; z = 0 is the floor."""
    board, ring, frame = finish("paint_white"), finish("paint_red"), finish("metal_grey")
    for x in (-0.5, 0.5):
        builder.cylinder(frame, (x, 0, 3.5), (x * 0.7, -0.75, 3.3), 0.03, segments=8)
        builder.cylinder(frame, (x, 0, 2.9), (x * 0.7, -0.75, 3.0), 0.03, segments=8)
    builder.box(board, (0, -0.78, 3.3), (1.8, 0.04, 1.05), bevel=0.01)
    for z in (2.95, 3.35):
        builder.box(ring, (0, -0.805, z), (0.6, 0.01, 0.05))
    for x in (-0.3, 0.3):
        builder.box(ring, (x, -0.805, 3.15), (0.05, 0.01, 0.45))
    around = np.linspace(0, 2 * math.pi, 20, endpoint=False)
    middle = np.array([0, -1.08, 3.05])
    loop = middle + np.c_[0.23 * np.cos(around), 0.23 * np.sin(around), np.zeros(20)]
    builder.tube(ring, loop, 0.014, segments=6, closed=True)
    for turn in around[::2]:
        top = middle + np.array([0.23 * math.cos(turn), 0.23 * math.sin(turn), 0])
        low = middle + np.array([0.13 * math.cos(turn + 0.6), 0.13 * math.sin(turn + 0.6), -0.4])
        other = middle + np.array([0.13 * math.cos(turn - 0.6), 0.13 * math.sin(turn - 0.6), -0.4])
        builder.cylinder(board, top, low, 0.004, segments=4)
        builder.cylinder(board, top, other, 0.004, segments=4)


@piece("wall_bars")
def wall_bars(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build climbing bars on a wall at y = 0. Parameters: width."""
    width, wood, height = spec.number("width", 2.6), finish("wood"), 2.5
    for x in np.linspace(-width / 2, width / 2, max(2, round(width / 0.9) + 1)):
        builder.box(wood, (float(x), -0.08, height / 2), (0.06, 0.16, height), bevel=0.008)
    for z in np.arange(0.16, height, 0.165):
        builder.cylinder(wood, (-width / 2, -0.12, float(z)), (width / 2, -0.12, float(z)), 0.02, segments=8)


@piece("peg_rail")
def peg_rail(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a board of coat pegs on a wall at y = 0, its lower edge at z = 0. Parameters: length."""
    length, wood = spec.number("length", 2.0), finish("wood")
    builder.box(wood, (0, -0.015, 0.07), (length, 0.03, 0.14), bevel=0.006)
    for x in np.arange(-length / 2 + 0.15, length / 2 - 0.1, 0.3):
        builder.cylinder(finish("chrome"), (float(x), -0.02, 0.08), (float(x), -0.11, 0.11), 0.011, segments=8)


@piece("column_post")
def column_post(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a square post from the floor up. Parameters: height."""
    height = spec.number("height", 2.4)
    builder.box(finish("wood_dark"), (0, 0, height / 2), (0.11, 0.11, height), bevel=0.008)


@piece("door_number")
def door_number(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a brass room number of three digits on a wall at y = 0. Parameters: seed."""
    builder.box(finish("brass"), (0, -0.012, 0), (0.2, 0.015, 0.11), bevel=0.004)
    for x in (-0.055, 0.0, 0.055):
        tall = float(spec.rng.uniform(0.05, 0.066))
        builder.box(finish("paint_black"), (x, -0.022, 0), (0.028, 0.006, tall))
