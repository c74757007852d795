"""Rules of the cut: the 180-degree line, the 30-degree rule, matching singles, screen direction."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from storyblender.geometry.boxes import wrap_angle
from storyblender.geometry.orbit import Orbit

JUMP_CUT_DEGREES = 30.0
"""Degrees that a camera must move between two shots of one subject in like size."""

_NEW_LINE_DEGREES = 50.0
"""Degrees that the line of two people must turn to be another line."""


def has_new_line(before: ArrayLike, now: ArrayLike) -> bool:
    """Return whether the line between two people has turned more than 50 degrees, so that a new 180-degree line holds.

    What was on one side of the old line has no side on the new one: a picture after it may choose, and answers none
    of those before.

    Args:
        before: (2, 3) world positions of their faces, in the same order as ``now``.
        now: (2, 3) world positions of their faces.
    """
    angles = []
    for faces in (before, now):
        first, second = np.asarray(faces, float)[:, :2]
        angles.append(math.atan2(*(second - first)[::-1]))
    return abs(wrap_angle(angles[1] - angles[0])) > math.radians(_NEW_LINE_DEGREES)


def side_of_line(camera: ArrayLike, first: ArrayLike, second: ArrayLike) -> int:
    """Return on which side of the line from ``first`` to ``second`` the camera is: 1 left, -1 right, 0 on it.

    Within 5 degrees of the line as seen from the middle counts as on it: a neutral shot breaks no axis.

    Args:
        camera: (2,) or (3,) world position, metres; only x and y count, here and below.
        first: World position of one person, metres.
        second: World position of the other person, metres.
    """
    a, b, c = (np.asarray(point, float)[:2] for point in (first, second, camera))
    line, sight = b - a, c - (a + b) / 2
    cross = line[0] * sight[1] - line[1] * sight[0]
    scale = float(np.hypot(*line) * np.hypot(*sight))
    if scale < 1e-9 or abs(cross) / scale < math.sin(math.radians(5)):
        return 0
    return 1 if cross > 0 else -1


def crosses_line(camera: Orbit, first: ArrayLike, second: ArrayLike, side: int) -> bool:
    """Return whether the camera is across the line from the side of the scene.

    Args:
        camera: Camera whose position is judged.
        first: World position of one person, metres.
        second: World position of the other person, metres.
        side: Side of the line from ``first`` to ``second`` used so far: 1 left, -1 right, 0 none yet.
    """
    here = side_of_line(camera.position, first, second)
    return side != 0 and here != 0 and here != side


def angle_between_views(before: Orbit, after: Orbit, subject: ArrayLike) -> float:
    """Return the angle in degrees between two cameras as seen from the subject.

    Args:
        before: Camera before the cut.
        after: Camera after the cut.
        subject: (3,) world position, metres.
    """
    a = before.position - np.asarray(subject, float)
    b = after.position - np.asarray(subject, float)
    cosine = float(a @ b / (np.linalg.norm(a) * np.linalg.norm(b)))
    return math.degrees(math.acos(min(1.0, max(-1.0, cosine))))


def screen_direction(camera: Orbit, vector: ArrayLike) -> float:
    """Return the share of a world direction that runs to the right of the picture: 1 right, -1 left, 0 in depth.

    Args:
        camera: Camera that shows it.
        vector: (3,) world direction of any length; a zero vector gives 0.
    """
    flat = np.asarray(vector, float)
    length = float(np.linalg.norm(flat))
    return float(camera.axes[:, 0] @ flat / length) if length > 1e-9 else 0.0


def do_looks_match(
    one: Orbit, one_look: ArrayLike, other: Orbit, other_look: ArrayLike, *, least: float = 0.12
) -> bool:
    """Return whether the looks of two singles run to opposite sides of the picture.

    Args:
        one: Camera of one single.
        one_look: (3,) world direction of the look in it.
        other: Camera of the other single.
        other_look: (3,) world direction of the look in that one.
        least: ``screen_direction`` below which a look runs to neither side and matches any.
    """
    a, b = screen_direction(one, one_look), screen_direction(other, other_look)
    return a * b < 0 or abs(a) < least or abs(b) < least


def mirror_azimuth(azimuth: float, first: ArrayLike, second: ArrayLike) -> float:
    """Return the azimuth of a camera mirrored across the plane midway between two people: degrees, 0 at -Y, 90 at +X.

    The reverse of a single: same side of the line, same angle off it, looking at the other one.

    Args:
        azimuth: Of the camera to mirror, in the same degrees.
        first: World position of one person, metres.
        second: World position of the other person, metres; the order of the two does not matter.
    """
    line = np.asarray(second, float) - np.asarray(first, float)
    along = math.degrees(math.atan2(line[0], -line[1]))
    return math.degrees(wrap_angle(math.radians(2 * (along + 90.0) - azimuth)))
