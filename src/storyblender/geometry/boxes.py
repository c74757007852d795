"""Yaw-oriented boxes standing upright: axes, gaps, penetration and the shortest way out.

Boxes are plain Python floats, not arrays: rooms hold tens of them, and the solver touches them one by one.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Axis = tuple[float, float]


@dataclass(slots=True)
class Box:
    """An upright box that may be moved and turned.

    Attributes:
        x: Centre, metres.
        y: Centre, metres.
        z: Bottom, metres.
        width: Extent along its own x.
        depth: Extent along its own y; the front is at -depth / 2.
        height: Extent along z.
        yaw: Radians, counter-clockwise; 0 faces -Y. Change it with ``turn_to``.
    """

    x: float
    y: float
    z: float
    width: float
    depth: float
    height: float
    yaw: float = 0.0
    cos: float = field(init=False, repr=False, compare=False)
    sin: float = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        self.turn_to(self.yaw)

    def turn_to(self, yaw: float) -> None:
        """Set the yaw in radians, wrapped to -pi..pi."""
        self.yaw = wrap_angle(yaw)
        self.cos, self.sin = math.cos(yaw), math.sin(yaw)

    @property
    def top(self) -> float:
        """Height of its upper face, metres."""
        return self.z + self.height

    @property
    def radius(self) -> float:
        """Radius of the circle around its footprint, metres."""
        return math.hypot(self.width, self.depth) / 2

    @property
    def forward(self) -> Axis:
        """Unit vector its front points to: (sin yaw, -cos yaw)."""
        return self.sin, -self.cos

    def copy(self) -> Box:
        """Return an independent box."""
        return Box(self.x, self.y, self.z, self.width, self.depth, self.height, self.yaw)

    def to_world(self, x: float, y: float) -> Axis:
        """Return the world x and y of a point of the box's own frame (metres from its centre; its front is at -y)."""
        return self.x + self.cos * x - self.sin * y, self.y + self.sin * x + self.cos * y

    def to_local(self, x: float, y: float) -> Axis:
        """Return a world point in the box's own frame (metres from its centre; its front is at -y)."""
        dx, dy = x - self.x, y - self.y
        return self.cos * dx + self.sin * dy, self.cos * dy - self.sin * dx

    def reach(self, axis: Axis) -> float:
        """Return half the extent of the footprint along a unit axis of the world, metres."""
        u = abs(self.cos * axis[0] + self.sin * axis[1]) * self.width
        v = abs(self.cos * axis[1] - self.sin * axis[0]) * self.depth
        return (u + v) / 2


def wrap_angle(angle: float) -> float:
    """Return the angle in radians brought into -pi..pi."""
    return (angle + math.pi) % (2 * math.pi) - math.pi


def shortest_turn(a: float, b: float) -> float:
    """Return the shortest turn from angle ``a`` to ``b`` in radians, -pi..pi, counter-clockwise positive."""
    return wrap_angle(b - a)


def yaw_along(dx: float, dy: float) -> float:
    """Return the yaw of a front that points along the world direction (dx, dy): radians, 0 at -Y, pi / 2 at +X."""
    return math.atan2(dx, -dy)


def footprint_gap(a: Box, b: Box) -> tuple[float, Axis]:
    """Return the signed gap of two footprints in metres and the unit axis from ``b`` to ``a`` on which it is widest.

    Separating-axis test over the four face normals: negative is the penetration depth, and then moving ``a`` by
    that depth along the axis is the shortest way out.
    """
    dx, dy = a.x - b.x, a.y - b.y
    best, out = -math.inf, (1.0, 0.0)
    for axis in ((a.cos, a.sin), (-a.sin, a.cos), (b.cos, b.sin), (-b.sin, b.cos)):
        along = dx * axis[0] + dy * axis[1]
        gap = abs(along) - a.reach(axis) - b.reach(axis)
        if gap > best + 1e-9:
            best, out = gap, axis if along >= 0 else (-axis[0], -axis[1])
    return best, out


def vertical_gap(a: Box, b: Box) -> float:
    """Return the free height between two boxes in metres; negative if they share some height."""
    return max(a.z - b.z - b.height, b.z - a.z - a.height)


def penetration(a: Box, b: Box, tolerance: float = 0.0) -> tuple[float, Axis]:
    """Return the penetration depth of two boxes in metres (0 if apart) and the unit axis on which ``a`` leaves ``b``.

    Args:
        a: The box that would move.
        b: The other one.
        tolerance: Shared height that counts as mere touching, metres.
    """
    if vertical_gap(a, b) >= -tolerance:
        return 0.0, (1.0, 0.0)
    if math.hypot(a.x - b.x, a.y - b.y) > a.radius + b.radius:
        return 0.0, (1.0, 0.0)
    gap, axis = footprint_gap(a, b)
    return max(-gap, 0.0), axis


def corners(box: Box) -> NDArray[np.float64]:
    """Return the (8, 3) corners in world metres: the four below first, counter-clockwise seen from above."""
    flat = [box.to_world(sx * box.width / 2, sy * box.depth / 2) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return np.array([(x, y, z) for z in (box.z, box.top) for x, y in flat])


def distance_to_point(box: Box, x: float, y: float) -> float:
    """Return the distance in metres of a floor point (world ``x`` and ``y``) from the footprint; negative inside."""
    u, v = box.to_local(x, y)
    du, dv = abs(u) - box.width / 2, abs(v) - box.depth / 2
    return math.hypot(max(du, 0.0), max(dv, 0.0)) + min(max(du, dv), 0.0)
