"""Prop builders: what stands on squares, in yards, in camps and on bridges."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, lean, seat
from storyblender.blender.props.parts import four_legs, spoked_wheel
from storyblender.blender.props.registry import PropSpec, prop


@prop("market_stall")
def market_stall(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stall with a striped awning and boxes of goods; the buyers are at -Y."""
    (w, d, h), cloth, wood = spec.size, spec.material("cloth"), spec.material("wood")
    for x in (-1, 1):
        for y, tall in ((-1, h - 0.3), (1, h - 0.08)):
            b.box(wood, (x * (w / 2 - 0.06), y * (d / 2 - 0.14), tall / 2), (0.06, 0.06, tall), bevel=0.006)
    stripes = 8
    for k in range(stripes):
        kind = cloth if k % 2 == 0 else "linen"
        x0, x1 = (-w / 2 - 0.05 + (w + 0.1) * i / stripes for i in (k, k + 1))
        edges = [(d / 2, h), (-d / 2, h - 0.34), (-d / 2 - 0.01, h - 0.5)]
        for lift, order in ((0.0, -1), (-0.008, 1)):
            b.loft(kind, [np.array([(x0, y, z + lift), (x1, y, z + lift)])[::order] for y, z in edges], closed=False)
    counter = 0.86
    b.box(wood, (0, -d * 0.12, counter - 0.02), (w - 0.08, d * 0.62, 0.04), bevel=0.006)
    for k in range(5):
        b.box(wood, (0, -d * 0.42, 0.12 + k * 0.16), (w - 0.1, 0.02, 0.13), bevel=0.004)
    goods = (spec.material("goods"), "fabric_red", "leaves", "brass", "wood_light", "leaves_dark")
    for i in range(4):
        x = (i - 1.5) * w * 0.235
        with b.at((x, -d * 0.16, counter), (12, 0, 0)):
            b.box(wood, (0, 0, 0.03), (w * 0.2, d * 0.46, 0.06), bevel=0.004)
            for row in range(3):
                for column in range(3):
                    center = ((column - 1) * 0.11, (row - 1) * 0.16, 0.09)
                    b.sphere(goods[(i + 2 * (row % 2)) % len(goods)], center, 0.06, segments=10, rings=6)
    return (lean((0, -d * 0.43, counter), w), lean((0, d * 0.2, counter), w, (0, -1, 0), "keeper"))


@prop("fence_panel")
def fence_panel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a picket fence."""
    (w, d, h), wood = spec.size, spec.material("wood")
    count = max(4, round(w / 0.16))
    for k in range(count):
        x = (k - (count - 1) / 2) * w / count
        with b.at((x, -d * 0.1, 0), (90, 0, 0)):
            half = w / count * 0.34
            b.extrude(wood, [(-half, 0.04), (half, 0.04), (half, h - 0.1), (0, h), (-half, h - 0.1)], d * 0.25)
    for z in (h * 0.26, h * 0.72):
        b.box(wood, (0, d * 0.1, z), (w, d * 0.35, 0.09), bevel=0.005)
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.05), d * 0.18, h * 0.48), (0.09, d * 0.6, h * 0.96), bevel=0.006)
    return (lean((0, -d / 2, h - 0.05), w),)


@prop("barricade")
def barricade(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a striped barrier on two trestles."""
    (w, d, h), wood, stripe = spec.size, spec.material("wood"), spec.material("stripe")
    for z in (h - 0.12, h * 0.52):
        for k in range(8):
            kind = stripe if k % 2 else "porcelain"
            b.box(kind, ((k - 3.5) * w / 8, 0, z), (w / 8, 0.03, 0.2))
    for x in (-1, 1):
        for y in (-1, 1):
            b.tube(wood, [(x * (w / 2 - 0.14), y * d / 2, 0.03), (x * (w / 2 - 0.14), y * 0.03, h)], 0.03, segments=6)
    return (lean((0, -0.05, h), w),)


