"""Seated clothes: the key exists, keeps the waist, and brings the cloth off the seat."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from storyblender.blender.people.body import RiggedBody
from storyblender.blender.people.drape import drape_seated, seated_pose
from storyblender.blender.people.pack import load_body_pack
from storyblender.blender.people.person import build_person
from storyblender.memory.asset_sheet import CharacterLook, Garment

pytestmark = [
    pytest.mark.blender,
    pytest.mark.skipif(load_body_pack() is None, reason="the body data has not been fetched"),
]


def _points(block: bpy.types.ShapeKey) -> np.ndarray:
    flat = np.empty(len(block.data) * 3, np.float32)
    block.data.foreach_get("co", flat)
    return flat.reshape(-1, 3)


def _seated(body: RiggedBody, garment: bpy.types.Object, points: np.ndarray) -> np.ndarray:
    """Return points of a garment, skinned with the seated pose."""
    weights = np.zeros((len(points), len(body.bone_names)))
    for vertex in garment.data.vertices:
        for entry in vertex.groups:
            weights[vertex.index, body.bone_names.index(garment.vertex_groups[entry.group].name)] = entry.weight
    matrices, shifts = seated_pose(body).blended(weights)
    return np.einsum("vij,vj->vi", matrices, points) + shifts


def test_a_skirt_is_draped_over_the_lap() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    keys = ("blouse", "skirt", "shoes")
    build = build_person("iris", CharacterLook(gender="female", age=30, garments=[Garment(key=k) for k in keys]), 3)
    (skirt,) = drape_seated(build)
    assert skirt.name == "iris_skirt"
    blocks = skirt.data.shape_keys.key_blocks
    assert blocks["sit"].value == 0
    rest, sit = _points(blocks["Basis"]), _points(blocks["sit"])
    waist = rest[:, 2] > rest[:, 2].max() - 0.02
    assert np.abs(sit[waist] - rest[waist]).max() < 1e-6
    assert 0.02 < np.abs(sit - rest).max() < 0.6

    # Skinned with the seated pose, the draped skirt does not hang through the seat as the stiff one does.
    body = build.body
    stiff, draped = (_seated(body, skirt, points) for points in (rest, sit))
    behind_the_knees = stiff[:, 1] > body.heads[body.bone_names.index("thigh.L")][1] - 0.2
    assert draped[behind_the_knees, 2].min() > stiff[behind_the_knees, 2].min() + 0.01


def test_trousers_need_no_drape() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    keys = ("shirt", "trousers", "shoes")
    build = build_person("jim", CharacterLook(gender="male", age=30, garments=[Garment(key=k) for k in keys]), 3)
    assert drape_seated(build) == []


def test_no_trousers_show_through_the_edges_of_a_coat_on_the_lap() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    keys = ("blouse", "trousers", "shoes", "coat")
    build = build_person("vera", CharacterLook(gender="female", age=60, garments=[Garment(key=k) for k in keys]), 3)
    (coat,) = drape_seated(build)
    trousers = next(mesh for mesh in build.meshes if mesh.name == "vera_trousers")
    rest = np.array([vertex.co[:] for vertex in trousers.data.vertices])
    faces = [list(polygon.vertices) for polygon in trousers.data.polygons]
    legs = BVHTree.FromPolygons(_seated(build.body, trousers, rest).tolist(), faces)
    points = _seated(build.body, coat, _points(coat.data.shape_keys.key_blocks["sit"]))
    middles = np.array([points[list(edge.vertices)].mean(0) for edge in coat.data.edges])
    found = [(middle, *legs.find_nearest(middle, 0.03)[:2]) for middle in map(Vector, middles)]
    lap = [(middle - near).dot(normal) for middle, near, normal in found if near is not None and normal.z > 0.5]
    assert len(lap) > 30
    assert min(lap) > 0.001
