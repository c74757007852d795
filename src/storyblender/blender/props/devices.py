"""Prop builders: things with a button, a lens or a screen that are held, and small everyday objects."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import (
    FIST,
    PINCH,
    Anchors,
    grips_around,
    grips_pinching,
    grips_under,
    two_hands,
)
from storyblender.blender.props.lamps import flame
from storyblender.blender.props.registry import PropSpec, prop


@prop("phone_handset")
def phone_handset(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a receiver that stands on its mouthpiece, cups to -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    bar = [(0, -0.005, 0.03), (0, d * 0.32, 0.07), (0, d * 0.36, h / 2), (0, d * 0.32, h - 0.07), (0, -0.005, h - 0.03)]
    b.tube(body, bar, (0.014, 0.016, 0.015, 0.016, 0.014), segments=12)
    for z in (w / 2, h - w / 2):
        outline = [(w * 0.3, -0.012), (w / 2, 0.012), (w / 2, 0.03), (w * 0.36, 0.036)]
        b.lathe(body, outline, origin=(0, d * 0.05, z), axis=(0, -1, 0), segments=20)
    b.tube("plastic_black", [(0, 0, 0.03), (0, 0.01, 0.012), (0, 0.02, 0.004)], 0.004)
    hold = two_hands((-0.024, d * 0.34, h * 0.5), (0.15, -1, 0.25), (1, 0.1, 0), (0.73, 0.85, 0.55), "ear")
    return two_hands((-0.024, d * 0.34, h * 0.5), (0.15, -1, 0.25), (1, 0.1, 0), (0.73, 0.85, 0.55)) + hold


@prop("smartphone")
def smartphone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a mobile phone that lies on its back, its top at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    b.rounded_box(body, (0, 0, h / 2), (w, d, h * 0.96), h * 0.4, steps=2)
    x, y = w * 0.46, d * 0.46
    b.quad(spec.material("screen"), (x, -y, h), (x, y, h), (-x, y, h), (-x, -y, h), uv=((0, 1), (0, 0), (1, 0), (1, 1)))
    read = two_hands((-0.012, d * 0.2, -0.014), (0.35, -0.93, 0), (0.15, 0, 1), (0.45, 0.5, 0.3))
    return read + two_hands((-0.012, 0.0, -0.014), (0.35, -0.93, 0), (0.15, 0, 1), (0.45, 0.5, 0.3), "ear")


@prop("tablet")
def tablet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tablet that lies on its back."""
    (w, d, h), body = spec.size, spec.material("body")
    b.rounded_box(body, (0, 0, h / 2), (w, d, h * 0.96), h * 0.4, steps=2)
    x, y = w * 0.45, d * 0.45
    b.quad(spec.material("screen"), (x, -y, h), (x, y, h), (-x, y, h), (-x, -y, h), uv=((0, 1), (0, 0), (1, 0), (1, 1)))
    return grips_under(d * 0.3)


