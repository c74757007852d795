"""The spatial relations that one prepositional phrase states for the subject of its clause."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.people.roles import Place
from storyblender.agents.director.reader.places.anchors import (
    ARRIVING,
    ATTACHING,
    BENT,
    CLOTHS,
    FLOOR,
    FLOORING,
    GETTING_DOWN,
    HALTING,
    HANGING,
    OPENINGS,
    STATIVE,
    SURFACES,
    THING_CLASSES,
    TURNING,
    StatedRelation,
    body_part_at,
    exact_relation,
    is_carried_support,
    is_scene_place,
    relation_at_body,
)
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import RelationKind

_ANCHORS = THING_CLASSES | {"scenery"}
_LYING = frozenset({"lie_down", "fall", "sleep"})
"""``sprawls across the bed`` is on it, who sits across the room is not."""
_SINKING = frozenset({"fall", "collapse", "sink", "slump", "crumple", "tumble", "crash", "topple"})
_IMAGES = frozenset({"mirror", "photo", "photograph", "picture", "painting", "screen", "monitor", "reflection"})


@rule("relations.stated", without=[])
def relations_at_place(
    state: ReaderState, clause: Clause, place: Place, located: list[str], motion: str | None
) -> list[StatedRelation]:
    """Return the relations of the located ids to a place.

    Args:
        state: The reader's state.
        clause: A clause that is not negated.
        place: A place of the clause that tells where its subject is.
        located: Ids of the subject, at least one.
        motion: Motion of the subject, or None.
    """
    kind = _relation_of_verb(state, clause, place, located)
    if kind is None or kind == "between" or place.preposition == "down":
        return []
    past_it = (
        place.preposition == "across"
        and motion not in _LYING
        and not clause.passive
        and state.person(located[0]) is not None
    )
    earlier = place.preposition == "before" and clause.verb == "be" and bool(place.people)  # was there before her
    bends = place.preposition == "close to" and clause.verb in BENT | {"lean"}
    if past_it or earlier or bends or _is_an_image(state, kind, place):
        return []
    if kind == "behind" and clause.verb not in STATIVE and state.inventory.head(located[0]) in OPENINGS:
        return []  # behind her the door opens: it is somewhere in the room
    openings = any(state.inventory.head(thing) in OPENINGS for thing in place.things)
    if kind == "on" and openings and state.person(located[0]):
        return []  # with his hand upon the gate
    if kind == "over" and clause.verb in BENT - {"hunch"} | {"lean"} and not clause.passive:
        return []  # stoops over the book, and is up again
    if kind == "in" and state.person(located[0]) and (_is_wrapping(state, place) or _is_corner(state, place)):
        return []  # in a blanket: that is what a person wears
    doorway = any(state.inventory.head(thing) == "doorway" for thing in place.things)
    doorway |= kind == "at" and clause.verb in TURNING and openings
    beside = kind in ("behind", "in_front_of", "next_to")
    halts = clause.verb in HALTING and kind == "at"
    arriving = clause.verb in ARRIVING and not halts and motion != "sit" and state.person(located[0]) is not None
    if arriving and not (beside or doorway or clause.passive):
        return []
    anchors = [person.id for person in place.people if kind != "at"]
    anchors += [thing for thing in place.things if _is_anchor(state, kind, thing)]
    body = body_part_at(place)
    if body:
        if kind == "under":
            return []  # ducks under his arm
        kind = relation_at_body(place.preposition, body[0], kind)
        anchors = [body[1]]
    if kind is None:
        return []
    if kind == "over" and state.inventory.head(located[0]) in CLOTHS and not body:
        kind = "on"
    return [
        (subject, exact_relation(state, kind, anchor, clause.verb), anchor)
        for anchor in anchors
        if not (is_scene_place(state, anchor) and kind in ("in", "at"))
        for subject in located
        if subject != anchor and not is_carried_support(state, subject, anchor)
    ]


def _relation_of_verb(state: ReaderState, clause: Clause, place: Place, located: list[str]) -> RelationKind | None:
    """Return the relation of a preposition after this verb: ``pinned to`` and ``hangs from`` are on."""
    if place.preposition == "to" and clause.verb in ATTACHING:
        living = state.person(located[0]) is not None
        seat = any(state.inventory.head(thing) in lexicon.SEATS for thing in place.things)
        vehicle = state.inventory.head(located[0]) in lexicon.VEHICLES
        return "next_to" if (living and not seat) or vehicle else "on"
    if place.preposition == "to" and any(state.inventory.head(thing) in FLOOR for thing in place.things):
        return "on" if state.person(located[0]) is None or clause.verb in _SINKING | GETTING_DOWN else None
    if place.preposition == "from" and clause.verb in HANGING:
        return None if state.person(located[0]) or body_part_at(place) else "on"
    if place.preposition in ("around", "round") and _is_around_furniture(state, place):
        return "at" if state.person(located[0]) else "next_to"
    return lexicon.relation_of(place.preposition)


def _is_anchor(state: ReaderState, kind: RelationKind, thing: str) -> bool:
    """Whether something can be in, on or beside a thing by this relation; scenery is nothing to be at."""
    if state.inventory.head(thing) in FLOORING | {"step"} and kind == "on":
        return True
    surface = state.inventory.head(thing) in SURFACES and kind in ("on", "in")
    if state.inventory.head(thing) == "water":
        return False
    at_large = kind in ("in", "at") and state.inventory.class_of(thing) == "scenery" and not surface
    return state.inventory.class_of(thing) in _ANCHORS and not at_large


def _is_around_furniture(state: ReaderState, place: Place) -> bool:
    """Whether people are around a piece: ``sit around the table``, not ``stand around the corner``."""
    return any(state.inventory.class_of(thing) in ("set_piece", "prop") for thing in place.things)


def _is_wrapping(state: ReaderState, place: Place) -> bool:
    """Whether a place is a cloth or a garment: ``in a blanket``."""
    return any(state.inventory.head(thing) in CLOTHS | lexicon.WORN for thing in place.things)


def _is_corner(state: ReaderState, place: Place) -> bool:
    """Whether a place is a corner of the room."""
    return any(state.inventory.head(thing) == "corner" for thing in place.things)


def _is_an_image(state: ReaderState, kind: RelationKind, place: Place) -> bool:
    """Whether a place is in an image: ``In the mirror stands a man`` puts him somewhere else."""
    return kind == "in" and any(state.inventory.head(thing) in _IMAGES for thing in place.things)
