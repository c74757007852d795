"""Builds an asset from a user's model file: one mesh, metres, bottom-centre origin, front -Y, with places to use it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import bpy
import numpy as np

from storyblender.blender.measure.surfaces import level_field
from storyblender.blender.models.addresses import readable
from storyblender.blender.models.blend import read_blend
from storyblender.blender.models.credits import with_files
from storyblender.blender.models.gltf import read_gltf
from storyblender.blender.models.obj import read_obj
from storyblender.blender.models.plain import PlainModel
from storyblender.blender.models.rebuild import build_mesh
from storyblender.blender.models.tangents import add_tangents
from storyblender.blender.props.anchors import Anchors, grip
from storyblender.blender.props.build import PropBuild, settle
from storyblender.catalog.props import PROPS, PropEntry
from storyblender.catalog.props.prop_names import kind_named
from storyblender.errors import InputError
from storyblender.geometry.canonical import find_scale, find_upright_rotation, rotation_of
from storyblender.geometry.holding import Hold, find_hold
from storyblender.geometry.resting import Places, Use, find_bed, find_seats
from storyblender.memory.asset_sheet import AssetDimension, ModelPose
from storyblender.memory.base import Vec3

_READERS: dict[str, Callable[[Path, Path], PlainModel]] = {
    ".glb": read_gltf,
    ".gltf": read_gltf,
    ".obj": read_obj,
    ".blend": read_blend,
}
SUFFIXES = tuple(_READERS)
"""The files that can be read."""
_LAIN_ON, _SAT_ON = ("cradle", "stretcher"), ("toilet",)
"""Props that one lies or sits on though their names do not say so."""
_LARGE = 12.0
"""Metres: no seat is looked for on a larger model."""
_Z_UP = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
"""Undoes the turn of an .obj that was Z up already."""


AS_ITS_SHAPE_SAYS = ModelPose()
"""The pose of a model whose front and top are not decided."""


def build_from_file(
    path: Path,
    dimension: AssetDimension | None = None,
    *,
    folder: Path | None = None,
    prop: str | None = None,
    told: bool = False,
    pose: ModelPose = AS_ITS_SHAPE_SAYS,
) -> PropBuild:
    """Read a model and bring it to the canonical frame.

    Its meshes are joined; everything that is no surface is left out: lights, cameras, rigs, animation, scripts.

    Args:
        path: A .glb, .gltf, .obj or .blend file.
        dimension: What the thing measures, usually; without it the unit is guessed.
        folder: The folder of models; what the file names must be in it. Its own folder if not given.
        prop: Catalog key of what it is, empty for what the catalog lacks; its file's name tells if not given.
        told: Whether the dimension is sure, so that it counts and not the file's size.
        pose: Its front and top, if they are decided; else they are found by its shape.

    Raises:
        InputError: The file cannot be read or holds no mesh.
    """
    model = read_model(path, folder or path.parent)
    mesh = build_mesh(model, path.stem[:40])
    entry, notes = PROPS.get(kind_named(path.stem) if prop is None else prop), list(model.notes)
    credit = with_files(model.credit, path, folder or path.parent, notes)
    if pose.top is not None:
        _transform(mesh, rotation_of(pose))
    elif path.suffix.lower() == ".obj":
        _stand(mesh, entry, dimension, notes)
    extent = np.ptp(_points(mesh), axis=0)
    scale, reason = find_scale(extent, dimension, told=told)
    _transform(mesh, np.eye(3) * scale)
    if reason:
        notes.append(f"{_size(extent)} becomes {_size(extent * scale)} ({scale:.4g} times): {reason}")
    places = _places(mesh, entry)
    turn = 0 if pose.front is not None else _turn_to_front(mesh, places)
    if turn:
        places = _places(mesh, entry)
        notes.append(f"it is turned by {turn} degrees to face the front")
    build = settle(mesh, places.anchors)
    if not build.anchors:
        build = replace(build, anchors=_grips(find_hold(_points(mesh), _triangles(mesh))))
    if any(material.normal_map for material in model.materials):
        add_tangents(build.mesh)
    return replace(build, notes=tuple(f"{path.name}: {note}" for note in notes), credit=credit)


def read_model(path: Path, folder: Path) -> PlainModel:
    """Read the surface of a model.

    Args:
        path: A .glb, .gltf, .obj or .blend file.
        folder: The folder of models; the file and what it names must be in it.

    Raises:
        InputError: It cannot be used; one sentence.
    """
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        named = path.suffix or "nameless"
        raise InputError(f"a {named} file is no model", mend=f"use {', '.join(SUFFIXES)}", path=path)
    if not path.is_file():
        raise InputError("there is no such model", path=path)
    try:
        return reader(readable(folder, path), folder)
    except InputError as error:
        mend = error.mend or "export it again as .glb"
        raise InputError(f"the model cannot be used: {error.problem}", mend=mend, path=path) from error
    except (OSError, MemoryError) as error:
        problem = f"the model cannot be read ({type(error).__name__})"
        raise InputError(problem, mend="export it again as .glb", path=path) from error


def _use(entry: PropEntry | None) -> Use:
    """Return what a thing is for, by what it is called."""
    if entry is None:
        return ""
    if "bed" in (entry.key, entry.key.rpartition("_")[2]) or entry.key in _LAIN_ON:
        return "bed"
    return "seat" if entry.seats or entry.key in _SAT_ON else "other"


def _places(mesh: bpy.types.Mesh, entry: PropEntry | None) -> Places:
    """Return where one sits or lies on a mesh in metres."""
    use = _use(entry)
    if use == "other" or max(np.ptp(_points(mesh), axis=0)) > _LARGE:
        return Places()
    field = level_field(mesh)
    bed = find_bed(field, use)
    faces_front = entry is not None and entry.category in ("vehicle", "animal")
    return bed if bed.anchors else find_seats(field, use, faces_front=faces_front)


def _turn_to_front(mesh: bpy.types.Mesh, places: Places) -> int:
    """Turn a mesh so that its seat faces -Y, or its bed's head is at +Y; return by how many degrees."""
    if not places.backed:
        return 0
    x, y = (round(value) for value in places.anchors[0].direction[:2])
    degrees = {(0, -1): 0, (1, 0): -90, (0, 1): 180, (-1, 0): 90}[(x, y)]
    angle = np.radians(degrees)
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]).round(12)
    _transform(mesh, turn)
    return abs(degrees)


