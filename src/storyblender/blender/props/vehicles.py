"""Prop builders: the airliner, the rowing boat, bicycles, carts and the pram. Their front is -Y."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, grip, handle, lean, seat
from storyblender.blender.props.parts import spoked_wheel, wheel
from storyblender.blender.props.registry import PropSpec, prop

PITCH = 9.0
"""Degrees a tail-dragger sits nose-up."""
AEROFOIL = (
    (0.0, 0.0), (0.03, 0.45), (0.12, 0.85), (0.3, 1.0), (0.6, 0.72), (1.0, 0.04), (1.0, -0.04), (0.6, -0.4),
    (0.3, -0.6), (0.12, -0.5), (0.03, -0.3),
)  # fmt: skip
"""Chord fraction from the leading edge, half-thickness fraction."""


def _wing(
    b: MeshBuilder,
    material: MaterialRef,
    stations: Sequence[tuple[tuple[float, float, float], float, float]],
    upright: bool = False,
) -> None:
    """Loft an aerofoil over (leading edge, chord, thickness) stations; the chord runs to +Y."""
    rings = [
        [(x + t * thick, y + c * chord, z) if upright else (x, y + c * chord, z + t * thick) for c, t in AEROFOIL]
        for (x, y, z), chord, thick in stations
    ]
    b.loft(material, rings)


@prop("airliner")
def airliner(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a twin-engine airliner on its tail wheel."""
    body, dark, glass, chrome, tyre = (spec.material(role) for role in ("body", "dark", "glass", "chrome", "tyre"))
    scale = np.array(spec.size) / (29.0, 19.6, 5.2)
    with b.at(scale=scale), b.at((0, 0, 3.0), (-PITCH, 0, 0)):
        stations = [
            (11.0, 0.1, 0.95), (9.0, 0.42, 0.62), (6.5, 0.82, 0.3), (3.0, 1.18, 0.05), (-1.0, 1.25, 0.0),
            (-4.0, 1.22, 0.0), (-5.8, 1.05, -0.02), (-7.0, 0.78, -0.12), (-7.9, 0.42, -0.22), (-8.25, 0.06, -0.26),
        ]  # fmt: skip
        angle = np.linspace(0, math.tau, 28, endpoint=False)
        b.loft(body, [np.c_[r * np.sin(angle), np.full(28, y), z + r * 1.08 * np.cos(angle)] for y, r, z in stations])
        for s in (-1, 1):
            _wing(
                b,
                body,
                [
                    ((s * 0.9, -3.2, -0.75), 4.2, 0.28),
                    ((s * 4.0, -2.9, -0.72), 3.9, 0.25),
                    ((s * 14.3, -0.9, 0.15), 1.3, 0.07),
                    ((s * 14.5, -0.6, 0.17), 0.7, 0.03),
                ],
            )
            _wing(b, body, [((s * 0.2, 8.6, 0.85), 2.1, 0.11), ((s * 4.2, 9.3, 0.95), 1.1, 0.05)])
            _engine(b, body, dark, chrome, s)
            for k in range(7):
                b.rounded_box(glass, (s * 1.2, -4.0 + 1.15 * k, 0.35), (0.1, 0.46, 0.42), 0.04)
            b.box(glass, (s * 0.84, -6.0, 0.62), (0.12, 0.56, 0.32), bevel=0.03, rotation=(0, 0, s * 16))
            b.box(glass, (s * 0.36, -6.62, 0.68), (0.62, 0.06, 0.32), bevel=0.02, rotation=(-32, 0, s * 14))
        stations = [
            ((0, 7.0, 0.85), 3.4, 0.16),
            ((0, 8.6, 2.6), 2.2, 0.12),
            ((0, 9.5, 3.5), 1.3, 0.07),
            ((0, 9.9, 3.75), 0.7, 0.04),
        ]
        _wing(b, body, stations, upright=True)
        b.rounded_box(dark, (1.12, 4.3, 0.1), (0.16, 0.8, 1.5), 0.06)
        b.rounded_box(glass, (1.17, 4.3, 0.45), (0.12, 0.34, 0.4), 0.04)
    ground = -0.0
    with b.at(scale=scale):
        for s in (-1, 1):
            wheel(b, tyre, chrome, (s * 2.9, -3.2, 0.56), 0.56, 0.36)
            for dx in (-0.28, 0.28):
                b.cylinder(chrome, (s * 2.9 + dx, -3.2, 0.56), (s * 2.9 + dx, -2.9, 2.3), 0.07, segments=8)
            b.cylinder(chrome, (s * 2.9, -3.1, 0.9), (s * 2.9, -1.9, 2.1), 0.05, segments=8)
        wheel(b, tyre, chrome, (0, 9.2, 0.22 + ground), 0.22, 0.14)
        b.cylinder(chrome, (0, 9.2, 0.25), (0, 9.0, 1.6), 0.07, segments=8)
    return (handle((float(1.15 * scale[0]), float(4.4 * scale[1]), float(1.6 * scale[2])), (1, 0, 0), "door"),)


