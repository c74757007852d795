"""Postures, looks and hands that a person decided: they lie over what the script says of people, in any staging."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import get_args

from storyblender.agents.visual_effects_artist.actions import Actions
from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.floor import facing
from storyblender.agents.visual_effects_artist.person import StagedPerson
from storyblender.agents.visual_effects_artist.posture_cues import GLANCE_FRAMES, gaze_mark
from storyblender.agents.visual_effects_artist.speeches import SPOKEN
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.motions import MOTIONS, STANDING
from storyblender.geometry.boxes import shortest_turn
from storyblender.geometry.paths import Vec2
from storyblender.memory.scene_decision import PersonMarks, PersonPlace
from storyblender.memory.shot_context import Blocking, BodyState, CharacterAction, Cue, Flaw, ShotContext
from storyblender.memory.vocabulary import GazeDirection

WAYS: tuple[GazeDirection, ...] = get_args(GazeDirection)
"""Directions in which a person may look at nothing in the set."""
_TAKEN: Mapping[str, str] = {
    "stand": "stand", "sit": "sit", "lie": "lie_down", "kneel": "kneel", "crouch": "crouch", "lean": "lean",
}  # fmt: skip
"""Posture -> the motion that takes it."""
_ASIDE = math.radians(50)
"""A standing person turns the body to what they look at if it is farther aside than this."""
_LET_GO = frozenset({"put_down", "give", "drop", "throw", "pocket", "take", "catch", "pick_up"})
"""Motions after which a thing is in other hands, or in none."""
_HEEDS = frozenset({*SPOKEN, "listen", "look", "idle"})
"""Motions that lead the eyes to their target."""


@dataclass
class _Kept:
    """What a person keeps from shot to shot, and what the script said of it as it was decided."""

    posture: tuple[str, str | None] | None = None
    told_posture: tuple[str, str | None] = ("stand", None)
    holding: tuple[str, ...] | None = None
    told_holding: tuple[str, ...] = ()


def with_poses(shots: Sequence[ShotContext]) -> tuple[ShotContext, ...]:
    """Return the shots of a scene with people as a person decided them, over what the script says.

    A posture and what is in the hands are kept in later shots, until the script changes them.

    Args:
        shots: Of one scene, in order.
    """
    kept: dict[str, _Kept] = {}
    found: list[ShotContext] = []
    for shot in shots:
        people = shot.blocking_decision.people if shot.blocking_decision is not None else {}
        states = tuple(_decided(state, people.get(state.asset_id), kept) for state in shot.states)
        found.append(shot.model_copy(update={"states": _one_holder(states, people, kept)}))
        ends = {state.asset_id: state for state in (*shot.states, *shot.end_states)}
        for asset_id, state in ends.items():
            _go_on(shot, state, people.get(asset_id, PersonMarks()), kept.setdefault(asset_id, _Kept()))
    return tuple(found)


def _decided(state: BodyState, marks: PersonMarks | None, kept: dict[str, _Kept]) -> BodyState:
    """Return a state as a person decided it, in this shot or in one before; what the script changed since counts."""
    before, start = kept.setdefault(state.asset_id, _Kept()), marks.start if marks is not None else None
    if (state.posture, state.support_id) != before.told_posture:
        before.posture = None
    if state.held != before.told_holding:
        before.holding = None
    if start is not None and start.posture is not None:
        before.posture = (start.posture, start.on)
    if start is not None and start.holding is not None:
        before.holding = start.holding
    update: dict[str, object] = {}
    if before.posture is not None and before.posture != (state.posture, state.support_id):
        update |= {"posture": before.posture[0], "support_id": before.posture[1], "spot": None}
    if before.holding is not None:
        update |= {"held": before.holding, "grips": tuple(each for each in state.grips if each[0] in before.holding)}
    if start is not None and start.looking_at is not None:
        way = start.looking_at in WAYS
        update |= {"looking_at": None if way else start.looking_at, "gaze": start.looking_at if way else None}
    return state.model_copy(update=update) if update else state


def _one_holder(
    states: tuple[BodyState, ...], people: Mapping[str, PersonMarks], kept: Mapping[str, _Kept]
) -> tuple[BodyState, ...]:
    """Return states in which a thing that was put into hands is in no others'."""
    given = {prop: name for name, each in kept.items() for prop in each.holding or ()}
    given |= {
        prop: name for name, marks in people.items() for prop in (marks.start and marks.start.holding) or ()
    }  # fmt: skip
    if not given:
        return states

    def own(state: BodyState) -> BodyState:
        held = tuple(prop for prop in state.held if given.get(prop, state.asset_id) == state.asset_id)
        return state if held == state.held else state.model_copy(update={"held": held})

    return tuple(own(state) for state in states)


