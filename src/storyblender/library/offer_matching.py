"""Which works of a catalogue fit a thing of a story: names decide, then tags, then likeness of meaning.

Names in catalogues are titles: ``Old wooden desk | game ready``. What they add to the thing may make another thing of
it (a street lamp is no lamp) or a likeness of it (a toy car).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Final

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.phrases import before_details, kept_words, noun_words
from storyblender.catalog.props.variants import TOY_WORDS, words_of
from storyblender.catalog.recipe import EXACT, HEAD, AssetQuery
from storyblender.library.built_in import CATALOG_TERMS
from storyblender.library.matching import ODD_HEAD, Likeness, Match, Term, best_of
from storyblender.library.named_models import named, terms_of
from storyblender.services.offers import Need, Offer

TAGGED = 7.5
"""Score of a work of another name that is tagged with the thing's."""
_LARGE = 2.0
"""Metres: larger things fill the picture, and get finer textures."""
_MOST_BYTES: Final = 100 << 20
"""Of a download for one thing."""
_SEAM = re.compile(r"[|(\[{/:;,+]|\s[-–—]\s|\bby\b|\bfor\b|#")
_HUMP, _NUMBER = re.compile(r"(?<=[a-z])(?=[A-Z])"), re.compile(r"v?\d+|[a-z]")
_PRAISE = frozenset(
    ("pbr", "hd", "hq", "realistic", "photorealistic", "stylized", "stylised", "photogrammetry", "scan", "scanned",
     "3d", "2k", "4k", "8k", "vr", "ar", "download", "textured", "detailed", "unity", "unreal", "blender", "highpoly",
     "optimized")
)  # fmt: skip
"""Words that say how a model is made."""
_AFTER = frozenset(
    ("round", "square", "tall", "low", "worn", "old", "new", "small", "medium", "large", "long", "short", "open",
     "closed", "dirty", "clean", "rusty", "broken", "destroyed", "burnt", "damaged", "modern", "vintage", "antique",
     "simple")
)  # fmt: skip
"""Words that titles put behind the thing: ``Side Table Tall 01``."""
_SPOILT = frozenset(("broken", "destroyed", "ruined", "burnt", "burned", "damaged", "smashed", "wrecked", "abandoned"))
"""Words for a state that a thing is in only if the story says so."""


@dataclass(frozen=True)
class Offers:
    """The works of a catalogue that may fit, with what they are called.

    Attributes:
        by_id: The works, in the order in which the catalogue gave them.
        names: What each is called, by id, as the name of a file.
        terms: The same for ``matching``.
    """

    by_id: dict[str, Offer]
    names: dict[str, str]
    terms: tuple[Term, ...]

    @classmethod
    def of(cls, offers: Sequence[Offer]) -> Offers:
        """Return works with what they are called; without those that are too large."""
        by_id = {offer.id: offer for offer in offers if offer.bytes <= _MOST_BYTES}
        names = {id: name for id, offer in by_id.items() if (name := title_words(offer.name))}
        return cls(by_id, names, terms_of(names.items()))


def search_words(phrase: str) -> str:
    """Return what a service is asked for: the words that name a thing, without colours, sizes and owners."""
    return " ".join(noun_words(phrase))[:60]


def title_words(title: str) -> str:
    """Return the words of a title that name the thing, lower-case and the noun last: ``Bookshelf Worn`` is worn."""
    head = next((part for part in _SEAM.split(title) if words_of(part)), "")
    words = words_of(_HUMP.sub(" ", head))
    words = [word for word in words if word not in _PRAISE and not _NUMBER.fullmatch(word)]
    words = before_details(words) if words else []
    described = next((n for n, word in enumerate(reversed(words)) if word not in _AFTER), 0)
    return " ".join([*words[len(words) - described :], *words[: len(words) - described]])


def ranked(query: AssetQuery, offers: Offers, likeness: Likeness, *, by_meaning: bool) -> list[Match]:
    """Return the works that fit a thing, best first; keys are ids.

    Args:
        query: The thing.
        offers: The works.
        likeness: Compares meanings.
        by_meaning: Whether also those whose tags or meaning are like it.
    """
    models = [(id, name, place) for place, (id, name) in enumerate(offers.names.items())]
    found = [*_written_together(query.phrase, offers), *named(query.phrase, models, offers.terms)]
    matches = [_weighed(match, query.phrase, offers) for match in found]
    if by_meaning:
        known = {match.key for match in matches}
        matches += [match for match in _tagged(query.phrase, offers) if match.key not in known]
        matches = likeness.with_likely(matches, query, offers.terms)
    return best_of(matches)


def _written_together(phrase: str, offers: Offers) -> list[Match]:
    """Return the works whose name has the thing as one word: a ``Rockingchair``."""
    thing = noun_words(phrase)
    word, reason = "".join(thing), f"its name has {' '.join(thing)!r}"
    together = [id for id, name in offers.names.items() if len(thing) > 1 and name.rpartition(" ")[2] == word]
    return [Match(id, EXACT, reason) for id in together]


def _weighed(match: Match, phrase: str, offers: Offers) -> Match:
    """Return a match by name, of a lower score if the name says more than the thing."""
    said = {*words_of(phrase)}
    more = [word for word in words_of(offers.names[match.key]) if word not in said]
    if TOY_WORDS.intersection(more) or _SPOILT.intersection(more):
        return Match(match.key, min(match.score, ODD_HEAD), match.reason)
    ours, theirs = _prop_called(phrase), _prop_called(offers.names[match.key])
    if more and theirs and theirs != ours:
        return Match(match.key, min(match.score, HEAD), match.reason)
    return match


def _prop_called(phrase: str) -> str:
    """Return the key of the prop of the built-in library that is called so; empty if none is."""
    words = words_of(phrase)
    return _props().get(tuple(noun_key(word) for word in kept_words(words)), "") if words else ""


@cache
def _props() -> dict[tuple[str, ...], str]:
    """Return the keys of the built-in library's props by the words of their names; a name goes before a further one."""
    terms = sorted(CATALOG_TERMS, key=lambda term: term.is_name)
    return {tuple(noun_key(word) for word in term.words): term.key for term in terms}


def _tagged(phrase: str, offers: Offers) -> list[Match]:
    """Return the works that are tagged with what a thing is called, in the order of the catalogue."""
    thing = [noun_key(word) for word in noun_words(phrase)]
    return [
        Match(offer.id, TAGGED, f"it is tagged {' '.join(thing)!r}", by_meaning=True)
        for offer in offers.by_id.values()
        if thing and any([noun_key(word) for word in words_of(tag)] == thing for tag in offer.words)
    ]


def need_of(query: AssetQuery) -> Need:
    """Return what a thing is wanted for, by the usual size of such a thing."""
    key = _prop_called(query.phrase)
    return Need(pixels=2048 if key and max(PROPS[key].size) > _LARGE else 1024)


def is_asked_for(query: AssetQuery) -> bool:
    """Tell whether services are asked for a thing.

    Not for what the script does not name, what moves by itself or is got into, nor what the story writes on, fills,
    or finds in a state: of those only the built-in library has all that is seen.
    """
    asset = query.asset
    made = query.kind in ("animal", "vehicle") or asset.fitted_part or asset.writing or asset.liquid or query.state
    return asset.asset_type == "object" and asset.origin != "dressing" and not made and bool(words_of(query.phrase))
