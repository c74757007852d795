"""Where a moving camera ends, and how it gets there: pan, tilt, orbit, push, truck, pedestal, zoom, track."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from storyblender.geometry.orbit import Orbit, matrix, orbit, slerp, swivel

_SIGN = {"left": 1.0, "right": -1.0, "up": 1.0, "down": -1.0}
_PAN, _TILT, _ORBIT = 18.0, 12.0, 28.0
"""Degrees of a plain move: a third of a normal lens's field."""
_PUSH, _ZOOM = 1.35, 1.4
"""Factor of distance, of focal length."""
_TRUCK, _PEDESTAL = 0.45, 0.35
"""Travel in heights of the picture at the pivot."""


def end_of_move(
    camera: Orbit, movement: str, direction: str | None = None, travel: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> Orbit:
    """Return the camera at the end of a shot.

    Args:
        camera: At the start.
        movement: One of the camera movements of the vocabulary.
        direction: left, right, up or down; the picture's, so panning left turns to what lies left of it.
        travel: How far the subject moves during the shot, metres; pan and track follow it.
    """
    sign = _SIGN.get(direction or "", 0.0)
    follows = float(np.linalg.norm(travel)) > 0.3
    axes = camera.axes
    if movement == "track":
        return _shifted(camera, np.asarray(travel)) if follows else _trucked(camera, -(sign or 1.0))
    if movement in ("pan", "tilt") and follows and (direction is None or movement == "pan"):
        return _follow(camera, travel)
    if movement == "tilt" or (movement == "pan" and direction in ("up", "down")):
        return swivel(camera, 0.0, _TILT * (sign or 1.0))
    if movement == "pan":
        return swivel(camera, _PAN * (sign or 1.0))
    if movement == "orbit":
        if direction in ("up", "down"):
            return orbit(camera, 0.0, sign * _ORBIT / 2)
        return orbit(camera, -_ORBIT * (sign or 1.0))
    if movement == "push in":
        return replace(camera, distance=camera.distance / _PUSH)
    if movement == "pull out":
        return replace(camera, distance=camera.distance * _PUSH)
    if movement == "zoom in":
        return replace(camera, lens=camera.lens * _ZOOM)
    if movement == "zoom out":
        return replace(camera, lens=camera.lens / _ZOOM)
    if movement == "truck":
        return _trucked(camera, -(sign or 1.0))
    if movement == "pedestal":
        return _shifted(camera, axes[:, 1] * camera.frame_height * _PEDESTAL * (sign or 1.0))
    return camera


def _trucked(camera: Orbit, right: float) -> Orbit:
    return _shifted(camera, camera.axes[:, 0] * camera.frame_height * _TRUCK * right)


def _shifted(camera: Orbit, by: np.ndarray) -> Orbit:
    x, y, z = np.asarray(camera.pivot) + by
    return replace(camera, pivot=(float(x), float(y), float(z)))


def _follow(camera: Orbit, travel: tuple[float, float, float]) -> Orbit:
    """Turn on the tripod until the travelled pivot is where it was in the picture."""
    old = np.asarray(camera.pivot) - camera.position
    new = old + np.asarray(travel)
    azimuth = math.atan2(new[1], new[0]) - math.atan2(old[1], old[0])
    azimuth = (azimuth + math.pi) % (2 * math.pi) - math.pi
    tilt = math.atan2(new[2], math.hypot(new[0], new[1])) - math.atan2(old[2], math.hypot(old[0], old[1]))
    turned = swivel(camera, math.degrees(azimuth), math.degrees(tilt))
    return replace(turned, distance=float(np.linalg.norm(new)), pivot=tuple((camera.position + new).tolist()))


def eased(share: float) -> float:
    """Return the share of the way gone at a share of the time: minimum jerk, at rest at both ends."""
    t = min(max(share, 0.0), 1.0)
    return t * t * t * (10 - 15 * t + 6 * t * t)


def in_between(start: Orbit, end: Orbit, share: float) -> Orbit:
    """Return the camera that share of the way from start to end (ease the share first).

    A camera on a tripod keeps its position, one that travels keeps its eye on the moving pivot.
    """
    a, b = np.asarray(start.pivot), np.asarray(end.pivot)
    rotation = slerp(start.rotation, end.rotation, share)
    distance = start.distance ** (1 - share) * end.distance**share
    if np.linalg.norm(end.position - start.position) < np.linalg.norm(b - a):
        position = (1 - share) * start.position + share * end.position
        pivot = position - matrix(rotation)[:, 2] * distance
    else:
        pivot = (1 - share) * a + share * b
    lens = start.lens ** (1 - share) * end.lens**share
    return replace(start, pivot=tuple(pivot.tolist()), rotation=rotation, distance=distance, lens=lens)
