"""The words the Director knows: closed lists and maps, read once from the ``.tsv`` files of this room.

Every file holds lines ``class<TAB>words``; a class may take several lines, ``#`` starts a comment. Underscores
inside a word stand for spaces (``get_up``, ``living_room``), ``word=value`` makes the class a map.
"""

from __future__ import annotations

import re
from importlib.resources import files
from typing import Literal, NamedTuple, cast

from storyblender.agents.director.naming import unaccented
from storyblender.memory.vocabulary import Expression, Gender, Mood, RelationKind, TimeOfDay, Weather

NounClass = Literal["abstract", "body", "set_piece", "prop", "worn", "scenery", "unknown"]


def _lines(name: str) -> list[str]:
    text = files(__name__).joinpath(name).read_text(encoding="utf-8")
    return [line for line in text.splitlines() if line and not line.startswith("#")]


def _read(name: str) -> dict[str, tuple[str, ...]]:
    """The classes of one lexicon file, words in file order."""
    classes: dict[str, list[str]] = {}
    for line in _lines(name):
        key, words = line.split("\t")
        classes.setdefault(key, []).extend(words.split(" "))
    return {key: tuple(words) for key, words in classes.items()}


def _pairs(words: tuple[str, ...]) -> dict[str, str]:
    return dict(word.split("=", 1) for word in words)


