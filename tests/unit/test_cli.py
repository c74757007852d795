"""The command line answers quickly, because it loads nothing that it does not need."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from storyblender.cli import app

HEAVY = ("numpy", "av", "reportlab", "opentimelineio", "fastmcp", "onnxruntime", "pydantic", "bpy")


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys; from typer.testing import CliRunner; from storyblender.cli import app;"
        "done = CliRunner().invoke(app, ['--help']); assert done.exit_code == 0 and 'undo' in done.stdout;"
        f"print([name for name in {HEAVY!r} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"


class Starter:
    """A worker of which only start and end are of interest."""

    def __init__(self) -> None:
        self.told: list[str] = []

    def start(self) -> None:
        self.told.append("start")

    def close(self) -> None:
        self.told.append("close")


def test_blender_comes_up_first_for_a_project_and_never_outlives_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker = Starter()
    monkeypatch.setattr("storyblender.engine.worker.blender_worker", lambda root, models: worker)
    assert CliRunner().invoke(app, ["check", str(tmp_path)]).exit_code == 2
    assert worker.told == [], "no project, no Blender"
    (tmp_path / "graph.json").write_text("{}")
    assert CliRunner().invoke(app, ["undo", str(tmp_path)]).exit_code == 2
    assert worker.told == [], "taking back draws nothing"
    for mistake in (["--look", "nope"], ["--jobs", "many"], ["--nonsense"]):
        assert CliRunner().invoke(app, ["render", str(tmp_path), *mistake]).exit_code == 2
        assert worker.told == ["start", "close"], mistake
        worker.told.clear()


@pytest.mark.parametrize("words", [["--help"], ["fly", "--json"], ["plan", "nowhere.txt", "--json"]])
def test_a_closed_pipe_is_no_error(words: list[str], tmp_path: Path) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    command = [sys.executable, "-c", "from storyblender.cli import app; app()", *words]
    done = subprocess.run(command, stdout=writing, stderr=subprocess.PIPE, text=True, timeout=60, check=False)
    both = subprocess.run(command, stdout=writing, stderr=writing, timeout=60, check=False)
    os.close(writing)
    assert (done.returncode, done.stderr, both.returncode) == (141, "", 141)


def test_a_stream_that_is_closed_from_the_start_is_no_error() -> None:
    command = f"exec {sys.executable} -c 'from storyblender.cli import app; app()' --version >&-"
    done = subprocess.run(["sh", "-c", command], stderr=subprocess.PIPE, text=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize(
    ("words", "problem", "help_of"),
    [
        (["make"], "missing argument 'SCRIPT'", "storyblender make"),
        (["make", "a.txt", "--nonsense"], "no such option: --nonsense", "storyblender make"),
        (["fly"], "no such command 'fly'", "storyblender"),
        (["export", "p", "--to", "docx"], "invalid value for '--to'", "storyblender export"),
    ],
)
def test_what_is_mistyped_is_one_sentence_and_json_too(words: list[str], problem: str, help_of: str) -> None:
    done = CliRunner().invoke(app, [*words, "--json"], prog_name="storyblender")
    told = json.loads(done.stdout)
    assert done.exit_code == 2 and done.stderr == f"storyblender: {told['error']}\n"
    assert told["problem"].startswith(problem) and told["mend"] == f"see `{help_of} --help`"
    assert told["file"] is told["line"] is None
    assert CliRunner().invoke(app, words).stdout == ""


def test_no_words_at_all_are_answered_with_help() -> None:
    done = CliRunner().invoke(app, [])
    assert done.exit_code == 0 and "Commands" in done.stdout and "make" in done.stdout
