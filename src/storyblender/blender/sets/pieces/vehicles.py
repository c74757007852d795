"""Set piece builders: the insides of vehicles: a car's body with its doors, dashboard, wheel and mirrors."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.catalog.sets.car_body import BELT, HALF, NOSE, REAR, ROOF, SCREEN, TAIL

_PANEL = 0.09
"""Metres that a door is thick."""


@piece("car_body")
def car_body(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a car about the origin, its nose at -Y, without roof lining and seats. Parameters: color, modern, taxi."""
    paint, lining = spec.paint("color", "#2c3f4c"), finish("paint_black" if spec.flag("modern") else "leather")
    _flanks(builder, paint, lining)
    _ends(builder, paint)
    _pillars(builder, paint)
    _dashboard(builder, modern=spec.flag("modern"))
    _mirrors(builder, paint)
    if spec.flag("taxi"):
        builder.box(finish("paint_cream"), (0, 0, ROOF + 0.13), (0.5, 0.2, 0.16), bevel=0.03)
        builder.box(finish("pane_warm"), (0, -0.105, ROOF + 0.13), (0.4, 0.01, 0.09))
        builder.box(finish("paint_black"), (-0.05, SCREEN[0] + 0.24, BELT + 0.15), (0.18, 0.12, 0.12), bevel=0.01)
        builder.box(finish("lamp_warm"), (-0.05, SCREEN[0] + 0.305, BELT + 0.17), (0.12, 0.01, 0.04))


def _flanks(builder: MeshBuilder, paint: MaterialRef, lining: MaterialRef) -> None:
    """Add doors, wings and sills with their cards, handles, armrests and wheels."""
    metal = finish("chrome")
    for side in (-1, 1):
        x = side * HALF
        builder.box(paint, (x, (NOSE + TAIL) / 2, (0.24 + BELT) / 2), (_PANEL, TAIL - NOSE, BELT - 0.24), bevel=0.02)
        builder.box(lining, (x - side * 0.055, (SCREEN[0] + REAR[0]) / 2, 0.5), (0.02, REAR[0] - SCREEN[0], 0.72))
        builder.box(metal, (x, (SCREEN[0] + REAR[0]) / 2, BELT + 0.005), (0.03, REAR[0] - SCREEN[0], 0.02))
        for y in (-0.55, 0.5):
            builder.box(lining, (x - side * 0.1, y, 0.62), (0.09, 0.5, 0.06), bevel=0.02)
            builder.box(metal, (x - side * 0.08, y - 0.2, 0.74), (0.02, 0.12, 0.025))
            builder.box(metal, (x + side * 0.055, y + 0.28, 0.76), (0.03, 0.16, 0.03), bevel=0.008)
        for y in (0.02, SCREEN[0] + 0.1):  # the gaps of the doors
            builder.box(finish("paint_black"), (x + side * 0.046, y, 0.56), (0.006, 0.012, 0.62))
        for y in (NOSE + 0.62, TAIL - 0.62):
            builder.cylinder(
                finish("rubber"), (x - side * 0.12, y, 0.32), (x + side * 0.06, y, 0.32), 0.32, segments=24
            )
            builder.cylinder(metal, (x, y, 0.32), (x + side * 0.07, y, 0.32), 0.17, segments=20)


def _ends(builder: MeshBuilder, paint: MaterialRef) -> None:
    """Add bonnet, boot, bulkheads, lamps and bumpers."""
    for y, middle, high in ((SCREEN[0], NOSE, BELT - 0.08), (REAR[0], TAIL, BELT - 0.05)):
        away = -1 if middle < y else 1
        rings = [
            [(-HALF, at, 0.3), (HALF, at, 0.3), (HALF, at, top - 0.04), (HALF * 0.7, at, top + bulge),
             (-HALF * 0.7, at, top + bulge), (-HALF, at, top - 0.04)]
            for at, top, bulge in ((y, BELT, 0.02), ((y + middle) / 2, (BELT + high) / 2, 0.04), (middle, high, -0.02))
        ]  # fmt: skip
        builder.loft(paint, [np.array(ring) for ring in rings])
        builder.box(finish("chrome"), (0, middle + away * 0.06, 0.42), (2 * HALF + 0.04, 0.1, 0.12), bevel=0.03)
        lamp = finish("lamp_warm") if away < 0 else finish("paint_red")
        for x in (-HALF + 0.18, HALF - 0.18):
            builder.cylinder(lamp, (x, middle - away * 0.03, 0.62), (x, middle + away * 0.03, 0.62), 0.09, segments=16)
    builder.box(finish("paint_black"), (0, REAR[0] - 0.12, BELT - 0.02), (2 * HALF - 0.1, 0.26, 0.03))


