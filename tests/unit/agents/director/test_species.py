"""Animals that act like people have the head of their kind and its height."""

from __future__ import annotations

import pytest

from storyblender.agents.director.casting import cast
from storyblender.agents.director.creatures import is_creature
from storyblender.agents.director.reading import Person, Reading
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
    mouse, bear = (cast(Person(word, word, kind="animal", role=word)) for word in ("mouse", "bear"))
    assert (mouse.species, bear.species) == ("mouse", "bear")
    assert mouse.stature and bear.stature and mouse.stature < 0.5 * bear.stature
    assert not cast(Person("fox", "Mr Fox", role="lawyer")).species, "a name makes no animal"


def test_every_kind_has_a_height_that_a_person_can_have() -> None:
    assert all(0.4 <= each.height <= 2.4 for each in SPECIES.values())
