"""Things look different in the states a story brings them to, and as before in others."""

from __future__ import annotations

import pytest
from tests.every import every

from storyblender.catalog.props import PROPS
from storyblender.catalog.states import state_at_first, state_look, state_looks
from storyblender.catalog.writing import WRITING
from storyblender.memory.thing_states import Condition


@every("key", sorted(key for key, entry in PROPS.items() if entry.params.get("open") is False))
def test_what_can_open_opens_and_closes_again(key: str) -> None:
    opened = state_look(key, {}, "open")
    assert opened is not None and opened.params["open"] is True and not opened.added
    assert state_look(key, {}, "closed") is None
    assert state_look(key, {"open": True}, "closed") is not None


@every("key", sorted(key for key, entry in PROPS.items() if entry.lights))
def test_what_shines_is_dark_when_it_is_off(key: str) -> None:
    dark = state_look(key, {}, "off")
    assert dark is not None and (dark.params.get("unlit") or False in dark.params.values())


@pytest.mark.parametrize(("key", "broken"), [("vase", "shards"), ("wall_mirror", "shards"), ("anvil", None)])
def test_only_what_is_fragile_goes_to_pieces(key: str, broken: str | None) -> None:
    look = state_look(key, {"color": "#9c2622"}, "broken")
    assert (look.key if look else None) == broken
    assert look is None or look.params["color"] == "#9c2622"


def test_flames_are_seen_with_what_burns() -> None:
    look = state_look("desk", {}, "burning")
    assert look is not None and (look.key, look.added) == ("flames", True)


@pytest.mark.parametrize(("changes", "before"), [(["open"], "closed"), (["off", "on"], "on"), (["wet"], ""), ([], "")])
def test_before_its_first_change_a_thing_was_otherwise(changes: list[str], before: str) -> None:
    assert state_at_first(changes) == before


def test_what_was_out_at_first_shines_once_it_is_lit() -> None:
    lit = state_look("candle", {"unlit": True}, "lit")
    assert lit is not None and "unlit" not in lit.params
    assert state_look("candle", {"unlit": True}, "off") is None


def test_a_lamp_that_is_off_stays_dark_whatever_else_happens_to_it() -> None:
    size = PROPS["table_lamp"].size
    for more in ("tipped", "dirty", "wet", "open"):
        (look,) = [
            look for look in state_looks("table_lamp", {}, Condition(states=("off", more)), size) if not look.added
        ]
        assert look.params.get("unlit") is True


@pytest.mark.parametrize("key", sorted(WRITING))
def test_other_words_are_read_where_the_story_says_so(key: str) -> None:
    condition = Condition().after("lettered", "TOO LATE")
    (look,) = state_looks(key, {"text": "COME HOME"}, condition, PROPS[key].size)
    assert look.params["text"] == "TOO LATE" and not look.added
    assert state_looks(key, {"text": "TOO LATE"}, condition, PROPS[key].size) == ()


def test_what_is_broken_lies_on_the_floor_even_if_it_was_tipped_over() -> None:
    size = PROPS["vase"].size
    pieces = state_looks("vase", {}, Condition(states=("tipped", "broken")), size)[0]
    assert pieces.key == "shards" and pieces.lying and pieces.location[2] == -size[1] / 2
