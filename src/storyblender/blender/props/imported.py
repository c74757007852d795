"""Builds an asset from a model file: one mesh, metres, bottom-centre origin, front -Y."""

from __future__ import annotations

from pathlib import Path

import bmesh
import bpy
import numpy as np

from storyblender.blender.props.build import PropBuild, settle
from storyblender.errors import InputError
from storyblender.geometry.canonical import Alignment, align, unit_for
from storyblender.memory.asset_sheet import AssetDimension

SUFFIXES = (".glb", ".gltf", ".obj", ".blend")
"""The files that can be read."""


def build_from_file(path: Path, dimension: AssetDimension | None = None) -> PropBuild:
    """Read a model and bring it to the canonical frame.

    Its meshes are joined; lights, cameras, rigs and scripts in the file are left out.

    Args:
        path: A .glb, .gltf, .obj or .blend file.
        dimension: The wanted size; without it the unit is guessed.

    Raises:
        InputError: The file cannot be read or holds no mesh.
    """
    kept = {block for blocks in (bpy.data.objects, bpy.data.meshes) for block in blocks}
    _read(path)
    objects = [obj for obj in bpy.data.objects if obj not in kept]
    meshes = sorted((obj for obj in objects if obj.type == "MESH"), key=lambda obj: obj.name)
    try:
        if not meshes:
            raise InputError("the file holds no mesh", path=path)
        mesh = _join(meshes, path.stem)
    finally:
        for obj in objects:
            bpy.data.objects.remove(obj)
    for left in [block for block in bpy.data.meshes if block not in kept and block != mesh and not block.users]:
        bpy.data.meshes.remove(left)
    _turn(mesh, align(*_arrays(mesh)), dimension)
    return settle(mesh, (), dimension)


def _read(path: Path) -> None:
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise InputError(f"a {suffix or 'nameless'} file is no model", mend=f"use {', '.join(SUFFIXES)}", path=path)
    if not path.is_file():
        raise InputError("there is no such model", path=path)
    try:
        if suffix == ".blend":
            _append(path)
        elif suffix == ".obj":
            bpy.ops.wm.obj_import(filepath=str(path))
        else:
            bpy.ops.import_scene.gltf(filepath=str(path), disable_bone_shape=True)
    except (RuntimeError, OSError, ValueError) as error:
        problem = f"the model cannot be read ({_reason(error)})"
        raise InputError(problem, mend="export it again as .glb", path=path) from error


def _reason(error: Exception) -> str:
    """Return the last thing that an importer says went wrong, without where in its own code."""
    said = [line.strip() for line in str(error).splitlines() if line.strip() and not line.startswith("Location:")]
    return said[-1].removeprefix("Error: ") if said else type(error).__name__


def _append(path: Path) -> None:
    """Append the mesh objects of a .blend; its scripts and drivers never run, as no file is opened."""
    bpy.context.preferences.filepaths.use_scripts_auto_execute = False
    with bpy.data.libraries.load(str(path), link=False) as (source, target):
        target.objects = list(source.objects)
    for obj in target.objects:
        if obj is not None:
            obj.animation_data_clear()
            bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.update()


def _join(objects: list[bpy.types.Object], name: str) -> bpy.types.Mesh:
    """Return one mesh of all objects in world space, modifiers applied, materials kept."""
    graph = bpy.context.evaluated_depsgraph_get()
    joined, materials = bmesh.new(), []
    for obj in objects:
        part = bpy.data.meshes.new_from_object(obj.evaluated_get(graph), depsgraph=graph)
        part.transform(obj.matrix_world)
        if obj.matrix_world.determinant() < 0:
            part.flip_normals()
        slots = np.zeros(len(part.polygons), np.int32)
        part.polygons.foreach_get("material_index", slots)
        part.polygons.foreach_set("material_index", slots + len(materials))
        materials += list(part.materials) or [None]
        joined.from_mesh(part)
        bpy.data.meshes.remove(part)
    mesh = bpy.data.meshes.new(name)
    joined.to_mesh(mesh)
    joined.free()
    for block in materials:
        mesh.materials.append(block)
    return mesh


def _arrays(mesh: bpy.types.Mesh) -> tuple[np.ndarray, np.ndarray]:
    mesh.calc_loop_triangles()
    points = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", points)
    corners = np.empty(len(mesh.loop_triangles) * 3, np.int32)
    mesh.loop_triangles.foreach_get("vertices", corners)
    return points.reshape(-1, 3).astype(float), corners.reshape(-1, 3).astype(np.int64)


def _turn(mesh: bpy.types.Mesh, alignment: Alignment, dimension: AssetDimension | None) -> None:
    points, _ = _arrays(mesh)
    turned = points @ alignment.rotation.T
    unit = alignment.unit
    if dimension is not None:
        wanted = (dimension.width, dimension.depth, dimension.height)
        known = [(size, goal) for size, goal in zip(np.ptp(turned, axis=0), wanted, strict=True) if goal is not None]
        unit = unit_for(*known[0])[1] if known else unit
    mesh.vertices.foreach_set("co", (turned * unit).astype(np.float32).ravel())
    mesh.update()
