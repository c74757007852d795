"""Prop builders: what is on tables: mug, paper cup, water bottle, spoon, chopsticks, cookie, carrot, lollipop, dice."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_around, grips_pinching, two_hands
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

_CUTLERY = ((0.3, -0.9, -0.2), (0.9, 0.3, 0.2), (0.75, 0.8, 0.6))


@prop("mug")
def mug(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a straight mug with a handle at +X, full of something dark."""
    r, h, body = spec.size[1] / 2, spec.size[2], spec.material("body")
    with b.at((r - spec.size[0] / 2, 0, 0)):
        wall = [(0.9, 0), (1, 0.03), (1, 0.97), (0.97, 1), (0.9, 0.97), (0.9, 0.84)]
        b.lathe(body, [(x * r, z * h) for x, z in wall], segments=32)
        b.lathe(spec.material("drink"), [(0.9 * r, 0.84 * h), (0.9 * r, 0.845 * h)], segments=32)
        ear = bent([(0.95, 0, 0.82), (1.5, 0, 0.8), (1.72, 0, 0.5), (1.45, 0, 0.22), (0.95, 0, 0.2)]) * (r, 1, h)
        b.tube(body, ear, 0.13 * r, segments=10)
    ring = two_hands((-r * 0.95, 0.012, 0.5 * h), (0.25, -1, 0), (1, 0.2, 0), (0.45, 0.5, 0.4))
    return ring


