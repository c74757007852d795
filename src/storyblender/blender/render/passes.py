"""Workbench flat passes to the G-buffer: ids, depth, normals, materials, albedo (notes: sets and light, section 0)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import partial
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.render.coarser import draw_far_textures
from storyblender.blender.render.exr import Channels, color
from storyblender.blender.render.relief import normals_in_maps, turns_of, with_normal_maps
from storyblender.blender.render.session import RenderSession, changed
from storyblender.blender.render.turning import told_in_blue, turned_and_made, turning_matcap
from storyblender.catalog.materials import MATERIALS, MaterialEntry
from storyblender.look.fading import fade_repeats
from storyblender.look.gbuffer import FAR, GBuffer
from storyblender.look.raster import window_around
from storyblender.look.surface import PERSON, Surface

_HAS_SKIN_COLORS = 16
"""Added to the class of objects whose albedo is in vertex colours."""


@dataclass(frozen=True)
class Node:
    """What a gid of the G-buffer stands for."""

    node_id: str
    asset_id: str
    kind: str


@dataclass(frozen=True)
class Passes:
    """A G-buffer and the nodes its ids name; ``nodes[gid - 1]``."""

    gbuffer: GBuffer
    nodes: tuple[Node, ...]

    def visible_shares(self) -> dict[str, float]:
        """Return the share of the frame that each visible node covers, by node_id."""
        counts = np.bincount(self.gbuffer.ids.ravel(), minlength=len(self.nodes) + 1)
        shares: dict[str, float] = {}
        for node, count in zip(self.nodes, counts[1:], strict=True):
            if count:
                shares[node.node_id] = shares.get(node.node_id, 0.0) + float(count) / self.gbuffer.ids.size
        return shares


def render_passes(session: RenderSession, width: int, height: int) -> Passes:
    """Draw the flat passes of the session's frame, without antialiasing.

    Args:
        session: The open scene, at its frame.
        width: Of the passes, supersampled, pixels.
        height: Of the passes, supersampled, pixels.
    """
    view = session.view(width, height)
    objects = session.visible_objects()
    materials = list(bpy.data.materials)
    with (
        ThreadPoolExecutor(1) as aside,  # reads each picture while Blender draws the next
        flat_workbench(session.scene),
        _identity_colors(objects) as nodes,
    ):
        with shading(session.scene, light="FLAT", color_type="OBJECT"):
            identified = session.exr_read_aside(aside, _identified, width, height, depth=True)
        with (
            shading(session.scene, light="MATCAP", studio_light=turning_matcap(), color_type="MATERIAL"),
            told_in_blue(materials),
        ):
            turned = session.exr_read_aside(aside, partial(turned_and_made, view=view), width, height)
        with shading(session.scene, light="FLAT", color_type="TEXTURE"):
            colored = session.exr_read_aside(aside, _half_color, width, height)
        ids, surface, depth, skin_colored = identified.result()
        window = window_around(skin_colored) if skin_colored.any() else None
        if window is not None:
            with shading(session.scene, light="FLAT", color_type="VERTEX"):
                (skin,) = session.exr_frames([session.scene.frame_current], width, height, window=window)
            painted = skin_colored[window.cut]
            colored.result()[window.cut][painted] = color(skin)[painted]
        (normal, material), albedo = turned.result(), colored.result()
        material[material > len(materials)] = 0
        material[ids == 0] = 0
        with shading(session.scene, light="FLAT", color_type="TEXTURE"):
            near = draw_far_textures(session, albedo, material, depth, normal, view, materials)
        relief = _relief(session, objects, materials, ids, material, normal, near)
    normal[ids == 0] = 0
    albedo[ids == 0] = 0
    entries = [MATERIALS.get(str(made.get("key", ""))) for made in materials]
    fade_repeats(albedo, material, depth, normal, view, *_patterns_of(materials, entries))
    glow_color, glow_gain = glow_of(materials)
    roughness = np.array([1.0, *(m.roughness for m in materials)], np.float32)
    patches = (_patchiness(made, entry) for made, entry in zip(materials, entries, strict=True))
    patchy = np.array([0.0, *patches], np.float32)
    gbuffer = GBuffer(
        view,
        ids,
        surface,
        material,
        depth,
        normal,
        albedo,
        glow_color,
        glow_gain,
        roughness,
        patchy,
        relief,
    )
    return Passes(gbuffer, nodes)


def _relief(
    session: RenderSession,
    objects: Sequence[bpy.types.Object],
    materials: Sequence[bpy.types.Material],
    ids: NDArray[np.uint16],
    material: NDArray[np.uint16],
    normal: NDArray[np.float16],
    near: NDArray[np.float32] | None,
) -> NDArray[np.float16] | None:
    """Return the (h, w, 3) normals by the normal maps in view, 0 where there is none; None where there are none.

    Of what is ``near`` by less than one, only that share of the relief is left.
    """
    mapped = with_normal_maps(materials)[material]
    if not mapped.any():
        return None
    window = window_around(mapped)
    there = mapped[window.cut]
    turns = turns_of(objects, _gids(objects))[ids[window.cut][there]]
    smooth = normal[window.cut][there].astype(np.float32)
    height, width = ids.shape
    found = np.zeros(normal.shape, np.float16)
    rough = normals_in_maps(session, (width, height), window, there, turns, smooth, materials)
    if near is not None:
        rough = smooth + (rough - smooth) * near[window.cut][there][:, None]
    found[window.cut][there] = rough
    return found


def _gids(objects: Sequence[bpy.types.Object]) -> list[int]:
    """Return the number of each object's ink group, from 1 in the order in which they are met."""
    known: dict[str, int] = {}
    return [known.setdefault(str(obj.get("ink_group", obj.name)), len(known) + 1) for obj in objects]


