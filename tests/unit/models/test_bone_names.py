"""Bones of other programs are known by their names."""

from __future__ import annotations

import pytest

from storyblender.blender.cast.bone_names import bone_named


@pytest.mark.parametrize(
    ("names", "bone"),
    [
        ("mixamorig:Hips pelvis J_Bip_C_Hips CC_Base_Hip Bip01_Pelvis", "hips"),
        ("mixamorig:LeftArm upperarm_l J_Bip_L_UpperArm DEF-upper_arm.L leftUpperArm lShldr Arm.L", "upper_arm.L"),
        ("mixamorig:RightForeArm lowerarm_r J_Bip_R_LowerArm DEF-forearm.R rForearm", "forearm.R"),
        ("mixamorig:LeftUpLeg thigh_l J_Bip_L_UpperLeg DEF-thigh.L leftUpperLeg", "thigh.L"),
        ("mixamorig:RightLeg calf_r J_Bip_R_LowerLeg DEF-shin.R Leg_R", "shin.R"),
        ("mixamorig:LeftHandIndex1 index_01_l DEF-f_index.01.L leftIndexProximal", "index1.L"),
        ("mixamorig:Spine1 spine_02 J_Bip_C_UpperChest DEF-spine.003", "spine"),
        ("mixamorig:HeadTop_End upperarm_twist_01_l root Camera Cube.001 hand_ik_l", ""),
    ],
)
def test_a_bone_is_known_by_its_name(names: str, bone: str) -> None:
    assert {name: bone_named(name) for name in names.split()} == dict.fromkeys(names.split(), bone)
