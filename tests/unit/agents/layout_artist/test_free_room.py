"""What a planner is told of the room: how much is needed, how much there is, and where it fits."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
from tests.unit.agents.layout_artist.test_language_spatial_planner import MEASURES, VIEW

from storyblender.agents.layout_artist.free_room import _SIDES, room_told
from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.geometry.boxes import Box, penetration
from storyblender.memory.scene_context import LayoutObject

_BESIDE = re.compile(r"(left_of|right_of|in_front_of|behind) ([\d.]+) m (?:up to (\w+[\w ]*)|and more)")
_FITS = re.compile(r"([\d.]+) m (left_of|right_of|in_front_of|behind) (\w+)")


def stage_with(*others: tuple[str, float, float]) -> LayoutStage:
    """Return a stage with a wardrobe in the middle and tables at floor points."""
    tables = (LayoutObject(node_id=name, asset_id="table", location=(x, y, 0.0)) for name, x, y in others)
    return LayoutStage(replace(VIEW, dressed=(*VIEW.dressed, *tables)))


@pytest.mark.parametrize("gap", [0.2, 0.9, 1.6])
def test_the_depth_beside_a_thing_is_the_gap_to_what_stands_next(gap: float) -> None:
    stage = stage_with(("table_1", 0.6 + gap + 0.7, 0.3))
    told = room_told(stage, "crate", stage.things["wardrobe_1"], "right_of")
    assert told.startswith("crate needs 0.8 x 0.6 m of floor; free at wardrobe_1: ")
    free = {side: (float(metres), blocker) for side, metres, blocker in _BESIDE.findall(told.split("; it fits")[0])}
    assert free.keys() == _SIDES.keys()
    assert free["right_of"] == (pytest.approx(gap, abs=0.11), "table_1")


def test_where_it_is_said_to_fit_it_fits() -> None:
    stage = stage_with(("table_1", 1.6, 0.3), ("table_2", -1.5, 0.3))
    told = room_told(stage, "crate", stage.things["wardrobe_1"], "right_of").split("it fits ")[1]
    places = _FITS.findall(told)
    assert places and len({name for _, _, name in places}) == len(places), "each by another neighbour"
    for metres, side, name in places:
        box, (dx, dy) = stage.things[name].box, _SIDES[side]
        away = box.reach((float(dx), float(dy))) + float(metres) + (0.4 if dx else 0.3)
        others = [each.box for each in stage.things.values() if each.name != name]
        tried = [
            Box(box.x + dx * away + dy * slide, box.y + dy * away + dx * slide, 0.05, 0.8, 0.6, 1.0)
            for slide in (0.25 * step for step in range(-8, 9))
        ]
        assert any(all(penetration(each, other)[0] < 0.1 for other in others) for each in tried), (metres, side, name)


def test_where_the_floor_is_full_it_is_said() -> None:
    stage = stage_with()
    huge = MEASURES["crate"].model_copy(update={"dimensions": (40.0, 40.0, 1.0)})
    stage.view = replace(VIEW, measures={**MEASURES, "crate": huge})
    assert "it fits nowhere else on the floor" in room_told(stage, "crate", stage.things["wardrobe_1"], "behind")


def test_what_lies_on_a_table_is_said() -> None:
    stage = stage_with(("table_1", 1.6, 0.3))
    vase = LayoutObject(
        node_id="vase", asset_id="vase", location=(1.6, 0.3, 0.75), anchor_asset_id="table_1",
        relationship="on_top_of",
    )  # fmt: skip
    stage.add_object(vase, fixed=True)
    told = room_told(stage, "crate", stage.things["table_1"], "on")
    assert told == "crate needs 0.8 x 0.6 m; the top of table_1 is 1.4 x 0.8 m, with vase on it"
    assert "crate is 0.8 x 0.6 x 0.9 m, table_1 is 1.4 x 0.8 x 0.8 m" in room_told(
        stage, "crate", stage.things["table_1"], "under"
    )
