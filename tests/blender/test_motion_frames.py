import contextlib
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")
sys.path.insert(0, str(Path(__file__).parent))

import render_stage  # noqa: E402

from storyblender.blender.render import flat_frames, glow, motion_frames  # noqa: E402
from storyblender.blender.render.complexion import told_in_shades  # noqa: E402
from storyblender.blender.render.detail import in_detail_seen  # noqa: E402
from storyblender.blender.render.flat_frames import animatic_workbench, draw_flat  # noqa: E402
from storyblender.blender.render.movement import watch  # noqa: E402
from storyblender.blender.render.session import RenderSession, evenly  # noqa: E402

FRAMES = range(1, 8, 2)
SIZE = (160, 90)


@pytest.fixture
def room():
    """The stage with the lamp rolling a metre to the right."""
    scene = render_stage.build_stage()
    lamp = (
        scene.objects["lamp"] if "lamp" in scene.objects else next(o for o in scene.objects if o["node_id"] == "lamp")
    )
    lamp.keyframe_insert("location", frame=1)
    lamp.location.x += 1.0
    lamp.keyframe_insert("location", frame=7)
    return scene


def drawn(scene, **changes):
    with RenderSession(scene, scene.camera, FRAMES[0]) as session:
        movement = replace(watch(session, FRAMES, *SIZE), **changes)
        with animatic_workbench(session, movement) as told:
            return movement, list(draw_flat(session, FRAMES, movement, told))


def test_what_moves_and_where_is_seen_before_it_is_drawn(room):
    behind = render_stage._add(room, "behind", render_stage._box((0, -30, 1), (1, 1, 1)), (1, 1, 1), "prop")
    with RenderSession(room, room.camera, FRAMES[0]) as session:
        movement = watch(session, FRAMES, *SIZE)
    assert [obj["node_id"] for obj in movement.movers] == ["lamp"]
    assert behind in movement.unseen and movement.movers[0] not in movement.unseen
    assert movement.is_locked_off and len(movement.views) == len(movement.people) == len(FRAMES)
    top, left, bottom, right = (getattr(movement.window, side) for side in ("top", "left", "bottom", "right"))
    assert 0 < top < bottom < 90 and 0 < left < right <= 160
    assert (bottom - top) * (right - left) < 0.4 * 160 * 90
    assert not any(edge % 2 for edge in (top, left, bottom, right))


def test_only_what_moves_is_drawn_anew_and_the_pictures_are_the_same(room, monkeypatch):
    movement, quick = drawn(room)
    monkeypatch.setattr(type(movement), "is_locked_off", property(lambda self: False))
    _, slow = drawn(room)
    for a, b in zip(quick, slow, strict=True):
        assert (np.abs(a.depth - b.depth) <= 0.005 * b.depth).all()
        assert (np.abs(a.albedo - b.albedo) <= 0.04 * (b.albedo + 0.1)).all()
        assert np.abs(a.glow - b.glow).max() < 1e-3
    elsewhere = np.ones((SIZE[1], SIZE[0]), bool)
    elsewhere[movement.window.cut] = False
    assert quick[1].changed.any() and not quick[1].changed[elsewhere].any() and slow[1].changed.all()


def test_what_glows_evenly_is_told_by_the_picture_as_if_it_were_drawn_for_itself(room, monkeypatch):
    _, told = drawn(room)
    nothing = glow.Told((), np.zeros((0, 3), np.float32), np.zeros((0, 3), np.float32))
    monkeypatch.setattr(flat_frames, "told_by_number", lambda: contextlib.nullcontext(nothing))
    _, apart = drawn(room)
    assert told[0].glow.max() > 2
    for a, b in zip(told, apart, strict=True):
        assert np.abs(a.glow - b.glow).max() < 1e-3 and np.abs(a.albedo - b.albedo).max() < 1e-2


