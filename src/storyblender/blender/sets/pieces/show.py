"""Set piece builders: boxing rings, circus pieces, grand stairs, horse stalls, round doors, roots."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish, painted
from storyblender.blender.sets.pieces.registry import PieceSpec, piece


@piece("boxing_ring")
def boxing_ring(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a boxing ring centred on the origin: posts, ropes and canvas. Parameters: size."""
    half = spec.number("size", 5.0) / 2
    builder.box(painted("#b8b4a4"), (0, 0, 0.012), (2 * half + 0.5, 2 * half + 0.5, 0.024))
    builder.lathe(painted("#33506b"), [(0.75, 0.026), (0.001, 0.026)], segments=24, caps=False)
    for x in (-half, half):
        for y in (-half, half):
            builder.cylinder(finish("metal_grey"), (x, y, 0), (x, y, 1.42), 0.06, segments=10)
            skin = painted("#a3241d" if x * y > 0 else "#33506b")
            inwards = 0.12 if x < 0 else -0.12, 0.12 if y < 0 else -0.12
            builder.rounded_box(skin, (x + inwards[0], y + inwards[1], 0.85), (0.2, 0.2, 1.0), 0.06)
    for index, z in enumerate((0.45, 0.8, 1.15)):
        skin = painted(("#a3241d", "#d9d5ca", "#33506b")[index])
        for a, b in (
            ((-half, -half), (half, -half)),
            ((half, -half), (half, half)),
            ((half, half), (-half, half)),
            ((-half, half), (-half, -half)),
        ):
            builder.cylinder(skin, (*a, z), (*b, z), 0.02, segments=6)


