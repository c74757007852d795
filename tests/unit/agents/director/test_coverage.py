"""Film grammar: each rule of the notes gives the shot it promises."""

from __future__ import annotations

from itertools import pairwise

import pytest
from handmade import Script

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.coverage import Coverage
from storyblender.agents.director.cutting import alternate_speakers, avoid_jump_cuts, size_steps
from storyblender.agents.director.directions import camera_notes_by_unit
from storyblender.agents.director.draft import ShotDraft
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import CameraNote, Reading, SceneReading
from storyblender.screenplay.source import read


def shots(script: Script, *, known: bool = True) -> list[ShotDraft]:
    """Cover a scene; ``known`` places are not established."""
    reading: Reading = script.read()
    scene = reading.scenes[0]
    if known:
        reading.scenes.insert(0, SceneReading(9, "", "ROOM", "", "indoor", "day"))
        scene.reference = 9
    return Coverage(reading).shots(scene, reading.units, camera_notes_by_unit(reading))


def forms(drafts: list[ShotDraft]) -> list[tuple[str, str]]:
    return [(draft.kind, draft.size) for draft in drafts]


def test_a_new_place_is_established_and_a_known_one_is_not() -> None:
    script = Script("Ann").action("Ann sits.", ("ann", "sit"))
    assert forms(shots(script, known=False)) == [("establishing", "WS")]
    assert forms(shots(Script("Ann").action("Ann sits.", ("ann", "sit")))) == [("action", "MWS")]
    outdoors = Script("Ann", scene_type="outdoor").action("Ann sits.", ("ann", "sit"))
    assert forms(shots(outdoors, known=False)) == [("establishing", "EWS")]


def test_a_scene_that_opens_on_a_line_gets_a_wide_without_words() -> None:
    first, second = shots(Script("Ann", "Bob").say("ann", "Well?", "bob"), known=False)
    assert (first.kind, first.beats) == ("establishing", [])
    assert second.kind == "two_shot"


def test_the_whole_body_travels_and_hands_bring_both_faces_and_the_thing() -> None:
    script = Script("Ann", "Bob", things=("key",))
    script.action("Ann runs in.", ("ann", "run")).action("Ann gives Bob the key.", ("ann", "give", "bob", "key"))
    run, give = shots(script)
    assert (run.size, run.movement, run.whole_body) == ("FS", "track", True)
    assert (give.size, give.focus) == ("MS", ["ann", "bob", "key"])


def test_a_look_at_a_thing_is_glance_then_thing() -> None:
    script = Script("Ann", things=("letter",)).action("Ann reads the letter.", ("ann", "read", "letter", "letter"))
    look, insert = shots(script)
    assert (look.kind, look.size, look.focus) == ("reaction", "MCU", ["ann"])
    assert (insert.kind, insert.size, insert.focus, insert.beats) == ("insert", "CU", ["letter"], [])


def test_falls_are_seen_from_above_and_a_gun_from_below() -> None:
    script = Script("Ann").action("Ann falls.", ("ann", "fall")).action("Ann aims.", ("ann", "aim"))
    assert [draft.angle for draft in shots(script)] == ["high angle", "low angle"]


def test_talk_goes_from_two_shot_over_the_shoulder_to_singles_that_tighten() -> None:
    script = Script("Ann", "Bob")
    for number in range(8):
        speaker, other = ("ann", "bob") if number % 2 == 0 else ("bob", "ann")
        script.say(speaker, "These are more than three words.", other)
    drafts = shots(script)
    assert [draft.kind for draft in drafts] == ["two_shot", "ots", "ots", "ots", "single", "single", "single", "single"]
    assert [draft.size for draft in drafts] == ["MS", "MS", "MCU", "MCU", "MCU", "MCU", "CU", "CU"]
    assert {draft.axis for draft in drafts} == {("ann", "bob")}
    assert [draft.over for draft in drafts[1:4]] == ["ann", "bob", "ann"]


