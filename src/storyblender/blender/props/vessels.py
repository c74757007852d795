"""Prop builders: a small ship, a mast, a ship's reactor, and a sledge."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, seat
from storyblender.blender.props.registry import PropSpec, prop


@prop("sailing_ship")
def sailing_ship(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a decked hull with a mast, a furled sail on its yard, a rail and stays."""
    (w, d, h), hull, rope = spec.size, spec.material("hull"), spec.material("rope")
    board = h * 0.22
    rings = []
    for share in np.linspace(0, 1, 15):
        full = math.sin(math.pi * (0.06 + 0.86 * share) ** 0.8) ** 0.6
        half, rise = max(0.02, w / 2 * full), board * (1 + 0.5 * (1 - share) ** 3 + 0.25 * share**4)
        keel = board * 0.5 * (1 - share) ** 4
        y = (share - 0.5) * (d - 0.7) + 0.3
        rings.append([(x * half, y, z) for x, z in (
            (1, rise), (0.94, rise * 0.6), (0.6, keel + 0.12), (0.06, keel), (-0.06, keel), (-0.6, keel + 0.12),
            (-0.94, rise * 0.6), (-1, rise),
        )])  # fmt: skip
    b.loft(hull, rings)
    deck = [[(x * 0.96, y, board * 0.86 + 0.02) for x, y, _ in (ring[0], ring[-1])] for ring in rings[1:]]
    b.loft(spec.material("deck"), deck, closed=False)
    for side in (0, -1):
        b.tube(hull, [ring[side] for ring in rings], 0.035, segments=6)
    b.cylinder(rope, (0, -d / 2 + 0.9, board * 1.3), (0, -d / 2 + 0.03, board * 1.7), 0.05, 0.03)
    b.cylinder(rope, (0, 0, board * 0.8), (0, 0, h), 0.075, 0.045)
    yard = h * 0.8
    b.cylinder(rope, (-w * 0.47, -0.09, yard), (w * 0.47, -0.09, yard), 0.035)
    path = [(x * w * 0.44, -0.12, yard - 0.05 - 0.03 * math.sin(9 * x)) for x in np.linspace(-1, 1, 11)]
    b.tube(spec.material("sail"), path, [0.03, 0.07, 0.09, 0.08, 0.1, 0.09, 0.1, 0.08, 0.09, 0.07, 0.03])
    for x, y in ((w * 0.45, 0.5), (-w * 0.45, 0.5), (0, -d / 2 + 0.1), (0, d / 2 - 0.2)):
        b.cylinder(rope, (0, 0, h * 0.95), (x, y, board * 1.4), 0.01, segments=5)
    return ()


@prop("mast")
def mast(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a mast with a furled sail on its yard."""
    (w, d, h), wood = spec.size, spec.material("wood")
    b.cylinder(wood, (0, 0, 0), (0, 0, h), d / 2, d * 0.36, segments=16)
    for z in (0.3, 0.55, 0.62):
        b.cylinder("iron", (0, 0, h * z), (0, 0, h * z + 0.05), d * 0.5, segments=16)
    for height, share in ((0.6, 1.0), (0.86, 0.62)):
        yard, half = h * height, w / 2 * share
        b.cylinder(wood, (-half, -d * 0.3, yard), (half, -d * 0.3, yard), 0.04)
        sail = [(x * half * 0.9, -d * 0.3, yard - 0.05 - 0.02 * math.sin(9 * x)) for x in np.linspace(-1, 1, 9)]
        b.tube(spec.material("rope"), sail, [0.03, 0.06, 0.08, 0.07, 0.085, 0.07, 0.08, 0.06, 0.03])
    for x in (-1, 1):
        for y in (-d * 0.4, d * 0.4):
            b.cylinder(spec.material("rope"), (0, 0, h * 0.97), (x * w * 0.42, y, 0), 0.012, segments=5)
    return ()


@prop("reactor")
def reactor(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a banded upright core on a plinth, glowing slots all round, pipes from its foot."""
    (w, _, h), body, dark = spec.size, spec.material("body"), spec.material("dark")
    r = w / 2
    b.cylinder(dark, (0, 0, 0), (0, 0, 0.18), r * 0.98, segments=32)
    core = [(0.78, 0.08), (0.8, 0.3), (0.66, 0.34), (0.66, 0.66), (0.8, 0.7), (0.8, 0.9), (0.5, 1.0)]
    b.lathe(body, [(x * r, z * h) for x, z in core], segments=32)
    for z in (0.3, 0.7):
        b.cylinder(dark, (0, 0, z * h - 0.04), (0, 0, z * h + 0.04), r * 0.86, segments=32)
    for k in range(10):
        with b.at((0, 0, 0), (0, 0, 36 * k)):
            b.box(spec.material("glow"), (0, -r * 0.655, h * 0.5), (0.07, 0.03, h * 0.26))
            b.box(dark, (r * 0.2, -r * 0.66, h * 0.5), (0.04, 0.06, h * 0.32))
    for k in range(4):
        with b.at((0, 0, 0), (0, 0, 90 * k + 45)):
            bend = [(0, -r * 0.6, h * 0.93), (0, -r * 0.93, h * 0.88), (0, -r * 0.93, 0.1)]
            b.tube(spec.material("pipe"), bend, 0.05, segments=10)
    return ()


@prop("sledge")
def sledge(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build slats on two runners that curl up at -Y."""
    (w, d, h), wood, metal = spec.size, spec.material("wood"), spec.material("metal")
    for x in (-1, 1):
        side = x * (w / 2 - 0.03)
        line = [(d / 2, 0.02), (-d * 0.34, 0.02), (-d * 0.44, 0.06), (-d / 2 + 0.02, h * 0.55), (-d * 0.44, h - 0.02)]
        b.tube(wood, [(side, y, z + 0.008) for y, z in line], 0.018, segments=8)
        b.box(metal, (side, d * 0.08, 0.006), (0.03, d * 0.82, 0.012))
        for y in (-d * 0.28, d * 0.05, d * 0.38):
            b.box(wood, (side, y, h * 0.45), (0.03, 0.045, h * 0.8))
    for x in np.linspace(-0.4, 0.4, 5):
        b.box(wood, (x * w, d * 0.03, h * 0.86), (w * 0.17, d * 0.92, 0.022), bevel=0.004)
    b.cylinder(wood, (-w / 2 + 0.01, -d * 0.44, h - 0.02), (w / 2 - 0.01, -d * 0.44, h - 0.02), 0.014)
    return (seat((0, -d * 0.15, h * 0.9), (w, d * 0.6)),)
