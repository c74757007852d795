"""Whatever goes wrong with what the user gives: one sentence, exit code 2, nothing half-written."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.project import Project

GOOD = "INT. ROOM - DAY\n\nANNA sits.\n"


def run(*arguments: str | Path) -> tuple[int, str]:
    result = CliRunner().invoke(app, [str(argument) for argument in arguments])
    return result.exit_code, result.stderr


@pytest.fixture
def script(tmp_path: Path) -> Path:
    path = tmp_path / "good.fountain"
    path.write_text(GOOD)
    return path


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("missing.fountain", None, "no such script"),
        ("empty.fountain", b"", "empty"),
        ("blank.fountain", b" \n\n \t\n", "nothing to read"),
        ("picture.fountain", b"\x89PNG\r\n\x1a\n\x00\x00\x00", ""),
        ("board.pdf", b"%PDF-1.7\n%\xe2\xe3", "PDF"),
        ("bad.fdx", b"<FinalDraft><Content>", ""),
    ],
)
def test_bad_scripts(tmp_path: Path, name: str, content: bytes | None, words: str) -> None:
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    code, said = run("plan", path, "--out", tmp_path / "out")
    assert code == 2 and words in said and said.count("\n") <= 3
    assert not (tmp_path / "out" / "graph.json").exists() or "outline" not in said


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--aspect", "40"], "aspect"),
        (["--fps", "1"], "fps"),
        (["--crew", "robots"], "crew"),
        (["--shots-per-scene", "0"], "shots_per_scene"),
    ],
)
def test_bad_settings(script: Path, options: list[str], words: str) -> None:
    code, said = run("plan", script, *options)
    assert code == 2 and words in said


def test_a_locked_project_is_left_alone(script: Path, tmp_path: Path) -> None:
    with Project(tmp_path / "p"):
        code, said = run("plan", script, "--out", tmp_path / "p")
    assert code == 2 and "another run" in said


def test_a_folder_of_something_else_is_left_alone(script: Path, tmp_path: Path) -> None:
    (tmp_path / "photos").mkdir()
    (tmp_path / "photos" / "a.jpg").write_bytes(b"x")
    code, said = run("plan", script, "--out", tmp_path / "photos")
    assert code == 2 and "not a project" in said
    assert sorted(item.name for item in (tmp_path / "photos").iterdir() if item.name != ".lock") == ["a.jpg"]


@pytest.mark.parametrize("command", ["check", "render"])
def test_no_project(tmp_path: Path, command: str) -> None:
    code, said = run(command, tmp_path)
    assert code == 2 and "not a StoryBlender project" in said
    assert not list(tmp_path.iterdir())


def test_unknown_shot_and_catalogue(script: Path, tmp_path: Path) -> None:
    assert run("plan", script, "--out", tmp_path / "p")[0] == 0
    code, said = run("render", tmp_path / "p", "--shot", "SC990_SH010")
    assert code == 2 and "SC990_SH010" in said
    code, said = run("render", tmp_path / "p", "--size", "CU")
    assert code == 2 and "needs a shot" in said
    code, said = run("catalog", "dragons")
    assert code == 2 and "dragons" in said


def test_plan_reads_a_script(script: Path, tmp_path: Path) -> None:
    code, said = run("plan", script, "--out", tmp_path / "p")
    assert code == 0, said
    assert (tmp_path / "p" / "graph.json").exists()


def test_a_folder_is_no_script(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    code, said = run("plan", ".")
    assert code == 2 and said.count("\n") <= 3 and "Traceback" not in said


def test_a_plan_is_not_drawn_before_it_is_made(script: Path, tmp_path: Path) -> None:
    project = tmp_path / "planned"
    assert run("plan", script, "--out", project)[0] == 0
    for command in (["render", project, "--shot", "SC010_SH010", "--lens", "85"], ["check", project]):
        code, said = run(*command)
        assert code == 2 and "planned, not made yet" in said
