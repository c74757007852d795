"""Resolves the pronouns of an introduction, which is no clause: ``TEO (33, a bag over his shoulder)``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import takewhile

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.words import Word, tokenize
from storyblender.agents.director.reader.people.coreference import resolve_pronoun
from storyblender.agents.director.reader.people.person_reference import gender_fits, resolve_mention
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import Gender

_BRACKETS = re.compile(r"\(([^()]*)\)")
_GENDERED: dict[str, Gender] = {"male": "male", "female": "female"}


@rule("people.pronouns_of_introduction")
def resolve_introduction_pronouns(state: ReaderState, written: Sequence[Word], end: int) -> None:
    """Record the pronouns that are in no clause: they mean the person named before them.

    Args:
        state: The state after the clauses of the sentence.
        written: The words of the sentence as they are written, what is in brackets left out.
        end: Where it ends in the script.
    """
    start = written[0].start
    text = state.reading.screenplay.text[start:end]
    known = {at for at, _, _ in takewhile(lambda pronoun: pronoun[0] >= start, reversed(state.reading.pronouns))}
    words = [word for word in written if word.mention is None and word.start not in known]
    for bracket in _BRACKETS.finditer(text):
        words += tokenize(bracket.group(1), start + bracket.start(1))
    for word in sorted(words, key=lambda word: word.start):
        gender = _GENDERED.get(lexicon.PRONOUNS.get(word.low, ""))
        people = _person_before(state, written, word, gender) if gender else []
        if people:
            state.record_pronoun(word.start, word.text, [person.id for person in people])


def _person_before(state: ReaderState, written: Sequence[Word], word: Word, gender: Gender) -> list[Person]:
    """Return the person named last before a pronoun whom it can mean, else whom it means in a clause."""
    named = [each.mention for each in written if each.mention and each.start < word.start]
    people = resolve_mention(state, named[-1]) if named else []
    if len(people) == 1 and gender_fits(people[0], gender):
        if people[0].gender == "unknown":
            people[0].gender = gender
        return people
    return resolve_pronoun(state, word.low, "possessor", (), state.discourse.subjects, people)
