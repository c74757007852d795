"""Prop builders: what scholars, judges and machines have on their tables: microscope, flasks, scales, robot, gavel."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, two_hands
from storyblender.blender.props.parts import bent
from storyblender.blender.props.registry import PropSpec, prop


@prop("microscope")
def microscope(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a microscope; one looks into it from +Y."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    b.rounded_box(body, (0, 0, 0.018), (w, d, 0.036), 0.014)
    arm = bent([(0, d * 0.3, 0.03), (0, d * 0.36, h * 0.36), (0, d * 0.2, h * 0.64), (0, 0.0, h * 0.68)])
    b.tube(body, arm, tuple(bent((0.024, 0.022, 0.022, 0.026))), segments=12)
    b.box(metal, (0, -d * 0.1, h * 0.34), (w * 0.78, d * 0.5, 0.014), bevel=0.003)
    b.box("glass", (0, -d * 0.1, h * 0.34 + 0.009), (0.075, 0.025, 0.003))
    b.cylinder(metal, (0, -d * 0.1, 0.04), (0, -d * 0.1, 0.075), 0.026, 0.02, segments=18)
    with b.at((0, -d * 0.06, h * 0.66), (-24, 0, 0)):
        b.cylinder(body, (0, 0, 0), (0, 0, h * 0.3), 0.022, segments=20)
        turned = np.multiply(
            [(0.02, 0.3), (0.017, 0.31), (0.017, 0.36), (0.022, 0.365), (0.022, 0.38), (0.012, 0.38)], (1, h)
        )
        b.lathe(metal, turned, segments=20)
        b.lathe(body, [(0.034, 0.012), (0.036, 0), (0.03, -0.024), (0.01, -0.028)], segments=22)
        for turn in (-42, 0, 42):
            with b.at((0, 0, -0.016), (0, turn, 0)):
                outline = [(0.012, 0), (0.013, -0.035), (0.008, -0.06), (0.006, -0.075), (0.002, -0.075)]
                b.lathe(metal, outline, segments=14)
    for x in (-1, 1):
        profile = [(0.026, 0), (0.026, 0.014), (0.02, 0.018)]
        b.lathe(metal, profile, origin=(x * 0.026, d * 0.35, h * 0.3), axis=(x, 0, 0), segments=20)
    return two_hands((-0.026, d * 0.3, h * 0.5), (0.2, -0.95, 0), (1, 0.2, 0), (0.8, 0.8, 0.5))


@prop("test_tubes")
def test_tubes(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wooden rack of test tubes with coloured liquids."""
    (w, d, h), wood, glass = spec.size, spec.material("rack"), spec.material("glass")
    top = h * 0.66
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.006), 0, top / 2), (0.012, d, top), bevel=0.002)
    for z, thick in ((0.006, 0.012), (top * 0.55, 0.008), (top - 0.006, 0.01)):
        b.box(wood, (0, 0, z), (w - 0.012, d, thick), bevel=0.001)
    colors = ("fabric_red", "fabric_blue", "leaves", "glass_amber", "neon_blue", "fabric_red")
    for k, liquid in enumerate(colors):
        x, r, full = (k - 2.5) * (w - 0.03) / 6, 0.0085, 0.3 + 0.14 * ((k * 2) % 4)
        outline = [(0.002, 0.014), (r * 0.8, 0.018), (r, 0.026), (r, h - 0.004), (r * 1.25, h), (r * 0.9, h)]
        b.lathe(glass, outline, origin=(x, 0, 0), segments=14)
        profile = [(0.002, 0.0145), (r * 0.85, 0.019), (r * 1.04, 0.027), (r * 1.04, h * full), (0.002, h * full)]
        b.lathe(liquid, profile, origin=(x, 0, 0), segments=14)
    return two_hands((-w / 2, 0.01, top * 0.6), (0.2, -0.95, 0), (1, 0.1, 0), (0.3, 0.35, 0.3))


