from __future__ import annotations

import pytest
from tests.every import every

from storyblender.catalog.props import PROPS
from storyblender.catalog.props.ordinary import ORDINARY
from storyblender.catalog.props.prop_names import kind_named, prop_of, props_of
from storyblender.memory.asset_sheet import Asset, CanonicalAsset, CharacterLook
from storyblender.memory.vocabulary import AssetType

MADE = {
    source: CanonicalAsset(source=source, key=key, dimensions=(1, 1, 1), digest="d")
    for source, key in (("catalog", "sofa"), ("file", "things/a.glb"), ("stand_in", "box"))
}


@every("key", PROPS)
def test_a_prop_is_meant_by_its_own_name(key: str) -> None:
    assert kind_named(PROPS[key].name) == key
    assert kind_named(f"the old {key}") == key


@every("key name", [(entry.key, name) for entry in ORDINARY for name in entry.tags])
def test_an_ordinary_thing_is_itself_by_all_its_names(key: str, name: str) -> None:
    assert kind_named(name) == key


@pytest.mark.parametrize(
    ("name", "key"),
    [
        ("two couches", "sofa"),
        ("old park benches", "park_bench"),
        ("old_wooden_table", "dining_table"),
        ("glass", "glass"),
        ("Ann's glasses", "glasses"),
        ("doll\u2019s house", "dolls_house"),
        ("photo of a car", "photograph"),
        ("bottle of milk", "bottle"),
        ("dog with a red collar", "dog"),
        ("xyzzy", ""),
        ("xyzzy on the table", ""),
        ("", ""),
    ],
)
def test_the_noun_of_a_name_says_what_a_thing_is(name: str, key: str) -> None:
    assert kind_named(name) == key


def made(source: str | None, kind: str | None, asset_type: AssetType = "object") -> Asset:
    look = CharacterLook() if asset_type == "character" else None
    return Asset(
        asset_id="it", asset_type=asset_type, name="lamp", description="a lamp", kind=kind, look=look,
        canonical=MADE.get(source or ""),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("source", "kind", "prop"),
    [
        ("catalog", "chair", "sofa"),
        ("file", "chair", "chair"),
        ("stand_in", "chair", "chair"),
        (None, "chair", "chair"),
        ("file", "", ""),
        ("catalog", None, "sofa"),
    ],
)
def test_a_thing_is_what_it_was_built_from_else_what_the_director_says(
    source: str | None, kind: str | None, prop: str
) -> None:
    assert prop_of(made(source, kind)) == prop


def test_in_an_older_project_the_name_says_what_a_thing_is() -> None:
    assert PROPS[prop_of(made("file", None))].lamp is not None
    assert "kind" not in made("file", None).model_dump()


def test_a_person_is_no_prop_whatever_they_are_called() -> None:
    assert prop_of(made(None, None, "character")) == ""


def test_what_the_catalog_does_not_have_any_more_is_left_out() -> None:
    assert props_of([made("file", "chair"), made("file", "zeppelin").model_copy(update={"asset_id": "z"})]) == {
        "it": "chair"
    }