def has_painted_skin(obj: bpy.types.Object) -> bool:
    """Return whether the object's colour is painted on its vertices: skin, with its brows and lips."""
    return obj.type == "MESH" and obj.get("surface") in PERSON and len(obj.data.color_attributes) > 0


@contextmanager
def flat_workbench(scene: bpy.types.Scene) -> Iterator[None]:
    """Set Workbench up for data: no antialiasing, shadow, cavity, outline or specular light."""
    render = {"engine": "BLENDER_WORKBENCH", "film_transparent": True}
    plain = {
        "show_shadows": False,
        "show_cavity": False,
        "show_object_outline": False,
        "show_specular_highlight": False,
        "show_backface_culling": False,
        "show_xray": False,
        "use_dof": False,
        "single_color": (1.0, 1.0, 1.0),
    }
    with (
        changed(scene.render, render),
        changed(scene.display, {"render_aa": "OFF"}),
        changed(scene.display.shading, plain),
    ):
        yield


@contextmanager
def shading(scene: bpy.types.Scene, **values: Any) -> Iterator[None]:
    """Set how Workbench shades what it draws."""
    with changed(scene.display.shading, values):
        yield


@contextmanager
def _identity_colors(objects: Sequence[bpy.types.Object]) -> Iterator[tuple[Node, ...]]:
    """Write gid and class of every object into its viewport colour; one gid for each ink group."""
    nodes: list[Node] = []
    with ExitStack() as stack:
        for obj, gid in zip(objects, _gids(objects), strict=True):
            if gid > len(nodes):
                node_id = str(obj.get("node_id", obj.name))
                nodes.append(Node(node_id, str(obj.get("asset_id", "")), str(obj.get("kind", "prop"))))
            code = int(obj.get("surface", Surface.PROP))
            if has_painted_skin(obj):
                code += _HAS_SKIN_COLORS
            stack.enter_context(changed(obj, {"color": (gid % 256 / 255, gid // 256 / 255, code / 255, 1.0)}))
        yield tuple(nodes)


def _identified(
    channels: Channels,
) -> tuple[NDArray[np.uint16], NDArray[np.uint8], NDArray[np.float32], NDArray[np.bool_]]:
    """Return ids, classes and depth, and which pixels have their albedo in vertex colours."""
    red, green, blue = (_levels(channels[f"Combined.{name}"]) for name in "RGB")
    ids = _number(red, green)
    solid = ids > 0
    surface = np.where(solid, blue % _HAS_SKIN_COLORS, 0).astype(np.uint8)
    depth = np.where(solid, channels["Depth.Z"], np.float32(FAR))
    return ids, surface, depth, (blue >= _HAS_SKIN_COLORS) & solid


def _half_color(channels: Channels) -> NDArray[np.float16]:
    return color(channels).astype(np.float16)


def material_index(channels: Channels, materials: Sequence[bpy.types.Material]) -> NDArray[np.uint16]:
    """Return each pixel's material, (h, w), from 1; 0 is none.

    Args:
        channels: Of a picture drawn with ``material_indices``.
        materials: The same, in the same order.
    """
    index = _number(_levels(channels["Combined.R"]), _levels(channels["Combined.G"]))
    index[index > len(materials)] = 0
    return index


@contextmanager
def material_indices(materials: Sequence[bpy.types.Material]) -> Iterator[None]:
    """Write every material's index (from 1) into its viewport colour."""
    with ExitStack() as stack:
        for index, material in enumerate(materials, 1):
            code = (index % 256 / 255, index // 256 / 255, 0.0, 1.0)
            stack.enter_context(changed(material, {"diffuse_color": code}))
        yield


def _levels(channel: NDArray[np.float32]) -> NDArray[np.uint8]:
    return (channel * 255 + 0.5).astype(np.uint8)


def _number(low: NDArray[np.uint8], high: NDArray[np.uint8]) -> NDArray[np.uint16]:
    return low.astype(np.uint16) | (high.astype(np.uint16) << np.uint16(8))


def _patchiness(made: bpy.types.Material, entry: MaterialEntry | None) -> float:
    """Return how much ground of a material varies over metres."""
    return entry.patchy if entry is not None else float(made.get("patchy", 0.0))


def _patterns_of(
    materials: Sequence[bpy.types.Material], entries: Sequence[MaterialEntry | None]
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the repeat of each material's pattern in metres, 0 for none, and its mean colour."""
    repeats, means = np.zeros(len(materials) + 1, np.float32), np.zeros((len(materials) + 1, 3), np.float32)
    for index, (material, entry) in enumerate(zip(materials, entries, strict=True), 1):
        if entry is not None and entry.repeat > 0:
            repeats[index] = entry.repeat
            means[index] = material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value[:3]
    return repeats, means


def glow_of(materials: Sequence[bpy.types.Material]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return emission by material index from 1: (n + 1, 3) linear colours, and (n + 1,) factors of the albedo.

    The factor is used where a material's own base texture glows; a glow map of its own has neither.
    """
    glow_color = np.zeros((len(materials) + 1, 3), np.float32)
    glow_gain = np.zeros(len(materials) + 1, np.float32)
    for index, material in enumerate(materials, 1):
        for node in material.node_tree.nodes if material.use_nodes else ():
            if node.type == "BSDF_PRINCIPLED":
                strength, tint = node.inputs["Emission Strength"].default_value, node.inputs["Emission Color"]
            elif node.type == "EMISSION":
                strength, tint = node.inputs["Strength"].default_value, node.inputs["Color"]
            else:
                continue
            if strength <= 0:
                continue
            if tint.is_linked:
                own = node.inputs["Base Color"].links if node.type == "BSDF_PRINCIPLED" else tint.links
                if own and own[0].from_node == tint.links[0].from_node:
                    glow_gain[index] = strength
            else:
                glow_color[index] = np.array(tint.default_value[:3]) * strength
    return glow_color, glow_gain
