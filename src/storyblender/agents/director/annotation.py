"""The answer of a language Director: one scene of the script, annotated unit by numbered unit."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Annotated, Any, Literal

from pydantic import Field

from storyblender.agents.asking import Notes
from storyblender.agents.director.reading import Deed, Person, SceneReading, StateChange, Thing, Unit
from storyblender.memory.base import Coordinate, Identifier
from storyblender.memory.scene_context import Relation, Spot
from storyblender.memory.vocabulary import (
    Expression,
    Gender,
    Grip,
    Moment,
    Mood,
    Posture,
    SceneType,
    TimeOfDay,
    Weather,
)

DIRECTORS_PICTURES = 1000
"""Pictures that the Director numbers begin here; lower numbers are panels of the page, or a person's."""
Name = Annotated[str, Field(max_length=200)]
"""A few words of the script."""


class PlaceNotes(Notes):
    """Where and when a scene plays."""

    kit: Identifier
    """Key of the set kit."""
    scene_type: SceneType
    time: TimeOfDay
    weather: Weather = "clear"
    same_place_as: int | None = None
    """Number of the earlier scene in the same place."""
    options: tuple[Identifier, ...] | None = None
    """Options of the kit that are turned on; left out, the words of the script tell."""
    snow: bool | None = None
    """Whether snow lies on the ground; left out, weather and place tell."""
    crowd: Literal["none", "busy", "full"] | None = None
    """How full of background people the place is; left out, the words of the script tell."""


class PlaceChange(PlaceNotes):
    """Another place, or another hour, in the middle of what the page has as one scene."""

    name: Name
    """What the script calls the place: ``the car park``."""
    relations: tuple[Relation, ...] = ()
    """Where things are as it is seen first, if the script says so."""


class PersonNotes(Notes):
    """A person, an animal that acts, or a crowd."""

    id: Identifier
    name: Name
    aliases: tuple[Name, ...] = ()
    """Every other name the script uses, in small letters."""
    kind: Literal["human", "animal", "group"] = "human"
    gender: Gender = "unknown"
    age: Name = ""
    """``35``, ``late 30s``, ``child``, ``old``."""
    build: tuple[Name, ...] = ()
    hair: tuple[Name, ...] = ()
    outfit: tuple[Name, ...] = ()
    """One piece of clothing each, with its colour."""
    face: tuple[Name, ...] = ()
    role: Name = ""
    """Trade or kin: ``waiter``, ``grandmother``."""
    variant_of: Identifier | None = None
    """Id of the same person at another age or in another costume."""
    count: int = Field(default=1, ge=1, le=40)
    """Members of a group."""


class ThingNotes(Notes):
    """A prop or a set piece that matters."""

    id: Identifier
    name: Name
    """The noun with its adjectives."""
    kind: Literal["prop", "set_piece", "vehicle", "animal"] = "prop"
    description: Annotated[str, Field(max_length=500)] = ""
    handled: bool = False
    writing: Annotated[str, Field(max_length=500)] = ""
    """Words that can be read on it."""
    part_of: Identifier | None = None


class DeedNotes(Notes):
    """One visible action."""

    actor: Identifier
    motion: Identifier
    """Key of a motion."""
    target: Identifier | None = None
    prop: Identifier | None = None
    distance: Coordinate | None = None
    """Metres, where the script says so."""
    mood: Mood = "neutral"


class HeldNotes(Notes):
    """A thing that a person carries."""

    id: Identifier
    """Of the thing."""
    grip: Grip | None = None
    """How it is carried; left out, the crew chooses."""


class StateNotes(Notes):
    """What is new about a person or a thing when a unit ends; a field that is left out stays as it was."""

    id: Identifier
    posture: Posture | None = None
    on: Identifier | None = None
    """What they sit, lie or lean on."""
    holds: tuple[HeldNotes, ...] | None = None
    """Everything they carry; empty for nothing."""
    looks_at: Identifier | None = None
    """Id of a person or thing, or ``left``, ``right``, ``up``, ``down``, ``camera``, ``closed``."""
    face: Expression | None = None
    activity: Identifier | Literal[""] | None = None
    """Key of a motion of `motions` that goes on while others act: `phone`, `paint`; the empty string ends it."""
    spot: Spot | None = None
    """Position; also of a thing."""


class ChangeNotes(Notes):
    """A door, a lamp, a thing or the light of the place (``light``) changes."""

    subject: Identifier
    state: Name


class UnitNotes(Notes):
    """A unit of the script, annotated."""

    number: int
    new_scene: PlaceChange | None = None
    """A scene that begins with this unit, though the page has no heading for it."""
    on_stage: tuple[Identifier, ...] = ()
    entering: tuple[Identifier, ...] = ()
    leaving: tuple[Identifier, ...] = ()
    things: tuple[Identifier, ...] = ()
    """Things that the unit is about."""
    deeds: tuple[DeedNotes, ...] = ()
    states: tuple[StateNotes, ...] = ()
    changes: tuple[ChangeNotes, ...] = ()
    absent: tuple[Identifier, ...] = ()
    speaker: Identifier | None = None
    to: Identifier | None = None
    off_screen: bool = False
    moment: Moment | None = None
    picture: int | None = None


