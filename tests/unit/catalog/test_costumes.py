"""Trades and ages are seen in the clothes; nobody is sent into another century by one word."""

from __future__ import annotations

from itertools import product

from tests.every import every

from storyblender.catalog.costumes import _CHILDRENS, _EVERYDAY, _TRADES, _sewn, costume
from storyblender.catalog.garments import GARMENTS
from storyblender.memory.asset_sheet import Garment
from storyblender.memory.vocabulary import Age


def worn(role: str = "", name: str = "Alex", age: str = "today", gender: str = "male", years: float = 35) -> set[str]:
    return {garment.key for garment in costume(role, name, age, gender, years, 0)}  # type: ignore[arg-type]


def test_a_trade_is_known_by_its_clothes() -> None:
    assert {"cowboy_hat", "badge", "boots"} <= worn("sheriff")
    assert "lab_coat" in worn("doctor") and "scrubs" in worn("nurse", gender="female")
    assert "apron" in worn("nurse", gender="female", age="classic")
    assert "uniform" in worn(name="Policeman") and "wedding_dress" in worn("bride", gender="female")


def test_a_surname_is_no_trade_and_a_father_no_priest() -> None:
    assert "chef_hat" not in worn(name="Tom Baker") and "cassock" not in worn("father", "John")
    assert "cassock" in worn(name="Father Michael")


def test_who_has_no_trade_wears_the_age() -> None:
    assert "long_skirt" in worn(age="west", gender="female") and "uniform" in worn(age="space")
    assert worn("doctor", years=8).isdisjoint({"lab_coat", "stethoscope"}) and "backpack" in worn("pupil", years=9)


@every("age gender years", product(("today", "medieval", "west", "victorian", "classic"), ("male", "female"), (8, 40)))
def test_four_people_of_a_story_are_told_apart_by_their_clothes(age: Age, gender: str, years: float) -> None:
    outfits: list[tuple[Garment, ...]] = []
    for seed in (3, 3, 7, 11):
        outfits.append(costume("", "Alex", age, gender, years, seed, outfits))
    assert len(set(outfits)) == 4


@every(
    "outfit",
    sorted(
        {
            *(one for choices in (*_EVERYDAY.values(), _CHILDRENS) for outfits in choices for one in outfits),
            *(one for row in _TRADES for one in row[2:]),
        }
    ),
)
def test_every_outfit_is_in_the_wardrobe(outfit: str) -> None:
    areas = {
        area for garment in _sewn(outfit) for area in (*GARMENTS[garment.key].covers, *GARMENTS[garment.key].bares)
    }
    assert not outfit or {"upper", "lower", "feet"} <= areas


def test_court_sport_and_cabin_are_seen_in_the_clothes() -> None:
    assert "cassock" in worn(name="Judge Halloran") and "lab_coat" in worn(name="Dr. Weiss")
    assert worn("goalkeeper", gender="female") >= {"shorts", "tee"}
    assert "sweater" in worn(name="Coach Brennan")
    assert "scarf" in worn(name="Flight Attendant", gender="female")
