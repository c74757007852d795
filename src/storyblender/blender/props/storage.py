"""Prop builders: cupboards, shelves, boxes and barrels."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.materials import material
from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.props.anchors import Anchors, handle, two_hands
from storyblender.blender.props.opened import open_carton, tray
from storyblender.blender.props.parts import book_row, bottle_profile, drawer, four_legs, panel_door
from storyblender.blender.props.registry import PropSpec, prop
from storyblender.catalog.materials import hex_color

COVERS = ("#6b2b22", "#2f4a3c", "#31445e", "#7a5a2c", "#3b2a22", "#8a7a5c", "#55304a", "#a9a08a")
"""Cloth and leather of book bindings."""


@prop("nightstand")
def nightstand(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bedside table with a drawer and a shelf."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("handle")
    b.box(body, (0, 0, h - 0.015), (w, d, 0.03), bevel=0.008)
    b.box(body, (0, 0.01, h - 0.11), (w - 0.05, d - 0.05, 0.16))
    drawer(b, body, brass, (0, -d / 2 + 0.03, h - 0.11), w - 0.09, 0.12, knob=True)
    b.box(body, (0, 0, h * 0.26), (w - 0.06, d - 0.06, 0.025), bevel=0.005)
    four_legs(b, body, w - 0.03, d - 0.03, h - 0.03, 0.045)
    return (handle((0, -d / 2, h - 0.11), name="drawer"),)


@prop("wardrobe")
def wardrobe(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a two-door wardrobe with a cornice."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("handle")
    b.box(body, (0, 0.01, h / 2), (w - 0.06, d - 0.06, h - 0.08), bevel=0.006)
    b.box(body, (0, 0, 0.06), (w - 0.01, d - 0.01, 0.12), bevel=0.012)
    b.box(body, (0, 0, h - 0.09), (w - 0.03, d - 0.03, 0.05), bevel=0.012)
    b.box(body, (0, 0, h - 0.035), (w, d, 0.07), bevel=0.02)
    door = (w - 0.12) / 2
    handles = []
    for x in (-1, 1):
        panel_door(b, body, (x * door / 2, -d / 2 + 0.03, h / 2 - 0.01), door - 0.01, h - 0.3, panels=2)
        at = (x * 0.045, -d / 2 + 0.005, h * 0.5)
        b.sphere(brass, at, 0.018)
        b.box(brass, (at[0], at[1] + 0.014, at[2] - 0.03), (0.025, 0.006, 0.12), bevel=0.002)
        handles.append(handle((at[0], -d / 2, at[2]), name="door_right" if x > 0 else "door_left"))
    return tuple(handles)


@prop("dresser")
def dresser(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a chest of drawers."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("handle")
    rows = spec.count("rows")
    b.box(body, (0, 0, h - 0.018), (w, d, 0.036), bevel=0.01)
    b.box(body, (0, 0.01, (h - 0.03 + 0.08) / 2), (w - 0.05, d - 0.05, h - 0.11), bevel=0.005)
    b.box(body, (0, 0, 0.1), (w - 0.02, d - 0.02, 0.05), bevel=0.01)
    four_legs(b, body, w - 0.03, d - 0.03, 0.12, 0.07)
    step = (h - 0.19) / rows
    for k in range(rows):
        drawer(b, body, brass, (0, -d / 2 + 0.03, 0.14 + step * (k + 0.5)), w - 0.11, step - 0.02, knob=True)
    return (handle((0, -d / 2, 0.14 + step * (rows - 0.5)), name="drawer"),)


@prop("cabinet")
def cabinet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a low cupboard with panelled doors."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("handle")
    doors = spec.count("doors")
    b.box(body, (0, 0, h - 0.018), (w, d, 0.036), bevel=0.01)
    b.box(body, (0, 0.01, h / 2 + 0.03), (w - 0.05, d - 0.05, h - 0.1), bevel=0.005)
    b.box(body, (0, 0, 0.05), (w - 0.02, d - 0.02, 0.1), bevel=0.01)
    step = (w - 0.09) / doors
    handles = []
    for i in range(doors):
        x = (i - (doors - 1) / 2) * step
        panel_door(b, body, (x, -d / 2 + 0.03, h / 2 + 0.035), step - 0.012, h - 0.17)
        at = x + (step / 2 - 0.045) * (1 if i % 2 == 0 else -1)
        b.sphere(brass, (at, -d / 2 + 0.004, h * 0.58), 0.016)
        handles.append(handle((at, -d / 2, h * 0.58), name=f"door_{i + 1}"))
    return tuple(handles)


@prop("filing_cabinet")
def filing_cabinet(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a filing cabinet with label holders."""
    (w, d, h), body, steel = spec.size, spec.material("body"), spec.material("handle")
    b.box(body, (0, 0.01, h / 2), (w, d - 0.02, h), bevel=0.008)
    rows = max(2, round(h / 0.33))
    step = (h - 0.07) / rows
    for k in range(rows):
        z = 0.04 + step * (k + 0.5)
        b.box(body, (0, -d / 2 + 0.012, z), (w - 0.035, 0.024, step - 0.025), bevel=0.007)
        drawer(b, body, steel, (0, -d / 2 + 0.02, z - 0.02), 0.13, 0.02)
        b.box(steel, (0, -d / 2 + 0.0, z + step * 0.24), (0.1, 0.008, 0.05), bevel=0.002)
        b.box("paper", (0, -d / 2 - 0.003, z + step * 0.24), (0.085, 0.005, 0.035))
    return (handle((0, -d / 2, 0.04 + step * (rows - 0.5)), name="drawer"),)


