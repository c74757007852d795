"""Lamps, screens and fires that are off or out: what shines is dark, and flames are gone."""

from __future__ import annotations

import bmesh
import bpy

from storyblender.blender.materials import material

_DARK = {"lamp_": "linen", "lampshade": "linen", "screen": "screen_off", "neon_": "glass_dark", "ember": "iron"}
"""How the key of a shining material begins -> the material of the same thing when it is off."""
_BURNS = ("flame", "fire")


def put_out(mesh: bpy.types.Mesh) -> None:
    """Take the flames out of a mesh and darken what else shines in it."""
    names = [slot.name.split(".")[0].removeprefix("MT_") if slot else "" for slot in mesh.materials]
    burning = {index for index, name in enumerate(names) if name.startswith(_BURNS)}
    if burning:
        shape = bmesh.new()
        shape.from_mesh(mesh)
        faces = [face for face in shape.faces if face.material_index in burning]
        if len(faces) < len(shape.faces):
            bmesh.ops.delete(shape, geom=faces, context="FACES")
            shape.to_mesh(mesh)
        shape.free()
    for index, name in enumerate(names):
        dark = next((key for start, key in _DARK.items() if name.startswith(start)), None)
        if dark is not None:
            mesh.materials[index] = material(dark)
