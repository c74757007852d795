"""Whatever goes wrong with what the user gives: one sentence, exit code 2, nothing half-written."""

from __future__ import annotations

import errno
import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.project import Project

GOOD = "INT. ROOM - DAY\n\nANNA sits.\n"
FDX = '<FinalDraft DocumentType="Script"><Content>{}</Content></FinalDraft>'


def run(*arguments: str | Path) -> tuple[int, str]:
    result = CliRunner().invoke(app, [str(argument) for argument in arguments])
    return result.exit_code, result.stderr


def refuses(words: str, *arguments: str | Path) -> None:
    """One sentence with these words, exit code 2, and no trace of what Python calls it."""
    code, said = run(*arguments)
    assert code == 2, said
    assert words in said and said.startswith("storyblender: ") and said.count("\n") == 1, said
    assert "Traceback" not in said and "Error" not in said, said


@pytest.fixture
def script(tmp_path: Path) -> Path:
    path = tmp_path / "good.fountain"
    path.write_text(GOOD)
    return path


@pytest.fixture
def planned(script: Path, tmp_path: Path) -> Path:
    assert run("plan", script, "--out", tmp_path / "planned")[0] == 0
    return tmp_path / "planned"


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("missing.fountain", None, "no such file"),
        ("n" * 300 + ".fountain", None, "too long"),
        ("empty.fountain", b"", "nothing to read"),
        ("blank.fountain", b" \n\n \t\n", "nothing to read"),
        ("picture.fountain", b"\x89PNG\r\n\x1a\n\x00\x00\x00", "picture"),
        ("board.pdf", b"%PDF-1.7\n%\xe2\xe3", "PDF"),
        ("letter.rtf", b"{\\rtf1 INT. ROOM}", "RTF"),
        ("old.doc", b"\xd0\xcf\x11\xe0\xa1\xb1", ".doc"),
        ("new.docx", b"PK\x03\x04....", ".docx"),
        ("story.blend", b"BLENDER-v405", ".blend"),
        ("page.txt", b"<html><body>INT. ROOM</body></html>", "web page"),
        ("data.txt", b'{"scene": "INT. ROOM - DAY"}', "JSON"),
        ("nul.fountain", b"INT. ROOM - DAY\n\nAn\x00na sits.\n", "NUL"),
        ("noise.txt", bytes(range(1, 32)) * 40 + b"\xff\xfe\x81\x9d", ""),
        ("note.fountain", b"INT. ROOM - DAY\n\nANNA sits. [[why\n", "note.fountain:3: a note is opened"),
        ("cut.fountain", b"INT. ROOM - DAY\n\n/* gone\n", "cut.fountain:3: a boneyard is opened"),
        ("notes.fountain", b"[[only a note]]\n", "only notes"),
        ("title.fountain", b"Title: Nothing\nAuthor: Me\n", "title page"),
        ("half.fdx", b"<FinalDraft><Content>", "half.fdx:1: the XML is damaged"),
        ("other.fdx", b"<svg></svg>", "not a Final Draft document"),
        ("none.fdx", FDX.format("").encode(), "no script in it"),
        ("bomb.fdx", b'<!DOCTYPE x [<!ENTITY a "b">]>\n<FinalDraft/>', "refused for safety"),
    ],
)
def test_bad_scripts(tmp_path: Path, name: str, content: bytes | None, words: str) -> None:
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    for command in ("plan", "make"):
        refuses(words, command, path, "--out", tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_huge_file_is_no_script(tmp_path: Path) -> None:
    path = tmp_path / "huge.txt"
    with path.open("wb") as file:
        file.truncate(200_000_000)
    refuses("far more than a script", "plan", path)


def test_a_name_that_is_no_text_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "\udcff.fountain"
    path.write_text(GOOD)
    refuses("rename it", "plan", path)
    assert CliRunner().invoke(app, ["plan", str(path), "--json"]).exit_code == 2
    assert len(list(tmp_path.iterdir())) == 1


@pytest.mark.parametrize("name", [".", "/dev/null"])
def test_not_a_file(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    refuses("this is", "plan", name)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--aspect", "40"], "aspect"),
        (["--aspect", "nan"], "aspect"),
        (["--fps", "1"], "'fps' cannot be 1; it should be greater"),
        (["--crew", "robots"], "crew"),
        (["--shots-per-scene", "0"], "shots_per_scene"),
        (["--seed", "-1"], "seed"),
        (["--look", "oil"], "'board', 'fast', 'pencil' or 'render'"),
        (["--width", "961"], "multiple of 4"),
        (["--jobs", "1000"], "jobs"),
        (["--models", "nowhere"], "nowhere: is not a folder"),
    ],
)
def test_bad_settings(script: Path, tmp_path: Path, options: list[str], words: str) -> None:
    refuses(words, "make", script, "--out", tmp_path / "out", *options)
    assert not (tmp_path / "out").exists()


def test_a_locked_project_is_left_alone(script: Path, tmp_path: Path) -> None:
    with Project(tmp_path / "p"):
        refuses("another run", "plan", script, "--out", tmp_path / "p")


