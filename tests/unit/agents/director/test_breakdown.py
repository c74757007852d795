"""The whole breakdown: budgets, states, the graph, and the promise that no word of a script is lost."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from xml.sax.saxutils import escape

import pytest
from handmade import Script

from storyblender.agents.director.breakdown import storyboard
from storyblender.agents.director.director import RulesShotDirector, ShotDirectorCritic, ShotDirectorView
from storyblender.agents.director.durations import action_seconds, frame_count, speech_seconds
from storyblender.agents.director.fixtures import FIXTURES
from storyblender.agents.director.reader import read_script
from storyblender.agents.director.reading import CameraNote, Person, Reading, StateChange
from storyblender.agents.director.settings import DirectorSettings
from storyblender.catalog.liquids import LIQUIDS
from storyblender.memory.graph import Storyboard
from storyblender.memory.scene_context import Relation
from storyblender.screenplay.source import load, read

EXAMPLES = sorted((Path(__file__).parents[4] / "examples").glob("*.[ft]*"))
FULL = DirectorSettings(shots_per_scene=None)


def board_of(script: Script, settings: DirectorSettings = FULL) -> Storyboard:
    return storyboard(script.read(), settings)


def covered(board: Storyboard) -> list[tuple[int, int]]:
    return [
        (line.span.start, line.span.end)
        for scene in board.storyboard_outline
        for shot in scene.shots
        for line in shot.lines
    ]


def assert_covers(board: Storyboard, reading: Reading) -> None:
    """Every unit is covered in order, whole or in parts that meet at white space; lines are verbatim."""
    spans = covered(board)
    text = reading.screenplay.text
    assert spans == sorted(spans)
    for unit in reading.units:
        parts = [span for span in spans if unit.start <= span[0] < max(unit.end, unit.start + 1)]
        assert parts[0][0] == unit.start and parts[-1][1] == unit.end
        assert all(not text[a[1] : b[0]].strip() for a, b in pairwise(parts))
    for scene in board.storyboard_outline:
        for line in (line for shot in scene.shots for line in shot.lines):
            assert line.text == text[line.span.start : line.span.end]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
@pytest.mark.parametrize("budget", [None, 5, 1])
def test_the_examples_lose_no_word(path: Path, budget: int | None) -> None:
    reading = read_script(load(path))
    board = storyboard(reading, DirectorSettings(shots_per_scene=budget))
    assert_covers(board, reading)
    assert board == storyboard(reading, DirectorSettings(shots_per_scene=budget))
    known = {asset.asset_id for asset in board.asset_sheet}
    assert len(known) == len(board.asset_sheet)
    for shot in board.shot_details:
        assert {*shot.on_stage, *shot.in_frame, *shot.camera_instruction.focus_on_ids} <= known
        assert set(shot.in_frame) <= set(shot.on_stage)
        assert {state.asset_id for state in shot.states} == set(shot.on_stage)
        assert shot.duration >= frame_count(1.5, 24)
        for action in shot.character_actions:
            assert {action.asset_id, action.prop_id or action.asset_id} <= known
            target = action.target_id or action.asset_id
            assert target in known or target.rsplit("_", 1)[-1] in FIXTURES


def test_a_budget_gives_fewer_and_longer_shots_without_touching_orders() -> None:
    script = Script("Ann", "Bob", things=("letter",))
    for number in range(4):
        script.say("ann" if number % 2 else "bob", "Some words that are said.", "bob" if number % 2 else "ann")
    script.action("Ann reads the letter.", ("ann", "read", "letter", "letter"))
    script.action("Bob waits.", ("bob", "stand"), camera=CameraNote("CLOSE ON", size="CU", subject="Bob"))
    script.action("Ann sits.", ("ann", "sit")).action("Ann stands up.", ("ann", "stand_up"))
    full, tight = board_of(script), board_of(script, DirectorSettings(shots_per_scene=3))
    assert len(tight.shot_details) < len(full.shot_details)
    assert len(tight.shot_details) <= 5
    assert [shot.camera_instruction.size for shot in tight.shot_details if shot.camera_instruction.explicit] == ["CU"]
    assert_covers(tight, script.read())


def test_inserts_go_before_anything_else() -> None:
    script = Script("Ann", things=("letter",)).action("Ann enters.", ("ann", "walk"))
    script.action("Ann reads the letter.", ("ann", "read", "letter", "letter")).action("Ann runs.", ("ann", "run"))
    kinds = [shot.camera_instruction.kind for shot in board_of(script).shot_details]
    assert kinds == ["establishing", "reaction", "insert", "action"]
    fewer = board_of(script, DirectorSettings(shots_per_scene=3)).shot_details
    assert [shot.camera_instruction.kind for shot in fewer] == ["establishing", "action", "action"]
    assert fewer[1].camera_instruction.focus_on_ids == ("ann", "letter")


def test_talk_is_not_joined_beyond_its_limit() -> None:
    script = Script("Ann", "Bob")
    for number in range(40):
        script.say(
            "ann" if number % 2 else "bob",
            "This is one line of about ten words in all.",
            "bob" if number % 2 else "ann",
        )
    settings = DirectorSettings(shots_per_scene=1)
    board = board_of(script, settings)
    assert max(shot.duration for shot in board.shot_details) <= frame_count(settings.longest_talk, settings.fps)
    assert len(board.shot_details) >= 10


def test_states_are_carried_and_start_as_the_scene_finds_them() -> None:
    script = Script("Ann", "Bob", things=("bench", "key"))
    script.action(
        "Ann sits on the bench.", ("ann", "sit", "bench"), posture={"ann": ("sit", "bench")}, entering=["ann"]
    )
    script.action("Ann stands up.", ("ann", "stand_up"), posture={"ann": ("stand", None)})
    script.action("Bob gives Ann the key.", ("bob", "give", "ann", "key"), held={"ann": ["key"]})
    script.action("Ann waves.", ("ann", "wave"), held={"ann": ["key"]})
    board = board_of(script)
    bodies = [{state.asset_id: state for state in shot.states} for shot in board.shot_details]
    assert (bodies[0]["ann"].posture, bodies[0]["ann"].support_id) == ("sit", "bench")
    assert board.shot_details[0].character_actions[0].motion == "idle"
    assert bodies[0]["bob"].held == ("key",) and bodies[-1]["bob"].held == ()
    assert (bodies[-1]["ann"].posture, bodies[-1]["ann"].held) == ("stand", ("key",))


def test_who_is_found_in_a_car_sits_and_who_comes_in_does_not_yet() -> None:
    script = Script("Ann", "Bob").action("Ann looks at the road.", ("ann", "look"))
    script.action("Bob jumps in.", ("bob", "walk"), entering=["bob"])
    script.reading.scenes[0] = replace(script.reading.scenes[0], place="car", place_kind="car")
    script.reading.units[0].on_stage = ["ann"]
    postures = {state.asset_id: state.posture for shot in board_of(script).shot_details for state in shot.states}
    assert postures == {"ann": "sit", "bob": "stand"}


def test_sitting_down_later_is_an_action() -> None:
    script = Script("Ann", things=("bench",)).action("Ann enters.", ("ann", "walk"), entering=["ann"])
    script.action("Ann sits.", ("ann", "sit", "bench"), posture={"ann": ("sit", "bench")})
    first, second = board_of(script).shot_details[0], board_of(script).shot_details[-1]
    assert first.states[0].posture == "stand"
    assert "sit" in [action.motion for action in second.character_actions]


def test_changes_sounds_and_light_reach_the_shot() -> None:
    script = Script("Ann", things=("door", "knife"))
    script.action("Ann draws a knife.", ("ann", "pick_up", "knife", "knife"))
    changes = [StateChange("door", "open"), StateChange("light", "the lamps go out")]
    script.action("The door opens and the lamps go out.", changes=changes, sounds=["thunder"])
    shots = board_of(script).shot_details
    modifications = [m for shot in shots for m in shot.asset_modifications]
    assert [(m.asset_id, m.modification_type, m.state) for m in modifications] == [
        ("knife", "add", ""),
        ("door", "transform", "open"),
    ]
    assert [shot.light_change.lamps for shot in shots if shot.light_change is not None] == ["off"]
    assert "thunder" in [shot.sound_effect for shot in shots]


def test_the_liquid_that_a_thing_is_named_for_is_on_the_sheet() -> None:
    script = Script("Ann", things=("milk", "glass")).action("Ann has a glass and milk.", things=["milk", "glass"])
    liquids = {asset.asset_id: asset.liquid for asset in board_of(script).asset_sheet}
    assert liquids == {"ann": "", "milk": LIQUIDS["milk"], "glass": ""}


def test_a_change_with_no_known_state_is_flagged_and_other_words_are_kept() -> None:
    script = Script("Ann", things=("sign", "door"))
    changes = [StateChange("sign", "reads GO"), StateChange("door", "a little wiser"), StateChange("light", "green")]
    script.action("The sign turns, and the door too.", changes=changes)
    shots = board_of(script).shot_details
    modifications = [m for shot in shots for m in shot.asset_modifications]
    assert [(m.asset_id, m.state, m.writing) for m in modifications] == [("sign", "lettered", "GO")]
    assert [flag.topic for shot in shots for flag in shot.flags] == ["door"]


def test_everybody_in_frame_has_something_to_do() -> None:
    script = Script("Ann", "Bob").say("ann", "I have something to tell you.", "bob", parenthetical="angrily")
    shot = board_of(script).shot_details[-1]
    actions = {action.asset_id: action for action in shot.character_actions}
    assert (actions["ann"].motion, actions["ann"].mood, actions["ann"].line_index) == ("talk", "angry", 0)
    assert (actions["bob"].motion, actions["bob"].target_id) == ("listen", "ann")


def test_people_who_never_appear_stay_off_the_sheet() -> None:
    script = Script("Ann").say("ghost", "I am here, and you cannot see me.", off_screen=True)
    script.reading.people.append(Person("ghost", "GHOST"))
    board = board_of(script)
    assert [asset.asset_id for asset in board.asset_sheet] == ["ann"]
    line = next(line for shot in board.storyboard_outline[0].shots for line in shot.lines)
    assert (line.speaker, line.speaker_name, line.off_screen) == (None, "GHOST", True)


def test_animals_are_objects_unless_they_are_dressed() -> None:
    script = (
        Script("Dog", "Fox").action("The dog runs after the fox.", ("dog", "run", "fox")).say("fox", "Never!", "dog")
    )
    for person in script.reading.people:
        person.kind = "animal"
        person.outfit = ("a red coat",) if person.id == "fox" else ()
    sheet = {asset.asset_id: asset for asset in board_of(script).asset_sheet}
    assert (sheet["dog"].asset_type, sheet["dog"].tags, sheet["dog"].look) == ("object", ("animal",), None)
    assert sheet["fox"].asset_type == "character" and sheet["fox"].look is not None


def test_a_group_is_as_many_bodies() -> None:
    script = Script("Guards", things=("gate",)).action(
        "The guards run.", ("guards", "run", "gate"), held={"guards": ["gate"]}
    )
    script.reading.people[0].kind, script.reading.people[0].count = "group", 3
    board = board_of(script)
    assert [asset.asset_id for asset in board.asset_sheet][:3] == ["guards_1", "guards_2", "guards_3"]
    assert len([a for a in board.shot_details[0].character_actions if a.motion == "run"]) == 3


def test_relations_hold_as_the_scene_opens() -> None:
    script = Script("Ann", things=("cup", "table", "lamp"))
    script.action("A lamp is on the table. Ann puts the cup on it.", ("ann", "put_down", "table", "cup"))
    reading = script.read()
    reading.relations = [
        (0, Relation(asset_id="lamp", kind="on", anchor_asset_id="table")),
        (0, Relation(asset_id="cup", kind="on", anchor_asset_id="table")),
    ]
    setup = storyboard(reading, FULL).scene_details[0].setup
    assert [relation.asset_id for relation in setup.relations] == ["lamp"]
    assert setup.light and setup.kit


def test_durations() -> None:
    assert speech_seconds("Yes.") == 1.5
    assert speech_seconds("a " * 25) == pytest.approx(10.4)
    assert speech_seconds("a " * 25, "beat") == pytest.approx(11.4)
    assert action_seconds("a " * 10) == pytest.approx(2.5)
    assert action_seconds("a " * 100) == 8.0
    assert action_seconds("ANN (40, tall, red hair, blue coat, boots) sits.") == 1.5


def test_shot_notes_reach_the_next_unit_and_the_script_words_stay() -> None:
    script = (
        "INT. BAR - NIGHT\n\nANNA sits at the bar.\n\n[[SHOT: low angle, close-up on Anna]]\n\nANNA\n*Never* again.\n"
    )
    reading = read_script(read(script))
    board = storyboard(reading)
    last = board.shot_details[-1].camera_instruction
    assert (last.explicit, last.angle, last.size) == (True, "low angle", "CU")
    assert re.search(r"never", board.storyboard_outline[0].shots[-1].lines[0].text, re.IGNORECASE)


def test_a_scene_without_words_is_still_one_shot() -> None:
    reading = read_script(read("EXT. ROAD - DAY\n\nINT. BAR - NIGHT\n\nANNA sits at the bar.\n"))
    board = storyboard(reading)
    assert [len(scene.shots) for scene in board.storyboard_outline] == [1, 1]


def test_final_draft_and_fountain_give_the_same_board() -> None:
    fountain = load(next(path for path in EXAMPLES if path.stem == "casablanca"))
    types = {"heading": "Scene Heading", "cue": "Character", "parenthetical": "Parenthetical", "dialogue": "Dialogue"}
    paragraphs = [
        f'<Paragraph Type="{types.get(element.kind, "Action")}"><Text>{escape(words)}</Text></Paragraph>'
        for element in fountain.elements
        if element.kind in types or element.kind == "action"
        for words in [fountain.text[element.start : element.end]]
    ]
    fdx = read(f"<FinalDraft><Content>{''.join(paragraphs)}</Content></FinalDraft>")
    without_notes = fountain.model_copy(update={"elements": tuple(e for e in fountain.elements if e.kind != "note")})
    one, other = storyboard(read_script(fdx)), storyboard(read_script(without_notes))
    assert [shot.camera_instruction for shot in one.shot_details] == [s.camera_instruction for s in other.shot_details]
    assert one.asset_sheet == other.asset_sheet


def test_names_in_any_alphabet_get_ids() -> None:
    script = "INT. BAR - NIGHT\n\nÉLODIE\nBonsoir.\n\nŁUCJA\nDobry wieczór.\n\n李\n晚上好。\n\n王\n你好。\n"
    sheet = storyboard(read_script(read(script))).asset_sheet
    assert [asset.name for asset in sheet] == ["Élodie", "Łucja", "李", "王"]
    assert len({asset.asset_id for asset in sheet}) == 4


def test_what_cannot_be_staged_is_flagged() -> None:
    script = Script("Ann").action("Ann waits.", ("ann", "stand"), camera=CameraNote("INTERCUT WITH", kind="intercut"))
    (flag,) = board_of(script).shot_details[0].flags
    assert (flag.topic, flag.start) == ("camera", 0) and "intercut" in flag.reason


@pytest.mark.parametrize(("size", "shown"), [("MS", {"ann", "bob", "cat"}), ("CU", {"ann", "cat"})])
def test_who_walks_along_is_in_the_picture_unless_it_is_tight(size: str, shown: set[str]) -> None:
    script = Script("Ann", "Bob", "Cat").action("Ann, Bob and Cat wait.", ("ann", "stand"), ("bob", "stand"))
    over = CameraNote("OVER CAT", kind="ots", size=size, who="Cat", subject="Ann")
    script.action("Ann and Bob leave.", ("ann", "walk"), ("bob", "walk"), camera=over)
    last = board_of(script).shot_details[-1]
    assert last.camera_instruction.focus_on_ids == ("ann",)
    assert set(last.in_frame) == shown


def test_an_insert_of_what_somebody_holds_shows_the_holder() -> None:
    held = {"held": {"ann": ["key"]}}
    script = Script("Ann", "Bob", things=("key",)).action("Ann sees Bob.", ("ann", "look", "bob"), **held)
    script.action("CLOSE ON the key.", camera=CameraNote("CLOSE ON", size="CU", subject="key"), **held)
    last = board_of(script).shot_details[-1]
    assert (last.camera_instruction.kind, last.in_frame) == ("insert", ("ann",))


def test_things_keep_their_modifiers_and_parts_of_buildings_are_nobody_s_props(tmp_path):
    script = tmp_path / "tango.fountain"
    script.write_text(
        "INT. BAR - NIGHT\n\nPaper lanterns hang from the beams. ANNA (28) sits at a small round table. She takes a red"
        " book and lowers the shutters. A goat chews hay. She drops it in the tip jar.\n"
    )
    sheet = {asset.asset_id: asset for asset in storyboard(read_script(load(script))).asset_sheet}
    assert not {"beam", "shutter", "shutters"} & set(sheet)
    assert sheet["table"].description == "small round table"
    assert sheet["book"].description == "red book"
    assert sheet["jar"].description == "tip jar"
    assert sheet["paper_lantern"].description == "paper lantern"
    assert sheet["hay"].description == "hay"


@pytest.mark.parametrize(("before", "held"), [("Ann waits.", ("gun",)), ("Ann sees a gun.", ())])
def test_what_somebody_is_found_to_hold_was_in_hand_unless_it_was_seen(before: str, held: tuple[str, ...]) -> None:
    script = Script("Ann", things=("gun",)).action(before, ("ann", "idle"), things=["gun"] if held == () else [])
    script.action("Ann holds up a gun.", ("ann", "hold", "gun", "gun"), things=["gun"])
    assert board_of(script).shot_details[0].states[0].held == held


def test_two_strong_acts_keep_two_pictures_however_small_the_budget() -> None:
    script = """INT. HALL - DAY

