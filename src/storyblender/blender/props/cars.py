"""Cars, vans, trucks and buses: lofted sections along their length. Their front is -Y."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.parts import wheel
from storyblender.blender.props.registry import Anchors, PropSpec, handle, prop

Section = tuple[float, float, float, float]
"""y, half width, lower z, upper z."""


def _shell(b: MeshBuilder, material: MaterialRef, sections: list[Section], round_top: float = 0.14) -> None:
    """Add a body whose sections bulge at the belt and round off at the top."""
    rings = []
    for y, half, low, high in sections:
        tall = high - low
        r = min(round_top, tall * 0.45)
        outline = [
            (0.9, low),
            (0.985, low + tall * 0.12),
            (1.0, low + tall * 0.45),
            (0.97, high - r),
            (0.93, high - r * 0.45),
            (0.84, high - r * 0.1),
            (0.6, high),
            (0.0, high + 0.012),
        ]
        right = [(half * x, y, z) for x, z in outline]
        left = [(-x, y_, z) for x, y_, z in reversed(right[:-1])]
        rings.append(np.array(right + left))
    b.loft(material, rings)


def _greenhouse(b: MeshBuilder, paint: MaterialRef, glass: MaterialRef, sections: list[Section]) -> None:
    """Add a glass cabin between pillars under a roof; the sections are belt, roof front, roof back, belt."""
    (y0, w0, z0, _), (y1, w1, _, h1), (y2, w2, _, h2), (y3, w3, z3, _) = sections
    belt = [np.array([(-w0, y0, z0), (w0, y0, z0)]), np.array([(-w3, y3, z3), (w3, y3, z3)])]
    roof = [np.array([(-w1, y1, h1), (w1, y1, h1)]), np.array([(-w2, y2, h2), (w2, y2, h2)])]
    skin = 0.012
    b.quad(glass, belt[0][0], belt[0][1], roof[0][1], roof[0][0])
    b.quad(glass, belt[1][1], belt[1][0], roof[1][0], roof[1][1])
    b.quad(glass, belt[0][1], belt[1][1], roof[1][1], roof[0][1])
    b.quad(glass, belt[1][0], belt[0][0], roof[0][0], roof[1][0])
    crown = []
    for y, half, z in (
        (y1 - 0.05, w1 * 0.97, h1 - 0.03),
        (y1 + 0.1, w1 * 1.02, h1 + 0.02),
        ((y1 + y2) / 2, (w1 + w2) / 2 * 1.03, max(h1, h2) + 0.035),
        (y2 - 0.1, w2 * 1.02, h2 + 0.02),
        (y2 + 0.05, w2 * 0.97, h2 - 0.03),
    ):
        crown.append(
            np.array(
                [
                    (-half, y, z - 0.05),
                    (half, y, z - 0.05),
                    (half * 0.96, y, z - 0.01),
                    (half * 0.7, y, z + 0.02),
                    (-half * 0.7, y, z + 0.02),
                    (-half * 0.96, y, z - 0.01),
                ]
            )
        )
    b.loft(paint, crown)
    for side in (0, 1):
        for start, end in ((belt[0][side], roof[0][side]), (belt[1][side], roof[1][side])):
            b.tube(paint, [start, end], 0.03 + skin, segments=6)
        middle = 0.52
        low = belt[0][side] * (1 - middle) + belt[1][side] * middle
        high = roof[0][side] * (1 - middle) + roof[1][side] * middle
        b.tube(paint, [low, high], 0.035, segments=6)


def _wheels(b: MeshBuilder, spec: PropSpec, half: float, radius: float, axles: tuple[float, ...], width: float) -> None:
    for x in (-1, 1):
        for y in axles:
            wheel(b, spec.material("tyre"), spec.material("chrome"), (x * (half - width / 2), y, radius), radius, width)


def _lamps(b: MeshBuilder, spec: PropSpec, x: float, front: float, back: float, z: float, radius: float) -> None:
    for side in (-1, 1):
        b.lathe(
            spec.material("chrome"),
            [(radius * 1.15, -0.06), (radius * 1.15, 0.01), (radius, 0.015)],
            origin=(side * x, front, z),
            axis=(0, -1, 0),
            segments=18,
        )
        b.lathe(
            spec.material("lamp"),
            [(radius, 0.012), (radius * 0.6, 0.035), (0.003, 0.045)],
            origin=(side * x, front, z),
            axis=(0, -1, 0),
            segments=18,
            caps=False,
        )
        b.rounded_box("neon_red", (side * x, back, z), (radius * 1.6, 0.05, radius * 1.3), 0.018)


@prop("car")
def car(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a car of the wanted ``period``: 1940s or modern."""
    return _old_car(b, spec) if spec.word("period") in ("1940s", "past", "classic") else _modern_car(b, spec)


