"""Motion by hand, read back from a saved story: what people and things do there that is not what was baked.

Read is the pose that Blender evaluates, so it counts alike whether a person keyed a bone above the strips, changed keys
in a strip, moved the strip, or put a constraint or a control of the rig to use.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field

import bpy
import numpy as np

from storyblender.blender.hiding import key_hidden
from storyblender.blender.motion.bake import LEG_TOLERANCE, LEGS, PLACE_TOLERANCE, TOLERANCE, reduce_keys
from storyblender.blender.motion.baked import bag_of, quaternions, read_channels
from storyblender.blender.story_values import ORIGIN
from storyblender.catalog.skeleton import SKELETON
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.geometry.solids import Floats
from storyblender.memory.blend_values import BlendReading, NodeValues, SceneValues
from storyblender.memory.motion_by_hand import HIPS_PLACE, PLACE, ROOT, TURN, HandChannel, HandMotionRead, MotionByHand

PACK = "pack"
"""Custom property of a story's scene: the path of the pack that it was compiled from."""
_MOVED, _TURNED = 0.0005, 0.004
"""Metres, radians: less is the rounding of keys."""
_ROUND = 6
"""Digits of what is kept."""
Sampled = dict[str, Floats]
"""Values (N, C) by name of the channel."""


@dataclass
class _Seen:
    """What is seen of an object in a shot: frames from its start, world matrices, and poses of bones."""

    frames: list[int] = field(default_factory=list)
    worlds: list[Floats] = field(default_factory=list)
    poses: dict[str, list[Floats]] = field(default_factory=dict)


def read_by_hand(reading: BlendReading, files: Folder) -> tuple[HandMotionRead, ...]:
    """Return what was animated by hand in the open file.

    Args:
        reading: Of the file.
        files: The project, whose packs say what was baked; without its pack, all of a changed shot counts.
    """
    saved = {scene.name: scene for scene in reading.saved.scenes}
    return tuple(
        motion
        for scene in (reading.compiled.scenes if reading.compiled is not None else ())
        if scene.name in saved
        for motion in _in_scene(scene, saved[scene.name], files)
    )


def _in_scene(compiled: SceneValues, saved: SceneValues, files: Folder) -> Iterator[HandMotionRead]:
    now = {node.origin: node for node in reversed(saved.nodes)}
    changed = [node for node in compiled.nodes if node.strips and node.name in now and _moves(node, now[node.name])]
    if not changed:
        return
    scene = bpy.data.scenes[compiled.name]
    objects = {str(obj.get(ORIGIN)): obj for obj in reversed(scene.objects)}
    seen = _watch(scene, [(node, now[node.name], objects[node.name]) for node in changed])
    baked = _baked(scene, files, sorted({strip.name for node in changed for strip in node.strips}))
    for node in changed:
        obj = objects[node.name]
        for strip in node.strips:
            there = seen[node.name, strip.name]
            if not there.frames:
                continue
            channels = _person(obj.data, there) if obj.type == "ARMATURE" else _thing(there)
            was = _as_baked(baked.get(strip.name), node.asset_id, there.frames, person=obj.type == "ARMATURE")
            found = {name: values for name, values in channels.items() if _differs(name, values, was.get(name))}
            if found and all(np.isfinite(values).all() for values in found.values()):
                motion = MotionByHand(channels={name: _keys(name, there, values) for name, values in found.items()})
                yield HandMotionRead(
                    scene=compiled.name, shot=strip.name, node_id=node.node_id, asset_id=node.asset_id, motion=motion
                )


def _moves(before: NodeValues, after: NodeValues) -> bool:
    """Return whether anything that moves an object is otherwise than it was compiled."""
    return (before.strips, before.action) != (after.strips, after.action) or bool(
        before.posing and before.posing != after.posing
    )


def _watch(
    scene: bpy.types.Scene, changed: Sequence[tuple[NodeValues, NodeValues, bpy.types.Object]]
) -> dict[tuple[str, str], _Seen]:
    """Play a scene and return what is seen of objects, by name and strip, while a strip of theirs plays."""
    bpy.context.window.scene = scene
    for obj in scene.objects:
        for modifier in obj.modifiers:
            modifier.show_viewport = False  # only poses count
    for _, _, obj in changed:
        key_hidden(obj, [(scene.frame_start, True)])  # Blender evaluates no hidden armature
    seen = {(node.name, strip.name): _Seen() for node, _, _ in changed for strip in node.strips}
    spans = {(strip.name, round(strip.start), round(strip.end)) for node, _, _ in changed for strip in node.strips}
    for name, start, end in sorted(spans, key=lambda span: span[1]):
        for frame in range(start, end):
            scene.frame_set(frame)
            graph = bpy.context.evaluated_depsgraph_get()
            for node, after, obj in changed:
                there = seen.get((node.name, name))
                if there is None or not any(strip.start <= frame < strip.end for strip in after.strips):
                    continue
                posed = obj.evaluated_get(graph)
                there.frames.append(frame - start)
                there.worlds.append(np.array(posed.matrix_world))
                for bone in posed.pose.bones if obj.type == "ARMATURE" else ():
                    there.poses.setdefault(bone.name, []).append(np.array(bone.matrix))
    return seen


