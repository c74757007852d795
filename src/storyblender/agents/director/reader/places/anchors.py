"""What people and things can be in, on or beside, the relation a preposition then states, and verbs of place."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.people.roles import Place
from storyblender.agents.director.reader.state import ReaderState
from storyblender.memory.vocabulary import RelationKind

StatedRelation = tuple[str, RelationKind, str]
"""Who or what, the relation, to whom or what."""

THING_CLASSES = frozenset({"prop", "set_piece", "worn", "unknown"})
FLOORING = lexicon.words("flooring")
SURFACES = lexicon.words("surfaces") | FLOORING
"""What things lie on or in without being an asset: the floor, a corner."""
FLOOR = frozenset({"rug", "carpet", "floor", "ground"})
OPENINGS = frozenset({"door", "window", "gate"})
BODY_OR_DRESS = lexicon.BODY | lexicon.WORN
CLOTHS = lexicon.words("cloths")
"""What is spread over something lies on it."""
CONTAINERS = lexicon.words("containers")
_BOXES = frozenset({"crate", "box", "trunk", "barrel", "chest", "basket", "suitcase", "bucket"})
"""A person sits on them, but things are put in them."""


def exact_relation(state: ReaderState, kind: RelationKind, anchor: str, verb: str) -> RelationKind:
    """Return a relation corrected for its anchor: in an armchair is on it, leaning on is against.

    Args:
        state: The reader's state.
        kind: The relation that the preposition states.
        anchor: Id of the thing that the preposition precedes.
        verb: Verb of the clause; ``put`` where a thing is put there.
    """
    head = state.inventory.head(anchor)
    if kind == "on" and verb in ("lean", "slouch"):
        return "against"
    if kind == "in" and head in lexicon.SEATS - {"wall"} and not (verb == "put" and head in _BOXES):
        return "on"
    return kind


def is_scene_place(state: ReaderState, anchor: str) -> bool:
    """Whether a thing's noun only names the place of the scene itself: ``He sits in the cafe``.

    Args:
        state: The reader's state.
        anchor: Id of the thing.
    """
    head = state.inventory.head(anchor)
    return bool(head) and head in state.place.place.lower().split()


def is_carried_support(state: ReaderState, subject: str, anchor: str) -> bool:
    """Whether an anchor moves along with the subject, as a crutch or a leash does, and so is no place.

    Args:
        state: The reader's state.
        subject: Id of the person or thing that it would support.
        anchor: Id of the anchor.
    """
    walks = state.person(subject) is not None or state.inventory.class_of(subject) == "set_piece"
    return state.inventory.head(anchor) in (_STICKS if walks else _LEADS)


def can_hold_things(state: ReaderState, thing: str) -> bool:
    """Whether other things can be on, in or beside a thing: it is an asset, or a surface such as the floor.

    Args:
        state: The reader's state.
        thing: Id of the thing.
    """
    return state.inventory.class_of(thing) in THING_CLASSES or state.inventory.head(thing) in SURFACES


def furniture_and_props(state: ReaderState, things: list[str]) -> list[str]:
    """Return the ids that are furniture or props.

    Args:
        state: The reader's state.
        things: Ids of things.
    """
    return [thing for thing in things if state.inventory.class_of(thing) in ("prop", "set_piece")]


def body_part_at(place: Place) -> tuple[str, str] | None:
    """Return the body part that a place names and the id of its owner: ``on her lap``; also ``onto his coat``."""
    parts = BODY_OR_DRESS if place.preposition in _ONTO_A_PERSON else lexicon.BODY
    return next(((noun.head, noun.owner) for noun in place.nouns if noun.owner and noun.head in parts), None)


def relation_at_body(preposition: str, part: str, kind: RelationKind | None) -> RelationKind | None:
    """Return the relation to the owner of a body part, or None where there is no lasting one.

    ``at his elbow`` is next to him, ``around her neck`` and ``behind his ear`` are on him.

    Args:
        preposition: The preposition before the body part.
        part: Noun of the body part.
        kind: The relation that the preposition states for things, or None.
    """
    if part in _BESIDE_PARTS and preposition in ("at", "by", "near", "beside"):
        at_foot = part in _FEET and preposition == "at"
        return "behind" if part in _HEELS else "at" if at_foot else "next_to"
    if part == "back" and kind == "behind":
        return None  # hides it behind her back: it is in her hand
    if preposition == "between" or kind == "at" or (preposition == "to" and kind is None):
        return None
    if preposition in ("around", "round", "about", "across", "over", "through", "to", "onto"):
        return "on"
    if kind == "in":
        return "on" if part in _WORN_PARTS else None
    return "on" if part in _WORN_PARTS and kind == "behind" else kind


_BESIDE_PARTS = frozenset({"side", "elbow", "shoulder", "foot", "knee", "hand", "arm", "heel", "back"})
_FEET = frozenset({"foot", "knee"})
_HEELS = frozenset({"heel", "back"})
_WORN_PARTS = frozenset({"ear", "hair", "lip", "tooth", "belt", "waistband", "mouth", "collar", "lap", "arm"})
"""What is behind or in them is on a person."""
_ONTO_A_PERSON = frozenset({"on", "onto", "to", "around", "round", "about", "over", "across"})
FITTINGS = frozenset({"button", "switch", "knob", "handle", "lever", "dial"})
"""Parts of what they are on."""
BEARING = frozenset({"lap", "shoulder", "knee", "back", "hip"})
"""``sets the child on her lap``."""
_STICKS = frozenset({"stick", "cane", "crutch", "staff", "umbrella", "leash", "lead", "chain", "string"})
_LEADS = frozenset({"leash", "lead", "chain", "string"})


STATIVE, ATTACHING = lexicon.words("stative"), lexicon.words("attaching")
TURNING = frozenset({"turn", "hesitate"})
"""``turns at the door``."""
HALTING = frozenset({"stop", "pause", "halt"})
"""``stops at the counter``."""
ARRIVING = TURNING | HALTING | {"drop", "emerge", "step", "watch", "follow", "appear", "pull"}
"""Verbs that place only relative to people: behind, before, beside."""
GETTING_DOWN = frozenset({"hop", "jump", "leap", "drop", "slide", "climb", "clamber", "spring"})
"""``hops to the floor``."""
HANGING = frozenset({"hang", "dangle", "swing", "droop", "suspend", "sway"})
"""``swings from a hook`` is on it."""
BENT = frozenset({"bend", "stoop", "hunch", "bow"})
"""``is bent over the desk``, but who bends over it does not stay so."""
TOUCHING = lexicon.words("touching")
"""``bangs her stick on the floor``, ``draws a cross on it``."""