@prop("well")
def well(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stone well with a winch under a little roof."""
    (w, d, h), stone, wood, roof = spec.size, spec.material("stone"), spec.material("wood"), spec.material("roof")
    r = w / 2 - 0.05
    profile = [(r, 0), (r, 0.75), (r + 0.05, 0.76), (r + 0.05, 0.86), (r - 0.16, 0.86), (r - 0.16, 0.1)]
    b.lathe(stone, profile, segments=28)
    b.lathe("water", [(r - 0.16, 0.3)] * 2, segments=24)
    for x in (-1, 1):
        b.box(wood, (x * (r - 0.02), 0, h * 0.46), (0.1, 0.1, h * 0.92), bevel=0.01)
    b.cylinder(wood, (-r, 0, 1.35), (r, 0, 1.35), 0.07, segments=12)
    b.tube("iron", [(r, 0, 1.35), (r + 0.09, 0, 1.35), (r + 0.09, -0.16, 1.25), (r + 0.16, -0.16, 1.25)], 0.014)
    b.cylinder("thatch", (0.1, 0, 1.3), (0.1, 0, 1.0), 0.014, segments=8)
    b.lathe(wood, [(0.09, 0.82), (0.12, 1.0), (0.11, 1.0), (0.08, 0.84)], origin=(0.1, 0, 0), segments=16)
    tilt = math.degrees(math.atan2(0.42, d / 2))
    for y in (-1, 1):
        b.box(roof, (0, y * d * 0.26, h - 0.24), (w * 1.06, d * 0.66, 0.05), bevel=0.01, rotation=(tilt * -y, 0, 0))
    return (lean((0, -r, 0.86), w * 0.7),)


@prop("fountain")
def fountain(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a round basin with a bowl on a column."""
    (w, _, h), stone, water = spec.size, spec.material("stone"), spec.material("water")
    r = w / 2
    rim = [(r, 0), (r * 0.97, 0.1), (r * 0.88, 0.14), (r * 0.88, 0.44), (r * 0.96, 0.5), (r * 0.96, 0.56)]
    b.lathe(stone, [*rim, (r * 0.8, 0.56), (r * 0.78, 0.3)], segments=32, caps=False)
    b.lathe(water, [(0.02, 0.46), (r * 0.8, 0.46)], segments=32, caps=False)
    column = [(0.13, 0.14), (0.09, 0.28), (0.07, 0.5), (0.1, 0.56), (0.27, 0.65), (0.29, 0.68), (0.22, 0.66)]
    b.lathe(stone, [(x * w / 1.2, z * h) for x, z in (*column, (0.05, 0.65))], segments=24)
    b.lathe(stone, [(0.1, 0.64 * h), (0.09, 0.8 * h), (0.13, 0.84 * h), (0.04, 0.94 * h), (0.02, h)], segments=16)
    b.lathe(water, [(0.02, 0.672 * h), (0.2 * w, 0.672 * h)], segments=24, caps=False)
    return (lean((0, -r, 0.56), w * 0.4),)


@prop("gravestone")
def gravestone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a round-headed gravestone with an inscription."""
    (w, d, h), stone = spec.size, spec.material("stone")
    b.box(stone, (0, 0, 0.07), (w, d, 0.14), bevel=0.015)
    half = w * 0.42
    arch = [(half * math.cos(a), h - half + half * math.sin(a)) for a in np.linspace(0, math.pi, 17)]
    with b.at((0, d * 0.26, 0), (90, 0, 0)):
        b.extrude(stone, [(half, 0.1), *arch, (-half, 0.1)], d * 0.52)
    for k, length in enumerate((0.5, 0.62, 0.4, 0.56)):
        b.box("iron", (0, -d * 0.262, h * (0.68 - 0.09 * k)), (w * length, 0.006, 0.02))
    b.box("iron", (0, -d * 0.262, h * 0.8), (0.02, 0.006, 0.12))
    b.box("iron", (0, -d * 0.262, h * 0.82), (0.08, 0.006, 0.02))
    return ()


@prop("tent")
def tent(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a ridge tent whose flaps are open at -Y."""
    (w, d, h), cloth, pole = spec.size, spec.material("cloth"), spec.material("pole")
    for y in (-1, 1):
        b.cylinder(pole, (0, y * (d / 2 - 0.06), 0), (0, y * (d / 2 - 0.06), h), 0.025, segments=8)
    for x in (-1, 1):
        rows = []
        for t in np.linspace(0, 1, 7):
            sag = 0.06 * math.sin(math.pi * t)
            rows.append(
                np.array(
                    [
                        (
                            x * w / 2 * t * (1 - 0.04 * math.sin(math.pi * t)),
                            y * d / 2,
                            (h - 0.02) * (1 - t) - sag * (1 - abs(y)),
                        )
                        for y in (-1, -0.5, 0, 0.5, 1)
                    ]
                )
            )
        for lift, order in ((0.0, x), (0.012, -x)):
            b.loft(cloth, [(row - np.array([0, 0, lift]))[::order] for row in rows], closed=False)
        flap = [(x * 0.02, -d / 2, h - 0.05), (x * w / 2, -d / 2, 0.02), (x * w * 0.34, -d / 2 - 0.1, 0.02)]
        b.polygon(cloth, flap)
        b.polygon(cloth, flap[::-1])
        for y in (-0.4, 0.4):
            b.cylinder("thatch", (x * w / 2, y * d, 0.05), (x * (w / 2 + 0.2), y * d, 0.0), 0.006, segments=5)
    b.polygon(cloth, [(-w / 2, d / 2, 0), (0, d / 2, h - 0.02), (w / 2, d / 2, 0)])
    b.polygon(cloth, [(w / 2, d / 2 - 0.01, 0), (0, d / 2 - 0.01, h - 0.02), (-w / 2, d / 2 - 0.01, 0)])
    return ()


@prop("ladder")
def ladder(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a straight ladder, standing."""
    (w, d, h), wood = spec.size, spec.material("wood")
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.02), 0, h / 2), (0.04, d * 0.6, h), bevel=0.008)
    for z in np.arange(0.25, h - 0.1, 0.28):
        b.cylinder(wood, (-w / 2 + 0.02, 0, z), (w / 2 - 0.02, 0, z), 0.016, segments=10)
    return ()


@prop("flag")
def flag(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flag that hangs from its pole."""
    (w, _, h), cloth = spec.size, spec.material("cloth")
    b.lathe("iron", [(0.15, 0), (0.14, 0.03), (0.04, 0.06), (0.03, 0.2)], segments=20)
    b.cylinder(spec.material("pole"), (0, 0, 0.1), (0, 0, h - 0.06), 0.02)
    b.sphere(spec.material("metal"), (0, 0, h - 0.04), 0.04, segments=14, rings=8)
    across = np.linspace(0, 1, 17)
    rows = []
    for t in np.linspace(0, 1, 7):
        reach = (w - 0.15) * (0.9 - 0.25 * t)
        drop = 0.35 * across**1.4 * (1 - 0.3 * t)
        rows.append(np.c_[0.02 + reach * across, 0.1 * np.sin(9 * across + 2 * t) * across, h - 0.12 - 0.85 * t - drop])
    for lift, order in ((0.0, 1), (0.006, -1)):
        b.loft(cloth, [(row + np.array([0, lift, 0]))[::order] for row in rows], closed=False)
    return ()


@prop("swing")
def swing(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a swing in its frame."""
    (w, d, h), frame = spec.size, spec.material("frame")
    for x in (-1, 1):
        for y in (-1, 1):
            b.cylinder(frame, (x * w / 2, y * d / 2, 0), (x * (w / 2 - 0.1), 0, h - 0.04), 0.03, segments=10)
        b.cylinder("iron", (x * 0.24, 0, 0.46), (x * 0.22, 0, h - 0.05), 0.008, segments=6)
    b.cylinder(frame, (-w / 2 + 0.04, 0, h - 0.04), (w / 2 - 0.04, 0, h - 0.04), 0.035, segments=12)
    b.box(spec.material("seat"), (0, 0, 0.46), (0.54, 0.22, 0.03), bevel=0.008)
    return (seat((0, -0.11, 0.475), (0.5, 0.22)),)


@prop("cannon")
def cannon(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a field gun that points to -Y."""
    (w, d, h), iron, wood = spec.size, spec.material("barrel"), spec.material("wood")
    for x in (-1, 1):
        spoked_wheel(b, wood, wood, (x * (w / 2 - 0.06), -d * 0.1, 0.55), 0.5, 0.045, 12)
        b.box(wood, (x * 0.18, d * 0.14, 0.48), (0.1, d * 0.66, 0.16), bevel=0.012, rotation=(-22, 0, 0))
    b.cylinder(iron, (-w / 2 + 0.05, -d * 0.1, 0.55), (w / 2 - 0.05, -d * 0.1, 0.55), 0.04)
    axis = np.array([0, -math.cos(0.14), math.sin(0.14)])
    barrel = [
        (0.03, -0.12), (0.05, -0.08), (0.03, -0.04), (0.17, 0), (0.18, 0.1), (0.16, 0.14), (0.14, 0.7), (0.16, 0.72),
        (0.12, 0.8), (0.1, 1.3), (0.13, 1.36), (0.13, 1.42), (0.07, 1.42), (0.065, 1.2),
    ]  # fmt: skip
    b.lathe(iron, barrel, origin=(0, d * 0.18, h * 0.62), axis=axis, segments=24)
    return ()


@prop("control_console")
def control_console(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a console of screens and buttons; the operator is at -Y."""
    (w, d, h), body, screen, light = spec.size, spec.material("body"), spec.material("screen"), spec.material("light")
    side = np.multiply([(-0.2, 0), (0.5, 0), (0.5, 1), (0.26, 1), (0.02, 0.72), (-0.5, 0.62), (-0.5, 0.54)], (d, h))
    with b.at((-w / 2, 0, 0), (90, 0, 90)):
        b.extrude(body, side, w)
    slope = math.degrees(math.atan2(h * 0.28, d * 0.24))
    for k in range(3):
        with b.at(((k - 1) * w * 0.31, d * 0.137, h * 0.862), (slope - 90, 0, 0)):
            b.box("plastic_black", (0, 0, 0), (w * 0.28, 0.02, h * 0.3), bevel=0.005)
            x, z = w * 0.13, h * 0.135
            b.quad(
                screen,
                (-x, -0.0115, -z),
                (x, -0.0115, -z),
                (x, -0.0115, z),
                (-x, -0.0115, z),
                uv=((0, 0), (1, 0), (1, 1), (0, 1)),
            )
    kinds = (light, "neon_red", "brass", "porcelain", "leaves")
    with b.at((0, -d * 0.24, h * 0.672), (math.degrees(math.atan2(h * 0.1, d * 0.52)), 0, 0)):
        for row in range(4):
            for k in range(18):
                kind = kinds[int(spec.rng.integers(len(kinds)))]
                b.box(
                    kind, ((k - 8.5) * w * 0.05, (row - 1.5) * d * 0.1, 0.008), (w * 0.03, d * 0.05, 0.02), bevel=0.003
                )
    b.box(light, (0, -d / 2 - 0.003, h * 0.58), (w * 0.96, 0.01, 0.02))
    return (lean((0, -d / 2, h * 0.62), w),)


@prop("altar")
def altar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an altar with a cloth."""
    (w, d, h), stone, cloth = spec.size, spec.material("stone"), spec.material("cloth")
    b.box(stone, (0, 0, 0.06), (w * 0.92, d * 0.92, 0.12), bevel=0.015)
    b.box(stone, (0, 0, h / 2), (w * 0.8, d * 0.7, h - 0.1), bevel=0.012)
    b.box(stone, (0, 0, h - 0.05), (w, d, 0.1), bevel=0.02)
    b.box(cloth, (0, 0, h + 0.004), (w * 0.6, d + 0.012, 0.012))
    b.box(cloth, (0, -d / 2 - 0.008, h - 0.2), (w * 0.6, 0.012, 0.42))
    for k in range(14):
        b.box("gold", ((k - 6.5) * w * 0.043, -d / 2 - 0.009, h - 0.43), (0.012, 0.01, 0.06))
    b.box("gold", (0, -d / 2 - 0.016, h - 0.2), (0.03, 0.006, 0.24))
    b.box("gold", (0, -d / 2 - 0.016, h - 0.16), (0.14, 0.006, 0.03))
    four_legs(b, stone, w * 0.84, d * 0.78, h - 0.1, 0.12)
    return ()
