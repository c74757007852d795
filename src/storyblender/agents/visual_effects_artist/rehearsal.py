"""The rehearsal of one scene: shot after shot, everybody goes on from where they were. Pure."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from storyblender.agents.visual_effects_artist.actions import Actions
from storyblender.agents.visual_effects_artist.company import Company
from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.deeds import CALL
from storyblender.agents.visual_effects_artist.fallen import Fallen
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.menagerie import Menagerie
from storyblender.agents.visual_effects_artist.posture_cues import PostureCues, extend_lasting_cues
from storyblender.agents.visual_effects_artist.speeches import SPOKEN, Speeches
from storyblender.catalog.motions import clip_of
from storyblender.catalog.states import Condition
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.outline import ScriptLine
from storyblender.memory.scene_context import LayoutObject
from storyblender.memory.shot_context import Blocking, CharacterAction, Cue, Flaw, PropState, ShotContext

AT_ONCE = 0.15
"""Delay in seconds between one member of a group and the next."""


@dataclass(frozen=True)
class ShotPlan:
    """What the rehearsal of one shot comes to."""

    shot_id: int
    blocking: tuple[Blocking, ...]
    cues: tuple[Cue, ...]
    prop_states: tuple[PropState, ...]
    duration: int
    cheats: tuple[Flaw, ...]


class Rehearsal:
    """A scene being staged.

    Args:
        floor: Where things are.
        assets: Characters with their statures, objects with their sizes.
        objects: The layout, for the people's first places.
        fps: Frames per second.
        found: States in which things are as the scene opens.
    """

    def __init__(
        self,
        floor: Floor,
        assets: Sequence[Asset],
        objects: Sequence[LayoutObject],
        fps: int,
        found: Mapping[str, Condition] = {},
    ) -> None:
        self.company, self.fps = Company(floor, assets, objects), fps
        self.animals = Menagerie(self.company, assets, objects)
        self.fallen = Fallen(assets, objects, found)

    def keep(self, shot: ShotContext) -> None:
        """Take over the ends of a shot whose blocking the user has locked."""
        self.company.keep(shot)

    def play(self, shot: ShotContext, lines: Sequence[ScriptLine], stay: Sequence[str]) -> ShotPlan:
        """Stage one shot.

        Args:
            shot: Actions, states, length.
            lines: Its lines, for the length of speeches.
            stay: Who is still on stage in the next shot.
        """
        company = self.company
        cast = [company.people[name] for name in shot.on_stage if name in company.people]
        company.bring_on(shot, cast, stay)
        company.apply_states(shot.states, shot.character_actions)
        company.place_loose_props(shot)
        standing = company.prop_states(shot)
        sheet = CueSheet(
            company,
            shot.duration / self.fps,
            self.fps,
            {name for name in shot.on_stage if name not in stay},
            {person.asset_id: person.mark() for person in cast},
            self.fallen.lay(shot, standing, company.lying),
        )
        ends = {state.asset_id: state for state in shot.end_states}
        calling = {state.asset_id for state in shot.states if state.activity == CALL}
        actions, speeches = Actions(company, sheet, ends), Speeches(company, sheet, calling)
        seconds = speeches.speech_seconds(shot, lines)
        began = sheet.clock
        for number, action in enumerate(shot.character_actions):
            person = company.people.get(action.asset_id)
            if person is None or not person.present:
                continue
            if number and _is_same_action(action, shot.character_actions[number - 1]):
                sheet.clock = began + AT_ONCE
            began = sheet.clock
            if clip_of(action.motion).key in SPOKEN:
                speeches.add_speech(action, person, seconds.get(number, 2.0), lines, cast)
            else:
                actions.add_action(action, person, shot.character_actions[number + 1 :])
        speeches.add_idle_looks(shot, cast)
        PostureCues(company, sheet).add_posture_cues(shot)
        duration = shot.duration
        if "duration" not in shot.locked:
            needed = math.ceil((max((person.busy for person in cast), default=0.0) + 0.25) * self.fps)
            duration = min(max(duration, needed), math.ceil(sheet.hard_limit * self.fps))
        blocking = tuple(Blocking(start=sheet.starts[person.asset_id], end=person.mark()) for person in cast)
        company.leave(stay)
        going_on = extend_lasting_cues(sheet.cues, duration)
        beasts, places = self.animals.play(shot, self.fps, duration)
        going_on = [*going_on, *beasts]
        cues = tuple(sorted((_end_with_shot(cue, duration) for cue in going_on), key=lambda cue: cue.start))
        moved = {state.asset_id for state in places}
        props = (*(state for state in sheet.start_props if state.asset_id not in moved), *places)
        return ShotPlan(shot.shot_id, blocking, cues, props, duration, tuple(sheet.cheats))


def _is_same_action(action: CharacterAction, before: CharacterAction) -> bool:
    """Tell whether two members of a group do the same thing: they do it together, not one after the other."""
    stems = {each.asset_id.rpartition("_")[0] for each in (action, before)}
    same = (action.motion, action.action_description) == (before.motion, before.action_description)
    return same and action.asset_id != before.asset_id and len(stems) == 1 and stems != {""}


def _end_with_shot(cue: Cue, frames: int) -> Cue:
    """End what is done on the spot with the shot; ways keep their time."""
    if cue.duration is None or cue.mark is not None or cue.start + cue.duration <= frames:
        return cue
    return cue.model_copy(update={"duration": max(1, frames - cue.start)})
