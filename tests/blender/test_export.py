"""Scenes for other programs: who is seen when, what burns, where an animation begins."""

from __future__ import annotations

import json
import struct
import sys
from pathlib import Path
from typing import Any

import bpy
import pytest

sys.path.insert(0, str(Path(__file__).parent))

from story_stage import LENGTH, SKY, lamp, pack, shot, story

from storyblender.blender.export import export_scene
from storyblender.blender.materials import material
from storyblender.blender.people.control_rig import CONTROLS, SWITCHES
from storyblender.blender.session import BlenderSession
from storyblender.blender.story import compile_story
from storyblender.blender.usd_visibility import _library
from storyblender.folder import Folder
from storyblender.memory.jobs import ExportJob
from storyblender.memory.scene_context import Lighting

SHOTS = ("SC010_SH010", "SC010_SH020", "SC010_SH030")


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Tom comes on with the second shot, whose camera takes the back wall away; each shot has a light of its own."""
    root = tmp_path_factory.mktemp("story")
    packs = [pack(root, 1, 3, {"ada": 1, "tom": 2})]
    shots = [shot(1, 1), shot(1, 2, hidden=("wall_back",)), shot(1, 3)]
    shots = [each.model_copy(update={"lights": (lamp("ada_key"),)}) for each in shots]
    compile_story(story(packs, shots, Lighting(lights=(lamp("pendant", "set"),), sky=SKY)), Folder(root))
    return root / "story.blend"


@pytest.fixture(scope="module")
def glb(file: Path) -> Path:
    export_scene(file, "SC010", "glb", file.with_name("scene.glb"))
    return file.with_name("scene.glb")


@pytest.fixture(scope="module")
def held(glb: Path) -> dict[str, Any]:
    data = glb.read_bytes()
    binary = 20 + int.from_bytes(data[12:16], "little")
    return json.loads(data[20:binary]) | {"binary": data[binary + 8 :]}


def test_every_animation_is_a_shot_and_starts_at_zero(held: dict[str, Any]):
    animations = {animation["name"]: animation for animation in held["animations"]}
    assert set(animations) == set(SHOTS)
    for animation in animations.values():
        times = [held["accessors"][sampler["input"]] for sampler in animation["samplers"]]
        assert {time["min"][0] for time in times} == {0}
        assert max(time["max"][0] for time in times) <= LENGTH / 24
        targets = [(channel["target"]["node"], channel["target"]["path"]) for channel in animation["channels"]]
        assert len(targets) == len(set(targets))


def test_gltf_hides_by_scale_who_is_not_seen(held: dict[str, Any]):
    nodes = {node["name"]: index for index, node in enumerate(held["nodes"])}
    assert held["nodes"][nodes["SC010.tom_rig"]]["scale"] == [0.001] * 3, "without an animation it is the first shot"
    assert "scale" not in held["nodes"][nodes["SC010.wall_back"]]
    ends = {}
    for animation in held["animations"]:
        for name in ("SC010.tom_rig", "SC010.wall_back"):
            channel = {"node": nodes[name], "path": "scale"}
            (sampler,) = [each["sampler"] for each in animation["channels"] if each["target"] == channel]
            ends[animation["name"], name] = _first(held, animation["samplers"][sampler]["output"])
    assert [ends[shot, "SC010.tom_rig"] for shot in SHOTS] == [0, 1, 1]
    assert [ends[shot, "SC010.wall_back"] for shot in SHOTS] == [1, 0, 1]


def _first(held: dict[str, Any], accessor: int) -> float:
    view = held["bufferViews"][held["accessors"][accessor]["bufferView"]]
    return struct.unpack_from("<f", held["binary"], view["byteOffset"])[0]


def test_a_door_turns_in_the_animation_of_its_shot(held: dict[str, Any]):
    door = next(index for index, node in enumerate(held["nodes"]) if node["name"] == "SC010.table")
    counts = {}
    for animation in held["animations"]:
        for channel in animation["channels"]:
            if channel["target"] == {"node": door, "path": "rotation"}:
                counts[animation["name"]] = held["accessors"][animation["samplers"][channel["sampler"]]["input"]][
                    "count"
                ]
    assert counts["SC010_SH020"] > 2 >= counts["SC010_SH010"]


def test_gltf_has_the_lamps_of_the_set_alone(held: dict[str, Any]):
    lights = held["extensions"]["KHR_lights_punctual"]["lights"]
    assert [light["name"] for light in lights] == ["SC010.pendant"]


def test_the_controls_of_rigs_are_for_blender_alone(held: dict[str, Any]):
    names = {node["name"] for node in held["nodes"]}
    assert {"SC010.tom_rig", "SC010.ada_rig", "head"} <= names and not names & set(CONTROLS)
    assert not [node["name"] for node in held["nodes"] if set(SWITCHES) & set(node.get("extras", ()))]


def test_a_reader_of_gltf_gets_what_was_written(glb: Path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(glb))
    objects = bpy.data.objects
    assert max(objects["SC010.tom_rig"].scale) < 0.01 < 1 == objects["SC010.ada_rig"].scale.x
    assert set(SHOTS) <= {track.name for track in objects["SC010.tom_rig"].animation_data.nla_tracks}


def test_usd_shows_everybody_when_they_are_seen(file: Path):
    out = file.with_name("scene.usdc")
    export_scene(file, "SC010", "usd", out)
    Usd, UsdGeom = _library()
    stage = Usd.Stage.Open(str(out))
    starts = [1 + LENGTH * number for number in range(len(SHOTS))]

    def seen(name: str) -> list[bool]:
        prim = UsdGeom.Imageable(stage.GetDefaultPrim().GetChild(name))
        assert prim, name
        return [prim.ComputeVisibility(frame + 1) == UsdGeom.Tokens.inherited for frame in starts]

    assert seen("SC010_tom_rig") == [False, True, True]
    assert seen("SC010_wall_back") == [True, False, True]
    assert seen("SC010_ada_rig") == [True, True, True]
    lights = [prim.GetName() for prim in stage.GetDefaultPrim().GetChildren() if "ada_key" in prim.GetName()]
    assert len(lights) == len(SHOTS)
    for light in lights:
        assert seen(light) == [light.startswith(shot) for shot in SHOTS]


def test_the_pictures_of_a_usd_file_lie_beside_it(tmp_path: Path):
    packs = [pack(tmp_path, 1, 1)]
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / packs[0].path))
    board = material("wood")
    bpy.data.objects["SC010.table"].data.materials.append(board)
    bpy.data.objects["SC010.table"].data.uv_layers.new(name="UV")
    bpy.ops.wm.save_mainfile()
    compile_story(story(packs, [shot(1, 1)]), Folder(tmp_path))
    BlenderSession(tmp_path).export_scene(
        ExportJob(story="story.blend", scene_id=1, format="usd", out="export/SC010.usdc")
    )
    assert next((tmp_path / "export" / "textures").iterdir()).read_bytes()[:4] == b"\x89PNG"
