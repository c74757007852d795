"""Resolves ``them``, ``it`` and ``there`` after prepositions of place, before the clauses of a sentence are read."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.bare_places import THERE
from storyblender.agents.director.reader.language.phrases import Phrase
from storyblender.agents.director.reader.people.coreference import Referents, record_reference
from storyblender.agents.director.reader.places.anchors import CONTAINERS
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.rules import rule

_OF_THINGS = frozenset(
    {"on", "upon", "on top of", "in", "inside", "into", "under", "underneath", "beneath", "below", "above", "among",
     "onto", "atop", "amid"}
)  # fmt: skip
"""What is there is rather with things than with people."""
_UPON = frozenset({"on", "onto", "upon", "in", "into"})
_LANDMARKS = frozenset({"against", "beside", "next to", "near", "by", "behind", "in front of", "alongside"})
_SITTING = frozenset({"sit", "lie_down", "climb", "kneel", "stand"})
_SOLID = ("prop", "set_piece", "worn")


@rule("things.settled")
def resolve_place_pronouns(state: ReaderState, phrases: list[Phrase]) -> None:
    """Record which things ``them``, ``it`` and ``there`` mean after prepositions of place.

    Args:
        state: The reader's state; the nouns of the sentence are noted, its clauses are not read yet.
        phrases: Phrases of the sentence.
    """
    plural: str | None = None
    told: str | None = None
    people = 0
    for index, phrase in enumerate(phrases):
        noun, left = phrase.noun, phrases[index - 1] if index else None
        if noun is None:
            continue
        if noun.kind == "thing":
            thing = _thing(state, phrase)
            solid = state.inventory.class_of(thing) in _SOLID
            plural = thing if solid and (noun.plural or _is_listed(phrases, index)) else plural
            told = thing if solid and (left is None or left.kind != "preposition") else told
        elif noun.head == THERE and left is not None:
            there = _thing_there(state, _start_of_with(phrases, index), left.text)
            state.sentence.pronouns[noun.index] = ([], there)
        elif noun.head == "it" and left is not None and left.kind == "preposition":
            at = _seat_brought(phrases, index) or _moved_to_landmark(phrases, index)
            meant = _thing(state, phrases[at]) if at else told if not people and _opens_clause(phrases, index) else None
            if meant:
                record_reference(state, noun.index, Referents([], meant))
        elif noun.head == "them" and left is not None and left.kind == "preposition":
            inverted = plural is not None and _is_named_after(state, plural, noun.index)
            moved = index > 1 and phrases[index - 2].noun
            if left.text == "between" and moved and moved.plural and moved.kind == "thing":
                here = state.referable_people()  # sets two glasses between them
                record_reference(state, noun.index, Referents(here if len(here) == 2 else []))
                continue
            meant = _recent_plural(state) if inverted or plural is None else plural
            if meant and (left.text in _OF_THINGS or (plural and people < 2)):
                record_reference(state, noun.index, Referents([], meant))
        elif noun.head != "it":
            people += 1 if noun.kind == "person" and noun.mention and noun.mention.kind != "group" else 2
    if plural:
        state.discourse.last_plural = (plural, state.discourse.sentence)


def _thing(state: ReaderState, phrase: Phrase) -> str | None:
    """Return the id of the thing that a phrase names, or None."""
    noun = phrase.noun
    return state.inventory.id_of(noun.key, state.sentence.words[noun.index].start) if noun else None


def _start_of_with(phrases: list[Phrase], index: int) -> int:
    """Return the word index before which the whole is named: ``a wardrobe with a suitcase on top``."""
    had = index > 2 and phrases[index - 3].text == "with"
    return phrases[index - 3 if had else index - 1].first


def _is_listed(phrases: list[Phrase], index: int) -> bool:
    """Whether a noun continues a list of things: ``a tin, a clamp``, but not ``on the table, his hat on it``."""
    if index < 2 or phrases[index - 1].text not in (",", "and"):
        return False
    before = phrases[index - 2].noun
    placed = index > 2 and phrases[index - 3].kind == "preposition"
    return before is not None and before.kind == "thing" and not placed


def _opens_clause(phrases: list[Phrase], index: int) -> bool:
    """Whether a place opens a clause of its own: ``A caravan stands by the fence; behind it``."""
    return index > 1 and phrases[index - 1].kind == "preposition" and phrases[index - 2].text in (";", ",", "and")


def _is_named_after(state: ReaderState, thing: str, index: int) -> bool:
    """Whether a thing is only named after the word at an index: ``Below them, a row of boots``."""
    words = state.sentence.words
    return all(words[at].start > words[index].start for at, named in state.sentence.things if named == thing)


def _seat_brought(phrases: list[Phrase], index: int) -> int:
    """Index of the seat that was brought: ``pulls a stool up and sits on it``; 0 if there is none."""
    verb = next((at for at in range(index - 1, -1, -1) if phrases[at].verb), 0)
    sits = phrases[verb].verb
    if sits is None or lexicon.MOTION_OF_VERB.get(sits.lemma) not in _SITTING or phrases[index - 1].text not in _UPON:
        return 0
    for at in range(verb - 1, 0, -1):
        noun = phrases[at].noun
        if noun and noun.kind == "thing" and noun.head in lexicon.SEATS and phrases[at - 1].kind == "verb":
            return at
    return 0


def _moved_to_landmark(phrases: list[Phrase], index: int) -> int:
    """Index of what was moved, not of the landmark: ``shoves the table against the door``; 0 for none."""
    for at in range(index - 3, 2, -1):
        noun, thing = phrases[at].noun, phrases[at - 2].noun
        if noun and phrases[at - 1].kind == "preposition":
            moved = thing is not None and thing.kind == "thing" and phrases[at - 3].kind == "verb"
            return at - 2 if moved and phrases[at - 1].text in _LANDMARKS else 0
    return 0


def _recent_plural(state: ReaderState) -> str | None:
    """Return the things in the plural that the sentence before named, or None."""
    plural = state.discourse.last_plural
    return plural[0] if plural and plural[1] == state.discourse.sentence - 1 else None


def _thing_there(state: ReaderState, index: int, preposition: str) -> str | None:
    """Return the thing that ``there`` means: the last one named before; after ``inside``, a container."""
    before = [thing for at, thing in reversed(state.sentence.things) if at < index]
    here = {thing for _, thing in state.sentence.things}
    before += [thing for thing in state.discourse.recent_things if thing not in here]
    solid = [thing for thing in before if state.inventory.class_of(thing) in ("prop", "set_piece")]
    if preposition == "inside":
        solid = [thing for thing in solid[:3] if state.inventory.head(thing) in CONTAINERS]
    return next(iter(solid), None)
