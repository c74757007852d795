"""What a person looks like as described in the script: age, build, hair, clothes, face, gender."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.morphology import is_person_noun
from storyblender.agents.director.reader.people.roster import Roster
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import singular
from storyblender.memory.vocabulary import Gender

_GENDER_WORDS: dict[str, Gender] = {
    "moustache": "male", "mustache": "male", "moustached": "male", "beard": "male", "bearded": "male", "goatee": "male",
    "woman": "female", "female": "female", "girl": "female", "lady": "female",
    "man": "male", "male": "male", "boy": "male", "gentleman": "male",
}  # fmt: skip
_LIKELY: dict[str, Gender] = {
    "pretty": "female", "beautiful": "female", "blonde": "female", "brunette": "female", "pregnant": "female",
    "handsome": "male", "balding": "male", "unshaven": "male", "stubbled": "male",
}  # fmt: skip
"""Words that are said of one gender mostly: they decide where the name does not."""


@rule("looks.described")
def read_description(roster: Roster, person: Person, phrase: str) -> None:
    """Read a description into a person: ``35, lean, short black hair, grey trench coat``.

    Args:
        roster: The cast.
        person: Takes what is said; what is known already stays.
        phrase: The words in brackets after a name, or the apposition.
    """
    for part in re.split(r",|;| with | and ", phrase):
        part = " ".join(part.split())
        words = part.lower().split()
        if not words:
            continue
        if age := age_phrase(part):
            person.age = age
            _keep_surname(person)
            continue
        if words[-1] in lexicon.SPELLED_AGES and len(words) < 3:
            person.age = person.age or lexicon.SPELLED_AGES[words[-1]]
            continue
        _file_part(person, part, words)
        head = _head_noun(words)
        _set_role(roster, person, part, head)
        for word in words:
            if word in _GENDER_WORDS:
                person.gender = _GENDER_WORDS[word]
            elif word in _LIKELY and (person.gender == "unknown" or lexicon.UNISEX & set(person.aliases)):
                person.gender = _LIKELY[word]
            told = lexicon.gender_of_word(word) if word == head and is_person_noun(word) else "unknown"
            if told != "unknown" and (person.gender == "unknown" or word in lexicon.KIN):
                person.gender = told
            if not person.age and (word in lexicon.AGE_WORDS or word in lexicon.AGE_NOUNS):
                person.age = lexicon.AGE_WORDS.get(word) or lexicon.AGE_NOUNS[word]
            if not person.role and word in lexicon.NEUTER_ROLES:
                person.role = word
            likened = re.search(r"\bof an? ", part) is not None  # a bear of a man
            if word == head and word in lexicon.MACHINES:
                person.kind, person.role = "human", word  # MULE, a robot
            if word in lexicon.ANIMALS and word == head and not likened and _is_alive(part):
                person.kind, person.role = "animal", word
                roster.add_alias(person, word)


def _is_alive(part: str) -> bool:
    """Whether a part of a description is about a live animal, not a hot dog: ``a fox in a green coat``."""
    words = part.lower().split()
    end = next(
        (i for i, word in enumerate(words) if i and word in lexicon.PREPOSITIONS | {"who", "wearing"}), len(words)
    )
    return lexicon.noun_class(" ".join(words[:end])) != "prop"


def _keep_surname(person: Person) -> None:
    """Keep a surname such as ``DESMOND FOX`` from making the person an animal."""
    first, *others = person.name.lower().split()
    if person.kind == "animal" and others and first in lexicon.FIRST_NAMES:
        person.kind, person.role, person.gender = "human", "", lexicon.gender_of_word(first)


def _head_noun(words: list[str]) -> str:
    """Return the noun that a part of a description is about: ``robot`` of ``a robot in a cap``."""
    end = next((i for i, word in enumerate(words) if i and word in lexicon.PREPOSITIONS | {"who"}), len(words))
    return words[end - 1]


def _set_role(roster: Roster, person: Person, part: str, head: str) -> None:
    """Set what a person is, if unknown: ``DADI, her grandmother``, ``PIKE, the district attorney``."""
    told = re.match(r"(?:the|a|an|her|his|their|[\w.]+['’]s) ", part, re.IGNORECASE)
    vague = head in _GENDER_WORDS or head in lexicon.YOUNG_NOUNS | lexicon.ANIMALS | lexicon.CROWDS
    if told and is_person_noun(head) and not vague and person.kind == "human" and head not in person.aliases:
        person.role = person.role or head
        roster.add_alias(person, head)


def _file_part(person: Person, part: str, words: list[str]) -> None:
    """Store one part of a description in the field of the person where it belongs."""
    if any(word in lexicon.HAIR or "hair" in word for word in words):
        person.hair = (*person.hair, part)
    elif part.lower().startswith(("in a ", "in an ")) or any(
        word in lexicon.WORN or singular(word) in lexicon.WORN for word in words
    ):
        person.outfit = (*person.outfit, part)
    elif any(word in lexicon.BUILD for word in words):
        person.build = (*person.build, part)
    elif any(word in lexicon.FACE for word in words):
        person.face = (*person.face, part)


def approximate_age(person: Person) -> int:
    """Return a person's age in years for comparison; 30 where the script tells none."""
    number = re.search(r"\d+", person.age)
    return int(number.group(0)) if number else {"infant": 1, "child": 8, "teen": 15}.get(person.age, 30)


_SPELLED = "|".join(sorted(map(re.escape, lexicon.SPELLED_AGES), key=lambda word: (-len(word), word)))
_PART = r"(early|mid|middle|late)(?:[- ]to[- ](?:mid|late))?[- ]+"
_ABOUT = (
    r"(?:age|aged|about|around|some|barely|nearly|almost|maybe|perhaps|pushing|roughly|of|just|only|not yet|over|under)"
)
_AGE = re.compile(
    rf"(?:(?:in )?(?:his|her|their) )?(?:{_ABOUT} )*(?:{_PART})?(\d{{1,3}}|{_SPELLED})(['’]?s|[- ]something|ish)?\+?"
    r"(?:[- ](?:years?|yrs?)(?:[- ](?:old|of age))?|[- ]?y/?o|[- ]year[- ]olds?)?"
    r"(?: if (?:he|she|they)(?:['’]s| is|['’]re| are) a day| or so| at (?:most|least)| going on \w+)?",
    re.IGNORECASE,
)
_STAGES = {
    "middle aged": "50s", "middle-aged": "50s", "midlife": "50s", "elderly": "70s", "teenaged": "teen",
    "late teens": "18", "early teens": "13", "mid teens": "15", "preteen": "11", "pre-teen": "11", "toddler": "infant",
    "college age": "20s", "college-aged": "20s", "retirement age": "60s",
}  # fmt: skip
_OLDEST = 120


def age_phrase(phrase: str) -> str:
    """Return the age in a part of a description, in the form casting reads, or an empty string.

    Args:
        phrase: A part without commas: ``mid-30s``, ``about nine years old``.
    """
    words = " ".join(phrase.lower().replace("–", "-").split()).strip(" .!?")
    if words in _STAGES:
        return _STAGES[words]
    match = _AGE.fullmatch(words)
    if match is None:
        return ""
    part, number, plural = match.groups()
    told = lexicon.SPELLED_AGES.get(number, number)
    if told.rstrip("s").isdigit() and int(told.rstrip("s")) > _OLDEST:
        return ""
    if part or (plural and told[-1] == "0"):
        told = f"{told.rstrip('s')}s"
    return f"{'mid' if part == 'middle' else part} {told}" if part else told
