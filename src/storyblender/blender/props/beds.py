"""Prop builders: beds, bath and toilet, screens. A bed's head is at +Y."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, bed_anchor, seat
from storyblender.blender.props.parts import turned_leg
from storyblender.blender.props.registry import PropSpec, prop


def _bedding(
    b: MeshBuilder, linen: MaterialRef, blanket: MaterialRef, width: float, length: float, top: float, pillows: int
) -> None:
    """Add a mattress, a blanket turned down at the head, and pillows; ``top`` is the lying height."""
    b.rounded_box(linen, (0, 0, top - 0.1), (width, length, 0.2), 0.05)
    b.rounded_box(blanket, (0, -length * 0.14, top - 0.055), (width + 0.05, length * 0.74, 0.15), 0.05)
    b.rounded_box(linen, (0, length * 0.2, top + 0.012), (width + 0.045, length * 0.13, 0.03), 0.014)
    for i in range(pillows):
        x = (i - (pillows - 1) / 2) * width / pillows
        center = (x, length / 2 - 0.24, top + 0.06)
        b.cushion(linen, center, (width / pillows * 0.86, 0.4, 0.16), softness=0.5, rotation=(10, 0, 0))


@prop("bed")
def bed(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wooden bed."""
    (w, d, h), wood = spec.size, spec.material("frame")
    top = 0.54
    b.box(wood, (0, d / 2 - 0.03, h * 0.56), (w - 0.06, 0.045, h * 0.74), bevel=0.012)
    b.box(wood, (0, d / 2 - 0.03, h - 0.03), (w, 0.07, 0.06), bevel=0.015)
    b.box(wood, (0, d / 2 - 0.058, h * 0.72), (w - 0.3, 0.02, h * 0.3), bevel=0.008)
    b.box(wood, (0, -d / 2 + 0.025, 0.4), (w - 0.06, 0.04, 0.36), bevel=0.012)
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.035), d / 2 - 0.035, h / 2), (0.07, 0.07, h), bevel=0.012)
        b.box(wood, (x * (w / 2 - 0.035), -d / 2 + 0.035, 0.31), (0.07, 0.07, 0.62), bevel=0.012)
        b.sphere(wood, (x * (w / 2 - 0.035), -d / 2 + 0.035, 0.65), 0.045)
        b.box(wood, (x * (w / 2 - 0.03), 0, 0.3), (0.03, d - 0.12, 0.16), bevel=0.006)
    _bedding(b, spec.material("linen"), spec.material("blanket"), w - 0.1, d - 0.14, top, spec.count("pillows"))
    edge = seat((w / 2 - 0.02, -0.1, top), (d * 0.6, 0.6), (1, 0, 0), "edge_right")
    other = seat((-w / 2 + 0.02, -0.1, top), (d * 0.6, 0.6), (-1, 0, 0), "edge_left")
    return (bed_anchor((0, 0, top + 0.02), w - 0.1, d - 0.14), edge, other)


