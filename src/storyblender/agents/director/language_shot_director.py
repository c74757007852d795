"""The Director cutting a script into shots, played by a language model: which units make a picture, and what picture.

Scene by scene it groups numbered units and says kind, size and angle of their picture. That becomes camera advice in
the reading, so the rules cut what it leaves out, and whatever the script itself directs is obeyed before it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any

from pydantic import Field

from storyblender.agents.asking import Asker, Notes
from storyblender.agents.director.annotation import DIRECTORS_PICTURES
from storyblender.agents.director.directions import camera_notes_by_unit, camera_words
from storyblender.agents.director.director import RulesShotDirector, ShotDirectorView
from storyblender.agents.director.durations import action_seconds, speech_seconds
from storyblender.agents.director.reading import CameraNote, Deed, Reading, Unit
from storyblender.agents.director.scene_coverage import ATTACHED_KINDS
from storyblender.errors import AnswerAwaited
from storyblender.memory.base import Identifier, scene_name
from storyblender.memory.graph import Storyboard
from storyblender.memory.shot_sizes import ShotSize
from storyblender.memory.vocabulary import Angle, BodyPart, CameraDirection, Movement, ShotKind
from storyblender.ports import Answerer
from storyblender.reflection import Critique

_MOST_UNITS = 40
"""Units in one request; a longer scene is cut in parts."""
_NEEDS_WHO = {"ots": "over whose shoulder", "pov": "whose eyes"}


class PictureNotes(Notes):
    """One picture of the storyboard."""

    first: int
    """Number of its first unit."""
    last: int
    """Number of its last unit; the same if it has only one."""
    kind: ShotKind
    size: ShotSize
    angle: Angle = "eye-level"
    movement: Movement = "static"
    direction: CameraDirection | None = None
    """Of a pan, tilt, orbit, truck or pedestal."""
    subjects: tuple[Identifier, ...] = ()
    """Whom and what it shows, the most important first."""
    who: Identifier | None = None
    """`ots`: over whose shoulder; `pov`: through whose eyes."""
    detail: BodyPart | None = None
    """`insert`: shows only this part of its first subject."""
    why: Annotated[str, Field(max_length=200)] = ""
    """What the audience learns or feels from it, in a few words."""


class CutNotes(Notes):
    """The pictures of a scene in order; units in none of them are cut by rules."""

    pictures: tuple[PictureNotes, ...] = ()


@dataclass(frozen=True)
class _Part:
    """Units of one scene that are cut in one request."""

    scene: int
    """Index of the scene."""
    units: Mapping[int, Unit]
    """By number, counted from one through the script."""


class LanguageShotDirector:
    """Cuts a script into shots by a language model.

    Args:
        answerer: The model, or a person in its place.
        rules: Make the shots of the pictures.
    """

    def __init__(self, answerer: Answerer, rules: RulesShotDirector) -> None:
        self._asker = Asker(answerer, "shot_director", CutNotes)
        self._rules = rules
        self._cuts: list[CutNotes] = []
        """The answers so far, by part."""

    def propose(self, view: ShotDirectorView) -> Storyboard:
        """Return the storyboard. Raises NoAnswer or AnswerAwaited."""
        self._cuts = []
        return self._cut(view, {})

    def refine(self, draft: Storyboard, critique: Critique, view: ShotDirectorView) -> Storyboard:
        """Return the storyboard with the scenes cut again in which the critic found faults.

        Args:
            draft: The storyboard.
            critique: Its faults; their subjects are units or shots.
            view: What was read.
        """
        scenes = {scene_name(scene.id): index for index, scene in enumerate(view.reading.scenes)}
        units = {f"unit {number}": unit.scene for number, unit in enumerate(view.reading.units, start=1)}
        wrong: dict[int, list[str]] = {}
        for fault in critique.faults:
            scene = units.get(fault.subject, scenes.get(fault.subject.partition("_")[0]))
            if scene is not None:
                wrong.setdefault(scene, []).append(fault.message)
        return self._cut(view, wrong) if wrong else draft

    def _cut(self, view: ShotDirectorView, wrong: Mapping[int, Sequence[str]]) -> Storyboard:
        """Ask for every part without an answer or with faults (sentences by scene); return the storyboard."""
        parts, written = _parts(view.reading), camera_notes_by_unit(view.reading)
        awaited: list[AnswerAwaited] = []
        cuts: list[CutNotes] = []
        for number, part in enumerate(parts):
            before = self._cuts[number] if number < len(self._cuts) else None
            faults = tuple(wrong.get(part.scene, ()))
            if before is not None and not faults:
                cuts.append(before)
                continue
            try:
                cuts.append(self._asked(part, view, written, before, faults))
            except AnswerAwaited as error:
                awaited.append(error)
        if awaited:
            raise AnswerAwaited.of(awaited)
        self._cuts = cuts
        units = list(view.reading.units)
        for part, notes in zip(parts, cuts, strict=True):
            for number, unit in _advised(part, notes, view.reading, written):
                units[number - 1] = unit
        return self._rules.propose(replace(view, reading=replace(view.reading, units=units)))

    def _asked(
        self,
        part: _Part,
        view: ShotDirectorView,
        written: Mapping[int, CameraNote],
        before: CutNotes | None,
        faults: tuple[str, ...],
    ) -> CutNotes:
        """Return the cut of a part; ``before`` is the answer that the faults are about."""
        return self._asker.ask(
            f"scene {view.reading.scenes[part.scene].id} from unit {min(part.units)}",
            _shown(part, view, written),
            lambda notes: _wrong(notes, part, view.reading, written),
            previous=before.model_dump_json(exclude_defaults=True) if before is not None and faults else "",
            feedback=faults,
        )


def _parts(reading: Reading) -> list[_Part]:
    """Return the units that get shots, scene by scene, forty at most in a part."""
    parts: list[_Part] = []
    for scene in range(len(reading.scenes)):
        units = [
            (number, unit)
            for number, unit in enumerate(reading.units, start=1)
            if unit.scene == scene and unit.kind not in ATTACHED_KINDS
        ]
        parts += [_Part(scene, dict(units[at : at + _MOST_UNITS])) for at in range(0, len(units), _MOST_UNITS)]
    return parts


def _shown(part: _Part, view: ShotDirectorView, written: Mapping[int, CameraNote]) -> dict[str, Any]:
    """Return what the model is shown of a part."""
    reading, units = view.reading, part.units.values()
    scene = reading.scenes[part.scene]
    seen = {name for unit in units for name in (*unit.on_stage, *unit.people, *unit.things)}
    seen |= {name for unit in units for deed in unit.deeds for name in (deed.target, deed.prop) if name}
    begins = min(part.units) == 1 or reading.units[min(part.units) - 2].scene != part.scene
    known = not begins or scene.reference is not None
    return {
        "title": reading.screenplay.title,
        "scene": {
            "number": scene.id,
            "heading": scene.heading or scene.place,
            "seen_before": known,
        },
        "aim": {
            "pictures_of_a_short_scene": view.settings.shots_per_scene,
            "longest_talk_seconds": view.settings.longest_talk,
            "longest_action_seconds": view.settings.longest_action,
        },
        "people": {each.id: each.name for each in reading.people if each.id in seen},
        "things": {each.id: each.name for each in reading.things if each.id in seen},
        "units": [_shown_unit(number, reading, written.get(number - 1)) for number in part.units],
    }


def _panel(unit: Unit) -> int | None:
    """Return the panel of the page, or the picture numbered by a person, that a unit is in; None for the Director's."""
    return unit.picture if unit.picture is not None and unit.picture < DIRECTORS_PICTURES else None


