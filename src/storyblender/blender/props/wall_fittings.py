"""Prop builders: what hangs on or stands against walls: pictures, mirrors, clocks, boards, curtains."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.parts import panel_door, turned_leg
from storyblender.blender.props.registry import PropSpec, prop

WHOLE = ((0, 0), (1, 0), (1, 1), (0, 1))
"""The picture once over a face."""


def frame(
    b: MeshBuilder, material: MaterialRef, width: float, height: float, thick: float, depth: float, y: float, low: float
) -> None:
    """Add a moulded picture frame that faces -Y.

    Args:
        b: Receives the parts.
        material: Of the frame.
        width: Outside, along X, metres.
        height: Outside, along Z.
        thick: Width of the moulding.
        depth: Along Y.
        y: Of its back.
        low: Z of its lower edge.
    """
    for x in (-1, 1):
        center = (x * (width - thick) / 2, y - depth / 2, low + height / 2)
        b.box(material, center, (thick, depth, height), bevel=depth * 0.3)
    for z in (thick / 2, height - thick / 2):
        b.box(material, (0, y - depth / 2, low + z), (width - thick, depth, thick), bevel=depth * 0.3)


def sheet(b: MeshBuilder, material: MaterialRef, width: float, height: float, y: float, low: float) -> None:
    """Add a flat picture that faces -Y and shows its texture once.

    Args:
        b: Receives the picture.
        material: With the texture.
        width: Along X, metres.
        height: Along Z.
        y: Of the picture.
        low: Z of its lower edge.
    """
    x = width / 2
    b.quad(material, (-x, y, low), (x, y, low), (x, y, low + height), (-x, y, low + height), uv=WHOLE)


@prop("wall_mirror")
def wall_mirror(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a framed mirror."""
    w, d, h = spec.size
    frame(b, spec.material("frame"), w, h, 0.07, d, d / 2, 0)
    b.box(spec.material("mirror"), (0, 0, h / 2), (w - 0.1, d * 0.4, h - 0.1))
    return ()


