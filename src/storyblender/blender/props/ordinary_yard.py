"""Prop builders: larger ordinary things: excavator, standing fan, mattress, ironing board, clubs and skis."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.aircraft_and_works import DARK
from storyblender.blender.props.anchors import (
    FIST,
    Anchors,
    bed_anchor,
    boarding_place,
    grips_around,
    grips_under,
    seat,
    two_hands,
)
from storyblender.blender.props.machines import fan_head
from storyblender.blender.props.ordinary_hardware import ring_of
from storyblender.blender.props.parts import bent, rectangle
from storyblender.blender.props.registry import PropSpec, prop


def _plate(b: MeshBuilder, material: MaterialRef, outline: ArrayLike, x: float, width: float) -> None:
    """Add a plate with an outline of (y, z) corners, its middle at ``x``."""
    with b.at((x - width / 2, 0, 0), (90, 0, 90)):
        b.extrude(material, outline, width)


def _ram(b: MeshBuilder, start: tuple[float, float, float], end: tuple[float, float, float]) -> None:
    """Add a hydraulic cylinder with its bright rod."""
    middle = np.add(start, np.subtract(end, start) * 0.58)
    b.cylinder(DARK, start, middle, 0.075)
    b.cylinder("chrome", middle, end, 0.04)


@prop("excavator")
def excavator(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an excavator on tracks, its cab at its own left, the bucket on the ground before it."""
    body, trim = spec.material("body"), spec.material("track")
    with b.at(scale=np.array(spec.size) / spec.entry.size):
        _tracks(b, trim)
        b.cylinder(DARK, (0, 0, 0.8), (0, 0, 1.0), 0.62, segments=28)
        b.box(body, (0, 0.45, 1.1), (2.3, 2.9, 0.22), bevel=0.04)
        b.rounded_box(body, (-0.6, 0.55, 1.6), (1.05, 2.5, 0.85), 0.1)
        b.rounded_box(DARK, (0, 1.72, 1.55), (2.3, 0.6, 0.9), 0.22)
        for k in range(5):
            b.box(DARK, (-1.13, 0.1 + 0.26 * k, 1.68), (0.03, 0.16, 0.4))
        b.cylinder(DARK, (-0.8, 1.0, 2.0), (-0.8, 1.0, 2.4), 0.06)
        _cab(b, body)
        _arm(b, body, trim)
    return (seat((0.72, -0.35, 1.62), (0.46, 0.44), name="driver"), boarding_place(1.85, -0.2))


def _tracks(b: MeshBuilder, trim: MaterialRef) -> None:
    """Add the excavator's two tracks and the frame between them."""
    for x in (-0.98, 0.98):
        ends = [
            (math.copysign(1.35, math.cos(a)) + 0.4 * math.cos(a), 0.4 + 0.4 * math.sin(a))
            for a in np.linspace(0, math.tau, 24, endpoint=False) + 0.01
        ]
        _plate(b, trim, ends, x, 0.5)
        for k in range(13):
            for z in (0.01, 0.8):
                b.box(trim, (x, -1.44 + 0.24 * k, z), (0.54, 0.1, 0.06))
        for y in (-1.3, -0.65, 0.0, 0.65, 1.3):
            side = math.copysign(0.26, x)
            b.lathe("steel", [(0.26, 0), (0.24, 0.02), (0.1, 0.03)], origin=(x + side, y, 0.4), axis=(side, 0, 0))
    b.box(DARK, (0, 0, 0.6), (1.6, 1.5, 0.44), bevel=0.05)


def _cab(b: MeshBuilder, body: MaterialRef) -> None:
    """Add the excavator's cab and engine."""
    x, low, high, front, back = 0.72, 1.2, 2.85, -1.0, 0.55
    b.box(body, (x, (front + back) / 2, high), (0.96, back - front + 0.1, 0.1), bevel=0.03)
    b.box(body, (x, (front + back) / 2, low + 0.12), (0.94, back - front, 0.24), bevel=0.02)
    for side in (-0.44, 0.44):
        for y, lean in ((front + 0.03, 0.16), (-0.1, 0.0), (back - 0.04, 0.0)):
            b.tube(body, [(x + side, y, low), (x + side, y + lean, high)], 0.045)
        b.box(body, (x + side, 0.22, low + 0.45), (0.05, 0.6, 0.7))
        b.box("glass_dark", (x + side, 0.22, low + 1.2), (0.02, 0.58, 0.75))
    b.box("glass", (x, front + 0.1, low + 1.05), (0.84, 0.015, 1.25), rotation=(-5, 0, 0))
    b.cushion(DARK, (x, -0.12, 1.55), (0.46, 0.46, 0.14), softness=0.3)
    b.cushion(DARK, (x, 0.14, 1.9), (0.46, 0.12, 0.66), softness=0.3)
    for side in (-0.3, 0.3):
        b.tube("steel", [(x + side, -0.45, low + 0.2), (x + side, -0.5, 1.85)], 0.018)
        b.sphere(DARK, (x + side, -0.5, 1.87), 0.04, segments=10, rings=6)


