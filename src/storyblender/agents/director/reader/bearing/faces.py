"""Facial expressions (``Furious, Otto``) and gaze at nothing in the set: up, aside, into the camera, eyes closed."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.words import Word, joined
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

_NEGATIONS = lexicon.words("negations")
_LOOK_BACK = 4
"""Words before an expression in which a negation is looked for."""


@rule("bearing.face")
def note_expressions(state: ReaderState, words: Sequence[Word], people: Sequence[Person]) -> None:
    """Note the facial expressions in a sentence, each with its person.

    Args:
        state: Its unit takes the expressions.
        words: The sentence.
        people: The people of the sentence, or of the one before if it names none.
    """
    for at, word in enumerate(words):
        expression = lexicon.EXPRESSION_OF_WORD.get(word.low)
        if expression is None or word.mention or word.quotation or _is_denied(words, at) or _is_of_a_thing(words, at):
            continue
        for person in _owner_of_expression(state, words, at) or people:
            state.unit.expressions[person.id] = expression


def _is_denied(words: Sequence[Word], at: int) -> bool:
    """Whether a negation stands before a word."""
    return any(word.low in _NEGATIONS for word in words[max(0, at - _LOOK_BACK) : at])


def _is_of_a_thing(words: Sequence[Word], at: int) -> bool:
    """Whether a word of mood describes a thing: ``an angry sea``, ``a sad little flag``."""
    for word in words[at + 1 : at + 3]:
        if word.mention:
            return False
        noun_class = lexicon.noun_class(word.low) if word.text.isalpha() else "unknown"
        if noun_class in ("prop", "set_piece", "scenery", "worn"):
            return True
        if not word.text.isalpha() or word.low in lexicon.PREPOSITIONS | lexicon.CONJUNCTIONS:
            return False
    return False


def _owner_of_expression(state: ReaderState, words: Sequence[Word], at: int) -> list[Person]:
    """Return the last person named before the word, or right after it: ``Furious, Otto leaves``."""
    if at > 2 and words[at - 1].text == "," and state.sentence.subjects:
        return []  # Otto looks at Nora, puzzled.
    for index in range(at - 1, -1, -1):
        if words[index].text in ";:" and index:
            break
        people = _people_of(state, words, index)
        if people:
            return people
    following = next(
        (people for index in range(at + 1, min(at + 4, len(words))) if (people := _people_of(state, words, index))), []
    )
    return following if at < 2 else []


def _people_of(state: ReaderState, words: Sequence[Word], index: int) -> list[Person]:
    """Return the people whom the word at an index mentions."""
    word = words[index]
    if word.mention and word.mention.people:
        return [person for person in word.mention.people if person.id in state.scene.on]
    return [person for person in state.sentence.pronouns.get(index, ([], None))[0] if person.id in state.scene.on]


_WAYS = ("closed", "camera", "up", "down", "left", "right")
_OPENED = lexicon.BEARING["eyes_open"]
_DENIED = re.compile(r"\b(?:not|n't|never|without|cannot)\b")


@rule("bearing.gaze")
def note_gaze(state: ReaderState, people: Sequence[Person]) -> None:
    """Note the gaze of the people of a sentence; a gaze ends when they look at something.

    Args:
        state: Its unit takes the directions; the scene remembers the people with a gaze.
        people: The people of the sentence.
    """
    turned = state.scene.gaze
    for deed in state.unit.deeds:
        if deed.motion in ("look", "read", "talk", "peek") and deed.target and deed.actor in turned:
            state.unit.gaze[deed.actor] = deed.target
            turned.discard(deed.actor)
    text = joined(state.sentence.words)
    way = next((way for way in _WAYS if lexicon.BEARING[f"gaze_{way}"].search(text)), None)
    if way and people and not _DENIED.search(text):
        for person in people:
            state.unit.gaze[person.id] = way
            turned.add(person.id)
        _forget_the_camera(state, way)
    elif _OPENED.search(text):
        for person in (person for person in people if person.id in turned):
            state.unit.gaze[person.id] = "camera"
            turned.discard(person.id)


def _forget_the_camera(state: ReaderState, way: str) -> None:
    """Drop the camera as a thing: a look at the camera is a look at the audience."""
    if way != "camera":
        return
    cameras = {
        thing for _, thing in state.sentence.things if state.inventory.head(thing) in ("camera", "lens", "audience")
    }
    for thing in cameras:
        state.inventory.forget(thing)
    state.unit.things = [thing for thing in state.unit.things if thing not in cameras]
    for deed in state.unit.deeds:
        deed.target = None if deed.target in cameras else deed.target
