"""An object that a person made or reshaped in a story's .blend, written out as a model of its own.

The file is opened without its scripts. What leaves it is plain meshes with modifiers applied and their materials;
pictures come along if they are packed or lie in the project. The model is named by its content.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix, Vector

from storyblender.blender.models.limits import VERTICES
from storyblender.blender.painting import shader_of
from storyblender.blender.story_values import ORIGIN
from storyblender.blender.surface_values import SOLID, surface_values
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.memory.asset_sheet import AdoptedModel
from storyblender.memory.blend_values import AdoptedObject
from storyblender.memory.jobs import ADOPTED
from storyblender.model_content import content_of


def adopt_object(story: str, scene: str, name: str, files: Folder, *, keep: bool) -> AdoptedObject:
    """Write an object of a story's file, with all that hangs on it, as a model, and return where it stands.

    Args:
        story: Name of the file in the project.
        scene: Name of its scene.
        name: Of the object.
        files: The project folder.
        keep: False only says what would be written.

    Raises:
        InputError: It has no surface that can be seen, or far too much of it.
    """
    bpy.ops.wm.open_mainfile(filepath=str(files.path(story)), load_ui=False, use_scripts=False)
    bpy.context.window.scene = bpy.data.scenes[scene]
    bpy.context.view_layer.update()
    root = bpy.data.scenes[scene].objects[name]
    place, rotation, _ = root.matrix_world.decompose()
    yaw = rotation.to_euler("XYZ").z
    frame = Matrix.Translation(place) @ Matrix.Rotation(yaw, 4, "Z")
    pieces = list(_pieces(root, frame.inverted()))
    points = np.concatenate([_points(piece) for piece in pieces]) if pieces else np.zeros((0, 3))
    if not len(points):
        raise InputError("it has no surface that can be seen")
    low, high = points.min(0), points.max(0)
    for block in dict.fromkeys(each for piece in pieces for each in piece.data.materials if each is not None):
        _keep_own_pictures(block, files)
    called = f"model_{_digest(pieces)}.blend"
    if keep and not files.path(ADOPTED, called).is_file():
        with files.writing(f"{ADOPTED}/{called}") as part:
            bpy.data.libraries.write(str(part), {*pieces}, fake_user=True, compress=True)
    x, y, z = frame @ Vector(((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]))
    path = files.path(ADOPTED, called)
    width, depth, height = (round(float(side), 6) for side in high - low)
    model = AdoptedModel(
        file=called, content=content_of(path, path.parent) if path.is_file() else "", size=(width, depth, height)
    )
    return AdoptedObject(
        model=model, location=(round(x, 4), round(y, 4), round(z, 4)), rotation=round(math.degrees(yaw) % 360.0, 3)
    )


def _pieces(root: bpy.types.Object, to_frame: Matrix) -> Iterator[bpy.types.Object]:
    """Yield new objects with the meshes of an object and of what hangs on it, as they are seen, in a frame."""
    own = {each for each in (root, *root.children_recursive) if each is root or ORIGIN in root or ORIGIN not in each}
    depsgraph, found, count = bpy.context.evaluated_depsgraph_get(), list[tuple[bpy.types.Mesh, Matrix]](), 0
    for instance in depsgraph.object_instances:
        owner = instance.parent.original if instance.is_instance else instance.object.original
        if owner not in own or instance.object.type not in SOLID:
            continue
        mesh = bpy.data.meshes.new_from_object(instance.object, preserve_all_data_layers=True, depsgraph=depsgraph)
        count += len(mesh.vertices)
        if count > VERTICES:
            raise InputError(f"it has more than {VERTICES:,} points", mend="apply fewer subdivisions")
        found.append((mesh, to_frame @ instance.matrix_world))
    for mesh, matrix in found:
        mesh.transform(matrix)
        if matrix.is_negative:
            mesh.flip_normals()
        mesh.update()
        yield bpy.data.objects.new("piece", mesh)


def _keep_own_pictures(block: bpy.types.Material, files: Folder) -> None:
    """Leave a material what can go with it: no drivers, and no picture from outside the project."""
    block.animation_data_clear()
    if block.node_tree is None:
        return
    block.node_tree.animation_data_clear()
    for node in list(block.node_tree.nodes):
        picture = getattr(node, "image", None)
        if picture is None or picture.packed_file is not None:
            continue
        path = Path(bpy.path.abspath(picture.filepath)).resolve()
        if picture.source == "FILE" and path.is_relative_to(files.root.resolve()) and path.is_file():
            picture.pack()
        else:
            block.node_tree.nodes.remove(node)


def _digest(pieces: list[bpy.types.Object]) -> str:
    """Return a digest of meshes, the places of their pictures and what their materials are like."""
    digest = hashlib.sha256()
    for piece in pieces:
        mesh = piece.data
        for values, field, kind, count in (
            (mesh.vertices, "co", np.float32, 3),
            (mesh.loops, "vertex_index", np.int32, 1),
            (mesh.polygons, "material_index", np.int32, 1),
            (mesh.polygons, "loop_total", np.int32, 1),
        ):
            told = np.empty(count * len(values), kind)
            values.foreach_get(field, told)
            digest.update((np.round(told, 5) + 0).tobytes())
        for layer in mesh.uv_layers:
            told = np.empty(2 * len(layer.uv), np.float32)
            layer.uv.foreach_get("vector", told)
            digest.update(told.tobytes())
        for block in mesh.materials:
            digest.update(_look(block).encode() if block is not None else b"-")
    return digest.hexdigest()[:16]


def _look(block: bpy.types.Material) -> str:
    nodes = block.node_tree.nodes if block.node_tree is not None else ()
    pictures = [node.image for node in nodes if getattr(node, "image", None) is not None]
    packed = [hashlib.sha256(each.packed_file.data).hexdigest() for each in pictures if each.packed_file is not None]
    shader = shader_of(block)
    light = [float(shader.inputs[name].default_value) for name in ("Alpha", "Emission Strength")] if shader else []
    return f"{surface_values(block).model_dump_json(exclude={'name'})} {packed} {light}"


def _points(piece: bpy.types.Object) -> np.ndarray:
    points = np.empty(3 * len(piece.data.vertices), np.float32)
    piece.data.vertices.foreach_get("co", points)
    return points.reshape(-1, 3).astype(float)
