"""Scene-linear light to display values: AgX through OpenColorIO, or a filmic curve where that is missing."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from storyblender.look.bundled import blender_folder, bundled_module
from storyblender.look.raster import Image

AGX_CONTRAST = "AgX - High Contrast"
"""Keeps faces, deepens the room and gives a sunny street its sparkle (chosen by eye among the five)."""

_TABLE = 49
"""Steps of a film's table along each colour."""
_STOPS = (-12.0, 7.0)
"""Stops of light round 1 that a film's table spans."""


def to_display(image: Image, contrast: str = AGX_CONTRAST) -> Image:
    """Return display-referred sRGB, 0 to 1.

    Args:
        image: (h, w, 3) scene-linear Rec. 709.
        contrast: Name of an AgX look of Blender's colour configuration.
    """
    processor = display_of(contrast)
    if processor is None:
        return _filmic(image)
    display = np.array(image, np.float32, order="C", copy=True)
    processor.applyRGB(display)
    return np.clip(display, 0, 1, out=display)


def to_film(image: Image) -> Image:
    """Return what ``to_display`` does to within a shade or two of 255, in under half the time; for films."""
    processor = _table_of(AGX_CONTRAST)
    if processor is None:
        return _filmic(image)
    display = np.array(image, np.float32, order="C", copy=True)
    processor.applyRGB(display)
    return np.clip(display, 0, 1, out=display)


def to_bytes(display: Image) -> NDArray[np.uint8]:
    """Round display values to 8 bits."""
    return (np.clip(display, 0, 1) * 255 + 0.5).astype(np.uint8)


@cache
def display_of(contrast: str) -> Any:
    """Return OpenColorIO's way from light to display for an AgX look, None without it; a first call takes a while."""
    folder, ocio = blender_folder(), bundled_module("PyOpenColorIO")
    if folder is None or ocio is None:
        return None
    config = ocio.Config.CreateFromFile(str(folder / "datafiles" / "colormanagement" / "config.ocio"))
    transform = ocio.DisplayViewTransform(src="Linear Rec.709", display="sRGB", view="AgX")
    pipeline = ocio.LegacyViewingPipeline()
    pipeline.setDisplayViewTransform(transform)
    pipeline.setLooksOverrideEnabled(True)
    pipeline.setLooksOverride(contrast)
    return pipeline.getProcessor(config, config.getCurrentContext()).getDefaultCPUProcessor()


@cache
def _table_of(contrast: str) -> Any:
    """Return the way from light to display as a table over the stops of light; None without OpenColorIO."""
    exact, ocio = display_of(contrast), bundled_module("PyOpenColorIO")
    if exact is None or ocio is None:
        return None
    darkest, brightest = _STOPS
    levels = np.exp2(np.linspace(darkest, brightest, _TABLE, dtype=np.float32))
    grid = np.stack(np.meshgrid(levels, levels, levels, indexing="ij"), axis=-1).reshape(1, -1, 3)
    exact.applyRGB(grid)
    table = ocio.Lut3DTransform(_TABLE)
    table.setData(grid.ravel())
    table.setInterpolation(ocio.INTERP_TETRAHEDRAL)
    scale = 1 / (brightest - darkest)
    matrix = np.diag([scale, scale, scale, 1.0]).ravel().tolist()
    way = ocio.GroupTransform()
    way.appendTransform(ocio.LogTransform(2.0))
    way.appendTransform(ocio.MatrixTransform(matrix, [-darkest * scale] * 3 + [0.0]))
    way.appendTransform(table)
    return ocio.Config.CreateRaw().getProcessor(way).getDefaultCPUProcessor()


def _filmic(image: Image) -> Image:
    """A rational filmic curve that meets AgX at middle grey and rolls off the highlights (Hable's shape)."""
    x = np.maximum(image, 0) * 0.8
    curve = (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14)
    linear = np.clip(curve, 0, 1)
    return np.where(linear <= 0.0031308, linear * 12.92, 1.055 * linear ** (1 / 2.4) - 0.055).astype(np.float32)
