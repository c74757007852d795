"""The user's library: what it keeps, what it does with damage, and nothing before there is something to keep."""

from __future__ import annotations

import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest

from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.library.shared.entries import EntryFacts
from storyblender.library.shared.place import library_folder
from storyblender.library.shared.shared_library import INDEX, SharedLibrary
from storyblender.memory.asset_sheet import Credit

FACTS = EntryFacts(
    kind="model",
    name="Arm Chair 01",
    words=("armchair", "seat"),
    category="furniture",
    main="scene/chair.gltf",
    credit=Credit(author="Ann", license="CC0-1.0"),
    source="museum",
    source_id="arm_chair_01",
)


def bundle(folder: Path, content: bytes = b"a chair") -> Path:
    (folder / "scene").mkdir(parents=True)
    (folder / "scene/chair.gltf").write_bytes(content)
    (folder / "scene/chair.bin").write_bytes(b"its buffer")
    (folder / "credits.toml").write_text('author = "Ann"')
    return folder


@pytest.fixture
def library(tmp_path: Path) -> SharedLibrary:
    return SharedLibrary.open(tmp_path / "library")


def test_a_bundle_is_kept_found_and_put_into_a_project_whole(library: SharedLibrary, tmp_path: Path) -> None:
    entry = library.add(FACTS, bundle(tmp_path / "fetched"))
    again = SharedLibrary.open(tmp_path / "library")
    assert again.get(entry.digest) == again.by_source("museum", "arm_chair_01") == entry
    assert entry.bytes == len(b"a chairits buffer") + len('author = "Ann"')
    main = again.put_into(entry, Folder(tmp_path / "project"), "build/models/museum/arm_chair_01")
    assert main == "build/models/museum/arm_chair_01/scene/chair.gltf"
    folder = tmp_path / "project/build/models/museum/arm_chair_01"
    assert (folder / "scene/chair.bin").read_bytes() == b"its buffer" and (folder / "credits.toml").is_file()


def test_the_same_files_are_one_entry_and_other_ones_another(library: SharedLibrary, tmp_path: Path) -> None:
    first = library.add(FACTS, bundle(tmp_path / "a"))
    same = library.add(FACTS.model_copy(update={"source_id": "by_another_name"}), bundle(tmp_path / "b"))
    other = library.add(FACTS, bundle(tmp_path / "c", b"another chair"))
    assert same == first != other
    assert library.by_source("museum", "by_another_name") == first
    assert library.by_source("museum", "arm_chair_01") == other, "the newest of one id"
    assert len(library.find()) == 2


def test_what_answers_a_request_is_found_by_it(library: SharedLibrary, tmp_path: Path) -> None:
    entry = library.add(FACTS.model_copy(update={"request": "ab12"}), bundle(tmp_path / "a"))
    assert library.by_request("ab12") == entry and library.by_request("ab13") is None


def test_entries_are_found_by_words_kind_and_source(library: SharedLibrary, tmp_path: Path) -> None:
    chair = library.add(FACTS, bundle(tmp_path / "a"))
    sky = FACTS.model_copy(update={"kind": "panorama", "name": "Evening sky 100%", "words": (), "source": "files"})
    sky = library.add(sky, bundle(tmp_path / "b", b"a sky"))
    assert library.find("CHAIR seat") == [chair] and library.find("ann") == [sky, chair]
    assert library.find(kind="panorama") == library.find(source="files") == library.find("100%") == [sky]
    assert library.find("chair sky_") == []


@pytest.mark.parametrize("damage", ["changed", "cut", "gone", "added", "link"])
def test_damaged_files_are_treated_as_missing_and_mended_by_adding_them_again(
    damage: str, library: SharedLibrary, tmp_path: Path
) -> None:
    entry = library.add(FACTS, bundle(tmp_path / "a"))
    path = library.path_of(entry)
    match damage:
        case "changed":
            path.write_bytes(b"a chaos")
        case "cut":
            path.write_bytes(b"")
        case "gone":
            path.unlink()
        case "added":
            path.with_name("more.bin").write_bytes(b"")
        case _:
            path.unlink()
            path.symlink_to(tmp_path / "a/scene/chair.gltf")
    assert library.get(entry.digest) is None and library.by_source("museum", "arm_chair_01") is None
    with pytest.raises(InputError, match="missing or damaged"):
        library.put_into(entry, Folder(tmp_path / "project"), "build/models/it")
    assert not (tmp_path / "project/build/models/it").exists()
    assert library.add(FACTS, tmp_path / "a") == entry == library.get(entry.digest)


