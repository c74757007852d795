"""A reading as a JSON file: what was understood of a script, unit by numbered unit, for a person to correct.

``storyblender plan SCRIPT --write-reading FILE`` writes it and ``storyblender make SCRIPT --reading FILE`` takes it
back, so that a misreading is corrected at its source and reading and staging can be judged apart. The fields are those
of ``reading.py``, documented in ``docs/reading-file.md``; a field that is left out has its default.
"""

from __future__ import annotations

import json
import re
from bisect import bisect_right
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, get_args

from pydantic import Field, TypeAdapter, ValidationError, model_validator

from storyblender.agents.director.fixtures import fixture_ids, is_piece
from storyblender.agents.director.reader.era import age_of
from storyblender.agents.director.reading import CameraNote, Person, Reading, SceneReading, Thing, Unit
from storyblender.agents.director.reading_passes import order_scenes_by_units
from storyblender.catalog.fixtures import named_pieces
from storyblender.catalog.motions import MOTION_KEYS, motion_called
from storyblender.catalog.sets import SETS, plan_of
from storyblender.errors import InputError
from storyblender.memory.base import Frozen, Identifier, content_hash
from storyblender.memory.scene_context import Environment, Relation
from storyblender.memory.shot_context import Flag
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import Age, Angle, CameraDirection, GazeDirection, Movement
from storyblender.screenplay.model import Screenplay

READING_VERSION = 2
"""2: the ``panel`` and the ``picture`` of a unit are one."""
_CAMERA_WORDS: dict[str, frozenset[str]] = {
    "size": frozenset(get_args(ShotSize)),
    "angle": frozenset(get_args(Angle)),
    "movement": frozenset(get_args(Movement)),
    "direction": frozenset(get_args(CameraDirection)),
    "focus": frozenset({"shallow", "deep", "soft", "rack"}),
}
"""Fields of a camera direction with a fixed set of values."""
_WORD = re.compile(r"\w+")


class WrittenScene(Frozen):
    """A scene of the file: the scene's own fields, and the relations stated in it."""

    scene: SceneReading
    relations: tuple[Relation, ...] = ()


class WrittenUnit(Frozen):
    """A unit of the file with its number, counted from 1 through the whole script."""

    number: int
    unit: Unit


class ReadingFile(Frozen):
    """The whole file."""

    reading_version: Annotated[int, Field(ge=1, le=READING_VERSION)]
    script: str
    """Digest of the words that were read."""
    people: tuple[Person, ...] = ()
    things: tuple[Thing, ...] = ()
    scenes: tuple[WrittenScene, ...] = ()
    units: tuple[WrittenUnit, ...] = ()
    flags: tuple[Flag, ...] = ()
    age: Age | None = None
    """When the story plays; where it is left out, the words of the script tell."""

    @model_validator(mode="before")
    @classmethod
    def _upgraded(cls, plain: dict[str, Any]) -> dict[str, Any]:
        """Return a file of an earlier version as this version writes it; what is no reading is left to be refused."""
        if not isinstance(plain, dict) or plain.get("reading_version") != 1:
            return plain
        units = [_one_picture(unit) for unit in plain.get("units", ())]
        return plain | {"reading_version": READING_VERSION, "units": units}


def _one_picture(written: Any) -> Any:
    """Return a unit of version 1 with its panel as its picture."""
    unit = written.get("unit") if isinstance(written, dict) else None
    if not isinstance(unit, dict) or unit.get("panel") is None:
        return written
    told = {key: value for key, value in unit.items() if key != "panel"}
    return written | {"unit": told | {"picture": unit["panel"]}}


def write_reading(reading: Reading) -> str:
    """Return a reading as the text of a JSON file; fields that have their default are left out.

    Args:
        reading: As the reader gave it, before it is cut into shots.
    """
    plain = _file_of(reading).model_dump(mode="json", exclude_defaults=True)
    return json.dumps(plain, indent=1, ensure_ascii=False) + "\n"


def _file_of(reading: Reading) -> ReadingFile:
    """Return a reading as a file holds it."""
    relations: dict[int, list[Relation]] = {}
    for scene, relation in reading.relations:
        relations.setdefault(scene, []).append(relation)
    return ReadingFile(
        reading_version=READING_VERSION,
        script=_digest(reading.screenplay),
        people=tuple(reading.people),
        things=tuple(reading.things),
        scenes=tuple(
            WrittenScene(scene=scene, relations=tuple(relations.get(index, ())))
            for index, scene in enumerate(reading.scenes)
        ),
        units=tuple(WrittenUnit(number=number, unit=unit) for number, unit in enumerate(reading.units, start=1)),
        flags=tuple(reading.flags),
        age=reading.age,
    )


