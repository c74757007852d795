"""What is told to be in a hollow thing lies within it, above its bottom and below its rim."""

from __future__ import annotations

from tests.every import every

from storyblender.catalog.hollows import HOLLOWS, OPEN_ABOVE, place_inside
from storyblender.catalog.props import PROPS


@every("key", sorted(HOLLOWS))
def test_a_small_thing_lies_within_the_outline_between_bottom_and_rim(key: str) -> None:
    size = PROPS[key].size
    x, y, z = place_inside(key, size, (0.1 * size[0], 0.1 * size[1], 0.05)) or (9.0, 9.0, 9.0)
    assert abs(x) <= size[0] / 2 and abs(y) <= size[1] / 2 and 0 < z < size[2]


@every("key", sorted(OPEN_ABOVE))
def test_five_things_lie_side_by_side_in_what_is_open_above(key: str) -> None:
    size = PROPS[key].size
    places = [place_inside(key, size, (0.05 * size[0], 0.05 * size[1], 0.02), before) for before in range(5)]
    assert len({place for place in places if place}) == 5


def test_what_is_much_larger_goes_into_nothing() -> None:
    assert place_inside("cup", PROPS["cup"].size, (1.0, 1.0, 0.4)) is None


def test_what_is_solid_holds_nothing() -> None:
    assert place_inside("anvil", PROPS["anvil"].size, (0.01, 0.01, 0.01)) is None
