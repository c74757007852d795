"""Set piece builders: nightclub and stage: mirror balls, lit dance floors, DJ booths, lighting trusses, amplifiers."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece

_LIGHTS = ("#ff3b8a", "#3b8aff", "#8a3bff", "#2ad0b0", "#ffb02a")


@piece("mirror_ball")
def mirror_ball(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a mirror ball from z = 0. Parameters: length of its rod."""
    length = spec.number("length", 0.6)
    builder.cylinder(finish("iron"), (0, 0, 0), (0, 0, -length), 0.012, segments=6)
    for ring in range(8):
        low, high = (math.pi * (ring / 8 - 0.5), math.pi * ((ring + 1) / 8 - 0.5))
        for step in range(16):
            a, b = 2 * math.pi * step / 16, 2 * math.pi * (step + 1) / 16
            points = [
                (0.3 * math.cos(e) * math.cos(t), 0.3 * math.cos(e) * math.sin(t), -length - 0.3 + 0.3 * math.sin(e))
                for e, t in ((low, a), (low, b), (high, b), (high, a))
            ]
            builder.polygon(finish(("chrome", "pane_cool", "metal_grey")[(ring + step * 2) % 3]), points)


@piece("dance_floor")
def dance_floor(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lay a dance floor of lit squares, centred on the origin. Parameters: width, depth."""
    width, depth = spec.number("width", 4.2), spec.number("depth", 4.2)
    columns, rows = max(3, round(width / 0.7)), max(3, round(depth / 0.7))
    glow = [painted(code) for code in ("#5c1f6b", "#1f3f7a", "#7a1f4a", "#1f5a5f")]
    dark = finish("plastic_black")
    builder.box(finish("metal_grey"), (0, 0, 0.012), (width + 0.1, depth + 0.1, 0.024))
    for column in range(columns):
        for row in range(rows):
            x, y = ((column + 0.5) / columns - 0.5) * width, ((row + 0.5) / rows - 0.5) * depth
            skin = glow[(column * 2 + row * 3 + column * row) % 4] if (column + row) % 2 else dark
            builder.box(skin, (x, y, 0.026), (width / columns - 0.03, depth / rows - 0.03, 0.012))


@piece("dj_booth")
def dj_booth(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a DJ booth with two decks and a lit front, the audience side at -Y. Parameters: length."""
    length = spec.number("length", 2.4)
    builder.box(finish("plastic_black"), (0, 0, 0.55), (length, 0.7, 1.1), bevel=0.02)
    for index, x in enumerate(np.linspace(-length * 0.4, length * 0.4, 7)):
        tall = 0.25 + 0.5 * abs(math.sin(1.7 * index + 0.8))
        builder.box(painted(_LIGHTS[index % 5]), (float(x), -0.36, 0.12 + tall / 2), (0.14, 0.02, tall))
    for side in (-1, 1):
        x = side * length * 0.28
        builder.box(finish("metal_grey"), (x, 0, 1.13), (0.5, 0.42, 0.06), bevel=0.01)
        builder.cylinder(finish("plastic_black"), (x - 0.05, 0, 1.16), (x - 0.05, 0, 1.175), 0.17, segments=22)
        builder.cylinder(finish("paint_red"), (x - 0.05, 0, 1.176), (x - 0.05, 0, 1.18), 0.05, segments=12)
        builder.tube(finish("chrome"), [(x + 0.18, 0.14, 1.2), (x + 0.18, 0.0, 1.2), (x + 0.06, -0.08, 1.19)], 0.01)
    builder.box(finish("paint_black"), (0, 0, 1.14), (0.42, 0.4, 0.08), bevel=0.01)
    for x in np.linspace(-0.15, 0.15, 5):
        builder.box(finish("lamp_cool"), (float(x), -0.06, 1.185), (0.02, 0.1, 0.012))


@piece("speaker_stack")
def speaker_stack(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a tower of loudspeakers that faces -Y. Parameters: height."""
    height, black = spec.number("height", 1.8), finish("plastic_black")
    builder.box(black, (0, 0, height / 2), (0.72, 0.6, height), bevel=0.02)
    rows = max(1, round(height / 0.6))
    for row in range(rows):
        z, radius = (row + 0.5) * height / rows, min(0.27, 0.44 * height / rows)
        builder.box(finish("paint_grey"), (0, -0.302, z), (0.66, 0.01, height / rows - 0.06))
        builder.lathe(finish("rubber"), [(radius, 0), (radius * 0.85, 0.02), (radius * 0.3, -0.05), (0.01, -0.03)],
                      origin=(0, -0.31, z), axis=(0, -1, 0), segments=20)  # fmt: skip


@piece("light_truss")
def light_truss(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a lighting truss with coloured lamps along x, its top at z = 0. Parameters: length, plain (white lamps)."""
    length, metal = spec.number("length", 5.0), finish("metal_grey")
    for y in (-0.14, 0.14):
        for z in (-0.04, -0.3):
            builder.cylinder(metal, (-length / 2, y, z), (length / 2, y, z), 0.02, segments=6)
    for index, x in enumerate(np.arange(-length / 2, length / 2, 0.35)):
        up = index % 2 == 0
        for y in (-0.14, 0.14):
            start, end = (float(x), y, -0.04 if up else -0.3), (float(x) + 0.35, y, -0.3 if up else -0.04)
            builder.cylinder(metal, start, end, 0.01, segments=5)
    for index, x in enumerate(np.linspace(-length / 2 + 0.4, length / 2 - 0.4, max(3, round(length / 0.9)))):
        with builder.at((float(x), 0, -0.45), (28 if index % 2 else -12, 14 * (index % 3 - 1), 0)):
            builder.lathe(finish("paint_black"), [(0.08, 0.14), (0.13, 0.0), (0.14, -0.16)], caps=False, segments=14)
            glow = finish("lamp_cool") if spec.flag("plain") else painted(_LIGHTS[index % 5])
            builder.cylinder(glow, (0, 0, -0.13), (0, 0, -0.12), 0.125, segments=14)
            builder.cylinder(finish("paint_black"), (0, 0, 0.13), (0, 0, 0.14), 0.08, segments=14)
        builder.cylinder(metal, (float(x), 0, -0.3), (float(x), 0, -0.42), 0.02, segments=6)


@piece("amplifier")
def amplifier(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a guitar amplifier that faces -Y. Parameters: width, height."""
    width, height = spec.number("width", 0.66), spec.number("height", 0.6)
    builder.box(finish("plastic_black"), (0, 0, height / 2), (width, 0.3, height), bevel=0.02)
    builder.box(finish("cloth_cream"), (0, -0.152, height * 0.42), (width - 0.08, 0.01, height * 0.68))
    builder.box(finish("brass"), (0, -0.152, height * 0.88), (width - 0.08, 0.012, 0.07))
    for x in np.linspace(-width * 0.36, width * 0.36, 7):
        start, end = (float(x), -0.155, height * 0.88), (float(x), -0.18, height * 0.88)
        builder.cylinder(finish("paint_black"), start, end, 0.016, segments=8)
