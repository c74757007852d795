"""Set piece builders: parts of docks, ships and airfields: quays, bollards, hulls, masts, hangars, towers."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("quay_edge")
def quay_edge(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the edge of a quay along x; water lies at +Y. Parameters: length, drop, material."""
    length, drop, skin = spec.number("length", 60), spec.number("drop", 1.5), spec.finish("material", "concrete_dark")
    builder.box(skin, (0, 0.05, -drop / 2), (length, 0.1, drop))
    builder.box(finish("wood_dark"), (0, -0.12, 0.07), (length, 0.24, 0.14), bevel=0.02)
    for x in np.arange(-length / 2 + 1, length / 2, 2.0):
        if abs(x) < 30:
            builder.cylinder(finish("wood_dark"), (float(x), 0.06, -drop), (float(x), 0.06, 0.35), 0.09, segments=10)


@piece("boom")
def boom(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lay timber afloat along x, as it keeps ships off a quay. Parameters: length."""
    length = spec.number("length", 10)
    for index, x in enumerate(np.arange(-length / 2 + 1.2, length / 2 - 1.0, 2.4)):
        middle, off = float(x), 0.03 * (index % 3)
        builder.cylinder(finish("wood_gray"), (middle - 1.1, off, 0.0), (middle + 1.1, off, 0.0), 0.11, segments=8)


@piece("bollard")
def bollard(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an iron bollard with a turn of rope."""
    profile = [(0.2, 0), (0.16, 0.08), (0.13, 0.3), (0.13, 0.42), (0.21, 0.48), (0.2, 0.56), (0.05, 0.6)]
    builder.lathe(finish("iron"), profile)
    for z in (0.18, 0.24, 0.3):
        ring = [(0.16 * math.cos(a), 0.16 * math.sin(a), z) for a in np.linspace(0, 2 * math.pi, 16, endpoint=False)]
        builder.tube(finish("canvas"), ring, 0.03, segments=6, closed=True)


def _hull(builder: MeshBuilder, material: object, length: float, beam: float, height: float) -> None:
    """Loft a hull along -Y..+Y, keel under z = 0, deck at ``height``."""
    rings = []
    for t in np.linspace(-1, 1, 13):
        fullness = max(0.04, 1 - abs(t) ** 3.2)
        half = beam / 2 * fullness
        sheer = height + 0.9 * t * t
        profile = [
            (-half * 0.55, -0.8), (-half * 0.85, height * 0.25), (-half, sheer), (half, sheer),
            (half * 0.85, height * 0.25), (half * 0.55, -0.8),
        ]  # fmt: skip
        rings.append([(x, t * length / 2, z) for x, z in profile])
    builder.loft(material, rings)


@piece("moored_ship")
def moored_ship(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a small steamer along Y. Parameters: length."""
    length = spec.number("length", 24)
    _hull(builder, finish("metal_grey"), length, 6.0, 3.0)
    white = finish("paint_white")
    builder.box(white, (0, -length * 0.12, 4.4), (3.8, length * 0.3, 2.6), bevel=0.1)
    builder.box(white, (0, -length * 0.16, 6.4), (3.0, length * 0.16, 1.8), bevel=0.1)
    for index in range(5):
        for side in (-1, 1):
            builder.box(
                spec.pane("pane_warm"), (side * 1.92, -length * 0.22 + index * length * 0.05, 4.6), (0.04, 0.5, 0.6)
            )
    builder.cylinder(finish("paint_red"), (0, length * 0.02, 5.6), (0, length * 0.03, 9.0), 0.9, 0.8, segments=18)
    for y in (-length * 0.3, length * 0.28):
        builder.cylinder(finish("iron"), (0, y, 3), (0, y, 11), 0.1, 0.05, segments=8)


@piece("mast_ship")
def mast_ship(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a sailing ship along Y, sails furled. Parameters: length."""
    length, wood = spec.number("length", 24), finish("wood_dark")
    _hull(builder, finish("boards_dark"), length, 6.0, 2.8)
    for share, height in ((-0.28, 15.0), (0.02, 18.0), (0.3, 14.0)):
        y = length * share
        builder.cylinder(wood, (0, y, 2.5), (0, y, height), 0.2, 0.09, segments=9)
        for z in (height * 0.5, height * 0.72, height * 0.9):
            half = 4.2 * (1.2 - z / height)
            builder.cylinder(wood, (-half - 1, y, z), (half + 1, y, z), 0.09, segments=8)
            builder.cylinder(finish("canvas"), (-half - 0.6, y, z + 0.18), (half + 0.6, y, z + 0.18), 0.16, segments=8)
        for side in (-1, 1):
            for dy in (-1.2, 0.0, 1.2):
                builder.cylinder(wood, (side * 2.6, y + dy, 3.0), (0, y, height * 0.8), 0.025, segments=5)
    builder.cylinder(wood, (0, length / 2 - 0.5, 3.6), (0, length / 2 + 5, 5.6), 0.13, 0.06, segments=8)


@piece("mast")
def mast(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a mast with yards, a furled sail and shrouds. Parameters: height."""
    height, wood = spec.number("height", 12), finish("wood")
    builder.cylinder(wood, (0, 0, 0), (0, 0, height), 0.24, 0.12, segments=16)
    for z in (0.9, 1.1, 1.3):
        builder.lathe(finish("iron"), [(0.235, z), (0.255, z + 0.02), (0.255, z + 0.06), (0.235, z + 0.08)], caps=False)
    for z, half in ((height * 0.42, 4.6), (height * 0.72, 3.4)):
        builder.cylinder(wood, (-half, 0.25, z), (half, 0.25, z), 0.11, segments=10)
        builder.cylinder(
            finish("canvas"), (-half + 0.3, 0.25, z - 0.22), (half - 0.3, 0.25, z - 0.22), 0.2, segments=10
        )
    for x in (-1.2, -0.4, 0.4, 1.2):
        builder.cylinder(finish("wood_black"), (x, 1.8, 0.9), (0, 0, height * 0.7), 0.014, segments=5)
    for k in range(4):
        ring = [
            (0.32 * math.cos(a), 0.32 * math.sin(a), 0.06 + 0.05 * k)
            for a in np.linspace(0, 2 * math.pi, 18, endpoint=False)
        ]
        builder.tube(finish("canvas"), ring, 0.03, segments=6, closed=True)


@piece("funnel")
def funnel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a steamer's funnel. Parameters: height."""
    height = min(spec.number("height", 8), 8.0)
    builder.box(finish("paint_white"), (0, 0.4, 0.7), (2.6, 2.4, 1.4), bevel=0.08)
    builder.cylinder(finish("paint_red"), (0, 0.4, 1.4), (0, 0.6, height - 1.2), 0.8, segments=24)
    builder.cylinder(finish("paint_black"), (0, 0.6, height - 1.2), (0, 0.65, height), 0.8, segments=24)


@piece("deck_house")
def deck_house(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the cabin of a ship, its door at -Y. Parameters: width, depth, old."""
    width, depth, old = spec.number("width", 5), spec.number("depth", 5), spec.flag("old")
    skin = finish("log_wall" if old else "paint_white")
    front = -depth / 2
    builder.box(skin, (0, 0, 1.25), (width, depth, 2.5))
    builder.box(
        finish("wood_dark" if old else "paint_cream"), (0, -0.1, 2.56), (width + 0.4, depth + 0.4, 0.14), bevel=0.03
    )
    builder.box(finish("wood_dark"), (0, front - 0.02, 1.02), (0.9, 0.06, 2.0))
    builder.sphere(finish("brass"), (0.34, front - 0.08, 1.0), 0.035, segments=10, rings=6)
    for x in (-width * 0.32, width * 0.32):
        builder.box(spec.pane("pane_warm"), (x, front - 0.01, 1.5), (0.7, 0.04, 0.6))
        for dz in (-0.32, 0.0, 0.32):
            builder.box(finish("wood_dark"), (x, front - 0.03, 1.5 + dz), (0.8, 0.05, 0.05))
        for dx in (-0.37, 0.0, 0.37):
            builder.box(finish("wood_dark"), (x + dx, front - 0.03, 1.5), (0.05, 0.05, 0.68))
    for x in (-width / 2, width / 2):
        builder.box(finish("wood_dark"), (x, front, 1.25), (0.14, 0.14, 2.5))
    profile = [(0.03, 0.14), (0.1, 0.1), (0.1, -0.1), (0.05, -0.14)]
    builder.lathe(finish("iron"), profile, origin=(0.75, front - 0.2, 2.2))
    builder.sphere(finish("lamp_warm"), (0.75, front - 0.2, 2.2), 0.07, segments=10, rings=6)


@piece("hatch")
def hatch(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a cargo hatch with its grating."""
    builder.box(finish("wood_dark"), (0, 0, 0.16), (1.6, 1.2, 0.32), bevel=0.03)
    for x in np.linspace(-0.66, 0.66, 9):
        builder.box(finish("wood"), (float(x), 0, 0.34), (0.06, 1.02, 0.05))
    for y in np.linspace(-0.45, 0.45, 6):
        builder.box(finish("wood"), (0, float(y), 0.335), (1.4, 0.05, 0.05))


@piece("ships_wheel")
def ships_wheel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a ship's wheel on its stand, the helmsman at -Y."""
    wood, brass = finish("wood_red"), finish("brass")
    builder.box(wood, (0, 0.15, 0.5), (0.34, 0.34, 1.0), taper=0.75, bevel=0.02)
    ring = [
        (0.46 * math.cos(a), -0.06, 1.05 + 0.46 * math.sin(a)) for a in np.linspace(0, 2 * math.pi, 24, endpoint=False)
    ]
    builder.tube(wood, ring, 0.032, segments=8, closed=True)
    for k in range(8):
        c, s = math.cos(math.pi * k / 4), math.sin(math.pi * k / 4)
        builder.cylinder(wood, (0.06 * c, -0.06, 1.05 + 0.06 * s), (0.64 * c, -0.06, 1.05 + 0.64 * s), 0.02, segments=7)
    builder.cylinder(brass, (0, -0.12, 1.05), (0, 0.15, 1.05), 0.08, segments=14)


@piece("hangar")
def hangar(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a hangar with an open, lit front at -Y. Parameters: width, depth, height."""
    width, depth, height = spec.number("width", 34), spec.number("depth", 30), spec.number("height", 11)
    tin, half, eaves = finish("sheet_metal"), width / 2, height * 0.55
    y0, y1 = -depth / 2, depth / 2
    arc = [(half * math.cos(a), eaves + (height - eaves) * math.sin(a)) for a in np.linspace(0, math.pi, 15)]
    for (x0, z0), (x1, z1) in pairwise(arc):
        builder.quad(tin, (x1, y0, z1), (x0, y0, z0), (x0, y1, z0), (x1, y1, z1))
        builder.quad(tin, (x1, y0, eaves), (x0, y0, eaves), (x0, y0, z0), (x1, y0, z1))
    for side in (-1, 1):
        builder.box(tin, (side * half, 0, eaves / 2), (0.3, depth, eaves))
        builder.box(tin, (side * half * 0.8, y0, eaves / 2), (width * 0.2, 0.3, eaves))
    builder.box(spec.pane("pane_amber"), (0, y1 - 0.3, eaves / 2), (width - 0.6, 0.1, eaves))
    builder.box(finish("iron"), (0, y0 - 0.1, eaves + 0.1), (width * 0.62, 0.3, 0.4))
    for index in range(5):
        center = (-width * 0.24 + index * width * 0.12, y0 - 0.05, eaves + (height - eaves) * 0.4)
        builder.box(spec.pane("pane_warm"), center, (1.6, 0.12, 1.0))


@piece("control_tower")
def control_tower(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a control tower."""
    builder.box(finish("plaster_cream"), (0, 0, 6), (5, 5, 12))
    builder.box(spec.pane("pane_pale"), (0, 0, 13), (6, 6, 1.8))
    for x in (-3, -1, 1, 3):
        for y in (-3, 3):
            builder.box(finish("iron"), (x, y, 13), (0.18, 0.18, 1.9))
            builder.box(finish("iron"), (y, x, 13), (0.18, 0.18, 1.9))
    builder.box(finish("plaster_cream"), (0, 0, 12.0), (6.6, 6.6, 0.3))
    builder.box(finish("concrete_dark"), (0, 0, 14.1), (6.8, 6.8, 0.4))
    builder.cylinder(finish("iron"), (0, 0, 14), (0, 0, 19), 0.08, 0.03, segments=8)
    for floor in range(3):
        glass = spec.pane("pane_warm") if floor == 1 else finish("glass_dark")
        builder.box(glass, (0, -2.52, 3 + 3 * floor), (1.6, 0.05, 1.2))


@piece("runway_light")
def runway_light(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a runway light. Parameters: cool."""
    builder.cylinder(finish("iron"), (0, 0, 0), (0, 0, 0.25), 0.04, segments=8)
    builder.sphere(finish("lamp_cool" if spec.flag("cool") else "lamp_warm"), (0, 0, 0.32), 0.09, segments=10, rings=6)


@piece("flood_mast")
def flood_mast(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a mast with three floodlights that shine to -Y."""
    iron = finish("iron")
    builder.cylinder(iron, (0, 0, 0), (0, 0, 9), 0.13, 0.08, segments=10)
    builder.box(iron, (0, -0.1, 9), (1.6, 0.2, 0.5), bevel=0.03)
    for x in (-0.5, 0, 0.5):
        builder.lathe(iron, [(0.12, -0.15), (0.22, 0.05)], origin=(x, -0.22, 9), axis=(0, -1, -0.4))
        builder.lathe(finish("lamp_cool"), [(0.2, 0.04), (0.02, 0.06)], origin=(x, -0.22, 9), axis=(0, -1, -0.4))


@piece("air_stairs")
def air_stairs(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the wheeled stairs of an airliner; one climbs towards +Y."""
    iron, rail = finish("metal_grey"), finish("paint_white")
    for step in range(9):
        builder.box(iron, (0, -1.25 + 0.27 * step, 0.22 * (step + 1)), (0.95, 0.28, 0.05))
    builder.box(iron, (0, 1.45, 2.0), (1.0, 0.9, 0.06))
    for x in (-0.5, 0.5):
        builder.tube(iron, [(x, -1.5, 0.12), (x, 1.0, 1.95), (x, 1.9, 1.95)], 0.045)
        builder.tube(rail, [(x, -1.4, 1.05), (x, 1.0, 2.9), (x, 1.9, 2.9)], 0.026)
        for y, z in ((-1.4, 0.15), (-0.2, 1.05), (1.0, 1.95), (1.9, 1.95)):
            builder.cylinder(rail, (x, y, z), (x, y, z + 0.92), 0.02, segments=7)
        builder.cylinder(iron, (x, 1.0, 0.2), (x, 1.0, 1.95), 0.04, segments=8)
        builder.cylinder(iron, (x, -1.2, 0.3), (x, 1.0, 0.4), 0.04, segments=8)
        for y in (-1.0, 0.9):
            profile = [(0.1, -0.05), (0.2, -0.05), (0.2, 0.05), (0.1, 0.05)]
            builder.lathe(finish("rubber"), profile, origin=(x, y, 0.2), axis=(1, 0, 0))


@piece("lighthouse")
def lighthouse(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a white lighthouse on a rock, with a red band, a gallery and its lantern."""
    white, red, iron = finish("limewash"), spec.paint("band", "#9c3328"), finish("iron")
    builder.lathe(finish("rock"), [(6.0, -1.0), (5.2, 0.6), (3.6, 1.6), (3.0, 1.8)], segments=11)
    for low, high, skin in ((1.6, 7.0, white), (7.0, 10.0, red), (10.0, 15.0, white)):
        radii = [2.6 - 0.065 * height for height in (low, high)]
        builder.cylinder(skin, (0, 0, low), (0, 0, high), radii[0], radii[1], segments=24)
    builder.cylinder(iron, (0, 0, 15.0), (0, 0, 15.25), 2.2, segments=24)
    builder.cylinder(spec.pane("pane_warm"), (0, 0, 15.2), (0, 0, 17.2), 1.25, segments=12)
    for angle in np.linspace(0, 2 * math.pi, 12, endpoint=False):
        x, y = math.cos(angle), math.sin(angle)
        builder.cylinder(iron, (1.28 * x, 1.28 * y, 15.2), (1.28 * x, 1.28 * y, 17.2), 0.06, segments=6)
        builder.cylinder(iron, (2.1 * x, 2.1 * y, 15.2), (2.1 * x, 2.1 * y, 16.2), 0.04, segments=6)
    rail = [(2.1 * math.cos(a), 2.1 * math.sin(a), 16.2) for a in np.linspace(0, 2 * math.pi, 24, endpoint=False)]
    builder.tube(iron, rail, 0.05, segments=6, closed=True)
    builder.lathe(red, [(1.6, 17.2), (1.2, 17.8), (0.3, 18.5), (0.2, 18.9), (0.02, 19.1)], segments=20)
    builder.box(finish("wood_dark"), (0, -2.5, 2.7), (1.0, 0.3, 2.0))
    for height in (6.0, 11.5):
        builder.box(finish("glass_dark"), (0, -(2.6 - 0.065 * height), height), (0.6, 0.3, 1.0))


@piece("great_lens")
def great_lens(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the lamp of a lighthouse: rings of glass in a brass cage on an iron drum."""
    iron, brass = finish("iron"), finish("brass")
    builder.lathe(iron, [(0.62, 0), (0.62, 0.1), (0.42, 0.16), (0.42, 0.8), (0.6, 0.86), (0.6, 0.94)], segments=24)
    for height in np.linspace(1.0, 2.05, 8):
        radius = 0.5 - 0.55 * (height - 1.5) ** 2
        ring = [(radius - 0.05, -0.055), (radius, -0.05), (radius + 0.05, 0.0), (radius, 0.05), (radius - 0.05, 0.055)]
        builder.lathe(finish("glass"), ring, origin=(0, 0, float(height)), segments=24, caps=False)
    for angle in np.linspace(0, 2 * math.pi, 8, endpoint=False):
        post = [((0.57 - 0.55 * (z - 1.5) ** 2) * math.cos(angle), (0.57 - 0.55 * (z - 1.5) ** 2) * math.sin(angle), z)
                for z in np.linspace(0.92, 2.12, 9)]  # fmt: skip
        builder.tube(brass, post, 0.018, segments=6)
    builder.lathe(brass, [(0.38, 2.1), (0.4, 2.16), (0.2, 2.32), (0.05, 2.4), (0.04, 2.5)], segments=24)


@piece("harbour_crane")
def harbour_crane(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a dockside crane on a portal, its jib raised to -Y."""
    steel = finish("metal_grey")
    for x in (-2.2, 2.2):
        for y in (-2.2, 2.2):
            builder.box(steel, (x, y, 4.0), (0.5, 0.5, 8.0))
    builder.box(steel, (0, 0, 8.2), (5.2, 5.2, 0.6))
    builder.box(steel, (0, 0.8, 10.0), (2.8, 4.2, 3.0))
    jib, back = np.array([0.0, -13.0, 22.0]), np.array([0.0, 1.2, 17.0])
    for x in (-0.9, 0.9):
        foot = np.array([x, -1.0, 11.0])
        builder.cylinder(steel, foot, jib, 0.2, segments=6)
        builder.cylinder(steel, (x, 1.6, 11.0), back, 0.16, segments=6)
        for low, high in pairwise(np.linspace(0, 1, 9)):
            start, end = foot + low * (jib - foot), foot * (-1, 1, 1) + high * (jib - foot * (-1, 1, 1))
            builder.cylinder(steel, start, end, 0.08, segments=5)
    builder.cylinder(steel, back, jib, 0.08, segments=5)
    builder.cylinder(steel, jib, jib - (0, 0, 12.0), 0.06, segments=5)
