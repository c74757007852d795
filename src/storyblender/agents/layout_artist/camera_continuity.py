"""What the shots of a scene have to match: the shot before, the reverse shot, the side of the line."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from storyblender.agents.layout_artist.camera_cuts import find_cut_faults
from storyblender.agents.layout_artist.camera_operator import camera_side
from storyblender.agents.layout_artist.camera_operator_view import (
    CameraOperatorDraft,
    CameraOperatorView,
    EarlierShot,
    interpolate_cameras,
)
from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.continuity import has_new_line
from storyblender.memory.base import Vec3
from storyblender.memory.shot_context import CameraState, Flaw, ShotContext

CUT_KINDS = ("line", "jump", "eyeline")
"""Kinds of faults that a shot may get or lose by the camera of another shot."""
_ANSWERS = ("single", "reaction", "ots")
"""Kinds of shots that have a reverse."""
Faces = tuple[Vec3, Vec3]
Pair = tuple[str, str]


class SceneCuts:
    """Collects what later shots have to match: call `match` before a camera is set and `remember` after it."""

    def __init__(self) -> None:
        self._previous: EarlierShot | None = None
        self._sides: dict[Pair, int] = {}
        self._answered: dict[Pair, EarlierShot] = {}
        self._lines: dict[Pair, Faces] = {}

    def match(self, shot: ShotContext, view: CameraOperatorView) -> CameraOperatorView:
        """Return a shot's view completed by what its camera has to match.

        That is the shots before it, the side of the 180-degree line, and the last single of the other person,
        which a reverse single mirrors.

        Args:
            shot: The next shot of the scene.
            view: What the Camera Operator knows of the shot.
        """
        view = replace(view, previous=self._previous)
        axis = shot.camera_instruction.axis
        if axis is None or view.axis is None:
            return view
        faces = (view.axis[0].face, view.axis[1].face)
        if has_new_line(self._lines.setdefault(axis, faces), faces):
            self._sides.pop(axis, None)
            self._answered.pop(axis, None)
        self._lines[axis] = faces
        last = self._answered.get(axis)
        had_last_word = last is not None and last.instruction.focus_on_ids != shot.camera_instruction.focus_on_ids
        return replace(view, side=self._sides.get(axis, 0), reverse=last if had_last_word else None)

    def remember(self, shot: ShotContext, view: CameraOperatorView, state: CameraState) -> None:
        """Remember the camera of a shot for the shots after it.

        Args:
            shot: The shot that was matched last.
            view: Its view, as `match` returned it.
            state: Its camera.
        """
        instruction = shot.camera_instruction
        self._previous = EarlierShot(instruction, state, view.subjects(view.moments[-1]) if view.moments else ())
        if instruction.axis is not None:
            self._sides[instruction.axis] = self._sides.get(instruction.axis) or camera_side(view, state)
            if instruction.kind in _ANSWERS:
                self._answered[instruction.axis] = self._previous


def judge_cuts(scene: Iterable[tuple[ShotContext, CameraOperatorView]]) -> Mapping[int, CameraState]:
    """Return the cameras of a scene by shot id, with the flaws that their cuts have now.

    A stored camera keeps the flaws of its own time; the camera before it may have changed since.

    Args:
        scene: All shots in order, with their projections of the graph.
    """
    going, states = SceneCuts(), dict[int, CameraState]()
    for shot, alone in scene:
        state, view = shot.camera, going.match(shot, alone)
        if state is None:
            continue
        going.remember(shot, view, state)
        ends = [orbit_of(pose, view.film) for pose in (state.poses[0], state.poses[-1])]
        take = CameraOperatorDraft(interpolate_cameras(ends[0], ends[1], 0.5), ends[0], ends[1], state.hidden_node_ids)
        found = find_cut_faults(view, take) if view.moments else []
        now = [Flaw(kind=each.kind, subject=each.subject, weight=each.severity, message=each.message) for each in found]
        kept = [flaw for flaw in state.residual if flaw.kind not in CUT_KINDS]
        states[shot.shot_id] = state.model_copy(update={"residual": (*kept, *now)})
    return states
