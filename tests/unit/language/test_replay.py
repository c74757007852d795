"""Replays: word for word, else the answer to the most similar question of the same role, subject and turn."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.answering import Scripted

from storyblender.errors import InputError, NoAnswer
from storyblender.folder import Folder
from storyblender.language.answer_folder import AnswerFolder
from storyblender.language.replay import Replay
from storyblender.memory.request import Request
from storyblender.reflection import Event, silent

FIRST = Request(
    role="animator",
    subject="SC010",
    instructions="Move them.",
    view=json.dumps({"people": ["anna"]}),
    answer_schema="{}",
)
SECOND = FIRST.model_copy(update={"previous": "first", "feedback": ("not so",)})
AGAIN = FIRST.model_copy(update={"view": json.dumps({"people": ["anna", "ben", "cleo"]})})


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    crew = AnswerFolder(Folder(tmp_path), Scripted(["first", "second", "again"]))
    for request in (FIRST, SECOND, AGAIN):
        crew.answer(request)
    return tmp_path


def test_the_same_questions_get_the_same_answers_and_nothing_is_written(recording: Path) -> None:
    before = {path: path.read_bytes() for path in recording.iterdir()}
    events = list[Event]()
    replay = Replay(recording, events.append)
    assert [replay.answer(each) for each in (FIRST, SECOND, AGAIN)] == ["first", "second", "again"]
    assert {path: path.read_bytes() for path in recording.iterdir()} == before and not events


def test_other_words_of_a_question_get_the_answer_to_the_most_similar_one_of_the_same_turn(recording: Path) -> None:
    events = list[Event]()
    replay = Replay(recording, events.append)
    newer = {"instructions": "Move them well."}
    for request, answer in ((FIRST, "first"), (SECOND, "second"), (AGAIN, "again")):
        assert replay.answer(request.model_copy(update=newer)) == answer
    assert [event.kind for event in events] == ["warning"], "one warning a role"


def test_a_turn_that_was_not_recorded_is_left_to_the_rules(recording: Path) -> None:
    third = FIRST.model_copy(update={"previous": "second", "feedback": ("still not so",)})
    with pytest.raises(NoAnswer, match="no answer to this turn"):
        Replay(recording, silent).answer(third)


def test_a_role_that_was_never_asked_is_refused(recording: Path) -> None:
    with pytest.raises(InputError, match="the recording has no answer for"):
        Replay(recording, silent).answer(FIRST.model_copy(update={"role": "director"}))


def test_another_script_is_refused(recording: Path) -> None:
    page = FIRST.model_copy(update={"role": "director", "subject": "scene 1 from unit 1"})
    AnswerFolder(Folder(recording), Scripted(["{}"])).answer(page)
    with pytest.raises(InputError, match="from another script"):
        Replay(recording, silent).answer(page.model_copy(update={"subject": "scene 2 from unit 9"}))


def test_a_recording_that_was_cut_short_is_gone_on_with_by_rules(recording: Path) -> None:
    with pytest.raises(NoAnswer, match="the recording ends before"):
        Replay(recording, silent).answer(FIRST.model_copy(update={"subject": "SC020"}))


def test_a_vision_critic_that_was_not_recorded_is_left_out(recording: Path) -> None:
    critic = FIRST.model_copy(update={"role": "camera_critic", "pictures_needed": True})
    with pytest.raises(NoAnswer, match="camera_critic is not in the recording"):
        Replay(recording, silent).answer(critic)
    AnswerFolder(Folder(recording), Scripted(["{}"])).answer(critic)
    with pytest.raises(NoAnswer, match="the recording ends before"):
        Replay(recording, silent).answer(critic.model_copy(update={"subject": "SC020"}))
