"""Walk-ons: people of a screenplay in small letters or without a name: ``A waitress brings the soup``."""

from __future__ import annotations

import re
from collections import Counter

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER
from storyblender.agents.director.reader.cast.animals import add_animals
from storyblender.agents.director.reader.cast.prose_names import names_in
from storyblender.agents.director.reader.language.morphology import FORMS, form_kind, is_person_noun
from storyblender.agents.director.reader.language.person_nouns import PersonNoun, find_person_nouns
from storyblender.agents.director.reader.manuscript import Manuscript, Paragraph, without_brackets, without_quotations
from storyblender.agents.director.reader.people.look import read_description
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import singular

_BETWEEN = r"(?:\s*,? (?:who|which|that)\b[^.;,]*,?|\s*,\s[^.;,]*,|\s+(?:in|on|with|of|at|from|behind|by)\s[^.;,]*?)?"
_FOLLOWING = re.compile(rf"{_BETWEEN}\s+(?:[a-z]+ly\s+|both\s+|all\s+|then\s+)?([a-z]+)\b")
"""The verb after a person, past any description in between."""
_ARRIVING = re.compile(
    r"(?:^|[.!?;]\s+|,\s+|\band\s+)(?:[Tt]here|[Hh]ere|[Oo]ut|[Uu]p|[Dd]own|[Nn]ext|[Tt]hen|"
    rf"(?:{'|'.join(f'[{word[0].upper()}{word[0]}]{word[1:]}' for word in sorted(lexicon.PREPOSITIONS))})\b[^.!?;,]*?)"
    r"\s+([a-z]+)\s+$"
)
"""``In walks a waiter``, ``At the bar sits a woman``."""
_NAMED_AFTER = re.compile(
    rf"[^.!?]{{0,60}}?(?:[,:(]|--|—|–)\s*(?:an? |the )?[{UPPER}]{{2,}}[{UPPER}'’ -]*(?![{LOWER}])"
)
"""``a bride, SELMA``, ``a kid with a broom: KITTY``: a noun that introduces a named person."""
_LIKENED = re.compile(r"\b(?:like|as|than|of|way|being|is|was|are|were|be|become|becomes|not|no)\s+$", re.IGNORECASE)
_PAINTED = re.compile(
    r"\b(?:painted|painting|margin|poster|portrait|photo\w*|mural|fresco|statue|advert\w*)\b[^.!?]*$", re.I
)
_APPOSED = re.compile(r"[A-Z]\S*(?:\s*\([^)]*\))?,\s+$")
_THE_KNOWN = frozenset({"man", "woman", "boy", "girl", "child", "lady", "guy", "figure", "kid", "person", "couple"})
"""Nouns that with ``the`` refer to a person the page has already shown."""
_STAFF = lexicon.words("staff")
"""Staff that may take ``the`` without an introduction: the bartender, where there is a bar."""
_NOBODY = lexicon.words("nobody")
_PLURAL = re.compile(
    r"(?:(?<=[.!?]\s)|(?<=[.!?]\s\s)|^)([A-Z][a-z]+s|[A-Z][a-z]+men|People)\s+(?:[a-z]+ly\s+)?([a-z]+)", re.M
)
_MOST = 6
_BACK = 80
"""Characters before a person noun that are searched."""
_NAME_ACTS = re.compile(r"(?:,? who|, [^.,;]{0,40},)?\s+(?:[a-z]+ly\s+)?([a-z]+)\b")
_FINITE = frozenset({"3sg", "past", "aux"})


def add_walk_ons(roster: Roster, script: Manuscript) -> None:
    """Cast the people who act in a screenplay without capitals or a cue.

    Args:
        roster: The people with capitals or a cue; changed.
        script: A screenplay.
    """
    told = [paragraph for paragraph in script.paragraphs if paragraph.kind == "action"]
    _add_named(roster, script, told)
    low = script.text.lower()
    for paragraph in told:
        text = without_quotations(without_brackets(paragraph.body))
        for phrase in find_person_nouns(text):
            told_before = phrase.determiner == "the" and (
                phrase.noun not in _STAFF or phrase.noun in low[: paragraph.start + phrase.start]
            )
            if not (told_before or _is_known(roster, phrase, text)) and _does_something(phrase, text):
                _add(roster, phrase, paragraph.start)
        for match in _PLURAL.finditer(text):
            _add_plural(roster, match, paragraph.start)
    add_animals(roster, script)
    roster.sort()


