"""A panorama as the world of a scene: packed into the story's file, turned as the light plan says."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))

from story_stage import SKY, pack, shot, story
from tests.panoramas import sky

from storyblender.blender.render.cycles import render_cycles
from storyblender.blender.render.lamps import PANORAMA, PanoramaImage, lit
from storyblender.blender.render.session import RenderSession
from storyblender.blender.story import compile_story
from storyblender.folder import Folder
from storyblender.library.panorama_file import radiance_file
from storyblender.look.irradiance import panorama_directions
from storyblender.memory.panorama import PanoramaLight
from storyblender.memory.scene_context import Lighting

NINE = ((0.1, 0.1, 0.1),) * 9


def light(yaw: float = 0.0, strength: float = 1.0) -> PanoramaLight:
    return PanoramaLight(digest="5c1" * 6, yaw=yaw, strength=strength, irradiance=NINE)


def written(folder: Path, picture: np.ndarray) -> Path:
    path = folder / light().file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(radiance_file(picture))
    return path


def test_the_world_of_the_scene_holds_the_packed_picture(tmp_path: Path):
    written(tmp_path, sky())
    packs, shots = [pack(tmp_path, 1, 2), pack(tmp_path, 2, 1)], [shot(1, 1), shot(1, 2), shot(2, 1)]
    shots[1] = shots[1].model_copy(update={"lighting": Lighting(sky=SKY)})
    compile_story(story(packs, shots, Lighting(sky=SKY, panorama=light(30))), Folder(tmp_path))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "story.blend"), use_scripts=False)
    (picture,) = (image for image in bpy.data.images if image.source == "FILE" and image.name.endswith(".hdr"))
    assert picture.packed_file is not None and tuple(picture.size) == (128, 64) and picture.is_float
    assert str(tmp_path) not in f"{picture.filepath} {picture.packed_files[0].filepath}"
    nodes = {name: bpy.data.scenes[name].world.node_tree.nodes for name in ("SC010", "SC020")}
    for own in nodes.values():
        assert next(node for node in own if node.type == "TEX_ENVIRONMENT").image == picture
    scene = bpy.context.window.scene = bpy.data.scenes["SC010"]
    shares = []
    for marker in scene.timeline_markers:
        scene.frame_set(marker.frame)
        shares.append(scene.world.node_tree.nodes[f"{PANORAMA}_share"].inputs["Fac"].default_value)
    assert shares == [1.0, 0.0], "the second shot has the sky of another plan"


@pytest.mark.parametrize("yaw", [0.0, 70.0])
@pytest.mark.parametrize("seen", [True, False])
def test_cycles_sees_it_where_numpy_has_it(tmp_path: Path, yaw: float, seen: bool):
    toward = panorama_directions(64, 128)
    spot = np.array([0.6, 0.7, 0.39])
    path = written(tmp_path, (0.02 + 3.0 * (toward @ (spot / np.linalg.norm(spot)) > 0.97))[..., None].repeat(3, -1))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    scene.collection.objects.link(camera)
    turn = math.atan2(0.7, 0.6) + math.radians(yaw)  # the azimuth at which the spot must be seen
    camera.rotation_euler = (math.pi / 2 + math.asin(0.39), 0, turn - math.pi / 2)
    scene.camera = camera
    with (
        RenderSession(scene, camera, None, ()) as session,
        lit(scene, (), SKY, (), PanoramaImage(light(yaw), path, seen=seen)),
    ):
        picture = render_cycles(session, 64, 36, samples=4, bounces=1, seed=0, draft=True)
    middle, corner = picture[16:20, 30:34].mean(), picture[:3, :3].mean()
    assert (middle > 2.5 and corner < 0.1) if seen else middle < 0.3
    assert not bpy.data.images.get(path.name)
