"""Inserts in camera directions: ``CLOSE ON the ring, alone on the table``, ``INSERT - the coin in his palm``."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.deeds.outcomes import hold
from storyblender.agents.director.reader.language.phrases import NounPhrase, find_phrases
from storyblender.agents.director.reader.language.rewrite import regularise
from storyblender.agents.director.reader.language.words import Word, tokenize
from storyblender.agents.director.reader.people.coreference import resolve_pronoun
from storyblender.agents.director.reader.people.thing_reference import ASIDE, raise_things
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import CameraNote, Person
from storyblender.agents.director.rules import rule

_GRIPS = frozenset({"hand", "palm", "fist", "finger", "grip"})
_SOLID = ("prop", "set_piece")


@rule("things.shown_by_camera")
def note_insert(state: ReaderState, camera: CameraNote) -> str | None:
    """Note the thing that a direction shows, with its owner if it is in a hand; return its id or None.

    Args:
        state: Its unit is the one the direction holds for.
        camera: The direction.
    """
    words = regularise(tokenize(camera.subject, state.unit.start))
    phrases = find_phrases(words)
    nouns = [phrase.noun for phrase in phrases if phrase.noun and phrase.noun.kind == "thing"]
    if not nouns or lexicon.noun_class(nouns[0].key) not in _SOLID:
        return None
    thing = state.inventory.id_of(nouns[0].key, state.unit.start)
    state.inventory.note(thing, "shown")
    state.unit.things.append(thing)
    for noun in nouns[1:]:
        for person in _hand_owners(state, noun, words) if noun.head in _GRIPS else ():
            state.enter(person)
            hold(state, person.id, thing)
    _set_it(state, thing)
    return thing


@rule("relations.shown_by_camera")
def locate_insert(state: ReaderState, thing: str, words: list[Word]) -> None:
    """State where the shown thing is, and let ``it`` mean the thing: ``alone on the table``.

    Args:
        state: The state after the sentence.
        thing: What was shown.
        words: The rest of the sentence, in which nobody does anything.
    """
    phrases = find_phrases(words)
    for before, phrase in pairwise(phrases):
        noun = phrase.noun
        kind = lexicon.relation_of(before.text) if before.kind == "preposition" else None
        if kind and noun and noun.kind == "thing" and lexicon.noun_class(noun.key) in _SOLID:
            state.relate(thing, kind, state.inventory.id_of(noun.key, words[noun.index].start))
    _set_it(state, thing)


def _set_it(state: ReaderState, thing: str) -> None:
    """Let ``it`` mean the shown thing."""
    raise_things(state, [thing], ASIDE)
    state.discourse.recent_things.insert(0, thing)


def _hand_owners(state: ReaderState, noun: NounPhrase, words: Sequence[Word]) -> list[Person]:
    """Return whose hand a thing is in."""
    if noun.possessor is None:
        return []
    word = words[noun.possessor]
    person = state.find(word.text)
    if person:
        return [person]
    known = lexicon.PRONOUNS.get(word.low, "thing") in ("male", "female")
    return resolve_pronoun(state, word.low, "possessor", (), state.discourse.subjects) if known else []
