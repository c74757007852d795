"""The Asset Retriever: finds the library's entry for a thing by its words and by likeness of meaning.

Words decide first, since a name is worth more than a likeness: the end of an English noun phrase says what a thing
is. Meaning decides where no word is known, and only when it is sure; MiniLM finds every thing a little like another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import PurePath

import numpy as np

from storyblender.agents.concept_artist.file_names import words_of_file
from storyblender.agents.concept_artist.recipe import AssetRetrieverView, ModelFile, Recipe
from storyblender.catalog.kinds import near_kind
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.variants import COLORS, MATERIALS, PLAIN, TOY_WORDS, read_variant, singular, words_of
from storyblender.catalog.stand_ins import STAND_INS
from storyblender.ports import Embedder
from storyblender.reflection import Critique

EXACT, TAG, HEAD, ODD_HEAD = 10.0, 9.5, 8.5, 5.0
"""Scores: the name itself, another name for it, its head noun, its head noun made into something else."""
PER_LIKENESS = 12.0
"""Points lost from cosine 1 to cosine 0: cosine 0.75 just passes the threshold."""
LEAST = 1.0
_WHOLE = 9.95
"""Score of a further name of several words that is the whole phrase: broken glass is no glass."""
_JOINTS = ("of", "on", "in")

_RESHAPING: frozenset[str] = frozenset(
    word for key in ("creature", "small_creature", "appliance", "craft") for word in STAND_INS[key].tags
) | frozenset(entry.name for entry in PROPS.values() if entry.category in ("animal", "vehicle"))
"""Words before a head that make another thing of it: a dragon statue, a robot dog, a toy car."""
_OTHERWISE_SHAPED = frozenset(("rocking", "surveillance", "snow", "sand"))
"""Words before a head of which nobody built the likeness."""
_UNEXPLAINED = 0.1
"""Points lost for each word of a phrase that a term leaves open: a round table is no long one."""
_OTHER_NUMBER = 0.01
"""Points lost by a name in another number than the word said: ``glasses`` are worn, two of them are to drink from."""
_NUMBERS = frozenset(("two", "three", "four", "five", "six", "several", "many", "empty", "full", "clean", "dirty"))
_HEAPS: frozenset[str] = frozenset(
    (
        "pile",
        "heap",
        "stack",
        "bunch",
        "pair",
        "piece",
        "set",
        "row",
        "bundle",
        "roll",
        "handful",
        "wad",
        "sheaf",
        "belt",
        "field",
        "ring",
        "shower",
        "swarm",
        "wall",
        "hail",
        "cloud",
    )
)
"""Words whose ``of`` names the thing: a pile of money, but a bottle of milk."""
_SERVED = frozenset(("turkey", "chicken", "lobster", "crab", "prawn", "prawns", "lamb", "crayfish"))
"""Animals that mean a dish when the script lists them among its things."""
_MODIFIERS: frozenset[str] = PLAIN | COLORS.keys() | MATERIALS.keys()


@dataclass(frozen=True)
class _Term:
    key: str
    words: tuple[str, ...]
    is_name: bool


@dataclass(frozen=True)
class _Match:
    key: str
    score: float
    reason: str


class RulesAssetRetriever:
    """The policy that searches the built-in catalog and the user's folder of models.

    Args:
        embedder: Likeness of meaning; loaded when the first thing is not found by its words.
    """

    def __init__(self, embedder: Callable[[], Embedder]) -> None:
        self._load = embedder
        self._known: dict[tuple[_Term, ...], np.ndarray] = {}

    def propose(self, view: AssetRetrieverView) -> Recipe:
        """Return the best match, whatever its score; files win against entries that fit no better."""
        return self.search(view, 1)[0]

    def refine(self, draft: Recipe, critique: Critique, view: AssetRetrieverView) -> Recipe:
        """Return the next best match after ``draft``; the catalog does not grow by asking again."""
        ranked = self.search(view, 6)
        place = next((i for i, recipe in enumerate(ranked) if recipe.key == draft.key), -1)
        return ranked[min(place + 1, len(ranked) - 1)]

    def search(self, view: AssetRetrieverView, count: int) -> tuple[Recipe, ...]:
        """Return the ``count`` best matches, best first."""
        phrase, theirs = view.phrase, _model_terms(view.models)
        matches, models = (
            _by_words(phrase, _suitable_terms(view)) or _by_words(phrase, CATALOG_TERMS),
            _models_by_words(phrase, view.models, theirs),
        )
        if all(match.score < HEAD for match in matches + models):
            if near_kind(noun_words(phrase)) is None:
                matches = self._with_likely(matches, view, _suitable_terms(view))
            models = self._with_likely(models, view, theirs)
        contents = {model.path: model.content for model in view.models}
        if next(iter(view.asset.tags), "") == "prop" and noun_words(phrase)[-1:] and noun_words(phrase)[-1] in _SERVED:
            matches = [_Match("plate", EXACT, "it is a thing, and no animal: it is served"), *matches]
        files = [
            Recipe(
                source="file",
                key=match.key,
                params={"content": contents[match.key]},
                score=match.score,
                reason=match.reason,
            )
            for match in models
        ]
        entries = [
            Recipe(
                source="catalog",
                key=(key := _meant(match, phrase, view.means)),
                params=read_variant(PROPS[key], view.told),
                score=match.score,
                reason=match.reason,
            )
            for match in matches
        ]
        ranked = sorted(files + entries, key=lambda recipe: -recipe.score)
        nothing = Recipe(source="catalog", key="gift", score=LEAST, reason="nothing is like it")
        return tuple(ranked[:count]) or (nothing,)

    def _with_likely(self, named: list[_Match], view: AssetRetrieverView, terms: tuple[_Term, ...]) -> list[_Match]:
        """Return what words found and what means nearly the same; what words found odd stays odd."""
        odd = {match.key for match in named}
        likely = self._by_meaning(view.phrase, view.asset.description, terms) if terms else []
        return _best_of(named + [match for match in likely if match.key not in odd])

    def _by_meaning(self, phrase: str, description: str, terms: tuple[_Term, ...]) -> list[_Match]:
        """Return entries by cosine with any of their names; a term that shares a modifier does not count."""
        words = _kept(words_of(phrase)) or words_of(phrase)
        if not words:
            return []
        query = self._model.embed([" ".join(words), description or " ".join(words)])
        vectors = self._vectors(terms)
        likeness = vectors @ query[0] + 0.02 * (vectors @ query[1])
        best: dict[str, _Match] = {}
        for index in np.argsort(-likeness, kind="stable")[:40]:
            term = terms[int(index)]
            shared = set(term.words) & set(words[:-1])
            if shared or words[-1] in term.words or _lookalike(words[-1], term.words[-1]):
                continue
            cosine = float(likeness[index])
            score = max(LEAST, min(EXACT, 10.0 - PER_LIKENESS * (1.0 - cosine)))
            found = _Match(term.key, score, f"means nearly {' '.join(term.words)!r} ({cosine:.2f})")
            best.setdefault(term.key, found)
        return list(best.values())

    def _vectors(self, terms: tuple[_Term, ...]) -> np.ndarray:
        if terms not in self._known:
            self._known[terms] = self._model.embed([" ".join(term.words) for term in terms])
        return self._known[terms]

    @cached_property
    def _model(self) -> Embedder:
        return self._load()


def _terms() -> Iterator[_Term]:
    for entry in PROPS.values():
        yield _Term(entry.key, tuple(words_of(entry.name)), True)
        for tag in entry.tags:
            yield _Term(entry.key, tuple(words_of(tag)), False)


CATALOG_TERMS: tuple[_Term, ...] = tuple(_terms())


@cache
def _terms_of(category: str) -> tuple[_Term, ...]:
    return tuple(term for term in CATALOG_TERMS if PROPS[term.key].category == category)


def _suitable_terms(view: AssetRetrieverView) -> tuple[_Term, ...]:
    """Return the library names a thing may mean: for an animal or a vehicle only animals or vehicles."""
    kind = next(iter(view.asset.tags), "")
    return _terms_of(kind) if kind in ("animal", "vehicle") else CATALOG_TERMS


def noun_words(phrase: str) -> list[str]:
    """Return the words of a phrase that name the thing, its head last, without colours, sizes and materials."""
    return _thing(_kept(words_of(phrase)))


def _kept(words: list[str]) -> list[str]:
    """Return the words that say what the thing is, cut before ``of``, ``with``, ``on`` ... phrases."""
    for stop in ("with", "on", "in", "from", "for", "at", "by"):
        if stop in words[1:]:
            words = words[: words.index(stop, 1)]
    return [word for word in words[:-1] if word not in _MODIFIERS] + words[-1:]


def _by_words(phrase: str, terms: tuple[_Term, ...]) -> list[_Match]:
    """Return matches of whole phrases and of their ends, best first, longer ends before shorter ones."""
    full = [singular(word) for word in words_of(phrase)]
    bare = [singular(word) for word in _kept(words_of(phrase))]
    found: list[tuple[float, int, _Match]] = []
    said = words_of(phrase)
    counted = bool(_NUMBERS & {*said}) or ("of" in said[1:] and said[said.index("of", 1) - 1] not in _HEAPS)
    for term in terms:
        name = tuple(singular(word) for word in term.words)
        score, length = _fit(name, full, bare, term.is_name)
        if score > 0:
            score -= _OTHER_NUMBER * ((said[-1] == term.words[-1]) is counted)
            found.append((score, length, _Match(term.key, score, f"is called {' '.join(term.words)!r}")))
    found.sort(key=lambda item: (-item[1], -item[0]))
    return _best_of([match for _, _, match in found])


def _fit(name: tuple[str, ...], full: list[str], bare: list[str], is_name: bool) -> tuple[float, int]:
    """Return the score of one term for the words of a phrase, and how many of them it explains."""
    if not name:
        return 0.0, 0
    exact = EXACT if is_name else TAG
    if name == tuple(full):
        return max(exact, _WHOLE) if len(name) > 1 else exact, 9
    if len(name) > 2 and tuple(full[-len(name) :]) == name and {*_JOINTS} & {*name}:
        return exact - _UNEXPLAINED * (len(full) - len(name)), len(name)
    if name == tuple(bare):
        return exact - _UNEXPLAINED * (len(full) - len(name)), 9
    for words in (_thing(full), _thing(bare)):
        if len(words) >= len(name) and tuple(words[-len(name) :]) == name:
            rest = [word for word in words[: -len(name)] if word not in _MODIFIERS | TOY_WORDS]
            odd = any(word in _RESHAPING or word in _OTHERWISE_SHAPED for word in rest)
            plain = exact - 0.7 * (len(words) < len(full)) if not rest else HEAD + (0.3 if is_name else 0.0)
            return (ODD_HEAD if odd else plain - _UNEXPLAINED * (len(words) - len(name))), len(name)
    return 0.0, 0


def _model_terms(models: tuple[ModelFile, ...]) -> tuple[_Term, ...]:
    """A model is called by its file's name, by what of it says what it is, and by that behind its folders' words."""
    names: list[tuple[str, list[str]]] = []
    for model in models:
        own = words_of(PurePath(model.path).stem)
        named = list(words_of_file(model.path).words)
        folders = _kept([*words_of(model.name)[: -len(own) or None], *named])
        names += [(model.path, each) for each in (own, named, _kept(named), folders)]
    return tuple(dict.fromkeys(_Term(path, tuple(words), True) for path, words in names if words))


def _models_by_words(phrase: str, models: tuple[ModelFile, ...], terms: tuple[_Term, ...]) -> list[_Match]:
    """Return the user's models by words, best first.

    A model whose name has the thing's noun and explains the words before it is the thing itself, in whatever order the
    name has them; of several the one comes first that shares most words with the phrase and has fewest others.
    """
    said = {singular(word) for word in words_of(phrase)}
    thing = [singular(word) for word in _thing(_kept(words_of(phrase)))]
    meant: list[tuple[int, int, str, _Match]] = []
    for model in models:
        name = words_of_file(model.path)
        own = {singular(word) for word in name.words}
        left = [word for word in thing[:-1] if word not in own | _MODIFIERS | TOY_WORDS]
        if thing and singular(name.noun) == thing[-1] and not left:
            match = _Match(model.path, EXACT, f"its name has the noun {thing[-1]!r}")
            meant.append((-len(own & said), len(own - said), model.path, match))
    return _best_of([match for *_, match in sorted(meant, key=lambda item: item[:3])] + _by_words(phrase, terms))


def _lookalike(word: str, other: str) -> bool:
    """Tell whether one word only begins like another, which the model takes for likeness: hatch and hatchet."""
    short, long = sorted((singular(word), singular(other)), key=len)
    return short != long and long.startswith(short)


def _meant(match: _Match, phrase: str, means: Mapping[str, str]) -> str:
    """Return the prop that a match means in its place, by the plain word or by what that usually is."""
    if match.score < HEAD - 2 * _UNEXPLAINED:
        return match.key
    plain = [singular(word) for word in _kept(words_of(phrase))]
    called = len(plain) > 1 and any(" ".join(plain) in (each.name, *each.tags) for each in PROPS.values())
    word = plain[-1] if plain and not called else ""
    return means.get(word) or means.get(match.key, match.key)


def _thing(words: list[str]) -> list[str]:
    """Return the words up to ``of``; after it where it only counts or heaps."""
    if "of" not in words[1:-1]:
        return words
    at = words.index("of", 1)
    return words[at + 1 :] if words[at - 1] in _HEAPS else words[:at]


def _best_of(matches: list[_Match]) -> list[_Match]:
    """Keep the first match of each key and order by score, equal ones as they came."""
    best: dict[str, _Match] = {}
    for match in matches:
        if match.key not in best or match.score > best[match.key].score:
            best[match.key] = match
    return sorted(best.values(), key=lambda match: -match.score)
