"""Sets that are made of pictures: the size of a board in metres, its direction, its colour in every picture."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np
import pytest
from tests.textures import BROWN, PALE, write_surface

from storyblender.blender.models.tangents import TANGENTS
from storyblender.blender.moment_glb import write_moment
from storyblender.blender.render.coarser import in_coarser_pictures
from storyblender.blender.render.passes import Passes, render_passes
from storyblender.blender.render.session import RenderSession
from storyblender.blender.sets.build import build_set
from storyblender.blender.sets.textured import TEXTURED, load_textures
from storyblender.catalog.sets import plan_of
from storyblender.folder import Folder
from storyblender.library.texture_file import read_texture
from storyblender.memory.scene_context import Environment
from storyblender.memory.texture import Texture

pytestmark = pytest.mark.blender
METRES = 1.6
"""Four boards of 40 cm."""


@pytest.fixture
def scene() -> Iterator[bpy.types.Scene]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.name = "SC010"
    yield bpy.context.scene


def taken_in(folder: Path, metres: float = METRES, side: int = 64) -> Texture:
    texture, pictures = read_texture(write_surface(folder / "surface", side=side), metres)
    for name, data in pictures.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(data)
    return texture


def built(environment: Environment, scene: bpy.types.Scene, folder: Path) -> dict[str, bpy.types.Object]:
    plan = plan_of(environment)
    load_textures(plan, Folder(folder))
    objects = build_set(plan, scene, scene.collection)
    bpy.context.view_layer.update()
    return {obj["node_id"]: obj for obj in reversed(objects)}


def steps(mesh: bpy.types.Mesh) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield the sides of faces that are made of pictures: in metres, and in metres of the picture."""
    layer = mesh.uv_layers[0].uv
    for face in mesh.polygons:
        if TEXTURED in mesh.materials[face.material_index]:
            corners = list(face.loop_indices)
            for here, there in zip(corners, corners[1:] + corners[:1], strict=True):
                ends = [np.array(mesh.vertices[mesh.loops[loop].vertex_index].co) for loop in (here, there)]
                yield ends[1] - ends[0], (np.array(layer[there].vector) - np.array(layer[here].vector)) * METRES


def photographed(scene: bpy.types.Scene, eye: tuple[float, float, float], pitch: float, yaw: float = 0.0) -> Passes:
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.lens = 36
    camera.location, camera.rotation_euler = eye, (math.radians(90 + pitch), 0, math.radians(yaw))
    scene.collection.objects.link(camera)
    scene.camera = camera
    bpy.context.view_layer.update()
    with RenderSession(scene, camera) as session:
        return render_passes(session, 320, 180)


def gid_of(passes: Passes, node_id: str) -> int:
    return next(index for index, node in enumerate(passes.nodes, 1) if node.node_id == node_id)


def test_a_metre_of_the_picture_is_a_metre_of_every_wall(scene: bpy.types.Scene, tmp_path: Path) -> None:
    objects = built(Environment(kit="kitchen", wall_texture=taken_in(tmp_path)), scene, tmp_path)
    walls = [obj for name, obj in objects.items() if name.startswith("wall")]
    assert len(walls) >= 3
    for wall in walls:
        sides = list(steps(wall.data))
        assert sides and TANGENTS in wall.data.color_attributes
        for real, laid in sides:
            assert np.linalg.norm(laid) == pytest.approx(np.linalg.norm(real), abs=1e-4)
        levels = [laid[1] - real[2] for real, laid in sides if abs(real[2]) > 0.1]
        assert levels == pytest.approx([0] * len(levels), abs=1e-4), "courses are level, up is up"


@pytest.mark.parametrize(("width", "depth"), [(6.0, 4.0), (4.0, 6.0)])
def test_boards_of_a_floor_run_along_its_longer_side(
    scene: bpy.types.Scene, tmp_path: Path, width: float, depth: float
) -> None:
    size = {"width": width, "depth": depth}
    environment = Environment(kit="room", params=size, ground_texture=taken_in(tmp_path))
    built(environment, scene, tmp_path)
    passes = photographed(scene, (0.0, 0.0, 1.5), -90)
    floor = passes.gbuffer.albedo.astype(float)[..., 0]
    shown = passes.gbuffer.ids == gid_of(passes, "floor_1")
    assert shown.mean() > 0.9
    edges = [np.abs(np.diff(floor, axis=axis)).sum() for axis in (1, 0)]
    assert (edges[1] > 4 * edges[0]) == (width > depth)
    across = floor[:, 160] if width > depth else floor[90]
    changes = np.count_nonzero(np.abs(np.diff(across > 0.4)))
    seen = len(across) / (320 / 1.5)
    assert changes == pytest.approx(seen / (METRES / 4), abs=1.5), "a board is 40 cm wide"