def test_a_short_reply_needs_no_cut() -> None:
    (shot,) = shots(Script("Ann", "Bob").say("ann", "Are you coming with us?", "bob").say("bob", "Yes.", "ann"))
    assert [beat.unit.text for beat in shot.beats] == ["Are you coming with us?", "Yes."]


def test_three_talkers_open_on_the_group_but_bystanders_do_not_count() -> None:
    script = Script("Ann", "Bob", "Cid", "Dot")
    script.say("ann", "Listen to me now.", "bob").say("cid", "Why should we listen?", "ann")
    group = shots(script)[0]
    assert (group.kind, group.size) == ("group", "MWS")
    assert "dot" not in group.focus


def test_a_long_speech_is_cut_to_the_listener_at_a_sentence_end() -> None:
    speech = (
        "One two three four five six seven eight nine ten eleven twelve thirteen. " + "And so on it goes for ever. " * 3
    )
    speaker, listener = shots(Script("Ann", "Bob").say("ann", speech.strip(), "bob"))
    text = speech.strip()
    assert (speaker.focus[0], listener.kind, listener.focus) == ("ann", "reaction", ["bob"])
    assert text[: speaker.beats[0].end].endswith(".")
    assert text[listener.beats[0].start :].startswith("And so on")


def test_a_voice_from_outside_holds_the_listener() -> None:
    script = Script("Ann").say("bob", "Open the door this minute!", "ann", off_screen=True)
    (shot,) = shots(script)
    assert (shot.kind, shot.size, shot.focus) == ("reaction", "MCU", ["ann"])


def test_dual_dialogue_is_one_two_shot() -> None:
    script = Script("Ann", "Bob").say("ann", "We are leaving this house.").say("bob", "We are staying here.", dual=True)
    (shot,) = shots(script)
    assert (shot.kind, set(shot.focus), len(shot.beats)) == ("two_shot", {"ann", "bob"}, 2)


def test_directions_are_obeyed() -> None:
    script = Script("Ann", "Bob", things=("key",))
    script.action(
        "she waits.", ("ann", "stand"), camera=CameraNote("LOW ANGLE ON", size="ECU", angle="low angle", subject="ANN")
    )
    script.say("bob", "Mine.", "ann", camera=CameraNote("OVER", kind="ots", who="ANN"))
    script.action("CLOSE ON the key.", camera=CameraNote("CLOSE ON", size="CU", subject="key"))
    script.action("Bob waves.", ("bob", "wave"), camera=CameraNote("POV", kind="pov", who="Ann"))
    low, over, insert, pov = shots(script)
    assert (low.size, low.angle, low.focus, low.has_note) == ("ECU", "low angle", ["ann"], True)
    assert (over.kind, over.over, over.focus) == ("ots", "ann", ["bob"])
    assert (insert.kind, insert.size, insert.focus) == ("insert", "CU", ["key"])
    assert (pov.kind, pov.pov, pov.focus) == ("pov", "ann", ["bob"])


@pytest.mark.parametrize(
    ("subject", "kind", "detail"),
    [("Ann's hand", "insert", "hand"), ("the eyes of Ann", "insert", "eyes"), ("Ann", "single", None)],
)
def test_a_direction_on_a_part_of_somebody_is_an_insert_of_it(subject: str, kind: str, detail: str | None) -> None:
    script = Script("Ann", "Bob")
    script.action("Ann waves.", ("ann", "wave"), camera=CameraNote("CLOSE ON", size="CU", subject=subject))
    (shot,) = shots(script)
    assert (shot.kind, shot.size, shot.focus, shot.detail) == (kind, "CU", ["ann"], detail)


@pytest.mark.parametrize(("second", "count"), [("hit", 2), ("nod", 1)])
def test_two_strong_acts_of_one_paragraph_get_a_picture_each(second: str, count: int) -> None:
    script = Script("Ann", "Bob").action("Both wait.", ("ann", "idle"), ("bob", "idle"))
    script.action("Ann hugs Bob.", ("ann", "hug", "bob"), element=7)
    script.action("Ann goes on.", ("ann", second, "bob"), element=7)
    assert len(shots(script)) == 1 + count


