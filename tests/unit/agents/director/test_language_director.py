"""The Director played by a model: it annotates units, and what it says becomes a reading or is sent back."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import pytest
from tests.answering import Alike, Answering, Scripted

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.director import DirectorCritic, RulesDirector
from storyblender.agents.director.kit_choice import choose_kit
from storyblender.agents.director.language_director import LanguageDirector
from storyblender.agents.director.reading import Reading
from storyblender.catalog.sets import SETS
from storyblender.errors import NoAnswer
from storyblender.ports import Answerer
from storyblender.reflection import Critique, Fault
from storyblender.screenplay.fountain import parse
from storyblender.screenplay.source import read as read_text

SCRIPT = parse(
    """INT. BAKERY - DAY

MIRA, in an apron, kneads dough. The bell rings. OTTO comes in with a parcel.

OTTO
For you.

EXT. YARD - NIGHT

Mira opens the parcel.

INT. BAKERY - DAY

She puts a medal on the counter.
"""
)


def director(answerer: Answerer) -> LanguageDirector:
    embedder = cache(Alike)
    return LanguageDirector(answerer, RulesDirector(embedder), embedder)


def noted(view: dict[str, Any]) -> dict[str, Any]:
    """Answer a request: the same few people and things in every unit."""
    number = view["scene"]["number"]
    places = {
        1: {"kit": "shop", "scene_type": "indoor", "time": "day"},
        2: {"kit": "back_yard", "scene_type": "outdoor", "time": "night"},
        3: {"kit": "shop", "scene_type": "indoor", "time": "day", "same_place_as": 1},
    }
    known = {person["id"] for person in view["cast_so_far"]}
    people = [{"id": "mira", "name": "Mira", "outfit": ["white apron"]}, {"id": "otto", "name": "Otto"}]
    units = [
        {
            "number": unit["number"],
            "on_stage": ["mira", "otto"],
            "deeds": [{"actor": "mira", "motion": "wave", "target": "otto"}],
            "states": [
                {"id": "mira", "looks_at": "otto", "face": "smile", "holds": [{"id": "parcel", "grip": "both"}]}
            ],
            "picture": unit["number"],
        }
        | ({"speaker": "otto", "to": "mira"} if unit["kind"] == "dialogue" else {})
        for unit in view["units"]
    ]
    return {
        "place": places[number],
        "people": [person for person in people if person["id"] not in known],
        "things": [] if view["things_so_far"] else [{"id": "parcel", "name": "parcel", "handled": True}],
        "units": units,
    }


@pytest.fixture(scope="module")
def told() -> tuple[Reading, Answering]:
    model = Answering(noted)
    return director(model).propose(SCRIPT), model


def test_the_answer_becomes_a_reading_without_fault(told: tuple[Reading, Answering]) -> None:
    reading, _ = told
    assert DirectorCritic().judge(reading, SCRIPT) == Critique(score=10.0)
    assert [person.name for person in reading.people] == ["Mira", "Otto"]
    assert [scene.kit for scene in reading.scenes] == ["shop", "back_yard", "shop"]
    unit = reading.units[0]
    assert (unit.gaze, unit.expressions) == ({"mira": "otto"}, {"mira": "smile"})
    assert unit.held == {"mira": ["parcel"], "otto": []}
    assert unit.grips == {"mira": {"parcel": "both"}}


def test_the_words_of_the_script_are_never_the_models(told: tuple[Reading, Answering]) -> None:
    reading, _ = told
    for unit in reading.units:
        assert unit.text in " ".join(SCRIPT.text[unit.start : unit.end].split())


def test_a_request_knows_what_came_before(told: tuple[Reading, Answering]) -> None:
    _, model = told
    views = [json.loads(request.view) for request in model.asked]
    assert [view["scene"]["number"] for view in views] == [1, 2, 3]
    assert [len(view["cast_so_far"]) for view in views] == [0, 2, 2]
    assert views[2]["places_so_far"] == [
        {"number": 1, "heading": "INT. BAKERY - DAY", "kit": "shop"},
        {"number": 2, "heading": "EXT. YARD - NIGHT", "kit": "back_yard"},
    ]
    assert views[1]["things_so_far"] == {"parcel": "parcel"}


def test_scenes_in_one_place_share_it(told: tuple[Reading, Answering]) -> None:
    assert [scene.reference for scene in told[0].scenes] == [None, None, 1]


def test_pictures_of_two_scenes_are_never_one(told: tuple[Reading, Answering]) -> None:
    pictures = [unit.picture for unit in told[0].units]
    assert len({*pictures}) == len(pictures)


def test_where_the_rules_read_something_else_it_is_said(told: tuple[Reading, Answering]) -> None:
    assert any(flag.topic == "thing" and "medal" in flag.reason for flag in told[0].flags)


def change(**update: Any) -> Any:
    """Return an answerer that is wrong once in the first unit of each scene, and right when it is told."""

    class Wrong(Answering):
        def answer(self, request: Any) -> str:
            right = json.loads(super().answer(request))
            if not request.feedback:
                right["units"][0] |= update
            return json.dumps(right)

    return Wrong(noted)


@pytest.mark.parametrize(
    ("update", "why"),
    [
        ({"on_stage": ["nobody"]}, "names the person 'nobody'"),
        ({"number": 7}, "each once and in order"),
        ({"deeds": [{"actor": "mira", "motion": "bake_bread"}]}, "names the motion 'bake_bread'"),
        ({"deeds": [{"actor": "mira", "motion": "open", "target": "treasure"}]}, "names 'treasure'"),
        ({"states": [{"id": "ghost", "posture": "sit"}]}, "'ghost'"),
        ({"states": [{"id": "mira", "activity": "kneading the dough"}]}, "activity"),
        ({"states": [{"id": "mira", "on": "parcel"}]}, "no `posture`"),
        ({"absent": ["parcel"]}, "mira holds 'parcel', which is `absent` there"),
        ({"states": [{"id": each, "holds": [{"id": "parcel"}]} for each in ("mira", "otto")]}, "both hold 'parcel'"),
    ],
)
def test_what_cannot_be_is_sent_back_with_the_reason(update: dict[str, Any], why: str) -> None:
    model = change(**update)
    reading = director(model).propose(SCRIPT)
    assert DirectorCritic().judge(reading, SCRIPT).score == 10.0
    sent_back = [request for request in model.asked if request.feedback]
    assert len(sent_back) == 3
    assert any(why in sentence for sentence in sent_back[0].feedback)


def test_a_door_of_the_set_needs_no_entry_among_the_things() -> None:
    opened = change(deeds=[{"actor": "otto", "motion": "open", "target": "door"}])
    reading = director(opened).propose(SCRIPT)
    assert "door" in {thing.id for thing in reading.things}
    assert not [request for request in opened.asked if request.feedback]


def test_a_request_offers_the_kit_that_the_rules_would_take_and_every_motion(told: tuple[Reading, Answering]) -> None:
    views = [json.loads(request.view) for request in told[1].asked]
    rules = RulesDirector(cache(Alike)).propose(SCRIPT)
    for view, scene in zip(views, rules.scenes, strict=True):
        assert choose_kit(scene, (), "") in view["kits"]
        others = [key for keys in view["other_kits"].values() for key in keys]
        assert {*view["kits"], *others} == {*SETS}
        assert "give" in view["motions"]


def test_a_place_that_is_known_keeps_its_kit() -> None:
    def moved(view: dict[str, Any]) -> dict[str, Any]:
        answer = noted(view)
        if view["scene"]["number"] == 3 and not model.asked[-1].feedback:
            answer["place"]["kit"] = "church"
        return answer

    model = Answering(moved)
    reading = director(model).propose(SCRIPT)
    assert "has the kit 'shop'" in model.asked[-1].feedback[0]
    assert reading.scenes[2].kit == "shop"


def test_only_the_scene_with_a_fault_is_read_again() -> None:
    model = Answering(noted)
    reader = director(model)
    draft = reader.propose(SCRIPT)
    number = next(index for index, unit in enumerate(draft.units, start=1) if unit.scene == 1)
    fault = Fault(kind="unknown", subject=f"unit {number}", message="unit names a thing that is not there")
    assert reader.refine(draft, Critique.of((fault,)), SCRIPT) == draft
    assert len(model.asked) == 4
    assert model.asked[3].feedback == (fault.message,)
    assert json.loads(model.asked[3].view)["scene"]["number"] == 2


def test_a_model_that_fails_leaves_the_script_to_the_rules() -> None:
    with pytest.raises(NoAnswer):
        director(Scripted([NoAnswer("the server is gone")])).propose(SCRIPT)


PROSE = read_text(
    "The ring\n\nMira led the cow into the ring. Otto nodded.\n\n"
    'He caught up with her on the road. "Wait," said Otto.\n\n'
    "At home Mira opened the door.\n"
)


def walked(view: dict[str, Any], **places: dict[str, Any]) -> dict[str, Any]:
    """Answer a request about ``PROSE``: the road and the house are scenes of their own."""
    told = {
        "He caught": {"kit": "street", "name": "the road", "scene_type": "outdoor", "time": "day"},
        "At home": {"kit": "living_room", "name": "home", "scene_type": "indoor", "time": "evening"},
    } | places
    units = [
        {"number": unit["number"], "on_stage": ["mira", "otto"]}
        | ({"speaker": "otto"} if unit["kind"] == "dialogue" else {})
        | next(({"new_scene": place} for words, place in told.items() if unit["text"].startswith(words)), {})
        for unit in view["units"]
    ]
    return {
        "place": {"kit": "open_ground", "scene_type": "outdoor", "time": "day"},
        "people": [{"id": "mira", "name": "Mira"}, {"id": "otto", "name": "Otto"}],
        "units": units,
    }


def test_a_scene_begins_where_the_place_changes_without_a_heading() -> None:
    reading = director(Answering(walked)).propose(PROSE)
    assert [(scene.id, scene.kit, scene.time) for scene in reading.scenes] == [
        (1, "open_ground", "day"), (2, "street", "day"), (3, "living_room", "evening"),
    ]  # fmt: skip
    assert [unit.scene for unit in reading.units] == sorted(unit.scene for unit in reading.units)
    for index, scene in enumerate(reading.scenes):
        inside = [unit for unit in reading.units if unit.scene == index]
        assert inside and scene.start <= inside[0].start and inside[-1].end <= scene.end
    assert DirectorCritic().judge(reading, PROSE).score == 10


@pytest.mark.parametrize(
    ("place", "why"),
    [
        ({"kit": "nowhere"}, "there is no kit 'nowhere'"),
        ({"same_place_as": 2}, "same_place_as 2 is no scene before it"),
        ({"same_place_as": 1}, "scene 1 has the kit 'open_ground'"),
        ({"options": ["moat"]}, "option 'moat'"),
        ({"kit": "car"}, "the kit 'car' is indoor, and scene_type is 'outdoor'"),
        ({"scene_type": "indoor"}, "the kit 'street' is outdoor, and scene_type is 'indoor'"),
    ],
)
def test_a_new_scene_that_cannot_be_is_sent_back(place: dict[str, Any], why: str) -> None:
    road = {"kit": "street", "name": "the road", "scene_type": "outdoor", "time": "day"}
    model = Answering(lambda view: walked(view, **{"He caught": road | place}))
    with pytest.raises(NoAnswer):
        director(model).propose(PROSE)
    assert any(why in sentence for sentence in model.asked[1].feedback)


def test_the_rest_of_a_long_scene_knows_how_everyone_is() -> None:
    script = parse("INT. BAKERY - DAY\n\n" + "\n\n".join(f"Mira waves {number} times." for number in range(60)))

    def answer(view: dict[str, Any]) -> dict[str, Any]:
        first = view["units"][0]["number"] == 1
        seated = [{"id": "mira", "posture": "sit", "holds": [{"id": "parcel"}]}]
        return {
            "place": {"kit": "shop", "scene_type": "indoor", "time": "day"},
            "people": [{"id": "mira", "name": "Mira"}],
            "things": [{"id": "parcel", "name": "parcel"}, {"id": "cake", "name": "cake"}],
            "units": [
                {"number": unit["number"], "on_stage": ["mira"], "absent": ["cake"]}
                | ({"states": seated} if first and unit["number"] == 1 else {})
                for unit in view["units"]
            ],
        }

    model = Answering(answer)
    assert len(director(model).propose(script).scenes) == 1
    before = json.loads(model.asked[1].view)["goes_on_from"]
    assert before["kit"] == "shop" and before["absent"] == ["cake"]
    assert before["states"] == {"mira": {"posture": "sit", "on": None, "holds": ["parcel"]}}


def test_the_light_that_the_first_unit_states_is_the_light_of_the_scene() -> None:
    lit = change(changes=[{"subject": "light", "state": "warm, dim"}])
    lit.answer = lambda request, wrong=lit.answer: wrong(request.model_copy(update={"feedback": ()}))
    board = storyboard(director(lit).propose(SCRIPT))
    assert {"warm", "dim"} <= {*board.scene_details[0].setup.light}
    assert all(shot.light_change is None for shot in board.shot_details)
