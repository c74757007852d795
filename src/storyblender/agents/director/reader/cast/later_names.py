"""Joins people introduced by a noun with the name they get later: ``Her brother came in. Goran sat down``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.cast.name_evidence import gender_by_pronouns
from storyblender.agents.director.reader.cast.namings import Naming
from storyblender.agents.director.reader.language.morphology import is_person_noun
from storyblender.agents.director.reader.language.words import TextIndex
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import singular

_SOON, _LATER = 900, 2500
"""Characters from where a person without a name was told of last to his title, and to a name that just turns up."""
_NEAR, _ANSWERING = 1600, 150
"""Characters between a person's last mention and what he is called."""
_PERSON_NOUNS = frozenset({"man", "woman", "lady", "gentleman"})
_YOUNG = frozenset({"boy", "girl", "child", "youth", "lad", "kid", "teenager"})
GENERIC = _PERSON_NOUNS | {"fellow", "stranger", "figure"}
"""Nouns that tell no more than that a person is there."""
_EITHER = frozenset({"nurse", "secretary", "housekeeper"})
"""They may be men after all."""
_PASSING = frozenset(
    {"waiter", "waitress", "barman", "bartender", "barmaid", "coachman", "cabman", "conductor", "porter", "doorman"}
    | {"guard", "sentry", "servant", "maid", "footman", "clerk", "cashier", "postman", "policeman", "constable"}
    | {"receptionist", "steward", "customer", "passenger", "guest", "neighbour", "neighbor", "stranger", "passer-by"}
)
"""They may come and go without a name: only what is said gives them one."""
GENTLE = frozenset({"mr", "mrs", "ms", "miss", "sir", "lord", "lady", "madame", "monsieur", "herr", "frau", "master"})
"""Titles that tell no trade."""
_BABIES = frozenset({"baby", "infant", "newborn"})
_ARRIVING = re.compile(
    r"(?:\w+ly )?(?:came|comes|entered|enters|arrived|arrives|appeared|appears|burst|bursts|strode|strides|returned"
    r"|returns|emerged|emerges|joined|joins|hurried|rushed|stood|stands|sat|sits|waited|waits|lay|lies"
    r"|was|is|were|are)\b"
)
"""What a story says of a person who is new to it."""
_GOING = re.compile(r"\b(?:passed|passes|went (?:by|past|out|away)|(?:ran|walked|hurried) (?:by|past|off|away)|left)\b")
_PLACED = re.compile(
    r"(?:^|[.!?]\s)\s*(?:[Bb]ehind|[Bb]eside|[Oo]n|[Ii]n|[Aa]t|[Uu]nder|[Nn]ext to|[Ff]rom)\b[^.!?]*, $"
)
_POSSESSED = re.compile(r"(?:my|our|his|her|their|\w+['’]s)\b", re.IGNORECASE)
_SHOWN = re.compile(r"\b(?i:an?|the) (?:[\w-]+ ){0,2}$")
_MEANT = re.compile(r"\bthe (?:[a-z-]+ )?$")
_PHRASE = 100
"""Characters before a noun in which its article stands."""
_INDEFINITE = re.compile(r"an?\b", re.IGNORECASE)
_APPOSED = re.compile(r",\s+(?:an?|the|his|her|my|their|who|whose|\w+['’]s)\s")


def is_nameless(person: Person) -> bool:
    """Whether a person is only known as ``man``, ``young man`` or ``nun``."""
    return _has_no_name(person) and person.kind == "human" and person.count == 1


def _has_no_name(person: Person) -> bool:
    """Whether a person's name is a noun and no name of their own."""
    return person.role == bare(person.name) or (person.role != "" and person.name.islower())


