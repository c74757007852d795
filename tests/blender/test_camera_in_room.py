import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.blender
pytest.importorskip("bpy")
sys.path.insert(0, str(Path(__file__).parent))

import camera_stage  # noqa: E402

from storyblender.agents.layout_artist.camera_operator import operate  # noqa: E402
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment  # noqa: E402
from storyblender.blender.measure.figures import figures  # noqa: E402
from storyblender.blender.measure.view import ViewfinderPose  # noqa: E402
from storyblender.catalog.set_plan import SetPlan  # noqa: E402
from storyblender.geometry.boxes import Box  # noqa: E402
from storyblender.memory.scene_context import SceneSize  # noqa: E402
from storyblender.memory.shot_context import CameraInstruction  # noqa: E402

HALF = camera_stage.HALF
PLAN = SetPlan(
    kit="room",
    indoor=True,
    size=SceneSize(x=HALF, x_negative=-HALF, y=HALF, y_negative=-HALF),
    walls=camera_stage.WALLS,
)
TALK = {"axis": ("anna", "tom")}


class RealFinder:
    def __init__(self, scene) -> None:
        self.scene = scene

    def look(self, requests):
        poses = [ViewfinderPose(r.pose, None, r.sensor_width, r.focus_ids, r.hidden_node_ids) for r in requests]
        return camera_stage.look(self.scene, poses)


@pytest.fixture(scope="module")
def scene():
    return camera_stage.build({"anna": (-0.6, 0, 80), "tom": (0.6, 0, -80)})


@pytest.mark.parametrize(
    "instruction",
    [
        {"kind": "two_shot", "size": "MS", "focus_on_ids": ("anna", "tom"), **TALK},
        {"kind": "ots", "size": "MS", "focus_on_ids": ("anna",), "over_id": "tom", **TALK},
        {"kind": "single", "size": "CU", "focus_on_ids": ("tom",), **TALK},
        {"kind": "action", "size": "FS", "focus_on_ids": ("anna",)},
    ],
    ids=lambda value: value["kind"],
)
def test_in_a_closed_room_the_camera_finds_its_picture(scene, instruction) -> None:
    moments = (Moment(0, figures(scene)),)
    props = {"table": Box(1.8, 1.6, 0, 1.2, 0.8, 0.75)}
    view = CameraOperatorView(1, 1, CameraInstruction(**instruction), 48, moments, PLAN, props, side=-1)
    state = operate(view, RealFinder(scene))
    assert state.score >= 9, state.residual
