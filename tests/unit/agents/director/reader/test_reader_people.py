from collections.abc import Callable

from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import Reading
from storyblender.screenplay.source import read

Read = Callable[[str], Reading]


def ids(text: str) -> list[str]:
    return [person.id for person in read_script(read(text)).people]


def test_a_short_cue_belongs_to_the_long_name() -> None:
    script = "EXT. PORCH - DAY\n\nOFFICER HALE climbs the steps. JO and JOANNA watch.\n\nHALE\nMorning.\n"
    assert ids(script) == ["officer_hale", "jo", "joanna"]


def test_noises_and_things_in_capitals_are_not_people(read_scene: Read) -> None:
    reading = read_scene("BANG! TOM (30s) drops a LANTERN. CRASH.")
    assert [person.id for person in reading.people] == ["tom"]


def test_the_look_is_sorted(read_scene: Read) -> None:
    nora = read_scene("NORA VANCE (35, lean, short black hair, grey trench coat) waits.").people[0]
    assert (nora.age, nora.build, nora.hair) == ("35", ("lean",), ("short black hair",))
    assert nora.outfit == ("grey trench coat",)
    assert nora.gender == "female"


def test_the_same_person_at_another_age_is_a_variant(read_scene: Read) -> None:
    reading = read_scene("EDWARD (40) sleeps. YOUNG EDWARD (12) climbs a tree.\n\nEdward wakes.")
    young = next(person for person in reading.people if person.id == "young_edward")
    assert young.variant_of == "edward"
    assert reading.units[-1].deeds[0].actor == "edward"


def test_several_in_one_name_are_a_group(read_scene: Read) -> None:
    reading = read_scene("TWO SAILORS wait by the door. VERA AND DUTCH enter.")
    assert next((p.id, p.kind, p.count) for p in reading.people) == ("sailor", "group", 2)
    assert {"vera", "dutch"} <= {person.id for person in reading.people}


def test_ids_are_unique_between_people_and_things(read_scene: Read) -> None:
    reading = read_scene("ROSE (20s) picks up a rose. She gives the rose to the WAITER.")
    every = [person.id for person in reading.people] + [thing.id for thing in reading.things]
    assert len(every) == len(set(every))


def test_kin_in_a_story_are_the_people_known() -> None:
    story = (
        "Mr. Hobbs sat at his bench in the little shop.\n\nHis niece Clara ran down with her little brother Milo. "
        "Clara read the letter, and her uncle turned away."
    )
    reading = read_script(read(story))
    assert [person.id for person in reading.people] == ["mr_hobbs", "clara", "milo"]
    assert any(deed.actor == "mr_hobbs" and deed.motion == "turn" for unit in reading.units for deed in unit.deeds)


def test_single_quotation_marks_are_speech() -> None:
    reading = read_script(
        read("Agnes ran in. ‘Don’t go,’ whispered Percival. 'Why not?' asked Agnes. The dogs' bowls lay there.")
    )
    assert [person.name for person in reading.people][:2] == ["Agnes", "Percival"]
    spoken = [(unit.speaker, unit.text) for unit in reading.units if unit.kind == "dialogue"]
    assert spoken == [("percival", "Don’t go,"), ("agnes", "Why not?")]


def test_food_on_a_plate_is_not_cast() -> None:
    text = "INT. KITCHEN - DAY\n\nTOM cuts a fish. He fries the fish. The fish burns.\n"
    assert [person.id for person in read_script(read(text)).people] == ["tom"]


def test_an_apposition_is_the_same_person() -> None:
    story = "At the door stood Mrs. Crabbe, the old housekeeper. She waited as a child would. The housekeeper left."
    assert ids(story) == ["mrs_crabbe"]
    assert ids("INT. RING - DAY\n\nHer OPPONENT, a YOUNG BOXER, waits. The boxer jumps.\n") == ["opponent"]


