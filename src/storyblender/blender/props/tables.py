"""Prop builders: tables and desks."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle, lean
from storyblender.blender.props.parts import circle, draped_cloth, drawer, four_legs, rectangle, table_top, turned_leg
from storyblender.blender.props.registry import PropSpec, prop


@prop("round_table")
def round_table(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pedestal table, with a cloth if wanted."""
    h, r = spec.size[2], spec.size[0] / 2
    b.lathe(spec.material("top"), [(r * 0.96, h - 0.035), (r, h - 0.025), (r, h - 0.008), (r * 0.985, h)], segments=40)
    profile = [
        (r * 0.62, 0), (r * 0.6, 0.025), (0.06, 0.07), (0.035, 0.14), (0.032, h - 0.14), (0.05, h - 0.08),
        (r * 0.4, h - 0.036),
    ]  # fmt: skip
    b.lathe(spec.material("frame"), profile, segments=20)
    if spec.flag("cloth"):
        draped_cloth(b, spec.material("cloth"), circle(r, 64), h + 0.006, 0.3, 9)
    return ()


@prop("dining_table")
def dining_table(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a four-legged table, with a cloth if wanted."""
    (w, d, h), top, leg = spec.size, spec.material("top"), spec.material("leg")
    table_top(b, top, w, d, h, 0.035)
    for y in (-1, 1):
        b.box(leg, (0, y * (d / 2 - 0.09), h - 0.085), (w - 0.22, 0.025, 0.1), bevel=0.004)
    for x in (-1, 1):
        b.box(leg, (x * (w / 2 - 0.09), 0, h - 0.085), (0.025, d - 0.22, 0.1), bevel=0.004)
    four_legs(b, leg, w - 0.1, d - 0.1, h - 0.035, 0.075)
    if spec.flag("cloth"):
        draped_cloth(b, spec.material("cloth"), rectangle(w, d), h + 0.006, 0.26, 14, flare=0.035)
    return ()


@prop("coffee_table")
def coffee_table(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a low table with a shelf."""
    (w, d, h), top, leg = spec.size, spec.material("top"), spec.material("leg")
    table_top(b, top, w, d, h, 0.035)
    b.box(leg, (0, 0, h - 0.06), (w - 0.14, d - 0.14, 0.05), bevel=0.004)
    four_legs(b, leg, w - 0.08, d - 0.08, h - 0.035, 0.05)
    b.box(top, (0, 0, h * 0.32), (w - 0.14, d - 0.14, 0.022), bevel=0.004)
    return ()


@prop("side_table")
def side_table(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a small tripod table."""
    (w, _, h), top, leg = spec.size, spec.material("top"), spec.material("leg")
    r = w / 2
    b.lathe(top, [(r * 0.95, h - 0.03), (r, h - 0.02), (r, h), (r * 0.94, h), (r * 0.92, h - 0.01)], segments=32)
    profile = [(0.03, 0.16), (0.04, 0.2), (0.025, 0.26), (0.045, 0.36), (0.022, 0.46), (0.05, h - 0.03)]
    b.lathe(leg, profile, segments=14)
    for k in range(3):
        with b.at(rotation=(0, 0, 120 * k + 90)):
            path = [(0.02, 0, 0.2), (0.1, 0, 0.16), (0.18, 0, 0.05), (0.21, 0, 0.015)]
            b.tube(leg, path, (0.02, 0.018, 0.014, 0.015))
    return ()


@prop("desk")
def desk(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pedestal desk: panelled front at -Y for the visitor, drawers at +Y for the sitter."""
    (w, d, h), top, body, brass = spec.size, spec.material("top"), spec.material("body"), spec.material("handle")
    table_top(b, top, w, d, h, 0.04)
    pedestal = 0.44
    handles = []
    for x in (-1, 1):
        middle = x * (w / 2 - pedestal / 2 - 0.03)
        b.box(body, (middle, 0, (h - 0.04) / 2 + 0.03), (pedestal, d - 0.08, h - 0.1), bevel=0.006)
        b.box(body, (middle, 0, 0.035), (pedestal + 0.02, d - 0.06, 0.07), bevel=0.01)
        with b.at(rotation=(0, 0, 180)):
            for low, tall in ((0.1, 0.26), (0.38, 0.14), (0.54, 0.14)):
                drawer(b, top, brass, (-middle, -d / 2 + 0.035, low + tall / 2), pedestal - 0.05, tall - 0.02)
        handles.append(handle((middle, d / 2, 0.61), (0, 1, 0), "drawer_right" if x > 0 else "drawer_left"))
        b.box(top, (middle, -d / 2 + 0.035, 0.38), (pedestal - 0.1, 0.016, 0.46), bevel=0.006)
    b.box(body, (0, -d / 2 + 0.08, h * 0.55), (w - 2 * pedestal, 0.025, h * 0.7))
    b.box(top, (0, -d / 2 + 0.064, h * 0.55), (w - 2 * pedestal - 0.16, 0.012, h * 0.48), bevel=0.005)
    b.box(body, (0, d / 2 - 0.1, h - 0.09), (w - 2 * pedestal, 0.03, 0.1))
    return tuple(handles)


@prop("school_desk")
def school_desk(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a pupil's desk with a sloping lid; the pupil is at -Y."""
    (w, d, h), top, iron = spec.size, spec.material("top"), spec.material("frame")
    b.box(top, (0, 0, h - 0.05), (w, d, 0.025), bevel=0.006, rotation=(6, 0, 0))
    b.box(top, (0, d / 2 - 0.05, h - 0.015), (w, 0.1, 0.02), bevel=0.004)
    b.box(top, (0, 0.01, h - 0.13), (w - 0.04, d - 0.06, 0.1), bevel=0.004)
    for x in (-1, 1):
        side = x * (w / 2 - 0.05)
        b.tube(iron, [(side, -d / 2 + 0.03, 0.015), (side, d / 2 - 0.03, 0.015)], 0.015)
        b.tube(iron, [(side, d / 2 - 0.1, 0.02), (side, 0.02, 0.32), (side, d / 2 - 0.12, h - 0.14)], 0.014)
        b.tube(iron, [(side, -d / 2 + 0.08, 0.02), (side, 0.02, 0.32), (side, -d / 2 + 0.1, h - 0.18)], 0.014)
    b.cylinder(iron, (-w / 2 + 0.05, 0.02, 0.32), (w / 2 - 0.05, 0.02, 0.32), 0.01)
    return ()


@prop("dressing_table")
def dressing_table(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a dressing table: desk top at half its height, a swinging oval mirror; the sitter is at -Y."""
    (w, d, h), body, glass, brass = spec.size, spec.material("body"), spec.material("mirror"), spec.material("handle")
    top = h * 0.5
    b.box(body, (0, 0, top - 0.015), (w, d, 0.03), bevel=0.008)
    b.box(body, (0, 0.01, top - 0.09), (w - 0.06, d - 0.06, 0.13), bevel=0.005)
    drawer(b, body, brass, (0, -d / 2 + 0.035, top - 0.09), w * 0.36, 0.1, knob=True)
    for x in (-1, 1):
        middle = x * (w / 2 - 0.19)
        b.box(body, (middle, 0.01, top - 0.27), (0.32, d - 0.06, 0.3), bevel=0.006)
        drawer(b, body, brass, (middle, -d / 2 + 0.035, top - 0.09), 0.28, 0.1, knob=True)
        drawer(b, body, brass, (middle, -d / 2 + 0.035, top - 0.205), 0.28, 0.12, knob=True)
        drawer(b, body, brass, (middle, -d / 2 + 0.035, top - 0.34), 0.28, 0.12, knob=True)
        for dx in (-0.13, 0.13):
            for y in (-d / 2 + 0.06, d / 2 - 0.06):
                b.cylinder(body, (middle + dx, y, 0), (middle + dx, y, top - 0.42), 0.012, 0.022, segments=10)
        b.lathe(body, [(0.025, 0), (0.014, 0.06), (0.016, h * 0.3), (0.026, h * 0.32), (0.004, h * 0.36)],
                origin=(x * w * 0.3, d / 2 - 0.07, top), segments=12)  # fmt: skip
        b.sphere(brass, (x * w * 0.285, d / 2 - 0.09, top + h * 0.28), 0.014)
    oval = [
        (w * 0.26 * math.cos(a), d / 2 - 0.08, top + h * 0.27 + h * 0.215 * math.sin(a))
        for a in np.linspace(0, 2 * math.pi, 40, endpoint=False)
    ]
    b.tube(body, oval, 0.018, closed=True)
    b.polygon(glass, [(x, y - 0.008, z) for x, y, z in oval])
    b.polygon(body, [(x, y + 0.008, z) for x, y, z in reversed(oval)])
    return (handle((0, -d / 2, top - 0.09), name="drawer"),)


@prop("workbench")
def workbench(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a heavy bench with a vice and a lower shelf."""
    (w, d, h), top, leg = spec.size, spec.material("top"), spec.material("leg")
    table_top(b, top, w, d, h, 0.07)
    for x in (-1, 1):
        for y in (-1, 1):
            b.box(leg, (x * (w / 2 - 0.12), y * (d / 2 - 0.09), (h - 0.07) / 2), (0.1, 0.1, h - 0.07), bevel=0.006)
        b.box(leg, (x * (w / 2 - 0.12), 0, 0.2), (0.06, d - 0.2, 0.08))
    for k in range(4):
        b.box(top, (0, (k - 1.5) * d * 0.2, 0.255), (w - 0.16, d * 0.18, 0.025), bevel=0.004)
    b.box(leg, (0, -d / 2 + 0.09, h - 0.13), (w - 0.2, 0.04, 0.12), bevel=0.004)
    b.box(leg, (-w / 2 + 0.3, -d / 2 - 0.03, h - 0.1), (0.26, 0.05, 0.17), bevel=0.008)
    b.cylinder("steel", (-w / 2 + 0.3, -d / 2 - 0.09, h - 0.13), (-w / 2 + 0.3, -d / 2, h - 0.13), 0.016)
    b.cylinder("steel", (-w / 2 + 0.18, -d / 2 - 0.08, h - 0.13), (-w / 2 + 0.42, -d / 2 - 0.08, h - 0.13), 0.009)
    return (lean((0, -d / 2, h), w),)


@prop("billiard_table")
def billiard_table(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a billiard table with balls."""
    (w, d, h), cloth, body = spec.size, spec.material("cloth"), spec.material("body")
    bed = h - 0.045
    b.box(body, (0, 0, bed - 0.13), (w - 0.1, d - 0.1, 0.2), bevel=0.01)
    b.box(cloth, (0, 0, bed - 0.015), (w - 0.14, d - 0.14, 0.03))
    for x in (-1, 1):
        b.box(body, (x * (w / 2 - 0.06), 0, h - 0.05), (0.12, d, 0.1), bevel=0.012)
        b.box(cloth, (x * (w / 2 - 0.14), 0, h - 0.03), (0.05, d - 0.3, 0.03), bevel=0.008)
        for y in (-1, 0, 1):
            turned_leg(b, body, x * (w / 2 - 0.14), y * (d / 2 - 0.16), bed - 0.2, 0.08)
            start = (x * (w / 2 - 0.1), y * (d / 2 - 0.1), h - 0.06)
            b.cylinder("leather_black", start, (x * (w / 2 - 0.1), y * (d / 2 - 0.1), h + 0.002), 0.055)
    for y in (-1, 1):
        b.box(body, (0, y * (d / 2 - 0.06), h - 0.05), (w, 0.12, 0.1), bevel=0.012)
        b.box(cloth, (0, y * (d / 2 - 0.14), h - 0.03), (w - 0.3, 0.05, 0.03), bevel=0.008)
    colors = ("porcelain", "fabric_red", "neon_blue", "brass", "plastic_black", "fabric_green")
    for k in range(9):
        x, y = spec.rng.uniform(-0.36, 0.36) * w, spec.rng.uniform(-0.4, 0.4) * d
        b.sphere(colors[k % len(colors)], (x, y, bed + 0.028), 0.028, segments=12, rings=8)
    return (lean((0, -d / 2, h), w),)


@prop("lectern")
def lectern(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a lectern; the speaker stands at +Y, the listeners are at -Y."""
    (w, d, h), body = spec.size, spec.material("body")
    b.box(body, (0, 0, 0.04), (w, d, 0.08), bevel=0.012)
    b.box(body, (0, 0, h * 0.45), (w * 0.78, d * 0.62, h * 0.82), bevel=0.008, taper=1.08)
    b.box(body, (0, -d * 0.335, h * 0.48), (w * 0.5, 0.02, h * 0.5), bevel=0.008)
    b.box(body, (0, 0, h - 0.09), (w, d, 0.035), bevel=0.008, rotation=(-16, 0, 0))
    b.box(body, (0, d / 2 - 0.02, h - 0.135), (w, 0.03, 0.05), bevel=0.006)
    return (lean((0, d / 2, h - 0.12), w, (0, -1, 0)),)


@prop("counter")
def counter(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a shop or kitchen counter; the customers are at -Y."""
    (w, d, h), body, top = spec.size, spec.material("body"), spec.material("top")
    b.box(top, (0, 0, h - 0.025), (w, d, 0.05), bevel=0.01)
    b.box(body, (0, 0.02, (h - 0.05) / 2), (w - 0.06, d - 0.1, h - 0.05))
    b.box("wood_dark", (0, -0.005, 0.05), (w - 0.05, d - 0.09, 0.1), bevel=0.006)
    count = max(2, round(w / 0.6))
    for i in range(count):
        x = (i - (count - 1) / 2) * (w - 0.06) / count
        b.box(body, (x, -d / 2 + 0.066, h * 0.52), ((w - 0.06) / count - 0.05, 0.022, h * 0.68), bevel=0.008)
        b.box(body, (x, -d / 2 + 0.055, h * 0.52), ((w - 0.06) / count - 0.19, 0.022, h * 0.54), bevel=0.008)
    return (lean((0, -d / 2, h), w), lean((0, d / 2, h), w, (0, -1, 0), "keeper"))


@prop("bar_counter")
def bar_counter(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bar; the guests are at -Y, the keeper at +Y."""
    (w, d, h), body, top, rail = spec.size, spec.material("body"), spec.material("top"), spec.material("rail")
    b.box(top, (0, 0, h - 0.03), (w, d, 0.06), bevel=0.014)
    b.cylinder(top, (-w / 2, -d / 2 + 0.035, h - 0.012), (w / 2, -d / 2 + 0.035, h - 0.012), 0.032, segments=12)
    b.box(body, (0, 0.06, (h - 0.06) / 2), (w - 0.04, d - 0.26, h - 0.06))
    b.box(body, (0, 0.0, 0.06), (w - 0.02, d - 0.2, 0.12), bevel=0.01)
    b.box(body, (0, 0.0, h - 0.1), (w - 0.02, d - 0.2, 0.08), bevel=0.01)
    count = max(2, round(w / 0.5))
    step, face = (w - 0.04) / count, -d / 2 + 0.19
    for i in range(count):
        x = (i - (count - 1) / 2) * step
        b.box(body, (x, face - 0.005, h * 0.48), (step - 0.12, 0.02, h * 0.6), bevel=0.008)
        b.box(top, (x, face - 0.012, h * 0.48), (step - 0.22, 0.02, h * 0.46), bevel=0.008)
    for i in range(count + 1):
        x = (i - count / 2) * step
        b.box(body, (x, face - 0.015, h * 0.48), (0.07, 0.03, h * 0.78), bevel=0.006)
        b.tube(rail, [(x, face, 0.15), (x, -d / 2 + 0.06, 0.17)], 0.012, segments=6)
    b.cylinder(rail, (-w / 2 + 0.02, -d / 2 + 0.06, 0.17), (w / 2 - 0.02, -d / 2 + 0.06, 0.17), 0.022, segments=12)
    return (lean((0, -d / 2, h), w), lean((0, d / 2, h), w, (0, -1, 0), "keeper"))
