"""Who is inside the furniture, and how deep: every person's skin against every thing, frame by frame.

The skin is posed with the motion solver's own body data, so the test needs no evaluated meshes. Hands are left out:
they hold things.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from numpy.typing import NDArray

from storyblender.blender.people.body import Body
from storyblender.memory.measure import Collision

TOLERANCE = 0.03
"""Metres: cushions and cloth give way this far."""
EVERY = 4
"""Every which skin vertex is tested."""
_HANDS = ("hand.", "thumb.", "index1.", "index2.", "fingers1.", "fingers2.")
_PROBES = (Vector((0.06, 0.11, 1.0)), Vector((1.0, 0.07, 0.05)), Vector((0.05, 1.0, 0.09)))
"""Directions of the parity rays, a little off the axes so that they do not graze edges."""

Floats = NDArray[np.float64]


def find_collisions(
    scene: bpy.types.Scene, bodies: Mapping[str, Body], frames: Mapping[str, range], step: int = 8
) -> list[Collision]:
    """Return the deepest collision of each person with each thing in each shot.

    Args:
        scene: The packed scene, in the window.
        bodies: Person's asset id to body.
        frames: Shot name to its timeline frames.
        step: Frames between the tests.
    """
    things = [obj for obj in scene.objects if obj.get("kind") == "prop" and obj.animation_data is None]
    trees = {obj.name: BVHTree.FromPolygons(*_polygons(obj.data)) for obj in things}
    rigs = {str(obj["asset_id"]): obj for obj in scene.objects if obj.type == "ARMATURE"}
    worst: dict[tuple[str, str, str], Collision] = {}
    for shot, span in frames.items():
        for frame in range(span.start, span.stop, step):
            scene.frame_set(frame)
            for asset_id, body in bodies.items():
                rig = rigs.get(asset_id)
                if rig is None or rig.hide_render:
                    continue
                for collision in _of_person(shot, frame - span.start, asset_id, posed_skin(rig, body), things, trees):
                    key = (shot, asset_id, collision.node_id)
                    if key not in worst or collision.depth > worst[key].depth:
                        worst[key] = collision
    return sorted(worst.values(), key=lambda item: -item.depth)


def posed_skin(rig: bpy.types.Object, body: Body) -> Floats:
    """Return (n, 3) world positions of every EVERYth skin vertex that is not on a hand."""
    hands = np.array([name.startswith(_HANDS) for name in body.bone_names])
    free = np.flatnonzero(body.weights[:, hands].sum(axis=1) < 0.1)[::EVERY]
    world = np.array(rig.matrix_world)
    matrices = np.stack(
        [
            world @ np.array(rig.pose.bones[name].matrix) @ np.linalg.inv(rest)
            for name, rest in zip(body.bone_names, body.rest, strict=True)
        ]
    )
    blended = np.einsum("vb,bij->vij", body.weights[free], matrices)
    points = np.c_[body.vertices[free], np.ones(len(free))]
    return np.einsum("vij,vj->vi", blended, points)[:, :3]


def _of_person(
    shot: str,
    frame: int,
    asset_id: str,
    skin: Floats,
    things: list[bpy.types.Object],
    trees: Mapping[str, BVHTree],
) -> Iterator[Collision]:
    for thing in things:
        if thing.hide_render:
            continue
        local = np.array(thing.matrix_world.inverted())
        points = skin @ local[:3, :3].T + local[:3, 3]
        low, high = np.array(thing.bound_box).min(axis=0), np.array(thing.bound_box).max(axis=0)
        near = points[((points > low + TOLERANCE) & (points < high - TOLERANCE)).all(axis=1)]
        depth = max((_depth(trees[thing.name], Vector(point)) for point in near), default=0.0)
        if depth > TOLERANCE:
            yield Collision(shot=shot, frame=frame, asset_id=asset_id, node_id=str(thing["node_id"]), depth=depth)


def _depth(tree: BVHTree, point: Vector) -> float:
    """Metres under the surface; 0 outside. Inside means an odd number of walls in most directions."""
    nearest = tree.find_nearest(point)[3]
    if nearest is None or nearest <= TOLERANCE:
        return 0.0
    odd = sum(_walls(tree, point, direction) % 2 for direction in _PROBES)
    return float(nearest) if odd >= 2 else 0.0


def _walls(tree: BVHTree, point: Vector, direction: Vector) -> int:
    count, origin = 0, point
    while count < 64:
        hit, _, _, _ = tree.ray_cast(origin, direction)
        if hit is None:
            break
        count += 1
        origin = hit + direction.normalized() * 1e-4
    return count


def _polygons(mesh: bpy.types.Mesh) -> tuple[list[Vector], list[tuple[int, ...]]]:
    return [vertex.co.copy() for vertex in mesh.vertices], [tuple(face.vertices) for face in mesh.polygons]
