"""Where things and people end up when they are put or moved somewhere: ``puts the tray on the table``."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.places.anchors import (
    BEARING,
    CLOTHS,
    CONTAINERS,
    FITTINGS,
    FLOOR,
    OPENINGS,
    TOUCHING,
    StatedRelation,
    body_part_at,
    can_hold_things,
    exact_relation,
    furniture_and_props,
    relation_at_body,
)
from storyblender.agents.director.reader.places.supports import PEGS
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import RelationKind

_PLACING, _ATTACHING, _SEATING = (lexicon.words(rule) for rule in ("placing", "attaching", "seating"))
_MOVED = frozenset({"put_down", "drop", "throw"})
_BRINGING = frozenset({"pull", "push", "carry"})
_DRAWN_UP = lexicon.words("drawn_up")
"""``pulls a chair up to the table``, ``drags a crate in front of the door``."""
_RETURNING = frozenset({"return", "restore", "add", "replace"})
"""``returns the book to the shelf``."""
_KINDS = frozenset({"on", "in", "under", "next_to", "behind", "against", "in_front_of", "over", "between"})
_THROWING = frozenset({"throw", "toss", "fling", "hurl", "lob", "chuck", "pass"})
_LOOPING = frozenset({"hook", "loop", "sling", "drape"})
_POCKETS = frozenset({"pocket", "belt", "waistband", "sleeve", "garter", "breast pocket"})
_TO_THERE = frozenset({"up to", "to", "over to"})
_NEAR = frozenset({"beside", "next to", "by", "near", "in front of", "against", "behind", "alongside", "under"})
_STOVES = frozenset({"stove", "fireplace", "furnace", "incinerator", "grate", "dumpster", "well"})
_RECENT_THINGS = 4
"""Things back to what something is thrown in."""
_EMPTYING = frozenset({"empty", "drain", "wring", "squirt"})
"""``empties the mug into the sink``: the mug stays in the hand."""


def moves_something(clause: Clause, roles: Roles, motion: str | None) -> bool:
    """Whether a clause moves its object, things or people, to another place.

    Args:
        clause: The clause.
        roles: The people and things of the clause.
        motion: Motion of its subject, or None.
    """
    touches = clause.verb in TOUCHING and clause.particle != "down"
    if clause.passive or roles.people == roles.subjects != [] or clause.verb in _EMPTYING or touches:
        return False
    aimed = bool(roles.prepositions & {"into", "onto", "on to"})
    carried = motion in _MOVED or clause.verb in _PLACING | _ATTACHING | _RETURNING or aimed
    drawn = clause.verb in _DRAWN_UP and bool(roles.prepositions & (_TO_THERE | _NEAR | {"across"}))
    seated = clause.verb in _SEATING | _PLACING | _ATTACHING or motion in _MOVED | _BRINGING or aimed
    return (bool(roles.things) and (carried or drawn)) or (bool(roles.people) and bool(roles.subjects) and seated)


@rule("relations.put", without=[])
def placed_relations(state: ReaderState, clause: Clause, roles: Roles) -> list[StatedRelation]:
    """Return where the objects of a clause end up: ``puts the ring into the pocket``.

    Args:
        state: The reader's state before the clause.
        clause: A clause for which ``moves_something`` holds.
        roles: The people and things of the clause.
    """
    moved = [thing for thing in roles.things if _can_be_placed(state, thing)]
    found: list[StatedRelation] = _dropped_in(state, clause, roles, moved)
    moved += [person.id for person in roles.people]
    for at, place in enumerate(roles.places):
        if place.preposition == "between":
            if len(place.people) == 1 and place.nouns[0].head == "them":
                place.people = [*place.people, *roles.subjects]
            relate_between(state, place, moved)
            continue
        if at and _describes_anchor(state, roles.places[at - 1], place):
            side, pieces = lexicon.relation_of(place.preposition), furniture_and_props(state, place.things)
            found.extend((roles.places[at - 1].things[0], side, piece) for piece in pieces if side)
            continue
        for thing in moved:
            kind = _relation_of_placing(state, place, thing, bool(roles.people_after("to", "toward", "towards")))
            if kind:
                anchors = _placing_anchors(state, roles, place, thing, kind)
                found.extend((thing, exact_relation(state, kind, anchor, "put"), anchor) for anchor in anchors)
    return _furniture_beside(state, roles, found)


def _dropped_in(state: ReaderState, clause: Clause, roles: Roles, moved: list[str]) -> list[StatedRelation]:
    """Relations to the container named last: ``opens the stove and throws the letter in``."""
    if clause.particle != "in" or any(place.things or place.people for place in roles.places):
        return []
    lately = [thing for thing in state.discourse.recent_things[:_RECENT_THINGS] if thing not in moved]
    holder = next((thing for thing in lately if state.inventory.head(thing) in CONTAINERS | _STOVES), None)
    return [(thing, "in", holder) for thing in moved if holder and state.inventory.class_of(thing) in ("prop", "worn")]


def _describes_anchor(state: ReaderState, before: Place, place: Place) -> bool:
    """Whether a place describes the place before it: ``clips it to the board above the desk``."""
    kind = lexicon.relation_of(place.preposition)
    pegs = any(state.inventory.head(thing) in PEGS for thing in before.things)
    side = kind in ("over", "under", "behind", "in_front_of") or (pegs and kind in ("next_to", "on"))
    fixed = pegs or any(state.inventory.class_of(thing) == "set_piece" for thing in before.things)
    return side and not place.people and fixed


def _can_be_placed(state: ReaderState, thing: str) -> bool:
    """Whether a thing is a prop or piece of its own, and no body part, liquid or fitting."""
    liquid = state.inventory.head(thing) in lexicon.LIQUIDS and state.sentence.verb in ("pour", "splash", "fill")
    part = state.inventory.head(thing) in FITTINGS | OPENINGS
    return state.inventory.class_of(thing) not in ("body", "abstract") and not liquid and not part


def _dresses_in(state: ReaderState, roles: Roles, thing: str, owner: str) -> bool:
    """Whether the subjects put a garment on themselves: ``jams the helmet onto her own head``."""
    return state.inventory.class_of(thing) == "worn" and owner in [person.id for person in roles.subjects]


def _relation_of_placing(state: ReaderState, place: Place, thing: str, passed_on: bool) -> RelationKind | None:
    """Return the relation that a preposition states for a thing put there, or None."""
    verb, kind = state.sentence.verb, lexicon.relation_of(place.preposition)
    cloth = state.inventory.head(thing) in CLOTHS
    if (kind == "over" and verb in _THROWING and not cloth) or _is_pocketed(place):
        return None
    body = body_part_at(place)
    if body:
        if verb in ("press", "push", "hold") and kind == "against":
            return None
        if state.person(thing):
            return "on" if kind == "on" and body[0] in BEARING else None
        attached = "on" if verb in _ATTACHING else kind
        return (
            None
            if state.inventory.head(thing) in lexicon.LIQUIDS
            else relation_at_body(place.preposition, body[0], attached)
        )
    if place.preposition == "across" and verb in _DRAWN_UP and passed_on:
        return None  # slides it across the desk to Kate: it does not stay there
    if place.preposition in _TO_THERE and verb in _DRAWN_UP:
        return "next_to" if state.inventory.class_of(thing) == "set_piece" else None
    if place.preposition == "to" and verb in _ATTACHING:
        seat = any(state.inventory.head(anchor) in lexicon.SEATS for anchor in place.things)
        tethered = state.person(thing) or state.inventory.head(thing) in lexicon.VEHICLES
        return "next_to" if tethered and not seat else "on"
    floor = any(state.inventory.head(anchor) in FLOOR for anchor in place.things)
    if place.preposition == "to" and (verb in _RETURNING or floor):
        return "on"
    if kind == "over":
        return (
            "on" if state.inventory.head(thing) in CLOTHS or verb in _LOOPING else None if verb in _THROWING else kind
        )
    return kind if kind in _KINDS else None


def _is_pocketed(place: Place) -> bool:
    """Whether a place is in the owner's clothes: ``puts the key in his pocket``."""
    return any(noun.head in _POCKETS and noun.possessor is not None for noun in place.nouns)


