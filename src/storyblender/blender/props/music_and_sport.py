"""Prop builders: drums, harps and pipes; rackets, bats and prizes."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, two_hands
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop

TURN = np.linspace(0, math.tau, 32, endpoint=False)


@prop("drum")
def drum(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a side drum with its cords and sticks on the skin."""
    (_, d, h), shell, hoop = spec.size, spec.material("shell"), spec.material("hoop")
    r, top = d / 2 * 0.97, h * 0.96
    b.lathe(shell, [(r * 0.96, 0.01), (r * 0.96, top - 0.005)], segments=32)
    b.lathe(spec.material("skin"), [(r * 0.95, top - 0.01), (r * 0.95, top), (0.004, top + 0.002)], segments=32)
    for z in (0.022, top - 0.022):
        outline = [(r * 0.97, z - 0.022), (r * 1.03, z - 0.02), (r * 1.03, z + 0.02), (r * 0.97, z + 0.022)]
        b.lathe(hoop, outline, segments=32, caps=False)
    for k in range(10):
        low, high = math.tau * (k + 0.5) / 10, (math.tau * k / 10, math.tau * (k + 1) / 10)
        for turn in high:
            ends = [(r * 0.99 * math.cos(a), r * 0.99 * math.sin(a), z) for a, z in ((low, 0.04), (turn, top - 0.04))]
            b.cylinder("linen", ends[0], ends[1], 0.004, segments=5)
    for k, turn in enumerate((62, 96)):
        with b.at((0.03 * k - 0.02, 0.02, top + 0.012), (0, 0, turn)):
            profile = [(0.009, -0.17), (0.008, 0.1), (0.004, 0.15), (0.009, 0.17), (0.004, 0.182)]
            b.lathe("wood_light", bent(profile, 2), axis=(1, 0, 0), segments=10)
    return two_hands((-r, 0.0, h * 0.6), (0.1, -0.9, -0.4), (1, 0, 0), (0.2, 0.25, 0.2))


