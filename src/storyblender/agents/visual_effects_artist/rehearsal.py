"""Stages a scene shot after shot: in each, everybody goes on from where they were."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from pydantic import Field

from storyblender.agents.visual_effects_artist.action_resolver import PHONE_CALL
from storyblender.agents.visual_effects_artist.actions import Actions
from storyblender.agents.visual_effects_artist.animals import Animals
from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.fallen_props import FallenProps
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.left_props import held_props, lay_left_props
from storyblender.agents.visual_effects_artist.marks_by_hand import end_on_mark, missed_marks, take_set_starts
from storyblender.agents.visual_effects_artist.motions_by_hand import (
    do_added,
    is_left_out,
    line_of,
    missed_motions,
    second_of,
    stretch,
)
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.poses_by_hand import (
    end_as_decided,
    face_what_they_watch,
    free_of_layout,
    keep_looking,
    missed_poses,
)
from storyblender.agents.visual_effects_artist.posture_cues import PostureCues, extend_lasting_cues
from storyblender.agents.visual_effects_artist.speeches import SPOKEN, Speeches
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.agents.visual_effects_artist.way_points import missed_way_points, take_way_points
from storyblender.geometry.paths import Vec2
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen, Identifier, is_none
from storyblender.memory.outline import ScriptLine
from storyblender.memory.scene_context import LayoutObject, Spot
from storyblender.memory.scene_decision import PersonMarks
from storyblender.memory.shot_context import Blocking, CharacterAction, Cue, Flaw, PropState, ShotContext
from storyblender.memory.thing_states import Condition

GROUP_DELAY = 0.15
"""Seconds between the starts of two members of a group who do the same thing."""


@dataclass(frozen=True)
class FloorMark:
    """Where a person stands as a shot begins.

    Attributes:
        point: Floor point in metres; the nearest free one is taken.
        facing: What they face, as in ``Spot``; None leaves it open.
    """

    point: Vec2
    facing: Identifier | None = None


@dataclass(frozen=True)
class ShotDirections:
    """What staging of a shot is asked for beyond its actions and states.

    Attributes:
        marks: Marks of people who stand as the shot begins and do not come in, by asset id.
        goals: Floor points in metres where walks end, by number of the action.
        together: Numbers of actions that begin with the action before them, not after it.
    """

    marks: Mapping[Identifier, FloorMark] = field(default_factory=dict[Identifier, FloorMark])
    goals: Mapping[int, Vec2] = field(default_factory=dict[int, Vec2])
    together: frozenset[int] = frozenset()


class ShotStaging(Frozen):
    """What the Animator decides for one shot; fields of the ShotContext."""

    shot_id: int
    blocking: tuple[Blocking, ...] = ()
    cues: tuple[Cue, ...] = ()
    prop_states: tuple[PropState, ...] = ()
    duration: int
    """Frames; the Director's, or longer where the actions need it, within the limit of the cue sheet."""
    flaws: tuple[Flaw, ...] = ()
    """Actions that were cut short or moved so that they fit."""
    character_actions: tuple[CharacterAction, ...] | None = Field(default=None, exclude_if=is_none)
    """The actions as they are played, where they are not as the Director read them."""

    def applied(self, shot: ShotContext) -> ShotContext:
        """Return the shot with this staging."""
        return shot.model_copy(update={name: value for name, value in self if value is not None})


