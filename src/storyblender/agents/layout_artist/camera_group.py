"""Several people in one picture: azimuth, distance, and what gives way in a small room."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView
from storyblender.agents.layout_artist.camera_room import BEFORE_WALL, VOID, reach_back, share_outside
from storyblender.agents.layout_artist.wild_walls import find_hidden_nodes
from storyblender.geometry import framing
from storyblender.geometry.boxes import wrap_angle
from storyblender.geometry.continuity import side_of_line
from storyblender.geometry.framing import Figure
from storyblender.geometry.orbit import Orbit
from storyblender.memory.shot_sizes import SIZES, TIGHT

_SMALLEST = 0.6
"""Least head height in a picture that holds all of a group's walks, as a share of what the shot size asks for."""
_OFF_MIDDLE = 0.1
"""Most widths that a group may be off the middle at the story moment."""
_EDGE = 0.03
"""Margin of the picture, as a share of its width, in which a face does not count as held."""


def frame_moving_group(view: CameraOperatorView, lens: float, azimuth: float, elevation: float) -> Orbit:
    """Return the camera that holds the focus people on all of their walks, else where they are at the story moment.

    Args:
        view: The shot.
        lens: Focal length in mm.
        azimuth: Degrees; 0 is the audience at -Y.
        elevation: Degrees above the horizon.
    """
    size = view.instruction.size
    whole = framing.frame_group(view.film, view.people_over_time, size, azimuth, elevation, lens)
    if view.people[0].head / whole.frame_height > _SMALLEST * SIZES[size].head and _is_group_centred(view, whole):
        return whole
    return framing.frame_group(view.film, view.people, size, azimuth, elevation, lens)


def keep_group_in_room(view: CameraOperatorView, camera: Orbit) -> Orbit:
    """Return the camera of a group, at the wall if it was beyond: there it turns and takes a wider lens.

    What the room is too short for is cropped. A lens in the instruction is kept.

    Args:
        view: The shot.
        camera: The camera as composed, perhaps outside the room.
    """
    plan, size = view.plan, view.instruction.size
    if plan is None or not plan.indoor or (reach := reach_back(plan, camera)) >= camera.distance:
        return camera
    widest = view.instruction.lens or (min(SIZES[size].widest, camera.lens) if size in TIGHT else SIZES["WS"].widest)
    held = _frame_group_from(view, camera, reach, widest)
    if share_outside(plan, held, find_hidden_nodes(plan, {}, [held], [])) < VOID:
        return held
    return _frame_group_from(view, camera, reach_back(plan, camera, BEFORE_WALL), widest)


def _frame_group_from(view: CameraOperatorView, camera: Orbit, reach: float, widest: float) -> Orbit:
    """Return the camera ``reach`` metres from its pivot, lens at least ``widest`` mm: all walks held if they fit."""
    film, size = view.film, view.instruction.size
    place = np.asarray(camera.pivot) + camera.axes[:, 2] * reach

    def held(figures: Sequence[Figure]) -> Orbit:
        fit = framing.frame_group_from(film, figures, size, place, camera.lens, widest)
        lens = view.instruction.lens or view.widened(fit.lens)
        return fit if lens == fit.lens else framing.frame_group_from(film, figures, size, place, lens, lens)

    whole = held(view.people_over_time)
    screen, depth = framing.project(whole, [figure.face for figure in view.people_over_time])
    framed = depth.min() > 0 and screen[:, 0].min() > _EDGE and screen[:, 0].max() < 1 - _EDGE
    nearest = max(framing.head_share(whole, figure) for figure in view.people)
    if framed and nearest > _SMALLEST * SIZES[size].head and _is_group_centred(view, whole):
        return whole
    return held(view.people)


def _is_group_centred(view: CameraOperatorView, camera: Orbit) -> bool:
    """Return whether the people are about the middle of the picture at the story moment."""
    across = framing.project(camera, [figure.face for figure in view.people])[0][:, 0]
    return abs(float(across.min() + across.max()) / 2 - 0.5) < _OFF_MIDDLE


def group_azimuth(view: CameraOperatorView) -> float:
    """Return the azimuth in degrees for a group: in front if they look one way, else at right angles to their line."""
    people = view.people
    look = np.mean([figure.forward[:2] for figure in people], axis=0)
    faces = np.array([figure.face[:2] for figure in people])
    spread = faces - faces.mean(0)
    _, _, axes = np.linalg.svd(spread)
    square = math.degrees(math.atan2(axes[1][0], -axes[1][1]))
    if np.hypot(*look) > 0.55:
        toward = math.degrees(math.atan2(look[0], -look[1]))
        return azimuth_towards_audience(toward, 40.0)
    choices = [square, square + 180.0]
    azimuth = min(choices, key=lambda angle: (_crosses_line(view, angle), abs(wrap_degrees(angle))))
    return wrap_degrees(azimuth)


def _crosses_line(view: CameraOperatorView, azimuth: float) -> float:
    """Return 1 where an azimuth is on the wrong side of the 180-degree line, else 0."""
    if (axis := view.axis) is None or not view.side:
        return 0.0
    way = np.array([math.sin(math.radians(azimuth)), -math.cos(math.radians(azimuth))])
    position = np.mean([figure.face[:2] for figure in view.people], axis=0) + 4 * way
    return float(side_of_line(position, axis[0].face, axis[1].face) == -view.side)


def wrap_degrees(angle: float) -> float:
    """Return an angle in degrees within -180..180."""
    return math.degrees(wrap_angle(math.radians(angle)))


def azimuth_towards_audience(yaw: float, most: float) -> float:
    """Return the azimuth nearest to the audience (0) from which a thing of that yaw is seen: all in degrees.

    Args:
        yaw: Where the thing faces.
        most: Largest angle between its front and the camera.
    """
    yaw = wrap_degrees(yaw)
    return yaw - max(-most, min(most, yaw))
