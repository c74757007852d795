"""What goes where: results to standard output, progress to standard error, JSON alone on its stream."""

from __future__ import annotations

import json
from io import BytesIO, TextIOWrapper
from pathlib import Path

import pytest

from storyblender.errors import InputError, StoryBlenderError
from storyblender.inspection import CheckRow, Inspection
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Commit
from storyblender.memory.outline import SceneOutline, ShotOutline
from storyblender.memory.shot_context import CameraInstruction, ShotContext
from storyblender.terminal import Terminal
from storyblender.terminal_progress import roughly
from storyblender.trace import Event

REPORT = Inspection(rows=(CheckRow(name="SDE", value="0", ok=True),), findings=("a sentence " * 30 + "end",))


def progress(role: str, step: int, total: int) -> Event:
    return Event(kind="stage", role=role, step=step, total=total, subject=f"item {step}")


def test_stages_begin_and_end_on_plain_lines(capsys: pytest.CaptureFixture[str]) -> None:
    with Terminal(quiet=False, json_lines=False) as terminal:
        for event in (progress("materialize", 0, 0), *(progress("frames", step, 3) for step in range(3))):
            terminal.show(event)
        assert capsys.readouterr().err == "Drawing the frames ...\n", "said as it begins, and nothing for no work"
        terminal.show(progress("frames", 3, 3))
        assert capsys.readouterr().err == "Drawing the frames: 3 of 3 (item 3)\n"
    assert capsys.readouterr() == ("", "")


def test_a_stage_that_is_gone_through_again_says_why(capsys: pytest.CaptureFixture[str]) -> None:
    with Terminal(quiet=False, json_lines=False) as terminal:
        for step in range(2):
            again = progress("frames", step, 1).model_copy(update={"message": "Taking 1 frame again", "subject": ""})
            terminal.show(again)
    assert capsys.readouterr().err == "Taking 1 frame again ...\nTaking 1 frame again: 1 of 1\n"


def test_a_warning_begins_with_what_it_is_about(capsys: pytest.CaptureFixture[str]) -> None:
    terminal = Terminal(quiet=False, json_lines=False)
    terminal.show(Event(kind="warning", role="asset_formatter", subject="letter", message="it cannot be read"))
    terminal.show(Event(kind="warning", role="asset_generator", message="there is no key"))
    terminal.show(Event(kind="handover", role="asset_retriever", subject="letter"))
    assert capsys.readouterr().err == "warning letter: it cannot be read\nwarning there is no key\n"


