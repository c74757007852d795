"""Two who do something together: they do it once, hold each other to the end of the shot, and part."""

from __future__ import annotations

import math

import pytest
from tests.unit.agents.visual_effects_artist.test_animator import _cues, _do, _end, _shot, _stage, _start

from storyblender.agents.visual_effects_artist.meetings import PARTED


@pytest.mark.parametrize("motion", ["hug", "kiss", "dance", "shake_hands"])
def test_what_two_do_to_each_other_is_done_once(motion: str) -> None:
    both = (_do("rick", motion, target_id="ilsa"), _do("ilsa", motion, target_id="rick"))
    (shot,) = _stage(_shot(1, *both))
    assert sum(cue.clip == motion for cue in shot.cues) == 1


def test_who_hits_each_other_hits_twice() -> None:
    both = (_do("rick", "hit", target_id="ilsa"), _do("ilsa", "hit", target_id="rick"))
    (shot,) = _stage(_shot(1, *both))
    assert (_cues(shot, "rick").count("hit"), _cues(shot, "ilsa").count("hit")) == (1, 1)


def test_the_last_embrace_lasts_to_the_end_of_the_shot_and_the_next_finds_them_apart() -> None:
    first, second = _stage(_shot(1, _do("rick", "hug", target_id="ilsa"), seconds=9), _shot(2))
    hug = next(cue for cue in first.cues if cue.clip == "hug")
    assert hug.duration is not None
    assert hug.start + hug.duration == first.duration
    apart = [math.dist(_end(first, "rick").location, _end(first, "ilsa").location)]
    apart.append(math.dist(_start(second, "rick").location, _start(second, "ilsa").location))
    assert apart[0] < 0.5
    assert apart[1] == pytest.approx(PARTED, abs=0.1)


def test_who_has_more_to_do_steps_back_from_an_embrace_first() -> None:
    (shot,) = _stage(_shot(1, _do("rick", "kiss", target_id="ilsa"), _do("ilsa", "wave", target_id="rick")))
    kiss = next(cue for cue in shot.cues if cue.clip == "kiss")
    assert kiss.mark == _end(shot, "rick")
    assert math.dist(_end(shot, "rick").location, _end(shot, "ilsa").location) == pytest.approx(PARTED, abs=0.1)
