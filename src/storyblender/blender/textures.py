"""Painted patterns as packed Blender images, made once per colour and reused by name."""

from __future__ import annotations

import bpy
import numpy as np

import storyblender.look.backdrop_patterns  # noqa: F401  registers its patterns
from storyblender.catalog.materials import MaterialEntry
from storyblender.look.patterns import PATTERNS, Floats
from storyblender.memory.base import Color, content_hash


def paint(entry: MaterialEntry, color: Color) -> Floats:
    """Return the (pixels, pixels, 3) scene-linear picture of a patterned material in ``color``."""
    seed = int(content_hash(entry.key)[:8], 16)
    return np.clip(PATTERNS[entry.pattern](entry.pixels, color, entry.accent, seed, **entry.params), 0, 1)


def image(name: str, picture: Floats) -> bpy.types.Image:
    """Return the packed sRGB image of that name, created from ``picture`` (h, w, 3), scene-linear, bottom row first."""
    found = bpy.data.images.get(name)
    if found is not None:
        return found
    height, width = picture.shape[:2]
    block = bpy.data.images.new(name, width, height, alpha=False)
    pixels = np.ones((height, width, 4), np.float32)
    pixels[..., :3] = np.where(picture <= 0.0031308, picture * 12.92, 1.055 * picture ** (1 / 2.4) - 0.055)
    block.pixels.foreach_set(pixels.ravel())
    block.update()
    block.pack()
    return block
