"""What the Director understood: people, things, and the script unit by unit, before it is cut into shots.

The reader (cast, sentences, clauses, staging) fills it in one pass in reading order; the breakdown only reads it.
All offsets are characters of ``Screenplay.text``. Ids are asset ids.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from pydantic import ConfigDict

from storyblender.memory.scene_context import Relation, Spot
from storyblender.memory.shot_context import Flag, Tether
from storyblender.memory.vocabulary import Age, Gender, Grip, Moment, Mood, Posture, SceneType, TimeOfDay, Weather
from storyblender.screenplay.model import Screenplay


class Facts:
    """Base of what a reading file holds: a field that does not exist is refused, so a typo never passes silently."""

    __pydantic_config__ = ConfigDict(extra="forbid")


@dataclass
class Person(Facts):
    """A character (or animal) of the story, from every name the script uses for them."""

    id: str
    name: str
    aliases: tuple[str, ...] = ()
    kind: Literal["human", "animal", "group"] = "human"
    gender: Gender = "unknown"
    age: str = ""
    """As written: ``35``, ``late 30s``, ``child``, ``old``."""
    build: tuple[str, ...] = ()
    hair: tuple[str, ...] = ()
    outfit: tuple[str, ...] = ()
    face: tuple[str, ...] = ()
    role: str = ""
    """What they are where the script says so: ``waiter``, ``officer``, ``grandmother``."""
    variant_of: str | None = None
    """Same person at another age or in another costume (reference_character)."""
    speaks: bool = False
    count: int = 1
    """Members of a group."""
    first: int = 0
    """Offset of the first mention."""


@dataclass
class Thing(Facts):
    """A prop or a set piece that matters to the story."""

    id: str
    name: str
    """Head noun with its modifiers as written, e.g. ``birthday card``."""
    kind: Literal["prop", "set_piece", "vehicle", "animal"] = "prop"
    description: str = ""
    handled: bool = False
    first: int = 0
    writing: str = ""
    """Text that can be read on it: a sign, a letter, a screen."""
    part_of: str | None = None
    """Id of the thing it is a part of: the box of a lid."""


@dataclass
class Deed(Facts):
    """One action of one person."""

    actor: str
    motion: str
    """Key of the motion vocabulary (notes of the director, 4.1)."""
    target: str | None = None
    """Person, thing or set piece acted on or moved to."""
    prop: str | None = None
    at: int = 0
    verb: str = ""
    distance: float | None = None
    """Metres, where the script says so."""
    mood: Mood = "neutral"


@dataclass
class CameraNote(Facts):
    """A camera direction written in the script."""

    phrase: str = ""
    size: str = ""
    kind: str = ""
    angle: str = ""
    movement: str = ""
    direction: str = ""
    subject: str = ""
    """The words after ON, TO, OF: what it shows."""
    who: str = ""
    """POV and OTS: whose."""
    roll: float = 0.0
    focus: str = ""
    """``shallow``, ``deep``, ``soft`` or ``rack``."""
    rack: str = ""
    """Rack focus: the words for where it goes, ``Ben`` or ``Ana to Ben``."""
    through: str = ""
    """POV: the device it looks through: ``binoculars``, ``keyhole``."""


@dataclass
class StateChange(Facts):
    """A door, a lamp, a prop or the light changes."""

    subject: str
    """Thing id, or ``light``."""
    state: str
    """``open``, ``closed``, ``on``, ``off``, ``lit``, ``broken``, ``tipped``, ``spilled``, ``burning``, ``running``,
    ``full``, ``empty``, ``wet``, ``torn``, ``dirty``, ``bloody``, ``gone``, ``there``, ``reads WORDS``; for ``light`` a
    description."""
    at: int = 0


@dataclass
class Unit(Facts):
    """A sentence of action or one speech: the smallest piece of script that a shot can cover.

    On-screen text (``title``), a labelled sound or music (``sound``) and remarks of the writer to the reader
    (``aside``) get no shot of their own: they go with the shot before or after them.
    """

    kind: Literal["action", "dialogue", "title", "sound", "aside"]
    scene: int
    """Index into ``Reading.scenes``."""
    element: int
    """Index into ``Screenplay.elements``; units of one paragraph share it."""
    start: int
    end: int
    text: str
    deeds: list[Deed] = field(default_factory=list)
    on_stage: list[str] = field(default_factory=list)
    """People on stage when the unit ends (before its exits take effect), in order of entrance."""
    entering: list[str] = field(default_factory=list)
    leaving: list[str] = field(default_factory=list)
    people: list[str] = field(default_factory=list)
    """People mentioned."""
    things: list[str] = field(default_factory=list)
    """Things mentioned."""
    posture: dict[str, tuple[Posture, str | None]] = field(default_factory=dict)
    """Person -> posture and what supports them, after the unit."""
    held: dict[str, list[str]] = field(default_factory=dict)
    """Person -> things in hand, after the unit."""
    camera: CameraNote | None = None
    changes: list[StateChange] = field(default_factory=list)
    sounds: list[str] = field(default_factory=list)
    expressions: dict[str, str] = field(default_factory=dict)
    """Person -> facial expression after the unit: one of the sixteen expressions, or the script's own words."""
    gaze: dict[str, str] = field(default_factory=dict)
    """Person -> id of what they look at, or ``left``, ``right``, ``up``, ``down``, ``camera``, ``closed``."""
    grips: dict[str, dict[str, Grip]] = field(default_factory=dict)
    """Person -> thing -> grip on it, until they no longer hold it."""
    activities: dict[str, str] = field(default_factory=dict)
    """Person -> lasting motion, until it changes; an empty string ends it."""
    spots: dict[str, Spot] = field(default_factory=dict)
    """Person or thing -> spot after the unit, until they move."""
    absent: list[str] = field(default_factory=list)
    """Things of the scene that are not in the set during this unit: not there yet, or removed."""
    tethers: list[Tether] = field(default_factory=list)
    """Who is led or tied, and by whom or to what, during this unit."""
    moment: Moment | None = None
    """The moment of the unit that a panel shows; None lets the crew choose."""
    picture: int | None = None
    """Panel, item of a series of shots or row of two columns, or a picture that a person numbered: units with the same
    number share one shot, units with another never do; None lets the crew choose."""
    speaker: str | None = None
    speaker_name: str = ""
    to: str | None = None
    """Whom a speech is addressed to."""
    parenthetical: str = ""
    off_screen: bool = False
    """V.O., O.S., O.C. or not on stage."""
    dual: bool = False


