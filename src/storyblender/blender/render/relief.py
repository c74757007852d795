"""Normal maps of models: the normal that a map tells at each pixel. Workbench, which draws the passes, knows none.

Two more pictures are drawn where such a material is in view: the map as if it were the colour, and the tangents of the
surface, which the asset's mesh has as a colour attribute.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.models.tangents import TANGENTS, tangents_in
from storyblender.blender.render.exr import color
from storyblender.blender.render.session import RenderSession, changed
from storyblender.look.raster import Image, Mask, Window


def with_normal_maps(materials: Sequence[bpy.types.Material]) -> NDArray[np.bool_]:
    """Return for each material, from 1, whether it has a normal map; 0 is none."""
    return np.array([False, *(_map_of(material) is not None for material in materials)])


@contextmanager
def maps_as_colors(materials: Sequence[bpy.types.Material]) -> Iterator[None]:
    """Let Workbench draw the normal maps of materials in place of their colours."""
    with ExitStack() as stack:
        for material in materials:
            node = _map_of(material)
            if node is not None:
                stack.enter_context(changed(material.node_tree.nodes, {"active": node}))
        yield


def normals_in_maps(
    session: RenderSession,
    size: tuple[int, int],
    window: Window,
    mapped: Mask,
    turns: NDArray[np.float32],
    normal: NDArray[np.float32],
    materials: Sequence[bpy.types.Material],
) -> Image:
    """Return the (n, 3) world normals that the maps tell.

    Args:
        session: The frame; Workbench is set up for flat passes.
        size: Width and height of the whole picture.
        window: The part of it to draw.
        mapped: (h, w) of the window: the n pixels with a normal map.
        turns: (n, 3, 3) the rotation of the object at each of them.
        normal: (n, 3) the surface's own world normals.
        materials: All of the file.
    """
    frame, shades = session.scene.frame_current, session.scene.display.shading
    with changed(shades, {"light": "FLAT", "color_type": "VERTEX"}):
        (drawn,) = session.exr_frames([frame], *size, window=window)
    along, side = tangents_in(color(drawn)[mapped])
    with changed(shades, {"light": "FLAT", "color_type": "TEXTURE"}), maps_as_colors(materials):
        (drawn,) = session.exr_frames([frame], *size, window=window)
    told = color(drawn)[mapped] * 2 - 1
    along = np.einsum("nij,nj->ni", turns, along)
    along -= normal * np.sum(along * normal, axis=1, keepdims=True)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-6)
    across = np.cross(normal, along) * side[:, None]
    found = along * told[:, :1] + across * told[:, 1:2] + normal * np.maximum(told[:, 2:], 0.05)
    return (found / np.maximum(np.linalg.norm(found, axis=1, keepdims=True), 1e-6)).astype(np.float32)


def turns_of(objects: Sequence[bpy.types.Object], gids: Sequence[int]) -> NDArray[np.float32]:
    """Return the (most gid + 1, 3, 3) rotations of objects by the gid that their pixels have.

    Args:
        objects: All that is drawn.
        gids: One for each.
    """
    turns = np.tile(np.eye(3, dtype=np.float32), (max(gids, default=0) + 1, 1, 1))
    for obj, gid in zip(objects, gids, strict=True):
        if obj.type == "MESH" and TANGENTS in obj.data.color_attributes:
            turns[gid] = np.array(obj.matrix_world.to_3x3().normalized())
    return turns


def _map_of(material: bpy.types.Material) -> bpy.types.Node | None:
    """Return the picture node of a material's normal map."""
    for node in material.node_tree.nodes if material.use_nodes and material.node_tree else ():
        if node.type == "NORMAL_MAP" and node.inputs["Color"].is_linked:
            source = node.inputs["Color"].links[0].from_node
            return source if source.type == "TEX_IMAGE" else None
    return None
