"""Prop builders: ordinary things for indoors: a door and a window by themselves, a barbecue, tubs, stacks, badges."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, grips_around, handle
from storyblender.blender.props.registry import PropSpec, prop


@prop("door")
def door(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a panelled door in its frame, ajar if open."""
    (w, d, h), leaf, frame, metal = spec.size, *(spec.material(role) for role in ("leaf", "frame", "metal"))
    post = 0.09 * w
    for x in (-1, 1):
        b.box(frame, (x * (w - post) / 2, 0, h / 2), (post, d, h), bevel=0.006)
    b.box(frame, (0, 0, h - post / 2), (w - 2 * post, d, post), bevel=0.006)
    wide, tall = w - 2 * post, h - post
    if spec.flag("open"):
        b.box("plastic_black", (0, d / 2 - 0.006, tall / 2), (wide, 0.01, tall))
    with b.at((-wide / 2, -d * 0.2, 0), (0, 0, -24 if spec.flag("open") else 0)):
        b.box(leaf, (wide / 2, 0, tall / 2), (wide - 0.01, d * 0.3, tall - 0.01))
        for z, size in ((0.26, 0.36), (0.72, 0.4)):
            for x in (0.29, 0.71):
                b.box(leaf, (x * wide, -d * 0.16, z * tall), (0.3 * wide, d * 0.06, size * tall), bevel=0.01)
        b.sphere(metal, (0.92 * wide, -d * 0.24, 0.47 * tall), 0.026)
    return (handle((0.42 * wide, -d / 2, 0.47 * tall)),)


@prop("window")
def window(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a window of six panes with a sill."""
    (w, d, h), frame, glass = spec.size, spec.material("frame"), spec.material("glass")
    bar = 0.06 * w
    b.box(glass, (0, d * 0.1, h / 2), (w - bar, 0.012, h - bar))
    for x in (-1, 1):
        b.box(frame, (x * (w - bar) / 2, d * 0.1, h / 2), (bar, d * 0.8, h))
    for z in (bar / 2, h - bar / 2):
        b.box(frame, (0, d * 0.1, z), (w - 2 * bar, d * 0.8, bar))
    b.box(frame, (0, d * 0.1, h / 2), (bar * 0.5, d * 0.5, h - 2 * bar))
    for z in (h / 3, 2 * h / 3):
        b.box(frame, (0, d * 0.1, z), (w - 2 * bar, d * 0.5, bar * 0.5))
    b.box(frame, (0, -d * 0.1, bar * 0.3), (w, d * 0.8, bar * 0.6))
    return ()


@prop("barbecue")
def barbecue(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a barbecue on wheels: a round lid over a firebox, a shelf at each side."""
    (w, d, h), lid, metal, tyre = spec.size, *(spec.material(role) for role in ("lid", "metal", "tyre"))
    body, foot = 0.54 * w, 0.16
    for x in (-1, 1):
        for y in (-1, 1):
            b.cylinder(metal, (x * body * 0.42, y * d * 0.36, 0.05), (x * body * 0.42, y * d * 0.36, h * 0.7), 0.016)
        b.box(metal, (x * (body + w) / 4, 0, h * 0.74), ((w - body) / 2, d * 0.8, 0.025), bevel=0.006)
        b.cylinder(
            tyre, (body * 0.42, x * d * 0.42 - 0.02, foot / 2), (body * 0.42, x * d * 0.42 + 0.02, foot / 2), foot / 2
        )
    b.box(metal, (0, 0, h * 0.22), (body * 0.9, d * 0.76, 0.02))
    b.rounded_box(lid, (0, 0, h * 0.66), (body, d * 0.86, h * 0.22), 0.04)
    angle = np.linspace(0, math.pi, 13)
    arc = np.c_[d * 0.43 * np.cos(angle), h * 0.26 * np.sin(angle)]
    b.loft(lid, [np.c_[np.full(13, x * body / 2), arc[:, 0], h * 0.74 + arc[:, 1]] for x in (-1, 1)])
    rod = [(-0.3, -0.4, 0.8), (-0.3, -0.5, 0.82), (0.3, -0.5, 0.82), (0.3, -0.4, 0.8)]
    b.tube(metal, [(x * body, y * d, z * h) for x, y, z in rod], 0.012)
    for x in (-0.3, 0.0, 0.3):
        b.cylinder(metal, (x * body, -d * 0.43, h * 0.64), (x * body, -d * 0.47, h * 0.64), 0.026)
    return (handle((0, -d * 0.5, h * 0.82)),)


@prop("food_tub")
def food_tub(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a round carton, wider above, under a lid."""
    (w, _, h), r = spec.size, spec.size[0] / 2
    b.lathe(spec.material("body"), [(r * 0.8, 0), (r * 0.95, h * 0.85)], segments=24)
    b.lathe(spec.material("lid"), [(r, h * 0.82), (r, h * 0.97), (r * 0.92, h), (0, h)], segments=24)
    b.lathe(spec.material("lid"), [(r * 0.86, h * 0.24), (r * 0.915, h * 0.52)], segments=24, caps=False)
    return grips_around(w * 0.46, h * 0.5)


@prop("aquarium")
def aquarium(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a tank of water on sand, with weed and two fish."""
    (w, d, h), frame, water = spec.size, spec.material("frame"), spec.material("water")
    b.box(spec.material("sand"), (0, 0, h * 0.08), (w * 0.96, d * 0.94, h * 0.1))
    for x, y, tall in ((-0.36, 0.2, 0.6), (-0.28, 0.26, 0.45), (0.34, 0.24, 0.68), (0.4, 0.1, 0.4)):
        b.tube(spec.material("weed"), [(x * w, y * d, h * 0.1), (x * w + 0.015, y * d, h * tall * 0.6),
                                       (x * w - 0.01, y * d, h * tall)], (0.012, 0.014, 0.004))  # fmt: skip
    for x, z, turn in ((-0.12, 0.58, 1), (0.16, 0.4, -1)):
        fish = spec.material("fish")
        b.sphere(fish, (x * w, -d * 0.1, z * h), 0.1 * w, scale=(1, 0.4, 0.55))
        tip, tail = x * w - turn * 0.08 * w, x * w - turn * 0.17 * w
        outline = [(tip, z * h), (tail, z * h + 0.06 * w), (tail, z * h - 0.06 * w)]
        for order in (outline, outline[::-1]):
            b.polygon(fish, [(px, -d * 0.1, pz) for px, pz in order])
    b.box(water, (0, 0, h * 0.5), (w * 0.98, d * 0.96, h * 0.82))
    for z in (0.03, 0.97):
        for y in (-1, 1):
            b.box(frame, (0, y * (d / 2 - 0.008), z * h), (w, 0.016, h * 0.06))
        for x in (-1, 1):
            b.box(frame, (x * (w / 2 - 0.008), 0, z * h), (0.016, d, h * 0.06))
    for x in (-1, 1):
        for y in (-1, 1):
            b.box(frame, (x * (w / 2 - 0.006), y * (d / 2 - 0.006), h / 2), (0.012, 0.012, h * 0.94))
    return ()
