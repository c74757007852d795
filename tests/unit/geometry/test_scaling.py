"""A model keeps the size that its file gives it, unless that cannot be meant."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.geometry.scaling import UsualSize, find_scale
from storyblender.memory.asset_sheet import AssetDimension

DESK = UsualSize((1.6, 0.8, 0.76), firm=True)


def test_a_plausible_size_is_kept_and_nothing_is_said() -> None:
    desk = np.array([1.40, 0.65, 0.75])
    assert find_scale(desk, DESK) == find_scale(desk[[1, 0, 2]], DESK) == (1.0, ""), "whichever way it lies"
    assert find_scale(desk, None, AssetDimension(width=1.6)) == (1.0, "")


@pytest.mark.parametrize(("unit", "name"), [(100.0, "centimetres"), (1000.0, "millimetres"), (39.37, "inches")])
def test_another_unit_is_told_by_what_the_thing_is(unit: float, name: str) -> None:
    scale, reason = find_scale(np.array([1.4, 0.65, 0.75]) * unit, DESK)
    assert scale * unit == pytest.approx(1.0, rel=0.01) and name in reason


def test_without_a_name_only_what_cannot_be_metres_is_scaled() -> None:
    assert find_scale(np.array([3.0, 3.0, 3.0]), None) == (1.0, "")
    scale, reason = find_scale(np.array([40.0, 40.0, 90.0]), None)
    assert scale == 0.01 and "centimetres" in reason


def test_what_the_script_tells_counts() -> None:
    scale, reason = find_scale(np.array([0.2, 0.2, 0.5]), None, AssetDimension(height=1.0), certainty="told")
    assert scale == pytest.approx(2.0) and reason == "its size was given"


def test_an_estimate_chooses_the_unit_and_counts_itself_where_none_is_near() -> None:
    inches = np.array([1.4, 0.65, 0.75]) * 39.37
    scale, reason = find_scale(inches, None, AssetDimension(width=1.6), certainty="estimated")
    assert scale == 0.0254 and "inches" in reason
    scale, reason = find_scale(inches * 0.2, DESK, AssetDimension(width=1.6), certainty="estimated")
    assert scale == pytest.approx(1.6 / inches[0] / 0.2) and "picture" in reason
    assert find_scale(inches, None, AssetDimension(width=1.6), certainty="estimated", unit=0.1)[0] == 0.0254
    assert find_scale(inches, None, AssetDimension(width=1.6), certainty="estimated", unit=0.029)[0] == 0.029


def test_what_is_absurd_in_every_unit_gets_the_usual_size() -> None:
    scale, reason = find_scale(np.array([5e5, 5e5, 5e5]), None, AssetDimension(height=0.5))
    assert scale * 5e5 == pytest.approx(0.5) and "usual" in reason


@pytest.mark.parametrize("share", [0.55, 0.75, 1.3])
def test_smaller_and_larger_desks_are_in_centimetres_and_not_in_inches(share: float) -> None:
    assert find_scale(share * 100 * np.array(DESK.size), DESK)[0] == 0.01


def test_a_table_as_high_as_a_man_is_in_no_unit() -> None:
    scale, reason = find_scale(2.3 * np.array(DESK.size), DESK)
    assert scale == pytest.approx(1 / 2.3, rel=0.01) and "usual" in reason


def test_the_unit_that_a_file_states_counts_unless_it_is_absurd() -> None:
    assert find_scale(np.array([55.0, 27.0, 30.0]), DESK, unit=0.0254) == (0.0254, "its file says its unit")
    assert find_scale(np.array([55.0, 27.0, 30.0]), None, unit=0.001)[0] == 0.001
    assert find_scale(np.array([160.0, 80.0, 76.0]), DESK, unit=1.0)[0] == 0.01


def test_of_a_thing_that_differs_much_in_size_the_file_s_own_unit_counts() -> None:
    cactus = UsualSize((0.35, 0.3, 0.6), span=4.0)
    in_a_desert = 3.8 * np.array(cactus.size)
    assert find_scale(in_a_desert, cactus) == (1.0, "")
    assert "usual" in find_scale(in_a_desert, UsualSize(cactus.size))[1]
    assert "usual" in find_scale(2 * in_a_desert, cactus)[1], "nor is it any size"
