"""Actions that a motion of the user's own plays: where the person stands for it, where it leads, and its cue."""

from __future__ import annotations

import math
from collections.abc import Mapping

from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.floor import BODY, facing
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.geometry.paths import Vec2
from storyblender.memory.mocap import MocapClip
from storyblender.memory.shot_context import BodyState, CharacterAction

TRAVELS = 0.25
"""Metres below which a recording stays on the spot."""
_STEPS = 6
"""Points of a way that are looked at for room."""


def play_recorded(
    stage: StageState,
    sheet: CueSheet,
    action: CharacterAction,
    person: StagedPerson,
    ends: Mapping[str, BodyState],
) -> bool:
    """Write the cue of an action that has a recording; return False where its posture is not the person's.

    Who sits or lies, and stays so, moves only arms, trunk and head; for a recording that travels they stand up first.

    Args:
        stage: The people of the scene.
        sheet: The cue sheet that takes the cue.
        action: The action.
        person: Who does it.
        ends: How the script has people at the end of the shot, by asset id.
    """
    clip = action.mocap
    if clip is None or (clip.seated and person.upright):
        return False
    start = now = sheet.earliest_start(person)
    end_state = ends.get(person.asset_id)
    stays = end_state is not None and end_state.posture == person.posture
    if not person.upright and not clip.seated and not stays:
        now = sheet.stand_up(person, now)
    partner = stage.people.get(action.target_id or "")
    thing = stage.floor.thing(action.target_id, person.place)
    if partner is not None and partner.present and partner is not person:
        now = sheet.turn_to_person(person, partner, now)
    elif thing is not None and person.upright:
        now = sheet.turn_to_yaw(person, facing(person.place, thing.location[:2]), now)
    mark = None
    if person.upright:
        goal = _goal(clip, person) if clip.travel > TRAVELS else None
        if goal is not None and not _has_room(stage, person, goal):
            sheet.note_cheat(person, f"stays on the spot for {clip.name}: there is no room for {clip.travel:.1f} m")
            goal = None
        person.place = goal or person.place
        person.yaw += math.radians(clip.turns)
        mark = person.mark() if goal is not None else None
    frames = max(1, round(clip.seconds * sheet.fps))
    target = partner.asset_id if partner is not None else thing.node_id if thing is not None else None
    end = sheet.add_cue(
        person, action.motion, now, clip.seconds, target_id=target, mood=action.mood, mark=mark, duration=frames,
        prop_id=action.prop_id if action.prop_id in person.held.values() else None, mocap=clip.digest,
    )  # fmt: skip
    sheet.finish_action(person, start, end)
    return True


def _goal(clip: MocapClip, person: StagedPerson) -> Vec2:
    """Return where a recording leads a person from where they stand."""
    way, length = person.yaw + math.radians(clip.way), clip.travel * person.scale
    return person.place[0] + length * math.sin(way), person.place[1] - length * math.cos(way)


def _has_room(stage: StageState, person: StagedPerson, goal: Vec2) -> bool:
    """Return whether the way to a goal, and the goal, are free."""
    others = stage.others(person)
    for step in range(1, _STEPS + 1):
        share = step / _STEPS
        point = tuple(a + (b - a) * share for a, b in zip(person.place, goal, strict=True))
        spot = (float(point[0]), float(point[1]))
        if stage.floor.room_at(spot) < BODY * person.scale * 0.7 or not stage.floor.inside(spot):
            return False
        if any(math.dist(spot, other) < 2 * BODY * person.scale for other in others):
            return False
    return True
