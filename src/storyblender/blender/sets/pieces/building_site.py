"""Set piece builders: building sites and fairs: concrete frames, scaffolds, diggers, cranes, Ferris wheels."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("concrete_frame")
def concrete_frame(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the concrete frame of a house under construction, its front at y = 0. Parameters: width, floors."""
    width, floors, skin = spec.number("width", 16), int(spec.number("floors", 4)), finish("concrete_light")
    for floor in range(floors):
        z = 3.2 * (floor + 1)
        builder.box(skin, (0, 4, z), (width, 8, 0.3))
        for x in np.linspace(-width / 2 + 0.4, width / 2 - 0.4, max(3, round(width / 4))):
            for y in (0.4, 4.0, 7.6):
                builder.box(skin, (float(x), y, z - 1.6), (0.4, 0.4, 3.0))
        if floor < floors - 1:
            builder.box(finish("brick_red"), (width * 0.24, 7.7, z - 1.0), (width * 0.46, 0.2, 1.9))
    for x in np.linspace(-width / 2 + 0.4, width / 2 - 0.4, max(3, round(width / 4))):
        for dx in (-0.1, 0.1):
            start, end = (float(x) + dx, 0.4, 3.2 * floors), (float(x) + dx, 0.4, 3.2 * floors + 1.0)
            builder.cylinder(finish("rust"), start, end, 0.02, segments=5)