def _engine(b: MeshBuilder, body: MaterialRef, dark: MaterialRef, chrome: MaterialRef, s: int) -> None:
    """Add a radial engine with its three-bladed propeller on the side ``s``."""
    angle = np.linspace(0, math.tau, 24, endpoint=False)
    x, y, z = s * 2.9, -3.0, -0.55
    rows = [
        np.c_[x + r * np.sin(angle), np.full(24, y + at), z + r * np.cos(angle)]
        for at, r in ((2.8, 0.25), (1.2, 0.6), (-0.2, 0.72), (-1.3, 0.74), (-1.75, 0.66))
    ]
    b.loft(body, rows)
    profile = [(0.64, 0), (0.6, -0.05), (0.3, 0.0), (0.2, 0.14)]
    b.lathe(dark, profile, origin=(x, y - 1.72, z), axis=(0, -1, 0), segments=24)
    for k in range(9):
        turn = math.tau * k / 9
        start = (x + 0.2 * math.sin(turn), y - 1.76, z + 0.2 * math.cos(turn))
        b.cylinder(chrome, start, (x + 0.55 * math.sin(turn), y - 1.76, z + 0.55 * math.cos(turn)), 0.07, segments=8)
    b.lathe(chrome, [(0.2, 0), (0.16, 0.25), (0.03, 0.42)], origin=(x, y - 1.8, z), axis=(0, -1, 0), segments=16)
    for k in range(3):
        with b.at((x, y - 1.95, z), (0, 120 * k + 25 + 15 * s, 0)), b.at(rotation=(0, 0, 18)):
            rings = [
                np.array([(-wd, -th, at), (wd, -th, at), (wd, th, at), (-wd, th, at)])
                for at, wd, th in ((0.1, 0.07, 0.05), (0.5, 0.13, 0.03), (1.2, 0.12, 0.02), (1.65, 0.05, 0.012))
            ]
            b.loft(dark, rings)


