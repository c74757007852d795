"""Prop builders: what scripts name in passing: gate, bollard, hook, buttons, security camera, loudspeaker."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.plants import GOLDEN_TURN
from storyblender.blender.props.anchors import FIST, PINCH, Anchors, grips_around, grips_under, handle, seat, two_hands
from storyblender.blender.props.registry import PropSpec, prop


@prop("gate")
def gate(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build two barred leaves that meet in the middle, between posts."""
    (w, d, h), metal, post = spec.size, spec.material("metal"), spec.material("post")
    wide = 0.2
    for x in (-1, 1):
        middle = x * (w - wide) / 2
        b.box(post, (middle, 0, (h - 0.05) / 2), (wide - 0.03, d - 0.02, h - 0.05))
        b.box(post, (middle, 0, h - 0.025), (wide, d, 0.05), bevel=0.01)
    inner, top = w / 2 - wide, h - 0.18
    for z in (0.12, 0.62 * top, top - 0.06):
        for x in (-1, 1):
            b.box(metal, (x * (inner / 2 + 0.005), 0, z), (inner - 0.02, 0.03, 0.035))
    for x in np.linspace(-inner + 0.02, inner - 0.02, 14):
        b.cylinder(metal, (x, 0, 0.06), (x, 0, top), 0.009, segments=6)
        b.cylinder(metal, (x, 0, top), (x, 0, top + 0.07), 0.014, 0.001, segments=6)
    b.box(metal, (0, -0.02, 0.62 * top), (0.14, 0.03, 0.09))
    return (handle((0.03, -0.035, 0.62 * top)),)


@prop("bollard")
def bollard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a turned iron post with a mushroom head."""
    r, h = spec.size[0] / 2, spec.size[2]
    outline = [
        (1, 0), (1, 0.06), (0.62, 0.12), (0.56, 0.5), (0.6, 0.68), (0.88, 0.78), (0.92, 0.88), (0.7, 0.97), (0, 1),
    ]  # fmt: skip
    b.lathe(spec.material("metal"), [(x * r, z * h) for x, z in outline], segments=24)
    return (seat((0, -0.6 * r, h), (2 * r, 1.2 * r)),)


@prop("wall_hook")
def wall_hook(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a plate with a long hook above a short one."""
    (w, d, h), metal = spec.size, spec.material("metal")
    b.rounded_box(metal, (0, d / 2 - 0.006, h * 0.5), (w * 0.7, 0.012, h * 0.9), 0.005)
    b.tube(metal, [(0, d / 2, h * 0.6), (0, -d * 0.2, h * 0.55), (0, -d * 0.4, h * 0.95)], [0.008, 0.007, 0.008])
    b.tube(metal, [(0, d / 2, h * 0.35), (0, 0, h * 0.06), (0, -d * 0.2, h * 0.3)], [0.008, 0.007, 0.008])
    b.sphere(metal, (0, -d / 2 + 0.01, h * 0.95), 0.011)
    return ()


@prop("button_panel")
def button_panel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a plate of round buttons under a small window."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, d * 0.25, h / 2), (w, d * 0.5, h), 0.006)
    b.box("plastic_black", (0, -0.002, h * 0.88), (w * 0.6, 0.008, h * 0.12))
    for row in range(4):
        key = spec.material("alarm" if row == 0 else "key")
        for x in (-0.22, 0.22):
            z = h * (0.13 + 0.19 * row)
            b.cylinder(key, (x * w, 0, z), (x * w, -d / 2, z), w * 0.12, w * 0.1)
    return ()