@prop("beaker")
def beaker(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a conical flask, part full."""
    h, r = spec.size[2], spec.size[0] / 2
    neck, full = r * 0.3, 0.42
    outline = [
        (r * 0.9, 0), (r, h * 0.04), (neck, h * 0.68), (neck, h * 0.94), (neck * 1.35, h), (neck * 1.1, h),
        (neck * 0.88, h * 0.94),
    ]  # fmt: skip
    b.lathe(spec.material("glass"), outline, segments=28, caps=False)
    level = r + (neck - r) * (full - 0.04) / 0.64
    profile = [(r * 0.92, h * 0.012), (r * 1.01, h * 0.04), (level * 1.01, h * full), (0.003, h * full)]
    b.lathe(spec.material("liquid"), profile, segments=28)
    return grips_around(neck, h * 0.76, (0.75, 0.8, 0.5))


@prop("scales")
def scales(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pair of scales, a little out of balance."""
    (w, d, h), brass, wood = spec.size, spec.material("metal"), spec.material("base")
    b.rounded_box(wood, (0, 0, 0.016), (w * 0.6, d, 0.032), 0.01)
    outline = [
        (0.05, 0.032), (0.016, 0.05), (0.01, h * 0.3), (0.018, h * 0.34), (0.009, h * 0.4), (0.008, h * 0.92),
        (0.016, h * 0.95), (0.003, h),
    ]  # fmt: skip
    b.lathe(brass, bent(outline, 2), segments=16)
    reach, tilt = w / 2 - d * 0.5, 0.02
    path = [
        (-reach, 0, h * 0.9 - tilt), (-reach * 0.4, 0, h * 0.93), (0, 0, h * 0.91), (reach * 0.4, 0, h * 0.95),
        (reach, 0, h * 0.9 + tilt),
    ]  # fmt: skip
    b.tube(brass, bent(path), 0.006)
    for x, low in ((-1, -tilt), (1, tilt)):
        hook, pan = (x * reach, 0.0, h * 0.9 + low), h * 0.34 + low
        for k in range(3):
            turn = 2.1 * k + 0.5
            b.cylinder(
                brass, hook, (hook[0] + d * 0.44 * math.cos(turn), d * 0.44 * math.sin(turn), pan), 0.0018, segments=5
            )
        profile = [(0.003, pan - 0.03), (d * 0.3, pan - 0.022), (d * 0.46, pan), (d * 0.43, pan), (0.003, pan - 0.024)]
        b.lathe(brass, bent(profile, 2), origin=(hook[0], 0, 0), segments=24)
    return grips_around(0.01, h * 0.6, (0.85, 0.85, 0.6))


@prop("robot")
def robot(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing robot with glowing eyes."""
    (w, d, h), body, joint, eye = spec.size, spec.material("body"), spec.material("joint"), spec.material("eye")
    b.rounded_box(body, (0, 0, h * 0.6), (w * 0.6, d * 0.8, h * 0.28), 0.06)
    b.rounded_box(body, (0, 0, h * 0.435), (w * 0.42, d * 0.62, h * 0.08), 0.03)
    b.rounded_box(joint, (0, -d * 0.4, h * 0.63), (w * 0.36, 0.03, h * 0.11), 0.012)
    for k in range(3):
        start, end = ((k - 1) * w * 0.11, -d * 0.41, h * 0.645), ((k - 1) * w * 0.11, -d * 0.435, h * 0.645)
        b.cylinder(eye if k == 1 else "neon_red", start, end, 0.018, segments=14)
    for k in range(4):
        b.box(body, (0, -d * 0.42, h * 0.615 - 0.014 * k), (w * 0.28, 0.014, 0.006))
    b.cylinder(joint, (0, 0, h * 0.73), (0, 0, h * 0.79), w * 0.09)
    b.rounded_box(body, (0, 0, h * 0.865), (w * 0.42, d * 0.72, h * 0.155), 0.05)
    b.rounded_box("plastic_black", (0, -d * 0.35, h * 0.875), (w * 0.34, 0.03, h * 0.06), 0.02)
    for x in (-1, 1):
        b.sphere(eye, (x * w * 0.09, -d * 0.36, h * 0.875), 0.022, segments=14, rings=8)
        b.cylinder(joint, (x * w * 0.21, 0, h * 0.87), (x * w * 0.25, 0, h * 0.87), 0.04, segments=18)
        b.sphere(joint, (x * w * 0.36, 0, h * 0.69), w * 0.1)
        b.cylinder(body, (x * w * 0.38, 0, h * 0.67), (x * w * 0.42, 0.01, h * 0.55), w * 0.075, w * 0.066)
        b.sphere(joint, (x * w * 0.425, 0.01, h * 0.535), w * 0.066)
        b.cylinder(body, (x * w * 0.425, 0.0, h * 0.52), (x * w * 0.425, -0.03, h * 0.41), w * 0.075, w * 0.062)
        for turn in (-1, 1):
            b.rounded_box(
                joint, (x * w * 0.425 + turn * w * 0.04, -0.035, h * 0.375), (w * 0.035, 0.05, h * 0.055), 0.01
            )
        b.sphere(joint, (x * w * 0.15, 0, h * 0.39), w * 0.095)
        b.cylinder(body, (x * w * 0.15, 0, h * 0.37), (x * w * 0.16, 0, h * 0.23), w * 0.1, w * 0.085)
        b.sphere(joint, (x * w * 0.16, 0, h * 0.21), w * 0.08)
        b.cylinder(body, (x * w * 0.16, 0, h * 0.19), (x * w * 0.17, 0, h * 0.06), w * 0.085, w * 0.1)
        b.rounded_box(body, (x * w * 0.17, -d * 0.1, h * 0.028), (w * 0.25, d * 0.78, h * 0.056), 0.025)
    b.cylinder(joint, (0, 0, h * 0.94), (0, 0, h * 0.985), 0.006, segments=6)
    b.sphere("neon_red", (0, 0, h * 0.988), h * 0.012, segments=10, rings=6)
    return ()


@prop("gavel")
def gavel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a gavel that lies on its sounding block; its handle is at +Y."""
    (w, d, h), wood, brass = spec.size, spec.material("wood"), spec.material("band")
    profile = [(w * 0.5, 0), (w * 0.5, h * 0.16), (w * 0.44, h * 0.22), (0.003, h * 0.22)]
    b.lathe(wood, profile, origin=(0, -d / 2 + w * 0.5, 0), segments=30)
    y, z, r = -d / 2 + w * 0.5, h * 0.62, h * 0.38
    head = [
        (r * 0.8, -w * 0.46), (r, -w * 0.43), (r, -w * 0.28), (r * 0.78, -w * 0.22), (r * 0.82, 0.0),
        (r * 0.78, w * 0.22), (r, w * 0.28), (r, w * 0.43), (r * 0.8, w * 0.46),
    ]  # fmt: skip
    b.lathe(wood, head, origin=(0, y, z), axis=(1, 0, 0), segments=26)
    b.lathe(brass, [(r * 0.86, -w * 0.05), (r * 0.86, w * 0.05)], origin=(0, y, z), axis=(1, 0, 0), segments=26)
    along = d - w * 0.5
    curve = np.multiply([(0.009, 0), (0.008, 0.3), (0.011, 0.6), (0.015, 0.88), (0.012, 0.98), (0.004, 1)], (1, along))
    shaft = bent(curve, 2)
    b.lathe(wood, shaft, origin=(0, y, z), axis=(0, 1, -0.12), segments=14)
    return two_hands((-0.014, d * 0.32, z - h * 0.12), (0.25, -0.8, -0.5), (0.95, 0.2, -0.1), FIST)


@prop("fire_extinguisher")
def fire_extinguisher(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fire extinguisher."""
    (w, d, h), body, black = spec.size, spec.material("body"), spec.material("hose")
    r = d / 2 * 0.92
    profile = [(r * 0.9, 0), (r, 0.012), (r, h * 0.7), (r * 0.8, h * 0.79), (r * 0.35, h * 0.83)]
    b.lathe(body, bent(profile, 3), segments=28)
    b.lathe("paper", [(r * 1.03, h * 0.32), (r * 1.03, h * 0.58)], segments=28, caps=False)
    b.cylinder("brass", (0, 0, h * 0.82), (0, 0, h * 0.9), r * 0.3)
    b.box(black, (0, -r * 0.5, h * 0.9), (0.026, r * 1.9, 0.016), bevel=0.003, rotation=(6, 0, 0))
    b.box(black, (0, -r * 0.55, h * 0.97), (0.026, r * 2.0, 0.014), bevel=0.003, rotation=(-10, 0, 0))
    path = [(r * 0.3, 0, h * 0.87), (w * 0.46, 0, h * 0.8), (w * 0.5, 0, h * 0.5), (r * 1.1, 0, h * 0.2)]
    b.tube(black, bent(path), 0.012)
    b.cylinder(black, (r * 1.12, 0, h * 0.22), (r * 1.06, 0, h * 0.06), 0.014, 0.026, segments=14)
    angle = np.linspace(0, math.tau, 24, endpoint=False)
    path = np.c_[r * 1.01 * np.cos(angle), r * 1.01 * np.sin(angle), np.full(24, h * 0.64)]
    b.tube("steel", path, 0.004, segments=5, closed=True)
    return two_hands((-0.013, -r * 0.7, h * 0.94), (0.1, -0.95, 0.1), (1, 0, 0), FIST)
