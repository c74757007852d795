"""What one place of a clause states about its subject: which relation, to what."""

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
    THINGS,
    TURNING,
    Stated,
    at_body,
    exact_kind,
    is_the_place,
    kind_at_body,
    leans_on_a_stick,
)
from storyblender.agents.director.reader.state import Stage
from storyblender.agents.director.rules import rule
from storyblender.memory.vocabulary import RelationKind

_ANCHORS = THINGS | {"scenery"}
_LYING = frozenset({"lie_down", "fall", "sleep"})
"""``sprawls across the bed`` is on it, who sits across the room is not."""
_SINKING = frozenset({"fall", "collapse", "sink", "slump", "crumple", "tumble", "crash", "topple"})
_IMAGES = frozenset({"mirror", "photo", "photograph", "picture", "painting", "screen", "monitor", "reflection"})


@rule("relations.stated", without=[])
def state_place(stage: Stage, clause: Clause, place: Place, located: list[str], motion: str | None) -> list[Stated]:
    """What a place says of who or what is there.

    Args:
        stage: The state before.
        clause: Not negated.
        place: One of its places that tell where its subject is.
        located: Ids of the subject, at least one.
        motion: The motion of the subject.
    """
    kind = _kind(stage, clause, place, located)
    if kind is None or kind == "between" or place.preposition == "down":
        return []
    past_it = (
        place.preposition == "across"
        and motion not in _LYING
        and not clause.passive
        and stage.person(located[0]) is not None
    )
    earlier = place.preposition == "before" and clause.verb == "be" and bool(place.people)  # was there before her
    bends = place.preposition == "close to" and clause.verb in BENT | {"lean"}
    if past_it or earlier or bends or _is_an_image(stage, kind, place):
        return []
    if kind == "behind" and clause.verb not in STATIVE and stage.inventory.head(located[0]) in OPENINGS:
        return []  # behind her the door opens: it is somewhere in the room
    openings = any(stage.inventory.head(thing) in OPENINGS for thing in place.things)
    if kind == "on" and openings and stage.person(located[0]):
        return []  # with his hand upon the gate
    if kind == "over" and clause.verb in BENT - {"hunch"} | {"lean"} and not clause.passive:
        return []  # stoops over the book, and is up again
    if kind == "in" and stage.person(located[0]) and (_wraps(stage, place) or _is_corner(stage, place)):
        return []  # in a blanket: that is what somebody wears
    doorway = any(stage.inventory.head(thing) == "doorway" for thing in place.things)
    doorway |= kind == "at" and clause.verb in TURNING and openings
    beside = kind in ("behind", "in_front_of", "next_to")
    halts = clause.verb in HALTING and kind == "at"
    arriving = clause.verb in ARRIVING and not halts and motion != "sit" and stage.person(located[0]) is not None
    if arriving and not (beside or doorway or clause.passive):
        return []
    anchors = [person.id for person in place.people if kind != "at"]
    anchors += [thing for thing in place.things if _is_anchor(stage, kind, thing)]
    body = at_body(place)
    if body:
        if kind == "under":
            return []  # ducks under his arm
        kind = kind_at_body(place.preposition, body[0], kind)
        anchors = [body[1]]
    if kind is None:
        return []
    if kind == "over" and stage.inventory.head(located[0]) in CLOTHS and not body:
        kind = "on"
    return [
        (subject, exact_kind(stage, kind, anchor, clause.verb), anchor)
        for anchor in anchors
        if not (is_the_place(stage, anchor) and kind in ("in", "at"))
        for subject in located
        if subject != anchor and not leans_on_a_stick(stage, subject, anchor)
    ]


def _kind(stage: Stage, clause: Clause, place: Place, located: list[str]) -> RelationKind | None:
    """What the preposition says of this verb: ``pinned to`` and ``hangs from`` are on."""
    if place.preposition == "to" and clause.verb in ATTACHING:
        living = stage.person(located[0]) is not None
        seat = any(stage.inventory.head(thing) in lexicon.SEATS for thing in place.things)
        vehicle = stage.inventory.head(located[0]) in lexicon.VEHICLES
        return "next_to" if (living and not seat) or vehicle else "on"
    if place.preposition == "to" and any(stage.inventory.head(thing) in FLOOR for thing in place.things):
        return "on" if stage.person(located[0]) is None or clause.verb in _SINKING | GETTING_DOWN else None
    if place.preposition == "from" and clause.verb in HANGING:
        return None if stage.person(located[0]) or at_body(place) else "on"
    if place.preposition in ("around", "round") and _ring(stage, place):
        return "at" if stage.person(located[0]) else "next_to"
    return lexicon.relation_of(place.preposition)


def _is_anchor(stage: Stage, kind: RelationKind, thing: str) -> bool:
    """Whether something is in, on or beside a thing; scenery is no place to be at."""
    if stage.inventory.head(thing) in FLOORING | {"step"} and kind == "on":
        return True
    surface = stage.inventory.head(thing) in SURFACES and kind in ("on", "in")
    if stage.inventory.head(thing) == "water":
        return False
    at_large = kind in ("in", "at") and stage.inventory.class_of(thing) == "scenery" and not surface
    return stage.inventory.class_of(thing) in _ANCHORS and not at_large


def _ring(stage: Stage, place: Place) -> bool:
    """``sit around the table``, but not ``stand around the corner``."""
    return any(stage.inventory.class_of(thing) in ("set_piece", "prop") for thing in place.things)


def _wraps(stage: Stage, place: Place) -> bool:
    return any(stage.inventory.head(thing) in CLOTHS | lexicon.WORN for thing in place.things)


def _is_corner(stage: Stage, place: Place) -> bool:
    return any(stage.inventory.head(thing) == "corner" for thing in place.things)


def _is_an_image(stage: Stage, kind: RelationKind, place: Place) -> bool:
    """``In the mirror stands a man``: he is somewhere else."""
    return kind == "in" and any(stage.inventory.head(thing) in _IMAGES for thing in place.things)
