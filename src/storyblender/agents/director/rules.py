"""The rules of a reading by name: which of them decided what, on which words, and what is read without one of them.

A rule is a function under ``rule``, or a test inside one, ``as_rule``. While a ledger is kept, whatever a rule adds to
the facts of the reading is written down with its name; without a ledger nothing is recorded, and nothing costs time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from copy import copy
from dataclasses import dataclass, field
from functools import wraps
from typing import NamedTuple, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")

RULES: set[str] = set()
"""The names of all rules met so far: functions when they are imported, tests inside them when they are first made."""


class Fact(NamedTuple):
    """Something that was decided; equal facts are one."""

    kind: str
    """``person``, ``thing``, ``place``, ``deed``, ``posture`` ..."""
    what: str
    unit: int = 0
    """Tells the deeds of one unit from the same deeds of another."""
    words: tuple[int, int] = (0, 0)
    """Its own characters in the script, if it has any; else it stands on the words its rule looked at."""


class Decision(NamedTuple):
    """A fact with the rule that decided it."""

    rule: str
    kind: str
    what: str
    start: int
    end: int
    """First character of the script that it stands on, and the one after the last."""


@dataclass
class Ledger:
    """What was decided, in order, and which rules are not to be used."""

    off: frozenset[str] = frozenset()
    decisions: list[Decision] = field(default_factory=list)
    facts: Callable[[], Iterable[Fact]] = tuple
    """Everything decided so far and still so; compared before and after each rule."""
    _seen: set[Fact] = field(default_factory=set)
    _rules: list[tuple[str, tuple[int, int]]] = field(default_factory=list)
    """The rules at work, the innermost last, each with the words it looks at."""

    def enter(self, name: str, words: tuple[int, int] | None) -> None:
        """Note that a rule begins its work, on these words or on those of the rule around it.

        Args:
            name: Name of the rule.
            words: Start and end of its words, or None for those of the rule around it.
        """
        self.settle()
        self._rules.append((name, words or (self._rules[-1][1] if self._rules else (0, 0))))

    def leave(self) -> None:
        """Note that the innermost rule has done its work."""
        self.settle()
        self._rules.pop()

    def settle(self) -> None:
        """Give every new fact to the innermost rule."""
        facts = {*self.facts()}
        for fact in sorted(facts - self._seen):
            self.decide(fact)
        self._seen = facts

    def decide(self, fact: Fact) -> None:
        """Write down a fact as decided by the innermost rule."""
        rule, span = self._rules[-1] if self._rules else ("page", (0, 0))
        start, end = fact.words if fact.words[1] else span
        self.decisions.append(Decision(rule, fact.kind, fact.what, start, end))


def _words_of(argument: object) -> tuple[int, int] | None:
    """The characters of a clause, a sentence, a paragraph: of what has a start and an end in the script."""
    start, end = getattr(argument, "start", None), getattr(argument, "end", None)
    return (start, end) if isinstance(start, int) and isinstance(end, int) and start < end else None


_KEPT: ContextVar[Ledger | None] = ContextVar("ledger", default=None)


@contextmanager
def using_ledger(ledger: Ledger) -> Iterator[Ledger]:
    """Keep a ledger of what is read inside the block."""
    token = _KEPT.set(ledger)
    try:
        yield ledger
    finally:
        _KEPT.reset(token)


def rule(name: str, without: object = None) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Make a function a rule.

    Args:
        name: Short and stable: ``place.heading``.
        without: What the function returns where the rule is switched off.
    """
    RULES.add(name)

    def decorate(function: Callable[P, R]) -> Callable[P, R]:
        @wraps(function)
        def ruled(*args: P.args, **kwargs: P.kwargs) -> R:
            ledger = _KEPT.get()
            if ledger is None:
                return function(*args, **kwargs)
            if name in ledger.off:
                return copy(without)  # pyright: ignore[reportReturnType]
            ledger.enter(name, next(filter(None, map(_words_of, args)), None))
            try:
                return function(*args, **kwargs)
            finally:
                ledger.leave()

        return ruled

    return decorate


@contextmanager
def as_rule(name: str, start: int, end: int) -> Iterator[None]:
    """Do as a rule what is inside the block, on these words.

    Args:
        name: Name of the rule.
        start: Offset where its words start.
        end: Offset where they end.
    """
    RULES.add(name)
    ledger = _KEPT.get()
    if ledger is None:
        yield
        return
    ledger.enter(name, (start, end))
    try:
        yield
    finally:
        ledger.leave()


def rule_applies(name: str, evidence: object) -> bool:
    """Return whether there is evidence and its rule is not switched off.

    Args:
        name: Name of the rule.
        evidence: What the rule found; false if nothing.
    """
    RULES.add(name)
    ledger = _KEPT.get()
    return bool(evidence) and (ledger is None or name not in ledger.off)


def record_fact(kind: str, what: str, start: int, end: int) -> None:
    """Write a fact into the ledger, if one is kept, as decided by the rule at work.

    Args:
        kind: Kind of the fact.
        what: The fact.
        start: Offset where its words start.
        end: Offset where they end.
    """
    ledger = _KEPT.get()
    if ledger is not None:
        ledger.decide(Fact(kind, what, words=(start, end)))


def watch_facts(facts: Callable[[], Iterable[Fact]]) -> None:
    """Let the ledger, if one is kept, see what is decided."""
    ledger = _KEPT.get()
    if ledger is not None:
        ledger.facts = facts
