"""Where people and things are in relation to each other (notes of the director, 4.3)."""

from __future__ import annotations

import re
from dataclasses import replace

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import joined
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.places.anchors import (
    CLOTHS,
    FLOOR,
    OPENINGS,
    SURFACES,
    THINGS,
    Stated,
    at_body,
    exact_kind,
    is_the_place,
    kind_at_body,
    leans_on_a_stick,
)
from storyblender.agents.director.reader.places.contents import relate_contents
from storyblender.agents.director.reader.places.put_places import put, puts_something
from storyblender.agents.director.reader.places.supports import describes_support, relate_supports
from storyblender.agents.director.reader.stage import Stage
from storyblender.agents.director.reading import Person
from storyblender.memory.vocabulary import RelationKind

_STATIVE = lexicon.words("stative")
_AT_REST = lexicon.words("at_rest")
"""Verbs that tell where a thing is, not what somebody does."""
_ALWAYS = frozenset({"be", "stay", "remain", "wait"})
"""What comes after them is no object that is moved."""
_TURNING = frozenset({"turn", "hesitate"})
"""``turns at the door``."""
_HALTING = frozenset({"stop", "pause", "halt"})
"""``stops at the counter``."""
_ARRIVING = (
    frozenset({"drop", "emerge", "step", "watch", "follow", "appear", "stop", "pause", "halt", "pull"}) | _TURNING
)
"""Verbs that place only relative to people: behind, before, beside."""
_STILL = frozenset({"sit", "stand", "lie_down", "kneel", "lean", "sleep", "hide", "crouch"})
_PLACING = lexicon.words("placing")
_ANCHORS = THINGS | {"scenery"}
_ATTACHING, _GAZE = lexicon.words("attaching"), lexicon.words("gaze")
_BESIDE = frozenset(word.replace("_", " ") for word in lexicon.words("beside"))
"""Prepositions that tell where somebody is whatever they do: ``runs alongside him``."""
_COMING_TO_REST, _WHERE = (
    lexicon.words("coming_to_rest"),
    ("on", "to", "in", "into", "onto", "under", "behind", "beneath"),
)
_AT_WORK = frozenset({"cook", "eat", "drink", "read", "write", "type", "work", "cut", "clean", "pour", "play_music"})
_CONSUMING = frozenset({"eat", "drink", "read", "smoke"})
"""``eats a sandwich on a ladder``: it is the eater who is on it."""
_BACKING = frozenset(
    {"back", "press", "flatten", "shrink", "retreat", "stagger", "crash", "slam", "lean", "prop", "brace"}
)
"""``backs against the wall``."""
_SINKING = frozenset({"fall", "collapse", "sink", "slump", "crumple", "tumble", "crash", "topple"})
_CREEPING = frozenset({"crawl", "creep", "scramble", "squeeze", "slide", "slip", "roll", "wriggle", "dive"})
_GETTING_DOWN = frozenset({"hop", "jump", "leap", "drop", "slide", "climb", "clamber", "spring"})
"""``hops to the floor``."""
_HANGING = frozenset({"hang", "dangle", "swing", "droop", "suspend", "sway"})
"""``swings from a hook`` is on it."""
_BOARDING = frozenset(
    {"get", "climb", "step", "hop", "scramble", "slide", "jump", "clamber", "leap", "squeeze", "crawl"}
)
_BENT = frozenset({"bend", "stoop", "hunch", "bow"})
"""``is bent over the desk``, but who bends over it does not stay so."""
_SEATS_TAKEN = frozenset({"seat", "place", "chair", "post", "stand"})
"""``takes her place at the window``."""
_IMAGES = frozenset({"mirror", "photo", "photograph", "picture", "painting", "screen", "monitor", "reflection"})
_SIDES = frozenset({"to the left of", "to the right of"})
_ON_THE_SIDE = re.compile(r"\bto (?:her|his|their) (left|right)\b|\bto the (left|right) of\b")
_BESIDE_FURNITURE = ("by", "near", "next to", "beside", "in front of")
_MOVING = lexicon.words("moving")
"""Verbs after which a thing is somewhere else than the words say."""
_STATIC = frozenset(
    {"on", "upon", "atop", "in", "inside", "under", "underneath", "beneath", "above", "over", "behind", "beside", "by",
     "next to", "near", "in front of", "on top of", "between", "among"}
)  # fmt: skip
"""Prepositions that tell where a thing is that does something: ``A radio plays on the shelf``."""


