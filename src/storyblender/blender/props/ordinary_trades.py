"""Prop builders: things of trades and hobbies: bullet, arrow, paper plane, lawn mower, printer, chainsaw."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_pinching, grips_under, handle, two_hands
from storyblender.blender.props.ordinary_hardware import ring_of
from storyblender.blender.props.parts import bent, wheel
from storyblender.blender.props.registry import PropSpec, prop


@prop("bullet")
def bullet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cartridge that stands on its rim."""
    r, h = spec.size[0] / 2, spec.size[2]
    case = [(1, 0), (1, 0.03), (0.86, 0.05), (0.86, 0.08), (0.96, 0.1), (0.92, 0.6)]
    b.lathe(spec.material("case"), [(x * r, z * h) for x, z in case], segments=22)
    tip = bent([(0.86, 0.6), (0.86, 0.68), (0.7, 0.84), (0.36, 0.97), (0.0, 1.0)], 3)
    b.lathe(spec.material("tip"), tip * (r, h), segments=22)
    return grips_pinching(0.0, 0.6 * h)


@prop("arrow")
def arrow(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an arrow that lies along Y, its head to -Y, with three vanes."""
    (_, d, h), shaft = spec.size, spec.material("shaft")
    z = h / 2
    b.cylinder(shaft, (0, d / 2, z), (0, -0.46 * d, z), 0.0035, segments=8)
    point = [(-0.5 * d, 0), (-0.44 * d, 0.4 * h), (-0.455 * d, 0.0), (-0.44 * d, -0.4 * h)]
    for turn in (0, 90):
        with b.at((0, 0, z), (0, turn, 0)), b.at((0, 0, -0.0007)):
            b.extrude(spec.material("head"), [(x, y) for y, x in point], 0.0014)
    for turn in (0, 120, 240):
        with b.at((0, 0, z), (0, turn, 0)), b.at((0, 0, 0), (0, -90, 0)):
            vane = [(0.003, 0.36 * d), (0.48 * h, 0.41 * d), (0.48 * h, 0.475 * d), (0.003, 0.46 * d)]
            b.extrude(spec.material("vane"), vane, 0.001, base=-0.0005)
    return two_hands((-0.006, 0.3 * d, z), (0.3, -0.9, -0.2), (0.9, 0.3, 0.2), (0.75, 0.85, 0.6))


@prop("paper_plane")
def paper_plane(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a folded paper plane, its nose to -Y."""
    (w, d, h), paper = spec.size, spec.material("paper")
    nose, tail = np.array((0, -d / 2, 0.8 * h)), np.array((0, d / 2, 0))
    keel_front, thick = np.array((0, -0.4 * d, 0.5 * h)), np.array((0, 0, 0.001))
    for x in (-1, 1):
        inner, outer = np.array((0.06 * x * w, d / 2, 0.9 * h)), np.array((x * w / 2, d / 2, h))
        wing = np.array([nose, inner, outer])
        b.loft(paper, [wing, wing + thick])
        side = np.array([nose, keel_front, tail, inner])
        b.loft(paper, [side, side + np.array((0.0006 * x, 0, 0))])
    return two_hands((-0.012, 0.05 * d, 0.3 * h), (0.3, -0.9, 0), (0.95, 0.2, 0.1), (0.6, 0.75, 0.6))


@prop("lawn_mower")
def lawn_mower(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lawn mower with an engine on its deck; it is pushed to -Y by the bar at +Y."""
    (w, d, h), body = spec.size, spec.material("body")
    front = -0.2 * d
    deck = [(0.98, 0.0), (1, 0.04), (0.96, 0.16), (0.6, 0.2), (0.0, 0.21)]
    with b.at((0, front, 0.09), scale=(0.44 * w, 0.27 * d, 1)):
        b.lathe(body, deck, segments=32)
    b.box(body, (0, front + 0.24 * d, 0.16), (0.6 * w, 0.16 * d, 0.12), bevel=0.02)
    for y, r in ((-0.2, 0.1), (0.22, 0.12)):
        b.cylinder("iron", (-0.46 * w, front + y * d, r), (0.46 * w, front + y * d, r), 0.014, segments=8)
        for x in (-1, 1):
            wheel(b, "rubber", "steel", (0.46 * x * w, front + y * d, r), r, 0.045)
    b.lathe("plastic_black", [(0.13, 0.28), (0.13, 0.36), (0.1, 0.38)], origin=(0, front, 0), segments=24)
    b.rounded_box("iron", (0, front - 0.13, 0.34), (0.13, 0.12, 0.1), 0.015)
    for k in range(4):
        b.box("iron", (0, front - 0.13, 0.305 + 0.022 * k), (0.16, 0.14, 0.006))
    b.lathe("iron", [(0.09, 0.38), (0.09, 0.41), (0.05, 0.43)], origin=(0, front, 0), segments=20)
    b.cushion("fabric_red", (0.07, front + 0.1, 0.37), (0.12, 0.1, 0.08), softness=0.4)
    with b.at((0, front + 0.32 * d, 0.32), (16, 0, 0)):
        b.cushion(spec.material("bag"), (0, 0.06, -0.04), (0.56 * w, 0.3 * d, 0.24), softness=0.35)
    bar = [(-0.42 * w, front + 0.2 * d, 0.2), (-0.4 * w, 0.42 * d, 0.92 * h), (-0.36 * w, d / 2 - 0.02, h - 0.02)]
    mirrored = [(-x, y, z) for x, y, z in bar[::-1]]
    b.tube("chrome", [*bar, *mirrored], 0.012)
    b.cylinder("rubber", (-0.3 * w, d / 2 - 0.02, h - 0.02), (0.3 * w, d / 2 - 0.02, h - 0.02), 0.018)
    return (handle((0.0, d / 2 - 0.02, h - 0.02), (0, 1, 0)),)


@prop("printer")
def printer(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an office printer, paper behind, a page in the tray at -Y."""
    (w, d, h), body, dark = spec.size, spec.material("body"), "plastic_black"
    tall = 0.72 * h
    b.rounded_box(body, (0, 0.06 * d, tall / 2), (w, 0.8 * d, tall), 0.02)
    b.box(dark, (0, -0.35 * d, 0.42 * tall), (0.8 * w, 0.02 * d, 0.3 * tall))
    b.box(dark, (0, -0.4 * d, 0.18 * tall), (0.72 * w, 0.22 * d, 0.012))
    page = [(-0.2, 0.34), (-0.34, 0.3), (-0.49, 0.22)]
    sheet = bent([(0, y * d, z * tall) for y, z in page], 4)
    side = np.array((0.3 * w, 0, 0))
    rings = [np.array([at - side, at + side, at + side + (0, 0, 0.001), at - side + (0, 0, 0.001)]) for at in sheet]
    b.loft("paper", rings)
    with b.at((0, 0.38 * d, 0.86 * tall), (-18, 0, 0)):
        b.box(dark, (0, 0.02, 0.1 * h), (0.7 * w, 0.008, 0.34 * h))
        b.box("paper", (0, 0.012, 0.14 * h), (0.6 * w, 0.008, 0.38 * h))
    b.box(dark, (0, -0.1 * d, tall), (0.9 * w, 0.3 * d, 0.006), bevel=0.002)
    b.box("screen", (-0.28 * w, -0.1 * d, tall + 0.003), (0.2 * w, 0.16 * d, 0.004))
    for k in range(4):
        start, end = ((0.02 + 0.1 * k) * w, -0.1 * d, tall), ((0.02 + 0.1 * k) * w, -0.1 * d, tall + 0.008)
        b.cylinder("fabric_green" if k == 3 else "steel", start, end, 0.012)
    return grips_under(0.4 * d)


@prop("chainsaw")
def chainsaw(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a chainsaw, its bar to -Y, with a front and a rear handle."""
    (w, d, h), body, bar = spec.size, spec.material("body"), spec.material("bar")
    b.rounded_box(body, (0.04 * w, 0.16 * d, 0.4 * h), (0.66 * w, 0.3 * d, 0.56 * h), 0.03)
    b.rounded_box("plastic_black", (0.36 * w, 0.14 * d, 0.36 * h), (0.12 * w, 0.22 * d, 0.36 * h), 0.015)
    turn = np.linspace(-math.pi / 2, math.pi / 2, 9)
    half = 0.17 * h
    tip = [(-0.5 * d + half - half * math.cos(t), 0.3 * h + half * math.sin(t)) for t in turn]
    with b.at((-0.3 * w - 0.003, 0, 0), (90, 0, 90)):
        b.extrude(bar, [(0.16 * d, 0.3 * h - half), *tip, (0.16 * d, 0.3 * h + half)], 0.006)
    for k in range(24):
        y = 0.06 * d - 0.5 * d * k / 23
        for z in (-half, half):
            b.box("iron", (-0.3 * w, y, 0.3 * h + z), (0.012, 0.012, 0.012), taper=0.7)
    hoop = np.multiply([(-0.42, 0.1, 0.12), (-0.44, 0.06, 0.8), (0, 0.04, 0.98), (0.42, 0.08, 0.7)], (w, d, h))
    b.tube("plastic_black", bent(hoop, 5), 0.011)
    rear = np.multiply([(0, 0.3, 0.6), (0, 0.44, 0.58), (0, 0.48, 0.4), (0, 0.44, 0.18), (0, 0.3, 0.16)], (1, d, h))
    b.tube(body, bent(rear, 5), 0.016)
    b.tube("plastic_black", ring_of(0.02, 12) + np.array((0.3 * w, 0.16 * d, 0.72 * h)), 0.004, closed=True)
    return two_hands((-0.016, 0.4 * d, 0.58 * h), (0.15, -0.6, -0.75), (1, 0.1, 0), FIST)
