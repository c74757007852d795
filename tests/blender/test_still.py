import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")
sys.path.insert(0, str(Path(__file__).parent))

import render_stage  # noqa: E402

from storyblender.blender.still import held_still  # noqa: E402


@pytest.fixture(scope="module")
def scene():
    """The stage, with a table that slides and a wall that is gone from frame 10 on."""
    stage = render_stage.build_stage()
    table, wall = stage.objects["table"], stage.objects["wall_left"]
    for frame, x in ((1, 0.0), (11, 1.0)):
        table.location.x = x
        table.keyframe_insert("location", frame=frame)
    for frame, hidden in ((1, False), (10, True)):
        wall.hide_render = hidden
        wall.keyframe_insert("hide_render", frame=frame)
    table.modifiers.new("bend", "BEVEL")
    return stage


def names(still):
    return {str(obj["node_id"]) for obj in still.objects}


def test_what_moves_stands_where_it_stood_at_the_frame(scene):
    with held_still(scene, 1) as still:
        table = next(obj for obj in still.objects if obj["node_id"] == "table")
        first = table.matrix_world.translation.x
        assert table.animation_data is None and not table.modifiers
    with held_still(scene, 11) as still:
        table = next(obj for obj in still.objects if obj["node_id"] == "table")
        assert table.matrix_world.translation.x - first == pytest.approx(1.0)
        assert len(table.data.vertices) > 8, "the bevel is in the mesh"
        assert still.frame_current == 11


def test_what_is_hidden_then_is_left_out_and_the_rest_is_shared(scene):
    with held_still(scene, 1) as still:
        assert "wall_left" in names(still)
        assert scene.objects["floor"].name in still.objects, "what never moves is the same object"
    with held_still(scene, 12) as still:
        assert "wall_left" not in names(still)


def test_nothing_stays_behind(scene):
    before = len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.scenes)
    with pytest.raises(RuntimeError, match="in the middle"), held_still(scene, 5):
        raise RuntimeError("in the middle")
    assert (len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.scenes)) == before
    assert bpy.context.window.scene == scene
