"""States of things: which exclude each other, and the words of scripts and of older projects that name them."""

from __future__ import annotations

import pytest
from tests.every import every

from storyblender.memory.shot_context import AssetModification
from storyblender.memory.thing_states import THING_STATES, Condition, state_values


def test_a_later_state_ends_one_of_its_kind_only() -> None:
    condition = Condition().after("off").after("tipped").after("on")
    assert condition.states == ("tipped", "on")
    lettered = Condition().after("lettered", "HELLO").after("broken").after("lettered", "GO")
    assert (lettered.states, lettered.writing) == (("broken", "lettered"), "GO")
    assert condition.after("") == condition


@every("state", sorted({*THING_STATES} - {"lettered"}))
def test_a_state_is_named_by_itself_with_or_without_details(state: str) -> None:
    assert state_values(state) == state_values(f"{state.capitalize()}, a call comes in") == (state, "", None)


@pytest.mark.parametrize(
    ("words", "values"),
    [
        ("reads TOO LATE", ("lettered", "TOO LATE", None)),
        ("driver passenger door open", ("open", "", ("driver", "passenger"))),
        ("doors closed", ("closed", "", ())),
        ("on fire", ("burning", "", None)),
        ("its number flipped from 47 to 0", ("", "", None)),
    ],
)
def test_the_words_of_older_projects_become_values(words: str, values: tuple[object, ...]) -> None:
    old = {"asset_id": "car", "modification_type": "transform", "state": words}
    change = AssetModification.model_validate(old)
    assert (change.state, change.writing, change.doors) == values
    assert AssetModification.model_validate(change.model_dump(mode="json")) == change
    condition = Condition.model_validate([words])
    assert condition == Condition().after(*state_values(words))
    assert Condition.model_validate(condition.model_dump(mode="json")) == condition


def test_conditions_that_differ_have_different_labels() -> None:
    opened, closed = Condition().after("open", doors=("driver",)), Condition().after("closed", doors=())
    conditions = [opened, closed, Condition().after("open"), Condition().after("lettered", "GO"), Condition()]
    assert len({each.labels for each in conditions}) == len(conditions)
