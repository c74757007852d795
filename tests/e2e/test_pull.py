"""Edits in Blender, saved, pulled, and built again: each is taken over as that edit, and stays."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from storyblender.deliver.panel import panels
from storyblender.edits.words import edits_of
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from tests.e2e.conftest import SCRIPT, SMALL, made

pytestmark = [pytest.mark.blender, pytest.mark.slow]

IN_BLENDER = """
import bpy, sys
bpy.ops.wm.open_mainfile(filepath=sys.argv[1], use_scripts=False)
scene = bpy.data.scenes["SC010"]
objects = sorted(scene.objects, key=lambda obj: obj.name)
thing = next(obj for obj in objects if str(obj.get("node_id")).startswith("set_") and obj.get("kind") == "prop")
camera = next(obj for obj in objects if obj.type == "CAMERA" and not obj.animation_data)
lamp = next(obj for obj in objects if obj.type == "LIGHT" and not obj["node_id"].startswith("ambient"))
person = next(obj for obj in objects if obj.type == "ARMATURE" and obj["node_id"] == "tom")
def bag_of(strip):
    return strip.action.layers[0].strips[0].channelbag(strip.action_slot)
def movement(strip):
    heights = [[point.co.y for point in curve.keyframe_points] for curve in bag_of(strip).fcurves]
    return max(max(each) - min(each) for each in heights)
strip = max((track.strips[0] for track in person.animation_data.nla_tracks), key=movement)
bag = bag_of(strip)
"""


def in_blender(story: Path, code: str) -> None:
    """Change a file as a person in Blender would, in a process that ends at once: bpy may hang at exit."""
    text = f"import os\n{IN_BLENDER}\n{code}\nbpy.ops.wm.save_mainfile()\nos._exit(0)"
    subprocess.run([sys.executable, "-c", text, str(story)], check=True, stdout=subprocess.DEVNULL)


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("pulled")
    (folder / "two_cups.fountain").write_text(SCRIPT, encoding="utf-8")
    made([folder / "two_cups.fountain", "--out", folder / "two_cups.storyboard", "--no-animatic", *SMALL])
    return folder / "two_cups.storyboard"


def pulled(project: Path) -> Any:
    with Studio(Settings.load(project=project)).open(project) as session:
        found = session.pull()
        if found.applied is not None:
            session.draw(found.applied)
        else:
            session.render()
        again = session.pull()
        assert not again.files, "a build after it keeps it, and there is nothing left to pull"
        return found


def saved(project: Path) -> Any:
    """Return what the compiled file says of the first static thing and camera."""
    code = """
import json
print(json.dumps({"thing": [*thing.location, thing.rotation_euler.z], "size": list(thing.dimensions),
    "camera": [*camera.location, camera.data.lens, camera.data.dof.aperture_fstop], "name": thing.get("node_id"),
    "markers": {marker.name: marker.frame for marker in scene.timeline_markers}}), file=sys.stderr)