@prop("hospital_bed")
def hospital_bed(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hospital bed with tube ends and side rails."""
    (w, d, h), metal = spec.size, spec.material("metal")
    top = 0.62
    for y, tall in ((d / 2 - 0.03, h), (-d / 2 + 0.03, h - 0.15)):
        arch = [
            (-w / 2 + 0.03, y, 0.1), (-w / 2 + 0.03, y, tall - 0.1), (-w / 2 + 0.12, y, tall - 0.02),
            (w / 2 - 0.12, y, tall - 0.02), (w / 2 - 0.03, y, tall - 0.1), (w / 2 - 0.03, y, 0.1),
        ]  # fmt: skip
        b.tube(metal, arch, 0.02)
        for x in np.linspace(-w * 0.32, w * 0.32, 5):
            b.cylinder(metal, (x, y, 0.42), (x, y, tall - 0.03), 0.009, segments=8)
        b.cylinder(metal, (-w / 2 + 0.03, y, 0.42), (w / 2 - 0.03, y, 0.42), 0.014)
        for x in (-1, 1):
            profile = [(0.03, -0.015), (0.05, -0.012), (0.05, 0.012), (0.03, 0.015)]
            b.lathe("rubber", profile, origin=(x * (w / 2 - 0.03), y, 0.05), axis=(1, 0, 0))
    for x in (-1, 1):
        side = x * (w / 2 - 0.03)
        b.box(metal, (side, 0, 0.42), (0.03, d - 0.06, 0.06), bevel=0.005)
        rail = [(side, -d * 0.16, 0.44), (side, -d * 0.12, 0.8), (side, d * 0.26, 0.8), (side, d * 0.3, 0.44)]
        b.tube(metal, rail, 0.012)
        b.cylinder(metal, (side, -d * 0.13, 0.68), (side, d * 0.27, 0.68), 0.009, segments=8)
    _bedding(b, spec.material("linen"), spec.material("blanket"), w - 0.14, d - 0.14, top, 1)
    return (
        bed_anchor((0, 0, top + 0.02), w - 0.14, d - 0.14),
        seat((w / 2 - 0.04, -d * 0.32, top), (0.5, 0.5), (1, 0, 0), "edge"),
    )


@prop("bunk_bed")
def bunk_bed(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build bunks with a ladder at the foot."""
    (w, d, h), metal = spec.size, spec.material("frame")
    for x in (-1, 1):
        for y in (-1, 1):
            foot, tip = (x * (w / 2 - 0.025), y * (d / 2 - 0.025), 0), (x * (w / 2 - 0.025), y * (d / 2 - 0.025), h)
            b.cylinder(metal, foot, tip, 0.025)
    for low in (0.34, h - 0.42):
        for x in (-1, 1):
            b.box(metal, (x * (w / 2 - 0.025), 0, low), (0.03, d - 0.05, 0.06))
        for y in (-1, 1):
            for z in (0, 0.3):
                start, end = (-w / 2 + 0.03, y * (d / 2 - 0.025), low + z), (w / 2 - 0.03, y * (d / 2 - 0.025), low + z)
                b.cylinder(metal, start, end, 0.015)
        with b.at((0, 0, low - 0.34)):
            _bedding(b, spec.material("linen"), spec.material("blanket"), w - 0.08, d - 0.1, 0.5, 1)
    for x in (-0.14, 0.14):
        b.cylinder(metal, (x, -d / 2, 0.05), (x, -d / 2, h - 0.1), 0.014)
    for z in np.arange(0.3, h - 0.2, 0.28):
        b.cylinder(metal, (-0.14, -d / 2, z), (0.14, -d / 2, z), 0.012)
    lower = seat((w / 2 - 0.02, -0.1, 0.5), (d * 0.6, 0.5), (1, 0, 0), "edge")
    return (
        bed_anchor((0, 0, 0.52), w - 0.08, d - 0.1, "lower"),
        bed_anchor((0, 0, h - 0.24), w - 0.08, d - 0.1, "upper"),
        lower,
    )


@prop("cradle")
def cradle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cot with bars."""
    (w, d, h), wood, linen = spec.size, spec.material("frame"), spec.material("linen")
    for x in (-1, 1):
        for y in (-1, 1):
            turned_leg(b, wood, x * (w / 2 - 0.03), y * (d / 2 - 0.03), h, 0.028)
        for z in (0.32, h - 0.06):
            b.box(wood, (x * (w / 2 - 0.03), 0, z), (0.025, d - 0.06, 0.045), bevel=0.006)
            b.box(wood, (0, x * (d / 2 - 0.03), z), (w - 0.06, 0.025, 0.045), bevel=0.006)
        for y in np.linspace(-d / 2 + 0.1, d / 2 - 0.1, 9):
            b.cylinder(wood, (x * (w / 2 - 0.03), y, 0.33), (x * (w / 2 - 0.03), y, h - 0.07), 0.008, segments=6)
        for at in np.linspace(-w / 2 + 0.1, w / 2 - 0.1, 5):
            b.cylinder(wood, (at, x * (d / 2 - 0.03), 0.33), (at, x * (d / 2 - 0.03), h - 0.07), 0.008, segments=6)
    b.rounded_box(linen, (0, 0, 0.38), (w - 0.09, d - 0.09, 0.1), 0.03)
    b.cushion(linen, (0, d / 2 - 0.2, 0.46), (0.34, 0.22, 0.09), softness=0.5)
    return (bed_anchor((0, 0, 0.43), w - 0.1, d - 0.1),)


@prop("bathtub")
def bathtub(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a roll-top bath on feet; taps at +Y."""
    (w, d, full), body, metal = spec.size, spec.material("body"), spec.material("metal")
    h = full - 0.12  # the taps stand over the rim
    around = np.linspace(0, 2 * math.pi, 40, endpoint=False)

    def ring(reach: float, z: float) -> np.ndarray:
        """Return an oval of the tub at height ``z``; ``reach`` is its share of the tub's outline."""
        power = 0.62
        x = np.sign(np.cos(around)) * np.abs(np.cos(around)) ** power * (w / 2) * reach
        y = np.sign(np.sin(around)) * np.abs(np.sin(around)) ** power * (d / 2 - (w / 2) * (1 - reach))
        return np.c_[x, y, np.full(len(around), z)]

    levels = [
        (0.5, 0.12), (0.66, 0.16), (0.82, 0.32), (0.9, h - 0.05), (0.97, h - 0.03), (1.0, h - 0.01), (0.97, h),
        (0.88, h - 0.02), (0.8, h - 0.08), (0.72, 0.32), (0.58, 0.2), (0.4, 0.18),
    ]  # fmt: skip
    b.loft(body, [ring(*level) for level in levels])
    for x in (-1, 1):
        for y in (-1, 1):
            path = np.multiply([(0.24, 0.3, 0.2), (0.33, 0.32, 0.1), (0.3, 0.32, 0.02)], (x * w, y * d, 1))
            b.tube(metal, path, (0.03, 0.025, 0.03))
        profile = [(0.02, 0), (0.02, 0.05), (0.035, 0.06), (0.035, 0.075), (0.01, 0.08)]
        b.lathe(metal, profile, origin=(x * 0.09, d / 2 - 0.05, h - 0.01), segments=12)
    b.tube(metal, [(0, d / 2 - y, h + z) for y, z in ((0.05, -0.01), (0.05, 0.1), (0.13, 0.12), (0.17, 0.07))], 0.014)
    return (bed_anchor((0, 0, 0.22), w * 0.5, d * 0.8),)


@prop("toilet")
def toilet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a toilet with a tank."""
    (w, d, h), body, lid = spec.size, spec.material("body"), spec.material("seat")
    rim = 0.4
    around = np.linspace(0, 2 * math.pi, 28, endpoint=False)

    def bowl(reach: float, z: float, back: float) -> np.ndarray:
        """Return an oval of the bowl at height ``z``, ``reach`` of its full size, moved ``back`` metres."""
        x, y = reach * w * 0.46 * np.cos(around), -d * 0.13 + back + reach * d * 0.33 * np.sin(around)
        return np.c_[x, y, np.full(len(around), z)]

    rings = [bowl(0.5, 0, 0.05), bowl(0.45, 0.1, 0.05), bowl(0.7, 0.26, 0.02), bowl(1, rim - 0.03, 0), bowl(1, rim, 0)]
    b.loft(body, rings)
    b.loft(lid, [bowl(1.02, rim, 0), bowl(1.04, rim + 0.012, 0), bowl(1.0, rim + 0.024, 0)])
    b.rounded_box(body, (0, d / 2 - 0.11, rim - 0.06), (w * 0.6, 0.22, 0.3), 0.03)
    b.rounded_box(body, (0, d / 2 - 0.1, h - 0.2), (w, 0.19, 0.36), 0.03)
    b.rounded_box(body, (0, d / 2 - 0.1, h - 0.015), (w + 0.02, 0.2, 0.03), 0.012)
    b.cylinder("chrome", (-w * 0.36, d / 2 - 0.2, h - 0.09), (-w * 0.2, d / 2 - 0.21, h - 0.1), 0.008)
    return (seat((0, -d / 2 + 0.06, rim + 0.02), (w * 0.8, d * 0.5)),)


@prop("folding_screen")
def folding_screen(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a folding screen of three panels in a zigzag."""
    (w, d, h), frame, panel = spec.size, spec.material("frame"), spec.material("panel")
    span = w / 3
    length = math.hypot(span, d - 0.03)
    turn = math.degrees(math.atan2(d - 0.03, span))
    for i in range(3):
        with b.at(((i - 1) * span, 0, 0), (0, 0, turn if i % 2 == 0 else -turn)):
            for x in (-1, 1):
                b.box(frame, (x * (length / 2 - 0.02), 0, h / 2), (0.035, 0.03, h), bevel=0.005)
            for z in (0.1, h * 0.4, h - 0.03):
                b.box(frame, (0, 0, z), (length - 0.06, 0.026, 0.045), bevel=0.004)
            for x in (-length / 6, length / 6):
                b.box(frame, (x, 0, h * 0.7), (0.014, 0.02, h * 0.58))
            b.box(panel, (0, 0, h / 2 + 0.03), (length - 0.05, 0.008, h - 0.14))
    return ()
