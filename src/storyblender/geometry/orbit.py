"""The paper's orbital camera model: pivot, rotation, distance, and the update laws of the visual servo (appendix).

World frame: metres, Z up. The camera looks along its -Z with +Y up in the picture. The sensor's width is stated; its
height follows the aspect, whatever the aspect is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Quaternion = tuple[float, float, float, float]
"""w, x, y, z; unit length."""

DOLLY = 1.15
"""beta: factor of distance of one dolly step."""
_NEAREST = 0.3
"""Least distance of camera and pivot, metres."""


@dataclass(frozen=True)
class Orbit:
    """The state of a camera.

    Attributes:
        pivot: Point of interest (c_piv), world metres.
        rotation: World from camera (r).
        distance: From the optical centre to the pivot (d), metres.
        lens: Focal length, mm.
        sensor_width: mm.
        aspect: Width / height of the picture.
    """

    pivot: tuple[float, float, float]
    rotation: Quaternion
    distance: float
    lens: float
    sensor_width: float = 36.0
    aspect: float = 16 / 9

    @cached_property
    def axes(self) -> Floats:
        """Columns: right, up and backward of the camera in the world (R(r))."""
        return rotation_matrix(self.rotation)

    @cached_property
    def position(self) -> Floats:
        """Optical centre, world metres: p_cam = c_piv + R(r) (0, 0, d)."""
        return np.asarray(self.pivot) + self.axes[:, 2] * self.distance

    @property
    def view(self) -> Floats:
        """M_view = T(0, 0, -d) R(r)^T T(-c_piv), 4 x 4, camera from world."""
        out = np.eye(4)
        out[:3, :3] = self.axes.T
        out[:3, 3] = -self.axes.T @ np.asarray(self.pivot) - (0.0, 0.0, self.distance)
        return out

    @property
    def world(self) -> Floats:
        """World from camera, 4 x 4: what Blender calls ``matrix_world``."""
        out = np.eye(4)
        out[:3, :3] = self.axes
        out[:3, 3] = self.position
        return out

    @property
    def tangent(self) -> float:
        """Half the picture's height at one metre of depth: tan(alpha / 2) of the vertical field of view."""
        return self.sensor_width / self.aspect / (2 * self.lens)

    @property
    def frame_height(self) -> float:
        """Height of the picture at the pivot, metres (eta(d) for a viewport of height 1)."""
        return 2 * self.distance * self.tangent

    @property
    def azimuth(self) -> float:
        """Degrees around the pivot: 0 stands at -Y, 90 at +X."""
        back = self.axes[:, 2]
        return math.degrees(math.atan2(back[0], -back[1]))

    @property
    def elevation(self) -> float:
        """Degrees above the pivot's horizon."""
        return math.degrees(math.asin(min(1.0, max(-1.0, float(self.axes[2, 2])))))

    @property
    def roll(self) -> float:
        """Degrees the horizon leans; 0 is level."""
        axes = self.axes
        return math.degrees(math.atan2(axes[2, 0], axes[2, 1]))


def camera_around(
    pivot: ArrayLike,
    azimuth: float,
    elevation: float,
    distance: float,
    lens: float,
    *,
    roll: float = 0.0,
    sensor_width: float = 36.0,
    aspect: float = 16 / 9,
) -> Orbit:
    """Return a camera that looks at a pivot from an azimuth and an elevation around it.

    Args:
        pivot: (3,) world position, metres.
        azimuth: Degrees, 0 at -Y, 90 at +X.
        elevation: Degrees above the pivot's horizon.
        distance: Metres from the optical centre to the pivot.
        lens: Focal length, mm.
        roll: Degrees about the optical axis.
        sensor_width: mm.
        aspect: Width / height of the picture.
    """
    about_z = axis_rotation((0.0, 0.0, 1.0), azimuth)
    about_x = axis_rotation((1.0, 0.0, 0.0), 90.0 - elevation)
    about_view = axis_rotation((0.0, 0.0, 1.0), roll)
    rotation = multiply_quaternions(multiply_quaternions(about_z, about_x), about_view)
    return Orbit(_as_point(pivot), rotation, distance, lens, sensor_width, aspect)


def camera_looking_at(
    position: ArrayLike, target: ArrayLike, lens: float, *, roll: float = 0.0, **film: float
) -> Orbit:
    """Return a camera at a world position that looks at a world target.

    Args:
        position: (3,) optical centre, world metres.
        target: (3,) world metres; it becomes the pivot and must not be the position itself.
        lens: Focal length, mm.
        roll: Degrees about the optical axis.
        film: ``sensor_width`` in mm and ``aspect``.
    """
    back = np.asarray(position, float) - np.asarray(target, float)
    distance = float(np.linalg.norm(back))
    azimuth = math.degrees(math.atan2(back[0], -back[1]))
    elevation = math.degrees(math.asin(back[2] / distance))
    return camera_around(target, azimuth, elevation, distance, lens, roll=roll, **film)


