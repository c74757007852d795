"""The camera of a shot that is staged again stays where it was, if it still shows what the shot is meant to show."""

from __future__ import annotations

from collections.abc import Iterator

from storyblender.agents.layout_artist.camera_operator import state_of
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.agents.layout_artist.camera_scout import with_hidden
from storyblender.agents.layout_artist.camera_start import nodes_in_the_way
from storyblender.geometry.camera_path import camera_at, orbit_of
from storyblender.memory.shot_context import CameraState
from storyblender.reflection import Critic

_WORSE = 0.5
"""Points of ten from which a fault is minded that the camera did not have before, or had less."""

_PLAIN = (
    "inside", "below_floor", "out_of_frame", "face_out", "hidden", "face_hidden", "face_away", "missing", "beheaded",
    "foreground", "line", "jump",
)  # fmt: skip
"""Kinds of faults that anybody sees; one of them is told before those of composition."""


def keep_camera(
    view: CameraOperatorView, former: CameraState, critic: Critic[CameraOperatorView, CameraOperatorDraft]
) -> tuple[CameraState | None, str]:
    """Return the camera that a shot had, as it is judged now; or why it has to go, as the end of a sentence.

    Args:
        view: The shot as it is staged now.
        former: Its camera before that.
        critic: Of the Camera Operator.
    """
    if view.instruction.kind == "pov":
        return None, f"it sees with the eyes of {view.instruction.pov_id}"
    take = _take_of(view, former)
    in_the_way = nodes_in_the_way(view, (take.start, take.camera, take.end))
    minded = {(flaw.kind, flaw.subject): flaw.weight for flaw in former.residual}
    why = ""
    for tried in _with_less_hidden(view, take, in_the_way, former.hidden_node_ids):
        critique = critic.judge(tried, view)
        new = [each for each in critique.faults if each.severity > minded.get((each.kind, each.subject), 0.0) + _WORSE]
        if not new:
            return state_of(view, tried, critique), ""
        worst = min(new, key=lambda each: (each.kind not in _PLAIN, -each.severity))
        why = f"in the picture of the one before, {worst.message}"
    return None, why


def _take_of(view: CameraOperatorView, state: CameraState) -> CameraOperatorDraft:
    """Return a camera as a take of its shot, with nothing hidden."""
    first, last = state.poses[0], state.poses[-1]
    final = max(view.duration - 1, 1)
    span = (first.frame / final, last.frame / final) if first is not last else (0.0, 1.0)
    moment = view.story_moment.frame
    return CameraOperatorDraft(
        camera=camera_at(state, moment, view.film),
        start=orbit_of(first, view.film),
        end=orbit_of(last, view.film),
        span=span,
    )


def _with_less_hidden(
    view: CameraOperatorView, take: CameraOperatorDraft, in_the_way: list[str], hidden: tuple[str, ...]
) -> Iterator[CameraOperatorDraft]:
    """Yield a take that shows the things which nothing takes away any more, then one that hides what it did before."""
    bare = with_hidden(take, [*in_the_way, *(node for node in hidden if node not in view.removable_props)])
    yield bare
    if {*hidden} - {*bare.hidden}:
        yield with_hidden(bare, hidden)
