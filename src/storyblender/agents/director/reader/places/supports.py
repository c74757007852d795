"""Where the furniture is that supports the subject: ``asleep on the couch by the doors``."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.places.anchors import FLOOR, OPENINGS, SURFACES, THING_CLASSES, StatedRelation
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.rules import rule

_HELD_UP = frozenset({"on", "in"})
_SOURCES = frozenset({"from", "off", "out of"})
_BESIDE = frozenset({"at", "in_front_of", "next_to"})
"""``kneels in front of the cabinet beside the desk``: it is the cabinet that is beside it."""
_ASIDE = frozenset({"next_to", "behind", "in_front_of", "under", "over", "against", "left_of", "right_of"})
_LAMPS = lexicon.words("lamps")
PEGS = frozenset({"hook", "nail", "peg"})
"""What things hang on; it is fixed somewhere itself."""


def locates_support(state: ReaderState, roles: Roles, at: int) -> bool:
    """Whether a place locates the furniture of the place before it: ``on the hook behind the door``.

    Args:
        state: The reader's state before the clause.
        roles: People and things of a clause that tells where its subject is.
        at: Index of the place in ``roles.places``.
    """
    if not at:
        return False
    before, place = roles.places[at - 1], roles.places[at]
    side = lexicon.relation_of(place.preposition)
    if roles.subjects and side == "behind":
        return False  # on a crate behind the counter: that is where the person is
    held = lexicon.relation_of(before.preposition)
    return (
        (
            (held in _HELD_UP and side in _ASIDE)
            or (before.preposition in _SOURCES and side in _ASIDE)
            or (held == "at" and side in ("under", "over"))
            or (held == "on" and side == "at" and not roles.subjects and _is_opening(state, place))
            or (held in _BESIDE and side == "next_to" and bool(roles.subjects))
        )
        and len(before.things) == len(place.things + place.people) == 1
        and not before.people
        and before.nouns[0].index < place.nouns[0].index
        and not _is_separated(state, before, place)
        and _is_fixed_piece(state, before)
        and (_is_landmark(state, roles, place) or state.inventory.head(before.things[0]) in PEGS)
        and before.things != place.things
    )


def _is_separated(state: ReaderState, before: Place, place: Place) -> bool:
    """Whether a comma separates two places, so that both are the subject's: ``On the sledge, under a canvas,``."""
    between = state.sentence.words[before.nouns[0].index : place.nouns[0].index]
    return any(word.text == "," for word in between)


@rule("relations.support", without=[])
def support_relations(state: ReaderState, roles: Roles) -> list[StatedRelation]:
    """Return the relations between pieces of furniture that the places of a clause tell.

    Args:
        state: The reader's state before the clause.
        roles: People and things of a clause that tells where its subject is.
    """
    found: list[StatedRelation] = []
    for at, place in enumerate(roles.places):
        side = lexicon.relation_of(place.preposition)
        if side and locates_support(state, roles, at):
            sides = [*(person.id for person in place.people), *place.things]
            found.extend((roles.places[at - 1].things[0], side, other) for other in sides)
    return found


def _is_opening(state: ReaderState, place: Place) -> bool:
    """Whether a place is a door or window: in ``on a tripod at the window`` the tripod is at it."""
    return bool(place.things) and state.inventory.head(place.things[0]) in OPENINGS


def _is_landmark(state: ReaderState, roles: Roles, place: Place) -> bool:
    """Whether a place is furniture, or a person with only a thing before: ``On a table behind him lies a tray``."""
    if place.people:
        return not roles.subjects and lexicon.relation_of(place.preposition) in ("behind", "in_front_of")
    return state.inventory.class_of(place.things[0]) == "set_piece" or state.inventory.head(place.things[0]) in _LAMPS


def _is_fixed_piece(state: ReaderState, place: Place) -> bool:
    """Whether a place is furniture or a hook in the wall, and neither floor nor a carried thing."""
    head, kind = state.inventory.head(place.things[0]), state.inventory.class_of(place.things[0])
    return head not in FLOOR | SURFACES and (kind == "set_piece" or (head in PEGS and kind in THING_CLASSES))
