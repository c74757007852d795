"""Who is cast and who is not: places with names, animals introduced by name, people named by a description."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.casting import age_word
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

Read = Callable[[str], Reading]


def told(story: str) -> dict[str, tuple[str, ...]]:
    return {person.id: person.aliases for person in read_script(read(story, "prose")).people}


@pytest.mark.parametrize("place", ["Linden Street", "the Anchor Café", "Market Square"])
def test_a_named_place_is_nobody(place: str) -> None:
    story = f"Nora walked into the rain.\n\nBy noon she stood in {place} and waited. Nora sighed.\n"
    assert [*told(story)] == ["nora"]


def test_an_animal_introduced_by_name_is_cast(read_scene: Read) -> None:
    reading = read_scene("OTTO (71, a man) sits. A basset hound, BISCUIT, sleeps by the stove.")
    assert [(person.id, person.kind) for person in reading.people] == [("otto", "human"), ("biscuit", "animal")]
    assert reading.units[-1].on_stage == ["otto", "biscuit"]


def test_who_is_known_by_another_name_is_one_person(read_scene: Read) -> None:
    reading = read_scene("DENISE WARD (48, known as DEN, the coach) frowns.\n\nDEN\nRun!\n\nDen sits.")
    assert [person.id for person in reading.people] == ["denise_ward"]


def test_a_trade_told_right_after_a_new_name_is_whoever_has_it() -> None:
    story = "Ines pushed her bicycle.\n\nTobias was there before her. The old fisherman sat on a bollard and slept.\n"
    people = told(story)
    assert [*people] == ["ines", "tobias"]
    assert "fisherman" in people["tobias"]


def test_what_a_name_is_said_to_be_may_be_followed_by_a_comma() -> None:
    people = told("Gus ran. Mrs Dorn, the headmistress, was at the piano. The headmistress got up.\n")
    assert [*people] == ["gus", "mrs_dorn"]
    assert "headmistress" in people["mrs_dorn"]


def test_a_name_on_a_badge_is_the_wearers() -> None:
    people = told("Nora stopped. The driver was new. Irma, says the tag on her jacket. Irma laughed.\n")
    assert "driver" in people["irma"]
    assert "driver" not in people


def test_a_man_is_not_the_old_man_of_before() -> None:
    middle = "Nora played. The old man looked at her. " * 12
    people = told(f"Beside Nora, on the bench, an old man was feeding a dove.\n\n{middle}\n\nA man opened the door.\n")
    assert {"old man", "man"} <= {alias for aliases in people.values() for alias in aliases}
    assert len(people) == 3


def test_a_rocking_horse_and_a_crew_cut_are_nobody() -> None:
    assert [*told("Nora had a crew cut. A rocking horse stood there, and the rocking horse swung. Nora sat.\n")] == [
        "nora"
    ]


def test_a_harbourmaster_is_somebody() -> None:
    people = told(
        "Kit waited for Rourke. Rourke, the harbourmaster, came in. Kit looked at him. The harbourmaster sat down.\n"
    )
    assert [*people] == ["kit", "rourke"]
    assert "harbourmaster" in people["rourke"]


def test_days_of_the_week_are_nobody() -> None:
    assert [*told("Nora sat down. The room was too small, and on Thursdays it was full. Nora sighed.\n")] == ["nora"]


def test_who_has_a_portrait_and_speaks_is_there() -> None:
    story = 'Nora looked at a portrait of Edward. "It is a poor likeness," said Edward. Nora laughed.\n'
    assert [*told(story)] == ["nora", "edward"]


@pytest.mark.parametrize(
    "line",
    [
        "The clerk: Tomorrow, perhaps. Nora sighed.",
        "Nora drew up the Mortgage that day. It was a Mortgage.",
        "Nora waited. (Softly) Whatever was in it glowed. Sorry, she thought.",
        "Only Nora stayed. Also the lamp. Medium, she thought.",
    ],
)
def test_a_capital_alone_names_nobody(line: str) -> None:
    assert [*told(f"Nora walked into the hall.\n\n{line}\n")] in (["nora"], ["nora", "clerk"])


def test_a_writer_who_says_i_tells_no_story() -> None:
    story = "I should like to record that Nora waited. She sat down. I think it is my best chapter.\n"
    assert [*told(story)] == ["nora"]


@pytest.mark.parametrize(
    ("action", "who"),
    [
        ("A waitress brings OTTO (50) the soup.", {"otto", "waitress"}),
        ("At the bar sits a tall sailor. OTTO (50) nods.", {"otto", "sailor"}),
        ("Two guards drag OTTO (50) in.", {"otto", "guard"}),
        ("OTTO (50) waits. Nadia opens the window.", {"otto", "nadia"}),
        ("The bartender pours OTTO (50) a drink.", {"otto", "bartender"}),
        ("OTTO (50) sits in the witness stand like a judge.", {"otto"}),
        ("A bride, SELMA (27), kisses OTTO (50).", {"otto", "selma"}),
        ('OTTO (50) hangs up a sign: "HAPPY BIRTHDAY ANNA". A CRASH, a SCREAM.', {"otto"}),
    ],
)
def test_walk_ons_who_do_something_are_cast(read_scene: Read, action: str, who: set[str]) -> None:
    assert {person.id for person in read_scene(action).people} == who


def test_the_list_of_a_cast_tells_each_one_apart() -> None:
    play = (
        "THE HAT\n\nCHARACTERS\n\nMAMA OTTI, a tailor, fifty-eight\nLARK, her apprentice, seventeen\n"
        "CHIEF BRONN, a baker, sixty\n\nSETTING: A shop.\n\nMAMA OTTI. Good day.\n\nLARK. Good day.\n\n"
        "CHIEF. Is it finished?\n\nMAMA OTTI. No.\n\nLARK. Not yet.\n"
    )
    reading = read_script(read(play))
    assert {p.id: (p.age, p.role) for p in reading.people if p.id != "mama_otti"} == {
        "lark": ("17", "apprentice"),
        "chief_bronn": ("60", "baker"),
    }
    assert reading.people[0].gender == "female"
    assert [unit.speaker for unit in reading.units if unit.kind == "dialogue"][2] == "chief_bronn"


def test_a_figure_who_is_revealed_has_a_name(read_scene: Read) -> None:
    reading = read_scene("OTTO (50) waits. A FIGURE. The figure steps into the light, revealing --\n\nMARCUS (40s).")
    assert [person.id for person in reading.people] == ["otto", "marcus"]


def test_a_name_of_two_words_with_a_hyphen_is_one(read_scene: Read) -> None:
    story = "Long-Ears sat by the door. Little Jack Bunny hopped in. Long-Ears waved to Jack.\n"
    assert {"long_ears"} < {*told(story)} and "long" not in told(story)


@pytest.mark.parametrize("line", ["GRACE sitting down. OTTO leaving.", "CLOSE ON - TOASTER\n\nGRACE sits. OTTO waits."])
def test_who_is_told_in_shorthand_is_cast(read_scene: Read, line: str) -> None:
    assert {person.id for person in read_scene(line).people} == {"grace", "otto"}


def test_old_before_a_new_name_is_an_age_and_no_part_of_the_name() -> None:
    reading = read_script(
        read("The Keeper\n\nMartha sits at the table. Old Jonas comes in. They dance in Old Town.", "prose")
    )
    assert [person.name for person in reading.people] == ["Martha", "Jonas"]
    assert age_word(reading.people[1], reading.screenplay.text) == "old"
