"""Painted surfaces as numpy pictures: wood, brick, cloth, leaves, facades. Tileable, deterministic, scene-linear.

Every pattern is ``pattern(size, color, accent, seed, **params) -> (size, size, 3)``; row 0 is the bottom, and
anything that runs along a direction (grain, boards) runs along a row, the texture's u axis. ``size`` is in pixels,
``color`` and ``accent`` are (3,) scene-linear from 0 to 1, the same ``seed`` gives the same picture, and ``params`` are
the numbers that a pattern's own docstring names.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
PatternFunction = Callable[..., Floats]

PATTERNS: dict[str, PatternFunction] = {}
"""Every tileable pattern by its key."""


def pattern(key: str) -> Callable[[PatternFunction], PatternFunction]:
    """Register a pattern under ``key``."""

    def register(function: PatternFunction) -> PatternFunction:
        PATTERNS[key] = function
        return function

    return register


def noise(size: int, roughness: float, seed: int, stretch: tuple[float, float] = (1.0, 1.0)) -> Floats:
    """Return tileable 1/f noise in 0..1.

    Args:
        size: Rows and columns.
        roughness: Exponent of the spectrum: 0.5 is gravel, 2 is clouds.
        seed: Same seed, same noise.
        stretch: How much longer its features are along u and along v.
    """
    white = np.random.default_rng(seed).standard_normal((size, size))
    frequency = np.fft.fftfreq(size) * size
    across, up = np.meshgrid(frequency * stretch[0], frequency * stretch[1])
    radius = np.hypot(across, up)
    spectrum = np.where(radius < 1, 0.0, np.maximum(radius, 1.0) ** -roughness)
    field = np.fft.ifft2(np.fft.fft2(white) * spectrum).real
    return np.clip(0.5 + 0.22 * (field - field.mean()) / field.std(), 0, 1)


def mix(a: ArrayLike, b: ArrayLike, weight: Floats) -> Floats:
    """Return a where weight is 0 and b where it is 1, per pixel.

    Args:
        a: (3,) colour or (h, w, 3) picture.
        b: (3,) colour or (h, w, 3) picture.
        weight: (h, w), 0 to 1.
    """
    return np.asarray(a) * (1 - weight[..., None]) + np.asarray(b) * weight[..., None]


def grid(size: int) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the row and the column of every pixel."""
    rows, columns = np.mgrid[0:size, 0:size]
    return rows, columns


def tone(color: ArrayLike, factor: Floats) -> Floats:
    """Return a (3,) ``color`` times an (h, w) ``factor`` per pixel, as an (h, w, 3) picture."""
    return np.asarray(color, float) * factor[..., None]


