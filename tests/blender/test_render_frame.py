import contextlib
import math
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")
sys.path.insert(0, str(Path(__file__).parent))

import render_stage  # noqa: E402

from storyblender.blender.render.frame import FrameRequest, render_frame  # noqa: E402
from storyblender.blender.render.motion_frames import render_motion  # noqa: E402
from storyblender.errors import InputError  # noqa: E402

GOLDEN = Path(__file__).parents[1] / "golden"
SIZE = {"width": 320, "height": 176}


@pytest.fixture(scope="module")
def room():
    return render_stage.build_stage()


@pytest.fixture(scope="module")
def yard():
    return render_stage.build_stage(walls=False)


def frame(scene, lighting, look="fast", **fields):
    return render_frame(scene, scene.camera, lighting, render_stage.heads(), FrameRequest(look=look, **(SIZE | fields)))


@pytest.mark.parametrize("look", ["fast", "pencil", "board"])
@pytest.mark.parametrize("place", ["room", "yard"])
def test_pictures_stay_as_they_were(place, look, request):
    """Means of 8 x 8 blocks against the kept picture: small drifts of drivers pass, a lost light or line does not."""
    lighting = render_stage.interior() if place == "room" else render_stage.exterior()
    result = frame(request.getfixturevalue(place), lighting, look)
    path = GOLDEN / f"{place}_{look}.png"
    kept = np.asarray(Image.open(path)).astype(float)
    difference = np.abs(_blocks(result.image) - _blocks(kept))
    assert difference.mean() < 2.5
    assert np.percentile(difference, 99) < 24


@contextlib.contextmanager
def focused(scene, away):
    """Open the lens of the scene's camera and focus it at some metres."""
    data = scene.camera.data
    before = data.dof.use_dof, data.dof.aperture_fstop, data.dof.focus_distance
    data.dof.use_dof, data.dof.aperture_fstop, data.dof.focus_distance = True, 0.7, away
    yield
    data.dof.use_dof, data.dof.aperture_fstop, data.dof.focus_distance = before


def test_a_picture_with_a_depth_of_field_stays_as_it_was(room):
    with focused(room, 2.5):
        image = frame(room, render_stage.interior(), "fast").image
    kept = np.asarray(Image.open(GOLDEN / "room_focused.png")).astype(float)
    difference = np.abs(_blocks(image) - _blocks(kept))
    assert difference.mean() < 2.5 and np.percentile(difference, 99) < 24


@pytest.mark.parametrize("look", ["fast", "pencil", "board", "render"])
def test_every_look_blurs_what_is_out_of_focus_and_leaves_faces_as_exposed(room, look):
    sharp = frame(room, render_stage.interior(), look)
    with focused(room, 0.6):
        blurred = frame(room, render_stage.interior(), look)
        assert room.camera.data.dof.use_dof
    detail = [np.abs(np.diff(each.image.astype(float), axis=1)).mean() for each in (sharp, blurred)]
    assert detail[1] < 0.95 * detail[0]
    assert blurred.statistics.face_luminance == pytest.approx(sharp.statistics.face_luminance, rel=0.02)
    assert blurred.statistics.visible == sharp.statistics.visible


def _blocks(image):
    return np.asarray(image, float).reshape(22, 8, 40, 8, 3).mean((1, 3))


@pytest.mark.parametrize("look", ["fast", "board"])
def test_the_same_request_gives_the_same_pixels(room, look):
    first, second = (frame(room, render_stage.interior(), look, width=96, height=56, seed=5) for _ in range(2))
    assert (first.image == second.image).all()
    assert first.lights == second.lights


def test_faces_reach_their_target_or_a_little_more(room, yard):
    for scene, lighting in ((room, render_stage.interior()), (yard, render_stage.exterior())):
        statistics = frame(scene, lighting).statistics
        assert statistics.face_luminance is not None
        assert 0.8 * lighting.face_luminance < statistics.face_luminance < 2.5 * lighting.face_luminance