ANA hugs BEN. CAL throws his hat into the fire. DEE picks up the ring.
"""
    board = storyboard(read_script(read(script, "fountain")), DirectorSettings(shots_per_scene=1))
    lines = [[line.text for line in shot.lines] for shot in board.storyboard_outline[0].shots]
    assert lines == [["ANA hugs BEN."], ["CAL throws his hat into the fire."], ["DEE picks up the ring."]]


def test_an_animal_that_only_sleeps_is_built_asleep() -> None:
    script = "INT. ROOM - DAY\n\nANA sits at the table. A cat sleeps on the rug.\n\nANA\nQuiet.\n"
    asleep = next(
        asset for asset in storyboard(read_script(read(script, "fountain"))).asset_sheet if "cat" in asset.name
    )
    awake_script = script.replace("sleeps on", "sits on")
    awake = next(a for a in storyboard(read_script(read(awake_script, "fountain"))).asset_sheet if "cat" in a.name)
    assert "sleeping" in asleep.description
    assert "sleeping" not in awake.description


def test_in_a_cabin_passengers_sit_and_those_who_serve_them_stand() -> None:
    script = """INT. AIRPLANE CABIN - NIGHT

The FLIGHT ATTENDANT pours coffee. ANA reads a letter.

ANA
Thank you.
"""
    shots = storyboard(read_script(read(script, "fountain"))).shot_details
    states = next(shot.states for shot in shots if len(shot.on_stage) == 2)
    assert {state.asset_id: state.posture for state in states} == {"flight_attendant": "stand", "ana": "sit"}


def test_the_critic_never_accepts_a_motion_that_does_not_exist() -> None:
    reading = Script("Ana").action("Ana walks.", ("ana", "walk")).read()
    view = ShotDirectorView(reading, DirectorSettings())
    board = RulesShotDirector().propose(view)
    assert ShotDirectorCritic().judge(board, view).score == 10
    *others, shot = board.shot_details
    actions = tuple(action.model_copy(update={"motion": "strolls"}) for action in shot.character_actions)
    changed = shot.model_copy(update={"character_actions": actions})
    draft = board.model_copy(update={"shot_details": (*others, changed)})
    critique = ShotDirectorCritic().judge(draft, view)
    assert [fault.kind for fault in critique.faults] == ["vocabulary"] and critique.score == 1
