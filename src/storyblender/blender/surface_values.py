"""What a story's .blend says of surfaces: its materials, and the shape of its meshes."""

from __future__ import annotations

import hashlib
from typing import Literal

import bpy
import numpy as np

from storyblender.blender.painting import PAINTED, base_of, can_be_painted, plain_name, shader_of
from storyblender.catalog.materials import MATERIALS
from storyblender.memory.blend_values import SurfaceValues, Vector

SOLID = frozenset(("MESH", "CURVE", "SURFACE", "FONT", "META"))
"""Types of objects that have a surface."""


def surface_values(block: bpy.types.Material) -> SurfaceValues:
    """Return what a material is like: by its shader where that tells, else as the viewport shows it."""
    shader = shader_of(block)
    base: Literal["plain", "picture", "other"] = base_of(block) if can_be_painted(block) else "other"
    color = shader.inputs["Base Color"].default_value if shader is not None and base == "plain" else block.diffuse_color
    rough, metal = block.roughness, block.metallic
    if shader is not None:
        rough, metal = (float(shader.inputs[name].default_value) for name in ("Roughness", "Metallic"))
    name, key = plain_name(block), str(block.get("key", ""))
    return SurfaceValues(
        name=name, color=_color(color), roughness=round(rough, 4), metallic=round(metal, 4), base=base,
        finish=key if key == name and key in MATERIALS and PAINTED not in block else "",
    )  # fmt: skip


def materials_of(obj: bpy.types.Object) -> tuple[str, ...]:
    """Return the names of the materials of an object, with those of the meshes that a rig moves."""
    parts = (obj, *obj.children) if obj.type == "ARMATURE" else (obj,)
    slots = (slot for part in parts for slot in part.material_slots)
    return tuple(slot.material.name if slot.material is not None else "" for slot in slots)


def shape_of(obj: bpy.types.Object) -> str:
    """Return a digest of the mesh of an object and its modifiers; empty for what has none."""
    if obj.type != "MESH":
        return ""
    mesh, digest = obj.data, hashlib.sha256()
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", points)
    corners = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corners)
    digest.update(points.tobytes())
    digest.update(corners.tobytes())
    digest.update("".join(each.type for each in obj.modifiers).encode())
    return digest.hexdigest()[:16]


def is_solid(obj: bpy.types.Object) -> bool:
    """Return whether an object, or what hangs on it, has a surface, or shows a collection."""
    shows = obj.type in SOLID or obj.instance_type == "COLLECTION"
    return shows or any(child.type in SOLID for child in obj.children_recursive)


def _color(values: bpy.types.bpy_prop_array) -> Vector:
    red, green, blue = (round(float(value), 5) + 0.0 for value in values[:3])
    return red, green, blue
