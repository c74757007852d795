"""Animals that act like people: upright, with their own heads, coats and tails, on the rig of a person."""

from __future__ import annotations

import bpy
import numpy as np
import pytest

from storyblender.blender.people.pack import load_body_pack
from storyblender.blender.people.person import PersonBuild, build_person
from storyblender.catalog.expressions import FACE
from storyblender.catalog.species import SPECIES
from storyblender.memory.asset_sheet import CharacterLook, Garment

pytestmark = [
    pytest.mark.blender,
    pytest.mark.skipif(load_body_pack() is None, reason="the body data has not been fetched"),
]


@pytest.fixture(autouse=True)
def _empty_file() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)


def _build(species: str, **fields: object) -> PersonBuild:
    look = CharacterLook.model_validate({"species": species, "stature": SPECIES[species].height} | fields)
    return build_person("brock", look, 3)


def _points(obj: bpy.types.Object) -> np.ndarray:
    flat = np.empty(len(obj.data.vertices) * 3, np.float32)
    obj.data.vertices.foreach_get("co", flat)
    return flat.reshape(-1, 3)


@pytest.mark.parametrize("species", ["mouse", "badger", "owl", "frog", "elephant"])
def test_an_animal_stands_on_the_floor_about_as_tall_as_its_kind(species: str) -> None:
    animal = _build(species)
    assert animal.body.stature == pytest.approx(SPECIES[species].height, rel=0.12)
    assert min(_points(obj)[:, 2].min() for obj in animal.meshes) > -0.03


def test_its_eyes_turn_about_their_own_middles() -> None:
    animal = _build("fox")
    heads = dict(zip(animal.body.bone_names, animal.body.heads, strict=True))
    eyes = _points(next(obj for obj in animal.meshes if obj.name.endswith("_eyes")))
    for side, sign in (("L", 1), ("R", -1)):
        ball = eyes[eyes[:, 0] * sign > 0]
        away = np.linalg.norm(ball - heads[f"eye.{side}"], axis=1)
        assert np.ptp(away[:-8]) < 0.15 * away.max(), "a ball about its bone, apart from the glint"


def test_its_face_has_every_shape_key_and_its_mouth_opens_downwards() -> None:
    head = next(obj for obj in _build("wolf").meshes if obj.name.endswith("_head"))
    blocks = head.data.shape_keys.key_blocks
    assert {*FACE} <= {*blocks.keys()}
    rest, opened = (np.array([point.co for point in blocks[key].data]) for key in ("Basis", "mouth_open"))
    assert (opened - rest)[:, 2].min() < -0.02
    assert np.allclose(opened[rest[:, 2] > rest[:, 2].mean() + 0.05], rest[rest[:, 2] > rest[:, 2].mean() + 0.05])


def test_it_wears_what_is_told_and_its_coat_where_nothing_is() -> None:
    bare = {obj.name for obj in _build("badger").meshes}
    bpy.ops.wm.read_factory_settings(use_empty=True)
    dressed = {obj.name for obj in _build("badger", garments=(Garment(key="vest"),)).meshes}
    assert dressed - bare == {"brock_vest"}
    assert "brock_tail" in bare
