"""Noun phrases, verbs and small words of a regular sentence, grouped from left to right.

``rewrite`` has already told verbs from nouns, and names are single words, so phrases follow from closed word classes.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Literal

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import VerbForm
from storyblender.agents.director.reader.language.words import Mention, Word
from storyblender.catalog.inflection import PLURAL_ONLY, singular

_SMALL = (
    frozenset({"open", "shut"})
    | lexicon.PREPOSITIONS
    | lexicon.CONJUNCTIONS
    | lexicon.DETERMINERS
    | lexicon.POSSESSIVES
)
_MODALS = lexicon.words("modals")
_HYPOTHETICAL = frozenset({"should", "could", "would", "cannot", "shall"})
_NEGATIONS = frozenset({"not", "n't", "never", "nobody", "neither"})
_LINKS = lexicon.CONJUNCTIONS | {"until", "if", "unless", "though", "although", "because", "since"}
_THING_NOUNS = lexicon.SET_PIECES | lexicon.PROPS
_KIND_NOUNS = _THING_NOUNS | lexicon.SCENERY
"""What tells the kind of what stands behind it: a corner booth, a barn owl."""
_PLAIN = re.compile(r"(?:[^\W_]|#)(?:[^\W_]|[#'’-])*$")
_BARE = lexicon.ADJECTIVES | lexicon.words("manner")
"""``breathes hard``, ``stops dead``, ``lands flat``: alone they are no nouns."""
_QUALITIES = (
    lexicon.ADJECTIVES | lexicon.BUILD | lexicon.HAIR | lexicon.FACE | lexicon.VARIANT_WORDS | {"poor", "same", "other"}
)
_NO_QUALITY = frozenset({"set_piece", "prop", "scenery", "body", "abstract"})
_COPULAS = lexicon.words("copulas")
_GERUND_COMPOUNDS = lexicon.words("gerund_compounds")
_PARTS = lexicon.words("parts")
"""``the handle of the mop`` is the mop."""
_VEHICLE_PARTS = lexicon.words("vehicle_parts")
"""``on the hood of a car`` is on the car, ``the roof of the house`` is a roof."""
_SUBORDINATING = frozenset({"as", "before", "after", "until", "till"})
_SOME_OF = frozenset({"one", "some", "both", "each", "all", "none", "most", "another", "two", "half"})
_FITTING = frozenset({"open", "shut", "opposite", "near", "inside", "outside"})
"""``an open coffin``, ``the opposite wall``: no prepositions after an article."""
_FACES_OF_THINGS = frozenset({"face", "crown", "belly", "bottom", "nose", "wheels", "spine", "rim", "mouth"})
"""``lays the book face down``: how it lies, no face."""
_UNITS = lexicon.words("units")
_NOBODY = frozenset({"we", "i", "you"})
"""``We see``: the audience."""
_INDEFINITE = frozenset(
    f"{some}{one}" for some in ("some", "every", "any", "no") for one in ("thing", "one", "body")
) - {"noone"}
"""They stand alone: ``In the hall something fell``."""
_SUBJECT_PRONOUNS = frozenset({"he", "she", "they", "it", "i", "you", "we"})


@dataclass
class NounPhrase:
    """One thing or person in a clause."""

    kind: Literal["person", "pronoun", "thing"]
    index: int
    """Position of its head among the words."""
    head: str = ""
    """Singular head noun."""
    key: str = ""
    """Thing: head with the words that make it a kind of its own, ``coffee cup``."""
    mention: Mention | None = None
    possessor: int | None = None
    """Position of ``her`` or ``Nora('s)``."""
    owner: str | None = None
    """Id of the possessor, once resolved."""
    plural: bool = False
    determiner: str = ""


@dataclass
class Phrase:
    """A verb, a noun phrase, a preposition or a link, with the words it covers."""

    kind: Literal["noun", "verb", "preposition", "link", "negation", "mark"]
    first: int
    last: int
    text: str = ""
    noun: NounPhrase | None = None
    verb: VerbForm | None = None


def find_phrases(words: list[Word]) -> list[Phrase]:
    """Return the phrases of a regular sentence, in order."""
    phrases: list[Phrase] = []
    at = 0
    while at < len(words):
        phrase = _mention_or_verb(words, at) or _pronoun(words, at)
        phrase = phrase or (None if at and _tells_how_it_lies(words, at - 1) else _small_word(words, at))
        if phrase is None and not _skipped(words, at):
            phrase = _noun_phrase(words, at)
        if phrase:
            if phrase.noun and phrase.noun.possessor is not None and phrase.noun.possessor < phrase.first:
                del phrases[-2:]  # the owner and its 's now belong to what is owned
            phrases.append(phrase)
        at = phrase.last + 1 if phrase else at + 1
    return phrases


def _mention_or_verb(words: list[Word], at: int) -> Phrase | None:
    """Return the phrase of a mention or a tagged verb at an index, or None."""
    word = words[at]
    if word.mention:
        noun = NounPhrase("person", at, word.mention.head, mention=word.mention, possessor=_genitive(words, at))
        return Phrase("noun", at, at, noun=noun)
    return Phrase("verb", at, at, word.low, verb=word.verb) if word.verb else None


def _pronoun(words: list[Word], at: int) -> Phrase | None:
    """Return the phrase of a pronoun at an index, or None."""
    word = words[at]
    if word.low in _SOME_OF and [w.low for w in words[at + 1 : at + 2]] == ["of"]:
        ahead = range(at + 2, min(at + 6, len(words)))
        inner = next((i for i in ahead if words[i].mention or words[i].verb or words[i].low in lexicon.PRONOUNS), None)
        mention = words[inner].mention if inner else None
        several = _noun_phrase(words, at + 2)
        of_things = several is not None and inner is not None and several.last < inner
        if inner and mention and not of_things:  # "one of the chairs Peel sits" tells of a chair
            return Phrase("noun", at, inner, noun=NounPhrase("person", inner, mention.head, mention=mention))
    if word.inserted:
        return Phrase("noun", at, at, noun=NounPhrase("pronoun", at, ""))
    if word.low in _NOBODY:
        return Phrase("noun", at, at, noun=NounPhrase("thing", at, word.low, word.low))
    if word.low not in lexicon.PRONOUNS or word.low in ("his", "its", "their"):
        return None
    if word.low == "her" and at + 1 < len(words):
        right = words[at + 1]
        named = right.mention is not None and right.mention.kind == "name"
        possessive = (right.mention and not named) or (
            not named
            and right.text.isalpha()
            and right.low not in _SMALL
            and not right.low.endswith("ly")
            and not right.verb
        )
        if possessive:
            return None
    return Phrase("noun", at, at, noun=NounPhrase("pronoun", at, word.low))


def _small_word(words: list[Word], at: int) -> Phrase | None:
    """Return the phrase of a preposition, link or punctuation mark at an index, or None."""
    word = words[at]
    if word.low in _SUBORDINATING and _subject_follows(words, at):
        return Phrase("link", at, at, word.low)
    compound = _compound_preposition(words, at)
    if compound:
        return Phrase("preposition", at, at + len(compound) - 1, " ".join(compound))
    owned = at > 0 and words[at - 1].low == "'s" and word.low not in lexicon.PREPOSITIONS  # on Jim's back
    if (word.low in lexicon.PREPOSITIONS or word.low in lexicon.PARTICLES) and not owned:
        return Phrase("preposition", at, at, word.low)
    if word.low in _LINKS:
        return Phrase("link", at, at, word.low)
    if word.low in _NEGATIONS:
        return Phrase("negation", at, at, word.low)
    if word.low in _MODALS or word.low in ("nearly", "almost"):
        return Phrase("negation", at, at, "modal")
    return Phrase("mark", at, at, word.text) if not word.text[0].isalnum() else None


def _compound_preposition(words: list[Word], at: int) -> tuple[str, ...]:
    """Return the words of a compound preposition at an index: ``next to``, ``in front of``."""
    known = lexicon.COMPOUND_PREPOSITIONS.get(words[at].low, ())
    return next((each for each in known if tuple(w.low for w in words[at : at + len(each)]) == each), ())


def _subject_follows(words: list[Word], at: int) -> bool:
    """Whether a word links a clause and no noun: ``as she reads``, ``before you shoot``."""
    right = words[at + 1 : at + 6]
    if right and right[0].low in _SUBJECT_PRONOUNS - {"it", "you"}:
        return True  # but not: runs after it
    if right and right[0].low in ("it", "you"):
        return len(right) > 1 and right[1].verb is not None
    if right and right[0].low in ("the", *lexicon.POSSESSIVES):
        right = right[1:]
    noun = next((i for i, word in enumerate(right[:3]) if not _in_noun_phrase(word)), 3)
    if noun < len(right) and right[noun].mention is not None:
        noun += 1
    following = right[noun].verb if 0 < noun < len(right) else None
    return following is not None and following.kind in ("past", "3sg", "aux")


def _skipped(words: list[Word], at: int) -> bool:
    """Whether a word is skipped: adverbs, ``each other``, ``face down``."""
    word = words[at]
    right = words[at + 1].low if at + 1 < len(words) else ""
    left = words[at - 1] if at else None
    if (word.low == "guard" and left and left.verb and left.verb.lemma in ("stand", "keep")) or _is_bolt(words, at):
        return True
    if _is_distance(words, at) or (at and _is_distance(words, at - 1)):
        return True
    if _tells_how_it_lies(words, at) or (at and _tells_how_it_lies(words, at - 1)):
        return True
    if word.low in ("each", "one") and right in ("other", "another"):
        return True
    if word.low in ("other", "another") and at and words[at - 1].low in ("each", "one"):
        return True
    return word.low.endswith("ly") or word.low in lexicon.ADVERBS


def _is_distance(words: list[Word], at: int) -> bool:
    """Whether a distance stands here: ``stops two steps in front of him``."""
    unit = words[at + 1].low if at + 2 < len(words) else ""
    counted = words[at].low in lexicon.NUMBERS and unit in _UNITS
    return counted and (words[at + 2].low in lexicon.PREPOSITIONS or bool(_compound_preposition(words, at + 2)))


def _is_bolt(words: list[Word], at: int) -> bool:
    """Whether ``bolt`` is an adverb: ``sits bolt upright``."""
    return words[at].low == "bolt" and [word.low for word in words[at + 1 : at + 2]] == ["upright"]


def _tells_how_it_lies(words: list[Word], at: int) -> bool:
    """Whether a body part tells a pose: ``face down``, but not ``her face up to the light``."""
    left, right = words[at - 1].low if at else "", words[at + 1].low if at + 1 < len(words) else ""
    owned = left in lexicon.DETERMINERS or left in lexicon.POSSESSIVES or left == "'s"
    return words[at].low in _FACES_OF_THINGS and right in ("down", "up") and not owned


def _genitive(words: list[Word], at: int) -> int | None:
    """Return the index of the owner where ``'s`` stands before ``at``, or None."""
    return at - 2 if at > 1 and words[at - 1].low == "'s" and words[at - 2].mention else None


def _noun_phrase(words: list[Word], at: int) -> Phrase | None:
    """Return the noun phrase at an index: determiner, adjectives and head; the last word is the head."""
    if words[at].low in _SOME_OF and at + 2 < len(words) and words[at + 1].low == "of":
        several = _noun_phrase(words, at + 2)
        return replace(several, first=at) if several else None
    determiner, possessor, first = "", _genitive(words, at), at
    if words[at].low in lexicon.DETERMINERS:
        determiner, first = words[at].low, at + 1
    elif words[at].low in lexicon.POSSESSIVES:
        possessor, first = at, at + 1
    end = first
    while (
        end < len(words)
        and (_in_noun_phrase(words[end]) or (end == first > at and (_is_superlative(words[end]) or _fits(words, end))))
        and not (end > at and words[end].low in _INDEFINITE)
        and not (end > first and _compound_preposition(words, end))
        and not (end > first and (words[end].low in lexicon.PARTICLES or _tells_how_it_lies(words, end)))
    ):
        end += 1
    name = end < len(words) and words[end].mention is not None and words[end].named and words[end].text[0].isupper()
    if end + 2 < len(words) and end > first and words[end].mention and words[end + 1].low == "'s":
        owned = _noun_phrase(words, end + 2)
        if owned and owned.noun and owned.noun.kind == "thing" and words[end].text.islower():
            owned.noun.possessor, owned.noun.determiner = None, determiner
            return replace(owned, first=at)
    leads = any(_is_thing(word) or (name and not _describes(word)) for word in words[first:end])
    leads = leads and not (determiner and end - first == 1 and _tells_a_kind(words, first))
    if end < len(words) and words[end].mention and end - first <= 3 and (determiner or possessor == at) and not leads:
        noun = NounPhrase("person", end, words[end].mention.head, mention=words[end].mention, possessor=possessor)  # type: ignore[union-attr]
        noun.determiner = determiner
        return Phrase("noun", at, end, noun=noun)
    if end == first:
        return None
    head = _before_manner(words, first, end - 1)
    noun = singular(words[head].low)
    if end == first + 1 and not determiner and possessor is None and noun in _BARE and not _predicated(words, at):
        return None
    whole = _whole(words, end) if noun in lexicon.MEASURES | _PARTS | _VEHICLE_PARTS else None
    if whole and whole.noun and (noun not in _VEHICLE_PARTS or whole.noun.head in lexicon.VEHICLES):
        whole.noun.determiner = whole.noun.determiner or determiner
        whole.noun.plural = whole.noun.plural or noun != words[head].low
        return replace(whole, first=at)
    key = _compound(words, first, head, noun)
    plural = noun != words[head].low or noun in PLURAL_ONLY
    thing = NounPhrase("thing", head, noun, key, possessor=possessor, plural=plural, determiner=determiner)
    return Phrase("noun", at, end - 1, noun=thing)


def _before_manner(words: list[Word], first: int, head: int) -> int:
    """Return the index of the head before an adjective of manner: ``puts her hand flat against it``."""
    while head > first and words[head].low in _BARE and _is_thing(words[head - 1]):
        head -= 1
    return head


def _describes(word: Word) -> bool:
    """Whether a word can stand between an article and a name: ``the unlucky Ben``, ``a YOUNG OFFICER``."""
    return (
        word.text.isupper()
        or word.low in _QUALITIES
        or re.search(r"(ed|ing|y|ful|less|ous|ish)$", word.low) is not None
    )


def _is_thing(word: Word) -> bool:
    """Whether a noun ends before a name: ``In the front pew MRS. VOSS``."""
    return word.text.islower() and lexicon.noun_class(singular(word.low)) in _NO_QUALITY


def _tells_a_kind(words: list[Word], at: int) -> bool:
    """Whether a thing names the kind of a person or animal: ``a barn owl``, ``the hotel porter``."""
    named = words[at + 1].text.islower() if at + 1 < len(words) else False
    return named and words[at].text.islower() and singular(words[at].low) in _KIND_NOUNS


def _predicated(words: list[Word], at: int) -> bool:
    """Whether an adjective is a predicate: ``turned pale``, ``is asleep``."""
    verb = words[at - 1].verb if at else None
    return verb is not None and verb.lemma in _COPULAS


def _whole(words: list[Word], end: int) -> Phrase | None:
    """Return the phrase of the noun after ``of``: ``a bunch of flowers``, ``the handle of the mop``."""
    if end + 1 >= len(words) or words[end].low != "of":
        return None
    inner = _noun_phrase(words, end + 1)
    return inner if inner and inner.noun and inner.noun.kind == "thing" else None


def _is_superlative(word: Word) -> bool:
    """Whether a word is a superlative: in ``the nearest door`` it is no preposition."""
    return word.low.endswith("est") and word.mention is None and word.verb is None


def _fits(words: list[Word], at: int) -> bool:
    """Whether a word is an adjective and no preposition, because a noun follows: ``an open coffin``."""
    word, right = words[at], words[at + 1] if at + 1 < len(words) else None
    return word.low in _FITTING and word.verb is None and right is not None and _in_noun_phrase(right)


def _in_noun_phrase(word: Word) -> bool:
    """Whether a word can be inside a noun phrase."""
    return (
        _PLAIN.match(word.text) is not None
        and word.mention is None
        and word.verb is None
        and word.low not in _SMALL
        and word.low not in lexicon.ADVERBS
        and word.low not in lexicon.PRONOUNS
        and word.low not in _NOBODY
        and word.low not in _HYPOTHETICAL
        and not word.low.endswith("ly")
    )


def _compound(words: list[Word], first: int, head: int, noun: str) -> str:
    """Return a noun with the word before it that names its kind: ``coffee cup``, ``rocking chair``."""
    if head == first:
        return noun
    left = words[head - 1].low
    if (
        left in lexicon.CARRIERS
        or f"{left}-{noun}" in lexicon.COMPOUNDS
        or f"{left}_{noun}" in _GERUND_COMPOUNDS
        or (left in _KIND_NOUNS and noun in _THING_NOUNS)
    ):
        return f"{left} {noun}"
    return noun