def _modern_car(b: MeshBuilder, spec: PropSpec) -> Anchors:
    (w, d, h), paint, glass = spec.size, spec.material("body"), spec.material("glass")
    half, f, r = w / 2, -d / 2, d / 2
    belt = h * 0.6
    _shell(
        b,
        paint,
        [
            (f, half * 0.78, 0.34, 0.6),
            (f + 0.08, half * 0.9, 0.24, 0.68),
            (f + 0.5, half * 0.97, 0.2, belt * 0.86),
            (f + 1.25, half, 0.2, belt * 0.98),
            (0.2, half, 0.2, belt + 0.03),
            (r - 1.0, half, 0.2, belt + 0.05),
            (r - 0.35, half * 0.96, 0.22, belt + 0.03),
            (r - 0.05, half * 0.88, 0.28, belt * 0.92),
            (r, half * 0.8, 0.36, belt * 0.8),
        ],
    )
    top = h - 0.05
    _greenhouse(
        b,
        paint,
        glass,
        [
            (f + 1.15, half * 0.9, belt, 0),
            (f + 1.95, half * 0.72, 0, top),
            (r - 1.15, half * 0.7, 0, top - 0.03),
            (r - 0.5, half * 0.88, belt + 0.04, 0),
        ],
    )
    axles = (f + 0.85, r - 0.85)
    for x in (-1, 1):
        for y in axles:
            b.cylinder("plastic_black", (x * (half - 0.24), y, 0.33), (x * (half + 0.003), y, 0.33), 0.38, segments=28)
    _wheels(b, spec, half + 0.015, 0.32, axles, 0.2)
    for side in (-1, 1):
        b.rounded_box(spec.material("lamp"), (side * half * 0.66, f + 0.05, 0.6), (half * 0.36, 0.1, 0.11), 0.03)
        b.rounded_box("neon_red", (side * half * 0.68, r - 0.03, 0.72), (half * 0.36, 0.08, 0.11), 0.03)
        b.rounded_box(paint, (side * (half + 0.06), f + 1.5, belt + 0.08), (0.16, 0.09, 0.12), 0.03)
        for y in (-0.02, 1.0):
            b.box("plastic_black", (side * (half - 0.003), y - 0.45, 0.52), (0.012, 0.008, 0.56))
            b.box(spec.material("chrome"), (side * (half + 0.003), y, belt - 0.1), (0.02, 0.16, 0.025), bevel=0.006)
    b.rounded_box("plastic_black", (0, f + 0.01, 0.42), (half * 1.1, 0.06, 0.14), 0.02)
    b.box("porcelain", (0, f - 0.025, 0.4), (0.46, 0.012, 0.1), bevel=0.003)
    b.box("porcelain", (0, r + 0.0, 0.55), (0.46, 0.012, 0.1), bevel=0.003)
    return _door_handles(half, (-0.02, 1.0), belt - 0.1)