"""
    text = f"{IN_BLENDER}\n{code}"
    ran = subprocess.run(
        [sys.executable, "-c", text, str(project / "story.blend")], check=True, capture_output=True, text=True
    )
    return json.loads(ran.stderr.splitlines()[-1])


def test_a_file_that_was_only_saved_changes_nothing(project: Path) -> None:
    in_blender(project / "story.blend", "")
    before = read_project_graph(project)
    found = pulled(project)
    assert not (found.understood or found.conflicts or found.kept)
    assert read_project_graph(project) == before


@pytest.mark.parametrize(
    ("code", "kept"),
    [
        ("thing.location.x += 0.3", lambda was, now: abs(now["thing"][0] - was["thing"][0] - 0.3) < 0.002),
        ("thing.rotation_euler.z += 0.5", lambda was, now: abs(now["thing"][3] - was["thing"][3] - 0.5) < 0.01),
        ("thing.scale = (1.2,) * 3", lambda was, now: abs(now["size"][2] / was["size"][2] - 1.2) < 0.02),
        ("camera.location.z += 0.2", lambda was, now: abs(now["camera"][2] - was["camera"][2] - 0.2) < 0.002),
        ("camera.data.lens += 10", lambda was, now: abs(now["camera"][3] - was["camera"][3] - 10) < 0.1),
        (
            "camera.data.dof.use_dof = True; camera.data.dof.aperture_fstop = 1.4",
            lambda was, now: abs(now["camera"][4] - 1.4) < 0.01,
        ),
        (
            "list(scene.timeline_markers)[1].frame -= 6",
            lambda was, now: sorted(was["markers"].values())[1] - sorted(now["markers"].values())[1] == 6,
        ),
    ],
)
def test_an_edit_in_blender_is_pulled_as_that_edit_and_stays(
    project: Path, code: str, kept: Callable[[Any, Any], bool]
) -> None:
    was = saved(project)
    in_blender(project / "story.blend", code)
    found = pulled(project)
    assert len(found.understood) == 1 and not found.kept and not found.conflicts, found
    assert kept(was, saved(project)), "the file that is built after it has the edit"


def test_a_lamp_is_dimmed_moved_and_taken_away(project: Path) -> None:
    in_blender(project / "story.blend", "lamp.data.energy *= 3; lamp.location.z -= 0.4")
    found = pulled(project)
    assert len(found.understood) == 1 and not found.kept, found
    [decision] = [scene.light_decision for scene in read_project_graph(project).scenes if scene.light_decision]
    [(name, lamp)] = decision.lamps.items()
    plan = next(each.lighting for each in read_project_graph(project).scenes if each.light_decision)
    assert plan is not None and lamp is not None
    assert next(light.power for light in plan.lights if light.name == name) == lamp.power
    in_blender(project / "story.blend", f"bpy.data.objects.remove(scene.objects['SC010.{name}'])")
    assert len(pulled(project).understood) == 1
    plan = next(each.lighting for each in read_project_graph(project).scenes if each.light_decision)
    assert plan is not None and name not in {light.name for light in plan.lights}


def test_a_copy_is_one_more_thing_where_it_stands(project: Path) -> None:
    code = "copy = thing.copy(); copy.location.x += 1.1; scene.collection.objects.link(copy)"
    was = saved(project)["thing"]
    in_blender(project / "story.blend", code)
    found = pulled(project)
    assert len(found.understood) == 1 and not found.kept, found
    added = [asset.asset_id for asset in read_project_graph(project).assets if asset.origin == "user"]
    items = [item for scene in read_project_graph(project).scenes if scene.layout for item in scene.layout.objects]
    [item] = [item for item in items if item.asset_id in added]
    assert abs(item.location[0] - was[0] - 1.1) < 0.01 and abs(item.location[1] - was[1]) < 0.01


def test_another_name_is_printed_and_nothing_is_drawn_for_it(project: Path) -> None:
    in_blender(project / "story.blend", "person.name = 'SC010.The Stranger'")
    found = pulled(project)
    assert len(found.understood) == 1 and found.applied is not None and not found.applied.stale, found
    assert "The Stranger" in {asset.name for asset in read_project_graph(project).assets}


def test_what_no_edit_can_say_is_kept_in_a_copy_and_told(project: Path) -> None:
    code = "crane = bpy.data.objects.new('Crane', bpy.data.cameras.new('Crane')); scene.collection.objects.link(crane)"
    before, copies = read_project_graph(project), set(project.glob("story *.blend"))
    in_blender(project / "story.blend", code)
    found = pulled(project)
    assert found.kept and not found.understood
    assert read_project_graph(project).scenes == before.scenes
    assert len(set(project.glob("story *.blend")) - copies) == 1


POSED = """
bone = person.pose.bones["head"]
bone.rotation_quaternion = (0.9, 0.3, 0.3, 0.0)
bone.keyframe_insert("rotation_quaternion", frame=strip.frame_start + 10)
"""
REACHED = """
person["ik_hand_R"] = 1.0
bone = person.pose.bones["hand_ik.R"]
bone.location.x += 0.15
bone.keyframe_insert("location", frame=strip.frame_start + 10)
"""
SEEN = """
bpy.context.window.scene = scene
parts = []
for frame in range(10, 60, 8):
    scene.frame_set(int(strip.frame_start) + frame)
    rig = person.evaluated_get(bpy.context.evaluated_depsgraph_get())
    bones = [rig.matrix_world @ rig.pose.bones[bone].matrix for bone in ("head", "hand.R", "foot.L")]
    parts += [round(part, 3) for bone in bones for row in bone for part in row]
