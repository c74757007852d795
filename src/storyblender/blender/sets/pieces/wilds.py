"""Set piece builders: nature: jungle plants, lily pads, grain, ice, snow, craters, coral, seaweed, wrecks, cliffs."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender import plants
from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.tags import Surface


@piece("jungle_tree", Surface.FOLIAGE)
def jungle_tree(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a tall jungle tree with buttress roots and a high crown. Parameters: variant."""
    plants.broad_tree(builder, finish("bark"), (finish("leaf"), finish("pine")), (9.0, 17.0), spec.rng)
    for turn in np.arange(0, 2 * math.pi, 1.25):
        a, wide = float(turn + spec.rng.uniform(-0.3, 0.3)), float(spec.rng.uniform(0.9, 1.5))
        x, y = math.cos(a), math.sin(a)
        side = np.array((-y, x, 0.0)) * 0.09
        foot, top, root = (
            np.array((x * wide, y * wide, -0.1)),
            np.array((x * 0.1, y * 0.1, 2.0)),
            np.array((0, 0, -0.1)),
        )
        builder.loft(finish("bark"), [np.stack([p - side, p + side]) for p in (foot, top)], closed=False)
        for points in ([foot + side, top + side, root + side], [root - side, top - side, foot - side]):
            builder.polygon(finish("bark"), points)
    for _ in range(4):
        a, reach = float(spec.rng.uniform(0, 6.28)), float(spec.rng.uniform(0.8, 2.6))
        x, y = reach * math.cos(a), reach * math.sin(a)
        low = float(spec.rng.uniform(0.6, 3.0))
        builder.tube(finish("leaf"), [(x * 0.6, y * 0.6, 11), (x, y, 6.0), (x * 1.05, y, low)], 0.03, segments=5)


