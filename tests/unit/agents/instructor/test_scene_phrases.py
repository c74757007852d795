"""Words about light, set, staging and things become edits; the words are the catalogue's."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from tests.answering import Scripted
from tests.crew import crew_of
from tests.every import every

from storyblender.agents.instructor.instructor import (
    Instruction,
    InstructorCritic,
    InstructorView,
    RulesInstructor,
    ShotNow,
)
from storyblender.agents.instructor.language_instructor import language_instructor
from storyblender.agents.instructor.scene_view import SceneNow
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import kind_named
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.finishes import FINISHES
from storyblender.catalog.sets.terms_of_finishes import finish_named
from storyblender.memory.camera_decision import CameraInstruction
from storyblender.memory.edits import AssetEdit, Edit, LayoutEdit, LightEdit, SetEdit, TakeEdit
from storyblender.memory.scene_decision import LightDecision
from storyblender.memory.vocabulary import TimeOfDay
from storyblender.reflection import reflect
from storyblender.settings import Settings

SCENE, SHOT = "SC010", "SC010_SH020"
ROOM = SceneNow(
    name=SCENE, kit="living_room", indoor=True, time_of_day="day", weather="clear", light=LightDecision(), options={},
    walls="plaster_cream", ground="parquet", size=(6.0, 5.0, 2.8),
    furniture={"set_sofa_1": "sofa", "set_chair_1": "chair"},
    things={"letter": "letter", "red_box": "gift"},
)  # fmt: skip
DOCK = ROOM.model_copy(update={"kit": "dock", "indoor": False, "options": {"cranes": True}, "walls": ""})


def view(words: str, scene: SceneNow = ROOM) -> InstructorView:
    shot = ShotNow(name=SHOT, camera=CameraInstruction(), frames=48, lens=50.0, on_stage=())
    return InstructorView(words, (shot,), {"rick": "Rick"}, 24, (scene,))


def edits(words: str, scene: SceneNow = ROOM) -> tuple[Edit, ...]:
    draft = RulesInstructor().propose(view(words, scene))
    assert not draft.unclear, draft.unclear
    assert InstructorCritic().judge(draft, view(words, scene)).score == 10
    return draft.edits


def decided(words: str, scene: SceneNow = ROOM) -> dict[str, Any]:
    [edit] = edits(words, scene)
    assert isinstance(edit, LightEdit | SetEdit) and edit.scene == SCENE
    return edit.decision.model_dump(exclude_defaults=True)


@every(
    "words decision",
    [
        ("warmer", {"warmth": 1.0}),
        ("a bit colder", {"warmth": -1.0}),
        ("much warmer light", {"warmth": 2.0}),
        ("darker", {"brightness": -1.0}),
        ("brighter", {"brightness": 1.0}),
        ("more contrast", {"contrast": 1.0}),
        ("softer light", {"contrast": -1.0}),
        ("after sunset", {"time_of_day": "dusk"}),
        ("just before dawn", {"time_of_day": "night"}),
        ("after dark", {"time_of_day": "night"}),
        ("at night", {"time_of_day": "night"}),
        ("make it noon", {"time_of_day": "noon"}),
        ("golden hour", {"time_of_day": "sunset"}),
        ("in the rain", {"weather": "rain"}),
        ("it rains", {"weather": "rain"}),
        ("foggy", {"weather": "fog"}),
        ("clear sky", {"weather": "clear"}),
        ("candlelight", {"qualities": ("candlelight",)}),
        ("harsh light", {"qualities": ("harsh",)}),
        ("light from the left", {"key_side": "left"}),
        ("warmer, after sunset", {"warmth": 1.0, "time_of_day": "dusk"}),
        ("darker and colder, in the rain", {"brightness": -1.0, "warmth": -1.0, "weather": "rain"}),
        ("brick walls", {"walls": "brick"}),
        ("make the walls brick", {"walls": "brick"}),
        ("green walls", {"walls": "plaster_green"}),
        ("a marble floor", {"ground": "marble"}),
        ("wooden floor", {"ground": "wood"}),
        ("paint the walls red", {"walls": "plaster_red"}),
        ("snow on the ground", {"snow": True}),
        ("modern furniture", {"period": "modern"}),
        ("in a kitchen", {"kit": "kitchen"}),
        ("a larger room", {"width": 7.8, "depth": 6.5}),
        ("higher ceiling", {"height": 3.64}),
    ],
)
def test_words_about_light_and_set_are_decisions(words: str, decision: dict[str, Any]) -> None:
    assert decided(words) == decision


def test_a_step_goes_on_from_what_was_decided() -> None:
    warm = ROOM.model_copy(update={"light": LightDecision(warmth=2.5)})
    assert decided("warmer", warm) == {"warmth": 3.0} and decided("colder", warm) == {"warmth": 1.5}


def test_options_of_a_kit_are_turned_on_and_off_by_their_names() -> None:
    assert decided("no cranes", DOCK) == {"options": {"cranes": False}}
    off = DOCK.model_copy(update={"options": {"cranes": False}})
    assert decided("with cranes", off) == {"options": {"cranes": True}}


@every("words", ["another staging", "stage it differently", "restage the scene", "a different layout", "new staging"])
def test_another_staging(words: str) -> None:
    assert edits(words) == (LayoutEdit(scene=SCENE),)


@every(
    "words action thing model",
    [
        ("replace the sofa by a bench", "replace", "sofa", "bench"),
        ("replace the sofa with a red bench", "replace", "sofa", "red bench"),
        ("a bench instead of the sofa", "replace", "sofa", "bench"),
        ("swap the letter for a book", "replace", "letter", "book"),
        ("change the chairs to stools", "replace", "chairs", "stools"),
        ("remove the sofa", "remove", "sofa", None),
        ("without the red box", "remove", "red_box", None),
        ("add a piano", "add", None, "piano"),
    ],
)
def test_things_are_replaced_added_and_taken_away(words: str, action: str, thing: str, model: str) -> None:
    assert edits(words) == (AssetEdit(action=action, thing=thing, scene=SCENE, model=model),)  # type: ignore[arg-type]


@every(
    "words action number",
    [
        ("keep this take", "keep", None),
        ("another take", "keep", None),
        ("take 1", "choose", 1),
        ("drop take 2", "drop", 2),
    ],
)
def test_takes(words: str, action: str, number: int | None) -> None:
    assert edits(words) == (TakeEdit(shot=SHOT, action=action, number=number),)  # type: ignore[arg-type]


@every("words", ["a sadder coat", "unobtainium walls", "replace the sofa by happiness", "warmer coat", "add a feeling"])
def test_what_the_catalogue_does_not_have_is_unclear(words: str) -> None:
    assert RulesInstructor().propose(view(words)).unclear


@every("hour", TimeOfDay.__args__)  # type: ignore[attr-defined]
def test_every_hour_is_understood_by_its_name(hour: str) -> None:
    assert decided(f"at {hour}") == {"time_of_day": hour}


@every("key", [*FINISHES, *MATERIALS])
def test_every_finish_is_found_by_its_key(key: str) -> None:
    assert finish_named(key.replace("_", " ")) in (key, key.replace("grey", "gray"), key.replace("gray", "grey"))


@every("kit", [kit for kit in SETS.values() if kit.indoor])
def test_every_kit_of_a_room_is_found_by_its_name(kit: Any) -> None:
    assert decided(f"set it in a {kit.name.lower()}") == {"kit": kit.key}


@every("prop", list(PROPS.values())[::9])
def test_a_prop_of_the_catalogue_is_added_by_its_name(prop: Any) -> None:
    [edit] = edits(f"add a {prop.name}")
    assert isinstance(edit, AssetEdit) and kind_named(edit.model or "") == kind_named(prop.name)


@pytest.mark.parametrize(
    "edit",
    [
        {"kind": "light", "scene": "SC990", "decision": {"warmth": 1}},
        {"kind": "set", "scene": SCENE, "decision": {"walls": "unobtainium"}},
        {"kind": "set", "scene": SCENE, "decision": {"kit": "beach"}},
        {"kind": "set", "scene": SCENE, "decision": {"options": {"cranes": True}}},
        {"kind": "asset", "scene": SCENE, "thing": "piano", "model": "bench"},
        {"kind": "asset", "scene": SCENE, "thing": "sofa", "model": "unobtainium"},
        {"kind": "take", "shot": "SC990_SH010"},
    ],
)
def test_an_edit_that_cannot_be_is_never_accepted(edit: dict[str, Any]) -> None:
    critique = InstructorCritic().judge(Instruction.model_validate({"edits": [edit]}), view("anything"))
    assert critique.score < 8 and critique.faults


class Flat:
    """An embedder to which all sentences are alike."""

    def embed(self, texts: list[str]) -> Any:
        return np.ones((len(texts), 2))


def test_a_model_sees_the_scene_and_a_part_of_the_catalogue() -> None:
    edit = {"kind": "set", "scene": SCENE, "decision": {"walls": "concrete"}}
    model = Scripted([json.dumps({"edits": [edit]})])
    role = crew_of(Settings()).instructor
    policy = language_instructor(model, cache(Flat))  # type: ignore[arg-type]
    outcome = reflect(replace(role, policies=(policy, *role.policies)), SCENE, view("like a bunker"))
    [done] = outcome.draft.edits
    assert isinstance(done, SetEdit) and done.decision.walls == "concrete"
    shown = json.loads(model.asked[0].view)
    assert shown["scenes"][0]["walls"] == "plaster_cream" and shown["scenes"][0]["furniture"] == {
        "set_sofa_1": "sofa",
        "set_chair_1": "chair",
    }
    assert 0 < len(shown["props"]) < len(PROPS) and 0 < len(shown["kits"]) < len(SETS) and "brick" in shown["materials"]