def test_a_camera_that_moves_draws_everything(room):
    room.camera.keyframe_insert("location", frame=1)
    room.camera.location.x += 0.4
    room.camera.keyframe_insert("location", frame=7)
    movement, frames = drawn(room)
    assert not movement.is_locked_off
    assert all(flat.changed.all() for flat in frames)
    assert np.abs(frames[0].depth - frames[-1].depth).max() > 0.1


def test_film_of_a_window_is_the_film_of_the_whole_picture(room, monkeypatch, tmp_path):
    def film(name):
        (tmp_path / name).mkdir()
        paths = motion_frames.render_motion(room, room.camera, FRAMES, *SIZE, tmp_path / name, render_stage.interior())
        return np.array([np.asarray(Image.open(path)).astype(int) for path in paths])

    quick = film("quick")
    whole = motion_frames.watch
    monkeypatch.setattr(
        motion_frames,
        "watch",
        lambda *args: replace(found := whole(*args), window=found.views[0].whole),
    )
    assert np.abs(quick - film("whole")).mean() < 0.5


@pytest.fixture
def focused(room):
    """The room through an open lens that is focused before the lamp."""
    room.camera.data.dof.use_dof = True
    room.camera.data.dof.aperture_fstop, room.camera.data.dof.focus_distance = 1.4, 2.0
    room.camera.data.lens = 85
    return room


def _film(scene, folder, frames=FRAMES):
    folder.mkdir()
    paths = motion_frames.render_motion(scene, scene.camera, frames, *SIZE, folder, render_stage.interior())
    return [np.asarray(Image.open(path), float) for path in paths]


def test_what_moves_out_of_focus_is_blurred_as_if_the_whole_frame_were(focused, tmp_path, monkeypatch):
    quick = _film(focused, tmp_path / "parts")
    assert focused.camera.data.dof.use_dof
    monkeypatch.setattr(motion_frames.MovingFocus, "differs", lambda *_: True)
    for part, whole in zip(quick, _film(focused, tmp_path / "whole"), strict=True):
        assert np.abs(part - whole).max() < 12 and np.abs(part - whole).mean() < 0.1
    assert np.abs(quick[-1] - quick[0]).max() > 40
    focused.camera.data.dof.use_dof = False
    sharp = _film(focused, tmp_path / "sharp")
    detail = [np.abs(np.diff(film[-1], axis=1)).mean() for film in (sharp, quick)]
    assert detail[1] < 0.8 * detail[0]


def test_a_rack_focus_is_drawn_though_nothing_moves(focused, tmp_path):
    lamp = next(obj for obj in focused.objects if obj["node_id"] == "lamp")
    lamp.animation_data_clear()
    dof = focused.camera.data.dof
    for frame, away in ((1, 2.0), (7, 6.0)):
        dof.focus_distance = away
        focused.camera.data.keyframe_insert("dof.focus_distance", frame=frame)
    frames = _film(focused, tmp_path / "racked")
    assert all(np.abs(b - a).max() > 4 for a, b in pairwise(frames))


def test_a_moving_point_of_view_is_seen_through_its_opening(room, tmp_path):
    corners = []
    for through in (None, "keyhole"):
        (folder := tmp_path / f"seen {through}").mkdir()
        (path,) = motion_frames.render_motion(
            room, room.camera, range(1, 2), *SIZE, folder, render_stage.interior(), through=through
        )
        picture = np.asarray(Image.open(path).convert("L"), float)
        corners.append(picture[:8, :8].mean())
        assert picture.max() > 40
    assert corners[1] < 20 < corners[0]


def test_skin_is_told_in_shades_and_given_back(room):
    skull = next(obj for obj in room.objects if obj.name.startswith("ana_skin"))
    mesh, colors = skull.data, skull.data.color_attributes[0]
    values = np.tile(np.array([0.75, 0.5, 0.4, 1.0], np.float32), (len(mesh.vertices), 1))
    values[:40, :3] = (0.3, 0.05, 0.05)
    colors.data.foreach_set("color", values.ravel())
    materials, count = list(mesh.materials), len(bpy.data.materials)
    with told_in_shades(skull):
        shades = {tuple(round(value, 2) for value in slot.diffuse_color[:3]) for slot in mesh.materials}
        assert {(0.75, 0.5, 0.4), (0.3, 0.05, 0.05)} <= shades
        face = mesh.polygons[0]
        own = np.mean([values[vertex, :3] for vertex in face.vertices], axis=0)
        assert mesh.materials[face.material_index].diffuse_color[:3] == pytest.approx(own, abs=0.03)
    assert list(mesh.materials) == materials and len(bpy.data.materials) == count
    assert {face.material_index for face in mesh.polygons} == {0}