def test_a_folder_of_something_else_is_left_alone(script: Path, tmp_path: Path) -> None:
    (tmp_path / "photos").mkdir()
    (tmp_path / "photos" / "a.jpg").write_bytes(b"x")
    refuses("not a project", "plan", script, "--out", tmp_path / "photos")
    assert [item.name for item in (tmp_path / "photos").iterdir()] == ["a.jpg"]


def test_where_no_folder_can_be_made(script: Path) -> None:
    refuses("give another --out", "plan", script, "--out", script)
    refuses("give another --out", "plan", script, "--out", script / "inside")
    refuses("give another --out", "plan", script, "--out", script.parent / ("n" * 300))


@pytest.mark.parametrize("command", ["check", "render", "undo", "redo"])
def test_no_project(tmp_path: Path, command: str) -> None:
    refuses("not a StoryBlender project", command, tmp_path)
    refuses("not a StoryBlender project", command, tmp_path / "nowhere")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("graph.json", "{", "cannot be read as a project graph"),
        ("graph.json", '{"schema_version": 99}', "newer StoryBlender"),
        ("graph.json", '{"schema_version": 0}', "cannot be read as a project graph"),
        ("history/HEAD", "one", "HEAD: the history is damaged"),
        ("history/HEAD", "7", "HEAD: names change 7, and the last one here is 1"),
        ("history/HEAD", "-2", "the history is damaged"),
        ("settings.json", '{"look": ', "cannot be read as settings"),
        ("settings.json", "[1]", "cannot be read as settings"),
        ("settings.json", '{"look": "oil"}', "settings.json:1: setting 'look' cannot be 'oil'"),
    ],
)
def test_a_damaged_project(planned: Path, name: str, content: str, words: str) -> None:
    (planned / name).write_text(content)
    refuses(words, "check", planned)
    assert (planned / name).read_text() == content


def test_damaged_history(planned: Path) -> None:
    (planned / "history" / "000001.json").write_text("{")
    (planned / "graph.json").unlink()
    refuses("the history is damaged", "plan", planned / "script.fountain", "--out", planned)


def test_unknown_shots_and_catalogues(planned: Path, tmp_path: Path) -> None:
    refuses("there is no shot 'SC990_SH010'", "render", planned, "--shot", "SC990_SH010")
    refuses("there is no shot '../../x'", "render", planned, "--shot", "../../x")
    refuses("nothing to change", "edit", planned, "--size", "CU")
    refuses("dragons", "catalog", "dragons")
    refuses("dragons", "catalog", "--picture", "dragons", "--out", tmp_path / "dragons.png")
    refuses("nothing to undo", "undo", planned)
    refuses("nothing to redo", "redo", planned)
    refuses("no story.blend yet", "export", planned, "--to", "glb")


def test_a_plan_is_not_drawn_before_it_is_made(planned: Path) -> None:
    refuses("planned, not made yet", "render", planned, "--shot", "SC010_SH010")
    refuses("planned, not made yet", "check", planned)


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EROFS, errno.EACCES])
def test_a_disk_that_takes_no_more(number: int, script: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_: int) -> None:
        raise OSError(number, "No room here")

    monkeypatch.setattr(os, "fsync", full)
    code, said = run("plan", script, "--out", tmp_path / "p", "--quiet")
    assert code == 2 and "No room here" in said and said.endswith("then run the same command again to go on\n")
    assert not [path.name for path in (tmp_path / "p").rglob("*") if path.suffix in (".part", ".json")]


def test_too_little_memory_is_one_sentence(script: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_: int) -> None:
        raise MemoryError

    monkeypatch.setattr(os, "fsync", full)
    code, said = run("plan", script, "--out", tmp_path / "p", "--quiet")
    assert code == 2 and said.startswith("storyblender: there is not enough memory; ") and said.count("\n") == 1
    monkeypatch.undo()
    assert run("plan", script, "--out", tmp_path / "p", "--quiet")[0] == 0


def test_errors_reach_a_machine_as_json(tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["plan", str(tmp_path / "none.txt"), "--json"])
    told = json.loads(done.stdout)
    assert "no such file" in told["problem"] and told["file"] == str(tmp_path / "none.txt") and told["mend"]


@pytest.mark.parametrize(
    "write",
    [
        lambda name: f"INT. ROOM - DAY\n\n{name}\nHello.\n\n{name} sits.\n",
        lambda name: f"Title: {name}\n\nINT. {name} - DAY\n\nANNA takes {name}.\n",
    ],
)
@pytest.mark.parametrize(
    "name", ["../../ETC/PASSWD", "A" * 400, "[BOLD]RED[/]", "A\x07B\x1b[31mC", "NUL:", "{0} $X %S"]
)
def test_odd_names_are_read_all_the_same(write: Callable[[str], str], name: str, tmp_path: Path) -> None:
    path = tmp_path / "odd.fountain"
    path.write_text(write(name), encoding="utf-8")
    code, said = run("plan", path, "--out", tmp_path / "p")
    assert code == 0, said
    assert {item.name for item in tmp_path.iterdir()} == {"odd.fountain", "p"}
