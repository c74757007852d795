"""Names a story only has its people say: ``"Sergeant-Major Morris," he said, introducing him``."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.naming import LOWER, UPPER
from storyblender.agents.director.reader.manuscript import QUOTATION, QUOTATION_MARKS, Manuscript
from storyblender.agents.director.reader.people.roster import Roster, bare
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_TITLES = "|".join(sorted((re.escape(title) for title in lexicon.TITLES - lexicon.KIN), key=len, reverse=True))
_TITLED = rf"(?:(?i:{_TITLES}))\.?(?: [{UPPER}][{LOWER}]+)+"
_ADDRESSED = re.compile(
    rf"(?:^|, )(?P<called>{_TITLED})(?=\s*(?:[,!?.]|$))"
    rf"|(?P<guessed>{_TITLED})(?=,? I (?:believe|presume|suppose|think))"
    rf"|(?:I am|I['’]m|[Mm]y name is) (?P<own>{_TITLED})"
)
_SOON, _JUST_BEFORE = 800, 200
"""Characters between ``a tall, burly man`` and his name, told after or before."""


def spoken_names(script: Manuscript) -> list[tuple[int, str]]:
    """Find titled names by which somebody is introduced or called, with their offsets."""
    found: list[tuple[int, str]] = []
    for paragraph in script.paragraphs:
        for quotation in QUOTATION.finditer(paragraph.raw):
            said = quotation.group(0).strip(QUOTATION_MARKS)
            at = paragraph.start + quotation.start() + 1
            found += [(at + match.start(), next(filter(None, match.groups()))) for match in _ADDRESSED.finditer(said)]
    return found


def announced(roster: Roster, spoken: Sequence[tuple[int, str]], at: int, noun: str) -> str:
    """The name by which ``a tall, burly man`` is called soon after he came in, or an empty string.

    Args:
        roster: The cast so far: the name is nobody else's.
        spoken: From ``spoken_names``.
        at: Offset of the noun phrase.
        noun: Its head.
    """
    gender = lexicon.gender_of_word(noun)
    for place, name in spoken:
        title = bare(name).split()[0].strip(".")
        known = roster.find(name) or roster.find(name.split()[-1]) or _called_by_role(roster, name)
        fits = title in lexicon.RANKS.get(noun, (title,)) and lexicon.TITLE_GENDER.get(title, gender) == gender
        if -_JUST_BEFORE < place - at < _SOON and not known and fits:
            return name
    return ""


def title_noun(name: str) -> str:
    """The noun a title stands for: ``doctor`` for Dr. Lebedev."""
    title = bare(name).split()[0].strip(".")
    return lexicon.TITLE_SYNONYMS.get(title, title)


@rule("people.title")
def call_by_title(roster: Roster, spoken: Sequence[tuple[int, str]]) -> None:
    """``"You win, Doctor Lebedev"``: the doctor has a name."""
    for _, name in spoken:
        words = bare(name).split()
        for person in [] if roster.find(words[-1]) else _called_by_role(roster, name):
            roster.call(person, bare(name))
            roster.call(person, words[-1])


def _called_by_role(roster: Roster, name: str) -> list[Person]:
    return [person for person in roster.people if person.role == title_noun(name)][:1]