def test_a_log_of_a_feature_says_now_and_then_how_far_it_has_come(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    clock = iter(range(100, 10_000_000, 60))
    monkeypatch.setattr("storyblender.terminal_progress.monotonic", lambda: next(clock))
    with Terminal(quiet=False, json_lines=False) as terminal:
        for step in range(1214):
            terminal.show(progress("frames", step, 1213))
    lines = capsys.readouterr().err.splitlines()
    assert lines[0] == "Drawing the frames ..." and lines[-1] == "Drawing the frames: 1213 of 1213 (item 1213)"
    assert lines[1] == "Drawing the frames: 25 of 1213 (item 25), about 48 minutes left", "a minute for 25 steps"
    assert 40 <= len(lines) <= 52


def test_steps_that_cost_nothing_do_not_shorten_the_estimate(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run that goes on where it was stopped passes over 300 frames at once; the others take ten seconds each."""
    now = 0.0
    monkeypatch.setattr("storyblender.terminal_progress.monotonic", lambda: now)
    with Terminal(quiet=False, json_lines=False) as terminal:
        for step in range(321):
            terminal.show(progress("frames", step, 500))
            now += 0.0 if step < 300 else 10.0
    assert capsys.readouterr().err.splitlines()[-1].endswith("320 of 500 (item 320), about 30 minutes left")


@pytest.mark.parametrize(
    ("seconds", "said"),
    [
        (0.2, "1 second"),
        (40, "40 seconds"),
        (200, "3 minutes"),
        (3700, "1 hour 2 minutes"),
        (12000, "3 hours 20 minutes"),
    ],
)
def test_what_is_left_is_said_as_people_say_it(seconds: float, said: str) -> None:
    assert roughly(seconds) == f"about {said}"


def test_results_are_alone_on_standard_output(capsys: pytest.CaptureFixture[str]) -> None:
    with Terminal(quiet=False, json_lines=False) as terminal:
        terminal.check(REPORT)
        terminal.files(Path("a_long_folder_name" * 20), ["board.pdf"])
        terminal.commits("undone", [Commit(revision=2, author="user", reason="SC010_SH010: size CU", changes=())])
    out, err = capsys.readouterr()
    assert (
        err == "" and "a_long_folder_name" * 20 in out and "board.pdf" in out and "undone SC010_SH010: size CU" in out
    )
    assert "SDE" in out and next(line for line in out.splitlines() if "a sentence" in line).endswith("end")


@pytest.mark.parametrize(("quiet", "json_lines"), [(True, False), (False, True)])
def test_quiet_and_json_show_no_table(capsys: pytest.CaptureFixture[str], quiet: bool, json_lines: bool) -> None:
    with Terminal(quiet=quiet, json_lines=json_lines) as terminal:
        terminal.show(progress("frames", 0, 3))
        terminal.check(REPORT)
    out, err = capsys.readouterr()
    assert err == ""
    results = [json.loads(line) for line in out.splitlines()]
    assert len(results) == (2 if json_lines else 0) and (quiet or results[-1]["rows"][0]["name"] == "SDE")


def test_errors_are_said_even_when_quiet(capsys: pytest.CaptureFixture[str]) -> None:
    Terminal(quiet=True, json_lines=False).error(InputError("no such [b]script[/b] :bomb: \x1b[31m"))
    assert capsys.readouterr().err == "storyblender: no such [b]script[/b] :bomb: \ufffd[31m\n", "as it is written"


def test_a_plan_names_people_as_the_script_does(capsys: pytest.CaptureFixture[str]) -> None:
    ivan = Asset(asset_id="asset_2", name="Иван", asset_type="character", description="A man.")
    shot = ShotContext(scene_id=1, shot_id=1, on_stage=("asset_2",), camera_instruction=CameraInstruction())
    scene = SceneOutline(scene_id=1, scene_description="A station", shots=(ShotOutline(shot_id=1),))
    terminal = Terminal(quiet=False, json_lines=False)
    terminal.plan(ContinuityMemoryGraph(outline=(scene,), assets=(ivan,), shots=(shot,)))
    terminal.plan(ContinuityMemoryGraph())
    out = capsys.readouterr().out
    assert "Cast Иван" in out and "A station  Иван" in out and "asset_2" not in out and "Cast nobody" in out


def test_an_error_is_json_too_where_a_machine_listens(capsys: pytest.CaptureFixture[str]) -> None:
    terminal = Terminal(quiet=False, json_lines=True)
    terminal.error(InputError("cannot be read", mend="mend it", path=Path("a.toml"), line=3))
    terminal.error(StoryBlenderError("Blender was stopped"))
    out, err = capsys.readouterr()
    whole, bare = (json.loads(line) for line in out.splitlines())
    assert whole.pop("error") == "a.toml:3: cannot be read; mend it" and "a.toml:3: cannot" in err
    assert whole == {"problem": "cannot be read", "file": "a.toml", "line": 3, "mend": "mend it"}
    assert bare == {"error": (said := "Blender was stopped"), "problem": said, "file": None, "line": None, "mend": None}


def test_a_terminal_without_the_letters_shows_their_codes(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = TextIOWrapper(BytesIO(), encoding="ascii")
    monkeypatch.setattr("sys.stdout", stream)
    Terminal(quiet=False, json_lines=False).files(Path("雨"), [])
    stream.flush()
    assert b"\\u96e8" in stream.buffer.getvalue()  # type: ignore[attr-defined]