def _arm(b: MeshBuilder, body: MaterialRef, trim: MaterialRef) -> None:
    """Add the excavator's boom, stick and bucket, with their hydraulic cylinders."""
    x = -0.08
    boom = [(-0.7, 1.2), (-1.0, 1.2), (-2.55, 3.0), (-4.0, 2.62), (-4.05, 2.85), (-2.5, 3.42), (-2.2, 3.36)]
    _plate(b, body, boom, x, 0.36)
    _plate(b, body, [(-3.75, 3.1), (-3.98, 3.16), (-4.62, 1.0), (-4.5, 0.92), (-3.85, 2.4)], x, 0.26)
    for y, z in ((-4.02, 2.74), (-0.88, 1.3), (-4.55, 1.0)):
        b.cylinder("steel", (x - 0.24, y, z), (x + 0.24, y, z), 0.09)
    for side in (-0.24, 0.24):
        _ram(b, (x + side, -1.1, 1.15), (x + side, -2.2, 2.75))
    _ram(b, (x, -2.5, 3.46), (x, -3.86, 3.1))
    _ram(b, (x, -4.02, 2.6), (x, -4.72, 1.2))
    scoop = [(-4.46, 0.95), (-4.8, 1.0), (-5.12, 0.7), (-5.05, 0.3), (-4.7, 0.05), (-4.2, 0.02), (-4.15, 0.09)]
    shell = [*scoop, (-4.62, 0.16), (-4.9, 0.4), (-4.94, 0.66), (-4.72, 0.84), (-4.5, 0.8)]
    _plate(b, trim, shell, x, 0.9)
    for side in (-0.45, 0.45):
        _plate(b, trim, scoop, x + side, 0.04)
    for k in range(5):
        b.box("steel", (x - 0.36 + 0.18 * k, -4.1, 0.05), (0.09, 0.2, 0.06), taper=0.6)


