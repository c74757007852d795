"""Answers in a folder, found by what was asked: the record of a model, a replay, and the mailbox of ``ask``.

Every request is one Markdown file with all that it rests on, its pictures beside it, and its answer beside that:
``director-sc010-1a2b3c4d5e6f.request.md`` and ``director-sc010-1a2b3c4d5e6f.answer.json``. An answer is kept as it was
given, mistakes included.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from pydantic_core import from_json

from storyblender.errors import AnswerAwaited, InputError
from storyblender.folder import Folder
from storyblender.memory.request import Request
from storyblender.ports import Answerer

REQUEST, ANSWER = ".request.md", ".answer.json"
BEFORE = "## Your answer before"
"""Heading in a request that is not the first."""
_FENCE = re.compile(r"\A\s*```[a-z]*\s*")
LONGEST = 5_000_000
"""Bytes of an answer; a longer one is refused."""


class AnswerFolder:
    """Answers each request from the folder, else from another answerer, whose answers it keeps.

    Args:
        files: The folder.
        otherwise: Answers what is not in the folder yet.
    """

    def __init__(self, files: Folder, otherwise: Answerer) -> None:
        self._files, self._otherwise = files, otherwise

    def answer(self, request: Request) -> str:
        """Return the kept answer of a request, or a new one. What a person has not finished writing is no answer.

        Raises:
            InputError: A kept answer cannot be read.
            NoAnswer: The other answerer failed.
            AnswerAwaited: The answer has to come from outside first.
        """
        name = name_of(request)
        kept = read_answer(self._files, name)
        if kept is not None and not (isinstance(self._otherwise, Mailbox) and is_unfinished(kept)):
            return kept
        given = self._otherwise.answer(request)
        write_request(self._files, request)
        self._files.write(f"{name}{ANSWER}", given)
        return given


@dataclass(frozen=True)
class Mailbox:
    """Asks by writing a request into a folder; its answer is written beside it.

    Attributes:
        folder: The folder.
    """

    folder: Path

    def answer(self, request: Request) -> str:
        """Write the request, and stop; an answer that is there is not whole yet. Raises AnswerAwaited."""
        files = Folder(self.folder)
        name = write_request(files, request)
        answer, again = self.folder / (name + ANSWER), f"see `storyblender answer {self.folder}`, and run this again"
        if read_answer(files, name) is not None:
            raise AnswerAwaited(f"{answer} ends in the middle", mend=f"complete it, {again}", names=(name,))
        problem = f"{self.folder / (name + REQUEST)} waits for its answer"
        raise AnswerAwaited(problem, mend=f"write it to {answer}, {again}", names=(name,))


def name_of(request: Request) -> str:
    """Return the name of a request's files, without their endings."""
    subject = re.sub(r"[^a-z0-9]+", "_", request.subject.lower()).strip("_")[:40]
    return "-".join(part for part in (request.role, subject, request.digest[:12]) if part)


def read_answer(files: Folder, name: str) -> str | None:
    """Return a kept answer as it was given; None if there is none yet, or an empty file.

    Args:
        files: The folder.
        name: As ``name_of`` gave it.

    Raises:
        InputError: It is not text, or too long.
    """
    path = files.path(f"{name}{ANSWER}")
    try:
        if path.stat().st_size > LONGEST:
            raise InputError("is too long for an answer", mend="give a shorter one", path=path)
        answer = path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        return None
    except UnicodeDecodeError as error:
        raise InputError("is no text in UTF-8", mend="save it as UTF-8", path=path) from error
    return answer if answer.strip() else None


def is_unfinished(answer: str) -> bool:
    """Return whether an answer is JSON that ends in the middle: a person still writes it, or it was cut off.

    Args:
        answer: As it was given; it may stand in a Markdown fence.
    """
    try:
        from_json(_FENCE.sub("", answer).strip().removesuffix("```"))
    except ValueError as error:
        return "EOF while parsing" in str(error)
    return False


def write_request(files: Folder, request: Request) -> str:
    """Write a request for a person or a chat model, its pictures beside it, and return the name of its files.

    Args:
        files: The folder.
        request: What is asked; its digest is part of the name.
    """
    name = name_of(request)
    for number, picture in enumerate(request.pictures, start=1):
        files.write(f"{name}.{number}.{picture.name}.png", picture.png)
    files.write(f"{name}{REQUEST}", as_markdown(request, name))
    return name


def asked(folder: Path) -> Iterator[tuple[str, str | None]]:
    """Yield the name of each request in a folder, in order, with its answer; None where it has none yet.

    Raises:
        InputError: There is no such folder, or an answer cannot be read.
    """
    if not folder.is_dir():
        raise InputError("there is no such folder", mend="give the one that --crew ask:FOLDER names", path=folder)
    files = Folder(folder)
    for path in sorted(folder.glob(f"*{REQUEST}")):
        name = path.name.removesuffix(REQUEST)
        yield name, read_answer(files, name)


def as_markdown(request: Request, name: str) -> str:
    """Return a request as one page: instructions, projection, what was wrong before, the form of the answer.

    Args:
        request: What is asked.
        name: Of the request's files, without their endings.
    """
    title = " ".join(part for part in (request.role.replace("_", " ").title(), request.subject) if part)
    parts = [f"# {title}", request.instructions.strip(), "## What you know", fenced(_indented(request.view))]
    if request.pictures:
        files = (f"{name}.{number}.{each.name}.png" for number, each in enumerate(request.pictures, start=1))
        parts += ["## Pictures", "\n".join(f"* `{file}`" for file in files)]
    parts += repair_parts(request)
    parts += [
        "## Your answer",
        f"Write one JSON value of this schema, and nothing else, to `{name}{ANSWER}` beside this file.",
        fenced(_indented(request.answer_schema)),
    ]
    return "\n\n".join(parts) + "\n"


def repair_parts(request: Request) -> list[str]:
    """Return the Markdown parts on the answer before and what is wrong with it; none for a first request."""
    if not request.feedback:
        return []
    wrong = "\n".join(f"* {sentence}" for sentence in request.feedback)
    return [BEFORE, fenced(request.previous), "## What is wrong with it; answer again, whole", wrong]


def fenced(text: str) -> str:
    """Return text as a block of data, in a fence longer than any fence inside it."""
    longest = max((len(run) for run in re.findall(r"`+", text)), default=0)
    fence = "`" * max(3, longest + 1)
    return f"{fence}json\n{text}\n{fence}"


def _indented(text: str) -> str:
    """Return JSON over several lines, as people read it."""
    return json.dumps(json.loads(text), indent=1, ensure_ascii=False)
