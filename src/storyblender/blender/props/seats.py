"""Prop builders: things to sit on. Fronts face -Y; every seat's anchor is the middle of its front edge."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, seat, seats_in_row
from storyblender.blender.props.parts import four_legs, spoked_wheel, turned_leg
from storyblender.blender.props.registry import PropSpec, prop


@prop("chair")
def chair(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wooden chair: ``style`` slat or bent."""
    (w, d, h), wood, top = spec.size, spec.material("frame"), spec.material("seat")
    sit, front, back = h * 0.5, -d / 2, d / 2
    for x in (-1, 1):
        inner = x * (w / 2 - 0.03)
        b.cylinder(wood, (inner * 1.03, front + 0.03, 0), (inner, front + 0.04, sit - 0.02), 0.014, 0.021, segments=10)
        post = [(inner * x, back - y, sit * z) for x, y, z in ((1, 0, 0), (0.97, 0.07, 0.95), (0.95, 0.06, 1.25))]
        b.tube(wood, [*post, (inner * 0.9, back - 0.02, h - 0.03)], (0.018, 0.021, 0.02, 0.016), segments=10)
        b.cylinder(wood, (inner, front + 0.04, sit * 0.42), (inner, back - 0.04, sit * 0.42), 0.011, segments=8)
    b.cylinder(wood, (-w / 2 + 0.04, 0, sit * 0.42), (w / 2 - 0.04, 0, sit * 0.42), 0.011, segments=8)
    if spec.word("style") == "bent":
        b.lathe(top, [(w * x, sit - z) for x, z in ((0.44, 0.03), (0.48, 0.02), (0.48, 0.005), (0.42, 0))], segments=28)
        for reach, low, rise in ((0.42, h - 0.17, 0.15), (0.24, h - 0.3, 0.2)):
            arc = [
                (w * reach * math.cos(a), back - 0.035, low + rise * math.sin(a)) for a in np.linspace(0, math.pi, 11)
            ]
            b.tube(wood, [(w * reach, back - 0.06, sit), *arc, (-w * reach, back - 0.06, sit)], 0.013)
    else:
        b.box(top, (0, -0.02, sit - 0.018), (w, d * 0.86, 0.036), bevel=0.01, taper=0.97)
        b.box(wood, (0, 0, sit - 0.06), (w - 0.08, d * 0.72, 0.05))
        for k, height in enumerate((0.64, 0.78, 0.93)):
            center = (0, back - 0.045 + 0.01 * k, h * height)
            b.box(wood, center, (w - 0.09, 0.016, h * 0.075), bevel=0.005, rotation=(-6, 0, 0))
    return (seat((0, front + 0.02, sit), (w, d * 0.86)),)


