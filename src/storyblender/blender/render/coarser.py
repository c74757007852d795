"""Coarser copies of the pictures that surfaces of a set are made of, drawn where the whole ones are too fine."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.render.exr import color
from storyblender.blender.render.session import RenderSession, changed
from storyblender.blender.sets.textured import TEXTURED
from storyblender.look.far_textures import HALVINGS, halvings, shares
from storyblender.look.gbuffer import View
from storyblender.look.raster import window_around


def textured(materials: Sequence[bpy.types.Material]) -> list[bpy.types.Material]:
    """Return the materials that are made of pictures."""
    return [block for block in materials if TEXTURED in block]


@contextmanager
def in_coarser_pictures(materials: Sequence[bpy.types.Material], times: int) -> Iterator[None]:
    """Let materials that are made of pictures show copies of them.

    Args:
        materials: Of the file.
        times: How often the copies are halved.
    """
    with ExitStack() as stack:
        for block in textured(materials):
            for node in block.node_tree.nodes:
                if node.type == "TEX_IMAGE":
                    stack.enter_context(changed(node, {"image": _halved(node.image, times)}))
        yield


def draw_far_textures(
    session: RenderSession,
    albedo: NDArray[np.float16],
    material: NDArray[np.uint16],
    depth: NDArray[np.float32],
    normal: NDArray[np.float16],
    view: View,
    materials: Sequence[bpy.types.Material],
) -> NDArray[np.float32] | None:
    """Lay coarser copies of pictures over the albedo, in place, where the whole ones are too fine for the pixels.

    Args:
        session: The frame; Workbench is set up for flat passes of textures.
        albedo: (h, w, 3).
        material: (h, w) index from 1 into the materials.
        depth: (h, w) metres.
        normal: (h, w, 3) world, unit.
        view: The camera, of this size.
        materials: All of the file.

    Returns:
        (h, w) what is left of the pictures' relief, 0 to 1; None where nothing is made of pictures.
    """
    texels, means = np.zeros(len(materials) + 1, np.float32), np.zeros((len(materials) + 1, 3), np.float32)
    for index, block in enumerate(materials, 1):
        if TEXTURED in block:
            texels[index] = block.node_tree.nodes.active.image.size[0] / float(block["tile"])
            means[index] = block.diffuse_color[:3]
    at = np.flatnonzero(texels[material] > 0)
    if not len(at):
        return None
    rows, columns = np.divmod(at, view.width)
    made = material.take(at)
    surface = normal.reshape(-1, 3)[at].astype(np.float32)
    whole, *copies, mean = shares(halvings(texels[made], depth.take(at), surface, rows, columns, view))
    flat = albedo.reshape(-1, 3)
    laid = flat[at].astype(np.float32) * whole[:, None] + means[made] * mean[:, None]
    for times, share in zip(HALVINGS, copies, strict=True):
        here = np.flatnonzero(share > 0)
        if not len(here):
            continue
        needed = np.zeros(material.shape, bool)
        needed.flat[at[here]] = True
        window = window_around(needed)
        with in_coarser_pictures(materials, times):
            (drawn,) = session.exr_frames([session.scene.frame_current], view.width, view.height, window=window)
        laid[here] += color(drawn)[needed[window.cut]] * share[here, None]
    flat[at] = laid
    relief = np.ones(material.shape, np.float32)
    relief.flat[at] = whole + copies[0]
    return relief


def _halved(image: bpy.types.Image, times: int) -> bpy.types.Image:
    """Return a copy of a picture that was halved so often, made once; no material of a saved file uses it."""
    name = f"{image.name} / {2**times}"
    found = bpy.data.images.get(name)
    if found is not None:
        return found
    width, height = image.size
    step = min(2**times, width, height)
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    shown = pixels.reshape(height, width, 4)[: height // step * step, : width // step * step, :3]
    encoded = image.colorspace_settings.name == "sRGB"
    linear = np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4) if encoded else shown
    small = linear.reshape(height // step, step, width // step, step, 3).mean(axis=(1, 3))
    stored = np.where(small <= 0.0031308, small * 12.92, 1.055 * small ** (1 / 2.4) - 0.055) if encoded else small
    block = bpy.data.images.new(name, width // step, height // step, alpha=False)
    block.colorspace_settings.name = image.colorspace_settings.name
    block.pixels.foreach_set(np.dstack([stored, np.ones(stored.shape[:2], np.float32)]).astype(np.float32).ravel())
    block.update()
    return block
