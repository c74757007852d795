"""Prop builders: weapons and long-handled tools. Firearms point to -Y; long things stand with their head up."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_on_shaft, two_hands
from storyblender.blender.props.registry import PropSpec, prop


@prop("gun")
def gun(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an automatic pistol, or a revolver."""
    (w, d, h), body, handle = spec.size, spec.material("body"), spec.material("grip")
    back, top = d / 2, h
    stock = [
        (back - 0.005, 0.0), (back - 0.045, 0.004), (back - 0.058, h * 0.6), (back - 0.008, h * 0.66),
        (back - 0.018, h * 0.4),
    ]  # fmt: skip
    with b.at((-w * 0.4, 0, 0), (90, 0, 90)):
        b.extrude(handle, stock, w * 0.8)
    if spec.flag("revolver"):
        b.box(body, (0, back - 0.06, top - 0.035), (w * 0.6, 0.1, 0.045), bevel=0.006)
        b.cylinder(body, (0, back - 0.04, top - 0.032), (0, back - 0.085, top - 0.032), 0.02, segments=12)
        b.cylinder(body, (0, back - 0.08, top - 0.022), (0, -d / 2, top - 0.02), 0.0095, segments=12)
        b.box(body, (0, -d / 2 + 0.012, top - 0.006), (0.004, 0.014, 0.01))
        b.box(body, (0, back - 0.012, top - 0.012), (0.008, 0.016, 0.02), rotation=(30, 0, 0))
    else:
        b.box(body, (0, 0, top - 0.018), (w, d, 0.034), bevel=0.005)
        b.box(body, (0, -0.005, top - 0.044), (w * 0.8, d * 0.86, 0.022), bevel=0.004)
        b.cylinder(
            "plastic_black", (0, -d / 2 - 0.001, top - 0.016), (0, -d / 2 + 0.01, top - 0.016), 0.007, segments=12
        )
        for k in range(5):
            b.box("plastic_black", (0, back - 0.014 - 0.006 * k, top - 0.016), (w + 0.001, 0.002, 0.024))
        b.box(body, (0, -d / 2 + 0.012, top), (0.004, 0.008, 0.006))
    guard = [(0, back - y, h * z) for y, z in ((0.058, 0.64), (0.07, 0.45), (0.1, 0.47), (0.105, 0.66))]
    b.tube(body, guard, 0.003, segments=6)
    b.tube(body, [(0, back - 0.075, h * 0.66), (0, back - 0.078, h * 0.53)], 0.0025, segments=6)
    hold = two_hands((-0.004, back - 0.008, h * 0.34), (0.06, -1, 0), (1, 0.1, 0), (0.22, 0.98, 0.22))
    return hold + two_hands(
        (0.03, back - 0.04, h * 0.12), (-0.35, -1, 0.05), (-1, 0.1, 0.25), (0.87, 0.89, 0.22), "support"
    )


@prop("rifle")
def rifle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bolt-action rifle."""
    (w, d, h), body, wood = spec.size, spec.material("body"), spec.material("stock")
    back, bore = d / 2, h * 0.78
    butt = [(back - x, h * z) for x, z in ((0, 0), (0.02, 0.62), (0.26, 0.7), (0.34, 0.74), (0.34, 0.48), (0.24, 0.4))]
    with b.at((-0.02, 0, 0), (90, 0, 90)):
        b.extrude(wood, butt, 0.04)
    b.box(wood, (0, -0.02, bore - 0.03), (0.042, 0.62, 0.045), bevel=0.012)
    b.cylinder(body, (0, 0.2, bore), (0, -d / 2, bore), 0.015, 0.009, segments=12)
    b.cylinder(body, (0, 0.24, bore), (0, 0.05, bore), 0.019, segments=12)
    b.tube(body, [(0, 0.17, bore), (-w / 2, 0.17, bore - 0.01), (-w / 2, 0.19, bore - 0.03)], 0.006)
    b.box(body, (0, -d / 2 + 0.03, bore + 0.02), (0.004, 0.02, 0.025))
    b.box(body, (0, 0.02, bore + 0.024), (0.016, 0.03, 0.016), bevel=0.003)
    path = [(0, 0.22, bore - 0.05), (0, 0.2, h * 0.36), (0, 0.12, h * 0.38), (0, 0.1, bore - 0.05)]
    b.tube(body, path, 0.004, segments=6)
    for y in (-0.3, -0.14):
        b.box(body, (0, y, bore - 0.02), (0.046, 0.016, 0.062), bevel=0.006)
    hold = two_hands((-0.016, 0.25, h * 0.52), (0.1, -0.9, -0.3), (1, 0.1, 0), (0.3, 0.95, 0.4))
    return hold + two_hands((0.0, -0.1, bore - 0.06), (-0.5, -0.8, 0.1), (0, 0, 1), (0.6, 0.65, 0.4), "support")


@prop("knife")
def knife(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a knife."""
    (w, d, _), handle, blade = spec.size, spec.material("handle"), spec.material("blade")
    b.cushion(handle, (0, d * 0.32, w / 2), (w * 0.7, d * 0.37, w), softness=0.4)
    b.box(blade, (0, d * 0.13, w / 2), (w * 0.8, 0.01, w), bevel=0.002)
    edge = np.multiply([(0.13, 0.08), (-0.34, 0.06), (-0.5, 0.62), (-0.36, 0.92), (0.13, 0.92)], (d, w))
    with b.at((-0.0012, 0, 0), (90, 0, 90)):
        b.extrude(blade, edge, 0.0024)
    return two_hands((-0.012, d * 0.32, w * 0.5), (0.15, -0.5, -0.85), (1, 0.1, 0), FIST)


