"""Prop builders: books, letters and other flat things. They lie on their backs; the reader is at +Y."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, grip, grips_under, two_hands
from storyblender.blender.props.registry import PropSpec, prop


def _lines(b: MeshBuilder, spec: PropSpec, width: float, depth: float, z: float, rows: int, x: float = 0.0) -> None:
    """Add lines of writing on a page that is read from +Y... towards -Y, so its top is at -Y."""
    for row in range(rows):
        length = width * float(spec.rng.uniform(0.6, 1.0)) if row % 5 != 4 else width * 0.4
        y = -depth / 2 + depth * (row + 0.5) / rows
        b.box("iron", (x + (width - length) / 2, y, z), (length, depth / rows * 0.22, 0.0006))


@prop("book")
def book(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a closed book, or one that lies open."""
    (w, d, h), cover, page = spec.size, spec.material("cover"), spec.material("page")
    if spec.flag("open"):
        for x in (-1, 1):
            b.box(cover, (x * w / 2, 0, 0.003), (w, d, 0.006), bevel=0.001)
            rows = [
                np.array(
                    [
                        (
                            x * w * u * 0.97,
                            y * (d / 2 - 0.006),
                            0.006 + h * 0.55 * (0.35 + 0.65 * math.sin(math.pi * (0.15 + 0.85 * u))),
                        )
                        for u in np.linspace(0, 1, 7)
                    ]
                )
                for y in (-1, 1)
            ]
            b.loft(page, rows if x > 0 else rows[::-1], closed=False)
            b.box(page, (x * w * 0.48, 0, 0.008), (w * 0.95, d - 0.014, 0.008))
        left = grip("grip_l", (w * 0.8, d * 0.25, -0.012), (0.35, -0.9, 0), (0, 0, 1), (0.11, 0.13, 0.0))
        right = grip("grip_r", (-w * 0.8, d * 0.25, -0.012), (-0.35, -0.9, 0), (0, 0, 1), (0.11, 0.13, 0.0))
        return (right, left)
    b.box(cover, (0, 0, 0.002), (w, d, 0.004), bevel=0.001)
    b.box(cover, (0, 0, h - 0.002), (w, d, 0.004), bevel=0.001)
    b.box(cover, (w / 2 - 0.003, 0, h / 2), (0.006, d, h - 0.002), bevel=0.002)
    b.box(page, (-0.003, 0, h / 2), (w - 0.008, d - 0.008, h - 0.008))
    b.box("gold", (0, -d * 0.2, h), (w * 0.6, d * 0.1, 0.0012))
    b.box("gold", (0, 0, h), (w * 0.4, d * 0.03, 0.0012))
    side = two_hands((-w / 2, 0.02, h * 0.5), (0.1, -0.6, -0.8), (1, 0, 0), (0.35, 0.4, 0.3))
    return side + grips_under(d * 0.3, (0.25, 0.3, 0.0))