@dataclass
class SceneReading(Facts):
    """One scene of the script."""

    id: int
    heading: str
    place: str
    place_kind: str = ""
    """Key of the place lexicon, or empty."""
    scene_type: SceneType = "indoor"
    time: TimeOfDay = "day"
    time_written: str = ""
    weather: Weather = "clear"
    reference: int | None = None
    """Id of the earlier scene in the same place."""
    number: str = ""
    start: int = 0
    end: int = 0
    kit: str = ""
    """Key of the set kit, if it was chosen by name."""
    set_options: list[str] | None = None
    """Options of the named kit that are turned on; None if the words tell."""
    snow: bool | None = None
    """Whether snow lies on the ground; None if weather and place tell."""
    crowd: Literal["none", "busy", "full"] | None = None
    """How full of background people the place is; None if the words tell."""
    furniture: list[str] = field(default_factory=list)
    """Things of this scene that belong to the set, as mentioned."""


@dataclass
class Reading:
    """Everything the reader understood."""

    screenplay: Screenplay
    people: list[Person] = field(default_factory=list)
    things: list[Thing] = field(default_factory=list)
    scenes: list[SceneReading] = field(default_factory=list)
    units: list[Unit] = field(default_factory=list)
    relations: list[tuple[int, Relation]] = field(default_factory=list)
    """Scene index and relation, as of when it is stated."""
    pronouns: list[tuple[int, str, tuple[str, ...]]] = field(default_factory=list)
    """Offset, word, who: for scoring and for showing."""
    flags: list[Flag] = field(default_factory=list)
    age: Age | None = None
    """The age the story plays in; None where its words do not tell."""


def ids_in(unit: Unit) -> set[str]:
    """Return the ids that a unit names as things, targets, supports or anchors, or that people look at."""
    done_to = (each for deed in unit.deeds for each in (deed.target, deed.prop))
    anchors = (each for spot in unit.spots.values() for each in (spot.anchor_id, spot.facing))
    supports = (support for _, support in unit.posture.values())
    changed = (change.subject for change in unit.changes)
    named = (*unit.things, *unit.absent, *unit.spots, *unit.gaze.values(), *done_to, *anchors, *supports, *changed)
    return {each for each in named if each}