class Rehearsal:
    """The staging of one scene.

    Args:
        floor: Everything on the floor.
        assets: Characters with their statures, objects with their sizes.
        objects: The layout, for the people's first places.
        fps: Frames per second.
        found: States of things as the scene opens, by asset id.
    """

    def __init__(
        self,
        floor: Floor,
        assets: Sequence[Asset],
        objects: Sequence[LayoutObject],
        fps: int,
        found: Mapping[str, Condition] = {},
    ) -> None:
        self.stage, self.fps = StageState(floor, assets, objects), fps
        self.animals = Animals(self.stage, assets, objects)
        self.fallen = FallenProps(assets, objects, found)

    def keep_locked_blocking(self, shot: ShotContext) -> None:
        """Take over the ends of a shot whose blocking the user has locked."""
        self.stage.keep_locked_blocking(shot)

    def play(
        self,
        shot: ShotContext,
        lines: Sequence[ScriptLine],
        stay: Sequence[str],
        directions: ShotDirections = ShotDirections(),
    ) -> ShotStaging:
        """Stage one shot.

        Args:
            shot: The shot with its actions and states.
            lines: Lines of the script that it covers, for the length of speeches.
            stay: Asset ids of people who are on stage in the next shot too.
            directions: Marks, goals of walks and overlaps that are asked for.
        """
        stage = self.stage
        cast = [stage.people[name] for name in shot.on_stage if name in stage.people]
        held = held_props(stage)
        stage.bring_on_stage(shot, cast, stay)
        decided = shot.blocking_decision.people if shot.blocking_decision is not None else {}
        free_of_layout(stage, decided)
        stage.apply_states(shot.states, shot.character_actions)
        lay_left_props(stage, held, shot)
        self._take_marks(directions.marks)
        take_set_starts(stage, decided)
        take_way_points(stage, decided)
        face_what_they_watch(stage, decided)
        stage.place_loose_props(shot)
        standing = stage.prop_states(shot)
        sheet = CueSheet(
            stage,
            shot.duration / self.fps,
            self.fps,
            {name for name in shot.on_stage if name not in stay},
            {person.asset_id: person.mark() for person in cast},
            self.fallen.add_fallen(shot, standing, stage.prop_places),
        )
        ends = {state.asset_id: state for state in shot.end_states}
        calling = {state.asset_id for state in shot.states if state.activity == PHONE_CALL}
        actions, speeches = Actions(stage, sheet, ends), Speeches(stage, sheet, calling)
        seconds = speeches.speech_seconds(shot, lines)
        began = sheet.clock
        for number, action in enumerate(shot.character_actions):
            person = stage.people.get(action.asset_id)
            if person is None or not person.present or is_left_out(action, decided):
                continue
            if number and _is_same_action(action, shot.character_actions[number - 1]):
                sheet.clock = began + GROUP_DELAY
            latest = sheet.clock
            if number in directions.together:
                sheet.clock = began
            if (at := second_of(action, decided)) is not None:
                sheet.clock = at
            began, person.goal = sheet.clock, directions.goals.get(number)
            if action.motion in SPOKEN:
                line = line_of(action, decided.get(action.asset_id, PersonMarks()))
                length = (line.seconds if line is not None else None) or seconds.get(number, 2.0)
                speeches.add_speech(action, person, length, cast)
            else:
                actions.add_action(action, person, shot.character_actions[number + 1 :])
            if number in directions.together or at is not None:
                sheet.clock = max(sheet.clock, latest)
            person.goal = None
        do_added(sheet, stage, ends, decided, shot.character_actions)
        for asset_id, marks in decided.items():
            person = stage.people.get(asset_id)
            if person is not None and person.present and marks.end is not None:
                end_on_mark(sheet, person, marks.end)
        end_as_decided(sheet, stage, ends, decided)
        speeches.add_idle_looks(shot, cast)
        PostureCues(stage, sheet).add_posture_cues(shot)
        keep_looking(sheet, stage, decided)
        stretch(sheet, decided)
        duration = shot.duration
        if "duration" not in shot.locked and shot.decided_duration is None:
            needed = math.ceil((max((person.busy for person in cast), default=0.0) + 0.25) * self.fps)
            duration = min(max(duration, needed), math.ceil(sheet.hard_limit * self.fps))
        blocking = tuple(Blocking(start=sheet.starts[person.asset_id], end=person.mark()) for person in cast)
        missed = (
            *missed_marks(decided, blocking),
            *missed_way_points(stage),
            *missed_poses(decided, blocking),
            *missed_motions(sheet, decided),
        )
        stage.end_shot(stay)
        going_on = extend_lasting_cues(sheet.cues, duration)
        beasts, places = self.animals.play(shot, self.fps, duration)
        going_on = [*going_on, *beasts]
        cues = tuple(sorted((_end_with_shot(cue, duration) for cue in going_on), key=lambda cue: cue.start))
        moved = {state.asset_id for state in places}
        props = (*(state for state in sheet.start_props if state.asset_id not in moved), *places)
        return ShotStaging(
            shot_id=shot.shot_id,
            blocking=blocking,
            cues=cues,
            prop_states=props,
            duration=duration,
            flaws=(*sheet.cheats, *missed),
        )

    def _take_marks(self, marks: Mapping[Identifier, FloorMark]) -> None:
        """Put people on their marks, then turn them, so that they can face each other."""
        stage, there = self.stage, list[tuple[StagedPerson, Spot]]()
        for asset_id, mark in marks.items():
            person = stage.people.get(asset_id)
            if person is not None and person.present and person.upright and not person.entering:
                person.place = stage.floor.free_spot(mark.point, person.scale, stage.others(person))
                there.append((person, Spot(facing=mark.facing)))
        for person, spot in there:
            station = stage.spot_finder.find_station(person, spot)
            person.yaw = station.yaw if station is not None else person.yaw


def _is_same_action(action: CharacterAction, before: CharacterAction) -> bool:
    """Tell whether two members of a group do the same thing: they do it together, not one after the other."""
    stems = {each.asset_id.rpartition("_")[0] for each in (action, before)}
    same = (action.motion, action.action_description) == (before.motion, before.action_description)
    return same and action.asset_id != before.asset_id and len(stems) == 1 and stems != {""}


def _end_with_shot(cue: Cue, frames: int) -> Cue:
    """Return a cue cut at the end of the shot (``frames``) if it is done on the spot; walks keep their time."""
    if cue.duration is None or cue.mark is not None or cue.start + cue.duration <= frames:
        return cue
    return cue.model_copy(update={"duration": max(1, frames - cue.start)})
