from typing import Literal

import pytest

from storyblender.agents.director.size_words import stated_size
from storyblender.agents.layout_artist.dimension_estimator import (
    DimensionEstimatorCritic,
    DimensionEstimatorView,
    RulesDimensionEstimator,
    estimate_dimension,
)
from storyblender.catalog.props import PROPS
from storyblender.catalog.recipe import Recipe
from storyblender.catalog.stand_ins import STAND_INS
from storyblender.memory.asset_sheet import Asset, AssetDimension, CanonicalAsset, CharacterLook


def thing(name: str, description: str = "") -> Asset:
    words = description or name
    size = stated_size(name, words, person=False)
    return Asset(asset_id=name.replace(" ", "_"), asset_type="object", name=name, description=words, stated_size=size)


def person(description: str = "a person", **look) -> Asset:
    size = stated_size("Someone", description, person=True)
    look = CharacterLook(**look)
    return Asset(asset_id="someone", asset_type="character", description=description, look=look, stated_size=size)


def only(dimension: AssetDimension) -> tuple[str, float]:
    ((side, value),) = [(side, value) for side, value in dimension.model_dump().items() if value is not None]
    return side, value


def test_people_follow_age_and_gender() -> None:
    man, woman, girl = (
        estimate_dimension(person(gender=gender, age=age)).height
        for gender, age in (("male", 35), ("female", 35), ("female", 6))
    )
    assert man is not None and woman is not None and girl is not None
    assert 1.7 < man < 1.85
    assert 1.55 < woman < man
    assert 1.0 < girl < 1.3


def test_a_stated_stature_and_a_written_measure_win() -> None:
    assert estimate_dimension(person(stature=1.93)).height == 1.93
    assert only(estimate_dimension(thing("statue", "a bronze statue, 3.5 m tall"))) == ("height", 3.5)
    assert only(estimate_dimension(thing("knife", "a 30 cm long knife"))) == ("depth", 0.3)
    assert only(estimate_dimension(thing("wall sign", "8 feet wide"))) == ("width", pytest.approx(2.438))


def test_words_of_size_scale_things_more_than_people() -> None:
    plain, huge = (only(estimate_dimension(thing("crate", words)))[1] for words in ("a crate", "a huge crate"))
    assert huge == pytest.approx(plain * 1.7, rel=0.02)
    plain, tall = (estimate_dimension(person(words)).height for words in ("a man", "a tall man"))
    assert plain is not None and tall is not None
    assert 1.03 < tall / plain < 1.1


def test_a_thing_is_as_large_as_the_prop_that_it_is() -> None:
    for kind in ("dressing_table", "car"):
        asset = thing("xyzzy").model_copy(update={"kind": kind})
        assert only(estimate_dimension(asset))[1] == pytest.approx(max(PROPS[kind].size), abs=0.01)
    assert only(estimate_dimension(thing("xyzzy on a car")))[1] < 1


def built(name: str, source: Literal["catalog", "stand_in"], key: str, description: str = "") -> Asset:
    recipe = Recipe(source=source, key=key, score=8.0)
    return thing(name, description).model_copy(update={"canonical": recipe.canonical()})


def test_a_stand_in_is_as_large_as_its_class() -> None:
    assert only(estimate_dimension(built("jug", "stand_in", "vessel")))[1] == max(STAND_INS["vessel"].size)
    assert only(estimate_dimension(built("frobnicator", "stand_in", "small_thing")))[1] < 0.2
    assert only(estimate_dimension(built("rocking horse", "stand_in", "garment")))[1] == max(STAND_INS["garment"].size)


def test_toys_are_small_and_furniture_keeps_to_people() -> None:
    assert only(estimate_dimension(built("car", "catalog", "car", "a red toy car")))[1] == pytest.approx(0.3)
    assert only(estimate_dimension(built("gun", "catalog", "gun", "a toy gun")))[1] == pytest.approx(0.19)
    plain, small = (
        only(estimate_dimension(built("chair", "catalog", "chair", words)))[1] for words in ("", "a tiny chair")
    )
    assert 0.7 * plain < small < plain


