"""Prop builders: what lies on desks and in pockets: stacks of paper, stamp, tickets, cards, badges, medal."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, grips_pinching, grips_under, two_hands
from storyblender.blender.props.ordinary_hardware import ring_of
from storyblender.blender.props.parts import bent, rectangle
from storyblender.blender.props.registry import PropSpec, prop


@prop("paper_stack")
def paper_stack(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build bundles of paper on each other, each a little askew, the top sheet printed."""
    (w, d, h), paper = spec.size, spec.material("paper")
    count = 8
    lies = spec.rng.uniform((-0.02, -0.02, -3), (0.02, 0.02, 3), (count, 3))
    for k, (x, y, turn) in enumerate(lies):
        middle = (x * w, y * d, (k + 0.5) * h / count)
        b.box(paper, middle, (0.93 * w, 0.94 * d, 0.94 * h / count), rotation=(0, 0, turn))
    with b.at((lies[-1][0] * w, lies[-1][1] * d, h), (0, 0, lies[-1][2])):
        _print(b, 0.93 * w, 0.94 * d)
    return grips_under(0.4 * d)


def _print(b: MeshBuilder, width: float, depth: float) -> None:
    """Add a heading and lines of print on the plane z = 0."""
    b.box("plastic_black", (0, 0.4 * depth, 0), (0.5 * width, 0.02 * depth, 0.0004))
    for k in range(9):
        b.box("iron", (0, (0.28 - 0.075 * k) * depth, 0), (0.78 * width, 0.006 * depth, 0.0004))


