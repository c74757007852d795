"""The user's library as an asset source: found by words and by meaning, filtered by licence, put into the project."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.crew import no_words

from storyblender.catalog.recipe import AssetQuery
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.library.library_source import LibrarySource
from storyblender.library.shared.entries import ADDED, EntryFacts, LibraryEntry
from storyblender.library.shared.shared_library import INDEX, SharedLibrary
from storyblender.library.sources import asset_sources
from storyblender.memory.asset_sheet import Asset, Credit
from storyblender.memory.jobs import FETCHED
from storyblender.model_content import content_of
from storyblender.service_setting import LicenceFilter
from storyblender.settings import Settings


class Synonyms:
    """Likeness of meaning in which only ``couch`` and ``settee`` are alike; counts what it read."""

    def __init__(self) -> None:
        self.read: list[str] = []

    def embed(self, texts: Sequence[str]) -> NDArray[np.float32]:
        self.read += texts
        same = {"couch": "settee", "red couch": "settee"}
        names = [same.get(text, text) for text in texts]
        vectors = np.zeros((len(texts), 64), np.float32)
        for row, name in enumerate(names):
            vectors[row, hash(name) % 63 if name != "settee" else 63] = 1.0
        return vectors


def query(name: str, origin: str = "script") -> AssetQuery:
    values = dict(asset_id="it", asset_type="object", description="", name=name, origin=origin)
    return AssetQuery(asset=Asset.model_validate(values))


@pytest.fixture
def library(tmp_path: Path) -> SharedLibrary:
    return SharedLibrary.open(tmp_path / "library")


def add(library: SharedLibrary, tmp_path: Path, name: str, licence: str = "CC0-1.0", **facts: object) -> LibraryEntry:
    folder = tmp_path / "fetched" / name
    folder.mkdir(parents=True)
    (folder / "it.glb").write_text(name)
    (folder / "credits.toml").write_text('author = "Ann"')
    known = dict(kind="model", name=name, main="it.glb", source="museum", source_id=name.replace(" ", "_"))
    known["credit"] = Credit(author="Ann", license=licence)
    return library.add(EntryFacts.model_validate(known | facts), folder)


def test_a_model_is_found_by_the_words_of_its_name(library: SharedLibrary, tmp_path: Path) -> None:
    for name in ("Chair 01", "red velvet armchair", "chair lamp", "Office Chair", "couch"):
        add(library, tmp_path, name)
    source = LibrarySource(library, no_words)
    found = source.search(query("red chair"))
    assert {recipe.key for recipe in found} == {"museum/Chair_01/it.glb", "museum/Office_Chair/it.glb"}
    assert all(recipe.score >= 8 for recipe in found)
    assert source.search(query("red velvet armchair"))[0].key == "museum/red_velvet_armchair/it.glb"
    assert source.search(query("samovar")) == source.search(query("椅子")) == []


def test_tags_of_a_service_are_no_names_but_what_a_story_called_it_is(library: SharedLibrary, tmp_path: Path) -> None:
    add(library, tmp_path, "Gothic Cabinet", words=("wood", "vase"))
    source = LibrarySource(library, no_words)
    assert source.search(query("vase")) == []
    add(library, tmp_path, "blue pot", words=("vase",), source=ADDED, source_id="")
    made = add(library, tmp_path, "object 7", words=("orrery",), request="ab", source="meshy")
    assert [recipe.key.split("/")[0] for recipe in source.search(query("vase"))] == ["library"]
    assert [recipe.key for recipe in source.search(query("orrery"))] == [made.key]


def test_what_means_the_same_is_found_and_each_name_is_read_once(library: SharedLibrary, tmp_path: Path) -> None:
    sofa, _ = add(library, tmp_path, "settee"), add(library, tmp_path, "lamp")
    words = Synonyms()
    source = LibrarySource(library, lambda: words)
    assert source.search(query("couch")) == []
    (found,) = [each for each in source.search(query("couch"), by_meaning=True) if each.score > 7]
    assert found.key == sofa.key and found.by_meaning
    again = Synonyms()
    (found,) = [
        each for each in LibrarySource(library, lambda: again).search(query("couch"), by_meaning=True) if each.score > 7
    ]
    assert found.key == sofa.key and "settee" in words.read and not {"settee", "lamp"} & set(again.read)
    add(library, tmp_path, "椅子")
    assert source.search(query("couch"), by_meaning=True)[0].key == sofa.key


def test_only_what_the_script_names_is_looked_for(library: SharedLibrary, tmp_path: Path) -> None:
    add(library, tmp_path, "chair")
    assert not LibrarySource(library, no_words).search(query("chair", "dressing"))


@pytest.mark.parametrize(
    ("wanted", "names"),
    [("any", {"a", "b", "c", "mine"}), ("commercial", {"a", "b", "mine"}), ("free", {"a", "mine"})],
)
def test_the_licence_filter_counts_for_what_is_in_the_library(
    wanted: LicenceFilter, names: set[str], library: SharedLibrary, tmp_path: Path
) -> None:
    for name, licence in (
        ("a", "CC0-1.0"),
        ("b", "CC-BY-4.0"),
        ("c", "CC-BY-NC-4.0"),
        ("d", "CC-BY-ND-4.0"),
        ("e", ""),
    ):
        add(library, tmp_path, f"{name} chair", licence)
    add(library, tmp_path, "mine chair", "", source=ADDED)
    found = LibrarySource(library, no_words, wanted).search(query("chair"))
    assert {recipe.key.split("/")[1].removesuffix("_chair") for recipe in found} == names


def test_a_model_is_put_into_the_project_with_its_credit(library: SharedLibrary, tmp_path: Path) -> None:
    add(library, tmp_path, "arm chair")
    source, files = LibrarySource(library, no_words), Folder(tmp_path / "project")
    recipe = source.fetch(source.search(query("armchair"))[0], files)
    path = files.path(FETCHED, recipe.key)
    assert path.read_text() == "arm chair" and path.with_name("credits.toml").is_file()
    assert recipe.params["content"] == content_of(path, files.path(FETCHED))
    told = recipe.provenance
    assert told is not None and (told.source, told.author, told.license) == ("museum", "Ann", "CC0-1.0")
    before = path.stat()
    source.fetch(recipe, files)
    assert path.stat().st_ino == before.st_ino, "what is there already is not written again"
    path.write_text("changed")
    source.fetch(recipe, files)
    assert path.read_text() == "arm chair"


def test_a_model_whose_files_are_damaged_cannot_be_fetched(library: SharedLibrary, tmp_path: Path) -> None:
    entry = add(library, tmp_path, "arm chair")
    source = LibrarySource(library, no_words)
    library.path_of(entry).write_text("damaged")
    (recipe,) = source.search(query("arm chairs"))
    with pytest.raises(InputError, match="missing or damaged"):
        source.fetch(recipe, Folder(tmp_path / "project"))


def test_a_person_names_a_model_by_key_digest_or_name(library: SharedLibrary, tmp_path: Path) -> None:
    entry = add(library, tmp_path, "Arm Chair")
    mine = add(library, tmp_path, "Throne", source=ADDED, source_id="")
    source = LibrarySource(library, no_words)
    for told in (entry.key, entry.digest, entry.digest[:8], "arm chair"):
        assert (found := source.chosen(told)) is not None and found.key == entry.key
    assert (found := source.chosen(mine.key)) is not None and found.key == mine.key
    assert source.chosen("../../etc/passwd") is source.chosen("") is source.chosen(entry.digest[:4]) is None


def test_a_damaged_library_offers_nothing(library: SharedLibrary) -> None:
    library.files.write(INDEX, b"this is no database" * 300)
    assert not LibrarySource(library, no_words).search(query("chair"))


def test_the_setting_turns_it_off() -> None:
    assert [source.name for source in asset_sources(Settings(), no_words)][:2] == ["models", "library"]
    assert "library" not in [source.name for source in asset_sources(Settings(library=False), no_words)]
