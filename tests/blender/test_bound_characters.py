"""Humanoid models of users are bound to our skeleton, whatever their topology, pose and proportions."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.every import every

pytestmark = pytest.mark.blender
bpy = pytest.importorskip("bpy")

from benchmarks.bound_cast import built, measured  # noqa: E402
from benchmarks.humanoids import box, figure, write_glb, write_humanoid, write_prop  # noqa: E402

from storyblender.blender.asset_store import AssetStore  # noqa: E402
from storyblender.blender.cast.character import CharacterBuild, character_from_file  # noqa: E402
from storyblender.blender.motion.measures import measure  # noqa: E402
from storyblender.blender.people.body import RiggedBody  # noqa: E402
from storyblender.blender.people.person import build_person  # noqa: E402
from storyblender.catalog.skeleton import BONE_INDEX  # noqa: E402
from storyblender.errors import InputError  # noqa: E402
from storyblender.folder import Folder  # noqa: E402
from storyblender.memory.asset_sheet import Asset, AssetDimension, CanonicalAsset, Certainty, CharacterLook, ModelPose  # noqa: E402
from storyblender.memory.jobs import AssetJob  # noqa: E402

ADULT = AssetDimension(height=1.75)


@pytest.fixture(autouse=True)
def empty_file() -> None:
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)


def _cast(path: Path, height: AssetDimension = ADULT, certainty: Certainty = "usual") -> CharacterBuild:
    return character_from_file("rick", path, path.parent, height, certainty=certainty, pose=ModelPose())


def _joint(body: RiggedBody, bone: str) -> np.ndarray:
    return body.heads[body.bone_names.index(bone)]


def test_joints_are_found_in_a_figure_with_raised_arms_that_faces_away(tmp_path: Path) -> None:
    suit, joints = figure(45, gender="male", age=40.0)
    points, triangles, color = suit
    path = write_glb(tmp_path / "rick.glb", [(100 * points * (-1, -1, 1), triangles, color)])
    built = _cast(path)
    body = built.person.body
    assert body.stature == pytest.approx(points[:, 2].max(), abs=0.03)
    assert [note for note in built.notes if "180 degrees" in note] and [n for n in built.notes if "centimetres" in n]
    names = ("thigh.L", "shin.L", "foot.L", "upper_arm.L", "forearm.L", "hand.L", "neck", "head")
    shift = _joint(body, "foot.L") - joints[BONE_INDEX["foot.L"]]
    for bone in names[:4] + names[6:]:
        apart = _joint(body, bone) - joints[BONE_INDEX[bone]] - shift
        assert np.linalg.norm(apart) < 0.05, bone
    arm = np.linalg.norm(joints[BONE_INDEX["hand.L"]] - joints[BONE_INDEX["forearm.L"]])
    assert np.linalg.norm(_joint(body, "hand.L") - _joint(body, "forearm.L")) == pytest.approx(arm, abs=0.03)
    assert _joint(body, "hand.L")[2] < _joint(body, "upper_arm.L")[2] - 0.2, "at rest the arms are as everybody's"
    assert body.vertices[:, 2].min() == pytest.approx(0, abs=1e-4)
    assert np.allclose(body.weights.sum(1), 1)


MIXAMO = {
    "hips": "Hips", "spine": "Spine", "chest": "Spine1", "upper_chest": "Spine2", "neck": "Neck", "head": "Head",
    "shoulder": "Shoulder", "upper_arm": "Arm", "forearm": "ForeArm", "hand": "Hand", "thumb": "HandThumb1",
    "index1": "HandIndex1", "index2": "HandIndex2", "fingers1": "HandMiddle1", "fingers2": "HandMiddle2",
    "thigh": "UpLeg", "shin": "Leg", "foot": "Foot", "toe": "ToeBase",
}  # fmt: skip


def test_a_file_that_has_a_rig_with_known_names_keeps_its_joints_and_weights(tmp_path: Path) -> None:
    person = build_person("anna", CharacterLook(gender="female", age=30), 1)
    for bone in list(person.armature.data.bones):
        stem, _, side = bone.name.partition(".")
        bone.name = f"mixamorig:{ {'L': 'Left', 'R': 'Right', '': ''}[side] }{MIXAMO.get(stem, stem)}"
    path = tmp_path / "anna.glb"
    bpy.ops.export_scene.gltf(filepath=str(path), export_morph=False, export_animations=False)
    empty = _cast(path).person.body
    shift = _joint(empty, "hips") - _joint(person.body, "hips")
    for bone in ("thigh.L", "shin.R", "foot.L", "upper_arm.L", "forearm.R", "neck", "head", "upper_chest"):
        assert np.linalg.norm(_joint(empty, bone) - _joint(person.body, bone) - shift) < 0.012, bone
    index = {name: column for column, name in enumerate(empty.bone_names)}
    arm = empty.weights[:, index["forearm.L"]] > 0.9
    assert arm.any() and empty.vertices[arm, 0].min() > 0.1, "her left arm is on her left"


def test_a_story_tells_how_tall_a_character_is(tmp_path: Path) -> None:
    path = write_humanoid("robot", tmp_path)
    child = _cast(path, AssetDimension(height=1.2), certainty="told")
    assert child.person.body.stature == pytest.approx(1.2, abs=0.001)


def test_a_figure_of_a_few_long_boxes_bends_at_its_knees_and_elbows(tmp_path: Path) -> None:
    sides = [
        box((min(near, far), -depth, low), (max(near, far), depth, high))
        for sign in (1, -1)
        for near, far, depth, low, high in (
            (sign * 0.03, sign * 0.16, 0.07, 0.0, 0.9),
            (sign * 0.21, sign * 0.82, 0.05, 1.35, 1.45),
        )
    ]
    trunk, head = box((-0.19, -0.12, 0.85), (0.19, 0.12, 1.5)), box((-0.1, -0.12, 1.5), (0.1, 0.12, 1.75))
    body = _cast(write_glb(tmp_path / "rick.glb", [*sides, trunk, head])).person.body
    column = {name: index for index, name in enumerate(body.bone_names)}
    for bone in ("thigh.L", "shin.R", "upper_arm.R", "forearm.L"):
        assert (body.weights[:, column[bone]] > 0.7).any(), f"part of a box moves with the {bone}"
    assert 0.03 < measure(body).seat_drop < 0.15


def test_a_body_without_skin_at_its_seat_is_measured_like_others() -> None:
    body = build_person("anna", CharacterLook(gender="female", age=30), 1).body
    column = {name: index for index, name in enumerate(body.bone_names)}
    weights = body.weights.copy()
    for bone in ("hips", "thigh.L", "thigh.R"):
        weights[:, column["spine"]] += weights[:, column[bone]]
        weights[:, column[bone]] = 0
    there, gone = measure(body), measure(replace(body, weights=weights))
    assert gone.seat_drop == pytest.approx(there.seat_drop, abs=0.06)
    assert gone.seat_back == pytest.approx(there.seat_back, abs=0.06)


@pytest.mark.parametrize("key", ["chair", "ladder", "dog"])
def test_what_is_no_human_figure_is_refused(tmp_path: Path, key: str) -> None:
    with pytest.raises(InputError, match="no human figure"):
        _cast(write_prop(key, tmp_path))


def test_a_character_of_a_model_is_built_once_and_comes_as_a_rig_with_its_mesh(tmp_path: Path) -> None:
    models = tmp_path / "models"
    models.mkdir()
    write_humanoid("robot", models)
    made = CanonicalAsset(source="file", key="robot.glb", dimensions=(1, 1, 1), digest="")
    asset = Asset(asset_id="rick", asset_type="character", description="", look=CharacterLook(), canonical=made)
    store = AssetStore(Folder(tmp_path / "film"), [models])
    measure = store.measure(AssetJob(asset=asset))
    assert measure.dimensions[2] == pytest.approx(1.82, abs=0.06)
    built = asset.model_copy(update={"canonical": made.model_copy(update={"digest": measure.digest})})
    member = store.append_person(built)
    assert len(member.armature.data.bones) == len(member.body.bone_names)
    (mesh,) = member.meshes
    assert mesh["kind"] == "character" and mesh.modifiers[0].object == member.armature
    assert {group.name for group in mesh.vertex_groups} <= {bone.name for bone in member.armature.data.bones}


def test_a_robot_moves_in_stiff_parts_that_meet_at_its_joints(tmp_path: Path) -> None:
    body = _cast(write_humanoid("robot", tmp_path)).person.body
    assert np.allclose(body.weights.max(1), 1), "each part moves with one bone"
    elbow, wrist = _joint(body, "forearm.L"), _joint(body, "hand.L")
    assert np.linalg.norm(elbow - wrist) == pytest.approx(0.28, abs=0.03), "from between its boxes to between its boxes"
    assert _joint(body, "shin.L")[2] == pytest.approx(0.455, abs=0.03)


@every("name", ["man_t", "arms_down", "swordsman"])
def test_motions_stretch_a_figure_little_more_than_the_built_in_people(name: str, tmp_path: Path) -> None:
    rows = {row.act: row for row in measured(built(name, tmp_path))}
    assert all(rows[act].stretch < 1.6 for act in ("walk", "run", "wave", "point", "talk", "hold"))
    assert all(row.stretch < 2.0 and row.torn < 4 and row.inside < 30 for row in rows.values())
    assert all(abs(rows[act].floor) < 5 for act in ("walk", "run", "wave", "talk", "kneel"))
    assert abs(rows["sit"].seat) < 35 and abs(rows["hold"].grip) < 60


def test_a_figure_with_thick_hands_and_long_feet_is_not_in_itself_nor_in_the_floor(tmp_path: Path) -> None:
    rows = {row.act: row for row in measured(built("robot", tmp_path))}
    assert all(rows[act].inside < 15 for act in ("walk", "run", "hold", "wave", "point", "talk"))
    assert all(abs(rows[act].floor) < 10 for act in ("walk", "run", "hold", "wave", "talk", "kneel"))
