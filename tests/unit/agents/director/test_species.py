"""Animals that act like people have the head of their kind and its height."""

from __future__ import annotations

import pytest

from storyblender.agents.director.casting import cast_look
from storyblender.agents.director.creatures import is_creature
from storyblender.agents.director.reading import Deed, Person, Reading, Unit
from storyblender.catalog.species import SPECIES, species_of
from storyblender.screenplay.model import Screenplay


def _reading() -> Reading:
    return Reading(screenplay=Screenplay(format="fountain", text=""))


@pytest.mark.parametrize(("words", "name"), [("old grey badger", "badger"), ("hare", "rabbit"), ("raven", "crow")])
def test_a_kind_is_known_by_any_of_its_words(words: str, name: str) -> None:
    found = species_of(words)
    assert found is not None and found.words[0] == name


def test_an_animal_that_speaks_is_a_character_and_one_that_does_not_is_none() -> None:
    badger = Person("brock", "Brock", kind="animal", role="badger", speaks=True)
    dog = Person("rex", "Rex", kind="animal", role="dog")
    parrot = Person("polly", "Polly", kind="animal", role="parrot", speaks=True)
    assert [is_creature(each, _reading()) for each in (badger, dog, parrot)] == [False, True, True]


def test_a_mouse_is_smaller_than_a_bear_and_both_have_their_heads() -> None:
    mouse, bear = (cast_look(Person(word, word, kind="animal", role=word)) for word in ("mouse", "bear"))
    assert (mouse.species, bear.species) == ("mouse", "bear")
    assert mouse.stature and bear.stature and mouse.stature < 0.5 * bear.stature
    assert not cast_look(Person("fox", "Mr Fox", role="lawyer")).species, "a name makes no animal"


def test_every_kind_has_a_height_that_a_person_can_have() -> None:
    assert all(0.4 <= each.height <= 2.4 for each in SPECIES.values())


def _does(actor: str, motion: str, prop: str | None = None) -> Unit:
    deed = Deed(actor, motion, prop=prop)  # type: ignore[arg-type]
    return Unit(kind="action", scene=0, element=0, start=0, end=1, text="x", deeds=[deed], on_stage=[actor])


def _of(*people: Person, units: tuple[Unit, ...] = ()) -> Reading:
    return Reading(screenplay=Screenplay(format="fountain", text=""), people=[*people], units=[*units])


def test_a_silent_animal_that_stamps_a_form_or_puts_glasses_on_acts_like_a_person() -> None:
    raccoon = Person("r", "Leonard", kind="animal", role="raccoon")
    worn = _does("r", "look")
    worn.grips["r"] = {"glasses": "worn"}
    assert not is_creature(raccoon, _of(raccoon, units=(_does("r", "write", "form"),)))
    assert not is_creature(raccoon, _of(raccoon, units=(worn,)))
    assert is_creature(raccoon, _of(raccoon, units=(_does("r", "take", "nut"),)))


def test_who_is_ridden_or_only_has_a_coat_is_an_animal() -> None:
    horse = Person("h", "Duke", kind="animal", role="horse", outfit=("saddle", "brown with a white blaze"))
    ridden = _does("ann", "look")
    ridden.posture["ann"] = ("ride", "h")
    assert is_creature(horse, _of(horse, units=(ridden,)))


def test_among_animals_that_talk_everyone_who_acts_is_one_of_them() -> None:
    fox, hen = (Person(word, word, kind="animal", role=word, speaks=True) for word in ("fox", "hen"))
    mole = Person("mole", "Mole", kind="animal", role="mole")
    assert not is_creature(mole, _of(fox, hen, mole, units=(_does("mole", "walk"),)))
    assert is_creature(mole, _of(mole, units=(_does("mole", "walk"),)))


def test_an_animal_wears_only_what_is_told() -> None:
    assert not cast_look(Person("b", "Brock", kind="animal", role="badger")).garments
    told = cast_look(Person("b", "Brock", kind="animal", role="badger", outfit=("waistcoat",)))
    assert [garment.key for garment in told.garments] == ["vest"]
