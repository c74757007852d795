"""The Asset Formatter: however a file has a thing, the same thing comes out of it, and no larger than needed."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

bpy = pytest.importorskip("bpy")

from tests.model_files import turn_obj, write_globe  # noqa: E402

from storyblender.blender.models.simplify import face_budget  # noqa: E402
from storyblender.blender.props.build import PropBuild, build_prop  # noqa: E402
from storyblender.blender.props.imported import build_from_file  # noqa: E402
from storyblender.errors import InputError  # noqa: E402
from storyblender.memory.asset_sheet import ModelPose  # noqa: E402

pytestmark = pytest.mark.blender
SPIN = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
TIP = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])


@pytest.fixture(autouse=True)
def empty_file() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)


def written(key: str, path: Path, scale: float = 1.0, at: tuple[float, float, float] = (0, 0, 0)) -> Path:
    """Write a prop of the library as a file."""
    return exported(build_prop(key).mesh, path, scale, at)


def exported(mesh: bpy.types.Mesh, path: Path, scale: float = 1.0, at: tuple[float, float, float] = (0, 0, 0)) -> Path:
    """Write a mesh as a file."""
    obj = bpy.data.objects.new(path.stem, mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.scale, obj.location = (scale,) * 3, at
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    match path.suffix:
        case ".obj":
            bpy.ops.wm.obj_export(filepath=str(path))
        case ".fbx":
            bpy.ops.export_scene.fbx(filepath=str(path))
        case ".stl":
            bpy.ops.wm.stl_export(filepath=str(path))
        case ".ply":
            bpy.ops.wm.ply_export(filepath=str(path))
        case _:
            bpy.ops.export_scene.gltf(filepath=str(path), export_format="GLB")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return path


def points(build: PropBuild) -> np.ndarray:
    found = np.array([vertex.co[:] for vertex in build.mesh.vertices])
    return found[np.lexsort(found.round(3).T)]


@pytest.mark.parametrize("key", ["chair", "armchair", "sofa"])
def test_a_seat_is_the_same_however_its_file_is_turned_and_tipped(tmp_path: Path, key: str) -> None:
    straight = points(build_from_file(written(key, tmp_path / f"{key}.obj")))
    for tips, quarters in ((0, 1), (1, 2), (2, 3), (3, 0), (1, 0), (3, 1)):
        path = written(key, tmp_path / f"{key}.obj", 100)
        turn_obj(path, np.linalg.matrix_power(TIP, tips) @ np.linalg.matrix_power(SPIN, quarters))
        found = points(build_from_file(path))
        assert np.ptp(found, axis=0) == pytest.approx(np.ptp(straight, axis=0), abs=0.002), (tips, quarters)
        spread = [np.percentile(each, (10, 50, 90), axis=0) for each in (found, straight)]
        assert spread[0] == pytest.approx(spread[1], abs=0.01), (tips, quarters)


@pytest.mark.parametrize("key", ["wardrobe", "fridge", "bookshelf"])
def test_what_lies_on_its_back_and_faces_away_stands_and_faces_the_front(tmp_path: Path, key: str) -> None:
    straight = build_from_file(written(key, tmp_path / f"{key}.obj"))
    mean = points(straight).mean(axis=0)
    path = turn_obj(written(key, tmp_path / f"{key}.obj", 100), TIP @ SPIN @ SPIN)
    found = build_from_file(path)
    assert found.dimensions == pytest.approx(straight.dimensions, rel=0.01)
    assert points(found).mean(axis=0) == pytest.approx(mean, abs=0.02)


def test_where_a_file_has_its_origin_and_its_floor_does_not_matter(tmp_path: Path) -> None:
    straight = build_from_file(written("chair", tmp_path / "chair.glb"))
    path = written("chair", tmp_path / "chair.obj", at=(40, -7, 3))
    with path.open("a") as file:
        file.write("".join(f"v {x} 3 {z}\n" for x, z in ((36, 3), (44, 3), (44, 11), (36, 11))) + "f -4 -3 -2 -1\n")
    found = build_from_file(path)
    assert found.dimensions == pytest.approx(straight.dimensions, rel=0.01)
    assert any("ground" in note for note in found.notes)
    assert found.anchors[0].location == pytest.approx(straight.anchors[0].location, abs=0.02)


def test_a_fine_model_is_simplified_to_what_shows_and_keeps_outline_and_picture(tmp_path: Path) -> None:
    path = write_globe(tmp_path / "globe.glb", 320)
    found = build_from_file(path)
    assert 0.5 * face_budget(0.8) < len(found.mesh.polygons) <= face_budget(0.8) < 2 * 320**2
    assert any("faces become" in note for note in found.notes)
    place = points(found) - (0, 0, found.dimensions[2] / 2)
    radius = np.linalg.norm(place, axis=1)
    assert radius.min() > 0.385 and radius.max() < 0.415
    around, down = np.arctan2(-place[:, 1], place[:, 0]) % (2 * np.pi), np.arccos(place[:, 2] / radius)
    should = 0.4 + 0.01 * np.sin(8 * around) * np.sin(12 * down)
    assert np.abs(radius - should).max() < 0.004, "half a percent of its size"
    layout = np.array([loop.uv[:] for loop in found.mesh.uv_layers.active.data])
    corners = np.array([loop.vertex_index for loop in found.mesh.loops])
    height = np.array([vertex.co.z for vertex in found.mesh.vertices])[corners] - found.dimensions[2] / 2
    assert np.abs(np.cos(np.pi * (1 - layout[:, 1])) * 0.4 - height).max() < 0.03


@pytest.mark.slow
def test_two_million_faces_are_read(tmp_path: Path) -> None:
    found = build_from_file(write_globe(tmp_path / "globe.glb", 1000))
    assert len(found.mesh.polygons) <= face_budget(0.8)
    radius = np.linalg.norm(points(found) - (0, 0, found.dimensions[2] / 2), axis=1)
    assert radius.min() > 0.385 and radius.max() < 0.415


def test_a_picture_of_8192_pixels_is_made_smaller(tmp_path: Path) -> None:
    data = io.BytesIO()
    Image.new("RGB", (8192, 8192), (200, 30, 30)).save(data, "JPEG")
    found = build_from_file(write_globe(tmp_path / "globe.glb", 16, data.getvalue()))
    (image,) = (each for each in bpy.data.images if each.size[0] > 64)
    assert tuple(image.size) == (2048, 2048) and found.mesh.materials[0]


def test_who_looked_counts_more_than_the_shape_and_is_told_where_both_differ(tmp_path: Path) -> None:
    path = written("chair", tmp_path / "chair.glb")
    seen = build_from_file(path, pose=ModelPose(front="back", top="top"))
    assert seen.anchors[0].direction[1] > 0.99
    assert any("its shape" in note for note in seen.notes)
    assert not build_from_file(path, pose=ModelPose(front="front", top="top")).notes


@pytest.mark.parametrize("suffix", [".fbx", ".stl", ".ply"])
def test_what_blender_imports_comes_as_from_any_other_file(tmp_path: Path, suffix: str) -> None:
    straight = build_from_file(written("armchair", tmp_path / "armchair.glb"))
    found = build_from_file(written("armchair", tmp_path / f"armchair{suffix}"))
    assert found.dimensions == pytest.approx(straight.dimensions, rel=0.01)
    assert found.anchors[0].location == pytest.approx(straight.anchors[0].location, abs=0.03)
    assert found.anchors[0].direction[1] < -0.99
    assert len(found.mesh.materials) == (2 if suffix == ".fbx" else 1)


def test_a_picture_that_an_fbx_names_outside_the_folder_is_left_out(tmp_path: Path) -> None:
    folder = tmp_path / "models"
    folder.mkdir()
    image = bpy.data.images.new("secret", 8, 8)
    image.filepath_raw, image.file_format = str(tmp_path / "secret.png"), "PNG"
    image.save()
    mesh = build_prop("crate").mesh
    mesh.uv_layers.new(name="UVMap")
    material = bpy.data.materials.new("outside")
    material.use_nodes = True
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    shader = material.node_tree.nodes["Principled BSDF"]
    material.node_tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
    mesh.materials.clear()
    mesh.materials.append(material)
    path = exported(mesh, folder / "crate.fbx")
    found = build_from_file(path, folder=folder)
    assert any("secret.png" in note or "outside" in note for note in found.notes)
    assert not any(each.name.startswith("TX_") for each in bpy.data.images)


@pytest.mark.parametrize("suffix", [".fbx", ".stl", ".ply"])
def test_a_broken_file_is_one_sentence(tmp_path: Path, suffix: str) -> None:
    whole = written("crate", tmp_path / f"crate{suffix}").read_bytes()
    rng = np.random.default_rng(4)
    damaged = bytearray(whole)
    for place in rng.integers(0, len(whole), 300):
        damaged[place] = int(rng.integers(0, 256))
    for number, data in enumerate((b"", b"Kaydara", whole[: len(whole) // 2], bytes(damaged), b"ply\n" + whole)):
        path = tmp_path / f"crate_{number}{suffix}"
        path.write_bytes(data)
        try:
            build_from_file(path)
        except InputError as error:
            assert "\n" not in str(error)
