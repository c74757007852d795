"""Collisions of people with props and with each other: skin against meshes, bone capsules against capsules.

The skin is posed with the motion solver's body data, so no evaluated meshes are needed. Hands are left out because they
hold props.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from functools import cached_property

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from storyblender.blender.people.body import RiggedBody
from storyblender.geometry.limbs import BONE_RADII, capsule_penetration
from storyblender.geometry.solids import Floats
from storyblender.look.surface import Surface
from storyblender.memory.measure import Collision

TOLERANCE = 0.03
"""Metres: cushions and cloth give way this far."""
STILL = 0.01
"""Metres; a body that moved less since the last test is not tested again."""
_EMBRACED = 0.12
"""Largest penetration depth in metres that an embrace may have: flesh and cloth give way."""
_NEAR = 1.8
"""Largest distance in metres between the centres of two bodies, standing or lying, that can touch."""
VERTEX_STEP = 4
"""Every how many-th skin vertex is tested."""
_HANDS = ("hand.", "thumb.", "index1.", "index2.", "fingers1.", "fingers2.")
_PROBES = (Vector((0.06, 0.11, 1.0)), Vector((1.0, 0.07, 0.05)), Vector((0.05, 1.0, 0.09)))
"""Directions of the parity rays, a little off the axes so that they do not graze edges."""


class _SolidProp:
    """A fixed prop: its surface and bounds in its own space."""

    def __init__(self, obj: bpy.types.Object) -> None:
        self.obj, self.node_id = obj, str(obj["node_id"])
        self._local = np.array(obj.matrix_world.inverted())
        corners = np.array(obj.bound_box)
        self._low, self._high = corners.min(axis=0) + TOLERANCE, corners.max(axis=0) - TOLERANCE

    @cached_property
    def _tree(self) -> BVHTree:
        """The surface of the prop."""
        mesh = self.obj.data
        points, faces = [vertex.co.copy() for vertex in mesh.vertices], [tuple(face.vertices) for face in mesh.polygons]
        return BVHTree.FromPolygons(points, faces)

    def depth(self, skin: Floats) -> float:
        """Return how far the deepest of the world points ``skin`` (N, 3) is below the surface, metres; 0 if none is."""
        points = skin @ self._local[:3, :3].T + self._local[:3, 3]
        near = points[((points > self._low) & (points < self._high)).all(axis=1)]
        deepest = 0.0
        while len(near):
            free, depth = _clearance(self._tree, Vector(near[0]))
            deepest = max(deepest, depth)
            others = near[1:]
            near = others[((others - near[0]) ** 2).sum(axis=1) >= free**2]
        return deepest


class _PosedSkin:
    """Sample vertices of a person's skin, without the hands."""

    def __init__(self, asset_id: str, rig: bpy.types.Object, body: RiggedBody) -> None:
        self.asset_id, self.rig, self._names = asset_id, rig, body.bone_names
        hands = np.array([name.startswith(_HANDS) for name in body.bone_names])
        free = np.flatnonzero(body.weights[:, hands].sum(axis=1) < 0.1)[::VERTEX_STEP]
        self._weights, self._points = body.weights[free], np.c_[body.vertices[free], np.ones(len(free))]
        self._inverse_rest = np.linalg.inv(body.rest)
        self.stature = float(np.ptp(body.vertices[:, 2]))

    def limbs(self) -> tuple[Floats, Floats]:
        """Return the (n, 2, 3) ends of trunk, head and leg bones in the world, and their (n,) radii, metres."""
        bones = [bone for bone in self.rig.pose.bones if bone.name.split(".")[0] in BONE_RADII]
        ends = np.array([[(*bone.head, 1.0), (*bone.tail, 1.0)] for bone in bones])
        world = ends @ np.array(self.rig.matrix_world).T
        radii: Floats = np.array(
            [self.stature * BONE_RADII[bone.name.split(".")[0]] for bone in bones], dtype=np.float64
        )
        return np.asarray(world[..., :3], dtype=np.float64), radii

    def posed(self) -> Floats:
        """Return the (n, 3) world positions of the samples at the scene's frame."""
        poses = np.array([self.rig.pose.bones[name].matrix for name in self._names])
        matrices = np.array(self.rig.matrix_world) @ poses @ self._inverse_rest
        blended = np.einsum("vb,bij->vij", self._weights, matrices)
        return np.einsum("vij,vj->vi", blended, self._points)[:, :3]


