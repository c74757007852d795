"""A vision critic beside the engine's: lower score, faults of both, engine alone where nothing is answered."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Literal

import pytest
from tests.answering import Scripted

from storyblender.agents import asking
from storyblender.agents.asking import Asker
from storyblender.agents.vision_critic import VisionCritic, critic_notes
from storyblender.errors import AnswerAwaited, NoAnswer
from storyblender.memory.request import Picture
from storyblender.reflection import UNUSABLE, Critique, Fault, Role, Typed, reflect
from storyblender.trace import Event

TurnNotes = critic_notes(Literal["left", "right"])


class Ruler:
    """An engine critic with a fixed opinion."""

    def __init__(self, *severities: float) -> None:
        self.faults = tuple(Fault(kind="long", message="too long", severity=each) for each in severities)

    def judge(self, draft: str, view: str) -> Critique:
        return Critique.of(self.faults)


@pytest.fixture(autouse=True)
def instructions(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(asking, "prompt", lambda name: f"You are the {name}.")


def critic(answerer: Scripted, *severities: float) -> VisionCritic[str, str]:
    return VisionCritic(
        Ruler(*severities),
        Asker(answerer, "turn_critic", TurnNotes),
        subject=lambda view: view,
        show=lambda draft, view: {"draft": draft},
        pictures=lambda draft, view: (Picture(name="preview", png=draft.encode()),),
        ids=lambda view: ("anna",),
    )


def answer(score: float, **faults: str) -> str:
    found = [{"message": message, "operations": [name]} for name, message in faults.items()]
    return json.dumps({"score": score, "faults": found})


def test_the_lower_score_counts_and_the_faults_of_both_are_kept() -> None:
    answerer = Scripted([answer(6, left="she is cut off", right="the lamp covers him"), answer(9.5)])
    both = critic(answerer, 1.0)
    said = both.judge("one", "SC010")
    assert said.score == 6
    assert [(each.kind, each.severity, each.fix.get("ops")) for each in said.faults] == [
        ("long", 1.0, None), ("seen", 2.0, "left"), ("seen", 2.0, "right"),
    ]  # fmt: skip
    assert both.judge("two", "SC010").score == 9
    assert [each.pictures[0].png for each in answerer.asked] == [b"one", b"two"]
    assert (answerer.asked[0].role, answerer.asked[0].subject) == ("turn_critic", "SC010")


@pytest.mark.parametrize("threshold", [8.0, 9.25, 5.0])
def test_what_a_vision_critic_accepts_passes_the_threshold_of_the_role_and_nothing_else_does(threshold: float) -> None:
    scores = [0, 4, 7.9, 8, 8.1, 10]
    both = replace(critic(Scripted([answer(score, left="it leans") for score in scores])), threshold=threshold)
    found = [both.judge(str(score), "SC010") for score in scores]
    assert [each.score >= threshold for each in found] == [score >= 8 for score in scores]
    assert [each.score for each in found] == sorted(each.score for each in found)
    assert all(each.score == max(1.0, Critique.of(each.faults).score) for each in found)


def test_without_an_answer_the_engine_decides_alone_and_the_trace_says_so() -> None:
    said = critic(Scripted([NoAnswer("the server is gone")]), 1.5).judge("one", "SC010")
    assert (said.score, len(said.faults)) == (8.5, 1)
    assert said.remarks == ("turn_critic is not heard: the server is gone",)


def test_a_run_that_waits_for_the_critic_stops() -> None:
    with pytest.raises(AnswerAwaited):
        critic(Scripted([AnswerAwaited("waits", mend="answer it", names=("x",))])).judge("one", "SC010")


def test_a_draft_that_cannot_be_is_not_drawn() -> None:
    assert critic(Scripted([]), UNUSABLE).judge("one", "SC010").score == 1


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ('{"score": 5}', "name the faults for which the score is 5"),
        ('{"score": 9, "faults": [{"message": "m", "subject": "ben"}]}', "there is no id 'ben'"),
        ('{"score": 9, "faults": [{"message": "m", "operations": ["jump"]}]}', "faults[0].operations[0]"),
        ('{"score": 11}', "score"),
    ],
)
def test_an_answer_that_cannot_be_goes_back_with_a_sentence(wrong: str, sentence: str) -> None:
    answerer = Scripted([wrong, answer(8)])
    assert critic(answerer).judge("one", "SC010").score == 8
    assert sentence in answerer.asked[1].feedback[0]


def test_the_trace_tells_what_the_critic_said() -> None:
    class Author:
        def propose(self, view: str) -> str:
            return "one"

        def refine(self, draft: str, critique: Critique, view: str) -> str:
            return draft

    events: list[Event] = []
    role = Role("turner", str, (Author(),), critic(Scripted([answer(6, left="she is cut off")])), Typed(str))
    reflect(role, "SC010", "SC010", events.append)
    scored = next(event for event in events if event.kind == "score")
    assert (scored.score, scored.details) == (6, ("she is cut off", "turn_critic gives 6: she is cut off (left)"))


def test_the_schema_names_the_closed_list_plainly() -> None:
    schema = TurnNotes.model_json_schema()
    assert {*schema["$defs"]} == {"SeenFault"}
    assert schema["$defs"]["SeenFault"]["properties"]["operations"]["items"]["enum"] == ["left", "right"]
