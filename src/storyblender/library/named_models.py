"""Models that people named: a phrase of the script finds them by the words of their names."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import PurePath

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props.phrases import MODIFIERS, kept_words, noun_words
from storyblender.catalog.props.variants import TOY_WORDS, words_of
from storyblender.catalog.recipe import EXACT
from storyblender.library.file_names import words_of_file
from storyblender.library.matching import Match, Term, best_of, by_words


def terms_of(names: Iterable[tuple[str, str]]) -> tuple[Term, ...]:
    """Return what models are called: all words of the name, those that describe it, and the folders' words.

    Args:
        names: Key and name of each model, the name as of a file, with its folders if it has any.
    """
    terms: list[Term] = []
    for key, name in names:
        own, described = words_of(PurePath(name).stem), list(words_of_file(name).words)
        folders = words_of(PurePath(name).parent.as_posix())
        called = (own, described, kept_words(described), kept_words([*folders, *described]))
        terms += [Term(key, tuple(words), True) for words in called if words]
    return tuple(dict.fromkeys(terms))


def named(phrase: str, models: Iterable[tuple[str, str, int]], terms: tuple[Term, ...]) -> list[Match]:
    """Return the models that a phrase names, best first.

    A model whose name has the thing's noun and explains the words before it is the thing itself, in whatever order the
    name has them; of several the one comes first that shares most words with the phrase and has fewest others.

    Args:
        phrase: What the script calls the thing.
        models: Key, name and rank of each; of equal ones the lower rank comes first.
        terms: Of the same models.
    """
    said = {noun_key(word) for word in words_of(phrase)}
    thing = [noun_key(word) for word in noun_words(phrase)]
    meant: list[tuple[int, int, int, str, str]] = []
    for key, name, rank in models:
        called = words_of_file(name)
        own = {noun_key(word) for word in called.words}
        unexplained = [word for word in thing[:-1] if word not in own | MODIFIERS | TOY_WORDS]
        if thing and noun_key(called.noun) == thing[-1] and not unexplained:
            meant.append((-len(own & said), len(own - said), rank, name, key))
    matches = [Match(key, EXACT, f"its name has the noun {thing[-1]!r}") for *_, key in sorted(meant)]
    return best_of(matches + by_words(phrase, terms))


def words_told(name: str) -> set[str]:
    """Return the words of a name or a phrase as an index has them: in the singular, and as read in a file's name."""
    return {noun_key(word) for word in (*words_of(name), *words_of_file(name).words)}