@piece("punch_bag")
def punch_bag(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a punching bag on chains from z = 0. Parameters: drop."""
    drop = spec.number("drop", 1.2)
    for x, y in ((-0.12, 0), (0.12, 0), (0, 0.12)):
        builder.cylinder(finish("iron"), (0, 0, 0), (x, y, -drop), 0.01, segments=5)
    builder.lathe(
        spec.paint("color", "#5c2a1c"),
        [(0.14, -drop), (0.18, -drop - 0.05), (0.19, -drop - 0.5), (0.18, -drop - 1.05), (0.12, -drop - 1.1)],
        segments=16,
    )
    for z in (0.2, 0.9):
        builder.lathe(
            finish("paint_black"), [(0.192, 0), (0.192, 0.05)], origin=(0, 0, -drop - z), segments=16, caps=False
        )


@piece("horse_stall")
def horse_stall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the front of a horse's stall along x with hay inside, its back at y = 1.8. Parameters: width."""
    width, wood = spec.number("width", 2.4), finish("boards")
    for x in (-width / 2, width / 2):
        builder.box(finish("wood_dark"), (x, 0, 1.2), (0.16, 0.16, 2.4))
        for z in np.arange(0.15, 1.6, 0.22):
            builder.box(wood, (x, 0.9, float(z)), (0.05, 1.8, 0.2))
    for z in np.arange(0.15, 1.25, 0.22):
        builder.box(wood, (0, 0, float(z)), (width, 0.05, 0.2))
    for x in (-width * 0.3, width * 0.3):
        builder.box(finish("wood_dark"), (x, -0.035, 0.65), (0.12, 0.03, 1.15))
    builder.box(finish("wood_dark"), (0, 0, 2.35), (width, 0.16, 0.16))
    builder.box(finish("iron"), (width * 0.3, -0.06, 0.8), (0.1, 0.03, 0.16))
    builder.cushion(finish("thatch"), (0, 1.4, 0.25), (width * 0.8, 0.8, 0.5), softness=0.8)


@piece("grand_stairs")
def grand_stairs(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build broad stairs that rise towards +Y from y = 0, with a carpet and balustrades. Parameters: width, height,
    run."""
    width, height, run = spec.number("width", 3.2), spec.number("height", 2.4), spec.number("run", 3.2)
    count = max(4, round(height / 0.17))
    for index in range(count):
        y, z = (index + 0.5) * run / count, (index + 1) * height / count
        builder.box(finish("marble"), (0, y, z / 2), (width, run / count + 0.02, z))
        builder.box(painted("#741a22"), (0, y - 0.01, z + 0.006), (width * 0.5, run / count + 0.02, 0.012))
        builder.box(
            painted("#741a22"),
            (0, y - run / count / 2 - 0.012, z - height / count / 2),
            (width * 0.5, 0.01, height / count),
        )
        for x in (-width / 2 + 0.1, width / 2 - 0.1):
            profile = [(0.03, 0), (0.055, 0.2), (0.025, 0.5), (0.04, 0.8)]
            builder.lathe(finish("wood_dark"), profile, origin=(x, y, z), segments=8)
    for x in (-width / 2 + 0.1, width / 2 - 0.1):
        builder.tube(finish("wood_dark"), [(x, 0.05, 1.0), (x, run, height + 0.86)], 0.06, segments=8)
        builder.box(finish("wood_dark"), (x, -0.05, 0.6), (0.22, 0.22, 1.2), bevel=0.02)
        builder.sphere(finish("brass"), (x, -0.05, 1.3), 0.12, segments=12, rings=8)


@piece("round_door")
def round_door(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a small round door on a wall at y = 0."""
    builder.cylinder(finish("wood_dark"), (0, 0.02, 0.85), (0, -0.1, 0.85), 0.95, segments=28)
    builder.cylinder(spec.paint("color", "#4a6b3a"), (0, -0.05, 0.85), (0, -0.14, 0.85), 0.82, segments=28)
    for x in (-0.4, -0.13, 0.13, 0.4):
        builder.box(finish("wood_dark"), (x, -0.143, 0.85), (0.015, 0.008, 1.3))
    builder.sphere(finish("brass"), (0, -0.18, 0.85), 0.06, segments=12, rings=8)


@piece("root_tangle")
def root_tangle(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang roots down from z = 0 around the origin. Parameters: reach, seed."""
    reach = spec.number("reach", 1.2)
    for _ in range(12):
        x, y, long = (float(v) for v in (*spec.rng.uniform(-reach, reach, 2), spec.rng.uniform(0.25, 0.9)))
        bend = float(spec.rng.uniform(-0.25, 0.25))
        path = [(x, y, 0.1), (x + bend * 0.5, y, -long * 0.5), (x + bend, y + 0.1, -long)]
        builder.tube(finish("bark_dark"), path, [0.06, 0.035, 0.01], segments=6)


@piece("ring_fence")
def ring_fence(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build the low red and gold wall around a circus ring, open at -Y. Parameters: radius."""
    radius = spec.number("radius", 4.4)
    edges = np.linspace(-math.pi / 2 + 0.3, 1.5 * math.pi - 0.3, 37)
    for index, (a, b) in enumerate(pairwise(edges)):
        t, skin = (a + b) / 2, painted(("#a3241d", "#c9a227")[index % 2])
        wide = radius * (b - a)
        center = (radius * math.cos(t), radius * math.sin(t), 0.22)
        builder.box(skin, center, (0.36, wide, 0.44), rotation=(0, 0, math.degrees(t)), bevel=0.02)


@piece("circus_seats")
def circus_seats(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build rows of benches with an audience in a half circle around the origin. Parameters: radius, rows."""
    radius, rows = spec.number("radius", 6), int(spec.number("rows", 4))
    coats = [painted(code) for code in ("#5a3a3a", "#3a4a5f", "#6b5a3a", "#44553f", "#7a6a6a", "#2f2f38")]
    faces = [painted(code) for code in ("#c99a7a", "#8a5a40", "#dcb294", "#a87454")]
    for row in range(rows):
        r, z = radius + 0.85 * row, 0.4 + 0.38 * row
        for t in np.linspace(0.25, math.pi - 0.25, 22 + 2 * row):
            x, y = r * math.cos(t), r * math.sin(t)
            builder.box(finish("planks"), (x, y, z / 2), (0.4, r * 0.14, z), rotation=(0, 0, math.degrees(t)))
            if spec.rng.random() < 0.75:
                builder.cushion(coats[int(spec.rng.integers(6))], (x, y, z + 0.32), (0.36, 0.42, 0.66), softness=0.6)
                builder.sphere(faces[int(spec.rng.integers(4))], (x, y, z + 0.8), 0.12, segments=8, rings=6)


@piece("tent_roof")
def tent_roof(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang the striped roof of a circus tent over the origin, from ``height`` up to its king poles. Parameters: radius,
    height, peak."""
    radius, height, peak = spec.number("radius", 9), spec.number("height", 4), spec.number("peak", 7)
    edges = np.linspace(0, 2 * math.pi, 33)
    for index, (a, b) in enumerate(pairwise(edges)):
        skin = painted(("#8f2a24", "#d8ccb0")[index % 2])
        p, q = ((radius * math.cos(t), radius * math.sin(t)) for t in (a, b))
        m, n = ((radius * 0.45 * math.cos(t), radius * 0.45 * math.sin(t)) for t in (a, b))
        mid = height + (peak - height) * 0.42
        builder.polygon(skin, [(*q, height), (*p, height), (*m, mid), (*n, mid)])
        builder.polygon(skin, [(*n, mid), (*m, mid), (0, 0, peak)])


@piece("trapeze")
def trapeze(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Hang a trapeze from z = 0. Parameters: drop."""
    drop = spec.number("drop", 2.2)
    for x in (-0.35, 0.35):
        builder.cylinder(finish("canvas"), (x, 0, 0), (x, 0, -drop), 0.012, segments=5)
    builder.cylinder(finish("metal_grey"), (-0.4, 0, -drop), (0.4, 0, -drop), 0.02, segments=8)


@piece("striped_stand")
def striped_stand(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a round painted pedestal for a circus animal."""
    for index, t in enumerate(np.linspace(0, 2 * math.pi, 13)[:-1]):
        a, b = t, t + 2 * math.pi / 12
        skin = painted(("#a3241d", "#c9a227")[index % 2])
        p, q = ((0.45 * math.cos(v), 0.45 * math.sin(v)) for v in (a, b))
        r, s = ((0.34 * math.cos(v), 0.34 * math.sin(v)) for v in (a, b))
        builder.quad(skin, (*p, 0), (*q, 0), (*s, 0.5), (*r, 0.5))
    builder.cylinder(painted("#33506b"), (0, 0, 0.5), (0, 0, 0.56), 0.38, segments=20)


@piece("great_idol")
def great_idol(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a large seated stone statue on a plinth that faces -Y."""
    stone, gold = finish("stone_light"), finish("gold")
    builder.box(finish("stone_sand"), (0, 0, 0.45), (2.1, 1.7, 0.9), bevel=0.04)
    builder.box(finish("stone_light"), (0, 0, 0.95), (2.3, 1.9, 0.12), bevel=0.02)
    builder.cushion(stone, (0, -0.15, 1.3), (1.8, 1.3, 0.6), softness=0.7)
    builder.cushion(stone, (0, 0.1, 2.0), (1.1, 0.7, 1.3), softness=0.6)
    for side in (-1, 1):
        path = [(side * 0.5, 0.05, 2.4), (side * 0.75, -0.1, 1.9), (side * 0.45, -0.55, 1.55), (side * 0.1, -0.6, 1.5)]
        builder.tube(stone, path, [0.19, 0.17, 0.14, 0.1])
    builder.cylinder(stone, (0, 0.05, 2.5), (0, 0.05, 2.8), 0.18, segments=14)
    builder.sphere(stone, (0, 0.0, 3.05), 0.36, scale=(0.85, 0.9, 1.1), segments=18, rings=12)
    builder.lathe(gold, [(0.36, 0), (0.4, 0.08), (0.2, 0.25), (0.03, 0.5)], origin=(0, 0.02, 3.28), segments=18)
    builder.lathe(gold, [(0.5, 0.0), (0.36, 0.05)], origin=(0, 0.05, 2.5), segments=20, caps=False)
    for x in (-0.12, 0.12):
        builder.box(finish("plaster_soot"), (x, -0.3, 3.1), (0.12, 0.06, 0.03))


@piece("earth_wall")
def earth_wall(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build an uneven wall of earth and stones along x, its back at y = 0. Parameters: length, height."""
    length, height = spec.number("length", 6), spec.number("height", 2.4)
    xs, zs = np.linspace(-length / 2, length / 2, int(length * 5)), np.linspace(0, height, 11)
    rows = []
    for z in zs:
        out = 0.16 + 0.09 * np.sin(2.1 * xs + 3 * z) + 0.05 * np.sin(5.3 * xs - 4 * z) + 0.5 * (z / height) ** 4
        rows.append(np.c_[xs, -out, np.full(len(xs), z)])
    builder.loft(finish("mud"), rows, closed=False)
    builder.loft(finish("mud"), rows[::-1], closed=False)
    for _ in range(14):
        x, z, size = (
            float(v)
            for v in (
                spec.rng.uniform(-length / 2, length / 2),
                spec.rng.uniform(0.1, height * 0.9),
                spec.rng.uniform(0.06, 0.16),
            )
        )
        builder.sphere(finish("stone"), (x, -0.24, z), size, scale=(1.2, 0.6, 0.8), segments=8, rings=5)
