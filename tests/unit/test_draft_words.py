"""What a role proposes and how a fault is mended, told in few words with units."""

from storyblender.draft_words import draft_in_words, fix_in_words
from storyblender.memory.asset_sheet import AssetDimension
from storyblender.memory.scene_context import Environment, Layout, LayoutObject, SceneSize


def test_a_fix_says_which_way_how_far_and_what_else_is_tried() -> None:
    assert fix_in_words({"azimuth": -9.329750213}) == "9.33 degrees around to the left"
    assert fix_in_words({"move_x": 0.25, "move_y": -1.0, "move_z": 0.0}) == "0.25 m to the right, 1 m to the front"
    assert fix_in_words({"ops": "orbit_left zoom_in"}) == "orbit left or zoom in"
    assert fix_in_words({"dolly": -2.0, "ops": "zoom_out"}) == "2 steps farther, or zoom out"


def test_a_draft_is_told_by_what_is_not_as_usual() -> None:
    assert draft_in_words("plain") == "plain" and draft_in_words(7) == "7"
    told = draft_in_words(Environment(kit="cafe", params={"width": 10.2000001, "depth": 10.0}, seed=5))
    assert told.startswith("kit cafe; params: width 10.2 m, depth 10 m") and "None" not in told and "{" not in told
    assert draft_in_words({"bar": AssetDimension(width=3.0)}) == "bar: width 3 m"


def test_a_long_draft_is_counted_and_has_no_types_in_it() -> None:
    size = SceneSize(x=4, x_negative=-4, y=4, y_negative=-4)
    things = tuple(LayoutObject(node_id=f"chair_{n}", asset_id="chair", location=(n, 0, 0)) for n in range(30))
    told = draft_in_words(Layout(scene_size=size, objects=things))
    assert "30 objects" in told and len(told) < 200 and "(" not in told