@prop("rowing_boat")
def rowing_boat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a clinker boat with thwarts and oars; its bow is at -Y."""
    (w, d, h), hull, inside, oar = spec.size, spec.material("hull"), spec.material("inside"), spec.material("oar")
    shape = np.linspace(0, 1, 15)
    beam = (w / 2 - 0.02) * np.clip(np.sin(np.pi * (0.06 + 0.86 * shape)) ** 0.7, 0.03, 1)
    beam = beam * np.clip(shape / 0.3, 0.03, 1) ** 0.6
    sheer = h * (0.72 + 0.28 * (1 - shape) ** 2 + 0.1 * shape**3)
    keel = h * 0.3 * np.clip(1 - shape / 0.25, 0, 1) ** 2

    def section(k: int, inset: float) -> np.ndarray:
        low, high, half = keel[k] + inset, sheer[k], max(beam[k] - inset, 0.012)
        profile = [(1.0, 1.0), (0.97, 0.72), (0.88, 0.45), (0.68, 0.2), (0.36, 0.05), (0.0, 0.0)]
        right = [(half * x, -d / 2 + d * shape[k], low + (high - low) * z) for x, z in profile]
        return np.array(right + [(-x, y, z) for x, y, z in reversed(right[:-1])])

    b.loft(hull, [section(k, 0.0) for k in range(15)][::-1], closed=False)
    b.loft(inside, [section(k, 0.022) for k in range(15)], closed=False)
    for x in (-1, 1):
        b.tube(inside, [(x * beam[k], -d / 2 + d * shape[k], sheer[k]) for k in range(15)], 0.024, segments=8)
        path = [
            (x * (beam[k] * 0.99 + 0.004), -d / 2 + d * shape[k], keel[k] + (sheer[k] - keel[k]) * 0.66)
            for k in range(15)
        ]
        b.tube(hull, path, 0.012, segments=6)
    b.polygon(hull, section(14, 0.0))
    b.polygon(inside, section(14, 0.02)[::-1])
    for y, z in ((-0.2, 0.42), (0.04, 0.4), (0.36, 0.42)):
        half = float(np.interp(y + 0.5, shape, beam)) * 0.93
        b.box(inside, (0, y * d, h * z), (2 * half, 0.24, 0.03), bevel=0.006)
    for x in (-1, 1):
        b.cylinder("iron", (x * w * 0.47, 0.0, h * 0.7), (x * w * 0.47, 0.0, h * 0.84), 0.012, segments=8)
        b.cylinder(oar, (x * 0.16, 0.3, h * 0.5), (x * w * 0.34, -d * 0.42, h * 0.72), 0.02, segments=8)
        b.box(oar, (x * w * 0.345, -d * 0.44, h * 0.725), (0.14, 0.5, 0.014), bevel=0.004, rotation=(0, 0, -x * 6))
    rower = seat((0, d * 0.04 + 0.12, h * 0.42), (w * 0.7, 0.24), (0, 1, 0), "rower")
    return (rower, seat((0, d * 0.36 - 0.12, h * 0.44), (w * 0.6, 0.24), (0, -1, 0), "stern"))


def _handlebars(b: MeshBuilder, metal: MaterialRef, y: float, z: float, width: float) -> Anchors:
    """Add handlebars whose stem is at ``y`` and ``z``; return the grips of both hands."""
    bar = [
        (width * x, y + t, z + up)
        for x, t, up in ((-0.5, 0.16, 0), (-0.4, 0.02, 0.02), (0, 0, -0.02), (0.4, 0.02, 0.02), (0.5, 0.16, 0))
    ]
    b.tube(metal, bar, 0.012)
    grips: list = []
    for name, x in (("grip_r", -1), ("grip_l", 1)):
        b.cylinder("rubber", (x * width * 0.46, y + 0.08, z + 0.005), (x * width / 2, y + 0.17, z), 0.017, segments=10)
        grips.append(
            grip(name, (x * width * 0.48, y + 0.12, z + 0.02), (0, -0.9, -0.4), (0, -0.3, -0.95), (0.85, 0.85, 0.5))
        )
    return tuple(grips)


@prop("bicycle")
def bicycle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bicycle on its stand."""
    (w, d, h), frame, tyre, metal = spec.size, spec.material("frame"), spec.material("tyre"), spec.material("metal")
    r = 0.33
    front, rear = -d / 2 + r, d / 2 - r
    for y in (front, rear):
        spoked_wheel(b, tyre, metal, (0, y, r), r - 0.017, 0.017, 14)
        arc = [(0, y + (r + 0.03) * math.cos(a), r + (r + 0.03) * math.sin(a)) for a in np.linspace(0.2, 2.4, 11)]
        b.tube(frame, arc, 0.014, segments=6)
    crank, head, post = (0, 0.06, 0.28), (0, front + 0.2, 0.82), (0, 0.24, 0.8)
    for a, c in (
        (crank, head),
        (crank, post),
        ((0, front + 0.17, 0.88), post),
        ((0, front + 0.21, 0.76), (0, front + 0.15, 0.94)),
        (post, (0, 0.28, 0.92)),
    ):
        b.cylinder(frame, a, c, 0.017, segments=10)
    for x in (-0.05, 0.05):
        for a, c in (((x, rear, r), crank), ((x, rear, r), post), ((x, front, r), (x * 0.6, front + 0.2, 0.78))):
            b.cylinder(frame, a, c, 0.009, segments=8)
    ring = [
        (0.06, 0.06 + 0.09 * math.cos(a), 0.28 + 0.09 * math.sin(a))
        for a in np.linspace(0, math.tau, 20, endpoint=False)
    ]
    b.tube(metal, ring, 0.006, segments=6, closed=True)
    for x in (-1, 1):
        b.cylinder(metal, (x * 0.07, 0.06, 0.28), (x * 0.09, 0.06 + x * 0.11, 0.28 - x * 0.1), 0.009, segments=8)
        b.box("rubber", (x * 0.13, 0.06 + x * 0.11, 0.28 - x * 0.1), (0.09, 0.05, 0.025), bevel=0.005)
    b.tube(metal, [(0.05, 0.1, 0.26), (0.12, 0.16, 0.01)], 0.008)
    b.cushion(spec.material("saddle"), (0, 0.3, 0.95), (0.17, 0.27, 0.07), softness=0.8)
    b.sphere(metal, (0, front + 0.02, 0.86), 0.05, scale=(1, 1.2, 1), segments=14, rings=8)
    return _handlebars(b, metal, front + 0.12, h - 0.03, w)