def _shown_unit(number: int, reading: Reading, written: CameraNote | None) -> dict[str, Any]:
    unit = reading.units[number - 1]
    talk, panel = unit.kind == "dialogue", _panel(unit)
    told: dict[str, Any] = {
        "number": number,
        "text": unit.text,
        "speaker": unit.speaker if talk else None,
        "to": unit.to,
        "off_screen": unit.off_screen,
        "seconds": round(speech_seconds(unit.text, unit.parenthetical) if talk else action_seconds(unit.text), 1),
        "on_stage": unit.on_stage,
        "does": [_shown_deed(deed) for deed in unit.deeds],
        "entering": unit.entering,
        "leaving": unit.leaving,
        "faces": unit.expressions,
        "posture": {each: posture for each, (posture, _) in unit.posture.items()},
        "holds": {each: things for each, things in unit.held.items() if things},
        "where": {each: spot.model_dump(mode="json", exclude_defaults=True) for each, spot in unit.spots.items()},
        "changes": [f"{change.subject} {change.state}" for change in unit.changes],
        "not_there": unit.absent,
        "moment": unit.moment,
        "panel": panel,
        "picture": unit.picture % DIRECTORS_PICTURES if unit.picture is not None and panel is None else None,
        "camera_in_script": camera_words(written) if written is not None else None,
    }
    return {name: value for name, value in told.items() if value}


