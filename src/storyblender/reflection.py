"""Story-centric Reflection (paper, Eq. 1): propose, judge, refine, hand over. One loop for every role."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Final, Generic, Literal, ParamSpec, Protocol, TypeVar

from pydantic import TypeAdapter

from storyblender.draft_words import draft_in_words, fix_in_words
from storyblender.errors import NoAnswer
from storyblender.memory.base import Frozen, content_hash
from storyblender.trace import DecidedBy, Event, Listener, silent

Subject = ParamSpec("Subject")
View = TypeVar("View")
Draft = TypeVar("Draft")
Seen = TypeVar("Seen", contravariant=True)
Judged = TypeVar("Judged", contravariant=True)


UNUSABLE: Final = 9.0
"""Severity of a fault with which a draft is never accepted, whatever else is right: the graph cannot hold it."""
SEEN: Final = "seen"
"""Kind of every fault that a vision critic finds."""


class Fault(Frozen):
    """One thing the critic minds, with the numbers that mend it where the engine can compute them."""

    kind: str
    """Closed word per critic, e.g. ``collision``, ``headroom``."""
    message: str
    """The sentence a person or a model reads, with the exact fix."""
    subject: str = ""
    """node_id or shot it is about."""
    severity: float = 1.0
    """Points of ten that it costs."""
    fix: dict[str, float | str] = {}
    """The engine's numeric fix, e.g. ``{"move_x": 1.25}``; applied by code, never re-asked of a model."""


class Critique(Frozen):
    """R(o, C) and the feedback F."""

    score: float
    """1 to 10; engine critics give 10 for valid, less for each fault."""
    faults: tuple[Fault, ...] = ()
    remarks: tuple[str, ...] = ()
    """What single critics said, where several judge together; for the trace."""

    @classmethod
    def of(cls, faults: tuple[Fault, ...]) -> Critique:
        """Score ten less the severities, never under one."""
        return cls(score=max(1.0, 10.0 - sum(fault.severity for fault in faults)), faults=faults)


class Policy(Protocol[Seen, Draft]):
    """Phi and Psi of one role: rules or a language model."""

    def propose(self, view: Seen) -> Draft:
        """Make the first draft from the role's projection of the graph."""
        ...

    def refine(self, draft: Draft, critique: Critique, view: Seen) -> Draft:
        """Return a better draft that answers the critique; an equal one ends the turns of this policy.

        Args:
            draft: The one that was judged.
            critique: Its faults, with the numbers that mend them where the critic computed any.
            view: What ``propose`` was given.

        Raises:
            NoAnswer: It failed for good, and the next policy of the role takes over.
        """
        ...


class Critic(Protocol[Seen, Judged]):
    """R: judges a draft; an engine critic computes, a vision critic looks."""

    def judge(self, draft: Judged, view: Seen) -> Critique:
        """Return the score of a draft, 1 to 10, and its faults.

        Args:
            draft: What a policy of the role made.
            view: The role's projection of the graph that it was made from.
        """
        ...


@dataclass(frozen=True)
class Outcome(Generic[View, Draft]):
    """What a reflection ended with."""

    view: View
    draft: Draft
    critique: Critique
    turns: int
    handed_over: bool
    by: DecidedBy = "rules"

    @property
    def accepted(self) -> bool:
        """True if nothing is left to mend above the critic's noise."""
        return not self.critique.faults


class Format(Protocol[Seen, Draft]):
    """How the drafts of a role are written down, so that a run can be replayed from them."""

    def write(self, draft: Draft) -> str:
        """Return a draft as JSON."""
        ...

    def read(self, text: str, view: Seen) -> Draft:
        """Return the draft that was written for a view.

        Args:
            text: As ``write`` returned it.
            view: The role's projection of the graph that it was made from.

        Raises:
            ValueError: The text is no draft of this role.
        """
        ...


@dataclass(frozen=True)
class Typed(Generic[Draft]):
    """The format of drafts that are values of one type.

    Attributes:
        kind: The type; pydantic writes and reads it.
    """

    kind: type[Draft]

    def write(self, draft: Draft) -> str:
        """Return a draft as JSON."""
        return _adapter_of(self.kind).dump_json(draft).decode()

    def read(self, text: str, view: object) -> Draft:
        """Return the draft that was written.

        Args:
            text: JSON, as ``write`` returned it.
            view: Not used: the type alone decides.

        Raises:
            ValueError: The text is no draft of this type.
        """
        return _adapter_of(self.kind).validate_json(text)


