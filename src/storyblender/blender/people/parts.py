"""Turns sheets into Blender objects: mesh, materials, vertex colours, weights, shape keys, tags."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import bmesh
import bpy
import numpy as np

from storyblender.blender.people.sheet import Sheet
from storyblender.blender.tags import Surface, tag
from storyblender.catalog.skeleton import SKELETON
from storyblender.geometry.solids import Floats
from storyblender.memory.base import Color

INFLUENCES, LEAST_WEIGHT = 4, 0.02
"""Most bones that move a vertex, and the least weight of one."""

FINISHES: dict[str, tuple[float, float, float]] = {
    "skin": (0.55, 0.0, 0.35),
    "eye": (0.12, 0.0, 0.5),
    "hair": (0.62, 0.0, 0.15),
    "cloth": (0.85, 0.0, 0.2),
    "knit": (0.95, 0.0, 0.1),
    "leather": (0.38, 0.0, 0.4),
    "satin": (0.32, 0.0, 0.4),
    "rubber": (0.7, 0.0, 0.3),
    "metal": (0.3, 0.8, 0.5),
    "glass": (0.05, 0.0, 0.5),
}
"""Roughness, metallic and specular level of each finish."""


@dataclass(frozen=True)
class Paint:
    """A flat material.

    Attributes:
        color: Scene-linear.
        finish: Key of ``FINISHES``.
        vertex_colors: Whether the mesh's ``Color`` attribute replaces the colour.
        alpha: 1 is opaque.
    """

    color: Color
    finish: str
    vertex_colors: bool = False
    alpha: float = 1.0


def material(paint: Paint) -> bpy.types.Material:
    """Return the Principled material of a paint; equal paints share one."""
    red, green, blue = (round(channel, 4) for channel in paint.color)
    how = "painted" if paint.vertex_colors else f"alpha {paint.alpha:g}"
    name = f"{paint.finish} {red} {green} {blue} ({how})"  # a number at its end Blender would take for a copy's
    if name in bpy.data.materials:
        return bpy.data.materials[name]
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.diffuse_color = (*paint.color, paint.alpha)
    shader = made.node_tree.nodes["Principled BSDF"]
    roughness, metallic, specular = FINISHES[paint.finish]
    made.roughness, made.metallic = roughness, metallic
    shader.inputs["Base Color"].default_value = (*paint.color, 1.0)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metallic
    shader.inputs["Specular IOR Level"].default_value = specular
    shader.inputs["Alpha"].default_value = paint.alpha
    if paint.vertex_colors:
        attribute = made.node_tree.nodes.new("ShaderNodeVertexColor")
        attribute.layer_name = "Color"
        made.node_tree.links.new(attribute.outputs["Color"], shader.inputs["Base Color"])
    return made


def build_object(
    name: str,
    sheet: Sheet,
    paints: Sequence[Paint],
    armature: bpy.types.Object,
    *,
    surface: Surface,
    ink_group: str = "",
    colors: Floats | None = None,
    shape_keys: Mapping[str, Floats] | None = None,
) -> bpy.types.Object:
    """Return a mesh object of a sheet, deformed by an armature.

    Args:
        name: Of the object and its mesh.
        sheet: The surface; its slots index ``paints``.
        paints: Materials.
        armature: Parent and deformer; its name is the asset id.
        surface: Tag for ink and light.
        ink_group: Tag; empty means the object alone.
        colors: (V, 3) scene-linear vertex colours for the painted slots.
        shape_keys: (V, 3) offsets by name.
    """
    mesh = _build_mesh(name, sheet)
    for paint in paints:
        mesh.materials.append(material(paint))
    mesh.polygons.foreach_set("material_index", sheet.slot.astype(np.int32))
    _write_colors(mesh, sheet, paints, colors)
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    write_weights(obj, sheet.weights)
    if shape_keys:
        obj.shape_key_add(name="Basis", from_mix=False)
        for key, offsets in shape_keys.items():
            block = obj.shape_key_add(name=key, from_mix=False)
            block.value = 0.0
            block.data.foreach_set("co", (sheet.points + offsets).astype(np.float32).ravel())
    obj.parent = armature
    modifier = obj.modifiers.new("Armature", "ARMATURE")
    modifier.object = armature
    return tag(
        obj, kind="character", node_id=armature.name, asset_id=armature.name, surface=surface, ink_group=ink_group
    )


def _build_mesh(name: str, sheet: Sheet) -> bpy.types.Mesh:
    """Return a smooth-shaded mesh of a sheet."""
    mesh = bpy.data.meshes.new(name)
    real = sheet.faces >= 0
    sizes = real.sum(1)
    mesh.vertices.add(len(sheet.points))
    mesh.vertices.foreach_set("co", sheet.points.astype(np.float32).ravel())
    mesh.loops.add(int(sizes.sum()))
    mesh.loops.foreach_set("vertex_index", sheet.faces[real].astype(np.int32))
    mesh.polygons.add(len(sizes))
    mesh.polygons.foreach_set("loop_start", (np.cumsum(sizes) - sizes).astype(np.int32))
    mesh.update(calc_edges=True)
    mesh.validate()
    mesh.shade_smooth()
    return mesh


def _write_colors(mesh: bpy.types.Mesh, sheet: Sheet, paints: Sequence[Paint], colors: Floats | None) -> None:
    """Write each corner's material colour, or the painted one (V, 3), as a colour attribute for Workbench."""
    flat = np.array([paint.color for paint in paints])[sheet.slot]
    corners = np.repeat(flat, (sheet.faces >= 0).sum(1), axis=0)
    if colors is not None:
        painted = np.repeat(np.array([paint.vertex_colors for paint in paints])[sheet.slot], (sheet.faces >= 0).sum(1))
        corners[painted] = colors[sheet.faces[sheet.faces >= 0]][painted]
    attribute = mesh.color_attributes.new("Color", "BYTE_COLOR", "CORNER")
    rgba = np.concatenate([corners, np.ones((len(corners), 1))], 1)
    attribute.data.foreach_set("color", rgba.astype(np.float32).ravel())
    mesh.color_attributes.active_color = attribute


def limit_influences(weights: Floats) -> Floats:
    """Return weights (V, B) with at most four influences for each vertex, rows summing to 1."""
    fourth = np.sort(weights, axis=1)[:, -INFLUENCES][:, None]
    kept = np.where(weights >= np.maximum(fourth, LEAST_WEIGHT), weights, 0)
    return kept / kept.sum(1, keepdims=True)


def write_weights(obj: bpy.types.Object, weights: Floats) -> None:
    """Write skin weights (V, 35) as vertex groups, through bmesh: ten times faster than ``VertexGroup.add``."""
    kept = limit_influences(weights)
    used = np.flatnonzero(kept.any(0))
    for column in used:
        obj.vertex_groups.new(name=SKELETON[column].name)
    group_of = {int(column): group for group, column in enumerate(used)}
    rows, columns = np.nonzero(kept)
    work = bmesh.new()
    work.from_mesh(obj.data)
    work.verts.ensure_lookup_table()
    layer = work.verts.layers.deform.verify()
    vertices = work.verts
    for row, column, weight in zip(rows.tolist(), columns.tolist(), kept[rows, columns].tolist(), strict=True):
        vertices[row][layer][group_of[column]] = weight
    work.to_mesh(obj.data)
    work.free()
