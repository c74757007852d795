"""Ways for people through a set: A* on a grid of clearances, string pulling, rounded corners, waiting for others.

Plan view only: metres, world frame, X and Y (notes: motion, section 4).
"""

from __future__ import annotations

import heapq
import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Vec2 = tuple[float, float]
Bounds = tuple[float, float, float, float]
"""x min, y min, x max, y max."""
Track = Callable[[float], Vec2]
"""Function from a time in seconds to the world x and y of a person, metres."""
Leg = Callable[[Vec2, Vec2], list[Vec2] | None]
"""Function from two floor points to the way from one to the other; None without one."""
Floats = NDArray[np.float64]

SQUEEZE_RADIUS = 0.19
"""Metres times k: the clearance of a person who edges between a table and a chair."""
BEFORE_SEAT = 0.18
"""Metres times k from a seat's edge to where one stands; nearer, clothes cut the chair while turning."""
LEG_ROOM = 0.17
"""Metres times k to the next thing, in front of a seat, from which one can stand up straight."""

GRID = 0.10
"""Cell of the search grid in metres."""
_AT_ONCE = 200_000
"""Distances that are worked out at a time."""
CORNER_RADIUS = 0.22
"""Largest radius of a rounded corner; more would cut into furniture at the padding people keep."""


@dataclass(frozen=True)
class Footprint:
    """A rectangle seen from above, grown by ``round`` on all sides; size (0, 0) makes it a disc.

    Attributes:
        centre: World x and y, metres.
        size: Extent along its own x and y before turning, metres.
        yaw: Radians, counter-clockwise; 0 faces -Y.
        round: Metres added all around.
        name: Its node_id, or empty.
    """

    centre: Vec2
    size: Vec2
    yaw: float = 0.0
    round: float = 0.0
    name: str = ""


def clearance(points: Floats, obstacles: Sequence[Footprint]) -> Floats:
    """Return the metres from each point to the nearest obstacle; negative inside, 1e9 without any.

    Args:
        points: (n, 2) world x and y, metres.
        obstacles: Footprints to keep away from.
    """
    return _Rectangles(obstacles).clearance(points)