def test_what_somebody_does_for_a_living_may_tell_the_gender(read_scene: Read) -> None:
    assert read_scene("XQ (30, waitress, freckles) waits.").people[0].gender == "female"


def test_the_small_woman_is_the_one_introduced_as_small(read_scene: Read) -> None:
    reading = read_scene("ANNA (68, tiny) sits. GRACE (38, tall) kneels. Grace smiles. The small woman nods.")
    assert reading.units[-1].deeds[0].actor == "anna"


def test_a_line_with_a_title_and_a_name_is_for_them() -> None:
    text = "INT. WARD - DAY\n\nMR. HAAS (70) lies on the bed. LENA and PORTER wait.\n\nLENA\nStay, Mr. Haas.\n"
    assert read_script(read(text)).units[-1].to == "mr_haas"


def test_what_stops_is_not_done_and_before_somebody_is_in_front_of_them(read_scene: Read) -> None:
    reading = read_scene("WALT (70) mops the floor. Walt stops mopping. He puts the plate before TOM.")
    assert not [deed for deed in reading.units[1].deeds if deed.motion == "clean"]
    assert [(r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations] == [("plate", "in_front_of", "tom")]


def test_names_in_any_latin_letters_are_whole_and_have_their_gender() -> None:
    action = "ŁUCJA ŻÓŁĆ (34) bows to SATŌ KENJIRŌ (60). ʿABD AL-RAHMAN (50) waves. Łucja gives Satō a letter."
    reading = read_script(read(f"EXT. SOUK - DAY\n\n{action}\n\nALL\nHooray!\n"))
    assert [person.name for person in reading.people] == ["ŁUCJA ŻÓŁĆ", "SATŌ KENJIRŌ", "ʿABD AL-RAHMAN"]
    assert reading.people[0].gender == "female"
    given = [(deed.actor, deed.target, deed.prop) for unit in reading.units for deed in unit.deeds][-1]
    assert given == ("lucja_zolc", "sato_kenjiro", "letter")


def test_what_follows_a_dash_is_no_name() -> None:
    assert ids("— Where are you going? asked Marie.\n\n— Home, said Paul.\n\nShe took his arm.\n") == ["marie", "paul"]


def test_a_calling_no_list_knows_is_met_without_capitals(read_scene: Read) -> None:
    reading = read_scene("A MOVER (30s) backs in. Then the mover sits.")
    assert [deed.motion for deed in reading.units[-1].deeds] == ["sit"]
    assert [thing.id for thing in reading.things] == []


def test_who_has_no_name_is_a_woman_and_a_man(read_scene: Read) -> None:
    reading = read_scene("She leaves. He stays.")
    assert [person.id for person in reading.people] == ["woman", "man"]
    assert reading.units[-1].on_stage == ["man"]


def test_a_captain_is_the_one_of_that_title_and_a_camel_coat_no_camel() -> None:
    reading = read_script(
        read(
            "Hester sat by the fire. Captain Rudd came in. He wore a camel coat.\n\n"
            'Hester looked at the Captain. "Heavy ones," said the Captain.\n\n'
            "Without knocking, a tiny woman opened the door. She sat down.\n"
        )
    )
    assert [person.id for person in reading.people] == ["hester", "captain_rudd", "woman"]


def test_a_robot_lowers_something_else_than_itself_and_animals_come_after_people() -> None:
    reading = read_script(
        read(
            "INT. DOME - DAY\n\nINES (40) sits. MULE, a robot, stands. A DOG sleeps. The dog licks her paw.\n\n"
            "Mule carries in a mattress and lowers it.\n\nInes wipes the dog. She laughs.\n\n"
            "She takes a radio, shakes the ice off it and hurls it away."
        )
    )
    deeds = [(deed.actor, deed.motion, deed.prop) for unit in reading.units for deed in unit.deeds]
    assert ("mule", "put_down", "mattress") in deeds
    assert ("ines", "laugh", None) in deeds
    assert ("ines", "throw", "radio") in deeds
