"""Telephone calls: both callers hold a phone to the ear from picking up until hanging up, also in an intercut."""

from __future__ import annotations

import re

from storyblender.agents.director import lexicon
from storyblender.agents.director.reader.deeds.outcomes import hold
from storyblender.agents.director.reader.state import Stage
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
def note_calls(stage: Stage, people: list[Person]) -> None:
    """Begin and end the calls that a sentence of action tells of.

    Args:
        stage: The state after the deeds of the sentence.
        people: Who may be meant, the subjects of the sentence first.
    """
    text = " ".join(stage.unit.text.lower().split("\n"))
    if stage.sentence.pictured:
        return
    over = _OVER.search(text)
    begun = _ON.search(text) or _TAKEN.search(text) or (_RUNG.search(text) if _rang(stage) else None)
    told = sorted((match.start(), match is begun) for match in (over, begun) if match)
    for at, begins in told:
        person = _doer(stage, stage.unit.start + at, people)
        if person is None or person.kind != "human":
            continue
        if begins:
            take_call(stage, person)
            _pick_up(stage, person)
        elif person.id in stage.calls or stage.scene.activities.get(person.id) == ACTIVITY:
            hang_up(stage, person)


def take_call(stage: Stage, person: Person) -> None:
    """Put a phone to a person's ear: the one in their hand or in the sentence, else one of the story's age."""
    stage.calls[person.id] = _place(stage)
    stage.called_from.add(_place(stage))
    if stage.scene.activities.get(person.id) != ACTIVITY:
        stage.scene.activities[person.id] = stage.unit.activities[person.id] = ACTIVITY
    held = stage.scene.held.get(person.id, [])
    if any(stage.inventory.head(thing) in _AT_THE_EAR and _is_pocketed(stage, thing) for thing in held):
        return
    for thing in [thing for thing in held if stage.inventory.head(thing) in _AT_THE_EAR | _CORDED]:
        held.remove(thing)
    thing = _instrument(stage, person)
    stage.inventory.seen(thing, "handled", determined=True)
    stage.unit.things.append(thing)
    hold(stage, person.id, thing)


def _pick_up(stage: Stage, person: Person) -> None:
    """Read ``answers it`` after a ring as picking up the phone: ``crosses to the wall and answers it``."""
    phone = stage.scene.held[person.id][-1]
    for deed in stage.unit.deeds:
        if (deed.actor, deed.verb, deed.motion) == (person.id, "answer", "talk"):
            deed.motion, deed.target, deed.prop = ACTIVITY, phone, phone


def hang_up(stage: Stage, person: Person) -> None:
    """End a person's call: the phone leaves the ear, and a receiver goes back on its cradle."""
    stage.calls.pop(person.id, None)
    stage.scene.activities.pop(person.id, None)
    stage.unit.activities[person.id] = ""
    held = stage.scene.held.get(person.id, [])
    corded = [thing for thing in held if stage.inventory.head(thing) in _CORDED | {"receiver", "handset"}]
    for deed in stage.unit.deeds:
        if deed.actor == person.id and deed.motion in ("put_down", ACTIVITY):
            deed.motion, deed.prop = "put_down", corded[0] if corded else deed.prop
    stage.scene.held[person.id] = [thing for thing in held if thing not in corded]


def keep_calls(stage: Stage) -> None:
    """Carry calls on to the next unit: a caller keeps the phone at the ear until seen in another place."""
    stage.intercut = stage.intercut or (stage.unit.kind == "aside" and _INTERCUT.search(stage.unit.text) is not None)
    for id in [id for id in stage.calls if id in stage.scene.on]:
        person = stage.person(id)
        if person is None or stage.calls[id] != _place(stage):
            del stage.calls[id]
        elif stage.scene.activities.get(id) != ACTIVITY:
            take_call(stage, person)


def is_far_end(stage: Stage, person: Person, extension: str) -> bool | None:
    """Tell by the bracket of a cue whether a speaker is heard through a phone; None where it tells nothing of phones.

    ``INTO PHONE`` is somebody who is seen; so is ``ON PHONE`` of whoever is there.
    """
    if re.search(r"\bIN(?:TO)? (?:THE |HIS |HER )?(?:TELE|CELL)?(?:PHONE|CELL|RECEIVER)\b", extension, re.IGNORECASE):
        return False
    if re.search(r"\b(?:ON|OVER|VIA|THROUGH) (?:THE )?(?:SPEAKER|TELE|CELL)?-?(?:PHONE|CELL)|^PHONE$", extension, re.I):
        return person.id not in stage.scene.on
    return None


def joins(stage: Stage, speaker: Person) -> bool:
    """Whether a speaker in an intercut is the other end of a call."""
    elsewhere = any(id not in stage.scene.on for id in stage.calls)
    return stage.intercut and elsewhere and _place(stage) not in stage.called_from and speaker.kind == "human"


def _place(stage: Stage) -> int:
    """The place of the running scene, told by the first scene there."""
    return stage.place.reference or stage.place.id


def _rang(stage: Stage) -> bool:
    """Return whether a phone rang in the last sentences, or a call is under way."""
    lately = stage.reading.units[-_RINGING:]
    return any("phone" in sound for unit in lately if unit.scene == stage.unit.scene for sound in unit.sounds)


def _doer(stage: Stage, at: int, people: list[Person]) -> Person | None:
    """Return the person who acts at an offset: the actor of the last deed up to there, else the first candidate."""
    named = [word.mention for word in stage.sentence.words if word.mention and word.start <= at]
    if named and named[-1].people and len(named[-1].people) == 1:
        return named[-1].people[0]
    before = [deed.actor for deed in stage.unit.deeds if deed.at <= at]
    actor = stage.person(before[-1]) if before else None
    subjects = stage.sentence.subjects or stage.discourse.subjects or people
    return actor or (subjects[0] if subjects else None)


def _is_pocketed(stage: Stage, thing: str) -> bool:
    """Whether a phone is held to the ear as it is: not one of an age whose phones have a receiver."""
    return stage.inventory.head(thing) != "phone" or stage.age in (None, "today", "space")


def _instrument(stage: Stage, person: Person) -> str:
    """The phone that a call is taken on: the one of the sentence, the last of the scene that is free, or a new one."""
    corded = stage.age not in (None, "today", "space")
    named = [thing for _, thing in stage.sentence.things]
    for thing in (*named, *stage.discourse.recent_things):
        head = stage.inventory.head(thing)
        free = stage.inventory.class_of(thing) == "prop" and not _is_taken(stage, thing, person)
        if head in _AT_THE_EAR and _is_pocketed(stage, thing) and free:
            return thing
        if head in _CORDED:
            corded = True
            break
    things = [stage.inventory.id_of(word, stage.unit.start) for word in (_OLD if corded else _NEW)]
    return next((thing for thing in things if not _is_taken(stage, thing, person)), things[0])


def _is_taken(stage: Stage, thing: str, person: Person) -> bool:
    return any(thing in held for id, held in stage.scene.held.items() if id != person.id and id in stage.scene.on)