@pattern("wood")
def wood(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint one board of wood: long grain and a few dark streaks."""
    fibre = noise(size, 1.2, seed, (9.0, 0.7))
    streak = noise(size, 1.7, seed + 1, (7.0, 1.0))
    return tone(color, 1 + 0.42 * (fibre - 0.5) - 0.35 * np.clip(streak - 0.62, 0, 1) * 2)


@pattern("planks")
def planks(size: int, color: ArrayLike, accent: ArrayLike, seed: int, count: float = 6) -> Floats:
    """Paint ``count`` rows of floorboards along u, staggered, with dark gaps."""
    boards = int(count)
    rows, columns = grid(size)
    board = rows * boards // size
    rng = np.random.default_rng(seed)
    shift = rng.integers(0, size, boards)
    half = ((columns + shift[board]) % size) // (size // 2)
    shade = rng.uniform(0.82, 1.16, (boards, 2))[board, half]
    fibre = noise(size, 1.2, seed + 1, (9.0, 0.7))
    image = tone(color, shade * (1 + 0.3 * (fibre - 0.5)))
    gap = (rows * boards % size < boards * 1.5) | ((columns + shift[board]) % (size // 2) < 1)
    return mix(image, accent, 0.75 * gap)


@pattern("parquet")
def parquet(size: int, color: ArrayLike, accent: ArrayLike, seed: int, count: float = 4) -> Floats:
    """Paint ``count`` x ``count`` squares of short boards, laid crosswise like a basket."""
    cells, strips = int(count), 4
    rows, columns = grid(size)
    cell = size // cells
    turned = (rows // cell + columns // cell) % 2 == 0
    along = np.where(turned, rows % cell, columns % cell)
    strip = along * strips // cell
    rng = np.random.default_rng(seed)
    shade = rng.uniform(0.8, 1.18, (cells, cells, strips))[rows // cell % cells, columns // cell % cells, strip]
    image = tone(color, shade * (0.92 + 0.16 * noise(size, 1.0, seed + 1)))
    gap = (along * strips % cell < strips) | (rows % cell < 1) | (columns % cell < 1)
    return mix(image, accent, 0.6 * gap)


@pattern("brick")
def brick(
    size: int,
    color: ArrayLike,
    accent: ArrayLike,
    seed: int,
    rows: float = 12,
    columns: float = 4,
    variation: float = 0.5,
) -> Floats:
    """Paint ``rows`` courses of ``columns`` bricks or blocks, with joints of the accent colour.

    ``variation`` is how much their brightness differs, 0 not at all.
    """
    courses, bricks = int(rows), int(columns)
    row, column = grid(size)
    course = row * courses // size
    shifted = (column + (course % 2) * (size // bricks // 2)) % size
    which = shifted * bricks // size
    rng = np.random.default_rng(seed)
    shade = 1 + variation * rng.uniform(-0.6, 0.4, (courses, bricks))[course, which]
    image = tone(color, shade * (0.84 + 0.32 * noise(size, 1.1, seed)))
    joint = max(2, size // 110)
    mortar = (row * courses % size < joint * courses) | (shifted * bricks % size < joint * bricks)
    return mix(image, accent, mortar.astype(float))


@pattern("speckle")
def speckle(
    size: int, color: ArrayLike, accent: ArrayLike, seed: int, amount: float = 0.3, roughness: float = 1.0
) -> Floats:
    """Paint an even surface with fine and broad variation: plaster, asphalt, leather, stone.

    ``amount`` is the range of its brightness as a share of the colour, ``roughness`` that of the fine ``noise``.
    """
    fine, broad = noise(size, roughness, seed), noise(size, 1.8, seed + 9)
    return tone(color, 1 - amount / 2 + amount * (0.55 * fine + 0.45 * broad))


@pattern("checker")
def checker(size: int, color: ArrayLike, accent: ArrayLike, seed: int, count: float = 4) -> Floats:
    """Paint ``count`` x ``count`` square tiles in two colours with dark joints."""
    tiles = int(count)
    row, column = grid(size)
    odd = (row * tiles // size + column * tiles // size) % 2
    image = mix(color, accent, odd.astype(float)) * (0.9 + 0.2 * noise(size, 1.4, seed))[..., None]
    joint = (row % (size // tiles) < 2) | (column % (size // tiles) < 2)
    image[joint] *= 0.55
    return image


@pattern("paving")
def paving(size: int, color: ArrayLike, accent: ArrayLike, seed: int, count: float = 4, jitter: float = 0.12) -> Floats:
    """Paint ``count`` x ``count`` stones as cells around points moved by at most ``jitter`` of a stone.

    Little jitter gives slabs, much gives cobbles.
    """
    stones = int(count)
    rng = np.random.default_rng(seed)
    spots = np.stack(np.meshgrid(np.arange(stones), np.arange(stones), indexing="ij"), -1).reshape(-1, 2) + 0.5
    spots = spots.astype(float)
    spots[:, 1] += 0.5 * (spots[:, 0].astype(int) % 2)
    spots = (spots + rng.uniform(-jitter, jitter, spots.shape)) / stones
    row, column = grid(size)
    points = np.stack([row, column], -1) / size
    away = np.abs(points[:, :, None] - spots)
    distance = np.linalg.norm(np.minimum(away, 1 - away), axis=-1)
    order = np.argsort(distance, axis=-1)[..., :2]
    near = np.take_along_axis(distance, order, -1)
    shade = rng.uniform(0.8, 1.15, len(spots))[order[..., 0]]
    edge = np.clip((near[..., 1] - near[..., 0]) * stones / 0.09, 0, 1)
    image = tone(color, shade * (0.86 + 0.28 * noise(size, 1.0, seed + 2)))
    return mix(np.broadcast_to(np.asarray(accent, float), image.shape), image, edge)


@pattern("slabs")
def slabs(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint cast concrete: one joint at the edge of the picture, stains, fine grit."""
    image = speckle(size, color, accent, seed, 0.32, 0.8)
    row, column = grid(size)
    return mix(image, accent, 0.8 * ((row < 2) | (column < 2)))


@pattern("grass")
def grass(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint ground cover with patches of the accent colour."""
    blades, patches = noise(size, 0.9, seed), noise(size, 2.0, seed + 1)
    return mix(tone(color, 0.6 + 0.8 * blades), accent, np.clip((patches - 0.58) * 2.5, 0, 0.8))


@pattern("bark")
def bark(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint ridges that run along u."""
    ridge = noise(size, 1.1, seed, (5.0, 0.9))
    return mix(tone(color, 0.75 + 0.5 * ridge), accent, np.clip((0.42 - ridge) * 5, 0, 0.85))


@pattern("weave")
def weave(size: int, color: ArrayLike, accent: ArrayLike, seed: int, threads: float = 32) -> Floats:
    """Paint plain cloth of ``threads`` threads each way."""
    row, column = grid(size)
    cloth = 0.5 + 0.25 * (np.sin(2 * math.pi * threads * column / size) + np.sin(2 * math.pi * threads * row / size))
    return tone(color, 0.9 + 0.1 * cloth + 0.14 * (noise(size, 1.5, seed) - 0.5))


@pattern("leaves")
def leaves(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint dense foliage: light leaves over dark gaps."""
    cover = noise(size, 0.75, seed)
    return mix(accent, tone(color, 0.7 + 0.6 * noise(size, 0.4, seed + 1)), np.clip((cover - 0.3) * 2.6, 0, 1))


@pattern("stripes")
def stripes(size: int, color: ArrayLike, accent: ArrayLike, seed: int, count: float = 8) -> Floats:
    """Paint vertical stripes, ``count`` of each colour."""
    _, column = grid(size)
    band = (column * int(count) * 2 // size) % 2
    return mix(color, accent, band.astype(float)) * (0.95 + 0.1 * noise(size, 1.5, seed))[..., None]


@pattern("persian")
def persian(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint one quarter-symmetric carpet: borders, a medallion, small figures. Covers the rug once."""
    row, column = grid(size)
    x, y = np.abs(column / (size - 1) * 2 - 1), np.abs(row / (size - 1) * 2 - 1)
    rim = np.maximum(x, y)
    dark = np.asarray(color) * 0.35
    figure = np.sin(x * 34) * np.sin(y * 34) > 0.45
    medallion = x * 1.1 + y < 0.52
    heart = x * 1.1 + y < 0.3
    image = mix(color, accent, 0.55 * figure)
    image = np.where(medallion[..., None], mix(dark, accent, 0.7 * figure), image)
    image = np.where(heart[..., None], np.asarray(accent), image)
    border = (rim > 0.74) & (rim < 0.9)
    beads = np.sin(np.arctan2(y, x) * 40) * np.sin(rim * 40) > 0.2
    image = np.where(border[..., None], mix(dark, accent, 0.75 * beads), image)
    lines = (np.abs(rim - 0.74) < 0.012) | (np.abs(rim - 0.9) < 0.012) | (rim > 0.975)
    image = np.where(lines[..., None], np.asarray(accent), image)
    return image * (0.88 + 0.24 * noise(size, 0.6, seed))[..., None]


@pattern("shingles")
def shingles(size: int, color: ArrayLike, accent: ArrayLike, seed: int, count: float = 6) -> Floats:
    """Paint ``count`` overlapping rows of shingles, each with a shadow under its edge."""
    courses = int(count)
    image = brick(size, color, accent, seed, courses, courses, 0.6)
    row, _ = grid(size)
    return image * (0.7 + 0.3 * (row * courses % size) / size)[..., None]


@pattern("corrugated")
def corrugated(size: int, color: ArrayLike, accent: ArrayLike, seed: int, count: float = 12) -> Floats:
    """Paint ``count`` vertical waves of sheet metal with a little rust."""
    _, column = grid(size)
    wave = 0.5 + 0.5 * np.sin(2 * math.pi * int(count) * column / size)
    return mix(accent, color, wave) * (0.9 + 0.2 * noise(size, 1.5, seed, (1.0, 4.0)))[..., None]


@pattern("book_spines")
def book_spines(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint a row of standing books with gilt bands."""
    rng = np.random.default_rng(seed)
    image = np.zeros((size, size, 3))
    start = 0
    while start < size:
        width = int(rng.integers(size // 28, size // 12))
        cover = np.asarray(color) * rng.uniform(0.4, 1.5) * rng.uniform(0.6, 1.2, 3)
        image[:, start : start + width] = cover
        image[:, start] *= 0.3
        for band in rng.uniform(0.1, 0.9, 2):
            low = int(band * size)
            image[low : low + size // 60, start + 1 : start + width] = accent
        start += width
    return np.clip(image, 0, 1)


@pattern("water")
def water(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint ripples along u."""
    ripple = noise(size, 1.4, seed, (2.5, 0.8))
    return mix(color, accent, np.clip((ripple - 0.5) * 2.2, 0, 0.7))


@pattern("newsprint")
def newsprint(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint a front page: headline, picture, columns of grey lines. Covers the sheet once."""
    row, column = grid(size)
    x, y = column / size, 1 - row / size
    rng = np.random.default_rng(seed)
    ink = np.zeros((size, size))
    words = rng.random((size, size // 8))[row, column // 8] < 0.82
    in_column = (x * 4 % 1 > 0.07) & (x * 4 % 1 < 0.95) & (x > 0.04) & (x < 0.96)
    ink[(y > 0.32) & (y < 0.96) & in_column & (y * 60 % 1 < 0.5) & words] = 0.6
    ink[(y > 0.07) & (y < 0.14) & (x > 0.06) & (x < 0.94) & (rng.random(size // 6 + 1)[column // 6] < 0.8)] = 0.95
    ink[(y > 0.18) & (y < 0.23) & (x > 0.1) & (x < 0.9) & (rng.random(size // 4 + 1)[column // 4] < 0.75)] = 0.8
    photo = (x > 0.3) & (x < 0.7) & (y > 0.32) & (y < 0.58)
    ink[photo] = 0.25 + 0.6 * noise(size, 1.8, seed)[photo]
    return mix(color, accent, ink)


@pattern("map")
def world_map(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint land (color) and sea (accent) with a graticule."""
    height = noise(size, 2.1, seed)
    image = mix(accent, tone(color, 0.8 + 0.4 * noise(size, 1.2, seed + 1)), (height > 0.52).astype(float))
    coast = np.abs(height - 0.52) < 0.008
    row, column = grid(size)
    lines = (row % (size // 8) == 0) | (column % (size // 8) == 0)
    image[coast] *= 0.35
    image[lines] *= 0.75
    return image


@pattern("clock_face")
def clock_face(
    size: int, color: ArrayLike, accent: ArrayLike, seed: int, hour: float = 10, minute: float = 9
) -> Floats:
    """Paint a dial with twelve marks and two hands at ``hour`` and ``minute``. Covers the clock once."""
    row, column = grid(size)
    x, y = column / (size - 1) * 2 - 1, row / (size - 1) * 2 - 1
    radius, angle = np.hypot(x, y), np.degrees(np.arctan2(x, y)) % 360
    off_mark = np.abs((angle + 15) % 30 - 15)
    ink = (radius > 0.78) & (radius < 0.92) & (off_mark * radius < 2.4)
    ink |= (radius > 0.95) | (radius < 0.05)
    for degrees, length, width in ((hour * 30 + minute / 2, 0.5, 0.045), (minute * 6, 0.76, 0.028)):
        along = x * math.sin(math.radians(degrees)) + y * math.cos(math.radians(degrees))
        across = x * math.cos(math.radians(degrees)) - y * math.sin(math.radians(degrees))
        ink |= (along > -0.1) & (along < length) & (np.abs(across) < width)
    return mix(color, accent, ink.astype(float))


@pattern("screen")
def screen(size: int, color: ArrayLike, accent: ArrayLike, seed: int) -> Floats:
    """Paint a lit display: a dark ground with lines of text and a panel."""
    row, column = grid(size)
    x, y = column / size, 1 - row / size
    rng = np.random.default_rng(seed)
    length = rng.uniform(0.25, 0.5, 24)[np.minimum((y * 22).astype(int), 23)]
    text = (x > 0.06) & (x < 0.06 + length) & (y * 22 % 1 < 0.45) & (y > 0.1) & (y < 0.92)
    panel = (x > 0.62) & (x < 0.94) & (y > 0.12) & (y < 0.6)
    bar = y < 0.06
    return mix(accent, color, np.clip(text + 0.55 * panel + 0.8 * bar, 0, 1).astype(float))
