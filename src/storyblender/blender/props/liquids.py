"""Prop builders: liquids in motion and at rest: water that runs from a tap, a jet of a hose, what fills a vessel."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors
from storyblender.blender.props.registry import PropSpec, prop


@prop("running_water")
def running_water(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a stream that falls from a spout at the top and breaks up where it lands."""
    (w, _, h), water = spec.size, spec.material("water")
    fall = np.linspace(0, 1, 9)
    path = np.c_[0.04 * w * np.sin(7 * fall), 0.04 * w * np.cos(5 * fall), h * (1 - fall)]
    b.tube(water, path, tuple(float(w * (0.13 - 0.05 * t)) for t in fall), segments=8)
    for k in range(3):
        b.lathe(water, [(w * (0.2 + 0.15 * k), 0), (w * (0.18 + 0.15 * k), 0.006 - 0.0015 * k)], segments=16)
    for k in range(9):
        angle, reach = 2.4 * k, w * (0.2 + 0.03 * k)
        b.sphere(water, (reach * math.cos(angle), reach * math.sin(angle), 0.006 + 0.004 * (k % 4)), 0.0045, segments=6)
    return ()


@prop("water_jet")
def water_jet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a jet that is thrown to -Y from the origin and spreads into drops where it comes down."""
    (w, d, h), water = spec.size, spec.material("water")
    t = np.linspace(0, 1, 14)
    path = np.c_[0 * t, -d * t, h * (1 - t) + 0.15 * d * t * (1 - t)]
    b.tube(water, path, tuple(float(w * (0.1 + 0.16 * each)) for each in t), segments=8)
    for k in range(26):
        along = 0.45 + 0.55 * ((k * 0.618) % 1)
        x = w * (0.1 + 0.33 * along) * math.sin(2.4 * k)
        z = h * (1 - along) + 0.15 * d * along * (1 - along) + 0.2 * w * math.cos(3.1 * k)
        b.sphere(water, (x, -d * along, max(z, 0.01)), 0.012, segments=6)
    return ()


@prop("liquid")
def liquid(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build the surface of what fills a vessel: round, or oblong with round corners."""
    (w, d, h), skin = spec.size, spec.material("liquid")
    turn = np.linspace(0, math.tau, 33)[:-1]
    power = 0.4 if spec.flag("oblong") else 1.0
    x = np.sign(np.cos(turn)) * np.abs(np.cos(turn)) ** power * w / 2
    y = np.sign(np.sin(turn)) * np.abs(np.sin(turn)) ** power * d / 2
    b.extrude(skin, np.c_[x, y], h)
    return ()