def _go_on(shot: ShotContext, end: BodyState, marks: PersonMarks, kept: _Kept) -> None:
    """Note what a person keeps after a shot, and what the script says of them as it ends."""
    own = [MOTIONS[action.motion] for action in shot.character_actions if action.asset_id == end.asset_id]
    moves = any(motion.speed or motion.after or motion.key in (*STANDING, *_TAKEN.values()) for motion in own)
    if moves or (marks.end is not None and marks.end.location is not None):
        kept.posture = None
    used = {action.prop_id for action in shot.character_actions if action.motion in _LET_GO}
    if kept.holding is not None and used & {*kept.holding}:
        kept.holding = None
    if marks.end is not None and marks.end.posture is not None:
        kept.posture = (marks.end.posture, marks.end.on)
    if marks.end is not None and marks.end.holding is not None:
        kept.holding = marks.end.holding
    kept.told_posture, kept.told_holding = (end.posture, end.support_id), end.held


def free_of_layout(stage: StageState, marks: Mapping[str, PersonMarks]) -> None:
    """Let people whose posture was decided leave the seats that the layout gave them.

    Args:
        stage: As the shot begins; changed.
        marks: By asset id.
    """
    for asset_id, mark in marks.items():
        if any(place is not None and place.posture is not None for place in (mark.start, mark.end)):
            stage.seats.seated_on.pop(asset_id, None)


def face_what_they_watch(stage: StageState, marks: Mapping[str, PersonMarks]) -> None:
    """Turn standing people to what they look at as the shot begins, and keep them from turning to who speaks.

    Args:
        stage: As the shot begins; changed.
        marks: By asset id.
    """
    for person in stage.people.values():
        start = marks.get(person.asset_id, PersonMarks()).start
        person.watches = start is not None and start.looking_at is not None
        if start is None or start.looking_at is None or start.rotation is not None or not person.upright:
            continue
        there = _place_of(stage, start.looking_at)
        if there is not None and abs(shortest_turn(person.yaw, facing(person.place, there))) > _ASIDE:
            person.yaw = facing(person.place, there)


def keep_looking(sheet: CueSheet, stage: StageState, marks: Mapping[str, PersonMarks]) -> None:
    """Let the eyes of people rest on what a person decided, whoever speaks meanwhile.

    Args:
        sheet: The cues of the shot; changed.
        stage: The people and things.
        marks: By asset id.
    """
    for asset_id, mark in marks.items():
        person, start = stage.people.get(asset_id), mark.start
        if person is None or not person.present or start is None or start.looking_at is None:
            continue
        own = [cue for cue in sheet.cues if cue.asset_id == asset_id and cue.clip in _HEEDS]
        look = _look(stage, person, start.looking_at, 0)
        sheet.cues = [
            cue if cue not in own else cue.model_copy(update={"target_id": look.target_id, "mark": look.mark})
            for cue in sheet.cues
            if cue not in own or look.target_id is not None or cue.clip in SPOKEN
        ]
        sheet.cues.append(look)