def _is_known(roster: Roster, phrase: PersonNoun, text: str) -> bool:
    """Whether a phrase means a member of the cast, or no particular person."""
    if phrase.noun in _NOBODY | lexicon.ANIMALS or phrase.noun not in lexicon.COMMON_PERSON_NOUNS:
        return True
    if _NAMED_AFTER.match(text, phrase.end) or _fits_cast_member(roster, phrase):
        return True
    definite = phrase.determiner not in ("a", "an", "two", "three", "four", "five")
    if phrase.noun in _THE_KNOWN and (definite or text[: phrase.start].lower().endswith("the ")):
        return True
    names = {phrase.noun, " ".join((*phrase.adjectives, phrase.noun))}
    return any(names & {person.role, *person.aliases} for person in roster.people)


def _fits_cast_member(roster: Roster, phrase: PersonNoun) -> bool:
    """Whether a phrase is another word for a fitting member of the cast: ``the detective``, ``her father``."""
    if phrase.determiner in ("a", "an") or phrase.plural:
        return False
    kin = phrase.noun in lexicon.KIN
    if not (kin or phrase.noun in lexicon.CALLINGS | lexicon.COMPANY | lexicon.ARRIVALS | lexicon.HOSTS):
        return False
    gender = lexicon.gender_of_word(phrase.noun)
    people = [person for person in roster.people if person.kind == "human" and person.count == 1]
    return len(people) > kin and any(
        "unknown" in (gender, person.gender) or gender == person.gender for person in people
    )


def _does_something(phrase: PersonNoun, text: str) -> bool:
    """Whether a person noun is the subject of a verb, or follows a verb of coming or being there."""
    before = text[max(0, phrase.start - _BACK) : phrase.start]
    if (
        _PAINTED.search(before)
        or _LIKENED.search(before)
        or _APPOSED.search(before)
        or re.match(r"['’]", text[phrase.end :])
    ):
        return False
    arriving = _ARRIVING.search(before)
    form = FORMS.get(arriving.group(1)) if arriving else None
    if form and form.kind in _FINITE and form.lemma in lexicon.INVERTING:
        return True
    several = phrase.plural or phrase.noun in lexicon.CROWDS
    after = _FOLLOWING.match(text, phrase.end)
    if after is None or _is_verb(after.group(1), several):
        return after is not None
    described = re.match(r"\s+(?:in|on|with|of|at|from|behind|by)\s[^.;,]*", text[phrase.end :])
    return described is not None and any(form_kind(word) == "3sg" for word in described.group().split())


def _is_verb(word: str, several: bool) -> bool:
    """Whether a word after a subject is its verb, ``are`` and ``is`` included."""
    kind = form_kind(word)
    return kind in _FINITE | {"ing"} or (several and kind == "base" and word not in lexicon.PREPOSITIONS)


@rule("people.noun_that_acts")
def _add(roster: Roster, phrase: PersonNoun, start: int) -> None:
    """Add a walk-on."""
    look = " ".join(phrase.adjectives)
    known = [person for person in roster.people if person.role == phrase.noun]
    name = f"{look} {phrase.noun}" if known and look else phrase.noun
    person = roster.add(name, start + phrase.start)
    number = lexicon.NUMBERS.get(phrase.determiner, 3 if phrase.plural else 1)
    if number > 1 and person.kind != "animal":
        person.kind, person.count = "group", min(max(person.count, number), _MOST)
    if look:
        read_description(roster, person, look)


@rule("people.plural_that_acts")
def _add_plural(roster: Roster, match: re.Match[str], start: int) -> None:
    """Add a group without a determiner: ``Soldiers run past.``, ``Children laugh``."""
    noun = singular(match.group(1).lower())
    if (
        not is_person_noun(noun)
        or noun in lexicon.ANIMALS | _NOBODY
        or form_kind(match.group(2)) not in ("base", "past", "aux", "ing")
    ):
        return
    if any(noun in (person.role, *person.aliases) for person in roster.people):
        return
    person = roster.add(noun, start + match.start(1))
    person.kind, person.count = "group", max(person.count, 3)


@rule("people.name_that_acts")
def _add_named(roster: Roster, script: Manuscript, told: list[Paragraph]) -> None:
    """Add names never in capitals: a first name that acts once, or any name that acts twice."""
    acts: Counter[str] = Counter()
    first: dict[str, int] = {}
    headings = {word for p in script.paragraphs if p.kind == "heading" for word in re.findall(r"\w+", p.text.lower())}
    for paragraph in told:
        text = without_quotations(without_brackets(paragraph.body))
        for at, name in names_in(text, paragraph.start):
            words = name.lower().split()
            known = roster.find(name) or any(roster.find(word) for word in words)
            if known or set(words) & headings:
                continue
            verb = _NAME_ACTS.match(text, at - paragraph.start + len(name))
            if verb and form_kind(verb.group(1)) in _FINITE - {"aux"}:
                acts[name] += 1
                first.setdefault(name, at)
    for name, times in acts.items():
        if times > 1 or name.lower().split()[0] in lexicon.FIRST_NAMES | lexicon.TITLES:
            roster.add(name, first[name])
