"""``python -m storyblender.blender.models.fbx_motion FILE OUT``: the motion of a skeleton in an FBX, as numbers.

Runs in a process of its own with bounded time and memory. Meshes, pictures, lights and cameras of the file are thrown
away before anything is played.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix

from storyblender.blender.models.blend_reader import bound_process
from storyblender.file_reading_process import PROBLEM
from storyblender.geometry.solids import Floats
from storyblender.library.mocap.fbx import MOTION

MOST_BONES, MOST_SECONDS = 600, 121
"""Of a skeleton, and of its motion; what comes after is not played."""


def main() -> None:
    """Read, write and end at once: the way out of an interpreter with Blender in it may hang."""
    path, out = Path(sys.argv[1]), Path(sys.argv[2])
    bound_process()
    status = 0
    try:
        problem = _read(path, out)
        if problem:
            (out / PROBLEM).write_text(problem, encoding="utf-8")
    except (RuntimeError, OSError, ValueError, MemoryError, ReferenceError, KeyError, IndexError, TypeError) as error:
        print(error, file=sys.stderr)
        status = 1
    sys.stdout.flush()
    os._exit(status)


def _read(path: Path, out: Path) -> str:
    """Write the motion of the largest skeleton that moves; return why there is none, or an empty text."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.fbx(filepath=str(path), use_image_search=False, use_custom_props=False, anim_offset=0.0)
    rigs = [obj for obj in bpy.data.objects if obj.type == "ARMATURE"]
    if not rigs:
        return "it has no skeleton"
    rig = max(rigs, key=lambda obj: (_action(obj) is not None, len(obj.data.bones)))
    action = _action(rig)
    if action is None:
        return "its skeleton does not move"
    if len(rig.data.bones) > MOST_BONES:
        return f"it is too large: {len(rig.data.bones)} bones"
    for obj in [each for each in bpy.data.objects if each.type not in ("ARMATURE", "EMPTY")]:
        bpy.data.objects.remove(obj)
    scene = bpy.context.scene
    rate = scene.render.fps / scene.render.fps_base
    first, last = (round(frame) for frame in action.frame_range)
    last = min(last, first + round(MOST_SECONDS * rate))
    bones = list(rig.data.bones)  # parents come before their children
    scene.frame_set(first)
    world = np.array(rig.matrix_world)
    rest = np.array([world @ np.array(bone.matrix_local) for bone in bones], float)
    places, turns = np.zeros((last - first + 1, len(bones), 3)), np.zeros((last - first + 1, len(bones), 3, 3))
    still = np.array([_turn(matrix).T for matrix in rest])
    for index, frame in enumerate(range(first, last + 1)):
        scene.frame_set(frame)
        world = np.array(rig.matrix_world)
        posed = np.array([world @ np.array(rig.pose.bones[bone.name].matrix) for bone in bones])
        places[index] = posed[:, :3, 3]
        turns[index] = np.array([_turn(matrix) for matrix in posed]) @ still
    number = {bone.name: index for index, bone in enumerate(bones)}
    np.savez(
        out / MOTION,
        names=np.array([bone.name for bone in bones]),
        parents=np.array([number[bone.parent.name] if bone.parent else -1 for bone in bones]),
        rest=np.array([matrix[:3, 3] for matrix in rest]),
        turns=turns,
        places=places,
        rate=np.array(rate),
    )
    return ""


def _action(obj: bpy.types.Object) -> bpy.types.Action | None:
    """Return the action that an object plays."""
    return obj.animation_data.action if obj.animation_data is not None else None


def _turn(matrix: Floats) -> Floats:
    """Return the rotation (3, 3) in a matrix (4, 4) that may have a scale."""
    return np.array(Matrix(matrix.tolist()).to_quaternion().to_matrix())


if __name__ == "__main__":
    main()