@prop("standing_mirror")
def standing_mirror(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tall mirror that swings between two posts."""
    (w, d, h), wood = spec.size, spec.material("frame")
    for x in (-1, 1):
        side = x * (w / 2 - 0.025)
        turned_leg(b, wood, side, 0, h * 0.62, 0.028)
        b.tube(wood, [(side, -d / 2, 0.015), (side, -d * 0.2, 0.07), (side, d * 0.2, 0.07), (side, d / 2, 0.015)], 0.02)
    b.cylinder(wood, (-w / 2 + 0.03, 0, 0.2), (w / 2 - 0.03, 0, 0.2), 0.015)
    with b.at((0, 0, 0.24), (-4, 0, 0)):
        frame(b, wood, w - 0.12, h - 0.26, 0.045, 0.04, 0.02, 0)
        b.box(spec.material("mirror"), (0, 0, (h - 0.26) / 2), (w - 0.18, 0.012, h - 0.32))
    return ()


@prop("picture")
def picture(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a framed painting."""
    w, d, h = spec.size
    frame(b, spec.material("frame"), w, h, 0.07, d, d / 2, 0)
    b.box("canvas", (0, d * 0.3, h / 2), (w - 0.1, d * 0.3, h - 0.1))
    sheet(b, spec.material("canvas"), w - 0.13, h - 0.13, d * 0.1, 0.065)
    return ()


@prop("wall_map")
def wall_map(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a map hanging between two rods."""
    (w, d, h), wood = spec.size, spec.material("frame")
    sheet(b, spec.material("map"), w - 0.06, h - 0.04, d * 0.2, 0.02)
    b.box("paper", (0, d * 0.35, h / 2), (w - 0.05, d * 0.2, h - 0.03))
    for z in (0.018, h - 0.018):
        b.cylinder(wood, (-w / 2, 0.0, z), (w / 2, 0.0, z), 0.018)
    return ()


def dial(b: MeshBuilder, material: MaterialRef, radius: float, y: float, z: float) -> None:
    """Add a round clock face that faces -Y and shows its texture once.

    Args:
        b: Receives the face.
        material: With the texture.
        radius: Metres.
        y: Of the face.
        z: Of its middle.
    """
    angle = np.linspace(0, 2 * math.pi, 32, endpoint=False)
    ring = np.c_[np.cos(angle), np.sin(angle)]
    b.polygon(material, np.c_[radius * ring[:, 0], np.full(32, y), z + radius * ring[:, 1]], uv=0.5 + 0.5 * ring)


@prop("wall_clock")
def wall_clock(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a round clock; the hands are modelled, the marks are painted."""
    w, d, h = spec.size
    r = w / 2
    profile = [(r * 0.9, 0), (r, d * 0.2), (r, d * 0.7), (r * 0.93, d), (r * 0.87, d * 0.9), (r * 0.86, d * 0.75)]
    b.lathe(spec.material("frame"), profile, origin=(0, d / 2, h / 2), axis=(0, -1, 0), segments=36)
    b.lathe("porcelain", [(r * 0.86, d * 0.76)] * 2, origin=(0, d / 2, h / 2), axis=(0, -1, 0), segments=36)
    for k in range(12):
        turn = math.tau * k / 12
        center = (r * 0.74 * math.sin(turn), -d * 0.28, h / 2 + r * 0.74 * math.cos(turn))
        b.box("plastic_black", center, (0.008, 0.003, r * 0.13), rotation=(0, math.degrees(turn), 0))
    for degrees, length, width in (
        (spec.number("hour") * 30 + spec.number("minute") / 2, 0.46, 0.014),
        (spec.number("minute") * 6, 0.7, 0.009),
    ):
        with b.at((0, -d * 0.3, h / 2), (0, degrees, 0)):
            b.box("plastic_black", (0, 0, r * length * 0.42), (width, 0.003, r * length))
    return ()


@prop("grandfather_clock")
def grandfather_clock(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a longcase clock with a pendulum behind its door."""
    (w, d, h), wood, brass = spec.size, spec.material("body"), spec.material("metal")
    b.box(wood, (0, 0, 0.2), (w, d, 0.4), bevel=0.02)
    b.box(wood, (0, 0.01, h * 0.47), (w * 0.68, d * 0.75, h * 0.58), bevel=0.012)
    b.box(wood, (0, 0, h * 0.85), (w * 0.9, d * 0.92, h * 0.24), bevel=0.015)
    b.box(wood, (0, 0, h * 0.73), (w, d, 0.04), bevel=0.012)
    b.box(wood, (0, 0, h * 0.975), (w, d, 0.05), bevel=0.018)
    panel_door(b, wood, (0, -d * 0.37, h * 0.46), w * 0.52, h * 0.44)
    b.box("plastic_black", (0, -d * 0.38, h * 0.46), (w * 0.36, 0.01, h * 0.38))
    b.cylinder(brass, (0.02, -d * 0.4, h * 0.34), (0, -d * 0.4, h * 0.6), 0.006)
    b.lathe(brass, [(0.06, 0), (0.055, 0.012), (0.02, 0.016)], origin=(0.02, -d * 0.385, h * 0.34), axis=(0, -1, 0))
    profile = [(w * 0.38, 0), (w * 0.38, 0.012), (w * 0.35, 0.014)]
    b.lathe(brass, profile, origin=(0, -d * 0.46, h * 0.85), axis=(0, -1, 0), segments=32)
    dial(b, spec.material("face"), w * 0.35, -d * 0.46 - 0.016, h * 0.85)
    for x in (-1, 0, 1):
        b.lathe(brass, [(0.015, 0), (0.03, 0.03), (0.004, 0.08)], origin=(x * w * 0.4, 0, h - 0.02), segments=12)
    return ()


@prop("mantel_clock")
def mantel_clock(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a clock with an arched case."""
    (w, d, h), wood = spec.size, spec.material("body")
    b.box(wood, (0, 0, 0.02), (w, d, 0.04), bevel=0.008)
    arch = [(w * 0.34 * math.cos(a), h - w * 0.34 + w * 0.34 * math.sin(a)) for a in np.linspace(0, math.pi, 17)]
    with b.at((0, d * 0.4, 0), (90, 0, 0)):
        b.extrude(wood, [(w * 0.34, 0.03), *arch, (-w * 0.34, 0.03)], d * 0.8)
    profile = [(w * 0.29, 0), (w * 0.29, 0.01), (w * 0.26, 0.012)]
    b.lathe("brass", profile, origin=(0, -d * 0.4, h - w * 0.34), axis=(0, -1, 0), segments=28)
    dial(b, spec.material("face"), w * 0.26, -d * 0.4 - 0.014, h - w * 0.34)
    return ()


@prop("calendar")
def calendar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wall calendar: a picture over a page of squares."""
    (w, d, h), ink = spec.size, spec.material("ink")
    b.box(spec.material("page"), (0, d * 0.1, h / 2), (w, d * 0.6, h))
    sheet(b, "picture", w - 0.03, h * 0.42, -d * 0.25, h * 0.55)
    for row in range(5):
        for column in range(7):
            x, z = (column - 3) * w * 0.125, h * (0.42 - 0.085 * row)
            b.box(ink, (x, -d * 0.25, z), (w * 0.05, 0.002, h * 0.03))
    return ()


@prop("notice_board")
def notice_board(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cork board with pinned papers."""
    w, d, h = spec.size
    frame(b, spec.material("frame"), w, h, 0.05, d, d / 2, 0)
    b.box(spec.material("board"), (0, d * 0.2, h / 2), (w - 0.08, d * 0.4, h - 0.08))
    for column in range(5):
        for row in range(3):
            if spec.rng.random() < 0.8:
                x, z = (column - 2) * w * 0.175 + spec.rng.uniform(-0.03, 0.03), h * (0.24 + 0.26 * row)
                size = (float(spec.rng.uniform(0.1, 0.18)), 0.004, float(spec.rng.uniform(0.12, 0.2)))
                kind = "newsprint" if spec.rng.random() < 0.3 else spec.material("note")
                b.box(kind, (x, -d * 0.06, z), size, rotation=(0, float(spec.rng.uniform(-7, 7)), 0))
                b.sphere("neon_red", (x, -d * 0.12, z + size[2] * 0.4), 0.008, segments=8, rings=5)
    return ()


@prop("blackboard")
def blackboard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a blackboard with a ledge, chalk and some lines of writing."""
    (w, d, h), wood = spec.size, spec.material("frame")
    frame(b, wood, w, h, 0.06, 0.04, d / 2, 0)
    b.box(spec.material("board"), (0, d / 2 - 0.015, h / 2), (w - 0.1, 0.02, h - 0.1))
    b.box(wood, (0, 0, 0.04), (w - 0.2, d, 0.02), bevel=0.005)
    b.cylinder("porcelain", (-0.2, -0.01, 0.058), (-0.12, 0.0, 0.058), 0.007)
    b.box("fabric", (0.3, -0.01, 0.07), (0.12, 0.05, 0.04), bevel=0.008)
    for row in range(4):
        x = -w * 0.4
        while x < w * 0.4 - row * 0.3:
            length = float(spec.rng.uniform(0.08, 0.24))
            b.box("porcelain", (x + length / 2, d / 2 - 0.027, h * (0.8 - 0.16 * row)), (length, 0.002, 0.022))
            x += length + 0.06
    return ()


@prop("curtain")
def curtain(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pair of curtains; ``open`` 0 closes them, 1 gathers them at the sides."""
    (w, d, h), cloth, rod = spec.size, spec.material("cloth"), spec.material("rod")
    b.cylinder(rod, (-w / 2, 0, h - 0.03), (w / 2, 0, h - 0.03), 0.014)
    span = w / 2 * (1 - 0.65 * min(max(spec.number("open"), 0.0), 1.0)) - 0.02
    folds = 7
    t = np.linspace(0, 1, folds * 8 + 1)
    for x in (-1, 1):
        b.sphere(rod, (x * (w / 2 - 0.015), 0, h - 0.03), 0.03)
        rows = []
        for z, gather in ((0.0, 1.0), (h * 0.35, 0.94), (h * 0.7, 0.98), (h - 0.05, 1.0)):
            wave = (d / 2 - 0.03) * np.sin(2 * math.pi * folds * t) * (0.7 + 0.3 * (1 - z / h))
            rows.append(np.c_[x * (w / 2 - 0.02 - span * gather * t), wave, np.full(len(t), z)])
        for lift, order in ((0.0, 1), (0.012, -1)):
            b.loft(cloth, [(row + np.array([0, lift, 0]))[:: order * x] for row in rows], closed=False)
        for k in range(folds):
            profile = [(0.02, -0.004), (0.024, 0.0), (0.02, 0.004)]
            b.lathe(
                rod, profile, origin=(x * (w / 2 - 0.04 - span * k / folds), 0, h - 0.03), axis=(1, 0, 0), segments=10
            )
    return ()