@pytest.mark.parametrize("facts", [b"{}", b"\xff", None, 7, "not json"])
def test_a_damaged_row_is_treated_as_missing_and_mended_by_adding_it_again(
    facts: object, library: SharedLibrary, tmp_path: Path
) -> None:
    entry = library.add(FACTS, bundle(tmp_path / "a"))
    index = library.index()
    assert index is not None
    with index.writing() as db:
        db.execute("UPDATE entries SET facts = ?", ("" if facts is None else facts,))
    assert library.get(entry.digest) is None and library.find() == []
    assert library.add(FACTS, tmp_path / "a") == entry and library.find() == [entry]


def test_a_damaged_index_is_said(library: SharedLibrary, tmp_path: Path) -> None:
    library.files.write(INDEX, b"this is no database" * 300)
    with pytest.raises(InputError, match="index is damaged"):
        library.add(FACTS, bundle(tmp_path / "a"))


def test_an_index_of_a_newer_program_is_left_alone(tmp_path: Path) -> None:
    SharedLibrary.open(tmp_path).index(make=True)
    db = sqlite3.connect(tmp_path / INDEX)
    db.execute("PRAGMA user_version = 99")
    db.close()
    with pytest.raises(InputError, match="newer"):
        SharedLibrary.open(tmp_path).find()


def test_a_bundle_with_a_link_or_without_its_main_file_is_refused(library: SharedLibrary, tmp_path: Path) -> None:
    folder = bundle(tmp_path / "a")
    with pytest.raises(InputError, match=r"has no file 'other\.glb'"):
        library.add(FACTS.model_copy(update={"main": "other.glb"}), folder)
    (folder / "passwords").symlink_to("/etc/passwd")
    with pytest.raises(InputError, match="no links"):
        library.add(FACTS, folder)
    assert library.find() == [] and not list((library.files.root / "incoming").iterdir())


@pytest.mark.parametrize("main", ["../chair.glb", "/etc/passwd", "a\\b.glb", ""])
def test_the_main_file_is_in_the_bundle(main: str) -> None:
    with pytest.raises(ValueError, match=r"bundle|character"):
        EntryFacts(kind="model", name="chair", main=main)


def test_what_is_removed_is_gone(library: SharedLibrary, tmp_path: Path) -> None:
    entry = library.add(FACTS, bundle(tmp_path / "a"))
    library.remove(entry)
    assert library.find() == [] and library.by_source("museum", "arm_chair_01") is None
    assert not library.path_of(entry).exists()


def test_nothing_is_made_and_sqlite_is_not_loaded_before_there_is_something_to_keep(tmp_path: Path) -> None:
    looks = (
        "import sys; from storyblender.library.shared.shared_library import SharedLibrary;"
        "library = SharedLibrary.open();"
        "print(library.find(), library.by_source('a', 'b'), library.by_request('c'), library.get('d'),"
        " library.jobs.unfinished(), 'sqlite3' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", looks], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["[]", "None", "None", "None", "[]", "False"]
    assert not library_folder().exists()


def test_where_it_lies(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("STORYBLENDER_LIBRARY", "/mine")
    assert library_folder() == Path("/mine")
    monkeypatch.delenv("STORYBLENDER_LIBRARY")
    monkeypatch.setenv("XDG_DATA_HOME", "/data")
    assert library_folder() == Path("/data/storyblender/library")
    monkeypatch.delenv("XDG_DATA_HOME")
    assert library_folder() == Path.home() / ".local/share/storyblender/library"
