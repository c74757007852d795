"""The deeds of a clause: actor, motion, target, prop and distance."""

from __future__ import annotations

import re
from itertools import pairwise

from storyblender.agents.director import lexicon
from storyblender.agents.director.feelings import mood_of
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import joined
from storyblender.agents.director.reader.people.roles import Place, Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Deed, Person
from storyblender.agents.director.rules import rule

_TOWARDS = lexicon.words("towards")
_GOING = lexicon.words("going")
"""Motions whose target stands after a preposition even where there is an object."""
_THROUGH = frozenset({"read", "search", "look", "crawl", "climb", "jump", "walk", "run"})
_FOLLOWING = frozenset({"walk", "run", "sneak"})
"""Motions that may be after a person, wherever they lead."""
_TO_PLACES = _GOING - {"aim", "shoot"} | {"look"}
"""Motions that may go to a piece of scenery."""
_UPON = frozenset({"to", "against", "on", "onto", "upon"})
_MUTUAL = frozenset({"hug", "kiss", "shake_hands", "fight", "dance"})
_PAIRING = frozenset({"walk", "hug", "kiss", "run", "touch", "shake_hands"})
_QUALITIES = lexicon.ADJECTIVES | lexicon.words("manner")
_EACH_OTHER = re.compile(r"each other|one another")
_TRAVEL = frozenset({"walk", "run", "sneak", "crawl", "stagger", "climb"})
_LEADING = frozenset({"lead", "usher", "escort", "show", "see", "march", "guide", "shepherd", "walk"})
_CAUSING = frozenset({"let", "help", "sit", "seat"})
"""``lets him in``, ``helps her up``, ``sits Mia on the stool``: who is helped does it."""
_RAISING = frozenset({"pull", "haul", "drag", "heave", "yank", "hoist", "lift", "jerk", "tug"})
"""``pulls Edna to her feet``: she gets up."""
_BORNE = frozenset({"on", "in", "over", "under", "across"})
"""``walks with Milo on her shoulders``: he does not walk."""
_PORTIONS = frozenset({"bite", "sip", "swig", "gulp", "drag", "puff", "mouthful", "swallow", "stack", "go", "hold"})
"""``takes a bite of it``, ``lets go of the rope``."""
_SEATS = lexicon.SEATS | {"table", "desk", "counter", "bar"}
_OUT_OF = frozenset({"from", "off", "out of", "off of"})
_ONTO = frozenset({"on", "onto", "upon", "in", "into", "inside", "under", "over", "against", "at", "to"})
_ENDS = {
    "put_down": _ONTO, "throw": _ONTO, "pour": _ONTO, "hide": _ONTO, "take": _OUT_OF, "pick_up": _OUT_OF,
    "pull": _OUT_OF, "catch": _OUT_OF,
}  # fmt: skip
"""Motion -> prepositions before where its thing goes or comes from."""
_ENDING = frozenset({"prop", "set_piece", "unknown"})
_WORKED = frozenset({"wipe", "work", "hit", "cut", "open", "press", "push", "touch", "write", "wash", "tie"})
"""What is done with a tool in the hand."""
_METRES = {
    "metre": 1.0, "meter": 1.0, "foot": 0.3048, "feet": 0.3048, "step": 0.75, "pace": 0.75, "yard": 0.9144,
    "block": 80.0,
}  # fmt: skip
"""Length of a unit in metres."""
_DISTANCE = re.compile(
    rf"\b(\d+|{'|'.join(word for word in lexicon.NUMBERS)}|few|several)\s+(?:more |quick |slow |small |big |careful )?"
    r"(metre|meter|foot|feet|step|pace|yard|block)s?\b"
)


@rule("deeds.verb", without=[])
def add_deeds(state: ReaderState, clause: Clause, roles: Roles, motion: str) -> list[Deed]:
    """Add the deeds of a clause to the current unit and return them.

    Args:
        state: The reader's state before the clause.
        clause: A clause that is not negated.
        roles: The people and things of the clause.
        motion: Motion of its subject.
    """
    if motion in ("touch", "stand") and _only_a_pose(state, clause, roles, motion):
        return []
    target, prop = find_target(state, clause, roles, motion)
    target, prop = _both_ends(state, roles, motion, target, prop) or (target, prop)
    distance = _distance(state) if motion in _TRAVEL else None
    actors = roles.people if clause.verb in _CAUSING and roles.people else roles.subjects
    if len(actors) > 2:
        actors = [person for person in actors if person.id != target]  # everybody turns to Edna
    deeds = [
        Deed(person.id, motion, target if target != person.id else None, prop, clause.at, clause.verb, distance)
        for person in actors
    ]
    deeds = _with_mutual_targets(state, roles, deeds, motion)
    mood = mood_of(joined(state.sentence.words))
    for deed in deeds:
        deed.mood = mood
    deeds += _companions(roles, clause, motion)
    state.unit.deeds += [deed for deed in deeds if not _repeats(state, deed)]
    _note_pairs(state, roles, motion)
    return deeds


