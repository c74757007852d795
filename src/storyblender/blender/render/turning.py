"""Which way surfaces are turned and what they are made of, in one Workbench picture.

A matcap colours a surface by its normal, times the colour of its material. Blender's own ``check_normal+y`` tells a
normal in red and green; ours (``turning.exr``, made from it) has 1 in blue, so that blue tells the material's number.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.render.exr import Channels
from storyblender.blender.render.session import changed
from storyblender.look.gbuffer import View

_MATCAP = Path(__file__).with_name("turning.exr")
_BAND = 128
"""Rows decoded at a time; keeps the float32 temporaries small."""
_FIRST, _STEP = 1024, 4
"""Bits of the half float that tells number 0, the smallest that is exact, and what each number adds: the matcap is
filtered, which may shift a value by one."""


def turning_matcap() -> str:
    """Return the name of the matcap for ``shading.studio_light``; a new or opened file may not have it yet."""
    lights = bpy.context.preferences.studio_lights
    if _MATCAP.name not in lights:
        lights.load(str(_MATCAP), "MATCAP")
    return _MATCAP.name


@contextmanager
def told_in_blue(materials: Sequence[bpy.types.Material]) -> Iterator[None]:
    """Write every material's number (from 1) into its viewport colour, as the bits of a half float in blue."""
    numbers = np.arange(len(materials) + 1, dtype=np.uint16) * _STEP + _FIRST
    with ExitStack() as stack:
        for material, blue in zip(materials, numbers.view(np.float16)[1:].tolist(), strict=True):
            stack.enter_context(changed(material, {"diffuse_color": (1.0, 1.0, blue, 1.0)}))
        yield


def turned_and_made(channels: Channels, view: View) -> tuple[NDArray[np.float16], NDArray[np.uint16]]:
    """Return world normals, (h, w, 3), and material numbers, (h, w) from 1, 0 for none, from a picture in the matcap.

    The matcap stores sRGB-encoded x and y of the normal in a basis that turns with the view ray: z towards the eye,
    x horizontal (measured in notes: sets and light, "traps met"). Numpy works on planes five times as fast as on pixels
    of three values, so the basis is written out.

    Args:
        channels: Of the picture, drawn with ``turning_matcap`` and ``told_in_blue``.
        view: The camera that drew it.
    """
    slope, climb = view.slopes()
    side_x = 1 / np.sqrt(1 + slope * slope)
    side_z = slope * side_x
    axes = view.axes.T.astype(np.float32)
    normal, material = (
        np.empty((view.height, view.width, 3), np.float16),
        np.empty((view.height, view.width), np.uint16),
    )
    for top in range(0, view.height, _BAND):
        rows = slice(top, top + _BAND)
        red, green, blue = (channels[f"Combined.{name}"][rows].astype(np.float16).view(np.uint16) for name in "RGB")
        material[rows] = (np.maximum(blue, _FIRST) - np.uint16(_FIRST - _STEP // 2)) // np.uint16(_STEP)
        x, y = _NORMAL_OF[red], _NORMAL_OF[green]
        flat = x * x + y * y
        z = np.sqrt(np.maximum(1 - flat, 0))
        length = np.sqrt(np.maximum(flat, 1))
        toward_z = 1 / np.sqrt(1 + slope * slope + climb[rows, None] ** 2)
        toward_x, toward_y = -slope * toward_z, -climb[rows, None] * toward_z
        local = (
            x * side_x + y * (toward_y * side_z) + z * toward_x,
            y * (toward_z * side_x - toward_x * side_z) + z * toward_y,
            x * side_z - y * (toward_y * side_x) + z * toward_z,
        )
        for axis in range(3):
            normal[rows, :, axis] = sum(part * axes[index, axis] for index, part in enumerate(local)) / length
    return normal, material


def encode_srgb(linear: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return scene-linear colours as sRGB, 0 to 1; brighter ones are 1."""
    value = np.clip(linear, 0, 1)
    return np.where(value <= 0.0031308, value * 12.92, 1.055 * value ** (1 / 2.4) - 0.055)


_NORMAL_OF = encode_srgb(np.nan_to_num(np.arange(1 << 16, dtype=np.uint16).view(np.float16).astype(np.float32))) * 2 - 1
"""The part of a normal that each half float of the matcap picture stands for, by its bits."""