def _old_car(b: MeshBuilder, spec: PropSpec) -> Anchors:
    (w, d, h), paint, glass, chrome = spec.size, spec.material("body"), spec.material("glass"), spec.material("chrome")
    half, f, r = w / 2, -d / 2, d / 2
    tall = h * 1.08
    _shell(
        b,
        paint,
        [
            (f + 0.12, half * 0.3, 0.5, 0.86),
            (f + 0.25, half * 0.42, 0.46, 1.0),
            (f + 0.9, half * 0.58, 0.44, 1.06),
            (f + 1.5, half * 0.76, 0.4, 1.08),
            (f + 1.75, half * 0.86, 0.38, 1.08),
            (0.3, half * 0.88, 0.38, 1.08),
            (r - 1.0, half * 0.86, 0.38, 1.04),
            (r - 0.4, half * 0.74, 0.4, 0.94),
            (r - 0.08, half * 0.5, 0.44, 0.76),
        ],
        0.2,
    )
    rings = []
    for y, wide, z in (
        (f + 1.5, 0.6, 1.1),
        (f + 1.85, 0.68, tall - 0.14),
        (f + 2.3, 0.7, tall - 0.02),
        (0.55, 0.72, tall),
        (r - 1.35, 0.7, tall - 0.1),
        (r - 0.9, 0.62, tall - 0.32),
        (r - 0.45, 0.5, 0.98),
    ):
        s = half * wide / 0.72 * 0.8
        rings.append(
            np.array(
                [
                    (-s * 1.05, y, 0.98),
                    (s * 1.05, y, 0.98),
                    (s, y, (z + 1) / 2),
                    (s * 0.9, y, z - 0.06),
                    (s * 0.6, y, z),
                    (-s * 0.6, y, z),
                    (-s * 0.9, y, z - 0.06),
                    (-s, y, (z + 1) / 2),
                ]
            )
        )
    b.loft(paint, rings)
    for x in (-1, 1):
        side = half * 0.82
        for y0, y1 in ((f + 2.02, f + 2.62), (f + 2.74, f + 3.3)):
            slope = 0.03 if y0 < f + 2.3 else -0.02
            b.loft(
                glass,
                [
                    np.array([(x * side * 1.0, y0 + 0.02, 1.12), (x * side * 0.94, y0 + 0.06 + slope, tall - 0.16)]),
                    np.array([(x * side * 1.0, y1, 1.12), (x * side * 0.94, y1 - 0.03, tall - 0.16)]),
                ][::x],
                closed=False,
            )
        b.box("plastic_black", (x * half * 0.885, f + 2.68, 0.74), (0.012, 0.008, 0.62))
        b.box(chrome, (x * half * 0.9, f + 2.5, 0.98), (0.03, 0.14, 0.025), bevel=0.006)
        b.box(paint, (x * (half - 0.14), (f + r) / 2 - 0.05, 0.33), (0.28, d * 0.46, 0.05), bevel=0.012)
        for y, length in ((f + 0.75, 0.62), (r - 0.85, 0.6)):
            b.cushion(paint, (x * (half - 0.17), y, 0.52), (0.34, length * 2, 0.62), softness=0.75)
            b.cylinder("plastic_black", (x * (half - 0.24), y, 0.35), (x * (half + 0.0), y, 0.35), 0.36, segments=26)
    b.quad(
        glass,
        (-half * 0.62, f + 1.54, 1.12),
        (half * 0.62, f + 1.54, 1.12),
        (half * 0.54, f + 1.83, tall - 0.17),
        (-half * 0.54, f + 1.83, tall - 0.17),
    )
    b.quad(
        glass,
        (half * 0.4, r - 0.62, 1.12),
        (-half * 0.4, r - 0.62, 1.12),
        (-half * 0.36, r - 0.98, tall - 0.36),
        (half * 0.36, r - 0.98, tall - 0.36),
    )
    _wheels(b, spec, half + 0.02, 0.34, (f + 0.75, r - 0.85), 0.17)
    _lamps(b, spec, half * 0.68, f + 0.14, r - 0.16, 0.82, 0.11)
    for k in range(9):
        z = 0.52 + 0.055 * k
        b.rounded_box(chrome, (0, f + 0.1 + 0.012 * k, z), (half * (0.62 - 0.02 * k), 0.04, 0.022), 0.01)
    for y in (f + 0.02, r - 0.02):
        b.rounded_box(chrome, (0, y, 0.46), (w * 0.92, 0.08, 0.13), 0.035)
    b.tube(chrome, [(0, f + 0.3, 1.0), (0, f + 0.9, 1.085), (0, f + 1.5, 1.1)], 0.012)
    return _door_handles(half, (f + 2.5, f + 3.2), 0.98)