def relate_clause(stage: Stage, clause: Clause, roles: Roles, motion: str | None, first: bool) -> None:
    """State the relations a clause tells.

    Args:
        stage: The state before.
        clause: Not negated.
        roles: Its people and things.
        motion: The motion of its subject.
        first: Whether it is the first clause of its sentence.
    """
    roles = _at_particle(clause, roles)
    roles = replace(roles, places=_across_from(roles.places))
    located = [person.id for person in roles.subjects] or [
        thing for thing in roles.subject_things if stage.inventory.class_of(thing) in THINGS
    ]
    found: list[Stated] = []
    if located:
        for place in _telling_places(stage, clause, roles, motion):
            found += _placed(stage, clause, place, located, motion)
        if _is_still(stage, clause, roles, motion):
            found += relate_supports(stage, roles)
        if _is_still(stage, clause, roles, motion) or (motion in ("walk", "sneak") and not roles.things):
            _between(stage, roles, located)
        if clause.verb == "face":
            found.extend((s, "facing", o) for s in located for o in [p.id for p in roles.people] + _solid(stage, roles))
        if clause.verb in _BOARDING and not clause.opening and not roles.things + roles.people:
            found += _aboard(stage, roles, located)
    if first and roles.subjects and not any(place.preposition in _SIDES and place.things for place in roles.places):
        _left_or_right(stage, roles.subjects)
    if puts_something(clause, roles, motion):
        found += put(stage, roles)
    for subject, kind, anchor in _seat_beside(stage, roles, motion, found):
        stage.relate(subject, kind, anchor)
    relate_contents(stage, clause, roles)


def _at_particle(clause: Clause, roles: Roles) -> Roles:
    """``is bent over the desk``, ``squats on a basket``: the particle of the verb tells a place."""
    bent = clause.verb in _BENT and clause.passive
    resting = (clause.verb in _STATIVE or bent) and clause.particle in lexicon.RELATION_OF_PREPOSITION
    leaning = clause.verb == "lean" and clause.particle == "over"
    if not resting or leaning or not clause.object:
        return roles
    place = Place(clause.particle, roles.people, roles.things, clause.object)
    return replace(roles, people=[], things=[], places=[place, *roles.places])


def _across_from(places: list[Place]) -> list[Place]:
    """``across the desk from him`` is across from him."""
    joined_places: list[Place] = []
    for place in places:
        before = joined_places[-1] if joined_places else None
        if before and before.preposition == "across" and place.preposition == "from" and place.people:
            joined_places[-1] = replace(place, preposition="across from")
        else:
            joined_places.append(place)
    return joined_places


def _is_still(stage: Stage, clause: Clause, roles: Roles, motion: str | None) -> bool:
    """Whether a clause tells where its subject is: it stands, is laid, hangs there."""
    if _settles_itself(clause, roles):
        return True
    if clause.verb not in _ALWAYS and not clause.passive and _moves_something(stage, roles, motion):
        return False
    still = (
        clause.verb in _STATIVE
        or (clause.verb in _BENT and clause.passive)
        or clause.verb in _ARRIVING
        or motion in _STILL
    )
    laid = clause.verb in _AT_REST and not roles.subjects
    put_there = clause.passive and (not roles.subjects or clause.verb in _PLACING | _AT_REST | _ATTACHING)
    return still or laid or put_there


