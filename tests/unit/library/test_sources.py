"""Asset sources: folders in their order, and one more source that needs no change elsewhere."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest
from tests.crew import no_words
from tests.stand_in_engine import StandInEngine
from tests.unit.models.model_corpus import glb, square

from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView
from storyblender.agents.concept_artist.retriever import RulesAssetRetriever
from storyblender.catalog.recipe import AssetQuery, Recipe
from storyblender.folder import Folder
from storyblender.library import sources
from storyblender.library.model_folders import ModelFolders
from storyblender.library.sources import SOURCES, asset_sources
from storyblender.memory.asset_sheet import Asset, Provenance
from storyblender.memory.jobs import FETCHED
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio

SCRIPT = "INT. KITCHEN - DAY\n\nANNA puts a samovar on the table.\n"


def query(name: str) -> AssetRetrieverView:
    return AssetRetrieverView(asset=Asset(asset_id="it", asset_type="object", description="", name=name))


def write(folder: Path, *names: str, content: bytes = b"a model") -> Path:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    return folder


def test_of_equal_models_that_in_the_earlier_folder_is_taken(tmp_path: Path) -> None:
    first, second = write(tmp_path / "z", "wood/chair.glb"), write(tmp_path / "a", "chair.glb", "red chair.glb")
    for folders, plain in (((first, second), "wood/chair.glb"), ((second, first), "chair.glb")):
        retriever = RulesAssetRetriever(asset_sources(Settings(models=folders), no_words))
        assert retriever.propose(query("chair")).key == plain
        assert retriever.propose(query("red chair")).key == "red chair.glb", "a better match wins from any folder"


def test_a_file_hides_that_of_the_same_name_in_a_later_folder(tmp_path: Path) -> None:
    first, second = write(tmp_path / "a", "chair.glb"), write(tmp_path / "b", "chair.glb", content=b"another")
    source = ModelFolders((first, second), no_words)
    assert [recipe.params for recipe in source.search(query("chair"))] == [
        recipe.params for recipe in ModelFolders((first,), no_words).search(query("chair"))
    ]


def test_a_model_with_other_credits_is_another_model(tmp_path: Path) -> None:
    source = ModelFolders((write(tmp_path, "wood/chair.glb"),), no_words)
    seen = {tuple(source.inventory().values())}
    for name in ("credits.toml", "wood/credits.toml", "wood/chair.credits.toml"):
        (tmp_path / name).write_text('author = "Ann"')
        seen.add(tuple(source.inventory().values()))
    assert len(seen) == 4


class Museum:
    """A service with one model, which it writes where the engine reads."""

    name = "museum"

    def search(self, query: AssetQuery, *, by_meaning: bool = False) -> Sequence[Recipe]:
        provenance = Provenance(source=self.name, file="samovar.glb", url="https://museum.example/7", license="CC0-1.0")
        found = Recipe(source="file", key="museum/samovar.glb", score=9.9, provenance=provenance)
        return [found] if "samovar" in query.phrase else []

    def inventory(self) -> Mapping[str, str]:
        return {}

    def fetch(self, recipe: Recipe, files: Folder) -> Recipe:
        files.write(f"{FETCHED}/{recipe.key}", glb(*square()))
        return recipe


def test_another_source_is_one_entry_of_the_register(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    monkeypatch.setattr(sources, "SOURCES", {"museum": lambda settings, embedder: Museum(), **SOURCES})
    script, project = tmp_path / "a.fountain", tmp_path / "a.storyboard"
    script.write_text(SCRIPT)
    Studio(Settings(width=160, look="fast", animatic=False)).make(script, project)
    (samovar,) = (asset for asset in read_project_graph(project).assets if "samovar" in asset.name)
    assert samovar.canonical is not None and samovar.canonical.provenance is not None
    assert samovar.canonical.provenance.url == "https://museum.example/7"
    assert (project / FETCHED / "museum/samovar.glb").is_file()
    credits_text = (project / "credits.md").read_text()
    assert "samovar" in credits_text and "<https://museum.example/7>" in credits_text
    assert "credits.md" in (project / "index.html").read_text()


def test_a_story_of_the_built_in_library_has_no_credits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    script, project = tmp_path / "a.fountain", tmp_path / "a.storyboard"
    script.write_text(SCRIPT.replace("samovar", "cup"))
    Studio(Settings(width=160, look="fast", animatic=False)).make(script, project)
    assert not (project / "credits.md").exists() and "provenance" not in (project / "graph.json").read_text()
