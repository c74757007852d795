"""What the things in a flat picture give off: told by the picture itself where it can be, else drawn again.

A moving camera sees every lamp anew in each frame, and a second picture for what glows costs half of the first one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.hiding import out_of_picture
from storyblender.blender.render.exr import color
from storyblender.blender.render.passes import flat_workbench, glow_of, material_index, material_indices, shading
from storyblender.blender.render.session import RenderSession, changed
from storyblender.look.raster import Image, Window, stacked

_AS_NEAR = 1e-4
"""Difference of depth, as a share of it, up to which two pictures show the same thing."""
_BEYOND = 2.0
"""Brighter than any colour: a material's number begins here. Half floats hold whole numbers exactly up to 2048."""


@dataclass(frozen=True)
class Told:
    """Materials of one colour that glow, whose number stands in the picture instead of that colour.

    Attributes:
        materials: By number.
        albedo: (n, 3) their colours.
        glow: (n, 3) what they give off.
    """

    materials: tuple[bpy.types.Material, ...]
    albedo: NDArray[np.float32]
    glow: NDArray[np.float32]

    def read(self, picture: Image) -> tuple[Image, Image]:
        """Return the (h, w, 3) albedo and glow of a picture drawn in ``told_by_number``."""
        red = picture[..., 0]
        places = np.flatnonzero(red > _BEYOND - 0.5)
        numbers = np.rint(red.ravel()[places] - _BEYOND).astype(np.intp)
        albedo = [np.array(picture[..., band]) for band in range(3)]
        glow = [np.zeros_like(red) for _ in range(3)]
        for band in range(3):
            albedo[band].flat[places] = self.albedo[numbers, band]
            glow[band].flat[places] = self.glow[numbers, band]
        return stacked(albedo), stacked(glow)


@contextmanager
def told_by_number() -> Iterator[Told]:
    """Write a number into the viewport colour of every material that glows evenly; it shows unless it has a texture."""
    materials = list(bpy.data.materials)
    glow_color, _ = glow_of(materials)
    found = [
        (material, glow)
        for material, glow in zip(materials, glow_color[1:], strict=True)
        if glow.any() and not any(node.type == "TEX_IMAGE" for node in material.node_tree.nodes)
    ]
    told = tuple(material for material, _ in found)
    albedo = np.array([material.diffuse_color[:3] for material in told], np.float32).reshape(-1, 3)
    glow = np.array([glow for _, glow in found], np.float32).reshape(-1, 3)
    with ExitStack() as stack:
        for number, material in enumerate(told):
            stack.enter_context(changed(material, {"diffuse_color": (_BEYOND + number, 0.0, 0.0, 1.0)}))
        yield Told(told, albedo, glow)


def render_glow(
    session: RenderSession,
    frames: Sequence[int],
    size: tuple[int, int],
    depths: Sequence[Image],
    told: Told,
    window: Window | None = None,
) -> list[Image] | None:
    """Return the (h, w, 3) light of what is not told, frame by frame; None where there is no such thing.

    Only what glows is drawn again, and seen where nothing stands before it.

    Args:
        session: The shot.
        frames: Timeline frames.
        size: Width and height of the whole picture, pixels.
        depths: Of each frame's picture, metres.
        told: What the pictures tell themselves.
        window: The part to draw; None is all.
    """
    materials = list(bpy.data.materials)
    glow_color, glow_gain = glow_of(materials)
    for index, material in enumerate(materials, 1):
        if material in told.materials:
            glow_color[index] = 0
    lit = {material for index, material in enumerate(materials, 1) if glow_color[index].any() or glow_gain[index] > 0}
    dark = [obj for obj in session.visible_objects() if not any(slot.material in lit for slot in obj.material_slots)]
    if len(dark) == len(session.visible_objects()):
        return None
    with flat_workbench(session.scene), out_of_picture(dark):
        with shading(session.scene, light="FLAT", color_type="MATERIAL"), material_indices(materials):
            pictures = session.exr_frames(frames, *size, depth=True, window=window)
        indices = [
            np.where(channels["Depth.Z"] <= depth * np.float32(1 + _AS_NEAR), material_index(channels, materials), 0)
            for channels, depth in zip(pictures, depths, strict=True)
        ]
        glows = [glow_color[index] for index in indices]
        if any(glow_gain[index].any() for index in indices):
            with shading(session.scene, light="FLAT", color_type="TEXTURE"):
                pictures = session.exr_frames(frames, *size, window=window)
            for glow, index, channels in zip(glows, indices, pictures, strict=True):
                glow += color(channels) * glow_gain[index][..., None]
    return glows
