"""The story's .blend, opened as an artist opens it: names, cameras on markers, the EDIT, assets, nothing missing."""

from __future__ import annotations

import csv
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.e2e.conftest import storyblender

pytestmark = [pytest.mark.blender, pytest.mark.timeout(900)]

READ = """
import bpy, json, os, sys
bpy.ops.wm.open_mainfile(filepath=sys.argv[1], use_scripts=False)
scenes = {}
for scene in bpy.data.scenes:
    strips = scene.sequence_editor.strips if scene.sequence_editor else []
    scenes[scene.name] = {
        "collections": [c.name for c in scene.collection.children],
        "markers": [[m.name, m.frame, m.camera.name if m.camera else ""] for m in scene.timeline_markers],
        "strips": [[s.name, s.scene.name, s.scene_camera.name, s.frame_final_duration] for s in strips],
        "objects": [[o.name, o.type, o.get("kind"), o.get("node_id"), o.get("asset_id"), o.data.name if o.data else ""]
                    for o in scene.objects],
        "nla": {o.name: [t.name for t in o.animation_data.nla_tracks]
                for o in scene.objects if o.type == "ARMATURE" and o.animation_data},
    }
facts = {
    "scenes": scenes,
    "opens_on": bpy.context.window.scene.name,
    "views": [area.spaces.active.region_3d.view_perspective
              for screen in bpy.data.screens for area in screen.areas if area.type == "VIEW_3D"],
    "assets": [c.name for c in bpy.data.collections if c.asset_data],
    "missing": [i.name for i in bpy.data.images if i.source == "FILE" and not i.packed_file],
    "libraries": len(bpy.data.libraries),
    "counts": {kind: len(getattr(bpy.data, kind)) for kind in ("objects", "meshes", "actions", "armatures", "lights")},
}
print("FACTS" + json.dumps(facts), flush=True)
os._exit(0)
"""


@pytest.fixture(scope="module")
def facts(project: Path) -> dict[str, Any]:
    return read(project)


def read(project: Path) -> dict[str, Any]:
    command = [sys.executable, "-c", READ, str(project / "story.blend")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    line = next((line for line in done.stdout.splitlines() if line.startswith("FACTS")), "")
    assert line, done.stderr[-2000:]
    return json.loads(line[5:])


def rows(project: Path) -> list[dict[str, str]]:
    return list(csv.DictReader((project / "shots.csv").open(encoding="utf-8-sig")))


def test_every_shot_has_a_camera_on_a_marker(project: Path, facts: dict[str, Any]) -> None:
    markers = facts["scenes"]["SC010"]["markers"]
    assert [name for name, _, _ in markers] == [row["shot"] for row in rows(project)]
    assert all(name == camera for name, _, camera in markers)


def test_the_file_opens_on_the_first_shot_through_its_camera(facts: dict[str, Any]) -> None:
    assert facts["opens_on"] == "SC010"
    assert set(facts["views"]) == {"CAMERA"}


def test_the_edit_has_one_strip_a_shot_with_its_camera_and_length(project: Path, facts: dict[str, Any]) -> None:
    strips = facts["scenes"]["EDIT"]["strips"]
    expected = [[row["shot"], "SC010", row["shot"], int(row["frames"])] for row in rows(project)]
    assert strips == expected


def test_every_object_says_what_it_is(facts: dict[str, Any]) -> None:
    objects = facts["scenes"]["SC010"]["objects"]
    assert not [name for name, _, kind, node, _, _ in objects if not kind or not node]
    kinds = {kind for _, _, kind, _, _, _ in objects}
    assert {"character", "prop", "set", "camera", "light"} <= kinds


def test_parts_of_a_person_share_the_asset(facts: dict[str, Any]) -> None:
    parts = [name for name, _, kind, _, asset, _ in facts["scenes"]["SC010"]["objects"] if asset == "ada"]
    assert len(parts) >= 4


def test_people_have_one_strip_a_shot(project: Path, facts: dict[str, Any]) -> None:
    tracks = facts["scenes"]["SC010"]["nla"]["SC010.ada"]
    assert sorted(tracks) == sorted(row["shot"] for row in rows(project))


def test_equal_assets_share_their_mesh(facts: dict[str, Any]) -> None:
    by_asset: dict[str, set[str]] = {}
    for _, kind, node, _, asset, data in facts["scenes"]["SC010"]["objects"]:
        if node == "prop" and kind == "MESH":
            by_asset.setdefault(asset, set()).add(data)
    assert by_asset and all(len(meshes) == 1 for meshes in by_asset.values()), by_asset


def test_assets_are_marked_and_nothing_is_missing(facts: dict[str, Any]) -> None:
    assert {"AST_ada", "AST_tom"} <= set(facts["assets"])
    assert facts["missing"] == [] and facts["libraries"] == 0


def test_a_scene_put_in_anew_is_as_in_a_whole_file(project: Path) -> None:
    name = rows(project)[0]["shot"]
    for command in (["edit", project, name, "--lens", "41"], ["render", project]):
        done = storyblender(*command, "--quiet")
        assert done.returncode == 0, done.stderr[-2000:]
        if command[0] == "edit":
            patched = read(project)
            (project / "build" / "story.json").unlink()
    assert read(project) == patched


def test_a_scene_goes_to_gltf_with_its_cameras_people_and_motion(project: Path) -> None:
    assert storyblender("export", project, "--to", "glb", "--quiet").returncode == 0
    data = (project / "export" / "SC010.glb").read_bytes()
    held = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
    nodes = {node["name"]: node for node in held["nodes"]}
    shots = {row["shot"] for row in rows(project)}
    assert shots <= set(nodes) and len(held["skins"]) >= 2
    motions = {animation["name"]: animation for animation in held["animations"]}
    assert shots <= set(motions)
    for person in ("SC010.ada", "SC010.tom"):
        assert any(nodes[person]["translation"]), "without motion people stand where the scene begins"
        for shot in shots:
            targets = [channel["target"] for channel in motions[shot]["channels"]]
            moved = {(held["nodes"][target["node"]]["name"], target["path"]) for target in targets}
            assert (person, "translation") in moved, f"{person} stands somewhere in {shot}"
