"""Prop builders: bags, baskets and what is carried by a handle."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_hanging, two_hands
from storyblender.blender.props.opened import open_case
from storyblender.blender.props.parts import bent, rectangle
from storyblender.blender.props.registry import PropSpec, prop


def _bail(b: MeshBuilder, material: MaterialRef, width: float, foot: float, rise: float, radius: float) -> None:
    """Add a handle over the top, along X."""
    arc = [
        (width * x, 0, foot + rise * z)
        for x, z in ((-0.5, 0), (-0.5, 0.6), (-0.36, 1), (0.36, 1), (0.5, 0.6), (0.5, 0))
    ]
    b.tube(material, bent(arc), radius)


@prop("briefcase")
def briefcase(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing briefcase."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("metal")
    case = h - 0.05
    b.rounded_box(body, (0, 0, case / 2), (w, d, case), 0.02)
    b.box(brass, (0, 0, case * 0.72), (w + 0.004, d + 0.004, 0.008))
    _bail(b, body, 0.14, case - 0.005, 0.05, 0.009)
    for x in (-1, 1):
        b.box(brass, (x * w * 0.3, -d / 2 - 0.004, case * 0.72), (0.045, 0.012, 0.04), bevel=0.003)
    return grips_hanging(h - 0.01)


@prop("toolbox")
def toolbox(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a closed toolbox with a sloping lid."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    case = h - 0.06
    b.rounded_box(body, (0, 0, case * 0.36), (w, d, case * 0.72), 0.008)
    b.box(body, (0, 0, case * 0.86), (w, d, case * 0.28), taper=0.8)
    b.box(metal, (0, 0, case * 0.72), (w + 0.004, d + 0.004, 0.008))
    _bail(b, metal, 0.18, case - 0.005, 0.06, 0.009)
    for x in (-1, 1):
        b.box(metal, (x * w * 0.28, -d / 2 - 0.004, case * 0.7), (0.04, 0.012, 0.06), bevel=0.003)
    return grips_hanging(h - 0.01)


@prop("suitcase")
def suitcase(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing suitcase with straps and corners, or one that lies ``open``."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("metal")
    if spec.flag("open"):
        open_case(b, body, brass, "linen", spec.size)
        return ()
    case = h - 0.05
    b.rounded_box(body, (0, 0, case / 2), (w, d, case), 0.03)
    b.box("leather_black", (0, 0, case / 2), (w + 0.004, 0.012, case + 0.004), bevel=0.002)
    for x in (-1, 1):
        b.box("leather_black", (x * w * 0.28, 0, case / 2), (0.035, d + 0.01, case + 0.01), bevel=0.003)
        b.box(brass, (x * w * 0.28, -d / 2 - 0.006, case * 0.6), (0.05, 0.012, 0.04), bevel=0.003)
        for y in (-1, 1):
            for z in (0.035, case - 0.035):
                b.rounded_box(brass, (x * (w / 2 - 0.028), y * (d / 2 - 0.028), z), (0.066, 0.066, 0.076), 0.02)
    _bail(b, "leather_black", 0.16, case, 0.05, 0.01)
    return grips_hanging(h - 0.01)


@prop("bag")
def bag(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a handbag with a clasp."""
    (w, d, h), body = spec.size, spec.material("body")
    case = h * 0.6
    rings = [
        np.c_[rectangle(w * wide, d * deep, 48, d * deep * 0.3), np.full(48, case * z)]
        for wide, deep, z in ((0.96, 0.92, 0), (1.0, 1.0, 0.06), (0.98, 0.95, 0.3), (0.9, 0.66, 0.7), (0.76, 0.26, 1.0))
    ]
    b.loft(body, rings)
    b.box("brass", (0, 0, case + 0.004), (w * 0.74, d * 0.24, 0.016), bevel=0.005)
    b.sphere("brass", (0, 0, case + 0.02), 0.014, segments=12, rings=8)
    _bail(b, body, w * 0.56, case, h - case - 0.006, 0.007)
    return grips_hanging(h - 0.01)


