"""Set piece builders: interiors of aircraft and submarines, and airport gates: instrument panels, periscopes."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.tags import Surface


@piece("seat_row")
def seat_row(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a row of joined airport seats along x that face -Y. Parameters: count."""
    count, steel, pad = int(spec.number("count", 4)), finish("steel"), spec.paint("color", "#2b3440")
    length = 0.6 * count
    builder.box(steel, (0, 0.05, 0.3), (length, 0.08, 0.06))
    for x in (-length * 0.36, length * 0.36):
        builder.box(steel, (x, 0.05, 0.15), (0.08, 0.08, 0.3))
        builder.box(steel, (x, 0.0, 0.02), (0.1, 0.6, 0.03))
    for index in range(count):
        x = (index + 0.5) * 0.6 - length / 2
        builder.rounded_box(pad, (x, -0.04, 0.43), (0.52, 0.5, 0.08), 0.03)
        builder.rounded_box(pad, (x, 0.24, 0.72), (0.52, 0.08, 0.5), 0.03, rotation=(-12, 0, 0))
    for index in range(count + 1):
        x = index * 0.6 - length / 2
        builder.tube(steel, [(x, 0.16, 0.4), (x, 0.14, 0.62), (x, -0.18, 0.62), (x, -0.2, 0.42)], 0.015, segments=6)


