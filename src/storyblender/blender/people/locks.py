"""Single locks of hair: flat locks, curls, the knot of a bun; and the body and clothes that hair lies on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from storyblender.blender.people.face import bone_weights
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.scalp import Scalp
from storyblender.blender.people.sheet import Sheet, rigid_sheet
from storyblender.blender.people.worn_layers import polygons
from storyblender.catalog.hair import HairSpec
from storyblender.geometry.solids import Floats, skin_faces

KNOT = np.array((0.0, 0.99, 0.10)) / np.linalg.norm((0.0, 0.99, 0.10))
"""Where hair is tied, low enough to be under the brim of a hat."""
DROP = 0.026
"""Metres between the rows of a lock that hangs."""
ROWS = 7
_FAR = 0.6
"""Metres behind the head at which rays to the back start."""


@dataclass
class Strand:
    """The middle line of a lock.

    Attributes:
        points: (N, 3) metres.
        outward: (N, 3) directions away from the head or body.
    """

    points: Floats
    outward: Floats


class HairSupport:
    """The body and clothes that long hair lies on.

    Args:
        figure: The body.
        clothes: Sheets of the clothes.
    """

    def __init__(self, figure: BodyFigure, clothes: Sequence[Sheet]) -> None:
        skin = figure.part("skin")
        low = skin.points[:, 2] > figure.heights["chest"] - 0.1 * figure.scale
        self._sheets = [skin.keep_faces(low[skin.faces].all(1)), *clothes]
        self._trees = [BVHTree.FromPolygons(sheet.points.tolist(), polygons(sheet)) for sheet in self._sheets]
        self._figure = figure

    def behind(self, point: Floats) -> float:
        """Return how far back (y, metres) body and clothes reach at a point's x and height."""
        origin = Vector((point[0], point[1] + _FAR, point[2]))
        hits = [tree.ray_cast(origin, Vector((0.0, -1.0, 0.0)), _FAR + 0.3)[0] for tree in self._trees]
        return max((hit.y for hit in hits if hit is not None), default=-_FAR)

    def clear(self, point: Floats, gap: float) -> Floats:
        """Return ``point`` (3,) in metres, moved off the face and at least ``gap`` metres outside body and clothes."""
        return self.push_out(self._aside(point), gap)

    def _aside(self, point: Floats) -> Floats:
        """Return ``point`` moved sideways off the face."""
        scale = self._figure.head_scale
        depth = self._figure.joint("head")[1] - point[1]
        least = float(np.interp(depth, (0.0, 0.05 * scale), (0.0, 0.072 * scale)))
        if point[2] < self._figure.heights["neck"] + 0.02 * scale or abs(point[0]) >= least:
            return point
        return np.array((least if point[0] > 0 else -least, point[1], point[2]))

    def push_out(self, point: Floats, gap: float) -> Floats:
        """Return ``point`` (3,) in metres, moved at least ``gap`` metres outside body and clothes."""
        for tree in self._trees:
            nearest, normal, _, _ = tree.find_nearest(Vector(point), 0.08)
            if nearest is not None:
                depth = gap - (Vector(point) - nearest).dot(normal)
                if depth > 0:
                    point = point + np.array(normal) * depth
        return point


def hair_weights(figure: BodyFigure, points: Floats) -> Floats:
    """Return bone weights (V, 35) of hair: the head's, blending to the chest's on the shoulders.

    Args:
        figure: The body.
        points: (V, 3) metres.
    """
    neck, chest = figure.heights["neck"], figure.heights["chest"]
    share = np.interp(points[:, 2], (chest, neck + 0.05 * figure.scale), (0.55, 0.0))[:, None]
    return (1 - share) * bone_weights("head") + share * bone_weights("upper_chest")


