import random
from collections.abc import Callable
from pathlib import Path

import pytest

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Deed, Reading, StateChange
from storyblender.errors import InputError
from storyblender.screenplay.source import read

Read = Callable[[str], Reading]

GOLD = sorted((Path(__file__).parents[5] / "tests" / "data" / "director").glob("*.gold"))


def deeds(reading: Reading) -> list[Deed]:
    return [deed for unit in reading.units for deed in unit.deeds]


def scripts() -> list[str]:
    return ["\n".join(x for x in p.read_text("utf-8").splitlines() if not x.startswith("|")) for p in GOLD]


def test_an_exit_takes_effect_after_the_sentence(read_scene: Read) -> None:
    reading = read_scene("TOM and MIA sit. Tom leaves. Mia sighs.")
    assert [unit.on_stage for unit in reading.units] == [["tom", "mia"], ["tom", "mia"], ["mia"]]
    assert reading.units[1].leaving == ["tom"]
    assert reading.units[0].entering == ["tom", "mia"]


def test_postures_and_things_in_hand_are_carried_on(read_scene: Read) -> None:
    reading = read_scene("TOM sits in the armchair. He picks up a cup. He drinks. MIA enters. Tom gives her the cup.")
    assert reading.units[0].posture["tom"] == ("sit", "armchair")
    assert reading.units[3].posture["tom"] == ("sit", "armchair")
    assert reading.units[2].held == {"tom": ["cup"]}
    assert reading.units[2].deeds[0].prop == "cup"
    assert reading.units[4].held == {"mia": ["cup"]}


