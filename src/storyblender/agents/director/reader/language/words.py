"""Words with their place in the script, and the people they mention."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Literal

from storyblender.agents.director.reader.language.morphology import VerbForm
from storyblender.agents.director.reading import Person

MentionKind = Literal["name", "role", "generic", "group"]


EVERYBODY = 99
"""Number of ``everyone``, ``all of them``: whoever is there."""


@dataclass
class Mention:
    """A noun phrase that means somebody.

    ``name``: Nora Vance; ``role``: the waiter, who is one of the cast; ``generic``: the old woman, found by
    looking who is there; ``group``: the two men.
    """

    kind: MentionKind
    candidates: list[Person]
    head: str
    determiner: str = ""
    adjectives: list[str] = field(default_factory=list)
    number: int = 1
    start: int = 0
    """Offset of the determiner."""
    people: list[Person] = field(default_factory=list)
    """Who it is, once resolved."""
    recorded: bool = False


@dataclass
class Word:
    """One word of a sentence; a name of several words is one Word. Inserted words (elided subject, missing
    ``was``) have no characters."""

    text: str
    start: int
    end: int
    mention: Mention | None = None
    verb: VerbForm | None = None
    """Set where the word is a verb of a clause (see ``rewrite``)."""
    inserted: bool = False
    quotation: str = ""
    """Prose: the quoted speech this word stands for."""
    closes: bool = False
    """Prose: the quotation ends with a full stop, an exclamation or a question mark."""
    low: str = field(init=False)

    def __post_init__(self) -> None:
        self.low = self.text.lower()

    @property
    def named(self) -> bool:
        """Whether it is somebody of the cast by name or role."""
        return self.mention is not None and self.mention.kind in ("name", "role")

    @property
    def solid(self) -> bool:
        """Whether it is a word or a mention, not punctuation."""
        return self.mention is not None or self.text.isalnum()


_TOKEN = re.compile(r"[^\W\d_]+(?:[-'’][^\W\d_]+)*|#?\d+[\w%]*|\.{3}|--|[^\s]")
_CLITIC = re.compile(r"^(.+?)(n['’]t|['’](?:s|S|re|ve|ll|d|m))$")


def tokenize(text: str, offset: int) -> list[Word]:
    """Split text into words; ``'s`` and ``n't`` are words of their own.

    Args:
        text: Any piece of the script.
        offset: Characters of the script before it.
    """
    words: list[Word] = []
    for match in _TOKEN.finditer(text):
        token, start, end = match.group(0), offset + match.start(), offset + match.end()
        clitic = _CLITIC.match(token)
        if clitic:
            cut = start + len(clitic.group(1))
            words += [Word(clitic.group(1), start, cut), Word(clitic.group(2).replace("’", "'").lower(), cut, end)]
        elif token.endswith("'") and len(token) > 1:
            words += [Word(token[:-1], start, end - 1), Word("'s", end - 1, end)]
        else:
            words.append(Word(token, start, end))
    return words


def key_of(name: str) -> tuple[str, ...]:
    """A name as the lower-case words it is matched by."""
    return tuple(word.low for word in tokenize(name, 0))


def joined(words: list[Word]) -> str:
    """The written words in lower case, inserted ones left out, one space between."""
    return " ".join(word.low for word in words if not word.inserted)
