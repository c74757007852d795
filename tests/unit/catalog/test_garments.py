"""Nobody is ever without clothes, and every garment is complete data."""

from __future__ import annotations

from itertools import product

import pytest
from tests.every import every

from storyblender.catalog.cuts import Bodice, Footwear, Legs, Skirt
from storyblender.catalog.garments import GARMENTS, OUTER_LAYER, dressed
from storyblender.catalog.materials import hex_color
from storyblender.memory.asset_sheet import CharacterLook, Garment

PROMISED = """shirt tee blouse jacket dinner_jacket coat cardigan tunic dress skirt trousers shorts tie bow_tie belt hat
cap shoes boots apron vest uniform socks"""


def _wear(*keys: str, **look: object) -> CharacterLook:
    return CharacterLook.model_validate({"garments": tuple(Garment(key=key) for key in keys), **look})


def _covered(outfit: tuple[Garment, ...]) -> set[str]:
    return {area for garment in outfit for area in (*GARMENTS[garment.key].covers, *GARMENTS[garment.key].bares)}


def test_the_promised_garments_exist() -> None:
    assert set(GARMENTS) >= set(PROMISED.split())


@every("key", GARMENTS)
def test_what_a_garment_covers_is_sewn(key: str) -> None:
    spec = GARMENTS[key]
    kinds = {type(piece) for piece in spec.pieces}
    assert ("upper" not in spec.covers) or Bodice in kinds
    assert ("lower" not in spec.covers) or kinds & {Legs, Skirt}
    assert ("feet" not in spec.covers) or Footwear in kinds
    for color in spec.colors:
        assert all(0 <= channel <= 1 for channel in hex_color(color))


@every("gender age seed", product(("female", "male"), (1, 8, 30, 80), range(5)))
def test_an_empty_wardrobe_gets_a_whole_outfit(gender: str, age: int, seed: int) -> None:
    assert _covered(dressed(_wear(age=age), gender, seed)) >= {"upper", "lower", "feet"}


@every("key", GARMENTS)
def test_one_named_garment_is_completed(key: str) -> None:
    for gender in ("female", "male"):
        outfit = dressed(_wear(key), gender, 1)
        assert key in [garment.key for garment in outfit]
        assert _covered(outfit) >= {"upper", "lower", "feet"}


@pytest.mark.parametrize("key", ["jacket", "dinner_jacket", "coat", "cardigan", "vest"])
def test_an_open_garment_is_worn_over_another(key: str) -> None:
    outfit = dressed(_wear(key, "trousers"), "male", 0)
    assert any("upper" in GARMENTS[g.key].covers and GARMENTS[g.key].layer < OUTER_LAYER for g in outfit)


def test_clothes_go_on_from_the_inside_out_in_whatever_order_they_are_named() -> None:
    outfit = dressed(_wear("jacket", "tie", "trousers", "shirt", "shoes"), "male", 0)
    layers = [GARMENTS[garment.key].layer for garment in outfit]
    assert layers == sorted(layers)
    assert [garment.key for garment in outfit].index("shirt") < [garment.key for garment in outfit].index("jacket")


def test_an_unknown_garment_does_not_leave_a_person_bare() -> None:
    outfit = dressed(_wear("force_field"), "female", 3)
    assert _covered(outfit) >= {"upper", "lower", "feet"}
    assert all(garment.key in GARMENTS for garment in outfit)