def _door_handles(half: float, places: tuple[float, float], z: float) -> Anchors:
    return tuple(
        handle((x * half, y, z), (float(x), 0.0, 0.0), f"door_{end}_{side}")
        for side, x in (("left", 1), ("right", -1))
        for end, y in zip(("front", "rear"), places, strict=True)
    )


@prop("van")
def van(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a delivery van."""
    (w, d, h), paint, glass = spec.size, spec.material("body"), spec.material("glass")
    half, f, r = w / 2, -d / 2, d / 2
    _shell(
        b,
        paint,
        [
            (f, half * 0.84, 0.36, 0.86),
            (f + 0.1, half * 0.94, 0.26, 1.02),
            (f + 0.75, half, 0.24, 1.16),
            (f + 1.35, half, 0.24, h - 0.2),
            (f + 1.7, half, 0.24, h - 0.05),
            (r - 0.4, half, 0.24, h - 0.04),
            (r - 0.02, half * 0.97, 0.26, h - 0.08),
            (r, half * 0.94, 0.3, h - 0.14),
        ],
        0.22,
    )
    b.quad(
        glass,
        (-half * 0.86, f + 0.74, 1.2),
        (half * 0.86, f + 0.74, 1.2),
        (half * 0.8, f + 1.36, h - 0.24),
        (-half * 0.8, f + 1.36, h - 0.24),
    )
    for x in (-1, 1):
        window = [
            np.array([(x * half * 1.006, f + 0.98, 1.2), (x * half * 0.985, f + 1.4, h - 0.36)]),
            np.array([(x * half * 1.006, f + 1.85, 1.2), (x * half * 0.985, f + 1.82, h - 0.3)]),
        ]
        b.loft(glass, window[::x], closed=False)
        b.box("plastic_black", (x * half, f + 1.95, 0.9), (0.012, 0.01, 1.3))
        b.box("plastic_black", (x * half, f + 3.3, 1.1), (0.012, 0.01, 1.5))
        b.box(spec.material("chrome"), (x * (half + 0.005), f + 1.75, 1.02), (0.03, 0.14, 0.03), bevel=0.006)
        b.rounded_box("plastic_black", (x * (half + 0.08), f + 1.0, 1.32), (0.14, 0.08, 0.26), 0.03)
        for y in (f + 0.85, r - 1.0):
            b.cylinder("plastic_black", (x * (half - 0.26), y, 0.36), (x * (half + 0.003), y, 0.36), 0.41, segments=26)
    b.box("plastic_black", (0, r - 0.002, 1.15), (0.012, 0.012, h - 0.6))
    _wheels(b, spec, half + 0.015, 0.34, (f + 0.85, r - 1.0), 0.22)
    _lamps(b, spec, half * 0.72, f + 0.02, r - 0.02, 0.74, 0.1)
    for y in (f + 0.0, r):
        b.rounded_box("plastic_black", (0, y, 0.42), (w * 0.9, 0.1, 0.16), 0.04)
    return _door_handles(half, (f + 1.75, f + 3.2), 1.02)


@prop("truck")
def truck(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a truck with a cab and an open wooden bed."""
    (w, d, h), paint, glass, wood = spec.size, spec.material("body"), spec.material("glass"), spec.material("bed")
    half, f, r = w / 2, -d / 2, d / 2
    cab = half * 0.84
    _shell(
        b,
        paint,
        [
            (f + 0.1, cab * 0.62, 0.6, 1.2),
            (f + 0.2, cab * 0.72, 0.55, 1.34),
            (f + 1.0, cab * 0.8, 0.55, 1.4),
            (f + 1.15, cab * 0.98, 0.5, 1.42),
            (f + 2.3, cab, 0.5, 1.42),
        ],
    )
    _greenhouse(
        b,
        paint,
        glass,
        [
            (f + 1.15, cab * 0.92, 1.4, 0),
            (f + 1.35, cab * 0.82, 0, h - 0.1),
            (f + 2.2, cab * 0.84, 0, h - 0.1),
            (f + 2.3, cab * 0.94, 1.4, 0),
        ],
    )
    b.box("iron", (0, (f + r) / 2 + 0.6, 0.66), (w * 0.4, d - 1.6, 0.16))
    bed = d - 2.5
    middle = r - bed / 2
    b.box(wood, (0, middle, 0.96), (w, bed, 0.08), bevel=0.01)
    for x in (-1, 1):
        for k in range(3):
            b.box(wood, (x * (half - 0.02), middle, 1.12 + 0.24 * k), (0.04, bed, 0.19), bevel=0.008)
        for k in range(5):
            b.box("iron", (x * (half + 0.01), middle + (k - 2) * bed * 0.235, 1.3), (0.03, 0.06, 0.8), bevel=0.006)
    for y in (r - 0.02, r - bed + 0.02):
        for k in range(3):
            b.box(wood, (0, y, 1.12 + 0.24 * k), (w - 0.1, 0.04, 0.19), bevel=0.008)
    axles = (f + 0.85, r - 1.2)
    for x in (-1, 1):
        b.cushion(paint, (x * (half - 0.24), f + 0.85, 0.66), (0.46, 1.3, 0.66), softness=0.7)
    _wheels(b, spec, half - 0.02, 0.46, axles, 0.24)
    _wheels(b, spec, half - 0.3, 0.46, axles[1:], 0.24)
    _lamps(b, spec, cab * 0.85, f + 0.12, r + 0.01, 1.05, 0.11)
    b.rounded_box(spec.material("chrome"), (0, f + 0.02, 0.6), (w * 0.9, 0.08, 0.16), 0.03)
    for k in range(8):
        b.box(spec.material("chrome"), ((k - 3.5) * 0.1, f + 0.1, 0.98), (0.035, 0.03, 0.5), bevel=0.008)
    return _door_handles(cab, (f + 2.0, f + 2.1), 1.2)


@prop("bus")
def bus(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bus with rows of windows."""
    (w, d, h), paint, glass, chrome = spec.size, spec.material("body"), spec.material("glass"), spec.material("chrome")
    half, f, r = w / 2, -d / 2, d / 2
    _shell(
        b,
        paint,
        [
            (f, half * 0.9, 0.4, h - 0.35),
            (f + 0.12, half * 0.98, 0.34, h - 0.12),
            (f + 0.5, half, 0.32, h - 0.03),
            (r - 0.4, half, 0.32, h - 0.03),
            (r - 0.06, half * 0.97, 0.36, h - 0.14),
            (r, half * 0.92, 0.42, h - 0.3),
        ],
        0.3,
    )
    b.rounded_box(glass, (0, f + 0.02, h * 0.62), (w * 0.84, 0.08, h * 0.36), 0.03)
    count = max(4, round((d - 2.6) / 1.1))
    for x in (-1, 1):
        for k in range(count):
            b.rounded_box(
                glass,
                (x * (half - 0.01), f + 2.3 + k * (d - 2.6) / count, h * 0.63),
                (0.05, (d - 2.6) / count - 0.14, h * 0.28),
                0.02,
            )
        b.box(chrome, (x * (half + 0.004), 0.3, h * 0.42), (0.02, d - 1.0, 0.05), bevel=0.006)
        for y in (f + 2.0, r - 2.1):
            b.cylinder("plastic_black", (x * (half - 0.3), y, 0.48), (x * (half + 0.004), y, 0.48), 0.54, segments=26)
    b.rounded_box(glass, (half - 0.01, f + 1.0, h * 0.45), (0.05, 0.8, h * 0.66), 0.02)
    b.box("plastic_black", (half + 0.008, f + 1.0, h * 0.45), (0.04, 0.03, h * 0.66))
    _wheels(b, spec, half + 0.02, 0.46, (f + 2.0, r - 2.1), 0.28)
    _lamps(b, spec, half * 0.74, f + 0.01, r - 0.01, 0.78, 0.12)
    b.rounded_box("lampshade", (0, f + 0.1, h - 0.24), (w * 0.6, 0.1, 0.2), 0.03)
    for y in (f, r):
        b.rounded_box(chrome, (0, y, 0.5), (w * 0.92, 0.1, 0.18), 0.04)
    return (handle((half, f + 1.0, h * 0.45), (1, 0, 0), "door"),)
