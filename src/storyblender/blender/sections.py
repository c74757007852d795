"""Sections of a placed thing: the panels that a shot can hide and the parts that are things of the story."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import bmesh
import bpy

from storyblender.blender.panel_faces import PANEL, PANELS

SECTION, FITTED = "section", "fitted"
"""Properties of objects: the id that hides a section; section -> node id and asset id of the part that it is."""

Fitted = Mapping[str, tuple[str, str]]


def split_sections(obj: bpy.types.Object, fitted: Fitted) -> list[str]:
    """Make every panel of an object's mesh an object of its own, parented to it; return the names of the panels.

    Args:
        obj: Tagged and linked to its collections; changed.
        fitted: Section -> node id and asset id of a thing of the story that it is; any other belongs to the object.
    """
    mesh = obj.data
    names = str(mesh.get(PANELS, "")).split()
    if not names:
        return []
    obj[FITTED] = {name: " ".join(ids) for name, ids in fitted.items()}
    for number, name in enumerate(names, start=1):
        part = bpy.data.objects.new(f"{obj.name}.{name}", _only(mesh, number, name))
        part.parent = obj
        node_id, asset_id = fitted.get(name, (obj["node_id"], obj["asset_id"]))
        for key in ("kind", "surface"):
            part[key] = obj[key]
        part["node_id"], part["asset_id"], part["ink_group"] = node_id, asset_id, str(obj["node_id"])
        part[SECTION] = f"{obj['node_id']}_{name}"
        for collection in obj.users_collection:
            collection.objects.link(part)
    obj["ink_group"] = str(obj["node_id"])
    obj.data = _only(mesh, 0, "body")
    return names


def fitted_in(obj: bpy.types.Object) -> Fitted:
    """Return the parts of a thing that are things of the story, as ``split_sections`` was given them."""
    told = obj.get(FITTED)
    pairs = {} if told is None else {str(name): str(ids).split(" ") for name, ids in told.items()}
    return {name: (ids[0], ids[1]) for name, ids in pairs.items()}


def with_sections(obj: bpy.types.Object) -> Sequence[bpy.types.Object]:
    """Return an object and its sections."""
    return [obj, *(child for child in obj.children if SECTION in child)]


def is_hidden_by(obj: bpy.types.Object, hidden: Collection[str]) -> bool:
    """Return whether ids to hide name an object's node, or the section of one that it is."""
    return obj.get("node_id") in hidden or obj.get(SECTION) in hidden


def _only(mesh: bpy.types.Mesh, number: int, name: str) -> bpy.types.Mesh:
    """Return the faces of a mesh with a panel number as a mesh of its own, made once for all objects."""
    digest = f"{mesh.get('digest', mesh.name)}.{name}"
    present = next((each for each in bpy.data.meshes if each.get("digest") == digest), None)
    if present is not None:
        return present
    found = mesh.copy()
    found.name, found["digest"] = f"{mesh.name}.{name}", digest
    work = bmesh.new()
    work.from_mesh(found)
    layer = work.faces.layers.int[PANEL]
    bmesh.ops.delete(work, geom=[face for face in work.faces if face[layer] != number], context="FACES")
    work.to_mesh(found)
    work.free()
    del found[PANELS]
    return found