@dataclass(frozen=True)
class Role(Generic[Subject, View, Draft]):
    """One member of the crew.

    Attributes:
        name: For the trace and the settings, e.g. ``spatial_planner``.
        project: The projection: from the graph and a subject to all that the role's policies may know.
        policies: Tried in order; each hands over to the next if it does not converge.
        critic: Scores every draft.
        drafts: How drafts are written down.
        threshold: tau, accept at this score.
        horizon: T_max, refinements before handing over.
        rules: How many of the policies are rules, from the last one back; those before them are models.
    """

    name: str
    project: Callable[Subject, View]
    policies: tuple[Policy[View, Draft], ...]
    critic: Critic[View, Draft]
    drafts: Format[View, Draft]
    threshold: float = 8.0
    horizon: int = 5
    rules: int = 1


def view_digest(view: object) -> str:
    """Return the digest of a view; recorded drafts are found by it, because equal views get equal drafts."""
    return content_hash(_adapter_of(type(view)).dump_python(view, mode="json"))


_adapter_of = cache(TypeAdapter)
"""How pydantic writes the values of a type; it takes a while to find out."""


def reflect(
    role: Role[Subject, View, Draft], subject: str, view: View, listener: Listener = silent
) -> Outcome[View, Draft]:
    """Run Eq. 1 and return the accepted draft, or the best one seen.

    Args:
        role: Whose decision it is.
        subject: What is being decided, for the trace.
        view: The role's projection of the graph (C).
        listener: Receives one event per step.

    Returns:
        The first draft at or over the threshold; else the best of all, with ``handed_over`` set if it is not of the
        role's first policy.
    """
    best: Outcome[View, Draft] | None = None
    for place, author in enumerate(role.policies):
        by: DecidedBy = "rules" if place >= len(role.policies) - role.rules else "model"
        if place:
            listener(Event(kind="handover", role=role.name, subject=subject, message=_takes_over(role, place, by)))
        try:
            for turn, draft, critique in _turns(role, author, subject, view, listener):
                kept = Outcome(view, draft, critique, turn, place > 0, by)
                if best is None or critique.score > best.critique.score:
                    best = kept
                if critique.score >= role.threshold:
                    return _accepted(role, subject, kept, listener)
        except NoAnswer as error:
            listener(Event(kind="warning", role=role.name, subject=subject, message=str(error)))
    if best is None:
        raise ValueError(f"{role.name} has no policy")
    return _accepted(role, subject, best, listener)


def _takes_over(role: Role[Subject, View, Draft], place: int, by: DecidedBy) -> str:
    """Return who takes over from a model; empty where one rule follows another, which concerns nobody but the trace."""
    if place > len(role.policies) - role.rules:
        return ""
    successor = "the rules take over" if by == "rules" else "the next model takes over"
    return f"{successor} as {role.name.replace('_', ' ')}"


def _turns(
    role: Role[Subject, View, Draft], author: Policy[View, Draft], subject: str, view: View, listener: Listener
) -> Iterator[tuple[int, Draft, Critique]]:
    """Yield each turn of one policy with its draft and the critique, until nothing more comes of asking again."""
    draft = author.propose(view)
    listener(_told(role, "propose", subject, draft))
    for turn in range(role.horizon + 1):
        critique = role.critic.judge(draft, view)
        listener(_scored(role.name, subject, turn, critique))
        yield turn, draft, critique
        if turn < role.horizon:
            refined = author.refine(draft, critique, view)
            if refined == draft:
                return
            draft = refined
            listener(_told(role, "refine", subject, draft, turn + 1, critique))


def _accepted(
    role: Role[Subject, View, Draft], subject: str, outcome: Outcome[View, Draft], listener: Listener
) -> Outcome[View, Draft]:
    """Return the outcome, after telling which draft answers which view."""
    seen, draft = view_digest(outcome.view), role.drafts.write(outcome.draft)
    told = Event(kind="accept", role=role.name, subject=subject, turn=outcome.turns, view=seen, draft=draft)
    listener(told.model_copy(update={"by": outcome.by}))
    return outcome


def _scored(role: str, subject: str, turn: int, critique: Critique) -> Event:
    return Event(
        kind="score",
        role=role,
        subject=subject,
        turn=turn,
        score=round(critique.score, 2),
        details=(*(fault.message for fault in critique.faults), *critique.remarks),
    )


def _told(
    role: Role[Subject, View, Draft],
    kind: Literal["propose", "refine"],
    subject: str,
    draft: Draft,
    turn: int = 0,
    critique: Critique | None = None,
) -> Event:
    """Return the event of a new draft, with the fixes that the critic gave for the one before."""
    fixes = (
        f"{fault.message}: {fix_in_words(fault.fix)}"
        for fault in (critique.faults if critique is not None else ())
        if fault.fix
    )
    return Event(
        kind=kind,
        role=role.name,
        subject=subject,
        turn=turn,
        message=draft_in_words(draft),
        details=tuple(fixes),
        draft=role.drafts.write(draft),
    )