@prop("sword")
def sword(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a straight sword."""
    (w, d, h), handle, blade, guard = spec.size, spec.material("handle"), spec.material("blade"), spec.material("guard")
    mid, hilt = h / 2, d / 2 - 0.2
    b.sphere(guard, (0, d / 2 - 0.022, mid), 0.022, segments=12, rings=8)
    b.cylinder(handle, (0, d / 2 - 0.03, mid), (0, hilt, mid), 0.014, segments=12)
    path = [(-w / 2, hilt - 0.025, mid), (-w * 0.3, hilt, mid), (w * 0.3, hilt, mid), (w / 2, hilt - 0.025, mid)]
    b.tube(guard, path, (0.012, 0.01, 0.01, 0.012))
    section = np.array([(-0.024, 0), (0, 0.006), (0.024, 0), (0, -0.006)])
    rings = [
        np.c_[section[:, 0] * s, np.full(4, y), mid + section[:, 1] * s]
        for y, s in ((hilt, 1.0), (-d * 0.4, 0.8), (-d / 2, 0.06))
    ]
    b.loft(blade, rings)
    return two_hands((-0.016, d / 2 - 0.11, mid), (0.15, -0.4, -0.9), (1, 0.1, 0), FIST)


@prop("axe")
def axe(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a felling axe, head up, its edge to -Y."""
    (w, d, h), wood, steel = spec.size, spec.material("handle"), spec.material("head")
    b.tube(wood, [(0, 0.08, 0), (0, 0.06, h * 0.2), (0, 0.07, h * 0.6), (0, 0.06, h)], (0.02, 0.015, 0.015, 0.018))
    edge = [
        (0.1, h - 0.12), (0.1, h - 0.03), (0.02, h - 0.02), (-d / 2, h + 0.02), (-d / 2 - 0.01, h - 0.1),
        (-d / 2 + 0.02, h - 0.18), (0.02, h - 0.12),
    ]  # fmt: skip
    with b.at((-w / 2, 0, 0), (90, 0, 90)):
        b.extrude(steel, edge, w)
    return grips_on_shaft(h * 0.3)


@prop("hammer")
def hammer(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hammer, head up."""
    (w, d, h), wood, steel = spec.size, spec.material("handle"), spec.material("head")
    b.tube(wood, [(0, 0, 0), (0, 0, h * 0.3), (0, 0, h)], (0.016, 0.013, 0.011))
    b.cylinder(steel, (0, -d / 2, h - 0.02), (0, d * 0.1, h - 0.02), w * 0.42, segments=12)
    b.box(steel, (0, d * 0.3, h - 0.02), (w * 0.7, d * 0.42, w * 0.6), bevel=0.005)
    return grips_on_shaft(h * 0.2)


@prop("wrench")
def wrench(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an open wrench, jaws up."""
    (w, d, h), steel = spec.size, spec.material("body")
    b.box(steel, (0, 0, h * 0.4), (w * 0.5, d * 0.28, h * 0.8), bevel=0.004)
    b.cylinder(steel, (-w * 0.3, 0, 0.02), (w * 0.3, 0, 0.02), d * 0.24)
    jaws = [(-0.2, 0.7), (0.2, 0.7), (0.5, 0.82), (0.42, 1.0), (0.2, 1.0), (0.18, 0.87), (-0.18, 0.87), (-0.2, 0.98),
            (-0.42, 1.0), (-0.5, 0.82)]  # fmt: skip
    with b.at((-w / 2, 0, 0), (90, 0, 90)):
        b.extrude(steel, [(x * d, z * h) for x, z in jaws], w)
    return grips_on_shaft(h * 0.35)


@prop("shovel")
def shovel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a shovel, blade down."""
    (w, d, h), wood, steel = spec.size, spec.material("handle"), spec.material("head")
    b.cylinder(wood, (0, 0, 0.26), (0, 0, h - 0.1), 0.016)
    path = [
        (x, 0, h - z) for x, z in ((0, 0.12), (-0.06, 0.07), (-0.06, 0.015), (0.06, 0.015), (0.06, 0.07), (0, 0.12))
    ]
    b.tube(wood, path, 0.012)
    rows = [
        np.array([(x * s, -d / 2 * (1 - (x / (w / 2)) ** 2) + 0.02, z) for x in np.linspace(-w / 2, w / 2, 7)])
        for z, s in ((0.0, 0.1), (0.07, 0.75), (0.16, 1.0), (0.32, 0.95))
    ]
    for lift, order in ((0.0, 1), (0.004, -1)):
        b.loft(steel, [(row + np.array([0, lift, 0]))[::order] for row in rows], closed=False)
    return grips_on_shaft(h * 0.72)


@prop("broom")
def broom(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a broom, bristles down."""
    (w, d, h), wood, head = spec.size, spec.material("handle"), spec.material("head")
    b.cylinder(wood, (0, 0, 0.22), (0, 0, h), 0.013)
    rings = [
        np.array(
            [
                (x * s, y * t, z)
                for x, y in ((-1, -1), (-0.3, -1), (0.3, -1), (1, -1), (1, 1), (0.3, 1), (-0.3, 1), (-1, 1))
            ]
        )
        for z, s, t in ((0, w / 2, d / 2), (0.12, w * 0.42, d * 0.45), (0.24, w * 0.16, d * 0.35), (0.32, 0.03, 0.03))
    ]
    b.loft(head, rings)
    b.box("fabric_red", (0, 0, 0.22), (w * 0.42, d * 0.76, 0.012))
    return grips_on_shaft(h * 0.7)


@prop("bow")
def bow(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a longbow, standing, its belly to the archer at +Y."""
    (_, d, h), wood = spec.size, spec.material("body")
    curve = [(0, -d / 2 + 0.02 + d * 0.9 * abs(2 * t - 1) ** 1.7, h * t) for t in np.linspace(0, 1, 15)]
    b.tube(wood, curve, [0.006 + 0.008 * (1 - abs(2 * t - 1)) for t in np.linspace(0, 1, 15)])
    b.cylinder("leather", (0, -d / 2 + 0.02, h / 2 - 0.06), (0, -d / 2 + 0.02, h / 2 + 0.06), 0.0165)
    b.cylinder(spec.material("string"), curve[0], curve[-1], 0.0016, segments=5)
    return two_hands((-0.016, -d / 2 + 0.026, h / 2), (0.2, -1, 0), (1, 0.15, 0), FIST)


@prop("spear")
def spear(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a spear, point up."""
    (w, _, h), steel = spec.size, spec.material("head")
    b.cylinder(spec.material("shaft"), (0, 0, 0), (0, 0, h - 0.22), 0.016)
    section = np.array([(-w / 2, 0), (0, 0.008), (w / 2, 0), (0, -0.008)])
    rings = [np.c_[section * s, np.full(4, z)] for z, s in ((h - 0.26, 0.4), (h - 0.2, 1.0), (h, 0.03))]
    b.loft(steel, rings)
    b.cylinder(steel, (0, 0, h - 0.32), (0, 0, h - 0.22), 0.02, segments=10)
    return grips_on_shaft(h * 0.58)


@prop("shield")
def shield(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a round shield that faces -Y."""
    w, d, h = spec.size
    r = w / 2
    place = {"origin": (0, d / 2, h / 2), "axis": (0, -1, 0), "segments": 36}
    outline = [(r * 0.98, 0), (r * 0.98, d * 0.2), (r * 0.6, d * 0.45), (0.004, d * 0.55)]
    b.lathe(spec.material("body"), outline, **place)
    b.lathe(spec.material("metal"), [(r, 0), (r, d * 0.25), (r * 0.9, d * 0.32)], **place)
    profile = [(r * 0.3, d * 0.5), (r * 0.28, d * 0.65), (r * 0.16, d * 0.92), (0.003, d)]
    b.lathe(spec.material("metal"), profile, **place)
    for k in range(12):
        turn = math.tau * k / 12
        center = (r * 0.9 * math.cos(turn), d * 0.2, h / 2 + r * 0.9 * math.sin(turn))
        b.sphere(spec.material("metal"), center, 0.012, segments=8, rings=5)
    return two_hands((0.0, d / 2 + 0.02, h / 2), (1, 0, 0), (0, -1, 0), FIST)