def _pillars(builder: MeshBuilder, paint: MaterialRef) -> None:
    """Add the posts between the windows, the rails of the roof and its two cross members."""
    top = HALF - 0.14
    for side in (-1, 1):
        foot, head = side * (HALF - 0.02), side * top
        for low, high, wide in ((SCREEN[0], SCREEN[1], 0.05), (0.06, 0.06, 0.06), (REAR[0], REAR[1], 0.07)):
            builder.tube(paint, [(foot, low, BELT - 0.05), (head, high, ROOF)], wide / 1.6, segments=8)
        builder.tube(paint, [(head, SCREEN[1], ROOF), (head, REAR[1], ROOF)], 0.04, segments=8)
    for y in (SCREEN[1], REAR[1]):
        builder.tube(paint, [(-top, y, ROOF), (top, y, ROOF)], 0.035, segments=8)


def _dashboard(builder: MeshBuilder, *, modern: bool) -> None:
    """Add the dashboard across the car, its dials and the wheel before the seat at +X: nose at -Y, the left seat."""
    skin, front = finish("paint_black" if modern else "wood_red"), SCREEN[0]
    builder.box(skin, (0, front + 0.13, BELT - 0.1), (2 * HALF - 0.12, 0.3, 0.22), bevel=0.05)
    builder.box(skin, (0, front + 0.08, 0.42), (2 * HALF - 0.14, 0.12, 0.5))
    for x in (0.3, 0.5):
        builder.lathe(finish("lamp_cool" if modern else "paint_cream"), [(0.065, 0), (0.065, 0.012)],
                      origin=(x, front + 0.275, BELT - 0.08), axis=(0, 1, 0.15), segments=18)  # fmt: skip
    builder.box(finish("chrome"), (-0.05, front + 0.285, BELT - 0.12), (0.24, 0.012, 0.09))
    builder.box(finish("lamp_cool" if modern else "lamp_warm"), (-0.05, front + 0.293, BELT - 0.11), (0.2, 0.006, 0.04))
    builder.box(finish("chrome"), (-0.45, front + 0.285, BELT - 0.16), (0.4, 0.008, 0.02))
    middle, dark = np.array((0.4, front + 0.42, BELT - 0.02)), finish("paint_black")
    tilt = math.radians(62)
    across, up = np.array((1.0, 0, 0)), np.array((0, -math.cos(tilt), math.sin(tilt)))
    rim = [middle + 0.19 * (math.cos(t) * across + math.sin(t) * up) for t in np.linspace(0, 2 * math.pi, 25)[:-1]]
    builder.tube(dark, rim, 0.017, segments=8, closed=True)
    for angle in (math.pi / 2 + 2.1, math.pi / 2 - 2.1, math.pi / 2):
        end = middle + 0.18 * (math.cos(angle) * across + math.sin(angle) * up)
        builder.tube(dark, [middle, end], 0.014, segments=6)
    builder.sphere(dark, middle, 0.05, segments=12, rings=8)
    builder.tube(dark, [middle, np.array((0.4, front + 0.15, BELT - 0.2))], 0.03, segments=8)


def _mirrors(builder: MeshBuilder, paint: MaterialRef) -> None:
    """Add the mirror under the roof and one at each side."""
    dark, glass = finish("paint_black"), finish("chrome")
    y = SCREEN[1] + 0.02
    builder.box(dark, (0, y, ROOF - 0.12), (0.24, 0.03, 0.07), bevel=0.015)
    builder.box(glass, (0, y + 0.018, ROOF - 0.12), (0.21, 0.004, 0.05))
    builder.cylinder(dark, (0, y, ROOF - 0.1), (0, y - 0.02, ROOF), 0.01, segments=6)
    for side in (-1, 1):
        x = side * (HALF + 0.13)
        builder.box(paint, (x, SCREEN[0] + 0.22, BELT + 0.09), (0.18, 0.06, 0.12), bevel=0.025)
        builder.box(glass, (x, SCREEN[0] + 0.254, BELT + 0.09), (0.15, 0.004, 0.09))
