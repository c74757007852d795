"""Words with their offsets in the script and the people they mention, a row of words being tagged, and a word index."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import VerbForm
from storyblender.agents.director.reading import Person

MentionKind = Literal["name", "role", "generic", "group"]


EVERYBODY = 99
"""Number of ``everyone``, ``all of them``: the people present."""


@dataclass
class Mention:
    """A noun phrase that means a person or a group."""

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
    """One word of a sentence. A name of several words is one Word; an inserted word has no characters."""

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
        """Whether it is a member of the cast, by name or role."""
        return self.mention is not None and self.mention.kind in ("name", "role")

    @property
    def solid(self) -> bool:
        """Whether it is a word or a mention and no punctuation."""
        return self.mention is not None or self.text.isalnum()


_TOKEN = re.compile(r"[^\W\d_]+(?:[-'’][^\W\d_]+)*|#?\d+[\w%]*|\.{3}|--|[^\s]")
_CLITIC = re.compile(r"^(.+?)(n['’]t|['’](?:s|S|re|ve|ll|d|m))$")


def tokenize(text: str, offset: int) -> list[Word]:
    """Return the words of a text; ``'s`` and ``n't`` are words of their own.

    Args:
        text: The text.
        offset: Offset of the text in the script.
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
    """Return a name as the lower-case words by which it is matched."""
    return tuple(word.low for word in tokenize(name, 0))


def joined(words: list[Word]) -> str:
    """Return the written words in lower case, with one space between; inserted words are left out."""
    return " ".join(word.low for word in words if not word.inserted)


_PASSED_OVER = lexicon.ADVERBS - {"there", "here"}


@dataclass
class TaggedRow:
    """The words of a sentence read so far, tagged as verbs and nouns."""

    words: list[Word] = field(default_factory=list)
    verb_seen: bool = False
    tail: list[Word] = field(default_factory=list)
    """``with a drum on her shoulder`` out of an apposition: it comes at the end of the sentence."""
    last_kind: str = ""
    """``3sg``, ``base`` or ``inf``: the form of the last finite verb or bare infinitive."""

    def insert_subject(self, at: int) -> None:
        """Insert the elided subject at an index."""
        self.words.append(Word("", at, at, inserted=True))

    def insert_was(self, at: int) -> None:
        """Insert the missing ``was`` at an index."""
        self.words.append(inserted_was(at))
        self.verb_seen = True

    def neighbour(self) -> Word | None:
        """The last word that is no adverb, or None."""
        return next((word for word in reversed(self.words) if not is_adverb(word)), None)


def inserted_was(at: int) -> Word:
    """Return an inserted ``was`` at an offset."""
    return Word("", at, at, verb=VerbForm("be", "aux"), inserted=True)


def is_adverb(word: Word) -> bool:
    """Whether a word only tells how or when: ``slowly``, ``again``."""
    adverb = (word.low.endswith("ly") and len(word.low) > 4) or word.low in _PASSED_OVER
    return adverb and word.mention is None


_WORD = re.compile(r"\w+")


class TextIndex:
    """The offsets of all words of a text, for quick look-up of names.

    Args:
        text: Any text.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self._starts: dict[str, list[int]] = {}
        for word in _WORD.finditer(text):
            self._starts.setdefault(word[0].lower(), []).append(word.start())

    def places(self, phrase: str) -> Iterator[int]:
        """Yield the offsets at which a phrase stands as a whole, in the same capitals.

        Args:
            phrase: Starts and ends with a letter, a digit or ``_``.
        """
        first = _WORD.match(phrase)
        for at in self._starts.get(first[0].lower(), ()) if first else ():
            end = at + len(phrase)
            if self.text.startswith(phrase, at) and not _WORD.match(self.text, end):
                yield at
