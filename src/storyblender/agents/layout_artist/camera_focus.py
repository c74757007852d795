"""What the lens of a shot is focused on, and at which f-number: told things stay sharp, unless the script says less.

Without a word of the script or of a person only tight shots have a depth of field: it parts a face from what is behind
it. The f-number is then closed until everything that the shot is about is sharp.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView
from storyblender.geometry.boxes import Box, corners
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import project
from storyblender.look.optics import Lens, stopped_down
from storyblender.memory.base import Vec3
from storyblender.memory.shot_context import CameraState, Flaw, FocusKey
from storyblender.memory.shot_sizes import SIZES, TIGHT

_EYES = 0.4
"""Head heights that the eyes lie before the middle of the head."""
_SEEN_APART = 2.0
"""f-number of a shot that is focused on something by order: open enough that it shows."""
_STILL = 0.1
"""Metres that a head may sway while the focus stays where it is; a lens that follows would make all else breathe."""
_RACK = (8, 30)
"""Least and most frames of a rack focus; between them it takes a third of the shot."""


def with_focus(view: CameraOperatorView, state: CameraState) -> CameraState:
    """Return the camera of a shot with its f-number and its focus.

    Args:
        view: The shot.
        state: Its camera, solved.
    """
    wanted = view.instruction
    ordered = wanted.f_number is not None or wanted.focus is not None or wanted.focus_to is not None
    if not ordered and (wanted.size not in TIGHT or wanted.kind in ("pov", "establishing")):
        return state
    unknown = [each for each in (wanted.focus, wanted.focus_to) if each and not _track(view, view.node(each))]
    flaws = tuple(Flaw(kind="focus", subject=each, weight=1.0, message=f"{each} is not in the shot to be focused on")
                  for each in unknown)  # fmt: skip
    state = state.model_copy(update={"residual": (*state.residual, *flaws)})
    first = _focused_on(view, wanted.focus)
    if first is None:
        return state
    second = view.node(wanted.focus_to) if wanted.focus_to and wanted.focus_to not in unknown else None
    keys = _racked(view, first, second) if second and second != first else _kept_on(view, first)
    if not ordered:
        f_number = _open_to(view, state, keys)
        return state if f_number is None else state.model_copy(update={"f_number": f_number, "focus": keys})
    opened = wanted.f_number or min(SIZES[wanted.size].f_number, _SEEN_APART)
    return state.model_copy(update={"f_number": opened, "focus": keys})


def _focused_on(view: CameraOperatorView, wanted: str | None) -> str | None:
    """Return the node the lens is on: the wanted one if it is there, else the first subject that is; "" is a detail."""
    if view.detail is not None and wanted is None:
        return ""
    nodes = (*([view.node(wanted)] if wanted else ()), *view.focus, *view.named, *view.in_frame)
    return next((node for node in nodes if _track(view, node)), None)


def _track(view: CameraOperatorView, node: str) -> list[tuple[int, Vec3]]:
    """Return frames and world points of what the lens is focused on: eyes, or the middle of a thing."""
    if node == "" and view.detail is not None:
        return [(view.story_moment.frame, _middle(view.detail))]
    figures = [(moment.frame, figure) for moment in view.moments if (figure := moment.figure(node)) is not None]
    if figures:
        return [(frame, _eyes(figure.face, figure.forward, figure.head)) for frame, figure in figures]
    return [(view.story_moment.frame, _middle(view.props[node]))] if node in view.props else []


def _eyes(face: Vec3, forward: Vec3, head: float) -> Vec3:
    x, y, z = (at + _EYES * head * way for at, way in zip(face, forward, strict=True))
    return x, y, z


def _middle(box: Box) -> Vec3:
    return box.x, box.y, box.z + box.height / 2


def _at(track: Sequence[tuple[int, Vec3]], frame: int) -> Vec3:
    """Return where a subject is at a frame, on straight lines between the known ones."""
    frames, points = zip(*track, strict=True)
    x, y, z = (round(float(np.interp(frame, frames, axis)), 4) for axis in zip(*points, strict=True))
    return x, y, z


def _kept_on(view: CameraOperatorView, node: str, first: int = 0, last: int | None = None) -> tuple[FocusKey, ...]:
    """Return the keys that hold the focus on one subject, from the first frame to the last."""
    last = max(view.duration - 1, 0) if last is None else last
    track = _track(view, node)
    frames = sorted({first, *(frame for frame, _ in track if first < frame < last), last})
    keys = tuple(FocusKey(frame=frame, point=_at(track, frame), node_id=node) for frame in frames)
    held = FocusKey(point=_at(track, view.story_moment.frame), node_id=node)
    still = all(np.abs(np.subtract(key.point, held.point)).max() < _STILL for key in keys)
    return (held,) if still and (first, last) == (0, max(view.duration - 1, 0)) else keys


def _racked(view: CameraOperatorView, first: str, second: str) -> tuple[FocusKey, ...]:
    """Return the keys of a rack focus: before or after the moment that is drawn, where there is more time for it."""
    end, drawn = max(view.duration - 1, 1), view.story_moment.frame
    time = min(max(round(view.duration / 3), _RACK[0]), _RACK[1], end)
    begins, ends = (0, drawn) if drawn > end / 2 else (drawn, end)
    time = min(time, max(ends - begins, 1))
    start = begins + (ends - begins - time) // 2
    return (*_kept_on(view, first, 0, start), *_kept_on(view, second, start + time, end))


def _open_to(view: CameraOperatorView, state: CameraState, keys: Sequence[FocusKey]) -> float | None:
    """Return the f-number at which everything that the shot is about is sharp; None where no stop will do."""
    own = [node for node in dict.fromkeys((*view.focus, *view.used)) if node != keys[0].node_id]
    own += [thing for who in view.focus for thing in view.carried.get(who, ())]
    own = [node for node in own if view.over is None or node != view.over.node_id]
    opened: float | None = SIZES[view.instruction.size].f_number
    for moment in view.moments:
        camera = camera_at(state, moment.frame, view.film)
        track = [(key.frame, key.point) for key in keys]
        focus = float(project(camera, [_at(track, moment.frame)])[1][0])
        depths: list[float] = []
        for node in own:
            figure, box = moment.figure(node), view.props.get(node)
            points = [_eyes(figure.face, figure.forward, figure.head)] if figure else corners(box) if box else []
            if not len(points):
                continue
            places, away = project(camera, points)
            inside = (away > 0) & (places > 0).all(axis=1) & (places < 1).all(axis=1)
            depths += away[inside].tolist()
        if focus <= 0:
            return None
        lens = stopped_down(Lens(camera.lens, opened, focus, state.sensor_width), depths)
        if lens is None:
            return None
        opened = lens.f_number
    return opened
