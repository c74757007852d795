"""Marks that a person set: people start and end a shot on them, whatever else their actions ask for."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.motions import AIMED, turning_seconds
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2
from storyblender.memory.scene_decision import FloorPlace, PersonMarks
from storyblender.memory.shot_context import Blocking, Flaw, ShotContext

_ON_MARK = 0.12
"""Metres that a person may be from a mark without a walk."""
ON_FLOOR = ("lie", "kneel", "crouch")
"""Postures that a person may have anywhere on the floor."""
_TURNED = math.radians(1)
_MISSED = 0.002
"""Metres."""


def set_marks(shot: ShotContext) -> Iterator[tuple[str, float, float]]:
    """Yield the marks of a shot that a person set, each as asset id and floor point in metres."""
    for asset_id, marks in shot.blocking_decision.people.items() if shot.blocking_decision is not None else ():
        for place in (marks.start, marks.end):
            if place is not None and place.location is not None:
                yield asset_id, *place.location


def take_set_starts(stage: StageState, marks: Mapping[str, PersonMarks]) -> None:
    """Put people who stand on the marks that a person set for the start of the shot.

    Args:
        stage: With everybody where the script has them; changed.
        marks: By asset id.
    """
    for asset_id, mark in marks.items():
        person = stage.people.get(asset_id)
        if person is None or not person.present or mark.start is None:
            continue
        if mark.start.posture in ON_FLOOR and mark.start.location is not None:
            person.support, person.anchor = None, ""
        elif not person.upright:
            continue
        if mark.start.location is not None:
            person.place, person.z = mark.start.location, 0.0
        if mark.start.rotation is not None:
            person.yaw = math.radians(mark.start.rotation)


def end_on_mark(sheet: CueSheet, person: StagedPerson, place: FloorPlace) -> None:
    """Let a person end the shot where their mark was set: they walk there if their actions end elsewhere.

    Args:
        sheet: The cues of the shot; changed.
        person: After their actions.
        place: The floor point in metres and the degrees that they end at; either may be left out.
    """
    yaw = None if place.rotation is None else math.radians(place.rotation)
    now = sheet.earliest_start(person)
    if place.location is not None and math.dist(place.location, person.place) > _ON_MARK:
        now = sheet.walk_to(person, place.location, yaw, now)
    if place.location is not None and 0.0 < math.dist(place.location, person.place) <= 2 * _ON_MARK:
        _shift_arrival(sheet, person, place.location)
    turn = 0.0 if yaw is None else shortest_turn(person.yaw, yaw)
    if yaw is not None and person.upright and abs(turn) > _TURNED:
        person.yaw = yaw
        seconds = turning_seconds(math.degrees(turn), 1.7 * person.scale)
        now = sheet.add_cue(person, "turn", now, seconds, mark=person.mark())
    sheet.finish_action(person, now, now)


def missed_marks(marks: Mapping[str, PersonMarks], blocking: Sequence[Blocking]) -> Iterator[Flaw]:
    """Yield a flaw for each mark that a person set and that the staging could not keep.

    Args:
        marks: By asset id.
        blocking: Of the shot as it is staged.
    """
    for each in blocking:
        mark = marks.get(each.start.asset_id, PersonMarks())
        for when, place, there in (("start", mark.start, each.start), ("end", mark.end, each.end)):
            away = 0.0 if place is None or place.location is None else math.dist(place.location, there.location[:2])
            if away > _MISSED:
                message = f"{there.asset_id} is {away:.2f} m from the mark that a person set for the {when} of the shot"
                yield Flaw(kind="mark", subject=there.asset_id, weight=round(away, 3), message=message)


def _shift_arrival(sheet: CueSheet, person: StagedPerson, place: Vec2) -> None:
    """Move the last mark of a person by a few centimetres: that of their last walk, or the one they stayed on."""
    own = [index for index, cue in enumerate(sheet.cues) if cue.asset_id == person.asset_id and cue.mark is not None]
    walks = [index for index in own if sheet.cues[index].clip not in AIMED]
    if not walks:
        sheet.move_start_mark(person, place, person.yaw)
    person.place = place
    for index in walks[-1:]:
        sheet.cues[index] = sheet.cues[index].model_copy(update={"mark": person.mark()})
