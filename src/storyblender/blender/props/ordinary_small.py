"""Prop builders: small things that are worn or carried: ties, belt, curlers, whistle, crutch, drumsticks, feather."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_pinching, two_hands
from storyblender.blender.props.ordinary_hardware import ring_of
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop


@prop("necktie")
def necktie(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a necktie laid flat, its knot and loop at +Y, striped."""
    (w, d, h), silk, stripe = spec.size, spec.material("silk"), spec.material("stripe")
    b.extrude(silk, np.multiply([(0, -0.5), (0.5, -0.43), (0.24, 0.24), (-0.24, 0.24), (-0.5, -0.43)], (w, d)), 0.4 * h)
    for k in range(6):
        y = (-0.4 + 0.1 * k) * d
        half = (0.5 - 0.26 * (y / d + 0.43) / 0.67) * w
        edge = [(-half, y), (half, y + 0.03 * d), (half, y + 0.05 * d), (-half, y + 0.02 * d)]
        b.extrude(stripe, edge, 0.06 * h, base=0.38 * h)
    b.box(silk, (0, 0.27 * d, 0.5 * h), (0.5 * w, 0.07 * d, h), bevel=0.003, taper=0.8)
    loop = [(0.1, 0.29), (0.6, 0.36), (0.7, 0.44), (0, 0.49), (-0.7, 0.44), (-0.6, 0.36), (-0.1, 0.29)]
    band = bent([(x * w, y * d, 0) for x, y in loop], 4)
    side = np.array((0, 0, 0.5 * h))
    inner = band * (0.8, 0.97, 1)
    b.loft(silk, [np.array([at, near, near + side, at + side]) for at, near in zip(band, inner, strict=True)])
    return grips_pinching(0.25 * d, 0.0)


