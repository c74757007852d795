"""Stories share a library: what one built the next one takes, and the figures count only what was truly avoided."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from tests.stand_in_engine import StandInEngine
from tests.unit.models.model_corpus import glb, square

from storyblender import studio
from storyblender.edits.words import edits_of
from storyblender.library.shared.entries import EntryFacts, LibraryEntry
from storyblender.library.shared.place import library_folder
from storyblender.library.shared.shared_library import INDEX, SharedLibrary
from storyblender.memory.jobs import ASSETS, FETCHED
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event

SCRIPT = "INT. KITCHEN - DAY\n\nANNA puts a red cup on the table.\n"


class CountingEngine(StandInEngine):
    """Keeps the ids of what it was asked to build."""

    built: list[str] = []

    def build_asset(self, job):  # type: ignore[no-untyped-def]
        self.built.append(job.asset.asset_id)
        return super().build_asset(job)


@pytest.fixture(autouse=True)
def _without_blender(monkeypatch: pytest.MonkeyPatch) -> None:
    CountingEngine.built = []
    monkeypatch.setattr(studio, "BlenderEngine", CountingEngine)
    monkeypatch.setattr("storyblender.library.shared.built_geometry.body_pack", lambda: "the pack")


def made(
    tmp_path: Path, name: str, library: bool = True, script: str = SCRIPT, told: list[Event] | None = None
) -> Path:
    (tmp_path / f"{name}.fountain").write_text(script)
    settings = Settings(width=160, look="fast", animatic=False, library=library)
    listener = told.append if told is not None else lambda _: None
    Studio(settings, listener).make(tmp_path / f"{name}.fountain", tmp_path / f"{name}.storyboard")
    return tmp_path / f"{name}.storyboard"


def test_the_second_story_builds_nothing_that_the_first_one_built(tmp_path: Path) -> None:
    first = made(tmp_path, "first")
    asked = {asset.asset_id for asset in read_project_graph(first).assets}
    assert {*CountingEngine.built} >= asked
    CountingEngine.built = []
    second = made(tmp_path, "second")
    assert CountingEngine.built == []
    assert read_project_graph(second).assets == read_project_graph(first).assets
    for path in (first / ASSETS).iterdir():
        assert (second / ASSETS / path.name).read_bytes() == path.read_bytes()
    figures = SharedLibrary.open().uses.figures()
    assert (figures.stories, figures.requests, figures.avoided) == (2, 2 * len(asked), len(asked))
    assert figures.reduction == 50 and figures.unique == len(asked) and figures.references >= 2
    assert figures.categories["characters"] == 1


def test_a_story_that_is_made_again_counts_once(tmp_path: Path) -> None:
    project = made(tmp_path, "first")
    before = SharedLibrary.open().uses.figures()
    shutil.rmtree(project / ASSETS)
    made(tmp_path, "first")
    shutil.rmtree(project)
    made(tmp_path, "first")
    assert SharedLibrary.open().uses.figures() == before and before.avoided == 0


def test_what_the_library_lost_is_built_and_counted_as_built(tmp_path: Path) -> None:
    made(tmp_path, "first")
    shutil.rmtree(library_folder() / "geometry")
    CountingEngine.built = []
    made(tmp_path, "second")
    assert CountingEngine.built and SharedLibrary.open().uses.figures().avoided == 0


def test_without_the_library_nothing_is_taken_or_given(tmp_path: Path) -> None:
    made(tmp_path, "first", library=False)
    assert not library_folder().exists()
    made(tmp_path, "second")
    CountingEngine.built = []
    made(tmp_path, "third", library=False)
    assert CountingEngine.built and SharedLibrary.open().uses.figures().stories == 1


def add(tmp_path: Path, name: str, **facts: str) -> LibraryEntry:
    folder = tmp_path / name
    folder.mkdir()
    (folder / "it.glb").write_bytes(glb(*square()))
    (folder / "credits.toml").write_text(f'author = "Ann, {name}"')
    values = {"kind": "model", "name": name, "main": "it.glb", "source": "museum", "source_id": f"{name}-1k"}
    values |= {"credit": {"author": "Ann", "license": "CC0-1.0"}, "category": "hand"}
    return SharedLibrary.open().add(EntryFacts.model_validate(values | facts), folder)


def test_a_model_of_the_library_stands_for_what_a_story_names_and_counts_as_no_download(tmp_path: Path) -> None:
    cup = add(tmp_path, "red cup")
    project = made(tmp_path, "first")
    (it,) = (asset for asset in read_project_graph(project).assets if asset.name == "cup" and asset.origin == "script")
    assert it.canonical is not None and it.canonical.key == cup.key and it.canonical.provenance is not None
    assert (it.canonical.provenance.source, it.canonical.provenance.author) == ("museum", "Ann")
    assert "Ann" in (project / "credits.md").read_text()
    library = SharedLibrary.open()
    assert library.uses.figures().downloads_avoided == library.uses.figures().avoided == 1
    assert library.uses.of_entry(cup.digest) == [(str(project), "cup")]


def test_files_of_a_fetched_model_that_are_gone_are_put_back_before_it_is_built_again(tmp_path: Path) -> None:
    cup = add(tmp_path, "red cup")
    project = made(tmp_path, "first")
    before = read_project_graph(project).assets
    shutil.rmtree(project / FETCHED)
    shutil.rmtree(project / ASSETS)
    shutil.rmtree(library_folder() / "geometry")
    CountingEngine.built = []
    Studio(Settings(width=160, look="fast", animatic=False)).render(project)
    assert (project / FETCHED / cup.key).is_file() and CountingEngine.built
    assert read_project_graph(project).assets == before


def test_a_person_has_a_thing_made_from_an_entry_by_name(tmp_path: Path) -> None:
    project = made(tmp_path, "first")
    throne = add(tmp_path, "Old Throne")
    edit = edits_of([{"kind": "asset", "thing": "cup", "action": "replace", "file": "old throne"}])
    Studio(Settings(width=160, look="fast", animatic=False)).edit(project, edit)
    (it,) = (asset for asset in read_project_graph(project).assets if asset.name == "cup" and asset.origin == "script")
    assert it.canonical is not None and it.canonical.key == throne.key
    assert (project / FETCHED / throne.key).is_file()


def test_a_damaged_library_does_not_stop_a_story(tmp_path: Path) -> None:
    library_folder().mkdir(parents=True)
    (library_folder() / INDEX).write_bytes(b"this is no database" * 300)
    told: list[Event] = []
    project = made(tmp_path, "first", told=told)
    assert (project / "index.html").is_file()
    assert [event.message for event in told if event.kind == "warning" and "goes on without it" in event.message]
