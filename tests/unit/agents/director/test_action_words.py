"""Facts in the words of an action reach the graph as values."""

from __future__ import annotations

import pytest

from storyblender.agents.director.action_words import with_facts
from storyblender.memory.shot_context import CharacterAction


def _facts(words: str, motion: str = "walk", **names: str) -> CharacterAction:
    return with_facts(CharacterAction(asset_id="tom", action_description=words, motion=motion), names)


@pytest.mark.parametrize(
    ("words", "out"),
    [
        ("gets out of the car", True),
        ("climbs down from the bus", True),
        ("walks to the car", False),
        ("gets in", False),
    ],
)
def test_words_say_who_gets_out(words: str, out: bool) -> None:
    assert _facts(words).gets_out == out


def test_nobody_gets_out_while_standing() -> None:
    assert not _facts("gets his keys out", "search").gets_out


@pytest.mark.parametrize(("words", "flies"), [("flies to Nora", True), ("hovers", True), ("walks", False)])
def test_words_say_what_flies(words: str, flies: bool) -> None:
    assert _facts(words).flies == flies


def test_company_is_named_after_with_by_the_first_or_last_word_of_a_name() -> None:
    names = {"tom": "Tom", "soldier": "Young Soldier", "ilsa": "Ilsa Lund", "sam": "Sam"}
    said = "stands at Sam's piano with Ilsa and the two soldiers"
    assert _facts(said, "stand", **names).company == ("soldier", "ilsa")
