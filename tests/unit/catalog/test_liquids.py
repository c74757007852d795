"""Liquids run from where they leave a thing, lie at its foot in their own colour, and fill only what holds them."""

from __future__ import annotations

import pytest

from storyblender.catalog.liquids import LIQUIDS, SPOUTS, VESSELS, filling_of, liquid_named, spill_width
from storyblender.catalog.props import PROPS
from storyblender.catalog.states import state_looks, topples
from storyblender.memory.thing_states import THING_STATES, Condition

_IS = {state: Condition(states=(state,)) for state in THING_STATES}


@pytest.mark.parametrize("key", sorted(SPOUTS))
def test_a_stream_leaves_by_the_spout_and_stops_when_it_is_turned_off(key: str) -> None:
    size = PROPS[key].size
    (stream,) = state_looks(key, {}, _IS["running"], size)
    assert stream.added and stream.key in ("running_water", "water_jet")
    mouth, end, _ = SPOUTS[key]
    assert stream.location[2] == pytest.approx(end * size[2])
    assert stream.location[2] + float(stream.params["height"]) == pytest.approx(max(mouth[2] * size[2], 0.03), abs=0.02)
    assert all(look.key != stream.key for look in state_looks(key, {}, _IS["off"], size))


@pytest.mark.parametrize("key", sorted(VESSELS))
def test_what_is_spilled_lies_outside_what_held_it_in_its_own_colour(key: str) -> None:
    size = PROPS[key].size
    puddles = [look for look in state_looks(key, {}, _IS["spilled"], size, LIQUIDS["milk"]) if look.key == "puddle"]
    assert len(puddles) == 1 and puddles[0].params["color"] == LIQUIDS["milk"] and puddles[0].added
    reach = float(puddles[0].params["depth"]) / 2 - puddles[0].location[1]
    assert reach > (size[2] if topples(size) else size[1] / 2)
    assert puddles[0].lying == topples(size)


def test_nothing_runs_out_of_what_holds_nothing() -> None:
    assert not [look for look in state_looks("chair", {}, _IS["tipped"], PROPS["chair"].size) if look.added]
    assert not [look for look in state_looks("glass", {}, _IS["tipped"], PROPS["glass"].size) if look.added]
    poured = Condition(states=("empty", "tipped"))
    assert not [look for look in state_looks("glass", {}, poured, PROPS["glass"].size, LIQUIDS["milk"]) if look.added]


@pytest.mark.parametrize(
    ("words", "color"), [("a bucket of red paint", LIQUIDS["paint"]), ("a bottle of ink", LIQUIDS["ink"])]
)
def test_liquids_have_the_colour_of_their_name(words: str, color: str) -> None:
    assert liquid_named(words) == color
    assert liquid_named("a bucket of blue paint") not in (color, "")
    assert liquid_named("a bucket") == ""


def test_a_filling_lies_within_its_vessel_and_a_larger_one_spills_farther() -> None:
    for key in sorted(VESSELS):
        found = filling_of(key, PROPS[key].size)
        if found is not None:
            (width, depth, _), level, _ = found
            assert width < PROPS[key].size[0] and depth < PROPS[key].size[1] and 0 < level < PROPS[key].size[2]
    assert spill_width(PROPS["cup"].size) < spill_width(PROPS["bucket"].size) <= 1.8