@piece("scaffold")
def scaffold(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a scaffold along x with boards, rails and ladders. Parameters: length, floors."""
    length, floors, metal = spec.number("length", 12), int(spec.number("floors", 3)), finish("metal_grey")
    high = 2.1 * floors + 1.0
    for x in np.linspace(-length / 2, length / 2, max(2, round(length / 2.2) + 1)):
        for y in (-0.5, 0.5):
            builder.cylinder(metal, (float(x), y, 0), (float(x), y, high), 0.035, segments=6)
    for floor in range(1, floors + 1):
        z = 2.1 * floor
        builder.box(finish("planks"), (0, 0, z), (length, 0.95, 0.05))
        for up in (0.5, 1.0):
            builder.cylinder(metal, (-length / 2, -0.5, z + up), (length / 2, -0.5, z + up), 0.025, segments=6)
        builder.box(finish("planks"), (0, -0.5, z + 0.12), (length, 0.03, 0.2))
    for index in range(floors):
        x = -length * 0.3 + index * 1.3
        for side in (-0.18, 0.18):
            builder.cylinder(metal, (x + side, -0.2, 2.1 * index), (x + side, 0.3, 2.1 * index + 2.3), 0.02, segments=5)


@piece("digger")
def digger(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an excavator on tracks, its arm towards -X."""
    yellow, black = painted("#c9952a"), finish("paint_black")
    for y in (-1.0, 1.0):
        builder.rounded_box(black, (0, y, 0.42), (3.2, 0.55, 0.84), 0.35)
    builder.box(yellow, (0.3, 0, 1.25), (2.6, 2.2, 0.7), bevel=0.08)
    builder.box(yellow, (1.2, 0, 1.9), (0.9, 2.1, 0.8), bevel=0.08)
    builder.box(finish("glass_dark"), (-0.45, -0.6, 2.2), (1.2, 0.95, 1.3), bevel=0.05)
    builder.box(yellow, (-0.45, -0.6, 2.9), (1.3, 1.05, 0.12), bevel=0.02)
    arm = [(-0.8, 0.3, 1.5), (-2.4, 0.3, 3.7), (-4.2, 0.3, 3.2)]
    builder.tube(yellow, arm, 0.2, segments=6)
    builder.tube(yellow, [arm[-1], (-4.7, 0.3, 1.3)], 0.14, segments=6)
    builder.tube(finish("chrome"), [(-1.0, 0.3, 1.9), (-2.1, 0.3, 3.0)], 0.06, segments=6)
    with builder.at((-4.5, 0.3, 0.75), (0, 25, 0)):
        builder.box(black, (0, 0, 0), (0.9, 0.9, 0.7), bevel=0.08)


@piece("tower_crane")
def tower_crane(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a tower crane, its jib along +X. Parameters: height."""
    height, skin = spec.number("height", 26), painted("#c9952a")
    for x in (-0.7, 0.7):
        for y in (-0.7, 0.7):
            builder.box(skin, (x, y, height / 2), (0.16, 0.16, height))
    for index, z in enumerate(np.arange(0, height, 1.6)):
        a, b = (-0.7, 0.7) if index % 2 else (0.7, -0.7)
        builder.cylinder(skin, (a, -0.7, float(z)), (b, -0.7, float(z) + 1.6), 0.06, segments=4)
        builder.cylinder(skin, (-0.7, a, float(z)), (-0.7, b, float(z) + 1.6), 0.06, segments=4)
    for y in (-0.5, 0.5):
        builder.box(skin, (7, y, height + 0.2), (26, 0.14, 0.14))
    builder.box(skin, (7, 0, height + 1.2), (26, 0.12, 0.12))
    for x in np.arange(-6, 20, 1.8):
        builder.cylinder(skin, (float(x), -0.5, height + 0.2), (float(x) + 0.9, 0, height + 1.2), 0.05, segments=4)
        builder.cylinder(skin, (float(x) + 0.9, 0, height + 1.2), (float(x) + 1.8, 0.5, height + 0.2), 0.05, segments=4)
    builder.box(finish("concrete"), (-5, 0, height - 0.6), (2.2, 1.4, 1.4))
    builder.box(finish("paint_white"), (0.9, -0.9, height - 0.4), (1.1, 1.0, 1.3))
    builder.cylinder(finish("iron"), (13, 0, height), (13, 0, height * 0.45), 0.05, segments=4)
    builder.box(finish("concrete_light"), (13, 0, height * 0.45 - 0.4), (2.6, 1.2, 0.4))


@piece("heap")
def heap(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a heap of sand, earth or gravel. Parameters: radius, material, variant."""
    radius, skin = spec.number("radius", 1.6), spec.finish("material", "dirt")
    rings = []
    for share, z in ((1.0, 0.0), (0.8, 0.22), (0.5, 0.5), (0.2, 0.68), (0.02, 0.72)):
        t = np.linspace(0, 2 * math.pi, 17)[:-1]
        r = radius * share * (1 + 0.1 * np.sin(3 * t + 4 * share) + 0.06 * np.sin(7 * t))
        rings.append(np.c_[r * np.cos(t), r * np.sin(t), np.full(16, z * radius * 0.9)])
    builder.loft(skin, rings, caps=False)


@piece("site_cabin")
def site_cabin(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a site office container that faces -Y. Parameters: color."""
    skin = spec.paint("color", "#3f6a8a")
    builder.box(skin, (0, 0, 1.4), (6.0, 2.4, 2.6), bevel=0.03)
    for x in np.arange(-2.9, 3.0, 0.25):
        builder.box(skin, (float(x), -1.21, 1.4), (0.1, 0.04, 2.4))
    builder.box(finish("paint_white"), (-1.9, -1.24, 1.15), (0.95, 0.05, 2.05))
    for x in (0.0, 1.7):
        builder.box(finish("paint_white"), (x, -1.24, 1.65), (1.2, 0.05, 0.95))
        builder.box(spec.pane("pane_pale"), (x, -1.27, 1.65), (1.05, 0.02, 0.8))
    builder.box(finish("metal_grey"), (-1.9, -1.6, 0.12), (1.2, 0.7, 0.22))


@piece("ferris_wheel")
def ferris_wheel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a Ferris wheel with gondolas, its face to -Y. Parameters: radius."""
    radius, metal = spec.number("radius", 9), finish("paint_white")
    hub = radius + 2.2
    for y in (-0.9, 0.9):
        for x in (-1, 1):
            builder.cylinder(metal, (x * radius * 0.55, y * 1.4, 0), (0, y, hub), 0.2, segments=6)
        ring = [(radius * math.cos(t), y, hub + radius * math.sin(t)) for t in np.linspace(0, 2 * math.pi, 33)[:-1]]
        builder.tube(painted("#b8352a"), ring, 0.12, segments=5, closed=True)
    for index, t in enumerate(np.linspace(0, 2 * math.pi, 13)[:-1]):
        x, z = radius * math.cos(t), hub + radius * math.sin(t)
        for y in (-0.9, 0.9):
            builder.cylinder(metal, (0, y, hub), (x, y, z), 0.06, segments=4)
        builder.cylinder(metal, (x, -0.9, z), (x, 0.9, z), 0.07, segments=5)
        skin = painted(("#c9a227", "#2f6f8a", "#b8352a", "#3c7a4a")[index % 4])
        builder.rounded_box(skin, (x, 0, z - 1.15), (1.4, 1.3, 0.8), 0.15)
        builder.lathe(skin, [(0.85, 0.0), (0.05, 0.35)], origin=(x, 0, z - 0.35), segments=10)
        for dx in (-0.6, 0.6):
            builder.cylinder(metal, (x + dx, 0, z - 0.8), (x + dx, 0, z - 0.3), 0.04, segments=4)
        builder.sphere(spec.pane("pane_pale"), (x * 1.02, -1.05, hub + (z - hub) * 1.02), 0.14, segments=6, rings=4)


@piece("carousel")
def carousel(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a carousel with a striped roof, lamps and horses. Parameters: radius."""
    radius = spec.number("radius", 3.6)
    builder.lathe(painted("#7a2a2a"), [(radius, 0), (radius, 0.3), (0.3, 0.32)], segments=28, caps=False)
    builder.cylinder(painted("#c9a227"), (0, 0, 0.3), (0, 0, 4.4), 0.5, segments=16)
    for index, (a, b) in enumerate(zip(np.linspace(0, 6.2832, 25)[:-1], np.linspace(0, 6.2832, 25)[1:], strict=True)):
        skin = painted(("#b8352a", "#e0d6bd")[index % 2])
        p, q = ((radius * 1.08 * math.cos(t), radius * 1.08 * math.sin(t)) for t in (a, b))
        builder.polygon(skin, [(*p, 3.4), (*q, 3.4), (0, 0, 5.0)])
        builder.polygon(skin, [(0, 0, 4.98), (*q, 3.38), (*p, 3.38)])
        builder.quad(skin, (*p, 2.95), (*q, 2.95), (*q, 3.42), (*p, 3.42))
        builder.sphere(spec.pane("pane_pale"), (p[0] * 1.01, p[1] * 1.01, 2.98), 0.08, segments=6, rings=4)
    for index, t in enumerate(np.linspace(0, 2 * math.pi, 9)[:-1]):
        x, y, z = radius * 0.72 * math.cos(t), radius * 0.72 * math.sin(t), 1.1 + 0.25 * (index % 3)
        builder.cylinder(finish("brass"), (x, y, 0.3), (x, y, 3.5), 0.03, segments=6)
        skin = painted(("#e0d6bd", "#57463a", "#8a8f94", "#a8703f")[index % 4])
        with builder.at((x, y, z), (0, 0, math.degrees(t))):
            builder.cushion(skin, (0, 0, 0), (0.34, 1.05, 0.42), softness=0.6)
            builder.tube(skin, [(0, 0.42, 0.1), (0, 0.62, 0.5), (0, 0.82, 0.46)], [0.15, 0.11, 0.07], segments=7)
            for lx in (-0.1, 0.1):
                builder.tube(skin, [(lx, 0.35, -0.1), (lx, 0.6, -0.35)], 0.05, segments=5)
                builder.tube(skin, [(lx, -0.38, -0.1), (lx, -0.6, -0.4)], 0.05, segments=5)
            builder.box(painted("#b8352a"), (0, -0.05, 0.22), (0.3, 0.4, 0.08), bevel=0.02)


@piece("lamp_string")
def lamp_string(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a string of small lamps along x in a curve from z = 0. Parameters: length, sag, flags (pennants instead)."""
    length, sag = spec.number("length", 8), spec.number("sag", 0.5)
    share = np.linspace(0, 1, max(9, round(length / 0.45)))
    path = [(length * (t - 0.5), 0, -4 * sag * t * (1 - t)) for t in share]
    builder.tube(finish("iron"), path, 0.008, segments=3)
    for index, (x, _, z) in enumerate(path[1:-1]):
        if spec.flag("flags"):
            skin = painted(("#b8352a", "#e0d6bd", "#2f6f8a", "#c9a227")[index % 4])
            builder.add(skin, [(x - 0.13, 0, z), (x + 0.13, 0, z), (x, 0, z - 0.32)], [(0, 1, 2), (2, 1, 0)])
        else:
            builder.sphere(spec.pane("pane_pale"), (x, 0, z - 0.06), 0.05, segments=7, rings=5)


@piece("striped_tent")
def striped_tent(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a round striped tent with a pennant. Parameters: radius, height, color."""
    radius, height = spec.number("radius", 4), spec.number("height", 3)
    skins = spec.paint("color", "#b8352a"), finish("paint_cream")
    edges = np.linspace(0, 2 * math.pi, 25)
    for index in range(24):
        p, q = ((radius * math.cos(t), radius * math.sin(t)) for t in edges[index : index + 2])
        if not 17 <= index <= 18:  # leave the entrance at -Y open
            builder.quad(skins[index % 2], (*p, 0), (*q, 0), (*q, height), (*p, height))
        builder.polygon(
            skins[index % 2],
            [(p[0] * 1.05, p[1] * 1.05, height - 0.1), (q[0] * 1.05, q[1] * 1.05, height - 0.1), (0, 0, height * 1.9)],
        )
    builder.lathe(finish("plaster_soot"), [(radius * 0.9, 0), (radius * 0.9, height - 0.1)], segments=20, caps=False)
    builder.cylinder(finish("wood"), (0, 0, height * 1.85), (0, 0, height * 1.9 + 1.0), 0.05, segments=6)
    builder.add(skins[0], [(x, 0, 1.9 * height + z) for x, z in ((0, 1), (0.8, 0.8), (0, 0.6))], [(0, 1, 2), (2, 1, 0)])
