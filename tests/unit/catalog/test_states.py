"""Things look different in the states a story brings them to, and as before in others."""

from __future__ import annotations

import pytest
from tests.every import every

from storyblender.catalog.props import PROPS
from storyblender.catalog.states import look_in, state_at_first


@every("key", sorted(key for key, entry in PROPS.items() if entry.params.get("open") is False))
def test_what_can_open_opens_and_closes_again(key: str) -> None:
    opened = look_in(key, {}, "open")
    assert opened is not None and opened.params["open"] is True and not opened.added
    assert look_in(key, {}, "closed") is None
    assert look_in(key, {"open": True}, "closed") is not None


@every("key", sorted(key for key, entry in PROPS.items() if entry.lights))
def test_what_shines_is_dark_when_it_is_off(key: str) -> None:
    dark = look_in(key, {}, "off")
    assert dark is not None and (dark.params.get("unlit") or False in dark.params.values())


@pytest.mark.parametrize(("key", "broken"), [("vase", "shards"), ("wall_mirror", "shards"), ("anvil", None)])
def test_only_what_is_fragile_goes_to_pieces(key: str, broken: str | None) -> None:
    look = look_in(key, {"color": "#9c2622"}, "broken")
    assert (look.key if look else None) == broken
    assert look is None or look.params["color"] == "#9c2622"


def test_flames_are_seen_with_what_burns() -> None:
    look = look_in("desk", {}, "burning")
    assert look is not None and (look.key, look.added) == ("flames", True)


@pytest.mark.parametrize(("changes", "before"), [(["open"], "closed"), (["off", "on"], "on"), (["wet"], ""), ([], "")])
def test_before_its_first_change_a_thing_was_otherwise(changes: list[str], before: str) -> None:
    assert state_at_first(changes) == before


def test_what_was_out_at_first_shines_once_it_is_lit() -> None:
    lit = look_in("candle", {"unlit": True}, "lit")
    assert lit is not None and "unlit" not in lit.params
    assert look_in("candle", {"unlit": True}, "off") is None