@prop("letter")
def letter(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a written sheet with folds."""
    (w, d, h), page = spec.size, spec.material("page")
    lift = [0.0, 0.3, 1.0, 0.25, 0.9, 0.1]
    for z, order in ((0.0004, 1), (0.0, -1)):
        rows = [
            np.array([(x * w / 2, d * (k / 5 - 0.5), z + h * up * 0.8) for x in (-1, 1)])[::order]
            for k, up in enumerate(lift)
        ]
        b.loft(page, rows[::-1], closed=False)
    for row in range(13):
        y = -d * 0.38 + d * 0.76 * row / 12
        length = w * (0.76 if row % 5 != 4 else 0.4)
        z = h * 0.8 * float(np.interp(y / d + 0.5, np.linspace(0, 1, 6), lift)) + 0.0006
        b.box(spec.material("ink"), ((length - w * 0.76) / -2, y, z), (length, 0.003, 0.0005))
    return grips_under(d * 0.4)


@prop("envelope")
def envelope(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sealed envelope, its flap up."""
    (w, d, h), page = spec.size, spec.material("page")
    b.box(page, (0, 0, h * 0.35), (w, d, h * 0.7), bevel=0.0008)
    with b.at((0, 0, h * 0.7)):
        b.extrude(page, [(-w / 2, -d / 2), (w / 2, -d / 2), (0, d * 0.12)], 0.0008)
    profile = [(0.013, h * 0.7), (0.013, h * 0.9), (0.01, h)]
    b.lathe(spec.material("seal"), profile, origin=(0, d * 0.06, 0), segments=14)
    return grips_under(d * 0.38)


@prop("photograph")
def photograph(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a print with a white border; its top is at -Y."""
    w, d, h = spec.size
    b.box(spec.material("page"), (0, 0, h * 0.4), (w, d, h * 0.8))
    x, y = w / 2 - 0.008, d / 2 - 0.008
    b.quad(
        spec.material("picture"), (x, -y, h), (x, y, h), (-x, y, h), (-x, -y, h), uv=((0, 1), (0, 0), (1, 0), (1, 1))
    )
    return grips_under(d * 0.38)


@prop("folder")
def folder(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a manila folder with papers showing."""
    (w, d, h), cover = spec.size, spec.material("cover")
    b.box(cover, (0, 0, 0.001), (w, d, 0.002))
    for k in range(3):
        turn = float(spec.rng.uniform(-3, 3))
        center = (-0.008, 0.004 * k, 0.004 + 0.003 * k)
        b.box(spec.material("page"), center, (w * 0.92, d * 0.93, 0.002), rotation=(0, 0, turn))
    b.box(cover, (0, 0, h - 0.001), (w, d, 0.002), rotation=(0, 1.5, 0))
    b.box(cover, (-w / 2 - 0.005, -d * 0.28, 0.001), (0.02, d * 0.25, 0.002))
    b.box("paper", (0, -d * 0.3, h + 0.001), (w * 0.5, d * 0.1, 0.001), rotation=(0, 1.5, 0))
    return grips_under(d * 0.38) + two_hands(
        (-w / 2, 0.0, h * 0.5), (0.1, -0.6, -0.8), (1, 0, 0), (0.4, 0.45, 0.3), "side"
    )


@prop("newspaper")
def newspaper(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a folded newspaper; its headline is at -Y."""
    (w, d, h), page = spec.size, spec.material("page")
    for k in range(4):
        b.box("linen", (0.002 * k, 0.0015 * k, h * (k + 0.5) / 4), (w - 0.004 * k, d, h / 4 * 0.85))
    x, y = w / 2, d / 2
    b.quad(page, (x, -y, h), (x, y, h), (-x, y, h), (-x, -y, h), uv=((0, 1), (0, 0), (1, 0), (1, 1)))
    b.cylinder("linen", (-w / 2, -d / 2, h / 2), (-w / 2, d / 2, h / 2), h * 0.48, segments=10)
    return grips_under(d * 0.4) + two_hands((-w / 2, 0.1, h), (0.2, -0.9, 0.2), (0.7, 0, 0.7), (0.5, 0.55, 0.3), "read")


@prop("scroll")
def scroll(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rolled sheet tied with a ribbon."""
    w, d, _ = spec.size
    r = d / 2
    b.cylinder(spec.material("page"), (-w / 2, 0, r), (w / 2, 0, r), r * 0.94, segments=20, caps=False)
    spiral = [(0.0, r * t / 10 * math.cos(t), r + r * t / 10 * math.sin(t)) for t in np.linspace(2, 9.2, 24)]
    for x in (-1, 1):
        b.tube(spec.material("page"), [(x * (w / 2 - 0.004), y, z) for _, y, z in spiral], 0.0015, segments=4)
    b.cylinder(spec.material("ribbon"), (-0.01, 0, r), (0.01, 0, r), r, segments=20)
    return two_hands((0.0, 0.0, 2 * r), (-0.2, -1, 0), (0, 0.1, -1), (0.7, 0.75, 0.5))


@prop("pen")
def pen(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fountain pen; its nib is at -Y."""
    w, d, _ = spec.size
    r = w / 2
    outline = [(r * 0.6, 0), (r * 0.95, d * 0.06), (r, d * 0.5), (r * 0.8, d * 0.84), (r * 0.6, d * 0.86)]
    b.lathe(spec.material("body"), outline, origin=(0, d / 2, r), axis=(0, -1, 0), segments=12)
    profile = [(r * 0.45, d * 0.86), (r * 0.4, d * 0.92), (0.0004, d)]
    b.lathe(spec.material("metal"), profile, origin=(0, d / 2, r), axis=(0, -1, 0), segments=8)
    b.box(spec.material("metal"), (0, d * 0.32, 2 * r), (0.002, d * 0.28, 0.002))
    return two_hands((-0.02, d * 0.02, 0.02), (0.5, -0.85, -0.2), (0.75, 0.4, -0.5), (0.6, 0.7, 0.6))


@prop("passport")
def passport(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a closed passport."""
    (w, d, h), cover, gold = spec.size, spec.material("cover"), spec.material("metal")
    b.box(cover, (0, 0, h / 2), (w, d, h * 0.9), bevel=0.001)
    b.lathe(gold, [(w * 0.2, 0), (w * 0.2, 0.001)], origin=(0, -d * 0.08, h * 0.92), segments=18)
    for y in (0.22, 0.32):
        b.box(gold, (0, d * y, h * 0.95), (w * 0.6, d * 0.04, 0.001))
    b.box(gold, (0, -d * 0.36, h * 0.95), (w * 0.6, d * 0.05, 0.001))
    return grips_under(d * 0.35)


@prop("money")
def money(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a banded bundle of notes."""
    (w, d, h), page = spec.size, spec.material("page")
    for k in range(6):
        slip = float(spec.rng.uniform(-0.0015, 0.0015))
        b.box(page, (slip, slip, h * (k + 0.5) / 6.2), (w - 0.004, d - 0.004, h / 6 * 0.9))
    b.box(spec.material("band"), (0, 0, h / 2), (w * 0.22, d + 0.001, h), bevel=0.002)
    b.lathe("linen", [(d * 0.22, 0), (d * 0.22, 0.0008)], origin=(-w * 0.3, 0, h * 0.965), segments=18)
    return grips_under(d * 0.4) + two_hands((-w / 2, 0.0, h / 2), (0.2, -1, 0), (1, 0, 0), (0.5, 0.6, 0.3), "side")
