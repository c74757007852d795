import numpy as np
import pytest

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")

from storyblender.blender.cameras import make_camera  # noqa: E402
from storyblender.blender.render.session import RenderSession  # noqa: E402
from storyblender.memory.shot_context import (  # noqa: E402
    CameraInstruction,
    CameraPose,
    CameraState,
    FocusKey,
    ShotContext,
)

LEVEL = (float(np.sqrt(0.5)), float(np.sqrt(0.5)), 0.0, 0.0)


def pushing_in() -> ShotContext:
    poses = tuple(
        CameraPose(frame=frame, pivot=(0, 0, 1.5), rotation=LEVEL, distance=distance, lens=50)
        for frame, distance in ((0, 4.0), (40, 2.0))
    )
    return ShotContext(
        scene_id=1, shot_id=1, camera_instruction=CameraInstruction(), camera=CameraState(poses=poses), duration=41
    )


@pytest.mark.parametrize(("frame", "distance"), [(101, 4.0), (121, 2.83), (141, 2.0)])
def test_a_camera_that_moves_is_seen_through_where_it_stands_now(frame, distance):
    scene = bpy.data.scenes.new("moves")
    bpy.context.window.scene = scene
    scene.frame_set(frame)
    camera = make_camera(scene, scene.collection, pushing_in(), 101)
    with RenderSession(scene, camera) as session:
        eye = session.view(64, 36).eye
        scene.frame_set(frame + 1)
        scene.frame_set(frame)
        assert eye == pytest.approx(session.view(64, 36).eye, abs=1e-3), "as the render sees it"
    assert eye[1] == pytest.approx(-distance, abs=0.01)


def test_the_camera_of_the_file_has_the_focus_of_the_shot():
    keys = (FocusKey(frame=0, point=(0, 0, 1.5), node_id="ana"), FocusKey(frame=40, point=(0, 2, 1.5), node_id="ben"))
    shot = pushing_in()
    assert shot.camera is not None
    still = shot.camera.model_copy(update={"poses": shot.camera.poses[:1], "focus": keys, "f_number": 2.0})
    scene = bpy.data.scenes.new("focused")
    for state, depths in ((still, (4.0, 6.0)), (shot.camera.model_copy(update={"focus": keys}), (4.0, 4.0))):
        camera = make_camera(scene, scene.collection, shot.model_copy(update={"camera": state}), 101)
        assert camera.data.dof.use_dof and camera.data.dof.aperture_fstop == pytest.approx(state.f_number)
        with RenderSession(scene, camera) as session:
            for frame, depth in zip((101, 141), depths, strict=True):
                session.go_to(frame)
                lens = session.lens()
                assert lens is not None and lens.focus == pytest.approx(depth, abs=0.01)
        assert camera.data.dof.use_dof
    sharp = make_camera(scene, scene.collection, shot, 101)
    with RenderSession(scene, sharp) as session:
        assert session.lens() is None and not sharp.data.dof.use_dof
