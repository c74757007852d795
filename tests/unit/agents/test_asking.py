"""Asking a model: the form is checked, what is wrong goes back, numbers of the critic are applied without asking."""

from __future__ import annotations

import json
from collections.abc import Iterable

import pytest
from pydantic import BaseModel
from tests.answering import Scripted

from storyblender.agents.asking import Asker, LanguagePolicy, Notes, prompt
from storyblender.errors import NoAnswer
from storyblender.reflection import Critique, Fault


class Light(BaseModel):
    mood: str
    lamps: int = 1


def asker(answers: Iterable[str | Exception]) -> tuple[Asker[Light], Scripted]:
    model = Scripted(answers)
    return Asker(model, "director", Light), model


@pytest.mark.parametrize(
    "fence",
    [
        "{}", "```json\n{}\n```", "\n```\n{}```\n", "Here it is:\n\n```json\n{}\n```\nI hope it helps.",
        "<think>\nWarm, or {cold}?\n</think>\n\n{}", "<think></think>Sure.\n```\n{}\n```",
    ],
)  # fmt: skip
def test_an_answer_may_stand_in_a_fence(fence: str) -> None:
    ask, _ = asker([fence.replace("{}", '{"mood": "warm"}')])
    assert ask.ask("SC010", {}) == Light(mood="warm")


@pytest.mark.parametrize(
    ("wrong", "why"),
    [
        ("", "Invalid JSON"),
        ('{"mood": "wa', "Invalid JSON"),
        ('{"lamps": 2}', "mood: Field required"),
        ('{"mood": "warm", "lamps": "many"}', "lamps: "),
        (json.dumps(Light.model_json_schema()), "mood: "),
        ("I am sorry, I cannot do that.", "Invalid JSON"),
        ('```json\n{"mood": "warm"}\n```\nor\n```json\n{"mood": "hot"}\n```', "Invalid JSON"),
        ("[" * 100_000, "Invalid JSON"),
        ('{"mood": "\\ud800"}', "Invalid JSON"),
        ('{"mood": "warm", "lamps": ' + "9" * 5000 + "}", "Invalid JSON"),
        ('{"mood": "warm", "lamps": NaN}', "lamps: "),
        ("```json\n" * 100_000, "Invalid JSON"),
        ('{"mood": "warm\x00"', "Invalid JSON"),
        ("null", "the answer: "),
    ],
)
def test_an_answer_of_the_wrong_form_is_sent_back_with_the_reason(wrong: str, why: str) -> None:
    ask, model = asker([wrong, '{"mood": "cold"}'])
    assert ask.ask("SC010", {}).mood == "cold"
    assert model.asked[1].previous == wrong
    assert any(why in sentence for sentence in model.asked[1].feedback)


def test_what_no_schema_can_say_is_checked_too() -> None:
    ask, model = asker(['{"mood": "green"}', '{"mood": "warm"}'])
    answer = ask.ask("SC010", {}, lambda light: [f"{light.mood} is no mood"] if light.mood == "green" else [])
    assert (answer.mood, model.asked[1].feedback) == ("warm", ("green is no mood",))


def test_after_three_wrong_answers_rules_take_over() -> None:
    ask, model = asker(["no"] * 9)
    with pytest.raises(NoAnswer, match="no answer of the right form"):
        ask.ask("SC010", {})
    assert len(model.asked) == 3


def test_the_view_and_the_schema_go_with_the_request() -> None:
    ask, model = asker(['{"mood": "warm"}'])
    ask.ask("SC010", {"heading": "INT. BAR"})
    request = model.asked[0]
    assert json.loads(request.view) == {"heading": "INT. BAR"}
    assert json.loads(request.answer_schema) == Light.model_json_schema()
    assert prompt("common") and request.instructions.startswith("You are the director")


def mended(draft: Light, critique: Critique, view: str) -> Light:
    lamps = [int(fault.fix["lamps"]) for fault in critique.faults if "lamps" in fault.fix]
    return draft.model_copy(update={"lamps": lamps[0]}) if lamps else draft


def policy(answers: list[str | Exception]) -> tuple[LanguagePolicy[str, Light, Light], Scripted]:
    ask, model = asker(answers)
    role = LanguagePolicy[str, Light, Light](
        ask,
        show=lambda view: {"heading": view},
        draft_of=lambda answer, view: answer,
        mend=mended,
    )
    return role, model


def test_numbers_of_the_critic_are_applied_and_never_asked_for() -> None:
    role, model = policy(['{"mood": "warm"}'])
    draft = role.propose("INT. BAR")
    fault = Fault(kind="dark", message="two lamps are wanted", fix={"lamps": 2})
    assert role.refine(draft, Critique.of((fault,)), "INT. BAR").lamps == 2
    assert len(model.asked) == 1


def test_what_has_no_number_is_asked_again_with_the_answer_before() -> None:
    role, model = policy(['{"mood": "warm"}', '{"mood": "cold"}'])
    draft = role.propose("INT. BAR")
    fault = Fault(kind="mood", message="the scene is cold")
    assert role.refine(draft, Critique.of((fault,)), "INT. BAR").mood == "cold"
    assert (model.asked[1].previous, model.asked[1].feedback) == ('{"mood":"warm"}', ("the scene is cold",))


def test_a_view_that_leaves_nothing_to_decide_is_not_asked_about() -> None:
    ask, model = asker([])
    role = LanguagePolicy[str, Light, Light](
        ask, show=lambda view: {}, draft_of=lambda answer, view: answer, settled=lambda view: Light(mood=view)
    )
    assert role.propose("warm") == Light(mood="warm")
    fault = Fault(kind="mood", message="the scene is cold")
    assert role.refine(Light(mood="warm"), Critique.of((fault,)), "warm") == Light(mood="warm")
    assert not model.asked


def test_the_schema_explains_its_fields() -> None:
    class Level(Notes):
        """How bright a room is."""

        stops: float = 0.0
        """Stops over the usual level."""

    assert Level.model_json_schema()["properties"]["stops"]["description"] == "Stops over the usual level."
