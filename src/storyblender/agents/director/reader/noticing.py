"""Notes how the things of a sentence come up: named, used, held, looked at; comparisons are left out."""

from __future__ import annotations

import re
from collections.abc import Sequence

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clause import Clause
from storyblender.agents.director.reader.language.phrases import NounPhrase, Phrase
from storyblender.agents.director.reader.language.words import Word, joined
from storyblender.agents.director.reader.people.person_reference import may_be_it
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import singular

_OBJECTLIKE = frozenset({"prop", "worn", "unknown", "set_piece"})
_TROPHIES = lexicon.words("trophies")
"""Parts of animals that may be things: the paw, where the story has no animal."""
_RECENT = 7
"""Things ``it`` can mean."""
_WITH = frozenset({"with", "off"})
_USING = frozenset({"on", "with", "into", "at", "through"})
_GRASP = frozenset({"hold", "grip", "go", "grasp"})
"""``takes hold of the rope``, ``lets go of it``."""
_APART = frozenset({"of", "like", "with", "without", "by", "off", "from", "out of"})
"""They put nothing into a hand: ``a ring of hands``, ``like a fist``."""
_DRAWING = frozenset({"draw", "sketch", "paint", "doodle", "chalk", "scrawl"})
_SIZE_OF = re.compile(r"\b(?:size|shape|colou?r|height|length|weight|width) of (?:an? |the )?(?:[a-z-]+ )?$")
"""``a bulb the size of a bath``."""
_NO_THING = "manner"
"""The key of a noun that names no thing: an abstract word."""
_LIKENING = frozenset({"like", "unlike", "as", "than"})
_IN_PLURAL = {"bar": "music"}
"""What is no thing in the plural: four bars, the bars of a cage."""
_NOUN_PHRASE = 4
"""Most words before a noun that belong to it."""
_IDIOMS = frozenset(idiom.replace("_", " ") for idiom in lexicon.words("idioms"))
_SHOWN = frozenset({"picture", "image"})
_SCREENS = lexicon.words("screens")
_TOWARDS = lexicon.words("noticing_towards")
"""Where a person does something: ``sips from a cup``, ``both hands around a mug``, ``reaches for the poker``."""
_ONLY_WORN = frozenset({"touch", "cut", "open", "clean"})
"""Motions that leave a garment on its wearer: ``straightens his tie``."""


@rule("things.named")
def notice_nouns(state: ReaderState, phrases: list[Phrase]) -> None:
    """Note every noun that names a thing; one in capitals is shown.

    Args:
        state: The state before the sentence; the things of its sentence and unit are noted.
        phrases: The phrases of the sentence.
    """
    for index, phrase in enumerate(phrases):
        noun = phrase.noun
        if noun is None or noun.kind != "thing" or lexicon.noun_class(noun.key) == "abstract":
            continue
        if noun.possessor is not None and noun.head in lexicon.OWN_BODY:
            noun.key = lexicon.OWN_BODY[noun.head]
        if noun.plural and noun.head in _IN_PLURAL:
            noun.key = _IN_PLURAL[noun.head]
        if _is_not_present(state, phrases, index, noun):
            noun.key = _NO_THING
            continue
        word = state.sentence.words[noun.index]
        if state.place.weather == "clear" and noun.head in lexicon.WEATHER_WORDS:
            _notice_weather(state, noun.head, phrases[index - 1] if index else None)
        thing = state.inventory.id_of(noun.key, word.start, noun.determiner == "the")
        if noun.head in _TROPHIES and noun.determiner and not any(may_be_it(p) for p in state.roster.people):
            state.inventory.detach(thing)
        state.sentence.things.append((noun.index, thing))
        if noun.plural:
            state.sentence.plurals.add(thing)
        loud = word.text.isupper() and len(word.text) > 2 and singular(word.low) in lexicon.PROPS
        state.inventory.note(thing, "shown" if loud else "seen")
        state.discourse.recent_things = [thing, *state.discourse.recent_things[:_RECENT]]
        if noun.head not in lexicon.BODY and _is_at_a_part(phrases, index):
            state.inventory.note(thing, "met")
        if state.inventory.class_of(thing) in _OBJECTLIKE and thing not in state.unit.things:
            state.unit.things.append(thing)


def _is_not_present(state: ReaderState, phrases: list[Phrase], index: int, noun: NounPhrase) -> bool:
    """Whether a noun names nothing that is there: ``like a tree``, ``in plaster``, the picture on a screen."""
    before = phrases[index - 1] if index else None
    if before is not None and before.kind == "preposition" and before.text in _LIKENING | {"without"}:
        return True
    if noun.determiner == "no" or _is_likened(state.sentence.words, noun.index) or _is_predicate(phrases, index, noun):
        return True
    if _is_in_an_idiom(state, noun) or _is_around_the_room(phrases, index, noun):
        return True
    bare = not noun.determiner and noun.possessor is None and not noun.plural
    if bare and state.sentence.words[noun.index].text.istitle() and lexicon.noun_class(noun.key) == "unknown":
        return True  # not a person of this scene
    if before is not None and before.text == "in" and bare and lexicon.noun_class(noun.key) == "prop":
        return True
    lately = {state.inventory.head(thing) for thing in state.discourse.recent_things}
    return noun.head in _SHOWN and noun.determiner == "the" and bool(lately & _SCREENS)