def _stand(mesh: bpy.types.Mesh, entry: PropEntry | None, dimension: AssetDimension | None, notes: list[str]) -> None:
    """Put an .obj on its feet, which may be Z up: as one can sit or lie on it, else as it does not fall over."""
    turn = find_upright_rotation(_points(mesh), _triangles(mesh))
    if _use(entry) in ("seat", "bed"):
        for candidate in (np.eye(3), _Z_UP):
            trial = mesh.copy()
            _transform(trial, candidate)
            scale, _ = find_scale(np.ptp(_points(trial), axis=0), dimension, told=False)
            _transform(trial, np.eye(3) * scale)
            found = _places(trial, entry).anchors
            bpy.data.meshes.remove(trial)
            if found:
                turn = candidate
                break
    if not np.array_equal(turn, np.eye(3)):
        _transform(mesh, turn)
        notes.append("it is tipped up to stand on its feet")


def _grips(hold: Hold | None) -> Anchors:
    """Return the grips of a small thing around its slender part, or at its side."""
    if hold is None:
        return ()
    x, y, z = hold.place
    ways: tuple[Vec3, Vec3]
    match hold.axis:
        case 0:
            place, ways = (x, y, z + hold.half), ((0.0, -1.0, 0.1), (0.0, -0.1, -1.0))
        case 1:
            place, ways = (x - hold.half, y, z), ((0.15, -0.4, -0.9), (1.0, 0.1, 0.0))
        case _:
            place, ways = (x - hold.half, y + 0.004, z), ((0.2, -1.0, 0.0), (1.0, 0.15, 0.0))
    (fx, fy, fz), (px, py, pz) = ways
    curl = (hold.closed, hold.closed, 0.6 * hold.closed)
    return (
        grip("grip_r", place, (fx, fy, fz), (px, py, pz), curl),
        grip("grip_l", (2 * x - place[0], place[1], place[2]), (-fx, fy, fz), (-px, py, pz), curl),
    )


def _points(mesh: bpy.types.Mesh) -> np.ndarray:
    points = np.empty(len(mesh.vertices) * 3, np.float32)
    mesh.vertices.foreach_get("co", points)
    return points.reshape(-1, 3).astype(float)


def _triangles(mesh: bpy.types.Mesh) -> np.ndarray:
    mesh.calc_loop_triangles()
    corners = np.empty(len(mesh.loop_triangles) * 3, np.int32)
    mesh.loop_triangles.foreach_get("vertices", corners)
    return corners.reshape(-1, 3).astype(np.int64)


def _transform(mesh: bpy.types.Mesh, matrix: np.ndarray) -> None:
    mesh.vertices.foreach_set("co", (_points(mesh) @ matrix.T).astype(np.float32).ravel())
    mesh.update()


def _size(extent: np.ndarray) -> str:
    return " x ".join(f"{value:.3g}" for value in extent) + " m"
