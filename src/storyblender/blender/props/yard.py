"""Prop builders of smithies, stables, nurseries and feasts: anvil, barrow, wheel, cage, lantern of paper."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, handle, two_hands
from storyblender.blender.props.parts import bent, spoked_wheel
from storyblender.blender.props.registry import PropSpec, prop

TURN = np.linspace(0, math.tau, 28, endpoint=False)


@prop("paper_lantern")
def paper_lantern(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a ribbed lantern of paper on its cord; it hangs from a ceiling."""
    (w, _, h), paper, rim = spec.size, spec.material("paper"), spec.material("rim")
    r, tall = w / 2, w * 0.95
    ribs = 9
    profile = []
    for k in range(2 * ribs + 1):
        t = -1 + k / ribs
        profile.append((r * (0.985 if k % 2 else 0.93) * math.sqrt(max(1 - (0.93 * t) ** 2, 0.12)), tall / 2 * (1 + t)))
    b.lathe(paper, profile, segments=28, caps=False)
    for z in (0.0, tall):
        b.lathe(rim, [(r * 0.38, z - 0.012), (r * 0.4, z), (r * 0.38, z + 0.012)], segments=24)
    b.sphere("lamp_warm", (0, 0, tall * 0.5), r * 0.3)
    b.cylinder(rim, (0, 0, tall), (0, 0, h), 0.005, segments=6)
    for k in range(7):
        x, y = 0.012 * math.cos(0.9 * k), 0.012 * math.sin(0.9 * k)
        b.cylinder("fabric_red", (x, y, -0.01), (1.8 * x, 1.8 * y, -w * 0.3), 0.003, segments=5)
    return ()