@prop("armchair")
def armchair(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stuffed chair, with wings if wanted."""
    (w, d, h), cover, leg = spec.size, spec.material("cover"), spec.material("leg")
    arm, sit, front = w * 0.19, h * 0.47, -d / 2
    inner = w - 2 * arm
    for x in (-1, 1):
        for y in (front + 0.09, d / 2 - 0.1):
            b.cylinder(leg, (x * (w / 2 - 0.09), y, 0), (x * (w / 2 - 0.08), y, 0.12), 0.018, 0.03, segments=10)
        b.rounded_box(cover, (x * (w - arm) / 2, 0.02, 0.1 + h * 0.23), (arm, d * 0.92, h * 0.46), 0.05)
        start, end = (x * (w - arm) / 2, front + 0.05, h * 0.6), (x * (w - arm) / 2, d * 0.36, h * 0.62)
        b.cylinder(cover, start, end, arm * 0.55, segments=16)
        if spec.flag("wings"):
            center = (x * (w / 2 - 0.09), d * 0.24, h * 0.82)
            b.rounded_box(cover, center, (0.09, d * 0.3, h * 0.32), 0.04, rotation=(0, 0, x * 12))
    b.rounded_box(cover, (0, 0.02, 0.12 + h * 0.12), (inner, d * 0.9, h * 0.24), 0.03)
    b.cushion(cover, (0, -0.05, sit - 0.075), (inner + 0.02, d * 0.78, 0.17), softness=0.22)
    b.rounded_box(cover, (0, d / 2 - 0.12, h * 0.58), (w * 0.88, 0.2, h * 0.82), 0.09, rotation=(-8, 0, 0))
    b.cushion(cover, (0, d / 2 - 0.24, sit + 0.2), (inner, 0.17, 0.42), softness=0.3, rotation=(-10, 0, 0))
    return (seat((0, front + 0.04, sit), (inner, d * 0.62)),)


@prop("sofa")
def sofa(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sofa with as many seat cushions as wanted."""
    (w, d, h), cover, leg = spec.size, spec.material("cover"), spec.material("leg")
    arm, sit, front, count = 0.19, h * 0.52, -d / 2, spec.count("cushions")
    inner = w - 2 * arm
    for x in (-1, 1):
        for y in (front + 0.09, d / 2 - 0.1):
            b.cylinder(leg, (x * (w / 2 - 0.1), y, 0), (x * (w / 2 - 0.09), y, 0.11), 0.02, 0.032, segments=10)
        b.rounded_box(cover, (x * (w - arm) / 2, 0.0, h * 0.4), (arm, d * 0.96, h * 0.56), 0.06)
        start, end = (x * (w - arm) / 2, front + 0.01, h * 0.68), (x * (w - arm) / 2, d * 0.4, h * 0.68)
        b.cylinder(cover, start, end, arm * 0.56, segments=16)
    b.rounded_box(cover, (0, 0.02, 0.11 + h * 0.13), (inner + 0.04, d * 0.92, h * 0.26), 0.03)
    b.rounded_box(cover, (0, d / 2 - 0.12, h * 0.56), (w * 0.97, 0.22, h * 0.84), 0.09, rotation=(-7, 0, 0))
    step = inner / count
    for i in range(count):
        x = (i - (count - 1) / 2) * step
        b.cushion(cover, (x, -0.06, sit - 0.075), (step * 1.01, d * 0.8, 0.17), softness=0.2)
        b.cushion(cover, (x, d / 2 - 0.26, sit + 0.18), (step * 0.99, 0.18, 0.4), softness=0.28, rotation=(-10, 0, 0))
    return seats_in_row(spec.entry.seats, inner, front + 0.03, sit, d * 0.6)


@prop("office_chair")
def office_chair(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a swivel chair."""
    (w, d, h), cover, metal = spec.size, spec.material("cover"), spec.material("metal")
    sit = 0.47 * h
    for k in range(5):
        with b.at(rotation=(0, 0, 72 * k + 17)):
            b.tube(metal, [(0, 0, 0.12), (0.28, 0, 0.07)], (0.028, 0.016), segments=8)
            b.sphere(metal, (0.28, 0, 0.03), 0.03, segments=10, rings=6)
    b.cylinder(metal, (0, 0, 0.1), (0, 0, sit - 0.06), 0.028)
    b.cushion(cover, (0, -0.02, sit - 0.03), (w * 0.8, d * 0.78, 0.1), softness=0.22)
    b.tube(metal, [(0, 0.1, sit - 0.07), (0, d * 0.4, sit - 0.05), (0, d * 0.44, sit + 0.25)], 0.018)
    b.cushion(cover, (0, d * 0.4, h - 0.24), (w * 0.74, 0.1, 0.46), softness=0.25, rotation=(-8, 0, 0))
    for x in (-1, 1):
        rail = [(x * w * 0.36, 0.08, sit - 0.05), (x * w * 0.47, 0.08, sit), (x * w * 0.47, 0.06, sit + 0.2)]
        b.tube(metal, rail, 0.014)
        b.rounded_box(cover, (x * w * 0.47, 0.0, sit + 0.21), (0.055, 0.27, 0.035), 0.015)
    return (seat((0, -d * 0.36, sit + 0.01), (w * 0.8, d * 0.7)),)


@prop("stool")
def stool(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a three-legged stool."""
    (w, _, h), top, wood = spec.size, spec.material("seat"), spec.material("frame")
    r = w / 2
    if spec.flag("cushion"):
        b.lathe(top, [(r * 0.9, h - 0.06), (r, h - 0.04), (r, h - 0.015), (r * 0.8, h)], segments=28)
    else:
        b.lathe(top, [(r * 0.92, h - 0.045), (r, h - 0.035), (r, h - 0.008), (r * 0.95, h)], segments=28)
    for k in range(3):
        turn = 2 * math.pi * k / 3 + math.pi / 2
        c, s = math.cos(turn), math.sin(turn)
        b.cylinder(
            wood, (r * 0.98 * c, r * 0.98 * s, 0), (r * 0.55 * c, r * 0.55 * s, h - 0.04), 0.016, 0.022, segments=10
        )
    ring = [
        (r * 0.8 * math.cos(a), r * 0.8 * math.sin(a), h * 0.38)
        for a in np.linspace(0, 2 * math.pi, 18, endpoint=False)
    ]
    b.tube(wood, ring, 0.009, segments=6, closed=True)
    return (seat((0, -r * 0.9, h), (w * 0.9, w * 0.9)),)


@prop("bar_stool")
def bar_stool(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bar stool with a foot ring."""
    (w, _, h), cover, metal = spec.size, spec.material("cover"), spec.material("metal")
    r = w / 2
    b.lathe(cover, [(r * 0.82, h - 0.09), (r * 0.92, h - 0.075), (r * 0.92, h - 0.02), (r * 0.75, h)], segments=28)
    b.lathe(metal, [(r * 0.84, h - 0.1), (r * 0.95, h - 0.09), (r * 0.95, h - 0.07)], segments=28)
    b.lathe(metal, [(r, 0), (r * 0.96, 0.02), (0.05, 0.05), (0.028, 0.1), (0.028, h - 0.1)], segments=24)
    ring = [
        (r * 0.85 * math.cos(a), r * 0.85 * math.sin(a), h * 0.36)
        for a in np.linspace(0, 2 * math.pi, 24, endpoint=False)
    ]
    b.tube(metal, ring, 0.011, segments=8, closed=True)
    b.cylinder(metal, (-r * 0.85, 0, h * 0.36), (r * 0.85, 0, h * 0.36), 0.009, segments=8)
    return (seat((0, -r * 0.85, h - 0.005), (w * 0.85, w * 0.85)),)


@prop("bench")
def bench(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a plain bench."""
    (w, d, h), wood, top = spec.size, spec.material("frame"), spec.material("seat")
    for y in (-d / 4, d / 4):
        b.box(top, (0, y, h - 0.02), (w, d / 2 - 0.012, 0.04), bevel=0.008)
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.16), 0, (h - 0.04) / 2), (0.06, d * 0.86, h - 0.04), bevel=0.006)
    b.box(wood, (0, 0, h * 0.4), (w - 0.3, 0.04, 0.09), bevel=0.005)
    return seats_in_row(spec.entry.seats, w, -d / 2, h, d)


