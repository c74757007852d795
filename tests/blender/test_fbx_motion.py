"""FBX clips as Blender's own exporter writes them: only the motion of the skeleton is read, in a process of its own."""

from __future__ import annotations

import math
from pathlib import Path

import bpy
import numpy as np
import pytest
from mathutils import Matrix, Vector
from tests.motion_files import PARENTS, Walker, a_person, bones_of, name_of

from storyblender.errors import InputError
from storyblender.geometry.mocap import BONES
from storyblender.geometry.rotations import about_axis, matrices_of
from storyblender.library.mocap.fbx import read_fbx
from storyblender.library.mocap.retarget import retarget

pytestmark = pytest.mark.blender


def write_fbx(walker: Walker, convention: str, path: Path, scale: float = 1.0, mesh: bool = True) -> None:
    """A skeleton, and a mesh on it, that moves as the walker does."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = round(walker.rate)
    rig = bpy.data.objects.new("Armature", bpy.data.armatures.new("Armature"))
    scene.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    rig.scale = (1 / scale,) * 3
    bpy.ops.object.mode_set(mode="EDIT")
    bones = bones_of(convention)
    for bone in bones:
        made = rig.data.edit_bones.new(name_of(bone, convention))
        made.head = Vector(walker.rest[bone]) * scale
        below = next((walker.rest[low] for low, high in PARENTS.items() if high == bone and low in bones), None)
        made.tail = Vector(walker.tips[bone] if below is None else below) * scale
        if (made.tail - made.head).length < 0.01 * scale:
            made.tail = made.head + Vector((0, 0, 0.05 * scale))
        if bone in PARENTS:
            made.parent = rig.data.edit_bones[name_of(PARENTS[bone], convention)]
    bpy.ops.object.mode_set(mode="POSE")
    for frame in range(len(walker.hips)):
        for bone in bones:
            posed = rig.pose.bones[name_of(bone, convention)]
            posed.rotation_mode = "QUATERNION"
            parent = PARENTS.get(bone)
            local = walker.turns[bone][frame]
            local = local if parent is None else walker.turns[parent][frame].T @ local
            rest = np.array(posed.bone.matrix_local)[:3, :3]
            posed.rotation_quaternion = Matrix((rest.T @ local @ rest).tolist()).to_quaternion()
            posed.keyframe_insert("rotation_quaternion", frame=frame)
            if parent is None:
                moved = (walker.hips[frame] - walker.rest["hips"]) * scale
                posed.location = Vector((rest.T @ moved).tolist())
                posed.keyframe_insert("location", frame=frame)
    scene.frame_end = len(walker.hips) - 1
    scene.frame_start = 0
    bpy.ops.object.mode_set(mode="OBJECT")
    if mesh:
        body = bpy.data.objects.new("Body", bpy.data.meshes.new("Body"))
        body.data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
        scene.collection.objects.link(body)
        body.parent = rig
    bpy.ops.export_scene.fbx(filepath=str(path), add_leaf_bones=False)


def waves(t: float) -> dict[str, np.ndarray]:
    swing = math.sin(math.pi * t / 2)
    return {
        "upper_arm.L": about_axis(1, np.array(1.3 - swing)), "upper_arm.R": about_axis(1, np.array(-1.3)),
        "forearm.L": about_axis(2, np.array(-1.2 * swing)), "head": about_axis(2, np.array(0.8 * swing)),
        "thigh.R": about_axis(0, np.array(-0.7 * swing)), "shin.R": about_axis(0, np.array(0.9 * swing)),
        "place": np.array([0.0, -0.8 * t, 0.0]),
    }  # fmt: skip


@pytest.mark.parametrize(("convention", "scale"), [("mixamo", 100.0), ("unreal", 1.0)])
def test_an_fbx_is_read_as_it_was_written(convention: str, scale: float, tmp_path: Path) -> None:
    walker = a_person(30.0, 2.0, waves)
    write_fbx(walker, convention, tmp_path / "clip.fbx", scale)
    motion = read_fbx(tmp_path / "clip.fbx")
    assert motion.rate == pytest.approx(30.0)
    assert len(motion.places) == 61
    poses = retarget(motion)
    turns = matrices_of(poses.turns)
    root = about_axis(2, poses.root[:, 2])
    for bone in ("upper_arm.L", "forearm.L", "thigh.R", "shin.R", "head", "upper_chest"):
        found = root @ turns[:, BONES.index(bone)]
        axis = {"u": [1.0, 0, 0], "f": [1.0, 0, 0]}.get(bone[0], [0, 0, 1.0])
        wanted = walker.turns[bone][: len(found)] @ np.array(axis)
        cosine = np.sum(wanted * (found @ np.array(axis)), axis=1)
        assert np.degrees(np.arccos(np.clip(cosine, -1, 1))).max() < 3, bone
    assert poses.travel * 0.82 == pytest.approx(1.6, abs=0.1)


def test_what_has_no_motion_and_what_is_no_fbx_is_refused(tmp_path: Path) -> None:
    (tmp_path / "text.fbx").write_text("; FBX 7.3.0 project file\n")
    with pytest.raises(InputError, match="no binary FBX"):
        read_fbx(tmp_path / "text.fbx")
    (tmp_path / "damaged.fbx").write_bytes(b"Kaydara FBX Binary  \x00\x1a\x00" + b"\xff" * 4000)
    with pytest.raises(InputError, match="damaged"):
        read_fbx(tmp_path / "damaged.fbx")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.export_scene.fbx(filepath=str(tmp_path / "cube.fbx"))
    with pytest.raises(InputError, match="no skeleton"):
        read_fbx(tmp_path / "cube.fbx")