def test_a_frame_in_which_nothing_moves_is_the_last_one_held(room):
    lamp = next(obj for obj in room.objects if obj["node_id"] == "lamp")
    lamp.keyframe_insert("location", frame=3)
    curves = lamp.animation_data.action.layers[0].strips[0].channelbag(lamp.animation_data.action_slot).fcurves
    for curve in curves:  # it stands until frame 3, then rolls evenly
        for key, value in zip(curve.keyframe_points, (0.0, 0.0, 1.0), strict=True):
            key.co[1] = value if curve.array_index == 0 else key.co[1]
            key.interpolation = "LINEAR"
        curve.update()
    movement, frames = drawn(room)
    assert movement.anew == (True, False, True, True)
    assert frames[1] is frames[0] and frames[2] is not frames[1]


def test_numbers_go_in_the_fewest_even_runs():
    assert [list(run) for run in evenly([1, 3, 5, 11, 12, 13, 40])] == [[1, 3, 5], [11, 12, 13], [40]]
    assert evenly([]) == [] and [list(run) for run in evenly([7])] == [[7]]


def test_small_figures_are_drawn_with_fewer_faces_and_keep_their_play(room):
    skin = _figure(room)
    whole, points = skin.data, len(skin.data.vertices)
    with RenderSession(room, room.camera, FRAMES[0]) as session:
        with in_detail_seen(session, FRAMES, 80, 44):
            small = skin.data
            assert small is not whole and len(small.vertices) < 0.6 * points
            assert [block.name for block in small.shape_keys.key_blocks] == ["Basis", "open"]
            basis, opened = (np.array([point.co[:] for point in block.data]) for block in small.shape_keys.key_blocks)
            assert (opened - basis)[:, 1].max() == pytest.approx(0.01) and (opened - basis)[:, 1].min() == 0
            values = []
            for number in (1, 7):
                session.go_to(number)
                values.append(small.shape_keys.key_blocks["open"].value)
            assert values == pytest.approx([0.0, 1.0])
        assert skin.data is whole
        with in_detail_seen(session, FRAMES, 8000, 4500):
            assert skin.data is whole
        with in_detail_seen(session, FRAMES, 80, 44):
            assert skin.data is small
        skin.parent.location = room.camera.location
        with in_detail_seen(session, FRAMES, 80, 44):
            assert skin.data is whole


def _figure(room):
    """Somebody with a rig, a fine skin, and a mouth that opens by frame 7."""
    import bmesh

    mesh = bpy.data.meshes.new("bo_skin")
    ball = bmesh.new()
    bmesh.ops.create_uvsphere(ball, u_segments=32, v_segments=24, radius=0.12)
    ball.to_mesh(mesh)
    ball.free()
    skin = bpy.data.objects.new("bo_skin", mesh)
    rig = bpy.data.objects.new("bo_rig", bpy.data.armatures.new("bo_rig"))
    for obj in (skin, rig):
        obj["node_id"], obj["kind"] = "bo", "character"
        room.collection.objects.link(obj)
    skin.parent, rig.location = rig, (0, 1, 1.6)
    skin.modifiers.new("rig", "ARMATURE").object = rig
    skin.shape_key_add(name="Basis")
    opened = skin.shape_key_add(name="open", from_mix=False)
    for point in opened.data:
        point.co.y += 0.01 if point.co.z < -0.05 else 0.0
    for value, frame in ((0.0, 1), (1.0, 7)):
        opened.value = value
        opened.keyframe_insert("value", frame=frame)
    room.view_layers[0].update()
    return skin
