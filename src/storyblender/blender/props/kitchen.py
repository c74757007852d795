"""Prop builders: stoves, hearths, fridge, sink, radiator, ceiling fan."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle, lean
from storyblender.blender.props.lamps import flame
from storyblender.blender.props.opened import open_fridge
from storyblender.blender.props.parts import panel_door
from storyblender.blender.props.registry import PropSpec, prop


@prop("stove")
def stove(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a kitchen range with an oven door and four rings."""
    (w, d, h), body, iron, metal = spec.size, spec.material("body"), spec.material("iron"), spec.material("metal")
    top = h - 0.12
    b.box(body, (0, 0.01, top / 2 + 0.03), (w, d - 0.04, top - 0.06), bevel=0.012)
    b.box(iron, (0, 0.02, 0.03), (w - 0.06, d - 0.1, 0.06))
    b.box(iron, (0, 0.0, top - 0.01), (w, d, 0.03), bevel=0.008)
    b.box(body, (0, d / 2 - 0.03, top + 0.06), (w, 0.05, 0.12), bevel=0.01)
    b.box(body, (0, -d / 2 + 0.02, top * 0.45), (w - 0.06, 0.03, top * 0.56), bevel=0.01)
    b.box("glass_dark", (0, -d / 2 + 0.005, top * 0.47), (w * 0.56, 0.01, top * 0.28), bevel=0.006)
    path = [(w * x, -d / 2 - y, 0.7 * top) for x, y in ((-0.36, 0), (-0.36, 0.04), (0.36, 0.04), (0.36, 0))]
    b.tube(metal, path, 0.01)
    for k in range(5):
        profile = [(0.022, 0), (0.02, 0.025)]
        b.lathe(iron, profile, origin=((k - 2) * w * 0.18, -d / 2 + 0.03, top * 0.87), axis=(0, -1, 0), segments=16)
    for x in (-1, 1):
        for y in (-1, 1):
            for reach in (0.08, 0.045):
                loop = [
                    (x * w * 0.24 + reach * math.cos(a), y * d * 0.22 + reach * math.sin(a), top + 0.012)
                    for a in np.linspace(0, math.tau, 20, endpoint=False)
                ]
                b.tube(iron, loop, 0.008, segments=6, closed=True)
    return (handle((0, -d / 2 - 0.04, top * 0.7), name="door"), lean((0, -d / 2, top), w))