def _person(rig: bpy.types.Armature, seen: _Seen) -> Sampled:
    """Return the channels of a person: what the armature object is tilted by goes to the hips."""
    worlds = np.array(seen.worlds)
    yaw = np.unwrap(np.arctan2(worlds[:, 1, 0], worlds[:, 0, 0]))
    flat = np.tile(np.eye(4), (len(yaw), 1, 1))
    flat[:, 0, 0], flat[:, 0, 1], flat[:, 1, 0], flat[:, 1, 1] = np.cos(yaw), -np.sin(yaw), np.sin(yaw), np.cos(yaw)
    flat[:, :3, 3] = worlds[:, :3, 3]
    tilt = np.linalg.inv(flat) @ worlds
    channels: Sampled = {ROOT: np.c_[worlds[:, :3, 3], yaw]}
    for bone in SKELETON:
        if bone.name not in seen.poses:
            continue
        rest, pose = rig.bones[bone.name].matrix_local, np.array(seen.poses[bone.name])
        if bone.parent:
            above = np.linalg.inv(np.array(seen.poses[bone.parent]))
            local = np.array(rig.bones[bone.parent].matrix_local.inverted() @ rest)
            basis = np.linalg.inv(local) @ above @ pose
        else:
            basis = np.array(rest.inverted()) @ tilt @ pose
            channels[HIPS_PLACE] = basis[:, :3, 3]
        channels[bone.name] = quaternions(basis)
    return channels


def _thing(seen: _Seen) -> Sampled:
    worlds = np.array(seen.worlds)
    return {PLACE: worlds[:, :3, 3], TURN: quaternions(worlds)}


def _baked(scene: bpy.types.Scene, files: Folder, shots: Sequence[str]) -> dict[str, bpy.types.Action]:
    """Return the actions of shots as they were baked, from the scene's pack; none where that is gone."""
    with suppress(InputError, OSError):
        path = str(files.path(str(scene.get(PACK, ""))))
        with bpy.data.libraries.load(path) as (source, target):
            names = [name for name in shots if name in source.actions]
            target.actions = list(names)
        return dict(zip(names, target.actions, strict=True))
    return {}


def _as_baked(action: bpy.types.Action | None, asset_id: str, frames: Sequence[int], *, person: bool) -> Sampled:
    """Return the channels that were baked, by the names that a motion by hand gives them."""
    slot = action.slots.get(f"OB{asset_id}") if action is not None else None
    bag = bag_of(action, slot)
    if bag is None:
        return {}
    curves = read_channels(bag, np.array(frames, float))
    if not person:
        return {PLACE: curves["location"], TURN: curves["rotation_quaternion"]}
    found = {bone.name: curves.get(f'pose.bones["{bone.name}"].rotation_quaternion') for bone in SKELETON}
    return {
        ROOT: np.c_[curves["location"], curves["rotation_euler"][:, 2]],
        HIPS_PLACE: curves['pose.bones["hips"].location'],
        **{name: values for name, values in found.items() if values is not None},
    }


def _differs(name: str, values: Floats, baked: Floats | None) -> bool:
    if baked is None:
        return True
    if name == ROOT:
        turned = np.abs((values[:, 3] - baked[:, 3] + np.pi) % (2 * np.pi) - np.pi).max() > _TURNED
        return bool(turned or np.abs(values[:, :3] - baked[:, :3]).max() > _MOVED)
    if name in (HIPS_PLACE, PLACE):
        return bool(np.abs(values - baked).max() > _MOVED)
    turns = baked / np.linalg.norm(baked, axis=1, keepdims=True)
    apart = np.minimum(np.linalg.norm(values - turns, axis=1), np.linalg.norm(values + turns, axis=1))
    return bool(4 * np.arcsin(np.clip(apart / 2, 0, 1)).max() > _TURNED)


def _keys(name: str, seen: _Seen, values: Floats) -> HandChannel:
    """Return as few keys as keep to half the tolerance of what is baked."""
    turns = LEG_TOLERANCE if name.startswith(LEGS) else TOLERANCE / 4
    tolerance = PLACE_TOLERANCE / 2 if name in (ROOT, HIPS_PLACE, PLACE) else turns
    kept = reduce_keys(np.array(seen.frames, float), values, tolerance)
    rows = np.round(values[kept], _ROUND) + 0.0
    return HandChannel(
        frames=tuple(seen.frames[index] for index in kept), values=tuple(tuple(row) for row in rows.tolist())
    )
