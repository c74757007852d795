import json
import sys
from pathlib import Path

import pytest
from pydantic_core import to_jsonable_python

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")
sys.path.insert(0, str(Path(__file__).parent))

import camera_stage  # noqa: E402

from storyblender.blender.session import BlenderSession  # noqa: E402
from storyblender.blender.windows import set_daylight_material  # noqa: E402
from storyblender.geometry.orbit import camera_looking_at  # noqa: E402
from storyblender.memory.graph import ProjectFormat  # noqa: E402
from storyblender.memory.jobs import FrameJob, MotionJob, PackRef  # noqa: E402
from storyblender.memory.measure import ViewRequest  # noqa: E402
from storyblender.memory.request import Picture  # noqa: E402
from storyblender.memory.scene_context import Lighting, Sky  # noqa: E402
from storyblender.memory.shot_context import CameraInstruction, CameraPose, CameraState, ShotContext  # noqa: E402

PACK = PackRef(scene_id=1, path="pack.blend", starts=((1, 1), (2, 11)))


@pytest.fixture
def session(tmp_path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = camera_stage.build({"anna": (0, 0, 0)})
    scene.name = "SC010"
    wall = scene.objects["wall_back"]
    for frame, hidden in ((1, False), (10, True)):
        wall.hide_render = hidden
        wall.keyframe_insert("hide_render", frame=frame)
    bpy.context.window.scene = scene
    scene.frame_set(1)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / PACK.path))
    return BlenderSession(tmp_path)


def request(shot_id: int, x: float = 0.0) -> ViewRequest:
    camera = camera_looking_at((x, -2.5, 1.5), (0, 0, 1.5), 35)
    pose = CameraPose(pivot=camera.pivot, rotation=camera.rotation, distance=camera.distance, lens=35)
    return ViewRequest(scene_id=1, shot_id=shot_id, frame=0, pose=pose, focus_ids=("anna",))


def test_looks_one_by_one_see_what_looks_together_see(session, tmp_path):
    wanted = [request(1), request(1, 0.5), request(2)]
    together = session.look(PACK, wanted, 16 / 9)
    assert together[2].void > together[0].void, "the wall is gone in the second shot"
    assert [session.look(PACK, [each], 16 / 9)[0] for each in wanted] == together
    session.read_figures(PACK, [1])  # puts the viewfinder away, as the file is opened anew
    other = BlenderSession(tmp_path)
    assert [view.subjects for view in other.look(PACK, wanted[1:2], 16 / 9)] == [together[1].subjects]
    other.read_figures(PACK, [1])


def test_previews_are_known_by_what_they_show(session):
    one, other, again = session.preview(PACK, [request(1), request(1, 0.5), request(1)], 16 / 9)
    assert one == again
    assert one.drawn_from != other.drawn_from and one.png != other.png
    assert Picture.model_validate(json.loads(json.dumps(to_jsonable_python(one)))) == one, "it goes over the wire"
    session.read_figures(PACK, [1])


def test_the_viewfinder_is_put_away_for_other_jobs(session):
    session.look(PACK, [request(1)], 16 / 9)
    scene = bpy.data.scenes["SC010"]
    assert bpy.context.window.scene.name == "still", "it is held for the next look"
    assert len(session.read_figures(PACK, [1])[0]) == 1
    assert "still" not in bpy.data.scenes and bpy.context.window.scene == scene
    assert not bpy.data.cameras


def test_what_is_drawn_has_the_windows_of_its_hour(session, monkeypatch):
    """A pack knows no hour: it is built with lit windows, and each picture switches them by its own sky."""
    scene = session._open_pack(PACK)
    block = bpy.data.materials.new("window")
    block.use_nodes = True
    set_daylight_material(block, scene, ((0.1, 0.1, 0.1), 0.0), ((1.0, 0.8, 0.5), 0.7))
    seen = []

    def drawn(*_args, **_kwargs):
        seen.append(round(block["emit"], 3))
        raise StopIteration

    monkeypatch.setattr("storyblender.blender.session.render_frame", drawn)
    monkeypatch.setattr("storyblender.blender.session.render_motion", drawn)
    shot = ShotContext(
        scene_id=1, shot_id=1, duration=24, camera_instruction=CameraInstruction(size="MS"),
        camera=CameraState(poses=(CameraPose(pivot=(0, 0, 1.5), rotation=(1, 0, 0, 0), distance=2.5, lens=35),)),
    )  # fmt: skip
    for light in (1.0, 0.0):
        plan = Lighting(sky=Sky(zenith=(light,) * 3, horizon=(light,) * 3, ground=(light,) * 3))
        job = {"pack": PACK, "shot": shot, "lighting": plan, "format": ProjectFormat()}
        with pytest.raises(StopIteration):
            session.render_frame(FrameJob(**job, look="fast", frame=0, out="a.png"))
        with pytest.raises(StopIteration):
            session.render_motion(MotionJob(**job, width=160, step=1, folder="moving"))
    assert seen == [0.0, 0.0, 0.7, 0.7]
