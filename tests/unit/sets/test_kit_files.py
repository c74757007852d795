"""Kit files: what they may say, what they draw, and the sentence that a damaged one gets."""

from __future__ import annotations

import math
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.every import every

from storyblender.agents.visual_effects_artist.furniture import prop_size
from storyblender.catalog.footprints import piece_boxes
from storyblender.catalog.props import PROPS
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import SETS, plan_of
from storyblender.catalog.sets.drawing import SetParams
from storyblender.catalog.sets.from_file import kits_from_files, read_kit
from storyblender.catalog.sets.kit import SetKit
from storyblender.catalog.sets.terms import value_of
from storyblender.errors import InputError
from storyblender.geometry.boxes import Box, penetration
from storyblender.memory.scene_context import Environment

HEAD = """name = "Boat house"
description = "Boats along the back wall."
tags = ["boat house"]
indoor = true
width = [6, 7, 10]
depth = [6, 7, 10]
options = { wet = ["flood"] }
"""
SHELL = '[shell]\nwall = "boards_grey"\nfloor = "planks_gray"\n[shell.modern]\nwall = "plaster_grey"\n'
FILES = [kit.key for kit in kits_from_files()]


def kit_with(tmp_path: Path, tables: str = SHELL, head: str = HEAD) -> SetKit:
    file = tmp_path / "boat_house.toml"
    file.write_text(head + tables, encoding="utf-8")
    return read_kit(file)


def put(things: str) -> str:
    return f"[plan]\nput = [{things}]\n"


def plan_with(tmp_path: Path, tables: str, **params: object) -> SetPlan:
    sized = SetParams(**({"width": 8.0, "depth": 6.0, "options": {"wet": False}} | params))  # type: ignore[arg-type]
    return kit_with(tmp_path, SHELL + put(tables)).draw(sized, np.random.default_rng(0))


@given(x=st.floats(1, 20), y=st.floats(1, 20))
def test_a_term_is_the_sum_that_it_says(x: float, y: float) -> None:
    names = {"x": x, "y": y}
    assert value_of("-x + 0.5*(y - 1)/2", names) == pytest.approx(-x + 0.25 * (y - 1), abs=1e-3)


@pytest.mark.parametrize("term", ["q + 1", "x ** 9", "__import__('os')", "x +", "1/0", "x.real", "'x'"])
def test_a_term_is_nothing_but_a_sum(term: str) -> None:
    with pytest.raises(ValueError, match="'"):
        value_of(term, {"x": 1.0})


def test_a_row_keeps_its_distance_and_stays_in_the_middle(tmp_path: Path) -> None:
    plan = plan_with(tmp_path, '{ prop = "barrel", x = { from = "-x", to = "x", every = 3 }, y = "y - 1" }')
    places = [item.location[:2] for item in plan.furnishings]
    assert places == [(-3.0, 2.0), (0.0, 2.0), (3.0, 2.0)]


def test_what_is_on_and_by_follows_what_it_belongs_to(tmp_path: Path) -> None:
    tables = (
        '{ prop = "desk", id = "desk", x = { from = -2, to = 2, count = 2 }, yaw = 90 },'
        '{ prop = "laptop", on = "desk", y = -0.2 },'
        '{ prop = "chair", by = "desk", y = 0.8, yaw = 180 },'
    )
    plan = plan_with(tmp_path, tables)
    laptops = [item for item in plan.furnishings if item.prop == "laptop"]
    chairs = [item for item in plan.furnishings if item.prop == "chair"]
    top = PROPS["desk"].size[2]
    assert [item.location for item in laptops] == [(-1.8, 0.0, top), (2.2, 0.0, top)]
    assert [(item.location, item.yaw) for item in chairs] == [((-2.8, 0.0, 0.0), 270.0), ((1.2, 0.0, 0.0), 270.0)]


