"""Prop builders: what people smoke and wash with: cigarettes, matches, razor, soap, tissues, toilet roll, plunger."""

from __future__ import annotations

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_under, two_hands
from storyblender.blender.props.parts import bent, circle, rectangle
from storyblender.blender.props.registry import PropSpec, prop


@prop("cigarette_pack")
def cigarette_pack(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an open packet of cigarettes that stands, two of them looking out."""
    (w, d, h), card, band = spec.size, spec.material("card"), spec.material("band")
    tall = 0.86 * h
    b.box(card, (0, 0, 0.4 * tall), (w, d, 0.8 * tall), bevel=0.001)
    b.box("paper", (0, 0, 0.82 * tall), (0.94 * w, 0.9 * d, 0.1 * tall))
    b.box(band, (0, 0, 0.52 * tall), (1.01 * w, 1.02 * d, 0.2 * tall))
    b.box(card, (0, 0.62 * d, 0.86 * tall), (w, 0.8 * d, 0.16 * tall), bevel=0.001, rotation=(-60, 0, 0))
    for x, rise in ((-0.3, 0.94), (-0.12, 1.0), (0.1, 0.88), (0.3, 0.87)):
        b.cylinder("linen", (x * w, -0.1 * d, 0.7 * tall), (x * w, -0.1 * d, rise * h), 0.0038, segments=10)
    return two_hands((-0.5 * w, 0.0, 0.4 * h), (0.2, -0.95, 0), (0.98, 0.1, 0), (0.45, 0.5, 0.4))


@prop("matchbox")
def matchbox(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a half open box of matches that lies flat, its drawer to -Y."""
    (w, d, h), card = spec.size, spec.material("card")
    long = 0.72 * d
    b.box(card, (0, (d - long) / 2, h / 2), (w, long, h), bevel=0.001)
    b.box(spec.material("label"), (0, (d - long) / 2, h), (0.8 * w, 0.8 * long, 0.0006))
    for x in (-1, 1):
        b.box("rubber", (0.5 * x * w, (d - long) / 2, h / 2), (0.0008, 0.96 * long, 0.7 * h))
        b.box("paper", (0.44 * x * w, -0.2 * d, 0.42 * h), (0.05 * w, 0.6 * d, 0.7 * h))
    b.box("paper", (0, -0.2 * d, 0.14 * h), (0.9 * w, 0.6 * d, 0.1 * h))
    b.box("paper", (0, -0.49 * d, 0.42 * h), (0.9 * w, 0.02 * d, 0.7 * h))
    for k in range(7):
        x, z = (k - 3) * 0.11 * w, (0.3 + 0.24 * (k % 2)) * h
        b.box("wood_light", (x, -0.2 * d, z), (0.05 * w, 0.5 * d, 0.12 * h))
        b.sphere("fabric_red", (x, -0.44 * d, z), 0.09 * h, segments=8, rings=5)
    return two_hands((-0.5 * w, 0.1 * d, 0.5 * h), (0.2, -0.95, 0), (0.98, 0.1, 0), (0.5, 0.6, 0.5))


@prop("razor")
def razor(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a safety razor that lies along Y, its head to -Y."""
    (w, d, h), handle, metal = spec.size, spec.material("handle"), spec.material("metal")
    grip = bent([(0.2, 0), (0.3, 0.06), (0.24, 0.3), (0.28, 0.6), (0.16, 0.8), (0.14, 1.0)], 3) * (h, 0.9 * d)
    b.lathe(handle, grip, origin=(0, d / 2, 0.3 * h), axis=(0, -1, 0.12), segments=14)
    with b.at((0, -0.45 * d, 0.62 * h), (28, 0, 0)):
        b.rounded_box(handle, (0, 0, 0), (w, 0.1 * d, 0.36 * h), 0.002)
        for y in (-0.025, 0.0, 0.025):
            b.box(metal, (0, y * d, 0.19 * h), (0.9 * w, 0.01 * d, 0.03 * h))
    return two_hands((-0.01, 0.15 * d, 0.3 * h), (0.3, -0.9, -0.2), (0.9, 0.3, 0.2), (0.75, 0.8, 0.6))


@prop("soap")
def soap(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bar of soap with a sunken oval on top and a few bubbles."""
    w, d, h = spec.size
    b.cushion(spec.material("soap"), (0, 0, 0.46 * h), (w, d, 0.92 * h), softness=0.3)
    path = np.c_[circle(1.0, 32) * (0.3 * w, 0.28 * d), np.full(32, 0.9 * h)]
    b.tube(spec.material("soap"), path, 0.0016, segments=6, closed=True)
    for k, (x, y) in enumerate(((0.32, -0.3), (0.4, -0.18), (0.26, -0.36), (-0.38, 0.2))):
        b.sphere("glass", (x * w, y * d, 0.88 * h), 0.1 * h * (1 + 0.4 * (k % 2)), segments=8, rings=5)
    return two_hands((-w / 2, 0.0, 0.5 * h), (0.2, -0.9, -0.3), (1, 0, 0), (0.45, 0.5, 0.4))


@prop("tissue_box")
def tissue_box(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a box of tissues, the next one looking out of its slot."""
    (w, d, h), card = spec.size, spec.material("card")
    low = 0.62 * h
    b.box(card, (0, 0, low / 2), (w, d, low), bevel=0.002)
    b.box(spec.material("band"), (0, 0, 0.24 * low), (1.005 * w, 1.005 * d, 0.3 * low))
    b.extrude("plastic_black", rectangle(0.6 * w, 0.22 * d, 32, 0.012), 0.001, base=low)
    across = np.linspace(-1, 1, 15)
    rows = []
    for t in np.linspace(0, 1, 7):
        wave = (0.04 + 0.14 * t) * d * np.sin(5 * across + 2 * t)
        rise = low + (h - low) * t * (0.7 + 0.3 * np.cos(2.2 * across - 0.6))
        rows.append(np.c_[(0.2 + 0.1 * t) * w * across, wave, rise])
    for lift, order in ((0.0, 1), (0.001, -1)):
        b.loft("porcelain", [(row + np.array([0, lift, 0]))[::order] for row in rows], closed=False)
    return grips_under(0.4 * d) + two_hands(
        (-w / 2, 0, 0.4 * low), (0.1, -0.9, -0.3), (1, 0, 0), (0.3, 0.35, 0.3), "side"
    )


@prop("toilet_roll")
def toilet_roll(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a roll of toilet paper that stands, its end hanging at the front."""
    r, h, paper = spec.size[0] / 2, spec.size[2], spec.material("paper")
    profile = [(0.36 * r, 0), (0.98 * r, 0), (r, 0.02 * h), (r, 0.98 * h), (0.98 * r, h), (0.36 * r, h)]
    b.lathe(paper, profile, segments=32, caps=False)
    b.lathe("cardboard", [(0.36 * r, h), (0.32 * r, h), (0.32 * r, 0), (0.36 * r, 0)], segments=24, caps=False)
    for share in (0.5, 0.64, 0.78, 0.9):
        b.tube(paper, np.c_[circle(share * r, 32), np.full(32, h)], 0.0006, segments=4, closed=True)
    b.box(paper, (0.4 * r, -0.98 * r, h / 2), (1.0 * r, 0.0015, h), rotation=(0, 0, -10))
    return grips_around(r, 0.5 * h, (0.35, 0.4, 0.3))


@prop("plunger")
def plunger(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a plunger that stands on its rubber cup."""
    r, h = spec.size[0] / 2, spec.size[2]
    cup = bent([(1.0, 0.0), (0.98, 0.04), (0.8, 0.12), (0.4, 0.17), (0.2, 0.19), (0.18, 0.26)], 3) * (r, h)
    b.lathe(spec.material("rubber"), cup, segments=28)
    b.lathe(spec.material("wood"), [(0.17 * r, 0.24 * h), (0.17 * r, 0.97 * h), (0.1 * r, h)], segments=14)
    return grips_around(0.17 * r, 0.8 * h, FIST)
