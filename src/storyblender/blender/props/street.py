"""Prop builders: the furniture of streets."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle, lean, seats_in_row
from storyblender.blender.props.parts import square
from storyblender.blender.props.registry import PropSpec, prop


@prop("lamppost")
def lamppost(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cast-iron lamp post with a four-sided lantern."""
    (w, _, h), metal = spec.size, spec.material("metal")
    profile = [
        (0.17, 0), (0.16, 0.1), (0.11, 0.25), (0.085, 0.7), (0.1, 0.74), (0.06, 0.82), (0.045, h - 0.62),
        (0.07, h - 0.58), (0.05, h - 0.52),
    ]  # fmt: skip
    b.lathe(metal, profile, segments=16)
    b.tube(metal, [(-w * 0.46, 0, h - 0.8), (w * 0.46, 0, h - 0.8)], 0.018)
    for x in (-1, 1):
        b.sphere(metal, (x * w * 0.46, 0, h - 0.8), 0.035, segments=12, rings=8)
    low, high = h - 0.5, h - 0.12
    b.loft(spec.material("glow"), [square((0, 0, low), 0.085), square((0, 0, high), w * 0.42)])
    for k in range(4):
        corner = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)][k])
        b.tube(metal, [(*(corner * 0.09), low), (*(corner * w * 0.43), high)], 0.012, segments=6)
    b.loft(
        metal,
        [
            square((0, 0, high), w * 0.5),
            square((0, 0, high + 0.03), w * 0.46),
            square((0, 0, h - 0.02), 0.06),
            square((0, 0, h), 0.02),
        ],
    )
    b.loft(metal, [square((0, 0, low - 0.04), 0.1), square((0, 0, low), 0.095)])
    return (lean((0, -0.1, 1.1), 0.2),)