def find_collisions(
    scene: bpy.types.Scene, bodies: Mapping[str, RiggedBody], frames: Mapping[str, range], step: int = 8
) -> list[Collision]:
    """Return the deepest collision of each person with each object and each other person in each shot.

    Args:
        scene: The packed scene, active in Blender's window.
        bodies: Asset id of each person to body.
        frames: Shot name to the timeline frames of the shot.
        step: Frames between two tests; a person who has not moved since the last one is skipped.
    """
    scene.frame_set(min((span.start for span in frames.values()), default=scene.frame_start))
    objects = (obj for obj in scene.objects if obj.get("kind") == "prop" and obj.animation_data is None)
    props = [_SolidProp(obj) for obj in objects if obj.get("surface") != int(Surface.SMOKE)]
    rigs = {str(obj["asset_id"]): obj for obj in scene.objects if obj.type == "ARMATURE"}
    people = [_PosedSkin(asset_id, rigs[asset_id], body) for asset_id, body in bodies.items() if asset_id in rigs]
    worst: dict[tuple[str, str, str], Collision] = {}
    for shot, span in frames.items():
        tested: dict[str, Floats] = {}
        for frame in range(span.start, span.stop, step):
            scene.frame_set(frame)
            shown = [person for person in people if not person.rig.hide_render]
            for collision in _people_collisions(shot, frame - span.start, shown):
                _keep_deepest(worst, collision)
            for person in shown:
                skin, last = person.posed(), tested.get(person.asset_id)
                if last is not None and np.abs(skin - last).max() < STILL:
                    continue
                tested[person.asset_id] = skin
                for collision in _prop_collisions(shot, frame - span.start, person.asset_id, skin, props):
                    _keep_deepest(worst, collision)
    return sorted(worst.values(), key=lambda item: -item.depth)


def _keep_deepest(worst: dict[tuple[str, str, str], Collision], collision: Collision) -> None:
    """Store a collision if it is the deepest of its shot and pair."""
    key = (collision.shot, collision.asset_id, collision.node_id)
    if key not in worst or collision.depth > worst[key].depth:
        worst[key] = collision


def _people_collisions(shot: str, frame: int, people: list[_PosedSkin]) -> Iterator[Collision]:
    """Yield the collisions between people, pair by pair."""
    posed = [(person.asset_id, *person.limbs()) for person in people]
    for (one, ends, radii), (other, others, widths) in itertools.combinations(posed, 2):
        apart = np.abs(ends.mean(axis=(0, 1)) - others.mean(axis=(0, 1))).max()
        if apart > _NEAR:
            continue
        depth = capsule_penetration(ends, radii, others, widths)
        if depth > _EMBRACED:
            yield Collision(shot=shot, frame=frame, asset_id=one, node_id=other, depth=depth)


def _prop_collisions(
    shot: str, frame: int, asset_id: str, skin: Floats, props: list[_SolidProp]
) -> Iterator[Collision]:
    """Yield the collisions of a person's ``skin`` (N, 3) with props."""
    for prop in props:
        depth = 0.0 if prop.obj.hide_render else prop.depth(skin)
        if depth > TOLERANCE:
            yield Collision(shot=shot, frame=frame, asset_id=asset_id, node_id=prop.node_id, depth=depth)


def _clearance(tree: BVHTree, point: Vector) -> tuple[float, float]:
    """Return the free radius around a point outside, else its depth below the surface, metres; the other value is 0.

    Inside means an odd number of surfaces in most directions.
    """
    nearest = tree.find_nearest(point)[3]
    if nearest is None or nearest <= TOLERANCE:
        return 0.0, 0.0
    first, second = (_count_surfaces(tree, point, direction) % 2 for direction in _PROBES[:2])
    inside = first if first == second else _count_surfaces(tree, point, _PROBES[2]) % 2
    return (0.0, float(nearest)) if inside else (float(nearest), 0.0)


def _count_surfaces(tree: BVHTree, point: Vector, direction: Vector) -> int:
    """Return how many surfaces a ray crosses, at most 64."""
    count, origin = 0, point
    while count < 64:
        hit, _, _, _ = tree.ray_cast(origin, direction)
        if hit is None:
            break
        count += 1
        origin = hit + direction.normalized() * 1e-4
    return count
