"""Hair: a thin shell over the scalp and tapered locks that are combed over it (notes on humans, section 4)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from numpy.typing import NDArray

from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import Figure
from storyblender.blender.people.scalp import Scalp, above_hairline
from storyblender.blender.people.sheet import Sheet, join, rigid
from storyblender.blender.people.under import polygons
from storyblender.catalog.bodies import Complexion
from storyblender.catalog.hair import HAIRSTYLES, HairSpec

Floats = NDArray[np.float64]

WHORL = np.array((0.08, 0.55, 0.83)) / np.linalg.norm((0.08, 0.55, 0.83))
KNOT = np.array((0.0, 0.95, 0.32)) / np.linalg.norm((0.0, 0.95, 0.32))
STEP = 0.13
"""Radians between the rows of a lock on the head."""
DROP = 0.026
"""Metres between the rows of a lock that hangs."""
ROWS = 7


@dataclass
class Hair:
    """A finished head of hair.

    Attributes:
        sheet: Shell and locks.
        colors: (V, 3) vertex colours, a little different from lock to lock.
    """

    sheet: Sheet
    colors: Floats


@dataclass
class Strand:
    """The middle line of a lock.

    Attributes:
        points: (N, 3).
        outward: (N, 3) away from the head or body.
    """

    points: Floats
    outward: Floats


def build_hair(
    figure: Figure,
    style: str,
    colors: Complexion,
    masculine: float,
    seed: int,
    *,
    clothes: Sequence[Sheet],
    hatted: bool,
) -> Hair | None:
    """Return the hair of ``figure``, or None for a shaved head.

    Args:
        figure: Whose head.
        style: Key of ``catalog.hair``.
        colors: Of hair and skin.
        masculine: 0 to 1, shapes the hairline.
        seed: Where the locks fall.
        clothes: What long hair lies on.
        hatted: Presses the hair on top flat.
    """
    spec = HAIRSTYLES[style]
    if not spec.top and not spec.side:
        return None
    rng = np.random.default_rng(seed + 4)
    scalp = Scalp(figure, spec, masculine, hatted)
    shell = scalp.cap()
    sheets = [shell]
    shades = [np.full(len(shell.points), 0.82)]
    for lock in _locks(scalp, clothes, rng):
        sheets.append(lock)
        # Each lock has its own shade and is darker at the root, which reads as strands.
        shade = rng.uniform(0.86, 1.18)
        shades.append(np.full(len(lock.points), shade))
    paint = np.concatenate(shades)[:, None] * np.array(colors.hair)
    # The shell thins out to the skin at the hairline.
    thin = 0.45 * np.exp(-np.maximum(above_hairline(shell.base, spec, masculine), 0) / 0.05)[:, None]
    paint[: len(shell.points)] = paint[: len(shell.points)] * (1 - thin) + np.array(colors.skin) * thin
    return Hair(join(sheets), np.clip(paint, 0, 1))


def _locks(scalp: Scalp, clothes: Sequence[Sheet], rng: np.random.Generator) -> list[Sheet]:
    spec, figure = scalp.spec, scalp.figure
    body = _Drape(figure, clothes) if spec.hang or spec.knot == "tail" else None
    locks: list[Sheet] = []
    for root in _roots(scalp, rng):
        if scalp.hatted and root[2] > 0.55 and not spec.hang:
            continue
        if spec.curls == "tight":
            locks.append(_curl(scalp, root, rng))
            continue
        strand = _ringlet(scalp, root, rng) if spec.curls else _comb(scalp, root, rng, body)
        if strand is not None:
            locks.append(_leaf(figure, strand, spec, spec.width * rng.uniform(0.8, 1.2)))
    if spec.knot == "bun":
        locks += _bun(scalp, rng)
    if spec.knot == "tail" and body:
        locks += _tail(scalp, body, rng)
    return locks


def _roots(scalp: Scalp, rng: np.random.Generator) -> list[Floats]:
    """Spread the roots evenly over where hair grows: a Fibonacci sphere, slightly shaken."""
    spec = scalp.spec
    if not spec.locks:
        return []
    count = int(spec.locks * (2.0 if spec.growth != "wreath" else 4.5))
    index = np.arange(count) + 0.5
    z = 1 - 2 * index / count
    turn = np.pi * (1 + 5**0.5) * index
    flat = np.sqrt(1 - z**2)
    directions = np.stack([flat * np.cos(turn), flat * np.sin(turn), z], 1)
    directions += rng.normal(0, 0.04, directions.shape)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    roots = []
    for direction in directions[directions[:, 2] > -0.6]:
        found = scalp.surface(direction)
        if found is not None and found[1] > 0.03:
            roots.append(direction)
    # From the nape upwards, so that upper locks lie over lower ones.
    return sorted(roots, key=lambda direction: float(direction[2]))


def _flow(direction: Floats, spec: HairSpec, side: float) -> Floats:
    """Return the combing direction at a place on the head, a unit tangent of the sphere."""
    x, y, z = direction
    down = np.array((0.0, 0.0, -1.0))
    if spec.comb == "part":
        high = np.clip(z, 0, 1)
        way = np.array((side * high * 1.1, spec.sweep * (0.4 + high), 0.0)) + down * (1.05 - high)
    elif spec.comb == "back":
        way = np.array((0.0, 1.0, 0.0)) + down * (0.35 + 0.5 * max(y, 0))
    elif spec.comb == "gather":
        way = KNOT - direction
    else:
        way = direction - WHORL + down * 0.35
    way = way - direction * (way @ direction)
    return way / max(float(np.linalg.norm(way)), 1e-6)


def _comb(scalp: Scalp, root: Floats, rng: np.random.Generator, body: _Drape | None) -> Strand | None:
    """Lead a lock over the head along the combing direction, and let it hang from where it leaves the hair."""
    spec, scale = scalp.spec, scalp.figure.head_scale
    side = 1.0 if root[0] > spec.parting else -1.0
    stray = rng.normal(0, 0.5 * spec.mess)
    rise = spec.lift * rng.uniform(0.3, 1.6) * scale
    rows = max(3, round(spec.reach * rng.uniform(0.8, 1.1) / STEP)) if not spec.knot else 14
    direction = root
    points, outward = [], []
    for row in range(rows):
        # The root is sunk into the shell, or the open end of the lock would show at the parting.
        lift = rise * np.sin(np.pi * min(1.0, 0.35 + row / rows)) if row else -0.45 * spec.top * scale
        found = scalp.over(direction, lift)
        if found is None:
            break
        point, grown = found
        if row and spec.hang and direction[2] < -0.05:
            break
        if row and not spec.hang and grown < -0.06 - 0.35 * spec.mess:
            break
        points.append(point)
        outward.append(direction)
        if spec.knot and direction @ KNOT > 0.985:
            break
        way = _flow(direction, spec, side)
        if spec.hang and grown < 0.25 and direction[1] < -0.2:
            # Off the face: long hair turns aside at the forehead.
            way = np.cross(direction, (0.0, -side, 0.35 * side)) + 0.4 * way
        way = way + stray * np.cross(direction, way)
        direction = direction + way / np.linalg.norm(way) * STEP
        direction = direction / np.linalg.norm(direction)
    if len(points) < 3:
        return None
    if spec.hang and body:
        body.hang(points, outward, spec, spec.hang * scale * rng.uniform(0.85, 1.08), rng)
    return Strand(np.array(points), np.array(outward))


class _Drape:
    """The body and clothes that long hair falls on."""

    def __init__(self, figure: Figure, clothes: Sequence[Sheet]) -> None:
        skin = figure.part("skin")
        low = skin.points[:, 2] > figure.heights["chest"] - 0.1 * figure.k
        self._sheets = [skin.keep_faces(low[skin.faces].all(1)), *clothes]
        self._trees = [BVHTree.FromPolygons(sheet.points.tolist(), polygons(sheet)) for sheet in self._sheets]
        self._figure = figure

    def hang(
        self, points: list[Floats], outward: list[Floats], spec: HairSpec, length: float, rng: np.random.Generator
    ) -> None:
        """Continue a lock downwards, outside the body."""
        scale = self._figure.head_scale
        phase = rng.uniform(0, 2 * np.pi)
        aim = points[-1] - points[-2]
        aim = aim / np.linalg.norm(aim)
        out = np.array((outward[-1][0], outward[-1][1], 0.0))
        out = out / max(float(np.linalg.norm(out)), 1e-6)
        drop = DROP * scale
        for row in range(max(2, round(length / drop))):
            aim = 0.55 * aim + 0.45 * np.array((0.0, 0.0, -1.0))
            aim = aim / np.linalg.norm(aim)
            swing = spec.wave * scale * 0.5 * np.sin(phase + row * 0.95)
            across = np.cross(out, (0.0, 0.0, 1.0))
            point = points[-1] + aim * drop + across * swing + out * 0.0015
            point = self.push_out(self._aside(point), 0.007 * scale)
            points.append(point)
            outward.append(out)

    def _aside(self, point: Floats) -> Floats:
        """Return ``point`` kept off the face."""
        scale = self._figure.head_scale
        depth = self._figure.joint("head")[1] - point[1]
        least = float(np.interp(depth, (0.0, 0.05 * scale), (0.0, 0.072 * scale)))
        if point[2] < self._figure.heights["neck"] + 0.02 * scale or abs(point[0]) >= least:
            return point
        return np.array((least if point[0] > 0 else -least, point[1], point[2]))

    def push_out(self, point: Floats, gap: float) -> Floats:
        """Return ``point`` moved at least ``gap`` outside the body and clothes."""
        for tree in self._trees:
            nearest, normal, _, _ = tree.find_nearest(Vector(point), 0.08)
            if nearest is not None:
                depth = gap - (Vector(point) - nearest).dot(normal)
                if depth > 0:
                    point = point + np.array(normal) * depth
        return point


def _hair_weights(figure: Figure, points: Floats) -> Floats:
    """Hair follows the head; where it lies on the shoulders it stays half with them."""
    neck, chest = figure.heights["neck"], figure.heights["chest"]
    share = np.interp(points[:, 2], (chest, neck + 0.05 * figure.k), (0.55, 0.0))[:, None]
    return (1 - share) * bone_weights("head") + share * bone_weights("upper_chest")


def _leaf(figure: Figure, strand: Strand, spec: HairSpec, width: float) -> Sheet:
    """Return a lock: a strip with a raised middle that tapers to its tip."""
    count = ROWS if not spec.hang else max(ROWS, round(len(strand.points) * (0.9 if spec.wave > 0.015 else 0.6)))
    at = np.linspace(0, len(strand.points) - 1, count)
    index = np.arange(len(strand.points))
    points = np.stack([np.interp(at, index, strand.points[:, axis]) for axis in range(3)], 1)
    outward = np.stack([np.interp(at, index, strand.outward[:, axis]) for axis in range(3)], 1)
    along = np.gradient(points, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    outward -= along * (outward * along).sum(1, keepdims=True)
    outward /= np.maximum(np.linalg.norm(outward, axis=1, keepdims=True), 1e-9)
    across = np.cross(along, outward)
    u = np.linspace(0, 1, count)
    profile = np.interp(u, (0, 0.25, 0.65, 1), (0.4, 1.0, max(0.85, spec.tip), spec.tip))
    half = (0.5 * width * figure.head_scale * profile)[:, None]
    sink = 0.45 * half * outward
    rows = np.stack([points - across * half - sink, points + outward * half * 0.25, points + across * half - sink], 1)
    faces = [(r * 3 + c, r * 3 + c + 1, r * 3 + c + 4, r * 3 + c + 3) for r in range(count - 1) for c in range(2)]
    flat = rows.reshape(-1, 3)
    return rigid(flat, faces, _hair_weights(figure, flat))


def _ball(figure: Figure, center: Floats, radii: Floats, spin: Floats, segments: int = 7, rings: int = 5) -> Sheet:
    """Return a small ellipsoid; ``spin`` (3, 3) turns it."""
    points = [np.array((0.0, 0.0, 1.0))]
    for ring in range(1, rings):
        tilt = np.pi * ring / rings
        for step in range(segments):
            turn = 2 * np.pi * step / segments
            points.append(np.array((np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt))))
    points.append(np.array((0.0, 0.0, -1.0)))
    last = len(points) - 1
    faces: list[tuple[int, ...]] = []
    for step in range(segments):
        after = (step + 1) % segments
        faces.append((0, 1 + step, 1 + after))
        for ring in range(rings - 2):
            a, b = 1 + ring * segments, 1 + (ring + 1) * segments
            faces.append((a + step, b + step, b + after, a + after))
        end = 1 + (rings - 2) * segments
        faces.append((end + step, last, end + after))
    placed = center + (np.array(points) * radii) @ spin.T
    return rigid(placed, faces, _hair_weights(figure, placed))


def _curl(scalp: Scalp, root: Floats, rng: np.random.Generator) -> Sheet:
    """Return one round curl standing on the hair."""
    spec, scale = scalp.spec, scalp.figure.head_scale
    size = 0.5 * spec.width * scale * rng.uniform(0.75, 1.25)
    found = scalp.over(root, -rng.uniform(0.1, 0.8) * size)
    center = found[0] if found else scalp.center
    spin, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    spin = spin * np.sign(np.linalg.det(spin))
    return _ball(scalp.figure, center, size * np.array((1.0, 0.85, 0.7)), spin, 6, 4)


def _ringlet(scalp: Scalp, root: Floats, rng: np.random.Generator) -> Strand | None:
    """Return the middle line of a ringlet: a short helix that falls off the head."""
    spec, scale = scalp.spec, scalp.figure.head_scale
    found = scalp.over(root, -0.012 * scale)
    if found is None:
        return None
    axis = root * 0.8 + np.array((0.0, 0.0, -0.55)) + rng.normal(0, 0.25, 3)
    axis /= np.linalg.norm(axis)
    across = np.cross(axis, rng.normal(size=3))
    across /= np.linalg.norm(across)
    second = np.cross(axis, across)
    u = np.linspace(0, 1, ROWS)[:, None]
    turn = 2 * np.pi * (1.25 * u + rng.uniform())
    round_ = across * np.cos(turn) + second * np.sin(turn)
    radius = 0.45 * spec.width * scale * rng.uniform(0.8, 1.2)
    points = found[0] + axis * u * spec.reach * 0.045 * scale + round_ * radius
    return Strand(points, round_)


def _bun(scalp: Scalp, rng: np.random.Generator) -> list[Sheet]:
    """Return a knot of wound locks."""
    figure, scale = scalp.figure, scalp.figure.head_scale
    found = scalp.over(KNOT, 0.020 * scale)
    center = found[0] if found else scalp.center
    radii = np.array((0.046, 0.038, 0.042)) * scale
    locks = [_ball(figure, center, radii * 0.94, np.eye(3), 10, 7)]
    right = np.array((1.0, 0.0, 0.0))
    up = np.cross(KNOT, right)
    for step in range(9):
        turn = 2 * np.pi * step / 9 + rng.normal(0, 0.1)
        angle = np.linspace(0.25, 1.75, ROWS)[:, None]
        wind = turn + 1.5 * angle
        directions = KNOT * np.cos(angle) + (right * np.cos(wind) + up * np.sin(wind)) * np.sin(angle)
        locks.append(_leaf(figure, Strand(center + directions * radii, directions), scalp.spec, 0.030))
    return locks


def _tail(scalp: Scalp, body: _Drape, rng: np.random.Generator) -> list[Sheet]:
    """Return the hanging locks of a ponytail and the band that holds them."""
    figure, spec, scale = scalp.figure, scalp.spec, scalp.figure.head_scale
    found = scalp.over(KNOT, 0.012 * scale)
    start = found[0] if found else scalp.center
    locks = [_ball(figure, start, np.full(3, 0.017) * scale, np.eye(3), 8, 6)]
    for step in range(9):
        turn = 2 * np.pi * step / 9
        fan = np.array((np.cos(turn), 0.3 * np.sin(turn), 0.8 * np.sin(turn))) * 0.009 * scale
        points = [start, start + KNOT * 0.03 * scale + fan, start + KNOT * 0.05 * scale + fan * 1.6]
        outward = [KNOT, KNOT, KNOT]
        body.hang(points, outward, spec, 0.24 * scale * rng.uniform(0.85, 1.05), rng)
        locks.append(_leaf(figure, Strand(np.array(points), np.array(outward)), spec, 0.028))
    return locks