def _settles_itself(clause: Clause, roles: Roles) -> bool:
    """``lowers himself into the chair``, ``takes a seat beside Kate``, ``joins her on the bench``."""
    own = bool(roles.people) and roles.people == roles.subjects and clause.verb in _PLACING | _STATIVE | _BACKING
    seat = clause.verb in ("take", "find", "have", "resume") and any(n.head in _SEATS_TAKEN for n in clause.object)
    return bool(roles.subjects) and (own or seat or clause.verb == "join")


def _moves_something(stage: Stage, roles: Roles, motion: str | None) -> bool:
    """``sets the doll on the chair``, ``rests her hands on the book``, but not ``leans her head on the chair``."""
    classes = {stage.inventory.class_of(thing) for thing in roles.things} - {"abstract"}
    classes -= set() if stage.sentence.verb in _PLACING else {"unknown"}
    return bool(roles.people) or bool(classes - {"body"}) or (bool(classes) and motion not in _STILL)


def _has_furniture(stage: Stage, place: Place) -> bool:
    """``writes at the desk``, but not ``works at the knot``."""
    return any(stage.inventory.class_of(thing) in ("set_piece", "scenery") for thing in place.things)


def _telling_places(stage: Stage, clause: Clause, roles: Roles, motion: str | None) -> list[Place]:
    """The places of a clause that tell where its subject is once it is over."""
    if _is_still(stage, clause, roles, motion):
        own = [at for at in range(len(roles.places)) if not describes_support(stage, roles, at)]
        return [roles.places[at] for at in own if not (at and _goes_with(stage, roles, at))]
    if clause.opening:
        return roles.places[-clause.opening :]
    if motion == "fall" or (roles.subject_things and clause.verb in _COMING_TO_REST):
        return [place for place in roles.places if place.preposition in _WHERE]
    if not roles.subjects:
        rests = clause.verb not in _MOVING and not roles.things
        return [place for place in roles.places if rests and _is_where(stage, clause, place)]
    if clause.verb in _GAZE or (clause.verb in _PLACING and roles.things):
        return []
    return [
        place
        for place in roles.places
        if (place.preposition == "at" and motion in _AT_WORK and _has_furniture(stage, place))
        or (place.preposition in ("on", "in") and motion in _CONSUMING and not place.people)
        or (
            place.preposition == "against"
            and clause.verb in _BACKING
            and _only_body(stage, roles)
            and bool(place.things)
        )
        or (place.preposition in _BESIDE and _is_beside(stage, roles, place))
        or (not roles.things + roles.people and _gets_there(stage, clause, place))
    ]


def _gets_there(stage: Stage, clause: Clause, place: Place) -> bool:
    """``hops to the floor``, ``crawls under the bed``."""
    if place.preposition == "to":
        return clause.verb in _GETTING_DOWN and any(stage.inventory.head(thing) in FLOOR for thing in place.things)
    return place.preposition in ("under", "underneath", "beneath") and clause.verb in _CREEPING


def _solid(stage: Stage, roles: Roles) -> list[str]:
    return [thing for thing in roles.things if stage.inventory.class_of(thing) in ("prop", "set_piece")]


def _only_body(stage: Stage, roles: Roles) -> bool:
    return all(stage.inventory.class_of(thing) == "body" for thing in roles.things)


def _is_beside(stage: Stage, roles: Roles, place: Place) -> bool:
    """``runs alongside him``; ``pulls a chair up beside him`` tells where the chair is."""
    return not (roles.things + roles.people) or (bool(place.people) and not _solid(stage, roles))


def _is_where(stage: Stage, clause: Clause, place: Place) -> bool:
    """``A radio plays on the shelf``, ``A lantern swings from a hook``: where a thing is that does something."""
    if place.preposition == "from":
        return clause.verb in _HANGING
    return place.preposition in _STATIC and any(
        stage.inventory.class_of(thing) in ("prop", "set_piece") for thing in place.things
    )