def test_a_period_changes_the_walls_and_an_option_the_furniture(tmp_path: Path) -> None:
    tables = '{ prop = "bucket", when = ["wet", "past"] }'
    classic, modern = plan_with(tmp_path, tables), plan_with(tmp_path, tables, period="modern", options={"wet": True})
    assert (classic.walls[0].material, modern.walls[0].material) == ("boards_grey", "plaster_grey")
    assert ([item.prop for item in classic.furnishings], [item.prop for item in modern.furnishings]) == ([], ["bucket"])


@pytest.mark.parametrize(
    ("tables", "head", "sentence"),
    [
        (SHELL, "name = 'Boat", "Unterminated|Expected|Illegal"),
        (SHELL, HEAD.replace('name = "Boat house"\n', ""), "name: Field required"),
        (SHELL, HEAD + "windth = 3\n", "windth: Extra inputs"),
        (SHELL + put('{ prop = "barel" }'), HEAD, "plan put 1 prop.*: there is no prop called 'barel'"),
        (SHELL + put('{ prop = "barrel", x = "-q" }'), HEAD, "plan put 1 x.*'q' is neither a number nor"),
        (SHELL + put('{ prop = "laptop", on = "desk" }'), HEAD, "put 1 is on or by 'desk'"),
        (SHELL + put("{ x = 1 }"), HEAD, "plan put 1: this needs either prop or piece"),
        (SHELL.replace("boards_grey", "gold_leaf"), HEAD, "no finish or material called 'gold_leaf'"),
        ("", HEAD, "needs .shell. where it is indoors"),
    ],
)
def test_a_damaged_file_is_told_in_one_sentence(tmp_path: Path, tables: str, head: str, sentence: str) -> None:
    with pytest.raises(InputError, match=f"^the kit file boat_house.toml cannot be used .*({sentence})") as caught:
        kit_with(tmp_path, tables, head).draw(
            SetParams(width=8.0, depth=6.0, options={"wet": False}), np.random.default_rng(0)
        )
    assert "\n" not in str(caught.value)


def test_the_examples_of_the_guide_make_a_kit(tmp_path: Path) -> None:
    guide = (Path(__file__).parents[3] / "docs" / "add-a-set.md").read_text(encoding="utf-8")
    head, indoors, outdoors, things = (block.split("```")[0] for block in guide.split("```toml\n")[1:])
    size = SetParams(width=7.0, depth=7.0, options={"wet": False})
    room = kit_with(tmp_path, indoors + things, head).draw(size, np.random.default_rng(0))
    assert [item.prop for item in room.furnishings] == ["workbench", "toolbox", "lantern"]
    open_air = kit_with(tmp_path, outdoors, head).draw(size, np.random.default_rng(0))
    assert len(open_air.backdrops) == 12 and not open_air.indoor


@every("key", FILES)
def test_a_kit_is_described_and_its_plan_is_of_its_sort(key: str) -> None:
    kit = SETS[key]
    assert kit.description.endswith(".") and len(kit.description) > 40
    assert plan_of(Environment(kit=key)).indoor == kit.indoor
    assert not kit.counterpart or SETS[kit.counterpart].indoor != kit.indoor


@every("key size period", product(FILES, ("least", "usual", "most"), ("past", "classic", "modern")))
def test_nothing_stands_in_anything_else(key: str, size: str, period: str) -> None:
    kit = SETS[key]
    params = {"width": getattr(kit.width, size), "depth": getattr(kit.depth, size), "period": period}
    plan = plan_of(Environment(kit=key, params=params, seed=3))
    standing = [box for box in _boxes(plan) if box[1].height > 0.06]
    clashes = [
        (a, b)
        for index, (a, first) in enumerate(standing)
        for b, second in standing[:index]
        if penetration(first, second, 0.03)[0] > (0.25 if "chair" in a + b or "stool" in a + b else 0.06)
    ]
    assert not clashes


def _boxes(plan: SetPlan) -> list[tuple[str, Box]]:
    props = [
        (item.node_id, Box(*item.location, *prop_size(item.prop, item.params), math.radians(item.yaw)))
        for item in plan.furnishings
        if item.prop not in ("curtain", "tuft", "bush")
    ]
    return props + [(piece.node_id, box) for piece in plan.pieces for box in piece_boxes(piece)]
