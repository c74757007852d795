"""Set piece builders: parts of stations: ticket windows, timetables, signs, posters, rails, trains, tunnels."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.printed_sheet import DESIGNS, Inks, print_sheet
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece

_CARRIAGE = 17.0
"""Metres from coupling to coupling."""


@piece("ticket_window")
def ticket_window(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a panelled ticket window with a lit hatch on a wall at y = 0, facing -Y."""
    wood, panel, brass = finish("wood"), finish("wood_dark"), finish("brass")
    width, hatch = 2.0, 1.1
    builder.box(wood, (0, -0.05, 0.5), (width, 0.1, 1.0))
    for x in (-0.62, 0.0, 0.62):
        builder.box(panel, (x, -0.105, 0.52), (0.5, 0.02, 0.7), bevel=0.006)
    builder.box(wood, (0, -0.16, 1.04), (width + 0.1, 0.44, 0.07), bevel=0.012)
    for x in (-1, 1):
        builder.box(wood, (x * (width + hatch) / 4, -0.05, 1.64), ((width - hatch) / 2, 0.1, 1.16))
    builder.box(spec.pane("pane_warm"), (0, -0.02, 1.55), (hatch, 0.02, 0.98))
    for x in np.linspace(-hatch / 2, hatch / 2, 10):
        builder.cylinder(brass, (float(x), -0.07, 1.24), (float(x), -0.07, 2.04), 0.009, segments=6)
    builder.box(brass, (0, -0.07, 1.24), (hatch, 0.03, 0.03))
    builder.box(wood, (0, -0.07, 2.14), (width + 0.1, 0.14, 0.2), bevel=0.01)
    builder.box(finish("paint_green"), (0, -0.1, 2.4), (1.5, 0.1, 0.3), bevel=0.02)
    _letters(builder, finish("paint_cream"), (-0.52, -0.155, 2.4), (0.13, 0.15, 0.04), 7, spec.rng)


def _letters(
    builder: MeshBuilder,
    ink: MaterialRef,
    start: tuple[float, float, float],
    size: tuple[float, float, float],
    count: int,
    rng: np.random.Generator,
) -> None:
    """Add a word of ``count`` block letters, readable as lettering and as no word; size is width, height and gap."""
    wide, tall, gap = size
    x, y, z = start
    for _ in range(count):
        stroke = wide * 0.24
        left, middle, low, high = rng.random(4) < (0.75, 0.6, 0.5, 0.6)
        builder.box(ink, (x + (0 if left else wide - stroke), y, z), (stroke, 0.01, tall))
        for there, level in ((middle, 0.0), (low, -0.5), (high, 0.5)):
            if there:
                builder.box(ink, (x + (wide - stroke) / 2, y, z + level * (tall - stroke)), (wide, 0.01, stroke))
        x += wide + gap


