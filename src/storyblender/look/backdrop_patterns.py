"""Painted cards for what is far away: towns, forests, hills, the sea, the night sky. Scene-linear, row 0 at the bottom.

``color`` is the sky at the horizon; ``accent`` is the land, the buildings' lit windows or the stars.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from storyblender.look.patterns import Floats, grid, mix, noise, pattern


@pattern("gradient")
def gradient(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint a sky: accent at the horizon, color at the top."""
    row, _ = grid(size)
    return mix(accent, color, (row / size) ** 0.7)


def _sky(size: int, color: ArrayLike) -> Floats:
    base = np.asarray(color, float)
    return gradient(size, base * 0.6, np.clip(base * 1.35, 0, 1), 0)


@pattern("facade")
def facade(
    size: int, color: ArrayLike, accent: ArrayLike, seed: int, columns: float = 6, rows: float = 8, lit: float = 0.25
) -> Floats:
    """Paint a wall of ``columns`` x ``rows`` windows, a share ``lit`` of them in the accent colour."""
    bays, floors = int(columns), int(rows)
    row, column = grid(size)
    rng = np.random.default_rng(seed)
    x, y = column * bays / size % 1, row * floors / size % 1
    lamp = np.where(rng.random((floors, bays)) < lit, rng.uniform(0.5, 1.0, (floors, bays)), 0.0)
    light = lamp[row * floors // size, column * bays // size]
    wall = np.asarray(color) * (0.85 + 0.3 * noise(size, 1.5, seed))[..., None]
    frame = (np.abs(x - 0.5) < 0.29) & (np.abs(y - 0.5) < 0.34)
    pane = (np.abs(x - 0.5) < 0.25) & (np.abs(y - 0.5) < 0.3) & (np.abs(x - 0.5) > 0.02) & (np.abs(y - 0.55) > 0.015)
    wall[frame] *= 1.3
    wall[y < 0.03] *= 0.7
    glass = mix((0.012, 0.016, 0.025), accent, light)
    return np.clip(np.where(pane[..., None], glass, wall), 0, 1)


@pattern("skyline")
def skyline(size: int, color: ArrayLike, accent: ArrayLike, seed: int, lit: float = 0.2) -> Floats:
    """Paint three rows of towers, darker towards the viewer, with a share ``lit`` of their windows lit."""
    image = _sky(size, color)
    rng = np.random.default_rng(seed)
    for nearness, height in ((0.45, 0.62), (0.75, 0.42), (1.0, 0.26)):
        wall = np.asarray(color) * (1 - 0.8 * nearness)
        left = 0
        while left < size:
            width = int(rng.integers(size // 22, size // 9))
            top = int(size * height * rng.uniform(0.5, 1.25))
            right = min(size, left + width)
            image[:top, left:right] = wall * rng.uniform(0.8, 1.2)
            step = max(4, size // 64)
            for low in range(step, top - step, step):
                for at in range(left + 2, right - 3, step):
                    if rng.random() < lit:
                        image[low : low + step // 2, at : at + step // 2] = np.asarray(accent) * rng.uniform(0.3, 1.0)
            left += width
    return np.clip(image, 0, 1)


def _ridge(size: int, base: float, swing: float, seed: int, roughness: float) -> Floats:
    """Return the height (0..1) of a ragged, tileable horizon for every column."""
    profile = noise(size, roughness, seed)[size // 2]
    return base + swing * (profile - 0.5)


@pattern("treeline")
def treeline(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint three rows of trees fading into haze."""
    image = _sky(size, color)
    row, column = grid(size)
    for layer, (nearness, base) in enumerate(((0.3, 0.62), (0.6, 0.5), (1.0, 0.36))):
        crowns = _ridge(size, base, 0.22, seed + layer, 1.0)
        points = 0.05 * np.abs(np.sin(column[0] * math.pi * (18 + 7 * layer) / size + layer))
        under = row / size < (crowns + points)[column]
        leaf = (
            mix(color, accent, np.full((size, size), nearness))
            * (0.8 + 0.4 * noise(size, 0.8, seed + layer))[..., None]
        )
        image = np.where(under[..., None], leaf, image)
    return np.clip(image, 0, 1)


@pattern("hills")
def hills(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint rows of hills fading into the sky."""
    image = _sky(size, color)
    row, column = grid(size)
    for layer, (nearness, base) in enumerate(((0.25, 0.55), (0.5, 0.42), (0.75, 0.3), (1.0, 0.16))):
        under = row / size < _ridge(size, base, 0.4, seed + layer, 1.9)[column]
        land = (
            mix(color, accent, np.full((size, size), nearness))
            * (0.9 + 0.2 * noise(size, 1.2, seed + layer))[..., None]
        )
        image = np.where(under[..., None], land, image)
    return np.clip(image, 0, 1)


@pattern("sea")
def sea(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint the sea up to a horizon at 45 % of the height, with glints."""
    row, _ = grid(size)
    wave = noise(size, 1.2, seed, (5.0, 0.7))
    water = mix(accent, color, np.clip((wave - 0.55) * 2 + row / size * 0.4, 0, 0.8))
    return np.where((row < 0.45 * size)[..., None], water, _sky(size, color))


@pattern("stars")
def stars(size: int, color: ArrayLike, accent: ArrayLike, seed: int, density: float = 0.0025) -> Floats:
    """Paint a night sky with a faint milky band and stars on a share ``density`` of its pixels."""
    rng = np.random.default_rng(seed)
    image = np.asarray(color) * (0.7 + 0.6 * noise(size, 2.0, seed))[..., None]
    spark = np.where(rng.random((size, size)) < density, rng.uniform(0.2, 1.0, (size, size)), 0.0)
    return np.clip(mix(image, accent, spark), 0, 1)