@prop("water_pump")
def water_pump(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an iron pump on its stone: spout to the front, the handle behind."""
    (w, d, h), iron = spec.size, spec.material("iron")
    r, spout = w * 0.17, h * 0.66
    b.box(spec.material("foot"), (0, 0, h * 0.04), (w, d * 0.8, h * 0.08), bevel=0.02)
    rings = (
        (r * 1.5, 0.08), (r, 0.12), (r, 0.6), (r * 1.25, 0.63), (r * 1.3, 0.84), (r * 1.45, 0.87), (r, 0.93),
        (0.02, 0.96),
    )  # fmt: skip
    b.lathe(iron, [(radius, h * share) for radius, share in rings], segments=20)
    b.tube(iron, [(0, d * y, spout - z) for y, z in ((0, 0), (-0.3, 0), (-0.42, 0.05), (-0.42, 0.12))], r * 0.6)
    lever = [(0, -r, h * 0.98), (0, d * 0.3, h * 0.96), (0, d * 0.42, h * 0.66), (0, d * 0.46, h * 0.42)]
    b.tube(iron, bent(lever, 3), 0.018, segments=8)
    return (handle((0, d * 0.46, h * 0.42)),)


@prop("birdcage")
def birdcage(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a domed cage with a perch and a ring to carry it by."""
    (w, _, h), wire, base = spec.size, spec.material("wire"), spec.material("base")
    r, side, dome = w / 2 * 0.96, h * 0.6, h * 0.9
    b.lathe(base, [(r * 0.98, 0), (r * 1.04, 0.012), (r * 1.04, 0.04), (r * 0.98, 0.045)], segments=28)
    for k in range(22):
        turn = math.tau * k / 22
        x, y = math.cos(turn), math.sin(turn)
        bar = [
            (r * x, r * y, 0.04), (r * x, r * y, side), (r * 0.84 * x, r * 0.84 * y, h * 0.75),
            (r * 0.45 * x, r * 0.45 * y, h * 0.86), (0.01 * x, 0.01 * y, dome),
        ]  # fmt: skip
        b.tube(wire, bent(bar, 2), 0.0028, segments=5)
    for z, k in ((h * 0.3, 1.0), (side, 1.0)):
        b.tube(wire, np.c_[r * k * np.cos(TURN), r * k * np.sin(TURN), np.full(28, z)], 0.004, segments=5, closed=True)
    b.box(wire, (0, -r, h * 0.2), (w * 0.3, 0.008, h * 0.012))
    b.cylinder("wood", (-r * 0.95, 0, h * 0.42), (r * 0.95, 0, h * 0.42), 0.007, segments=8)
    b.lathe(base, [(0.03, dome - 0.012), (0.035, dome), (0.012, dome + 0.012)], segments=14)
    ring = np.c_[0.032 * np.cos(TURN), np.zeros(28), h - 0.034 + 0.032 * np.sin(TURN)]
    b.tube(wire, ring, 0.0035, segments=6, closed=True)
    return two_hands((0, 0, h + 0.004), (0, -0.3, -0.95), (0.0, -0.95, 0.3), (0.9, 0.9, 0.5))


@prop("chalice")
def chalice(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a goblet of metal with stones about its cup."""
    h, r, gold = spec.size[2], spec.size[0] / 2, spec.material("metal")
    outline = [
        (0.8, 0), (0.78, 0.03), (0.3, 0.08), (0.14, 0.2), (0.34, 0.3), (0.14, 0.4), (0.3, 0.47), (0.85, 0.6),
        (1.0, 0.8), (0.96, 1.0), (0.88, 1.0), (0.9, 0.8), (0.75, 0.62), (0.03, 0.52),
    ]  # fmt: skip
    b.lathe(gold, bent([(x * r, z * h) for x, z in outline], 3), segments=26)
    b.lathe(spec.material("drink"), [(r * 0.85, h * 0.8), (r * 0.9, h * 0.88), (0.003, h * 0.88)], segments=24)
    for k in range(8):
        turn = math.tau * k / 8
        center = (r * 0.99 * math.cos(turn), r * 0.99 * math.sin(turn), h * 0.76)
        b.sphere("fabric_red" if k % 2 else "fabric_blue", center, r * 0.11, segments=8, rings=6)
    return grips_around(0.014, h * 0.36, (0.7, 0.75, 0.45))


@prop("anvil")
def anvil(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an anvil on its block; its horn is at -X."""
    (w, d, h), iron, wood = spec.size, spec.material("iron"), spec.material("block")
    block = h * 0.6
    b.lathe(wood, [(d * 0.5, 0), (d * 0.48, block * 0.5), (d * 0.5, block)], segments=22)
    rings = []
    for z, wide, deep in (
        (0.0, 0.5, 0.62),
        (0.12, 0.46, 0.56),
        (0.3, 0.24, 0.34),
        (0.55, 0.24, 0.34),
        (0.75, 0.42, 0.42),
        (1.0, 0.42, 0.42),
    ):
        x, y, at = w * wide / 2, d * deep / 2, block + (h - block) * z
        rings.append(np.add([(-x, -y, at), (x, -y, at), (x, y, at), (-x, y, at)], (w * 0.1, 0, 0)))
    b.loft(iron, rings)
    top = block + (h - block) * 0.84
    b.box(iron, (w * 0.36, 0, top + 0.012), (w * 0.28, d * 0.42, (h - block) * 0.28), bevel=0.006)
    path = [(-w * 0.08, 0, top), (-w * 0.3, 0, top + 0.008), (-w * 0.49, 0, top + 0.025)]
    b.tube(iron, bent(path), tuple(bent((0.048, 0.036, 0.008))), segments=14)
    return ()


@prop("wheelbarrow")
def wheelbarrow(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wheelbarrow; its wheel is at -Y, one pushes from +Y."""
    (w, d, h), tray, wood, iron = spec.size, spec.material("tray"), spec.material("wood"), spec.material("iron")
    radius = h * 0.32
    hub = (0.0, -d / 2 + radius, radius)
    spoked_wheel(b, "rubber", iron, hub, radius - 0.022, 0.022, 8)
    for x in (-1, 1):
        shaft = [
            (x * 0.06, hub[1] - 0.04, radius),
            (x * w * 0.3, -d * 0.1, h * 0.46),
            (x * w * 0.42, d * 0.3, h * 0.62),
            (x * w * 0.43, d / 2, h * 0.68),
        ]
        b.tube(wood, bent(shaft), 0.022)
        b.tube(iron, [(x * w * 0.36, d * 0.16, h * 0.52), (x * w * 0.38, d * 0.2, 0.0)], 0.016)
    foot, rim = h * 0.5, h
    lower = np.multiply([(-0.26, -0.2, 1), (0.26, -0.2, 1), (0.3, 0.2, 1), (-0.3, 0.2, 1)], (w, d, foot))
    upper = np.multiply([(-0.4, -0.36, 0.94), (0.4, -0.36, 0.94), (0.48, 0.28, 1), (-0.48, 0.28, 1)], (w, d, rim))
    inner = [np.multiply(upper, (0.96, 0.96, 1.0)), np.add(np.multiply(lower, (0.96, 0.96, 1.0)), (0, 0, 0.02))]
    b.loft(tray, [lower, upper, *inner])
    b.tube(tray, upper, 0.014, segments=6, closed=True)
    return (handle((0.0, d / 2, h * 0.68), (0.0, 1.0, 0.0), name="push"),)


@prop("wagon_wheel")
def wagon_wheel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a spoked wheel that stands, seen flat from -Y."""
    (_, d, h), wood, iron = spec.size, spec.material("wood"), spec.material("iron")
    r = h / 2
    with b.at((0, 0, r), (0, 0, 90)):
        spoked_wheel(b, wood, wood, (0, 0, 0), r - 0.035, 0.034, 12)
        outline = [(r - 0.004, -d * 0.3), (r, -d * 0.3), (r, d * 0.3), (r - 0.004, d * 0.3)]
        b.lathe(iron, outline, axis=(1, 0, 0), segments=36, caps=False)
        profile = [(r * 0.1, -d * 0.5), (r * 0.17, -d * 0.2), (r * 0.17, d * 0.2), (r * 0.1, d * 0.5)]
        b.lathe(wood, profile, axis=(1, 0, 0), segments=18)
    return ()


@prop("spinning_wheel")
def spinning_wheel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a spinning wheel; one spins at -Y."""
    (w, d, h), wood = spec.size, spec.material("wood")
    b.box(wood, (0, 0, h * 0.36), (w * 0.8, d * 0.36, 0.045), bevel=0.008, rotation=(0, 12, 0))
    for x, y in ((-0.38, 0.0), (0.34, -0.45), (0.34, 0.45)):
        b.cylinder(wood, (x * w * 0.75, y * d * 0.3, h * 0.34), (x * w * 1.15, y * d, 0), 0.024, 0.016)
    r = h * 0.27
    center = np.array((w * 0.2, 0.0, h - r - 0.02))
    with b.at(center, (0, 0, 90)):
        spoked_wheel(b, wood, wood, (0, 0, 0), r, 0.02, 10)
    for y in (-1, 1):
        b.cylinder(wood, (w * 0.22, y * d * 0.14, h * 0.36), np.add(center, (0, y * d * 0.14, 0.03)), 0.018)
    b.cylinder(wood, np.add(center, (0, -d * 0.16, 0)), np.add(center, (0, d * 0.16, 0)), 0.012)
    for y in (-1, 1):
        b.cylinder(wood, (-w * 0.34, y * d * 0.16, h * 0.4), (-w * 0.34, y * d * 0.16, h * 0.66), 0.014)
    outline = [(0.012, -d * 0.12), (0.034, -d * 0.04), (0.034, d * 0.04), (0.012, d * 0.12)]
    b.lathe("linen", bent(outline), origin=(-w * 0.34, 0, h * 0.62), axis=(0, 1, 0), segments=14)
    b.cylinder(wood, (-w * 0.42, d * 0.1, h * 0.4), (-w * 0.42, d * 0.1, h * 0.86), 0.012)
    profile = [(0.012, h * 0.72), (0.06, h * 0.8), (0.045, h * 0.92), (0.004, h)]
    b.lathe("linen", bent(profile), origin=(-w * 0.42, d * 0.1, 0), segments=14)
    b.cylinder("linen", np.add(center, (0, 0, r)), (-w * 0.34, 0, h * 0.65), 0.0022, segments=5)
    return ()


@prop("stretcher")
def stretcher(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a canvas stretcher on two poles."""
    (w, d, h), canvas, pole = spec.size, spec.material("canvas"), spec.material("pole")
    for x in (-1, 1):
        b.cylinder(pole, (x * w * 0.44, -d / 2, h * 0.8), (x * w * 0.44, d / 2, h * 0.8), 0.02)
        for y in (-0.32, 0.32):
            path = [
                (x * w * 0.44, y * d, h * 0.8),
                (x * w * 0.44, y * d + 0.03, 0.01),
                (x * w * 0.44, y * d - 0.03, 0.01),
                (x * w * 0.44, y * d - 0.01, h * 0.8),
            ]
            b.tube("iron", bent(path), 0.009, segments=6)
    across = np.linspace(-1, 1, 13)
    sag = h * 0.8 - 0.045 * (1 - across**2) + 0.012
    for gap in (0.0, -0.012):
        rows = [np.c_[across * w * 0.46, np.full(13, y * d), sag + gap] for y in (-0.4, 0.4)]
        b.loft(canvas, rows if gap else rows[::-1], closed=False)
    b.cushion("linen", (0, d * 0.33, h * 0.82), (w * 0.55, d * 0.1, 0.07), softness=0.6)
    return (
        handle((-w * 0.44, -d / 2, h * 0.8), name="front"),
        handle((-w * 0.44, d / 2, h * 0.8), (0.0, 1.0, 0.0), name="back"),
    )


@prop("saddle")
def saddle(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a western saddle with horn and stirrups."""
    (w, d, h), skin = spec.size, spec.material("leather")
    across = np.linspace(-1, 1, 15)
    seat = ((-0.46, 0.86), (-0.34, 0.8), (-0.1, 0.7), (0.15, 0.72), (0.36, 0.86), (0.46, 0.94))
    for gap in (0.0, 0.025):
        rows = [
            np.c_[across * w * 0.42, np.full(15, y * d), h * z - gap - h * 0.5 * np.abs(across) ** 1.7] for y, z in seat
        ]
        b.loft(skin, rows if gap else rows[::-1], closed=False)
    b.cushion(skin, (0, d * 0.43, h * 0.86), (w * 0.56, d * 0.12, h * 0.26), softness=0.8)
    b.cushion(skin, (0, -d * 0.42, h * 0.8), (w * 0.4, d * 0.14, h * 0.24), softness=0.8)
    profile = [(0.02, 0), (0.016, h * 0.12), (0.036, h * 0.15), (0.03, h * 0.18), (0.003, h * 0.19)]
    b.lathe(skin, profile, origin=(0, -d * 0.42, h * 0.81), axis=(0, -0.3, 1), segments=14)
    for x in (-1, 1):
        b.box(
            skin, (x * w * 0.44, -d * 0.05, h * 0.3), (0.014, d * 0.5, h * 0.42), bevel=0.005, rotation=(0, x * -8, 0)
        )
        b.box(skin, (x * w * 0.47, -d * 0.05, h * 0.24), (0.014, 0.05, h * 0.34), bevel=0.003)
        ring = np.c_[np.full(28, x * w * 0.475), -d * 0.05 + 0.055 * np.cos(TURN), 0.062 + 0.055 * np.sin(TURN)]
        b.tube(spec.material("metal"), ring, 0.008, segments=6, closed=True)
    return two_hands((-w * 0.1, -d * 0.42, h * 0.9), (0.2, -0.9, -0.3), (0.5, 0, -0.85), FIST)


@prop("trough")
def trough(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wooden trough full of water."""
    (w, d, h), wood = spec.size, spec.material("wood")
    for y in (-1, 1):
        b.box(wood, (0, y * d * 0.4, h * 0.58), (w, 0.04, h * 0.84), bevel=0.008, rotation=(y * -12, 0, 0))
    for x in (-1, 1):
        b.box(wood, (x * w * 0.46, 0, h * 0.55), (0.04, d * 0.8, h * 0.76), bevel=0.008)
        b.box(wood, (x * w * 0.34, 0, h * 0.12), (0.09, d * 0.84, h * 0.24), bevel=0.008)
    b.box(wood, (0, 0, h * 0.22), (w * 0.94, d * 0.66, 0.03))
    b.box(spec.material("water"), (0, 0, h * 0.8), (w * 0.92, d * 0.78, 0.012))
    return ()


@prop("bone")
def bone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bone along X."""
    (w, d, h), body = spec.size, spec.material("body")
    r = d * 0.27
    profile = [(r, -w * 0.42), (r * 0.62, -w * 0.2), (r * 0.58, 0), (r * 0.66, w * 0.2), (r, w * 0.42)]
    b.lathe(body, bent(profile), origin=(0, 0, h / 2), axis=(1, 0, 0), segments=14)
    for x in (-1, 1):
        for y in (-1, 1):
            center = (x * (w / 2 - r), y * (d / 2 - r), h / 2)
            b.sphere(body, center, r, scale=(1, 1, min(h / 2 / r, 1.2)), segments=14, rings=9)
    return two_hands((0.0, 0.0, h), (0.1, -0.9, -0.3), (0, -0.3, -0.95), FIST)


@prop("water_cooler")
def water_cooler(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an office water cooler with its bottle."""
    (w, d, h), body, bottle = spec.size, spec.material("body"), spec.material("bottle")
    case = h * 0.68
    b.rounded_box(body, (0, 0.01, case / 2), (w, d - 0.02, case), 0.03)
    b.rounded_box("plastic_black", (0, -d / 2 + 0.02, case * 0.78), (w * 0.66, 0.05, case * 0.26), 0.012)
    for x, tap in ((-0.14, "fabric_red"), (0.14, "neon_blue")):
        b.cylinder(tap, (x * w, -d / 2 - 0.004, case * 0.84), (x * w, -d / 2 - 0.03, case * 0.84), 0.014, segments=12)
        b.box(tap, (x * w, -d / 2 - 0.028, case * 0.81), (0.018, 0.014, 0.05), bevel=0.003)
    b.box("steel", (0, -d / 2 - 0.01, case * 0.66), (w * 0.6, 0.08, 0.012), bevel=0.003)
    r, tall = w * 0.43, h - case
    profile = [
        (r * 0.3, case), (r * 0.4, case + tall * 0.12), (r, case + tall * 0.3), (r, case + tall * 0.5),
        (r * 0.97, case + tall * 0.55), (r, case + tall * 0.6), (r, case + tall * 0.96), (r * 0.9, h),
    ]  # fmt: skip
    b.lathe(bottle, bent(profile, 2), segments=28)
    return (handle((0.0, -d / 2 - 0.03, case * 0.81), name="tap"),)
