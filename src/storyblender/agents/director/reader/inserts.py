"""The thing a camera direction shows: ``CLOSE ON the ring, alone on the table``, ``INSERT - the coin in his palm``."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.deeds.outcomes import hold
from storyblender.agents.director.reader.language.phrases import NounPhrase, find_phrases
from storyblender.agents.director.reader.language.rewrite import regularise
from storyblender.agents.director.reader.language.words import Word, tokenize
from storyblender.agents.director.reader.people.coreference import resolve_pronoun
from storyblender.agents.director.reader.people.thing_reference import ASIDE, weigh
from storyblender.agents.director.reader.state import Stage
from storyblender.agents.director.reading import CameraNote, Person
from storyblender.agents.director.rules import rule

_GRIPS = frozenset({"hand", "palm", "fist", "finger", "grip"})
_SOLID = ("prop", "set_piece")


@rule("things.shown_by_camera")
def show_thing(stage: Stage, camera: CameraNote) -> str | None:
    """Note the thing that a direction shows; in somebody's hand it is theirs. Return its id.

    Args:
        stage: Its unit is the one the direction holds for.
        camera: The direction.
    """
    words = regularise(tokenize(camera.subject, stage.unit.start))
    phrases = find_phrases(words)
    nouns = [phrase.noun for phrase in phrases if phrase.noun and phrase.noun.kind == "thing"]
    if not nouns or lexicon.noun_class(nouns[0].key) not in _SOLID:
        return None
    thing = stage.inventory.id_of(nouns[0].key, stage.unit.start)
    stage.inventory.seen(thing, "shown")
    stage.unit.things.append(thing)
    for noun in nouns[1:]:
        for person in _owners(stage, noun, words) if noun.head in _GRIPS else ():
            stage.enter(person)
            hold(stage, person.id, thing)
    _mean(stage, thing)
    return thing


@rule("relations.shown_by_camera")
def lies_there(stage: Stage, thing: str, words: list[Word]) -> None:
    """``alone on the table``: say where what was shown is; ``it`` is what was shown.

    Args:
        stage: The state after the sentence.
        thing: What was shown.
        words: The rest of the sentence, in which nobody does anything.
    """
    phrases = find_phrases(words)
    for before, phrase in pairwise(phrases):
        noun = phrase.noun
        kind = lexicon.relation_of(before.text) if before.kind == "preposition" else None
        if kind and noun and noun.kind == "thing" and lexicon.noun_class(noun.key) in _SOLID:
            stage.relate(thing, kind, stage.inventory.id_of(noun.key, words[noun.index].start))
    _mean(stage, thing)


def _mean(stage: Stage, thing: str) -> None:
    """Let ``it`` mean what was shown."""
    weigh(stage, [thing], ASIDE)
    stage.discourse.recent_things.insert(0, thing)


def _owners(stage: Stage, noun: NounPhrase, words: Sequence[Word]) -> list[Person]:
    """Whose hand it is."""
    if noun.possessor is None:
        return []
    word = words[noun.possessor]
    person = stage.find(word.text)
    if person:
        return [person]
    known = lexicon.PRONOUNS.get(word.low, "thing") in ("male", "female")
    return resolve_pronoun(stage, word.low, "possessor", (), stage.discourse.subjects) if known else []
