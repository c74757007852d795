"""The words of a sentence read so far, while its verbs are told from its nouns."""

from __future__ import annotations

from dataclasses import dataclass, field

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import VerbForm
from storyblender.agents.director.reader.language.words import Word

_PASSED_OVER = lexicon.ADVERBS - {"there", "here"}


@dataclass
class Row:
    """The words so far."""

    words: list[Word] = field(default_factory=list)
    verb_seen: bool = False
    tail: list[Word] = field(default_factory=list)
    """``with a drum on her shoulder`` out of an apposition: it is told at the end."""
    last_kind: str = ""
    """``3sg``, ``base`` or ``inf``: the form of the last finite verb or bare infinitive."""

    def insert_subject(self, at: int) -> None:
        """Put in the elided subject."""
        self.words.append(Word("", at, at, inserted=True))

    def insert_was(self, at: int) -> None:
        """Put in the missing verb."""
        self.words.append(was(at))
        self.verb_seen = True

    def neighbour(self) -> Word | None:
        """The last word that is no adverb."""
        return next((word for word in reversed(self.words) if not is_adverb(word)), None)


def was(at: int) -> Word:
    """An inserted ``was``."""
    return Word("", at, at, verb=VerbForm("be", "aux"), inserted=True)


def is_adverb(word: Word) -> bool:
    """Whether a word only tells how or when: ``slowly``, ``again``."""
    adverb = (word.low.endswith("ly") and len(word.low) > 4) or word.low in _PASSED_OVER
    return adverb and word.mention is None