@rule("deeds.companions", without=[])
def _companions(roles: Roles, clause: Clause, motion: str) -> list[Deed]:
    """Return the deeds of people who are led or go along: ``ran down with her brother``."""
    along = roles.people_after("with") if motion in _TRAVEL and clause.verb != "leave" else []
    carried = any(one.preposition == "with" and two.preposition in _BORNE for one, two in pairwise(roles.places))
    along = [] if carried else along
    along += roles.people if clause.verb in _LEADING and motion == "walk" else []
    along += roles.people if clause.verb == "chase" and clause.places else []
    deeds = [
        Deed(person.id, motion, at=clause.at, verb=clause.verb) for person in along if person not in roles.subjects
    ]
    raised = clause.verb in _RAISING and any(p.preposition == "to" and _is_feet(p) for p in roles.places)
    return deeds + [Deed(p.id, "stand_up", at=clause.at, verb=clause.verb) for p in roles.people if raised]


def _is_feet(place: Place) -> bool:
    """Whether a place is a person's feet."""
    return any(noun.head in ("foot", "feet") for noun in place.nouns)


def _repeats(state: ReaderState, deed: Deed) -> bool:
    """Whether the unit has the same deed already."""
    return any((d.actor, d.motion, d.at) == (deed.actor, deed.motion, deed.at) for d in state.unit.deeds)


def _only_a_pose(state: ReaderState, clause: Clause, roles: Roles, motion: str) -> bool:
    """Whether a motion adds nothing to a pose: touching oneself; ``reads it, standing``."""
    own = bool(clause.object) and bool(roles.subjects) and clause.object[0].owner == roles.subjects[0].id
    own = own and state.inventory.class_of(next(iter(roles.things), None)) != "worn"
    own = own and not any(
        place.people or (place.things and place.preposition in _UPON) or any(n.owner for n in place.nouns)
        for place in roles.places
    )
    return own if motion == "touch" else clause.participle and not clause.places


@rule("deeds.target", without=(None, None))
def find_target(state: ReaderState, clause: Clause, roles: Roles, motion: str) -> tuple[str | None, str | None]:
    """Return whom or what a motion is for, and the thing used: ``gives Ben the folder`` -> Ben, folder.

    Args:
        state: The reader's state.
        clause: The clause.
        roles: The people and things of the clause.
        motion: Motion of its subject.

    Returns:
        The ids of target and prop, each None if there is none.
    """
    thing = next((thing for thing in roles.things if state.inventory.head(thing) not in _QUALITIES), None)
    if motion == "give":
        return _receiver(state, roles), thing or (roles.recipient_things[0] if roles.recipient_things else None)
    aimed_at = roles.recipients + roles.people_after("to", "at", "after")
    if motion == "throw" and thing and aimed_at:
        return aimed_at[0].id, thing
    if clause.verb == "give" and roles.recipients + roles.recipient_things:
        return next((person.id for person in roles.recipients), None) or roles.recipient_things[0], None
    owner = _owner_of_part(state, clause, roles)
    if owner:
        return owner, None
    people = roles.people + roles.recipients
    target = people[0].id if people else thing
    prop = thing
    if motion in ("eat", "drink", "read") and not thing:
        prop = target = _last_held(state, roles.subjects[0])
    whole = [part for place in roles.places if place.preposition == "of" for part in place.things]
    if whole and (state.inventory.head(thing) in _PORTIONS or (motion == "drop" and not thing)):
        prop = target = whole[0]
    if state.inventory.class_of(target) == "body" and not people:
        target = prop = None
    if not target or (motion in _GOING and not (people and motion in _FOLLOWING)):
        target = _destination(state, roles, motion, target)
    if motion == "sit" and state.inventory.head(target) not in _SEATS:
        target = _seat_walked_to(state, roles.subjects[0]) or target
    if motion == "take" and not target:
        prop = target = next((t for place in roles.places if place.preposition == "with" for t in place.things), None)
    if motion == "touch":
        owned = next((noun.owner for place in roles.places for noun in place.nouns if noun.owner), None)
        target = owned if state.inventory.class_of(target) == "body" else target
        prop = None
    return target, prop


@rule("deeds.other_end")
def _both_ends(
    state: ReaderState, roles: Roles, motion: str, target: str | None, prop: str | None
) -> tuple[str, str] | None:
    """Return target and prop: where a thing is put, where it is taken from, and the tool of a work.

    ``sets the pistol in the drawer``: the drawer is the target, the pistol in the hand; ``wipes the bulb with a
    duster``: the bulb, and the duster. None where no other end is stated.
    """
    thing = prop or (target if target and not state.person(target) else None)
    if thing is None or (target and target != thing):
        return None
    ends = _ENDS.get(motion, frozenset())
    for place in roles.places:
        others = [other for other in (*(p.id for p in place.people), *place.things) if other != thing]
        solid = [each for each in others if state.inventory.class_of(each) in _ENDING or state.person(each)]
        own = any(noun.owner in {person.id for person in roles.subjects} for noun in place.nouns)
        if place.preposition in ends and solid and not own:
            return solid[0], thing
        if place.preposition == "with" and motion in _WORKED and place.things and not place.people:
            return thing, place.things[0]
    return None


