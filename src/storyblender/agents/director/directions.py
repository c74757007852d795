"""Turns camera directions of the script into shots; whatever they say is obeyed (notes, sections 2 and 3)."""

from __future__ import annotations

import re
from bisect import bisect_left
from dataclasses import replace
from typing import cast, get_args

from storyblender.agents.director.camera_phrases import parse_direction, parse_note
from storyblender.agents.director.draft import Beat, ShotDraft
from storyblender.agents.director.reading import CameraNote, Reading, Unit
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import Angle, BodyPart, CameraDirection, Movement, ShotKind

SIZE_OF_KIND: dict[str, ShotSize] = {
    "insert": "CU", "ots": "MS", "two_shot": "MS", "group": "MWS", "pov": "MS", "reverse": "MCU",
}  # fmt: skip
"""Size of a kind of picture that is asked for without a size."""
_PARTS: dict[BodyPart, str] = {
    "hand": r"hands?|fingers?|fingertips?|fists?|knuckles|palms?|thumbs?",
    "eyes": r"eyes?|eyelids?|tears?",
    "mouth": r"mouth|lips?|smile",
    "feet": r"feet|foot|shoes?|boots?|toes?|heels?",
}
"""Words that make a direction on a person an insert of a part of them."""


class NameFinder:
    """Finds people and things by the words of a direction."""

    def __init__(self, reading: Reading) -> None:
        self.people = {person.id for person in reading.people}
        self._whole: dict[str, list[str]] = {}
        self._ids: dict[str, list[str]] = {}
        self._starting: dict[str, list[str]] = {}
        self._order: dict[str, int] = {}
        for each in (*reading.people, *reading.things):
            self._whole.setdefault(each.id.lower(), []).append(each.id)
        for each in (*reading.people, *reading.things):
            self._whole.setdefault(each.name.lower(), []).append(each.id)
        for person in reading.people:
            self._name(person.id, person.name, *person.aliases, person.role)
        for thing in reading.things:
            self._name(thing.id, thing.name, *thing.name.split()[-1:])

    def _name(self, id_: str, *names: str) -> None:
        """Let an id be found by some names."""
        for name in {name.lower(): None for name in names if name}:
            if name not in self._ids:
                self._ids[name], self._order[name] = [], len(self._order)
                self._starting.setdefault(_first_word(name), []).append(name)
            self._ids[name].append(id_)

    def find(self, words: str) -> list[str]:
        """Return the ids named in ``words``, in order: by id or whole name, else by the longest names inside."""
        found = [
            id_
            for item in words.split(",")
            for id_ in self._exactly_named(item.strip().lower()) or self._named_inside(item)
        ]
        return list(dict.fromkeys(found))

    def _exactly_named(self, name: str) -> list[str]:
        """Return the ids with that id or whole name, else the first that the name may refer to."""
        return self._whole.get(name, self._ids.get(name, []))[:1]

    def _named_inside(self, words: str) -> list[str]:
        """Return the ids of the longest names inside ``words``, in order of place."""
        found: list[tuple[int, str]] = []
        rest = words
        words_in = {"", *re.findall(r"\w+", words.lower())}
        named = [name for word in words_in for name in self._starting.get(word, ())]
        for name in sorted(named, key=lambda name: (-len(name), self._order[name])):
            match = re.search(rf"(?<!\w){re.escape(name)}(?!\w)", rest, re.IGNORECASE)
            if match:
                rest = rest[: match.start()] + " " * len(match[0]) + rest[match.end() :]
                found += [(match.start(), id_) for id_ in self._whole.get(name, self._ids[name])]
        return [id_ for _, id_ in sorted(found)]


