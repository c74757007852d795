"""Prop builders: jars, tins, pots and jugs, and what one cooks with."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_under, two_hands
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

Points = list[tuple[float, float]]


def turned(b: MeshBuilder, spec: PropSpec, role: str, profile: Points, steps: int = 4) -> None:
    """Add a smooth body of revolution to a prop.

    Args:
        b: Receives the body.
        spec: Of the prop.
        role: Material role of the body.
        profile: Pairs of radius, as a share of half the prop's width, and height, as a share of the prop's.
        steps: Points per stretch of the smoothed profile.
    """
    r, h = spec.size[0] / 2, spec.size[2]
    b.lathe(spec.material(role), bent([(x * r, z * h) for x, z in profile], steps), segments=28)


@prop("jar")
def jar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a glass jar with a lid; ``money`` puts coins and notes in it and leaves it open."""
    (_, _, h), glass, r = spec.size, spec.material("glass"), spec.size[0] / 2
    tipped = spec.flag("money")
    body = [(r * 0.9, 0.0), (r, h * 0.05), (r, h * 0.7), (r * 0.94, h * 0.77), (r * 0.8, h * 0.82), (r * 0.8, h * 0.98)]
    b.lathe(
        glass,
        [*body, (r * 0.84, h), (r * 0.76, h), (r * 0.76, h * 0.83), (r * 0.93, h * 0.7), (r * 0.93, h * 0.06)],
        segments=28,
    )
    b.lathe("paper", [(r * 1.005, h * 0.28), (r * 1.005, h * 0.56)], segments=28, caps=False)
    if not tipped:
        outline = [(r * 0.86, h * 0.88), (r * 0.88, h * 0.9), (r * 0.88, h * 0.98), (r * 0.8, h)]
        b.lathe(spec.material("lid"), outline, segments=28)
        profile = [(r * 0.88, h * 0.07), (r * 0.9, h * 0.1), (r * 0.9, h * 0.62), (0.003, h * 0.65)]
        b.lathe(spec.material("filling"), profile, segments=24)
        return grips_around(r, h * 0.45)
    for k in range(26):
        turn, reach = 2.4 * k, r * 0.7 * math.sqrt((k % 13 + 0.5) / 13)
        with b.at(
            (reach * math.cos(turn), reach * math.sin(turn), h * (0.08 + 0.008 * k)),
            (20 * math.sin(k), 25 * math.cos(2 * k), 0),
        ):
            b.cylinder("gold" if k % 3 else "silver", (0, 0, 0), (0, 0, 0.002), 0.011, segments=12)
    for k in range(3):
        center = (0, 0, h * (0.42 + 0.12 * k))
        b.box("fabric_green", center, (0.05, 0.002, 0.09), rotation=(12 * k - 8, 20 - 14 * k, 70 * k))
    return grips_around(r, h * 0.45)