@prop("bow_tie")
def bow_tie(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bow tie that stands and faces -Y."""
    (w, d, h), silk = spec.size, spec.material("silk")
    t = np.linspace(0, math.tau, 21)[:-1]
    for x in (-1, 1):
        rings = []
        for along, tall, deep in bent([(0.06, 0.3, 0.3), (0.24, 0.7, 0.5), (0.4, 0.98, 0.36), (0.5, 0.94, 0.1)], 3):
            fold = deep * (1 + 0.4 * np.cos(3 * t) * (0.5 - along))
            rings.append(np.c_[np.full(20, x * along * w), fold * d * np.cos(t), (0.5 + tall / 2 * np.sin(t)) * h])
        b.loft(silk, rings)
    b.cushion(silk, (0, 0, 0.5 * h), (0.15 * w, 0.95 * d, 0.4 * h), softness=0.4)
    return grips_pinching(-0.02, 0.3 * h)


@prop("belt")
def belt(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rolled leather belt that lies on its edge, its buckle out to -Y."""
    (w, d, h), leather, metal = spec.size, spec.material("leather"), spec.material("buckle")
    r = min(w, 0.75 * d) / 2
    t = np.linspace(0, 3.25, 80)
    reach = r * (0.55 + 0.45 * t / 3.25)
    roll = np.c_[reach * np.cos(math.tau * t), d / 2 - r + reach * np.sin(math.tau * t)]
    end = bent([roll[-1], (0.4 * w, 0.0), (0.2 * w, -0.38 * d)], 5)[1:]
    path = np.concatenate([roll, end])
    way = np.gradient(path, axis=0)
    out = np.c_[way[:, 1], -way[:, 0]] / np.linalg.norm(way, axis=1, keepdims=True) * 0.002
    rings = [
        np.array([(*(p - o), 0), (*(p + o), 0), (*(p + o), h), (*(p - o), h)]) for p, o in zip(path, out, strict=True)
    ]
    b.loft(leather, rings)
    with b.at((path[-1][0], path[-1][1], h / 2), (90, 0, 62)):
        frame = [(-0.02, -0.6 * h), (0.03, -0.6 * h), (0.03, 0.6 * h), (-0.02, 0.6 * h)]
        b.tube(metal, np.c_[frame, np.zeros(4)], 0.003, segments=6, closed=True)
        b.cylinder(metal, (-0.02, 0, 0), (0.032, 0, 0.002), 0.0022, segments=6)
    return grips_around(r, h * 0.5, FIST)


@prop("hair_curlers")
def hair_curlers(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build five hair curlers in a heap: open ribbed tubes with rims."""
    (w, d, h), body = spec.size, spec.material("body")
    r, long = 0.24 * h, 0.48 * w
    places = ((-0.26, -0.2, 0, 8), (0.24, -0.22, 0, -14), (-0.24, 0.22, 0, -6), (0.26, 0.2, 0, 20), (0, 0, 1, 35))
    for x, y, row, turn in places:
        with b.at((x * w, y * d, r * (1 + 1.9 * row)), (0, 0, turn)):
            profile = [(r, 0), (r, 0.06 * long), (0.86 * r, 0.08 * long)]
            outline = [*profile, *((q, long - z) for q, z in profile[::-1]), (0.7 * r, long), (0.7 * r, 0), (r, 0)]
            b.lathe(body, outline, origin=(-long / 2, 0, 0), axis=(1, 0, 0), segments=18, caps=False)
            for k in range(9):
                a = math.tau * k / 9
                rib = np.array([(s * 0.42 * long, 0.88 * r * math.cos(a), 0.88 * r * math.sin(a)) for s in (-1, 1)])
                b.tube(body, rib, 0.09 * r, segments=5)
    return grips_around(0.3 * w, 0.5 * h, (0.4, 0.45, 0.3))


@prop("whistle")
def whistle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a referee's whistle that lies on its side, its mouthpiece to -Y, a cord through its ring."""
    (w, d, h), metal = np.array(spec.size) * (0.5, 0.4, 1.05), spec.material("metal")
    r = 0.46 * h
    b.cylinder(metal, (-0.32 * w, 0, r), (0.32 * w, 0, r), r, segments=24)
    b.box(metal, (0, -0.28 * d, 2 * r - 0.22 * h), (0.64 * w, 0.44 * d, 0.42 * h), bevel=0.002)
    b.box("plastic_black", (0, -0.18 * d, 2 * r), (0.5 * w, 0.06 * d, 0.02 * h))
    b.box("plastic_black", (0, -d / 2, 2 * r - 0.22 * h), (0.46 * w, 0.001, 0.2 * h))
    with b.at((0, 0.3 * d, r), (0, 90, 0)):
        b.tube(metal, ring_of(0.14 * d), 0.0012, closed=True)
    cord = [(0, 0.42, 0.4), (0.6, 0.48, 0.08), (1.0, 1.3, 0.08), (0.1, 1.9, 0.08), (-0.9, 1.3, 0.08), (-0.4, 0.5, 0.08)]
    b.tube(spec.material("cord"), bent([(x * w, y * d, z * h) for x, y, z in [*cord, cord[0]]]), 0.0012, segments=6)
    return grips_pinching(0.0, 0.5 * h)


@prop("crutch")
def crutch(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an underarm crutch with a padded top, a hand grip and a rubber foot; or a pair."""
    (w, d, h), wood = spec.size, spec.material("wood")
    for x0 in (-1, 1) if spec.flag("pair") else (0,):
        with b.at((0.65 * x0 * w, 0, 0)):
            for x in (-1, 1):
                side = [(0.04, 0.06), (0.09, 0.3), (0.42, 0.62), (0.46, 0.8), (0.44, 0.97)]
                b.tube(wood, bent([(x * i * w, 0, z * h) for i, z in side]), 0.012, segments=8)
            b.lathe("rubber", [(0.02, 0), (0.022, 0.02), (0.014, 0.05)])
            b.cylinder(wood, (0, 0, 0.03), (0, 0, 0.3 * h), 0.013)
            pad = bent([(-0.5 * w, 0, 0.97 * h), (0, 0, 0.955 * h), (0.5 * w, 0, 0.97 * h)])
            b.tube(spec.material("pad"), pad, 0.5 * d, segments=10)
            b.cylinder(spec.material("pad"), (-0.44 * w, 0, 0.66 * h), (0.44 * w, 0, 0.66 * h), 0.016)
    return two_hands((0.0, 0.014, 0.67 * h), (0.9, -0.3, 0), (0, -0.3, -0.95), FIST)


@prop("drumstick")
def drumstick(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a drumstick that lies along Y, its bead to -Y; or a pair, crossed."""
    (_, d, h), wood = spec.size, spec.material("wood")
    r = h / 2
    outline = [
        (0.5, 0), (0.9, 0.01), (1, 0.03), (1, 0.7), (0.5, 0.93), (0.42, 0.955), (0.7, 0.975), (0.6, 0.992), (0, 1),
    ]  # fmt: skip
    turns = (-14, 14) if spec.flag("pair") else (0,)
    for k, turn in enumerate(turns):
        with b.at((0, 0, r + k * h), (0, 0, turn)):
            b.lathe(wood, [(x * r, z * d) for x, z in outline], origin=(0, d / 2, 0), axis=(0, -1, 0), segments=14)
    return two_hands((-r, 0.3 * d, r), (0.3, -0.9, -0.2), (0.9, 0.3, 0.2), (0.75, 0.85, 0.5))


@prop("feather")
def feather(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a feather that lies flat, its quill to +Y."""
    (w, d, h), vane = spec.size, spec.material("vane")
    spine = bent([(0.0, 0.5, 0.1), (0.04, 0.2, 0.3), (0.02, -0.2, 0.7), (-0.12, -0.5, 0.4)], 6) * (w, d, h)
    b.tube("wax", spine, list(np.linspace(0.0016, 0.0004, len(spine))), segments=6)
    tips = np.clip(np.linspace(-0.35, 1, len(spine)), 0, 1)
    for x in (-1, 1):
        half = 0.42 * w * np.sin(math.pi * np.sqrt(tips)) ** 0.7 * (1 + 0.08 * np.sin(7 * np.arange(len(spine))))
        edge = spine + np.c_[x * half, -0.35 * half, np.full(len(spine), -0.05 * h) - 0.1 * half]
        b.loft(
            vane, [np.array([p, e, e - (0, 0, 0.0006), p - (0, 0, 0.0006)]) for p, e in zip(spine, edge, strict=True)]
        )
    return grips_pinching(0.42 * d, 0.0)


@prop("leash")
def leash(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dog's lead, loosely coiled, with a hand loop and a snap hook at -Y."""
    (w, d, h), strap = spec.size, spec.material("strap")
    t = np.linspace(0, 2.5, 70)
    reach = 0.46 * w * (1 - 0.18 * t)
    coil = np.c_[reach * np.cos(math.tau * t), 0.1 * d + reach * 0.8 * np.sin(math.tau * t), h * (0.2 + 0.28 * t)]
    tail = [(0.42, -0.1, 0.2), (0.2, -0.34, 0.2), (0, -0.42, 0.2)]
    b.tube(strap, coil, 0.005, segments=6)
    b.tube(strap, bent([coil[0], *((x * w, y * d, z * h) for x, y, z in tail)]), 0.005, segments=6)
    loop = [coil[-1], (-0.5 * w, 0.3 * d, h), (-0.42 * w, 0.5 * d, h), (-0.2 * w, 0.44 * d, h), coil[-1]]
    b.tube(strap, bent(loop), 0.005, segments=6)
    with b.at((0, -0.46 * d, 0.2 * h), scale=(0.7, 1.3, 1)):
        b.tube("chrome", ring_of(0.04 * d), 0.0024, closed=True)
    return grips_around(0.46 * w, 0.5 * h, FIST)


@prop("megaphone")
def megaphone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hand megaphone that speaks to -Y, a pistol grip below."""
    (w, d, h), horn, grip = spec.size, spec.material("horn"), spec.material("grip")
    r, z = w / 2, h - w / 2
    bell = bent([(0.34, 0.3), (0.42, 0.5), (0.62, 0.75), (0.94, 0.97), (1.0, 1.0)], 4)
    inside = bell[::-1] * (0.94, 1) - (0, 0.01)
    b.lathe(horn, np.concatenate([bell, inside]) * (r, d), origin=(0, d / 2, z), axis=(0, -1, 0), segments=32)
    profile = [(0.4 * r, 0), (0.44 * r, 0.02 * d), (0.44 * r, 0.3 * d), (0.36 * r, 0.33 * d)]
    b.lathe(grip, profile, origin=(0, d / 2, z), axis=(0, -1, 0))
    b.lathe(grip, np.multiply([(0.22, 0.5), (0.22, 0.8), (0.1, 0.84)], (r, d)), origin=(0, d / 2, z), axis=(0, -1, 0))
    b.rounded_box(grip, (0, 0.34 * d, 0.5 * z), (0.032, 0.04, z), 0.012, rotation=(8, 0, 0))
    b.box("fabric_red", (0, 0.34 * d - 0.026, 0.74 * z), (0.014, 0.012, 0.03))
    return two_hands((-0.016, 0.34 * d, 0.5 * z), (0.1, -1, -0.1), (1, 0.1, 0), FIST)


@prop("toothbrush")
def toothbrush(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a toothbrush that lies on its back, its bristles at -Y pointing up."""
    (w, d, h), body = spec.size, spec.material("body")
    curve = [(0, 0.49, 0.24), (0, 0.2, 0.3), (0, -0.1, 0.22), (0, -0.28, 0.2)]
    b.tube(body, bent(curve) * (w, d, h), [0.3 * w] * 5 + [0.42 * w] * 4 + [0.22 * w] * 4, segments=10)
    b.rounded_box(body, (0, -0.4 * d, 0.22 * h), (0.9 * w, 0.2 * d, 0.3 * h), 0.0025)
    for row in range(8):
        for x in (-0.27, 0, 0.27):
            y = (-0.475 + 0.021 * row) * d
            key = spec.material("bristle") if row not in (3, 4) else "fabric_blue"
            b.cylinder(key, (x * w, y, 0.3 * h), (x * w, y, (1 - 0.06 * (x == 0)) * h), 0.13 * w, segments=6)
    return two_hands((-0.012, 0.3 * d, 0.3 * h), (0.3, -0.9, -0.2), (0.9, 0.3, 0.2), (0.75, 0.8, 0.6))


@prop("toothpaste")
def toothpaste(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tube that lies flat, its cap to -Y, the fold at +Y."""
    (w, d, h), body = spec.size, spec.material("body")
    t = np.linspace(0, math.tau, 21)[:-1]
    rings = [
        np.c_[x * w / 2 * np.cos(t), np.full(20, y * d), h / 2 + z * h / 2 * np.sin(t)]
        for y, x, z in ((-0.36, 0.3, 0.45), (-0.32, 0.75, 1.0), (-0.1, 0.82, 0.95), (0.3, 0.98, 0.4), (0.46, 1, 0.1))
    ]
    b.loft(body, rings)
    b.box(body, (0, 0.48 * d, h / 2), (w, 0.05 * d, 0.14 * h))
    b.loft(spec.material("band"), [ring * (1.01, 1, 1.01) for ring in rings[2:4]], caps=False)
    cap = [(0.3 * w, 0), (0.34 * w, 0.02 * d), (0.28 * w, 0.14 * d)]
    b.lathe(spec.material("cap"), cap, origin=(0, -0.36 * d, h / 2), axis=(0, -1, 0), segments=18)
    return two_hands((-0.4 * w, 0.1 * d, h / 2), (0.3, -0.9, 0), (0.95, 0.2, 0), (0.6, 0.65, 0.5))
