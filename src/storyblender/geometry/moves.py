"""Start, end and interpolation of camera moves: pan, tilt, orbit, push, truck, pedestal, zoom, track."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from storyblender.geometry.orbit import Orbit, orbit, rotation_matrix, slerp, swivel

_SIGN = {"left": 1.0, "right": -1.0, "up": 1.0, "down": -1.0}
_PAN = 18.0
"""Degrees of a pan: a third of a normal lens's field."""
_TILT = 12.0
"""Degrees of a tilt."""
_ORBIT = 28.0
"""Degrees of an orbit."""
_PUSH = 1.35
"""Factor of distance of a push or a pull."""
_ZOOM = 1.4
"""Factor of focal length of a zoom."""
_TRUCK = 0.45
"""Travel of a truck or track, in heights of the picture at the pivot."""
_PEDESTAL = 0.35
"""Travel of a pedestal, in heights of the picture at the pivot."""


def move_camera(camera: Orbit, movement: str, direction: str | None = None, share: float = 1.0) -> Orbit:
    """Return the camera after a share of a move; a move from share -1/2 to 1/2 is centred on ``camera``.

    Args:
        camera: Camera at share 0.
        movement: One of the camera movements of the vocabulary.
        direction: left, right, up or down; the picture's, so panning left turns to what lies left of it.
        share: Of the whole move; negative goes the other way.
    """
    sign = share * _SIGN.get(direction or "", 1.0)
    vertical = direction in ("up", "down")
    if movement == "tilt" or (movement == "pan" and vertical):
        return swivel(camera, 0.0, _TILT * sign)
    if movement == "pan":
        return swivel(camera, _PAN * sign)
    if movement == "orbit":
        return orbit(camera, 0.0, _ORBIT / 2 * sign) if vertical else orbit(camera, -_ORBIT * sign)
    if movement == "pedestal" or (movement == "truck" and vertical):
        return _shift_camera(camera, camera.axes[:, 1] * camera.frame_height * _PEDESTAL * sign)
    if movement in ("truck", "track"):
        return _shift_camera(camera, camera.axes[:, 0] * camera.frame_height * _TRUCK * -sign)
    factor = {"push in": 1 / _PUSH, "pull out": _PUSH}.get(movement, 1.0) ** share
    zoom = {"zoom in": _ZOOM, "zoom out": 1 / _ZOOM}.get(movement, 1.0) ** share
    return replace(camera, distance=camera.distance * factor, lens=camera.lens * zoom)


def follow_subject(camera: Orbit, movement: str, travel: tuple[float, float, float]) -> Orbit:
    """Return the camera at the end of a walk it follows: ``track`` travels along, other moves turn on the tripod.

    Args:
        camera: At the start of the walk.
        movement: ``track``, or any other movement of the vocabulary.
        travel: World shift of the subject from start to end, metres.
    """
    return _shift_camera(camera, np.asarray(travel)) if movement == "track" else _turn_to_follow(camera, travel)


def _shift_camera(camera: Orbit, by: np.ndarray) -> Orbit:
    x, y, z = np.asarray(camera.pivot) + by
    return replace(camera, pivot=(float(x), float(y), float(z)))


def _turn_to_follow(camera: Orbit, travel: tuple[float, float, float]) -> Orbit:
    """Turn on the tripod until the travelled pivot is where it was in the picture."""
    old = np.asarray(camera.pivot) - camera.position
    new = old + np.asarray(travel)
    azimuth = math.degrees(math.atan2(new[1], new[0]) - math.atan2(old[1], old[0]))
    azimuth = (azimuth + 180) % 360 - 180
    tilt = math.atan2(new[2], math.hypot(new[0], new[1])) - math.atan2(old[2], math.hypot(old[0], old[1]))
    turned = swivel(camera, azimuth, math.degrees(tilt))
    return replace(turned, distance=float(np.linalg.norm(new)), pivot=tuple((camera.position + new).tolist()))


def ease_in_out(share: float) -> float:
    """Return the share of the way covered at a share of the time (both 0..1): minimum jerk, at rest at both ends."""
    t = min(max(share, 0.0), 1.0)
    return t * t * t * (10 - 15 * t + 6 * t * t)


def interpolate_cameras(start: Orbit, end: Orbit, share: float) -> Orbit:
    """Return the camera at a share (0..1, already eased) of the move from ``start`` to ``end``.

    A camera on a tripod keeps its position, one that travels keeps its eye on the moving pivot.
    """
    a, b = np.asarray(start.pivot), np.asarray(end.pivot)
    rotation = slerp(start.rotation, end.rotation, share)
    distance = start.distance ** (1 - share) * end.distance**share
    if np.linalg.norm(end.position - start.position) < np.linalg.norm(b - a):
        position = (1 - share) * start.position + share * end.position
        pivot = position - rotation_matrix(rotation)[:, 2] * distance
    else:
        pivot = (1 - share) * a + share * b
    lens = start.lens ** (1 - share) * end.lens**share
    return replace(start, pivot=tuple(pivot.tolist()), rotation=rotation, distance=distance, lens=lens)
