"""The people and things that take part in a clause, resolved from its noun phrases in reading order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.phrases import NounPhrase
from storyblender.agents.director.reader.people.coreference import (
    GrammaticalRole,
    Referents,
    record_reference,
    resolve,
    resolve_owner,
    resolve_pronoun,
)
from storyblender.agents.director.reader.people.thing_reference import raise_clause_things
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person

_FALLING = lexicon.words("falling")
_STRIKING = lexicon.words("striking")
_INVERTED = lexicon.INVERTING | {"live", "be"}
"""Verbs whose subject may follow: ``On the stone sat a fox``, ``There was a man``."""
_CONTACT = frozenset({"hold", "touch", "take", "kiss", "squeeze", "stroke", "pat", "grab", "wipe", "hit", "slap"})
_SHUTTING = frozenset({"close", "shut", "lock", "slam", "bolt", "bar", "pull", "drag"})
"""``locks the door behind her``: behind herself."""
_HAVING = frozenset({"have", "keep", "trail", "drag", "tow"})
"""``has a plate in front of him``: before himself."""
_ROLLING = lexicon.words("coming_to_rest") | lexicon.words("moving") | frozenset({"stop", "ring", "rattle", "hang"})
"""Motions that a thing continues: ``The coin drops. Rolls away.``"""
_SIDES = frozenset({"left", "right", "side"})


@dataclass
class Place:
    """A preposition with the people, things and nouns that follow it."""

    preposition: str
    people: list[Person]
    things: list[str]
    nouns: list[NounPhrase]


@dataclass
class Roles:
    """The resolved people and things of a clause by grammatical role: subject, object, recipient, places."""

    subjects: list[Person] = field(default_factory=list)
    subject_things: list[str] = field(default_factory=list)
    people: list[Person] = field(default_factory=list)
    """In object position."""
    things: list[str] = field(default_factory=list)
    recipients: list[Person] = field(default_factory=list)
    recipient_things: list[str] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)

    @property
    def prepositions(self) -> set[str]:
        """Prepositions of the clause's places."""
        return {place.preposition for place in self.places}

    def people_after(self, *prepositions: str) -> list[Person]:
        """Return the people after one of these prepositions."""
        return [person for place in self.places if place.preposition in prepositions for person in place.people]


def resolve_subject(state: ReaderState, clause: Clause, previous: Sequence[Person]) -> Roles:
    """Return the roles of a clause with its subject resolved.

    Args:
        state: The reader's state before the clause.
        clause: The clause; a subject that follows its verb is moved before it.
        previous: Subjects of the clause or sentence before.
    """
    roles = Roles()
    state.sentence.object_thing = state.sentence.subject_thing = None
    follows = not clause.subject or all(noun.kind == "pronoun" and noun.head == "" for noun in clause.subject)
    after = clause.recipient or clause.object or clause.complement
    if not clause.subject and after and clause.verb in _INVERTED and any(n.kind != "pronoun" for n in after):
        clause.subject, clause.recipient, clause.object, clause.complement = after, [], [], []
        clause.elided = False
        previous = ()
    for noun in clause.subject:
        resolve_owner(state, noun, "possessor", state.sentence.subjects, state.sentence.subjects or previous)
        _victim_falls(state, clause, noun)
        found = _they_without_him(state, clause, noun) or resolve(state, noun, "subject", (), previous)
        roles.subjects += [person for person in found.people if person not in roles.subjects]
        roles.subject_things += [found.thing] if found.thing else []
    state.sentence.subject_thing = next(iter(roles.subject_things), None)
    if follows and clause.elided and state.discourse.moving and clause.verb in _ROLLING and not clause.object:
        roles.subject_things = [state.discourse.moving]
    if follows and clause.elided and not roles.subject_things and not clause.passive:
        roles.subjects = roles.subjects or list(previous)
    return roles


def _they_without_him(state: ReaderState, clause: Clause, noun: NounPhrase) -> Referents | None:
    """Resolve ``They pull him in`` after a sentence about one person: he is that one, they the others."""
    alone = state.discourse.subjects
    others = [*clause.object, *clause.recipient, *(place for _, nouns in clause.places for place in nouns)]
    singular = any(o.kind == "pronoun" and o.head in ("him", "her") for o in others)
    if noun.kind != "pronoun" or noun.head != "they" or not singular or len(alone) != 1:
        return None
    people = resolve_pronoun(state, "they", "subject", (), (), alone)
    return record_reference(state, noun.index, Referents(people)) if people else None


