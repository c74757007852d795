"""The tables of docs/edits.md: every phrase decides what its row says, and no phrase is fulfilled in part."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from tests.every import every
from tests.unit.agents.instructor.test_scene_phrases import ROOM

from storyblender.agents.instructor.address import address_of
from storyblender.agents.instructor.instructor import (
    Instruction,
    InstructorCritic,
    InstructorView,
    RulesInstructor,
    ShotNow,
)
from storyblender.errors import InputError
from storyblender.memory.camera_decision import CameraInstruction
from storyblender.memory.edits import BlockingEdit, CameraEdit, DurationEdit, Edit, FormatEdit, LightEdit, SetEdit
from storyblender.memory.scene_decision import BlockingDecision

PAGE = (Path(__file__).parents[4] / "docs" / "edits.md").read_text("utf-8").split("\n## In words")[1].split("\n## ")[0]
NAMES = {"rick": "Rick Blaine", "ilsa": "Ilsa Lund", "letter": "letter"}
PARTS = ("door", "window", "wall", "corner")
SHOTS = ("SC010_SH010", "SC010_SH020", "SC010_SH030", "SC020_SH010", "SC100_SH010")
SCENES = ("SC010", "SC020", "SC100")
STRANGE = ("zorbling", "not", "never", "yesterday", "without", "Sam")
"""Words of which none may be dropped from a phrase, wherever it stands."""


NEGATED = {"not dutch angle", "without dutch angle", "not approved"}
"""These mean something themselves."""


def view(words: str, *names: str) -> InstructorView:
    camera = CameraInstruction(size="MS", focus_on_ids=("ilsa",))
    shots = tuple(
        ShotNow(name=name, camera=camera, frames=48, lens=50.0, on_stage=("rick", "ilsa"))
        for name in names or ("SC010_SH020",)
    )
    room = ROOM.model_copy(update={"parts": PARTS})
    return InstructorView(words, shots, NAMES, 24, (room,), genders={"rick": "male", "ilsa": "female"})


def instruction(words: str) -> Instruction:
    return RulesInstructor().propose(view(words))


def told(edit: Edit) -> str:
    """Return an edit as the page writes it."""
    match edit:
        case CameraEdit():
            return edit.decision.words
        case LightEdit() | SetEdit():
            return f"{edit.kind}: {edit.decision.words}"
        case BlockingEdit():
            return BlockingDecision(people={edit.person: edit.marks}).words
        case DurationEdit():
            return f"{edit.seconds:g} seconds"
    said = edit.model_dump(mode="json", exclude_defaults=True, exclude={"kind", "shot", "scene", "target"})
    fields = (f"{name} {', '.join(value) if isinstance(value, list) else value}" for name, value in said.items())
    return ": ".join(filter(None, (edit.kind, ", ".join(fields))))


def rows(heading: str) -> Iterator[tuple[list[str], str]]:
    """Yield the phrases of each row of a table, and its last cell."""
    table = PAGE.split(heading)[1].split("\n\n")[0]
    for line in table.splitlines():
        phrases = re.findall(r"`([^`]+)`", line.split("|")[1]) if line.startswith("|") else []
        if phrases:
            yield phrases, line.split("|")[2].strip()


PHRASES = [(phrase, meaning) for phrases, meaning in rows("| words |") for phrase in phrases]


@every("phrase meaning", PHRASES)
def test_a_phrase_decides_what_its_row_says(phrase: str, meaning: str) -> None:
    draft = instruction(phrase)
    assert not draft.unclear, draft.unclear
    assert "; ".join(map(told, draft.edits)) == meaning
    assert InstructorCritic().judge(draft, view(phrase)).score == 10


OF_FILM = [(phrase, meaning) for phrases, meaning in rows("| words after `all:` |") for phrase in phrases]


@every("phrase meaning", OF_FILM)
def test_a_phrase_of_the_whole_film_decides_what_its_row_says_and_only_there(phrase: str, meaning: str) -> None:
    of_all = replace(view(phrase), everywhere=True)
    for words in (phrase, f"Please {phrase}.", f"{phrase}, and now"):
        draft = RulesInstructor().propose(replace(of_all, words=words))
        said = [edit.decision.words for edit in draft.edits if isinstance(edit, FormatEdit)]
        assert (draft.unclear, "; ".join(said)) == ((), meaning), words
        assert InstructorCritic().judge(draft, of_all).score == 10
    for words in with_strange_words(phrase):
        assert RulesInstructor().propose(replace(of_all, words=words)).unclear, words
    assert "it is of the whole film" in instruction(phrase).unclear[0], "a shot has no picture of its own"


def test_two_pictures_of_one_film_contradict_each_other() -> None:
    draft = RulesInstructor().propose(replace(view("4:3, 16:9"), everywhere=True))
    assert draft.unclear == ("'4:3' and '16:9' contradict each other",)


@every("phrase meaning", PHRASES)
def test_politeness_and_capitals_change_nothing(phrase: str, meaning: str) -> None:
    for said in (f"Please {phrase}.", f"{phrase.capitalize()}, please!", f"{phrase}, and now"):
        draft = instruction(said)
        assert (draft.unclear, "; ".join(map(told, draft.edits))) == ((), meaning), said


def with_strange_words(phrase: str) -> list[str]:
    """Return the phrase with each of the strange words at each place."""
    words = phrase.split()
    return [" ".join((*words[:at], strange, *words[at:])) for strange in STRANGE for at in range(len(words) + 1)]


@every("phrase meaning", PHRASES)
def test_a_word_that_carries_meaning_is_never_dropped(phrase: str, meaning: str) -> None:
    for said in with_strange_words(phrase)[len(meaning) % 4 :: 4]:
        assert instruction(said).unclear or said in NEGATED, said


@pytest.mark.slow
@every("phrase meaning", PHRASES)
def test_no_word_at_any_place_is_dropped(phrase: str, meaning: str) -> None:
    for said in with_strange_words(phrase):
        assert instruction(said).unclear or said in NEGATED, said


@every("phrase meaning", PHRASES)
def test_what_is_not_understood_is_named(phrase: str, meaning: str) -> None:
    for said in (f"{phrase}, zorbling", f"zorbling, {phrase}"):
        assert instruction(said).unclear == ("zorbling",), said


@every(
    "said missed",
    [
        ("move the table closer to the window", "move the table; to the window"),
        ("get closer to Ben", "to Ben"),
        ("keep the frame wide", "keep the frame"),
        ("bring Rick closer", "bring Rick"),
        ("slower push in", "slower"),
        ("show everyone but Rick", "Rick"),
        ("remove the piano", "'remove the piano' (SC010: there is no piano in SC010)"),
        ("make the door red", "'make the door red' (SC010: there is no door in SC010)"),
        ("add a huge piano", "'add a huge piano' (SC010: the library's piano cannot be 'huge')"),
        ("put a piano by the throne", "'put a piano by the throne' (SC010: there is no throne in SC010)"),
        ("dusty brick walls", "'dusty brick walls' (SC010: the walls cannot be 'dusty')"),
        ("two-shot of Rick", "a two-shot is of two, not of rick"),
        ("over Rick's shoulder on Rick", "rick is behind the camera, and cannot be what it looks at"),
        ("closer, wider", "'closer' and 'wider' contradict each other"),
    ],
)
def test_what_cannot_be_is_said_in_one_sentence(said: str, missed: str) -> None:
    assert "; ".join(instruction(said).unclear) == missed


def test_people_are_those_of_each_shot() -> None:
    alone = view("").shots[0].model_copy(update={"on_stage": ("rick",)})
    for words in ("both of them", "closer on her"):
        asked = replace(view(words), shots=(alone,))
        [problem] = RulesInstructor().propose(asked).unclear
        assert "on stage: rick" in problem
    two = (alone, view("").shots[0].model_copy(update={"name": "SC010_SH030"}))
    assert RulesInstructor().propose(replace(view("both of them"), shots=two)).unclear, "not in some of those named"
    draft = RulesInstructor().propose(replace(view("both of them"), shots=two, everywhere=True))
    assert [edit.shot for edit in draft.edits if isinstance(edit, CameraEdit)] == ["SC010_SH030"]


def test_a_word_of_two_names_means_neither() -> None:
    names = {"old_man": "Old Man", "young_man": "Young Man"}
    asked = replace(view("on the man"), names=names)
    assert RulesInstructor().propose(asked).unclear == ("on the man",)
    [edit] = RulesInstructor().propose(replace(asked, words="on the young man")).edits
    assert told(edit) == "focus on young_man"


ADDRESSES = [(phrase, meaning) for phrases, meaning in rows("| who is meant |") for phrase in phrases]
MEANT = {
    "one shot": ("SC010_SH020",),
    "a scene": ("SC010",),
    "several": ("SC010_SH010", "SC010_SH020"),
    "all; what only some of them can do is done there": SCENES,
}


@every("address meaning", ADDRESSES)
def test_an_address_is_read_with_and_without_a_colon(address: str, meaning: str) -> None:
    for joint in (": ", " ", " : "):
        found = address_of(f"{address}{joint}closer, 35 mm", SHOTS, SCENES)
        assert found.names == MEANT[meaning.partition(":")[0]], joint
        assert found.said == "closer, 35 mm" and found.everywhere == (meaning.startswith("all"))


@every(
    "words names said",
    [
        ("SC010_SH010-SH030: closer", SHOTS[:3], "closer"),
        ("SC010_SH030 - SC010_SH010 closer", SHOTS[:3], "closer"),
        ("SC010 to SC020: warmer", ("SC010", "SC020"), "warmer"),
        ("SC010_SH010 note: too slow: cut", SHOTS[:1], "note: too slow: cut"),
        ("SC010, SC020: 35 mm", ("SC010", "SC020"), "35 mm"),
        ("SC010_SH010 4 seconds", SHOTS[:1], "4 seconds"),
        ("SC010_SH020, closer", SHOTS[1:2], "closer"),
    ],
)
def test_ranges_and_lists(words: str, names: tuple[str, ...], said: str) -> None:
    found = address_of(words, SHOTS, SCENES)
    assert (found.names, found.said) == (names, said)


@pytest.mark.parametrize(
    "words",
    ["SC990_SH010: closer", "Scene 30: closer", "SC010_SH010-SH990: closer", "SC010-SC010_SH020: closer", "SC0101: x",
     "closer", "SC010", "SC010:", "everything in focus", "allover: closer", "SC010_SHX: closer", "SC010x: closer"],
)  # fmt: skip
def test_an_address_that_there_is_not_is_refused(words: str) -> None:
    with pytest.raises(InputError):
        address_of(words, SHOTS, SCENES)


def test_words_without_end_are_refused_quickly() -> None:
    assert instruction("closer and " * 5000).unclear
    assert instruction("@" * 2000 + " closer").unclear
