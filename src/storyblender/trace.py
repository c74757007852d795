"""The typed record of a run: what each role proposed, how it scored, what was fixed, who took over."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Literal

from storyblender.memory.base import Frozen
from storyblender.memory.plain_words import plain

EventKind = Literal[
    "stage", "job", "propose", "score", "refine", "accept", "handover", "commit", "reject", "warning", "follow",
    "cancel",
]  # fmt: skip
"""``stage``: a step of a stage is done; ``job``: progress inside a job; ``follow``: a shot that nobody edited
changed in consequence of an edit; ``cancel``: a call was ended."""


DecidedBy = Literal["rules", "model"]
"""Who plays a role; a person at a chat window who answers for one counts as a model."""


class Event(Frozen):
    """One thing that happened; shown live and appended to ``trace.jsonl``."""

    kind: EventKind
    role: str
    """Role or stage, e.g. ``spatial_planner``."""
    subject: str = ""
    """What it was about, e.g. ``SC010_SH020``."""
    turn: int = 0
    score: float | None = None
    message: str = ""
    """For people; of a stage what it is called where it is gone through a second time."""
    details: tuple[str, ...] = ()
    view: str = ""
    """Digest of what the role saw."""
    by: DecidedBy | None = None
    """Whose draft is accepted."""
    draft: str = ""
    """The whole draft as JSON; in ``trace.jsonl`` its digest, by which ``drafts.jsonl`` has it."""
    step: int | None = None
    """Progress: this many of ``total`` are done."""
    total: int | None = None

    def in_words_for(self, names: Mapping[str, str]) -> Event:
        """Return the event as people read it: with display names, as ``names_of`` returns them, in place of ids."""
        return self.model_copy(
            update={
                "subject": names.get(self.subject, self.subject).removeprefix("the "),
                "message": plain(self.message, names),
                "details": tuple(plain(each, names) for each in self.details),
            }
        )


Listener = Callable[[Event], None]
"""Receives every event, in order."""


def silent(event: Event) -> None:
    """A listener that ignores everything."""
