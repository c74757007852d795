"""A catalogue as an asset source: found by name, fetched once, kept in the library and credited."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from threading import Event
from typing import Any

import pytest

from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView
from storyblender.agents.concept_artist.retriever import RulesAssetRetriever
from storyblender.catalog.recipe import Recipe
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.library.catalogue_source import CatalogueSource
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.library.sources import asset_sources, service_run
from storyblender.memory.jobs import FETCHED
from storyblender.model_content import content_of
from storyblender.ports import AssetSource
from storyblender.service_setting import services_in
from storyblender.services.budget import ServiceBudget
from storyblender.services.register import ServiceRun, catalogues
from storyblender.settings import Settings
from tests.crew import no_words
from tests.services.catalogue_sites import Fab, Haven, open_poly_haven, open_sketchfab
from tests.services.site import QUICK, Reply, Site, serving
from tests.services.test_offer_matching import query

CHAIR = Haven("ArmChair_01", "Arm Chair 01")
LAMP = Fab("4737a3b84e00415b9d8bb42ae44285b2", "Brass Lamp", ("by-nc", "CC Attribution-NonCommercial"))


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        open_poly_haven(site, [CHAIR])
        open_sketchfab(site, [LAMP])
        yield site


def opened(
    site: Site, library: Path | None, name: str = "poly_haven", **given: Any
) -> tuple[CatalogueSource, list[str]]:
    run, told = ServiceRun(patience=QUICK, **given), []
    (catalogue,) = catalogues(services_in(f"{name}@{site.address}"), run)
    kept = SharedLibrary.open(library) if library is not None else None
    return CatalogueSource(catalogue, run, no_words, kept, told.append), told


def brought(source: AssetSource, files: Folder, name: str = "armchair") -> Recipe:
    return source.fetch(source.search(query(name))[0], files)


def test_a_thing_is_found_fetched_and_credited(site: Site, tmp_path: Path) -> None:
    source, told = opened(site, tmp_path / "library")
    files = Folder(tmp_path / "p")
    recipe = brought(source, files)
    assert recipe.key == "poly_haven/ArmChair_01-1k/model.gltf" and recipe.source == "file" and not told
    model = files.path(FETCHED, recipe.key)
    assert recipe.params["content"] == content_of(model, files.path(FETCHED))
    assert recipe.provenance is not None
    assert (recipe.provenance.source, recipe.provenance.license) == ("poly_haven", "CC0-1.0")
    assert recipe.provenance.url == "https://polyhaven.com/a/ArmChair_01" and len(recipe.provenance.digest) == 64
    entry = SharedLibrary.open(tmp_path / "library").by_source("poly_haven", "ArmChair_01-1k")
    assert entry is not None and entry.credit.author == "Rico Cilliers, Greg Zaal" and entry.key == recipe.key


def test_what_is_in_the_library_is_not_asked_for_again(site: Site, tmp_path: Path) -> None:
    first = brought(opened(site, tmp_path / "library")[0], Folder(tmp_path / "p"))
    downloads = site.count("/dl/")
    again = brought(opened(site, tmp_path / "library")[0], Folder(tmp_path / "q"))
    assert again == first and site.count("/dl/") == downloads == 3
    assert (tmp_path / "q" / FETCHED / first.key).is_file()


def test_without_a_library_the_project_keeps_it(site: Site, tmp_path: Path) -> None:
    first = brought(opened(site, None)[0], Folder(tmp_path / "p"))
    assert brought(opened(site, None)[0], Folder(tmp_path / "p")) == first
    assert site.count("/dl/") == 3


def test_what_the_project_has_already_goes_into_the_library(site: Site, tmp_path: Path) -> None:
    brought(opened(site, None)[0], Folder(tmp_path / "p"))
    brought(opened(site, tmp_path / "library")[0], Folder(tmp_path / "p"))
    assert site.count("/dl/") == 3
    assert SharedLibrary.open(tmp_path / "library").by_source("poly_haven", "ArmChair_01-1k") is not None


def test_a_service_that_fails_is_said_once_and_offers_nothing(site: Site, tmp_path: Path) -> None:
    site.pages["/assets"] = Reply(status=500)
    source, told = opened(site, tmp_path / "library")
    assert not source.search(query("chair")) and not source.search(query("lamp"))
    assert len(told) == 1 and told[0].startswith("poly_haven: ") and site.count("/assets") == QUICK.tries


def test_a_fetch_that_fails_is_an_input_error_and_leaves_nothing(site: Site, tmp_path: Path) -> None:
    site.pages["/dl/1k/ArmChair_01/scene.bin"] = Reply(status=404)
    source, _ = opened(site, tmp_path / "library")
    with pytest.raises(InputError, match="Arm Chair 01"):
        brought(source, Folder(tmp_path / "p"))
    assert not [path for path in (tmp_path / "p").rglob("*") if path.is_file()]
    assert not (tmp_path / "library").exists()


def test_the_budget_ends_what_is_fetched(site: Site, tmp_path: Path) -> None:
    source, _ = opened(site, tmp_path / "library", budget=ServiceBudget({"megabytes": 0.002}))
    with pytest.raises(InputError, match="limit of"):
        brought(source, Folder(tmp_path / "p"))
    assert not site.count("/dl/")


@pytest.mark.parametrize(("licences", "found"), [("any", 1), ("commercial", 0)])
def test_a_licence_that_is_not_wanted_is_not_offered(site: Site, licences: Any, found: int) -> None:
    source, _ = opened(site, None, "sketchfab", licences=licences)
    assert len(source.search(query("lamp"))) == found


def test_only_words_for_the_thing_are_sent(site: Site) -> None:
    source, _ = opened(site, None, "sketchfab")
    source.search(query("lamp", "Anna's secret old brass lamp"))
    assert [hit.query["q"] for hit in site.hits] == ["lamp"] and not any(hit.body for hit in site.hits)


def test_services_come_after_the_users_folders_and_before_the_built_in_library(site: Site, tmp_path: Path) -> None:
    address = site.address
    settings = Settings(models=(tmp_path,), services=f"sketchfab@{address},poly_haven@{address}")
    names = [source.name for source in asset_sources(settings, no_words, ServiceRun(patience=QUICK))]
    assert names == ["models", "library", "sketchfab", "poly_haven", "built_in"]
    assert [source.name for source in asset_sources(settings, no_words)] == ["models", "library", "built_in"]


def test_a_service_wins_over_the_built_in_library_and_a_folder_over_both(site: Site, tmp_path: Path) -> None:
    settings = Settings(models=(tmp_path,), services=f"poly_haven@{site.address}")
    retriever = RulesAssetRetriever(asset_sources(settings, no_words, ServiceRun(patience=QUICK)))
    view = AssetRetrieverView(asset=query("armchair").asset)
    assert retriever.propose(view).key.startswith("poly_haven/")
    asked = len(site.hits)
    (tmp_path / "armchair.glb").write_bytes(b"x")
    retriever = RulesAssetRetriever(asset_sources(settings, no_words, ServiceRun(patience=QUICK)))
    assert retriever.propose(view).key == "armchair.glb" and len(site.hits) == asked, "nobody is asked in vain"


def test_what_could_not_be_fetched_is_not_offered_again(site: Site) -> None:
    settings = Settings(services=f"poly_haven@{site.address}")
    retriever = RulesAssetRetriever(asset_sources(settings, no_words, ServiceRun(patience=QUICK)))
    first = retriever.propose(AssetRetrieverView(asset=query("armchair").asset))
    other = retriever.propose(AssetRetrieverView(asset=query("armchair").asset, rejected=frozenset((first.key,))))
    assert other.source == "catalog"


def test_a_credit_from_outside_cannot_break_its_file(site: Site, tmp_path: Path) -> None:
    import tomllib

    authors = ('A"\n[x]\nlicense = "MIT', "B\\", "\x7f\x00'''")
    open_poly_haven(site, [Haven("ArmChair_01", "Arm Chair 01", authors=authors)])
    files = Folder(tmp_path / "p")
    recipe = brought(opened(site, None)[0], files)
    told = tomllib.loads(files.path(FETCHED, recipe.key).with_name("credits.toml").read_text(encoding="utf-8"))
    assert told["license"] == "CC0-1.0" and set(told) == {"author", "license", "url"}
    assert json.loads(json.dumps(told))["author"].startswith('A" [x] license = "MIT, B\\')


def test_services_whose_packages_are_missing_are_refused_in_one_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("storyblender.library.sources.find_spec", lambda name: None)
    with pytest.raises(InputError, match=r"extra `services`; pip install"):
        service_run(Settings(services="poly_haven"), Event())
    assert service_run(Settings(), Event()) is None