@piece("timetable")
def timetable(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a board of departures on a wall at y = 0, its lower edge at z = 0. Parameters: width, height, modern."""
    width, height = spec.number("width", 1.7), spec.number("height", 1.25)
    modern = spec.flag("modern")
    frame, ink = finish("metal_grey" if modern else "wood_dark"), finish("lamp_warm" if modern else "paint_cream")
    builder.box(frame, (0, -0.03, height / 2), (width, 0.06, height), bevel=0.01)
    builder.box(finish("paint_black"), (0, -0.062, height / 2), (width - 0.12, 0.01, height - 0.12))
    columns = ((-0.44, 0.1), (-0.3, 0.42), (0.2, 0.08), (0.34, 0.09))
    rows = max(4, int(height / 0.12))
    for row in range(rows):
        z = height - 0.14 - row * (height - 0.22) / rows
        tall = 0.07 if row == 0 else 0.04
        for at, share in columns:
            wide = share * width * (1.0 if row == 0 else float(spec.rng.uniform(0.55, 1.0)))
            builder.box(ink, (at * width + wide / 2, -0.07, z), (wide, 0.006, tall))


@piece("station_sign")
def station_sign(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a station's name on a wall at y = 0. Parameters: width, color."""
    width = spec.number("width", 2.6)
    builder.box(finish("paint_white"), (0, -0.02, 0), (width, 0.04, 0.56), bevel=0.01)
    builder.box(spec.paint("color", "#23446b"), (0, -0.045, 0), (width - 0.1, 0.02, 0.4))
    count = max(4, int(width / 0.3))
    step = (width - 0.5) / count
    start = (-width / 2 + 0.28, -0.06, 0.0)
    _letters(builder, finish("paint_white"), start, (step * 0.72, 0.22, step * 0.28), count, spec.rng)


@piece("poster")
def poster(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a printed poster on a wall at y = 0, its lower edge at z = 0. Parameters: width, height, variant."""
    width, height = spec.number("width", 1.0), spec.number("height", 1.4)
    kind = int(spec.number("variant", 0)) % DESIGNS
    ground, shape, accent = (
        ("paint_blue", "paint_cream", "paint_red"),
        ("paint_yellow", "paint_blue", "paint_red"),
        ("paint_red", "paint_cream", "paint_black"),
        ("paint_green", "paint_black", "paint_yellow"),
    )[kind]
    builder.box(finish("metal_grey"), (0, -0.012, height / 2), (width + 0.08, 0.024, height + 0.08))
    builder.box(finish("paint_cream"), (0, -0.026, height / 2), (width, 0.008, height))
    print_sheet(builder, Inks(finish(ground), finish(shape), finish(accent)), width, height, -0.03, kind)


@piece("vending_machine")
def vending_machine(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a lit drinks machine, its back at y = 0, facing -Y. Parameters: color."""
    body, width, depth, height = spec.paint("color", "#9b2320"), 0.95, 0.78, 1.85
    builder.box(body, (0, -depth / 2, height / 2), (width, depth, height), bevel=0.03)
    builder.box(finish("paint_black"), (-0.12, -depth - 0.004, 1.12), (0.62, 0.02, 1.2))
    builder.box(finish("lamp_cool"), (-0.12, -depth - 0.01, 1.68), (0.58, 0.02, 0.05))
    colors = ("paint_red", "paint_blue", "paint_yellow", "paint_green", "paint_white")
    for row in range(5):
        z = 0.6 + 0.21 * row
        builder.box(finish("metal_grey"), (-0.12, -depth - 0.012, z - 0.005), (0.6, 0.02, 0.012))
        for column in range(5):
            key = colors[int(spec.rng.integers(len(colors)))]
            x = -0.36 + 0.12 * column
            builder.cylinder(finish(key), (x, -depth - 0.015, z), (x, -depth - 0.015, z + 0.12), 0.032, segments=8)
    builder.box(finish("metal_grey"), (0.33, -depth - 0.006, 1.2), (0.18, 0.02, 0.5))
    builder.box(finish("lamp_warm"), (0.33, -depth - 0.018, 1.38), (0.1, 0.01, 0.05))
    builder.box(finish("paint_black"), (-0.12, -depth - 0.006, 0.34), (0.56, 0.02, 0.2))


@piece("rails")
def rails(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lay a track along x on z = 0. Parameters: length."""
    length = spec.number("length", 60)
    for x in np.arange(-length / 2, length / 2, 0.75):
        builder.box(finish("boards_dark"), (float(x), 0, 0.03), (0.26, 2.5, 0.1))
    for y in (-0.72, 0.72):
        builder.box(finish("iron"), (0, y, 0.15), (length, 0.07, 0.14))


@piece("train")
def train(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Stand carriages along x, z = 0 the platform, doors at -Y. Parameters: carriages, modern, color."""
    count, modern = max(1, int(spec.number("carriages", 3))), spec.flag("modern")
    body = spec.paint("color", "#b4b8ba" if modern else "#3c4a35")
    for index in range(count):
        with builder.at(((index - (count - 1) / 2) * _CARRIAGE, 0, 0)):
            _carriage(builder, spec, body, modern)


def _carriage(builder: MeshBuilder, spec: PieceSpec, body: MaterialRef, modern: bool) -> None:
    """Add one carriage of a train."""
    length, half = _CARRIAGE - 0.7, 1.4
    trim = finish("paint_blue" if modern else "paint_cream")
    turn = np.linspace(0, math.pi, 11)
    outline = [(-half, 0.05), (half, 0.05), *((half * math.cos(t), 2.45 + 0.55 * math.sin(t)) for t in turn)]
    ends = [[(x, y, z) for y, z in outline] for x in (-length / 2, length / 2)]
    builder.loft(body, [np.array(end) for end in ends])
    builder.box(finish("iron"), (0, 0, -0.35), (length - 1.2, 2.3, 0.75))
    for x in (-length / 2 + 2.6, length / 2 - 2.6):
        for dx in (-0.9, 0.9):
            builder.cylinder(finish("iron"), (x + dx, -0.95, -0.62), (x + dx, 0.95, -0.62), 0.42, segments=18)
    face = -half - 0.012
    builder.box(trim, (0, -half, 2.28 if modern else 1.02), (length, 0.02, 0.14))
    doors = (-length / 2 + 1.1, 0.0, length / 2 - 1.1) if modern else (-length / 2 + 0.8, length / 2 - 0.8)
    for x in doors:
        builder.box(trim if modern else finish("wood_dark"), (x, face, 1.12), (1.2 if modern else 0.8, 0.03, 2.1))
        builder.box(spec.pane("pane_far"), (x, face - 0.02, 1.6), (0.5, 0.01, 0.8))
    for x in np.arange(-length / 2 + 2.1, length / 2 - 1.6, 1.55):
        if all(abs(x - door) > 1.25 for door in doors):
            builder.box(trim, (float(x), face, 1.65), (1.22, 0.02, 0.92))
            with builder.at((float(x), face - 0.012, 1.65)):
                _compartment(builder, spec)


def _compartment(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Add the window of a compartment round the origin, -Y outside: what stands before the light gives it depth."""
    width, height = 1.1, 0.8
    builder.box(spec.pane("pane_far"), (0, 0, 0), (width, 0.01, height))
    builder.box(finish("wood_dark"), (0, -0.008, 0.2), (width, 0.006, 0.03))
    builder.box(finish("brass"), (0, -0.008, 0.3), (width, 0.006, 0.012))
    for side in (-1, 1):
        for fold in range(3):
            wide = 0.075 - 0.012 * fold
            x = side * (width / 2 - 0.035 - 0.062 * fold)
            builder.box(finish("cloth_red"), (x, -0.010 - 0.002 * fold, 0), (wide, 0.006, height - 0.06 * fold))
        builder.box(finish("cloth_green"), (side * 0.19, -0.008, -0.28), (0.3, 0.006, 0.24))


@piece("tunnel")
def tunnel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the inside of a dark tunnel that runs along +X from its mouth at x = 0. Parameters: width, height."""
    half, height, length = spec.number("width", 3.4) / 2, spec.number("height", 3.6), 16.0
    skin, floor = finish("plaster_dark"), finish("gravel")
    near = [(0, -half, 0), (0, half, 0), (0, half, height), (0, -half, height)]
    far = [(length, y, z) for _, y, z in near]
    builder.quad(floor, near[0], far[0], far[1], near[1])
    builder.quad(skin, near[1], far[1], far[2], near[2])
    builder.quad(skin, near[2], far[2], far[3], near[3])
    builder.quad(skin, near[3], far[3], far[0], near[0])
    builder.quad(finish("paint_black"), *far)


@piece("canopy")
def canopy(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a platform's roof along x with its valance; its posts are columns. Parameters: length, depth, height."""
    length, depth, height = spec.number("length", 30), spec.number("depth", 4.4), spec.number("height", 3.6)
    for side in (-1, 1):
        tilt = side * 7.0
        middle = (0, side * depth / 4, height + 0.18 + 0.03 * depth)
        builder.box(finish("paint_cream"), middle, (length, depth / 2 + 0.05, 0.09), rotation=(tilt, 0, 0))
        builder.box(finish("paint_green"), (0, side * depth / 2, height + 0.26), (length, 0.05, 0.34))
    for x in np.arange(-length / 2 + 0.5, length / 2, 2.0):
        builder.box(finish("iron"), (float(x), 0, height + 0.1), (0.1, depth, 0.14))