@rule("people.named_later_in_story")
def name_the_nameless(roster: Roster, told: str, namings: Sequence[Naming]) -> None:
    """Join people introduced by a noun with the name they get later.

    Args:
        roster: The cast of a story; a person who is joined leaves it under the old name.
        told: The script without what is said.
        namings: Where people get names.
    """
    for naming in namings:
        _give_name(roster, told, naming)
    nameless = [person for person in roster.people if is_nameless(person)]
    for person in sorted(roster.people, key=lambda person: person.first):
        plain = person.role != bare(person.name) and person is not roster.narrator and person.kind == "human"
        if plain and told.startswith(person.name, person.first) and not is_person_noun(singular(person.name)):
            nameless = [each for each in nameless if roster.person(each.id) is each]
            _match_new_name(roster, person, told, nameless)


# -- names that are said -----------------------------------------------------------------------------------------


def _give_name(roster: Roster, told: str, naming: Naming) -> None:
    """Give a spoken name to the nameless person it belongs to, if there is one."""
    known = roster.find(naming.name) or roster.find(naming.name.split()[-1]) or roster.find(naming.name.split()[0])
    named = known[0] if known else None
    if named is not None and (named.first < naming.at or _has_no_name(named)):
        return
    spoken_only = named is None
    if spoken_only and naming.way != "told" and (naming.way == "called" or not _is_a_name(naming.name)):
        return
    fitting = [each for each in roster.people if _can_be_called(roster, each, named, told, naming)]
    if not fitting and naming.alone:
        naming = naming._replace(way="own")  # "Sir Dunstan," said the knight
        fitting = [each for each in roster.people if _can_be_called(roster, each, named, told, naming)]
    if not fitting:
        return
    nameless = min(fitting, key=lambda each: _distance(told, each, naming))
    if _distance(told, nameless, naming) > _NEAR:
        return
    if named is None:
        named = roster.add(naming.name, naming.at)
    roster.add_alias(named, bare(naming.name))
    merge_people(roster, named, nameless)


def _is_a_name(name: str) -> bool:
    """Whether a spoken name is one: a first name, or one with a title."""
    words = bare(name).replace(".", "").split()
    return words[0] in lexicon.FIRST_NAMES or (words[0] in lexicon.TITLES and len(words) > 1)


def _can_be_called(roster: Roster, person: Person, named: Person | None, told: str, naming: Naming) -> bool:
    """Whether a person has no name yet and may have this one."""
    animal = _has_no_name(person) and person.kind == "animal" and person.count == 1
    if not (is_nameless(person) or animal) or person in (named, roster.narrator):
        return False
    soon = (
        naming.way == "called" and "\n" not in told[naming.at : person.first] and person.first - naming.at < _ANSWERING
    )
    if not (person.first < naming.at or soon):
        return False
    gender = naming.gender if naming.gender != "thing" else "unknown"
    if not _agree(gender, person.gender) or (
        naming.way != "called" and not _agree(_tag_gender(naming.tag), person.gender)
    ):
        return False
    if not _may_bear(person, naming.name) or _distance(told, person, naming) > _NEAR:
        return False
    return named is None or (_genders_may_agree(named, person, told) and not appear_together(told, person, named))


def _may_bear(person: Person, name: str) -> bool:
    """Whether a person may bear a title: a butler is no ``Inspector Gale``."""
    title = bare(name).split()[0].strip(".")
    if person.kind == "animal":
        return title not in lexicon.TITLES or " " not in name
    office = (
        " " in name and is_person_noun(lexicon.TITLE_SYNONYMS.get(title, title)) and title not in lexicon.KIN | GENTLE
    )
    ranks = lexicon.RANKS.get(person.role, frozenset()) | {person.role}
    return not office or person.role in GENERIC | _YOUNG | lexicon.KIN or title in ranks


def _tag_gender(tag: str) -> str:
    """Return the gender of the noun in a speech tag, or ``unknown``."""
    said = re.match(r"(?:\w+ )?(he|she)\b", tag, re.IGNORECASE)
    return lexicon.PRONOUNS.get(said.group(1).lower(), "unknown") if said else "unknown"