def _shown_deed(deed: Deed) -> str:
    """Return a deed in words: ``rick pick_up envelope``, ``tam tap hull with wrench``."""
    tool = f"with {deed.prop}" if deed.prop is not None and deed.target is not None else deed.prop
    return " ".join(filter(None, (deed.actor, deed.motion, deed.target, tool)))


def _wrong(notes: CutNotes, part: _Part, reading: Reading, written: Mapping[int, CameraNote]) -> Iterator[str]:
    """Yield pictures that overlap or are out of order, names that do not exist, and panels of the page cut anew."""
    people, things = {each.id for each in reading.people}, {each.id for each in reading.things}
    least, end = min(part.units), max(part.units)
    before = least - 1
    for place, picture in enumerate(notes.pictures, start=1):
        name = f"picture {place} (units {picture.first} to {picture.last})"
        if not before < picture.first <= picture.last <= end:
            yield f"{name}: pictures go in order through units {least} to {end}, and no unit is in two"
            return
        before = picture.last
        inside = [unit for number, unit in part.units.items() if picture.first <= number <= picture.last]
        for subject in picture.subjects:
            if subject not in people | things:
                yield f"{name} shows {subject!r}, which is neither in `people` nor in `things`"
            elif subject in people and not any(subject in unit.on_stage for unit in inside):
                yield f"{name} shows {subject}, and {subject} is not on stage then"
        if picture.kind in _NEEDS_WHO and picture.who not in people:
            yield f"{name} is of kind {picture.kind} and needs `who`: {_NEEDS_WHO[picture.kind]}"
        directed = [n for n in range(picture.first, picture.last + 1) if n in part.units and n - 1 in written]
        if len(directed) > 1:
            yield f"{name} has several directions of the script, at units {directed}; each is a picture of its own"
        panels = {_panel(unit) for unit in inside}
        beyond = [n for n, unit in part.units.items() if _panel(unit) in panels - {None} and unit not in inside]
        if len(panels) > 1 or beyond:
            yield f"{name} does not keep to the panels of the page; units share a picture if they share a `panel`"


def _advised(
    part: _Part, notes: CutNotes, reading: Reading, written: Mapping[int, CameraNote]
) -> Iterator[tuple[int, Unit]]:
    """Yield units by number with their picture, the first of each with its camera unless the script directs it."""
    first = DIRECTORS_PICTURES * (DIRECTORS_PICTURES + min(part.units))
    for place, picture in enumerate(notes.pictures, start=first):
        numbers = range(picture.first, picture.last + 1)
        directed = any(number - 1 in written for number in numbers)
        for number in numbers:
            unit = reading.units[number - 1]
            own = unit.camera if directed or number != picture.first else _camera_note(picture, reading)
            yield number, replace(unit, picture=place, camera=own)


def _camera_note(picture: PictureNotes, reading: Reading) -> CameraNote:
    """Return a picture as camera advice: a direction without words of the script."""
    subject = ", ".join(picture.subjects)
    names = {each.id: each.name for each in reading.people}
    if picture.detail is not None and picture.subjects[:1] and picture.subjects[0] in names:
        subject = f"{names[picture.subjects[0]]} {picture.detail}"
    return CameraNote(
        size=picture.size, kind=picture.kind, angle=picture.angle, movement=picture.movement,
        direction=picture.direction or "", subject=subject, who=picture.who or "",
    )  # fmt: skip
