"""What the motion of a verb needs: ``take`` a thing, ``eat`` food, ``push`` something solid."""

from __future__ import annotations

from collections.abc import Collection

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.phrases import NounPhrase
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.state import ReaderState

_TO_SOMETHING = lexicon.words("to_something")
"""Motions that need an object, a thing or a person."""
_SOLID = lexicon.words("solid")
"""Motions whose object must be tangible: taking a question or dropping a hint does not count."""
_TOGETHER = frozenset({"kiss", "hug", "hit"})
_AGAINST = frozenset(
    {"at", "against", "on", "onto", "into", "with", "from", "to", "for", "of", "through", "over", "out", "up", "down"}
    | {"off", "away", "in", "by", "around", "back", "on to", "out of", "hold of"}
)
"""``pulls at the rope``, ``pushes against the door``."""
_BITING = frozenset({"bite", "taste", "lick", "swallow", "suck"})
_BACKING = frozenset({"reverse", "back_up", "brake", "accelerate", "park", "steer", "pilot", "cruise", "coast"})
_SHIFTING = frozenset({"shift", "roll", "bump", "edge", "force"})
_OBJECTS = frozenset({"prop", "worn", "set_piece", "unknown", "body", "scenery"})
_MATTER = lexicon.PARTS | lexicon.words("food") | lexicon.LIQUIDS | lexicon.SHAPELESS | lexicon.words("deed_objects")
"""Words that are no props of their own but can be taken in the hand."""


def fitting_motion(state: ReaderState, clause: Clause, roles: Roles, motion: str) -> str | None:
    """Return the motion a verb means with its objects, or None if it cannot be a bodily motion here.

    Args:
        state: The state before the clause.
        clause: A clause in the active voice.
        roles: The people and things of the clause.
        motion: The usual motion of the verb.
    """
    bare = not (clause.object or clause.recipient)
    if clause.verb in _BITING and motion in ("eat", "drink") and bare and not clause.places:
        return None
    if motion == "drive" and clause.verb in _BACKING and not _has_vehicle(state, roles):
        return "walk"
    if motion in ("push", "pull") and clause.verb in _SHIFTING and bare:
        return "walk" if _prepositions(clause) & {"to", "over", "toward", "towards", "into"} else None
    if motion in _TO_SOMETHING and not _has_something(state, clause, roles, motion):
        return None
    if motion == "hold" and _is_own_body(clause) and not roles.people:
        return None
    if motion in _SOLID and clause.object and not _is_solid(state, clause, roles):
        return None
    return motion


def _is_own_body(clause: Clause) -> bool:
    """Whether the object is a part of one's own body: ``holding hands``, ``holds his head high``."""
    return bool(clause.object) and all(n.head in lexicon.BODY and n.owner is None for n in clause.object)


def _has_something(state: ReaderState, clause: Clause, roles: Roles, motion: str) -> bool:
    """Whether there is a thing that the motion can handle."""
    if clause.object or clause.recipient or (motion in _TOGETHER and len(roles.subjects) > 1):
        return True
    if any(word.low == "one" for word in state.sentence.words[clause.index : clause.index + 2]):
        return True  # picks one up
    if any(preposition in _AGAINST and nouns for preposition, nouns in clause.places):
        return True
    return bool(clause.particle) and motion in ("hold", "press", "push", "pull", "put_down")


def _is_solid(state: ReaderState, clause: Clause, roles: Roles) -> bool:
    """Whether the object of a clause is a person or a thing that can be touched."""
    if roles.people or roles.recipients:
        return True
    return any(_can_be_touched(state, noun, roles.things) for noun in clause.object)


def _can_be_touched(state: ReaderState, noun: NounPhrase, things: Collection[str]) -> bool:
    """Whether a noun is a person or a solid thing."""
    if noun.kind != "thing" or noun.head in _MATTER | {"it", "one", "other", "everything", "this", "that"}:
        return True
    if noun.head in lexicon.ABSTRACT:
        return any(
            state.inventory.head(thing) == noun.head and state.inventory.class_of(thing) in _OBJECTS for thing in things
        )
    return lexicon.noun_class(noun.key) in _OBJECTS


def _has_vehicle(state: ReaderState, roles: Roles) -> bool:
    """Whether the subject of ``reverses`` or ``parks`` has a vehicle to drive."""
    if any(state.inventory.head(thing) in lexicon.VEHICLES for thing in roles.things):
        return True
    supports = (state.scene.posture.get(person.id, ("stand", None))[1] for person in roles.subjects)
    inside = any(state.inventory.head(support) in lexicon.VEHICLES for support in supports)
    words = {*state.place.place.lower().split(), *state.place.heading.lower().split()}
    return inside or bool(words & lexicon.VEHICLES) or bool({*state.inventory.ids()} & lexicon.VEHICLES)


def _prepositions(clause: Clause) -> set[str]:
    """Return the prepositions of a clause."""
    return {preposition for preposition, _ in clause.places} | {clause.particle}
