"""The registry of clips and the parts of the body they use."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from storyblender.blender.motion.motion_stage import MotionStage, StagedCue
from storyblender.blender.motion.performer import Performer
from storyblender.blender.motion.skeleton import SIDES

Play = Callable[[MotionStage, Performer, StagedCue], float]
"""A clip: sets keys on the channels of the performer for a cue and returns the second at which it is over.

It takes the stage of the shot, the person who acts, and the cue, with seconds from the start of the shot (before 0 for
a motion under way at the first frame) and with target and prop on this stage. A cue that cannot be performed raises
nothing; it may be recorded by ``MotionStage.report``.
"""


@dataclass(frozen=True)
class Clip:
    """A motion.

    Attributes:
        key: Its name in ``catalog.motions``.
        uses: ``body`` (root, legs, trunk), ``hand`` (the cue's), ``hands`` (both), ``head``. A clip waits until these
            are free, and cancels what was planned later for the hands it uses.
        play: The function.
    """

    key: str
    uses: tuple[str, ...]
    play: Play

    def parts(self, side: str) -> tuple[str, ...]:
        """Return the keys of ``Performer.free`` that the clip needs when ``side`` acts."""
        names: list[str] = []
        for use in self.uses:
            names += list(SIDES) if use == "hands" else [side] if use == "hand" else [use]
        return tuple(names)


CLIPS: dict[str, Clip] = {}


def clip(key: str, *uses: str) -> Callable[[Play], Play]:
    """Return a decorator that registers a clip by its key in ``catalog.motions`` and what it uses; see ``Clip``."""

    def register(play: Play) -> Play:
        CLIPS[key] = Clip(key, uses, play)
        return play

    return register


def play(stage: MotionStage, who: Performer, key: str, cue: StagedCue) -> float:
    """Play a clip as soon as the parts it uses are free, and keep them until it is over; return that second.

    Args:
        stage: The stage of the shot.
        who: The person.
        key: A key of ``CLIPS``.
        cue: Gives the earliest start, the acting hand and what else the clip needs.

    Raises:
        KeyError: No clip has this key.
    """
    chosen = CLIPS[key]
    parts = chosen.parts(cue.side)
    start = max([cue.start, *(who.free[part] for part in parts)])
    for side in SIDES:
        if side in parts:
            who.hands[side].remove_from(start)
    end = chosen.play(stage, who, replace(cue, start=start))
    stage.played[who.asset_id, key, cue.frame] = (start, end)
    for part in parts:
        who.free[part] = max(who.free[part], end)
    return end
