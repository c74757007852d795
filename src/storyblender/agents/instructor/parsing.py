"""Reads a sentence as phrases that cover it: a word belongs to a phrase that is understood, adds nothing, or is left.

What is left is told to the person, and nothing is done; so no wish is ever fulfilled in part.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Final, Generic, TypeVar

from storyblender.memory.edits import (
    ApproveEdit,
    CameraEdit,
    DurationEdit,
    Edit,
    FormatEdit,
    JoinEdit,
    LightEdit,
    LockEdit,
    NoteEdit,
    OmitEdit,
    ReorderEdit,
    RestoreEdit,
    SetEdit,
    SplitEdit,
    TakeEdit,
    UnlockEdit,
)

_SENTENCES: Final = re.compile(r"\s*(?:;|!|\?|\.(?=\s|$)|\bthen\b)\s*", re.IGNORECASE)
_TOKEN: Final = re.compile(r",(?!\d)|(?:[^\s,]|,(?=\d))+")
ARTICLES: Final = frozenset({"the", "a", "an", "this", "that", "it", "its"})
_FILLERS: Final = frozenset((
    *ARTICLES, ",", "and", "but", "also", "please", "now", "here", "try", "get", "go", "make", "have", "want", "be",
    "is", "it's", "do", "with", "use", "just", "instead", "maybe", "perhaps", "slightly", "somewhat", "camera", "shot",
    "scene", "picture", "frame", "panel", "make it", "make this", "can you", "can we", "could you", "could we",
    "would you", "will you", "shall we", "i want", "we want", "i need", "we need", "i would like", "we would like",
    "i'd like", "we'd like", "i think", "let's", "let us", "let me", "give me", "give us", "it should be", "should be",
    "needs to be", "to be", "a bit", "a little", "a little bit", "a touch", "a tad", "for me",
))  # fmt: skip
"""Words that add nothing to a wish."""
_JOINTS: Final = frozenset((",", "and", "but"))
"""Words between the clauses of a sentence."""
_COMMANDS: Final = (
    ApproveEdit, JoinEdit, LockEdit, NoteEdit, OmitEdit, ReorderEdit, RestoreEdit, SplitEdit, TakeEdit, UnlockEdit,
)  # fmt: skip
_NEGATED: Final = re.compile(r"(?:no|not|don't|do not|never|stop|without)\b(?! (?:so|as|that) )")
"""Begins what is not wanted; with more behind it, it would not be clear how far it goes."""
_UNKNOWN: Final = 3
"""How much worse a word is that is not known than one of a wish that is known and cannot be."""
_LONGEST, _MOST = 16, 80
"""Words of a phrase and of a sentence; what is longer is not understood."""


@dataclass(frozen=True)
class Phrase:
    """Words that were understood, or recognised as what cannot be.

    Attributes:
        words: As they were said.
        edits: What they mean.
        problem: Why they cannot be done, in one sentence; empty if they can.
    """

    words: str
    edits: tuple[Edit, ...] = ()
    problem: str = ""

    @property
    def stands_alone(self) -> bool:
        """Whether it counts only where nothing else is said in its clause: ``keep``, not ``keep it wide``."""
        plain = len(self.words.split()) == 1
        return _NEGATED.match(self.words) is not None or any(
            isinstance(edit, _COMMANDS)
            or (isinstance(edit, DurationEdit) and not re.search(r"\d|\bs(?:ec|econds?)?\b", self.words))
            or (isinstance(edit, LightEdit) and edit.decision.qualities is not None and plain)
            for edit in self.edits
        )


Meaning = TypeVar("Meaning")


class Table(Generic[Meaning]):
    """Patterns and what each means; they are compiled when the first words are looked up.

    Args:
        rows: A pattern and its meaning; the alternatives of a pattern may have groups of the same name.
    """

    def __init__(self, *rows: tuple[str, Meaning]) -> None:
        self._rows = rows

    @cached_property
    def _compiled(self) -> list[tuple[re.Pattern[str], Meaning]]:
        return [(re.compile(each), meaning) for pattern, meaning in self._rows for each in _alternatives(pattern)]

    def look_up(self, words: str) -> tuple[re.Match[str], Meaning] | None:
        """Return the first pattern that all of the words fit, as its match, and what it means."""
        found = ((pattern.fullmatch(words), meaning) for pattern, meaning in self._compiled)
        return next(((match, meaning) for match, meaning in found if match is not None), None)


def _alternatives(pattern: str) -> list[str]:
    """Return the alternatives of a pattern outside of its brackets."""
    found, depth, start = list[str](), 0, 0
    for at, letter in enumerate(pattern):
        depth += (letter == "(") - (letter == ")")
        if letter == "|" and not depth:
            found.append(pattern[start:at])
            start = at + 1
    return [*found, pattern[start:]]


Reader = Callable[[str], Phrase | None]
"""Reads words in lower case; None where it does not know them as one phrase."""
_Cost = tuple[int, int, int]


def read_sentences(said: str, read: Reader) -> tuple[list[Edit], list[str]]:
    """Return the edits that words mean, and what of them is not understood or cannot be.

    Args:
        said: By a person.
        read: Knows a phrase.
    """
    phrases: list[Phrase] = []
    unclear: list[str] = []
    for sentence in filter(None, _SENTENCES.split(said.replace("’", "'"))):
        understood, left = _covered(_TOKEN.findall(sentence), read)
        phrases += understood
        unclear += left
    unclear += [phrase.problem for phrase in phrases if phrase.problem]
    edits = [edit for phrase in phrases for edit in phrase.edits]
    if not edits and not unclear:
        unclear.append(said)
    return edits, [*unclear, *_contradictions(phrases)]


def _covered(tokens: Sequence[str], read: Reader) -> tuple[list[Phrase], list[str]]:
    """Return the phrases that cover a sentence best, and the words outside of them, as they were said.

    Best is: the fewest words that cannot be followed, then the fewest that are not known, then the fewest
    phrases, the longest first.
    """
    if len(tokens) > _MOST:
        return [], [" ".join(tokens[:8]) + " ..."]
    low = [token.lower() for token in tokens]
    best: list[tuple[_Cost, int, Phrase | None]] = [((0, 0, 0), 0, None)] * (len(tokens) + 1)
    for start in range(len(tokens) - 1, -1, -1):
        rest = best[start + 1][0]
        options: list[tuple[_Cost, int, Phrase | None]] = [
            ((rest[0] + _UNKNOWN, rest[1] + 1, rest[2]), start + 1, None)
        ]
        for end in range(start + 1, min(start + _LONGEST, len(tokens)) + 1):
            words, (lost, strange, count) = " ".join(low[start:end]), best[end][0]
            if words in _FILLERS:
                options.append(((lost, strange, count + 1), end, Phrase(words)))
            phrase = read(words) if "," not in (low[start], low[end - 1]) else None
            if phrase is not None and (not phrase.stands_alone or _is_clause(low, start, end)):
                lost += sum(word not in _FILLERS for word in low[start:end]) if phrase.problem else 0
                options.append(((lost, strange, count + 1), end, phrase))
        best[start] = min(options, key=lambda option: (option[0], -option[1]))
    phrases: list[Phrase] = []
    left: list[list[str]] = []
    at, open_run = 0, False
    while at < len(tokens):
        _, end, phrase = best[at]
        if phrase is None:
            articles = tokens[at - 1 : at] if at and low[at - 1] in ARTICLES and not open_run else []
            left = left if open_run else [*left, list(articles)]
            left[-1] += tokens[at:end]
        elif phrase.edits or phrase.problem:
            phrases.append(phrase)
        elif open_run and phrase.words != ",":
            left[-1] += tokens[at:end]
        open_run = phrase is None or (open_run and not phrase.edits and not phrase.problem and phrase.words != ",")
        at = end
    return phrases, [" ".join(run) for run in left]


def _is_clause(words: Sequence[str], start: int, end: int) -> bool:
    """Return whether words are a whole clause, but for words that add nothing."""
    before = next((at + 1 for at in range(start - 1, -1, -1) if words[at] in _JOINTS), 0)
    after = next((at for at in range(end, len(words)) if words[at] in _JOINTS), len(words))
    return all(word in _FILLERS for word in (*words[before:start], *words[end:after]))


def _contradictions(phrases: Sequence[Phrase]) -> list[str]:
    """Return which phrases decide the same thing differently."""
    decided: dict[tuple[str, str], tuple[object, str]] = {}
    found: dict[str, None] = {}
    for phrase in phrases:
        for edit in phrase.edits:
            for place, value in _decisions(edit).items():
                before, words = decided.setdefault(place, (value, phrase.words))
                if before != value:
                    found[f"{words!r} and {phrase.words!r} contradict each other"] = None
    return list(found)


def _decisions(edit: Edit) -> Mapping[tuple[str, str], object]:
    """Return the value of each field that an edit decides, by what it is about and the field."""
    match edit:
        case CameraEdit():
            return {(edit.shot, name): value for name, value in edit.decision if value is not None}
        case LightEdit() | SetEdit():
            return {(edit.scene, name): value for name, value in edit.decision if value not in (None, {})}
        case DurationEdit():
            return {(edit.shot, "seconds"): edit.seconds}
        case FormatEdit():
            return {("film", name): value for name, value in edit.decision.told.items()}
        case _:
            return {}
