"""How a role asks a language model: prompt, projection and schema become a request, the answer a checked value."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from typing import Any, Generic, TypeVar

from pydantic import BaseModel, ValidationError

from storyblender.errors import NoAnswer
from storyblender.memory.base import Described
from storyblender.memory.request import Picture, Request
from storyblender.ports import Answerer
from storyblender.reflection import Critique, Fault, view_digest

Answer = TypeVar("Answer", bound=BaseModel)
View = TypeVar("View")
Draft = TypeVar("Draft")

_REPAIRS = 2
"""How often an answer of the wrong form is asked for again."""
_COMPLAINTS = 12
"""Most sentences of feedback in one request."""
_FENCED = re.compile(r"\A\s*```[a-z]*\s*\n(.*?)\n?\s*```\s*\Z", re.DOTALL)
_THOUGHT = re.compile(r"\A\s*<think>.*?</think>", re.DOTALL)
"""What a reasoning model says before its answer, where its server does not take it away."""


class Notes(Described):
    """A part of an answer."""


@cache
def prompt(name: str) -> str:
    """Return the instructions of a role: its own Markdown file after the one that all share.

    Args:
        name: Of the file in ``agents/prompts``, without its ending.
    """
    folder = files("storyblender.agents").joinpath("prompts")
    return "\n\n".join(folder.joinpath(f"{each}.md").read_text(encoding="utf-8").strip() for each in (name, "common"))


@dataclass(frozen=True)
class Asker(Generic[Answer]):
    """Asks for one kind of answer.

    Attributes:
        answerer: Who answers.
        role: Name of the role; its prompt is ``agents/prompts/<role>.md`` unless ``instructions`` names another.
        kind: Type of the answer; its JSON schema goes with the request.
        instructions: Name of the prompt, if it is not the role's.
    """

    answerer: Answerer
    role: str
    kind: type[Answer]
    instructions: str = ""

    def ask(
        self,
        subject: str,
        view: Mapping[str, Any],
        check: Callable[[Answer], Iterable[str]] = lambda answer: (),
        *,
        previous: str = "",
        feedback: tuple[str, ...] = (),
        pictures: tuple[Picture, ...] = (),
        pictures_needed: bool = False,
    ) -> Answer:
        """Return an answer of the right form; one of the wrong form is sent back with what is wrong, twice at most.

        Args:
            subject: What is to be decided, e.g. ``SC010``.
            view: What the answer may rest on, as JSON values.
            check: Returns a sentence for each thing that no schema can say.
            previous: The answer that ``feedback`` is about, as JSON.
            feedback: What a critic found wrong with it.
            pictures: What there is to look at.
            pictures_needed: Whether a model that sees no pictures cannot answer.

        Raises:
            NoAnswer: None of the answers was of the right form, or nothing answered.
            AnswerAwaited: The answer has to come from outside first.
        """
        request = Request(
            role=self.role,
            subject=subject,
            instructions=prompt(self.instructions or self.role),
            view=json.dumps(view, ensure_ascii=False),
            answer_schema=json.dumps(self.kind.model_json_schema()),
            previous=previous,
            feedback=feedback[:_COMPLAINTS],
            pictures=pictures,
            pictures_needed=pictures_needed,
        )
        wrong = list[str]()
        for _ in range(_REPAIRS + 1):
            given = self.answerer.answer(request)
            answer, wrong = self._read(given, check)
            if answer is not None and not wrong:
                return answer
            request = request.model_copy(update={"previous": given, "feedback": tuple(wrong[:_COMPLAINTS])})
        mend = "rules take over"
        raise NoAnswer(f"{self.role} {subject}: no answer of the right form; the last one: {wrong[0]}", mend=mend)

    def _read(self, given: str, check: Callable[[Answer], Iterable[str]]) -> tuple[Answer | None, list[str]]:
        """Return an answer as a value, or what is wrong with it."""
        answer, wrong = read_answer_as(self.kind, given)
        return answer, wrong if answer is None else list(check(answer))


def read_answer_as(kind: type[Answer], given: str) -> tuple[Answer | None, list[str]]:
    """Return an answer as a value, or what is wrong with its form.

    Args:
        kind: Type of the answer.
        given: The answer as JSON; it may be the only Markdown block among words, or follow a model's thoughts.

    Returns:
        The value and no sentences, or None and a sentence for each fault.
    """
    try:
        return kind.model_validate_json(_json_in(given)), []
    except ValidationError as error:
        return None, [f"{_place(each['loc'])}: {each['msg']}" for each in error.errors()]


def _json_in(given: str) -> str:
    """Return the part of an answer that is meant to be JSON."""
    said = _THOUGHT.sub("", given).strip()
    if inside := _FENCED.match(said):
        return inside[1]
    parts = said.split("```")
    return parts[1].partition("\n")[2] if len(parts) == 3 and not said.startswith(("{", "[")) else said


def _place(location: tuple[int | str, ...]) -> str:
    """Return a place in an answer as JSON paths are written: ``units[3].deeds[0].motion``."""
    path = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in location)
    return path.removeprefix(".") or "the answer"


@dataclass(frozen=True)
class LanguagePolicy(Generic[View, Answer, Draft]):
    """A role played by a language model: one request a turn.

    Attributes:
        asker: Asks for the role's answer.
        show: Returns what the model is shown of a view, as JSON values.
        draft_of: Returns the draft that an answer means for a view.
        check: Returns what is wrong with an answer beyond its form, given the view.
        subject: Returns what a view is about, for people.
        mend: The rules' ``refine``: applies the numbers that the critic computed; the model is asked only for the rest.
        pictures: Returns what there is to look at.
        draft_pictures: Returns what there is to look at of a draft that the model is asked to better.
        pictures_needed: Whether a model that sees no pictures is not asked.
        settled: Returns the draft of a view that leaves nothing to decide; None where the model is asked.
    """

    asker: Asker[Answer]
    show: Callable[[View], Mapping[str, Any]]
    draft_of: Callable[[Answer, View], Draft]
    check: Callable[[Answer, View], Iterable[str]] = lambda answer, view: ()
    subject: Callable[[View], str] = lambda view: ""
    mend: Callable[[Draft, Critique, View], Draft] = lambda draft, critique, view: draft
    pictures: Callable[[View], tuple[Picture, ...]] = lambda view: ()
    draft_pictures: Callable[[Draft, View], tuple[Picture, ...]] = lambda draft, view: ()
    pictures_needed: bool = False
    settled: Callable[[View], Draft | None] = lambda view: None
    _last: dict[str, str] = field(default_factory=dict)
    """The last answer as JSON, by the digest of its view."""

    def propose(self, view: View) -> Draft:
        """Return the draft of the model. Raises NoAnswer or AnswerAwaited."""
        settled = self.settled(view)
        return self._asked(view) if settled is None else settled

    def refine(self, draft: Draft, critique: Critique, view: View) -> Draft:
        """Return the draft with the critic's numbers applied; where it gave none, the model's next draft.

        Args:
            draft: The draft.
            critique: Its faults.
            view: What the role knows.
        """
        mended = self.mend(draft, critique, view)
        if mended != draft or self.settled(view) is not None:
            return mended
        feedback = tuple(_sentence(fault) for fault in critique.faults)
        return self._asked(view, feedback, self.draft_pictures(draft, view))

    def _asked(self, view: View, feedback: tuple[str, ...] = (), pictures: tuple[Picture, ...] = ()) -> Draft:
        seen = view_digest(view)
        answer = self.asker.ask(
            self.subject(view),
            self.show(view),
            lambda answer: self.check(answer, view),
            previous=self._last.get(seen, "") if feedback else "",
            feedback=feedback,
            pictures=(*self.pictures(view), *pictures),
            pictures_needed=self.pictures_needed,
        )
        self._last[seen] = answer.model_dump_json(exclude_defaults=True)
        return self.draft_of(answer, view)


def _sentence(fault: Fault) -> str:
    """Return what is wrong, with the operations that a vision critic expects to help."""
    operations = str(fault.fix.get("ops", "")).split()
    return f"{fault.message} (try {', '.join(operations)})" if operations else fault.message
