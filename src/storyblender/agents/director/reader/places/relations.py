"""Spatial relations between people and things that a clause states (notes of the director, 4.3)."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import Word, joined
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.places.anchors import (
    BEARING,
    BENT,
    CONTAINERS,
    FLOOR,
    STATIVE,
    SURFACES,
    THING_CLASSES,
    StatedRelation,
    body_part_at,
    exact_relation,
    furniture_and_props,
    is_scene_place,
)
from storyblender.agents.director.reader.places.place_relations import relations_at_place
from storyblender.agents.director.reader.places.placing import moves_something, placed_relations, relate_between
from storyblender.agents.director.reader.places.subject_places import subject_places, subject_stays
from storyblender.agents.director.reader.places.supports import support_relations
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import RelationKind

_BOARDING = lexicon.words("boarding")
_RECENT_THINGS = 4
"""Things back to a vehicle."""
_LEAPING = frozenset({"jump", "climb", "ride", "fall"})
_PASSING = frozenset({"walk", "sneak"})
_SIDES = frozenset({"to the left of", "to the right of"})
_ON_THE_SIDE = re.compile(r"\bto (?:her|his|their) (left|right)\b|\bto the (left|right) of\b")
_BESIDE_FURNITURE = ("by", "near", "next to", "beside", "in front of")


@rule("relations.clause")
def relate_clause(state: ReaderState, clause: Clause, roles: Roles, motion: str | None, first: bool) -> None:
    """State in ``state`` the spatial relations that a clause tells.

    Args:
        state: The reader's state before the clause.
        clause: A clause that is not negated.
        roles: The people and things of the clause.
        motion: Motion of its subject, or None.
        first: Whether it is the first clause of its sentence.
    """
    roles = _with_particle_place(clause, roles)
    roles = replace(roles, places=_across_from(roles.places))
    located = [person.id for person in roles.subjects] or [
        thing for thing in roles.subject_things if state.inventory.class_of(thing) in THING_CLASSES
    ]
    found: list[StatedRelation] = []
    if located:
        telling = subject_places(state, clause, roles, motion)
        for place in telling:
            found += relations_at_place(state, clause, place, located, motion)
        if subject_stays(state, clause, roles, motion):
            found += support_relations(state, roles)
        _relate_between_clause(state, clause, roles, telling, motion, located)
        if clause.verb == "face":
            faced = [person.id for person in roles.people] + furniture_and_props(state, roles.things)
            faced = faced or located  # each other
            found.extend((subject, "facing", other) for subject in located for other in faced if other != subject)
        found += _boarding_known_vehicle(state, clause, roles, located)
        found += _relations_on_body(roles, motion, located)
        if clause.verb in _BOARDING and not clause.opening and not roles.things + roles.people:
            found += _boarding_relations(state, roles, located)
    if first and roles.subjects and not any(place.preposition in _SIDES and place.things for place in roles.places):
        _relate_left_right(state, roles.subjects)
    if moves_something(clause, roles, motion):
        found += placed_relations(state, clause, roles)
    for subject, kind, anchor in _move_to_seat(state, roles, motion, found):
        state.relate(subject, kind, anchor)


def _relations_on_body(roles: Roles, motion: str | None, located: list[str]) -> list[StatedRelation]:
    """Return relations to people whose lap or back is got on: ``The cat jumps into her lap``."""
    if motion not in _LEAPING:
        return []
    bodies = [
        body_part_at(place) for place in roles.places if place.preposition in ("on", "onto", "on to", "in", "into")
    ]
    return [(who, "on", body[1]) for who in located for body in bodies if body and body[0] in BEARING]


def _with_particle_place(clause: Clause, roles: Roles) -> Roles:
    """Add the verb's particle as a place: ``is bent over the desk``, ``squats on a basket``."""
    bent = clause.verb in BENT and clause.passive
    resting = (clause.verb in STATIVE or bent) and clause.particle in lexicon.RELATION_OF_PREPOSITION
    leaning = clause.verb == "lean" and clause.particle == "over"
    if not resting or leaning or not clause.object:
        return roles
    place = Place(clause.particle, roles.people, roles.things, clause.object)
    return replace(roles, people=[], things=[], places=[place, *roles.places])


def _across_from(places: list[Place]) -> list[Place]:
    """Join two places to ``across from``: ``across the desk from him`` is across from him."""
    joined_places: list[Place] = []
    for place in places:
        before = joined_places[-1] if joined_places else None
        if before and before.preposition == "across" and place.preposition == "from" and place.people:
            joined_places[-1] = replace(place, preposition="across from")
        else:
            joined_places.append(place)
    return joined_places


def _boarding_relations(state: ReaderState, roles: Roles, located: list[str]) -> list[StatedRelation]:
    """Relations to what a verb of boarding names: ``climbs onto a chair``, ``gets into the car``."""
    found: list[StatedRelation] = []
    for place in roles.places:
        for thing in place.things:
            solid = state.inventory.class_of(thing) in ("set_piece", "prop") and not is_scene_place(state, thing)
            if place.preposition in ("onto", "on to") and (solid or state.inventory.head(thing) in SURFACES):
                found.extend((subject, "on", thing) for subject in located)
            elif place.preposition in ("into", "aboard", "inside") and solid:
                found.extend((subject, exact_relation(state, "in", thing, ""), thing) for subject in located)
    return found