def test_each_person_in_frame_gets_three_lamps(room):
    lights = frame(room, render_stage.interior()).lights
    assert [(light.for_asset, light.role) for light in lights] == [
        (name, role) for name in ("ana", "ben") for role in ("key", "fill", "rim")
    ]


def test_an_insert_of_a_hand_gets_the_lamps_of_the_face():
    scene = render_stage.build_stage()
    render_stage.add_hand(scene, "ana", (-0.6, -0.5, 0.9))
    scene.camera.location, scene.camera.rotation_euler = (-0.6, -2.0, 0.9), (math.radians(90), 0, 0)
    scene.camera.data.lens = 85
    scene.view_layers[0].update()
    by_role = {light.role: light for light in frame(scene, render_stage.interior()).lights if light.for_asset == "ana"}
    assert by_role["key"].target == pytest.approx((-0.6, -0.5, 0.9), abs=0.08)
    away = np.linalg.norm(np.subtract(by_role["key"].location, by_role["key"].target))
    assert away == pytest.approx(2.3, abs=0.05), "as far as from a face"


def test_quick_and_traced_light_agree(yard):
    fast, board = (frame(yard, render_stage.exterior(), look).image.astype(float) for look in ("fast", "board"))
    assert abs(fast.mean() - board.mean()) < 14


def test_the_sun_casts_shadows(yard):
    with_sun = frame(yard, render_stage.exterior()).image.astype(float)
    lighting = render_stage.exterior()
    from_the_other_side = lighting.lights[0].model_copy(update={"location": (5.0, -4.0, 8.0)})
    other = frame(yard, lighting.model_copy(update={"lights": (from_the_other_side,)})).image.astype(float)
    ground = np.abs(with_sun - other)[70:].max(axis=2)
    assert (ground > 20).mean() > 0.02


def test_void_and_visible_nodes_are_reported(room, yard):
    assert frame(room, render_stage.interior()).statistics.void < 0.1
    statistics = frame(yard, render_stage.exterior(), hidden_node_ids=("table",)).statistics
    assert statistics.void > 0.5
    assert {"ana", "ben", "floor"} <= set(statistics.visible)
    assert "table" not in statistics.visible


def test_render_look_draws_no_lines(room):
    plain = frame(room, render_stage.interior(), "render", width=96, height=56, samples=4)
    assert plain.image.shape == (56, 96, 3)
    assert plain.image.std() > 10


def test_odd_requests_are_refused_in_a_sentence(room):
    with pytest.raises(InputError, match="no look 'oil'"):
        frame(room, render_stage.interior(), "oil")
    with pytest.raises(InputError, match="cannot be divided"):
        frame(room, render_stage.interior(), width=161)


def test_moving_frames_are_lit_like_the_board_and_do_not_flicker(room, tmp_path):
    lamp = next(obj for obj in room.objects if obj.get("node_id") == "lamp")
    lamp.keyframe_insert("location", frame=1)
    lamp.location.x += 1.0
    lamp.keyframe_insert("location", frame=5)
    paths = render_motion(room, room.camera, range(1, 6, 2), 160, 90, tmp_path, render_stage.interior())
    assert [path.name for path in paths] == ["00001.jpg", "00003.jpg", "00005.jpg"]
    pictures = [np.asarray(Image.open(path)).astype(float) for path in paths]
    still = frame(room, render_stage.interior(), frame=1).image.astype(float)
    assert abs(pictures[0].mean() - still.mean()) < 25
    assert np.abs(pictures[0] - pictures[2]).max() > 60, "the ball has moved"
    assert np.abs(pictures[0] - pictures[2])[:, :20].max() < 4, "the wall beside it has not changed"
    again = render_motion(room, room.camera, range(1, 6, 2), 160, 90, tmp_path, render_stage.interior())
    assert [np.asarray(Image.open(path)).tolist() for path in again] == [p.tolist() for p in pictures]
    lamp.animation_data_clear()
