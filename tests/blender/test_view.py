import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")
sys.path.insert(0, str(Path(__file__).parent))

import io  # noqa: E402

import camera_stage  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402

from storyblender.blender.measure.figures import figures  # noqa: E402
from storyblender.blender.measure.preview import preview  # noqa: E402
from storyblender.blender.measure.view import ViewfinderPose, viewfinder  # noqa: E402
from storyblender.geometry.framing import Film, frame_single  # noqa: E402
from storyblender.geometry.orbit import Orbit, camera_around, camera_looking_at  # noqa: E402
from storyblender.look.viewfinder_picture import frame_in  # noqa: E402
from storyblender.memory.shot_context import CameraPose  # noqa: E402


def pose(camera: Orbit) -> CameraPose:
    return CameraPose(pivot=camera.pivot, rotation=camera.rotation, distance=camera.distance, lens=camera.lens)


@pytest.fixture(scope="module")
def scene():
    return camera_stage.build({"anna": (-0.6, 0, 90), "tom": (0.6, 0, -90)})


def subject(seen, name):
    return next(each for each in seen.subjects if each.node_id == name)


def test_faces_are_read_from_the_rig(scene) -> None:
    anna, tom = figures(scene)
    assert (anna.node_id, tom.node_id) == ("anna", "tom")
    assert anna.forward == pytest.approx((1, 0, 0), abs=1e-5)
    assert anna.face[2] == pytest.approx(1.635, abs=0.02)
    assert anna.head == pytest.approx(0.22, abs=0.02)
    assert tom.base == pytest.approx((0.6, 0, 0))


def test_a_single_measures_as_it_was_framed(scene) -> None:
    anna = figures(scene)[0]
    camera = frame_single(Film(), anna, "MCU", 60, 2, 65)
    seen = subject(camera_stage.view(scene, pose(camera), focus_ids=["anna"]), "anna")
    assert seen.head_height == pytest.approx(0.31, rel=0.12)
    assert seen.face_angle == pytest.approx(30, abs=5)
    assert seen.face_visible > 0.9
    assert 0.2 < seen.in_frame_fraction < 1


def test_whoever_stands_before_hides_the_other(scene) -> None:
    camera = camera_looking_at((-3, 0.0, 1.5), (0.6, 0, 1.5), 50)
    tom = subject(camera_stage.view(scene, pose(camera), focus_ids=["tom"]), "tom")
    assert tom.in_frame_fraction > 0.3
    assert tom.visible_fraction < 0.5 * tom.in_frame_fraction
    assert tom.face_visible < 0.3


def test_a_wall_hides_all_until_it_is_taken_away(scene) -> None:
    camera = pose(camera_around((0, 0, 1.4), 0, 3, 6, 35))
    blocked, open_ = camera_stage.look(
        scene, [ViewfinderPose(camera), ViewfinderPose(camera, hidden=("wall_front",))], 320, 180
    )
    assert subject(blocked, "anna").visible_fraction == 0
    assert subject(open_, "anna").visible_fraction > 0.9
    assert not any(obj.hide_render for obj in scene.objects)


def test_void_shows_outside_the_walls_and_is_sky_where_the_scene_has_one(scene) -> None:
    camera = camera_around((0, 0, 1.4), 0, -3, 9, 24)
    without = camera_stage.view(scene, pose(camera), hidden=["wall_front"])
    assert without.void > 0.2 and without.sky == 0
    scene["open_sky"] = True
    with_sky = camera_stage.view(scene, pose(camera), hidden=["wall_front"])
    del scene["open_sky"]
    assert with_sky.sky == pytest.approx(without.void, abs=0.05)


def test_a_camera_in_a_table_or_below_the_floor_is_told(scene) -> None:
    assert "table" in camera_stage.view(scene, pose(camera_looking_at((1.8, 1.6, 0.5), (0, 0, 1), 35))).inside
    assert camera_stage.view(scene, pose(camera_looking_at((0, -2, -0.3), (0, 0, 1), 35))).below_floor
    good = camera_stage.view(scene, pose(camera_looking_at((0, -2.5, 1.5), (0, 0, 1.4), 35)))
    assert good.inside == () and not good.below_floor


def test_foreground_counts_what_stands_in_the_way(scene) -> None:
    over_tom = camera_stage.view(
        scene, pose(camera_looking_at((1.1, 0.25, 1.65), (-0.6, 0, 1.6), 35)), focus_ids=["anna"]
    )
    assert over_tom.foreground > 0.1


def test_two_looks_at_the_same_thing_are_equal_and_leave_no_trace(scene) -> None:
    counts = [len(block) for block in (bpy.data.cameras, bpy.data.images, bpy.data.objects, bpy.data.meshes)]
    engine, color = scene.render.engine, tuple(scene.objects["table"].color)
    camera = pose(camera_around((0, 0, 1.4), 20, 3, 3, 35))
    first, second = camera_stage.look(scene, [ViewfinderPose(camera), ViewfinderPose(camera)])
    assert first == second
    assert [len(block) for block in (bpy.data.cameras, bpy.data.images, bpy.data.objects, bpy.data.meshes)] == counts
    assert (scene.render.engine, tuple(scene.objects["table"].color)) == (engine, color)


def test_a_hidden_person_is_out_of_the_picture_even_where_visibility_is_keyed() -> None:
    scene = camera_stage.build({"anna": (0, 0, 0), "tom": (0, 1.0, 0)})
    parts = [obj for obj in scene.objects if obj.get("node_id") == "anna" and obj.type == "MESH"]
    for part in parts:
        part.keyframe_insert("hide_render", frame=1)
    camera = pose(camera_looking_at((0, -2.5, 1.5), (0, 0, 1.5), 50))
    shown, hidden = camera_stage.look(
        scene, [ViewfinderPose(camera, 1), ViewfinderPose(camera, 1, hidden=("anna",))], 320, 180
    )
    assert subject(shown, "tom").visible_fraction < 0.4
    assert subject(hidden, "tom").visible_fraction > 0.5
    assert not any(part.hide_render or part.animation_data.action.fcurves[0].mute for part in parts)


def test_a_preview_outlines_the_focus_where_the_look_sees_it_and_leaves_no_trace(scene) -> None:
    camera = pose(camera_looking_at((-0.2, -2.8, 1.4), (-0.2, 0, 1.4), 50))
    wanted = ViewfinderPose(camera, focus_ids=("anna",), hidden=("wall_front",))
    counts = [len(block) for block in (bpy.data.cameras, bpy.data.images, bpy.data.objects, bpy.data.meshes)]
    with viewfinder(scene) as see:
        before, png, after = see(wanted), preview(see, wanted, 16 / 9), see(wanted)
    assert before == after, "a picture changes no look"
    assert [len(block) for block in (bpy.data.cameras, bpy.data.images, bpy.data.objects, bpy.data.meshes)] == counts
    picture = np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)
    rows, columns = np.nonzero((picture[..., 0] > 200) & (picture[..., 1:].max(-1) < 60))
    left, top, right, bottom = frame_in(picture.shape[1], picture.shape[0])
    box = subject(before, "anna").box
    assert (columns.min() - left) / (right - left) == pytest.approx(box[0], abs=0.02)
    assert (columns.max() - left) / (right - left) == pytest.approx(box[2], abs=0.02)
    assert (rows.min() - top) / (bottom - top) == pytest.approx(box[1], abs=0.03)
