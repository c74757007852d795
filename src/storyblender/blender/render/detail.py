"""Bodies, hair and clothes with no more faces than a small moving picture can show.

Blender bends, shades and draws every corner of a mesh anew in every frame; a skin has ten thousand faces, of which a
head forty pixels high shows some hundred (measured: two microseconds of processor a vertex and frame).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager

import bpy
import numpy as np
from mathutils import Vector
from mathutils.kdtree import KDTree

from storyblender.blender.measure.figures import figures
from storyblender.blender.render.session import RenderSession

_LOOK_EVERY = 24
"""Frames between looks at how near people come."""
_PIXELS = 3.0
"""Square pixels of surface, front and back, that one vertex stands for."""
_CLOSE = 0.1
"""Metres before the eye nearer than which no person can be."""
_MOST = 4
"""Times that a mesh is halved."""
_SMALL = 300
"""Vertices up to which a mesh is left as it is."""


@contextmanager
def in_detail_seen(session: RenderSession, frames: Sequence[int], width: int, height: int) -> Iterator[None]:
    """Give everybody the detail that the shot can show; the scene is as it was afterwards.

    Args:
        session: The shot.
        frames: Timeline frames, at least one.
        width: Pixels of the picture.
        height: Pixels of the picture.
    """
    scale = _nearest(session, (*frames[::_LOOK_EVERY], frames[-1]), width, height)
    session.go_to(frames[0])
    levels: dict[bpy.types.Object, int] = {}
    for obj in session.scene.objects:
        if obj.type == "MESH" and not obj.hide_render and any(part.type == "ARMATURE" for part in obj.modifiers):
            level = _level(obj.data, scale.get(str(obj.get("node_id")), 0.0))
            if level > 0 and len(obj.data.vertices) > _SMALL:
                levels[obj] = level
    _make_missing({obj.data: level for obj, level in levels.items()})
    whole = [obj.data for obj in levels]
    try:
        for obj, level in levels.items():
            obj.data = obj.data[_name(level)]
        yield
    finally:
        for obj, mesh in zip(levels, whole, strict=True):
            obj.data = mesh


def _nearest(session: RenderSession, frames: Sequence[int], width: int, height: int) -> dict[str, float]:
    """Return the most pixels a metre of each person covers, by node_id."""
    scale: dict[str, float] = {}
    for number in frames:
        session.go_to(number)
        view = session.view(width, height)
        for figure in figures(session.scene):
            depth = float(view.project(np.asarray(figure.face))[2]) - figure.head
            pixels = view.pixels_per_metre / max(depth, _CLOSE)
            scale[figure.node_id] = max(scale.get(figure.node_id, 0.0), pixels)
    return scale


def _level(mesh: bpy.types.Mesh, pixels_per_metre: float) -> int:
    """Return how many times the mesh may be halved."""
    areas = np.empty(len(mesh.polygons), np.float32)
    mesh.polygons.foreach_get("area", areas)
    wanted = float(areas.sum()) * pixels_per_metre**2 / _PIXELS
    return int(np.clip(round(np.log2(len(mesh.vertices) / max(wanted, 1.0))), 0, _MOST))


def _name(level: int) -> str:
    """Return the name under which a mesh keeps its reduced ones: the next shot of the scene wants them too."""
    return f"halved {level} times"


def _make_missing(wanted: Mapping[bpy.types.Mesh, int]) -> None:
    """Reduce the meshes that are not known yet; shape keys go with them."""
    missing = {mesh: level for mesh, level in wanted.items() if _name(level) not in mesh}
    bench = bpy.data.scenes.new("decimated")
    used: list[bpy.types.ID] = [bench]
    try:
        for mesh, level in missing.items():
            plain = bpy.data.objects.new("decimated", mesh.copy())
            used += [plain, plain.data]
            plain.shape_key_clear()
            plain.modifiers.new("decimate", "DECIMATE").ratio = 0.5**level
            bench.collection.objects.link(plain)
        bench.view_layers[0].update()
        depsgraph = bench.view_layers[0].depsgraph
        for (mesh, level), plain in zip(missing.items(), list(bench.objects), strict=True):
            evaluated = plain.evaluated_get(depsgraph)
            reduced = bpy.data.meshes.new_from_object(evaluated, preserve_all_data_layers=True, depsgraph=depsgraph)
            if mesh.shape_keys is not None:
                plain.modifiers.clear()
                plain.data = reduced
                _give_keys(plain, mesh.shape_keys)
            mesh[_name(level)] = reduced
    finally:
        bpy.data.batch_remove(used)


def _give_keys(shown: bpy.types.Object, keys: bpy.types.Key) -> None:
    """Give the object's mesh the keys, their values and their animation: each vertex moves as the nearest one did."""
    basis = _points(keys.reference_key)
    here = np.empty(len(shown.data.vertices) * 3, np.float32)
    shown.data.vertices.foreach_get("co", here)
    here = here.reshape(-1, 3)
    nearest = _nearest_of(basis, here)
    for block in keys.key_blocks:
        made = shown.shape_key_add(name=block.name, from_mix=False)
        made.slider_min, made.slider_max = block.slider_min, block.slider_max
        made.value = block.value
        made.data.foreach_set("co", (here + (_points(block) - basis)[nearest]).ravel())
    data = keys.animation_data
    if data is not None and data.action is not None:
        own = shown.data.shape_keys.animation_data_create()
        own.action, own.action_slot = data.action, data.action_slot


def _points(block: bpy.types.ShapeKey) -> np.ndarray:
    points = np.empty(len(block.data) * 3, np.float32)
    block.data.foreach_get("co", points)
    return points.reshape(-1, 3)


def _nearest_of(points: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    tree = KDTree(len(points))
    for index, point in enumerate(points.tolist()):
        tree.insert(Vector(point), index)
    tree.balance()
    return np.array([tree.find(Vector(point))[1] for point in wanted.tolist()], np.int64)