def _owner_of_part(state: ReaderState, clause: Clause, roles: Roles) -> str | None:
    """Return whose body something is done to: ``grabs her arm``, ``strokes the back of his hand``."""
    if roles.people or not roles.things or state.inventory.class_of(roles.things[0]) not in ("body", "abstract"):
        return None
    nouns = clause.object + [noun for place in roles.places if place.preposition == "of" for noun in place.nouns]
    owners = [noun.owner for noun in nouns if noun.owner and noun.owner not in [p.id for p in roles.subjects]]
    return owners[0] if owners else None


def _receiver(state: ReaderState, roles: Roles) -> str | None:
    """Return who receives something: the one named, or the only other person on stage."""
    receivers = roles.recipients + roles.people_after("to")
    if receivers:
        return receivers[0].id
    others = [p for p in state.on_stage() if p not in roles.subjects and p.kind == "human"]
    return others[0].id if len(others) == 1 else None


def _last_held(state: ReaderState, person: Person) -> str | None:
    """Return the prop in a person's hand, for ``He drinks.``; None if there is none."""
    held = state.scene.held.get(person.id, ())
    return next((thing for thing in reversed(held) if state.inventory.class_of(thing) == "prop"), None)


def _destination(state: ReaderState, roles: Roles, motion: str, target: str | None) -> str | None:
    """Return the person or thing after a preposition of direction, or None."""
    for place in sorted(roles.places, key=lambda place: place.preposition != "at"):
        if place.preposition == "of" or (motion == "look" and place.preposition in ("in", "from")):
            continue
        directed = place.preposition in _TOWARDS or " " in place.preposition or motion in ("climb", "kneel")
        through = place.preposition == "through" and motion in _THROUGH
        through |= place.preposition in ("behind", "after") and motion in _GOING | {
            "hide",
            "stand",
            "kneel",
            "crouch",
            "stagger",
        }
        if place.preposition == "from" and motion not in ("take", "drink", "eat"):
            continue
        if directed or through:
            found = _place_target(state, place, motion)
            if found and not (motion == "throw" and target):
                return found
    return target


def _place_target(state: ReaderState, place: Place, motion: str) -> str | None:
    """Return the target that a place names for this motion, or None."""
    owner = next((n.owner for n in place.nouns if n.kind == "thing" and n.head in lexicon.BODY and n.owner), None)
    if owner:
        return owner
    if place.people:
        return place.people[0].id
    solid = sorted(place.things, key=lambda thing: state.inventory.class_of(thing) == "scenery")
    for thing in solid:
        noun_class = state.inventory.class_of(thing)
        weather = state.inventory.head(thing) in lexicon.WEATHER_NOUNS
        if noun_class != "abstract" and not weather and (noun_class != "scenery" or motion in _TO_PLACES):
            return thing
    return None


def _seat_walked_to(state: ReaderState, person: Person) -> str | None:
    """Return the seat that the sentence walks to: ``Walks over to the booth and sits down``."""
    units = state.reading.units[-2:]
    walked = [d for unit in units for d in unit.deeds if d.actor == person.id and d.motion in ("walk", "run", "pull")]
    return next((d.target for d in reversed(walked) if state.inventory.head(d.target) in lexicon.SEATS), None)


def _with_mutual_targets(state: ReaderState, roles: Roles, deeds: list[Deed], motion: str) -> list[Deed]:
    """Make people each other's targets: ``They hug``, ``They look at each other``."""
    if len(deeds) != 2:
        return deeds
    together = motion in _MUTUAL and not roles.people + roles.recipients
    if together or _EACH_OTHER.search(joined(state.sentence.words)):
        first, second = deeds
        first.target, second.target = second.actor, first.actor
    return deeds


def _note_pairs(state: ReaderState, roles: Roles, motion: str) -> None:
    """Note two people as a group after one walks to or hugs the other: ``they`` may follow."""
    others = roles.people + roles.recipients + roles.people_after("to", "toward")
    pair = {person.id: person for person in roles.subjects + others}
    if len(roles.subjects) == 1 and motion in _PAIRING and len(pair) == 2:
        discourse = state.discourse
        discourse.groups.append((discourse.sentence, list(pair.values()), discourse.clock))


def _distance(state: ReaderState) -> float | None:
    """Return the metres that the sentence tells: ``ten metres``, ``three steps``; None if it tells none."""
    found = _DISTANCE.search(joined(state.sentence.words))
    if found is None:
        return None
    count = found.group(1)
    number = float(count) if count.isdigit() else float(lexicon.NUMBERS.get(count, 3))
    return round(number * _METRES[found.group(2)], 2)