def _placing_anchors(state: ReaderState, roles: Roles, place: Place, thing: str, kind: RelationKind) -> list[str]:
    """Return the ids that a thing is put on, in or beside."""
    body = body_part_at(place)
    if body:
        return [] if _dresses_in(state, roles, thing, body[1]) else [body[1]]
    spread = kind == "on" and state.inventory.head(thing) in CLOTHS
    beside = kind in ("in_front_of", "next_to") or spread or (bool(roles.people) and kind == "behind")
    anchors = [person.id for person in place.people if beside]
    anchors += [anchor for anchor in place.things if can_hold_things(state, anchor)]
    on_oneself = any(noun.head in lexicon.BODY for noun in place.nouns)
    if kind == "on" and on_oneself and roles.subjects and not state.person(thing):
        anchors.append(roles.subjects[0].id)
    return [anchor for anchor in anchors if anchor != thing]


@rule("relations.between")
def relate_between(state: ReaderState, place: Place, located: list[str]) -> None:
    """State that things or people are between two anchors: ``between Joe and the door``, ``between the beds``.

    Args:
        state: The reader's state.
        place: The place with ``between``.
        located: Ids of who or what is there.
    """
    anchors = [person.id for person in place.people] + place.things
    several = len(anchors) == 1 and bool(place.things) and place.nouns[0].plural
    if len(anchors) > 1 or (several and state.inventory.class_of(anchors[0]) in ("prop", "set_piece")):
        for thing in located:
            if thing not in anchors:
                state.relate(thing, "between", anchors[0], anchors[1] if len(anchors) > 1 else None)


def _furniture_beside(state: ReaderState, roles: Roles, found: list[StatedRelation]) -> list[StatedRelation]:
    """Give the place beside furniture to the support: ``Lays her hat on the chair by the stove``."""
    pieces = [
        anchor for _, kind, anchor in found if kind in ("on", "in") and state.inventory.class_of(anchor) == "set_piece"
    ]
    beside = [
        place.things[0]
        for place in roles.places
        if place.preposition in ("by", "near", "next to", "beside")
        and place.things
        and state.inventory.class_of(place.things[0]) == "set_piece"
    ]
    if not pieces or not beside or beside[0] == pieces[0]:
        return found
    return [*(relation for relation in found if relation[2] != beside[0]), (pieces[0], "next_to", beside[0])]