@prop("locker")
def locker(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a row of three metal lockers with louvres."""
    (w, d, h), body, steel = spec.size, spec.material("body"), spec.material("handle")
    b.box(body, (0, 0.01, h / 2), (w, d - 0.02, h), bevel=0.006)
    for i in range(3):
        x = (i - 1) * w / 3
        b.box(body, (x, -d / 2 + 0.012, h / 2 + 0.02), (w / 3 - 0.02, 0.022, h - 0.1), bevel=0.006)
        for z in (h - 0.16, h - 0.2, h - 0.24, 0.24, 0.2):
            b.box("iron", (x, -d / 2 - 0.0, z), (w / 3 - 0.12, 0.008, 0.012))
        b.box(steel, (x + w / 6 - 0.05, -d / 2 - 0.008, h * 0.52), (0.02, 0.02, 0.1), bevel=0.005)
    return (handle((w / 6 - 0.05, -d / 2, h * 0.52), name="door"),)


@prop("safe")
def safe(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a safe with a dial and a spoked wheel."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("handle")
    b.box(body, (0, 0.02, h / 2 + 0.03), (w, d - 0.1, h - 0.06), bevel=0.02)
    b.box(body, (0, -d / 2 + 0.06, h / 2 + 0.03), (w - 0.1, 0.05, h - 0.16), bevel=0.015)
    four_legs(b, body, w - 0.04, d - 0.14, 0.05, 0.07)
    profile = [(0.055, 0), (0.055, 0.012), (0.03, 0.02), (0.026, 0.045)]
    b.lathe(brass, profile, origin=(0.1, -d / 2 + 0.04, h * 0.6), axis=(0, -1, 0))
    center = (-0.08, -d / 2 + 0.03, h * 0.5)
    b.cylinder(brass, (center[0], center[1] + 0.02, center[2]), (center[0], center[1] - 0.02, center[2]), 0.022)
    for k in range(4):
        turn = math.pi * k / 4
        reach = (0.09 * math.cos(turn), 0.0, 0.09 * math.sin(turn))
        start, end = (
            tuple(c + s * r for c, r in zip((center[0], center[1] - 0.015, center[2]), reach, strict=True))
            for s in (-1, 1)
        )
        b.cylinder(brass, start, end, 0.008, segments=8)
    for z in (0.25, 0.75):
        foot, tip = (w / 2 - 0.025, -d / 2 + 0.06, h * z - 0.06), (w / 2 - 0.025, -d / 2 + 0.06, h * z + 0.06)
        b.cylinder(brass, foot, tip, 0.02, segments=10)
    return (handle((-0.08, -d / 2, h * 0.5), name="door"),)


@prop("bookshelf")
def bookshelf(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bookcase with standing books."""
    (w, d, h), body = spec.size, spec.material("body")
    rows, thick = spec.count("rows"), 0.026
    covers = [material("leather", hex_color(code)) for code in COVERS]
    for x in (-1, 1):
        b.box(body, (x * (w - thick) / 2, 0, h / 2), (thick, d, h), bevel=0.004)
    b.box(body, (0, d / 2 - 0.008, h / 2), (w, 0.016, h))
    b.box(body, (0, 0, 0.04), (w - 2 * thick, d - 0.02, 0.08))
    b.box(body, (0, 0, h - 0.02), (w + 0.03, d + 0.02, 0.04), bevel=0.01)
    step = (h - 0.12) / rows
    for k in range(rows):
        z = 0.08 + k * step
        b.box(body, (0, 0, z), (w - 2 * thick, d - 0.02, thick), bevel=0.003)
        start = (-w / 2 + thick + 0.01, 0.0, z + thick / 2)
        book_row(b, covers, spec.rng, start, w - 2 * thick - 0.02, d * 0.8, step - 0.05, spec.number("fill"))
    return ()


@prop("back_bar")
def back_bar(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a bar's back wall: cupboards, a mirror, two shelves of bottles."""
    (w, d, h), body, glass = spec.size, spec.material("body"), spec.material("mirror")
    base = h * 0.42
    b.box(body, (0, 0, base / 2), (w - 0.04, d - 0.04, base), bevel=0.006)
    b.box(body, (0, 0, base - 0.02), (w, d, 0.04), bevel=0.01)
    doors = max(2, round(w / 0.6))
    for i in range(doors):
        panel_door(
            b, body, ((i - (doors - 1) / 2) * w / doors, -d / 2 + 0.015, base * 0.46), w / doors - 0.06, base * 0.76
        )
    b.box(body, (0, d / 2 - 0.02, (base + h) / 2), (w, 0.04, h - base))
    b.box(glass, (0, d / 2 - 0.045, base + (h - base) * 0.46), (w - 0.2, 0.012, (h - base) * 0.8))
    for x in (-1, 1):
        b.box(body, (x * (w / 2 - 0.05), d / 2 - 0.09, (base + h) / 2), (0.1, 0.14, h - base), bevel=0.012)
    b.box(body, (0, d / 2 - 0.1, h - 0.06), (w, 0.2, 0.12), bevel=0.02)
    kinds = [spec.material("bottle"), "glass_green", "glass", "glass_dark", "wood_red"]
    for level in range(3):
        z = base + level * (h - base) * 0.29
        if level:
            b.box(body, (0, d / 2 - 0.11, z - 0.012), (w - 0.18, 0.16, 0.024), bevel=0.004)
        x = -w / 2 + 0.16
        while x < w / 2 - 0.14:
            radius, tall = float(spec.rng.uniform(0.032, 0.043)), float(spec.rng.uniform(0.22, 0.31))
            kind = kinds[int(spec.rng.integers(len(kinds)))]
            b.lathe(kind, bottle_profile(radius, tall), origin=(x, d / 2 - 0.11, z), segments=10)
            x += float(spec.rng.uniform(0.085, 0.13))
    return ()


@prop("crate")
def crate(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a crate of boards with corner posts and a diagonal."""
    (w, d, h), body, frame = spec.size, spec.material("body"), spec.material("frame")
    boards = 5
    for k in range(boards):
        z = (k + 0.5) * h / boards
        b.box(body, (0, 0, z), (w * 0.94, d * 0.94, h / boards - 0.012), bevel=0.004)
    t = 0.09 * w
    for x in (-1, 1):
        for y in (-1, 1):
            b.box(frame, (x * (w - t) / 2, y * (d - t) / 2, h / 2), (t, t, h), bevel=0.006)
        for z in (t / 2, h - t / 2):
            b.box(frame, (x * (w - t * 0.7) / 2, 0, z), (t * 0.7, d - 2 * t, t), bevel=0.006)
            b.box(frame, (0, x * (d - t * 0.7) / 2, z), (w - 2 * t, t * 0.7, t), bevel=0.006)
        slope = math.degrees(math.atan2(h - 2 * t, w - 2 * t))
        center = (0, x * (d * 0.47 + 0.008), h / 2)
        b.box(frame, center, (math.hypot(w - 2 * t, h - 2 * t), 0.02, t * 0.9), bevel=0.004, rotation=(0, -slope, 0))
    return ()


@prop("cardboard_box")
def cardboard_box(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a closed, taped carton, or one that stands ``open``."""
    (w, d, h), body = spec.size, spec.material("body")
    if spec.flag("open"):
        open_carton(b, body, spec.size)
        return two_hands((-w / 2, 0, h * 0.4), (0, -1, -0.1), (1, 0, 0), (0.15, 0.15, 0.1))
    b.box(body, (0, 0, h / 2), (w, d, h), bevel=0.004)
    for y in (-1, 1):
        b.box(body, (0, y * (d / 4), h + 0.002), (w, d / 2 - 0.004, 0.004))
    b.box(material("cardboard", hex_color("#8f6e40")), (0, 0, h + 0.005), (w + 0.002, 0.05, 0.002))
    b.box(material("cardboard", hex_color("#8f6e40")), (0, 0, h * 0.85), (w + 0.004, 0.05, h * 0.3))
    return two_hands((-w / 2, 0, h * 0.4), (0, -1, -0.1), (1, 0, 0), (0.15, 0.15, 0.1))


@prop("barrel")
def barrel(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a barrel of staves with four hoops."""
    (w, _, h), body, hoop = spec.size, spec.material("body"), spec.material("hoop")
    r = w / 2 - 0.006
    levels = np.linspace(0, 1, 11)
    bulge = r * (0.84 + 0.16 * np.sin(np.pi * levels))
    outline = [(radius, z * h) for radius, z in zip(bulge, levels, strict=True)]
    b.lathe(body, [*outline, (bulge[-1] - 0.025, h), (bulge[-1] - 0.03, h - 0.03)], segments=28)
    for z in (0.06, 0.27, 0.73, 0.94):
        reach = r * (0.84 + 0.16 * math.sin(math.pi * z)) + 0.004
        profile = [(reach, (z - 0.022) * h), (reach + 0.004, z * h), (reach, (z + 0.022) * h)]
        b.lathe(hoop, profile, segments=28, caps=False)
    return ()


@prop("chest")
def chest(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a round-lidded chest with iron bands and a lock."""
    (w, d, h), body, trim = spec.size, spec.material("body"), spec.material("trim")
    base = h * 0.58
    if spec.flag("open"):
        tray(b, body, "wood_dark", (w, d, base))
    else:
        b.box(body, (0, 0, base / 2), (w, d, base), bevel=0.006)

    def arch(reach: float) -> list[tuple[float, float]]:
        return [
            ((d / 2 + reach) * math.cos(a), base + 0.008 + (h - base - 0.01 + reach) * math.sin(a))
            for a in np.linspace(0, math.pi, 15)
        ]

    raised = -78.0 if spec.flag("open") else 0.0
    with b.at((0, d / 2, base), (raised, 0, 0)), b.at((-w / 2, -d / 2, -base), (90, 0, 90)):
        b.extrude(body, arch(0.0), w)
        for at in (0.0, 0.22, 0.74, 0.96):
            b.extrude(trim, arch(0.008), w * 0.05, base=at * w - 0.003)
    for x in (-0.475, -0.255, 0.265, 0.485):
        for y in (-1, 1):
            b.box(trim, (x * w, y * d / 2, base / 2), (w * 0.05, 0.014, base + 0.01))
    b.box(trim, (0, 0, 0.025), (w + 0.012, d + 0.012, 0.05), bevel=0.004)
    b.box(trim, (0, -d / 2 - 0.012, base - 0.03), (0.11, 0.02, 0.14), bevel=0.006)
    b.cylinder("brass", (0, -d / 2 - 0.03, base - 0.05), (0, -d / 2, base - 0.05), 0.016)
    for x in (-1, 1):
        path = [
            (x * w / 2, -0.09, base * 0.6),
            (x * (w / 2 + 0.03), -0.07, base * 0.55),
            (x * (w / 2 + 0.03), 0.07, base * 0.55),
            (x * w / 2, 0.09, base * 0.6),
        ]
        b.tube(trim, path, 0.01)
    return (handle((0, -d / 2, base), (0, -0.4, 0.9), "lid"),)


@prop("coffin")
def coffin(b: MeshBuilder, spec: PropSpec) -> Anchors:
    """Build a six-sided coffin with a closed lid; the head is at +Y."""
    (w, d, h), body, brass = spec.size, spec.material("body"), spec.material("handle")
    plan = np.array([(-0.26, -0.5), (0.26, -0.5), (0.5, 0.24), (0.3, 0.5), (-0.3, 0.5), (-0.5, 0.24)]) * (
        w - 0.06,
        d - 0.04,
    )
    b.extrude(body, plan * 0.97, h - 0.1, base=0.0)
    b.extrude(body, plan * 1.02, 0.035, base=h - 0.1)
    b.extrude(body, plan * 0.98, 0.065, base=h - 0.065, taper=0.86)
    for x in (-1, 1):
        for y in (-0.28, 0.05, 0.33):
            side = x * float(np.interp(y, [-0.5, 0.24, 0.5], [0.26, 0.5, 0.3])) * (w - 0.06) * 0.97
            path = [
                (side + x * s, y * d + t, h * z)
                for s, t, z in ((0, -0.07, 0.45), (0.035, -0.06, 0.42), (0.035, 0.06, 0.42), (0, 0.07, 0.45))
            ]
            b.tube(brass, path, 0.009)
    return ()
