"""The record of what the program wrote: cheap to ask, hard to fool, and worth nothing more than a cache."""

from __future__ import annotations

import json
import os
import shutil
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from pathlib import Path

import pytest

from storyblender import outputs as module
from storyblender.folder import Folder
from storyblender.outputs import RECORD, Outputs

NOW = datetime(2026, 11, 22, 14, 5)


@pytest.fixture
def files(tmp_path: Path) -> Folder:
    return Folder(tmp_path / "p")


def test_what_is_as_it_was_is_not_read(files: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    written = Outputs(files)
    written.write("build/a", "content")
    with files.writing_tree("build/tree") as part:
        (part / "one").write_text("1")
    written.note("build/tree")
    monkeypatch.setattr(module, "digest_of", lambda path: pytest.fail(f"{path} was read"))
    again = Outputs(files)
    assert again.whole("build/a") and again.whole("build/tree")


def test_what_was_moved_to_another_place_is_read_once_and_counts(
    files: Folder, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    Outputs(files).write("build/a", "content")
    shutil.copytree(files.root, tmp_path / "copy")
    copy = Folder(tmp_path / "copy")
    assert Outputs(copy).whole("build/a")
    monkeypatch.setattr(module, "digest_of", lambda path: pytest.fail(f"{path} was read again"))
    assert Outputs(copy).whole("build/a")


@pytest.mark.parametrize("name", ["one", "deep/two", "three"])
def test_a_folder_counts_only_with_all_its_files(files: Folder, name: str) -> None:
    written = Outputs(files)
    with files.writing_tree("build/tree") as part:
        (part / "deep").mkdir()
        (part / "one").write_text("1")
        (part / "deep" / "two").write_text("2")
    written.note("build/tree")
    assert written.whole("build/tree")
    path = files.path("build/tree", name)
    path.unlink() if path.exists() else path.write_text("3")
    assert not written.whole("build/tree") and not Outputs(files).whole("build/tree")


def test_what_is_no_file_is_never_whole_and_stops_nobody(files: Folder) -> None:
    written = Outputs(files)
    written.write("build/a", "content")
    files.delete("build/a")
    os.mkfifo(files.root / "build" / "a")
    assert not written.whole("build/a") and not written.changed("build/a")


def test_a_torn_record_costs_its_last_line_only(files: Folder) -> None:
    written = Outputs(files)
    written.write("build/a", "a")
    written.write("build/b", "b")
    record = files.root / RECORD
    record.write_bytes(record.read_bytes()[:-20])
    again = Outputs(files)
    assert again.whole("build/a")
    again.write("build/c", "c")
    assert Outputs(files).whole("build/c") and Outputs(files).whole("build/a")


def test_the_record_does_not_grow_for_ever(files: Folder, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_SPARE", 20)
    for turn in range(30):
        Outputs(files).write("build/a", str(turn))
    assert len((files.root / RECORD).read_text().splitlines()) < 30
    assert Outputs(files).whole("build/a")


@pytest.mark.parametrize("name", ["../mine", "/etc/passwd", "a/../../mine", "a\0b", "", 5, None, "x" * 5000, "\ud800"])
def test_a_record_names_nothing_outside(files: Folder, tmp_path: Path, name: object) -> None:
    (tmp_path / "mine").write_text("mine")
    files.write(RECORD, json.dumps({"name": name, "digest": "", "description": ""}) + "\n[]\nnull\n5\n")
    written = Outputs(files)
    written.keep_only("", ())
    assert (tmp_path / "mine").read_text() == "mine" and not written.known(str(name))


def test_only_what_is_as_it_was_written_is_deleted(files: Folder) -> None:
    written = Outputs(files)
    for name in ("build/kept", "build/gone", "build/changed"):
        written.write(name, name)
    files.path("build/changed").write_text("mine")
    files.path("build/unknown").write_text("mine")
    written.keep_only("build/", ("build/kept",))
    assert sorted(path.name for path in files.path("build").iterdir()) == ["changed", "kept", "unknown"]


def test_copies_aside_never_meet(files: Folder) -> None:
    written = Outputs(files)
    for content in ("one", "two", "three"):
        files.write("story.blend", content)
        assert written.copy_aside("story.blend", NOW) is not None
    assert {path.name: path.read_text() for path in files.root.glob("story *")} == {
        "story 2026-11-22 14.05.blend": "one",
        "story 2026-11-22 14.05 (2).blend": "two",
        "story 2026-11-22 14.05 (3).blend": "three",
    }
    written.write("story.blend", "ours")
    assert written.copy_aside("story.blend", NOW) is None
    files.write("story.blend", b"")
    assert written.copy_aside("story.blend", NOW) is None, "there is nothing in it to lose"


def test_many_write_at_once(files: Folder) -> None:
    written = Outputs(files)
    names = [f"build/{number}" for number in range(100)]
    with ThreadPoolExecutor(8) as threads:
        list(threads.map(lambda name: written.write(name, name), names))
    assert all(map(Outputs(files).whole, names))


def test_what_others_wrote_is_read_once_a_write(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    outputs, read = Outputs(Folder(tmp_path)), list[Path]()
    digest_of = module.digest_of
    outputs.write("story.blend", "ours")
    monkeypatch.setattr(module, "digest_of", lambda path: read.append(path) or digest_of(path))
    for words in ("theirs", "theirs again"):
        (tmp_path / "story.blend").write_text(words)
        read.clear()
        assert all(outputs.changed("story.blend") for _ in range(3))
        assert len(read) == 1
    (tmp_path / "story.blend").write_text("ours")
    assert not outputs.changed("story.blend")
