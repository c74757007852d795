"""The catalog of motions covers the Director's vocabulary and tells plausible lengths."""

from __future__ import annotations

import pytest

from storyblender.agents.director import lexicon
from storyblender.catalog.motions import MOTION_KEYS, MOTIONS, motion_called, natural_seconds, turning_seconds


def test_every_motion_of_the_director_has_a_clip() -> None:
    assert set(lexicon.MOTIONS) - set(MOTION_KEYS) == set()


def test_a_key_is_its_own_motion_and_so_called() -> None:
    assert all(MOTION_KEYS[key] == motion_called(key) == key for key in MOTIONS)
    assert set(MOTION_KEYS.values()) == set(MOTIONS)


@pytest.mark.parametrize(
    ("words", "key"),
    [
        ("digging", "dig"),
        ("whistles", "whistle"),
        ("leaning over", "lean_over"),
        ("stand_up", "rise"),
        ("play_music", "play_piano"),
        ("photosynthesise", None),
        ("", None),
    ],
)
def test_a_motion_is_found_by_what_it_is_called(words: str, key: str | None) -> None:
    assert motion_called(words) == key


def test_no_director_motion_is_claimed_twice() -> None:
    words = [word for motion in MOTIONS.values() for word in motion.directs]
    assert len(words) == len(set(words))


def test_walking_four_metres_takes_about_four_seconds_and_a_child_is_slower() -> None:
    walk = MOTIONS["walk"]
    adult, child = natural_seconds(walk, distance=4.0), natural_seconds(walk, distance=4.0, stature=1.2)
    assert adult == pytest.approx(4.1, abs=0.3)
    assert child > adult


@pytest.mark.parametrize(("degrees", "seconds"), [(30, 0.0), (90, 1.14), (-170, 2.18)])
def test_turns_cost_steps(degrees: float, seconds: float) -> None:
    assert turning_seconds(degrees) == pytest.approx(seconds, abs=0.01)