def camera_notes_by_unit(reading: Reading) -> dict[int, CameraNote]:
    """Return the camera direction of each unit by index: its own, or the ``SHOT`` note before it."""
    notes = {index: unit.camera for index, unit in enumerate(reading.units) if unit.camera}
    starts = [unit.start for unit in reading.units]
    headings = [element.start for element in reading.screenplay.elements if element.kind == "heading"]
    for element in reading.screenplay.elements:
        note = parse_note(element.text) if element.kind == "note" else None
        if note is None:
            continue
        after = bisect_left(starts, element.start)
        last = reading.units[after - 1] if after else None
        heading = headings[at - 1] if (at := bisect_left(headings, element.start)) else -1
        opens = last is None or heading > last.start  # under a heading that comes after the last unit
        same_scene = after < len(starts) and (opens or last is None or reading.units[after].scene == last.scene)
        target = after if same_scene else after - 1 if after else None
        if target is not None:
            notes.setdefault(target, note)
    return notes


def camera_words(note: CameraNote) -> str:
    """Return a camera direction with what it shows, for people and models: ``CLOSE ON: Rick's hand``."""
    return ": ".join(filter(None, (note.phrase, note.subject or note.who)))


def is_direction_only(words: str) -> bool:
    """Whether words are a camera direction and nothing else: ``CLOSE ON the ring.``"""
    note, (start, end) = parse_direction(words)
    return note is not None and not words[start:end].strip()


def _first_word(name: str) -> str:
    """Return the first word of a name, or an empty string."""
    word = re.search(r"\w+", name)
    return word[0] if word else ""


def directed_shot(
    unit: Unit, note: CameraNote, names: NameFinder, default_size: ShotSize, last: ShotDraft | None
) -> ShotDraft:
    """Return the shot that a direction orders for a unit.

    Args:
        unit: What it covers.
        note: The direction.
        names: To find its subject.
        default_size: Where the direction names no size.
        last: The shot before, for POV and reverse angles that name nobody.
    """
    if note.kind == "pov" and not note.through:
        note = replace(note, through=_optical_device(f"{note.phrase} {note.subject} {unit.text}"))
    named = names.find(note.subject)
    acting = [deed.actor for deed in unit.deeds] or ([unit.speaker] if unit.speaker in unit.on_stage else [])
    focus = (
        named or list(dict.fromkeys(each for each in acting if each)) or unit.people or unit.on_stage[:3] or unit.things
    )
    size = cast(ShotSize, note.size) if note.size else SIZE_OF_KIND.get(note.kind, default_size)
    shot = ShotDraft(
        kind=_shot_kind(note, focus, names, unit),
        size=size,
        focus=list(focus),
        beats=[Beat.whole(unit)],
        angle=cast(Angle, note.angle or "eye-level"),
        movement=cast(Movement, note.movement or "static"),
        direction=cast(CameraDirection, note.direction) if note.direction else None,
        note=note,
        rack=rack_of(unit, note, names, last),
        on_stage=list(unit.on_stage),
    )
    if shot.rack:
        shot.focus = list(dict.fromkeys((*shot.rack, *shot.focus)))
    who = next(iter(names.find(note.who)), None)
    if shot.kind == "pov":
        shot.pov = who or next((each for each in (last.focus if last else []) if each in names.people), None)
        shot.focus = [each for each in focus if each != shot.pov] or [e for e in unit.on_stage if e != shot.pov]
    if shot.kind not in ("pov", "ots") and shot.focus and shot.focus[0] in names.people:
        shot.detail = _body_part(note.subject)
    if shot.detail:
        shot.kind, shot.size, shot.focus = "insert", "ECU" if note.size == "ECU" else "CU", shot.focus[:1]
    if shot.kind == "ots":
        _over_shoulder(shot, who, unit, last)
    return shot


