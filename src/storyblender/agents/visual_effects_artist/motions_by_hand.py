"""Motions and lines that a person added, moved in time or took away: they lie over what the script has people do."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from storyblender.agents.visual_effects_artist.actions import Actions
from storyblender.agents.visual_effects_artist.cue_sheet import CueSheet
from storyblender.agents.visual_effects_artist.speeches import SPOKEN
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.motions import MOCAP, MOTIONS
from storyblender.memory.scene_decision import DecidedLine, DecidedMotion, PersonMarks
from storyblender.memory.shot_context import BodyState, CharacterAction, Flaw

_LATE = 2.0
"""Seconds after the one that was asked for, in which the person turns to what a motion is aimed at."""


def is_left_out(action: CharacterAction, marks: Mapping[str, PersonMarks]) -> bool:
    """Return whether a person took an action away.

    Args:
        action: Of the script.
        marks: What was decided, by asset id.
    """
    own = marks.get(action.asset_id, PersonMarks()).motions
    return action.motion in own and own[action.motion] is None


def second_of(action: CharacterAction, marks: Mapping[str, PersonMarks]) -> float | None:
    """Return the second of the shot from which an action is to begin; None where the crew decides.

    Args:
        action: Of the script.
        marks: What was decided, by asset id.
    """
    own = marks.get(action.asset_id, PersonMarks())
    line, told = line_of(action, own), own.motions.get(action.motion)
    if line is not None and line.at is not None:
        return line.at
    return told.at if told is not None else None


def line_of(action: CharacterAction, own: PersonMarks) -> DecidedLine | None:
    """Return what was decided about the line that an action says; None if nothing was, or it says none.

    Args:
        action: Of the script.
        own: What was decided about who does it.
    """
    if action.motion not in SPOKEN or action.line_index is None:
        return None
    return own.lines.get(action.line_index + 1)


def do_added(
    sheet: CueSheet,
    stage: StageState,
    ends: Mapping[str, BodyState],
    marks: Mapping[str, PersonMarks],
    scripted: Sequence[CharacterAction],
) -> None:
    """Write the motions that the script does not have, each from its second on, or after what the person does.

    Args:
        sheet: The cues of the shot; changed.
        stage: The people after their actions; changed.
        ends: How the script has people at the end of the shot, by asset id.
        marks: What was decided, by asset id.
        scripted: The actions of the shot.
    """
    actions, there = Actions(stage, sheet, ends), {(each.asset_id, each.motion) for each in scripted}
    for asset_id, mark in marks.items():
        person = stage.people.get(asset_id)
        if person is None or not person.present:
            continue
        for key, motion in mark.motions.items():
            if motion is None or (asset_id, key) in there:
                continue
            latest = sheet.clock
            sheet.clock = latest if motion.at is None else motion.at
            said = {"asset_id": asset_id, "action_description": _called(key, motion), "motion": key}
            if motion.mocap is not None:
                length = motion.seconds or motion.mocap.seconds
                said |= {"motion": MOCAP, "mocap": motion.mocap.model_copy(update={"seconds": length})}
            action = CharacterAction.model_validate({**said, "target_id": motion.target, "prop_id": motion.prop})
            actions.add_action(action, person, ())
            sheet.clock = max(sheet.clock, latest)


def _called(key: str, motion: DecidedMotion) -> str:
    """Return what a motion is called."""
    return f"move as in {motion.mocap.name}" if motion.mocap is not None else MOTIONS[key].name


def stretch(sheet: CueSheet, marks: Mapping[str, PersonMarks]) -> None:
    """Give motions the length that was decided, where they can have another one.

    Args:
        sheet: The cues of the shot; changed.
        marks: What was decided, by asset id.
    """
    for index, cue in enumerate(sheet.cues):
        told = marks.get(cue.asset_id, PersonMarks()).motions.get(cue.clip)
        if told is not None and told.seconds is not None and MOTIONS[cue.clip].stretches:
            frames = max(1, round(told.seconds * sheet.fps))
            sheet.cues[index] = cue.model_copy(update={"duration": frames})


def missed_motions(sheet: CueSheet, marks: Mapping[str, PersonMarks]) -> Iterator[Flaw]:
    """Yield a flaw for each motion that was asked for and nobody does, or that begins later than asked.

    Args:
        sheet: The cues of the shot.
        marks: What was decided, by asset id.
    """
    for asset_id, mark in marks.items():
        for key, motion in mark.motions.items():
            played = MOCAP if motion is not None and motion.mocap is not None else key
            own = motion.mocap.digest if motion is not None and motion.mocap is not None else None
            begins = [
                cue.start / sheet.fps
                for cue in sheet.cues
                if (cue.asset_id, cue.clip) == (asset_id, played) and own in (None, cue.mocap)
            ]
            if motion is None or (begins and (motion.at is None or min(begins) <= motion.at + _LATE)):
                continue
            late = f" before {min(begins):.1f} s" if begins else ""
            message = f"{asset_id} does not {_called(key, motion)}{late}, as a person decided"
            yield Flaw(kind="mark", subject=asset_id, weight=1.0, message=message)
        said = [cue.start / sheet.fps for cue in sheet.cues if cue.asset_id == asset_id and cue.clip in SPOKEN]
        for number, line in mark.lines.items():
            if line is None or line.at is None or any(abs(begins - line.at) <= _LATE for begins in said):
                continue
            message = f"{asset_id} does not say line {number} at {line.at:g} s, as a person decided"
            yield Flaw(kind="mark", subject=asset_id, weight=1.0, message=message)
