"""The moment of a shot that its frame shows: its strongest action at the key pose."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.catalog.motions import FIRST_STRESS, MOTIONS
from storyblender.memory.jobs import PlayedCue
from storyblender.memory.shot_context import CharacterAction, Cue, ShotContext

_REST = 0.55
"""Share of its length at which a shot without action is drawn."""
_FPS = 24
"""Frames per second assumed for motions; other rates are near enough."""
_OPENING = 2
"""First frame after the opening of a shot."""
_ARRIVAL = 0.95
"""Share of a walk to a person at which it is drawn: near the goal, the face turned to them."""
_BENT = ("pick_up", "put_down")
"""Clips that bend the body; in an insert of the hand they are drawn earlier."""
_SPOKEN = ("talk", "shout", "whisper")
"""Clips of speech."""
AT_REST = ("idle", "stand", "look", "listen", "turn", "face")
"""Clips that show no action."""
_ADDED_CLIPS = {"put_down": (), "rise": ("stand", "get_up")}
"""Clips that the crew adds before others -> the other motions of a script that ask for them."""
_RELEASING_CLIPS = ("put_down", "drop", "throw")
"""Clips after which nobody holds the thing."""
_BEGUN = 0.45
"""Share of the time until its key pose at which an action has begun."""


def board_frame(shot: ShotContext, played: Sequence[PlayedCue] = ()) -> int:
    """Return the frame from the start of a shot that the storyboard shows: the stored one, else its story moment.

    Args:
        shot: The shot with its cues.
        played: The cues as the engine played them; needed only where no frame is stored.
    """
    return shot.frame if shot.frame is not None else story_moment(shot, played)


def story_moment(shot: ShotContext, played: Sequence[PlayedCue] = ()) -> int:
    """Return the frame that shows the story of a shot: its strongest action at its key pose, the last of several.

    The script or the user may ask for the start or the end of the shot; if they ask it of one line, it holds for the
    actions of that line. If the subjects of a shot do nothing, it shows what others do.

    Args:
        shot: The shot with its cues.
        played: The cues as the engine played them; if empty, the cues' own times are used.
    """
    focus = set(shot.camera_instruction.focus_on_ids)
    last = max(0, shot.duration - 1)
    if (named := _named_moment(shot, played)) is not None:
        return min(last, named)
    others = any(action.line_index not in (None, shot.moment_line) for action in shot.character_actions)
    moment = None if shot.moment_line is not None and others else shot.moment
    if moment == "start":
        return min(_OPENING, last)
    done = [cue for cue in shot.cues if cue.start < last and not is_at_rest(cue)]
    cues = [cue for cue in done if cue.asset_id in focus] or [cue for cue in done if cue.asset_id in shot.on_stage]
    if not cues:
        return last if moment == "end" else round(last * _REST)
    if moment == "end":
        cue = max(cues, key=lambda item: item.start)
        if MOTIONS[cue.clip].after not in (None, "stand"):
            return last
    else:
        cue = max(cues, key=lambda item: (_cue_rank(item, shot) - _is_prelude(item, cues, shot), item.start))
    motion = MOTIONS[cue.clip]
    together = len(focus & set(shot.on_stage)) > 1 and shot.camera_instruction.kind != "establishing"
    arrives = motion.speed is not None and (together or moment == "end")
    insert = cue.clip in _BENT and shot.camera_instruction.kind == "insert"
    share = _ARRIVAL if arrives else 0.5 if insert else motion.telling
    start, length = cue_span(cue, shot, played)
    told = round(length * share)
    return min(last, start + (min(told, round(FIRST_STRESS * _FPS)) if cue.clip in _SPOKEN else told))


def is_at_rest(cue: Cue) -> bool:
    """Return whether a cue shows no action; a recorded one does."""
    return cue.clip in AT_REST and cue.mocap is None


def _named_moment(shot: ShotContext, played: Sequence[PlayedCue]) -> int | None:
    """Return the frame of the action that the script names the moment of; None if it names none that is played."""
    named = [action for action in shot.character_actions if action.line_index == shot.moment_line]
    cues = [cue for action in named for cue in cues_of(action, shot) if not is_at_rest(cue)]
    if shot.moment is None or shot.moment_line is None or not cues:
        return None
    if shot.moment == "middle":
        cue = max(cues, key=lambda item: (_cue_rank(item, shot), item.start))
    else:
        cue = min(cues, key=lambda item: item.start) if shot.moment == "start" else max(cues, key=lambda c: c.start)
    motion = MOTIONS[cue.clip]
    share = _ARRIVAL if motion.speed is not None and shot.moment == "end" else motion.telling
    start, length = cue_span(cue, shot, played)
    return start + round(length * share * (_BEGUN if shot.moment == "start" else 1.0))


def cues_of(action: CharacterAction, shot: ShotContext) -> list[Cue]:
    """Return the cues that play an action.

    They have its clip; else they handle its thing or its target; else they are all that the person does, if this is
    their only action in the shot.

    Args:
        action: The action in the script.
        shot: The staged shot.
    """
    own = [cue for cue in shot.cues if cue.asset_id == action.asset_id]
    done = [cue for cue in own if not is_at_rest(cue) and cue.clip not in _SPOKEN]
    about = {action.prop_id, action.target_id} - {None, action.asset_id}
    played = [cue for cue in own if cue.clip == action.motion]
    played = played or [cue for cue in done if about & {cue.prop_id, cue.target_id}]
    told = {each.motion for each in shot.character_actions if each.asset_id == action.asset_id}
    alone = told <= {action.motion, *AT_REST, *_SPOKEN}
    return played or [cue for cue in done if alone and MOTIONS[cue.clip].speed is None]


def cue_span(cue: Cue, shot: ShotContext, played: Sequence[PlayedCue] = ()) -> tuple[int, int]:
    """Return the start frame and the length in frames of a cue, without the steps and turns before it.

    Args:
        cue: The cue.
        shot: Its shot.
        played: The cues as the engine played them; may be empty.
    """
    length = _cue_length(cue, shot)
    name = (cue.asset_id, cue.clip, cue.start)
    real = next((each for each in played if (each.asset_id, each.clip, each.start) == name), None)
    if real is None:
        return cue.start, length
    if MOTIONS[cue.clip].speed is not None or cue.duration is not None:
        return real.began, max(1, real.over - real.began)
    return max(real.began, real.over - length), length


def _cue_length(cue: Cue, shot: ShotContext) -> int:
    """Return the length of a cue in frames: its own, else until the same person's next cue."""
    if cue.duration is not None:
        return cue.duration
    after = [item.start for item in shot.cues if item.asset_id == cue.asset_id and item.start > cue.start]
    until, motion = min([*after, shot.duration]) - cue.start, MOTIONS[cue.clip]
    stays = motion.speed is not None or (motion.reach == "thing" and motion.after in ("sit", "lie"))
    return until if stays else min(until, round(motion.seconds * _FPS))