class _Rectangles:
    """Footprints as arrays: many short lines are tried against the same ones.

    Args:
        obstacles: Footprints to keep away from.
    """

    def __init__(self, obstacles: Sequence[Footprint]) -> None:
        rows = [(*box.centre, math.cos(box.yaw), math.sin(box.yaw), *box.size, box.round) for box in obstacles]
        self._rows = np.array(rows, float).reshape(-1, 7)

    def clearance(self, points: Floats) -> Floats:
        """As the function of that name."""
        best = np.full(len(points), 1e9)
        at_once = max(1, _AT_ONCE // max(1, len(points)))
        for first in range(0, len(self._rows), at_once):
            x, y, cos, sin, width, depth, grown = self._rows[first : first + at_once].T[:, :, None]
            across, along = points[:, 0] - x, points[:, 1] - y
            u = np.abs(cos * across + sin * along) - width / 2
            v = np.abs(cos * along - sin * across) - depth / 2
            outside = np.hypot(np.maximum(u, 0), np.maximum(v, 0))
            best = np.minimum(best, (outside + np.minimum(np.maximum(u, v), 0) - grown).min(axis=0))
        return best


def find_path(
    start: Vec2, goal: Vec2, obstacles: Sequence[Footprint], bounds: Bounds, radius: float
) -> list[Vec2] | None:
    """Return a short smooth way from ``start`` to ``goal``, or None where there is none.

    A place that is itself tighter than ``radius`` (the spot in front of a chair) can still be reached: the wanted
    clearance grows from what the place allows to ``radius`` on the way out.

    Args:
        start: World x and y, metres.
        goal: World x and y, metres.
        obstacles: What stands in the way, furniture and people.
        bounds: The playing area; grown where start or goal lie outside.
        radius: Clearance to keep, body radius and padding, metres.

    Returns:
        Way points from start to goal, corners rounded.
    """
    room = _FreeSpace(start, goal, obstacles, radius)
    if room.free_line(start, goal):
        return [start, goal]
    cells = _search(room, start, goal, bounds)
    if cells is None:
        return None
    pulled = [start]
    index = 0
    while index < len(cells) - 1:
        last = len(cells) - 1
        while last > index + 1 and not room.free_line(cells[index], cells[last]):
            last -= 1
        pulled.append(cells[last])
        index = last
    return round_corners(pulled)


class _FreeSpace:
    """Clearances, with the relaxation around tight ends."""

    def __init__(self, start: Vec2, goal: Vec2, obstacles: Sequence[Footprint], radius: float) -> None:
        self.obstacles, self.radius = _Rectangles(obstacles), radius
        self.ends = np.array([start, goal])
        self.allowed = 0.9 * self.obstacles.clearance(self.ends)

    def free(self, points: Floats) -> NDArray[np.bool_]:
        wanted = np.full(len(points), self.radius)
        for end, allowed in zip(self.ends, self.allowed, strict=True):
            away = np.hypot(points[:, 0] - end[0], points[:, 1] - end[1])
            wanted = np.minimum(wanted, max(0.02, float(allowed)) + 0.6 * away)
        return self.obstacles.clearance(points) >= wanted

    def free_line(self, a: Vec2, b: Vec2) -> bool:
        count = int(math.dist(a, b) / (GRID / 2)) + 2
        share = np.linspace(0, 1, count)[1:-1, None]
        line = np.asarray(a) * (1 - share) + np.asarray(b) * share
        return bool(self.free(line).all())


def _search(room: _FreeSpace, start: Vec2, goal: Vec2, bounds: Bounds) -> list[Vec2] | None:
    """A* over 8 neighbours; returns cell centres with the exact ends."""
    low = np.minimum(np.minimum(bounds[:2], start), goal) - GRID
    high = np.maximum(np.maximum(bounds[2:], start), goal) + GRID
    columns, rows = (int(n) + 1 for n in np.ceil((high - low) / GRID))
    x, y = np.meshgrid(low[0] + GRID * np.arange(columns), low[1] + GRID * np.arange(rows), indexing="ij")
    free = room.free(np.stack([x.ravel(), y.ravel()], 1)).reshape(columns, rows)

    def cell(point: Vec2) -> tuple[int, int]:
        return round((point[0] - low[0]) / GRID), round((point[1] - low[1]) / GRID)

    first, last = cell(start), cell(goal)
    free[first] = free[last] = True
    came: dict[tuple[int, int], tuple[int, int]] = {}
    cost = {first: 0.0}
    heap = [(0.0, first)]
    while heap:
        _, here = heapq.heappop(heap)
        if here == last:
            break
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            there = (here[0] + dx, here[1] + dy)
            if not (0 <= there[0] < columns and 0 <= there[1] < rows and free[there]):
                continue
            total = cost[here] + math.hypot(dx, dy)
            if total < cost.get(there, math.inf) - 1e-9:
                cost[there], came[there] = total, here
                heapq.heappush(heap, (total + math.dist(there, last), there))
    if last not in cost:
        return None
    cells = [last]
    while cells[-1] != first:
        cells.append(came[cells[-1]])
    points = [(float(low[0] + GRID * i), float(low[1] + GRID * j)) for i, j in reversed(cells)]
    return [start, *points[1:-1], goal]


def round_corners(points: Sequence[Vec2], radius: float = CORNER_RADIUS) -> list[Vec2]:
    """Replace every corner of a polyline by a parabola that starts at most ``radius`` metres before it.

    Args:
        points: World x and y, metres; the first and the last stay.
        radius: Metres; less where a neighbouring corner is near.
    """
    corners = [np.asarray(point, float) for point in points]
    smooth = [corners[0]]
    for before, corner, after in zip(corners, corners[1:], corners[2:], strict=False):
        back, ahead = before - corner, after - corner
        cut = min(radius, 0.45 * float(np.hypot(*back)), 0.45 * float(np.hypot(*ahead)))
        a = corner + back / max(1e-9, float(np.hypot(*back))) * cut
        b = corner + ahead / max(1e-9, float(np.hypot(*ahead))) * cut
        smooth += [a * (1 - w) ** 2 + corner * 2 * w * (1 - w) + b * w * w for w in np.linspace(0, 1, 7)]
    smooth.append(corners[-1])
    return [(float(point[0]), float(point[1])) for point in smooth]


def walk_through(leg: Leg, stops: Sequence[Vec2]) -> list[Vec2] | None:
    """Return a way from the first of several floor points to the last, through all of them; None without one.

    Args:
        leg: Finds the way between two of them.
        stops: Floor points.
    """
    way = [stops[0]]
    for start, end in itertools.pairwise(stops):
        found = leg(start, end)
        if found is None:
            return None
        way += found[1:]
    return way


def path_length(points: Sequence[Vec2]) -> float:
    """Return the length of a polyline in metres."""
    return sum(math.dist(a, b) for a, b in itertools.pairwise(points))


def find_seat_access(edge: Vec2, yaw: float, width: float, k: float, obstacles: Sequence[Footprint], seat: str) -> Vec2:
    """Return the floor point (world x and y) of a person before sitting down and after getting up.

    It is in front of the seat, or beside it where a table leaves no room in front.

    Args:
        edge: Middle of the seat's front edge, world metres.
        yaw: Direction the sitter faces, radians, counter-clockwise; 0 faces -Y.
        width: Of the furniture, metres.
        k: Stature over 1.7 m.
        obstacles: Furniture and walls.
        seat: Name of the furniture among the obstacles.
    """
    forward, right = np.array([math.sin(yaw), -math.cos(yaw)]), np.array([math.cos(yaw), math.sin(yaw)])
    before = np.asarray(edge) + BEFORE_SEAT * k * forward
    others = [box for box in obstacles if box.name != seat]
    if float(clearance(before[None], others)[0]) >= LEG_ROOM * k:
        return float(before[0]), float(before[1])
    aside = [np.asarray(edge) - 0.12 * k * forward + side * (width / 2 + 0.28 * k) * right for side in (1, -1)]
    room = clearance(np.array(aside), obstacles)
    spot = aside[int(room.argmax())] if float(room.max()) > LEG_ROOM * k else before
    return float(spot[0]), float(spot[1])


def find_waiting_time(
    track: Track, duration: float, start: float, others: Sequence[tuple[Track, float]], *, step: float = 0.3
) -> tuple[float, float]:
    """Return the seconds to wait before a walk that passes everybody, and the smallest gap then left.

    Args:
        track: Position of the walker, by seconds since setting out.
        duration: Seconds the walk takes.
        start: Earliest time of setting out.
        others: Each other person's position by absolute time, and the metres to keep from them.
        step: Waits are multiples of this many seconds, at most eleven of them.

    Returns:
        Seconds to wait, and the metres of gap beyond the wanted distance (negative: nobody can pass; the best wait).
    """
    moments = np.arange(0.0, duration + 0.1, 0.1)
    walk = [track(float(moment)) for moment in moments]
    best = (0.0, -1e9)
    for count in range(12):
        wait = step * count
        gap = min(
            (
                math.dist(place, other(start + wait + float(moment))) - keep
                for other, keep in others
                for moment, place in zip(moments, walk, strict=True)
            ),
            default=1e9,
        )
        if gap >= 0:
            return wait, gap
        if gap > best[1]:
            best = (wait, gap)
    return best
