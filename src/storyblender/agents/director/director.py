"""The Director as a role that reflects: first the reading of the script, then its shots, each with a computed critic.

The rules' own drafts pass as they are; a language model's are held to the same list: ids exist, each unit of the script
is covered once and in order, speakers are on stage or marked off screen, written camera directions are obeyed, motions
and places come from the vocabulary.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.directions import camera_notes_by_unit
from storyblender.agents.director.places_by_meaning import choose_kits_by_meaning
from storyblender.agents.director.reader.reader import read_script
from storyblender.agents.director.reading import Reading, Unit
from storyblender.agents.director.reading_file import unknown_names, unknown_sets
from storyblender.agents.director.settings import DirectorSettings
from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.props import PROPS
from storyblender.catalog.sets import SETS
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.graph import Storyboard
from storyblender.memory.outline import ScriptLine
from storyblender.ports import Embedder
from storyblender.reflection import UNUSABLE, Critique, Fault
from storyblender.screenplay.model import Screenplay


class RulesDirector:
    """Reads a script by rules.

    Args:
        embedder: Likeness of meaning, for places that no word list knows; loaded only then.
    """

    def __init__(self, embedder: Callable[[], Embedder]) -> None:
        self._embedder = embedder

    def propose(self, view: Screenplay) -> Reading:
        """Return the reading of a script."""
        reading = read_script(view)
        choose_kits_by_meaning(reading, self._embedder)
        return reading

    def refine(self, draft: Reading, critique: Critique, view: Screenplay) -> Reading:
        """Return the draft: rules read a script in one way only.

        Args:
            draft: The reading.
            critique: Its faults.
            view: The script.
        """
        return draft


class DirectorCritic:
    """Checks a reading against the script, its own ids and the vocabulary."""

    def judge(self, draft: Reading, view: Screenplay) -> Critique:
        """Score ten less one for each unit or element that is wrong.

        Args:
            draft: The reading.
            view: The script.
        """
        return Critique.of(
            (*_uncovered_lines(draft, view), *(fault for unit in _faults_of_units(draft) for fault in unit))
        )


def _uncovered_lines(reading: Reading, script: Screenplay) -> Iterator[Fault]:
    """Yield lines of action and speech of the script that no unit has, and units that are out of order."""
    covered = {unit.element for unit in reading.units}
    first = min((scene.start for scene in reading.scenes), default=0)
    for index, element in enumerate(script.elements):
        told = element.kind in ("action", "dialogue") and element.text.strip() and element.start >= first
        if told and index not in covered:
            yield Fault(kind="uncovered", subject=f"line {element.line}", message=f"line {element.line} is in no unit")
    places = [(unit.scene, unit.start) for unit in reading.units]
    for number, (before, after) in enumerate(itertools.pairwise(places), start=2):
        if after < before:
            yield Fault(kind="order", subject=f"unit {number}", message=f"unit {number} comes before the one above it")


def _faults_of_units(reading: Reading) -> Iterator[Iterator[Fault]]:
    """Yield the faults of each unit of a reading."""
    people = {person.id for person in reading.people}
    known = people | {thing.id for thing in reading.things}
    for number, unit in enumerate(reading.units, start=1):
        yield _faults_of_unit(f"unit {number}", unit, reading, people, known)


def _faults_of_unit(name: str, unit: Unit, reading: Reading, people: set[str], known: set[str]) -> Iterator[Fault]:
    """Yield names, sets and speakers of a unit that do not exist or are not on stage."""
    for kind, unknown in dict.fromkeys(unknown_names(unit, people, known)):
        message = f"{name} names the {kind} {unknown!r}, which does not exist"
        yield Fault(kind="unknown", subject=name, message=message, severity=UNUSABLE if kind == "motion" else 1.0)
    for unknown, _ in unknown_sets(reading.scenes[unit.scene]):
        yield Fault(kind="vocabulary", subject=name, message=f"{name} plays in a scene with {unknown}")
    if unit.speaker is not None and unit.speaker not in unit.on_stage and not unit.off_screen:
        message = f"{unit.speaker} speaks in {name}, and is neither on stage nor marked off screen"
        yield Fault(kind="speaker", subject=name, message=message)


@dataclass(frozen=True)
class ShotDirectorView:
    """What the Director sees when cutting a script into shots.

    Attributes:
        reading: What the script says.
        settings: How finely to cut.
    """

    reading: Reading
    settings: DirectorSettings


class RulesShotDirector:
    """Cuts a script into shots by rules."""

    def propose(self, view: ShotDirectorView) -> Storyboard:
        """Return the storyboard."""
        return storyboard(view.reading, view.settings)

    def refine(self, draft: Storyboard, critique: Critique, view: ShotDirectorView) -> Storyboard:
        """Return the draft: rules cut a script in one way only.

        Args:
            draft: The storyboard.
            critique: Its faults.
            view: The reading and how finely to cut it.
        """
        return draft


class ShotDirectorCritic:
    """Checks that shots cover the script once and in order, show who speaks, obey directions; props and sets exist."""

    def judge(self, draft: Storyboard, view: ShotDirectorView) -> Critique:
        """Score ten less one for each fault.

        Args:
            draft: The storyboard.
            view: The reading and how finely to cut it.
        """
        return Critique.of(
            (
                *_uncovered_units(draft, view.reading),
                *_unmarked_speakers(draft),
                *_ignored_directions(draft, view.reading),
                *_unknown_motions(draft),
                *_unknown_kinds(draft),
                *_unknown_sets(draft),
            )
        )


def _lines(board: Storyboard) -> Iterator[tuple[str, ScriptLine]]:
    """Yield every line of a storyboard with the name of its shot."""
    for scene in board.storyboard_outline:
        for shot in scene.shots:
            for line in shot.lines:
                yield shot_name(scene.scene_id, shot.shot_id), line


def _uncovered_units(board: Storyboard, reading: Reading) -> Iterator[Fault]:
    """Yield units of the script that no shot covers."""
    spans = sorted((line.span.start, line.span.end) for _, line in _lines(board))
    for number, unit in enumerate(reading.units, start=1):
        told = unit.kind in ("action", "dialogue")
        if told and not any(start < unit.end and unit.start < end for start, end in spans):
            yield Fault(kind="uncovered", subject=f"unit {number}", message=f"no shot covers unit {number}")


def _unknown_motions(board: Storyboard) -> Iterator[Fault]:
    """Yield motions of actions and activities that the catalogue does not have."""
    for shot in board.shot_details:
        name = shot_name(shot.scene_id, shot.shot_id)
        for motion in sorted(shot.motions.difference(MOTIONS)):
            message = f"{name} has the motion {motion!r}, which does not exist"
            yield Fault(kind="vocabulary", subject=name, message=message, severity=UNUSABLE)


def _unmarked_speakers(board: Storyboard) -> Iterator[Fault]:
    """Yield speakers who are neither on stage nor marked off screen."""
    on_stage = {shot_name(shot.scene_id, shot.shot_id): shot.on_stage for shot in board.shot_details}
    for name, line in _lines(board):
        if line.speaker is not None and line.speaker not in on_stage[name] and not line.off_screen:
            message = f"{line.speaker} speaks in {name}, and is neither on stage nor marked off screen"
            yield Fault(kind="speaker", subject=name, message=message)


def _unknown_kinds(board: Storyboard) -> Iterator[Fault]:
    """Yield objects that are said to be a prop that the catalog does not have."""
    for asset in board.asset_sheet:
        if asset.kind and asset.kind not in PROPS:
            message = f"{asset.asset_id} is said to be a {asset.kind!r}, which is no prop of the catalog"
            yield Fault(kind="vocabulary", subject=asset.asset_id, message=message)


def _unknown_sets(board: Storyboard) -> Iterator[Fault]:
    """Yield scenes whose set kit does not exist, or has not all of their options."""
    for scene in board.scene_details:
        name, kit = scene_name(scene.scene_id), SETS.get(scene.setup.kit)
        if kit is None or not kit.options.keys() >= {*scene.setup.set_options}:
            message = f"{name} has a set that does not exist: {scene.setup.kit!r}, {list(scene.setup.set_options)}"
            yield Fault(kind="vocabulary", subject=name, message=message, severity=UNUSABLE)


def _ignored_directions(board: Storyboard, reading: Reading) -> Iterator[Fault]:
    """Yield sizes and angles that the script asks for and no shot of those words has."""
    cameras = {shot_name(shot.scene_id, shot.shot_id): shot.camera_instruction for shot in board.shot_details}
    lines = list(_lines(board))
    for index, note in camera_notes_by_unit(reading).items():
        unit = reading.units[index]
        shots = {name for name, line in lines if line.span.start < unit.end and unit.start < line.span.end}
        for field in ("size", "angle"):
            asked = getattr(note, field)
            if asked and shots and not any(cameras[name].model_dump()[field] == asked for name in shots):
                message = f"the script asks for {field} {asked} in unit {index + 1}"
                yield Fault(kind="direction", subject=sorted(shots)[0], message=message)