@prop("wood_stove")
def wood_stove(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pot-bellied stove with its pipe."""
    (w, d, h), iron = spec.size, spec.material("body")
    r = w / 2
    profile = [
        (r * 0.7, 0.16), (r * 0.8, 0.2), (r * 0.7, 0.26), (r * 0.96, 0.42), (r, 0.52), (r * 0.9, 0.66), (r * 0.62, 0.8),
        (r * 0.8, 0.84), (r * 0.8, 0.88), (r * 0.3, 0.92),
    ]  # fmt: skip
    b.lathe(iron, profile, segments=28)
    for k in range(3):
        with b.at(rotation=(0, 0, 120 * k + 90)):
            b.tube(iron, [(r * 0.6, 0, 0.2), (r * 0.75, 0, 0.1), (r * 0.85, 0, 0.0)], (0.03, 0.022, 0.03))
    b.cylinder(iron, (0, 0.02, 0.9), (0, 0.02, h), 0.065, segments=18)
    for z in (1.2, 1.65):
        b.lathe(iron, [(0.065, z), (0.072, z + 0.015), (0.065, z + 0.03)], origin=(0, 0.02, 0), segments=18, caps=False)
    b.box(iron, (0, -r * 0.94, 0.46), (0.24, 0.05, 0.2), bevel=0.012)
    for k in range(4):
        b.box(spec.material("fire"), ((k - 1.5) * 0.045, -r * 0.94 - 0.024, 0.46), (0.022, 0.01, 0.13), bevel=0.003)
    b.sphere("brass", (0.1, -d / 2 - 0.0, 0.46), 0.016)
    return (handle((0.1, -d / 2, 0.46), name="door"),)


@prop("fridge")
def fridge(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a refrigerator with rounded shoulders, or one whose door stands ``open``."""
    (w, d, h), body, metal = spec.size, spec.material("body"), spec.material("metal")
    if spec.flag("open"):
        open_fridge(b, body, metal, spec.size)
        return (handle((-w * 0.38, -d / 2 - 0.03, h * 0.55), name="door"),)
    b.rounded_box(body, (0, 0.03, h / 2 + 0.02), (w, d - 0.08, h - 0.04), 0.07)
    b.rounded_box(body, (0, -d / 2 + 0.06, h * 0.4), (w - 0.02, 0.1, h * 0.66), 0.04)
    b.rounded_box(body, (0, -d / 2 + 0.06, h * 0.86), (w - 0.02, 0.1, h * 0.23), 0.04)
    for z, tall in ((h * 0.55, 0.2), (h * 0.8, 0.12)):
        path = [
            (-0.38 * w, -d / 2 + y, z + tall * up) for y, up in ((0.01, -0.5), (-0.03, -0.5), (-0.03, 0.5), (0.01, 0.5))
        ]
        b.tube(metal, path, 0.011)
    b.box("iron", (0, 0, 0.03), (w - 0.08, d - 0.14, 0.06))
    b.box(metal, (w * 0.2, -d / 2 + 0.008, h * 0.86), (0.16, 0.01, 0.03), bevel=0.004)
    return (handle((-w * 0.38, -d / 2 - 0.03, h * 0.55), name="door"),)


@prop("sink")
def sink(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a basin in a cupboard; one stands at -Y."""
    (w, d, h), body, basin, metal = spec.size, spec.material("body"), spec.material("basin"), spec.material("metal")
    top = h - 0.24
    b.box(body, (0, 0.01, top / 2 - 0.065), (w - 0.04, d - 0.05, top - 0.23), bevel=0.006)
    for x in (-1, 1):
        b.box(body, (x * (w / 2 - 0.03), 0.01, top - 0.12), (0.02, d - 0.05, 0.14))
        b.box(body, (0, 0.01 + x * (d / 2 - 0.035), top - 0.12), (w - 0.04, 0.02, 0.14))
        panel_door(b, body, (x * w * 0.235, -d / 2 + 0.03, top * 0.48), w * 0.45, top * 0.7)
        b.sphere(metal, (x * 0.05, -d / 2 + 0.005, top * 0.6), 0.014)
    for x in (-1, 1):
        b.box(basin, (x * (w * 0.4), 0, top - 0.03), (w * 0.2, d, 0.06), bevel=0.01)
        b.box(basin, (0, x * (d / 2 - 0.06), top - 0.03), (w * 0.62, 0.12, 0.06), bevel=0.01)
    b.box(basin, (0, 0, top - 0.16), (w * 0.62, d - 0.2, 0.02))
    for x in (-1, 1):
        b.box(basin, (x * w * 0.3, 0, top - 0.09), (0.02, d - 0.2, 0.14))
        b.box(basin, (0, x * (d / 2 - 0.11), top - 0.09), (w * 0.6, 0.02, 0.14))
        profile = [(0.016, 0), (0.016, 0.05), (0.03, 0.055), (0.03, 0.07)]
        b.lathe(metal, profile, origin=(x * 0.1, d / 2 - 0.06, top), segments=12)
    path = [
        (0, d / 2 - 0.06, top), (0, d / 2 - 0.06, h - 0.04), (0, d / 2 - 0.1, h), (0, d / 2 - 0.2, h - 0.02),
        (0, d / 2 - 0.22, h - 0.08),
    ]  # fmt: skip
    b.tube(metal, path, 0.014)
    return (lean((0, -d / 2, top), w),)


@prop("fireplace")
def fireplace(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a fireplace with its mantel; ``lit`` lights the logs."""
    (w, d, h), body, inside = spec.size, spec.material("body"), spec.material("inside")
    hole_w, hole_h = w * 0.54, h * 0.62
    side = (w * 0.92 - hole_w) / 2
    for x in (-1, 1):
        b.box(body, (x * (hole_w + side) / 2, 0.03, h * 0.46), (side, d - 0.1, h * 0.92), bevel=0.01)
        b.box(body, (x * (hole_w + side) / 2, -d / 2 + 0.07, h * 0.42), (side * 0.6, 0.05, h * 0.72), bevel=0.01)
        b.box(body, (x * (hole_w + side) / 2, -d / 2 + 0.07, 0.06), (side * 1.05, 0.09, 0.12), bevel=0.012)
        b.box(inside, (x * (hole_w / 2 - 0.02), 0.05, hole_h / 2), (0.04, d - 0.16, hole_h))
    b.box(body, (0, 0.03, (hole_h + h * 0.92) / 2), (hole_w, d - 0.1, h * 0.92 - hole_h), bevel=0.006)
    b.box(body, (0, -d / 2 + 0.075, h * 0.76), (w * 0.4, 0.03, h * 0.14), bevel=0.012)
    b.box(body, (0, -0.0, h * 0.94), (w * 0.97, d - 0.04, h * 0.04), bevel=0.014)
    b.box(body, (0, 0, h * 0.98), (w, d, h * 0.04), bevel=0.012)
    b.box(inside, (0, d / 2 - 0.06, hole_h / 2), (hole_w, 0.08, hole_h))
    b.box(inside, (0, 0.05, 0.02), (hole_w, d - 0.12, 0.04))
    for x in (-1, 1):
        b.tube("iron", [(x * 0.2, -d * 0.3, 0.16), (x * 0.2, -d * 0.28, 0.07), (x * 0.2, d * 0.24, 0.07)], 0.012)
    wood = spec.material("wood")
    for k, (y, z, turn) in enumerate(((-0.08, 0.13, 3), (0.06, 0.13, -5), (-0.01, 0.22, 8))):
        with b.at((0, y, z), (0, 0, turn)):
            b.cylinder(wood, (-hole_w * 0.36, 0, 0), (hole_w * 0.36, 0, 0), 0.052 - 0.004 * k, segments=12)
    if spec.flag("lit"):
        for k in range(7):
            x = (k - 3) * hole_w * 0.1
            flame(b, spec.material("fire"), x, 0.05 * math.sin(2.3 * k), 0.16, 0.2 + 0.12 * math.cos(1.7 * k) ** 2)
    return (lean((0, -d / 2, h), w, name="mantel"),)


@prop("radiator")
def radiator(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a ribbed radiator."""
    (w, d, h), body = spec.size, spec.material("body")
    count = max(4, round(w / 0.075))
    for k in range(count):
        x = (k - (count - 1) / 2) * w / count
        b.rounded_box(body, (x, 0, h / 2 + 0.04), (w / count * 0.8, d * 0.9, h - 0.08), 0.024)
    for z in (0.13, h - 0.09):
        b.cylinder(body, (-w / 2, 0, z), (w / 2, 0, z), 0.022)
    for x in (-0.4, 0.4):
        b.box(body, (x * w, 0, 0.04), (0.04, d, 0.08), bevel=0.006)
    return ()


@prop("ceiling_fan")
def ceiling_fan(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a ceiling fan."""
    (w, _, h), blade, metal = spec.size, spec.material("blade"), spec.material("metal")
    b.cylinder(metal, (0, 0, 0.12), (0, 0, h), 0.015)
    b.lathe(metal, [(0.05, h - 0.07), (0.07, h - 0.02), (0.07, h)], segments=18)
    b.lathe(metal, [(0.04, 0.0), (0.09, 0.03), (0.1, 0.08), (0.07, 0.13), (0.02, 0.15)], segments=22)
    for k in range(4):
        with b.at((0, 0, 0.07), (0, 0, 90 * k + 20)), b.at(rotation=(9, 0, 0)):
            b.box(metal, (0.13, 0, 0), (0.12, 0.035, 0.008))
            outline = [(0.17, -0.05), (w / 2 - 0.02, -0.075), (w / 2, 0.0), (w / 2 - 0.02, 0.075), (0.17, 0.05)]
            b.extrude(blade, outline, 0.01)
    return ()
