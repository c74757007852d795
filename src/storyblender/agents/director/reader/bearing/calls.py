"""Telephone calls: both callers hold a phone to the ear from picking up until hanging up, also in an intercut."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.deeds.outcomes import hold
from storyblender.agents.director.reader.state import ReaderState
from storyblender.agents.director.reading import Person
from storyblender.agents.director.rules import rule

ACTIVITY = "phone"
_ON, _TAKEN, _RUNG, _OVER = (lexicon.BEARING[f"call_{key}"] for key in ("on", "taken", "rung", "over"))
_INTERCUT = re.compile(r"\bintercut", re.IGNORECASE)
_POCKETED = frozenset({"cellphone", "cell", "mobile", "smartphone", "flip-phone", "mobile-phone"})
_CORDED = frozenset({"telephone", "payphone", "pay-phone", "switchboard"})
_AT_THE_EAR = frozenset({"phone", "receiver", "handset", "headset", "earpiece"}) | _POCKETED
_OLD, _NEW = ("receiver", "handset"), ("phone", "cellphone")
"""What is at an ear, and at another in the same place."""
_RINGING = 8
"""Units back in which a phone rang that is now picked up."""


@rule("bearing.call")
def note_calls(state: ReaderState, people: list[Person]) -> None:
    """Begin and end the telephone calls that a sentence of action tells of.

    Args:
        state: The state after the deeds of the sentence.
        people: Who may be meant, the subjects of the sentence first.
    """
    text = " ".join(state.unit.text.lower().split("\n"))
    if state.sentence.pictured:
        return
    over = _OVER.search(text)
    begun = _ON.search(text) or _TAKEN.search(text) or (_RUNG.search(text) if _is_ringing(state) else None)
    told = sorted((match.start(), match is begun) for match in (over, begun) if match)
    for at, begins in told:
        person = _person_acting_at(state, state.unit.start + at, people)
        if person is None or person.kind != "human":
            continue
        if begins:
            take_call(state, person)
            _pick_up(state, person)
        elif person.id in state.calls or state.scene.activities.get(person.id) == ACTIVITY:
            hang_up(state, person)


def take_call(state: ReaderState, person: Person) -> None:
    """Put a phone to a person's ear: the one in their hand or in the sentence, else a new one of the story's age.

    Args:
        state: The reader's state; changed in place.
        person: The caller.
    """
    state.calls[person.id] = _place(state)
    state.called_from.add(_place(state))
    if state.scene.activities.get(person.id) != ACTIVITY:
        state.scene.activities[person.id] = state.unit.activities[person.id] = ACTIVITY
    held = state.scene.held.get(person.id, [])
    if any(state.inventory.head(thing) in _AT_THE_EAR and _is_pocketed(state, thing) for thing in held):
        return
    for thing in [thing for thing in held if state.inventory.head(thing) in _AT_THE_EAR | _CORDED]:
        held.remove(thing)
    thing = _phone_for(state, person)
    state.inventory.note(thing, "handled", determined=True)
    state.unit.things.append(thing)
    hold(state, person.id, thing)


def _pick_up(state: ReaderState, person: Person) -> None:
    """Pick up the phone that rang: ``crosses to the wall and answers it``."""
    phone = state.scene.held[person.id][-1]
    for deed in state.unit.deeds:
        if (deed.actor, deed.verb, deed.motion) == (person.id, "answer", "talk"):
            deed.motion, deed.target, deed.prop = ACTIVITY, phone, phone


def hang_up(state: ReaderState, person: Person) -> None:
    """End a person's call: the phone leaves the ear, and a receiver goes back on its cradle.

    Args:
        state: The reader's state; changed in place.
        person: The caller.
    """
    state.calls.pop(person.id, None)
    state.scene.activities.pop(person.id, None)
    state.unit.activities[person.id] = ""
    held = state.scene.held.get(person.id, [])
    corded = [thing for thing in held if state.inventory.head(thing) in _CORDED | {"receiver", "handset"}]
    for deed in state.unit.deeds:
        if deed.actor == person.id and deed.motion in ("put_down", ACTIVITY):
            deed.motion, deed.prop = "put_down", corded[0] if corded else deed.prop
    state.scene.held[person.id] = [thing for thing in held if thing not in corded]


def keep_calls(state: ReaderState) -> None:
    """Carry calls on to the next unit: a caller keeps the phone at the ear until seen in another place."""
    state.intercut = state.intercut or (state.unit.kind == "aside" and _INTERCUT.search(state.unit.text) is not None)
    for id in [id for id in state.calls if id in state.scene.on]:
        person = state.person(id)
        if person is None or state.calls[id] != _place(state):
            del state.calls[id]
        elif state.scene.activities.get(id) != ACTIVITY:
            take_call(state, person)


def is_far_end(state: ReaderState, person: Person, extension: str) -> bool | None:
    """Whether the bracket of a cue says that its speaker is heard through a phone; None where it says nothing.

    ``INTO PHONE`` is a person who is seen; so is ``ON PHONE`` of a person on stage.

    Args:
        state: The reader's state.
        person: The speaker.
        extension: The bracket after the name in the cue, without its marks.
    """
    if re.search(r"\bIN(?:TO)? (?:THE |HIS |HER )?(?:TELE|CELL)?(?:PHONE|CELL|RECEIVER)\b", extension, re.IGNORECASE):
        return False
    if re.search(r"\b(?:ON|OVER|VIA|THROUGH) (?:THE )?(?:SPEAKER|TELE|CELL)?-?(?:PHONE|CELL)|^PHONE$", extension, re.I):
        return person.id not in state.scene.on
    return None


def is_other_end(state: ReaderState, speaker: Person) -> bool:
    """Whether a speaker in an intercut is the other end of a call.

    Args:
        state: The reader's state.
        speaker: The speaker.
    """
    elsewhere = any(id not in state.scene.on for id in state.calls)
    return state.intercut and elsewhere and _place(state) not in state.called_from and speaker.kind == "human"


def _place(state: ReaderState) -> int:
    """Return the id of the current place: its first scene."""
    return state.place.reference or state.place.id


def _is_ringing(state: ReaderState) -> bool:
    """Whether a phone rang in the last units of the scene."""
    lately = state.reading.units[-_RINGING:]
    return any("phone" in sound for unit in lately if unit.scene == state.unit.scene for sound in unit.sounds)


def _person_acting_at(state: ReaderState, at: int, people: list[Person]) -> Person | None:
    """Return the person who acts at an offset: the actor of the last deed up to there, else the first candidate."""
    named = [word.mention for word in state.sentence.words if word.mention and word.start <= at]
    if named and named[-1].people and len(named[-1].people) == 1:
        return named[-1].people[0]
    before = [deed.actor for deed in state.unit.deeds if deed.at <= at]
    actor = state.person(before[-1]) if before else None
    subjects = state.sentence.subjects or state.discourse.subjects or people
    return actor or (subjects[0] if subjects else None)


def _is_pocketed(state: ReaderState, thing: str) -> bool:
    """Whether a phone is held to the ear whole, because it has no receiver."""
    return state.inventory.head(thing) != "phone" or state.age in (None, "today", "space")


def _phone_for(state: ReaderState, person: Person) -> str:
    """Return the phone that a call is taken on: of the sentence, the last free one of the scene, or a new one."""
    corded = state.age not in (None, "today", "space")
    named = [thing for _, thing in state.sentence.things]
    for thing in (*named, *state.discourse.recent_things):
        head = state.inventory.head(thing)
        free = state.inventory.class_of(thing) == "prop" and not _is_taken(state, thing, person)
        if head in _AT_THE_EAR and _is_pocketed(state, thing) and free:
            return thing
        if head in _CORDED:
            corded = True
            break
    things = [state.inventory.id_of(word, state.unit.start) for word in (_OLD if corded else _NEW)]
    return next((thing for thing in things if not _is_taken(state, thing, person)), things[0])


def _is_taken(state: ReaderState, thing: str, person: Person) -> bool:
    """Whether another person holds a phone to the ear."""
    return any(thing in held for id, held in state.scene.held.items() if id != person.id and id in state.scene.on)
