"""Casting: words of the script become years, hair, cloth."""

from __future__ import annotations

import pytest

from storyblender.agents.director.casting import (
    age_in_years,
    age_word,
    cast_look,
    describe_person,
    garments_in,
    introduction_words,
)
from storyblender.agents.director.reading import Person
from storyblender.catalog.homelands import homeland_of


@pytest.mark.parametrize(
    ("age", "number"),
    [("35", 35), ("late 30s", 38), ("early 40s", 42), ("mid-50s", 55), ("20s", 25), ("child", 9), ("old", 72),
     ("forties", 45), ("age 7", 7), ("young", 25)],
)  # fmt: skip
def test_years(age: str, number: float) -> None:
    assert age_in_years(Person("x", "X", age=age)) == number


def test_an_age_that_is_not_said_is_an_adults_and_always_the_same() -> None:
    look = cast_look(Person("bob", "BOB"))
    assert 30 <= look.age < 45 and look == cast_look(Person("bob", "BOB"))


@pytest.mark.parametrize(
    ("words", "keys"),
    [
        ("white dinner jacket", "shirt trousers bow_tie dinner_jacket"),
        ("grey suit and a red tie", "shirt trousers tie jacket"),
        ("navy uniform", "trousers uniform boots cap"),
        ("trench coat over a black dress", "dress coat"),
        ("red hoodie", "hoodie"),
        ("two men in grey uniforms", "trousers uniform boots cap"),
        ("a white evening gown", "gown"),
        ("a green dress and high heels", "dress heels"),
        ("a blouse, a long skirt and a straw hat", "blouse long_skirt straw_hat"),
        ("a flat cap and a scarf over a jumper", "sweater scarf flat_cap"),
        ("jeans, white t-shirt, sneakers", "tee jeans shoes"),
        ("yellow oilskins and boots", "raincoat boots"),
        ("waistcoat", "vest"),
        ("a grey kimono", "kimono"),
        ("muddy red kits", "socks tee shorts shoes"),
        ("a white spacesuit", "space_suit"),
        ("striped pyjamas and a dressing gown", "pyjamas robe"),
        ("a black top hat and a cloak", "cloak top_hat"),
        ("nothing at all", ""),
    ],
)
def test_garments(words: str, keys: str) -> None:
    assert {garment.key for garment in garments_in(words)} == {*keys.split()}


def test_colours_belong_to_their_garment() -> None:
    coat, dress = (
        next(g for g in garments_in("dark green coat over a red dress") if g.key == key) for key in ("coat", "dress")
    )
    assert coat.color and coat.color[1] > coat.color[0]
    assert dress.color and dress.color[0] > 5 * dress.color[1]
    brown = garments_in("brown leather jacket")[0].color
    assert brown and brown[0] > brown[2]


def test_looks() -> None:
    look = cast_look(
        Person(
            "x",
            "X",
            gender="male",
            age="60s",
            build=("tall", "burly"),
            hair=("long grey hair", "black beard"),
            face=("glasses",),
        )
    )
    assert (look.build, look.hair, look.facial_hair, look.glasses) == ("stocky", "long", "beard", True)
    assert look.stature and look.stature > 1.85
    assert look.hair_color and max(look.hair_color) - min(look.hair_color) < 0.05


@pytest.mark.parametrize(
    ("words", "style"),
    [("slicked black hair", "slick"), ("wavy brown hair", "wavy"), ("an afro", "afro"),
     ("receding grey hair", "receding"),
     ("a shaved head", "shaved"), ("a blonde bob", "bob"), ("curly hair", "curly")],
)  # fmt: skip
def test_hair(words: str, style: str) -> None:
    assert cast_look(Person("x", "X", gender="male", hair=(words,))).hair == style


