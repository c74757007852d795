"""Over the shoulder: one person past the head of another, and the lens that this needs."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from storyblender.geometry.framing import Figure, Film, distance_for, face_screen_y, place_on_screen, project
from storyblender.geometry.orbit import Orbit, camera_looking_at
from storyblender.memory.shot_sizes import SIZES, ShotSize

SHOULDER_CROWN_Y = -0.04
"""Least screen y of the near crown of an over-the-shoulder: a little hair may be cut, not the head."""
_SHOULDER_HEAD_RATIO = 3.2
"""Largest ratio of the near head of an over-the-shoulder to the far one."""
_SHOULDER_DISTANCE_RATIO = 1.6
"""Largest ratio of an over-the-shoulder's camera distance to the distance that the shot size asks for."""
_SHOULDER_RISE_SHARE = 0.5
"""Share of the height of a partner's face above the subject's by which the camera goes up."""
_SHOULDER_FACE_OFFSET = 0.13
"""Screen distance from the middle to the face of an over-the-shoulder, on the side without the shoulder."""
_SHOULDER_FACE_LOWEST_Y = 0.55
"""Largest screen y of the subject's face in an over-the-shoulder."""
_LONGER = (1.3, 1.75)
"""Factors on the usual lens for people who stand far apart."""


def lens_over_shoulder(
    film: Film, focus: Figure, over: Figure, size: ShotSize, lens: float, kit: Sequence[float] = ()
) -> float | None:
    """Return the shortest lens with which a camera behind a shoulder sees the subject about as large as asked.

    Args:
        film: Sensor and aspect.
        focus: Person who is seen.
        over: Person whose shoulder is in the picture.
        size: Shot size of ``focus``.
        lens: Usual focal length, mm; a longer one is taken where the two are far apart.
        kit: Focal lengths at hand, mm; empty for any.

    Returns:
        None if not even the longest is long enough.
    """
    away = _distance_over_shoulder(math.dist(focus.face[:2], over.face[:2]))
    longer = kit or [lens * factor for factor in _LONGER]
    lenses = [lens, *sorted(each for each in longer if lens < each <= lens * _LONGER[-1])]
    share = SIZES[size].head
    fits = (mm for mm in lenses if away <= _SHOULDER_DISTANCE_RATIO * distance_for(focus.head, share, film.tangent(mm)))
    return next(fits, None)


def _distance_over_shoulder(apart: float) -> float:
    """Return the least metres from camera to subject behind a partner who is ``apart`` metres from the subject."""
    return apart + max(0.75, apart / (_SHOULDER_HEAD_RATIO - 1))


def frame_over_shoulder(
    film: Film, focus: Figure, over: Figure, size: ShotSize, side: float, elevation: float, lens: float
) -> Orbit:
    """Return the camera behind a shoulder: the listener's head a dark third, the speaker's face in the other.

    Args:
        film: Sensor and aspect.
        focus: Person who is seen.
        over: Person whose shoulder is in the picture.
        size: Shot size of ``focus``.
        side: +1 if the camera is on the left of the line from ``over`` to ``focus``, -1 if on the right.
        elevation: Degrees above the eyes of ``focus``, added to the height that clears the shoulder.
        lens: Focal length, mm.
    """
    tangent = film.tangent(lens)
    line = np.asarray(focus.face) - np.asarray(over.face)
    apart = max(float(np.hypot(line[0], line[1])), 0.4)
    ahead = np.array([line[0], line[1], 0.0]) / apart
    left = np.array([-ahead[1], ahead[0], 0.0])
    distance = max(distance_for(focus.head, SIZES[size].head, tangent), _distance_over_shoulder(apart))
    behind = distance - apart
    spread = 0.42 * 2 * tangent * film.aspect
    # Placing the face on its third takes the camera back by as much.
    taken = _SHOULDER_FACE_OFFSET * 2 * tangent * film.aspect * distance
    aside = min(spread / (1 / behind - 1 / distance) + taken, 0.75 * behind, 0.7 * distance)
    aside = max(aside, 0.32)
    lift = distance * math.tan(math.radians(elevation))
    position = np.asarray(over.face) - ahead * behind + left * side * aside
    taller = max(over.face[2] - focus.face[2], 0.0)
    position[2] = max(focus.face[2], over.face[2]) + 0.06 + lift + _SHOULDER_RISE_SHARE * taller
    camera = camera_looking_at(position, focus.face, lens, sensor_width=film.sensor_width, aspect=film.aspect)
    height = min(face_screen_y(size) + 0.03, 0.42)
    camera = place_on_screen(camera, focus.face, 0.5 - side * _SHOULDER_FACE_OFFSET, height)
    screen, depth = project(camera, [over.crown, focus.face])
    if screen[0, 1] >= SHOULDER_CROWN_Y:
        return camera
    # A camera that goes up moves a near head further down its picture than the face behind it.
    lower = (SHOULDER_CROWN_Y - float(screen[0, 1])) * float(depth[0] / depth[1])
    return place_on_screen(
        camera,
        focus.face,
        0.5 - side * _SHOULDER_FACE_OFFSET,
        max(height, min(height + lower, _SHOULDER_FACE_LOWEST_Y)),
    )
