"""Where a story names a person, in narration (``His name was Barnaby``) or in speech (``"Ada, get out"``)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal, NamedTuple

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER
from storyblender.agents.director.reader.manuscript import QUOTATION, QUOTATION_MARKS, Manuscript, without_quotations
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

Way = Literal["own", "told", "called"]

_TITLE = "|".join(sorted((re.escape(title) for title in lexicon.TITLES), key=len, reverse=True))
_NAME = rf"(?:(?i:{_TITLE})\.?\s)?[{UPPER}][{LOWER}]+(?:['’-][{UPPER}][{LOWER}]+)?(?:\s[{UPPER}][{LOWER}]+)?"
_ENDS = r"(?=\s*(?:[.,!?;:…—–-]|$|\band\b|\bfrom\b|\bof\b))"
_OWN = re.compile(
    rf"(?:\bI am|\bI['’]m|\b[Mm]y name(?: is|['’]s)|\b[Nn]ame['’]s|\b[Cc]alls? me|\bcalled|\b[Ii]t['’]s)"
    rf"\s({_NAME}){_ENDS}"
)
_CALLED = re.compile(
    rf"(?:^|[.!?]\s+)(?:(?:Oh|Ah|Well|Hey|Hello|Hi|Come|Come on|Come here|No|Yes|Now|Please|And|Evening|Morning)[, ]+)?"
    rf"({_NAME})(?=\s*[,!?.—–-])"
    rf"|,\s({_NAME})(?=\s*(?:[,!?.—–…]|$))"
    rf"|\b(?:[Tt]his is|[Tt]hat['’]s|[Mm]eet|[Yy]ou are|[Yy]ou['’]re|[Yy]ou must be|[Aa]re you)\s({_NAME}){_ENDS}"
)
_TOLD = re.compile(
    rf"\b(?P<whose>[Hh]is|[Hh]er|[Ii]ts|[Tt]heir)\s(?:first |last )?name\s(?:is|was)\s(?P<told>{_NAME})"
    rf"|\b(?:(?:who|he|she)\s(?:was|is)\s(?:called|named)|whose\sname\s(?:was|is)|call(?:ed|s)\s(?:him|her|it)(?:self)?"
    rf"|(?:introduced|introduces)\s(?:him|her)self\sas|gave\s(?:his|her)\sname\sas)\s(?P<other>{_NAME})"
)
_TAG = r"(?:name ?tag|tag|badge|label|name ?plate|plate)"
_WORN = re.compile(
    rf"\b([{UPPER}][\w'’-]+),? (?:says|said|reads|read) (?:the|his|her|a) {_TAG}\b"
    rf"|\b{_TAG} (?:on (?:his|her|the) \w+ )?(?:says|said|reads|read) ([{UPPER}][\w'’-]+)"
)
"""``IRMA, says the tag on her jacket``."""
_TAG_WORDS = re.compile(r"[^.!?]{0,2000}")
_ASKED = re.compile(r"\bname\b|\b[Ww]ho are you\b|\bI['’]m [A-Z]|\bI am [A-Z]")
"""What the answer is a name to: ``"You got a name?" "Silas."``"""


class Naming(NamedTuple):
    """A place in the text where a person gets a name."""

    at: int
    name: str
    way: Way
    """Said by themselves, told by the story, or called so by a person."""
    tag: str
    """What the story says around the words in its paragraph: ``said the mole``."""
    gender: str = "unknown"
    """Of the pronoun in ``his name was``."""
    alone: bool = False
    """Whether nothing else is said."""


def narration_only(script: Manuscript) -> str:
    """Return the script with everything but narration blanked, offsets unchanged."""
    told = [" " if letter != "\n" else letter for letter in script.text]
    for paragraph in script.paragraphs:
        told[paragraph.start : paragraph.end] = without_quotations(paragraph.raw)
    return "".join(told)


def _next_words(told: str, at: int) -> str:
    """Return the words after an offset."""
    words = _TAG_WORDS.match(told, at)
    return words[0] if words else ""


def find_namings(script: Manuscript) -> list[Naming]:
    """Return every place where a person is named, in reading order."""
    found: list[Naming] = []
    asked = False
    for paragraph in script.paragraphs:
        told = without_quotations(paragraph.raw)
        for match in _TOLD.finditer(told):
            group = "told" if match.group("told") else "other"
            gender = lexicon.PRONOUNS.get((match.group("whose") or "").lower(), "unknown")
            found.append(Naming(paragraph.start + match.start(group), match.group(group), "told", "", gender))
        for match in _WORN.finditer(told):
            name = match.group(1) or match.group(2)
            found.append(Naming(paragraph.start + match.start(), name.capitalize(), "told", ""))
        for quotation in QUOTATION.finditer(paragraph.raw):
            said = quotation.group(0).strip(QUOTATION_MARKS)
            at = paragraph.start + quotation.start() + 1
            tag = " ".join(_next_words(told, quotation.end()).split())[:60]
            own = [(match.start(1), match.group(1)) for match in _OWN.finditer(said)]
            found += [Naming(at + place, name, "own", tag) for place, name in own]
            alone = re.fullmatch(rf"({_NAME})[,.!]?", said)
            if alone and asked:
                own.append((0, alone.group(1)))
                found.append(Naming(at, alone.group(1), "own", tag))
            asked = _ASKED.search(said) is not None or (asked and alone is not None)  # the other may say his, too
            for match in _CALLED.finditer(said):
                group = next(index for index in (1, 2, 3) if match.group(index))
                if (match.start(group), match.group(group)) not in own:
                    found.append(
                        Naming(at + match.start(group), match.group(group), "called", tag, alone=alone is not None)
                    )
    return sorted(found)


_TITLES = "|".join(sorted((re.escape(title) for title in lexicon.TITLES - lexicon.KIN), key=len, reverse=True))
_TITLED = rf"(?:(?i:{_TITLES}))\.?(?: [{UPPER}][{LOWER}]+)+"
_ADDRESSED = re.compile(
    rf"(?:^|, )(?P<called>{_TITLED})(?=\s*(?:[,!?.]|$))"
    rf"|(?P<guessed>{_TITLED})(?=,? I (?:believe|presume|suppose|think))"
    rf"|(?:I am|I['’]m|[Mm]y name is) (?P<own>{_TITLED})"
)
_SOON, _JUST_BEFORE = 800, 200
"""Characters between ``a tall, burly man`` and his name, told after or before."""


def find_spoken_names(script: Manuscript) -> list[tuple[int, str]]:
    """Return the titled names by which people are introduced or addressed in speech, with offsets."""
    found: list[tuple[int, str]] = []
    for paragraph in script.paragraphs:
        for quotation in QUOTATION.finditer(paragraph.raw):
            said = quotation.group(0).strip(QUOTATION_MARKS)
            at = paragraph.start + quotation.start() + 1
            found += [(at + match.start(), next(filter(None, match.groups()))) for match in _ADDRESSED.finditer(said)]
    return found


def name_called_soon(roster: Roster, spoken: Sequence[tuple[int, str]], at: int, noun: str) -> str:
    """Return the name by which ``a tall, burly man`` is called soon after he came in, or an empty string.

    Args:
        roster: The cast so far: the name is nobody else's.
        spoken: From ``find_spoken_names``.
        at: Offset of the noun phrase.
        noun: Its head.
    """
    gender = lexicon.gender_of_word(noun)
    for place, name in spoken:
        title = bare(name).split()[0].strip(".")
        known = roster.find(name) or roster.find(name.split()[-1]) or _people_with_title(roster, name)
        fits = title in lexicon.RANKS.get(noun, (title,)) and lexicon.TITLE_GENDER.get(title, gender) == gender
        if -_JUST_BEFORE < place - at < _SOON and not known and fits:
            return name
    return ""


def title_noun(name: str) -> str:
    """Return the noun that a title stands for: ``doctor`` for Dr. Lebedev."""
    title = bare(name).split()[0].strip(".")
    return lexicon.TITLE_SYNONYMS.get(title, title)


@rule("people.title")
def name_by_title(roster: Roster, spoken: Sequence[tuple[int, str]]) -> None:
    """Name people by a titled address: after ``"You win, Doctor Lebedev"`` the doctor has a name.

    Args:
        roster: The cast; changed in place.
        spoken: Names said in speech, with offsets.
    """
    for _, name in spoken:
        words = bare(name).split()
        for person in [] if roster.find(words[-1]) else _people_with_title(roster, name):
            roster.add_alias(person, bare(name))
            roster.add_alias(person, words[-1])


def _people_with_title(roster: Roster, name: str) -> list[Person]:
    """Return the people who have the title of a name as their role."""
    return [person for person in roster.people if person.role == title_noun(name)][:1]