@prop("flute")
def flute(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flute along X with its holes or keys up."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    r = d / 2
    tube = [
        (r * 0.9, 0), (r, 0.01), (r, w * 0.22), (r * 1.08, w * 0.23), (r * 1.08, w * 0.26), (r * 0.95, w * 0.27),
        (r * 0.95, w * 0.99), (r * 0.85, w),
    ]  # fmt: skip
    b.lathe(body, tube, origin=(-w / 2, 0, r), axis=(1, 0, 0), segments=16)
    b.cushion(metal, (-w * 0.36, 0, h * 0.8), (0.034, d, 0.008), softness=0.9)
    b.cylinder("plastic_black", (-w * 0.36, 0, h * 0.78), (-w * 0.36, 0, h * 0.9), 0.004, segments=10)
    for k in range(9):
        x = -w * 0.14 + k * w * 0.065
        b.cylinder(metal, (x, 0, h * 0.72), (x, 0, h), 0.0072, 0.0064, segments=14)
    b.tube(metal, [(-w * 0.18, -r * 0.75, h * 0.72), (w * 0.42, -r * 0.75, h * 0.72)], 0.002, segments=6)
    return two_hands((-w * 0.12, 0.0, -0.004), (0.1, -0.9, 0.3), (0, 0.1, 1), (0.7, 0.75, 0.5))


@prop("harp")
def harp(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a concert harp; its player sits at +Y."""
    (w, d, h), gold, string = spec.size, spec.material("body"), spec.material("string")
    post = -d / 2 + 0.07
    b.cushion(gold, (0, d * 0.02, 0.045), (w, d * 0.85, 0.09), softness=0.45)
    profile = [
        (0.07, 0.08), (0.05, 0.14), (0.032, 0.22), (0.03, h * 0.8), (0.045, h * 0.84), (0.036, h * 0.88),
        (0.062, h * 0.96), (0.03, h),
    ]  # fmt: skip
    b.lathe(gold, bent(profile, 2), origin=(0, post, 0), segments=16)
    curve = [
        (0, post, h * 0.93), (0, -d * 0.2, h * 0.985), (0, 0.02, h * 0.8), (0, d * 0.24, h * 0.78),
        (0, d * 0.4, h * 0.88), (0, d * 0.46, h * 0.84),
    ]  # fmt: skip
    top = bent(curve, 5)
    b.tube(gold, top, tuple(np.linspace(0.045, 0.03, len(top))), segments=10)
    foot, head = np.array((0, -d * 0.12, 0.08)), np.array((0, d * 0.44, h * 0.82))
    for t in range(8):
        lower, upper = foot + (head - foot) * t / 8, foot + (head - foot) * (t + 1) / 8
        b.cylinder(
            gold, lower, upper, w * (0.3 - 0.025 * t), w * (0.3 - 0.025 * (t + 1)), segments=14, caps=t in (0, 7)
        )
    for k in range(18):
        t = 0.1 + 0.85 * k / 18
        low = foot + (head - foot) * t
        high = np.array(
            [0.0, np.interp(low[1] - 0.06, top[:, 1], top[:, 1]), np.interp(low[1] - 0.06, top[:, 1], top[:, 2])]
        )
        b.cylinder(string if k % 7 else "fabric_red", low, high, 0.0016, segments=5, caps=False)
    return ()


@prop("accordion")
def accordion(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an accordion, its bellows a little open."""
    (w, d, h), body = spec.size, spec.material("body")
    for x in (-1, 1):
        b.rounded_box(body, (x * w * 0.36, 0, h / 2), (w * 0.24, d, h), 0.02)
        b.rounded_box("chrome", (x * w * 0.36, -d / 2, h * 0.5), (w * 0.14, 0.012, h * 0.6), 0.004)
        path = [(x * w * 0.32, d * 0.5, h * 0.85), (x * w * 0.34, d * 0.6, h * 0.5), (x * w * 0.32, d * 0.5, h * 0.15)]
        b.tube("leather_black", bent(path), 0.012, segments=6)
    for k in range(9):
        x = (k - 4) * w * 0.053
        b.box(spec.material("bellows"), (x, 0, h / 2), (w * 0.036, d * 0.94, h * 0.94), bevel=0.006)
    for k in range(14):
        b.box(
            "porcelain", (-w / 2 + 0.006, -d * 0.2, h * (0.12 + 0.058 * k)), (0.024, d * 0.42, h * 0.052), bevel=0.002
        )
        if k % 7 not in (2, 6):
            center = (-w / 2 + 0.002, -d * 0.08, h * (0.149 + 0.058 * k))
            b.box("plastic_black", center, (0.03, d * 0.22, h * 0.026), bevel=0.002)
    for row in range(4):
        for k in range(9):
            start = (w / 2 - 0.006, (row - 1.5) * d * 0.16, h * (0.2 + 0.075 * k))
            b.cylinder(
                "porcelain", start, (w / 2 + 0.004, (row - 1.5) * d * 0.16, h * (0.2 + 0.075 * k)), 0.007, segments=8
            )
    return two_hands((-w / 2, 0.02, h * 0.5), (0.1, -0.9, -0.3), (1, 0, 0), (0.3, 0.35, 0.3))


@prop("racket")
def racket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a racket, its strings up, its handle at the foot."""
    (w, d, h), frame, string, grip = spec.size, spec.material("frame"), spec.material("string"), spec.material("grip")
    tall, thick = h * 0.24, w / 2
    middle = h - tall
    loop = np.c_[(thick - 0.01) * np.cos(TURN), np.zeros(32), middle + (tall - 0.01) * np.sin(TURN)]
    b.tube(frame, loop, 0.011, segments=8, closed=True)
    for k in range(-6, 7):
        x, z = k / 7 * thick, k / 7 * tall
        up, across = tall * math.sqrt(1 - (k / 7) ** 2), thick * math.sqrt(1 - (k / 7) ** 2)
        b.cylinder(string, (x, 0, middle - up + 0.01), (x, 0, middle + up - 0.01), 0.0014, segments=4, caps=False)
        b.cylinder(
            string, (-across + 0.01, 0, middle + z), (across - 0.01, 0, middle + z), 0.0014, segments=4, caps=False
        )
    for x in (-1, 1):
        path = [(x * thick * 0.62, 0, middle - tall * 0.76), (x * 0.016, 0, h * 0.38), (x * 0.011, 0, h * 0.3)]
        b.tube(frame, bent(path), 0.009)
    profile = [(d * 0.52, 0), (d * 0.56, 0.012), (d * 0.46, 0.03), (d * 0.46, h * 0.32), (0.014, h * 0.34)]
    b.lathe(grip, profile, segments=12)
    return two_hands((-d * 0.48, 0.004, h * 0.12), (0.2, -1, 0.05), (1, 0.15, 0), FIST)


@prop("bat")
def bat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a baseball bat on its knob."""
    h, r = spec.size[2], spec.size[0] / 2
    outline = [
        (0.6, 0.0), (0.74, 0.012), (0.7, 0.022), (0.42, 0.04), (0.38, 0.2), (0.5, 0.42), (0.86, 0.68), (1.0, 0.84),
        (0.97, 0.965), (0.6, 0.995), (0.02, 1.0),
    ]  # fmt: skip
    b.lathe(spec.material("wood"), bent([(x * r, z * h) for x, z in outline], 3), segments=20)
    b.lathe(spec.material("grip"), [(r * 0.44, 0.035 * h), (r * 0.42, 0.28 * h)], segments=20, caps=False)
    return two_hands((-r * 0.42, 0.004, h * 0.12), (0.2, -1, 0.05), (1, 0.15, 0), FIST)


@prop("dumbbell")
def dumbbell(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dumbbell along X."""
    (w, _, h), iron, r = spec.size, spec.material("iron"), spec.size[2] / 2
    profile = [(r * 0.26, -w * 0.24), (r * 0.34, 0), (r * 0.26, w * 0.24)]
    b.lathe(spec.material("bar"), bent(profile), origin=(0, 0, r), axis=(1, 0, 0), segments=14)
    for x in (-1, 1):
        plates = np.multiply(
            [(0.9, 0.2), (1, 0.22), (1, 0.3), (0.92, 0.32), (0.92, 0.33), (0.84, 0.42), (0.3, 0.43), (0.3, 0.5)], (r, w)
        )
        b.lathe(iron, plates, origin=(0, 0, r), axis=(x, 0, 0), segments=24)
    return two_hands((0.0, 0.004, h * 0.72), (0.1, -0.5, -0.8), (0, -0.8, -0.5), FIST)


@prop("trophy")
def trophy(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cup with two handles on a plinth."""
    (w, d, h), gold, base = spec.size, spec.material("cup"), spec.material("base")
    r = d / 2
    b.box(base, (0, 0, h * 0.06), (d * 0.8, d * 0.8, h * 0.12), bevel=0.006)
    b.box(base, (0, 0, h * 0.15), (d * 0.62, d * 0.62, h * 0.07), bevel=0.005)
    b.box("brass", (0, -d * 0.405, h * 0.06), (d * 0.4, 0.006, h * 0.06), bevel=0.001)
    cup = [
        (0.5, 0.185), (0.42, 0.2), (0.14, 0.26), (0.12, 0.32), (0.24, 0.36), (0.14, 0.4), (0.5, 0.5), (0.88, 0.68),
        (0.92, 0.9), (1.0, 1.0), (0.93, 1.0), (0.84, 0.88), (0.8, 0.7), (0.03, 0.5),
    ]  # fmt: skip
    b.lathe(gold, bent([(x * r, z * h) for x, z in cup], 3), segments=28)
    for x in (-1, 1):
        path = [
            (x * r * 0.9, 0, h * 0.9), (x * w * 0.46, 0, h * 0.95), (x * w / 2, 0, h * 0.78),
            (x * w * 0.36, 0, h * 0.58), (x * r * 0.5, 0, h * 0.52),
        ]  # fmt: skip
        b.tube(gold, bent(path), 0.011)
    return two_hands((-w / 2, 0.0, h * 0.75), (0.2, -1, 0), (1, 0.1, 0), (0.85, 0.85, 0.5))


@prop("balloon")
def balloon(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a balloon on its string, held at the foot."""
    (_, _, h), skin, r = spec.size, spec.material("skin"), spec.size[0] / 2
    top = [
        (0.01, -0.02), (0.09, -0.03), (0.05, 0.0), (0.2, 0.1), (0.62, 0.42), (0.94, 0.85), (1.0, 1.25), (0.88, 1.75),
        (0.55, 2.1), (0.02, 2.24),
    ]  # fmt: skip
    b.lathe(skin, bent([(x * r, h - 2.24 * r + z * r) for x, z in top], 3), segments=26)
    z = h - 2.26 * r
    path = [(0, 0, 0), (0.015, 0.01, z * 0.25), (-0.012, -0.01, z * 0.55), (0.008, 0, z * 0.8), (0, 0, z)]
    b.tube("linen", bent(path), 0.0022, segments=5)
    b.sphere("porcelain", (-r * 0.42, -r * 0.72, h - r * 0.68), r * 0.1, scale=(1, 0.4, 1.5), segments=10, rings=6)
    return grips_around(0.004, 0.03, FIST)
