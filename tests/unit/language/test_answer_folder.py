"""Answers in a folder: asked once, kept as given, replayed; requests that a person can answer."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.answering import Scripted

from storyblender.errors import AnswerAwaited, InputError
from storyblender.folder import Folder
from storyblender.language.answer_folder import AnswerFolder, Mailbox, asked, name_of
from storyblender.memory.request import Picture, Request

REQUEST = Request(
    role="lighting_arranger",
    subject="SC010",
    instructions="Light the scene.",
    view=json.dumps({"heading": "INT. BAR", "words": "``` is no fence"}),
    answer_schema=json.dumps({"type": "object"}),
    pictures=(Picture(name="plan", png=b"\x89PNG"),),
)


def test_an_answer_is_asked_for_once_and_kept_as_it_was_given(tmp_path: Path) -> None:
    model = Scripted(['{"a": 1} and some words'])
    crew = AnswerFolder(Folder(tmp_path), model)
    assert [crew.answer(REQUEST), crew.answer(REQUEST)] == ['{"a": 1} and some words'] * 2
    assert len(model.asked) == 1


def test_a_request_waits_in_the_folder_until_somebody_answers_it(tmp_path: Path) -> None:
    crew = AnswerFolder(Folder(tmp_path), Mailbox(tmp_path))
    with pytest.raises(AnswerAwaited) as waits:
        crew.answer(REQUEST)
    name = name_of(REQUEST)
    assert waits.value.names == (name,)
    assert list(asked(tmp_path)) == [(name, None)]
    (tmp_path / f"{name}.answer.json").write_text('{"mood": "warm"}')
    assert crew.answer(REQUEST) == '{"mood": "warm"}'
    assert list(asked(tmp_path)) == [(name, '{"mood": "warm"}')]


def test_a_request_is_a_page_with_all_that_the_answer_rests_on(tmp_path: Path) -> None:
    again = REQUEST.model_copy(update={"previous": '{"mood": 3}', "feedback": ("mood: is no word",)})
    with pytest.raises(AnswerAwaited):
        Mailbox(tmp_path).answer(again)
    name = name_of(again)
    page = (tmp_path / f"{name}.request.md").read_text()
    for told in ("Light the scene.", "INT. BAR", '"type": "object"', '{"mood": 3}', "mood: is no word", "1.plan.png"):
        assert told in page
    assert page.count("````json") == 1, "script text must not close its own fence"
    assert (tmp_path / f"{name}.1.plan.png").read_bytes() == b"\x89PNG"


@pytest.mark.parametrize(
    "change",
    [
        {"role": "animator"}, {"instructions": "x"}, {"view": "{}"}, {"answer_schema": "{}"}, {"previous": "{}"},
        {"feedback": ("wrong",)}, {"pictures": ()},
    ],
)  # fmt: skip
def test_another_request_has_another_digest(change: dict[str, object]) -> None:
    assert REQUEST.model_copy(update=change).digest != REQUEST.digest


def test_the_subject_is_for_people_only_and_safe_as_a_name() -> None:
    other = REQUEST.model_copy(update={"subject": "../../etc/passwd"})
    assert other.digest == REQUEST.digest
    assert "/" not in name_of(other) and ".." not in name_of(other)


def test_an_answer_that_is_no_text_is_refused(tmp_path: Path) -> None:
    (tmp_path / f"{name_of(REQUEST)}.answer.json").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError, match="no text in UTF-8"):
        AnswerFolder(Folder(tmp_path), Mailbox(tmp_path)).answer(REQUEST)


def test_a_folder_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no such folder"):
        list(asked(tmp_path / "nowhere"))
