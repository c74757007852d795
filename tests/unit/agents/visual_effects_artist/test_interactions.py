"""Two who do something together: they do it once, hold each other to the end of the shot, and part."""

from __future__ import annotations

import math

import pytest
from tests.unit.agents.visual_effects_artist.test_animator import (
    ASSETS,
    LAYOUT,
    PLAN,
    _cues,
    _do,
    _end,
    _shot,
    _stage,
    _start,
    _thing,
    _view,
)

from storyblender.agents.visual_effects_artist.animator import RulesAnimator, ShotStaging
from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.handling import Handling
from storyblender.agents.visual_effects_artist.interactions import DISTANCE_AFTER_EMBRACE
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.memory.shot_context import BodyState, ShotContext


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
    assert apart[1] == pytest.approx(DISTANCE_AFTER_EMBRACE, abs=0.1)


def test_who_has_more_to_do_steps_back_from_an_embrace_first() -> None:
    (shot,) = _stage(_shot(1, _do("rick", "kiss", target_id="ilsa"), _do("ilsa", "wave", target_id="rick")))
    kiss = next(cue for cue in shot.cues if cue.clip == "kiss")
    assert kiss.mark == _end(shot, "rick")
    assert math.dist(_end(shot, "rick").location, _end(shot, "ilsa").location) == pytest.approx(
        DISTANCE_AFTER_EMBRACE, abs=0.1
    )


def _with_luggage(*shots: ShotContext) -> tuple[ShotStaging, ...]:
    luggage = (_thing("crate", (0.5, 0.4, 0.3)), _thing("lamp", (0.1, 0.1, 0.3)))
    view = _view(*shots)
    return RulesAnimator().propose(view.model_copy(update={"assets": (*luggage, *ASSETS)})).shots


@pytest.mark.parametrize("motion", ["hug", "dance"])
def test_who_embraces_somebody_puts_aside_what_they_hold_and_leaves_it_there(motion: str) -> None:
    states = (BodyState(asset_id="rick", held=("lamp",)),)
    embrace = _shot(1, _do("rick", motion, target_id="ilsa"), states=states, seconds=9)
    first, second = _with_luggage(embrace, _shot(2, states=states))
    clips = _cues(first, "rick")
    assert clips.index("put_down") < clips.index(motion)
    assert not _end(first, "rick").held
    assert not _start(second, "rick").held, "it does not jump back into the hand"
    assert next(state for state in second.prop_states if state.asset_id == "lamp").location


def test_who_carries_something_in_both_hands_puts_it_down_before_being_given_something() -> None:
    states = (BodyState(asset_id="rick", held=("lamp",)), BodyState(asset_id="ilsa", held=("crate",)))
    give = _do("rick", "give", target_id="ilsa", prop_id="lamp")
    (shot,) = _with_luggage(_shot(1, give, states=states, seconds=9))
    down = next(cue for cue in shot.cues if cue.clip == "put_down")
    assert (down.asset_id, down.prop_id) == ("ilsa", "crate")
    assert [prop for _, prop in _end(shot, "ilsa").held] == ["lamp"]


def test_who_shakes_hands_holds_their_stick_in_the_left_one() -> None:
    states = (BodyState(asset_id="ilsa", held=("lamp",)),)
    (shot,) = _with_luggage(_shot(1, _do("rick", "shake_hands", target_id="ilsa"), states=states, seconds=9))
    assert (_start(shot, "ilsa").held, _end(shot, "ilsa").held) == ((("L", "lamp"),),) * 2


def test_to_who_sits_the_other_comes_for_an_embrace() -> None:
    states = (BodyState(asset_id="ilsa", posture="sit", support_id="chair_l"),)
    (shot,) = _stage(_shot(1, _do("ilsa", "hug", target_id="rick"), states=states, seconds=9))
    hug = next(cue for cue in shot.cues if cue.clip == "hug")
    assert (hug.asset_id, hug.target_id) == ("rick", "ilsa")
    assert math.dist(_end(shot, "rick").location[:2], _end(shot, "ilsa").location[:2]) < 0.8


def test_who_embraces_a_sitter_stands_beside_their_knees_near_their_breast() -> None:
    states = (BodyState(asset_id="ilsa", posture="sit", support_id="chair_l"),)
    (shot,) = _stage(_shot(1, _do("rick", "hug", target_id="ilsa"), states=states, seconds=9))
    edge, place, yaw = _end(shot, "ilsa").location, _end(shot, "rick").location, math.radians(_end(shot, "ilsa").yaw)
    breast = (edge[0] - 0.25 * math.sin(yaw), edge[1] + 0.25 * math.cos(yaw))
    assert 0.45 < math.dist(place[:2], breast) < 0.75


def test_what_is_put_aside_is_put_ahead_so_that_nobody_turns_for_it() -> None:
    states = (BodyState(asset_id="rick", held=("lamp",)),)
    (shot,) = _with_luggage(_shot(1, _do("rick", "hug", target_id="ilsa"), states=states, seconds=9))
    start, down = _start(shot, "rick"), next(cue for cue in shot.cues if cue.clip == "put_down")
    assert down.mark is not None
    (x, y, _), (px, py, _) = down.mark.location, start.location
    yaw = math.radians(start.yaw)
    ahead, left = (
        (x - px) * math.sin(yaw) - (y - py) * math.cos(yaw),
        (x - px) * math.cos(yaw) + (y - py) * math.sin(yaw),
    )
    assert math.degrees(math.atan2(abs(left), ahead)) < 60
    assert "turn" not in [cue.clip for cue in shot.cues if cue.asset_id == "rick" and cue.start < down.start]


def test_who_sits_is_come_to_by_whom_they_give_something() -> None:
    states = (BodyState(asset_id="rick", posture="sit", support_id="chair_l", held=("lamp",)),)
    give = _do("rick", "give", target_id="ilsa", prop_id="lamp")
    (shot,) = _with_luggage(_shot(1, give, states=states, seconds=9))
    assert _cues(shot, "ilsa")[0] == "walk"
    assert _end(shot, "rick").posture == "sit"
    assert math.dist(_end(shot, "rick").location, _end(shot, "ilsa").location) < 1.0


def test_of_two_who_sit_too_far_apart_the_one_who_gives_gets_up() -> None:
    seats = zip(("rick", "ilsa"), ("chair_l", "chair_r"), strict=True)
    states = tuple(BodyState(asset_id=who, posture="sit", support_id=seat) for who, seat in seats)
    (shot,) = _stage(_shot(1, _do("rick", "touch", target_id="ilsa"), states=states, seconds=12))
    assert _cues(shot, "rick")[:2] == ["rise", "walk"]
    assert _end(shot, "ilsa").posture == "sit"


def test_who_puts_something_aside_across_themselves_turns_to_it() -> None:
    stage = StageState(Floor(LAYOUT, ASSETS, PLAN), (_thing("lamp", (0.1, 0.1, 0.3)), *ASSETS), LAYOUT.objects)
    sheet = CueSheet(stage, 9.0, 24, set(), {}, ())
    rick, ilsa = stage.people["rick"], stage.people["ilsa"]
    rick.present = ilsa.present = True
    rick.place, rick.held, ilsa.place = (0.0, -1.0), {"R": "lamp"}, (-0.55, -1.1)  # on the right of who faces -Y
    Handling(stage, sheet).put_props_aside(rick, ["lamp"], 0.0)
    assert [cue.clip for cue in sheet.cues] == ["turn", "put_down"]
