"""Bodies, places and panels of a corrected reading reach the graph and are carried from shot to shot."""

from __future__ import annotations

import pytest

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.feelings import expression_of
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.agents.director.settings import DirectorSettings
from storyblender.memory.graph import Storyboard
from storyblender.memory.scene_context import Spot
from storyblender.memory.shot_context import BodyState, ShotContext, Tether
from storyblender.screenplay.source import read

_SCRIPT = """INT. WORKSHOP - DAY

ORLA (40) stands at the bench. PIM (12) waits near a ladder with a lamp.

Orla hums.

ORLA
Hand me that.

Pim walks to the door.

Orla frowns.
"""


def _reading() -> Reading:
    return read_script(read(_SCRIPT, "fountain"))


def _plan(reading: Reading, shots: int | None = None) -> Storyboard:
    return storyboard(reading, DirectorSettings(shots_per_scene=shots))


def _state(shot: ShotContext, person: str) -> BodyState:
    return next(state for state in shot.states if state.asset_id == person)


def _covering(story: Storyboard, words: str) -> ShotContext:
    for scene in story.storyboard_outline:
        for outline in scene.shots:
            if any(words in line.text for line in outline.lines):
                return next(
                    s for s in story.shot_details if (s.scene_id, s.shot_id) == (scene.scene_id, outline.shot_id)
                )
    raise AssertionError(words)


def test_facts_without_a_deed_hold_from_the_first_frame_and_stay_until_they_change() -> None:
    reading = _reading()
    first, walk = reading.units[0], next(unit for unit in reading.units if "walks" in unit.text)
    for unit in reading.units:
        unit.spots.clear()
    first.spots["pim"] = Spot(relation="next_to", anchor_id="ladder", distance=0.5)
    first.expressions["orla"] = "thoughtful"
    first.gaze["pim"] = "up"
    first.activities["orla"] = "paint"
    first.grips["pim"] = {"lamp": "both"}
    for unit in reading.units:
        unit.held["pim"] = ["lamp"]
    reading.units[-1].expressions["orla"] = "angry"
    story = _plan(reading)
    shots = {shot.shot_id: shot for shot in story.shot_details}
    before = [shot for shot in shots.values() if shot.shot_id <= _covering(story, walk.text).shot_id]
    for shot in before:
        pim = _state(shot, "pim")
        assert pim.spot == first.spots["pim"] and pim.gaze == "up" and ("lamp", "both") in pim.grips
        assert _state(shot, "orla").expression == "thoughtful" and _state(shot, "orla").activity == "paint"
    last = _covering(story, "frowns")
    assert _state(last, "pim").spot is None, "whoever walks leaves their spot"
    assert _state(last, "orla").expression == "angry"


def test_units_of_one_picture_share_a_shot_and_others_never_do() -> None:
    reading = _reading()
    for number, unit in enumerate(reading.units):
        unit.picture = number // 2
    for shots in (1, 4, None):
        outline = _plan(reading, shots).storyboard_outline[0]
        covered = [{line.text for line in shot.lines} for shot in outline.shots]
        expected = [{unit.text for unit in reading.units if unit.picture == picture} for picture in range(len(covered))]
        assert covered == expected


def test_moment_tethers_absent_things_and_the_set_are_told() -> None:
    reading = _reading()
    unit = reading.units[-1]
    unit.moment = "end"
    unit.tethers.append(Tether(holder="orla", held="pim", kind="hand"))
    unit.absent.append("ladder")
    reading.scenes[0].kit = "workshop"
    story = _plan(reading)
    shot = _covering(story, unit.text)
    assert shot.moment == "end" and shot.tethers == (Tether(holder="orla", held="pim", kind="hand"),)
    assert shot.absent == ("ladder",)
    assert story.scene_details[0].setup.kit == "workshop"


@pytest.mark.parametrize(
    ("words", "expression"),
    [("rage", "rage"), ("beaming with joy", "smile"), ("tears in her eyes", "cry"), ("table", "neutral")],
)
def test_words_for_a_face_become_one_of_the_sixteen(words: str, expression: str) -> None:
    assert expression_of(words) == expression


def test_a_caption_at_the_start_of_a_picture_goes_with_it() -> None:
    reading = _reading()
    for number, unit in enumerate(reading.units):
        unit.picture = number // 2
    for unit in reading.units[2:5:2]:
        unit.kind = "title"
    covered = [{line.text for line in shot.lines} for shot in _plan(reading).storyboard_outline[0].shots]
    expected = [{unit.text for unit in reading.units if unit.picture == picture} for picture in range(len(covered))]
    assert covered == expected


def test_the_moment_of_a_line_names_the_actions_of_that_line() -> None:
    reading = _reading()
    walk = next(unit for unit in reading.units if "walks" in unit.text)
    walk.moment = "start"
    for unit in reading.units:
        unit.picture = 1
    shot = _covering(_plan(reading), "walks")
    named = [action for action in shot.character_actions if action.line_index == shot.moment_line]
    assert shot.moment == "start"
    assert [(action.asset_id, action.motion) for action in named] == [("pim", "walk")]
    assert len(shot.character_actions) > 1
