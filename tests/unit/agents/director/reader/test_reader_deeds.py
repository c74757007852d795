"""Deeds told in the manners of screenplays: parts of bodies, agents, late names, groups, things worn and made."""

import pytest

from conftest import Read
from storyblender.agents.director.reader import read_script
from storyblender.screenplay.source import read


def told(read_scene: Read, action: str) -> set[tuple[str, str, str | None]]:
    reading = read_scene(f"ANNA (30) and BOB (40) are here.\n\n{action}")
    return {(deed.actor, deed.motion, deed.target) for unit in reading.units for deed in unit.deeds}


def test_what_hands_and_eyes_do_is_done_by_their_owner(read_scene: Read) -> None:
    found = told(read_scene, "Anna's hand finds the lamp. Bob's eyes flick to the door. Anna's eyes are blue.")
    assert {("anna", "touch", "lamp"), ("bob", "look", "door")} == found


def test_what_is_done_by_somebody_is_their_deed(read_scene: Read) -> None:
    assert ("bob", "open", "door") in told(read_scene, "The door is opened by Bob.")


def test_what_somebody_sits_like_is_no_deed(read_scene: Read) -> None:
    assert told(read_scene, "Anna sits hunched on a bench.") == {("anna", "sit", "bench")}


def test_reading_glasses_are_not_read(read_scene: Read) -> None:
    found = told(read_scene, "Behind her Bob, in street clothes and reading glasses, opens the locker.")
    assert found == {("bob", "open", "locker")}


def test_a_hand_flat_against_a_wall_is_a_hand(read_scene: Read) -> None:
    assert not any(motion == "put_down" for _, motion, _ in told(read_scene, "Anna puts her hand flat on the wall."))


def test_who_sits_where_is_told_before_who(read_scene: Read) -> None:
    assert ("bob", "sit", "suitcase") in told(read_scene, "Under the stairs, sitting on a suitcase, is BOB.")


def test_the_two_of_them_are_those_spoken_of_last(read_scene: Read) -> None:
    found = told(read_scene, "Anna hugs Bob. CARL (50) enters. The three of them sit.")
    assert {("anna", "sit", None), ("bob", "sit", None), ("carl", "sit", None)} <= found


def test_his_son_and_a_name_are_one(read_scene: Read) -> None:
    reading = read_scene("EDDIE (30s) enters, followed by his SON, JAKE (6). Jake hides behind Eddie.")
    assert [person.name for person in reading.people] == ["EDDIE", "JAKE"]


def test_a_name_in_s_is_a_name(read_scene: Read) -> None:
    assert [person.name for person in read_scene("On the stairs is DOLORES. She waves.").people] == ["DOLORES"]


def test_nicknames_name_tags_and_grey_suits_are_names(read_scene: Read) -> None:
    reading = read_scene(
        'BEATRIZ "BEA" LUNA (17) and a WAITRESS (40s, name tag that says MARGE) wait. A MAN IN A GREY SUIT enters.\n\n'
        "BEA\nHi.\n\nMARGE\nHon?\n\nGREY SUIT\nEvening."
    )
    assert [person.name for person in reading.people] == ["BEATRIZ LUNA", "WAITRESS", "MAN IN A GREY SUIT"]


def test_the_mother_is_the_woman_without_a_name(read_scene: Read) -> None:
    found = told(read_scene, "A WOMAN (40s) screams. Anna takes off her cap. The mother sits down on the floor.")
    assert any(actor == "woman" and motion == "sit" for actor, motion, _ in found)


def test_who_sings_does_not_talk(read_scene: Read) -> None:
    reading = read_scene("GUS (35) strolls out.\n\nGUS\n~My baby left on the nine-fifteen\n\nGUS\n(singing)\nAlone.")
    assert [deed.motion for unit in reading.units for deed in unit.deeds] == ["walk", "sing", "sing"]


