"""Joints of other programs are known by their names, those of models and those of motion clips alike."""

from __future__ import annotations

import numpy as np
import pytest
from tests.every import every
from tests.motion_files import CONVENTIONS, PARENTS, Style, a_person, bones_of, name_of, write_bvh

from storyblender.blender.cast.own_rig import own_rig
from storyblender.blender.models.plain import PlainRig
from storyblender.catalog.joint_names import bones_named
from storyblender.library.mocap.bvh import parse_bvh
from storyblender.library.mocap.roles import find_roles


@pytest.mark.parametrize(
    ("names", "bone"),
    [
        ("mixamorig:Hips pelvis J_Bip_C_Hips CC_Base_Hip Bip01_Pelvis", "hips"),
        ("mixamorig:LeftArm upperarm_l J_Bip_L_UpperArm DEF-upper_arm.L leftUpperArm lShldr Arm.L", "upper_arm.L"),
        ("mixamorig:RightForeArm lowerarm_r J_Bip_R_LowerArm DEF-forearm.R rForearm", "forearm.R"),
        ("mixamorig:LeftUpLeg thigh_l J_Bip_L_UpperLeg DEF-thigh.L leftUpperLeg", "thigh.L"),
        ("mixamorig:RightLeg calf_r J_Bip_R_LowerLeg DEF-shin.R Leg_R Leg_R_jnt", "shin.R"),
        ("mixamorig:LeftHandIndex1 index_01_l DEF-f_index.01.L leftIndexProximal L_Finger1 finger2-1.L", "index1.L"),
        ("RightHandMiddle2_044 ring_02_r rMid2 rightLittleDistal R_Finger31 finger3-2.R", "fingers2.R"),
        ("mixamorig:Spine1 spine_02 J_Bip_C_UpperChest DEF-spine.003 L5 thorax", "spine"),
        ("mixamorig:HeadTop_End upperarm_twist_01_l root Camera Cube.001 hand_ik_l earring.L head_end", ""),
    ],
)
def test_a_joint_is_known_by_its_name(names: str, bone: str) -> None:
    assert {name: bones_named([name], [-1]).get(0, "") for name in names.split()} == dict.fromkeys(names.split(), bone)


@every("convention", sorted({*CONVENTIONS} - {"nameless"}))
def test_a_rig_that_moves_a_model_is_known_and_so_is_one_that_moves_a_clip(convention: str) -> None:
    bones = bones_of(convention)
    limbs = {bone for bone in bones if bone.startswith(("upper_arm", "forearm", "hand", "thigh", "shin", "foot"))}

    person = a_person(seconds=0.5)
    names, parents = [name_of(bone, convention) for bone in bones], [PARENTS.get(bone, "") for bone in bones]
    above = tuple(bones.index(parent) if parent else -1 for parent in parents)
    heads = np.array([person.rest[bone] for bone in bones], np.float32)
    joints = np.array([[row, -1, -1, -1] for row in range(len(bones))])
    rig = PlainRig(tuple(names), above, heads, joints, (joints >= 0).astype(float))
    model = own_rig(rig, np.arange(len(bones)))
    assert model is not None
    wrong = {
        bone for bone in limbs | {"hips", "head"} if not np.allclose(model.heads[bone], person.rest[bone], atol=1e-6)
    }
    assert not wrong

    clip = parse_bvh(write_bvh(person, Style(convention=convention)))
    roles = find_roles(clip)
    assert roles.by_names
    assert {bone: clip.names[roles.limbs[bone]] for bone in limbs} == {
        bone: name_of(bone, convention) for bone in limbs
    }
