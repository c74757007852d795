"""What is so meanwhile: faces, eyes, lasting activities, how things are carried, who is led."""

from collections.abc import Callable

import pytest

from storyblender.agents.director.reader.people.look import age_phrase
from storyblender.agents.director.reading import Reading, Unit

Read = Callable[[str], Reading]
_CAST = "NORA (30) and OTTO (50) wait. "


def last(reading: Reading) -> Unit:
    return reading.units[-1]


@pytest.mark.parametrize(
    ("line", "faces"),
    [
        ("Nora is terrified.", {"nora": "terrified"}),
        ("Furious, Otto nods.", {"otto": "rage"}),
        ("Otto looks at Nora, puzzled.", {"otto": "thoughtful"}),
        ("Otto is not angry.", {}),
        ("Otto crosses an angry sea.", {}),
    ],
)
def test_faces_are_told_by_what_people_are(read_scene: Read, line: str, faces: dict[str, str]) -> None:
    told = last(read_scene(_CAST + line)).expressions
    assert {person: told.get(person) for person in faces} == faces and (faces or not told)


@pytest.mark.parametrize(
    ("line", "way"),
    [
        ("Otto looks up at the ceiling.", "up"),
        ("Otto stares at his shoes.", "down"),
        ("Otto closes his eyes.", "closed"),
        ("Otto looks into the camera.", "camera"),
    ],
)
def test_eyes_go_where_nothing_is(read_scene: Read, line: str, way: str) -> None:
    reading = read_scene(_CAST + line)
    assert last(reading).gaze == {"otto": way}
    assert "camera" not in {thing.id for thing in reading.things}


def test_who_looks_at_somebody_has_his_eyes_open_again(read_scene: Read) -> None:
    assert last(read_scene(_CAST + "Otto closes his eyes. Otto looks at Nora.")).gaze == {"otto": "nora"}


def test_what_goes_on_ends_with_another_deed(read_scene: Read) -> None:
    reading = read_scene(_CAST + "Otto is on the phone. Nora nods. Otto hangs up.")
    assert [unit.activities for unit in reading.units[1:]] == [{"otto": "phone"}, {}, {"otto": ""}]
    assert not reading.relations


@pytest.mark.parametrize(
    ("line", "grip"),
    [
        ("Otto sits, a drum on his lap.", "lap"),
        ("Otto enters with a drum under his arm.", "under_arm"),
        ("Otto holds a drum in both hands.", "both"),
    ],
)
def test_things_are_carried_as_told(read_scene: Read, line: str, grip: str) -> None:
    unit = last(read_scene(_CAST + line))
    assert unit.grips == {"otto": {"drum": grip}}
    assert unit.held["otto"] == ["drum"]


def test_what_somebody_has_is_in_hand(read_scene: Read) -> None:
    assert last(read_scene(_CAST + "Otto has a pistol.")).held == {"otto": ["pistol"]}


def test_who_leads_whom(read_scene: Read) -> None:
    reading = read_scene(_CAST + "A dog trots in. Otto leads the dog on a leash. Otto and Nora hold hands.")
    told = [(tether.holder, tether.held, tether.kind) for unit in reading.units for tether in unit.tethers]
    assert told == [("otto", "dog", "leash"), ("otto", "nora", "hand")]


def test_looks_are_told_anywhere(read_scene: Read) -> None:
    reading = read_scene(
        "OTTO. Sixty-six. Bald.\n\nNORA waits. She is twenty. Her hair is wet, her coat is torn. "
        "Otto is a tall man with a grey beard. Nora wears a red dress. Otto is not fat."
    )
    otto, nora = reading.people
    assert (otto.age, otto.hair, otto.build) == ("66", ("bald", "grey beard"), ("tall man",))
    assert (nora.age, nora.hair, nora.outfit) == ("20", ("wet hair",), ("torn coat", "red dress"))


@pytest.mark.parametrize(
    ("written", "age"),
    [
        ("72 years", "72"),
        ("late thirties", "late 30s"),
        ("middle aged", "50s"),
        ("about nine", "9"),
        ("in her forties", "40s"),
        ("15-year-old", "15"),
        ("5 feet", ""),
        ("1998", ""),
    ],
)
def test_ages_in_all_forms(written: str, age: str) -> None:
    assert age_phrase(written) == age


@pytest.mark.parametrize(
    ("line", "posture"),
    [
        ("Otto hangs from the gutter.", "hang"),
        ("Otto hangs upside down from a branch.", "upside_down"),
        ("Otto floats above the table.", "float"),
        ("Otto crawls to the door.", "crawl"),
        ("Otto is on horseback.", "ride"),
    ],
)
def test_postures_to_which_no_motion_leads(read_scene: Read, line: str, posture: str) -> None:
    assert last(read_scene(_CAST + line)).posture["otto"][0] == posture


@pytest.mark.parametrize(
    "line",
    [
        "There is no lamp and no chair.",
        "Lights like a spaceship landed.",
        "It is an oven in here.",
        "In any case he waits.",
        "Otto sits without a blanket.",
        "The sea is as flat as a mirror.",
    ],
)
def test_what_is_denied_or_likened_is_not_there(read_scene: Read, line: str) -> None:
    assert read_scene(_CAST + line).things == []


def test_clothes_that_are_somebodys_belong_to_their_looks(read_scene: Read) -> None:
    reading = read_scene("NORA walks in. TIBOR tips his straw hat to her. PELLE, a boy in a torn coat, laughs.")
    worn = {person.id: " ".join(person.outfit) for person in reading.people}
    assert "straw hat" in worn["tibor"]
    assert "torn coat" in worn["pelle"]
    assert not worn["nora"]
