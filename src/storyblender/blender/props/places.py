"""Prop builders: what belongs to one sort of place: shelves of goods, the shopping cart, the boiler."""

from __future__ import annotations

import itertools
import math

import numpy as np

from storyblender.blender.materials import material
from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.props.anchors import Anchors, grip, handle
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.catalog.materials import hex_color

LABELS = ("#a3282b", "#d0a231", "#2f5d8c", "#d9d3c2", "#3f7a4a", "#c8642a", "#5d3a6e", "#7fa7c4")
"""Colours of packets and labels."""


@prop("store_shelf")
def store_shelf(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build shelves of goods, each shelf in runs of one sort: tins, jars or packets."""
    (w, d, h), body, rng = spec.size, spec.material("body"), spec.rng
    rows, thick = spec.count("rows"), 0.03
    labels = [material("paint", hex_color(code)) for code in LABELS]
    for x in (-1, 1):
        b.box(body, (x * (w - thick) / 2, 0, h / 2), (thick, d, h), bevel=0.004)
    b.box(body, (0, d / 2 - 0.01, h / 2), (w - 2 * thick, 0.02, h))
    step = (h - 0.14) / rows
    for row in range(rows):
        z = 0.12 + row * step
        b.box(body, (0, 0, z - thick / 2), (w - 2 * thick, d, thick))
        b.box("paper", (0, -d / 2 - 0.002, z - thick / 2), (w - 2 * thick, 0.004, 0.022))
        x, end = -w / 2 + thick + 0.02, w / 2 - thick - 0.02
        while x < end - 0.08:
            run = min(end, x + rng.uniform(0.24, 0.42))
            if rng.random() < spec.number("fill"):
                _goods(b, spec, labels[int(rng.integers(len(labels)))], (x, run), (-d / 2 + 0.03, z), step - 0.06)
            x = run + 0.012
    return ()


def _goods(
    b: MeshBuilder,
    spec: PropSpec,
    label: MaterialRef,
    span: tuple[float, float],
    edge: tuple[float, float],
    room: float,
) -> None:
    """Stand one sort of goods side by side over ``span`` of x, their fronts at ``edge`` (y, z), lower than ``room``."""
    rng, (y, z), depth = spec.rng, edge, spec.size[1] * 0.7
    kind = int(rng.integers(4))
    if kind < 2:  # packets, one box deep
        wide, tall = rng.uniform(0.09, 0.16), room * rng.uniform(0.75, 0.98)
        for x in _side_by_side(span, wide):
            b.box(label, (x, y + depth / 2, z + tall / 2), (wide * 0.95, depth, tall))
        return
    radius, layers = rng.uniform(0.045, 0.058), 2 if kind == 2 else 1
    metal, tall = spec.material("tin" if kind == 2 else "jar"), room * rng.uniform(0.72, 0.94) / layers
    for x, layer in itertools.product(_side_by_side(span, 2 * radius), range(layers)):
        foot = z + layer * tall
        b.cylinder(metal, (x, y + radius, foot), (x, y + radius, foot + tall), radius * 0.97, segments=9)
        low, high = ((x, y + radius, foot + tall * share) for share in (0.14, 0.84))
        b.cylinder(label, low, high, radius, segments=9, caps=False)


def _side_by_side(span: tuple[float, float], wide: float) -> np.ndarray:
    """Return the centres of things ``wide`` metres each, side by side between the two ends of ``span``."""
    count = max(1, int((span[1] - span[0]) / wide))
    return span[0] + wide * (np.arange(count) + 0.5)


@prop("shopping_cart")
def shopping_cart(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a wire cart; it is pushed from +Y."""
    (w, d, h), wire = spec.size, spec.material("wire")
    low, high, back = 0.5, 0.9, d / 2 - 0.1

    def corner(x: int, y: float, share: float) -> tuple[float, float, float]:
        """A point of the basket: it is narrower below and towards its nose (y from 0 at the nose to 1)."""
        half = (w / 2 - 0.02) * (0.72 + 0.16 * share + 0.12 * y)
        nose = -d / 2 + 0.02 + 0.1 * (1 - share)
        return (x * half, nose + (back - nose) * y, low + (high - low) * share + 0.04 * (1 - share) * (1 - y))

    for share in np.linspace(0, 1, 6):
        loop = [corner(-1, 0, share), corner(1, 0, share), corner(1, 1, share), corner(-1, 1, share)]
        b.tube(wire, loop, 0.009 if share == 1 else 0.004, segments=4, closed=True)
    for y, x in itertools.product(np.linspace(0, 1, 9), (-1, 1)):
        b.tube(wire, [corner(x, y, 0), corner(x, y, 1)], 0.003, segments=4)
    for y in np.linspace(0, 1, 9):
        b.tube(wire, [corner(-1, y, 0), corner(1, y, 0)], 0.003, segments=4)
    for t in np.linspace(-0.8, 0.8, 7):
        for y in (0, 1):
            ends = [(t * corner(1, y, share)[0], *corner(1, y, share)[1:]) for share in (0, 1)]
            b.tube(wire, ends, 0.003, segments=4)
    for x in (-1, 1):
        side = x * (w / 2 - 0.05)
        b.tube(wire, [(side, -d / 2 + 0.12, 0.14), (side, back, 0.16), (side, back + 0.02, 0.85)], 0.012, segments=6)
        b.tube(wire, [(side, back - 0.02, 0.16), (side, back, high), (side, d / 2 - 0.02, h - 0.02)], 0.011, segments=6)
        for y in (-d / 2 + 0.12, back):
            b.cylinder(spec.material("tyre"), (side - 0.014, y, 0.06), (side + 0.014, y, 0.06), 0.06, segments=12)
    b.cylinder(
        spec.material("grip"), (-w / 2, d / 2 - 0.02, h - 0.02), (w / 2, d / 2 - 0.02, h - 0.02), 0.018, segments=10
    )
    right = grip("grip_r", (-w * 0.25, d / 2, h), (0.0, -0.6, -0.8), (0, -0.5, -0.85), (0.85, 0.85, 0.5))
    left = grip("grip_l", (w * 0.25, d / 2, h), (0.0, -0.6, -0.8), (0, -0.5, -0.85), (0.85, 0.85, 0.5))
    return (right, left)


@prop("boiler")
def boiler(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a boiler: a riveted drum on a brick foot, a fire door, two gauges, pipes upwards."""
    (w, d, h), body, pipe, iron = spec.size, spec.material("body"), spec.material("pipe"), spec.material("iron")
    radius, top = min(w, d) / 2 - 0.06, h * 0.76
    b.box("brick", (0, 0, 0.09), (w, d, 0.18), bevel=0.01)
    b.lathe(
        body,
        [(radius, 0.18), (radius, top), (radius * 0.9, top + 0.09), (radius * 0.5, top + 0.14), (0.02, top + 0.15)],
        segments=28,
    )
    for z in (0.26, top * 0.55, top - 0.04):
        profile = [(radius, z), (radius + 0.015, z + 0.01), (radius + 0.015, z + 0.05), (radius, z + 0.06)]
        b.lathe(iron, profile, segments=28)
    b.box(iron, (0, -radius, 0.5), (0.36, 0.09, 0.3), bevel=0.02)
    b.box(spec.material("iron"), (0.0, -radius - 0.05, 0.5), (0.28, 0.03, 0.22), bevel=0.01)
    for k in range(4):
        b.box("ember", (0.0, -radius - 0.067, 0.43 + 0.045 * k), (0.2, 0.004, 0.014))
    for x in (-0.12, 0.12):
        b.cylinder("brass", (x, -radius + 0.03, top * 0.78), (x, -radius - 0.035, top * 0.78), 0.07, segments=18)
        b.cylinder("paper", (x, -radius - 0.035, top * 0.78), (x, -radius - 0.037, top * 0.78), 0.058, segments=18)
    for x, y, bent in ((-0.22, 0.1, 0.3), (0.2, 0.16, 0.12), (0.0, -0.06, 0.0)):
        knee = h - 0.1 - bent
        path = [(x, y, top), (x, y, knee), (x * 1.2, y + 0.02, knee + 0.08), (x * 1.5, y + 0.05, h)]
        b.tube(pipe, path, 0.04, segments=10)
    return (handle((0.12, -radius - 0.06, 0.5), name="door"),)


@prop("towel")
def towel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Spread a towel in stripes across its length."""
    (w, d, h), colors = spec.size, (spec.material("cloth"), spec.material("stripe"))
    stripes = 11
    for k in range(stripes):
        b.box(colors[k % 2], (0, d * ((k + 0.5) / stripes - 0.5), h / 2), (w, d / stripes, h))
    return ()


@prop("parasol")
def parasol(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a sunshade of eight panels in two colours on a tilted pole."""
    (w, _, h), colors, panels = spec.size, (spec.material("cloth"), spec.material("stripe")), 8
    b.cylinder(spec.material("pole"), (0, 0, 0), (0, 0, h), 0.024, segments=10)
    shares = (1.0, 0.7, 0.4, 0.03)
    for k, inside in itertools.product(range(panels), (0.0, 0.008)):
        around = np.linspace(math.tau * k / panels, math.tau * (k + 1) / panels, 5)
        sag = 1 - 0.05 * np.sin(np.linspace(0, math.pi, 5))
        rings = [
            np.c_[
                w / 2 * t * sag * np.cos(around),
                w / 2 * t * sag * np.sin(around),
                np.full(5, h - 0.04 - 0.42 * t**1.5 - inside),
            ]
            for t in shares
        ]
        b.loft(colors[k % 2], rings if inside == 0 else rings[::-1], closed=False)
    for k in range(panels):
        turn = math.tau * k / panels
        b.cylinder(
            "steel", (0, 0, h * 0.7), (w * 0.3 * math.cos(turn), w * 0.3 * math.sin(turn), h - 0.26), 0.006, segments=5
        )
    b.sphere(spec.material("pole"), (0, 0, h - 0.02), 0.035, segments=10, rings=6)
    return ()
