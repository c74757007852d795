"""Which places of a clause tell where its subject is once the clause is over."""

from __future__ import annotations

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.places.anchors import (
    ARRIVING,
    ATTACHING,
    BENT,
    FLOOR,
    GETTING_DOWN,
    HANGING,
    STATIVE,
    furniture_and_props,
)
from storyblender.agents.director.reader.places.supports import locates_support
from storyblender.agents.director.reader.state import ReaderState

_AT_REST = lexicon.words("at_rest")
"""Verbs that tell where a thing is, not what a person does."""
_ALWAYS = frozenset({"be", "stay", "remain", "wait"})
"""What comes after them is no object that is moved."""
_STILL = frozenset({"sit", "stand", "lie_down", "kneel", "lean", "sleep", "hide", "crouch"})
_PLACING = lexicon.words("placing")
_GAZE = lexicon.words("gaze")
_BESIDE = frozenset(word.replace("_", " ") for word in lexicon.words("beside"))
"""Prepositions that tell where a person is whatever they do: ``runs alongside him``."""
_COMING_TO_REST, _WHERE = (
    lexicon.words("coming_to_rest"),
    ("on", "to", "in", "into", "onto", "under", "behind", "beneath", "across"),
)
_AT_WORK = frozenset({"cook", "eat", "drink", "read", "write", "type", "work", "cut", "clean", "pour", "play_music"})
_CONSUMING = frozenset({"eat", "drink", "read", "smoke"})
"""``eats a sandwich on a ladder``: it is the eater who is on it."""
_BACKING = lexicon.words("backing")
"""``backs against the wall``."""
_CREEPING = frozenset({"crawl", "creep", "scramble", "squeeze", "slide", "slip", "roll", "wriggle", "dive"})
_SEEING = frozenset({"see", "look", "glance", "stare", "spot", "notice", "hear"})
_SEATED = frozenset({"turn", "look_around", "laugh", "cry", "wear", "light", "play_music", "phone", "wake", "talk"})
"""What a person does without leaving the seat."""
_SEATS_TAKEN = frozenset({"seat", "place", "chair", "post", "stand"})
"""``takes her place at the window``."""
_MOVING = lexicon.words("moving")
"""Verbs after which a thing is somewhere else than the words say."""
_WITH_PREPOSITIONS = frozenset(
    {"on", "over", "under", "across", "on top of", "underneath", "beneath", "inside", "below", "above"}
)
"""``with her feet on the desk``."""
_STATIC = frozenset(
    {"on", "upon", "atop", "in", "inside", "under", "underneath", "beneath", "above", "over", "behind", "beside", "by",
     "next to", "near", "in front of", "on top of", "between", "among"}
)  # fmt: skip
"""Prepositions that tell where a thing is that does something: ``A kettle sings on the stove``."""


def subject_stays(state: ReaderState, clause: Clause, roles: Roles, motion: str | None) -> bool:
    """Whether a clause tells where its subject rests: it stands, is laid, hangs there.

    Args:
        state: The reader's state before the clause.
        clause: A clause that is not negated.
        roles: The people and things of the clause.
        motion: Motion of its subject, or None.
    """
    if _settles_itself(clause, roles):
        return True
    if clause.verb not in _ALWAYS and not clause.passive and _moves_something(state, roles, motion):
        return False
    still = (
        clause.verb in STATIVE
        or (clause.verb in BENT and clause.passive)
        or clause.verb in ARRIVING
        or motion in _STILL
    )
    laid = clause.verb in _AT_REST and not roles.subjects
    put_there = clause.passive and (not roles.subjects or clause.verb in _PLACING | _AT_REST | ATTACHING)
    return still or laid or put_there


def _settles_itself(clause: Clause, roles: Roles) -> bool:
    """Whether the subject settles: ``lowers himself into the chair``, ``joins her on the bench``."""
    own = bool(roles.people) and roles.people == roles.subjects and clause.verb in _PLACING | STATIVE | _BACKING
    seat = clause.verb in ("take", "find", "have", "resume") and any(n.head in _SEATS_TAKEN for n in clause.object)
    return bool(roles.subjects) and (own or seat or clause.verb == "join")


def _moves_something(state: ReaderState, roles: Roles, motion: str | None) -> bool:
    """Whether the object is what moves: ``sets the doll on the chair``, not ``leans her head on the chair``."""
    classes = {state.inventory.class_of(thing) for thing in roles.things} - {"abstract"}
    classes -= set() if state.sentence.verb in _PLACING else {"unknown"}
    return bool(roles.people) or bool(classes - {"body"}) or (bool(classes) and motion not in _STILL)