@prop("pew")
def pew(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a church or court bench with solid ends."""
    (w, d, h), wood, top = spec.size, spec.material("frame"), spec.material("seat")
    sit = h * 0.48
    for x in (-1, 1):
        outline = [
            (-d / 2, 0), (d / 2, 0), (d / 2, h), (d / 2 - 0.1, h), (d / 2 - 0.16, sit + 0.2),
            (-d / 2 + 0.05, sit + 0.16), (-d / 2, sit),
        ]  # fmt: skip
        with b.at((x * (w / 2 - 0.025) - 0.025, 0, 0), (90, 0, 90)):
            b.extrude(wood, outline, 0.05)
    b.box(top, (0, -0.04, sit - 0.02), (w - 0.1, d * 0.8, 0.04), bevel=0.008)
    b.box(wood, (0, d / 2 - 0.08, (sit + h) / 2 - 0.02), (w - 0.1, 0.03, h - sit), bevel=0.006, rotation=(-6, 0, 0))
    b.box(wood, (0, d / 2 - 0.05, h - 0.03), (w - 0.06, 0.07, 0.04), bevel=0.008)
    b.box(wood, (0, -d / 2 + 0.08, sit * 0.5), (w - 0.1, 0.025, sit * 0.7))
    return seats_in_row(spec.entry.seats, w - 0.1, -d / 2 + 0.04, sit, d * 0.75)


@prop("rocking_chair")
def rocking_chair(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a rocking chair with a spindle back."""
    (w, d, h), wood, top = spec.size, spec.material("frame"), spec.material("seat")
    sit = 0.42
    for x in (-1, 1):
        side = x * (w / 2 - 0.05)
        arc = [(side, y, 0.02 + 0.22 * (y / d) ** 2 * 1.6) for y in np.linspace(-d / 2, d / 2, 9)]
        b.tube(wood, arc, 0.018)
        b.cylinder(wood, (side, -d * 0.24, 0.06), (side, -d * 0.24, 0.66), 0.016, segments=8)
        b.cylinder(wood, (side, d * 0.16, 0.05), (side * 0.9, d * 0.33, h - 0.02), 0.017, segments=8)
        b.box(wood, (side, -0.02, 0.67), (0.06, d * 0.56, 0.025), bevel=0.006)
    b.box(top, (0, -0.03, sit - 0.015), (w - 0.08, d * 0.5, 0.035), bevel=0.008, rotation=(-4, 0, 0))
    for z, y in ((h - 0.05, d * 0.325), (sit + 0.12, d * 0.21)):
        b.box(wood, (0, y, z), (w - 0.14, 0.025, 0.09), bevel=0.006, rotation=(-14, 0, 0))
    for x in np.linspace(-0.32, 0.32, 6):
        b.cylinder(wood, (x * w, d * 0.21, sit + 0.1), (x * w, d * 0.325, h - 0.06), 0.009, segments=6)
    return (seat((0, -d * 0.27, sit + 0.02), (w - 0.1, d * 0.45)),)


@prop("deck_chair")
def deck_chair(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a deck chair: two crossed frames and a sling."""
    (w, d, h), cover, wood = spec.size, spec.material("cover"), spec.material("frame")
    for x in (-1, 1):
        side = x * (w / 2 - 0.025)
        b.cylinder(wood, (side, -d / 2 + 0.02, 0.02), (side, d / 2 - 0.02, h - 0.02), 0.018, segments=8)
        b.cylinder(wood, (side * 0.92, -d / 2 + 0.12, 0.42), (side * 0.92, d / 2 - 0.12, 0.02), 0.018, segments=8)
    for y, z in ((-d / 2 + 0.12, 0.42), (d / 2 - 0.02, h - 0.02), (d / 2 - 0.12, 0.02), (-d / 2 + 0.02, 0.02)):
        b.cylinder(wood, (-w / 2 + 0.02, y, z), (w / 2 - 0.02, y, z), 0.016, segments=8)
    sag = [(-d / 2 + 0.12, 0.43), (-d * 0.2, 0.3), (0.0, 0.27), (d * 0.2, 0.4), (d * 0.36, 0.62), (d / 2 - 0.02, h)]
    for lift in (0.0, -0.008):
        rows = [
            np.array([(x * (w / 2 - 0.06), y, z + lift) for x in ((-1, 0, 1) if lift == 0 else (1, 0, -1))])
            for y, z in sag
        ]
        b.loft(cover, rows, closed=False)
    return (seat((0, -d * 0.32, 0.36), (w - 0.14, d * 0.5)),)


@prop("wheelchair")
def wheelchair(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wheelchair."""
    (w, d, h), cover, metal, tyre = spec.size, spec.material("cover"), spec.material("metal"), spec.material("tyre")
    sit, half = 0.5, w / 2
    b.cushion(cover, (0, 0.0, sit - 0.03), (w - 0.16, 0.44, 0.08), softness=0.2)
    b.rounded_box(cover, (0, 0.23, sit + 0.22), (w - 0.16, 0.04, 0.4), 0.015, rotation=(-6, 0, 0))
    for x in (-1, 1):
        side = x * (half - 0.075)
        spoked_wheel(b, tyre, metal, (x * (half - 0.02), 0.16, 0.3), 0.28, 0.018, 12)
        spoked_wheel(b, tyre, metal, (side, -d / 2 + 0.2, 0.1), 0.085, 0.014, 5)
        b.tube(metal, [(side, -0.22, sit), (side, 0.2, sit), (side, 0.27, h - 0.02), (side, 0.4, h)], 0.012)
        path = [(side, 0.22, sit + 0.22), (side, -0.16, sit + 0.22), (side, -0.22, sit), (side, -d / 2 + 0.12, 0.12)]
        b.tube(metal, path, 0.012)
        b.rounded_box(cover, (side, 0.02, sit + 0.235), (0.05, 0.3, 0.03), 0.012)
        b.box(metal, (x * 0.17, -d / 2 + 0.09, 0.1), (0.2, 0.16, 0.012), rotation=(-15, 0, 0))
    return (seat((0, -0.22, sit), (w - 0.18, 0.44)),)


@prop("booth")
def booth(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a diner banquette with buttoned channels."""
    (w, d, h), cover, wood = spec.size, spec.material("cover"), spec.material("frame")
    sit = 0.46
    b.box(wood, (0, 0.02, sit * 0.36), (w, d - 0.08, sit * 0.72), bevel=0.006)
    b.rounded_box(cover, (0, -0.03, sit - 0.07), (w, d - 0.06, 0.14), 0.05)
    b.box(wood, (0, d / 2 - 0.04, h / 2), (w, 0.08, h), bevel=0.01)
    count = max(4, round(w / 0.2))
    for i in range(count):
        x = (i - (count - 1) / 2) * w / count
        center = (x, d / 2 - 0.13, (sit + h) / 2 - 0.02)
        b.rounded_box(cover, center, (w / count * 1.02, 0.12, h - sit - 0.06), 0.05, rotation=(-5, 0, 0))
    return seats_in_row(spec.entry.seats, w, -d / 2, sit, d - 0.2)


@prop("carriage_seat")
def carriage_seat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build the upholstered bench of a railway carriage."""
    (w, d, h), cover, wood = spec.size, spec.material("cover"), spec.material("frame")
    sit = 0.47
    b.box(wood, (0, 0.02, 0.17), (w, d - 0.12, 0.34), bevel=0.02)
    b.cushion(cover, (0, -0.03, sit - 0.08), (w - 0.04, d - 0.06, 0.16), softness=0.2)
    b.box(wood, (0, d / 2 - 0.025, h / 2), (w, 0.05, h), bevel=0.02)
    b.cushion(
        cover, (0, d / 2 - 0.11, (sit + h) / 2), (w - 0.04, 0.15, h - sit - 0.1), softness=0.2, rotation=(-6, 0, 0)
    )
    for x in (-1, 1):
        b.box(wood, (x * (w / 2 - 0.025), -0.01, 0.6), (0.05, d - 0.08, 0.07), bevel=0.02)
    return seats_in_row(spec.entry.seats, w - 0.1, -d / 2, sit, d - 0.2)


@prop("car_seat")
def car_seat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build the front seat of a car."""
    (w, d, h), cover, iron = spec.size, spec.material("cover"), spec.material("frame")
    sit, neck = 0.44, h - 0.24
    b.box(iron, (0, 0.0, 0.14), (w * 0.8, d * 0.7, 0.28), bevel=0.02)
    b.cushion(cover, (0, -0.04, sit - 0.08), (w, d - 0.08, 0.18), softness=0.25)
    for x in (-1, 1):
        b.cushion(cover, (x * w * 0.4, -0.04, sit - 0.03), (w * 0.2, d - 0.12, 0.14), softness=0.4)
    b.cushion(
        cover, (0, d / 2 - 0.1, (sit + neck) / 2), (w, 0.16, neck - sit + 0.12), softness=0.25, rotation=(-8, 0, 0)
    )
    for x in (-0.07, 0.07):
        b.cylinder(iron, (x, d / 2 - 0.05, neck - 0.04), (x, d / 2 - 0.03, h - 0.1), 0.01, segments=8)
    b.cushion(cover, (0, d / 2 - 0.05, h - 0.1), (w * 0.5, 0.1, 0.2), softness=0.35)
    return (seat((0, -d / 2 + 0.1, sit), (w * 0.8, d * 0.7)),)


@prop("porch_swing")
def porch_swing(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a slatted bench that hangs on four chains from a ceiling at its height."""
    (w, d, h), wood = spec.size, spec.material("seat")
    sit, top = 0.46, 1.0
    for y in np.linspace(-d / 2 + 0.05, d / 2 - 0.16, 5):
        b.box(wood, (0, float(y), sit - 0.02), (w - 0.08, 0.08, 0.03), bevel=0.006)
    for z in np.linspace(sit + 0.12, top - 0.04, 4):
        b.box(wood, (0, d / 2 - 0.1 + 0.12 * (float(z) - sit), float(z)), (w - 0.08, 0.025, 0.09), bevel=0.006)
    for x in (-1, 1):
        at = x * (w / 2 - 0.03)
        b.box(wood, (at, -0.03, sit - 0.05), (0.06, d - 0.14, 0.06), bevel=0.008)
        b.box(wood, (at, d / 2 - 0.07, (sit + top) / 2), (0.06, 0.06, top - sit), bevel=0.008, rotation=(-7, 0, 0))
        b.box(wood, (at, -0.06, sit + 0.22), (0.08, d - 0.2, 0.035), bevel=0.01)
        b.box(wood, (at, -d / 2 + 0.1, sit + 0.1), (0.05, 0.05, 0.24))
        for y in (-d / 2 + 0.1, d / 2 - 0.08):
            b.cylinder("iron", (at, y, sit + 0.2), (at, 0.0, h - 0.5), 0.012, segments=6)
        b.cylinder("iron", (at, 0.0, h - 0.5), (at, 0.0, h), 0.012, segments=6)
    return seats_in_row(spec.entry.seats, w - 0.12, -d / 2 + 0.06, sit, d * 0.75)


@prop("throne")
def throne(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a state chair with a crested back."""
    (w, d, h), gold, cover = spec.size, spec.material("frame"), spec.material("cover")
    sit = 0.52
    b.box(gold, (0, 0, 0.06), (w, d, 0.12), bevel=0.015)
    b.box(gold, (0, 0.02, 0.28), (w * 0.8, d * 0.8, 0.34), bevel=0.015)
    b.cushion(cover, (0, -0.02, sit - 0.04), (w * 0.72, d * 0.78, 0.12), softness=0.2)
    crest = [(-w * 0.4, 0), (w * 0.4, 0), (w * 0.42, h * 0.52), (w * 0.3, h * 0.6), (w * 0.16, h * 0.64), (0, h * 0.8),
             (-w * 0.16, h * 0.62), (-w * 0.3, h * 0.6), (-w * 0.42, h * 0.52)]  # fmt: skip
    with b.at((0, d / 2 - 0.02, sit - 0.25), (90, 0, 0)):
        b.extrude(gold, crest, 0.09)
    b.rounded_box(cover, (0, d / 2 - 0.13, sit + 0.38), (w * 0.6, 0.06, h * 0.4), 0.025)
    b.sphere(gold, (0, d / 2 - 0.06, h - 0.09), 0.07)
    for x in (-1, 1):
        turned_leg(b, gold, x * (w / 2 - 0.09), -d / 2 + 0.08, sit + 0.24, 0.05)
        b.rounded_box(gold, (x * (w / 2 - 0.09), -0.0, sit + 0.27), (0.11, d * 0.82, 0.07), 0.03)
        b.sphere(gold, (x * (w / 2 - 0.09), -d / 2 + 0.07, sit + 0.28), 0.07)
        b.sphere(gold, (x * w * 0.41, d / 2 - 0.06, sit - 0.22 + h * 0.52), 0.055)
    four_legs(b, gold, w * 0.84, d * 0.84, 0.2, 0.07)
    return (seat((0, -d / 2 + 0.06, sit + 0.01), (w * 0.68, d * 0.7)),)