def test_its_mean_colour_is_that_of_the_pictures_near_and_far(scene: bpy.types.Scene, tmp_path: Path) -> None:
    texture = taken_in(tmp_path, side=1024)
    built(Environment(kit="square", ground_texture=texture), scene, tmp_path)
    expected = (((np.array([BROWN, PALE]) / 255) + 0.055) / 1.055) ** 2.4
    for height in (3.0, 60.0):
        passes = photographed(scene, (0.0, 0.0, height), -90)
        shown = passes.gbuffer.ids == gid_of(passes, "ground_1")
        assert shown.sum() > 1000
        seen = passes.gbuffer.albedo[shown].astype(float)
        assert seen.mean(axis=0) == pytest.approx(expected.mean(axis=0), abs=0.03)
        assert seen.std() > 0.1 if height == 3.0 else seen[:, 0].std() < 0.06, "far off it does not swarm"


def test_the_relief_of_its_normal_map_is_drawn(scene: bpy.types.Scene, tmp_path: Path) -> None:
    built(Environment(kit="room", wall_texture=taken_in(tmp_path)), scene, tmp_path)
    passes = photographed(scene, (0.0, 0.0, 1.5), 0)
    relief = passes.gbuffer.relief
    assert relief is not None
    shown = (passes.gbuffer.ids == gid_of(passes, "wall_back")) & (np.abs(relief).sum(axis=2) > 0.5)
    leaning = np.median(relief[shown].astype(float), axis=0)
    assert abs(leaning[0]) == pytest.approx(0.25, abs=0.05) and leaning[1] == pytest.approx(-0.97, abs=0.03)


def test_a_facade_takes_it_too_and_what_is_not_meant_stays(scene: bpy.types.Scene, tmp_path: Path) -> None:
    objects = built(Environment(kit="street", wall_texture=taken_in(tmp_path)), scene, tmp_path)
    fronts = [obj for obj in objects.values() if obj.data.name.startswith("facade")]
    assert fronts and all(any(TEXTURED in block for block in front.data.materials) for front in fronts)
    others = [obj for obj in objects.values() if obj not in fronts and not obj["node_id"].startswith("wall")]
    assert not any(TEXTURED in block for obj in others for block in obj.data.materials)


def test_copies_for_far_off_leave_no_trace_in_the_file(scene: bpy.types.Scene, tmp_path: Path) -> None:
    built(Environment(kit="room", wall_texture=taken_in(tmp_path)), scene, tmp_path)
    materials = list(bpy.data.materials)
    before = {node.image for block in materials for node in block.node_tree.nodes if node.type == "TEX_IMAGE"}
    with in_coarser_pictures(materials, 2):
        pass
    after = {node.image for block in materials for node in block.node_tree.nodes if node.type == "TEX_IMAGE"}
    assert before == after and all(image.packed_file is not None for image in before)
    assert not any(image.users for image in bpy.data.images if image not in before)


def test_the_studio_gets_the_pictures_in_its_gltf(scene: bpy.types.Scene, tmp_path: Path) -> None:
    built(Environment(kit="room", wall_texture=taken_in(tmp_path)), scene, tmp_path)
    write_moment(scene, 1, tmp_path / "moment.glb")
    data = (tmp_path / "moment.glb").read_bytes()
    document = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
    material = next(each for each in document["materials"] if each["name"].startswith("TX_oak_boards"))
    looks = material["pbrMetallicRoughness"]
    assert "baseColorTexture" in looks and "metallicRoughnessTexture" in looks and "normalTexture" in material
    index = document["materials"].index(material)
    parts = [part for mesh in document["meshes"] for part in mesh["primitives"] if part.get("material") == index]
    assert parts and all("TEXCOORD_0" in part["attributes"] for part in parts)
