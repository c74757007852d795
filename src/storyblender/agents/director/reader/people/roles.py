"""Who and what takes part in a clause: its noun phrases resolved in reading order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.phrases import NounPhrase
from storyblender.agents.director.reader.people.coreference import (
    Referents,
    Role,
    remember,
    resolve,
    resolve_owner,
    resolve_pronoun,
)
from storyblender.agents.director.reader.people.thing_reference import weigh_clause
from storyblender.agents.director.reader.state import Stage
from storyblender.agents.director.reading import Person

_FALLING = frozenset(
    {"fall", "collapse", "drop", "die", "stagger", "stumble", "crumple", "faint", "slump", "tumble", "crash"}
)
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
    """A preposition with what follows it."""

    preposition: str
    people: list[Person]
    things: list[str]
    nouns: list[NounPhrase]


@dataclass
class Roles:
    """A clause's people and things."""

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
        """All prepositions of the clause."""
        return {place.preposition for place in self.places}

    def people_after(self, *prepositions: str) -> list[Person]:
        """People after one of these prepositions."""
        return [person for place in self.places if place.preposition in prepositions for person in place.people]


def resolve_subject(stage: Stage, clause: Clause, previous: Sequence[Person]) -> Roles:
    """Resolve the subject of a clause.

    Args:
        stage: The state before the clause.
        clause: The clause; a subject that follows its verb is moved before it.
        previous: Subject of the clause or sentence before.
    """
    roles = Roles()
    stage.sentence.object_thing = stage.sentence.subject_thing = None
    follows = not clause.subject or all(noun.kind == "pronoun" and noun.head == "" for noun in clause.subject)
    after = clause.recipient or clause.object or clause.complement
    if not clause.subject and after and clause.verb in _INVERTED and any(n.kind != "pronoun" for n in after):
        clause.subject, clause.recipient, clause.object, clause.complement = after, [], [], []
        clause.elided = False
        previous = ()
    for noun in clause.subject:
        resolve_owner(stage, noun, "possessor", stage.sentence.subjects, stage.sentence.subjects or previous)
        _victim_falls(stage, clause, noun)
        found = _they_without_him(stage, clause, noun) or resolve(stage, noun, "subject", (), previous)
        roles.subjects += [person for person in found.people if person not in roles.subjects]
        roles.subject_things += [found.thing] if found.thing else []
    stage.sentence.subject_thing = next(iter(roles.subject_things), None)
    if follows and clause.elided and stage.discourse.moving and clause.verb in _ROLLING and not clause.object:
        roles.subject_things = [stage.discourse.moving]
    if follows and clause.elided and not roles.subject_things and not clause.passive:
        roles.subjects = roles.subjects or list(previous)
    return roles


def _they_without_him(stage: Stage, clause: Clause, noun: NounPhrase) -> Referents | None:
    """``They pull him in`` after a sentence about one person: that is him, and they are the others."""
    alone = stage.discourse.subjects
    others = [*clause.object, *clause.recipient, *(place for _, nouns in clause.places for place in nouns)]
    singular = any(o.kind == "pronoun" and o.head in ("him", "her") for o in others)
    if noun.kind != "pronoun" or noun.head != "they" or not singular or len(alone) != 1:
        return None
    people = resolve_pronoun(stage, "they", "subject", (), (), alone)
    return remember(stage, noun.index, Referents(people)) if people else None


def _victim_falls(stage: Stage, clause: Clause, noun: NounPhrase) -> None:
    """A hits B. He collapses: it is B."""
    victim = stage.discourse.victim
    recent = victim is not None and victim[1] >= stage.discourse.sentence - 2
    if victim and recent and noun.kind == "pronoun" and noun.head in ("he", "she") and clause.verb in _FALLING:
        remember(stage, noun.index, Referents([victim[0]]))


def resolve_objects(stage: Stage, clause: Clause, roles: Roles, previous: Sequence[Person]) -> None:
    """Resolve everything after the verb into ``roles``."""
    stage.sentence.object_thing = None
    roles.recipients, roles.recipient_things = _resolve_all(stage, clause, clause.recipient, roles.subjects, previous)
    roles.people, roles.things = _resolve_all(stage, clause, clause.object, roles.subjects, previous)
    for preposition, nouns in clause.places:
        placed = preposition in lexicon.RELATION_OF_PREPOSITION
        had = clause.verb in _HAVING and placed and bool(clause.object)
        own = had or (preposition == "behind" and clause.verb in _SHUTTING)
        among = preposition == "between" and bool(roles.subjects)
        role: Role = "possessor" if own else "other" if among else "object"
        people, things = _resolve_all(stage, clause, nouns, roles.subjects, previous, placed, role)
        roles.places.append(Place(preposition, people, things, nouns))
    _resolve_all(stage, clause, clause.complement, roles.subjects, previous)
    things_of_places = [thing for place in roles.places for thing in place.things]
    weigh_clause(stage, roles.subject_things, roles.recipient_things + roles.things, things_of_places)
    if roles.people and clause.verb in _STRIKING and not clause.negated:
        stage.discourse.victim = (roles.people[0], stage.discourse.sentence)


def _resolve_all(
    stage: Stage,
    clause: Clause,
    nouns: Sequence[NounPhrase],
    subjects: list[Person],
    previous: Sequence[Person],
    place: bool = False,
    role: Role = "object",
) -> tuple[list[Person], list[str]]:
    people: list[Person] = []
    things: list[str] = []
    for noun in nouns:
        resolve_owner(stage, noun, _owner_role(stage, clause, noun, subjects), subjects, previous)
        found = resolve(stage, noun, role, subjects, previous, place)
        people += found.people
        stage.scene.named |= {person.id for person in found.people}
        if found.thing:
            things.append(found.thing)
            if nouns is clause.object:
                stage.sentence.object_thing = found.thing
            if noun.plural and stage.inventory.class_of(found.thing) in ("prop", "unknown"):
                stage.sentence.plural_thing = found.thing
    if nouns is clause.object and len(things) > 1 and not people:
        stage.sentence.plural_thing = things[0]
    return people, things


def _owner_role(stage: Stage, clause: Clause, noun: NounPhrase, subjects: list[Person]) -> Role:
    """Holding *her* hand is somebody else's hand; to *her* right, MEI is not Mei's right."""
    if noun.possessor is None:
        return "possessor"
    gender = lexicon.PRONOUNS.get(stage.sentence.words[noun.possessor].low)
    others = [
        person
        for person in stage.on_stage()
        if person not in subjects
        and person.gender == gender
        and stage.discourse.last_sentence.get(person.id, -9) >= stage.discourse.sentence - 1
    ]
    contact = clause.verb in _CONTACT or (clause.verb == "shake" and noun.head == "hand")
    if contact and noun.head in lexicon.BODY and others:
        return "other"
    leads = bool(clause.subject) and clause.subject[0].index > noun.index
    return "other" if leads and noun.head in _SIDES else "possessor"
