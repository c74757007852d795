"""Story-centric Reflection (paper, Eq. 1): propose, judge, refine, hand over. One loop for every role."""

from __future__ import annotations

from dataclasses import dataclass
from reprlib import Repr
from typing import Generic, Protocol, TypeVar

from storyblender.memory.base import Frozen
from storyblender.trace import Event, Listener, silent

View = TypeVar("View", contravariant=True)
Draft = TypeVar("Draft")
Judged = TypeVar("Judged", contravariant=True)


_SHORT = Repr()
"""How a draft is written into the trace."""
_SHORT.maxother = 240


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

    @classmethod
    def of(cls, faults: tuple[Fault, ...]) -> Critique:
        """Score ten less the severities, never under one."""
        return cls(score=max(1.0, 10.0 - sum(fault.severity for fault in faults)), faults=faults)


class Policy(Protocol[View, Draft]):
    """Phi and Psi of one role: rules or a language model."""

    def propose(self, view: View) -> Draft:
        """Make the first draft from the role's projection of the graph."""
        ...

    def refine(self, draft: Draft, critique: Critique, view: View) -> Draft:
        """Return a better draft that answers the critique."""
        ...


class Critic(Protocol[View, Judged]):
    """R: judges a draft; an engine critic computes, a vision critic looks."""

    def judge(self, draft: Judged, view: View) -> Critique:
        """Score the draft."""
        ...


@dataclass(frozen=True)
class Outcome(Generic[Draft]):
    """What a reflection ended with."""

    draft: Draft
    critique: Critique
    turns: int
    handed_over: bool

    @property
    def accepted(self) -> bool:
        """True if nothing is left to mend above the critic's noise."""
        return not self.critique.faults


def reflect(
    role: str,
    subject: str,
    view: View,
    policy: Policy[View, Draft],
    critic: Critic[View, Draft],
    *,
    threshold: float = 8.0,
    horizon: int = 5,
    fallback: Policy[View, Draft] | None = None,
    listener: Listener = silent,
) -> Outcome[Draft]:
    """Run Eq. 1 and return the accepted draft, or the best one seen.

    Args:
        role: Name of the role, for the trace.
        subject: What is being decided, for the trace.
        view: The role's projection of the graph (C).
        policy: Proposes (Phi) and refines (Psi).
        critic: Scores (R).
        threshold: tau, accept at this score.
        horizon: T_max, refinements before handing over.
        fallback: Takes the context over (Omega) where the policy did not converge.
        listener: Receives one event per step.

    Returns:
        The first draft at or over the threshold; else the best of all, with ``handed_over`` set if the
        fallback made it.
    """
    best: Outcome[Draft] | None = None
    for handed_over, author in ((False, policy), (True, fallback)):
        if author is None:
            continue
        if handed_over:
            listener(Event(kind="handover", role=role, subject=subject, message="the fallback takes over"))
        draft = author.propose(view)
        listener(Event(kind="propose", role=role, subject=subject, message=_SHORT.repr(draft)))
        for turn in range(horizon + 1):
            critique = critic.judge(draft, view)
            kept = Outcome(draft, critique, turn, handed_over)
            listener(_scored(role, subject, kept))
            if critique.score >= threshold:
                return kept
            if best is None or critique.score > best.critique.score:
                best = kept
            if turn < horizon:
                refined = author.refine(draft, critique, view)
                if refined == draft:  # nothing more comes of asking again
                    break
                draft = refined
                listener(_refined(role, subject, turn + 1, draft, critique))
    assert best is not None
    return best


def _scored(role: str, subject: str, outcome: Outcome[Draft]) -> Event:
    return Event(
        kind="score",
        role=role,
        subject=subject,
        turn=outcome.turns,
        score=round(outcome.critique.score, 2),
        details=tuple(fault.message for fault in outcome.critique.faults),
    )


def _refined(role: str, subject: str, turn: int, draft: object, critique: Critique) -> Event:
    """The new draft, and the fixes that the critic gave for the one before."""
    fixes = (
        f"{fault.kind} {fault.subject}: " + ", ".join(f"{name} {value}" for name, value in fault.fix.items())
        for fault in critique.faults
        if fault.fix
    )
    return Event(kind="refine", role=role, subject=subject, turn=turn, message=_SHORT.repr(draft), details=tuple(fixes))