@prop("standing_fan")
def standing_fan(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a caged fan on a tall stand that blows to -Y."""
    (w, _, h), metal, base = spec.size, spec.material("metal"), spec.material("base")
    middle = h - w / 2
    b.lathe(base, [(0.2, 0), (0.19, 0.025), (0.05, 0.05), (0.024, 0.07), (0.022, 0.55 * h)], segments=28)
    b.cylinder("chrome", (0, 0, 0.5 * h), (0, 0, middle - 0.06), 0.014)
    b.lathe(base, [(0.022, 0.53 * h), (0.03, 0.54 * h), (0.03, 0.57 * h), (0.02, 0.58 * h)], segments=14)
    b.box(base, (0, -0.02, middle - 0.12), (0.09, 0.05, 0.12), bevel=0.01)
    fan_head(b, metal, base, w / 2 - 0.006, 0.24, middle)
    return two_hands((-0.024, 0.0, 0.56 * h), (0.2, -1, 0), (1, 0.15, 0), FIST)


@prop("mattress")
def mattress(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a mattress on the floor: piped edges, rows of buttons."""
    (w, d, h), cover, piping = spec.size, spec.material("cover"), spec.material("piping")
    b.rounded_box(cover, (0, 0, h / 2), (w, d, 0.98 * h), 0.05)
    edge = rectangle(w - 0.01, d - 0.01, 64, 0.05)
    for z in (0.18, 0.82):
        b.tube(piping, np.c_[edge, np.full(64, z * h)], 0.012, segments=8, closed=True)
    for x in np.linspace(-0.33, 0.33, 3):
        for y in np.linspace(-0.42, 0.42, 6):
            b.sphere(piping, (x * w, y * d, 0.985 * h), 0.016, scale=(1, 1, 0.4), segments=10, rings=5)
    return (bed_anchor((0, 0, h), w, d), seat((0, -d / 2, h), (w, 0.5)))


@prop("ironing_board")
def ironing_board(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an ironing board along X on crossed legs, its point to -X."""
    (w, d, h), cover = spec.size, spec.material("cover")
    half = [(-0.5, 0.0), (-0.47, 0.2), (-0.36, 0.36), (-0.1, 0.48), (0.46, 0.5), (0.5, 0.46), (0.5, 0.0)]
    upper = bent([(x * w, y * d) for x, y in half], 3)
    board = np.concatenate([upper, (upper * (1, -1))[-2:0:-1]])
    b.extrude(cover, board, 0.03, base=h - 0.03)
    b.extrude("steel", board * 0.94, 0.012, base=h - 0.042)
    for x, y in ((-1, 0.1), (1, 0.16)):
        for side in (-1, 1):
            b.tube("chrome", [(0.3 * x * w, side * y, h - 0.04), (-0.32 * x * w, side * y, 0.012)], 0.011)
        b.cylinder("rubber", (-0.32 * x * w, -y - 0.06, 0.013), (-0.32 * x * w, y + 0.06, 0.013), 0.013)
    return ()


@prop("golf_club")
def golf_club(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a golf club that stands on its head, the face to -Y."""
    (w, d, h), metal = spec.size, spec.material("metal")
    x = -0.34 * w
    b.cylinder(metal, (x, 0, 0.03), (x, 0, 0.76 * h), 0.0055, segments=10)
    b.lathe(spec.material("grip"), [(0.009, 0.74 * h), (0.014, 0.98 * h), (0.012, h)], origin=(x, 0, 0), segments=12)
    blade = [(-0.46, 0.0), (0.4, 0.0), (0.5, 0.024), (0.44, 0.055), (-0.2, 0.034), (-0.3, 0.06), (-0.46, 0.06)]
    with b.at((0, 0.2 * d, 0), (68, 0, 0)):
        b.extrude(metal, [(i * w, j) for i, j in blade], 0.4 * d)
    return two_hands((x - 0.012, 0.006, 0.88 * h), (0.2, -1, 0), (1, 0.15, 0), FIST)


@prop("hockey_stick")
def hockey_stick(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hockey stick that stands on its blade, the blade to +X, taped."""
    (w, d, h), wood = spec.size, spec.material("wood")
    x = -0.42 * w
    line = bent([(x, 0, h), (x, 0, 0.3 * h), (x + 0.02, 0, 0.09 * h), (x + 0.08, 0, 0.04), (0.46 * w, 0, 0.035)], 5)
    tall = np.interp(line[:, 2], (0.035, 0.1, h), (0.034, 0.018, 0.016))
    rings = []
    way = np.gradient(line, axis=0)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    for at, t, u in zip(line, tall, way, strict=True):
        across = np.array((-u[2], 0, u[0])) * t
        deep = np.array((0, 0.4 * d, 0))
        rings.append(np.array([at - across - deep, at + across - deep, at + across + deep, at - across + deep]))
    b.loft(wood, rings)
    b.box(spec.material("tape"), (0.22 * w, 0, 0.037), (0.4 * w, 0.9 * d, 0.074))
    b.box(spec.material("tape"), (x, 0, 0.93 * h), (0.036, 0.9 * d, 0.13 * h))
    return two_hands((x - 0.014, 0.006, 0.82 * h), (0.2, -1, 0), (1, 0.15, 0), FIST)


@prop("skis")
def skis(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pair of skis that stand side by side with their bindings, their tips up, bases to +Y."""
    (w, d, h), board = spec.size, spec.material("board")
    for x in (-0.27, 0.27):
        curve = bent([(0.1, 0.0), (0.0, 0.3), (0.0, 0.85), (-0.2, 0.95), (-0.5, 1.0)], 5) * (d, h)
        wide = np.interp(curve[:, 1] / h, (0, 0.5, 0.9, 0.97, 1), (0.2, 0.17, 0.22, 0.16, 0.04)) * w
        rings = []
        for (y, z), half in zip(curve, wide, strict=True):
            rings.append([(x * w + half * s, y + t, z) for s, t in ((-1, 0), (1, 0), (1, 0.012), (-1, 0.012))])
        b.loft(board, [np.array(ring) for ring in rings])
        for z in (0.4, 0.55):
            b.rounded_box(DARK, (x * w, -0.025, z * h), (0.3 * w, 0.05, 0.09), 0.012)
    return two_hands((-0.5 * w, 0.0, 0.6 * h), (0.2, -0.9, 0.2), (1, 0, 0), (0.5, 0.55, 0.4))


@prop("car_battery")
def car_battery(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a car battery with its two poles and a strap to carry it by."""
    (w, d, h), body = spec.size, spec.material("body")
    b.rounded_box(body, (0, 0, 0.38 * h), (w, d, 0.76 * h), 0.008)
    b.rounded_box(spec.material("lid"), (0, 0, 0.8 * h), (w, d, 0.14 * h), 0.006)
    b.box("wax", (0, -d / 2, 0.42 * h), (0.6 * w, 0.003, 0.3 * h))
    for x, ring in ((-0.36, "fabric_red"), (0.36, "fabric_blue")):
        b.cylinder("steel", (x * w, -0.26 * d, 0.86 * h), (x * w, -0.26 * d, 0.96 * h), 0.01, 0.008)
        b.tube(ring, ring_of(0.015, 16, 0.88 * h) + np.array((x * w, -0.26 * d, 0)), 0.003, segments=6, closed=True)
    strap = [(-0.4 * w, 0.2 * d, 0.86 * h), (-0.3 * w, 0.2 * d, 0.97 * h), (0.3 * w, 0.2 * d, 0.97 * h)]
    b.tube(body, [*strap, (0.4 * w, 0.2 * d, 0.86 * h)], 0.008)
    return grips_under(0.4 * d) + grips_around(0.01, 0.97 * h, FIST)