@prop("motorcycle")
def motorcycle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a motorcycle on its stand."""
    (w, d, h), body, tyre, metal = spec.size, spec.material("body"), spec.material("tyre"), spec.material("metal")
    r = 0.34
    front, rear = -d / 2 + r, d / 2 - r
    for y in (front, rear):
        spoked_wheel(b, tyre, metal, (0, y, r), r - 0.05, 0.05, 12)
        b.cushion(body, (0, y + 0.04 * (1 if y > 0 else 0), r + 0.16), (0.17, 0.66, 0.44), softness=0.7)
    b.cushion(body, (0, -0.16, 0.82), (0.3, 0.62, 0.28), softness=0.7)
    b.cushion(spec.material("saddle"), (0, 0.34, 0.8), (0.28, 0.6, 0.14), softness=0.5)
    b.rounded_box(metal, (0, -0.02, 0.44), (0.26, 0.46, 0.3), 0.06)
    for y, tilt in ((-0.16, 20), (0.08, -20)):
        with b.at((0, y, 0.56), (tilt, 0, 0)):
            for k in range(5):
                b.rounded_box("iron", (0, 0, 0.035 * k), (0.16, 0.15, 0.022), 0.008)
    for x in (-1, 1):
        path = [(x * 0.08, -0.2, 0.5), (x * 0.16, -0.26, 0.3), (x * 0.18, 0.2, 0.26), (x * 0.18, d / 2 - 0.05, 0.3)]
        b.tube(metal, path, (0.025, 0.03, 0.04, 0.045))
        b.cylinder(metal, (x * 0.09, front, r), (x * 0.08, front + 0.32, 0.98), 0.022, segments=10)
        b.cylinder("iron", (x * 0.1, rear, r), (x * 0.12, 0.44, 0.74), 0.022, segments=10)
    profile = [(0.05, -0.1), (0.1, -0.04), (0.105, 0.02), (0.09, 0.03)]
    b.lathe(metal, profile, origin=(0, front + 0.16, 0.92), axis=(0, -1, 0), segments=20)
    profile = [(0.09, 0.028), (0.003, 0.05)]
    b.lathe(spec.material("lamp"), profile, origin=(0, front + 0.16, 0.92), axis=(0, -1, 0), segments=18)
    b.cylinder("iron", (0.1, 0.1, 0.3), (0.24, 0.2, 0.0), 0.014, segments=8)
    return (seat((0, 0.08, 0.85), (0.28, 0.4)), *_handlebars(b, metal, front + 0.36, h - 0.02, w))


@prop("cart")
def cart(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cart whose shafts reach to -Y."""
    (w, d, h), body, iron = spec.size, spec.material("body"), spec.material("iron")
    r = 0.55
    bed, rear = d * 0.54, d / 2
    middle = rear - bed / 2
    floor = r + 0.12
    wide = w - 0.36
    b.box(body, (0, middle, floor), (wide, bed, 0.06), bevel=0.008)
    for x in (-1, 1):
        spoked_wheel(
            b, spec.material("wheel"), spec.material("wheel"), (x * (w / 2 - 0.06), middle, r), r - 0.03, 0.035, 10
        )
        for k in range(3):
            b.box(body, (x * (wide / 2 - 0.02), middle, floor + 0.14 + 0.2 * k), (0.035, bed, 0.15), bevel=0.006)
        for y in (-0.42, 0, 0.42):
            center = (x * (wide / 2 + 0.01), middle + y * bed, floor + 0.3)
            b.box(body, center, (0.05, 0.07, h - floor - 0.08), bevel=0.008)
        path = [
            (x * wide * 0.42, rear - 0.2, floor - 0.08),
            (x * wide * 0.42, middle - bed / 2, floor - 0.05),
            (x * wide * 0.36, -d / 2, floor + 0.1),
        ]
        b.tube(body, path, 0.035, segments=8)
    for y in (rear - 0.02, rear - bed + 0.02):
        for k in range(2):
            b.box(body, (0, y, floor + 0.14 + 0.2 * k), (wide - 0.06, 0.035, 0.15), bevel=0.006)
    b.cylinder(iron, (-w / 2 + 0.02, middle, r), (w / 2 - 0.02, middle, r), 0.035, segments=10)
    b.box(body, (0, middle - 0.3, floor - 0.09), (0.1, 0.1, 0.14))
    return (lean((0, -d / 2, floor + 0.1), wide * 0.7, name="shafts"),)


