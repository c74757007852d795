"""What the things of a planned story would be made from, and what that takes: nothing is fetched, made or built."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from storyblender.agents.concept_artist.asset_retriever_view import RETRIEVAL_THRESHOLD, nothing_drawn
from storyblender.catalog.meanings import WORDS_BY_AGE
from storyblender.catalog.props import PROPS
from storyblender.catalog.recipe import Recipe
from storyblender.errors import ServiceFailure
from storyblender.library.catalogue_source import CatalogueSource
from storyblender.library.file_names import character_file
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen
from storyblender.pipeline.prices import NotAsked, makers_of, not_asked
from storyblender.pipeline.run import Run
from storyblender.reflection import reflect
from storyblender.services.making import Maker


class ExpectedAsset(Frozen):
    """Where one thing of a story would come from."""

    asset_id: str
    name: str
    """What the script calls it."""
    how: Literal["here", "fetched", "made"]
    """From this machine, from a catalogue, or made by services; what is made costs at most ``dollars``."""
    source: str
    """Name of the asset source or of the services."""
    what: str
    """The work, the file or the entry of the library."""
    licence: str = ""
    url: str = ""
    megabytes: float = 0.0
    """Of the download."""
    dollars: float = 0.0
    stands_in: bool = False
    """Whether no source has what the script means, so that this stands in for it."""
    note: str = ""
    """Why the figures are not known."""


class Expected(Frozen):
    """What a dry run found."""

    assets: tuple[ExpectedAsset, ...]
    not_asked: tuple[NotAsked, ...] = ()
    """Services of the setting that failed, or that lack a key or an address."""
    most_dollars: float = 0.0
    """The most that a run may spend; 0 where no service is named."""


def expected_assets(run: Run) -> Expected:
    """Return where the things that the script names would come from, and the people that you have models of.

    Args:
        run: On a planned project.
    """
    makers, lacking = makers_of(run.settings.services, run.services) if run.services is not None else ([], [])
    if len(makers) < 2 or run.settings.licences == "free":
        makers = []
    means = WORDS_BY_AGE.get(run.graph.age or "today", {})
    things = [each for each in run.graph.assets if each.asset_type == "object" and not each.fitted_part]
    found = [_expected(run, each, means, makers) for each in things if each.canonical is None]
    return expected_of(run, [*_people(run), *found], lacking)


def expected_of(run: Run, assets: Sequence[ExpectedAsset], lacking: Sequence[NotAsked]) -> Expected:
    """Return what a dry run found, with the services that failed meanwhile.

    Args:
        run: The run.
        assets: Where things would come from.
        lacking: Services that have no key or no address.
    """
    if run.services is None:
        return Expected(assets=tuple(assets))
    failed = [not_asked(name, f"{why}; this list is without it") for name, why in run.services.outages.met.items()]
    return Expected(
        assets=tuple(assets), not_asked=(*failed, *lacking), most_dollars=run.services.budget.left("dollars")
    )


def _people(run: Run) -> list[ExpectedAsset]:
    """Return the characters of whom the sources have a model; casting builds the others."""
    source_of = {key: source.name for source in run.sources for key in source.inventory()}
    people = [(each, character_file(each, source_of)) for each in run.graph.assets if each.asset_type == "character"]
    return [
        ExpectedAsset(
            asset_id=each.asset_id, name=each.name or each.asset_id, how="here", source=source_of[file], what=file
        )
        for each, file in people
        if file
    ]


def _expected(run: Run, asset: Asset, means: Mapping[str, str], makers: Sequence[Maker]) -> ExpectedAsset:
    """Return where one thing would come from."""
    role = run.crew.asset_retriever
    view = role.project(run.graph, asset, means, frozenset(asset.turned_down), nothing_drawn)
    recipe = reflect(role, asset.asset_id, view).draft
    source = recipe.provenance.source if recipe.provenance else "built_in"
    name = asset.name or asset.asset_id
    stands_in = recipe.score < RETRIEVAL_THRESHOLD
    here = ExpectedAsset(
        asset_id=asset.asset_id, name=name, how="here", source=source, what=_told(recipe), stands_in=stands_in
    )
    if stands_in and asset.origin != "dressing" and makers:
        return made_by(makers, asset)
    catalogue = next((each for each in run.sources if isinstance(each, CatalogueSource) and each.name == source), None)
    return here if catalogue is None else here.model_copy(update=_offered(catalogue, recipe))


def _told(recipe: Recipe) -> str:
    """Return what a thing would be made from, as people say it."""
    match recipe.source:
        case "catalog":
            return PROPS[recipe.key].name
        case "stand_in":
            return recipe.key.replace("_", " ")
        case "file":
            return recipe.key


def made_by(makers: Sequence[Maker], asset: Asset) -> ExpectedAsset:
    """Return what it takes to have an asset made.

    Args:
        makers: The image model, the maker of models, and for a person what rigs the model.
        asset: A thing or a person.
    """
    name = asset.name or asset.asset_id
    return ExpectedAsset(
        asset_id=asset.asset_id,
        name=name,
        how="made",
        source=" + ".join(maker.settings for maker in makers),
        what=f"a model of {name}",
        licence="; ".join(dict.fromkeys(maker.licence for maker in makers[1:])),
        url=makers[1].url,
        dollars=round(sum(maker.price for maker in makers), 3),
    )


def _offered(catalogue: CatalogueSource, recipe: Recipe) -> dict[str, Any]:
    """Return what is known of a work that a catalogue offers, by the fields of ``ExpectedAsset``."""
    offer = catalogue.offer_of(recipe.key)
    told = {"what": offer.name, "licence": offer.licence.name, "url": offer.url}
    try:
        size = catalogue.bytes_to_fetch(recipe)
    except ServiceFailure as failure:
        return {**told, "how": "fetched", "note": str(failure)}
    return {**told, "how": "here" if size is None else "fetched", "megabytes": round((size or 0) / 1e6, 3)}
