"""What grows and lies outdoors: trees, bushes, grass, rocks, cliffs, and the land itself. Planted by the dozen."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from storyblender.blender.mesh_builder import MaterialRef, MeshBuilder
from storyblender.blender.sets.finish import finish
from storyblender.blender.sets.pieces.registry import PieceSpec, piece
from storyblender.blender.tags import Surface
from storyblender.catalog.sets.terrain import ground_height

Floats = NDArray[np.float64]

_TURN = 2.399963
"""The golden angle: spreads branches evenly without repeating."""


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


def _blob(builder: MeshBuilder, leaf: MaterialRef, centre: ArrayLike, radius: float, rng: np.random.Generator) -> None:
    """Add a clump of leaves: an uneven ball with loose leaves on its skin."""
    middle, phase = np.asarray(centre, float), rng.uniform(0, 6.3, 3)
    rings = []
    for k in range(8):
        polar = math.pi * k / 7
        around = np.linspace(0, 2 * math.pi, 12, endpoint=False) + 0.3 * k
        swell = 1 + 0.13 * np.sin(3 * around + phase[0] + 2 * polar) + 0.08 * np.cos(5 * around + phase[1])
        flat = radius * swell * max(math.sin(polar), 0.02)
        height = np.full(12, -0.78 * radius * math.cos(polar))
        rings.append(middle + np.c_[flat * np.cos(around), flat * np.sin(around), height])
    builder.loft(leaf, rings)
    _leaves(builder, leaf, middle, radius, 16, rng)


def _leaves(
    builder: MeshBuilder, leaf: MaterialRef, middle: Floats, radius: float, count: int, rng: np.random.Generator
) -> None:
    """Scatter leaf sprays over a ball: they break its outline."""
    out = rng.normal(size=(count, 3))
    out[:, 2] *= 0.8
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    side = np.cross(out, rng.normal(size=(count, 3)))
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(side, out) * 0.45 + out
    size = radius * rng.uniform(0.16, 0.34, (count, 1))
    root = middle + out * radius * (0.86, 0.86, 0.7)
    a, b, c, d = (
        root - side * size * 0.3,
        root + side * size * 0.55 + up * size * 0.5,
        root + up * size * 1.3,
        root - side * size * 0.6 + up * size * 0.6,
    )
    vertices = np.stack([a, b, c, d], axis=1).reshape(-1, 3)
    builder.add(leaf, vertices, [(4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3) for i in range(count)])


def _trunk(height: float, lean: Floats, share: float) -> Floats:
    """Return the axis of a trunk at a share of its height."""
    return np.array([lean[0] * share * share, lean[1] * share * share, share * height])


def _trunk_rings(height: float, radius: float, lean: Floats, upto: float, rng: np.random.Generator) -> list[Floats]:
    around = np.linspace(0, 2 * math.pi, 12, endpoint=False)
    phase = rng.uniform(0, 6.3)
    rings = []
    for share in np.linspace(-0.02, upto, 9):
        flare = 1 + 0.7 * math.exp(-max(share, 0) * 26) * (1 + 0.25 * np.sin(5 * around + phase))
        girth = radius * (1 - 0.72 * max(share, 0)) * flare * (1 + 0.05 * np.sin(3 * around + 9 * share + phase))
        axis = _trunk(height, lean, max(share, 0)) + np.array((0, 0, min(share, 0) * height))
        rings.append(axis + np.c_[girth * np.cos(around), girth * np.sin(around), np.zeros(12)])
    return rings


@piece("broad_tree", Surface.FOLIAGE)
def broad_tree(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a broad-leaved tree, 9 to 12 m. Parameters: variant."""
    rng, variant = spec.rng, int(spec.number("variant", 0))
    height = (10.5, 12.0, 9.0)[variant % 3]
    bark = finish(("bark", "bark_dark", "bark")[variant % 3])
    leaf, shade = finish(("leaf", "leaf_yellow", "hedge")[variant % 3]), finish("hedge")
    lean = rng.uniform(-0.8, 0.8, 2)
    radius = height * 0.026
    builder.loft(bark, _trunk_rings(height, radius, lean, 0.78, rng))
    for index in range(11):
        share = 0.36 + 0.5 * index / 11
        angle = index * _TURN + rng.uniform(-0.3, 0.3)
        foot = _trunk(height, lean, share)
        reach = height * (0.30 - 0.16 * abs(share - 0.5)) * rng.uniform(0.8, 1.1)
        tip = foot + reach * np.array([math.cos(angle), math.sin(angle), rng.uniform(0.25, 0.6)])
        middle = (foot + tip) / 2 + np.array((0, 0, 0.12 * reach))
        builder.tube(bark, [foot, middle, tip], [radius * 0.42, radius * 0.28, radius * 0.12], segments=6)
        for spot, size in ((tip, 1.0), (middle + np.array((0, 0, 0.5)), 0.7)):
            jitter = rng.uniform(-0.4, 0.4, 3)
            _blob(
                builder,
                leaf if rng.random() < 0.7 else shade,
                spot + jitter,
                height * rng.uniform(0.085, 0.125) * size,
                rng,
            )
    for _ in range(5):
        spot = _trunk(height, lean, 0.92) + rng.uniform(-1, 1, 3) * (height * 0.1, height * 0.1, height * 0.06)
        _blob(builder, leaf, spot, height * rng.uniform(0.1, 0.13), rng)


