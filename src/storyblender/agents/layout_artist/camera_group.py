"""Several people in one picture: from where they are taken, how far away, and what is done where the room is short."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView
from storyblender.agents.layout_artist.camera_room import BEFORE_WALL, VOID, outside, reach_back
from storyblender.agents.layout_artist.wild_walls import taken_away
from storyblender.geometry import framing
from storyblender.geometry.boxes import wrap_angle
from storyblender.geometry.continuity import side_of_line
from storyblender.geometry.framing import Figure
from storyblender.geometry.orbit import Orbit
from storyblender.memory.shot_sizes import SIZES, TIGHT

_SMALLEST = 0.6
"""How small heads may get, of what the size wants, so that the picture holds all of a group's walks."""
_OFF_MIDDLE = 0.1
"""Share of the width that a group may be off the middle when it is drawn."""
_EDGE = 0.03
"""Share of the picture at its edges in which a face is not held."""


def grouped(view: CameraOperatorView, lens: float, azimuth: float, elevation: float) -> Orbit:
    """Return the camera that holds the focus people wherever they go, or where they are if that is too far."""
    size = view.instruction.size
    whole = framing.frame_group(view.film, view.stages, size, azimuth, elevation, lens)
    if view.people[0].head / whole.frame_height > _SMALLEST * SIZES[size].head and _centred(view, whole):
        return whole
    return framing.frame_group(view.film, view.people, size, azimuth, elevation, lens)


def inside(view: CameraOperatorView, camera: Orbit) -> Orbit:
    """Return the camera of a group, at the wall if it would stand beyond: there it turns, with a wider lens.

    What a room does not hold is cropped; nobody looks at a group past the edge of its set. A lens that was asked for
    is the lens.
    """
    plan, size = view.plan, view.instruction.size
    if plan is None or not plan.indoor or (reach := reach_back(plan, camera)) >= camera.distance:
        return camera
    widest = view.instruction.lens or (min(SIZES[size].widest, camera.lens) if size in TIGHT else SIZES["WS"].widest)
    held = _held_from(view, camera, reach, widest)
    if outside(plan, held, taken_away(plan, {}, [held], [])) < VOID:
        return held
    return _held_from(view, camera, reach_back(plan, camera, BEFORE_WALL), widest)


def _held_from(view: CameraOperatorView, camera: Orbit, reach: float, widest: float) -> Orbit:
    """Return the camera of a group so far from its pivot: all walks held, or the people where they are."""
    film, size = view.film, view.instruction.size
    place = np.asarray(camera.pivot) + camera.axes[:, 2] * reach

    def held(figures: Sequence[Figure]) -> Orbit:
        fit = framing.frame_group_from(film, figures, size, place, camera.lens, widest)
        lens = view.instruction.lens or view.widened(fit.lens)
        return fit if lens == fit.lens else framing.frame_group_from(film, figures, size, place, lens, lens)

    whole = held(view.stages)
    screen, depth = framing.project(whole, [figure.face for figure in view.stages])
    framed = depth.min() > 0 and screen[:, 0].min() > _EDGE and screen[:, 0].max() < 1 - _EDGE
    nearest = max(framing.head_share(whole, figure) for figure in view.people)
    if framed and nearest > _SMALLEST * SIZES[size].head and _centred(view, whole):
        return whole
    return held(view.people)


def _centred(view: CameraOperatorView, camera: Orbit) -> bool:
    """Return whether the people are about the middle of the picture when it is drawn, whatever their walks need."""
    across = framing.project(camera, [figure.face for figure in view.people])[0][:, 0]
    return abs(float(across.min() + across.max()) / 2 - 0.5) < _OFF_MIDDLE


def group_azimuth(view: CameraOperatorView) -> float:
    """Return from where several are taken: where they look if they look one way, else square to their line."""
    people = view.people
    look = np.mean([figure.forward[:2] for figure in people], axis=0)
    faces = np.array([figure.face[:2] for figure in people])
    spread = faces - faces.mean(0)
    _, _, axes = np.linalg.svd(spread)
    square = math.degrees(math.atan2(axes[1][0], -axes[1][1]))
    if np.hypot(*look) > 0.55:
        toward = math.degrees(math.atan2(look[0], -look[1]))
        return towards_audience(toward, 40.0)
    choices = [square, square + 180.0]
    azimuth = min(choices, key=lambda angle: (_group_cost(view, angle), abs(turned(angle))))
    return turned(azimuth)


def _group_cost(view: CameraOperatorView, azimuth: float) -> float:
    if (axis := view.axis) is None or not view.side:
        return 0.0
    way = np.array([math.sin(math.radians(azimuth)), -math.cos(math.radians(azimuth))])
    position = np.mean([figure.face[:2] for figure in view.people], axis=0) + 4 * way
    return float(side_of_line(position, axis[0].face, axis[1].face) == -view.side)


def turned(angle: float) -> float:
    """Return degrees within -180..180."""
    return math.degrees(wrap_angle(math.radians(angle)))


def towards_audience(yaw: float, most: float) -> float:
    """Return the azimuth nearest to the audience (0) from which something of that yaw is seen within ``most``."""
    yaw = turned(yaw)
    return yaw - max(-most, min(most, yaw))
