"""The catalog of motions covers the Director's vocabulary and tells plausible lengths."""

from __future__ import annotations

import pytest

from storyblender.agents.director import lexicon
from storyblender.catalog.motions import CLIP_OF, MOTIONS, clip_of, natural_seconds, turning_seconds


def test_every_motion_of_the_director_has_a_clip() -> None:
    assert set(lexicon.MOTIONS) - set(CLIP_OF) == set()


def test_an_unknown_motion_stands_idle() -> None:
    assert clip_of("photosynthesise").key == "idle"
    assert clip_of("stand_up").key == "rise"
    assert clip_of("play_music").key == "play_piano"


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