def test_a_forehead_on_the_glass_touches_it(read_scene: Read) -> None:
    assert ("anna", "touch", "window") in told(read_scene, "Anna presses her forehead to the window.")


def test_full_stops_and_clocks_in_headings() -> None:
    reading = read_script(
        read(
            "INT. ASHDOWN PARK, BALLROOM. NIGHT. 1811.\n\nANNA sits.\n\nINT. ST. BRIGID'S - WARD - 4:10 A.M.\n\n"
            "She stands.\n\nINT. DINER - 3 P.M. - ESTABLISHING\n\nAnna waits.\n"
        )
    )
    assert [(scene.place, scene.time) for scene in reading.scenes] == [
        ("ashdown park, ballroom", "night"),
        ("st. brigid's ward", "night"),
        ("diner", "afternoon"),
    ]


def test_hands_and_knees_are_not_kneeing(read_scene: Read) -> None:
    assert told(read_scene, "Anna was on her hands and knees.") == set()


def test_short_forms_of_is(read_scene: Read) -> None:
    reading = read_scene("ANNA (30) is here. She's in the booth. Anna's on the stairs, she's smoking a cigar.")
    assert ("anna", "sit") in {(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds}
    assert ("anna", "smoke") in {(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds}


def test_slumped_is_how_somebody_sits(read_scene: Read) -> None:
    assert ("bob", "sit") in {deed[:2] for deed in told(read_scene, "Bob is slumped at the bar.")}


def test_people_in_smocks_run(read_scene: Read) -> None:
    reading = read_scene("SOLDIERS in white smocks run past the wall.")
    assert [(deed.actor, deed.motion) for unit in reading.units for deed in unit.deeds] == [("soldier", "run")]


def test_a_maids_uniform_is_worn_by_a_woman(read_scene: Read) -> None:
    found = told(read_scene, "A WOMAN in a hotel maid's uniform (40s) is screaming at Bob.")
    assert ("woman", "shout", "bob") in found


def test_who_eats_on_a_ladder_is_on_it(read_scene: Read) -> None:
    reading = read_scene("ANNA (30) eats a sandwich on a ladder.")
    assert [(r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations] == [("anna", "on", "ladder")]


def test_a_microphone_is_no_phone(read_scene: Read) -> None:
    reading = read_scene("ANNA (30) waits.\n\nANNA\n(tapping a microphone)\nIs this on?")
    assert reading.units[-1].deeds[-1].motion == "talk"


def related(read_scene: Read, action: str) -> set[tuple[str, str, str]]:
    reading = read_scene(f"ANNA (30) and BOB (40) are here.\n\n{action}")
    return {(r.asset_id, r.kind, r.anchor_asset_id) for _, r in reading.relations}


def test_what_is_put_on_somebodys_coat_is_on_them(read_scene: Read) -> None:
    assert ("badge", "on", "bob") in related(read_scene, "Anna pins the badge on Bob's coat.")


def test_who_shouts_at_somebody_is_not_placed_at_them(read_scene: Read) -> None:
    assert (
        related(read_scene, "Anna, standing, screams at Bob. In the mirror stands Bob. Bob is across the table.")
        == set()
    )


def test_who_works_at_a_knot_is_nowhere(read_scene: Read) -> None:
    assert related(read_scene, "Anna works at the knot. Bob works at the desk.") == {("bob", "at", "desk")}


def test_a_hot_dog_is_food(read_scene: Read) -> None:
    assert ("bob", "eat") in {deed[:2] for deed in told(read_scene, "Bob bites into a hot dog. The hot dog is cold.")}


def test_common_turns_of_phrase(read_scene: Read) -> None:
    people = "JOE (40, a man) sits on a chair. KATE (35, a woman) stands.\n\n"
    for action, motion in (
        ("Joe hauls himself out of the chair.", "stand_up"),
        ("Kate comes around the table.", "walk"),
        ("Kate starts towards the kitchen.", "walk"),
        ("Kate looks at the letter for a long time.", "look"),
        ("Kate pages through the book.", "read"),
        ("Kate retakes her seat.", "sit"),
        ("Kate reaches for the next book.", "take"),
    ):
        assert [deed.motion for deed in read_scene(people + action).units[-1].deeds] == [motion], action


SAYINGS = [
    ("Anna pulls out a tray.", "take"),
    ("Anna pulls out a chair.", "pull"),
    ("Anna thrusts the box at Bob.", "give"),
    ("Anna hammers away at a typewriter.", "type"),
    ("Anna makes for the stairs.", "walk"),
    ("Anna breaks into a run.", "run"),
    ("Anna shakes the box.", "shake"),
    ("Anna shakes her head.", "shake_head"),
    ("Anna folds the map.", "fold"),
    ("Anna heaves the sack onto the table.", "put_down"),
    ("Anna raises the ledger above her head.", "hold"),
    ("Anna gives the box a shove.", "push"),
    ("Anna draws the blanket up.", "pull"),
    ("Anna draws a map.", "write"),
    ("Anna is on her knees.", "kneel"),
    ("Anna lets go of the rope.", "drop"),
    ("Anna pulls herself to her feet.", "stand_up"),
    ("Anna locks the door behind her.", "close"),
    ("Anna slides down the wall.", "sit"),
    ("Anna hammers on the door with her fists.", "knock"),
    ("Anna flips through a magazine.", "read"),
    ("Anna peels tomatoes.", "cut"),
    ("Anna drags herself to the door.", "crawl"),
    ("Anna plants a kiss on his cheek.", "kiss"),
]


@pytest.mark.parametrize(("action", "motion"), SAYINGS)
def test_a_verb_means_what_its_object_and_preposition_make_of_it(read_scene: Read, action: str, motion: str) -> None:
    assert {(actor, found) for actor, found, _ in told(read_scene, action)} == {("anna", motion)}


def test_what_is_gripped_in_passing_is_held(read_scene: Read) -> None:
    found = told(read_scene, "Anna climbs the stairs, a flashlight gripped between her teeth.")
    assert found == {("anna", "climb", "stairs"), ("anna", "hold", "flashlight")}


@pytest.mark.parametrize(
    ("parenthetical", "text", "motion"),
    [
        ("quietly", "Sit down.", "talk"),
        ("muttering", "That was my queen.", "talk"),
        ("hissing", "Sit down.", "whisper"),
        ("under his breath", "Sit down.", "whisper"),
        ("to Mia", "They started it! I was only standing there. Ask anybody you like.", "talk"),
        ("to Mia", "Stop it! Stop it!", "shout"),
    ],
)
def test_only_what_is_said_without_voice_is_whispered(parenthetical: str, text: str, motion: str) -> None:
    told = f"INT. ROOM - DAY\n\nTOM and MIA sit.\n\nTOM\n({parenthetical})\n{text}\n"
    assert [unit.deeds[0].motion for unit in read_script(read(told)).units if unit.kind == "dialogue"] == [motion]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("“Three hours,” the man told Matthis.", "matthis"),
        ("“Where would you have it?” Lene asked Matthis.", "matthis"),
        ("“Come up,” said Lene to Rourke.", "rourke"),
    ],
)
def test_prose_says_whom_a_speech_is_for(text: str, told: str) -> None:
    story = "Matthis, Rourke, Lene and an old man sat in the kitchen with a dog.\n\nThe dog barked at Lene.\n\n"
    speeches = [unit for unit in read_script(read(story + text + "\n")).units if unit.kind == "dialogue"]
    assert [unit.to for unit in speeches] == [told]


def test_who_is_called_by_name_need_not_be_there() -> None:
    told = "INT. ROOM - DAY\n\nMIA waves.\n\nEXT. YARD - DAY\n\nTOM knocks. BEN waits.\n\nTOM\nMia! Open up!\n"
    unit = read_script(read(told)).units[-1]
    assert (unit.deeds[0].target, unit.to) == ("mia", None)
