"""Builds a character from the user's model: its mesh with its own materials on an armature like everybody's."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import bpy
import numpy as np

from storyblender.blender.cast.divide import divide_long_edges
from storyblender.blender.cast.humanoid import BoundMesh, bound_mesh
from storyblender.blender.cast.own_rig import OwnRig, own_rig
from storyblender.blender.cast.template import template_of
from storyblender.blender.models.credits import with_files
from storyblender.blender.models.plain import PlainModel
from storyblender.blender.models.rebuild import build_mesh
from storyblender.blender.models.tangents import add_tangents
from storyblender.blender.people import rig
from storyblender.blender.people.pack import load_body_pack
from storyblender.blender.people.parts import write_weights
from storyblender.blender.people.person import PersonBuild
from storyblender.blender.props.imported import read_model
from storyblender.blender.tags import Surface, tag
from storyblender.errors import InputError
from storyblender.geometry.canonical import rotation_of
from storyblender.geometry.scaling import find_scale
from storyblender.memory.asset_sheet import AssetDimension, Certainty, Credit, ModelPose


@dataclass(frozen=True)
class CharacterBuild:
    """A character from a file.

    Attributes:
        person: The rig with its mesh.
        notes: Sentences about what was changed or left out.
        credit: Whose work the model is.
    """

    person: PersonBuild
    notes: tuple[str, ...]
    credit: Credit


def character_from_file(
    asset_id: str, path: Path, folder: Path, dimension: AssetDimension | None, *, certainty: Certainty, pose: ModelPose
) -> CharacterBuild:
    """Read a humanoid model and bind it to the skeleton of the built-in people, in the open file.

    Args:
        asset_id: Name of the armature object and tag of the mesh.
        path: A model, as of a thing.
        folder: The folder of models; what the file names must be in it.
        dimension: How tall such a person is; without it the unit is guessed.
        certainty: Of that height.
        pose: Its front and top, if they are decided.

    Raises:
        InputError: It cannot be read, or is no human figure.
    """
    pack = load_body_pack()
    if pack is None:
        raise InputError("a model cannot be bound without the body data", mend="run `make setup`", path=path)
    file = read_model(path, folder)
    model = file.repaired()
    notes = list(model.notes)
    credit = with_files(model.credit, path, folder, notes)
    mesh = build_mesh(model, f"{asset_id}_model")
    turn = rotation_of(pose) if pose.top is not None else np.eye(3)
    extent = np.ptp(_geometry(mesh)[0] @ turn.T, axis=0)
    scale, reason = find_scale(extent, None, dimension, certainty=certainty, unit=model.unit)
    if reason:
        notes.append(f"{extent[2]:.3g} m become {extent[2] * scale:.3g} m: {reason}")
    try:
        own = _own_rig(file, mesh, scale * turn)
        if own is None:
            divide_long_edges(mesh)
        points, normals, triangles = _geometry(mesh)
        points, normals = scale * points @ turn.T, normals @ turn.T
        known = pose.front is not None
        bound = bound_mesh(points, normals, triangles, template_of(pack), front_known=known, own=own)
    except InputError as error:
        problem = f"{path.name} cannot be a character: {error.problem}"
        raise InputError(problem, mend=error.mend, path=path) from error
    if certainty == "told" and dimension is not None and dimension.height is not None:
        bound = _scaled(bound, dimension.height / bound.stature)
    if bound.turned and pose.front is None:
        notes.append("it is turned by 180 degrees to face the front")
    if any(material.normal_map for material in model.materials):
        add_tangents(mesh)
    person = _built(asset_id, mesh, bound)
    return CharacterBuild(person, tuple(f"{path.name}: {note}" for note in notes), credit)


def _own_rig(model: PlainModel, mesh: bpy.types.Mesh, matrix: np.ndarray) -> OwnRig | None:
    """Return the file's skeleton in metres, for the vertices of the mesh that was built of it; None if it has none."""
    if model.rig is None:
        return None
    row_of = {place.tobytes(): row for row, place in enumerate(model.vertices + np.float32(0.0))}
    flat = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", flat)
    rows = np.array([row_of[place.tobytes()] for place in flat.reshape(-1, 3) + np.float32(0.0)])
    own = own_rig(model.rig, rows)
    return own and OwnRig({bone: matrix @ head for bone, head in own.heads.items()}, own.weights)


def _scaled(bound: BoundMesh, factor: float) -> BoundMesh:
    return replace(
        bound,
        points=bound.points * factor,
        heads=bound.heads * factor,
        tails=bound.tails * factor,
        stature=bound.stature * factor,
    )


def _built(asset_id: str, mesh: bpy.types.Mesh, bound: BoundMesh) -> PersonBuild:
    """Return the armature with the mesh on it."""
    armature = rig.build_armature(asset_id, bound.joints)
    tag(armature, kind="character", node_id=asset_id, asset_id=asset_id)
    mesh.vertices.foreach_set("co", bound.points.astype(np.float32).ravel())
    mesh.update()
    obj = bpy.data.objects.new(mesh.name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    write_weights(obj, bound.weights)
    obj.parent = armature
    obj.modifiers.new("Armature", "ARMATURE").object = armature
    tag(obj, kind="character", node_id=asset_id, asset_id=asset_id, surface=Surface.CLOTH)
    body = rig.measure_body(armature, bound.points, bound.weights, bound.stature, ())
    return PersonBuild(armature, [obj], body)


def _geometry(mesh: bpy.types.Mesh) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the points, the normals and the triangles of a mesh."""
    count = len(mesh.vertices)
    points, normals = np.empty(3 * count, np.float32), np.empty(3 * count, np.float32)
    mesh.vertices.foreach_get("co", points)
    mesh.vertices.foreach_get("normal", normals)
    mesh.calc_loop_triangles()
    corners = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", corners)
    return (
        points.reshape(-1, 3).astype(float),
        normals.reshape(-1, 3).astype(float),
        corners.reshape(-1, 3).astype(np.int64),
    )
