"""Replays a recording: the same answers to the same questions, even where a newer version words them otherwise."""

from __future__ import annotations

from difflib import SequenceMatcher
from pathlib import Path

from storyblender.errors import InputError, NoAnswer
from storyblender.folder import Folder
from storyblender.language.answer_folder import (
    BEFORE,
    REQUEST,
    as_markdown,
    asked,
    name_of,
    read_answer,
    repair_parts,
)
from storyblender.memory.request import Request
from storyblender.trace import Event, Listener

READING = ("director", "shot_director")
"""Roles that read the script: what they were never asked is of another script."""


class Replay:
    """Answers from a recording and knows nothing else.

    A request that was recorded word for word gets its answer. Another one gets the answer to the most similar request
    of the same role about the same subject, after the same answer before, with one warning a role.

    Args:
        folder: The recording; nothing is written into it.
        listener: Receives the warnings.
    """

    def __init__(self, folder: Path, listener: Listener) -> None:
        self._folder, self._listener = folder, listener
        self._warned = set[str]()

    def answer(self, request: Request) -> str:
        """Return the recorded answer of a request.

        Raises:
            InputError: The recording is of another script, or has nothing of this role.
            NoAnswer: It has not this turn, or ends before this subject; or it was made without this vision critic.
        """
        exact = read_answer(Folder(self._folder), name_of(request))
        return self._most_similar(request) if exact is None else exact

    def knows(self, role: str) -> bool:
        """Return whether the recording has anything of a role; one that is missing has."""
        return not self._folder.is_dir() or any(name.startswith(f"{role}-") for name, _ in asked(self._folder))

    def _most_similar(self, request: Request) -> str:
        """Return the answer to the recorded request that is most like another. Raises InputError or NoAnswer."""
        about = f"{request.role} {request.subject}".rstrip()
        stem = name_of(request).removesuffix(request.digest[:12])
        recorded = {
            Folder(self._folder).path(f"{name}{REQUEST}").read_text(encoding="utf-8"): answer
            for name, answer in asked(self._folder)
            if answer is not None and name[:-12] == stem
        }
        if not recorded:
            if request.pictures_needed and not self.knows(request.role):
                raise NoAnswer(f"{request.role} is not in the recording", mend="record it anew")
            if self.knows(request.role) and request.role not in READING:
                raise NoAnswer(f"the recording ends before {about}", mend="record it anew")
            mend = "it was recorded from another script, or with other roles; record it anew"
            raise InputError(f"the recording has no answer for {about}", mend=mend, path=self._folder)
        same_turn = [page for page in recorded if _before(page, request)]
        if not same_turn:
            raise NoAnswer(f"{about}: the recording has no answer to this turn", mend="record it anew")
        wanted = as_markdown(request, name_of(request)).splitlines()
        if request.role not in self._warned:
            self._warned.add(request.role)
            message = (
                f"the answer of the {request.role.replace('_', ' ')} was recorded for other words of the question; "
                "the one to the most similar question is taken"
            )
            self._listener(Event(kind="warning", role=request.role, subject=request.subject, message=message))
        return recorded[max(same_turn, key=lambda page: _likeness(wanted, page.splitlines()))]


def _before(page: str, request: Request) -> bool:
    """Return whether a recorded request has the same answer before it as another, or both have none."""
    if not request.feedback:
        return BEFORE not in page
    return "\n\n".join(repair_parts(request)[:2]) in page


def _likeness(one: list[str], other: list[str]) -> float:
    """Return the share of equal lines, from 0 to 1."""
    return SequenceMatcher(None, one, other, autojunk=False).ratio()