def flat_lock(figure: BodyFigure, strand: Strand, spec: HairSpec, width: float) -> Sheet:
    """Return a lock along a strand: a strip that tapers to its tip.

    Args:
        figure: The body; its bones carry the lock.
        strand: Middle line of the lock.
        spec: The hairstyle, for the width at the tip.
        width: Metres, on a head of an adult's size.
    """
    count = ROWS
    at = np.linspace(0, len(strand.points) - 1, count)
    index = np.arange(len(strand.points))
    points = np.stack([np.interp(at, index, strand.points[:, axis]) for axis in range(3)], 1)
    outward = np.stack([np.interp(at, index, strand.outward[:, axis]) for axis in range(3)], 1)
    along = np.gradient(points, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    outward -= along * (outward * along).sum(1, keepdims=True)
    outward /= np.maximum(np.linalg.norm(outward, axis=1, keepdims=True), 1e-9)
    across = np.cross(along, outward)
    u = np.linspace(0, 1, count)
    profile = np.interp(u, (0, 0.25, 0.65, 1), (0.4, 1.0, max(0.85, spec.tip), spec.tip))
    half = (0.5 * width * figure.head_scale * profile)[:, None]
    sink = 0.45 * half * outward
    rows = np.stack([points - across * half - sink, points + outward * half * 0.25, points + across * half - sink], 1)
    flat = rows.reshape(-1, 3)
    return rigid_sheet(flat, skin_faces(count, 3, False), hair_weights(figure, flat))


def ball(figure: BodyFigure, center: Floats, radii: Floats, spin: Floats, segments: int = 7, rings: int = 5) -> Sheet:
    """Return a small ellipsoid of hair.

    Args:
        figure: The body; its bones carry the hair.
        center: (3,) metres.
        radii: Semi-axes, (3,) metres.
        spin: Rotation matrix, (3, 3).
        segments: Faces around.
        rings: Faces from pole to pole.
    """
    points, faces = _unit_ball(segments, rings)
    placed = center + (points * radii) @ spin.T
    return rigid_sheet(placed, list(faces), hair_weights(figure, placed))


@cache
def _unit_ball(segments: int, rings: int) -> tuple[Floats, tuple[tuple[int, ...], ...]]:
    """Return points and faces of a unit sphere."""
    points = [np.array((0.0, 0.0, 1.0))]
    for ring in range(1, rings):
        tilt = np.pi * ring / rings
        for step in range(segments):
            turn = 2 * np.pi * step / segments
            points.append(np.array((np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt))))
    points.append(np.array((0.0, 0.0, -1.0)))
    last = len(points) - 1
    faces: list[tuple[int, ...]] = []
    for step in range(segments):
        after = (step + 1) % segments
        faces.append((0, 1 + step, 1 + after))
        for ring in range(rings - 2):
            a, b = 1 + ring * segments, 1 + (ring + 1) * segments
            faces.append((a + step, b + step, b + after, a + after))
        end = 1 + (rings - 2) * segments
        faces.append((end + step, last, end + after))
    return np.array(points), tuple(faces)


def round_curl(scalp: Scalp, root: Floats, rng: np.random.Generator) -> Sheet:
    """Return one round curl on the hair.

    Args:
        scalp: The head, with the hairstyle.
        root: Unit direction (3,) from the middle of the head to the curl.
        rng: Varies its size, depth and turn.
    """
    spec, scale = scalp.spec, scalp.figure.head_scale
    size = 0.5 * spec.width * scale * rng.uniform(0.75, 1.25)
    found = scalp.hair_surface(root, -rng.uniform(0.1, 0.8) * size)
    center = found[0] if found else scalp.center
    spin, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    spin = spin * np.sign(np.linalg.det(spin))
    return ball(scalp.figure, center, size * np.array((1.0, 0.85, 0.7)), spin, 7, 4)


def wound_bun(scalp: Scalp, rng: np.random.Generator) -> list[Sheet]:
    """Return the locks of a bun at the back of the head.

    Args:
        scalp: The head, with the hairstyle.
        rng: Varies how the locks are wound.
    """
    figure, scale = scalp.figure, scalp.figure.head_scale
    found = scalp.hair_surface(KNOT, 0.020 * scale)
    center = found[0] if found else scalp.center
    radii = np.array((0.046, 0.038, 0.042)) * scale
    locks = [ball(figure, center, radii * 0.94, np.eye(3), 10, 7)]
    right = np.array((1.0, 0.0, 0.0))
    up = np.cross(KNOT, right)
    for step in range(9):
        turn = 2 * np.pi * step / 9 + rng.normal(0, 0.1)
        angle = np.linspace(0.25, 1.75, ROWS)[:, None]
        wind = turn + 1.5 * angle
        directions = KNOT * np.cos(angle) + (right * np.cos(wind) + up * np.sin(wind)) * np.sin(angle)
        locks.append(flat_lock(figure, Strand(center + directions * radii, directions), scalp.spec, 0.030))
    return locks