def test_an_establishing_shot_takes_in_no_strong_act() -> None:
    script = Script("Ann", "Bob").action("Both wait.", ("ann", "idle"), element=3)
    script.action("Ann hugs Bob.", ("ann", "hug", "bob"), element=3)
    reading = script.read()
    drafts = Coverage(reading).shots(reading.scenes[0], reading.units, {})
    assert [draft.kind for draft in drafts] == ["establishing", "action"]


def test_an_establishing_shot_of_somebody_is_not_about_the_furniture() -> None:
    script = Script("Ann", things=("piano",)).action("Ann waits.", ("ann", "idle"), element=3)
    script.action("An upright piano.", things=["piano"], element=3)
    reading = script.read()
    reading.things[0].kind = "set_piece"
    (shot,) = Coverage(reading).shots(reading.scenes[0], reading.units, {})
    assert (shot.kind, shot.focus) == ("establishing", ["ann"])


def test_the_same_subject_is_cut_two_sizes_apart_and_orders_stay() -> None:
    script = Script("Ann")
    for _ in range(4):
        script.action("Ann nods at the long grey wall and thinks of summer and home again.", ("ann", "nod"))
    script.action("Ann nods.", ("ann", "nod"), camera=CameraNote("CLOSE ON", size="CU", subject="Ann"))
    drafts = shots(script)
    avoid_jump_cuts(drafts)
    sizes = [draft.size for draft in drafts]
    assert len(drafts) == 5 and sizes[-1] == "CU"
    assert all(abs(size_steps(a, b)) >= 2 for a, b in pairwise(sizes))


def test_joined_talk_turns_from_face_to_face() -> None:
    script = Script("Ann", "Bob").say("ann", "One two three four.", "bob").say("bob", "One two three four five.", "ann")
    script.say("ann", "One two three four five six.", "bob")
    drafts = shots(script)
    for draft in drafts:
        draft.kind, draft.over, draft.focus = "two_shot", None, ["ann", "bob"]
    alternate_speakers(drafts)
    assert [(draft.kind, draft.focus[0]) for draft in drafts] == [("two_shot", "ann"), ("ots", "bob"), ("ots", "ann")]


@pytest.mark.parametrize(
    ("direction", "line", "played"),
    [
        ("CLOSE ON TOM.", "TOM\nI never loved you.", True),
        ("CLOSE ON TOM.", "He cries.", True),
        ("CLOSE ON the ring.", "TOM\nI never loved you.", True),
        ("CLOSE ON the ring.", "Tom picks it up.", True),
        ("CLOSE ON the ring.", "Tom runs to the door.", False),
        ("CLOSE ON TOM.", "Anna runs to the door.", False),
        ("WIDE SHOT.", "Anna runs to the door.", True),
        ("CLOSE ON TOM. He sits.", "Anna runs to the door.", False),
    ],
)
def test_the_line_under_a_direction_plays_in_its_shot(direction: str, line: str, played: bool) -> None:
    opening = "INT. ROOM - DAY\n\nTOM (30) and ANNA (28) sit. A ring lies on the table."
    script = f"{opening}\n\n{direction}\n\n{line}\n\nANNA\nNo.\n"
    outline = storyboard(read_script(read(script))).storyboard_outline[0]
    words = line.rpartition("\n")[2]
    (shot,) = (shot for shot in outline.shots if any(line.text == words for line in shot.lines))
    assert any(line.text.startswith(direction.rstrip(".")[:8]) for line in shot.lines) == played
    assert all(line.text != "No." for line in shot.lines) or not played


def test_only_words_of_the_script_order_a_camera() -> None:
    script = Script("Ann", "Bob")
    script.action("Ann waves.", ("ann", "wave"), camera=CameraNote("CLOSE ON", size="CU", subject="Ann"))
    script.action("Bob waves.", ("bob", "wave"), camera=CameraNote(size="CU", subject="Bob"))
    written, advised = shots(script)
    assert (written.script_directed, advised.script_directed) == (True, False)
    assert written.has_note and advised.has_note, "both are pictures of their own"
