"""Prop builders: signs: placard, banner, poster, boards and plates. Their front is -Y."""

from __future__ import annotations

import numpy as np

from storyblender.blender.materials import material
from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.printed_sheet import DESIGNS, Inks, print_sheet
from storyblender.blender.props.anchors import Anchors, two_hands
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.catalog.materials import hex_color

_INKS = (
    ("#2f5d73", "#d9b36a", "#a33b2a"),
    ("#d8893b", "#2c4a52", "#f0dcae"),
    ("#7f2f2b", "#e4cf9f", "#26282b"),
    ("#3f5b41", "#1f2a24", "#dcae4e"),
)
"""Of a poster's print, by its design: the picture's ground, the large shape, the small one with the type."""


@prop("placard")
def placard(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a protest placard: a board on a stick."""
    w, _, h = spec.size
    b.box(spec.material("board"), (0, 0, h * 0.77), (w, 0.012, h * 0.46), bevel=0.003)
    b.box(spec.material("stick"), (0, 0.016, h * 0.42), (0.032, 0.02, h * 0.84), bevel=0.004)
    return two_hands((-0.02, 0.016, h * 0.22), (0.25, -1, 0), (1, 0.2, 0), (0.85, 0.85, 0.6))


@prop("banner")
def banner(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a cloth banner between two poles."""
    w, _, h = spec.size
    for x in (-1, 1):
        b.cylinder(spec.material("pole"), (x * w / 2, 0, 0), (x * w / 2, 0, h), 0.022, segments=10)
    rows = []
    for t in np.linspace(0, 1, 13):
        sag = 0.05 * np.sin(np.pi * t)
        x = (t - 0.5) * w
        rows.append(np.array([(x, y, -sag + h * z) for y, z in ((0, 0.98), (0.006, 0.98), (0.006, 0.62), (0, 0.62))]))
    b.loft(spec.material("cloth"), rows)
    return ()


@prop("poster")
def poster(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a poster on a wall: printed, unless it bears writing."""
    w, d, h = spec.size
    b.box(spec.material("paper"), (0, 0, h / 2), (w, d, h))
    if not spec.lettered:
        design = int(spec.rng.integers(DESIGNS))
        inks = Inks(*(material("paint", hex_color(code)) for code in _INKS[design]))
        print_sheet(b, inks, w, h, -d / 2, design)
    return ()


@prop("sign_board")
def sign_board(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sign board on two posts: a town sign, a for-sale sign."""
    w, d, h = spec.size
    for x in (-1, 1):
        b.box(spec.material("post"), (x * w * 0.38, d * 0.2, h / 2), (0.08, 0.08, h), bevel=0.01)
    b.box(spec.material("board"), (0, -d * 0.2, h * 0.74), (w, 0.035, h * 0.5), bevel=0.008)
    return ()


@prop("wall_sign")
def wall_sign(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wall plate with two screws, for a door or a gate."""
    w, d, h = spec.size
    b.box(spec.material("plate"), (0, 0, h / 2), (w, d, h), bevel=min(d / 3, 0.004))
    for x in (-1, 1):
        start, end = (x * w * 0.46, -d / 2, h / 2), (x * w * 0.46, -d / 2 - 0.004, h / 2)
        b.cylinder("steel", start, end, min(0.006, h * 0.05), segments=8)
    return ()


@prop("shop_sign")
def shop_sign(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a long shop sign, high on two posts."""
    w, d, h = spec.size
    for x in (-1, 1):
        b.cylinder("iron", (x * w * 0.42, 0.03, 0), (x * w * 0.42, 0.03, h), 0.045, segments=10)
    b.box(spec.material("board"), (0, -d * 0.2, h * 0.87), (w, 0.07, h * 0.22), bevel=0.012)
    for z in (h * 0.77, h * 0.97):
        b.box(spec.material("rim"), (0, -d * 0.2 - 0.03, z), (w, 0.04, 0.05), bevel=0.012)
    return ()
