"""Set piece builders: outdoors by the dozen: the trees, bushes, grass and rocks that a kit scatters, cliffs, surf."""

from __future__ import annotations

import math

import numpy as np

from storyblender.blender import plants
from storyblender.blender.mesh_builder import MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.tags import Surface
from storyblender.catalog.sets.terrain import ground_height


@piece("terrain")
def terrain(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Skin the rolling land: fine near the stage, coarse far off. Parameters: as ``Ground.land`` gives them."""
    share = np.linspace(-1, 1, 113)
    line = spec.number("reach", 90) * np.sign(share) * np.abs(share) ** 1.7
    x, y = np.meshgrid(line, line)
    z = ground_height(
        x,
        y,
        flat=spec.number("flat", 8),
        relief=spec.number("relief", 1),
        rise=spec.number("rise", 0),
        seed=int(spec.number("seed", 0)),
    )
    count = len(line)
    corners = np.arange(count * (count - 1)).reshape(count - 1, count)[:, :-1].ravel()
    faces = np.c_[corners, corners + 1, corners + count + 1, corners + count]
    builder.add(spec.finish("material", "grass"), np.stack([x, y, z], axis=2).reshape(-1, 3), faces.tolist())


@piece("broad_tree", Surface.FOLIAGE)
def broad_tree(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a broad-leaved tree, 9 to 12 m. Parameters: variant."""
    variant = int(spec.number("variant", 0)) % 3
    height = (10.5, 12.0, 9.0)[variant]
    leaves = spec.leaf(("leaf", "leaf_yellow", "hedge")[variant]), finish("hedge")
    bark = finish(("bark", "bark_dark", "bark")[variant])
    plants.broad_tree(builder, bark, leaves, (0.8 * height, height), spec.rng)


@piece("pine_tree", Surface.FOLIAGE)
def pine_tree(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a conifer, 12 to 17 m. Parameters: variant."""
    variant = int(spec.number("variant", 0)) % 3
    height, bare = ((14.0, 0.16), (17.0, 0.26), (12.0, 0.1))[variant]
    plants.conifer(builder, finish("bark_dark"), spec.leaf("pine"), (0.41 * height, height), spec.rng, bare)


@piece("palm_tree", Surface.FOLIAGE)
def palm_tree(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a palm, 7 to 9 m. Parameters: variant."""
    plants.palm(builder, finish("bark"), spec.leaf("leaf"), (5.4, spec.rng.uniform(6.8, 8.8)), spec.rng)


@piece("bush", Surface.FOLIAGE)
def bush(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bush about a metre high. Parameters: variant."""
    leaf = spec.leaf(("hedge", "leaf", "leaf_yellow")[int(spec.number("variant", 0)) % 3])
    plants.bush(builder, leaf, (1.6, 1.6, 1.0), spec.rng)


@piece("vine_row", Surface.FOLIAGE)
def vine_row(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a row of vines along x: posts, wires, a trunk and leaves each metre. Parameters: length, variant."""
    length, wood, rng = spec.number("length", 6), finish("wood_gray"), spec.rng
    leaf = spec.leaf(("leaf", "hedge", "leaf_yellow")[int(spec.number("variant", 0)) % 3])
    for x in (-length / 2, 0.0, length / 2):
        builder.cylinder(wood, (x, 0, -0.2), (x, 0, 1.65), 0.04, segments=8)
    for z in (0.75, 1.35):
        builder.cylinder(finish("iron"), (-length / 2, 0, z), (length / 2, 0, z), 0.004, segments=4)
    count = round(length / 1.0)
    for index in range(count):
        x = (index + 0.5) * length / count - length / 2
        sway = rng.uniform(-0.07, 0.07, 2)
        builder.tube(
            finish("bark_dark"), [(x, 0, -0.1), (x + sway[0], sway[1], 0.4), (x, 0, 0.8)], [0.035, 0.028, 0.02],
            segments=6,
        )  # fmt: skip
        with builder.at((x, 0, 0.55)):
            plants.bush(builder, leaf, (1.25, 0.6, rng.uniform(0.95, 1.15)), rng)


@piece("dry_bush", Surface.NO_INK)
def dry_bush(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bare thorny bush. Parameters: variant."""
    for index in range(22):
        angle, rise = index * plants.GOLDEN_TURN, spec.rng.uniform(0.3, 1.2)
        tip = np.array([math.cos(angle), math.sin(angle), rise]) * spec.rng.uniform(0.35, 0.6)
        bent = tip * 0.5 + np.array((0, 0, 0.1))
        builder.tube(finish("wood_gray"), [np.zeros(3), bent, tip], [0.014, 0.01, 0.004], segments=4)


@piece("grass_tuft", Surface.NO_INK)
def grass_tuft(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a tuft of grass. Parameters: variant."""
    key = ("hedge", "grass_dry", "leaf")[int(spec.number("variant", 0)) % 3]
    plants.blades(builder, finish(key), 16, (0.14, 0.36), 0.011, spec.rng)


@piece("reeds", Surface.NO_INK)
def reeds(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a stand of dune grass. Parameters: variant."""
    plants.blades(builder, finish("grass_dry"), 30, (0.25, 0.85), 0.012, spec.rng)


@piece("fern", Surface.NO_INK)
def fern(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a fern: arching fronds from one root. Parameters: variant."""
    for index in range(9):
        angle, length = index * plants.GOLDEN_TURN, spec.rng.uniform(0.35, 0.6)
        along, side = np.array([math.cos(angle), math.sin(angle), 0]), np.array([-math.sin(angle), math.cos(angle), 0])
        rows = []
        for t in np.linspace(0, 1, 7):
            spine = along * length * t + np.array((0, 0, 0.45 * t - 0.42 * t * t))
            wide = 0.09 * math.sin(math.pi * (0.1 + 0.9 * t)) + 0.004
            rows.append([spine + side * wide, spine + np.array((0, 0, 0.012)), spine - side * wide])
        builder.loft(finish("leaf"), rows, closed=False)


@piece("flowers", Surface.NO_INK)
def flowers(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a clump of flowers. Parameters: variant."""
    plants.blades(builder, finish("leaf"), 14, (0.18, 0.3), 0.014, spec.rng)
    petal = finish(("paint_red", "paint_yellow", "paint_white")[int(spec.number("variant", 0)) % 3])
    for _ in range(9):
        x, y = spec.rng.uniform(-0.22, 0.22, 2)
        z = spec.rng.uniform(0.24, 0.38)
        builder.cylinder(finish("leaf"), (x * 0.6, y * 0.6, 0), (x, y, z), 0.005, segments=4)
        profile = [(0.005, z - 0.015), (0.045, z + 0.02), (0.01, z + 0.01)]
        builder.lathe(petal, profile, origin=(x, y, 0), segments=7, caps=False)


@piece("cactus", Surface.SET)
def cactus(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a columnar cactus with one to three arms. Parameters: variant."""
    arms = int(spec.number("variant", 0)) % 3 + 1
    plants.cactus(builder, finish("hedge"), (1.5, spec.rng.uniform(2.2, 3.6)), arms, spec.rng)


@piece("rock", Surface.SET)
def rock(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a boulder about 0.8 m wide. Parameters: variant."""
    wide = spec.rng.uniform(0.4, 0.52, 2)
    plants.boulder(builder, finish("rock"), (wide[0], wide[1], spec.rng.uniform(0.28, 0.42)), spec.rng)


@piece("cliff", Surface.SET)
def cliff(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a rock face towards -Y, in ledges that step back. Parameters: width, height, seed."""
    width, height, rng = spec.number("width", 12), spec.number("height", 8), spec.rng
    stone, z = finish("rock"), -0.5
    while z < height:
        tall = float(rng.uniform(0.9, 1.9))
        share = max(z, 0) / height
        half, back = width / 2 * (1 - 0.45 * share), 5.0
        xs = np.linspace(-half, half, 11)
        front = -2.4 + 2.6 * share + rng.uniform(-0.7, 0.7, 11) + 1.8 * (np.abs(xs) / half) ** 3
        outline = [*zip(xs, front, strict=True), (half * 0.96, back), (-half * 0.96, back)]
        builder.extrude(stone, outline, tall, base=z, taper=0.95)
        z += tall * 0.96
    for _ in range(9):
        with builder.at((rng.uniform(-width * 0.5, width * 0.5), rng.uniform(-3.6, -2.2), 0)):
            plants.boulder(builder, stone, rng.uniform(0.3, 0.9, 3), rng)


@piece("surf", Surface.NO_INK)
def surf(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lay lines of foam along x where water meets the sand. Parameters: length."""
    half, foam = spec.number("length", 100) / 2, finish("snow")
    xs = np.linspace(-half, half, 160)
    for row, (y, wide) in enumerate(((0.0, 0.34), (2.6, 0.2), (6.4, 0.16), (12.0, 0.14))):
        wave = y + 0.35 * np.sin(xs * 0.35 + row) + 0.18 * np.sin(xs * 0.9 + 2 * row)
        broad = wide * (0.55 + 0.45 * np.sin(xs * 0.6 + 1.3 * row) ** 2)
        edges = [
            np.c_[xs, wave + side * broad / 2, np.full(len(xs), z)] for side, z in ((-1, 0.0), (0, 0.03), (1, 0.0))
        ]
        builder.loft(foam, edges, closed=False)  # its edges are under the water: no gap to see or to cast a shadow