@piece("pine_tree", Surface.FOLIAGE)
def pine_tree(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a conifer, 12 to 17 m: whorls of drooping boughs. Parameters: variant."""
    rng, variant = spec.rng, int(spec.number("variant", 0))
    height, needles = (14.0, 17.0, 12.0)[variant % 3], finish("pine")
    lean = rng.uniform(-0.25, 0.25, 2)
    builder.loft(finish("bark_dark"), _trunk_rings(height, height * 0.017, lean, 0.95, rng))
    start = (0.16, 0.26, 0.1)[variant % 3]
    whorls = 15
    for index in range(whorls):
        share = start + (0.97 - start) * (index / whorls) ** 0.92
        reach = height * 0.19 * (1 - share) ** 0.85 + 0.18
        middle = _trunk(height, lean, share)
        points = 18
        around = np.linspace(0, 2 * math.pi, points, endpoint=False) + rng.uniform(0, 1)
        tips = np.where(np.arange(points) % 2 == 0, 1.0, 0.52) * rng.uniform(0.82, 1.12, points)
        rings = []
        for out, rise in ((1.0, -0.30), (0.62, 0.02), (0.1, 0.34)):
            flat = reach * out * (tips if out > 0.3 else np.ones(points))
            z = reach * rise * (np.where(np.arange(points) % 2 == 0, 1.0, 0.45) if out == 1.0 else np.ones(points))
            rings.append(middle + np.c_[flat * np.cos(around), flat * np.sin(around), z])
        builder.loft(needles, rings, caps=False)
    top = _trunk(height, lean, 0.95)
    builder.cylinder(needles, top, top + np.array((0, 0, height * 0.06)), 0.14, 0.02, segments=7)


@piece("palm_tree", Surface.FOLIAGE)
def palm_tree(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a palm with a bent trunk. Parameters: variant."""
    rng = spec.rng
    height, bend = rng.uniform(6.0, 8.0), rng.uniform(0.6, 1.8)
    path = [(bend * share**1.8, 0, height * share) for share in np.linspace(0, 1, 10)]
    builder.tube(finish("bark"), path, [0.26 - 0.13 * share for share in np.linspace(0, 1, 10)], segments=10)
    head, leaf = np.array(path[-1]), finish("leaf")
    for index in range(15):
        angle, droop, length = index * _TURN, rng.uniform(0.5, 1.5), rng.uniform(2.0, 2.8)
        along, side = np.array([math.cos(angle), math.sin(angle), 0]), np.array([-math.sin(angle), math.cos(angle), 0])
        spine = [
            head + along * length * t + np.array((0, 0, 0.9 * t - droop * 1.5 * t * t)) for t in np.linspace(0, 1, 9)
        ]
        widths = (0.05, 0.2, 0.3, 0.34, 0.34, 0.3, 0.22, 0.12, 0.01)
        rows = [
            [p + side * w - (0, 0, 0.5 * w), p, p - side * w - (0, 0, 0.5 * w)]
            for p, w in zip(spine, widths, strict=True)
        ]
        builder.loft(leaf, rows, closed=False)
    for index in range(4):
        angle = index * 1.6
        builder.sphere(
            finish("wood"),
            head + np.array((0.2 * math.cos(angle), 0.2 * math.sin(angle), -0.2)),
            0.13,
            segments=10,
            rings=6,
        )


@piece("bush", Surface.FOLIAGE)
def bush(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bush about a metre high. Parameters: variant."""
    leaf = finish(("hedge", "leaf", "leaf_yellow")[int(spec.number("variant", 0)) % 3])
    for _ in range(8):
        spot = spec.rng.uniform(-1, 1, 3) * (0.5, 0.5, 0.18) + np.array((0, 0, 0.42))
        _blob(builder, leaf, spot, spec.rng.uniform(0.28, 0.44), spec.rng)


@piece("dry_bush", Surface.NO_INK)
def dry_bush(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a bare thorny bush. Parameters: variant."""
    for index in range(22):
        angle, rise = index * _TURN, spec.rng.uniform(0.3, 1.2)
        tip = np.array([math.cos(angle), math.sin(angle), rise]) * spec.rng.uniform(0.35, 0.6)
        bent = tip * 0.5 + np.array((0, 0, 0.1))
        builder.tube(finish("wood_gray"), [np.zeros(3), bent, tip], [0.014, 0.01, 0.004], segments=4)


def _blades(
    builder: MeshBuilder,
    material: MaterialRef,
    count: int,
    height: float,
    spread: float,
    width: float,
    rng: np.random.Generator,
) -> None:
    for _ in range(count):
        angle, off = rng.uniform(0, 2 * math.pi), rng.uniform(0, spread)
        root = np.array([off * math.cos(angle), off * math.sin(angle), 0.0])
        turn = rng.uniform(0, 2 * math.pi)
        along = np.array([math.cos(turn), math.sin(turn), 0])
        side = np.array([-along[1], along[0], 0]) * width
        tall = height * rng.uniform(0.55, 1.0)
        knee, tip = (
            root + along * tall * 0.12 + np.array((0, 0, tall * 0.6)),
            root + along * tall * 0.42 + np.array((0, 0, tall)),
        )
        builder.add(
            material, [root - side, root + side, knee + side * 0.7, knee - side * 0.7, tip], [(0, 1, 2, 3), (3, 2, 4)]
        )


@piece("grass_tuft", Surface.NO_INK)
def grass_tuft(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a tuft of grass. Parameters: variant."""
    key = ("hedge", "grass_dry", "leaf")[int(spec.number("variant", 0)) % 3]
    _blades(builder, finish(key), 16, 0.36, 0.14, 0.011, spec.rng)


@piece("reeds", Surface.NO_INK)
def reeds(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a stand of dune grass. Parameters: variant."""
    _blades(builder, finish("grass_dry"), 30, 0.85, 0.25, 0.012, spec.rng)


@piece("fern", Surface.NO_INK)
def fern(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a fern: arching fronds from one root. Parameters: variant."""
    for index in range(9):
        angle, length = index * _TURN, spec.rng.uniform(0.35, 0.6)
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
    _blades(builder, finish("leaf"), 14, 0.3, 0.18, 0.014, spec.rng)
    petal = finish(("paint_red", "paint_yellow", "paint_white")[int(spec.number("variant", 0)) % 3])
    for _ in range(9):
        x, y = spec.rng.uniform(-0.22, 0.22, 2)
        z = spec.rng.uniform(0.24, 0.38)
        builder.cylinder(finish("leaf"), (x * 0.6, y * 0.6, 0), (x, y, z), 0.005, segments=4)
        builder.lathe(
            petal, [(0.005, z - 0.015), (0.045, z + 0.02), (0.01, z + 0.01)], origin=(x, y, 0), segments=7, caps=False
        )


@piece("cactus", Surface.SET)
def cactus(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a columnar cactus with arms. Parameters: variant."""
    green, height = finish("hedge"), spec.rng.uniform(2.2, 3.6)
    builder.tube(
        green,
        [(0, 0, -0.1), (0, 0, height * 0.5), (0, 0, height - 0.1), (0, 0, height)],
        [0.2, 0.24, 0.2, 0.05],
        segments=12,
    )
    for index in range(int(spec.number("variant", 0)) % 3 + 1):
        angle = index * 2.6 + spec.rng.uniform(0, 1)
        c, s, z = math.cos(angle), math.sin(angle), height * spec.rng.uniform(0.35, 0.55)
        path = [
            (0.15 * c, 0.15 * s, z),
            (0.5 * c, 0.5 * s, z + 0.05),
            (0.62 * c, 0.62 * s, z + 0.3),
            (0.62 * c, 0.62 * s, z + 1.0),
            (0.62 * c, 0.62 * s, z + 1.1),
        ]
        builder.tube(green, path, [0.12, 0.14, 0.15, 0.13, 0.04], segments=10)


def _stone(builder: MeshBuilder, material: MaterialRef, size: ArrayLike, rng: np.random.Generator) -> None:
    """Add a boulder with flat faces: a ball pressed by random planes."""
    polar, around = np.meshgrid(
        np.linspace(0.02, math.pi - 0.02, 9), np.linspace(0, 2 * math.pi, 14, endpoint=False), indexing="ij"
    )
    ball = np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), -np.cos(polar)], axis=2)
    for normal in rng.normal(size=(11, 3)):
        normal = normal / np.linalg.norm(normal)
        over = np.maximum(ball @ normal - rng.uniform(0.55, 0.8), 0)
        ball = ball - over[..., None] * normal
    builder.loft(material, list(ball * np.asarray(size, float) + (0, 0, 0.5 * float(np.asarray(size)[2]))))


@piece("rock", Surface.SET)
def rock(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Build a boulder about 0.8 m wide. Parameters: variant."""
    wide = spec.rng.uniform(0.4, 0.52, 2)
    _stone(builder, finish("rock"), (wide[0], wide[1], spec.rng.uniform(0.28, 0.42)), spec.rng)


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
            _stone(builder, stone, rng.uniform(0.3, 0.9, 3), rng)


@piece("surf", Surface.NO_INK)
def surf(builder: MeshBuilder, spec: PieceSpec) -> None:
    """Lay lines of foam along x where water meets the sand. Parameters: length."""
    half, foam = spec.number("length", 100) / 2, finish("snow")
    xs = np.linspace(-half, half, 160)
    for row, (y, wide) in enumerate(((0.0, 0.34), (2.6, 0.2), (6.4, 0.16), (12.0, 0.14))):
        wave = y + 0.35 * np.sin(xs * 0.35 + row) + 0.18 * np.sin(xs * 0.9 + 2 * row)
        broad = wide * (0.55 + 0.45 * np.sin(xs * 0.6 + 1.3 * row) ** 2)
        z = np.full(len(xs), 0.03)
        builder.loft(foam, [np.c_[xs, wave - broad / 2, z], np.c_[xs, wave + broad / 2, z]], closed=False)
