"""Hair: a thin shell over the scalp and tapered locks combed over it (notes on humans, section 4)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.hanging_hair import hanging_hair
from storyblender.blender.people.locks import KNOT, HairSupport, Strand, flat_lock, round_curl, wound_bun
from storyblender.blender.people.scalp import Scalp, above_hairline
from storyblender.blender.people.sheet import Sheet, join
from storyblender.blender.people.tied_hair import tied_hair
from storyblender.catalog.bodies import Complexion
from storyblender.catalog.hair import HairSpec, hairstyle
from storyblender.geometry.solids import Floats

WHORL = np.array((0.08, 0.55, 0.83)) / np.linalg.norm((0.08, 0.55, 0.83))
STEP = 0.13
"""Radians between the rows of a lock on the head."""


@dataclass
class Hair:
    """A finished head of hair.

    Attributes:
        sheet: Shell and locks.
        colors: (V, 3) vertex colours, a little different from lock to lock.
    """

    sheet: Sheet
    colors: Floats


def build_hair(
    figure: BodyFigure,
    style: str,
    colors: Complexion,
    masculine: float,
    seed: int,
    *,
    clothes: Sequence[Sheet],
    hatted: bool,
) -> Hair | None:
    """Return the hair of a figure, or None for a shaved head.

    Args:
        figure: The body.
        style: Key of ``catalog.hair``.
        colors: Of hair and skin.
        masculine: 0 to 1, shapes the hairline.
        seed: Varies the locks.
        clothes: Sheets that long hair lies on.
        hatted: Whether a hat presses the hair on top flat.
    """
    spec = hairstyle(style)
    if not spec.top and not spec.side:
        return None
    rng = np.random.default_rng(seed + 4)
    scalp = Scalp(figure, spec, masculine, hatted)
    shell = scalp.shell()
    sheets = [shell]
    shades = [np.full(len(shell.points), 0.82)]
    if spec.hang:
        fall, tones = hanging_hair(scalp, HairSupport(figure, clothes), rng)
        sheets.append(fall)
        shades.append(tones)
    for lock in () if spec.hang else _locks(scalp, clothes, rng):
        sheets.append(lock)
        shades.append(np.full(len(lock.points), rng.uniform(0.86, 1.18)))
    paint = np.concatenate(shades)[:, None] * np.array(colors.hair)
    # The shell thins out to the skin at the hairline.
    thin = 0.45 * np.exp(-np.maximum(above_hairline(shell.base, spec, masculine), 0) / 0.05)[:, None]
    paint[: len(shell.points)] = paint[: len(shell.points)] * (1 - thin) + np.array(colors.skin) * thin
    return Hair(join(sheets), np.clip(paint, 0.0, 1.0).astype(float))


def _locks(scalp: Scalp, clothes: Sequence[Sheet], rng: np.random.Generator) -> list[Sheet]:
    """Return the locks of a hairstyle that does not hang, with its bun, tail or braid."""
    spec, figure = scalp.spec, scalp.figure
    body = HairSupport(figure, clothes) if spec.knot in ("tail", "braid") else None
    locks: list[Sheet] = []
    for root in _roots(scalp, rng):
        if scalp.hatted and (root[2] > 0.55 or root[1] < -0.2):  # under the brim; its tips would fall on the temples
            continue
        if spec.curls:
            locks.append(round_curl(scalp, root, rng))
            continue
        strand = _comb(scalp, root, rng)
        if strand is not None:
            locks.append(flat_lock(figure, strand, spec, spec.width * rng.uniform(0.8, 1.2)))
    if spec.knot == "bun":
        locks += wound_bun(scalp, rng)
    if body:
        locks += tied_hair(scalp, body)
    return locks


def _roots(scalp: Scalp, rng: np.random.Generator) -> list[Floats]:
    """Return evenly spread directions of locks where hair grows: a Fibonacci sphere with noise."""
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
        found = scalp.skull_surface(direction)
        if found is not None and found[1] > 0.03:
            roots.append(direction)
    if not spec.curls and spec.growth != "wreath":
        roots += _hairline_roots(scalp)
    # From the nape upwards, so that upper locks lie over lower ones.
    return sorted(roots, key=lambda direction: float(direction[2]))


def _hairline_roots(scalp: Scalp) -> list[Floats]:
    """Return a row of directions along the front hairline."""
    roots = []
    for turn in np.radians(np.linspace(-72, 72, 17)):
        for rise in np.radians(np.arange(8, 70, 3)):
            forward = np.cos(rise)
            direction = np.array((np.sin(turn) * forward, -np.cos(turn) * forward, np.sin(rise)))
            found = scalp.skull_surface(direction)
            if found is not None and found[1] > 0.05:
                roots.append(direction)
                break
    return roots


def _flow(direction: Floats, spec: HairSpec, side: float) -> Floats:
    """Return the combing direction at a place on the head, a unit tangent of the sphere."""
    x, y, z = direction.tolist()
    down = np.array((0.0, 0.0, -1.0))
    if spec.comb == "part":
        high = min(max(z, 0.0), 1.0)
        # Along the parting itself the hair is drawn back, so that no bare wedge opens at the forehead.
        near = math.exp(-(((x - spec.parting) / 0.13) ** 2)) * high
        way = np.array((side * high * 1.1 * (1 - 0.8 * near), spec.sweep * (0.4 + high) + 1.4 * near, 0.0))
        way = way + down * (1.05 - high)
    elif spec.comb == "back":
        way = np.array((0.0, 1.0, 0.0)) + down * (0.35 + 0.5 * max(y, 0))
    elif spec.comb == "gather":
        way = KNOT - direction
    else:
        way = direction - WHORL + down * 0.35
    way = way - direction * (way @ direction)
    return way / max(math.sqrt(way @ way), 1e-6)


def _cross(a: Floats, b: Floats) -> Floats:
    """Return the cross product of two vectors; ten times faster than numpy's for single vectors."""
    return np.array((a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]))


def _comb(scalp: Scalp, root: Floats, rng: np.random.Generator) -> Strand | None:
    """Return the middle line of a lock led over the head along the combing direction; None if it ends at once."""
    spec, scale = scalp.spec, scalp.figure.head_scale
    side = 1.0 if root[0] > spec.parting else -1.0
    stray = rng.normal(0, 0.5 * spec.mess)
    rise = spec.lift * rng.uniform(0.3, 1.6) * scale
    rows = max(3, round(spec.reach * rng.uniform(0.8, 1.1) / STEP)) if not spec.knot else 14
    direction = root
    points, outward = [], []
    for row in range(rows):
        lift = rise * math.sin(math.pi * min(1.0, 0.35 + row / rows))
        if row == 0:  # sunk into the shell, or the open end of the lock would show at the parting
            lift = -spec.top * scale * (0.45 if root[1] > -0.6 else 0.2)
        found = scalp.hair_surface(direction, lift)
        if found is None:
            break
        point, grown = found
        if row and grown < -0.06 - 0.35 * spec.mess:
            break
        points.append(point)
        outward.append(direction)
        if spec.knot and direction @ KNOT > 0.985:
            break
        way = _flow(direction, spec, side)
        if spec.comb == "part" and grown < 0.3 and direction[1] < -0.3:
            # Off the forehead: short hair is brushed up and back there.
            way = way + (1 - max(grown, 0.0) / 0.3) * np.array((0.0, 1.1, 0.9))
        way = way + stray * _cross(direction, way)
        direction = direction + way / math.sqrt(way @ way) * STEP
        direction = direction / math.sqrt(direction @ direction)
    if len(points) < 3:
        return None
    return Strand(np.array(points), np.array(outward))
