"""What lasts after a sentence: postures, what supports people, what they hold."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import zip_longest

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.language.clauses import Clause
from storyblender.agents.director.reader.language.words import joined
from storyblender.agents.director.reader.people.roles import Roles
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Deed, Person
from storyblender.agents.director.rules import rule
from storyblender.catalog.inflection import singular
from storyblender.memory.vocabulary import Posture

_POSTURE_OF_MOTION: dict[str, Posture] = {
    "sit": "sit", "lie_down": "lie", "kneel": "kneel", "crouch": "crouch", "sleep": "asleep", "crawl": "crawl",
    "fall": "lie", "wake": "lie", "lean": "lean",
}  # fmt: skip
_UPRIGHT = lexicon.words("upright")
_TAKING = frozenset({"pick_up", "take", "hold", "carry", "catch"})
_TRAVEL = frozenset({"walk", "run", "climb", "sneak", "stagger", "crawl", "ride"})
_POSES = frozenset({"stand", "sit", "lean", "kneel", "crouch", "lie_down"})
_LOSING = frozenset({"put_down", "drop", "throw"})
_NOT_HELD = frozenset({"abstract", "body", "set_piece", "scenery"})
_NEAR = frozenset({"beside", "by", "near", "next to", "before", "in front of", "behind"})
"""``sits beside the bed``: not on it."""
_SUPPORTED = frozenset({"sit", "lie_down", "sleep", "lean", "kneel"})
_FILLED = lexicon.words("filled")
"""What these are done with is not in the doer's hand."""
_NOT_WITH = frozenset({"look", "think", "read", "listen"})
_WHERE = frozenset(
    {"on", "over", "under", "around", "round", "across", "before", "in front of", "at", "behind", "beside", "by"}
)
"""``with a hat on her head``: where what comes with a person is, if not in the hand."""
_HANDS = frozenset({"hand", "arm", "fist", "paw", "finger", "shoulder", "back"})
_SLIPPING = frozenset({"slip", "fall", "drop", "slide", "tumble"})
_OUT_OF = frozenset({"out of", "from", "through"})
_GRASP = frozenset({"hand", "finger", "grip", "grasp"})
_AROUND = frozenset({"around", "round", "about"})
_REACH = 6
"""Words from hands to what they are around."""
_LEANT_ON = frozenset({"against", "on", "over"})
_WORN_ON = frozenset({"shoulder", "back", "lap"})
"""``stands there with a pack on his back``: not in the hand."""
_LONG = frozenset({"ladder", "stretcher", "plank"})
"""Furniture that people carry past."""
_WHOSE = r"(?:(?:his|her|their|its|each|one|the other|both|either) )?"
_GRIPPED = (
    r"(?:gripped|clutched|clasped|clamped|held|clenched|tucked|cradled|hugged|slung)(?: tight| tightly)?"
    r" (?:in|under|between|against|to|across|over)"
)
_READY = re.compile(
    rf"\b([a-z-]+) (drawn|raised|ready|at the ready|in {_WHOSE}hands?"
    rf"|{_GRIPPED} {_WHOSE}(?:arms?|hands?|fists?|teeth|elbow|fingers|chest|back|shoulders?)"
    rf"|under {_WHOSE}arms?|between {_WHOSE}teeth|in {_WHOSE}(?:arms|fist|teeth))(?! of)\b"
)
_HAVING = re.compile(r"\b(?:has|had|have)(?: [a-z]+){0,3} $")
"""``He has a mug in one hand``: no deed."""


@rule("postures.after_deed")
def apply_outcomes(state: ReaderState, deeds: Sequence[Deed], clause: Clause, roles: Roles) -> None:
    """Update postures, things in hand and vehicles by the deeds of a clause.

    Args:
        state: The reader's state; changed in place.
        deeds: Deeds of the clause.
        clause: The clause.
        roles: The people and things of the clause.
    """
    for deed in deeds:
        posture = _POSTURE_OF_MOTION.get(deed.motion)
        if posture and _posture_lasts(state, deed, roles):
            state.scene.posture[deed.actor] = (posture, _support(state, deed, roles))
        elif deed.motion in _UPRIGHT:
            state.scene.posture[deed.actor] = ("stand", None)
        _enter_vehicle(state, deed, clause, roles)
        _update_held(state, deed)
    _hold_brought_things(state, deeds, clause, roles)


def _hold_brought_things(state: ReaderState, deeds: Sequence[Deed], clause: Clause, roles: Roles) -> None:
    """Put things named with a person in hand: ``stands in the doorway with an umbrella``."""
    told = {deed.motion for deed in deeds}
    in_hand = any(state.inventory.class_of(thing) == "prop" for thing in roles.things)
    if clause.passive or clause.verb in _FILLED or told & _NOT_WITH or in_hand or not deeds:
        return
    for place, after in zip_longest(roles.places, roles.places[1:]):
        heads = {noun.head for noun in after.nouns} if after else set[str]()
        elsewhere = after is not None and after.preposition in _WHERE and not heads & _HANDS
        if place.preposition == "with" and not place.people and not elsewhere:
            for thing in place.things:
                if state.inventory.class_of(thing) == "prop" or state.inventory.head(thing) in _LONG:
                    hold(state, deeds[0].actor, thing)
                    worn = after is not None and bool(heads & _WORN_ON)
                    hangs = worn and after is not None and after.preposition == "over"  # a satchel over her shoulder
                    if (told & _TRAVEL and not hangs) or (told & _POSES and not worn):
                        _carry_or_hold(state, deeds[0].actor, thing, clause.at)