def _goes_with(stage: Stage, roles: Roles, at: int) -> bool:
    """``sits with her feet on the desk``: the feet are on it; ``lies on the sofa behind them``: the sofa is there."""
    before, place = roles.places[at - 1], roles.places[at]
    if place.nouns[0].index < before.nouns[0].index:
        return False
    if before.preposition == "with":
        return bool(before.things) and place.preposition in ("on", "over", "under", "across")
    pieces = any(stage.inventory.class_of(thing) == "set_piece" for thing in place.things)
    supported = lexicon.relation_of(before.preposition) in ("on", "in") and any(
        stage.inventory.class_of(thing) == "set_piece" for thing in before.things
    )
    side = lexicon.relation_of(place.preposition) in ("behind", "in_front_of", "next_to", "under", "over")
    return not roles.subjects and supported and side and (pieces or bool(place.people))


def _aboard(stage: Stage, roles: Roles, located: list[str]) -> list[Stated]:
    """``climbs onto a chair``, ``gets into the car``."""
    found: list[Stated] = []
    for place in roles.places:
        for thing in place.things:
            solid = stage.inventory.class_of(thing) in ("set_piece", "prop") and not is_the_place(stage, thing)
            if place.preposition in ("onto", "on to") and (solid or stage.inventory.head(thing) in SURFACES):
                found.extend((subject, "on", thing) for subject in located)
            elif place.preposition in ("into", "aboard", "inside") and solid:
                found.extend((subject, exact_kind(stage, "in", thing, ""), thing) for subject in located)
    return found


def _placed(stage: Stage, clause: Clause, place: Place, located: list[str], motion: str | None) -> list[Stated]:
    kind = _kind(stage, clause, place, located)
    if kind is None or kind == "between" or place.preposition == "down":
        return []
    past_it = place.preposition == "across" and clause.verb == "be" and stage.person(located[0]) is not None
    if past_it or _is_an_image(stage, kind, place):
        return []
    if kind == "behind" and clause.verb not in _STATIVE and stage.inventory.head(located[0]) in OPENINGS:
        return []  # behind her the door opens: it is somewhere in the room
    openings = any(stage.inventory.head(thing) in OPENINGS for thing in place.things)
    if kind == "on" and openings and stage.person(located[0]):
        return []  # with his hand upon the gate
    if kind == "over" and clause.verb in _BENT - {"hunch"} and not clause.passive:
        return []  # stoops over the book, and is up again
    if kind == "in" and stage.person(located[0]) and _wraps(stage, place):
        return []  # in a blanket: that is what somebody wears
    doorway = any(stage.inventory.head(thing) == "doorway" for thing in place.things)
    doorway |= kind == "at" and clause.verb in _TURNING and openings
    beside = kind in ("behind", "in_front_of", "next_to")
    halts = clause.verb in _HALTING and kind == "at" and not openings
    arriving = clause.verb in _ARRIVING and not halts and motion != "sit" and stage.person(located[0]) is not None
    if arriving and not (beside or doorway or clause.passive):
        return []
    anchors = [person.id for person in place.people]
    anchors += [thing for thing in place.things if stage.inventory.class_of(thing) in _ANCHORS]
    if kind in ("in", "at") and place.things and stage.inventory.class_of(place.things[0]) == "scenery":
        anchors = [person.id for person in place.people]
        surfaces = kind == "in" or place.preposition in ("on", "onto", "upon")
        anchors += [thing for thing in place.things if surfaces and stage.inventory.head(thing) in SURFACES]
    body = at_body(place)
    if body:
        if kind == "under":
            return []  # ducks under his arm
        kind = kind_at_body(place.preposition, body[0], kind)
        anchors = [body[1]]
    if kind is None:
        return []
    return [
        (subject, exact_kind(stage, kind, anchor, clause.verb), anchor)
        for anchor in anchors
        if not (is_the_place(stage, anchor) and kind in ("in", "at"))
        for subject in located
        if subject != anchor and not leans_on_a_stick(stage, subject, anchor)
    ]


