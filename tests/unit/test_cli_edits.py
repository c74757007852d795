"""The commands that change a project say what they did, in words and as JSON, and refuse in one sentence."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.stage import Stage
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.engine.worker import Worker
from storyblender.memory.shot_context import CameraDecision
from storyblender.project import read_project_graph

SHOT = "SC010_SH010"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(Worker, "start", lambda _: None)
    return Stage(tmp_path / "p", monkeypatch).folder


def said(*words: object, code: int = 0) -> list[dict[str, Any]]:
    done = CliRunner().invoke(app, [*map(str, words), "--json"])
    assert done.exit_code == code, done.output
    return [json.loads(line) for line in done.stdout.splitlines()]


def test_an_edit_is_told_with_its_revision_and_what_is_stale(folder: Path) -> None:
    move = ("--move", "pan left", "--f-number", "2", "--focus", "Anna")
    *_, edited = [line for line in said("edit", folder, SHOT, "--size", "cu".upper(), *move) if "edited" in line]
    assert edited["edited"] == f"{SHOT}: size CU, movement pan, direction left, f number 2, focus Anna"
    assert edited["stale"] == [SHOT] and edited["revision"].partition(".")[0].isdigit()
    decided = CameraDecision(size="CU", movement="pan", direction="left", f_number=2, focus="anna")
    assert read_project_graph(folder).shots[0].camera_decision == decided
    [refused] = said("edit", folder, SHOT, "--size", "WS", "--revision", "1", "--no-render", code=2)
    assert refused["problem"].startswith(f"{SHOT} changed since: user: ")
    said("undo", folder)
    assert read_project_graph(folder).shots[0].camera_decision is None


def test_a_length_and_a_placed_camera_can_be_typed_or_come_as_a_batch(folder: Path) -> None:
    place = ("--at", "2,-3,1.6", "--look-at", "0,0,1.4", "--to", "1,-2,1.6")
    said("edit", folder, SHOT, "--seconds", "2.5", *place, "--no-render")
    typed = read_project_graph(folder).shots[0]
    assert typed.duration == 60 and typed.camera_decision is not None and typed.camera_decision.placed is not None
    said("undo", folder)
    decision = {"placed": typed.camera_decision.placed.model_dump(mode="json")}
    batch = folder.parent / "edits.json"
    edits = [
        {"kind": "camera", "shot": SHOT, "decision": decision}, {"kind": "duration", "shot": SHOT, "frames": 60},
    ]  # fmt: skip
    batch.write_text(json.dumps(edits))
    said("edit", folder, "--batch", batch, "--no-render")
    assert read_project_graph(folder).shots[0] == typed


def test_locks_are_set_seen_and_lifted(folder: Path) -> None:
    *_, locked = said("lock", folder, SHOT, "SC010", "anna")
    assert locked["stale"] == [] and locked["edited"].count("locked") == 3
    graph = read_project_graph(folder)
    assert graph.shots[0].locked and graph.scenes[0].locked and graph.asset("anna").locked
    [refused] = said("edit", folder, SHOT, "--size", "CU", code=2)
    assert refused["error"] == f"the camera of {SHOT} is locked; unlock it first"
    said("unlock", folder, SHOT, "SC010", "anna")
    assert not read_project_graph(folder).shots[0].locked


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["edit", SHOT], "there is nothing to change"),
        (["edit", SHOT, "--size", "HUGE"], "size cannot be 'HUGE'; it is one of: EWS"),
        (["edit", SHOT, "--at", "1,2", "--look-at", "0,0,0"], "'1,2' is no point"),
        (["edit", SHOT, "--at", "1,2,3"], "give --at and --look-at"),
        (["edit", SHOT, "--at", "1,2,3", "--look-at", "1,2,3"], "at least 5 cm away"),
        (["edit", "--batch", "nowhere.json"], "nowhere.json"),
        (["lock", "SC010", "--part", "camera"], "SC010 is a scene and has no camera to lock"),
        (["cast", "peter", "--age", "30"], "there is no person 'peter'; there are: anna"),
        (["cast", "anna", "--front", "sideways"], "--front cannot be 'sideways'; it is front, back, left, right, top"),
        (["asset", "cup", "--top", "up"], "--top cannot be 'up'; it is front, back, left, right, top or bottom"),
        (["lock", "SC010", "--part", "colour"], "should be 'camera', 'blocking'"),
    ],
)
def test_what_cannot_be_is_refused_in_one_sentence(words: list[str], sentence: str, folder: Path) -> None:
    before = read_project_graph(folder)
    command, *rest = words
    [refused] = said(command, folder, *rest, code=2)
    assert sentence in refused["error"] and "\n" not in refused["error"]
    assert read_project_graph(folder) == before


@pytest.mark.parametrize("command", ["edit", "lock", "unlock"])
def test_help_teaches_with_examples(command: str) -> None:
    shown = CliRunner().invoke(app, [command, "--help"], terminal_width=120).stdout
    assert "Examples" in shown and f"storyblender {command} my_film.storyboard" in shown


def test_notes_and_approval_are_typed_and_seen(folder: Path) -> None:
    *_, written = [line for line in said("shot", "note", folder, SHOT, "Too slow.", "--author", "Ilsa", "--no-render")]
    assert written["edited"] == f"{SHOT}: note 1: “Ilsa: Too slow.”" and written["stale"] == []
    said("shot", "note", folder, SHOT, "--resolve", "1", "--no-render")
    [refused] = said("shot", "approve", folder, SHOT, "--no-render", code=2)
    assert f"{SHOT} is not drawn yet" in refused["error"] and f"render DIR --shot {SHOT}" in refused["error"]
    said("render", folder)
    said("shot", "approve", folder, SHOT, "--no-render")
    shot = read_project_graph(folder).shots[0]
    assert shot.approved == () and shot.notes[0].resolved
    [refused] = said("shot", "note", folder, SHOT, "--no-render", code=2)
    assert "takes its text" in refused["error"]
    said("shot", "approve", folder, SHOT, "--withdraw", "--no-render")
    assert read_project_graph(folder).shots[0].approved is None


def test_light_and_set_of_a_scene_are_typed(folder: Path) -> None:
    *_, lit = [line for line in said("light", folder, "SC010", "--hour", "night", "--warmth", "1") if "edited" in line]
    assert lit["edited"] == "SC010: light: time of day night, warmth +1"
    said("set", folder, "SC010", "--snow", "--no-render")
    scene = read_project_graph(folder).scenes[0]
    assert scene.light_decision is not None and scene.light_decision.time_of_day == "night"
    assert scene.set_decision is not None and scene.set_decision.snow
    [refused] = said("light", folder, "SC010", "--weather", "frogs", code=2)
    assert "weather" in refused["problem"]
    [refused] = said("light", folder, "SC010", "--hdri", folder / "no.hdr", code=2)
    assert "no.hdr" in str(refused)


def test_a_program_writes_its_edits_to_standard_input(folder: Path) -> None:
    note = json.dumps([{"kind": "note", "shot": SHOT, "action": "add", "text": "Slower."}])
    done = CliRunner().invoke(app, ["edit", str(folder), "--batch", "-", "--no-render", "--json"], input=note)
    assert done.exit_code == 0, done.output
    assert [each.text for each in read_project_graph(folder).shots[0].notes] == ["Slower."]
    broken = CliRunner().invoke(app, ["edit", str(folder), "--batch", "-", "--json"], input="[{")
    assert broken.exit_code == 2 and "JSON" in json.loads(broken.stdout.splitlines()[-1])["problem"]


def test_shots_are_listed_with_what_a_person_should_know_of_them(folder: Path) -> None:
    said("shot", "note", folder, SHOT, "Slower.", "--no-render")
    said("edit", folder, SHOT, "--size", "CU", "--no-render")
    said("lock", folder, "SC020_SH010", "--part", "camera")
    listed = CliRunner().invoke(app, ["shot", "list", str(folder)])
    first, *_, last = listed.stdout.splitlines()
    assert first.startswith(SHOT) and first.endswith("not drawn, 1 note") and " CU " in first
    assert last.startswith("SC020_SH010") and "locked" in last
    *_, told = said("shot", "list", folder)
    cards = {card["shot"]: card for scene in told["board"]["scenes"] for card in scene["shots"]}
    assert cards[SHOT]["notes"] == 1 and cards["SC020_SH010"]["locked"] and cards[SHOT]["state"] == "none"
    [details] = [shot for shot in told["shots"] if shot["shot"] == SHOT]
    assert details["notes"][0]["text"] == "Slower." and details["size"] == "CU"


def test_the_picture_of_the_film_is_decided_in_one_line(folder: Path) -> None:
    [edited] = [line for line in said("format", folder, "--aspect", "2.39", "--sensor", "super 35") if "edited" in line]
    assert edited["edited"] == "film: aspect 2.39:1, sensor Super 35 (24.89 mm)" and SHOT in edited["stale"]
    assert read_project_graph(folder).format.aspect == 2.39
    [refused] = said("format", folder, code=2)
    assert refused["problem"] == "nothing is decided about the picture"
    said("undo", folder)
    assert read_project_graph(folder).format_decision is None
