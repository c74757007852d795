"""The built-in library as an asset source: finds its props for the things of a script."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.kinds import near_kind
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.phrases import kept_words, noun_words
from storyblender.catalog.props.variants import read_variant, words_of
from storyblender.catalog.recipe import EXACT, HEAD, AssetQuery, Recipe
from storyblender.folder import Folder
from storyblender.library.matching import UNEXPLAINED, Likeness, Match, Term, by_words
from storyblender.ports import Embedder

_SERVED = frozenset(("turkey", "chicken", "lobster", "crab", "prawn", "prawns", "lamb", "crayfish"))
"""Animals that mean a dish when the script lists them among its things."""


class BuiltInLibrary:
    """The props of ``catalog.props``; builders make them, so there is nothing to fetch or to credit.

    Args:
        embedder: Loads the sentence model.
    """

    name = "built_in"

    def __init__(self, embedder: Callable[[], Embedder]) -> None:
        self._likeness = Likeness(embedder)

    def search(self, query: AssetQuery, *, by_meaning: bool = False) -> Sequence[Recipe]:
        """Return the props that fit, best first, each in the colour, material and state that the script gives."""
        phrase, terms = query.phrase, _suitable_terms(query)
        matches = by_words(phrase, terms) or by_words(phrase, CATALOG_TERMS)
        if by_meaning and near_kind(noun_words(phrase)) is None:
            matches = self._likeness.with_likely(matches, query, terms)
        if query.kind == "prop" and noun_words(phrase)[-1:] and noun_words(phrase)[-1] in _SERVED:
            matches = [Match("plate", EXACT, "it is a thing, and no animal: it is served"), *matches]
        return [
            Recipe(
                source="catalog",
                key=(key := _meant(match, phrase, query.means)),
                params=read_variant(PROPS[key], query.told),
                score=match.score,
                reason=match.reason,
                by_meaning=match.by_meaning,
            )
            for match in matches
        ]

    def inventory(self) -> Mapping[str, str]:
        """Return nothing: the library is the same for every run of a version."""
        return {}

    def fetch(self, recipe: Recipe, files: Folder) -> Recipe:
        """Return the recipe: the engine builds it without a file."""
        return recipe


def _terms() -> Iterator[Term]:
    for entry in PROPS.values():
        yield Term(entry.key, tuple(words_of(entry.name)), True)
        for tag in entry.tags:
            yield Term(entry.key, tuple(words_of(tag)), False)


CATALOG_TERMS: tuple[Term, ...] = tuple(_terms())


@cache
def _terms_of(category: str) -> tuple[Term, ...]:
    return tuple(term for term in CATALOG_TERMS if PROPS[term.key].category == category)


def _suitable_terms(query: AssetQuery) -> tuple[Term, ...]:
    """Return the library names a thing may mean: for an animal or a vehicle only animals or vehicles."""
    kind = query.kind
    return _terms_of(kind) if kind in ("animal", "vehicle") else CATALOG_TERMS


def _meant(match: Match, phrase: str, means: Mapping[str, str]) -> str:
    """Return the prop that a match means in its place, by the plain word or by what that usually is."""
    if match.score < HEAD - 2 * UNEXPLAINED:
        return match.key
    plain = [noun_key(word) for word in kept_words(words_of(phrase))]
    called = len(plain) > 1 and any(" ".join(plain) in (each.name, *each.tags) for each in PROPS.values())
    word = plain[-1] if plain and not called else ""
    return means.get(word) or means.get(match.key, match.key)
