import math

import pytest

from storyblender.geometry.boxes import Box, distance_to_point, wrap_angle, yaw_along
from storyblender.geometry.stations import stations

SINK = Box(0.0, 2.3, 0.0, 1.0, 0.6, 0.9)
PERSON = Box(1.0, 0.0, 0.0, 0.5, 0.36, 1.7, math.radians(90))


def test_who_is_at_a_sink_stands_at_its_front_within_reach_and_looks_at_it() -> None:
    best = stations(SINK, "thing", "at")[0]
    assert best.y < SINK.y and distance_to_point(SINK, best.x, best.y) < 0.35
    assert abs(wrap_angle(best.yaw - math.pi)) < 0.01


def test_behind_a_counter_is_at_its_back_looking_across_it() -> None:
    counter = Box(0.0, 0.0, 0.0, 3.0, 0.7, 1.1, math.radians(180))
    assert all(place.y < -0.3 and abs(wrap_angle(place.yaw - math.pi)) < 0.01
               for place in stations(counter, "thing", "behind"))  # fmt: skip


@pytest.mark.parametrize(("side", "x"), [("left", 1), ("right", -1)])
def test_sides_are_the_things_own(side: str, x: int) -> None:
    assert all(x * place.x > 0.5 for place in stations(SINK, "thing", "next_to", side))


def test_a_told_distance_is_kept() -> None:
    places = stations(PERSON, "person", "facing", distance=3.0)
    assert all(abs(math.dist((place.x, place.y), (PERSON.x, PERSON.y)) - 3.0) < 1e-6 for place in places)


def test_who_talks_to_somebody_is_before_them_and_looks_at_them() -> None:
    best = min(stations(PERSON, "person", "facing"), key=lambda place: place.dislike)
    assert best.x > PERSON.x + 0.8
    look = yaw_along(PERSON.x - best.x, PERSON.y - best.y)
    assert abs(wrap_angle(best.yaw - look)) < math.radians(30)


def test_who_is_in_a_doorway_is_between_its_posts() -> None:
    door = Box(-3.5, 0.0, 0.0, 0.95, 0.15, 2.1, math.radians(90))
    (place,) = stations(door, "door", "in")
    assert abs(place.x + 3.4) < 0.05 and abs(place.y) < 0.01 and abs(wrap_angle(place.yaw - math.radians(90))) < 0.01


def test_who_is_at_a_window_is_beside_its_middle_and_seen() -> None:
    window = Box(0.0, 2.6, 1.0, 1.4, 0.15, 1.2)
    for place in stations(window, "window", "at"):
        assert 0.3 < window.y - place.y < 0.7
        assert -math.cos(place.yaw) < 0.95, "not with the whole back to the audience"