print(parts, file=sys.stderr)
"""


def seen(story: Path) -> list[float]:
    ran = subprocess.run(
        [sys.executable, "-c", f"{IN_BLENDER}\n{SEEN}", str(story)], check=True, capture_output=True, text=True
    )
    return json.loads(ran.stderr.splitlines()[-1])


@pytest.mark.parametrize(
    "code",
    [
        pytest.param(POSED, id="a key above the strips"),
        pytest.param(REACHED, id="a control"),
        pytest.param("person.pose.bones['torso'].rotation_quaternion = (0.98, 0.2, 0, 0)", id="a pose at rest"),
        pytest.param(
            "for curve in bag.fcurves:\n    if 'head' in curve.data_path:\n"
            "        for point in curve.keyframe_points: point.co.y += 0.1",
            id="keys in a strip",
        ),
        pytest.param(
            "for curve in bag.fcurves:\n    for point in curve.keyframe_points: point.co.x *= 0.6", id="keys retimed"
        ),
        pytest.param("strip.action_frame_start += 8", id="a strip that plays later"),
    ],
)
def test_what_is_animated_is_pulled_as_motion_by_hand_and_undone(project: Path, code: str) -> None:
    before, graph = seen(project / "story.blend"), (project / "graph.json").read_bytes()
    in_blender(project / "story.blend", code)
    wanted = seen(project / "story.blend")
    assert max(abs(a - b) for a, b in zip(before, wanted, strict=True)) > 0.02
    found = pulled(project)
    assert found.understood and not found.kept and not found.conflicts, found
    assert all("animated by hand" in words for words in found.understood)
    shots = [shot for shot in read_project_graph(project).shots if shot.motion_by_hand]
    assert len(shots) == len(found.understood)
    now = seen(project / "story.blend")
    assert max(abs(a - b) for a, b in zip(wanted, now, strict=True)) < 0.02
    with Studio(Settings.load(project=project)).open(project) as session:
        session.undo()
        session.render()
    assert (project / "graph.json").read_bytes() == graph
    assert seen(project / "story.blend") == before


def test_what_was_changed_on_both_sides_is_a_conflict_and_the_project_stands(project: Path) -> None:
    with Studio(Settings.load(project=project)).open(project) as session:
        shot = session.graph.cut[0]
        name = f"SC{shot.scene_id * 10:03d}_SH{shot.shot_id * 10:03d}"
    in_blender(project / "story.blend", f"scene.objects[{name!r}].data.lens = 77")
    with Studio(Settings.load(project=project)).open(project) as session:
        from storyblender.memory.edits import CameraEdit

        session.apply([CameraEdit.model_validate({"kind": "camera", "shot": name, "decision": {"lens": 24}})])
        found = session.pull(apply=False)
        assert len(found.conflicts) == 1 and not found.understood
        session.undo()
        assert session.pull(apply=False).understood, "undone, there is no conflict any more"


def test_an_older_file_that_is_saved_over_a_newer_one_is_written_anew(project: Path) -> None:
    story = project / "story.blend"
    with Studio(Settings.load(project=project)).open(project) as session:
        session.render()
        older, lens = story.read_bytes(), saved(project)["camera"][3]
        shots = [panel.name for panel in panels(session.graph)]
        edits = [{"kind": "camera", "shot": shot, "decision": {"lens": lens + 20}} for shot in shots]
        session.draw(session.apply(edits_of(edits)))
        assert abs(saved(project)["camera"][3] - lens) > 10
        story.write_bytes(older)
        session.render()
    assert abs(saved(project)["camera"][3] - lens) > 10, "what was edited since is in the file"