@prop("pram")
def pram(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a baby carriage; it is pushed from +Y."""
    (w, d, h), body, metal, tyre = spec.size, spec.material("body"), spec.material("metal"), spec.material("tyre")
    rings = []
    for t, s, z in ((-0.36, 0.72, 0.62), (-0.3, 0.9, 0.5), (-0.1, 1.0, 0.42), (0.15, 1.0, 0.44), (0.26, 0.86, 0.54)):
        half = w * 0.38 * s
        rings.append(
            np.array([(-half, t * d, 0.72), (-half * 0.9, t * d, z), (half * 0.9, t * d, z), (half, t * d, 0.72)])
        )
    b.loft(body, rings)
    hood = []
    for a in np.linspace(-10, 95, 8):
        c, s = math.cos(math.radians(a)), math.sin(math.radians(a))
        arc = [
            (w * 0.4 * math.cos(t), -0.04 + d * 0.32 * c * math.sin(t), 0.7 + d * 0.32 * s * math.sin(t))
            for t in np.linspace(0, math.pi, 11)
        ]
        hood.append(np.array(arc))
    b.loft(body, hood, closed=False)
    b.loft(body, [ring + np.array([0, 0, -0.01]) for ring in hood[::-1]], closed=False)
    b.cushion("linen", (0, 0.06, 0.73), (w * 0.62, d * 0.36, 0.1), softness=0.6)
    for x in (-1, 1):
        for y in (-d * 0.3, d * 0.18):
            spoked_wheel(b, tyre, metal, (x * (w / 2 - 0.02), y, 0.19), 0.175, 0.014, 8)
        line = [(x * w * 0.36, -d * 0.3, 0.19), (x * w * 0.36, -0.06, 0.4), (x * w * 0.36, d * 0.18, 0.19)]
        b.tube(metal, line, 0.01)
        path = [(x * w * 0.38, 0.1, 0.6), (x * w * 0.38, d * 0.36, 0.9), (x * w * 0.3, d / 2 - 0.02, h - 0.02)]
        b.tube(metal, path, 0.011)
    b.cylinder("rubber", (-w * 0.3, d / 2 - 0.02, h - 0.02), (w * 0.3, d / 2 - 0.02, h - 0.02), 0.016, segments=10)
    right = grip("grip_r", (-w * 0.2, d / 2, h), (0.0, -0.6, -0.8), (0, -0.5, -0.85), (0.85, 0.85, 0.5))
    left = grip("grip_l", (w * 0.2, d / 2, h), (0.0, -0.6, -0.8), (0, -0.5, -0.85), (0.85, 0.85, 0.5))
    return (right, left)