@prop("backpack")
def backpack(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing backpack; its straps are at +Y."""
    (w, d, h), body, strap = spec.size, spec.material("body"), spec.material("strap")
    b.rounded_box(body, (0, 0.02, h * 0.45), (w * 0.9, d * 0.72, h * 0.88), 0.07)
    b.rounded_box(body, (0, -0.0, h * 0.82), (w * 0.92, d * 0.82, h * 0.24), 0.06)
    b.rounded_box(body, (0, -d * 0.36, h * 0.3), (w * 0.66, d * 0.28, h * 0.4), 0.04)
    for x in (-1, 1):
        b.rounded_box(body, (x * w * 0.44, 0.02, h * 0.28), (w * 0.14, d * 0.5, h * 0.34), 0.03)
        b.box(strap, (x * w * 0.18, -d * 0.42, h * 0.62), (0.022, 0.012, h * 0.3), bevel=0.003, rotation=(8, 0, 0))
        path = np.multiply([(0.18, 0.38, 0.86), (0.24, 0.52, 0.7), (0.28, 0.5, 0.3), (0.3, 0.36, 0.1)], (x * w, d, h))
        b.tube(strap, path, 0.016)
    loop = [(0.04 * math.cos(a), d * 0.3, h * 0.92 + 0.045 * math.sin(a)) for a in np.linspace(0, math.pi, 9)]
    b.tube(strap, loop, 0.009)
    return grips_hanging(h - 0.01)


@prop("sack")
def sack(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a full sack, tied at its neck."""
    (w, d, h), body = spec.size, spec.material("body")
    angle = np.linspace(0, math.tau, 24, endpoint=False)
    rings = []
    for reach, z in (
        (0.6, 0),
        (0.96, 0.06),
        (1.0, 0.3),
        (0.9, 0.52),
        (0.62, 0.7),
        (0.22, 0.8),
        (0.2, 0.83),
        (0.36, 0.92),
        (0.42, 1.0),
    ):
        fold = 1 + (0.1 if 0.6 < z < 0.99 else 0.03) * np.sin(7 * angle) + 0.03 * np.sin(3 * angle + 5 * z)
        rings.append(
            np.c_[reach * w / 2 * fold * np.cos(angle), reach * d / 2 * fold * np.sin(angle), np.full(24, z * h)]
        )
    b.loft(body, list(bent(rings)))
    knot = [(0.24 * w / 2 * math.cos(a), 0.24 * d / 2 * math.sin(a), h * 0.815) for a in angle[::2]]
    b.tube(spec.material("rope"), knot, 0.012, closed=True)
    return grips_around(w * 0.12, h * 0.82, FIST)


@prop("basket")
def basket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a basket with a bow handle."""
    (w, d, h), body = spec.size, spec.material("body")
    bowl = h * 0.46
    angle = np.linspace(0, math.tau, 28, endpoint=False)
    for k in range(7):
        reach = 0.78 + 0.2 * k / 6
        ring = np.c_[
            reach * w / 2 * np.cos(angle), reach * d / 2 * np.sin(angle), np.full(28, 0.016 + (bowl - 0.02) * k / 6)
        ]
        b.tube(body, ring, 0.017, segments=6, closed=True)
    b.polygon(body, np.c_[0.78 * w / 2 * np.cos(angle), 0.78 * d / 2 * np.sin(angle), np.full(28, 0.012)])
    arc = [(w * 0.48 * math.cos(a), 0, bowl + (h - bowl - 0.012) * math.sin(a)) for a in np.linspace(0, math.pi, 15)]
    b.tube(body, arc, 0.011)
    return grips_hanging(h - 0.01)


@prop("bucket")
def bucket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bucket with its bail up."""
    (w, _, h), body, r = spec.size, spec.material("body"), spec.size[0] / 2
    pail = h * 0.62
    profile = [
        (r * 0.7, 0), (r * 0.72, 0.012), (r * 0.96, pail - 0.015), (r, pail - 0.006), (r * 0.96, pail),
        (r * 0.93, pail - 0.01), (r * 0.69, 0.03),
    ]  # fmt: skip
    b.lathe(body, profile, segments=30)
    b.lathe("water", [(r * 0.9, pail * 0.85)] * 2, segments=30)
    arc = [
        (w * 0.49 * math.cos(a), 0, pail - 0.02 + (h - pail + 0.015) * math.sin(a)) for a in np.linspace(0, math.pi, 15)
    ]
    b.tube(spec.material("metal"), arc, 0.005)
    b.cylinder("wood", (-0.05, 0, h - 0.008), (0.05, 0, h - 0.008), 0.013, segments=10)
    return grips_hanging(h - 0.01)


@prop("umbrella")
def umbrella(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an umbrella, open overhead or furled, its handle down."""
    h, cloth, metal = spec.size[2], spec.material("cloth"), spec.material("metal")
    r = h * 0.53
    b.cylinder(metal, (0, 0, 0.08), (0, 0, h), 0.007, segments=10)
    crook = [(0, 0, 0.16), (0, 0, 0.05), (0, -0.02, 0.012), (0, -0.06, 0.01), (0, -0.08, 0.05)]
    b.tube(spec.material("handle"), crook, 0.011)
    if spec.flag("up"):
        angle = np.linspace(0, math.tau, 48, endpoint=False)
        scallop = 0.04 * (1 - np.abs(np.cos(4 * angle)))
        for inside in (0.0, 0.006):
            rings = []
            for t in (1.0, 0.8, 0.55, 0.3, 0.02):
                z = h - 0.05 - (h * 0.24) * t**1.8 + scallop * t - inside
                rings.append(np.c_[r * t * np.cos(angle), r * t * np.sin(angle), z])
            b.loft(cloth, rings if inside == 0 else rings[::-1], caps=False)
        for k in range(8):
            turn = math.tau * k / 8
            start, end = (0, 0, h * 0.6), (r * 0.55 * math.cos(turn), r * 0.55 * math.sin(turn), h - 0.15)
            b.cylinder(metal, start, end, 0.003, segments=5)
    else:
        b.lathe(cloth, [(0.016, 0.2), (0.038, 0.24), (0.03, h * 0.5), (0.012, h - 0.06)], segments=12)
    return two_hands((-0.014, 0.004, 0.13), (0.2, -1, 0.05), (1, 0.15, 0), FIST)


@prop("cane")
def cane(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a walking stick with a crook along X."""
    (w, _, h), body = spec.size, spec.material("body")
    crook = [
        (w * 0.3 - w * 0.4 + w * 0.4 * math.cos(a), 0, h - w * 0.5 + w * 0.42 * math.sin(a))
        for a in np.linspace(0, math.pi * 1.1, 11)
    ]
    b.tube(body, [(w * 0.3, 0, 0.02), *crook], 0.011)
    b.cylinder("rubber", (w * 0.3, 0, 0), (w * 0.3, 0, 0.03), 0.013)
    return two_hands((w * -0.1, 0.0, h), (0.3, -0.9, -0.3), (0, -0.3, -0.95), FIST)
