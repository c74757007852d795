"""Set piece builders: studio and workshop: mixing desks, acoustic foam, servers, canvases, paint, printing presses."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("mixing_desk")
def mixing_desk(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a mixing desk with faders, screens and speakers along x, the engineer's side at -Y. Parameters: length."""
    length = spec.number("length", 2.6)
    builder.box(finish("wood"), (0, 0, 0.36), (length, 0.7, 0.72), bevel=0.02)
    builder.box(finish("paint_black"), (0, -0.08, 0.79), (length - 0.1, 0.66, 0.1), rotation=(9, 0, 0), bevel=0.01)
    for index, x in enumerate(np.arange(-length / 2 + 0.14, length / 2 - 0.1, 0.075)):
        z = 0.825
        builder.box(finish("metal_grey"), (float(x), -0.26, z - 0.01), (0.012, 0.2, 0.006), rotation=(9, 0, 0))
        builder.box(
            finish("paint_white"), (float(x), -0.3 + 0.02 * (index * 7 % 6), z), (0.03, 0.04, 0.02), rotation=(9, 0, 0)
        )
        for row in range(4):
            skin = ("paint_red", "paint_yellow", "paint_green", "paint_blue")[(row + index // 4) % 4]
            start = (float(x), -0.1 + 0.08 * row, 0.84 + 0.013 * row)
            builder.cylinder(finish(skin), start, (float(x), -0.1 + 0.08 * row, 0.86 + 0.013 * row), 0.014, segments=6)
    for x in (-length * 0.36, length * 0.36):
        builder.box(finish("plastic_black"), (x, 0.3, 1.08), (0.3, 0.26, 0.44), bevel=0.015)
        builder.cylinder(finish("paint_yellow"), (x, 0.165, 1.0), (x, 0.155, 1.0), 0.1, segments=16)
    builder.box(finish("plastic_black"), (0, 0.34, 1.12), (0.72, 0.04, 0.42), bevel=0.01)
    builder.box(finish("lamp_cool"), (0, 0.315, 1.12), (0.66, 0.006, 0.36))
    for z in (1.02, 1.1, 1.18, 1.26):
        center = (float(spec.rng.uniform(-0.12, 0.12)), 0.31, z)
        builder.box(finish("paint_green"), center, (float(spec.rng.uniform(0.2, 0.45)), 0.004, 0.03))


@piece("foam_panel")
def foam_panel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a panel of acoustic foam on a wall at y = 0, lower edge at z = 0. Parameters: width, height, color."""
    width, height, skin = spec.number("width", 1.8), spec.number("height", 1.2), spec.paint("color", "#3b3f44")
    count = max(4, round(width / 0.12))
    builder.box(skin, (0, -0.015, height / 2), (width, 0.03, height))
    for index in range(count):
        x, half = (index + 0.5) * width / count - width / 2, width / count / 2
        builder.loft(
            skin, [[(x - half, -0.03, z), (x, -0.1, z), (x + half, -0.03, z)] for z in (0.0, height)], closed=False
        )


@piece("studio_window")
def studio_window(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the window to a recording booth on a wall at y = 0, its lower edge at z = 0. Parameters: width, height."""
    width, height = spec.number("width", 2.6), spec.number("height", 1.1)
    builder.box(finish("wood_dark"), (0, -0.03, height / 2), (width + 0.2, 0.06, height + 0.2), bevel=0.01)
    builder.box(finish("glass_dark"), (0, -0.065, height / 2), (width, 0.01, height))
    builder.box(finish("pane_warm"), (width * 0.22, -0.072, height * 0.72), (width * 0.2, 0.004, height * 0.12))
    builder.cylinder(
        finish("metal_grey"), (-width * 0.18, -0.072, 0.05), (-width * 0.18, -0.072, height * 0.6), 0.012, segments=6
    )
    builder.sphere(
        finish("metal_grey"), (-width * 0.18, -0.075, height * 0.68), 0.06, scale=(1, 0.2, 1.3), segments=10, rings=6
    )
    builder.box(finish("paint_red"), (0, -0.07, height + 0.2), (0.5, 0.06, 0.16), bevel=0.01)
    builder.box(finish("paint_white"), (0, -0.103, height + 0.2), (0.34, 0.006, 0.06))


@piece("server_rack")
def server_rack(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a row of server cabinets along x that face -Y. Parameters: count, seed."""
    count, black = int(spec.number("count", 4)), finish("plastic_black")
    for index in range(count):
        x = (index - (count - 1) / 2) * 0.62
        builder.box(black, (x, 0, 1.0), (0.6, 0.9, 2.0), bevel=0.01)
        for row in range(13):
            z = 0.16 + 0.137 * row
            builder.box(finish("metal_grey" if row % 3 else "paint_grey"), (x, -0.455, z), (0.5, 0.012, 0.115))
            for lamp in range(5):
                if spec.rng.random() < 0.7:
                    key = ("paint_green", "lamp_cool", "paint_green", "paint_yellow")[int(spec.rng.integers(4))]
                    builder.box(finish(key), (x - 0.2 + 0.05 * lamp, -0.464, z), (0.022, 0.006, 0.016))
            if row % 4 == 1:
                builder.tube(
                    painted("#33506b"),
                    [(x + 0.1, -0.46, z), (x + 0.18, -0.5, z - 0.1), (x + 0.22, -0.46, z - 0.26)],
                    0.01,
                    segments=4,
                )


@piece("canvas_stack")
def canvas_stack(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lean painted canvases on a wall at y = 0. Parameters: variant."""
    codes = ("#b0564a", "#2f6f8a", "#c9a24a", "#57704a", "#6b3a6a", "#d0b8a0")
    at = -0.9
    for index in range(4):
        wide, tall = float(spec.rng.uniform(0.55, 0.95)), float(spec.rng.uniform(0.7, 1.3))
        with builder.at((at + wide / 2, -0.16 - 0.05 * index, 0), (-9, 0, 0)):
            builder.box(finish("linen"), (0, 0, tall / 2), (wide, 0.03, tall))
            for stroke in range(6):
                skin = painted(codes[int(spec.rng.integers(6))])
                sx, sz = float(spec.rng.uniform(-0.3, 0.3)) * wide, float(spec.rng.uniform(0.2, 0.8)) * tall
                size = (wide * float(spec.rng.uniform(0.15, 0.4)), 0.002, tall * float(spec.rng.uniform(0.08, 0.3)))
                builder.box(
                    skin, (sx, -0.017 - 0.001 * stroke, sz), size, rotation=(0, float(spec.rng.uniform(-30, 30)), 0)
                )
        at += 0.38


@piece("paint_spots")
def paint_spots(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Spatter the floor with paint around the origin. Parameters: reach."""
    reach = spec.number("reach", 1.6)
    for _ in range(34):
        x, y, r = (float(v) for v in (*spec.rng.uniform(-reach, reach, 2), spec.rng.uniform(0.02, 0.09)))
        skin = painted(("#b0564a", "#2f6f8a", "#c9a24a", "#57704a", "#d9d5ca")[int(spec.rng.integers(5))])
        ring = [
            (x + r * (1 + 0.3 * math.sin(3 * t + x * 9)) * math.cos(t), y + r * math.sin(t), 0.006)
            for t in np.linspace(0, 6.28, 12)[:-1]
        ]
        builder.polygon(skin, ring)


@piece("printing_press")
def printing_press(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an iron printing press with a wheel that faces -Y."""
    iron = painted("#2c3134")
    for x in (-0.6, 0.6):
        builder.box(iron, (x, 0, 0.9), (0.16, 0.5, 1.8), bevel=0.03)
        builder.box(iron, (x, 0, 0.06), (0.3, 0.9, 0.12), bevel=0.02)
    builder.box(iron, (0, 0, 1.82), (1.5, 0.5, 0.22), bevel=0.04)
    builder.box(finish("wood_dark"), (0, -0.1, 0.82), (1.0, 1.3, 0.12), bevel=0.01)
    builder.box(finish("paint_white"), (0, -0.35, 0.885), (0.6, 0.5, 0.006))
    builder.box(iron, (0, 0, 1.18), (0.8, 0.5, 0.14), bevel=0.02)
    builder.cylinder(finish("steel"), (0, 0, 1.24), (0, 0, 1.75), 0.08, segments=10)
    ring = [(0.85, 0.36 * math.cos(t), 1.1 + 0.36 * math.sin(t)) for t in np.linspace(0, 6.28, 19)[:-1]]
    builder.tube(iron, ring, 0.03, segments=6, closed=True)
    for t in np.arange(0, math.pi, math.pi / 3):
        y, z = 0.36 * math.cos(t), 0.36 * math.sin(t)
        builder.cylinder(iron, (0.85, -y, 1.1 - z), (0.85, y, 1.1 + z), 0.016, segments=5)
    builder.cylinder(iron, (0.6, 0, 1.1), (0.9, 0, 1.1), 0.05, segments=8)


@piece("news_desk")
def news_desk(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a curved TV news desk with a lit edge, the camera side at -Y."""
    t = np.linspace(math.pi * 1.2, math.pi * 1.8, 13)
    outer = np.c_[2.6 * np.cos(t), 2.2 + 2.6 * np.sin(t)]
    inner = np.c_[2.0 * np.cos(t), 2.2 + 2.0 * np.sin(t)]
    for (p, q), (r, s) in zip(pairwise(outer), pairwise(inner), strict=True):
        builder.quad(finish("paint_white"), (*p, 0.98), (*q, 0.98), (*s, 0.98), (*r, 0.98))
        builder.quad(painted("#1f3a5f"), (*p, 0.1), (*q, 0.1), (*q, 0.9), (*p, 0.9))
        builder.quad(finish("lamp_cool"), (*p, 0.9), (*q, 0.9), (*q, 0.98), (*p, 0.98))
        builder.quad(finish("paint_grey"), (*s, 0.1), (*r, 0.1), (*r, 0.98), (*s, 0.98))
    for x in (-0.7, 0.7):
        builder.box(finish("paint_white"), (x, 0.0, 0.985), (0.22, 0.3, 0.004))
        builder.lathe(finish("porcelain"), [(0.035, 0), (0.04, 0.09)], origin=(x + 0.28, 0.0, 0.98), segments=10)


@piece("drying_line")
def drying_line(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Stretch a drying line along x at z = 0 with printed sheets on it. Parameters: length."""
    length = spec.number("length", 5)
    builder.cylinder(finish("canvas"), (-length / 2, 0, 0), (length / 2, 0, 0), 0.008, segments=4)
    for x in np.arange(-length / 2 + 0.3, length / 2 - 0.2, 0.42):
        tall = float(spec.rng.uniform(0.4, 0.5))
        builder.box(finish("paper"), (float(x), 0, -tall / 2), (0.34, 0.01, tall))
        for row in range(6):
            wide = 0.26 if row else 0.16
            builder.box(finish("paint_black"), (float(x), -0.007, -0.08 - 0.055 * row), (wide, 0.003, 0.012))