def read_reading(path: Path, screenplay: Screenplay) -> Reading:
    """Read a corrected reading of a script.

    Args:
        path: The JSON file.
        screenplay: The script that it is a reading of.

    Raises:
        InputError: The file is no reading, or is one of other words; the sentence names the unit and the field.
    """
    file = _parsed(path)
    if not _is_of(file, screenplay):
        mend = "write a new one with `storyblender plan SCRIPT --write-reading FILE`"
        raise InputError("is a reading of another script, or of another version of it", mend=mend, path=path)
    _check_units(file, screenplay, path)
    _check_ids(file, path)
    return reading_with_fixtures(_reading_of(file, screenplay))


def reading_with_fixtures(reading: Reading) -> Reading:
    """Return a reading with the ids of the set's own doors and windows, and its scenes in the order of its units."""
    file = _file_of(reading)
    kits = {written.scene.kit for written in file.scenes} & SETS.keys()
    pieces = {name for kit in kits for names in named_pieces(plan_of(Environment(kit=kit))) for name in names}
    things = [thing for thing in file.things if thing.part_of is None]
    built = {thing.name.lower() for thing in things if is_piece(thing, pieces)}
    if ids := fixture_ids(((thing.id, thing.name) for thing in things), built):
        file = ReadingFile.model_validate(_with_ids(file.model_dump(mode="json", exclude_defaults=True), ids))
    return order_scenes_by_units(_reading_of(file, reading.screenplay))


def _reading_of(file: ReadingFile, screenplay: Screenplay) -> Reading:
    """Return the reading that a file holds."""
    return Reading(
        screenplay,
        people=list(file.people),
        things=list(file.things),
        scenes=[written.scene for written in file.scenes],
        units=[replace(written.unit, element=_element_at(written.unit.start, screenplay)) for written in file.units],
        relations=[(index, relation) for index, written in enumerate(file.scenes) for relation in written.relations],
        flags=list(file.flags),
        age=file.age or age_of(screenplay),
    )


def _with_ids(plain: object, ids: Mapping[str, str]) -> object:
    """Return JSON values with ids replaced wherever they stand alone, as values and as keys."""
    if isinstance(plain, dict):
        return {ids.get(key, key): _with_ids(value, ids) for key, value in plain.items()}
    if isinstance(plain, list | tuple):
        return [_with_ids(value, ids) for value in plain]
    return ids.get(plain, plain) if isinstance(plain, str) else plain


def is_reading_of(path: Path, screenplay: Screenplay) -> bool:
    """Whether the file at ``path`` is a reading of the text of ``screenplay``.

    Raises:
        InputError: The file cannot be read or is no reading.
    """
    return _is_of(_parsed(path), screenplay)


def _digest(screenplay: Screenplay) -> str:
    """Return the digest of a script's text."""
    return content_hash(screenplay.text)


def _is_of(file: ReadingFile, screenplay: Screenplay) -> bool:
    """Whether a file is a reading of this text; early versions included the format in the hash."""
    return file.script in (_digest(screenplay), content_hash(screenplay.text, screenplay.format))


def _element_at(start: int, screenplay: Screenplay) -> int:
    """Return the index of the element that contains a character; a later version may split the page differently."""
    return max(bisect_right(screenplay.elements, start, key=lambda element: element.start) - 1, 0)


def _parsed(path: Path) -> ReadingFile:
    """Return the file at a path, or raise an InputError that says what is wrong in it."""
    try:
        return ReadingFile.model_validate_json(path.read_bytes())
    except OSError as error:
        raise InputError(f"cannot be read ({error.strerror})", mend="check the name", path=path) from error
    except ValidationError as error:
        first = error.errors()[0]
        where = _where(first["loc"])
        raise InputError(
            f"{where}: {first['msg']}", mend="see docs/reading-file.md for the fields", path=path
        ) from error


def _where(location: tuple[int | str, ...]) -> str:
    """Name a place in the file as a person counts: ``unit 12, deeds 2, motion``."""
    words: list[str] = []
    for part in location:
        if isinstance(part, int) and words:
            words[-1] = f"{words[-1].removesuffix('s') if words[-1] in ('units', 'scenes') else words[-1]} {part + 1}"
        elif part not in ("unit", "scene"):
            words.append(str(part))
    return ", ".join(words) or "the file"


