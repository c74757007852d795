"""People of every age in every garment: dressed, rigged, standing, and the same twice."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from tests.every import every

from storyblender.blender.people import mouth
from storyblender.blender.people.figure import BodyFigure
from storyblender.blender.people.pack import PARTS, load_body_pack
from storyblender.blender.people.person import PersonBuild, build_person
from storyblender.blender.people.scalp import Scalp, above_hairline
from storyblender.blender.people.skin import whisker_growth
from storyblender.blender.people.whiskers import build_whiskers
from storyblender.catalog.bodies import recipe
from storyblender.catalog.expressions import FACE
from storyblender.catalog.garments import GARMENTS
from storyblender.catalog.hair import HAIRSTYLES, hairstyle
from storyblender.catalog.skeleton import SKELETON
from storyblender.memory.asset_sheet import CharacterLook, Garment

pytestmark = pytest.mark.blender
needs_data = pytest.mark.skipif(load_body_pack() is None, reason="the body data has not been fetched")


@pytest.fixture(autouse=True)
def _empty_file() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)


def _coordinates(obj: bpy.types.Object) -> np.ndarray:
    flat = np.empty(len(obj.data.vertices) * 3, np.float32)
    obj.data.vertices.foreach_get("co", flat)
    return flat.reshape(-1, 3)


def _part(build: PersonBuild, suffix: str) -> bpy.types.Object:
    return next(obj for obj in build.meshes if obj.name.endswith(f"_{suffix}"))


def _build_alone(look: CharacterLook) -> PersonBuild:
    """Build a person in a file without others, whose parts would take the names of theirs."""
    bpy.data.batch_remove(bpy.data.objects)
    bpy.data.batch_remove([*bpy.data.meshes, *bpy.data.armatures])
    return build_person("emil", look, 1)


@needs_data
@pytest.mark.parametrize(
    ("gender", "age", "build"),
    [("male", 1, "average"), ("female", 6, "slim"), ("male", 35, "heavy"), ("female", 95, "stocky")],
)
def test_a_person_stands_on_the_floor_facing_the_camera_at_the_wanted_stature(
    gender: str, age: int, build: str
) -> None:
    look = CharacterLook.model_validate(
        {"gender": gender, "age": age, "build": build, "stature": 0.75 if age == 1 else 1.5}
    )
    person = build_person("anna", look, 3)
    assert person.body.stature == pytest.approx(look.stature, abs=0.01)
    assert person.body.vertices[:, 2].min() == pytest.approx(0, abs=1e-6)
    names = list(person.body.bone_names)
    heads = person.body.heads
    assert heads[names.index("toe.L")][1] < heads[names.index("foot.L")][1]
    assert heads[names.index("hand.L")][0] > 0 > heads[names.index("hand.R")][0]
    assert min(_coordinates(obj)[:, 2].min() for obj in person.meshes) > -0.02


@needs_data
def test_the_rig_and_the_body_agree_by_name() -> None:
    person = build_person("anna", CharacterLook(gender="female", age=30), 1)
    armature, body = person.armature, person.body
    assert armature.name == "anna"
    assert set(body.bone_names) == {bone.name for bone in SKELETON}
    assert np.allclose(body.weights.sum(1), 1, atol=1e-3)
    for name, parent in zip(body.bone_names, body.parents, strict=True):
        bone = armature.data.bones[name]
        assert (bone.parent.name if bone.parent else None) == (body.bone_names[parent] if parent >= 0 else None)
    # A vertex that hangs on a bone lies near it: a permuted matrix would fail this.
    for name in ("hand.L", "foot.R", "head", "thigh.L"):
        row = body.weights[:, body.bone_names.index(name)].argmax()
        bone = armature.data.bones[name]
        assert np.linalg.norm(body.vertices[row] - np.array(bone.head_local)) < 0.35


@needs_data
def test_every_part_is_tagged_weighted_and_coloured() -> None:
    look = CharacterLook(gender="male", age=50, facial_hair="beard", glasses=True)
    person = build_person("bert", look, 2)
    for obj in person.meshes:
        assert (obj["kind"], obj["node_id"], obj["asset_id"]) == ("character", "bert", "bert")
        assert obj["surface"] > 0
        assert obj.parent == person.armature
        assert [m.object for m in obj.modifiers if m.type == "ARMATURE"] == [person.armature]
        assert obj.data.color_attributes.active_color.name == "Color"
        assert all(abs(sum(g.weight for g in v.groups) - 1) < 1e-3 for v in obj.data.vertices)
    assert _part(person, "skin")["ink_group"] == _part(person, "eyes")["ink_group"] == "bert_skin"
    assert _part(person, "hair")["ink_group"] == _part(person, "beard")["ink_group"] == "bert_hair"
    assert sum(len(obj.data.vertices) for obj in person.meshes) < 18_000


@needs_data
def test_the_face_moves_with_its_shape_keys() -> None:
    person = build_person("anna", CharacterLook(gender="female", age=30), 1)
    keys = _part(person, "skin").data.shape_keys.key_blocks
    assert [key.name for key in keys] == ["Basis", *person.body.shape_keys]
    assert person.body.shape_keys == FACE
    basis = np.array([point.co for point in keys["Basis"].data])
    for key in keys[1:]:
        moved = np.linalg.norm(np.array([point.co for point in key.data]) - basis, axis=1)
        assert 0.0025 < moved.max() < 0.05
        assert key.value == 0


@needs_data
def test_an_open_mouth_is_dark_with_a_band_of_upper_teeth() -> None:
    pack = load_body_pack()
    assert pack is not None
    throat, lip, chin = (0.0, 6.585, 0.57), (0.0, 6.671, 1.601), (0.0, 6.43, 1.491)
    assert mouth.mouth_depth(pack, np.array([throat, lip, chin])).tolist() == [1.0, 0.0, 0.0]
    rows = mouth.paint_teeth(pack.points[PARTS["teeth"]])
    lower, upper = (row.max() for row in np.split(rows, 2))
    assert mouth.TONGUE[0] < upper / 2, "the teeth are told from what is behind them"
    assert lower < upper / 3 < 0.2, "two bright rows read as one block"


@needs_data
def test_building_twice_gives_equal_vertices_and_another_seed_another_face() -> None:
    look = CharacterLook(gender="male", age=40, hair="messy", facial_hair="moustache")
    first = {obj.name: _coordinates(obj) for obj in build_person("carl", look, 5).meshes}
    bpy.ops.wm.read_factory_settings(use_empty=True)
    second = {obj.name: _coordinates(obj) for obj in build_person("carl", look, 5).meshes}
    assert first.keys() == second.keys()
    assert all(np.array_equal(first[name], second[name]) for name in first)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    other = build_person("carl", look.model_copy(update={"stature": 1.8}), 6).body.vertices
    bpy.ops.wm.read_factory_settings(use_empty=True)
    same = build_person("carl", look.model_copy(update={"stature": 1.8}), 5).body.vertices
    assert np.abs(other - same).max() > 0.005


@needs_data
@pytest.mark.parametrize("age", [7, 40])
def test_no_skin_shows_between_neck_and_hem(age: int) -> None:
    person = build_person("dora", CharacterLook(gender="female", age=age), 4)
    skin = _part(person, "skin")
    groups = {group.index: group.name for group in skin.vertex_groups}
    joint = {bone.name: bone.head_local for bone in person.armature.data.bones}
    low, high = joint["thigh.L"].z - 0.02, joint["chest"].z
    arms = ("upper_arm", "forearm", "hand", "thumb", "index", "finger")
    for vertex in skin.data.vertices:
        arm = sum(g.weight for g in vertex.groups if groups[g.group].startswith(arms))
        assert arm > 0.05 or not low < vertex.co.z < high


@needs_data
@every("key", GARMENTS)
def test_every_garment_can_be_worn(key: str) -> None:
    keys = (key,) if GARMENTS[key].covers else ("shirt", "trousers", "shoes", key)
    worn = [Garment(key=key) for key in keys]
    person = _build_alone(CharacterLook(gender="male", age=35, hair="shaved", garments=worn))
    garment = _part(person, key)
    assert len(garment.data.polygons) > 10
    assert np.abs(_coordinates(garment)).max() < 2.2


@needs_data
@every("key", [key for key in HAIRSTYLES if key != "shaved"])
def test_every_hairstyle_grows_on_the_head(key: str) -> None:
    person = _build_alone(CharacterLook(gender="female", age=25, hair=key))
    points = _coordinates(_part(person, "hair"))
    assert points[:, 2].max() > (0.93 if key == "bald" else 0.99) * person.body.stature
    assert np.abs(points[:, 0]).max() < 0.26
    assert not np.isnan(points).any()


@needs_data
def test_a_bob_goes_round_the_back_of_the_head_and_ends_at_the_jaw() -> None:
    person = build_person("ivy", CharacterLook(gender="female", age=30, hair="bob"), 1)
    points = _coordinates(_part(person, "hair"))
    head = person.armature.data.bones["head"].head_local
    low = points[points[:, 2] < points[:, 2].max() - 0.18]
    around = np.degrees(np.arctan2(low[:, 0] - head.x, low[:, 1] - head.y))
    assert np.histogram(around, bins=12, range=(-90, 90))[0].min() > 0
    assert 0.2 < np.ptp(points[:, 2]) < 0.3
    back = points[np.abs(points[:, 0] - head.x) < 0.03]
    hem = back[back[:, 2] < back[:, 2].min() + 0.02, 1].max()
    assert hem < back[:, 1].max() - 0.02, "it turns in at the nape, a lampshade does not"


@needs_data
@pytest.mark.parametrize("key", ["ponytail", "braid"])
def test_tied_hair_hangs_behind_the_neck_as_one_and_ends_in_one_tip(key: str) -> None:
    person = build_person("una", CharacterLook(gender="female", age=30, hair=key), 1)
    points = _coordinates(_part(person, "hair"))
    neck = person.armature.data.bones["neck"].head_local
    for height in np.arange(points[:, 2].min(), neck.z, 0.02):
        row = points[np.abs(points[:, 2] - height - 0.01) < 0.012]
        assert len(row)
        assert np.ptp(row[:, 0]) < 0.075
        assert row[:, 1].min() > neck.y
    tip = points[points[:, 2] < points[:, 2].min() + 0.01]
    assert np.ptp(tip[:, :2], axis=0).max() < 0.03


@needs_data
@pytest.mark.parametrize(("key", "coat"), [("ponytail", "shirt"), ("braid", "coat")])
def test_tied_hair_lies_on_neck_and_back_over_the_collar(key: str, coat: str) -> None:
    person = build_person("una", CharacterLook(gender="female", age=60, hair=key, garments=(Garment(key=coat),)), 1)
    hair = _coordinates(_part(person, "hair"))
    others = np.concatenate([_coordinates(mesh) for mesh in person.meshes if mesh is not _part(person, "hair")])
    neck = person.armature.data.bones["neck"].head_local.z
    assert hair[:, 2].min() < neck - 0.05, "it reaches the back"
    for height in np.arange(hair[:, 2].min() + 0.02, neck, 0.02):
        tail = hair[np.abs(hair[:, 2] - height) < 0.02, 1]
        middle = (np.abs(others[:, 2] - height) < 0.03) & (np.abs(others[:, 0]) < 0.06)
        assert tail.min() < others[middle, 1].max() + 0.03, "it does not stand off"


@needs_data
@pytest.mark.parametrize(("key", "least"), [("ponytail", 0.5), ("braid", 0.9)])
def test_tied_hair_stays_on_the_back_of_who_bows_the_head(key: str, least: float) -> None:
    person = build_person("una", CharacterLook(gender="female", age=30, hair=key), 1)
    hair = _part(person, "hair")
    weights = np.zeros((len(hair.data.vertices), len(hair.vertex_groups)))
    for vertex in hair.data.vertices:
        for group in vertex.groups:
            weights[vertex.index, group.group] = group.weight
    back, head = (weights[:, hair.vertex_groups[bone].index] for bone in ("upper_chest", "head"))
    height = _coordinates(hair)[:, 2]
    tip, top = height < height.min() + 0.02, height > height.max() - 0.1
    assert back[tip].min() > least
    assert head[top].min() > 0.99


@needs_data
def test_outer_clothes_lie_outside_inner_ones() -> None:
    keys = ("shirt", "trousers", "jacket", "shoes")
    person = build_person("gus", CharacterLook(gender="male", age=40, garments=tuple(Garment(key=k) for k in keys)), 2)
    shirt, jacket = _part(person, "shirt"), _part(person, "jacket")
    misses = 0
    collar = person.armature.data.bones["neck"].head_local.z - 0.04
    for polygon in shirt.data.polygons:
        if polygon.center.z > collar or abs(polygon.center.x) > 0.2 or polygon.material_index:
            continue  # collar, cuffs and buttons are meant to be seen
        hit, where, _, _ = jacket.closest_point_on_mesh(polygon.center)
        behind = (polygon.center - where).dot(polygon.normal) > 0.004
        misses += hit and behind and (polygon.center - where).length < 0.02
    assert misses < 5


def test_without_the_data_a_flagged_mannequin_stands_in(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("STORYBLENDER_BODY_DATA", "/nowhere/pack.npz.xz")
    person = build_person("hal", CharacterLook(stature=1.6), 1)
    assert person.stand_in
    assert person.armature["stand_in"]
    assert person.body.vertices[:, 2].max() == pytest.approx(1.6, abs=0.02)
    assert set(person.body.bone_names) == {bone.name for bone in SKELETON}


@needs_data
def test_a_beard_ends_in_one_clean_line_on_the_cheek() -> None:
    pack = load_body_pack()
    assert pack is not None
    look = CharacterLook(gender="male", age=60, facial_hair="beard")
    grown = build_whiskers(BodyFigure(pack, pack.shape(recipe(look, 1))), "beard", 1, {})
    growth = whisker_growth(grown.sheet.base)
    edge = np.abs(growth) < 1e-6
    assert edge.sum() > 60
    assert np.abs(grown.sheet.base[edge, 0]).max() > 0.6


@needs_data
def test_no_lock_falls_on_the_temples_from_under_a_cap() -> None:
    person = build_person(
        "ned", CharacterLook(gender="male", age=67, hair="short", garments=(Garment(key="flat_cap"),)), 1
    )
    points = _coordinates(_part(person, "hair"))
    eye = person.armature.data.bones["eye.L"].head_local
    face = (points[:, 1] < eye.y + 0.025) & (points[:, 2] < eye.z + 0.02) & (points[:, 2] > eye.z - 0.06)
    assert not face.any()


@needs_data
def test_a_lock_knows_how_far_above_the_hairline_it_grows() -> None:
    pack = load_body_pack()
    assert pack is not None
    figure = BodyFigure(pack, pack.shape(recipe(CharacterLook(gender="female", age=30), 1)))
    scalp = Scalp(figure, hairstyle("short"), 0.0)
    skin = figure.part("skin")
    line = above_hairline(skin.base, scalp.spec, 0.0)
    for direction in np.array(((0.0, -0.6, 0.8), (0.3, 0.5, 0.81), (0.0, 1.0, 0.0), (-0.5, -0.2, 0.84))):
        found = scalp.skull_surface(direction / np.linalg.norm(direction))
        assert found is not None
        nearest = int(np.argmin(np.linalg.norm(skin.points - found[0], axis=1)))
        assert abs(found[1] - line[nearest]) < 0.25, "decimetres: about the width of a face of the skull"
    assert scalp.figure.joint("neck") is scalp.figure.joint("neck"), "read for every point of hair, measured once"


@needs_data
def test_the_armholes_of_a_vest_lie_inside_the_shoulders() -> None:
    worn = tuple(Garment(key=key) for key in ("shirt", "vest", "trousers"))
    person = build_person("tom", CharacterLook(gender="male", age=40, garments=worn), 1)
    shoulder = person.armature.data.bones["upper_arm.L"].head_local
    vest = _coordinates(_part(person, "vest"))
    high = vest[vest[:, 2] > shoulder.z - 0.03]
    assert np.abs(high[:, 0]).max() < abs(shoulder.x) + 0.035