@prop("walkie_talkie")
def walkie_talkie(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hand radio, standing, its speaker to -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    case = h * 0.58
    b.rounded_box(body, (0, 0, case / 2), (w, d, case), 0.008)
    b.cylinder(body, (w * 0.3, 0, case), (w * 0.3, 0, h), 0.007, 0.005, segments=10)
    b.cylinder(body, (-w * 0.25, 0, case), (-w * 0.25, 0, case + 0.02), 0.009, segments=10)
    for k in range(5):
        b.box("iron", (0, -d / 2 - 0.0005, case * (0.35 + 0.08 * k)), (w * 0.6, 0.002, 0.005))
    return grips_around(w / 2, case * 0.45, (0.7, 0.75, 0.4))


@prop("photo_camera")
def photo_camera(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a still camera that looks to -Y."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    back = d / 2
    b.rounded_box(body, (0, back - 0.025, h * 0.42), (w, 0.05, h * 0.84), 0.012)
    b.box(metal, (0, back - 0.025, h * 0.82), (w * 0.96, 0.046, h * 0.12), bevel=0.004)
    b.box(metal, (0, back - 0.025, h * 0.92), (w * 0.3, 0.04, h * 0.16), bevel=0.005, taper=0.7)
    lens = [
        (0.036, 0), (0.036, 0.02), (0.031, 0.022), (0.031, 0.045), (0.034, 0.05), (0.034, 0.06), (0.026, 0.06),
        (0.02, 0.05),
    ]  # fmt: skip
    b.lathe(body, lens, origin=(0, back - 0.05, h * 0.42), axis=(0, -1, 0), segments=24)
    profile = [(0.022, 0), (0.012, 0.006), (0.001, 0.008)]
    b.lathe("glass_dark", profile, origin=(0, -d / 2 + 0.01, h * 0.42), axis=(0, -1, 0), segments=20)
    b.cylinder(metal, (-w * 0.36, back - 0.025, h * 0.88), (-w * 0.36, back - 0.025, h * 0.95), 0.008, segments=10)
    return two_hands((-w / 2, back - 0.025, h * 0.4), (0.3, -0.95, 0.1), (0.95, 0.3, 0), (0.6, 0.7, 0.3))


@prop("binoculars")
def binoculars(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build binoculars that look to -Y."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("metal")
    r = h / 2
    for x in (-1, 1):
        outline = np.multiply(
            [(0.55, 0), (0.6, 0.15), (0.6, 0.3), (0.95, 0.45), (0.95, 0.92), (1, 1), (0.8, 1), (0.75, 0.95)], (r, d)
        )
        b.lathe(body, outline, origin=(x * (w / 2 - r), d / 2, r), axis=(0, -1, 0), segments=20)
        origin = (x * (w / 2 - r), -d / 2 + 0.008, r)
        b.lathe("glass_dark", [(r * 0.78, 0), (0.001, 0.004)], origin=origin, axis=(0, -1, 0), segments=16, caps=False)
    b.cylinder(brass, (0, d * 0.3, r), (0, -d * 0.1, r), 0.012, segments=12)
    b.box(body, (0, 0.0, r), (w - 2 * r, d * 0.3, 0.014), bevel=0.003)
    return two_hands((-w / 2, 0.0, r), (0.3, -0.4, 0.85), (0.95, 0, -0.3), (0.5, 0.55, 0.3))


@prop("flashlight")
def flashlight(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an electric torch that shines to -Y."""
    (w, d, _), body = spec.size, spec.material("body")
    r = w / 2
    place = {"origin": (0, d / 2, r), "axis": (0, -1, 0), "segments": 20}
    profile = [
        (r * 0.6, 0), (r * 0.68, 0.006), (r * 0.66, d * 0.66), (r * 0.95, d * 0.8), (r, d * 0.84), (r, d), (r * 0.9, d),
        (r * 0.8, d * 0.92),
    ]  # fmt: skip
    b.lathe(body, profile, **place)
    b.lathe(spec.material("glass"), [(r * 0.88, d * 0.95), (0.001, d * 0.96)], **place)
    b.box("plastic_black", (0, 0.0, r * 1.66), (0.012, 0.03, 0.008), bevel=0.002)
    return two_hands((-r * 0.8, d * 0.18, r), (0.2, -0.5, -0.8), (1, 0.1, 0), FIST)


@prop("magnifying_glass")
def magnifying_glass(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a reading glass that lies flat, its handle at +Y."""
    (w, d, h), body = spec.size, spec.material("body")
    r = w / 2 - 0.006
    ring = [
        (r * math.cos(a), -d / 2 + w / 2 + r * math.sin(a), h / 2) for a in np.linspace(0, math.tau, 32, endpoint=False)
    ]
    b.tube(body, ring, 0.006, closed=True)
    profile = [(0.001, -0.004), (r, 0), (0.001, 0.004)]
    b.lathe(spec.material("glass"), profile, origin=(0, -d / 2 + w / 2, h / 2), segments=28, caps=False)
    b.cylinder("wood_dark", (0, d / 2, h / 2), (0, -d / 2 + w, h / 2), 0.008, 0.006, segments=12)
    return two_hands((-0.012, d * 0.36, h * 0.5), (0.3, -0.9, -0.3), (0.9, 0.3, 0), PINCH)


@prop("key")
def key(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a door key that lies flat, its bow at +Y."""
    (w, d, h), body = spec.size, spec.material("body")
    ring = [
        (w * 0.4 * math.cos(a), d / 2 - w * 0.45 + w * 0.4 * math.sin(a), h / 2)
        for a in np.linspace(0, math.tau, 18, endpoint=False)
    ]
    b.tube(body, ring, h * 0.45, segments=6, closed=True)
    b.cylinder(body, (0, d / 2 - w * 0.85, h / 2), (0, -d / 2, h / 2), h * 0.42, segments=8)
    for y in (0.02, 0.008):
        b.box(body, (w * 0.2, -d / 2 + y, h / 2), (w * 0.4, 0.006, h * 0.6))
    return grips_pinching(d * 0.3, 0.0)


@prop("coin")
def coin(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a coin."""
    h, r = spec.size[2], spec.size[0] / 2
    profile = np.multiply(
        [(0.96, 0), (1, 0.2), (1, 0.9), (0.95, 1), (0.86, 1), (0.84, 0.8), (0.4, 0.8), (0.3, 1)], (r, h)
    )
    b.lathe(spec.material("body"), profile, segments=28)
    return grips_pinching(0.0, 0.0)


@prop("cigarette")
def cigarette(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cigarette whose glowing tip is at -Y."""
    w, d, _ = spec.size
    r = w / 2
    b.cylinder("cardboard", (0, d / 2, r), (0, d / 2 - 0.024, r), r, segments=10)
    b.cylinder(spec.material("body"), (0, d / 2 - 0.024, r), (0, -d / 2 + 0.008, r), r * 0.96, segments=10)
    b.cylinder(spec.material("ember"), (0, -d / 2 + 0.008, r), (0, -d / 2, r), r * 0.94, r * 0.7, segments=10)
    return grips_pinching(d * 0.2, 0.0)


@prop("pipe")
def pipe(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tobacco pipe; its bowl is at -Y."""
    (w, d, h), body, r = spec.size, spec.material("body"), spec.size[0] / 2
    profile = [(r * 0.5, 0), (r * 0.95, h * 0.25), (r, h * 0.6), (r * 0.9, h), (r * 0.65, h), (r * 0.6, h * 0.7)]
    b.lathe(body, profile, origin=(0, -d / 2 + r, 0), segments=18)
    b.tube(body, [(0, -d / 2 + w * 0.8, h * 0.25), (0, 0.0, h * 0.55), (0, d * 0.3, h * 0.85)], (0.009, 0.006, 0.005))
    b.tube("plastic_black", [(0, d * 0.28, h * 0.83), (0, d / 2, h * 0.95)], (0.006, 0.004))
    return grips_pinching(-d / 2 + r, h * 0.4)


@prop("lighter")
def lighter(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an open lighter with its flame."""
    (w, d, h), body = spec.size, spec.material("body")
    b.rounded_box(body, (0, 0, h * 0.28), (w, d, h * 0.56), 0.004)
    b.rounded_box(body, (w * 0.72, 0, h * 0.62), (w * 0.3, d, w), 0.004)
    b.box("steel", (-w * 0.1, 0, h * 0.6), (w * 0.5, d * 0.7, h * 0.1))
    flame(b, spec.material("flame"), -w * 0.1, 0, h * 0.64, h * 0.36)
    return grips_around(w * 0.4, h * 0.25, (0.75, 0.8, 0.5))


@prop("ashtray")
def ashtray(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build an ashtray with a burning end."""
    h, r = spec.size[2], spec.size[0] / 2
    profile = [(r * 0.9, 0), (r, h * 0.6), (r, h * 0.75), (r * 0.85, h * 0.75), (r * 0.75, h * 0.25)]
    b.lathe(spec.material("body"), profile, segments=28)
    b.sphere(spec.material("ash"), (0.01, 0, h * 0.25), r * 0.4, scale=(1, 0.8, 0.25), segments=10, rings=5)
    b.cylinder("paper", (r * 0.2, 0.01, h * 0.45), (r * 0.95, 0.02, h * 0.85), 0.004, segments=8)
    return grips_under(r * 0.8)


@prop("glasses")
def glasses(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build spectacles that look to -Y, standing on their temples."""
    (w, d, h), body = spec.size, spec.material("body")
    front = -d / 2 + 0.004
    for x in (-1, 1):
        middle = (x * w * 0.25, front, h * 0.5)
        rim = [
            (middle[0] + w * 0.2 * math.cos(a), front, middle[2] + h * 0.45 * math.sin(a))
            for a in np.linspace(0, math.tau, 24, endpoint=False)
        ]
        b.tube(body, rim, 0.0025, segments=6, closed=True)
        b.polygon(spec.material("glass"), rim)
        line = [
            (x * w * 0.45, front, h * 0.7),
            (x * w * 0.5, 0.0, h * 0.72),
            (x * w * 0.49, d * 0.35, h * 0.7),
            (x * w * 0.47, d / 2, h * 0.2),
        ]
        b.tube(body, line, 0.0022, segments=6)
    path = [(-w * 0.06, front, h * 0.6), (0, front - 0.002, h * 0.68), (w * 0.06, front, h * 0.6)]
    b.tube(body, path, 0.0025, segments=6)
    return two_hands((-w / 2 - 0.005, 0.02, h * 0.6), (0.3, -0.95, 0), (1, 0.2, 0), PINCH)


@prop("watch")
def watch(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pocket watch that lies on its back, its crown at -Y."""
    (w, d, h), body, r = spec.size, spec.material("body"), spec.size[0] / 2
    middle = d / 2 - r
    profile = [(r * 0.9, 0), (r, h * 0.4), (r * 0.98, h * 0.8), (r * 0.86, h * 0.9)]
    b.lathe(body, profile, origin=(0, middle, 0), segments=32)
    angle = np.linspace(0, math.tau, 32, endpoint=False)
    ring = np.c_[np.cos(angle), np.sin(angle)]
    b.polygon(spec.material("face"), np.c_[r * 0.85 * ring + (0, middle), np.full(32, h * 0.92)], uv=0.5 - 0.5 * ring)
    b.cylinder(body, (0, middle - r, h / 2), (0, middle - r - w * 0.14, h / 2), w * 0.06, segments=10)
    loop = [
        (w * 0.12 * math.cos(a), -d / 2 + w * 0.14 + w * 0.12 * math.sin(a), h / 2)
        for a in np.linspace(0, math.tau, 16, endpoint=False)
    ]
    b.tube(body, loop, 0.0018, segments=6, closed=True)
    return grips_under(d * 0.3)


@prop("handcuffs")
def handcuffs(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build handcuffs laid flat."""
    (w, d, h), body = spec.size, spec.material("body")
    r = d / 2 - 0.006
    for x in (-1, 1):
        middle = x * (w / 2 - d / 2)
        ring = [
            (middle + r * math.cos(a), r * math.sin(a), h / 2) for a in np.linspace(0, math.tau, 28, endpoint=False)
        ]
        b.tube(body, ring, h * 0.3, segments=8, closed=True)
        b.box(body, (middle - x * r, 0, h / 2), (0.018, 0.034, h), bevel=0.003)
    for k in range(3):
        at = (k - 1) * 0.009
        link = [
            (at + 0.007 * math.cos(a), 0.004 * math.sin(a), h / 2) for a in np.linspace(0, math.tau, 10, endpoint=False)
        ]
        b.tube("iron", link, 0.0016, segments=5, closed=True)
    return two_hands((-w / 2, 0.03, h / 2), (0.4, -0.9, 0), (0.9, 0.4, 0), FIST)


@prop("syringe")
def syringe(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a syringe whose needle is at -Y."""
    (w, d, h), glass, steel = spec.size, spec.material("body"), spec.material("metal")
    z = h / 2
    b.cylinder(glass, (0, d * 0.25, z), (0, -d * 0.2, z), h * 0.42, segments=14)
    b.cylinder(steel, (0, -d * 0.2, z), (0, -d * 0.26, z), h * 0.3, 0.002, segments=10)
    b.cylinder(steel, (0, -d * 0.26, z), (0, -d / 2, z), 0.0009, segments=6)
    b.cylinder(steel, (0, d * 0.5, z), (0, d * 0.25, z), h * 0.12, segments=8)
    for y in (d * 0.26, d * 0.49):
        b.box(steel, (0, y, z), (w, 0.003, h * 0.7), bevel=0.001)
    return two_hands((-0.014, d * 0.1, z), (0.4, -0.9, 0), (0.9, 0.4, 0), PINCH)


@prop("bell")
def bell(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a hand bell, its handle up."""
    h, body, r = spec.size[2], spec.material("body"), spec.size[0] / 2
    b.lathe(
        body,
        [(r, 0), (r * 0.94, 0.008), (r * 0.66, h * 0.18), (r * 0.55, h * 0.36), (r * 0.3, h * 0.45), (0.004, h * 0.46)],
        segments=28,
    )
    profile = [(0.008, h * 0.45), (0.012, h * 0.52), (0.009, h * 0.6), (0.015, h * 0.8), (0.012, h * 0.96), (0.004, h)]
    b.lathe(spec.material("handle"), profile, segments=14)
    return grips_around(0.014, h * 0.75, FIST)


@prop("bomb")
def bomb(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bundle of dynamite with a clock and wires."""
    (w, _, h), body, band = spec.size, spec.material("body"), spec.material("band")
    r = w / 6.2
    for row in range(2):
        for k in range(3):
            x, y = (k - 1) * 2 * r, (row - 0.5) * 2 * r
            b.cylinder(body, (x, y, 0), (x, y, h * 0.92), r * 0.97, segments=16)
            b.tube("linen", [(x, y, h * 0.9), (x * 0.5, y * 0.5, h * 0.97), (0, 0, h)], 0.002, segments=5)
    for z in (0.18, 0.72):
        b.rounded_box(band, (0, 0, h * z), (w * 0.99, 4.1 * r, 0.025), 0.01)
    profile = [(r * 1.5, 0), (r * 1.5, 0.014), (r * 1.3, 0.018)]
    b.lathe("plastic_black", profile, origin=(0, -2 * r, h * 0.46), axis=(0, -1, 0), segments=24)
    angle = np.linspace(0, math.tau, 24, endpoint=False)
    ring = np.c_[np.cos(angle), np.sin(angle)]
    face = np.c_[r * 1.3 * ring[:, 0], np.full(24, -2 * r - 0.019), h * 0.46 + r * 1.3 * ring[:, 1]]
    b.polygon(spec.material("face"), face, uv=0.5 + 0.5 * ring)
    path = [(0.03, -2 * r - 0.01, h * 0.6), (0.05, -2 * r - 0.01, h * 0.8), (0.02, -r, h * 0.95)]
    b.tube("neon_red", path, 0.003, segments=6)
    return two_hands((-w / 2, 0, h * 0.45), (0.1, -1, -0.1), (1, 0.1, 0), (0.3, 0.35, 0.2))