@prop("tin_can")
def tin_can(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tin with a paper label."""
    (_, _, h), tin, r = spec.size, spec.material("tin"), spec.size[0] / 2
    profile = [(r * 0.94, 0), (r, 0.002), (r, h - 0.002), (r * 0.97, h), (r * 0.94, h - 0.004), (0.003, h - 0.004)]
    b.lathe(tin, profile, segments=28)
    b.lathe(spec.material("label"), [(r * 1.012, h * 0.1), (r * 1.012, h * 0.9)], segments=28, caps=False)
    return grips_around(r, h * 0.5)


@prop("canteen")
def canteen(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flat round flask in a cloth cover, on its strap."""
    (w, d, h), cover, metal = spec.size, spec.material("cover"), spec.material("metal")
    r = w / 2
    profile = [(r * 0.6, -d / 2), (r * 0.93, -d * 0.36), (r, 0), (r * 0.93, d * 0.36), (r * 0.6, d / 2)]
    b.lathe(cover, profile, origin=(0, 0, r), axis=(0, 1, 0), segments=28)
    b.cylinder(metal, (0, 0, 2 * r - 0.01), (0, 0, h - 0.02), d * 0.26)
    b.lathe(metal, [(d * 0.34, h - 0.028), (d * 0.34, h - 0.004), (d * 0.28, h)], segments=16)
    angle = np.linspace(-0.35, math.pi + 0.35, 26)
    path = np.c_[(r + 0.004) * np.cos(-angle), np.zeros(26), r + (r + 0.004) * np.sin(-angle)]
    b.tube("leather", path, 0.006, segments=6)
    return two_hands((-0.01, 0.012, 2 * r + 0.01), (0.25, -1, 0), (1, 0.2, 0), FIST)


@prop("jug")
def jug(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a jug with a lip at +X and its handle at -X."""
    (w, d, h), body = spec.size, spec.material("body")
    r = d / 2
    outer = bent(np.multiply([(0.62, 0), (0.95, 0.18), (1, 0.36), (0.72, 0.66), (0.58, 0.8), (0.7, 1)], (r, h)), 4)
    inner = bent([(r * 0.64, h * 0.99), (r * 0.5, h * 0.8), (r * 0.62, h * 0.66)], 3)
    rings, angle = [], np.linspace(0, math.tau, 28, endpoint=False)
    for radius, z in [*outer, *inner]:
        lip = 1 + 0.32 * np.exp(-((np.minimum(angle, math.tau - angle) / 0.4) ** 2)) * max(0.0, (z / h - 0.82) / 0.18)
        rings.append(np.c_[radius * lip * np.cos(angle), radius * np.sin(angle), np.full(28, z)])
    b.loft(body, rings)
    profile = [(0.003, h * 0.66), (r * 0.68, h * 0.66), (r * 0.6, h * 0.7), (0.003, h * 0.7)]
    b.lathe(spec.material("drink"), profile, segments=24)
    bow = [
        (-r * 0.6, 0, h * 0.88), (-w * 0.42, 0, h * 0.9), (-w * 0.5, 0, h * 0.66), (-w * 0.44, 0, h * 0.38),
        (-r * 0.95, 0, h * 0.32),
    ]  # fmt: skip
    b.tube(body, bent(bow), 0.011)
    return two_hands((-w * 0.5, 0.0, h * 0.62), (0.2, -1, 0), (1, 0.1, 0), (0.85, 0.85, 0.5))


@prop("pot")
def pot(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cooking pot with its lid and two handles."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("handle")
    r, top = d / 2, h * 0.78
    b.lathe(body, [(r * 0.94, 0), (r * 0.98, h * 0.04), (r * 0.98, top - 0.006), (r, top), (r * 0.9, top)], segments=32)
    lid = [(r * 1.0, top), (r * 1.0, top + 0.006), (r * 0.75, h * 0.87), (r * 0.3, h * 0.9), (0.012, h * 0.91)]
    b.lathe(body, [*lid, (0.012, h * 0.94), (0.022, h * 0.97), (0.016, h)], segments=32)
    for x in (-1, 1):
        loop = [
            (x * r * 0.95, -0.045, top * 0.8),
            (x * w / 2, -0.04, top * 0.82),
            (x * w / 2, 0.04, top * 0.82),
            (x * r * 0.95, 0.045, top * 0.8),
        ]
        b.tube(metal, bent(loop), 0.007)
    return two_hands((-w / 2, 0.0, top * 0.8), (0.1, -0.9, -0.3), (0.9, 0, 0.4), (0.7, 0.75, 0.4))


@prop("cauldron")
def cauldron(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a witch's kettle on three feet, full of brew."""
    (w, _, h), iron = spec.size, spec.material("iron")
    r = w / 2 * 0.95
    turned(b, spec, "iron", [
        (0.3, 0.1), (0.72, 0.16), (0.93, 0.4), (0.92, 0.6), (0.74, 0.8), (0.72, 0.86), (0.86, 0.93), (0.86, 0.95),
        (0.7, 0.88), (0.7, 0.7),
    ])  # fmt: skip
    b.lathe(spec.material("brew"), [(r * 0.76, h * 0.7), (r * 0.73, h * 0.84), (0.004, h * 0.85)], segments=28)
    for k, (x, y) in enumerate(((0.3, 0.1), (-0.25, 0.3), (-0.1, -0.4), (0.2, -0.25))):
        center = (x * r, y * r, h * 0.845)
        b.sphere(spec.material("brew"), center, r * (0.1 + 0.03 * k), scale=(1, 1, 0.7), segments=12, rings=7)
    for k in range(3):
        with b.at(rotation=(0, 0, 120 * k + 30)):
            path = [(r * 0.6, 0, h * 0.2), (r * 0.82, 0, h * 0.1), (r * 0.85, 0, 0.0)]
            b.tube(iron, bent(path), tuple(bent((0.045, 0.03, 0.02))))
    for x in (-1, 1):
        with b.at((x * r * 0.92, 0, h * 0.74), (90, 0, 90)):
            ring = [(0.05 * math.cos(a), 0.05 * math.sin(a), 0) for a in np.linspace(0, math.tau, 18, endpoint=False)]
            b.tube(iron, ring, 0.01, segments=6, closed=True)
    return ()


@prop("ladle")
def ladle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a ladle that lies with its bowl at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    r = w / 2
    bowl = [
        (0.004, 0.0), (r * 0.7, h * 0.12), (r, h * 0.55), (r * 0.93, h * 0.55), (r * 0.64, h * 0.2), (0.004, h * 0.08),
    ]  # fmt: skip
    b.lathe(body, bent(bowl, 2), origin=(0, -d / 2 + r, 0), segments=22)
    path = [(0, -d / 2 + 1.95 * r, h * 0.5), (0, -d * 0.2, h * 0.85), (0, d * 0.3, h * 0.6), (0, d / 2, h * 0.5)]
    b.tube(body, bent(path), 0.006)
    return two_hands((-0.014, d * 0.28, h * 0.6), (0.2, -1, 0), (1, 0.2, 0), (0.9, 0.9, 0.5))


@prop("rolling_pin")
def rolling_pin(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rolling pin along X."""
    (w, _, h), wood, r = spec.size, spec.material("wood"), spec.size[2] / 2
    outline = [
        (r * 0.3, 0), (r * 0.5, 0.01), (r * 0.5, w * 0.14), (r * 0.34, w * 0.19), (r, w * 0.2), (r, w * 0.8),
        (r * 0.34, w * 0.81),
    ]  # fmt: skip
    b.lathe(
        wood, [*outline, (r * 0.5, w * 0.86), (r * 0.5, w - 0.01), (r * 0.3, w)], origin=(-w / 2, 0, r), axis=(1, 0, 0)
    )
    return two_hands((-w * 0.42, 0.0, h + 0.004), (0.1, -0.95, -0.3), (0, -0.2, -0.98), (0.6, 0.65, 0.4))


@prop("cutting_board")
def cutting_board(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cutting board with a hole to hang it by."""
    (w, d, h), wood = spec.size, spec.material("wood")
    b.rounded_box(wood, (0, -d * 0.08, h / 2), (w, d * 0.84, h), 0.008)
    for x in (-1, 1):
        b.rounded_box(wood, (x * 0.028, d * 0.41, h / 2), (0.03, d * 0.18, h), 0.008)
    b.rounded_box(wood, (0, d * 0.48, h / 2), (0.08, d * 0.05, h), 0.008)
    return grips_under(d * 0.4)


@prop("pizza_box")
def pizza_box(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flat carton with a printed lid."""
    (w, d, h), card = spec.size, spec.material("card")
    b.box(card, (0, 0, h * 0.48), (w - 0.006, d - 0.006, h * 0.94), bevel=0.002)
    b.box(card, (0, 0, h - 0.002), (w, d, 0.004), bevel=0.001)
    b.box(card, (0, -d / 2 + 0.001, h * 0.72), (w, 0.002, h * 0.55))
    b.lathe(spec.material("print"), [(w * 0.3, h), (w * 0.3, h + 0.0015), (0.004, h + 0.0015)], segments=28)
    for k in range(5):
        end = (w * 0.17 * math.cos(1.26 * k), w * 0.17 * math.sin(1.26 * k), h + 0.0025)
        b.cylinder(
            "linen", (w * 0.17 * math.cos(1.26 * k), w * 0.17 * math.sin(1.26 * k), h), end, w * 0.05, segments=14
        )
    return grips_under(d * 0.42)


@prop("egg")
def egg(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an egg that stands on its blunt end."""
    turned(
        b,
        spec,
        "shell",
        [(0.02, 0.0), (0.62, 0.08), (0.97, 0.32), (0.98, 0.48), (0.78, 0.76), (0.4, 0.95), (0.02, 1.0)],
    )
    return grips_around(spec.size[0] / 2, spec.size[2] * 0.5, (0.5, 0.55, 0.4))


@prop("banana")
def banana(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bunch of three bananas."""
    (_, d, h), skin = spec.size, spec.material("skin")
    for k, turn in enumerate((-16, 0, 16)):
        with b.at((0.012 * (k - 1), d * 0.4, h * 0.55), (0, 0, turn)):
            curve = [
                (0, 0.03, 0.02), (0, -d * 0.15, h * 0.02), (0, -d * 0.5, -h * 0.22), (0, -d * 0.82, h * 0.02),
                (0, -d * 0.93, h * 0.2),
            ]  # fmt: skip
            path = bent(curve)
            thick = np.interp(
                np.linspace(0, 1, len(path)), (0, 0.12, 0.3, 0.75, 0.95, 1), (0.007, 0.009, 0.018, 0.018, 0.007, 0.004)
            )
            b.tube(skin, path, tuple(float(r) for r in thick), segments=6)
    b.cylinder("bark", (0, d * 0.42, h * 0.6), (0, d * 0.5, h * 0.75), 0.014, 0.009, segments=8)
    return two_hands((-0.03, d * 0.3, h * 0.5), (0.2, -1, 0), (1, 0.2, 0), (0.6, 0.65, 0.4))