@piece("gate_desk")
def gate_desk(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an airport gate desk with its sign above, the passenger side at -Y."""
    builder.box(finish("paint_grey"), (0, 0, 0.55), (2.2, 0.6, 1.1), bevel=0.02)
    builder.box(finish("paint_blue"), (0, -0.31, 0.6), (2.0, 0.02, 0.7))
    builder.box(finish("steel"), (0, -0.05, 1.12), (2.3, 0.75, 0.04), bevel=0.01)
    for x in (-0.55, 0.55):
        builder.box(finish("plastic_black"), (x, 0.05, 1.32), (0.46, 0.05, 0.32), rotation=(-8, 0, 0))
    for x in (-1.05, 1.05):
        builder.box(finish("metal_grey"), (x, 0.24, 1.3), (0.06, 0.06, 2.6))
    builder.box(finish("paint_yellow"), (0, 0.24, 2.5), (2.2, 0.1, 0.42), bevel=0.01)
    builder.box(finish("paint_black"), (-0.75, 0.185, 2.5), (0.36, 0.01, 0.26))
    for x, wide in ((-0.15, 0.5), (0.5, 0.6)):
        builder.box(finish("paint_black"), (x, 0.185, 2.5), (wide, 0.01, 0.1))


@piece("parked_jet")
def parked_jet(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an airliner along x outside the windows, its nose at -X."""
    white, dark = finish("paint_white"), finish("glass_dark")
    sections = (
        (-15.5, 0.1, 2.6), (-14.6, 1.0, 2.8), (-12.5, 1.8, 3.1), (9.0, 1.85, 3.2), (14.0, 1.0, 3.9), (17.0, 0.25, 4.4),
    )  # fmt: skip
    rings = [
        np.array([(x, r * math.cos(t), z + r * math.sin(t)) for t in np.linspace(0, 2 * math.pi, 19)[:-1]])
        for x, r, z in sections
    ]
    builder.loft(white, rings)
    for x in np.arange(-11.0, 9.5, 0.75):
        builder.box(dark, (float(x), -1.8, 3.55), (0.26, 0.1, 0.36))
    builder.box(dark, (-13.9, -0.95, 3.25), (0.9, 0.5, 0.4))
    builder.box(painted("#33506b"), (0, -1.86, 2.6), (22, 0.02, 0.24))
    builder.polygon(painted("#33506b"), [(12.5, 0, 4.6), (15.8, 0, 4.7), (17.6, 0, 8.8), (15.9, 0, 8.8)])
    builder.polygon(painted("#33506b"), [(15.9, 0.02, 8.8), (17.6, 0.02, 8.8), (15.8, 0.02, 4.7), (12.5, 0.02, 4.6)])
    for side in (-1, 1):
        rows = [
            np.array([(-2.5, side * 1.2, 2.4), (3.0, side * 1.2, 2.4), (3.0, side * 1.2, 2.7)]),
            np.array([(4.5, side * 12, 3.2), (6.2, side * 12, 3.2), (6.2, side * 12, 3.3)]),
        ]
        builder.loft(white, rows)
        builder.cylinder(finish("metal_grey"), (-2.4, side * 4.5, 1.6), (0.8, side * 4.5, 1.7), 0.75, 0.5, segments=14)
    for x, y in ((-11, 0), (2, -2), (2, 2)):
        builder.cylinder(finish("metal_grey"), (x, y, 0.4), (x, y, 2.2), 0.1, segments=6)
        builder.cylinder(finish("rubber"), (x, y - 0.2, 0.45), (x, y + 0.2, 0.45), 0.45, segments=14)


@piece("periscope")
def periscope(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a submarine's periscope from the floor to ``height``, its handles to -Y. Parameters: height."""
    height, steel = spec.number("height", 2.3), finish("steel")
    builder.cylinder(steel, (0, 0, 0.9), (0, 0, height), 0.11, segments=16)
    builder.box(finish("paint_grey"), (0, -0.02, 1.5), (0.36, 0.34, 0.42), bevel=0.03)
    builder.cylinder(finish("rubber"), (-0.07, -0.2, 1.56), (-0.07, -0.26, 1.56), 0.045, segments=12)
    builder.cylinder(finish("rubber"), (0.07, -0.2, 1.56), (0.07, -0.26, 1.56), 0.045, segments=12)
    for side in (-1, 1):
        builder.tube(finish("paint_black"), [(side * 0.18, -0.05, 1.42), (side * 0.42, -0.12, 1.38)], 0.025)
    builder.lathe(finish("metal_grey"), [(0.3, 0), (0.3, 0.06), (0.14, 0.1), (0.13, 0.9)], segments=18)


@piece("valve_wall")
def valve_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Run pipes, valves and gauges over a wall at y = 0. Parameters: length, height, seed."""
    length, height, rng = spec.number("length", 3.0), spec.number("height", 2.1), spec.rng
    pipes = (painted("#6f7a6c"), painted("#8a5a3a"), painted("#77797a"), painted("#4f5a4c"))
    for z in np.arange(0.4, height, 0.34):
        skin, r = pipes[int(rng.integers(4))], float(rng.uniform(0.03, 0.07))
        builder.cylinder(skin, (-length / 2, -0.1, float(z)), (length / 2, -0.1, float(z)), r, segments=8)
    for x in np.arange(-length / 2 + 0.3, length / 2, 0.6):
        builder.cylinder(
            pipes[int(rng.integers(4))], (float(x), -0.2, 0.1), (float(x), -0.2, height), 0.035, segments=8
        )
        z = float(rng.uniform(0.7, height - 0.5))
        ring = [(float(x) + 0.13 * math.cos(t), -0.3, z + 0.13 * math.sin(t)) for t in np.linspace(0, 6.28, 13)[:-1]]
        builder.tube(painted("#a3241d"), ring, 0.016, segments=5, closed=True)
        builder.cylinder(finish("iron"), (float(x), -0.2, z), (float(x), -0.3, z), 0.02, segments=6)
        gauge = float(x) + 0.3
        if gauge < length / 2 - 0.1:
            g = float(rng.uniform(1.1, height - 0.3))
            builder.cylinder(finish("brass"), (gauge, -0.1, g), (gauge, -0.22, g), 0.1, segments=16)
            builder.cylinder(finish("paint_cream"), (gauge, -0.22, g), (gauge, -0.226, g), 0.085, segments=16)
            builder.box(finish("paint_black"), (gauge, -0.23, g + 0.025), (0.01, 0.004, 0.07), rotation=(0, 35, 0))


@piece("flight_panel")
def flight_panel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an instrument panel along x whose dials face +Y, with two control wheels. Parameters: length."""
    length, grey = spec.number("length", 2.4), painted("#4a5055")
    builder.box(grey, (0, 0, 0.75), (length, 0.36, 0.5), bevel=0.03)
    builder.box(finish("paint_black"), (0, -0.02, 1.02), (length + 0.06, 0.42, 0.05), bevel=0.02)
    for x in np.arange(-length / 2 + 0.16, length / 2 - 0.1, 0.22):
        for z in (0.66, 0.86):
            builder.cylinder(finish("paint_black"), (float(x), 0.18, z), (float(x), 0.195, z), 0.085, segments=16)
            builder.cylinder(finish("paint_cream"), (float(x), 0.195, z), (float(x), 0.199, z), 0.015, segments=8)
            builder.box(
                finish("lamp_cool"), (float(x) + 0.02, 0.199, z + 0.03), (0.012, 0.004, 0.06), rotation=(0, 30, 0)
            )
    for x in (-length * 0.25, length * 0.25):
        builder.cylinder(finish("iron"), (x, 0.2, 0.6), (x, 0.42, 0.72), 0.03, segments=8)
        path = [(x - 0.17, 0.44, 0.84), (x - 0.15, 0.44, 0.7), (x + 0.15, 0.44, 0.7), (x + 0.17, 0.44, 0.84)]
        builder.tube(finish("paint_black"), path, 0.024)
    builder.box(grey, (0, 0.5, 0.42), (0.4, 0.8, 0.3), bevel=0.03)
    for y in (0.35, 0.5, 0.65):
        for x in (-0.1, 0.1):
            builder.cylinder(finish("metal_grey"), (x, y, 0.56), (x, y - 0.04, 0.72), 0.015, segments=6)
            builder.sphere(
                finish("paint_red" if y > 0.6 else "paint_white"), (x, y - 0.045, 0.73), 0.028, segments=8, rings=5
            )


@piece("switch_panel")
def switch_panel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a panel of switches, lamps and small screens on a wall at y = 0, lower edge at z = 0. Parameters: width,
    height."""
    width, height = spec.number("width", 0.9), spec.number("height", 0.9)
    builder.box(painted("#4a5055"), (0, -0.03, height / 2), (width, 0.06, height), bevel=0.01)
    for x in np.arange(-width / 2 + 0.07, width / 2 - 0.03, 0.09):
        for z in np.arange(0.08, height - 0.04, 0.1):
            kind = spec.rng.random()
            if kind < 0.5:
                start, end = (float(x), -0.06, float(z)), (float(x), -0.085, float(z) + 0.012)
                builder.cylinder(finish("chrome"), start, end, 0.007, segments=5)
                builder.box(finish("paint_black"), (float(x), -0.062, float(z)), (0.035, 0.006, 0.035))
            elif kind < 0.8:
                key = ("paint_green", "lamp_warm", "paint_red", "lamp_cool")[int(spec.rng.integers(4))]
                builder.box(finish(key), (float(x), -0.063, float(z)), (0.03, 0.008, 0.02))
            else:
                builder.cylinder(
                    finish("paint_black"), (float(x), -0.06, float(z)), (float(x), -0.072, float(z)), 0.034, segments=12
                )
                builder.box(finish("paint_white"), (float(x), -0.075, float(z) + 0.01), (0.006, 0.004, 0.03))


@piece("overhead_panel")
def overhead_panel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a panel of switches from the ceiling at z = 0."""
    builder.box(painted("#4a5055"), (0, 0, -0.08), (0.7, 0.8, 0.16), rotation=(-10, 0, 0), bevel=0.02)
    for x in np.arange(-0.28, 0.3, 0.08):
        for y in np.arange(-0.3, 0.32, 0.1):
            skin = finish(("chrome", "lamp_warm", "paint_green", "chrome")[int(spec.rng.integers(4))])
            builder.cylinder(skin, (float(x), float(y), -0.15), (float(x), float(y) - 0.01, -0.19), 0.009, segments=5)


@piece("wave_rings", Surface.NO_INK)
def wave_rings(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lay rings of small waves around a boat at the origin."""
    for radius in (2.6, 3.3, 4.3):
        ring = [(radius * 1.25 * math.cos(t), radius * 0.7 * math.sin(t), 0.0) for t in np.linspace(0, 6.28, 40)[:-1]]
        builder.tube(painted("#5a7f8a"), ring, 0.025, segments=4, closed=True)
    for _ in range(70):
        x, y, wide = (float(v) for v in (*spec.rng.uniform(-16, 16, 2), spec.rng.uniform(0.3, 0.9)))
        if math.hypot(x, y) > 4:
            builder.box(
                painted("#4a707c"), (x, y, 0.0), (wide, 0.05, 0.02), rotation=(0, 0, float(spec.rng.uniform(-12, 12)))
            )