def _spaced(words: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(word.replace("_", " ") for word in words)


def _by_first(words: tuple[str, ...]) -> dict[str, tuple[tuple[str, ...], ...]]:
    phrases = [tuple(word.split("_")) for word in words]
    return {first: tuple(p for p in phrases if p[0] == first) for first in dict.fromkeys(p[0] for p in phrases)}


def _inverse(classes: dict[str, tuple[str, ...]]) -> dict[str, str]:
    return {word: key for key, words in classes.items() for word in _spaced(words)}


_nouns, _people, _places, _verbs = _read("nouns.tsv"), _read("people.tsv"), _read("places.tsv"), _read("verbs.tsv")
_motions, _time = _read("motions.tsv"), _read("times.tsv")
_rules = _read("rules.tsv")
_names, _function = _read("names.tsv"), _read("function_words.tsv")
_wordnet = {kind: frozenset(words) for kind, words in _read("wordnet.tsv").items()}
"""The large list: what the hand-made lists of a class do not have."""

# -- motions -----------------------------------------------------------------------------------------------------
MOTION_OF_VERB: dict[str, str] = _inverse(_motions)
"""Verb, or verb and particle, to motion: ``get up`` -> ``stand_up``."""
MOTIONS: tuple[str, ...] = tuple(_motions)
NEAR_MOTIONS: dict[str, str] = _inverse(_read("near.tsv"))
"""Verb, or verb and particle, without a motion of its own -> the motion that looks most like it."""
SILENT_VERBS = frozenset(_verbs["silent"])
"""Verbs of state and of the face: no motion of the body."""
SPEECH_VERBS = frozenset(_verbs["speech"])
FACE_VERBS = frozenset(_verbs["face"])
"""Verbs kept as an expression of the face."""
HANDLING = frozenset(_verbs["handling"])
"""Motions that touch a thing; the thing is then worth a place on the asset sheet."""
GRIPPING = frozenset(_verbs["gripping"])
"""Motions that take a thing in the hand or put it out of it."""
VERBS: tuple[str, ...] = tuple(
    dict.fromkeys([verb.split(" ")[0] for verb in MOTION_OF_VERB] + [*_verbs["plain"], *_verbs["silent"]])
)
IRREGULAR_PAST = _pairs(_verbs["irregular"])
DOUBLING = frozenset(_verbs["doubling"])
DOUBLING_ING = frozenset(_verbs["doubling_ing"]) | DOUBLING
ODD_FORMS: dict[str, tuple[str, str]] = {
    form: (value.split("/")[0], value.split("/")[1]) for form, value in _pairs(_verbs["form"]).items()
}


class Override(NamedTuple):
    """A row of ``overrides.tsv``: what a verb means with this particle, object, preposition and noun after it."""

    verbs: tuple[str, ...]
    particles: tuple[str, ...]
    objects: tuple[str, ...]
    prepositions: tuple[str, ...]
    nouns: tuple[str, ...]
    motion: str


def _overrides() -> dict[str, tuple[Override, ...]]:
    rows = [line.split("\t") for line in _lines("overrides.tsv")]
    rules = [Override(*(_cell(cell) for cell in row[:5]), motion=row[5]) for row in rows]
    verbs = dict.fromkeys(verb for rule in rules for verb in rule.verbs)
    return {verb: tuple(rule for rule in rules if verb in rule.verbs) for verb in verbs}


def _cell(words: str) -> tuple[str, ...]:
    return tuple(words.split(" "))


OVERRIDES = _overrides()
OVERRIDDEN_PARTICLES = frozenset(
    f"{verb} {particle}"
    for verb, rules in OVERRIDES.items()
    for rule in rules
    if rule.objects != ("-",)
    for particle in rule.particles
)
"""Verb and particle pairs that have a rule: ``pull off``."""
"""Verb -> its rules, in order."""

_BODILY = frozenset(
    {"walk", "run", "sneak", "stagger", "crawl", "sit", "stand", "kneel", "crouch", "lie_down", "ride", "jump", "climb"}
)
INVERTING = frozenset(_rules["inverting"]) | {verb for verb, motion in MOTION_OF_VERB.items() if motion in _BODILY}
"""Verbs whose subject may follow: ``Behind him trudges SERGEANT OAKE``."""

# -- things ------------------------------------------------------------------------------------------------------
_SOLID = frozenset(noun for kind in ("prop", "worn", "set_piece") for noun in _nouns[kind])
ABSTRACT, BODY = frozenset(_nouns["abstract"]) | (_wordnet["abstract"] - _SOLID), frozenset(_nouns["body"])
PROPS, WORN, SET_PIECES, SCENERY = (
    frozenset(_nouns[kind]) | (_wordnet[kind] - _SOLID) for kind in ("prop", "worn", "set_piece", "scenery")
)
COMPOUNDS = frozenset(noun for noun in PROPS | WORN | SET_PIECES if "-" in noun)
"""Kinds of things that take two words: ``egg-cup``, ``fire-escape``."""
OWN_BODY = _pairs(_rules["own_body"])
"""Thing -> part of the body that it is where it is a person's own: bites his nails."""
SEATS, VEHICLES = frozenset(_nouns["seat"]), frozenset(_nouns["vehicle"])
PORTABLE = frozenset(_nouns["portable"])
"""Nouns that are both set piece and prop, and rather a prop when they stand alone."""
MOVABLE = frozenset(_nouns["movable"])
"""Set pieces that are props where a person handles them or where they are on something: a stool, a lamp, a tent."""
PARTS = frozenset(_nouns["part"])
"""Parts of other things, which are things only where a person handles them: a page, a switch."""
PART_OF = {part: frozenset(wholes.split("/")) for part, wholes in _pairs(_nouns["part_of"]).items()}
"""Thing -> what it is a part of, where such a thing was named before it."""
CARRIERS = frozenset(_nouns["carrier"])
"""First words of a compound that name a kind of the second: ``coffee cup``, ``birthday card``."""
MEASURES, LIQUIDS, SHAPELESS, WEATHER_NOUNS = (
    frozenset(_nouns[key]) for key in ("measure", "liquid", "shapeless", "weather")
)
OPENABLE = frozenset(_nouns["openable"])
SUITING: dict[str, frozenset[str]] = {
    verb: frozenset(_nouns[kind])
    for kind, verbs in (
        ("openable", ("open", "close", "shut", "lock", "unlock", "slam")),
        ("readable", ("read", "sign", "unfold")),
        ("drinkable", ("drink", "sip", "drain", "gulp")),
        ("callable", ("answer",)),
    )
    for verb in verbs
}
"""Verb -> nouns that ``it`` rather means as its object."""
SOUNDS = _pairs(_nouns["sound"])
"""Word for a noise -> name of the sound effect."""

# -- people ------------------------------------------------------------------------------------------------------
MALE_NOUNS, FEMALE_NOUNS = frozenset(_people["male"]), frozenset(_people["female"])
ANIMALS = frozenset(_people["animal"])
COMMON_PERSON_NOUNS = MALE_NOUNS | FEMALE_NOUNS | frozenset(_people["neutral"]) | ANIMALS
"""Nouns for people from the hand-made lists; these nouns never mean anything else."""
PERSON_NOUNS = COMMON_PERSON_NOUNS | (_wordnet["person"] - frozenset(_rules["devices"]))
RARE_PERSON_NOUNS = _wordnet["person"]
"""Of the large list: after a title rather a surname."""
YOUNG_NOUNS = frozenset(_people["young"])
CROWDS = frozenset(_people["crowd"])
NEUTER_ROLES = frozenset(_people["neuter"])
"""A person who may be called ``it``."""
MACHINES = frozenset(_people["machine"])
"""Those that are built and do not look like people."""
TITLE_SYNONYMS = _pairs(_people["title_synonym"])
CONVERSE_KIN = {kin: tuple(others.split("/")) for kin, others in _pairs(_people["converse"]).items()}
"""Kin -> what they are to each other: the uncle of a niece or nephew."""
KIN = frozenset(_people["kin"])
YOUNGER_KIN = frozenset(_people["younger_kin"])
ARRIVALS, HOSTS = frozenset(_people["arrival"]), frozenset(_people["host"])
"""The visitor came last, the host was there first."""
COMPANY, CALLINGS = frozenset(_people["company"]), frozenset(_people["calling"])
"""``his companion``, ``the other``; ``the detective``, who was named before."""
KINDS = {kind: frozenset(animals.split("/")) for kind, animals in _pairs(_people["animal_kind"]).items()}
"""``the bird`` -> what it may have been called before: a goose."""
RANKS = {noun: frozenset(titles.split("/")) for noun, titles in _pairs(_people["rank"]).items()}
"""Noun -> titles of those it may mean: the soldier is a sergeant."""
TITLES = frozenset(_people["title"])
TITLE_GENDER = cast(dict[str, Gender], _pairs(_people["title_gender"]))
UNISEX = frozenset(_people["unisex"])
"""First names of both genders: a pronoun knows better."""
AGE_WORDS, AGE_NOUNS = _pairs(_people["age_word"]), _pairs(_people["age_noun"])
AGED = frozenset(word for word, age in AGE_WORDS.items() if age == "70s")
VARIANT_WORDS = frozenset(_people["variant"])
"""Words before a name that make the same person at another age or in another costume."""
SPELLED_AGES = _pairs(_people["spelled_age"])
BUILD, HAIR, FACE = frozenset(_people["build"]), frozenset(_people["hair"]), frozenset(_people["face"])
MALE_NAMES, FEMALE_NAMES = frozenset(_names["male"]), frozenset(_names["female"])
FIRST_NAMES = MALE_NAMES | FEMALE_NAMES

# -- places and times --------------------------------------------------------------------------------------------
INDOOR, OUTDOOR = frozenset(_places["indoor"]), frozenset(_places["outdoor"])
PLACES = INDOOR | OUTDOOR
PLACE_KINDS: dict[str, str] = {
    word.replace("_", " "): kind for kind, words in _read("place_kinds.tsv").items() for word in words
}
"""Words of a heading -> place kind, e.g. ``tavern`` -> ``bar``."""
RELATION_OF_PREPOSITION: dict[str, str] = _inverse(_read("relations.tsv"))
TIME_WORDS: dict[str, TimeOfDay] = cast(dict[str, TimeOfDay], _pairs(_time["time"]))
FOREIGN_TIMES: dict[str, TimeOfDay] = cast(dict[str, TimeOfDay], _pairs(_time["foreign"]))
"""Times of day in other languages, for headings."""
TIME_PHRASES: dict[str, TimeOfDay] = {
    phrase.replace("_", " "): time for phrase, time in cast(dict[str, TimeOfDay], _pairs(_time["phrase"])).items()
}
"""Times of day in several words: ``first light``."""
WEATHER_WORDS: dict[str, Weather] = cast(dict[str, Weather], _pairs(_time["weather"]))

EXPRESSION_OF_WORD = cast(dict[str, Expression], _inverse(_read("expressions.tsv")))
"""Word describing a person, in any form -> facial expression."""
MOOD_OF_WORD = cast(dict[str, Mood], _inverse(_read("moods.tsv")))

# -- function words ----------------------------------------------------------------------------------------------
PRONOUNS = _pairs(_function["pronoun"])
"""Pronoun -> ``male``, ``female``, ``plural`` or ``thing``."""
DETERMINERS, POSSESSIVES = frozenset(_function["determiner"]), frozenset(_function["possessive"])
NUMBERS = {word: int(value) for word, value in _pairs(_function["number"]).items()}
PREPOSITIONS, CONJUNCTIONS = frozenset(_function["preposition"]), frozenset(_function["conjunction"])
PARTICLES = frozenset(_function["particle"])
COMPOUND_PREPOSITIONS: dict[str, tuple[tuple[str, ...], ...]] = _by_first(_function["compound_preposition"])
"""First word -> prepositions of several words."""
ADVERBS = frozenset(_function["adverb"]) | _wordnet["adverb"]
ADJECTIVES, OTHER_VERBS = _wordnet["adjective"], _wordnet["verb"]
"""Words that are adjectives before all; verbs whose motion nobody knows."""
NOT_PEOPLE = frozenset(_function["caps"])
"""Words in capitals that are never people: noises, title cards, transitions."""


def noun_class(key: str) -> NounClass:
    """What kind of thing a noun names: as a compound, else from its head; the first list that knows it wins."""
    compound = key.replace(" ", "-")
    head = compound if compound in COMPOUNDS else key.rsplit(" ", 1)[-1]
    if head in ABSTRACT or head in PRONOUNS:
        return "abstract"
    if head in BODY:
        return "body"
    if key in SET_PIECES or (head in SET_PIECES and head not in PORTABLE):
        return "set_piece"
    if head in PROPS:
        return "prop"
    if head in WORN:
        return "worn"
    if head in SET_PIECES:
        return "set_piece"
    return "scenery" if head in SCENERY or head in PLACES else "unknown"


def words(rule: str) -> frozenset[str]:
    """A closed set of words that one rule asks for, from ``rules.tsv``."""
    return frozenset(_rules[rule])


def gender_of_word(word: str) -> Gender:
    """The gender a noun or first name carries, with or without its accents."""
    word = unaccented(word)
    if word in FEMALE_NOUNS or word in FEMALE_NAMES or word.endswith("woman"):
        return "female"
    male = word in MALE_NOUNS or word in MALE_NAMES or (word.endswith("man") and len(word) > 5)
    return "male" if male and word != "human" else "unknown"


def _patterns() -> dict[str, re.Pattern[str]]:
    rows = [line.split("\t") for line in _lines("bearing.tsv")]
    whose = r"(?:his|her|their|its|the|an|one|each|either|both|my)"
    side = r"(?:free |other |good |bare |gloved )?"
    told = [(key, text.replace("WHOSE", whose).replace("SIDE", side)) for key, text in rows]
    return {key: re.compile("|".join(text for other, text in told if other == key)) for key, _ in told}


BEARING: dict[str, re.Pattern[str]] = _patterns()
"""Category of bearing -> pattern of its words, from ``bearing.tsv``."""


def relation_of(preposition: str) -> RelationKind | None:
    """The layout relation a preposition states, or None (``through``, ``along``, ``around`` place nothing)."""
    kind = RELATION_OF_PREPOSITION.get(preposition)
    return cast(RelationKind, kind) if kind else None


_BESIDE = re.compile(r"(?<=\w)\s+(?:behind|near|beside|outside|opposite|next to|close to)\s+")


def place_kind(place: str) -> str:
    """The place kind of a heading or phrase: the last known words in it, or an empty string.

    What it is beside names another place: an alley behind the market is an alley.
    """
    for part in _BESIDE.split(place.lower(), maxsplit=1):
        padded = f" {part.replace(',', ' ')} "
        known = [word for word in PLACE_KINDS if f" {word} " in padded]
        if known:
            return PLACE_KINDS[max(known, key=lambda word: (padded.rfind(f" {word} ") + len(word), len(word)))]
    return ""
