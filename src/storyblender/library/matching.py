"""Compares what a thing is called in the script with what entries of an asset source are called.

Words decide first, since a name is worth more than a likeness: the end of an English noun phrase says what a thing
is. Meaning decides where no word is known, and only when it is sure; MiniLM finds every thing a little like another.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.phrases import HEAPS, MODIFIERS, kept_words, thing_words
from storyblender.catalog.props.variants import TOY_WORDS, words_of
from storyblender.catalog.recipe import EXACT, HEAD, LEAST, AssetQuery
from storyblender.catalog.stand_ins import STAND_INS
from storyblender.ports import Embedder

Vectors = NDArray[np.float32]

TAG, ODD_HEAD = 9.5, 5.0
"""Scores: another name for the thing; its head noun made into something else."""
PER_LIKENESS = 12.0
"""Points lost from cosine 1 to cosine 0: cosine 0.75 just passes the threshold."""
UNEXPLAINED = 0.1
"""Points lost for each word of a phrase that a term leaves open: a round table is no long one."""
_WHOLE = 9.95
"""Score of a further name of several words that is the whole phrase: broken glass is no glass."""
_JOINTS = ("of", "on", "in")
_RESHAPING: frozenset[str] = frozenset(
    word for key in ("creature", "small_creature", "appliance", "craft") for word in STAND_INS[key].tags
) | frozenset(entry.name for entry in PROPS.values() if entry.category in ("animal", "vehicle"))
"""Words before a head that make another thing of it: a dragon statue, a robot dog, a toy car."""
_OTHERWISE_SHAPED = frozenset(("rocking", "surveillance", "snow", "sand"))
"""Words before a head noun that make it a thing the library has no likeness of."""
_OTHER_NUMBER = 0.01
"""Points lost by a name in another number than the word said: ``glasses`` are worn, two of them are to drink from."""
_NUMBERS = frozenset(("two", "three", "four", "five", "six", "several", "many", "empty", "full", "clean", "dirty"))


@dataclass(frozen=True)
class Term:
    """One name of an entry.

    Attributes:
        key: Of the entry.
        words: Lower-case.
        is_name: Whether it is the entry's own name and not a further one.
    """

    key: str
    words: tuple[str, ...]
    is_name: bool


@dataclass(frozen=True)
class Match:
    """An entry that fits a phrase.

    Attributes:
        key: Of the entry.
        score: 1 to 10.
        reason: Why it fits, for people.
        by_meaning: Whether its name only means nearly the same.
    """

    key: str
    score: float
    reason: str
    by_meaning: bool = False


class Likeness:
    """Finds entries whose names mean nearly the same as a phrase.

    Args:
        embedder: Loads the sentence model, the first time that a phrase is compared.
    """

    def __init__(self, embedder: Callable[[], Embedder]) -> None:
        self._load = embedder

    def with_likely(
        self, named: list[Match], query: AssetQuery, terms: tuple[Term, ...], vectors: Vectors | None = None
    ) -> list[Match]:
        """Return the matches by words and those by meaning, best first; what words found odd stays odd.

        Args:
            named: The matches by words.
            query: The thing; its phrase and its description are compared.
            terms: Names of the entries that it may be.
            vectors: Of the terms, (n, d), where they are known.
        """
        odd = {match.key for match in named}
        likely = self._by_meaning(query.phrase, query.asset.description, terms, vectors) if terms else []
        return best_of(named + [match for match in likely if match.key not in odd])

    def _by_meaning(
        self, phrase: str, description: str, terms: tuple[Term, ...], vectors: Vectors | None
    ) -> list[Match]:
        """Return entries by cosine with any of their names; a term that shares a modifier does not count."""
        words = kept_words(words_of(phrase)) or words_of(phrase)
        if not words:
            return []
        query = self._model.embed([" ".join(words), description or " ".join(words)])
        if vectors is None:
            vectors = self._model.embed([" ".join(term.words) for term in terms])
        likeness = vectors @ query[0] + 0.02 * (vectors @ query[1])
        best: dict[str, Match] = {}
        for index in np.argsort(-likeness, kind="stable")[:40]:
            term = terms[int(index)]
            shared = set(term.words) & set(words[:-1])
            if shared or words[-1] in term.words or _begins_alike(words[-1], term.words[-1]):
                continue
            cosine = float(likeness[index])
            score = max(LEAST, min(EXACT, 10.0 - PER_LIKENESS * (1.0 - cosine)))
            found = Match(term.key, score, f"means nearly {' '.join(term.words)!r} ({cosine:.2f})", by_meaning=True)
            best.setdefault(term.key, found)
        return list(best.values())

    @cached_property
    def _model(self) -> Embedder:
        return self._load()


def by_words(phrase: str, terms: tuple[Term, ...]) -> list[Match]:
    """Return matches of whole phrases and of their ends, best first, longer ends before shorter ones.

    Args:
        phrase: What the script calls the thing, head noun last.
        terms: Names of the entries that it may be.
    """
    full = [noun_key(word) for word in words_of(phrase)]
    bare = [noun_key(word) for word in kept_words(words_of(phrase))]
    found: list[tuple[float, int, Match]] = []
    said = words_of(phrase)
    counted = bool(_NUMBERS & {*said}) or ("of" in said[1:] and said[said.index("of", 1) - 1] not in HEAPS)
    for term in terms:
        name = tuple(noun_key(word) for word in term.words)
        score, length = _fit(name, full, bare, term.is_name)
        if score > 0:
            score -= _OTHER_NUMBER * ((said[-1] == term.words[-1]) is counted)
            found.append((score, length, Match(term.key, score, f"is called {' '.join(term.words)!r}")))
    found.sort(key=lambda item: (-item[1], -item[0]))
    return best_of([match for _, _, match in found])


def _fit(name: tuple[str, ...], full: list[str], bare: list[str], is_name: bool) -> tuple[float, int]:
    """Return the score of one term for the words of a phrase, and how many of them it explains."""
    if not name:
        return 0.0, 0
    exact = EXACT if is_name else TAG
    if name == tuple(full):
        return max(exact, _WHOLE) if len(name) > 1 else exact, 9
    if len(name) > 2 and tuple(full[-len(name) :]) == name and {*_JOINTS} & {*name}:
        return exact - UNEXPLAINED * (len(full) - len(name)), len(name)
    if name == tuple(bare):
        return exact - UNEXPLAINED * (len(full) - len(name)), 9
    for words in (thing_words(full), thing_words(bare)):
        if len(words) >= len(name) and tuple(words[-len(name) :]) == name:
            rest = [word for word in words[: -len(name)] if word not in MODIFIERS | TOY_WORDS]
            odd = any(word in _RESHAPING or word in _OTHERWISE_SHAPED for word in rest)
            plain = exact - 0.7 * (len(words) < len(full)) if not rest else HEAD + (0.3 if is_name else 0.0)
            return (ODD_HEAD if odd else plain - UNEXPLAINED * (len(words) - len(name))), len(name)
    return 0.0, 0


def _begins_alike(word: str, other: str) -> bool:
    """Tell whether one word only begins like another, which the model takes for likeness: hatch and hatchet."""
    short, long = sorted((noun_key(word), noun_key(other)), key=len)
    return short != long and long.startswith(short)


def best_of(matches: list[Match]) -> list[Match]:
    """Keep the first match of each key and order by score, equal ones as they came."""
    best: dict[str, Match] = {}
    for match in matches:
        if match.key not in best or match.score > best[match.key].score:
            best[match.key] = match
    return sorted(best.values(), key=lambda match: -match.score)