def rack_of(unit: Unit, note: CameraNote, names: NameFinder, last: ShotDraft | None) -> tuple[str, str] | None:
    """Return what a rack focus starts on and what it ends on; None where the direction orders none or names nothing.

    Args:
        unit: Under the direction.
        note: The direction.
        names: To find its subject: ``from Ana to Ben``, or ``to Ben``.
        last: The shot before; a rack focus that says only where it goes starts on its first subject.
    """
    named = names.find(note.rack) if note.focus == "rack" else []
    if len(named) == 1:
        own = names.find(note.subject) if note.subject != note.rack else []
        others = (*own, *(last.focus if last else ()), *unit.on_stage)
        named = [*[each for each in others if each != named[0]][:1], *named]
    return (named[0], named[1]) if len(named) > 1 else None


def racks_within(shot: ShotDraft, unit: Unit, note: CameraNote, names: NameFinder) -> bool:
    """Let a shot go over from one subject to another where a direction says so, and return whether it does.

    A rack focus is no cut: what the unit tells plays in the shot that runs, unless the direction gives it a size.

    Args:
        shot: The last one.
        unit: Under the direction.
        note: The direction.
        names: To find its subject.
    """
    rack = rack_of(unit, note, names, shot)
    if rack is None or note.size or shot.kind not in ("action", "single", "reaction", "two_shot", "group"):
        return False
    shot.rack = rack
    shot.add_focus(*rack)
    if shot.kind in ("single", "reaction"):
        shot.kind, shot.size = "action", shot.size if shot.has_note else "MS"
    phrases = (shot.note.phrase, note.phrase) if shot.note else (note.phrase,)
    shot.note = replace(shot.note or note, focus="rack", phrase=", ".join(filter(None, phrases)))
    shot.beats.append(Beat.whole(unit))
    shot.on_stage = list(dict.fromkeys((*shot.on_stage, *unit.on_stage)))
    return True


def _optical_device(words: str) -> str:
    """Return the device of a point of view as written: ``THROUGH THE BINOCULARS``."""
    match = re.search(r"\bthrough (?:the |an? |his |her |its |their )?([\w' -]{3,30})", words, re.IGNORECASE)
    return match[1].strip().lower() if match else ""


def _body_part(subject: str) -> BodyPart | None:
    """Return the body part that a direction ends on (``Rick's hand``), or None."""
    head = re.split(r"\b(?:of|on|as|in|with)\b", subject, maxsplit=1, flags=re.IGNORECASE)[0].strip()
    for part, words in _PARTS.items():
        if re.search(rf"\b(?:{words})$", head, re.IGNORECASE):
            return part
    return None


def _over_shoulder(shot: ShotDraft, who: str | None, unit: Unit, last: ShotDraft | None) -> None:
    """Set whose shoulder and whose face a shot shows; without two people on stage it is a single."""
    if shot.note and shot.note.kind == "reverse" and who is None and last and last.focus:
        who = last.focus[0]
    candidates = [unit.speaker, *shot.focus, unit.to, *unit.on_stage]
    shot.over = who or next((each for each in (unit.to, *unit.on_stage) if each and each not in shot.focus[:1]), None)
    face = next((each for each in (*shot.focus, *candidates) if each and each != shot.over), None)
    shot.focus = [face] if face else []
    if shot.over not in unit.on_stage or not face:
        shot.kind, shot.over = "single", None
        shot.focus = shot.focus or ([who] if who else [])


def _shot_kind(note: CameraNote, focus: list[str], names: NameFinder, unit: Unit) -> ShotKind:
    """Return the kind of shot that a direction orders."""
    if note.through:
        return "pov"
    if note.kind in get_args(ShotKind):
        return cast(ShotKind, note.kind)
    if note.kind == "reverse":
        return "ots" if len(unit.on_stage) > 1 else "single"
    people = [each for each in focus if each in names.people]
    if focus and not people:
        return "insert" if note.size in ("", "CU", "ECU", "MCU") else "action"
    if len(people) > 1:
        return "group" if len(people) > 2 else "two_shot" if unit.kind == "dialogue" else "action"
    return "single" if people and note.size in ("MCU", "CU", "ECU") else "action"