@rule("things.around_the_room", without=False)
def _is_around_the_room(phrases: list[Phrase], index: int, noun: NounPhrase) -> bool:
    """Whether a noun is the building that a room is in: ``the kitchen of the lighthouse``."""
    if index < 2 or phrases[index - 1].text != "of" or noun.head not in lexicon.PLACES:
        return False
    room = phrases[index - 2].noun
    return room is not None and room.head in lexicon.INDOOR


@rule("things.likened", without=False)
def _is_likened(words: Sequence[Word], at: int) -> bool:
    """Whether a noun is a comparison: ``lights like a spaceship landed``, ``as flat as a mirror``."""
    back = at - 1
    if _SIZE_OF.search(f"{joined(list(words[max(0, at - _NOUN_PHRASE - 1) : at]))} "):
        return True
    while back >= 0 and at - back <= _NOUN_PHRASE and words[back].text.isalpha():
        if words[back].low == "like":
            return back > 0 and words[back - 1].mention is None and words[back - 1].low not in lexicon.PRONOUNS
        if words[back].verb:
            return False
        if words[back].low in ("as", "than"):
            return any(
                word.low in ("as", "more", "less") or word.low.endswith("er") for word in words[max(0, back - 2) : back]
            )
        back -= 1
    return False


@rule("things.said_of_it", without=False)
def _is_predicate(phrases: list[Phrase], index: int, noun: NounPhrase) -> bool:
    """Whether a noun describes something else: ``It's an oven in here``, ``Now it is a boat``."""
    if noun.determiner not in ("a", "an") or index < 2:
        return False
    verb, subject = phrases[index - 1], phrases[index - 2]
    being = verb.kind == "verb" and verb.verb is not None and verb.verb.lemma == "be"
    return being and subject.noun is not None and subject.noun.head in ("it", "this", "that")


@rule("things.idiom", without=False)
def _is_in_an_idiom(state: ReaderState, noun: NounPhrase) -> bool:
    """Whether a noun is part of an idiom: ``in any case``, ``knows the ropes``, ``throws a tantrum``."""
    text = f" {joined(state.sentence.words)} "
    return any(noun.head in idiom and f" {idiom} " in text for idiom in _IDIOMS)


@rule("things.at_a_part_of_body", without=False)
def _is_at_a_part(phrases: list[Phrase], index: int) -> bool:
    """Whether a noun is at a part of a body: ``phone to his ear``, ``both hands around a tin mug``."""
    for preposition, other in ((index + 1, index + 2), (index - 1, index - 2)):
        if min(preposition, other) >= 0 and max(preposition, other) < len(phrases):
            noun = phrases[other].noun
            told = phrases[preposition].kind == "preposition" and phrases[preposition].text not in _APART
            if told and noun and noun.kind == "thing" and noun.head in lexicon.BODY:
                return True
    return False


def _notice_weather(state: ReaderState, word: str, left: Phrase | None) -> None:
    """Note weather in the action: rain hammers the windows; ``like thunder`` is no weather."""
    if left is None or left.kind in ("mark", "link") or left.text in ("in", "through", "into", "under", "of"):
        state.place.weather = lexicon.WEATHER_WORDS[word]


@rule("things.acted_on")
def notice_things(state: ReaderState, clause: Clause, roles: Roles, motion: str | None) -> None:
    """Note how the things of a clause come up: used, held, looked at.

    Args:
        state: The reader's state before the clause.
        clause: The clause.
        roles: Its people and things.
        motion: Motion of its subject, or None.
    """
    inventory = state.inventory
    if motion == "write" and clause.verb in _DRAWING and not any(_is_existing_thing(noun) for noun in clause.object):
        for thing in roles.things:
            inventory.forget(thing)
        roles.things = []
    how = "held" if motion in lexicon.GRIPPING else "handled" if motion in lexicon.HANDLING else "met"
    for thing in roles.things if roles.subjects else ():
        determined = _is_determined(clause.object, inventory.head(thing))
        if how == "held" or not (motion in _ONLY_WORN and inventory.class_of(thing) == "worn"):
            inventory.note(thing, how if how != "met" or determined else "seen", determined)
    grasped = any(noun.head in _GRASP for noun in clause.object)
    for place in roles.places if roles.subjects else ():
        used = how != "met" and not roles.things and place.preposition in _USING
        for thing in place.things:
            if used and inventory.class_of(thing) == "prop":
                inventory.note(thing, "handled")
            elif place.preposition in _WITH or (place.preposition == "of" and grasped):
                inventory.note(thing, "with")
            elif place.preposition in _TOWARDS and _is_determined(place.nouns, inventory.head(thing)):
                inventory.note(thing, "met")
    for thing in roles.subject_things:
        if inventory.class_of(thing) == "prop":
            inventory.note(thing, "related")


def _is_existing_thing(noun: NounPhrase) -> bool:
    """Whether a thing is there: ``paints the door``, while ``draws a tree`` makes none."""
    return noun.determiner not in ("", "a", "an") or noun.possessor is not None


def _is_determined(nouns: Sequence[NounPhrase], head: str) -> bool:
    """Whether a noun with this head has a determiner or an owner, and so is surely a thing."""
    noun = next((n for n in nouns if n.kind == "thing" and n.head == head), None)
    return noun is None or (noun.determiner not in ("", "no")) or noun.possessor is not None