def end_as_decided(
    sheet: CueSheet, stage: StageState, ends: Mapping[str, BodyState], marks: Mapping[str, PersonMarks]
) -> None:
    """Let people end the shot in the posture, with the look and with the things in hand that a person decided.

    Args:
        sheet: The cues of the shot; changed.
        stage: The people after their actions; changed.
        ends: How the script has people at the end of the shot, by asset id.
        marks: By asset id.
    """
    for asset_id, mark in marks.items():
        person, end = stage.people.get(asset_id), mark.end
        if person is None or not person.present or end is None or not end.is_posed:
            continue
        state = BodyState(asset_id=asset_id, posture=end.posture or person.posture, support_id=end.on)
        actions = Actions(stage, sheet, {**ends, asset_id: state})
        for action in _actions_of(person, end):
            actions.add_action(action, person, ())
        if end.looking_at is not None:
            there, now = _place_of(stage, end.looking_at), sheet.earliest_start(person)
            if there is not None and person.upright and end.rotation is None:
                now = sheet.turn_to_yaw(person, facing(person.place, there), now)
            sheet.cues.append(_look(stage, person, end.looking_at, round(now * sheet.fps)))
            sheet.finish_action(person, now, now + 0.5)


def missed_poses(marks: Mapping[str, PersonMarks], blocking: Sequence[Blocking]) -> Iterator[Flaw]:
    """Yield a flaw for each posture and each thing in hand that a person decided and the staging could not give.

    Args:
        marks: By asset id.
        blocking: Of the shot as it is staged.
    """
    for each in blocking:
        mark = marks.get(each.start.asset_id, PersonMarks())
        for when, place, there in (("start", mark.start, each.start), ("end", mark.end, each.end)):
            if place is None:
                continue
            name, said = there.asset_id, f"as a person decided for the {when} of the shot"
            if place.posture is not None and (place.posture, place.on) not in _shown(there.posture, there.support_id):
                message = f"{name} does not {place.posture}{f' on {place.on}' if place.on else ''} {said}"
                yield Flaw(kind="mark", subject=name, weight=1.0, message=message)
            for prop in sorted({*(place.holding or ())} - {prop for _, prop in there.held}):
                yield Flaw(kind="mark", subject=name, weight=1.0, message=f"{name} does not hold {prop} {said}")


def _shown(posture: str, support: str | None) -> tuple[tuple[str, str | None], ...]:
    return (posture, support), (posture, None)


def _actions_of(person: StagedPerson, end: PersonPlace) -> Iterator[CharacterAction]:
    """Yield the actions that bring a person to the end of a shot; hands first, so that they still can walk."""
    wanted = end.holding if end.holding is not None else tuple(person.held.values())
    for prop in sorted({*person.held.values()} - {*wanted}):
        yield _action(person, "put_down", prop_id=prop)
    for prop in wanted:
        if not person.hand_of(prop):
            yield _action(person, "pick_up", prop_id=prop)
    if end.posture is not None and (end.posture, end.on) not in _shown(person.posture, person.support):
        yield _action(person, _TAKEN[end.posture], target_id=end.on)


def _action(person: StagedPerson, motion: str, **names: str | None) -> CharacterAction:
    words = {"asset_id": person.asset_id, "action_description": MOTIONS[motion].name, "motion": motion}
    return CharacterAction.model_validate({**words, **names})


def _look(stage: StageState, person: StagedPerson, at: str, frame: int) -> Cue:
    """Return the cue of a look at a person or a thing, or in a direction."""
    words: dict[str, object] = {"asset_id": person.asset_id, "start": frame}
    if at == "closed":
        return Cue.model_validate({**words, "clip": "close_eyes", "lasting": True})
    words |= {"clip": "look", "duration": GLANCE_FRAMES}
    for way in WAYS:
        if way == at:
            return Cue.model_validate({**words, "mark": gaze_mark(person, way)})
    thing = None if at in stage.people else stage.floor.thing(at)
    return Cue.model_validate({**words, "target_id": thing.node_id if thing is not None else at})


def _place_of(stage: StageState, name: str) -> Vec2 | None:
    """Return the floor point of a person, of a thing, or of who holds it; None for a direction."""
    holder = stage.people.get(name) or stage.holder_of(name)
    if holder is not None:
        return holder.place if holder.present else None
    lies = stage.prop_places.get(name)
    thing = None if name in WAYS else stage.floor.thing(name)
    return lies[:2] if lies is not None else thing.location[:2] if thing is not None else None