def test_relations_of_people_and_things(read_scene: Read) -> None:
    reading = read_scene(
        "A folder lies on the table. TOM stands behind MIA, a book in her lap. The phone on the wall rings."
    )
    stated = [(r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations]
    assert stated == [
        ("folder", "on", "table"), ("tom", "behind", "mia"), ("book", "on", "mia"), ("phone", "on", "wall"),
    ]  # fmt: skip


def test_doors_lights_and_breakage_are_emitted(read_scene: Read) -> None:
    reading = read_scene(
        "TOM opens the door. The lights go out. He lights a candle. The window shatters. He shuts the door."
    )
    changes = [change for unit in reading.units for change in unit.changes]
    assert [(c.subject, c.state) for c in changes] == [
        ("door", "open"), ("light", "off"), ("candle", "on"), ("window", "broken"), ("door", "closed"),
    ]  # fmt: skip
    assert isinstance(changes[0], StateChange)


def test_sounds_are_collected(read_scene: Read) -> None:
    reading = read_scene("BANG! Thunder rumbles. The phone rings. Footsteps. TOM fires. TOM looks at the phone.")
    assert [unit.sounds for unit in reading.units] == [
        ["bang"], ["thunder"], ["phone_ring"], ["footsteps"], ["gunshot"], [],
    ]  # fmt: skip


def test_distances_vehicles_and_moods(read_scene: Read) -> None:
    reading = read_scene("TOM angrily walks ten metres to the window. He gets into a truck. He gets out of the truck.")
    walk = reading.units[0].deeds[0]
    assert (walk.motion, walk.target, walk.distance, walk.mood) == ("walk", "window", 10.0, "angry")
    assert reading.units[1].posture["tom"] == ("sit", "truck")
    assert reading.units[2].posture["tom"] == ("stand", None)
    assert next(thing.kind for thing in reading.things if thing.id == "truck") == "vehicle"


def test_compounds_are_one_thing(read_scene: Read) -> None:
    reading = read_scene("TOM hands MIA a BIRTHDAY CARD. She opens the card.")
    assert [thing.id for thing in reading.things] == ["birthday_card"]
    assert reading.units[1].deeds[0].target == "birthday_card"


def test_pronouns_keep_whom_they_mean_and_close_calls_are_flagged(read_scene: Read) -> None:
    reading = read_scene("TOM hits BEN. He collapses. TOM and BEN stare at each other. They shake hands.")
    assert [who for _, word, who in reading.pronouns if word == "He"] == [("ben",)]
    assert [who for _, word, who in reading.pronouns if word == "They"] == [("tom", "ben")]
    unsure = read_scene("TOM and BEN wait. BEN and TOM nod. He laughs.")
    assert "pronoun" in {flag.topic for flag in unsure.flags}


def test_an_unknown_noun_in_the_hand_is_a_prop_and_flagged(read_scene: Read) -> None:
    reading = read_scene("TOM picks up the zorgle. The blivet hums.")
    assert [thing.id for thing in reading.things] == ["zorgle"]
    assert [flag.choice for flag in reading.flags if flag.topic == "prop"] == ["zorgle"]


def test_speech_addressee_manner_and_off_screen() -> None:
    reading = read_script(
        read(
            "INT. ROOM - DAY\n\nTOM, MIA and DR. LEE sit at the table.\n\nTOM\nWake up, Mia.\n\n"
            "MIA\n(whispering)\nHush.\n\n"
            "TOM\n(to Lee)\nYou too.\n\nBEN (V.O.)\nHello.\n\nMIA\n(into phone)\nWho is it?\n"
        )
    )
    speeches = [unit for unit in reading.units if unit.kind == "dialogue"]
    assert [unit.to for unit in speeches] == ["mia", "tom", "dr_lee", None, None]
    assert [unit.deeds[0].motion for unit in speeches if unit.deeds] == ["talk", "whisper", "talk", "talk"]
    assert speeches[-1].activities == {"mia": "phone"} and speeches[-1].held == {"mia": ["phone"]}
    assert [unit.off_screen for unit in speeches] == [False, False, False, True, False]
    assert "ben" not in speeches[-1].on_stage


def test_camera_directions_are_kept_and_are_no_people(read_scene: Read) -> None:
    reading = read_scene("CLOSE ON KIRA. She smiles.\n\nOVER KIRA'S SHOULDER: TOM waits.")
    cameras = [unit.camera for unit in reading.units if unit.camera]
    assert next(camera.size for camera in cameras) == "CU"
    assert [person.id for person in reading.people] == ["kira", "tom"]
    assert reading.units[0].expressions == {"kira": "smile"}


def test_offsets_point_into_the_script() -> None:
    text = "INT. CAFÉ - DAY\n\nÉLODIE (30s) takes *the cup*. She [[a note]] drinks.\n\nÉLODIE\nBonjour.\n"
    reading = read_script(read(text))
    assert [text[unit.start : unit.end].split()[0] for unit in reading.units] == ["ÉLODIE", "She", "Bonjour."]
    assert reading.people[0].id == "elodie"


def test_scenes_places_times_and_returns() -> None:
    reading = read_script(
        read(
            "INT. PALACE HOTEL - RM 412 - NIGHT\n\nTOM waits.\n\nEXT. STREET - CONTINUOUS\n\n"
            "Rain hammers the cars. Tom runs.\n\n"
            "INT. RM 412, DAY\n\nTom sleeps.\n\nINT KITCHEN\n\nTom eats.\n"
        )
    )
    rows = [(s.scene_type, s.place, s.time, s.reference, s.weather) for s in reading.scenes]
    assert rows == [
        ("indoor", "palace hotel rm 412", "night", None, "clear"),
        ("outdoor", "street", "night", None, "rain"),
        ("indoor", "rm 412", "day", 1, "clear"),
        ("indoor", "kitchen", "day", None, "clear"),
    ]
    assert [scene.place_kind for scene in reading.scenes] == ["hotel_room", "street", "", "kitchen"]


def test_a_story_changes_scenes_only_at_openings() -> None:
    reading = read_script(
        read(
            "Old Magnus kept the lighthouse for forty years. He lit the lamp.\n\n"
            "They pulled a stranger into the kitchen.\n\n"
            "In the morning the storm was over. Magnus walked along the beach.\n\nWhen he came home, he slept.\n"
        )
    )
    assert [(scene.place, scene.time) for scene in reading.scenes] == [
        ("lighthouse", "day"), ("beach", "morning"), ("lighthouse", "morning"),
    ]  # fmt: skip


def test_the_same_script_gives_the_same_reading() -> None:
    text = scripts()[0]
    assert read_script(read(text)) == read_script(read(text))


def test_a_feature_is_read_whole() -> None:
    chooser = random.Random(7)
    scenes = [f"INT. {part}" for text in scripts() for part in text.split("INT. ")[1:]]
    feature = "\n\n".join(chooser.choice(scenes) for _ in range(280))
    assert len(feature.splitlines()) / 55 > 100
    reading = read_script(read(feature))
    assert len(reading.scenes) >= 280
    assert all(unit.deeds or unit.text for unit in reading.units)


@pytest.mark.parametrize("seed", range(25))
def test_damaged_scripts_are_read_too(seed: int) -> None:
    chooser = random.Random(seed)
    text = chooser.choice(scripts())
    start = chooser.randrange(max(1, len(text) - 3000))
    letters = list(text[start : start + 3000])
    for _ in range(chooser.randrange(20, 150)):
        at = chooser.randrange(len(letters) - 1)
        letters[at : at + 1] = chooser.choice(
            (["\n"], ["\n", "\n"], [], ["\t"], list(" ( "), list('"'), list(":"), list("—"))
        )
    try:
        screenplay = read("".join(letters))
    except InputError:
        return
    reading = read_script(screenplay)
    assert all(0 <= unit.start <= unit.end <= len(screenplay.text) for unit in reading.units)


def _relations(reading: Reading) -> set[tuple[str, str, str]]:
    return {(r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations}


def test_a_noun_may_tell_the_motion(read_scene: Read) -> None:
    reading = read_scene("TOM gives a shrug and takes the stool. MIA breezes in. TOM jerks his head.")
    assert [deed.motion for deed in deeds(reading)] == ["shrug", "sit", "walk", "nod"]


def test_where_things_and_people_end_up(read_scene: Read) -> None:
    reading = read_scene(
        "TOM crosses to the desk and drops an envelope on it. He sweeps the bottle into a drawer. "
        "MIA runs alongside him. He lays his hat on the chair by the stove. "
        "On the table: a lamp, two glasses and a gun."
    )
    assert _relations(reading) >= {
        ("envelope", "on", "desk"), ("bottle", "in", "drawer"), ("mia", "next_to", "tom"), ("hat", "on", "chair"),
        ("chair", "next_to", "stove"), ("lamp", "on", "table"), ("gun", "on", "table"),
    }  # fmt: skip
    assert ("hat", "next_to", "stove") not in _relations(reading)


def test_numbered_people_are_the_group(read_scene: Read) -> None:
    reading = read_scene("In the booth sit two THUGS.\n\nTHUG #1 gets up. THUG #2 follows.")
    assert [person.id for person in reading.people] == ["thug_1", "thug_2"]
    assert {(deed.actor, deed.motion) for deed in reading.units[0].deeds} == {("thug_1", "sit"), ("thug_2", "sit")}


def test_people_by_age_by_kin_and_as_they_were_first_seen(read_scene: Read) -> None:
    reading = read_scene(
        "BRUNO, a young officer, waits. Bruno's daughter OLGA, six, hops. The girl laughs.\n\n"
        "A man staggers in. He falls.\n\nBruno drags the STRANGER to the bed."
    )
    assert [deed.actor for deed in deeds(reading) if deed.motion == "laugh"] == ["olga"]
    assert [deed.actor for deed in deeds(reading) if deed.motion in ("stagger", "fall")] == ["stranger", "stranger"]


def test_an_animal_in_a_name_for_a_thing_is_a_thing(read_scene: Read) -> None:
    reading = read_scene(
        "MIA swings a teddy bear.\n\nTOM takes the bear. He is a bear of a man. He sits in the witness stand."
    )
    assert {person.id: person.kind for person in reading.people} == {"mia": "human", "tom": "human"}


def test_a_script_in_capitals_is_read_like_others() -> None:
    reading = read_script(read("INT. BAR - NIGHT\n\nTHE MAN SITS DOWN AT THE BAR.\n\nMAN\nHELLO THERE.\n"))
    assert [person.id for person in reading.people] == ["man"]
    assert "sit" in {deed.motion for deed in deeds(reading)}


@pytest.mark.slow  # in other words the same as test_a_feature_is_read_whole
def test_a_whole_feature_is_read() -> None:
    feature = "\n\n".join(text for text in scripts() if "INT." in text or "EXT." in text)
    reading = read_script(read(feature))
    assert len(reading.scenes) > 60 and len(reading.people) > 60


def test_who_stands_alone_is_the_only_one_there() -> None:
    reading = read_script(
        read("INT. CAFÉ - NUIT\n\nRICK and ILSA kiss. ILSA smiles. RICK stands alone in the rain. He smokes.\n")
    )
    assert reading.scenes[0].time == "night"
    assert [unit.on_stage for unit in reading.units][1:] == [["rick", "ilsa"], ["rick"], ["rick"]]


def test_a_cart_is_the_fruit_cart_and_stones_are_ground(read_scene: Read) -> None:
    reading = read_scene("PIA vaults a fruit cart. She runs across the stones and hides behind the cart.")
    assert [thing.id for thing in reading.things] == ["fruit_cart"]
