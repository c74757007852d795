"""Prop builders: musical instruments. Stringed ones stand with their strings to -Y."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import FIST, Anchors, grips_around, two_hands
from storyblender.blender.props.registry import PropSpec, prop


def _strings(
    b: MeshBuilder, material: MaterialRef, count: int, low: float, high: float, y: float, spread: float
) -> None:
    """Add upright strings from ``low`` to ``high`` at depth ``y``, ``spread`` metres from the first to the last."""
    for k in range(count):
        x = (k - (count - 1) / 2) * spread / (count - 1)
        b.cylinder(material, (x * 1.3, y, low), (x, y, high), 0.0007, segments=4, caps=False)


def _bout(width: float, height: float, waist: float) -> np.ndarray:
    """Return the outline of a guitar's or violin's body, standing, foot at 0."""
    t = np.linspace(0, math.pi, 22)
    side = (
        width
        / 2
        * (np.sin(t) ** 0.5)
        * (1 - waist * np.exp(-(((t / math.pi - 0.55) / 0.13) ** 2)) - 0.2 * (t / math.pi) ** 2)
    )
    z = height * (1 - np.cos(t)) / 2
    return np.r_[np.c_[side, z], np.c_[-side, z][::-1][1:-1]]


@prop("guitar")
def guitar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a guitar that stands, strings to -Y."""
    (w, d, h), body, neck = spec.size, spec.material("body"), spec.material("neck")
    bout = h * 0.49
    with b.at((0, d / 2, 0), (90, 0, 0)):
        b.extrude("wood_red", _bout(w, bout, 0.22), d * 0.8)
        b.extrude(body, _bout(w * 0.98, bout, 0.22), d * 0.02, base=d * 0.8)
    profile = [(w * 0.13, 0), (w * 0.13, 0.002)]
    b.lathe("plastic_black", profile, origin=(0, -d * 0.32, bout * 0.62), axis=(0, -1, 0), segments=24)
    b.box(neck, (0, -d * 0.3, (bout * 0.68 + h * 0.9) / 2), (0.05, 0.03, h * 0.9 - bout * 0.68), bevel=0.004)
    b.box(neck, (0, -d * 0.28, h * 0.95), (0.07, 0.02, h * 0.1), bevel=0.004)
    b.box(neck, (0, -d * 0.34, bout * 0.3), (w * 0.4, 0.012, 0.02), bevel=0.003)
    for x in (-1, 1):
        for k in range(3):
            b.sphere("silver", (x * 0.045, -d * 0.28, h * (0.92 + 0.03 * k)), 0.009, segments=8, rings=5)
    _strings(b, spec.material("string"), 6, bout * 0.3, h * 0.9, -d * 0.47, 0.036)
    return two_hands((-0.02, -d * 0.3, h * 0.72), (0.3, -0.9, 0), (1, 0.2, 0), FIST, "neck") + grips_around(
        w * 0.2, bout * 0.6, (0.3, 0.35, 0.2)
    )


@prop("violin")
def violin(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a violin that stands, strings to -Y."""
    (w, d, h), body, neck = spec.size, spec.material("body"), spec.material("neck")
    bout = h * 0.6
    with b.at((0, d / 2, 0), (90, 0, 0)):
        b.extrude(body, _bout(w, bout, 0.36), d * 0.4)
    b.box(neck, (0, -d * 0.02, h * 0.7), (0.028, 0.016, h * 0.54), bevel=0.003)
    b.box(neck, (0, -d * 0.02, bout * 0.16), (0.035, 0.014, bout * 0.3), bevel=0.004, taper=0.6)
    b.box("wood_light", (0, -d * 0.05, bout * 0.42), (0.05, 0.006, 0.02), rotation=(0, 0, 0))
    for x in (-1, 1):
        path = np.multiply([(0.17, 0.09, 0.32), (0.15, 0.09, 0.42), (0.12, 0.09, 0.5)], (x * w, d, bout))
        b.tube("plastic_black", path, 0.004, segments=5)
        for k in range(2):
            b.cylinder(neck, (0, 0, h * (0.9 + 0.03 * k)), (x * 0.035, 0, h * (0.9 + 0.03 * k)), 0.004, segments=6)
    b.lathe(body, [(0.014, -0.015), (0.014, 0.015)], origin=(0, d * 0.02, h - 0.015), axis=(1, 0, 0), segments=14)
    _strings(b, spec.material("string"), 4, bout * 0.2, h * 0.92, -d * 0.16, 0.018)
    return two_hands((-0.016, 0.0, h * 0.76), (0.3, -0.9, 0), (1, 0.2, 0), FIST)


@prop("trumpet")
def trumpet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a trumpet whose bell is at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    z, r = h * 0.55, w / 2
    bell = [(r, 0), (r * 0.97, 0.004), (r * 0.62, 0.03), (r * 0.35, 0.08), (r * 0.2, 0.16), (r * 0.16, d * 0.5)]
    b.lathe(body, bell, origin=(0, -d / 2, z), axis=(0, 1, 0), segments=28, caps=False)
    path = [
        (0, 0, z), (0, d * 0.28, z), (0, d * 0.34, z - 0.03), (0, d * 0.28, z - 0.06), (0, -d * 0.2, z - 0.06),
        (0, -d * 0.26, z - 0.03), (0, -d * 0.2, z), (0, d / 2 - 0.02, z),
    ]  # fmt: skip
    b.tube(body, path, 0.0075)
    b.lathe(body, [(0.006, 0), (0.012, 0.015), (0.012, 0.02)], origin=(0, d / 2 - 0.02, z), axis=(0, 1, 0), segments=14)
    for k in range(3):
        y = -0.02 + 0.028 * k
        b.cylinder(body, (0, y, z - 0.08), (0, y, z + 0.045), 0.011, segments=12)
        b.cylinder("porcelain", (0, y, z + 0.045), (0, y, z + 0.06), 0.007, segments=10)
    return two_hands((-0.02, 0.0, z - 0.03), (0.25, -0.9, 0.2), (1, 0.1, 0), (0.8, 0.85, 0.5))
