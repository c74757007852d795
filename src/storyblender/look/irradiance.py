"""Light from all sides as nine numbers a colour: irradiance in spherical harmonics of order 2.

Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001, equations 3 and
8 to 12. A coefficient here is theirs with the cosine lobe in it, over pi: the sum over the basis is irradiance / pi,
the luminance of a white diffuse surface, as everywhere in ``look``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.look.raster import Image, stacked

_LOBE = np.array([1.0] + [2 / 3] * 3 + [1 / 4] * 5)
"""The clamped cosine over pi, by order (equation 8)."""


def panorama_directions(height: int, width: int) -> NDArray[np.float64]:
    """Return the (h, w, 3) unit vectors along which the pixels of an equirectangular picture are seen.

    As in Blender: the middle of the picture is +X, and the azimuth falls from left to right.

    Args:
        height: Pixels; the first row is the zenith's.
        width: Pixels.
    """
    elevation = np.pi * (0.5 - (np.arange(height) + 0.5) / height)[:, None]
    azimuth = 2 * np.pi * (0.5 - (np.arange(width) + 0.5) / width)[None]
    level = np.cos(elevation)
    up = np.broadcast_to(np.sin(elevation), (height, width))
    return np.stack([level * np.cos(azimuth), level * np.sin(azimuth), up], axis=-1).astype(np.float64)


def solid_angles(height: int, width: int) -> NDArray[np.float64]:
    """Return the (h, 1) solid angles, in steradians, of the pixels of each row; all pixels together have 4 pi.

    Args:
        height: Pixels of an equirectangular picture.
        width: Pixels.
    """
    edges = np.sin(np.pi * (0.5 - np.arange(height + 1) / height))
    return (edges[:-1] - edges[1:])[:, None] * (2 * np.pi / width)


def irradiance_of(radiance: Image) -> NDArray[np.float64]:
    """Return the (9, 3) coefficients of the irradiance from an (h, w, 3) equirectangular picture."""
    height, width = radiance.shape[:2]
    weighted = radiance * solid_angles(height, width)[..., None]
    basis = _basis(panorama_directions(height, width))
    sums = np.array([(weighted * each[..., None]).sum(axis=(0, 1)) for each in basis], np.float64)
    return sums * _LOBE[:, None]


def turned(coefficients: NDArray[np.float64], yaw: float) -> NDArray[np.float64]:
    """Return (9, 3) coefficients turned about Z by ``yaw`` degrees, counter-clockwise from above."""
    result = coefficients.copy()
    for cosine, sine, order in ((3, 1, 1), (7, 5, 1), (8, 4, 2)):
        c, s = math.cos(math.radians(yaw) * order), math.sin(math.radians(yaw) * order)
        result[cosine] = c * coefficients[cosine] - s * coefficients[sine]
        result[sine] = s * coefficients[cosine] + c * coefficients[sine]
    return result


def mean_irradiance(coefficients: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the (3,) mean over all normals of irradiance / pi, which is the mean radiance."""
    return coefficients[0] * 0.282095


def irradiance_at(coefficients: Sequence[Sequence[float]], normal: Image) -> Image:
    """Return irradiance / pi of surfaces with (h, w, 3) unit normals; never below zero.

    Args:
        coefficients: (9, 3).
        normal: World, unit.
    """
    basis = _basis(normal)
    bands = zip(*coefficients, strict=True)
    light = [sum(np.float32(value) * each for value, each in zip(band, basis, strict=True)) for band in bands]
    return stacked([np.maximum(band, np.float32(0)).astype(np.float32) for band in light])


def _basis(direction: NDArray) -> list[NDArray]:
    """Return the nine real spherical harmonics of (..., 3) unit vectors: orders 0, 1 (y, z, x) and 2 (equation 3)."""
    x, y, z = direction[..., 0], direction[..., 1], direction[..., 2]
    first, second = direction.dtype.type(0.488603), direction.dtype.type(1.092548)
    return [
        np.full_like(x, 0.282095), first * y, first * z, first * x,
        second * x * y, second * y * z, direction.dtype.type(0.315392) * (3 * z * z - 1), second * x * z,
        direction.dtype.type(0.546274) * (x * x - y * y),
    ]  # fmt: skip