@prop("paper_cup")
def paper_cup(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a paper cup to take away, with a sleeve and a lid."""
    r, h = spec.size[0] / 2, spec.size[2]
    b.lathe(spec.material("paper"), [(0.7 * r, 0), (0.95 * r, 0.9 * h)], segments=28)
    b.lathe(spec.material("sleeve"), [(0.785 * r, 0.24 * h), (0.905 * r, 0.68 * h)], segments=28, caps=False)
    lid = np.multiply([(0.97, 0.88), (1, 0.89), (1, 0.92), (0.9, 0.93), (0.84, 1), (0.76, 1), (0.74, 0.97)], (r, h))
    b.lathe(spec.material("lid"), lid, segments=28)
    b.box("plastic_black", (0, -0.6 * r, 0.972 * h), (0.2 * r, 0.08 * r, 0.004 * h))
    return grips_around(0.82 * r, 0.45 * h, (0.45, 0.5, 0.4))


@prop("water_bottle")
def water_bottle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a clear plastic bottle of water with waists, a label and a screw cap."""
    r, h, clear = spec.size[0] / 2, spec.size[2], spec.material("bottle")
    side = [(0.85, 0), (0.97, 0.02), (1, 0.1), (0.93, 0.13), (1, 0.16), (1, 0.3), (0.93, 0.33), (1, 0.36), (1, 0.62)]
    neck = [(0.96, 0.7), (0.7, 0.8), (0.42, 0.87), (0.4, 0.92)]
    b.lathe(clear, [(x * r, z * h) for x, z in [*side, *neck]], segments=28)
    b.lathe(spec.material("label"), [(1.01 * r, 0.4 * h), (1.01 * r, 0.6 * h)], segments=28, caps=False)
    b.lathe(spec.material("cap"), [(0.48 * r, 0.91 * h), (0.5 * r, 0.92 * h), (0.48 * r, h)], segments=20)
    return grips_around(r, 0.35 * h, (0.45, 0.5, 0.4))


@prop("spoon")
def spoon(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a spoon that lies with its hollow up at -Y."""
    (w, d, h), metal = spec.size, spec.material("metal")
    t = np.linspace(0, math.tau, 25)[:-1]
    shape = np.c_[0.5 * w * np.cos(t) * (1 - 0.12 * np.sin(t)), 0.17 * d * np.sin(t)]
    bowl = [np.c_[shape * s, np.full(24, z * h)] for s, z in ((0.02, 0.0), (0.6, 0.1), (0.9, 0.4), (1.0, 0.66))]
    inside = [ring * (0.95, 0.97, 1) + (0, 0, 0.06 * h) for ring in bowl[::-1]]
    with b.at((0, -0.33 * d, 0)):
        b.loft(metal, [*bowl, *inside])
    stem = bent([(0, -0.17, 0.7), (0, -0.05, 0.9), (0, 0.25, 0.6), (0, 0.48, 0.5)]) * (1, d, h)
    wide = np.interp(stem[:, 1], (-0.17 * d, 0, 0.48 * d), (0.12 * w, 0.11 * w, 0.26 * w))
    rings = [
        at + np.array([(-half, 0, 0), (0, 0, 0.0012), (half, 0, 0), (0, 0, -0.0012)])
        for at, half in zip(stem, wide, strict=True)
    ]
    b.loft(metal, rings)
    return two_hands((-0.012, 0.2 * d, 0.006), *_CUTLERY)


@prop("chopsticks")
def chopsticks(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pair of chopsticks that lies side by side, the points to -Y."""
    (w, d, h), wood = spec.size, spec.material("wood")
    for x, turn in ((-0.25, 1.5), (0.25, -1.5)):
        with b.at((x * w, 0, h / 2), (0, 0, turn)):
            b.cylinder(wood, (0, 0.5 * d, 0), (0, -0.5 * d, 0), 0.48 * h, 0.2 * h, segments=8)
            b.cylinder(spec.material("band"), (0, 0.44 * d, 0), (0, 0.36 * d, 0), 0.5 * h, segments=8)
    return two_hands((-0.012, 0.15 * d, 0.006), *_CUTLERY)


@prop("cookie")
def cookie(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cookie with chips of chocolate."""
    r, h = spec.size[0] / 2, spec.size[2]
    edge = [(0.9, 0), (1, 0.2), (0.98, 0.5), (0.8, 0.85), (0.4, 0.95), (0.0, 0.97)]
    b.lathe(spec.material("dough"), [(x * r, z * h) for x, z in edge], segments=26)
    for k in range(13):
        turn, reach = 2.4 * k, 0.85 * r * math.sqrt((k + 0.3) / 13)
        z = float(np.interp(reach / r, (0, 0.4, 0.8, 1), (0.97, 0.95, 0.85, 0.5))) * h
        b.sphere(
            spec.material("chip"), (reach * math.cos(turn), reach * math.sin(turn), z), 0.09 * r, segments=8, rings=5
        )
    return two_hands((-r, 0.0, h / 2), (0.2, -0.95, -0.1), (0.95, 0, -0.2), (0.4, 0.45, 0.6))


@prop("carrot")
def carrot(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a carrot that lies with its tip to -Y, its leaves to +Y."""
    (_, d, h), root, leaf = spec.size, spec.material("root"), spec.material("leaf")
    r = 0.42 * h
    ribs = [(1 - 0.6 * t**1.4 - 0.04 * (k % 2), t) for k, t in enumerate(np.linspace(0.05, 0.94, 16))]
    outline = [(0.5 * r, 0), *((x * r, t * 0.68 * d) for x, t in ribs), (0.001, 0.68 * d)]
    b.lathe(root, outline, origin=(0, 0.18 * d, r), axis=(0, -1, 0), segments=16)
    for k in range(6):
        side, up = 0.9 * math.cos(2.4 * k), 0.5 + 0.5 * math.sin(2.4 * k)
        curve = [
            (0, 0.17 * d, r),
            (side * 0.5 * r, 0.3 * d, r * (1 + 0.3 * up)),
            (side * 1.6 * r, 0.48 * d, r * (0.3 + 1.2 * up)),
        ]
        path = bent(curve)
        b.tube(leaf, path, list(np.linspace(0.0022, 0.0008, len(path))), segments=5)
        for at in path[4::2]:
            b.sphere(leaf, at, 0.007, scale=(1.2, 1, 0.4), segments=7, rings=4)
    return two_hands((-r, 0.0, r), (0.3, -0.9, 0), (0.95, 0.2, 0), (0.7, 0.75, 0.5))


@prop("lollipop")
def lollipop(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flat swirled lollipop on its stick, facing -Y."""
    (w, d, h), candy, swirl = spec.size, spec.material("candy"), spec.material("swirl")
    r = w / 2
    b.cylinder("linen", (0, 0, 0), (0, 0, h - r), 0.0022, segments=8)
    disc = [(0.9 * r, -0.5 * d), (r, -0.2 * d), (r, 0.2 * d), (0.9 * r, 0.5 * d)]
    b.lathe(candy, disc, origin=(0, 0, h - r), axis=(0, 1, 0), segments=28)
    t = np.linspace(0.1, 1, 50)
    for side in (-1, 1):
        turn = 5.5 * math.pi * t
        line = np.c_[0.92 * r * t * np.cos(turn), np.full(50, 0.48 * side * d), h - r + 0.92 * r * t * np.sin(turn)]
        b.tube(swirl, line, 0.06 * r, segments=6)
    return two_hands((-0.006, 0.006, 0.3 * h), (0.2, -1, 0), (1, 0.15, 0), (0.7, 0.85, 0.6))


@prop("dice")
def dice(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build two dice beside each other."""
    (w, d, h), body, pip = spec.size, spec.material("body"), spec.material("pip")
    for x, y, turn, faces in ((-0.25, 0.1, 20, (5, 3, 6)), (0.25, -0.1, -33, (2, 1, 4))):
        with b.at((x * w, y * d, h / 2), (0, 0, turn)):
            b.rounded_box(body, (0, 0, 0), (h, h, h), 0.12 * h)
            for count, tilt in zip(faces, ((0, 0, 0), (90, 0, 0), (0, 90, 0)), strict=True):
                spots = [(-1, -1), (1, 1), (-1, 1), (1, -1), (-1, 0), (1, 0)][: count - count % 2]
                with b.at(rotation=tilt):
                    for i, j in [*spots, *([(0, 0)] if count % 2 else [])]:
                        start, end = (i * 0.25 * h, j * 0.25 * h, 0.49 * h), (i * 0.25 * h, j * 0.25 * h, 0.505 * h)
                        b.cylinder(pip, start, end, 0.09 * h, segments=10)
    return grips_pinching(0.0, 0.5 * h)


@prop("chocolate_bar")
def chocolate_bar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bar of chocolate that lies flat, unwrapped at its end to -Y."""
    (w, d, h), wrapper, foil = spec.size, spec.material("wrapper"), spec.material("foil")
    b.box(spec.material("chocolate"), (0, 0, 0.35 * h), (0.92 * w, d, 0.7 * h))
    for row in range(3):
        for x in (-0.3, 0.0, 0.3):
            middle = (x * w, (-0.44 + 0.12 * row) * d, 0.82 * h)
            b.box(spec.material("chocolate"), middle, (0.26 * w, 0.1 * d, 0.3 * h), taper=0.8)
    b.box(foil, (0, 0.12 * d, 0.48 * h), (0.96 * w, 0.7 * d, 0.92 * h), bevel=0.001)
    b.box(wrapper, (0, 0.2 * d, 0.5 * h), (w, 0.6 * d, h), bevel=0.002)
    b.box("wax", (0, 0.2 * d, h), (0.7 * w, 0.3 * d, 0.0006))
    return two_hands((-0.5 * w, 0.2 * d, 0.5 * h), (0.2, -0.95, 0), (0.98, 0.1, 0), (0.5, 0.55, 0.5))