def test_every_draft_of_the_rules_passes_the_critic() -> None:
    assets = [
        *(thing(name) for name in ("apple", "castle", "frobnicator", "tiny ring", "huge ship")),
        person(age=3),
        person(age=90).model_copy(update={"asset_id": "elder"}),
        Asset(asset_id="dog", asset_type="character", description="a dog"),
    ]
    draft = RulesDimensionEstimator().propose(DimensionEstimatorView(assets))
    assert DimensionEstimatorCritic().judge(draft, DimensionEstimatorView(assets)).faults == ()


def test_the_critic_wants_exactly_one_value_and_the_rules_repair_it() -> None:
    assets = [thing("apple"), person()]
    draft = {"apple": AssetDimension(width=0.1, height=0.1), "someone": AssetDimension(height=4.0)}
    critique = DimensionEstimatorCritic().judge(draft, DimensionEstimatorView(assets))
    assert {fault.subject for fault in critique.faults} == {"apple", "someone"}
    repaired = RulesDimensionEstimator().refine(draft, critique, DimensionEstimatorView(assets))
    assert DimensionEstimatorCritic().judge(repaired, DimensionEstimatorView(assets)).score == 10


def made_of(key: str, name: str, *tags: str, source: Literal["catalog", "stand_in"] = "catalog") -> Asset:
    asset = Asset(asset_id="it", asset_type="object", name=name, description=name, tags=tags)
    recipe = Recipe(source=source, key=key, score=9.0)
    return asset.model_copy(update={"canonical": recipe.canonical()})


def test_what_somebody_carries_is_no_larger_than_arms_can_hold() -> None:
    carried = ("prop", "handled")
    assert only(estimate_dimension(made_of("potted_plant", "plant", *carried)))[1] < 0.6
    assert only(estimate_dimension(made_of("potted_plant", "plant", "prop")))[1] > 1.0
    assert only(estimate_dimension(made_of("bear", "bear", *carried)))[1] < 0.4
    assert only(estimate_dimension(made_of("bear", "bear", "animal")))[1] > 1.2
    assert only(estimate_dimension(made_of("wheelchair", "wheelchair", *carried)))[1] > 0.8
    assert only(estimate_dimension(made_of("round_thing", "plant", *carried, source="stand_in")))[1] < 0.5


def test_a_tree_that_was_brought_into_a_room_ends_below_its_ceiling() -> None:
    tree = made_of("tree", "tree")
    assert only(estimate_dimension(tree))[1] > 4
    room = (6.0, 5.0, 2.8)
    side, height = only(estimate_dimension(tree, room))
    assert side == "height"
    assert 2.0 < height < room[2]
    assert RulesDimensionEstimator().propose(DimensionEstimatorView((tree,), {"it": room}))["it"].height == height


def test_nothing_is_larger_than_its_room() -> None:
    bear = made_of("bear", "bear")
    assert estimate_dimension(bear, (6.0, 5.0, 2.8)) == estimate_dimension(bear)
    shape = CanonicalAsset(source="stand_in", key="slab", dimensions=(5.0, 8.0, 3.0), digest="")
    ship = thing("stranded thing").model_copy(update={"canonical": shape})
    assert only(estimate_dimension(ship)) == ("depth", 8.0)
    assert only(estimate_dimension(ship, (10.0, 9.0, 4.0)))[1] == pytest.approx(6.0)
    assert only(estimate_dimension(ship, (8.0, 10.0, 4.0)))[1] == pytest.approx(0.45 * 8 * 8 / 5)
    assert only(estimate_dimension(ship, (20.0, 20.0, 2.0)))[1] == pytest.approx(0.92 * 2 * 8 / 3, abs=0.01)
    stated = ship.model_copy(update={"stated_size": stated_size("ship", "12 m long", person=False)})
    assert only(estimate_dimension(stated, (10.0, 9.0, 4.0)))[1] == pytest.approx(6.0)


def test_furniture_keeps_to_peoples_size_in_the_smallest_room() -> None:
    bed, cell = made_of("bed", "bed"), (2.0, 2.2, 2.4)
    assert estimate_dimension(bed, cell) == estimate_dimension(bed)
