"""Seated clothes: skirts, coats and jackets are draped once over the seated body and kept as the shape key ``sit``.

Position-based cloth at rest (notes on motion, section 5): gravity, stiff edges, the skinned body and the seat as
obstacles. The result is carried back through the skinning to the rest pose, so it is an ordinary shape key whose value
follows the sitting clip.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from numpy.typing import NDArray

from storyblender.blender.people.body import RiggedBody
from storyblender.blender.people.pack import PARTS, BodyPack, load_body_pack
from storyblender.blender.people.person import PersonBuild
from storyblender.geometry.solids import Floats

Ints = NDArray[np.int64]

KEY = "sit"
ROUNDS = 70
"""Steps of the simulation."""
GRAVITY = 0.0012
"""Metres of fall in a step."""
STRETCH, SQUEEZE = 0.5, 0.28
"""Stiffness of an edge that is longer, and shorter, than at rest."""
GAP = 0.012
"""Metres between cloth and skin on a person of 1.70 m."""
REACH = 0.09
"""Metres from an obstacle within which it pushes."""
THIGH, SHIN = (0.10, -1.0, -0.03), (0.02, 0.06, -1.0)
"""Directions of the left thigh and shin of a seated person."""


@dataclass
class SeatedPose:
    """The pose of a seated person, hips in place; B bones.

    Attributes:
        turns: (B, 3, 3) rotation of each bone from rest, armature space.
        shifts: (B, 3) translation: x becomes turn x + shift.
    """

    turns: Floats
    shifts: Floats

    def blended(self, weights: Floats) -> tuple[Floats, Floats]:
        """Return the matrix (V, 3, 3) and shift (V, 3) of each vertex for skin ``weights`` (V, B)."""
        count = len(self.turns)
        return (weights @ self.turns.reshape(count, 9)).reshape(-1, 3, 3), weights @ self.shifts


def seated_pose(body: RiggedBody) -> SeatedPose:
    """Return the pose of a person on a chair: thighs forward, shins down, feet flat."""
    turns = np.repeat(np.eye(3)[None], len(body.bone_names), axis=0)
    places = body.heads.copy()
    for index, (name, parent) in enumerate(zip(body.bone_names, body.parents, strict=True)):
        if parent < 0:
            continue
        places[index] = places[parent] + turns[parent] @ (body.heads[index] - body.heads[parent])
        stem, _, side = name.partition(".")
        mirrored = np.array((1.0 if side == "L" else -1.0, 1.0, 1.0))
        if stem in ("thigh", "shin"):
            rest = Vector(body.tails[index] - body.heads[index])
            aim = Vector(np.array(THIGH if stem == "thigh" else SHIN) * mirrored)
            turns[index] = np.array(rest.rotation_difference(aim).to_matrix())
        elif stem not in ("foot", "toe"):
            turns[index] = turns[parent]
    return SeatedPose(turns, places - np.einsum("bij,bj->bi", turns, body.heads))


def drape_seated(build: PersonBuild) -> list[bpy.types.Object]:
    """Add the shape key ``sit`` (value 0) to every garment that lies on the lap, and return those garments.

    Args:
        build: A finished person; the custom property ``drapes`` marks the garments.
    """
    pack = load_body_pack()
    if pack is None or build.stand_in:
        return []
    pose = seated_pose(build.body)
    skin, seat = _seated_skin(build.body, pose, pack)
    obstacles = [skin]
    draped = []
    for garment in (mesh for mesh in build.meshes if "drapes" in mesh):
        cloth = _DrapedCloth(garment, build.body, pose)
        if garment["drapes"]:
            cloth.settle(obstacles, seat)
            _write_key(garment, cloth.at_rest())
            draped.append(garment)
        if cloth.reaches_the_legs():
            faces = [list(polygon.vertices) for polygon in garment.data.polygons]
            obstacles.append(BVHTree.FromPolygons(cloth.points.tolist(), faces))
    return draped


def _seated_skin(body: RiggedBody, pose: SeatedPose, pack: BodyPack) -> tuple[BVHTree, float]:
    """Return the seated trunk and legs as an obstacle, and the height of the seat below them, metres."""
    matrices, shifts = pose.blended(body.weights)
    points = np.einsum("vij,vj->vi", matrices, body.vertices) + shifts
    trunk = [
        i for i, name in enumerate(body.bone_names) if name.split(".")[0] in ("hips", "spine", "chest", "thigh", "shin")
    ]
    near = body.weights[:, trunk].sum(1) > 0.5
    faces = pack.faces[pack.faces[:, 0] < PARTS["skin"].stop]
    tree = BVHTree.FromPolygons(points.tolist(), faces[near[faces].all(1)].tolist())
    thighs = [i for i, name in enumerate(body.bone_names) if name.startswith(("hips", "thigh"))]
    seat = float(np.percentile(points[body.weights[:, thighs].sum(1) > 0.8][:, 2], 1))
    return tree, seat


class _DrapedCloth:
    """A garment that falls onto obstacles."""

    def __init__(self, garment: bpy.types.Object, body: RiggedBody, pose: SeatedPose) -> None:
        mesh = garment.data
        flat = np.empty(len(mesh.vertices) * 3, np.float32)
        mesh.vertices.foreach_get("co", flat)
        self.rest = flat.reshape(-1, 3).astype(float)
        pairs = np.empty(len(mesh.edges) * 2, np.int32)
        mesh.edges.foreach_get("vertices", pairs)
        self.edges: Ints = pairs.reshape(-1, 2).astype(np.int64)
        self.lengths = np.linalg.norm(self.rest[self.edges[:, 0]] - self.rest[self.edges[:, 1]], axis=1)
        self.valence = np.maximum(np.bincount(self.edges.ravel(), minlength=len(self.rest)), 1)[:, None]
        weights = _vertex_weights(garment, body)
        self.matrices, self.shifts = pose.blended(weights)
        self.points = np.einsum("vij,vj->vi", self.matrices, self.rest) + self.shifts
        self.scale = body.stature / 1.7
        self.hips = float(body.heads[body.bone_names.index("hips")][2])
        waist = self.hips + 0.10 * self.scale
        arms = [i for i, name in enumerate(body.bone_names) if name.split(".")[0] in ("upper_arm", "forearm", "hand")]
        below = np.clip((waist - self.rest[:, 2]) / (0.06 * self.scale), 0, 1)
        self.free = (below * (weights[:, arms].sum(1) < 0.3))[:, None]
        thigh = body.bone_names.index("thigh.L")
        length = float(np.linalg.norm(body.tails[thigh] - body.heads[thigh]))
        self.edge_of_seat = float(body.heads[thigh][1]) - 0.8 * length

    def reaches_the_legs(self) -> bool:
        """Return whether it reaches the lap, so that other clothes can lie on it."""
        return float(self.rest[:, 2].max()) > 0.45 * self.hips > float(self.rest[:, 2].min())

    def settle(self, obstacles: Sequence[BVHTree], seat: float) -> None:
        """Let it fall onto ``obstacles``, the body first, and a seat at height ``seat`` until it rests."""
        for turn in range(ROUNDS):
            self.points[:, 2] -= GRAVITY * self.free[:, 0]
            for _ in range(3):
                self._hold_edges()
            if turn % 5 == 4:
                self._flatten()
            if turn % 2 or turn == ROUNDS - 1:
                for obstacle in obstacles:
                    self._push_vertices(obstacle)
                    self._push_edges(obstacle)
            on_seat = (
                (self.points[:, 1] > self.edge_of_seat) & (self.points[:, 2] < seat - 0.002) & (self.free[:, 0] > 0)
            )
            self.points[on_seat, 2] = seat - 0.002

    def at_rest(self) -> Floats:
        """Return the draped points (V, 3) carried back to the rest pose."""
        carried = np.einsum("vij,vj->vi", np.linalg.inv(self.matrices), self.points - self.shifts)
        return np.where(self.free > 0, carried, self.rest)

    def _spread(self, pairs: Ints, moves: Floats) -> Floats:
        """Return the sum of edge moves at each vertex, added at one end and subtracted at the other."""
        total = np.zeros_like(self.points)
        for axis in range(3):
            total[:, axis] += np.bincount(pairs[:, 0], moves[:, axis], len(self.points))
            total[:, axis] -= np.bincount(pairs[:, 1], moves[:, axis], len(self.points))
        return total

    def _hold_edges(self) -> None:
        """Pull edges back to their rest lengths."""
        span = self.points[self.edges[:, 1]] - self.points[self.edges[:, 0]]
        length = np.linalg.norm(span, axis=1)
        pull = np.where(length > self.lengths, STRETCH, SQUEEZE) * (length - self.lengths) / np.maximum(length, 1e-6)
        self.points += self._spread(self.edges, span * pull[:, None]) / self.valence * 1.6 * self.free

    def _flatten(self) -> None:
        """Smooth the cloth."""
        span = self.points[self.edges[:, 1]] - self.points[self.edges[:, 0]]
        self.points += self._spread(self.edges, span) / self.valence * 0.12 * self.free

    def _push_vertices(self, obstacle: BVHTree) -> None:
        """Push vertices out of an obstacle."""
        loose = np.flatnonzero(self.free[:, 0] > 0)
        hit, moves = _pushes(obstacle, self.points[loose], GAP * self.scale)
        self.points[loose[hit]] += 0.8 * moves

    def _push_edges(self, obstacle: BVHTree) -> None:
        """Push the middles of edges out too: vertices alone let legs cut through a coarse skirt or coat."""
        loose = np.flatnonzero(self.free[self.edges, 0].max(1) > 0)
        hit, moves = _pushes(obstacle, self.points[self.edges[loose]].mean(1), 0.6 * GAP * self.scale)
        for end in (0, 1):
            vertices = self.edges[loose[hit], end]
            np.add.at(self.points, vertices, moves * self.free[vertices])


def _pushes(obstacle: BVHTree, points: Floats, gap: float) -> tuple[Ints, Floats]:
    """Return the rows of ``points`` within ``gap`` of an obstacle or inside it, and the move that takes each out."""
    hit: list[int] = []
    moves: list[tuple[float, float, float]] = []
    find = obstacle.find_nearest
    for row, point in enumerate(map(Vector, points.tolist())):
        nearest, normal, _, _ = find(point, REACH)
        if nearest is not None and (depth := gap - (point - nearest).dot(normal)) > 0:
            hit.append(row)
            moves.append((normal.x * depth, normal.y * depth, normal.z * depth))
    return np.array(hit, np.int64), np.array(moves, float).reshape(-1, 3)


def _vertex_weights(garment: bpy.types.Object, body: RiggedBody) -> Floats:
    """Return the skin weights (V, B) in the order of the body's bones."""
    column = {group.index: body.bone_names.index(group.name) for group in garment.vertex_groups}
    weights = np.zeros((len(garment.data.vertices), len(body.bone_names)))
    for vertex in garment.data.vertices:
        for entry in vertex.groups:
            weights[vertex.index, column[entry.group]] += entry.weight
    return weights / weights.sum(1, keepdims=True)


def _write_key(garment: bpy.types.Object, points: Floats) -> None:
    """Add the shape key ``sit`` with these points."""
    if garment.data.shape_keys is None:
        garment.shape_key_add(name="Basis", from_mix=False)
    block = garment.shape_key_add(name=KEY, from_mix=False)
    block.data.foreach_set("co", points.astype(np.float32).ravel())
    block.value = 0.0