def _check_units(file: ReadingFile, screenplay: Screenplay, path: Path) -> None:
    """Every unit is words of the script, in its order, in a scene of the file."""
    end = 0
    for index, written in enumerate(file.units):
        unit, number = written.unit, index + 1
        fault = ""
        if written.number != number:
            fault = f"has the number {written.number}"
        elif not 0 <= unit.scene < len(file.scenes):
            fault = f"is in scene {unit.scene}, and scenes count from 0 to {len(file.scenes) - 1}"
        elif not end <= unit.start < unit.end <= len(screenplay.text):
            fault = f"covers the characters {unit.start} to {unit.end}, which are not after those of the unit before"
        elif not _said_in(unit.text, screenplay.text[unit.start : unit.end]):
            fault = "does not have the script's own words"
        if fault:
            raise InputError(f"unit {number} {fault}", mend="keep number, start, end and text", path=path)
        end = unit.start


def _said_in(text: str, words: str) -> bool:
    """Whether the words of a unit are the script's, in order; quotation marks and stage directions may be left out."""
    script = iter(_WORD.findall(words))
    return all(word in script for word in _WORD.findall(text))


def _check_ids(file: ReadingFile, path: Path) -> None:
    """Ids are names, each is given once, and what units and relations say is about people and things of the file."""
    identifier = TypeAdapter(Identifier)
    known: set[str] = set()
    for each in (*file.people, *file.things):
        try:
            identifier.validate_python(each.id)
        except ValidationError as error:
            mend = "an id is small letters, digits and _, and begins with a letter"
            raise InputError(f"{each.id!r} is not a valid id", mend=mend, path=path) from error
        if each.id in known:
            raise InputError(f"the id {each.id!r} is given twice", mend="rename one of them", path=path)
        known.add(each.id)
    people = {person.id for person in file.people}
    for index, written in enumerate(file.scenes):
        for unknown, mend in unknown_sets(written.scene):
            raise InputError(f"scene {index} has {unknown}", mend=mend, path=path)
    for written in file.units:
        unit, where = written.unit, f"unit {written.number}"
        for kind, name in unknown_names(unit, people, known):
            problem = f"{where} names {name!r}, and there is no {kind} of that id"
            near = motion_called(name) if kind == "motion" else None
            mend = f"the nearest motion is {near!r}" if near else "add it, or mend the id"
            raise InputError(problem, mend=mend, path=path)
        _refuse_camera_words(unit.camera, where, path)


def unknown_sets(scene: SceneReading) -> Iterator[tuple[str, str]]:
    """Yield the set kit and the options of a scene that do not exist, each with what to do."""
    known = SETS[scene.kit].options if scene.kit in SETS else ()
    if scene.kit and scene.kit not in SETS:
        yield f"the set kit {scene.kit!r}, which does not exist", "`storyblender catalog sets` lists them"
    for option in scene.set_options or ():
        if option not in known:
            mend = f"options of the kit {scene.kit!r}: {', '.join(known) or 'none'}"
            yield f"the set option {option!r}, which its kit does not have", mend


def unknown_names(unit: Unit, people: Collection[str], known: Collection[str]) -> Iterator[tuple[str, str]]:
    """Yield what a unit names that does not exist, each with its kind: ``person``, ``thing``, ``motion`` ...

    Args:
        unit: Of a reading.
        people: Ids of the people of the reading.
        known: Ids of its people and things.
    """
    gazes = {*known, *get_args(GazeDirection)}
    motions = [*unit.activities.values(), *(deed.motion for deed in unit.deeds)]
    yield from (("person", each) for each in _people_of(unit) if each not in people)
    yield from (("thing", each) for each in _things_of(unit) if each not in known)
    yield from (("person or thing", each) for each in unit.gaze.values() if each not in gazes)
    yield from (("motion", each) for each in motions if each and each not in MOTION_KEYS)


def _people_of(unit: Unit) -> list[str]:
    """Return every id of a unit that must be a person's."""
    lists = (
        unit.on_stage, unit.entering, unit.leaving, unit.people, unit.posture, unit.held, unit.expressions, unit.gaze,
        unit.grips, unit.activities,
    )  # fmt: skip
    named = [each for ids in lists for each in ids]
    named += [deed.actor for deed in unit.deeds]
    return named + [each for each in (unit.speaker, unit.to) if each is not None]


def _things_of(unit: Unit) -> list[str]:
    """Return every id in a unit that may be a thing's or a person's."""
    gripped = (thing for grips in unit.grips.values() for thing in grips)
    tied = (each for tether in unit.tethers for each in (tether.holder, tether.held))
    return [*unit.things, *unit.absent, *unit.spots, *gripped, *tied]


def _refuse_camera_words(camera: CameraNote | None, where: str, path: Path) -> None:
    """Raise an error for an unknown value of a camera direction."""
    for field, words in _CAMERA_WORDS.items():
        said = getattr(camera, field, "")
        if said and said not in words:
            mend = f"it is one of: {', '.join(sorted(words))}"
            raise InputError(f"{where} has the camera {field} {said!r}, which does not exist", mend=mend, path=path)