def _is_prelude(cue: Cue, cues: Sequence[Cue], shot: ShotContext) -> bool:
    """Tell whether a cue only picks up a thing that the person then uses, or only frees a hand."""
    after = [each for each in cues if each.asset_id == cue.asset_id and each.start > cue.start]
    if cue.clip in _ADDED_CLIPS:
        told = {action.motion for action in shot.character_actions if action.asset_id == cue.asset_id}
        return bool(after) and not told & {cue.clip, *_ADDED_CLIPS[cue.clip]}
    return cue.clip == "pick_up" and any(
        each.prop_id == cue.prop_id and each.clip not in _RELEASING_CLIPS for each in after
    )


def _cue_rank(cue: Cue, shot: ShotContext) -> int:
    """Return the rank of a cue: actions on people 3; other actions, signs and shouts 2; words 1; walks 0.

    An activity that goes on since before the shot, such as reading, counts as words.
    """
    motion = MOTIONS[cue.clip]
    if cue.mocap is not None:
        return 2
    if motion.speed is not None:
        return 0
    if cue.clip == "shout":
        return 2
    goes_on = cue.lasting and not cue.start
    if goes_on or (motion.reach == "self" and motion.after is None and not motion.hands):
        return 1
    to_a_person = cue.target_id in shot.on_stage and cue.target_id != cue.asset_id
    return 3 if to_a_person and motion.reach != "self" else 2