@prop("hydrant")
def hydrant(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fire hydrant."""
    h, body, metal = spec.size[2], spec.material("body"), spec.material("metal")
    profile = [
        (0.15, 0), (0.15, 0.04), (0.11, 0.06), (0.11, h * 0.58), (0.14, h * 0.6), (0.14, h * 0.66), (0.11, h * 0.7),
        (0.11, h * 0.76), (0.13, h * 0.77), (0.12, h * 0.86), (0.06, h * 0.95), (0.03, h * 0.96), (0.03, h),
    ]  # fmt: skip
    b.lathe(body, profile, segments=22)
    for turn in (0, 90, 180):
        with b.at((0, 0, h * 0.48), (0, 0, turn)):
            b.cylinder(body, (0.08, 0, 0), (0.15, 0, 0), 0.05, segments=16)
            b.cylinder(metal, (0.15, 0, 0), (0.18, 0, 0), 0.056, segments=8)
    return ()


@prop("dumpster")
def dumpster(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dumpster with a sloping lid, on castors."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    front, rear = h * 0.72, h - 0.06
    side = [(-d * 0.44, 0.16), (d * 0.44, 0.16), (d / 2, rear), (-d / 2, front)]
    with b.at((-w / 2 + 0.06, 0, 0), (90, 0, 90)):
        b.extrude(body, side, w - 0.12)
    for k in range(6):
        middle = ((k - 2.5) * (w - 0.2) / 5.4, -d * 0.48, front * 0.56)
        b.box(body, middle, (0.06, 0.06, front * 0.66), bevel=0.01, rotation=(-4, 0, 0))
    slope = math.degrees(math.atan2(rear - front, d))
    for x in (-1, 1):
        center = (x * w * 0.24, 0, (front + rear) / 2 + 0.03)
        b.box(spec.material("lid"), center, (w * 0.47, d + 0.06, 0.05), bevel=0.015, rotation=(slope, 0, 0))
        b.box(metal, (x * (w / 2 - 0.03), 0, h * 0.5), (0.06, d * 0.3, 0.1), bevel=0.01)
        for y in (-1, 1):
            start, end = (x * (w / 2 - 0.24), y * d * 0.34 - 0.02, 0.08), (x * (w / 2 - 0.2), y * d * 0.34 - 0.02, 0.08)
            b.cylinder("rubber", start, end, 0.08, segments=16)
            b.box(metal, (x * (w / 2 - 0.22), y * d * 0.34 - 0.02, 0.13), (0.1, 0.1, 0.08))
    return (handle((0, -d / 2, front), (0, -0.3, 0.95), "lid"),)


@prop("trash_can")
def trash_can(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a galvanised dustbin with its lid."""
    (w, _, h), body, r = spec.size, spec.material("body"), spec.size[0] / 2
    outline = [(r * 0.78, 0)]
    outline += [
        (r * (0.8 + 0.12 * z) + (0.008 if k % 2 else 0.0), h * 0.86 * z) for k, z in enumerate(np.linspace(0.04, 1, 17))
    ]
    b.lathe(body, outline, segments=30)
    b.lathe(body, [(r, h * 0.85), (r, h * 0.89), (r * 0.8, h * 0.93), (0.05, h * 0.96)], segments=30)
    b.tube(body, [(-0.06, 0, h * 0.95), (-0.05, 0, h * 0.99), (0.05, 0, h * 0.99), (0.06, 0, h * 0.95)], 0.01)
    for x in (-1, 1):
        path = [
            (x * r * 0.88, -0.08, h * 0.66),
            (x * w * 0.5, -0.07, h * 0.62),
            (x * w * 0.5, 0.07, h * 0.62),
            (x * r * 0.88, 0.08, h * 0.66),
        ]
        b.tube(body, path, 0.009)
    return (handle((0, 0, h), (0, 0, 1), "lid"),)


@prop("street_sign")
def street_sign(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sign plate on a post."""
    (w, d, h), post = spec.size, spec.material("post")
    b.cylinder(post, (0, 0, 0), (0, 0, h), 0.03)
    b.sphere(post, (0, 0, h), 0.04, segments=12, rings=8)
    tall = w * 0.62
    b.rounded_box(spec.material("plate"), (0, -0.04, h - tall / 2 - 0.08), (w, 0.02, tall), 0.008)
    for z, length in ((0.62, 0.7), (0.4, 0.5)):
        b.box(spec.material("text"), (0, -0.052, h - 0.08 - tall + tall * z), (w * length, 0.004, tall * 0.12))
    b.box(spec.material("text"), (0, -0.051, h - 0.08 - tall / 2), (w * 0.94, 0.002, 0.012))
    b.lathe(post, [(d / 2, 0), (d * 0.45, 0.03), (0.035, 0.06)], segments=16)
    return (lean((0, -0.03, 1.1), 0.1),)


@prop("sandwich_board")
def sandwich_board(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an A-board with chalk writing."""
    (w, d, h), board, frame = spec.size, spec.material("board"), spec.material("frame")
    lean_angle = math.degrees(math.atan2(d / 2 - 0.02, h))
    for turn in (0, 180):
        with b.at(rotation=(0, 0, turn)), b.at((0, -d / 2 + 0.02, 0), (-lean_angle, 0, 0)):
            for x in (-1, 1):
                b.box(frame, (x * (w / 2 - 0.025), 0, h / 2), (0.05, 0.03, h), bevel=0.006)
            for z in (0.12, h - 0.03):
                b.box(frame, (0, 0, z), (w - 0.1, 0.028, 0.06), bevel=0.005)
            b.box(board, (0, 0, h * 0.54), (w - 0.08, 0.014, h * 0.84))
            for k in range(5):
                length = w * float(spec.rng.uniform(0.35, 0.7))
                b.box("porcelain", (0, -0.009, h * (0.84 - 0.13 * k)), (length, 0.003, 0.03 if k else 0.05))
    return ()


@prop("neon_sign")
def neon_sign(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lit sign: a border and BAR in tubes."""
    (w, d, h), tube = spec.size, spec.material("tube")
    b.box(spec.material("board"), (0, d * 0.2, h / 2), (w, d * 0.5, h), bevel=0.02)
    front = -d * 0.28
    border = [(x * w * 0.46, front, h / 2 + z * h * 0.42) for x, z in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    b.tube("neon_blue", border, 0.014, closed=True)
    s = h * 0.25

    def letter(x: float, *strokes: tuple[tuple[float, float], ...]) -> None:
        for stroke in strokes:
            b.tube(tube, [(x + u * s, front, h / 2 + v * s) for u, v in stroke], 0.018, segments=8)

    letter(
        -w * 0.25,
        ((-0.6, -1), (-0.6, 1), (0.3, 1), (0.55, 0.5), (0.3, 0), (-0.6, 0)),
        ((0.3, 0), (0.6, -0.5), (0.3, -1), (-0.6, -1)),
    )
    letter(0.0, ((-0.7, -1), (0, 1), (0.7, -1)), ((-0.42, -0.2), (0.42, -0.2)))
    letter(w * 0.25, ((-0.6, -1), (-0.6, 1), (0.3, 1), (0.55, 0.5), (0.3, 0), (-0.6, 0)), ((0.1, 0), (0.6, -1)))
    return ()


@prop("traffic_light")
def traffic_light(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a traffic light."""
    (w, _, h), body, post = spec.size, spec.material("body"), spec.material("post")
    b.lathe(post, [(0.14, 0), (0.13, 0.1), (0.055, 0.16), (0.05, h - 0.2)], segments=16)
    b.rounded_box(body, (0, 0, h - 0.48), (w * 0.9, 0.24, 0.96), 0.05)
    for k, kind in enumerate(("leaves", "brass", "neon_red")):
        z = h - 0.78 + 0.3 * k
        profile = [(0.1, 0), (0.06, 0.03), (0.003, 0.04)]
        b.lathe(kind, profile, origin=(0, -0.115, z), axis=(0, -1, 0), segments=20, caps=False)
        visor = [(0.12 * math.cos(a), 0.12 * math.sin(a)) for a in np.linspace(-0.3, math.pi + 0.3, 13)]
        for order in (1, -1):
            rings = [np.array([(x, -0.12 - y, z + up) for x, up in visor])[::order] for y in (0.0, 0.15)]
            b.loft(body, rings, closed=False)
    return ()


@prop("traffic_cone")
def traffic_cone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a traffic cone."""
    (w, d, h), body, band = spec.size, spec.material("body"), spec.material("band")
    b.box(body, (0, 0, 0.02), (w, d, 0.04), bevel=0.01)
    b.lathe(body, [(w * 0.38, 0.03), (w * 0.1, h - 0.01), (w * 0.08, h)], segments=24)
    for low in (0.4, 0.66):
        r0, r1 = (w * (0.38 - 0.28 * t) + 0.003 for t in (low, low + 0.14))
        b.lathe(band, [(r0, h * low), (r1, h * (low + 0.14))], segments=24, caps=False)
    return ()


@prop("park_bench")
def park_bench(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a slatted bench on iron sides."""
    (w, d, h), wood, iron = spec.size, spec.material("wood"), spec.material("iron")
    sit, front, back = 0.45, -d / 2, d / 2
    for k in range(5):
        b.box(wood, (0, front + 0.07 + 0.092 * k, sit - 0.015 - 0.006 * k), (w, 0.075, 0.03), bevel=0.006)
    for k in range(4):
        center = (0, back - 0.12 + 0.028 * k, sit + 0.1 + 0.09 * k)
        b.box(wood, center, (w, 0.026, 0.072), bevel=0.006, rotation=(-16, 0, 0))
    for x in (-1, 0, 1):
        at = x * (w / 2 - 0.1)
        line = [
            (at, front + 0.02, 0), (at, front + 0.08, sit * 0.5), (at, front + 0.05, sit - 0.04),
            (at, back - 0.16, sit - 0.06), (at, back - 0.02, h),
        ]  # fmt: skip
        b.tube(iron, line, 0.022)
        b.tube(iron, [(at, back - 0.02, 0), (at, back - 0.14, sit * 0.5), (at, back - 0.15, sit - 0.05)], 0.022)
        if x:
            path = [
                (at, front + 0.05, sit - 0.02),
                (at, front + 0.04, sit + 0.2),
                (at, front + 0.14, sit + 0.23),
                (at, back - 0.1, sit + 0.2),
            ]
            b.tube(iron, path, 0.018)
    return seats_in_row(spec.entry.seats, w - 0.16, front + 0.03, sit, d - 0.18)


@prop("mailbox")
def mailbox(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pillar box."""
    (w, _, h), body, iron, r = spec.size, spec.material("body"), spec.material("metal"), spec.size[0] / 2
    b.lathe(iron, [(r * 0.96, 0), (r * 0.96, 0.12)], segments=30)
    profile = [(r * 0.9, 0.12), (r * 0.9, h * 0.82), (r, h * 0.84), (r, h * 0.9), (r * 0.9, h * 0.94), (r * 0.3, h)]
    b.lathe(body, profile, segments=30)
    b.box(iron, (0, -r * 0.9, h * 0.76), (w * 0.5, 0.03, 0.035), bevel=0.006)
    b.box("porcelain", (0, -r * 0.88, h * 0.6), (w * 0.36, 0.03, 0.18), bevel=0.006)
    b.box(body, (0, -r * 0.86, h * 0.38), (w * 0.56, 0.06, h * 0.4), bevel=0.012)
    return ()


@prop("phone_booth")
def phone_booth(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a glazed telephone booth, open at -Y, with its telephone inside."""
    (w, d, h), body = spec.size, spec.material("body")
    b.box(body, (0, 0, 0.06), (w, d, 0.12), bevel=0.01)
    b.box(body, (0, 0, h - 0.12), (w, d, 0.24), bevel=0.03)
    b.box("lampshade", (0, -d / 2 - 0.002, h - 0.13), (w * 0.74, 0.01, 0.12), bevel=0.003)
    for x in (-1, 1):
        for y in (-1, 1):
            b.box(body, (x * (w / 2 - 0.04), y * (d / 2 - 0.04), h / 2), (0.08, 0.08, h), bevel=0.008)
        for k in range(1, 7):
            b.box(body, (x * (w / 2 - 0.04), 0, h * 0.06 + k * h * 0.118), (0.03, d - 0.14, 0.025))
            b.box(body, (0, d / 2 - 0.04, h * 0.06 + k * h * 0.118), (w - 0.14, 0.03, 0.025))
        b.box(body, (x * (w / 2 - 0.04), 0, h * 0.12), (0.04, d - 0.14, h * 0.14))
    b.box(body, (0, d / 2 - 0.04, h * 0.12), (w - 0.14, 0.04, h * 0.14))
    b.box("plastic_black", (0, d / 2 - 0.12, h * 0.6), (0.3, 0.14, 0.46), bevel=0.01)
    b.cylinder("chrome", (0.05, d / 2 - 0.2, h * 0.62), (0.05, d / 2 - 0.18, h * 0.62), 0.06, segments=20)
    b.tube("plastic_black", [(-0.12, d / 2 - y, h * z) for y, z in ((0.22, 0.53), (0.25, 0.6), (0.22, 0.68))], 0.022)
    b.box("wood", (0, d / 2 - 0.18, h * 0.46), (0.5, 0.24, 0.03), bevel=0.006)
    return (handle((-0.12, d / 2 - 0.25, h * 0.6), name="receiver"),)