@prop("rubber_stamp")
def rubber_stamp(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stamp that stands on its rubber, with a turned handle."""
    (w, d, h), handle = spec.size, spec.material("handle")
    b.box(spec.material("foot"), (0, 0, 0.03 * h), (0.96 * w, 0.94 * d, 0.06 * h))
    b.rounded_box(handle, (0, 0, 0.15 * h), (w, d, 0.18 * h), 0.003)
    outline = [(0.3, 0.22), (0.2, 0.3), (0.17, 0.5), (0.26, 0.66), (0.32, 0.84), (0.24, 0.97), (0.0, 1.0)]
    b.lathe(handle, bent([(x * w, z * h) for x, z in outline], 3), segments=20)
    return grips_around(0.28 * w, 0.7 * h, (0.7, 0.8, 0.6))


@prop("envelope_stack")
def envelope_stack(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dozen envelopes tied crosswise with string, a stamp on the top one."""
    (w, d, h), paper, string = spec.size, spec.material("paper"), spec.material("string")
    count = 12
    for k in range(count):
        turn, x, y = spec.rng.uniform((-2, -0.015, -0.015), (2, 0.015, 0.015))
        z, cover = (k + 0.5) * h / count, "cardboard" if k % 5 == 2 else paper
        b.box(cover, (x * w, y * d, z), (0.95 * w, 0.93 * d, 0.86 * h / count), bevel=0.001, rotation=(0, 0, turn))
    b.box("fabric_red", (0.38 * w, 0.3 * d, h), (0.022, 0.028, 0.0006))
    for k in range(3):
        b.box("plastic_black", (-0.12 * w, -(0.1 + 0.1 * k) * d, h), ((0.34 - 0.06 * k) * w, 0.003, 0.0006))
    for size, turn in (((w, h), 0), ((d, h), 90)):
        with b.at((0, 0, 0.5 * h), (90, 0, turn)):
            loop = rectangle(size[0] + 0.002, size[1] + 0.002, 40, 0.003)
            b.tube(string, np.c_[loop, np.zeros(len(loop))], 0.0016, segments=6, closed=True)
    for x in (-1, 1):
        bow = [(0, 0, h), (0.09 * x * w, 0.1 * d, h + 0.008), (0.12 * x * w, -0.06 * d, h + 0.003), (0, 0, h)]
        b.tube(string, bent(bow), 0.0014, segments=6)
    return grips_under(0.4 * d)


@prop("ticket")
def ticket(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a ticket that lies flat, its stub perforated at +X."""
    (w, d, h), paper, ink = spec.size, spec.material("paper"), spec.material("print")
    notch = [(math.cos(a) * 0.09 * d, math.sin(a) * 0.09 * d) for a in np.linspace(math.pi, 0, 5)]
    top = [(0.24 * w + x, d / 2 - y) for x, y in notch]
    outline = [
        (-w / 2, -d / 2), *((x, -y) for x, y in top), (w / 2, -d / 2), (w / 2, d / 2), *top[::-1], (-w / 2, d / 2),
    ]  # fmt: skip
    b.extrude(paper, outline, h)
    for k in range(7):
        b.box("plastic_black", (0.24 * w, (k - 3) * 0.11 * d, h), (0.004, 0.05 * d, 0.0004))
    for x, y, across, along in ((-0.14, 0.26, 0.6, 0.2), (-0.14, -0.04, 0.5, 0.05), (-0.14, -0.2, 0.5, 0.05)):
        b.box(ink, (x * w, y * d, h), (across * w, along * d, 0.0004))
    for k in range(6):
        b.box("plastic_black", ((0.3 + 0.03 * k) * w, 0, h), (0.012 * w * (1 + k % 2), 0.6 * d, 0.0004))
    return grips_pinching(0.1 * d, 0.0)


@prop("id_card")
def id_card(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a card with a photograph, on a band laid out behind it."""
    (w, d, h), card, band = spec.size, spec.material("card"), spec.material("band")
    tall = 1.45 * w
    middle = -d / 2 + tall / 2
    with b.at((0, middle, 0)):
        b.extrude(card, rectangle(w, tall, 32, 0.004), 0.6 * h)
        b.box(band, (0, 0.37 * tall, 0.6 * h), (0.98 * w, 0.14 * tall, 0.0006))
        b.box("steel", (0, 0.03 * tall, 0.6 * h), (0.52 * w, 0.46 * tall, 0.0006))
        b.cushion("linen", (0, 0.08 * tall, 0.62 * h), (0.2 * w, 0.17 * tall, 0.001), softness=1.0)
        b.cushion("fabric_blue", (0, -0.12 * tall, 0.62 * h), (0.4 * w, 0.16 * tall, 0.001), softness=0.7)
        for k in range(2):
            b.box("plastic_black", (0, -(0.29 + 0.09 * k) * tall, 0.6 * h), ((0.7 - 0.2 * k) * w, 0.03 * tall, 0.0006))
    b.box("steel", (0, middle + tall / 2 + 0.006, 0.4 * h), (0.012, 0.022, 0.5 * h))
    front = middle + tall / 2 + 0.014
    for x in (-1, 1):
        path = [(0, front, 0.002), (0.4 * x * w, front + 0.4 * (d / 2 - front), 0.002), (0.1 * x * w, d / 2, 0.002)]
        flat = bent(path, 6)
        side = np.array((0.005, 0, 0))
        rings = [np.array([at - side, at + side, at + side + (0, 0, 0.001), at - side + (0, 0, 0.001)]) for at in flat]
        b.loft(band, rings)
    return grips_pinching(middle, 0.0)


def _star(b: MeshBuilder, metal: MaterialRef, radius: float, thick: float) -> None:
    """Add a five-pointed star with a ridge to each point, its middle raised, on the plane z = 0."""
    turn = math.pi / 2 + np.arange(10) * math.pi / 5
    reach = np.where(np.arange(10) % 2, 0.42 * radius, radius)
    edge = np.c_[reach * np.cos(turn), reach * np.sin(turn)]
    rings = [np.c_[edge, np.zeros(10)], np.c_[edge, np.full(10, 0.4 * thick)], np.c_[edge * 0.02, np.full(10, thick)]]
    b.loft(metal, rings)


@prop("badge")
def badge(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a shield with a star in a ring, which stands and faces -Y."""
    (w, d, h), metal = spec.size, spec.material("metal")
    half = [(0, -0.5), (0.3, -0.36), (0.47, -0.1), (0.42, 0.16), (0.5, 0.3), (0.38, 0.38), (0.2, 0.42), (0, 0.5)]
    outline = bent([(x * w, y * h) for x, y in half], 3)
    with b.at((0, 0.3 * d, 0.5 * h), (90, 0, 0)):
        b.extrude(metal, np.concatenate([outline, (outline * (-1, 1))[-2:0:-1]]), 0.3 * d, taper=0.95)
        b.lathe("fabric_blue", [(0.33 * w, 0.3 * d), (0.33 * w, 0.36 * d)], segments=28)
        b.tube(metal, ring_of(0.34 * w, 28, 0.34 * d), 0.0022, segments=6, closed=True)
        with b.at((0, 0, 0.34 * d)):
            _star(b, metal, 0.3 * w, 0.4 * d)
    return grips_pinching(-0.02, 0.4 * h)


@prop("medal")
def medal(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a medal that lies flat, a star on its disc at -Y and the ribbon's two ends behind it."""
    (w, d, h), disc, ribbon = spec.size, spec.material("disc"), spec.material("ribbon")
    r = 0.48 * w
    with b.at((0, r - d / 2, 0)):
        b.lathe(disc, [(0.94 * r, 0), (r, 0.2 * h), (r, 0.6 * h), (0.9 * r, 0.7 * h), (0.86 * r, 0.5 * h)], segments=32)
        with b.at((0, 0, 0.5 * h)):
            _star(b, disc, 0.66 * r, 0.5 * h)
    front = 2 * r - d / 2
    with b.at((0, front + 0.003, 0.45 * h)):
        b.tube(disc, ring_of(0.005, 12), 0.001, segments=6, closed=True)
    for x, level in ((-1, 0.4), (1, 0.6)):
        edge = [(0, front), (0.16 * x * w, front), (0.46 * x * w, d / 2), (0.14 * x * w, d / 2)]
        b.extrude(ribbon, edge, 0.0012, base=level * h)
        stripe = [(0.07 * x * w, front), (0.1 * x * w, front), (0.33 * x * w, d / 2), (0.27 * x * w, d / 2)]
        b.extrude("linen", stripe, 0.0016, base=level * h)
    return grips_pinching(d / 2 - 0.04, 0.0)


@prop("remote_control")
def remote_control(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a remote control that lies flat, its sender at -Y, the keys on top."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, 0, 0.45 * h), (w, d, 0.86 * h), 0.008)
    b.box("glass_dark", (0, -0.49 * d, 0.5 * h), (0.6 * w, 0.03 * d, 0.4 * h), bevel=0.002)
    top, key = 0.88 * h, spec.material("key")
    b.cylinder(spec.material("power"), (0.28 * w, -0.4 * d, top), (0.28 * w, -0.4 * d, h), 0.09 * w)
    b.lathe(key, [(0.28 * w, 0), (0.26 * w, 0.08 * h), (0.14 * w, 0.08 * h)], origin=(0, -0.2 * d, top), segments=20)
    for row in range(5):
        for x in (-0.26, 0, 0.26):
            b.rounded_box(key, (x * w, (0.02 + 0.085 * row) * d, top), (0.16 * w, 0.045 * d, 0.2 * h), 0.0015)
    return two_hands((-0.5 * w, 0.15 * d, 0.4 * h), (0.2, -0.95, 0), (0.95, 0.2, 0.1), (0.5, 0.7, 0.35))


@prop("stapler")
def stapler(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a desk stapler, its mouth to -Y."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    b.rounded_box("rubber", (0, 0, 0.07 * h), (w, d, 0.14 * h), 0.003)
    b.box(metal, (0, 0, 0.17 * h), (0.7 * w, 0.96 * d, 0.06 * h))
    with b.at((0, 0.42 * d, 0.45 * h), (-9, 0, 0)):
        b.box(metal, (0, -0.44 * d, 0.06 * h), (0.5 * w, 0.92 * d, 0.16 * h), bevel=0.002)
        b.rounded_box(body, (0, -0.43 * d, 0.26 * h), (0.78 * w, 0.94 * d, 0.3 * h), 0.006)
    for x in (-1, 1):
        b.box(metal, (0.4 * x * w, 0.4 * d, 0.36 * h), (0.06 * w, 0.14 * d, 0.42 * h), bevel=0.001)
    return grips_around(0.45 * w, 0.7 * h, (0.4, 0.5, 0.3))


@prop("ruler")
def ruler(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wooden ruler that lies along Y, marked at its edge."""
    w, d, h = spec.size
    b.box(spec.material("wood"), (0, 0, h / 2), (w, d, h), bevel=0.001)
    for k in range(31):
        long = 0.34 if k % 5 == 0 else 0.18
        b.box("plastic_black", ((0.5 - long / 2) * w, (k / 30 - 0.5) * 0.97 * d, h), (long * w, 0.0008, 0.0004))
    return grips_pinching(0.35 * d, 0.0)


@prop("tape_measure")
def tape_measure(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tape measure that stands, the tape out to -Y."""
    (w, d, h), case = spec.size, spec.material("case")
    b.rounded_box(case, (0, d / 2 - 0.5 * h, 0.5 * h), (0.6 * w, h, h), 0.012)
    for x in (-1, 1):
        disc = [(0.4 * h, 0), (0.38 * h, 0.004), (0.1 * h, 0.004)]
        b.lathe("plastic_black", disc, origin=(0.3 * x * w, d / 2 - 0.5 * h, 0.5 * h), axis=(x, 0, 0), segments=24)
    b.box(spec.material("tape"), (0, 0, 0.12 * h), (0.36 * w, d, 0.001))
    b.box("steel", (0, -d / 2, 0.06 * h), (0.36 * w, 0.002, 0.16 * h))
    for k in range(5):
        b.box("plastic_black", (0.08 * w, (-0.44 + 0.08 * k) * d, 0.12 * h + 0.0006), (0.16 * w, 0.001, 0.0004))
    return two_hands((-0.3 * w, d / 2 - 0.5 * h, 0.5 * h), (0.2, -0.95, 0), (1, 0.1, 0), FIST)
