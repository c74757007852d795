"""Prop builders: what is worn: hats, crowns, helmets, masks, jewels."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, two_hands
from storyblender.blender.props.registry import PropSpec, prop


@prop("hat")
def hat(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a felt hat with a creased crown."""
    (w, d, h), body = spec.size, spec.material("body")
    angle = np.linspace(0, math.tau, 36, endpoint=False)

    def ring(reach: float, z: float, dent: float = 0.0) -> np.ndarray:
        crease = -dent * np.exp(-((np.cos(angle) / 0.3) ** 2)) * 0.3 - dent * 0.5
        lift = 0.014 * np.cos(angle) ** 2 * (reach > 0.9)
        return np.c_[reach * w / 2 * np.cos(angle), reach * d / 2 * np.sin(angle), z + crease + lift]

    crown = [
        ring(0.98, 0.0), ring(1.0, 0.006), ring(0.62, 0.012), ring(0.6, 0.03), ring(0.56, h * 0.7), ring(0.5, h * 0.94),
        ring(0.4, h), ring(0.2, h, 0.03), ring(0.02, h, 0.04),
    ]  # fmt: skip
    b.loft(body, crown)
    band = [ring(0.625, 0.012), ring(0.615, 0.042)]
    b.loft(spec.material("band"), band, caps=False)
    return two_hands((-w * 0.44, 0.02, 0.01), (0.4, -0.9, 0), (0.3, 0, 0.95), (0.4, 0.5, 0.3)) + two_hands(
        (0.0, -d * 0.2, h * 0.9), (0, -0.7, -0.6), (0, 0.3, -0.95), (0.4, 0.5, 0.3), "top"
    )


@prop("crown")
def crown(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a crown of points with stones."""
    (_, _, h), body, gem, r = spec.size, spec.material("body"), spec.material("gem"), spec.size[0] / 2
    count = 48
    angle = np.linspace(0, math.tau, count, endpoint=False)
    tip = h * (0.55 + 0.4 * np.abs(np.cos(4 * angle)) ** 1.5)
    rings = [
        np.c_[r * s * np.cos(angle), r * s * np.sin(angle), z]
        for s, z in (
            (0.9, np.zeros(count)), (0.9, np.full(count, h * 0.3)), (0.98, tip), (0.95, tip),
            (0.87, np.full(count, h * 0.3)), (0.87, np.zeros(count)),
        )
    ]  # fmt: skip
    b.loft(body, rings, caps=False)
    b.lathe(body, [(r * 0.9, 0), (r * 0.94, 0.008), (r * 0.94, h * 0.2), (r * 0.9, h * 0.25)], segments=36, caps=False)
    for k in range(8):
        turn = math.tau * k / 8
        b.sphere(gem, (r * 0.94 * math.cos(turn), r * 0.94 * math.sin(turn), h * 0.12), 0.011, segments=8, rings=6)
        b.sphere(body, (r * 0.97 * math.cos(turn), r * 0.97 * math.sin(turn), h * 0.95), 0.009, segments=8, rings=6)
    return two_hands((-r, 0.0, h * 0.2), (0.2, -1, 0), (1, 0, 0), (0.4, 0.45, 0.3))


@prop("helmet")
def helmet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a closed helmet whose visor looks to -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    b.cushion(body, (0, 0.0, h * 0.55), (w, d, h * 0.9), softness=0.8)
    b.lathe(body, [(w * 0.42, 0), (w * 0.44, 0.02), (w * 0.42, h * 0.25)], segments=28)
    b.cushion(spec.material("visor"), (0, -d * 0.14, h * 0.56), (w * 0.86, d * 0.76, h * 0.36), softness=0.6)
    b.tube(body, [(0, -d * 0.3, h * 0.93), (0, 0, h * 1.0), (0, d * 0.4, h * 0.8)], (0.006, 0.012, 0.006))
    return two_hands((-w / 2, 0, h * 0.4), (0.1, -0.9, -0.4), (1, 0.1, 0), (0.35, 0.4, 0.2))


@prop("mask")
def mask(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a face mask that looks to -Y, standing."""
    (w, d, h), body, hole = spec.size, spec.material("body"), spec.material("hole")
    across = np.linspace(-1, 1, 15)
    rows = []
    for t in np.linspace(0, 1, 11):
        width = w / 2 * math.sin(math.pi * (0.2 + 0.7 * t)) ** 0.7
        nose = 0.16 * np.exp(-((across / 0.16) ** 2)) * (0.3 < t < 0.62) * (t - 0.3 < 0.4) * (1.2 - t)
        section = np.c_[
            width * across, d * (0.42 - 0.75 * np.sqrt(np.clip(1 - across**2 * 0.95, 0, 1)) - nose), np.full(15, h * t)
        ]
        rows.append(section)
    for lift, order in ((0.0, 1), (0.006, -1)):
        b.loft(body, [(row + np.array([0, lift, 0]))[::order] for row in rows], closed=False)
    for x in (-1, 1):
        b.cushion(hole, (x * w * 0.2, -d * 0.27, h * 0.62), (w * 0.2, 0.02, h * 0.07), softness=0.9)
    b.cushion(hole, (0, -d * 0.3, h * 0.22), (w * 0.3, 0.02, h * 0.05), softness=0.9)
    return two_hands((-w * 0.45, 0.02, h * 0.4), (0.3, -0.9, 0.2), (1, 0, 0), (0.4, 0.45, 0.3))


@prop("necklace")
def necklace(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a necklace laid in a loop, its stone at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    count = 46
    for k in range(count):
        turn = math.tau * k / count
        squeeze = 1 - 0.25 * max(0.0, math.sin(turn))
        center = (w * 0.46 * squeeze * math.cos(turn), 0.015 + (d * 0.42) * math.sin(turn), h * 0.4)
        b.sphere(body, center, h * 0.4, segments=8, rings=5)
    b.cushion(spec.material("gem"), (0, -d * 0.44, h / 2), (0.022, 0.028, h), softness=0.8)
    return _pinched(d * 0.4, h)


@prop("ring")
def ring(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a standing ring, its stone on top."""
    (w, _, h), body = spec.size, spec.material("body")
    r = w / 2 - 0.002
    band = [(r * math.cos(a), 0, w / 2 + r * math.sin(a)) for a in np.linspace(0, math.tau, 28, endpoint=False)]
    b.tube(body, band, 0.0018, closed=True)
    b.lathe(spec.material("gem"), [(0.001, w - 0.002), (0.005, h - 0.002), (0.003, h)], segments=8)
    return _pinched(0.0, h * 0.5)


def _pinched(y: float, z: float) -> Anchors:
    """Return the grips of fingertips on a piece of jewellery at ``y`` and ``z``."""
    return two_hands((-0.03, y + 0.03, z), (0.5, -0.85, -0.15), (0.8, 0.4, -0.4), (0.55, 0.65, 0.6))
