"""Which works of a catalogue are the thing that a script names, and which are only called like it."""

from __future__ import annotations

import pytest

from storyblender.catalog.recipe import AssetQuery
from storyblender.library.embedder import load_embedder
from storyblender.library.matching import Likeness
from storyblender.library.offer_matching import Offers, is_asked_for, need_of, ranked, search_words, title_words
from storyblender.memory.asset_sheet import Asset
from storyblender.services.offers import Offer
from tests.crew import no_words


def query(name: str, description: str = "", **more: object) -> AssetQuery:
    values = dict(asset_id="it", asset_type="object", name=name, description=description or f"a {name}", **more)
    return AssetQuery(asset=Asset.model_validate(values))


def best(phrase: str, *titles: str, by_meaning: bool = False, words: tuple[str, ...] = ()) -> tuple[str, float]:
    """Return the title that is taken and its score."""
    offers = Offers.of([Offer("sketchfab", f"n{n}", title, words=words) for n, title in enumerate(titles)])
    likeness = Likeness(load_embedder if by_meaning else no_words)
    found = ranked(query(phrase), offers, likeness, by_meaning=by_meaning)
    return (offers.by_id[found[0].key].name, found[0].score) if found else ("", 0.0)


@pytest.mark.parametrize(
    ("phrase", "titles", "taken"),
    [
        ("chair", ["Table Lamp", "Dining Chair 02", "Chair"], "Chair"),
        ("armchair", ["Chair", "ArmChair 01"], "ArmChair 01"),
        ("desk", ["Old wooden Desk | game ready (PBR)", "Desk lamp"], "Old wooden Desk | game ready (PBR)"),
        ("violin", ["Violin by someone", "Violin case"], "Violin by someone"),
        ("typewriter", ["Vintage Typewriter - Low Poly", "Typewriter key"], "Vintage Typewriter - Low Poly"),
        ("red telephone", ["Telephone", "Red Telephone 3D scan"], "Red Telephone 3D scan"),
        ("vase", ["Broken vase", "Ceramic Vase 03"], "Ceramic Vase 03"),
        ("bookshelf", ["Shelf 01", "Wooden Bookshelf Worn"], "Wooden Bookshelf Worn"),
        ("coffee table", ["Coffee Cart 01", "Coffee Table Round 01"], "Coffee Table Round 01"),
        ("rocking chair", ["School Chair 01", "Rockingchair 01"], "Rockingchair 01"),
        ("oil lamp", ["Industrial Wall Lamp", "Vintage Oil Lamp"], "Vintage Oil Lamp"),
    ],
)
def test_the_thing_itself_is_taken(phrase: str, titles: list[str], taken: str) -> None:
    title, score = best(phrase, *titles)
    assert title == taken and score >= 9


@pytest.mark.parametrize(
    ("phrase", "title", "most"),
    [
        ("car", "Toy Car", 6), ("chair", "Destroyed Chair", 6), ("lamp", "Street Lamp 01", 8.5),
        ("chair", "Rocking chair", 8.5), ("table", "Tablecloth", 0), ("glass", "Magnifying Glass", 8.5),
    ],
)  # fmt: skip
def test_what_is_only_called_like_it_is_not_the_thing(phrase: str, title: str, most: float) -> None:
    assert best(phrase, title)[1] <= most


def test_a_tag_helps_where_no_name_does() -> None:
    assert best("astrolabe", "Old device", words=("astrolabe", "brass")) == ("", 0.0)
    assert best("astrolabe", "Old device", words=("astrolabe", "brass"), by_meaning=True)[1] == 7.5


def test_meaning_helps_where_no_name_does() -> None:
    title, score = best("couch", "Brick wall", "Sofa", by_meaning=True)
    assert title == "Sofa" and score >= 7


def test_what_is_too_large_is_not_offered() -> None:
    assert Offers.of([Offer("sketchfab", "a", "Chair", bytes=10**9)]).names == {}


@pytest.mark.parametrize(
    ("phrase", "words"),
    [
        ("small red leather armchair", "armchair"), ("Anna's old guitar", "guitar"), ("bottle of milk", "bottle"),
        ("pile of money", "money"),
    ],
)  # fmt: skip
def test_only_the_words_for_the_thing_are_sent(phrase: str, words: str) -> None:
    assert search_words(phrase) == words


@pytest.mark.parametrize("title", ["", "|||", "<script>", "3D", "椅子"])
def test_odd_titles_are_no_names(title: str) -> None:
    assert title_words(title) in ("", "script")
    assert Offers.of([Offer("sketchfab", "a", title)]).terms is not None


def test_large_things_get_finer_textures() -> None:
    assert (
        need_of(query("mug")).pixels == 1024
        and need_of(query("bookshelf")).pixels <= need_of(query("tree")).pixels == 2048
    )


@pytest.mark.parametrize(
    ("more", "asked"),
    [({}, True), ({"origin": "dressing"}, False), ({"tags": ("animal",)}, False), ({"tags": ("vehicle",)}, False),
     ({"writing": "HELP"}, False), ({"liquid": "#ffffff"}, False)],
)  # fmt: skip
def test_services_are_asked_for_plain_things_that_the_script_names(more: dict[str, object], asked: bool) -> None:
    assert is_asked_for(query("chair", **more)) is asked
