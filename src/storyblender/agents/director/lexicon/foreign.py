"""Word tables for German, Spanish, French and Italian: verbs, common things, people, function words."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from typing import cast

from storyblender.memory.vocabulary import Gender, RelationKind

_WORD = re.compile(r"[^\W\d_]+")
_SHARE = 0.14
"""Least share of function words of a language on a page written in it."""
_ENOUGH = 30
"""Least number of words for detecting the language of a page."""


_NAMES = {"de": "German", "es": "Spanish", "fr": "French", "it": "Italian"}


@dataclass
class Tongue:
    """One language.

    Attributes:
        key: ``de``, ``es``, ``fr``, ``it``.
        name: In English.
        verbs: Verb form -> pairs of its companion word (a particle, a noun) and the motion, longest first.
        things: Noun -> English noun.
        people: Noun -> English noun.
        places: Preposition -> relation.
        pronouns: Word -> gender; ``unknown`` for plurals.
        links: Words and punctuation that begin another clause.
        small: Function words for detecting the language.
        articles: Articles and possessives.
    """

    key: str
    name: str
    verbs: dict[str, list[tuple[tuple[str, ...], str]]] = field(default_factory=dict)
    things: dict[str, str] = field(default_factory=dict)
    people: dict[str, str] = field(default_factory=dict)
    places: dict[str, RelationKind] = field(default_factory=dict)
    pronouns: dict[str, Gender] = field(default_factory=dict)
    links: frozenset[str] = frozenset()
    small: frozenset[str] = frozenset()
    articles: frozenset[str] = frozenset()


def _rows(name: str) -> list[tuple[str, str, list[str]]]:
    """Return language, kind and words of each row of a file."""
    text = files(__package__ or "").joinpath(name).read_text(encoding="utf-8")
    rows = [line.split("\t") for line in text.splitlines() if line and not line.startswith("#")]
    return [(*cast(tuple[str, str], tuple(key.split(" "))), words.split(" ")) for key, words in rows]


@cache
def tongues() -> dict[str, Tongue]:
    """Return the languages by key."""
    known: dict[str, Tongue] = {}
    for key, kind, words in _rows("foreign_words.tsv"):
        _take(known.setdefault(key, Tongue(key, _NAMES[key])), kind, words)
    for key, motion, forms in _rows("foreign_verbs.tsv"):
        for form in forms:
            verb, *others = form.split("+")
            known[key].verbs.setdefault(verb, []).append((tuple(others), motion))
    for tongue in known.values():
        for meanings in tongue.verbs.values():
            meanings.sort(key=lambda meaning: -len(meaning[0]))
    return known


def _take(tongue: Tongue, kind: str, words: list[str]) -> None:
    """Add one row of words to the table of its kind."""
    pairs = dict(word.replace("_", " ").split("=", 1) for word in words if "=" in word)
    if kind == "thing":
        tongue.things |= pairs
    elif kind == "person":
        tongue.people |= pairs
    elif kind == "place":
        tongue.places |= {word: cast(RelationKind, kind.replace(" ", "_")) for word, kind in pairs.items()}
    elif kind in ("male", "female", "both"):
        gender: Gender = "unknown" if kind == "both" else kind
        tongue.pronouns |= dict.fromkeys(words, gender)
    elif kind == "link":
        tongue.links |= frozenset(words)
    elif kind == "article":
        tongue.articles |= frozenset(words)
    else:
        tongue.small |= frozenset(words)


def tongue_of(text: str) -> Tongue | None:
    """The language a text is written in, or None for English and any other.

    Args:
        text: Action lines, in upper or lower case.
    """
    words = [word.lower() for word in _WORD.findall(text)]
    if len(words) < _ENOUGH:
        return None
    shares = {key: sum(word in tongue.small for word in words) / len(words) for key, tongue in tongues().items()}
    best = max(sorted(shares), key=lambda key: shares[key])
    english = sum(word in _ENGLISH for word in words) / len(words)
    return tongues()[best] if shares[best] > max(_SHARE, english) else None


_ENGLISH = frozenset(
    {"the", "and", "of", "to", "is", "with", "his", "her", "at", "on", "it", "he", "she", "they", "from"}
)