def _boarding_known_vehicle(
    state: ReaderState, clause: Clause, roles: Roles, located: list[str]
) -> list[StatedRelation]:
    """Relations to the last named vehicle: ``opens the car door and gets in``, ``steps aboard``."""
    after = [word.low for word in state.sentence.words[clause.index + 1 : clause.index + 2]]
    aboard, into = after == ["aboard"], clause.verb in _BOARDING and clause.particle == "in"
    told = roles.things + roles.people or any(place.things for place in roles.places)
    told = told or any(state.inventory.head(thing) == "window" for _, thing in state.sentence.things)
    lately = (t for t in state.discourse.recent_things[:_RECENT_THINGS] if state.inventory.head(t) in lexicon.VEHICLES)
    vehicle = next(lately, None)
    if vehicle is None or told or not (aboard or into) or not roles.subjects:
        return []
    return [(who, "on" if aboard else "in", vehicle) for who in located]


def _relate_between_clause(
    state: ReaderState, clause: Clause, roles: Roles, telling: list[Place], motion: str | None, located: list[str]
) -> None:
    """State the person who is between two things; ``weaves between the stalls`` states nothing."""
    still = not roles.subjects or subject_stays(state, clause, roles, motion)
    boxes = [
        thing
        for place in roles.places
        for thing in place.things
        if place.preposition == "in" and state.inventory.head(thing) in CONTAINERS
    ]
    located = boxes[:1] or located  # sleeps in a basket between the stove and the door
    walks = motion in _PASSING and not roles.things
    for place in roles.places if roles.subjects else telling:
        if place.preposition == "between" and (still or (walks and len(place.nouns) > 1)):
            relate_between(state, place, located)


def _relate_left_right(state: ReaderState, subjects: list[Person]) -> None:
    """State the side of the subjects: ``To her left, Dutch chews a toothpick.``"""
    side = _ON_THE_SIDE.search(joined(state.sentence.words))
    if side is None:
        return
    kind: RelationKind = "left_of" if "left" in side.group(0) else "right_of"
    pronouns = state.sentence.pronouns
    owner = next((pronouns[i][0] for i in sorted(pronouns) if state.sentence.words[i].low in ("her", "his")), [])
    others = [person for person in owner if person not in subjects]
    others = others or [person for person in state.on_stage() if person not in subjects][:1]
    for subject in subjects:
        for other in others:
            state.relate(subject.id, kind, other.id)


def _move_to_seat(
    state: ReaderState, roles: Roles, motion: str | None, found: list[StatedRelation]
) -> list[StatedRelation]:
    """Give the place beside furniture to the seat: in ``Sits in the armchair by the window`` the chair is there."""
    if motion not in ("sit", "lie_down", "sleep"):
        return found
    seats = [
        place
        for place in roles.places
        if place.things
        and lexicon.relation_of(place.preposition) in ("on", "in", "at")
        and state.inventory.class_of(place.things[0]) != "body"
        and state.inventory.head(place.things[0]) in lexicon.SEATS | {"table", "desk"}
    ]
    beside = [
        place
        for place in roles.places
        if place.things
        and (
            (place.preposition in _BESIDE_FURNITURE and state.inventory.class_of(place.things[0]) == "set_piece")
            or (place.preposition == "in" and state.inventory.head(place.things[0]) == "corner")
        )
    ]
    at_table = any(kind == "at" for _, kind, _ in found)
    if not seats or not beside or (at_table and beside[0].preposition == "in front of"):
        return found
    seat, window = seats[0].things[0], beside[0].things[0]
    if state.inventory.head(seat) in FLOOR or seat == window:
        return found
    if beside[0].nouns[0].index < seats[0].nouns[0].index:
        return found  # in front of the stove on a crate
    kind = lexicon.relation_of(beside[0].preposition)
    moved = [relation for relation in found if relation[2] != window]
    return [*moved, (seat, kind, window)] if kind else moved


_SIDE_WORDS = frozenset({"side", "shoulder", "elbow", "hip", "cheek", "knee"})


@rule("relations.side_by_side")
def relate_side_by_side(state: ReaderState, words: list[Word], subjects: list[Person]) -> None:
    """State that each subject is next to the one before: ``They stand shoulder to shoulder``.

    Args:
        state: The reader's state after the clauses of the sentence.
        words: Words of the sentence as written.
        subjects: Subjects of the sentence.
    """
    low = [word.low for word in words]
    if any(low[i] == low[i + 2] in _SIDE_WORDS and low[i + 1] in ("by", "to") for i in range(len(low) - 2)):
        for before, person in pairwise(subjects):
            state.relate(before.id, "next_to", person.id)
