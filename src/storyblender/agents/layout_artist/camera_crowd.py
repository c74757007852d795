"""Extras before the subjects of a picture: they are out of it, as on a film stage they are waved aside."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.agents.layout_artist.camera_start import compose_take
from storyblender.agents.layout_artist.crowd_places import crowds_of
from storyblender.catalog.bystanders import BYSTANDER
from storyblender.geometry.framing import project
from storyblender.geometry.orbit import Orbit
from storyblender.memory.base import Vec3

_BODY = 0.27
"""Metres from the middle of a person to their arm."""
_MIDDLE = 0.12
"""Share of the width on either side of the middle that belongs to the subject."""


def compose_without_crowd(view: CameraOperatorView, turn: float = 0.0, rise: float = 0.0) -> CameraOperatorDraft:
    """Return the take from a side without the people of a crowd before its subjects.

    Args:
        view: The shot.
        turn: Degrees around the subjects from the first camera.
        rise: Degrees above it.
    """
    take = compose_take(view, turn, rise)
    gone = (*take.hidden, *find_crowd_in_front(view, take.camera))
    return replace(take, hidden=tuple(dict.fromkeys(gone)))


def find_crowd_in_front(view: CameraOperatorView, camera: Orbit) -> list[str]:
    """Return the node_ids of people of a crowd before the subjects, or large in the middle of their picture.

    These are figures of the background and members of a crowd who have no part in the shot; a picture of a place
    keeps them all.

    Args:
        view: The shot.
        camera: The camera.
    """
    subjects = [(each.base, each.crown) for each in view.people]
    subjects += [((box.x, box.y, box.z), (box.x, box.y, box.top)) for box in view.things]
    if not subjects or view.instruction.kind == "establishing":
        return []
    members = {each for crowd in crowds_of([figure.node_id for figure in view.story_moment.figures]) for each in crowd}
    extras = {
        node: ((box.x, box.y, box.z), (box.x, box.y, box.top))
        for node, box in view.removable_props.items()
        if node.startswith(BYSTANDER)
    }
    extras |= {
        figure.node_id: (figure.base, figure.crown)
        for figure in view.story_moment.figures
        if figure.node_id in members and figure.node_id in view.strangers
    }
    wanted = [_upright(camera, *each) for each in subjects]
    deepest, largest = max(each.depth for each in wanted), max(each.tall for each in wanted)
    gone: list[str] = []
    for node, ends in extras.items():
        extra = _upright(camera, *ends)
        before = [each for each in wanted if 0 < extra.depth < each.depth]
        covers = any(abs(extra.x - each.x) < extra.half + each.half for each in before)
        leads = 0 < extra.depth < deepest and extra.tall > largest and abs(extra.x - 0.5) < _MIDDLE + extra.half
        if covers or leads:
            gone.append(node)
    return gone


class _Upright(NamedTuple):
    """Someone or something in a picture: middle and half width in widths, height in heights, depth in metres."""

    x: float
    half: float
    tall: float
    depth: float


def _upright(camera: Orbit, foot: Vec3, top: Vec3) -> _Upright:
    """Return how a person between two world points is in the picture."""
    middle = np.add(foot, top) / 2
    points = [foot, top, middle - camera.axes[:, 0] * _BODY, middle + camera.axes[:, 0] * _BODY]
    screen, depth = project(camera, points)
    return _Upright(
        float(screen[2:, 0].mean()), float(np.ptp(screen[2:, 0])) / 2, float(np.ptp(screen[:2, 1])), float(depth.mean())
    )