def _distance(told: str, person: Person, naming: Naming) -> int:
    """Return the characters between a naming and the nearest mention of a person."""
    places = list(_mentions(told, person))
    before = [naming.at - at for at in places if at < naming.at]
    after = [2 * (at - naming.at) for at in places if at >= naming.at and naming.way == "called"]
    return min([*before, *after], default=_NEAR + 1) + (person.kind == "animal") * _ANSWERING


def _mentions(told: str, person: Person) -> tuple[int, ...]:
    """Return the offsets at which a person is mentioned."""
    plain = {"man", "boy"} if person.role == "stranger" else set[str]()
    called = "|".join(
        map(re.escape, sorted({person.role, *person.aliases, *plain}, key=lambda name: (-len(name), name)))
    )
    return _places(told, rf"\b(?:{called})\b")


@lru_cache(maxsize=1024)
def _places(told: str, pattern: str) -> tuple[int, ...]:
    """Return the offsets of a pattern in a text."""
    return tuple(match.end() for match in re.finditer(pattern, told, re.IGNORECASE))


# -- names that turn up ------------------------------------------------------------------------------------------


def _match_new_name(roster: Roster, named: Person, told: str, nameless: Sequence[Person]) -> None:
    """Match a name that nobody introduced with a nameless person: ``a man came up the path … said Arlo``."""
    nameless = [each for each in nameless if is_nameless(each) and each.first < named.first]
    nameless = [each for each in nameless if each is not roster.narrator and each.role not in _BABIES]
    for each in sorted(
        nameless, key=lambda each: -max((at for at in _mentions(told, each) if at < named.first), default=0)
    ):
        if _may_be_same(each, named, told, len(nameless) == 1):
            merge_people(roster, named, each)
            return


def _may_be_same(nameless: Person, named: Person, told: str, alone: bool) -> bool:
    """Whether a nameless and a named person may be one, by gender, title, distance and how both are told."""
    last = max((at for at in _mentions(told, nameless) if at < named.first), default=-_LATER)
    since = named.first - last
    if since > _LATER or not _genders_may_agree(named, nameless, told):
        return False
    if _is_introduced_later(nameless, named, told):
        return True
    title, noun = bare(named.name).split()[0].strip("."), nameless.role
    if (title in lexicon.TITLES - GENTLE and " " in named.name) or (title in GENTLE and noun in _PERSON_NOUNS):
        ranked = title in lexicon.RANKS.get(noun, ())
        plain = noun in _PERSON_NOUNS and title not in lexicon.KIN
        indefinite = _INDEFINITE.match(told, nameless.first) is not None
        return (ranked or plain) and named.first - nameless.first < _SOON and indefinite
    if title in GENTLE and noun in _YOUNG | lexicon.KIN:
        return False
    if noun in lexicon.KIN and _POSSESSED.match(told, nameless.first) is None:
        return False
    if (
        since > (_LATER if alone else _SOON)
        or noun in _PASSING
        or _is_brought_in(named, told)
        or appear_together(told, nameless, named)
    ):
        return False
    sentence = re.split(r"[.!?\n]", told[nameless.first :])[0]
    return _GOING.search(sentence) is None and (alone or named.first - nameless.first < _LATER)


def _is_brought_in(named: Person, told: str) -> bool:
    """Whether a name is introduced as a new person: ``Tom came in``, ``Gerald, who owns the place,``."""
    before, after = told[max(0, named.first - 80) : named.first], told[named.first + len(named.name) :][:60]
    return (
        _ARRIVING.match(after.lstrip()) is not None
        or _APPOSED.match(after) is not None
        or _PLACED.search(before) is not None
        or re.search(r"\b(?:saw|and|with|called|named|of|like|about|for|to|than) $", before) is not None
    )


