"""States that a story brings things to: open, off, broken, burning, spilled; and all states of a thing at one time."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import Final, Literal, NamedTuple, get_args

from pydantic import Field, model_validator

from storyblender.memory.base import Frozen
from storyblender.memory.vocabulary import ThingState

THING_STATES: Final[tuple[ThingState, ...]] = get_args(ThingState)
OFF_STATES: Final[frozenset[str]] = frozenset({"off", "unlit"})
ON_STATES: Final[frozenset[str]] = frozenset({"on", "lit", "burning"})
OF_LAMPS: Final[frozenset[str]] = (
    OFF_STATES | ON_STATES | {"running", "overflowing", "flickering", "dim", "smoking", "steaming"}
)
"""States of lamps, fires, taps and devices."""
LYING_STATES: Final[frozenset[str]] = frozenset({"tipped", "spilled"})
"""States in which a thing lies on its side."""
_EXCLUSIVE: Final[tuple[frozenset[str], ...]] = (
    frozenset({"open", "closed"}),
    OF_LAMPS,
    frozenset({"broken", "mended", "torn"}),
    LYING_STATES | {"upright"},
    frozenset({"full", "empty"}),
    frozenset({"wet", "dry", "dirty", "clean", "bloody"}),
    frozenset({"gone", "there"}),
)
"""States that exclude each other: a later one replaces an earlier one of the same set."""
_NAMED: Final[dict[str, ThingState]] = {
    **{state: state for state in THING_STATES if state != "lettered"},
    "shut": "closed", "locked": "closed", "ajar": "open", "out": "unlit", "dead": "off", "stopped": "off",
    "on fire": "burning", "in flames": "burning", "leaking": "running", "spraying": "running", "smashed": "broken",
    "shattered": "broken", "cracked": "broken", "fallen": "tipped", "overturned": "tipped", "toppled": "tipped",
    "knocked over": "tipped", "on its side": "tipped", "upturned": "tipped", "standing": "upright",
    "righted": "upright", "filled": "full", "emptied": "empty",
}  # fmt: skip
_LETTERED: Final = re.compile(r"reads (?P<writing>.+)", re.DOTALL)
_DOORS: Final = re.compile(r"(?P<doors>.+) door open|doors closed")


class StateValues(NamedTuple):
    """A state with what belongs to it.

    Attributes:
        state: Empty where it is unknown.
        writing: The words of a thing that is ``lettered``.
        doors: Names of the doors of a vehicle that is ``open``; no names for all that are open when it is ``closed``.
    """

    state: ThingState | Literal[""]
    writing: str = ""
    doors: tuple[str, ...] | None = None


def state_values(words: str) -> StateValues:
    """Return the state that words name.

    Args:
        words: A state or a synonym, also with more after a comma: ``on, a call comes in``; ``reads CLOSED`` for what
            is written on a thing; in projects of schema 5 and older ``driver door open`` and ``doors closed`` too.
    """
    if found := _LETTERED.fullmatch(words):
        return StateValues("lettered", found["writing"].strip())
    if found := _DOORS.fullmatch(words):
        doors = tuple((found["doors"] or "").split())
        return StateValues("open" if doors else "closed", doors=doors)
    return StateValues(_NAMED.get(words.lower().partition(",")[0].strip(), ""))


class Condition(Frozen):
    """All states of a thing at one time."""

    states: tuple[ThingState, ...] = ()
    """The oldest first; at most one of those that exclude each other."""
    writing: str = Field(default="", exclude_if=lambda value: not value)
    """Words on a thing that is ``lettered``."""
    doors: tuple[str, ...] | None = Field(default=None, exclude_if=lambda value: value is None)
    """Names of the open doors of a vehicle; None where nobody has used one."""

    @model_validator(mode="before")
    @classmethod
    def _from_words(cls, value: object) -> object:
        """Older projects have a list of words."""
        if not isinstance(value, list | tuple):
            return value
        condition = cls()
        for words in value:
            condition = condition.after(*state_values(str(words)))
        return condition.model_dump()

    def after(
        self, state: ThingState | Literal[""], writing: str = "", doors: tuple[str, ...] | None = None
    ) -> Condition:
        """Return the condition after a change.

        Args:
            state: The new state, which replaces those that it excludes; empty for no change.
            writing: The new words, where it is ``lettered``.
            doors: The doors of a vehicle that are open from now on.
        """
        if not state:
            return self
        excluded = next((each for each in _EXCLUSIVE if state in each), {state})
        update: dict[str, object] = {"states": (*(each for each in self.states if each not in excluded), state)}
        update |= {"writing": writing} if writing else {}
        return self.model_copy(update=update | ({"doors": doors} if doors is not None else {}))

    def only(self, states: Collection[str]) -> Condition:
        """Return the condition without all other states than these."""
        return self.model_copy(update={"states": tuple(each for each in self.states if each in states)})

    @property
    def labels(self) -> tuple[str, ...]:
        """The states in words that tell all conditions apart, for names and hashes."""
        doors = () if self.doors is None else ((" ".join(self.doors) or "no") + " door open",)
        return (*(f"reads {self.writing}" if each == "lettered" else each for each in self.states), *doors)