def _victim_falls(state: ReaderState, clause: Clause, noun: NounPhrase) -> None:
    """Resolve the subject of a fall after a blow to who was hit: ``Al hits Bo. He collapses``."""
    victim = state.discourse.victim
    recent = victim is not None and victim[1] >= state.discourse.sentence - 2
    if victim and recent and noun.kind == "pronoun" and noun.head in ("he", "she") and clause.verb in _FALLING:
        record_reference(state, noun.index, Referents([victim[0]]))


def resolve_objects(state: ReaderState, clause: Clause, roles: Roles, previous: Sequence[Person]) -> None:
    """Resolve the objects, recipients and places of a clause into its ``roles``.

    Args:
        state: The reader's state; what ``it`` may mean is updated.
        clause: The clause.
        roles: Its roles with the subject resolved; completed in place.
        previous: Subjects of the clause or sentence before.
    """
    state.sentence.object_thing = None
    roles.recipients, roles.recipient_things = _resolve_all(state, clause, clause.recipient, roles.subjects, previous)
    roles.people, roles.things = _resolve_all(state, clause, clause.object, roles.subjects, previous)
    for preposition, nouns in clause.places:
        placed = preposition in lexicon.RELATION_OF_PREPOSITION
        had = clause.verb in _HAVING and placed and bool(clause.object)
        own = had or (preposition == "behind" and clause.verb in _SHUTTING)
        among = preposition == "between" and bool(roles.subjects)
        role: GrammaticalRole = "possessor" if own else "other" if among else "object"
        people, things = _resolve_all(state, clause, nouns, roles.subjects, previous, placed, role)
        roles.places.append(Place(preposition, people, things, nouns))
    _resolve_all(state, clause, clause.complement, roles.subjects, previous)
    things_of_places = [thing for place in roles.places for thing in place.things]
    raise_clause_things(state, roles.subject_things, roles.recipient_things + roles.things, things_of_places)
    if roles.people and clause.verb in _STRIKING and not clause.negated:
        state.discourse.victim = (roles.people[0], state.discourse.sentence)


def _resolve_all(
    state: ReaderState,
    clause: Clause,
    nouns: Sequence[NounPhrase],
    subjects: list[Person],
    previous: Sequence[Person],
    place: bool = False,
    role: GrammaticalRole = "object",
) -> tuple[list[Person], list[str]]:
    """Return the people and the ids of the things that nouns mean."""
    people: list[Person] = []
    things: list[str] = []
    for noun in nouns:
        resolve_owner(state, noun, _owner_role(state, clause, noun, subjects), subjects, previous)
        found = resolve(state, noun, role, subjects, previous, place)
        people += found.people
        state.scene.named |= {person.id for person in found.people}
        if found.thing:
            things.append(found.thing)
            if nouns is clause.object:
                state.sentence.object_thing = found.thing
            if noun.plural and state.inventory.class_of(found.thing) in ("prop", "unknown"):
                state.sentence.plural_thing = found.thing
    if nouns is clause.object and len(things) > 1 and not people:
        state.sentence.plural_thing = things[0]
    return people, things


def _owner_role(state: ReaderState, clause: Clause, noun: NounPhrase, subjects: list[Person]) -> GrammaticalRole:
    """Return the role of a possessive: in ``holds her hand`` the owner is other than the subject."""
    if noun.possessor is None:
        return "possessor"
    gender = lexicon.PRONOUNS.get(state.sentence.words[noun.possessor].low)
    others = [
        person
        for person in state.on_stage()
        if person not in subjects
        and person.gender == gender
        and state.discourse.last_sentence.get(person.id, -9) >= state.discourse.sentence - 1
    ]
    contact = clause.verb in _CONTACT or (clause.verb == "shake" and noun.head == "hand")
    if contact and noun.head in lexicon.BODY and others:
        return "other"
    leads = bool(clause.subject) and clause.subject[0].index > noun.index
    return "other" if leads and noun.head in _SIDES else "possessor"
