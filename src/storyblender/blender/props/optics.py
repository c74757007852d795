"""Prop builders: cameras, telescopes and microphones on stands."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, two_hands
from storyblender.blender.props.registry import PropSpec, prop


def _tripod(b: MeshBuilder, material: MaterialRef, reach: float, top: float) -> None:
    """Add three legs from a head at height ``top`` to feet ``reach`` metres from the middle."""
    for k in range(3):
        with b.at(rotation=(0, 0, 120 * k - 90)):
            b.cylinder(material, (reach, 0, 0), (0.04, 0, top), 0.014, 0.02, segments=8)
            b.cylinder("brass", (0.02, 0, top - 0.02), (0.07, 0, top - 0.04), 0.026, segments=10)


@prop("camera")
def camera(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a film camera on a tripod; it looks to -Y."""
    (w, _, h), body = spec.size, spec.material("body")
    top = h * 0.7
    _tripod(b, spec.material("leg"), w * 0.46, top)
    b.box("iron", (0, 0, top), (0.12, 0.12, 0.04), bevel=0.01)
    b.box(body, (0, 0, top + 0.13), (0.15, 0.32, 0.22), bevel=0.015)
    for y in (-0.1, 0.12):
        b.cylinder(body, (-0.05, y, top + 0.34), (0.05, y, top + 0.34), 0.115, segments=28)
        b.cylinder("steel", (-0.055, y, top + 0.34), (0.055, y, top + 0.34), 0.03, segments=14)
    profile = [(0.045, 0), (0.045, 0.06), (0.06, 0.07), (0.06, 0.12), (0.05, 0.12), (0.04, 0.1)]
    b.lathe(body, profile, origin=(0, -0.16, top + 0.13), axis=(0, -1, 0), segments=24)
    b.lathe("glass_dark", [(0.048, 0.105), (0.002, 0.115)], origin=(0, -0.16, top + 0.13), axis=(0, -1, 0), segments=20)
    b.cylinder(body, (0.1, 0.1, top + 0.18), (0.1, 0.24, top + 0.18), 0.022, segments=12)
    b.cylinder("steel", (0.02, 0.1, top), (0.12, 0.38, top - 0.14), 0.008, segments=8)
    return ()


@prop("microphone")
def microphone(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a microphone on a stand."""
    (w, _, h), metal = spec.size, spec.material("metal")
    profile = [
        (w / 2, 0), (w * 0.48, 0.02), (w * 0.16, 0.045), (0.014, 0.06), (0.012, h * 0.6), (0.016, h * 0.6),
        (0.016, h * 0.64), (0.009, h * 0.65), (0.009, h - 0.13),
    ]  # fmt: skip
    b.lathe(metal, profile, segments=28)
    with b.at((0, -0.01, h - 0.08), (14, 0, 0)):
        b.rounded_box(metal, (0, 0, 0), (0.075, 0.06, 0.15), 0.028)
        for k in range(7):
            b.box("iron", (0, -0.0, (k - 3) * 0.018), (0.077, 0.062, 0.006), bevel=0.001)
        b.box(metal, (0, 0, 0), (0.084, 0.066, 0.012), bevel=0.002)
    return two_hands((-0.014, 0.006, h * 0.75), (0.2, -1, 0), (1, 0.15, 0), (0.85, 0.85, 0.5))


@prop("telescope")
def telescope(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a telescope that looks up to -Y."""
    (w, d, h), brass = spec.size, spec.material("tube")
    top = h * 0.66
    _tripod(b, spec.material("leg"), w * 0.5, top)
    b.sphere(brass, (0, 0, top + 0.03), 0.05)
    axis = np.array([0, -0.9, 0.42]) / math.hypot(0.9, 0.42)
    start = np.array([0, 0, top + 0.08]) - axis * d * 0.42
    outline = [
        (0.02, 0), (0.026, 0.03), (0.026, 0.14), (0.038, 0.15), (0.04, d * 0.45), (0.05, d * 0.46), (0.052, d * 0.86),
        (0.062, d * 0.87), (0.062, d * 0.94), (0.05, d * 0.94),
    ]  # fmt: skip
    b.lathe(brass, outline, origin=start, axis=axis, segments=22)
    b.lathe("glass_dark", [(0.05, d * 0.942), (0.001, d * 0.944)], origin=start, axis=axis, segments=18)
    return ()
