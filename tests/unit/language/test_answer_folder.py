"""Answers in a folder: asked once, kept as given, replayed; requests that a person can answer."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import Any

import pytest
from tests.answering import Scripted

from storyblender.errors import AnswerAwaited, InputError
from storyblender.folder import Folder
from storyblender.language.answer_folder import AnswerFolder, Mailbox, asked, is_unfinished, name_of
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


@pytest.mark.parametrize("text", ["", " \n", '{"mood": "wa', "```json\n{", '{"a": [1, 2', '[{"a": 1},'])
def test_an_answer_that_is_not_whole_yet_is_waited_for(text: str, tmp_path: Path) -> None:
    crew, answer = AnswerFolder(Folder(tmp_path), Mailbox(tmp_path)), tmp_path / f"{name_of(REQUEST)}.answer.json"
    answer.write_text(text)
    with pytest.raises(AnswerAwaited, match="ends in the middle; complete it" if text.strip() else "waits for its"):
        crew.answer(REQUEST)
    answer.write_text('\ufeff{"mood": "warm"}', encoding="utf-8")
    assert crew.answer(REQUEST) == '{"mood": "warm"}'
    assert [name for name, _ in asked(tmp_path)] == [name_of(REQUEST)], "nothing more is asked"


@pytest.mark.parametrize("text", ["{}", '{"a": 1} x', "I would rather not.", "```json\n{}\n```", "{'a': 1", "[1] ["])
def test_what_no_more_words_would_complete_is_an_answer(text: str) -> None:
    assert not is_unfinished(text)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="kills a forked process")
def test_a_run_killed_while_it_asks_leaves_whole_pages_or_none(tmp_path: Path) -> None:
    """Killed at each flush and each renaming of its files in turn, until there is nothing left to be killed at."""
    for at in range(1, 20):
        folder = tmp_path / str(at)
        survived = _asked_and_killed(folder, at)
        pages = sorted(folder.glob("*.request.md"))
        for page in pages:
            assert page.read_text().rstrip().endswith("```"), "a page is whole"
            assert (folder / f"{name_of(REQUEST)}.1.plan.png").is_file(), "and has its pictures"
        with pytest.raises(AnswerAwaited):
            Mailbox(folder).answer(REQUEST)
        assert list(asked(folder)) == [(name_of(REQUEST), None)]
        if survived:
            break
    assert survived and at > 4


def _asked_and_killed(folder: Path, at: int) -> bool:
    """Ask in a child process that is killed at a call that changes the disk; return whether it came to its end."""
    child = os.fork()
    if not child:
        calls = count(1)

        def deadly(call: Callable[..., Any]) -> Callable[..., Any]:
            def called(*given: Any, **more: Any) -> Any:
                if next(calls) == at:
                    os.kill(os.getpid(), signal.SIGKILL)
                return call(*given, **more)

            return called

        for name in ("fsync", "replace", "rename", "link"):
            setattr(os, name, deadly(getattr(os, name)))
        try:
            Mailbox(folder).answer(REQUEST)
        finally:
            os._exit(0)
    return os.waitpid(child, 0)[1] == 0


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