@prop("security_camera")
def security_camera(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a box camera on an arm, looking to -Y and down, its lamp lit."""
    (w, d, h), body = spec.size, spec.material("body")
    b.rounded_box(body, (0, d / 2 - 0.01, h * 0.72), (w * 0.8, 0.02, h * 0.5), 0.006)
    b.tube(body, [(0, d / 2 - 0.01, h * 0.75), (0, d * 0.15, h * 0.85), (0, 0.0, h * 0.6)], 0.014)
    with b.at((0, -d * 0.12, h * 0.42), (18, 0, 0)):
        b.rounded_box(body, (0, 0, 0), (w * 0.8, d * 0.6, h * 0.4), 0.012)
        b.box(body, (0, -d * 0.04, h * 0.23), (w, d * 0.66, 0.008))
        b.cylinder("iron", (0, -d * 0.28, 0), (0, -d * 0.36, 0), w * 0.28, w * 0.32)
        b.sphere(spec.material("lens"), (0, -d * 0.34, 0), w * 0.24, scale=(1, 0.4, 1))
        b.sphere(spec.material("lamp"), (w * 0.28, -d * 0.3, h * 0.13), 0.006)
    return ()


@prop("loudspeaker")
def loudspeaker(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a box with a large and a small cone towards -Y."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, 0.004, h / 2), (w, d - 0.008, h), 0.012)
    for z, r in ((h * 0.36, w * 0.38), (h * 0.78, w * 0.2)):
        origin, front = (0, -d / 2 + 0.008, z), (0, -1, 0)
        b.lathe(spec.material("ring"), [(r, 0), (r, 0.008), (r * 0.9, 0.008)], origin=origin, axis=front, caps=False)
        cone = [(r * 0.9, 0.006), (r * 0.35, 0.001), (r * 0.3, 0.005), (0, 0.007)]
        b.lathe(spec.material("cone"), cone, origin=origin, axis=front)
    return ()


@prop("headset")
def headset(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a band over two cups that stands on them, the microphone to -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    turn = np.linspace(0, math.pi, 13)
    r = w / 2 - 0.016
    b.tube(body, np.c_[r * np.cos(turn), np.zeros(13), h - 0.01 - r + r * np.sin(turn)], 0.009, segments=8)
    for x in (-1, 1):
        b.cylinder(body, (x * r, 0, h * 0.22), (x * r, 0, h - r), 0.008, segments=8)
        b.lathe(body, [(0.038, 0), (0.04, 0.01), (0.03, 0.016)], origin=(x * r, 0, 0.04), axis=(x, 0, 0))
        b.lathe(spec.material("pad"), [(0.04, 0), (0.036, 0.02)], origin=(x * r, 0, 0.04), axis=(-x, 0, 0))
    b.tube(body, [(-r, 0, 0.03), (-r * 0.9, -d * 0.6, 0.012), (-r * 0.4, -d * 0.9, 0.012)], [0.004, 0.004, 0.008])
    return grips_around(0.012, h - 0.02)


@prop("keyboard")
def keyboard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a keyboard that is typed on from -Y."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, 0, h * 0.3), (w, d, h * 0.6), 0.006)
    key = spec.material("key")
    for row in range(5):
        y = d * (0.34 - 0.17 * row)
        for column in range(14 if row < 4 else 5):
            x = (column - 6.5) * w * 0.067 if row < 4 else (column - 2) * w * 0.19
            b.box(key, (x, y, h * 0.78), (w * (0.058 if row < 4 else 0.17), d * 0.14, h * 0.4), taper=0.85)
    return grips_under(d * 0.42)


@prop("memory_stick")
def memory_stick(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a memory stick that lies flat, its plug to -Y."""
    w, d, h = spec.size
    b.rounded_box(spec.material("body"), (0, d * 0.14, h / 2), (w, d * 0.72, h), 0.003)
    b.box(spec.material("metal"), (0, -d * 0.36, h / 2), (w * 0.7, d * 0.28, h * 0.45))
    return two_hands((-0.03, d * 0.3, h / 2 + 0.01), (0.5, -0.85, -0.15), (0.8, 0.4, -0.4), PINCH)


@prop("truncheon")
def truncheon(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a truncheon with a ribbed handle and a guard."""
    r, h = spec.size[0] / 2, spec.size[2]
    ribs = [(r * (0.66 if k % 2 else 0.74), h * (0.02 + 0.028 * k)) for k in range(10)]
    top = [(r, 0.29 * h), (r, 0.31 * h), (r * 0.7, 0.32 * h), (r * 0.86, 0.5 * h), (r * 0.9, 0.95 * h), (r * 0.6, h)]
    b.lathe(spec.material("body"), [(r * 0.6, 0), *ribs, *top], segments=16)
    return two_hands((-r * 0.7, 0.004, h * 0.15), (0.2, -1, 0.05), (1, 0.15, 0), FIST)


@prop("compass")
def compass(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a flat round case with a dial, a needle and a ring to hang it by."""
    (w, d, h), body = spec.size, spec.material("body")
    y, r = (d - w) / 2, w / 2
    case = [(r * 0.94, 0), (r, h * 0.2), (r, h * 0.8), (r * 0.94, h), (r * 0.84, h), (r * 0.82, h * 0.75)]
    b.lathe(body, case, origin=(0, y, 0), segments=28)
    b.cylinder(spec.material("face"), (0, y, h * 0.5), (0, y, h * 0.78), r * 0.82, segments=28)
    b.box(spec.material("needle"), (0, y - r * 0.3, h * 0.84), (0.006, r * 0.6, 0.002))
    b.box("iron", (0, y + r * 0.3, h * 0.84), (0.006, r * 0.6, 0.002))
    turn = np.linspace(0, math.tau, 12, endpoint=False)
    ring = (d - w) * 0.5
    b.tube(body, np.c_[ring * np.cos(turn), ring * np.sin(turn) - d / 2 + ring, np.full(12, h / 2)], 0.002, closed=True)
    return grips_under(r * 0.8)


@prop("plank")
def plank(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a plank that lies flat along x."""
    w, d, h = spec.size
    b.box(spec.material("wood"), (0, 0, h / 2), (w, d, h), bevel=0.004)
    for x in (-0.46, 0.46):
        b.cylinder("iron", (x * w, d * 0.25, h), (x * w, d * 0.25, h + 0.001), 0.006, segments=8)
    return grips_under(d * 0.45)


@prop("grapes")
def grapes(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bunch that stands on its tip, the stem above."""
    (w, d, h), fruit = spec.size, spec.material("fruit")
    r = 0.013
    for k in range(46):
        share = (k + 0.5) / 46
        reach = (0.25 + 0.75 * math.sin(math.pi * min(1.0, 0.12 + share * 0.8))) * math.sqrt(
            (k * 0.37) % 1.0 * 0.6 + 0.4
        )
        x, y = math.cos(k * GOLDEN_TURN), math.sin(k * GOLDEN_TURN)
        z = r + share * (h * 0.84 - 2 * r)
        b.sphere(fruit, (x * reach * (w / 2 - r), y * reach * (d / 2 - r), z), r, segments=8, rings=5)
    b.tube(spec.material("stem"), [(0, 0, h * 0.6), (0, 0.004, h * 0.86), (0.008, 0, h)], 0.003)
    return grips_around(0.012, h * 0.92)