def _carry_or_hold(state: ReaderState, person: str, thing: str, at: int, between_teeth: bool = False) -> None:
    """Make a person who goes carry a thing, and a person who stays hold it."""
    own = [deed for deed in state.unit.deeds if deed.actor == person]
    if not any(deed.motion in ("hold", "carry") and deed.prop == thing for deed in own):
        motion = "carry" if not between_teeth and any(deed.motion in _TRAVEL for deed in own) else "hold"
        state.unit.deeds.append(Deed(person, motion, thing, thing, at, "hold"))


def _posture_lasts(state: ReaderState, deed: Deed, roles: Roles) -> bool:
    """Whether a posture lasts: not where a person leans forward for a moment."""
    if deed.motion == "wake":
        return state.scene.posture.get(deed.actor, ("", None))[0] == "asleep"
    return deed.motion != "lean" or _support(state, deed, roles) is not None or bool(roles.prepositions & _LEANT_ON)


@rule("deeds.slips_away")
def drop_slipped_things(state: ReaderState, clause: Clause, roles: Roles) -> None:
    """Note things that slip from a hand: ``The tray slips out of his hands``.

    Args:
        state: The reader's state; changed in place.
        clause: The clause.
        roles: The people and things of the clause.
    """
    if roles.subjects or not roles.subject_things or clause.verb not in _SLIPPING:
        return
    grips = [n for p in roles.places if p.preposition in _OUT_OF for n in p.nouns if n.head in _GRASP and n.owner]
    for noun in grips[:1]:
        _release(state, roles.subject_things[0])
        thing = roles.subject_things[0]
        state.inventory.note(thing, "handled")
        state.unit.deeds.append(Deed(noun.owner or "", "drop", thing, thing, clause.at, "drop"))


def _support(state: ReaderState, deed: Deed, roles: Roles) -> str | None:
    """Return the id of what a person sits, lies or leans on, or None."""
    if deed.motion not in _SUPPORTED:
        return None
    for place in roles.places:
        kind = lexicon.relation_of(place.preposition)
        for thing in place.things:
            if kind in ("on", "in", "against") and state.inventory.class_of(thing) in ("set_piece", "prop"):
                return thing
    near = any(deed.target in place.things and place.preposition in _NEAR for place in roles.places)
    if state.inventory.head(deed.target) in lexicon.SEATS and not near:
        return deed.target
    known = state.scene.posture.get(deed.actor)
    return known[1] if known and known[0] in ("sit", "lie", "asleep") and deed.motion in ("sit", "sleep") else None


def _enter_vehicle(state: ReaderState, deed: Deed, clause: Clause, roles: Roles) -> None:
    """Seat a person who gets into a vehicle, and stand up one who gets out."""
    if clause.verb not in ("get", "climb", "step", "slide", "jump") or deed.motion not in ("walk", "climb", "jump"):
        return
    prepositions = roles.prepositions | {clause.particle}
    if state.inventory.head(deed.target) in lexicon.VEHICLES and prepositions & {"in", "into", "inside"}:
        state.scene.posture[deed.actor] = ("sit", deed.target)
    elif prepositions & {"out", "out of"}:
        state.scene.posture[deed.actor] = ("stand", None)


def _update_held(state: ReaderState, deed: Deed) -> None:
    """Update what a person holds by a deed: taken, given, put down."""
    thing, held = deed.prop, state.scene.held
    if not thing or state.inventory.class_of(thing) in _NOT_HELD:
        return
    if deed.motion in _TAKING:
        hold(state, deed.actor, thing)
    elif deed.motion in _LOSING and thing in held.get(deed.actor, ()):
        held[deed.actor].remove(thing)
    elif deed.motion == "give":
        _release(state, thing)
        if deed.target and state.person(deed.target):
            hold(state, deed.target, thing)


def hold(state: ReaderState, person: str, thing: str) -> None:
    """Put a thing into a person's hand and out of everybody else's.

    Args:
        state: The reader's state; changed in place.
        person: Id of the person.
        thing: Id of the thing.
    """
    if thing not in state.scene.held.get(person, ()):
        _release(state, thing)
        state.scene.held.setdefault(person, []).append(thing)


def _release(state: ReaderState, thing: str) -> None:
    """Take a thing out of every hand."""
    for things in state.scene.held.values():
        if thing in things:
            things.remove(thing)


def _hold_gripped_things(state: ReaderState, people: Sequence[Person]) -> None:
    """Put things in hand that are gripped without a deed: ``both hands around a tin mug``."""
    words = state.sentence.words
    for index, thing in state.sentence.things:
        before = [word.low for word in words[max(0, index - _REACH) : index]]
        at = next(
            (i for i in range(1, len(before)) if before[i] in _AROUND and before[i - 1] in ("hands", "fingers")), 0
        )
        if at and people and "," not in before[at:] and state.inventory.class_of(thing) == "prop":
            state.inventory.note(thing, "handled")
            hold(state, people[0].id, thing)


@rule("things.in_hand")
def hold_drawn_things(state: ReaderState, people: Sequence[Person]) -> None:
    """Put things in hand that the subject has ready: ``Gun drawn``, ``notebook in hand``.

    Args:
        state: The reader's state; changed in place.
        people: Subjects of the sentence.
    """
    _hold_gripped_things(state, people)
    text = joined(state.sentence.words)
    for match in _READY.finditer(text):
        noun = singular(match.group(1))
        if noun not in lexicon.PROPS or not people:
            continue
        at = next((word.start for word in state.sentence.words if word.low == match.group(1)), state.unit.start)
        thing = state.inventory.id_of(noun, at)
        state.inventory.note(thing, "handled")
        hold(state, people[0].id, thing)
        has = _HAVING.search(text[: match.start()]) is not None
        if " " in match.group(2) and "ready" not in match.group(2) and not has:
            _carry_or_hold(state, people[0].id, thing, at, between_teeth="teeth" in match.group(2))
