"""Who is first a noun and then a name is one person; who only looks so is two."""

from __future__ import annotations

import pytest

from storyblender.agents.director.reader.reader import read_script
from storyblender.screenplay.source import read


def cast(*paragraphs: str) -> set[str]:
    """The names of everybody who is there at some time."""
    reading = read_script(read("\n\n".join(paragraphs), "prose"))
    seen = {person for unit in reading.units for person in unit.on_stage}
    return {person.name for person in reading.people if person.id in seen}


INN = "Henrik pushed open the door of the inn. An old woman sat by the stove and peeled apples into a bowl."


@pytest.mark.parametrize(
    ("told", "who"),
    [
        ((INN, '"I\'m Oline," she said.', "Oline rose."), {"Henrik", "Oline"}),
        ((INN, '"Sit down," said the old woman. "My name is Oline."', "Oline rose."), {"Henrik", "Oline"}),
        ((INN, '"Good evening, Oline," said Henrik.', "Oline rose and took his coat."), {"Henrik", "Oline"}),
        ((INN, "Her name was Oline. She rose at once."), {"Henrik", "Oline"}),
        ((INN, '"You are late," she said.', "Oline rose and took his coat."), {"Henrik", "Oline"}),
        ((INN, '"This is Oline," said Henrik to the dog.', "Oline rose and took his coat."), {"Henrik", "Oline"}),
    ],
)
def test_a_name_goes_to_who_is_there_without_one(told: tuple[str, ...], who: set[str]) -> None:
    assert cast(*told) == who


@pytest.mark.parametrize(
    ("told", "who"),
    [
        ((INN, "Oline came in from the yard."), {"Henrik", "woman", "Oline"}),
        ((INN, "Oline looked at the old woman and laughed."), {"Henrik", "woman", "Oline"}),
        ((INN, "Tom sat at the other table."), {"Henrik", "woman", "Tom"}),
        ((INN, "On the stair Oline, his wife, held up a lantern."), {"Henrik", "woman", "Oline"}),
        (("Anna sat down. A waiter brought the coffee.", "Marit drank hers standing."), {"Anna", "waiter", "Marit"}),
    ],
)
def test_who_is_brought_in_is_somebody_else(told: tuple[str, ...], who: set[str]) -> None:
    assert cast(*told) == who


def test_a_dog_may_be_called_by_its_name() -> None:
    assert cast(
        "Anna stopped at the gate. An old dog lifted his head and barked.",
        '"Ringo," she said, and knelt down. Ringo licked her hand.',
    ) == {"Anna", "Ringo"}


def test_a_surname_is_his_where_he_is_he() -> None:
    who = cast(
        "Bess knocked. A man in a grey coat opened the door, and an old woman in the kitchen looked up.",
        "Mrs. Coker took both her hands.",
        '"My name is Coker," said the man. "Come in."',
        '"I was out," said Coker. He lit the lantern.',
    )
    assert who == {"Bess", "Coker", "Mrs. Coker"}


def test_a_young_man_much_later_is_another_man() -> None:
    walk = "They went down through the wet field without a word, in the rain and in the wind. " * 6
    who = cast("Bess knocked. A man in a grey coat opened the door.", walk, "By the wheel knelt a young man.")
    assert len(who) == 3


@pytest.mark.parametrize(
    ("told", "who"),
    [
        ("Tom watered a black horse. He sat down.", {"Tom"}),
        ("Tom held up a chair the way lion tamers do.", {"Tom"}),
        ("Tom sat down. On the step sat a grey cat.", {"Tom", "cat"}),
        ("Tom had a butterfly tattooed on his neck.", {"Tom"}),
        ("Tom stroked the goose. The bird hissed and walked away.", {"Tom", "goose"}),
        ("A robot the size of a child looked at Tom.", {"robot", "Tom"}),
    ],
)
def test_an_animal_is_cast_when_it_does_something(told: str, who: set[str]) -> None:
    assert cast(told) == who


@pytest.mark.parametrize(
    ("told", "who"),
    [
        ("Tom leaned on a silver Volvo and smoked.", {"Tom"}),
        ("By noon the fever had reached Stow. Tom lay down.", {"Tom"}),
        ("Tom sat in the office of Finch & Daughters and read.", {"Tom"}),
        ("Detective Mara Quinn ducks under the tape. Lopez hands her a cup.", {"Detective Mara Quinn", "Lopez"}),
        ("Anna sat down. So Tom rose and shut the door.", {"Anna", "Tom"}),
    ],
)
def test_what_is_a_name_of_somebody(told: str, who: set[str]) -> None:
    assert cast(told) == who


def test_the_lawyer_is_who_was_just_named() -> None:
    told = ('"Sit," said Mr. Finch. The lawyer unrolled the will.', "Henry sat down.")
    assert cast(*told) == {"Mr. Finch", "Henry"}


def test_a_surname_may_be_a_trade() -> None:
    reading = read_script(read("INT. ROOM - DAY\n\nTOM BAKER (40) sits.\n\nTom stands up.\n", "fountain"))
    assert [person.name for person in reading.people] == ["TOM BAKER"]


@pytest.mark.parametrize(
    ("told", "who"),
    [
        (("Mira sat still. Under the chair lay the twins, Ola and Per.", "The twins laughed."), {"Mira", "Ola", "Per"}),
        (
            ("The stranger sat on the well.", '"You got a name?"', '"Silas." The stranger spat.', "Silas rose."),
            {"Silas"},
        ),
        (("Jun came down. In the kitchen stood a young man.", "The thief put down the rice."), {"Jun", "thief"}),
        (("A man opened the door to the hall.", '"I am sorry," said her neighbor.'), {"neighbor"}),
        (("Inga sat on the bench.", "Her grandfather was sitting beside her."), {"Inga", "grandfather"}),
        (("Marcus sat on the bed.", '"No," said Dee.', "His sister sat down beside him."), {"Marcus", "Dee"}),
        (("Freya sat on the gate beside Uncle Gus.", "His brother looked at his boots."), {"Freya", "Uncle Gus"}),
        (("Father Ambrose put down a bucket.", "The priest pulled the curtain."), {"Father Ambrose"}),
        (("The nurse was a big man. He hung up a bag.", '"No," said Dee.'), {"nurse", "Dee"}),
        (("The kid looked behind him.", '"Mouse," said Tom. "You are in."', "Mouse stood up."), {"Tom", "Mouse"}),
        (("Emil stood at the door.", "Emil's mother went on hanging up sheets."), {"Emil", "mother"}),
        (
            ("A knight came in.", '"Sir Dunstan," said the knight. "I am late."', "Sir Dunstan sat down."),
            {"Sir Dunstan"},
        ),
        (("Vera rode as far as Linz. The train stood still.",), {"Vera"}),
        (("The tuner was blind. Greta stared.", '"Stop that," said Mr. Lux.'), {"Mr. Lux", "Greta"}),
        (("Tom sat down. The butler bowed.", '"Inspector Gale?" said Tom.'), {"Tom", "butler"}),
    ],
)
def test_one_person_is_counted_once(told: tuple[str, ...], who: set[str]) -> None:
    assert cast(*told) == who
