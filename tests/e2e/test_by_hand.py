"""A camera, a thing and a mark set by hand stand in the Blender file exactly there, and undo takes them back."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from storyblender.geometry.orbit import camera_around, rotation_matrix
from storyblender.project import read_project_graph
from tests.e2e.conftest import storyblender, typed

pytestmark = [pytest.mark.blender, pytest.mark.timeout(900)]

READ = """
import bpy, json, os, sys
bpy.ops.wm.open_mainfile(filepath=sys.argv[1], use_scripts=False)
scene = bpy.data.scenes["SC010"]
camera, start, length = bpy.data.objects[sys.argv[2]], 0, int(sys.argv[3])
start = next(marker.frame for marker in scene.timeline_markers if marker.camera is camera)
bpy.context.window.scene = scene
def matrix(frame, obj):
    scene.frame_set(frame)
    return [list(row) for row in obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).matrix_world]
things = {obj["node_id"]: obj for obj in scene.objects if obj.get("kind") == "prop"}
print("FACTS" + json.dumps({
    "first": matrix(start, camera), "last": matrix(start + length - 1, camera), "lens": camera.data.lens,
    "things": {name: matrix(start, obj) for name, obj in things.items() if name in sys.argv[4:]},
}), flush=True)
os._exit(0)
"""
SHOT, TURNED = "SC010_SH020", camera_around((0, 0, 0), 31.0, -7.5, 1.0, 50.0, roll=4.0).rotation
START, END = [0.4321, -1.9, 1.3], [-0.6, -1.7, 1.55]


def done(*arguments: str | Path) -> str:
    result = storyblender(*arguments, "--quiet")
    assert result.returncode == 0, result.stderr[-2000:]
    return result.stdout


def in_blender(project: Path, *things: str) -> dict[str, Any]:
    length = str(read_project_graph(project).shot(1, 2).duration)
    command = [sys.executable, "-c", READ, str(project / "story.blend"), SHOT, length, *things]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    line = next((line for line in ran.stdout.splitlines() if line.startswith("FACTS")), "")
    assert line, ran.stderr[-2000:]
    return json.loads(line[5:])


def test_what_is_placed_stands_just_there_and_undo_takes_it_back(project: Path, tmp_path: Path) -> None:
    frames = {path.name: path.read_bytes() for path in (project / "frames").glob("SC*.png")}
    graph = (project / "graph.json").read_bytes()
    layout = read_project_graph(project).scenes[0].layout
    assert layout is not None
    cup = next(item for item in layout.objects if 0.7 < item.location[2] < 0.8)
    edits = tmp_path / "edits.json"
    placed = {"start": {"location": START, "rotation": TURNED}, "end": {"location": END, "target": [0.0, 1.0, 1.0]}}
    edits.write_text(
        json.dumps(
            [
                {
                    "kind": "place",
                    "scene": "SC010",
                    "thing": "table",
                    "place": {"location": [0.1234, 0.05], "rotation": 77.7},
                },
                {"kind": "blocking", "shot": SHOT, "person": "tom", "marks": {"start": {"location": [-1.1, 0.9]}}},
                {"kind": "camera", "shot": SHOT, "decision": {"placed": placed, "lens": 28}},
            ]
        )
    )
    told = done("edit", project, "--batch", edits, "--json")
    assert "table placed at 0.12, 0.05" in told
    seen = in_blender(project, "table", cup.node_id)
    assert seen["lens"] == pytest.approx(28.0)
    first, last = np.array(seen["first"]), np.array(seen["last"])
    assert np.allclose(first[:3, :3], rotation_matrix(TURNED), atol=1e-6) and np.allclose(
        first[:3, 3], START, atol=1e-6
    )
    ahead = np.subtract([0.0, 1.0, 1.0], END)
    assert np.allclose(last[:3, 3], END, atol=1e-5) and np.allclose(
        -last[:3, 2], ahead / np.linalg.norm(ahead), atol=1e-5
    )
    table = np.array(seen["things"]["table"])
    assert np.allclose(table[:3, 3], [0.1234, 0.05, 0.0], atol=1e-6)
    assert np.allclose(table[:2, 0], [np.cos(np.radians(77.7)), np.sin(np.radians(77.7))], atol=1e-6)
    on_it = read_project_graph(project).scenes[0].layout
    assert on_it is not None
    carried = next(item for item in on_it.objects if item.node_id == cup.node_id)
    assert carried.location != cup.location and carried.location[2] == cup.location[2]
    drawn = {path.name: path.read_bytes() for path in (project / "frames").glob("SC*.png")}
    assert all(drawn[name] != frames[name] for name in frames), "the table is in every picture of this kitchen"
    typed("undo", project)
    assert (project / "graph.json").read_bytes() == graph


def test_a_camera_in_a_table_is_told_and_drawn(project: Path) -> None:
    layout = read_project_graph(project).scenes[0].layout
    assert layout is not None
    x, y, _ = next(item.location for item in layout.objects if item.node_id == "table")
    told = storyblender("edit", project, SHOT, "--at", f"{x},{y},0.72", "--look-at", "0,0,1")
    assert told.returncode == 0 and "the camera is in the table" in told.stdout + told.stderr
    camera = read_project_graph(project).shot(1, 2).camera
    assert camera is not None and "inside" in {flaw.kind for flaw in camera.residual}
    far = storyblender("edit", project, SHOT, "--at", "9000,0,1", "--look-at", "0,0,1")
    assert far.returncode != 0 and "too far from the set" in far.stderr


HIPS = """
import bpy, json, os, sys
bpy.ops.wm.open_mainfile(filepath=sys.argv[1], use_scripts=False)
scene = bpy.data.scenes["SC010"]
bpy.context.window.scene = scene
start = next(marker.frame for marker in scene.timeline_markers if marker.name == sys.argv[2])
scene.frame_set(start + 2)
depsgraph = bpy.context.evaluated_depsgraph_get()
rigs = {o.get("asset_id"): o.evaluated_get(depsgraph) for o in scene.objects if o.type == "ARMATURE"}
rig = rigs[sys.argv[3]]
hips = next(bone for bone in rig.pose.bones if bone.name == "hips")
print("FACTS" + json.dumps([*(rig.matrix_world @ hips.head)]), flush=True)
os._exit(0)
"""


def hips_in_blender(project: Path, person: str) -> list[float]:
    command = [sys.executable, "-c", HIPS, str(project / "story.blend"), SHOT, person]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    line = next((line for line in ran.stdout.splitlines() if line.startswith("FACTS")), "")
    assert line, ran.stderr[-2000:]
    return json.loads(line[5:])


def test_who_is_told_to_sit_sits_with_the_hips_on_the_seat(project: Path) -> None:
    stood = hips_in_blender(project, "tom")
    seats = read_project_graph(project).scenes[0].layout
    assert seats is not None
    chair = next(item for item in seats.objects if "chair" in item.node_id and item.node_id not in sat_on(project))
    done("pose", project, SHOT, "Tom", "--posture", "sit", "--on", chair.node_id, "--look-at", "ada")
    sits = hips_in_blender(project, "tom")
    assert stood[2] > 0.8 and 0.4 < sits[2] < 0.7, (stood, sits)
    assert np.linalg.norm(np.subtract(sits[:2], chair.location[:2])) < 0.35


def sat_on(project: Path) -> set[str | None]:
    return {each.start.support_id for shot in read_project_graph(project).shots for each in shot.blocking}
