"""The guarded folder: nothing outside is touched, and files appear whole or not at all."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from storyblender.errors import InputError
from storyblender.folder import Folder

WAYS: dict[str, Callable[[Folder, str], object]] = {
    "write": lambda folder, name: folder.write(name, "new"),
    "writing": lambda folder, name: fill(folder, name),
    "writing_tree": lambda folder, name: fill_tree(folder, name),
    "append": lambda folder, name: folder.append(name, "new"),
    "empty": lambda folder, name: folder.empty(name),
    "delete": lambda folder, name: folder.delete(name),
    "make_folder": lambda folder, name: folder.make_folder(name),
}


def fill(folder: Folder, name: str, content: str = "new") -> None:
    with folder.writing(name) as part:
        part.write_text(content)


def fill_tree(folder: Folder, name: str) -> None:
    with folder.writing_tree(name) as room:
        (room / "one").write_text("1")


def listing(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*"))


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", ["../out", "/etc/out", "a/../../out", "", "a\0b"])
def test_no_name_leaves_the_folder(tmp_path: Path, way: str, name: str) -> None:
    root = tmp_path / "project"
    root.mkdir()
    with pytest.raises(InputError, match="leaves the project folder"):
        WAYS[way](Folder(root), name)
    assert listing(tmp_path) == ["project"]


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("target", ["file", "folder", "nothing"])
@pytest.mark.parametrize("link", ["a", "a/b", "a/b/c"])
def test_no_link_is_followed(tmp_path: Path, way: str, target: str, link: str) -> None:
    outside = tmp_path / "outside"
    (outside / "b" / "c").mkdir(parents=True)
    (outside / "file").write_text("mine")
    before = listing(outside)
    root = tmp_path / "project"
    (root / link).parent.mkdir(parents=True)
    (root / link).symlink_to({"file": outside / "file", "folder": outside, "nothing": outside / "no"}[target])
    with pytest.raises(InputError, match=r"is a link.*real file or folder") as refusal:
        WAYS[way](Folder(root), "a/b/c")
    assert refusal.value.path == root / link
    assert listing(outside) == before and (outside / "file").read_text() == "mine"


def test_a_tree_is_deleted_and_links_in_it_are_not_followed(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "file").write_text("mine")
    root = tmp_path / "project"
    (root / "tree" / "deep").mkdir(parents=True)
    (root / "tree" / "deep" / "link").symlink_to(tmp_path / "mine")
    Folder(root).delete("tree")
    assert listing(tmp_path) == ["mine", "mine/file", "project"]
    Folder(root).delete("tree")


def test_what_has_a_second_name_elsewhere_is_not_changed_there(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("mine")
    root = tmp_path / "project"
    root.mkdir()
    (root / "log").hardlink_to(tmp_path / "mine")
    Folder(root).append("log", " and more")
    assert (root / "log").read_text() == "mine and more"
    Folder(root).empty("log")
    assert (root / "log").read_text() == "" and (tmp_path / "mine").read_text() == "mine"


def test_a_pipe_in_place_of_a_log_stops_nobody(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "log")
    with pytest.raises(InputError, match=r"cannot be written|is not a file"):
        Folder(tmp_path).append("log", "x")


def test_files_appear_whole_and_leave_nothing_else(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    folder.write("a/text", "é")
    fill(folder, "a/library.blend")
    fill_tree(folder, "a/tree")
    fill_tree(folder, "a/tree")
    folder.append("a/text", "e")
    assert listing(tmp_path) == ["a", "a/library.blend", "a/text", "a/tree", "a/tree/one"]
    assert (tmp_path / "a" / "text").read_text(encoding="utf-8") == "ée"


def test_what_fails_leaves_what_was_there(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    fill_tree(folder, "tree")
    folder.write("file", "old")
    with pytest.raises(ZeroDivisionError), folder.writing_tree("tree") as room:
        (room / "two").write_text(str(1 // 0))
    with pytest.raises(ZeroDivisionError), folder.writing("file") as part:
        part.write_text("half")
        raise ZeroDivisionError
    with pytest.raises(TypeError):
        folder.write("file", 5)  # type: ignore[arg-type]
    assert listing(tmp_path) == ["file", "tree", "tree/one"] and (tmp_path / "file").read_text() == "old"


@pytest.mark.parametrize(
    ("way", "call"),
    [("append", "mkdir"), *((way, call) for way in WAYS if way.startswith("writ") for call in ("fsync", "replace"))],
)
def test_a_full_disk_is_one_sentence_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, way: str, call: str
) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, call, full)
    with pytest.raises(InputError, match=r"a/file: cannot be written \(No space left.*free some room"):
        WAYS[way](Folder(tmp_path), "a/file")
    assert not [name for name in listing(tmp_path) if name != "a"]


@pytest.mark.parametrize("kind", [RuntimeError, OSError])
def test_a_library_that_fails_for_want_of_room_is_told_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: type[Exception]
) -> None:
    usage = type("Usage", (), {"free": 1000})
    monkeypatch.setattr("shutil.disk_usage", lambda _: usage)
    with pytest.raises(InputError, match=r"a.blend: cannot be written \("), Folder(tmp_path).writing("a.blend"):
        raise kind("Error: cannot write")


def test_another_fault_of_a_library_stays_what_it_is(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError), Folder(tmp_path).writing("a.png"):
        (tmp_path / "source").read_bytes()


def test_build_may_lie_elsewhere(tmp_path: Path) -> None:
    folder = Folder(tmp_path / "project", tmp_path / "disk")
    path = folder.write("build/frames/a.png", "x")
    assert path == (tmp_path / "disk" / "frames" / "a.png").resolve() and folder.name_of(path) == "build/frames/a.png"
    assert folder.name_of(folder.write("frames/a.png", "x")) == "frames/a.png"
    (tmp_path / "disk" / "motion").symlink_to(tmp_path)
    with pytest.raises(InputError, match="is a link"):
        folder.write("build/motion/x", "")
    folder.delete("build/frames")
    assert listing(tmp_path / "disk") == ["motion"]


def test_left_part_files_are_cleared(tmp_path: Path) -> None:
    folder = Folder(tmp_path)
    folder.write("a/.mine", "mine")
    folder.write("a/.film.part", "mine")
    for name in (".b.1-1.part", "a/.c.1-2.part", "build/motion/.e.1-4.part"):
        folder.write(name, "left")
    (tmp_path / "a" / ".d.1-3.part").mkdir()
    (tmp_path / "b").symlink_to(tmp_path / "a")
    folder.clear_parts()
    assert listing(tmp_path) == ["a", "a/.film.part", "a/.mine", "b", "build", "build/motion"]