def test_a_woman_in_a_dress_wears_heels_unless_it_is_said() -> None:
    def keys(gender: str, words: str) -> set[str]:
        look = cast_look(Person("x", "X", gender=gender, age="30", outfit=(words,)))  # type: ignore[arg-type]
        return {garment.key for garment in look.garments}

    assert "heels" in keys("female", "red dress")
    assert "heels" not in keys("female", "red dress, sandals") | keys("male", "kimono") | keys("female", "grey suit")


def test_blonde_hair_is_not_yellow() -> None:
    color = cast_look(Person("x", "X", hair=("blonde hair",))).hair_color
    assert color and color[0] / color[2] < 3.5


def test_skin_only_where_it_is_said() -> None:
    assert cast_look(Person("x", "X", hair=("dark hair",))).skin == "light"
    assert cast_look(Person("x", "X"), "40s, broad, dark-skinned, blue suit").skin == "dark"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("SAM (40s, blue suit) sits.", "40s, blue suit"),
        ("ANN, a young woman in a red dress, looks up.", "a young woman in a red dress, looks up"),
        ("GUARDS in grey uniforms stand.", "grey uniforms stand"),
        ("SAM sits. BOB (30, tie) waits.", ""),
    ],
)
def test_introductions(text: str, words: str) -> None:
    assert introduction_words(Person("x", "X"), text) == words


def test_a_description_is_one_sentence() -> None:
    person = Person(
        "x", "X", gender="female", age="35", build=("lean",), hair=("short black hair",), outfit=("a grey coat",)
    )
    assert describe_person(person) == "A lean woman, 35, short black hair, in grey coat."


def test_who_is_not_dressed_by_the_script_is_dressed_by_trade_and_age() -> None:
    sheriff = Person(id="cole", name="Cole", role="sheriff", gender="male")
    assert "cowboy_hat" in {garment.key for garment in cast_look(sheriff, era="west").garments}
    in_red = Person(id="cole", name="Cole", role="sheriff", gender="male", outfit=("red sweater",))
    assert {garment.key for garment in cast_look(in_red, era="west").garments} == {"sweater"}


@pytest.mark.parametrize(
    ("heading", "skin"),
    [
        ("EXT. BALOGUN MARKET, LAGOS - DAY", "dark"),
        ("INT. TEA HOUSE, KYOTO - AFTERNOON", "light"),
        ("EXT. GHATS, VARANASI - DAWN", "brown"),
        ("EXT. LONDON / EXT. PORT OF DAR ES SALAAM", "dark"),
    ],
)
def test_people_look_as_most_do_where_the_story_is_set(heading: str, skin: str) -> None:
    look = cast_look(Person("ade", "ADE", gender="male", age="30"), homeland=homeland_of(heading))
    assert look.skin == skin
    assert look.hair_color is not None and max(look.hair_color) < 0.05


def test_the_script_and_foreigners_go_before_the_place() -> None:
    lagos = homeland_of("LAGOS")
    assert cast_look(Person("ann", "ANN", build=("pale",)), homeland=lagos).skin == "pale"
    assert cast_look(Person("bob", "BOB", role="tourist"), homeland=lagos).skin == "light"
    assert homeland_of("INT. KITCHEN - NIGHT") is None


def test_a_word_of_age_before_the_name_is_its_age() -> None:
    text = "Baby TOM sleeps. Inspector RAO waits."
    assert age_word(Person("tom", "TOM", first=5), text) == "baby"
    assert age_word(Person("rao", "RAO", first=text.index("RAO")), text) == ""


def test_a_womans_swimming_costume_is_no_trunks() -> None:
    for gender, key in (("female", "swimsuit"), ("male", "swim_trunks")):
        look = cast_look(Person("kim", "Kim", gender=gender, outfit=("green swimming costume",)))
        assert [garment.key for garment in look.garments] == [key]


def test_a_garment_named_again_without_a_colour_is_the_same_garment() -> None:
    (jacket,) = (garment for garment in garments_in("cream linen suit, jacket") if garment.key == "jacket")
    assert jacket.color == next(each.color for each in garments_in("cream linen suit") if each.key == "jacket")
