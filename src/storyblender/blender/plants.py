"""Plants and rocks at any size in any material: sets plant them by the dozen, and they are props.

Origin on the ground, metres. All variation comes from the random generator, so one seed gives one plant.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from storyblender.blender.mesh_builder import Floats, MaterialRef, MeshBuilder
from storyblender.memory.base import Vec2, Vec3

GOLDEN_TURN = 2.399963
"""The golden angle: spreads branches evenly without repeating."""


def along_trunk(height: float, leans: ArrayLike, share: float) -> Floats:
    """Return the point (3,) of a trunk's axis at a share of its height, metres.

    Args:
        height: Metres.
        leans: x and y of its top relative to its foot, metres.
        share: 0 at the foot, 1 at the top.
    """
    return np.append(np.asarray(leans, float) * share * share, share * height)


def trunk(
    b: MeshBuilder, bark: MaterialRef, height: float, radius: float, leans: ArrayLike, rng: np.random.Generator
) -> None:
    """Add a trunk that flares into its roots, from below the ground up.

    Args:
        b: Takes the trunk.
        bark: Its material.
        height: Metres.
        radius: At the foot, without the flare, metres.
        leans: x and y of its top relative to its foot, metres.
        rng: Varies its girth.
    """
    around, phase = np.linspace(0, math.tau, 12, endpoint=False), rng.uniform(0, math.tau)
    rings = []
    for share in np.linspace(-0.02, 1, 9):
        flare = 1 + 0.7 * math.exp(-max(share, 0) * 22) * (1 + 0.25 * np.sin(5 * around + phase))
        girth = radius * (1 - 0.62 * max(share, 0)) * flare * (1 + 0.05 * np.sin(3 * around + 9 * share + phase))
        axis = along_trunk(height, leans, max(share, 0)) + np.array((0, 0, min(share, 0) * height))
        rings.append(axis + np.c_[girth * np.cos(around), girth * np.sin(around), np.zeros(12)])
    b.loft(bark, rings)


def _clump(b: MeshBuilder, leaf: MaterialRef, centre: ArrayLike, radius: float, rng: np.random.Generator) -> None:
    """Add a clump of leaves: an uneven ball with loose leaves that break its outline."""
    middle, phase = np.asarray(centre, float), rng.uniform(0, math.tau, 3)
    rings = []
    for k in range(8):
        polar = math.pi * k / 7
        around = np.linspace(0, math.tau, 12, endpoint=False) + 0.3 * k
        swell = 1 + 0.13 * np.sin(3 * around + phase[0] + 2 * polar) + 0.08 * np.cos(5 * around + phase[1])
        flat = radius * swell * max(math.sin(polar), 0.02)
        height = np.full(12, -0.78 * radius * math.cos(polar))
        rings.append(middle + np.c_[flat * np.cos(around), flat * np.sin(around), height])
    b.loft(leaf, rings)
    _sprays(b, leaf, middle, radius, 16, rng)


def _sprays(
    b: MeshBuilder, leaf: MaterialRef, middle: Floats, radius: float, count: int, rng: np.random.Generator
) -> None:
    """Add loose leaves on the surface of a clump."""
    out = rng.normal(size=(count, 3))
    out[:, 2] *= 0.8
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    side = np.cross(out, rng.normal(size=(count, 3)))
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(side, out) * 0.45 + out
    size = radius * rng.uniform(0.16, 0.34, (count, 1))
    root = middle + out * radius * (0.86, 0.86, 0.7)
    corners = (
        root - side * size * 0.3,
        root + side * size * 0.55 + up * size * 0.5,
        root + up * size * 1.3,
        root - side * size * 0.6 + up * size * 0.6,
    )
    vertices = np.stack(corners, axis=1).reshape(-1, 3)
    b.add(leaf, vertices, [(4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3) for i in range(count)])


def broad_tree(
    b: MeshBuilder, bark: MaterialRef, leaves: tuple[MaterialRef, MaterialRef], size: Vec2, rng: np.random.Generator
) -> None:
    """Add a broad-leaved tree.

    Args:
        b: Receives it.
        bark: Of trunk and branches.
        leaves: In the light and in the shade of the crown.
        size: Width of the crown and height, metres.
        rng: Random generator.
    """
    (w, h), (leaf, shade) = size, leaves
    radius, leans = h * 0.026, rng.uniform(-0.075, 0.075, 2) * h
    trunk(b, bark, h * 0.78, radius, leans * 0.6, rng)
    for index in range(11):
        share, angle = 0.36 + 0.5 * index / 11, index * GOLDEN_TURN + rng.uniform(-0.3, 0.3)
        foot = along_trunk(h, leans, share)
        reach = w * (0.375 - 0.2 * abs(share - 0.5)) * rng.uniform(0.8, 1.1)
        tip = foot + reach * np.array([math.cos(angle), math.sin(angle), rng.uniform(0.25, 0.6)])
        middle = (foot + tip) / 2 + np.array((0, 0, 0.12 * reach))
        b.tube(bark, [foot, middle, tip], [radius * 0.42, radius * 0.28, radius * 0.12], segments=6)
        for spot, full in ((tip, 1.0), (middle + np.array((0, 0, 0.05 * h)), 0.7)):
            clump = leaf if rng.random() < 0.7 else shade
            _clump(b, clump, spot + rng.uniform(-0.04, 0.04, 3) * h, w * rng.uniform(0.115, 0.165) * full, rng)
    for _ in range(5):
        spot = along_trunk(h, leans, 0.88) + rng.uniform(-1, 1, 3) * (w * 0.125, w * 0.125, h * 0.06)
        _clump(b, leaf, spot, w * rng.uniform(0.125, 0.16), rng)


def conifer(
    b: MeshBuilder, bark: MaterialRef, needles: MaterialRef, size: Vec2, rng: np.random.Generator, bare: float = 0.12
) -> None:
    """Add a conifer of drooping whorls.

    Args:
        b: Takes the tree.
        bark: Material of the trunk.
        needles: Material of the whorls.
        size: Width and height, metres.
        rng: Varies lean and whorls.
        bare: Share of the trunk below the whorls.
    """
    w, h = size
    leans, whorls, points = rng.uniform(-0.018, 0.018, 2) * h, 15, 18
    trunk(b, bark, h * 0.95, h * 0.017, leans, rng)
    long = np.arange(points) % 2 == 0
    for index in range(whorls):
        share = bare + (0.97 - bare) * (index / whorls) ** 0.92
        reach = w * (0.47 * (1 - share) ** 0.85 + 0.03)
        around = np.linspace(0, math.tau, points, endpoint=False) + rng.uniform(0, 1)
        tips = np.where(long, 1.0, 0.52) * rng.uniform(0.82, 1.12, points)
        rings = []
        for out, rise in ((1.0, -0.30), (0.62, 0.02), (0.1, 0.34)):
            flat = reach * out * (tips if out > 0.3 else np.ones(points))
            z = reach * rise * (np.where(long, 1.0, 0.45) if out == 1.0 else np.ones(points))
            rings.append(along_trunk(h, leans, share) + np.c_[flat * np.cos(around), flat * np.sin(around), z])
        b.loft(needles, rings, caps=False)
    top = along_trunk(h, leans, 0.94)
    b.cylinder(needles, top, top + np.array((0, 0, h * 0.06)), h * 0.01, h * 0.0015, segments=7)


def palm(b: MeshBuilder, bark: MaterialRef, leaf: MaterialRef, size: Vec2, rng: np.random.Generator) -> None:
    """Add a palm with a bent trunk and drooping fronds.

    Args:
        b: Takes the palm.
        bark: Material of the trunk and the nuts.
        leaf: Material of the fronds.
        size: Width and height, metres.
        rng: Varies bend and fronds.
    """
    w, h = size
    shares, bend = np.linspace(0, 1, 10), w * rng.uniform(0.1, 0.3)
    path = [(bend * (share**1.8 - 0.5), 0, h * 0.9 * share) for share in shares]
    b.tube(bark, path, [h * (0.037 - 0.019 * share) for share in shares], segments=10)
    head, widths = np.array(path[-1]), (0.02, 0.08, 0.12, 0.14, 0.14, 0.12, 0.09, 0.05, 0.004)
    for index in range(15):
        angle, droop, length = index * GOLDEN_TURN, rng.uniform(0.5, 1.5), w * rng.uniform(0.38, 0.5)
        out, side = np.array([math.cos(angle), math.sin(angle), 0]), np.array([-math.sin(angle), math.cos(angle), 0])
        rows = []
        for t, share in zip(np.linspace(0, 1, 9), widths, strict=True):
            spine = head + length * (out * t + np.array((0, 0, 0.38 * t - droop * 0.62 * t * t)))
            fold = length * share * np.array((0, 0, 0.5))
            rows.append([spine + side * length * share - fold, spine, spine - side * length * share - fold])
        b.loft(leaf, rows, closed=False)
    for index in range(4):
        angle = index * 1.6
        b.sphere(
            bark, head + np.array((0.2 * math.cos(angle), 0.2 * math.sin(angle), -0.2)), 0.13, segments=10, rings=6
        )


def bush(b: MeshBuilder, leaf: MaterialRef, size: Vec3, rng: np.random.Generator) -> None:
    """Add a bush of several clumps.

    Args:
        b: Takes the bush.
        leaf: Its material.
        size: Width, depth and height, metres.
        rng: Varies the clumps.
    """
    w, d, h = size
    for index in range(8):
        angle, reach = index * GOLDEN_TURN, 0.28 * math.sqrt((index + 0.5) / 8)
        spot = (w * reach * math.cos(angle), d * reach * math.sin(angle), h * rng.uniform(0.3, 0.62))
        _clump(b, leaf, spot, w * rng.uniform(0.2, 0.28), rng)


def blades(b: MeshBuilder, leaf: MaterialRef, count: int, size: Vec2, width: float, rng: np.random.Generator) -> None:
    """Add bent blades of grass.

    Args:
        b: Takes the blades.
        leaf: Their material.
        count: How many.
        size: Radius of their patch and height of the tallest, metres.
        width: Half the width of a blade at its root, metres.
        rng: Varies height and direction.
    """
    spread, height = size
    for index in range(count):
        angle, off = index * GOLDEN_TURN, spread * math.sqrt((index + 0.5) / count)
        turn = angle + rng.uniform(-0.9, 0.9)
        root = np.array([off * math.cos(angle), off * math.sin(angle), 0.0])
        out = np.array([math.cos(turn), math.sin(turn), 0])
        side = np.array([-out[1], out[0], 0]) * width
        tall = height * rng.uniform(0.55, 1.0)
        knee = root + out * tall * 0.12 + np.array((0, 0, tall * 0.6))
        tip = root + out * tall * 0.42 + np.array((0, 0, tall))
        outline = [root - side, root + side, knee + side * 0.7, knee - side * 0.7, tip]
        b.add(leaf, outline, [(0, 1, 2, 3), (3, 2, 4)])


def cactus(b: MeshBuilder, skin: MaterialRef, size: Vec2, arms: int, rng: np.random.Generator) -> None:
    """Add a ribbed columnar cactus.

    Args:
        b: Takes the cactus.
        skin: Its material.
        size: Span of its arms and height of its column, metres.
        arms: How many.
        rng: Varies the arms.
    """
    w, h = size
    angle = np.linspace(0, math.tau, 24, endpoint=False)
    ribs = np.c_[np.cos(angle), np.sin(angle)] * (1 + 0.08 * np.sin(8 * angle))[:, None]
    column = ((0.17, -0.1), (0.2, h * 0.2), (0.2, h * 0.8), (0.15, h * 0.95), (0.03, h))
    b.loft(skin, [np.c_[radius * ribs, np.full(24, z)] for radius, z in column])
    for index in range(arms):
        turn, z = index * 2.8 + rng.uniform(0, 0.6), h * (0.36 + 0.14 * index % 0.3)
        out, top = np.array([math.cos(turn), math.sin(turn), 0]), z + h * rng.uniform(0.26, 0.36)
        reaches = ((0.25, z), (0.75, z + 0.03), (1.0, z + 0.28), (1.0, top - 0.1), (1.0, top))
        path = [out * (w / 2 - 0.13) * reach + np.array((0, 0, height)) for reach, height in reaches]
        b.tube(skin, path, [0.12, 0.13, 0.14, 0.13, 0.04], segments=10)


def boulder(
    b: MeshBuilder,
    stone: MaterialRef,
    size: ArrayLike,
    rng: np.random.Generator,
    foot: float = -math.inf,
    top: float = math.inf,
) -> None:
    """Add a boulder with flat faces: a ball cut by random planes, a quarter of it in the ground.

    Args:
        b: Receives it.
        stone: Its material.
        size: Half its width and depth, and two thirds of its height above the ground, metres.
        rng: Random generator.
        foot: Lowest z; what is lower is flattened. Without it the boulder continues below the ground.
        top: Highest z; what is higher is flattened, to sit on.
    """
    polar, around = np.meshgrid(
        np.linspace(0.02, math.pi - 0.02, 9), np.linspace(0, math.tau, 14, endpoint=False), indexing="ij"
    )
    ball = np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), -np.cos(polar)], axis=2)
    for normal in rng.normal(size=(11, 3)):
        normal = normal / np.linalg.norm(normal)
        over = np.maximum(ball @ normal - rng.uniform(0.55, 0.8), 0)
        ball = ball - over[..., None] * normal
    half = np.asarray(size, float)
    rings = ball * half + (0, 0, 0.5 * half[2])
    rings[..., 2] = np.clip(rings[..., 2], foot, top)
    b.loft(stone, list(rings))
