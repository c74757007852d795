"""Prop builders: rugs, stands, globes, plants, statues, games."""

from __future__ import annotations

import itertools
import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle, lean
from storyblender.blender.props.keepsakes import bloom
from storyblender.blender.props.parts import four_legs
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.blender.props.wall_fittings import frame, sheet


@prop("rug")
def rug(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a carpet whose picture covers it once, with fringes at its short ends."""
    (w, d, h), cloth = spec.size, spec.material("rug")
    inner = w - 0.12
    x, y = inner / 2, d / 2
    b.box("linen", (0, 0, h * 0.4), (inner - 0.004, d - 0.004, h * 0.8))
    b.quad(cloth, (-x, -y, h), (x, -y, h), (x, y, h), (-x, y, h), uv=((0, 0), (1, 0), (1, 1), (0, 1)))
    for side in (-1, 1):
        for k in range(max(8, round(d / 0.05))):
            at = -d / 2 + (k + 0.5) * d / max(8, round(d / 0.05))
            b.box("linen", (side * (inner / 2 + 0.03), at, h * 0.3), (0.06, 0.012, h * 0.4))
    return ()


@prop("hat_stand")
def hat_stand(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hat stand; ``hung`` puts a hat and a coat on it."""
    (w, _, h), wood = spec.size, spec.material("wood")
    outline = [
        (0.03, 0.1), (0.022, 0.3), (0.026, h * 0.55), (0.02, h * 0.56), (0.022, h - 0.14), (0.035, h - 0.1),
        (0.012, h - 0.03), (0.004, h),
    ]  # fmt: skip
    b.lathe(wood, outline, segments=16)
    for k in range(4):
        with b.at(rotation=(0, 0, 90 * k + 45)):
            b.tube(wood, [(0.02, 0, 0.2), (w * 0.3, 0, 0.12), (w * 0.48, 0, 0.015)], (0.02, 0.017, 0.02))
            b.tube(wood, [(0.02, 0, h - 0.22), (0.12, 0, h - 0.2), (0.17, 0, h - 0.1)], 0.011)
            b.sphere(wood, (0.175, 0, h - 0.09), 0.02, segments=10, rings=6)
    if spec.flag("hung"):
        hat, coat = spec.material("hat"), spec.material("coat")
        with b.at((-0.12, -0.12, h - 0.14), (18, -14, 0)):
            profile = [(0.15, 0), (0.155, 0.006), (0.095, 0.012), (0.09, 0.08), (0.07, 0.11), (0.02, 0.1)]
            b.lathe(hat, profile, segments=24)
        angle = np.linspace(0, math.tau, 28, endpoint=False)
        rings = []
        for z, wide, deep, fold in (
            (0.52, 0.17, 0.1, 0.16),
            (0.9, 0.16, 0.095, 0.12),
            (1.25, 0.19, 0.09, 0.05),
            (1.42, 0.17, 0.075, 0.02),
            (1.56, 0.05, 0.04, 0.0),
        ):
            ripple = 1 + fold * np.sin(6 * angle)
            ring = np.c_[
                0.15 + wide * ripple * np.cos(angle), -0.15 + deep * ripple * np.sin(angle), np.full(28, z * h / 1.82)
            ]
            rings.append(ring)
        b.loft(coat, rings)
        for x in (-1, 1):
            path = [
                (0.15 + x * 0.15, -0.16, 1.38 * h / 1.82),
                (0.15 + x * 0.22, -0.18, 1.0 * h / 1.82),
                (0.15 + x * 0.22, -0.2, 0.78 * h / 1.82),
            ]
            b.tube(coat, path, (0.055, 0.055, 0.05), segments=12)
    return ()


@prop("globe")
def globe(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a globe in its meridian ring."""
    (w, _, h), wood = spec.size, spec.material("stand")
    r, z = w * 0.42, h - w * 0.5
    longitude, latitude = np.linspace(0, 1, 29), np.linspace(0, 1, 17)
    rings = [
        np.c_[
            r * math.sin(math.pi * v) * np.cos(math.tau * longitude),
            r * math.sin(math.pi * v) * np.sin(math.tau * longitude),
            np.full(29, -r * math.cos(math.pi * v)),
        ]
        for v in latitude
    ]
    uv = [
        (u0, v0)
        for v_low, v_high in itertools.pairwise(latitude)
        for u_low, u_high in itertools.pairwise(longitude)
        for u0, v0 in ((u_low, v_low), (u_high, v_low), (u_high, v_high), (u_low, v_high))
    ]
    faces = [(i * 29 + j, i * 29 + j + 1, (i + 1) * 29 + j + 1, (i + 1) * 29 + j) for i in range(16) for j in range(28)]
    with b.at((0, 0, z), (0, 23, 0)):
        b.add(spec.material("map"), np.concatenate(rings), faces, uv=uv)
        ring = [(w * 0.47 * math.cos(a), 0, w * 0.47 * math.sin(a)) for a in np.linspace(-math.pi / 2, math.pi / 2, 19)]
        b.tube("brass", ring, 0.008)
    b.lathe(wood, [(w * 0.36, 0), (w * 0.34, 0.025), (0.05, 0.05), (0.025, 0.07), (0.035, z - w * 0.46)], segments=24)
    return ()


@prop("potted_plant")
def potted_plant(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a leafy plant in a clay pot."""
    (w, _, h), leaf = spec.size, spec.material("leaf")
    r = min(0.2, w * 0.24)
    pot = r * 1.7
    profile = [(r * 0.66, 0), (r * 0.92, pot * 0.8), (r, pot * 0.8), (r, pot), (r * 0.9, pot), (r * 0.86, pot * 0.9)]
    b.lathe(spec.material("pot"), profile, segments=26)
    b.lathe("dirt", [(r * 0.88, pot * 0.9), (0.002, pot * 0.94)], segments=20)
    for k in range(22):
        turn = 137.5 * k
        rise = 25 + 60 * (1 - k / 22)
        length = (h - pot) * (0.55 + 0.45 * k / 22) if rise < 60 else (h - pot) * 0.6
        with b.at((0, 0, pot * 0.9), (0, 0, turn)):
            reach = min(w * 0.48, length * math.cos(math.radians(88 - 50 * (1 - k / 22))))
            top = (h - pot) * (0.45 + 0.55 * k / 21)
            spine = np.array(
                [(0.01, 0, 0), (reach * 0.25, 0, top * 0.6), (reach * 0.6, 0, top * 0.95), (reach, 0, top * 0.86)]
            )
            widths = np.array([0.008, 0.05, 0.06, 0.004]) * (0.8 + h * 0.25)
            for lift, order in ((0.0, 1), (0.003, -1)):
                rows = [
                    np.array([(x, -wd, z + lift), (x, 0, z - wd * 0.3 + lift), (x, wd, z + lift)])[::order]
                    for (x, _, z), wd in zip(spine, widths, strict=True)
                ]
                b.loft(leaf, rows, closed=False)
    return ()


@prop("vase")
def vase(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a vase of flowers."""
    (w, _, h), leaf = spec.size, spec.material("leaf")
    profile = [
        (0.045, 0), (0.05, 0.01), (0.075, h * 0.2), (0.06, h * 0.36), (0.035, h * 0.44), (0.05, h * 0.5),
        (0.044, h * 0.5), (0.03, h * 0.44),
    ]  # fmt: skip
    b.lathe(spec.material("vase"), profile, segments=26)
    for k in range(7):
        turn = 2.4 * k
        reach = w * 0.4 * math.sqrt((k + 0.3) / 7)
        x, y, z = reach * math.cos(turn), reach * math.sin(turn), h * (0.94 - 0.9 * reach)
        b.tube("leaves_dark", [(0, 0, h * 0.4), (x * 0.5, y * 0.5, h * 0.62), (x, y, z)], 0.003, segments=5)
        bloom(b, spec.material("petal") if k % 2 else "linen", (x, y, z), 0.04)
        with b.at((x * 0.6, y * 0.6, h * 0.6), (0, -30, math.degrees(turn) + 40)):
            b.cushion(leaf, (0.05, 0, 0), (0.1, 0.045, 0.004), softness=1.0)
    return ()


@prop("statue")
def statue(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bust on a column."""
    (w, d, h), stone = spec.size, spec.material("stone")
    foot = h * 0.6
    b.box(stone, (0, 0, 0.05), (w * 0.8, d * 0.8, 0.1), bevel=0.012)
    b.lathe(
        stone,
        [(w * 0.34, 0.1), (w * 0.28, 0.16), (w * 0.26, foot * 0.8), (w * 0.3, foot * 0.9), (w * 0.34, foot * 0.94)],
        segments=24,
    )
    b.box(stone, (0, 0, foot - 0.015), (w * 0.76, d * 0.76, 0.07), bevel=0.01)
    b.lathe(stone, [(w * 0.22, foot + 0.02), (w * 0.1, foot + 0.06), (w * 0.1, foot + 0.1)], segments=18)
    top = h - foot
    b.cushion(stone, (0, 0, foot + top * 0.34), (w, d * 0.56, top * 0.36), softness=0.75)
    b.cushion(stone, (0, -d * 0.08, foot + top * 0.3), (w * 0.7, d * 0.5, top * 0.3), softness=0.8)
    b.cylinder(stone, (0, 0.0, foot + top * 0.44), (0, -0.01, foot + top * 0.66), w * 0.11, segments=16)
    b.sphere(stone, (0, -0.01, foot + top * 0.8), top * 0.2, scale=(0.78, 0.95, 1.05))
    b.sphere(stone, (0, 0.02, foot + top * 0.86), top * 0.19, scale=(0.86, 0.95, 0.78))
    b.cushion(stone, (0, -top * 0.2, foot + top * 0.77), (0.03, 0.045, 0.06), softness=0.8)
    b.cushion(stone, (0, -top * 0.13, foot + top * 0.64), (0.08, 0.07, 0.05), softness=0.8)
    for x in (-1, 1):
        b.cushion(stone, (x * top * 0.065, -top * 0.16, foot + top * 0.83), (0.05, 0.03, 0.02), softness=0.8)
        b.sphere(stone, (x * top * 0.155, 0.0, foot + top * 0.78), 0.025, scale=(0.4, 0.8, 1.2))
    return ()


@prop("chessboard")
def chessboard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a chess game in progress."""
    w, _, h = spec.size
    b.box("wood_dark", (0, 0, 0.01), (w, w, 0.02), bevel=0.004)
    cell = w * 0.9 / 8
    for row in range(8):
        for column in range(8):
            kind = "wood_light" if (row + column) % 2 else "wood_dark"
            b.box(kind, ((column - 3.5) * cell, (row - 3.5) * cell, 0.021), (cell, cell, 0.003))
    for side, kind in ((-1, spec.material("white")), (1, spec.material("black"))):
        for k in range(8):
            for row, tall in ((3.5, 0.5 + 0.5 * math.sin(math.pi * (k + 0.5) / 8)), (2.5 - (k % 3 == 1), 0.5)):
                r, t = cell * 0.3, (h - 0.023) * tall
                profile = [
                    (r, 0), (r * 0.9, t * 0.12), (r * 0.4, t * 0.3), (r * 0.35, t * 0.65), (r * 0.65, t * 0.72),
                    (r * 0.5, t * 0.9), (0.001, t),
                ]  # fmt: skip
                b.lathe(kind, profile, origin=((k - 3.5) * cell, side * row * cell, 0.023), segments=12)
    return ()


@prop("easel")
def easel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an easel with a canvas that faces -Y."""
    (w, d, h), wood = spec.size, spec.material("wood")
    for x in (-1, 1):
        b.cylinder(wood, (x * w / 2, -d * 0.3, 0), (x * 0.05, d * 0.02, h), 0.016, segments=8)
    b.cylinder(wood, (0, d / 2, 0), (0, d * 0.04, h * 0.92), 0.016, segments=8)
    b.box(wood, (0, -d * 0.2, h * 0.4), (w * 0.86, 0.06, 0.03), bevel=0.005)
    with b.at((0, -d * 0.17, h * 0.42), (-10, 0, 0)):
        frame(b, "linen", w * 0.8, h * 0.44, 0.02, 0.025, 0.02, 0)
        b.box("linen", (0, 0.008, h * 0.22), (w * 0.78, 0.01, h * 0.42))
        sheet(b, spec.material("canvas"), w * 0.77, h * 0.41, 0.0, h * 0.015)
    return ()


@prop("slot_machine")
def slot_machine(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lit machine with a round top, as of an arcade, a casino or a diner."""
    (w, d, h), body, metal, light = spec.size, spec.material("body"), spec.material("metal"), spec.material("light")
    arch = [(w / 2 * math.cos(a), h - w / 2 + w / 2 * math.sin(a)) for a in np.linspace(0, math.pi, 21)]
    with b.at((0, d / 2, 0), (90, 0, 0)):
        b.extrude(body, [(w / 2, 0.05), *arch, (-w / 2, 0.05)], d - 0.03)
    tube = [(x * 0.92, -d / 2 + 0.02, 0.06 + (z - 0.06) * 0.965) for x, z in [(w / 2, 0.12), *arch, (-w / 2, 0.12)]]
    b.tube(light, tube, 0.022)
    b.box(metal, (0, 0, 0.035), (w + 0.02, d, 0.07), bevel=0.01)
    b.rounded_box(spec.material("screen"), (0, -d / 2 + 0.03, h * 0.7), (w * 0.66, 0.03, h * 0.2), 0.014)
    for k in range(3):
        b.rounded_box("porcelain", ((k - 1) * w * 0.2, -d / 2 + 0.012, h * 0.7), (w * 0.16, 0.02, h * 0.12), 0.008)
        b.sphere(light, ((k - 1) * w * 0.2, -d / 2 + 0.01, h * 0.7), 0.03, scale=(1, 0.4, 1), segments=10, rings=6)
    for k in range(6):
        b.box(metal, (0, -d / 2 + 0.025, h * (0.2 + 0.045 * k)), (w * 0.7, 0.02, 0.02), bevel=0.006)
    b.box(metal, (0, -d / 2 + 0.0, h * 0.52), (w * 0.8, 0.06, 0.04), bevel=0.012)
    b.tube(metal, [(w / 2, 0, h * 0.55), (w / 2 + 0.06, 0, h * 0.55), (w / 2 + 0.06, 0, h * 0.78)], 0.012)
    b.sphere(light, (w / 2 + 0.06, 0, h * 0.8), 0.035)
    return (handle((w / 2 + 0.06, 0, h * 0.78), (0, -1, -0.5), "lever"),)


@prop("roulette_table")
def roulette_table(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a gaming table with a wheel at +Y and chips."""
    (w, d, h), cloth, body, brass = spec.size, spec.material("cloth"), spec.material("body"), spec.material("metal")
    top = h - 0.06
    b.box(body, (0, 0, top - 0.05), (w, d, 0.1), bevel=0.02)
    b.box(cloth, (0, -0.0, top + 0.002), (w - 0.16, d - 0.16, 0.01))
    b.box(body, (0, 0, top - 0.16), (w * 0.8, d * 0.86, 0.14), bevel=0.01)
    four_legs(b, body, w * 0.84, d * 0.88, top - 0.1, 0.12)
    wheel = {"origin": (0, d * 0.32, top), "segments": 36}
    b.lathe(spec.material("wheel"), [(0.36, 0), (0.36, 0.06), (0.33, 0.06), (0.27, 0.03)], **wheel)
    for k in range(36):
        with b.at((0, d * 0.32, top), (0, 0, 10 * k)):
            b.box("fabric_red" if k % 2 else "plastic_black", (0.23, 0, 0.034), (0.07, 0.036, 0.012))
    b.lathe(brass, [(0.12, 0.035), (0.03, 0.05), (0.015, 0.09), (0.03, 0.1), (0.004, 0.12)], **wheel)
    for row in range(12):
        for column in range(3):
            kind = "fabric_red" if (row + column) % 2 else "plastic_black"
            b.box(kind, ((column - 1) * 0.2, -d * 0.4 + 0.1 * row, top + 0.008), (0.17, 0.085, 0.003))
    for k in range(12):
        x, y = spec.rng.uniform(-0.36, 0.36) * w, spec.rng.uniform(-0.42, 0.02) * d
        start, end = (x, y, top + 0.008), (x, y, top + 0.012 + 0.008 * (k % 5))
        b.cylinder(("gold", "fabric_blue", "porcelain")[k % 3], start, end, 0.02, segments=12)
    return (
        lean((0, -d / 2, h), w),
        lean((-w / 2, -d * 0.1, h), d * 0.6, (1, 0, 0), "left"),
        lean((w / 2, -d * 0.1, h), d * 0.6, (-1, 0, 0), "right"),
    )