def camera_turned(position: ArrayLike, rotation: Quaternion, lens: float, distance: float, **film: float) -> Orbit:
    """Return a camera at a world position with a rotation.

    Args:
        position: (3,) optical centre, world metres.
        rotation: World from camera; made a unit quaternion.
        lens: Focal length, mm.
        distance: Metres ahead of it to its pivot.
        film: ``sensor_width`` in mm and ``aspect``.
    """
    unit = multiply_quaternions(rotation, (1.0, 0.0, 0.0, 0.0))
    pivot = np.asarray(position, float) - rotation_matrix(unit)[:, 2] * distance
    return Orbit(_as_point(pivot), unit, distance, lens, **film)


def pan(camera: Orbit, dx: float, dy: float) -> Orbit:
    """Move the camera and its pivot ``dx`` picture heights right and ``dy`` up across the picture; 1:1 at the pivot."""
    axes, eta = camera.axes, camera.frame_height
    shift = axes[:, 0] * dx * eta + axes[:, 1] * dy * eta
    return replace(camera, pivot=_as_point(np.asarray(camera.pivot) + shift))


def orbit(camera: Orbit, azimuth: float, elevation: float = 0.0) -> Orbit:
    """Orbit around the pivot; the roll stays.

    Args:
        camera: Camera before the move.
        azimuth: Degrees to add, counter-clockwise positive as seen from above.
        elevation: Degrees to add, up positive; the sum stays within 85 either way.
    """
    elevation = min(max(camera.elevation + elevation, -85.0), 85.0) - camera.elevation
    level = multiply_quaternions(camera.rotation, axis_rotation((0.0, 0.0, 1.0), -camera.roll))
    tilted = multiply_quaternions(
        multiply_quaternions(axis_rotation((0.0, 0.0, 1.0), azimuth), level), axis_rotation((1.0, 0.0, 0.0), -elevation)
    )
    return replace(camera, rotation=multiply_quaternions(tilted, axis_rotation((0.0, 0.0, 1.0), camera.roll)))


def dolly(camera: Orbit, steps: float) -> Orbit:
    """Move towards the pivot along the optical axis: d beta^-steps (``DOLLY``); negative steps move back."""
    return replace(camera, distance=max(_NEAREST, camera.distance * DOLLY**-steps))


def roll(camera: Orbit, angle: float) -> Orbit:
    """Roll the camera about its optical axis by degrees, counter-clockwise positive as seen from behind it."""
    return replace(camera, rotation=multiply_quaternions(camera.rotation, axis_rotation((0.0, 0.0, 1.0), angle)))


def swivel(camera: Orbit, azimuth: float, elevation: float = 0.0) -> Orbit:
    """Turn on the tripod by degrees, left (azimuth) and up (elevation) positive: the position stays, not the pivot."""
    position = camera.position
    turned = multiply_quaternions(
        multiply_quaternions(axis_rotation((0.0, 0.0, 1.0), azimuth), camera.rotation),
        axis_rotation((1.0, 0.0, 0.0), elevation),
    )
    back = rotation_matrix(turned)[:, 2]
    return replace(camera, rotation=turned, pivot=_as_point(position - back * camera.distance))


def axis_rotation(axis: tuple[float, float, float], angle: float) -> Quaternion:
    """Return the quaternion of a turn about a unit axis by degrees."""
    half = math.radians(angle) / 2
    s = math.sin(half)
    return math.cos(half), axis[0] * s, axis[1] * s, axis[2] * s


def multiply_quaternions(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the Hamilton product: first ``b``, then ``a``; normalised."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    out = (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )
    length = math.sqrt(sum(part * part for part in out))
    return out[0] / length, out[1] / length, out[2] / length, out[3] / length


def rotation_matrix(q: Quaternion) -> Floats:
    """Return the 3 x 3 rotation of a unit quaternion."""
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def slerp(a: Quaternion, b: Quaternion, share: float) -> Quaternion:
    """Return the rotation at a share (0..1) of the shorter way from ``a`` to ``b``."""
    p, q = np.asarray(a), np.asarray(b)
    dot = float(p @ q)
    if dot < 0:
        q, dot = -q, -dot
    angle = math.acos(min(1.0, dot))
    if angle < 1e-6:
        return b if share >= 0.5 else a
    out = (math.sin((1 - share) * angle) * p + math.sin(share * angle) * q) / math.sin(angle)
    return float(out[0]), float(out[1]), float(out[2]), float(out[3])


def _as_point(values: ArrayLike) -> tuple[float, float, float]:
    x, y, z = np.asarray(values, float)
    return float(x), float(y), float(z)
