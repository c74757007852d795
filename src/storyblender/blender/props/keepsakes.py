"""Prop builders: boxes, presents, flowers and toys."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_at_side, grips_under, two_hands
from storyblender.blender.props.lamps import flame
from storyblender.blender.props.registry import PropSpec, prop


@prop("jewel_box")
def jewel_box(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a jewel box, closed or with its lid back and pearls inside."""
    (w, d, h), body, gold = spec.size, spec.material("body"), spec.material("trim")
    base, opened = h * 0.66, spec.flag("open")
    b.box(body, (0, 0, base / 2 + 0.008), (w - 0.012, d - 0.012, base - 0.008), bevel=0.004)
    b.box("fabric_red", (0, 0, base - 0.002), (w - 0.04, d - 0.04, 0.012))
    for x in (-1, 1):
        for y in (-1, 1):
            b.sphere(gold, (x * (w / 2 - 0.016), y * (d / 2 - 0.016), 0.009), 0.011, segments=10, rings=6)
            middle = (x * (w / 2 - 0.008), y * (d / 2 - 0.008), base / 2 + 0.008)
            b.box(gold, middle, (0.016, 0.016, base - 0.01), bevel=0.003)
    with b.at((0, d / 2 - 0.006, base + 0.006), (-100 if opened else 0, 0, 0)):
        center = (0, -d / 2 + 0.006, (h - base) * 0.4)
        b.box(body, center, (w - 0.004, d - 0.004, (h - base) * 0.8), bevel=0.006, taper=0.93)
        b.box(gold, (0, -d / 2 + 0.006, 0.004), (w, d, 0.006), bevel=0.002)
        b.cushion(gold, (0, -d / 2 + 0.006, (h - base) * 0.84), (w * 0.4, d * 0.4, 0.008), softness=0.8)
    b.box(gold, (0, -d / 2 - 0.003, base), (0.03, 0.008, 0.032), bevel=0.003)
    if opened:
        for k in range(12):
            turn = 0.52 * k
            b.sphere(
                "porcelain", (0.05 * math.cos(turn), 0.03 * math.sin(turn), base + 0.008), 0.007, segments=8, rings=5
            )
    return grips_at_side(-w / 2, h * 0.35) + grips_under(d * 0.3)