def _has_furniture(state: ReaderState, place: Place) -> bool:
    """Whether a place names furniture or scenery: ``writes at the desk``, but not ``works at the knot``."""
    return any(state.inventory.class_of(thing) in ("set_piece", "scenery") for thing in place.things)


def subject_places(state: ReaderState, clause: Clause, roles: Roles, motion: str | None) -> list[Place]:
    """Return the places of a clause that tell where its subject is once the clause is over.

    Args:
        state: The reader's state before the clause.
        clause: A clause that is not negated.
        roles: The people and things of the clause.
        motion: Motion of its subject, or None.
    """
    if subject_stays(state, clause, roles, motion):
        own = [at for at in range(len(roles.places)) if not locates_support(state, roles, at)]
        return [roles.places[at] for at in own if not (at and _belongs_to_with(state, roles, at))]
    if clause.opening and clause.verb not in _SEEING:
        first = max(0, len(roles.places) - clause.opening)
        return [roles.places[at] for at in range(first, len(roles.places)) if not locates_support(state, roles, at)]
    if motion == "fall" or (roles.subject_things and clause.verb in _COMING_TO_REST):
        return [place for place in roles.places if place.preposition in _WHERE]
    if not roles.subjects:
        rests = clause.verb not in _MOVING and not roles.things
        return [place for place in roles.places if rests and _locates_active_thing(state, clause, place)]
    if clause.verb in _GAZE or (clause.verb in _PLACING and roles.things):
        return []
    return [
        place
        for place in roles.places
        if (place.preposition == "at" and motion in _AT_WORK and _has_furniture(state, place))
        or (place.preposition in ("on", "in") and motion in _CONSUMING and _has_furniture(state, place))
        or (place.preposition == "on" and _is_seat(state, place) and _only_body(state, roles) and motion in _SEATED)
        or (
            place.preposition == "against"
            and clause.verb in _BACKING
            and _only_body(state, roles)
            and bool(place.things)
        )
        or (place.preposition in _BESIDE and _is_beside(state, roles, place))
        or (not roles.things + roles.people and _moves_to_place(state, clause, place))
    ]


def _moves_to_place(state: ReaderState, clause: Clause, place: Place) -> bool:
    """Whether the subject ends at the place: ``hops to the floor``, ``crawls under the bed``."""
    if place.preposition == "to":
        return clause.verb in GETTING_DOWN and any(state.inventory.head(thing) in FLOOR for thing in place.things)
    return place.preposition in ("under", "underneath", "beneath") and clause.verb in _CREEPING


def _is_seat(state: ReaderState, place: Place) -> bool:
    """Whether a place names a seat."""
    return any(state.inventory.head(thing) in lexicon.SEATS for thing in place.things)


def _only_body(state: ReaderState, roles: Roles) -> bool:
    """Whether the object of the clause is nothing but body parts."""
    return all(state.inventory.class_of(thing) == "body" for thing in roles.things)


def _is_beside(state: ReaderState, roles: Roles, place: Place) -> bool:
    """Whether a place beside is the subject's: ``runs alongside him``, but not ``pulls a chair up beside him``."""
    return not (roles.things + roles.people) or (bool(place.people) and not furniture_and_props(state, roles.things))


def _locates_active_thing(state: ReaderState, clause: Clause, place: Place) -> bool:
    """Whether a place tells where an active thing is: ``A kettle sings on the stove``."""
    if place.preposition == "from":
        return clause.verb in HANGING
    return place.preposition in _STATIC and any(
        state.inventory.class_of(thing) in ("prop", "set_piece") for thing in place.things
    )


def _belongs_to_with(state: ReaderState, roles: Roles, at: int) -> bool:
    """Whether a place belongs to what follows ``with`` or to a support: ``sits with her feet on the desk``."""
    before, place = roles.places[at - 1], roles.places[at]
    if before.preposition == "of" and at > 1:
        before = roles.places[at - 2]  # with a basket of bread on the handlebars
    if place.nouns[0].index < before.nouns[0].index:
        return False
    if before.preposition == "with":
        return bool(before.things) and place.preposition in _WITH_PREPOSITIONS
    pieces = any(state.inventory.class_of(thing) == "set_piece" for thing in place.things)
    supported = lexicon.relation_of(before.preposition) in ("on", "in") and any(
        state.inventory.class_of(thing) == "set_piece" for thing in before.things
    )
    side = lexicon.relation_of(place.preposition) in ("behind", "in_front_of", "next_to", "under", "over")
    return not roles.subjects and supported and side and (pieces or bool(place.people))