class SceneNotes(Notes):
    """A scene of the script, annotated."""

    place: PlaceNotes
    people: tuple[PersonNotes, ...] = ()
    """Everybody in this scene; of people known before only what is new about them."""
    things: tuple[ThingNotes, ...] = ()
    relations: tuple[Relation, ...] = ()
    """Where things are as the scene opens, if the script says so."""
    units: tuple[UnitNotes, ...] = ()


def annotated_scene(scene: SceneReading, number: int, notes: PlaceNotes) -> SceneReading:
    """Return a scene of the page with the place, hour and weather of its notes.

    Args:
        scene: As the page has it.
        number: Of the scene among all that the Director sees.
        notes: What the Director said of its place.
    """
    return SceneReading(
        id=number, heading=scene.heading, place=scene.place, time_written=scene.time_written, number=scene.number,
        start=scene.start, end=scene.end, **_place_of(notes),
    )  # fmt: skip


def new_scene(number: int, notes: PlaceChange, start: int, end: int) -> SceneReading:
    """Return a scene that the Director begins where the page has no heading.

    Args:
        number: Of the scene.
        notes: Its place.
        start: Offset in the script where it begins.
        end: Offset where it ends.
    """
    return SceneReading(id=number, heading="", place=notes.name, start=start, end=end, **_place_of(notes))


def _place_of(notes: PlaceNotes) -> dict[str, Any]:
    """Return the fields of a scene that its place gives."""
    return {
        "scene_type": notes.scene_type, "time": notes.time, "weather": notes.weather, "kit": notes.kit,
        "reference": notes.same_place_as, "snow": notes.snow, "crowd": notes.crowd,
        "set_options": None if notes.options is None else [*notes.options],
    }  # fmt: skip


def annotated_unit(unit: Unit, notes: UnitNotes, scene: int, picture: int) -> Unit:
    """Return a unit of the page with its notes; camera directions and sounds stay as they are written.

    Args:
        unit: As the page has it.
        notes: What the Director said of it.
        scene: Index of its scene.
        picture: Added to the number of its picture, so that scenes do not share pictures.
    """
    states = notes.states
    return Unit(
        kind=unit.kind, scene=scene, element=unit.element, start=unit.start, end=unit.end, text=unit.text,
        deeds=[
            Deed(each.actor, each.motion, each.target, each.prop, unit.start, "", each.distance, each.mood)
            for each in notes.deeds
        ],
        on_stage=[*notes.on_stage], entering=[*notes.entering], leaving=[*notes.leaving],
        people=[*dict.fromkeys(each.actor for each in notes.deeds)], things=[*notes.things],
        posture={each.id: (each.posture, each.on) for each in states if each.posture is not None},
        held={each.id: [thing.id for thing in each.holds] for each in states if each.holds is not None},
        camera=unit.camera,
        changes=[StateChange(each.subject, each.state, unit.start) for each in notes.changes],
        sounds=unit.sounds,
        expressions={each.id: each.face for each in states if each.face is not None},
        gaze={each.id: each.looks_at for each in states if each.looks_at is not None},
        grips={
            each.id: {thing.id: thing.grip for thing in each.holds or () if thing.grip is not None}
            for each in states
            if any(thing.grip is not None for thing in each.holds or ())
        },
        activities={each.id: each.activity for each in states if each.activity is not None},
        spots={each.id: each.spot for each in states if each.spot is not None},
        absent=[*notes.absent], moment=notes.moment,
        picture=picture + notes.picture if notes.picture is not None else unit.picture,
        speaker=notes.speaker if unit.kind == "dialogue" else None, speaker_name=unit.speaker_name,
        to=notes.to, parenthetical=unit.parenthetical, off_screen=notes.off_screen, dual=unit.dual,
    )  # fmt: skip


def with_speakers(units: Sequence[Unit], people: Sequence[Person]) -> list[Unit]:
    """Return units whose speeches have the name of their speaker, where the page names nobody or another.

    Args:
        units: Of the whole reading, each with its ``speaker``.
        people: Of the reading.
    """
    called = {person.id: person for person in people}
    return [_with_speaker(unit, called.get(unit.speaker or "")) for unit in units]


def _with_speaker(unit: Unit, speaker: Person | None) -> Unit:
    """Return a unit with the name of a speaker; what the page calls them is kept."""
    if speaker is None:
        return unit
    names = " ".join((speaker.id, speaker.name, *speaker.aliases)).lower().replace("_", " ").split()
    written = re.findall(r"\w+", unit.speaker_name.lower())
    kept = written and all(word in names for word in written)
    return unit if kept else replace(unit, speaker_name=speaker.name)


def person_of(notes: PersonNotes, first: int) -> Person:
    """Return a person as a reading has them; ``first`` is the offset in the script where they first appear."""
    return Person(**notes.model_dump(), first=first)


def thing_of(notes: ThingNotes, first: int) -> Thing:
    """Return a thing as a reading has it; ``first`` is the offset in the script where it first appears."""
    return Thing(**notes.model_dump(), first=first)
