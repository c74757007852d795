"""Light at low resolution, texture at full: demodulate by albedo, upsample along edges, remodulate (notes 0.3)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.look.gbuffer import GBuffer
from storyblender.look.raster import Image, every, shrink

FLOOR = 0.04
"""Reflectance added to every albedo, so that gloss on black survives the division."""
_MIXED, _BEND = 0.002, 0.01
"""Least weight of a block of light that mixes surfaces, and the bend of its depth at which it begins to."""
_SAME_DEPTH = 0.02
"""Difference of depth, as a share of it, at which two pixels begin to show different things."""


def demodulate(picture: Image, albedo: Image) -> Image:
    """Return the illumination of an (h, w, 3) linear picture, rendered over an ``albedo`` of the same size."""
    return picture / (albedo + FLOOR)


def remodulate(illumination: Image, albedo: Image) -> Image:
    """Return the linear picture of an (h, w, 3) illumination over an albedo of the same size."""
    return illumination * (albedo + FLOOR)


def upsample(low: Image, gbuffer: GBuffer, factor: int) -> Image:
    """Enlarge a low-resolution image by ``factor`` without bleeding over edges of depth or normal.

    Args:
        low: (h, w, 3).
        gbuffer: Of the same frame; its size a multiple of h * factor.
        factor: Enlargement.

    Returns:
        (h * factor, w * factor, 3).
    """
    height, width = low.shape[:2]
    coarse, fine = gbuffer.view.height // height, gbuffer.view.height // (height * factor)
    depth, normal = every(gbuffer.depth, fine), every(gbuffer.normal, fine)
    middle = every(gbuffer.depth, coarse)
    planes = (*_planes(low), *_planes(every(gbuffer.normal, coarse)), middle, _whole(gbuffer.depth, middle, coarse))
    padded = np.pad(np.stack(planes), ((0, 0), (1, 1), (1, 1)), mode="edge")
    result = np.empty((height * factor, width * factor, 3), np.float32)
    for row, down in enumerate(_between(factor)):
        for column, across in enumerate(_between(factor)):
            own = slice(row, None, factor), slice(column, None, factor)
            mixed = _blend(padded, depth[own], _planes(normal[own]), down, across)
            for band, plane in enumerate(mixed):
                result[(*own, band)] = plane
    return result


def _planes(pixels: NDArray) -> list[Image]:
    """Return the values of (h, w, 3) pixels one by one: numpy works on those three times as fast."""
    return [np.ascontiguousarray(pixels[..., band], np.float32) for band in range(3)]


def _between(factor: int) -> list[tuple[int, float]]:
    """Return for each pixel of a block the first of the two low pixels round it (-1 or 0) and the way to the other."""
    places = [(pixel + 0.5) / factor - 0.5 for pixel in range(factor)]
    return [(math.floor(place), place - math.floor(place)) for place in places]


def _whole(depth: Image, middle: Image, step: int) -> Image:
    """Return 1 for each block of ``step`` pixels that shows one surface, down to a little where it mixes near and far.

    The corners of a block on a plane, however it recedes, mirror each other about its middle in 1 / depth.
    """
    last = step - 1
    bent = np.zeros_like(middle)
    for (top, left), (bottom, right) in (((0, 0), (last, last)), ((0, last), (last, 0))):
        corners = 1 / depth[top::step, left::step] + 1 / depth[bottom::step, right::step]
        bent += np.abs(corners * middle - 2)
    return _MIXED + (1 - _MIXED) * np.exp(-bent / _BEND)


def _blend(
    low: Image, depth: Image, normal: Sequence[Image], down: tuple[int, float], across: tuple[int, float]
) -> list[Image]:
    """Mix, for one pixel of every block, the four nearest low pixels, weighted by nearness, depth and normal.

    Args:
        low: Planes with a pixel more on each side: colour, normal, depth, and how whole the surface is.
        depth: (h, w) of these pixels.
        normal: Its planes.
        down: First row of low pixels and the share of the second.
        across: The same for columns.
    """
    height, width = depth.shape
    tolerance = 0.01 * depth + 0.01
    mixed, weights = [np.zeros_like(depth) for _ in range(3)], np.zeros_like(depth)
    for row, high in ((down[0], 1 - down[1]), (down[0] + 1, down[1])):
        for column, wide in ((across[0], 1 - across[1]), (across[0] + 1, across[1])):
            near = low[:, row + 1 : row + 1 + height, column + 1 : column + 1 + width]
            facing = sum(theirs * own for theirs, own in zip(near[3:6], normal, strict=True))
            facing = np.square(np.square(np.maximum(np.float32(0.02), facing)))
            level = np.exp(-np.abs(near[6] - depth) / tolerance)
            weight = np.float32(high * wide + 0.02) * level * facing * near[7] + np.float32(1e-5)
            weights += weight
            for plane, light in zip(mixed, near[:3], strict=True):
                plane += light * weight
    return [plane / weights for plane in mixed]


def upsample_by_depth(low: Image, low_depth: Image, depth: Image) -> Image:
    """Return planes at twice their size: each pixel mixes its four nearest low ones, those at its depth before all.

    Args:
        low: (c, h, w) planes, which numpy mixes three times as fast as pixels of c values.
        low_depth: (h, w) metres.
        depth: (2h, 2w) metres.
    """
    planes, (height, width) = low.shape[0], low_depth.shape
    padded = np.pad(low, ((0, 0), (1, 1), (1, 1)), mode="edge")
    levels = np.pad(low_depth, 1, mode="edge")
    result = np.empty((planes, 2 * height, 2 * width), np.float32)
    for y, x in ((0, 0), (0, 1), (1, 0), (1, 1)):
        own = depth[y::2, x::2]
        tolerance = (_SAME_DEPTH * own) ** 2
        parts, shares = [], []
        for row, down in ((1, 0.75), (2 * y, 0.25)):
            for column, across in ((1, 0.75), (2 * x, 0.25)):
                part = (slice(row, row + height), slice(column, column + width))
                parts.append(part)
                likeness = tolerance / (tolerance + (levels[part] - own) ** 2)
                shares.append(down * across * (likeness * likeness) + np.float32(1e-6))
        whole = 1 / (shares[0] + shares[1] + shares[2] + shares[3])
        for plane in range(planes):  # one plane at a time stays in the processor's cache
            light = padded[plane]
            mixed = light[parts[0]] * shares[0]
            for part, share in zip(parts[1:], shares[1:], strict=True):
                mixed += light[part] * share
            np.multiply(mixed, whole, out=result[plane, y::2, x::2])
    return result


def mean_albedo(gbuffer: GBuffer, step: int, sky: Image | None = None) -> Image:
    """Return the albedo averaged over blocks of ``step`` pixels, in bands to save memory.

    Args:
        gbuffer: Any size.
        step: Block size.
        sky: (h / step, w / step, 3) what stands in for albedo where the sky shows; black if None.
    """
    height, width = gbuffer.view.height // step, gbuffer.view.width // step
    result = np.empty((height, width, 3), np.float32)
    band = 64
    for top in range(0, height, band):
        rows = slice(top * step, (top + band) * step)
        result[top : top + band] = shrink(gbuffer.albedo[rows], step)
    if sky is not None:
        result += sky * shrink(gbuffer.sky.astype(np.float32), step)[..., None]
    return result