@prop("gift")
def gift(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wrapped box with a bow."""
    (w, d, h), ribbon = spec.size, spec.material("ribbon")
    case = h * 0.76
    b.box(spec.material("body"), (0, 0, case / 2), (w - 0.006, d - 0.006, case), bevel=0.003)
    b.box(ribbon, (0, 0, case / 2), (w * 0.14, d, case + 0.006))
    b.box(ribbon, (0, 0, case / 2), (w, d * 0.14, case + 0.006))
    for turn in (35, 145, 215, 325):
        with b.at((0, 0, case), (0, 0, turn)):
            loop = [
                (0, 0, 0), (w * 0.16, 0, h * 0.14), (w * 0.3, 0, h * 0.17), (w * 0.3, 0, h * 0.06), (0.01, 0, 0.005),
            ]  # fmt: skip
            b.tube(ribbon, loop, 0.012, segments=6)
    b.sphere(ribbon, (0, 0, case + 0.015), 0.022, segments=10, rings=6)
    return two_hands((-w / 2, 0.0, case * 0.4), (0.1, -0.9, -0.4), (1, 0, 0), (0.15, 0.2, 0.15))


@prop("candle_holder")
def candle_holder(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lit candle in a dish with a ring to hold it by."""
    (w, d, h), metal = spec.size, spec.material("metal")
    r = d / 2
    outline = [(r * 0.8, 0), (r, 0.014), (r, 0.018), (r * 0.78, 0.007), (0.02, 0.009), (0.018, 0.03), (0.024, 0.034)]
    b.lathe(metal, outline, origin=(w / 2 - r, 0, 0), segments=26)
    loop = [
        (-w / 2 + 0.012 + 0.02 * math.cos(a), 0, 0.024 + 0.018 * math.sin(a))
        for a in np.linspace(0, math.tau, 16, endpoint=False)
    ]
    b.tube(metal, loop, 0.0035, segments=6, closed=True)
    profile = [(0.012, 0.02), (0.012, h * 0.68), (0.008, h * 0.7)]
    b.lathe(spec.material("wax"), profile, origin=(w / 2 - r, 0, 0), segments=12)
    flame(b, spec.material("flame"), w / 2 - r, 0, h * 0.7, h * 0.3)
    return two_hands((-w / 2 - 0.01, 0.01, 0.024), (0.4, -0.9, 0), (0.95, 0.3, 0), (0.8, 0.85, 0.6))


@prop("rope")
def rope(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a coil of rope."""
    w, _, h = spec.size
    turns, r = 5, w / 2 - 0.02
    t = np.linspace(0, turns, turns * 24)
    reach = r * (1 - 0.06 * np.sin(t * 4.1))
    path = np.c_[
        reach * np.cos(math.tau * t),
        reach * np.sin(math.tau * t),
        0.016 + (h - 0.034) * t / turns + 0.006 * np.sin(9 * t),
    ]
    line = np.r_[path, [(w * 0.2, -w * 0.1, h - 0.01), (w * 0.1, -w * 0.25, h - 0.04)]]
    b.tube(spec.material("body"), line, 0.015, segments=7)
    return two_hands((-r, 0.0, h * 0.5), (0.3, -0.3, -0.9), (1, 0, 0), FIST)


@prop("flower")
def flower(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rose on its stem."""
    h = spec.size[2]
    stem = spec.material("stem")
    b.tube(stem, [(0, 0, 0), (0.006, 0, h * 0.4), (0, 0.004, h * 0.86)], 0.003, segments=6)
    bloom(b, spec.material("petal"), (0, 0.004, h * 0.9), 0.036)
    for turn, z in ((0, 0.35), (150, 0.55)):
        with b.at((0.004, 0, h * z), (0, -35, turn)):
            b.cushion(spec.material("leaf"), (0.026, 0, 0), (0.05, 0.026, 0.004), softness=1.0)
    return grips_around(0.006, h * 0.25, (0.7, 0.8, 0.6))


def bloom(b: MeshBuilder, material: MaterialRef, center: tuple[float, float, float], radius: float) -> None:
    """Add a round blossom of three rings of petals.

    Args:
        b: Receives the petals.
        material: Of the petals.
        center: Middle of the blossom.
        radius: Of the blossom.
    """
    x, y, z = center
    b.sphere(material, center, radius * 0.55, segments=10, rings=6)
    for row, (count, reach, tilt) in enumerate(((4, 0.35, 70), (5, 0.55, 45), (6, 0.7, 15))):
        for k in range(count):
            with b.at((x, y, z), (0, -tilt, 360 * k / count + 20 * row)):
                petal = (0.4, 0.45, 0.08)
                b.sphere(material, (radius * reach, 0, 0), radius, scale=petal, segments=8, rings=4)


@prop("bouquet")
def bouquet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bunch of flowers in a cone of paper."""
    (w, _, h), leaf = spec.size, spec.material("leaf")
    angle = np.linspace(0, math.tau, 30, endpoint=False)
    wave = 1 + 0.08 * np.sin(6 * angle)
    for inside in (0.0, 0.006):
        rings = [
            np.c_[
                (r * wave - inside) * np.cos(angle),
                (r * wave - inside) * np.sin(angle),
                np.full(30, z) + 0.02 * np.sin(3 * angle) * (z > 0.1),
            ]
            for r, z in ((0.03, 0.0), (0.035, h * 0.2), (w * 0.4, h * 0.62))
        ]
        b.loft(spec.material("paper"), rings if inside == 0 else rings[::-1], caps=False)
    for k in range(9):
        turn, reach = 2.4 * k, w * 0.36 * math.sqrt((k + 0.5) / 9)
        at = (reach * math.cos(turn), reach * math.sin(turn), h * (0.82 - 0.6 * reach))
        bloom(b, spec.material("petal") if k % 3 else "linen", at, 0.045)
        b.sphere(leaf, (at[0] * 1.25, at[1] * 1.25, at[2] - 0.06), 0.05, segments=8, rings=5)
    return grips_around(0.03, h * 0.15, FIST)


@prop("ball")
def ball(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sewn ball."""
    r = spec.size[0] / 2
    b.sphere(spec.material("body"), (0, 0, r), r, segments=28, rings=16)
    for rotation in ((0, 0, 0), (90, 0, 0), (90, 0, 90)):
        with b.at((0, 0, r), rotation):
            seam = [(r * math.cos(a), r * math.sin(a), 0) for a in np.linspace(0, math.tau, 36, endpoint=False)]
            b.tube(spec.material("seam"), seam, r * 0.012, segments=5, closed=True)
    return two_hands((-r, 0.0, r * 0.8), (0.2, -0.9, -0.3), (1, 0, 0.2), (0.25, 0.3, 0.2))


@prop("teddy_bear")
def teddy_bear(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sitting teddy bear."""
    (w, d, h), body, snout, eye = spec.size, spec.material("body"), spec.material("snout"), spec.material("eye")
    b.sphere(body, (0, 0.02, h * 0.3), h * 0.26, scale=(1, 0.9, 1.1))
    b.sphere(body, (0, 0.0, h * 0.74), h * 0.22, scale=(1.05, 0.95, 1))
    b.sphere(snout, (0, -h * 0.18, h * 0.69), h * 0.1)
    b.sphere(eye, (0, -h * 0.27, h * 0.72), h * 0.03)
    for x in (-1, 1):
        b.sphere(body, (x * h * 0.17, 0.0, h * 0.92), h * 0.08, scale=(1, 0.5, 1))
        b.sphere(eye, (x * h * 0.08, -h * 0.19, h * 0.79), h * 0.024)
        b.cushion(
            body, (x * w * 0.36, -0.03, h * 0.42), (w * 0.2, w * 0.2, h * 0.34), softness=0.9, rotation=(20, x * 25, 0)
        )
        b.cushion(body, (x * w * 0.3, -d * 0.3, h * 0.12), (w * 0.27, d * 0.5, h * 0.22), softness=0.9)
        b.cushion(snout, (x * w * 0.3, -d * 0.47, h * 0.12), (w * 0.2, 0.03, h * 0.17), softness=0.9)
    return grips_around(w * 0.3, h * 0.4, (0.4, 0.45, 0.3))


@prop("skull")
def skull(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a skull that looks to -Y."""
    (w, d, h), body, hole = spec.size, spec.material("body"), spec.material("hole")
    b.sphere(body, (0, d * 0.12, h * 0.64), w * 0.48, scale=(1, 1.18, 0.86))
    b.rounded_box(body, (0, -d * 0.2, h * 0.4), (w * 0.62, d * 0.36, h * 0.4), 0.025)
    b.rounded_box(body, (0, -d * 0.22, h * 0.12), (w * 0.56, d * 0.36, h * 0.2), 0.02)
    for x in (-1, 1):
        b.sphere(hole, (x * w * 0.19, -d * 0.36, h * 0.52), w * 0.13, scale=(1, 0.5, 0.9))
        b.sphere(body, (x * w * 0.36, -d * 0.22, h * 0.42), w * 0.1)
    b.cushion(hole, (0, -d * 0.38, h * 0.38), (w * 0.12, 0.02, h * 0.1), softness=0.8)
    b.box(hole, (0, -d * 0.395, h * 0.21), (w * 0.48, 0.008, 0.006))
    for k in range(6):
        b.box(hole, ((k - 2.5) * w * 0.085, -d * 0.398, h * 0.21), (0.002, 0.006, h * 0.1))
    return two_hands((0.0, 0.05, -0.01), (0, -1, 0), (0, 0, 1), (0.35, 0.4, 0.2))