@piece("great_leaf", Surface.NO_INK)
def great_leaf(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a broad-leaved plant, about two metres high. Parameters: variant."""
    skins = finish("leaf"), finish("hedge"), finish("pine")
    for index in range(8):
        a = index * 2.4 + float(spec.rng.uniform(-0.3, 0.3))
        high, reach, wide = (
            float(v) for v in (spec.rng.uniform(0.9, 2.0), spec.rng.uniform(0.5, 1.3), spec.rng.uniform(0.16, 0.3))
        )
        axis, side = np.array((math.cos(a), math.sin(a), 0.0)), np.array((-math.sin(a), math.cos(a), 0.0))
        spine = [axis * reach * t + (0, 0, high * (1.9 * t - 1.0 * t * t)) for t in np.linspace(0, 1, 6)]
        widths = (0.02, 0.35, 0.9, 1.0, 0.7, 0.02)
        rows = [
            np.stack([p - side * wide * w, p - np.array((0, 0, 0.05 * w)), p + side * wide * w])
            for p, w in zip(spine, widths, strict=True)
        ]
        skin = skins[index % 3]
        builder.loft(skin, rows, closed=False)
        builder.loft(skin, [row[::-1] for row in rows], closed=False)


@piece("lily_pads", Surface.NO_INK)
def lily_pads(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lay lily pads and a few flowers on water around the origin. Parameters: variant."""
    for _ in range(9):
        x, y, r = (
            float(v) for v in (spec.rng.uniform(-1, 1), spec.rng.uniform(-0.8, 0.8), spec.rng.uniform(0.1, 0.24))
        )
        cut = float(spec.rng.uniform(0, 6.28))
        ring = [(x, y, 0.02)] + [
            (x + r * math.cos(cut + t), y + r * math.sin(cut + t), 0.02) for t in np.linspace(0.3, 6.0, 14)
        ]
        builder.polygon(finish("leaf" if r > 0.16 else "hedge"), ring)
        if r > 0.2:
            builder.lathe(
                painted("#d8b8c4"), [(0.02, 0), (0.07, 0.05), (0.04, 0.08)], origin=(x + r * 0.5, y, 0.02), segments=7
            )


@piece("grain_patch", Surface.NO_INK)
def grain_patch(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build two by two metres of standing grain. Parameters: corn (tall, with leaves and cobs), variant."""
    corn, rng = spec.flag("corn"), spec.rng
    if corn:
        for x in np.arange(-0.85, 1.0, 0.45):
            for y in np.arange(-0.85, 1.0, 0.45):
                _corn(builder, (float(x + rng.uniform(-0.08, 0.08)), float(y + rng.uniform(-0.08, 0.08))), rng)
        return
    stalk, ear = finish("grain"), painted("#b98f3c")
    spots = rng.uniform(-1, 1, (230, 2))
    lean, tall = rng.uniform(-0.12, 0.12, (230, 2)), rng.uniform(0.75, 1.05, 230)
    for (x, y), (dx, dy), high in zip(spots, lean, tall, strict=True):
        turn = float(rng.uniform(0, 3.14))
        side = np.array((math.cos(turn), math.sin(turn), 0.0))
        foot, top = np.array((x, y, 0.0)), np.array((x + dx, y + dy, high))
        builder.add(stalk, [foot - side * 0.012, foot + side * 0.012, top], [(0, 1, 2), (2, 1, 0)])
        tip = top + np.array((dx * 0.4, dy * 0.4, 0.13))
        builder.add(
            ear, [top - side * 0.022 - (0, 0, 0.03), top + side * 0.022 - (0, 0, 0.03), tip], [(0, 1, 2), (2, 1, 0)]
        )


def _corn(builder: MeshBuilder, at: tuple[float, float], rng: np.random.Generator) -> None:
    """Add one stalk of corn."""
    x, y = at
    high, leaf = float(rng.uniform(1.8, 2.3)), finish("grass_lush")
    builder.cylinder(leaf, (x, y, 0), (x, y, high), 0.018, 0.008, segments=5, caps=False)
    for index in range(7):
        a, z = 2.5 * index + float(rng.uniform(-0.4, 0.4)), 0.3 + index * 0.24
        out, side = np.array((math.cos(a), math.sin(a), 0.0)), np.array((-math.sin(a), math.cos(a), 0.0)) * 0.04
        root = np.array((x, y, z))
        middle, tip = root + out * 0.3 + (0, 0, 0.22), root + out * 0.6 + (0, 0, 0.02)
        for points in ([root, middle - side, tip, middle + side], [root, middle + side, tip, middle - side]):
            builder.polygon(leaf, points)
    builder.sphere(painted("#c9a24a"), (x + 0.05, y, high * 0.55), 0.045, scale=(1, 1, 2.6), segments=7, rings=5)
    builder.cylinder(finish("grain"), (x, y, high), (x, y, high + 0.16), 0.03, 0.004, segments=5)


@piece("ice_cracks")
def ice_cracks(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Draw cracks and snow drifts on ice around the origin. Parameters: reach, seed."""
    reach, rng = spec.number("reach", 12), spec.rng
    for _ in range(14):
        x, y = (float(v) for v in rng.uniform(-reach, reach, 2))
        a, path = float(rng.uniform(0, 6.28)), [(x, y, 0.012)]
        for _ in range(6):
            a += float(rng.uniform(-0.7, 0.7))
            x, y = x + 0.9 * math.cos(a), y + 0.9 * math.sin(a)
            path.append((x, y, 0.012))
        builder.tube(painted("#e6eef2"), path, 0.02, segments=4)
    for _ in range(16):
        x, y, r = (float(v) for v in (*rng.uniform(-reach, reach, 2), rng.uniform(0.5, 1.6)))
        if math.hypot(x, y) > 2.2:
            profile = [(r, 0.0), (r * 0.7, 0.05), (0.01, 0.09)]
            builder.lathe(finish("snow"), profile, origin=(x, y, 0), segments=14, caps=False)


@piece("crater")
def crater(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the rim of a crater on level ground. Parameters: radius, material."""
    radius, skin = spec.number("radius", 3), spec.finish("material", "moon_dust")
    profile = [
        (radius * 1.5, 0.0), (radius * 1.12, radius * 0.1), (radius, radius * 0.15), (radius * 0.86, radius * 0.07),
        (radius * 0.6, 0.01), (0.01, 0.012),
    ]  # fmt: skip
    builder.lathe(skin, profile, segments=30, caps=False)


@piece("coral", Surface.NO_INK)
def coral(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a head of branching coral. Parameters: variant."""
    skin = painted(("#c2604a", "#c9924a", "#8a5a8f", "#c9c0a0")[int(spec.number("variant", 0)) % 4])
    for _ in range(11):
        a, lean, high = (
            float(v) for v in (spec.rng.uniform(0, 6.28), spec.rng.uniform(0.1, 0.5), spec.rng.uniform(0.35, 0.9))
        )
        x, y = math.cos(a) * lean, math.sin(a) * lean
        path = [(x * 0.2, y * 0.2, 0), (x * 0.7, y * 0.7, high * 0.55), (x, y, high)]
        builder.tube(skin, path, [0.07, 0.05, 0.03], segments=6)


@piece("seaweed", Surface.NO_INK)
def seaweed(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a clump of long seaweed. Parameters: variant."""
    skins = painted("#3f5a2c"), painted("#54702f"), painted("#2f4a33")
    for index in range(9):
        x, y = (float(v) for v in spec.rng.uniform(-0.35, 0.35, 2))
        high, phase = float(spec.rng.uniform(1.2, 3.4)), float(spec.rng.uniform(0, 6.28))
        rows = []
        for t in np.linspace(0, 1, 9):
            sway = 0.14 * math.sin(5 * t + phase)
            half = 0.07 * (1 - 0.85 * t)
            rows.append(np.array([(x + sway - half, y, high * t), (x + sway + half, y + 0.03, high * t)]))
        builder.loft(skins[index % 3], rows, closed=False)
        builder.loft(skins[index % 3], [row[::-1] for row in rows], closed=False)


@piece("lander")
def lander(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a space lander on four legs with a ladder at -Y."""
    foil, white, metal = finish("brass"), finish("paint_white"), finish("metal_grey")
    ring = [(1.9 * math.cos(t), 1.9 * math.sin(t)) for t in np.linspace(0, 2 * math.pi, 9)[:-1] + math.pi / 8]
    with builder.at((0, 0, 1.2)):
        builder.extrude(foil, ring, 1.4)
        builder.extrude(white, [(0.72 * x, 0.72 * y) for x, y in ring], 1.9, base=1.4, taper=0.62)
    for a in np.arange(math.pi / 4, 2 * math.pi, math.pi / 2):
        x, y = math.cos(a), math.sin(a)
        builder.tube(metal, [(x * 1.8, y * 1.8, 2.2), (x * 2.9, y * 2.9, 0.12)], 0.07)
        builder.tube(metal, [(x * 1.7, y * 1.7, 1.3), (x * 2.6, y * 2.6, 0.6)], 0.05)
        builder.cylinder(foil, (x * 2.9, y * 2.9, 0.0), (x * 2.9, y * 2.9, 0.1), 0.42, segments=16)
    builder.lathe(metal, [(0.75, 0.35), (0.4, 1.2)], segments=18, caps=False)
    for side in (-0.25, 0.25):
        builder.cylinder(metal, (side, -2.2, 0.1), (side, -1.85, 2.9), 0.03, segments=6)
    for z in np.arange(0.4, 2.8, 0.3):
        builder.cylinder(
            metal, (-0.25, -2.2 + 0.125 * z, float(z)), (0.25, -2.2 + 0.125 * z, float(z)), 0.02, segments=6
        )
    builder.box(finish("paint_black"), (0, -1.3, 3.5), (0.9, 0.3, 1.1), rotation=(14, 0, 0))
    profile = [(0.7, 0), (0.55, 0.12), (0.05, 0.2)]
    builder.lathe(white, profile, origin=(0.7, 0.2, 4.6), axis=(0.4, -0.2, 1), segments=16)


@piece("snow_drift")
def snow_drift(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a low drift of snow. Parameters: radius, variant."""
    radius, t = spec.number("radius", 1.8), np.linspace(0, 2 * math.pi, 19)[:-1]
    long, phase = float(spec.rng.uniform(1.2, 1.8)), float(spec.rng.uniform(0, 6))
    rings = []
    for share, z in ((1.0, -0.02), (0.85, 0.08), (0.6, 0.2), (0.3, 0.27), (0.02, 0.29)):
        r = radius * share * (1 + 0.12 * np.sin(2 * t + phase) + 0.07 * np.sin(5 * t))
        rings.append(np.c_[r * long * np.cos(t) + 0.25 * (1 - share) * radius, r * np.sin(t), np.full(18, z * radius)])
    builder.loft(finish("snow"), rings, caps=False)


@piece("snow_rock")
def snow_rock(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a boulder with a cap of snow. Parameters: variant."""
    plants.boulder(builder, finish("rock"), (0.6, 0.5, 0.45), spec.rng)
    builder.cushion(finish("snow"), (0, 0, 0.3), (1.12, 0.95, 0.4), softness=0.7)


@piece("grey_rock")
def grey_rock(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bare boulder. Parameters: variant."""
    plants.boulder(builder, finish("rock"), (0.6, 0.5, 0.4), spec.rng)


@piece("snow_pine", Surface.FOLIAGE)
def snow_pine(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a conifer laden with snow. Parameters: variant."""
    height = (14.0, 17.0, 12.0)[int(spec.number("variant", 0)) % 3]
    plants.conifer(builder, finish("bark_dark"), finish("leaf_snow"), (0.41 * height, height), spec.rng, 0.12)


@piece("bare_tree", Surface.SET)
def bare_tree(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a dead tree hung with moss. Parameters: variant."""
    bark, moss = finish("bark_dark"), finish("grass_lush")
    line = [(0, 0, -0.2), (0.1, 0, 1.6), (-0.1, 0.1, 3.4), (0.1, 0.1, 5.0)]
    builder.tube(bark, line, [0.42, 0.3, 0.22, 0.1], segments=8)
    for index in range(9):
        a, z = 2.4 * index, 1.9 + 0.34 * index
        long = 2.4 - 0.16 * index
        x, y = math.cos(a), math.sin(a)
        path = [
            (0, 0.05, z),
            (x * long * 0.5, y * long * 0.5, z + 0.6),
            (x * long, y * long, z + 0.75 + 0.2 * (index % 3)),
        ]
        builder.tube(bark, path, [0.12, 0.07, 0.02], segments=6)
        for share in (0.45, 0.7, 0.92):
            px, py, pz = x * long * share, y * long * share, z + 0.62
            drop = float(spec.rng.uniform(0.4, 1.2))
            points = [(px + x, py, pz - drop * z) for x, z in ((-0.1, 0), (0.1, 0), (0.03, 1), (-0.03, 0.8))]
            builder.polygon(moss, points)
            builder.polygon(moss, points[::-1])


@piece("ice_hole")
def ice_hole(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a fishing hole in the ice with slush around it."""
    builder.lathe(finish("water_deep"), [(0.36, 0.006), (0.001, 0.006)], segments=18, caps=False)
    builder.lathe(finish("snow"), [(0.34, 0.0), (0.38, 0.07), (0.5, 0.05), (0.62, 0.0)], segments=18, caps=False)


@piece("bubbles", Surface.NO_INK)
def bubbles(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a column of bubbles that rises from the ground."""
    for z in np.arange(0.4, 4.5, 0.24):
        x, y = (float(v) for v in spec.rng.uniform(-0.12, 0.12, 2))
        builder.sphere(finish("pane_cool"), (x, y, float(z)), float(spec.rng.uniform(0.015, 0.05)), segments=8, rings=5)


@piece("wreck_ribs")
def wreck_ribs(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the ribs and keel of a wooden wreck that lies along x."""
    wood = finish("boards_grey")
    builder.box(wood, (0, 0, 0.15), (7.5, 0.4, 0.5))
    for index, x in enumerate(np.linspace(-3.2, 3.2, 8)):
        wide = 1.7 * math.cos(0.32 * float(x) / 1.1) + 0.3
        for side in (-1, 1):
            cut = 3 if (index * 3 + side) % 4 == 0 else 5
            path = [(float(x), 0, 0.3), (float(x), side * wide * 0.7, 0.5), (float(x), side * wide, 1.5),
                    (float(x), side * wide * 1.02, 2.5), (float(x), side * wide * 0.95, 3.4)][:cut]  # fmt: skip
            builder.tube(wood, path, 0.13, segments=5)
    for z, side in ((1.0, 1), (1.3, 1), (1.6, 1), (1.0, -1)):
        builder.box(wood, (-0.6, side * 1.75, z), (4.6, 0.06, 0.26), rotation=(0, 0, side * 2))
    builder.cylinder(wood, (0.8, 0.1, 0.3), (2.0, 0.6, 4.6), 0.16, 0.1, segments=8)


@piece("bank_edge")
def bank_edge(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the low bank of a lake along x; water lies at +Y. Parameters: length."""
    half = spec.number("length", 90) / 2
    xs = np.linspace(-half, half, int(half * 1.6))
    top = np.c_[xs, 0.06 * np.sin(1.7 * xs), np.full(len(xs), 0.004)]
    foot = np.c_[xs, 0.5 + 0.22 * np.sin(0.9 * xs) + 0.1 * np.sin(2.3 * xs), np.full(len(xs), -0.4)]
    builder.loft(finish("mud"), [top, foot], closed=False)
    builder.loft(finish("mud"), [foot, top], closed=False)


@piece("cliff_edge")
def cliff_edge(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the edge of a cliff along x and the rock face below it; the drop lies at +Y. Parameters: length."""
    half = spec.number("length", 90) / 2
    xs, rows = np.linspace(-half, half, int(half * 2)), []
    for depth, out in ((0.012, 0.0), (-0.35, 0.5), (-1.6, 0.7), (-4.0, 1.6), (-9.0, 2.4), (-26.0, 4.0)):
        wave = out + 0.45 * np.sin(1.1 * xs + depth) + 0.25 * np.sin(2.9 * xs - depth)
        rows.append(np.c_[xs, wave if depth < 0 else -0.05 + 0 * xs, np.full(len(xs), depth)])
    builder.loft(finish("rock"), rows, closed=False)
    builder.loft(finish("rock"), rows[::-1], closed=False)


@piece("jetty_posts")
def jetty_posts(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the posts and edge beams of a jetty along y, centred on the origin. Parameters: length, width."""
    half, wide, wood = spec.number("length", 6) / 2, spec.number("width", 1.5) / 2, finish("wood_gray")
    for x in (-wide, wide):
        builder.box(wood, (x, 0, -0.03), (0.1, 2 * half, 0.16))
        for y in np.linspace(-half + 0.2, half, 4):
            builder.cylinder(wood, (x, float(y), -1.2), (x, float(y), 0.5 if y > 0 else 0.1), 0.08, segments=8)
    builder.box(wood, (0, half, -0.03), (2 * wide, 0.1, 0.16))


@piece("signpost")
def signpost(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a wooden signpost with two arms."""
    wood = finish("wood_gray")
    builder.box(wood, (0, 0, 1.1), (0.12, 0.12, 2.2))
    for z, turn in ((1.95, 12), (1.65, 160)):
        with builder.at((0, -0.07, z), (0, 0, turn)):
            builder.box(finish("wood_light"), (0.5, 0, 0), (0.95, 0.04, 0.2))
            for x in (0.25, 0.45, 0.62):
                builder.box(finish("paint_black"), (x, -0.025, 0), (0.12, 0.006, 0.06))


@piece("scarecrow")
def scarecrow(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a scarecrow that faces -Y."""
    coat, straw = painted("#5a4a3a"), finish("thatch")
    builder.cylinder(finish("wood_gray"), (0, 0, 0), (0, 0, 2.0), 0.04, segments=6)
    builder.cylinder(finish("wood_gray"), (-0.8, 0, 1.5), (0.8, 0, 1.5), 0.03, segments=6)
    builder.rounded_box(coat, (0, 0, 1.2), (0.5, 0.26, 0.75), 0.1)
    for side in (-1, 1):
        builder.cylinder(coat, (side * 0.2, 0, 1.48), (side * 0.68, 0, 1.44), 0.1, 0.12, segments=8)
        for k in range(5):
            builder.cylinder(
                straw, (side * 0.68, 0, 1.44), (side * 0.86, 0.04 * (k - 2), 1.36 + 0.03 * k), 0.01, segments=3
            )
    builder.sphere(finish("canvas"), (0, 0, 1.75), 0.15, segments=12, rings=8)
    for x in (-0.05, 0.05):
        builder.sphere(finish("paint_black"), (x, -0.14, 1.79), 0.02, segments=6, rings=4)
    builder.lathe(
        painted("#4a3826"), [(0.32, 0), (0.3, 0.02), (0.15, 0.04), (0.08, 0.24)], origin=(0, 0, 1.86), segments=14
    )
