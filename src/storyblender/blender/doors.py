"""Swinging doors: open for people who pass or open them, shut behind them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import bpy
import numpy as np
from numpy.typing import NDArray

from storyblender.blender.motion.plan import Performance
from storyblender.catalog.openings import OpeningPlace
from storyblender.memory.base import Vec2
from storyblender.memory.shot_context import Cue

PASSING = 0.95
"""Metres from the doorway within which a door is open for a walker."""
WALKING = 1.0
"""Least metres a person travels in a shot to count as a walker."""
SWING = 0.8
"""Seconds of a full swing."""
GRASP = 0.9
"""Seconds from the start of an ``open`` or ``close`` cue to the movement of the leaf, if no hand was solved for it."""


class Door:
    """One door over the scene's timeline.

    Args:
        place: The doorway.
        fps: Frames per second.
        left_open: Whether an earlier scene left it open; None keeps the set's state.
    """

    def __init__(self, place: OpeningPlace, fps: int, left_open: bool | None = None) -> None:
        self.name, self.centre, self.fps = place.opening.name, place.location[:2], fps
        self.built_open = place.opening.state == "open"
        self.left_open = self.built_open if left_open is None else left_open
        """Whether it stays open by itself."""
        self.amounts: list[float] = []
        """Opening of the leaf by frame, 0..1."""

    def play(self, performance: Performance | None, cues: Sequence[Cue], frames: int) -> None:
        """Add one shot to the door's movement.

        Args:
            performance: What the people of the shot do, as solved; its frame 0 is the shot's first. None where that is
                not known: nobody passes.
            cues: Of the shot; those that open or close this door count.
            frames: Length of the shot.
        """
        passed = self._frames_passed(performance, frames)
        changes = {
            self._grasp_frame(performance, cue): cue.clip == "open"
            for cue in sorted(cues, key=lambda cue: cue.start)
            if cue.target_id == self.name and cue.clip in ("open", "close")
        }
        for frame in range(frames):
            self.left_open = changes.get(frame, self.left_open)
            wanted = 1.0 if self.left_open or passed[frame] else 0.0
            amount = self.amounts[-1] if self.amounts and frame else wanted
            step = 1 / (SWING * self.fps)
            self.amounts.append(min(wanted, amount + step) if wanted > amount else max(wanted, amount - step))

    def _grasp_frame(self, performance: Performance | None, cue: Cue) -> int:
        """Return the frame at which the hand of an ``open`` or ``close`` cue begins to move the leaf."""
        grasps = performance.grasps if performance is not None else {}
        return round(grasps.get((cue.asset_id, cue.start), cue.start / self.fps + GRASP) * self.fps)

    def _frames_passed(self, performance: Performance | None, frames: int) -> NDArray[np.bool_]:
        """Return for each frame whether a person passes the doorway."""
        passed = np.zeros(frames, bool)
        if performance is None:
            return passed
        for track in performance.people.values():
            places = track.root[:, :2]
            if np.hypot(*(places - places[0]).T).max() < WALKING:
                continue
            near = np.hypot(*(places - np.asarray(self.centre)).T) < PASSING
            passed |= np.interp(np.arange(frames), performance.frames, near.astype(float)) > 0.5
        return passed

    def key_amounts(self) -> Iterator[Vec2]:
        """Yield (frame, amount) wherever the leaf's movement begins, ends or changes; frames from 0, amounts 0..1."""
        amounts = self.amounts
        for frame, amount in enumerate(amounts):
            before, after = amounts[max(0, frame - 1)], amounts[min(len(amounts) - 1, frame + 1)]
            if frame in (0, len(amounts) - 1) or not math.isclose(amount - before, after - amount, abs_tol=1e-9):
                yield frame, amount


def swing_doors(doors: Sequence[Door], leaves: Sequence[bpy.types.Object]) -> None:
    """Key the leaves that ``build_set`` made, in place of earlier keys; doors that never move get no keys.

    Args:
        doors: Played from the scene's first frame on.
        leaves: Objects with the custom property ``opening``.
    """
    by_name = {door.name: door for door in doors if {*door.amounts} - {float(door.built_open)}}
    built_open = {door.name: door.built_open for door in doors}
    for leaf in leaves:
        if leaf.animation_data is not None:
            leaf.animation_data_clear()
            leaf.rotation_euler[2] = leaf["shut"] + leaf["swing"] * built_open[leaf["opening"]]
        door = by_name.get(leaf.get("opening", ""))
        if door is None:
            continue
        for frame, amount in door.key_amounts():
            leaf.rotation_euler[2] = leaf["shut"] + leaf["swing"] * amount
            leaf.keyframe_insert("rotation_euler", index=2, frame=frame + 1)
        for bag in leaf.animation_data.action.layers[0].strips[0].channelbags:
            for curve in bag.fcurves:
                for key in curve.keyframe_points:
                    key.interpolation = "LINEAR"