def _kind(stage: Stage, clause: Clause, place: Place, located: list[str]) -> RelationKind | None:
    """What the preposition says of this verb: ``pinned to`` and ``hangs from`` are on."""
    if place.preposition == "to" and clause.verb in _ATTACHING:
        living = stage.person(located[0]) is not None
        seat = any(stage.inventory.head(thing) in lexicon.SEATS for thing in place.things)
        vehicle = stage.inventory.head(located[0]) in lexicon.VEHICLES
        return "next_to" if (living and not seat) or vehicle else "on"
    if place.preposition == "to" and any(stage.inventory.head(thing) in FLOOR for thing in place.things):
        return "on" if stage.person(located[0]) is None or clause.verb in _SINKING | _GETTING_DOWN else None
    if place.preposition == "from" and clause.verb in _HANGING:
        return None if stage.person(located[0]) or at_body(place) else "on"
    if place.preposition in ("around", "round") and _ring(stage, place):
        return "at" if stage.person(located[0]) else "next_to"
    return lexicon.relation_of(place.preposition)


def _ring(stage: Stage, place: Place) -> bool:
    """``sit around the table``, but not ``stand around the corner``."""
    return any(stage.inventory.class_of(thing) in ("set_piece", "prop") for thing in place.things)


def _wraps(stage: Stage, place: Place) -> bool:
    return any(stage.inventory.head(thing) in CLOTHS | lexicon.WORN for thing in place.things)


def _is_an_image(stage: Stage, kind: RelationKind, place: Place) -> bool:
    """``In the mirror stands a man``: he is somewhere else."""
    return kind == "in" and any(stage.inventory.head(thing) in _IMAGES for thing in place.things)


def _between(stage: Stage, roles: Roles, located: list[str]) -> None:
    """Between two anchors; a group counts as its members."""
    for place in roles.places:
        anchors = [person.id for person in place.people] + place.things
        if place.preposition == "between" and len(anchors) > 1:
            for subject in located:
                stage.relate(subject, "between", anchors[0], anchors[1])


def _left_or_right(stage: Stage, subjects: list[Person]) -> None:
    """``To her left, Dutch chews a toothpick.``"""
    side = _ON_THE_SIDE.search(joined(stage.sentence.words))
    if side is None:
        return
    kind: RelationKind = "left_of" if "left" in side.group(0) else "right_of"
    pronouns = stage.sentence.pronouns
    owner = next((pronouns[i][0] for i in sorted(pronouns) if stage.sentence.words[i].low in ("her", "his")), [])
    others = [person for person in owner if person not in subjects]
    others = others or [person for person in stage.on_stage() if person not in subjects][:1]
    for subject in subjects:
        for other in others:
            stage.relate(subject.id, kind, other.id)


def _seat_beside(stage: Stage, roles: Roles, motion: str | None, found: list[Stated]) -> list[Stated]:
    """``Sits in the armchair by the window``: it is the armchair that is by the window."""
    if motion not in ("sit", "lie_down", "sleep"):
        return found
    seats = [
        place.things[0]
        for place in roles.places
        if place.things
        and lexicon.relation_of(place.preposition) in ("on", "in", "at")
        and stage.inventory.class_of(place.things[0]) != "body"
        and stage.inventory.head(place.things[0]) in lexicon.SEATS | {"table", "desk"}
    ]
    beside = [
        place
        for place in roles.places
        if place.things
        and (
            (place.preposition in _BESIDE_FURNITURE and stage.inventory.class_of(place.things[0]) == "set_piece")
            or (place.preposition == "in" and stage.inventory.head(place.things[0]) == "corner")
        )
    ]
    at_table = any(kind == "at" for _, kind, _ in found)
    if not seats or not beside or (at_table and beside[0].preposition == "in front of"):
        return found
    if stage.inventory.head(seats[0]) in FLOOR or seats[0] == beside[0].things[0]:
        return found
    window = beside[0].things[0]
    kind = lexicon.relation_of(beside[0].preposition)
    moved = [relation for relation in found if relation[2] != window]
    return [*moved, (seats[0], kind, window)] if kind else moved
