"""Statures, morph weights, faces and colours."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.catalog.bodies import (
    SKIN_TONES,
    body_pack_path,
    complexion,
    macro_targets,
    maturity,
    recipe,
    resolved_gender,
    typical_stature,
)
from storyblender.catalog.hair import HAIRSTYLES, hairstyle
from storyblender.catalog.skeleton import BONE_INDEX, SKELETON, columns
from storyblender.memory.asset_sheet import CharacterLook


@pytest.mark.parametrize(
    ("gender", "age", "low", "high"),
    [("male", 1, 0.7, 0.8), ("female", 8, 1.2, 1.35), ("male", 14, 1.58, 1.7), ("female", 30, 1.6, 1.7),
     ("male", 30, 1.74, 1.84), ("female", 90, 1.48, 1.6)],
)  # fmt: skip
def test_typical_statures(gender: str, age: float, low: float, high: float) -> None:
    assert low < typical_stature(gender, age) < high


def test_a_wanted_stature_is_kept_and_others_vary() -> None:
    assert recipe(CharacterLook(stature=1.93), 4).stature == 1.93
    statures = {round(recipe(CharacterLook(gender="male"), seed).stature, 4) for seed in range(12)}
    assert len(statures) > 8
    assert all(1.66 < stature < 1.92 for stature in statures)


def test_age_values_meet_the_landmarks() -> None:
    assert [maturity(age) for age in (1, 10, 25, 90)] == [0, 0.1875, 0.5, 1]
    assert maturity(110) == 1


@pytest.mark.parametrize("age", [1, 5, 17, 33, 60, 95])
@pytest.mark.parametrize("height", [0.2, 0.5, 0.8])
def test_the_shares_of_each_kind_of_macro_target_sum_to_one(age: float, height: float) -> None:
    targets = macro_targets(recipe(CharacterLook(gender="female", age=age, skin="tan"), 7), height)
    ancestry = sum(
        w for name, w in targets.items() if name.split("/")[1].split("-")[0] in ("african", "asian", "caucasian")
    )
    universal = sum(w for name, w in targets.items() if "universal" in name)
    stature = sum(w for name, w in targets.items() if "/height/" in name)
    assert ancestry == pytest.approx(1, abs=0.01)
    assert universal == pytest.approx(1, abs=0.01)
    assert stature == pytest.approx(abs(2 * height - 1), abs=0.01)


def test_two_people_with_the_same_words_have_different_faces_and_the_same_person_one() -> None:
    look = CharacterLook(gender="male", age=40)
    first, second = recipe(look, 1), recipe(look, 2)
    assert first == recipe(look, 1)
    moved = sum(
        abs(first.details.get(name, 0) - second.details.get(name, 0)) for name in {*first.details, *second.details}
    )
    assert moved > 2


def test_children_have_gentler_faces_and_only_the_old_have_old_ones() -> None:
    child, adult, old = (recipe(CharacterLook(gender="male", age=age), 5) for age in (6, 30, 75))
    assert sum(child.details.values()) < 0.75 * sum(adult.details.values())
    assert "head/head-age-incr" not in adult.details
    assert old.details["head/head-age-incr"] > 0.5


def test_hair_greys_with_age_unless_its_colour_is_given() -> None:
    def spread(age: float) -> float:
        hair = complexion(CharacterLook(age=age, skin="light"), 3).hair
        return max(hair) - min(hair)

    assert spread(80) < 0.08
    assert complexion(CharacterLook(age=80, hair_color=(0.5, 0.1, 0.1)), 3).hair == (0.5, 0.1, 0.1)
    assert sum(complexion(CharacterLook(age=85), 3).hair) > 3 * sum(complexion(CharacterLook(age=25), 3).hair)


def test_an_open_gender_is_decided_by_the_seed() -> None:
    assert {resolved_gender(CharacterLook(), seed) for seed in range(4)} == {"female", "male"}
    assert resolved_gender(CharacterLook(gender="female"), 1) == "female"


def test_the_pack_lies_in_the_cache_unless_a_pack_is_named(tmp_path: Path) -> None:
    assert body_pack_path({}, tmp_path).parent == tmp_path / ".cache" / "storyblender"
    assert body_pack_path({"XDG_CACHE_HOME": "/x"}, tmp_path).parent == Path("/x/storyblender")
    assert body_pack_path({"STORYBLENDER_BODY_DATA": "/y/pack.npz.xz"}, tmp_path) == Path("/y/pack.npz.xz")
    wheel = body_pack_path({"STORYBLENDER_BODY_DATA": "/y/data.whl"}, tmp_path)
    assert wheel.parent == tmp_path / ".cache" / "storyblender"


def test_the_skeleton_has_35_bones_and_parents_first() -> None:
    assert len(SKELETON) == 35
    seen: set[str] = set()
    for bone in SKELETON:
        assert not bone.parent or bone.parent in seen
        seen.add(bone.name)
    assert columns("head", "thigh") == [BONE_INDEX["head"], BONE_INDEX["thigh.L"], BONE_INDEX["thigh.R"]]


def test_unknown_hair_is_short() -> None:
    assert hairstyle("no_such_style") is HAIRSTYLES["short"]
    assert {"short", "crop", "messy", "bald", "bun", "long", "bob", "ponytail", "curly"} <= set(HAIRSTYLES)


@pytest.mark.parametrize("skin", SKIN_TONES)
def test_lips_are_a_little_redder_than_any_skin_and_never_glow(skin: str) -> None:
    look = CharacterLook.model_validate({"gender": "female", "age": 30, "skin": skin})
    for seed in range(3):
        colors = complexion(look, seed)
        assert colors.lips[0] / colors.lips[1] > 1.3 * colors.skin[0] / colors.skin[1]
        assert colors.lips[0] < 1.5 * colors.skin[0]