def _is_introduced_later(nameless: Person, named: Person, told: str) -> bool:
    """Whether a name identifies a person seen before: ``A man stood there. It was Goran``."""
    between = told[nameless.first : named.first]
    if len(between) > _SOON or _INDEFINITE.match(between) is None or nameless.role not in GENERIC | _YOUNG:
        return False
    return re.search(r"(?<=\w)(?:: | — | -- )$|[.;] (?:It|This|That|it) (?:was|is) $", between) is not None


# -- one or two --------------------------------------------------------------------------------------------------


@lru_cache(maxsize=2)
def _sentences(told: str) -> tuple[str, ...]:
    """Return the sentences of a text."""
    return tuple(re.split(r"(?<!\bMr)(?<!\bMrs)(?<!\bDr)[.!?\n]", told))


def appear_together(told: str, nameless: Person, named: Person) -> bool:
    """Whether one sentence has both, so that they are two people: ``Bess looked at the old woman``.

    Args:
        told: The story without speeches.
        nameless: A person without a name.
        named: A person with a name.
    """
    names = "|".join(re.escape(alias) for alias in sorted(named.aliases, key=len, reverse=True))
    if not names:
        return False
    noun = re.compile(
        rf"\b(?:an?|the|his|her|their|my) (?:[\w-]+,? ){{0,3}}(?:{re.escape(nameless.role)})\b", re.IGNORECASE
    )
    name = re.compile(rf"\b(?:{names})\b(?!['’]s)", re.IGNORECASE)
    for sentence in _sentences(told):
        if nameless.role not in sentence.lower():
            continue
        one, other = noun.search(sentence), name.search(sentence)
        if one and other and not re.match(r",? (?:named |called )?$", sentence[one.end() : other.start()]):
            return True
    return False


def _genders_may_agree(named: Person, nameless: Person, told: str) -> bool:
    """Whether the genders of two people may agree; an unknown one is taken from the pronouns after it."""
    unsure = named.gender == "unknown" or bool(set(named.aliases) & lexicon.UNISEX)
    gender = gender_by_pronouns(told, rf"(?:{re.escape(named.name)})") if unsure else named.gender
    other = nameless.gender
    if other == "unknown" or nameless.role in _EITHER:
        other = gender_by_pronouns(told, rf"(?:(?:[Aa]n?|[Tt]he) (?:[\w-]+ )?{re.escape(nameless.role)})")
    return _agree(gender, other)


def _agree(gender: str, other: str) -> bool:
    """Whether two genders may be the same."""
    return "unknown" in (gender, other) or gender == other


def merge_people(roster: Roster, named: Person, nameless: Person) -> None:
    """Merge two of the cast into one person, who keeps the name.

    Args:
        roster: The cast; changed in place.
        named: The person who stays.
        nameless: The person who is removed.
    """
    for alias in nameless.aliases:
        roster.add_alias(named, alias)
    named.first = min(named.first, nameless.first)
    named.role = nameless.role if _has_no_name(named) else named.role or nameless.role
    named.kind = nameless.kind
    if nameless.gender != "unknown":
        named.gender = nameless.gender
    for look in ("age", "hair", "face", "outfit", "build"):
        if not getattr(named, look):
            setattr(named, look, getattr(nameless, look))
    roster.remove(nameless)


@rule("people.called_by_nouns")
def add_noun_aliases(roster: Roster, text: str) -> None:
    """Let ``A MOVER`` answer to ``the mover``, though no list knows the noun.

    Args:
        roster: The cast; changed in place.
        text: The script.
    """
    written = TextIndex(text)
    for person in roster.people:
        name = person.name.lower()
        known = name in lexicon.FIRST_NAMES or lexicon.noun_class(name) != "unknown"
        if person.role or known or not name.isalpha():
            continue
        shown = any(_SHOWN.search(text, max(0, at - _PHRASE), at) for at in written.places(name.upper()))
        if shown and any(_MEANT.search(text, max(0, at - _PHRASE), at) for at in written.places(name)):
            person.role = name
