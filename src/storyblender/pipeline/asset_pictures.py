"""People and things to look at, one by one: small pictures and glTF, each made once; and what else a thing could be."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Final, Literal

from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView, asset_retriever_view
from storyblender.agents.concept_artist.retriever import RulesAssetRetriever
from storyblender.catalog.meanings import WORDS_BY_AGE
from storyblender.catalog.recipe import Recipe
from storyblender.errors import InputError
from storyblender.library.catalogue_source import CatalogueSource
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import content_hash
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import AssetJob
from storyblender.memory.paint import Paint
from storyblender.pipeline.asset_files import assets_to_build
from storyblender.pipeline.fetching import fetched
from storyblender.pipeline.run import Run

SHOWN: Final = "build/cast"
"""Folder of the pictures and models, each named by what it shows."""
OFFERED: Final = 12
"""Most candidates for a thing."""


def view_of(run: Run, asset: Asset, kind: Literal["png", "glb"]) -> Path:
    """Return an asset as a small picture or as glTF.

    Args:
        run: Its engine makes what is not made yet.
        asset: With its canonical, which need not be built.
        kind: A picture, or glTF.

    Raises:
        EngineError: It cannot be built.
    """
    name = view_name(run.graph, asset, kind)
    if not run.outputs.whole(name):
        make = run.engine.portrait if kind == "png" else run.engine.write_asset
        make(AssetJob(asset=asset), name, _paints_on(run.graph, asset)).result()
        run.outputs.note(name)
    return run.project.path(name)


def view_name(graph: ContinuityMemoryGraph, asset: Asset, kind: Literal["png", "glb"]) -> str:
    """Return the name of a picture or of the glTF of an asset in the project: it tells all that is seen.

    Args:
        graph: The story, with what is painted.
        asset: With its canonical.
        kind: A picture, or glTF.
    """
    digest, paints = AssetJob(asset=asset).digest, _paints_on(graph, asset)
    return f"{SHOWN}/{content_hash(digest, *paints) if paints else digest}.{kind}"


def _paints_on(graph: ContinuityMemoryGraph, asset: Asset) -> tuple[Paint, ...]:
    """Return what a person painted on an asset wherever it is, or on a material of the whole story."""
    everywhere = (each for each in graph.paints if each.target.scene_id is None and each.target.node_id is None)
    return tuple(each for each in everywhere if each.target.asset_id in (None, asset.asset_id))


def built_asset(run: Run, asset_id: str) -> Asset:
    """Return an asset of the story; if an edit changed it, it is built first.

    Args:
        run: Its engine builds.
        asset_id: Of the asset.

    Raises:
        KeyError: There is none.
    """
    if assets_to_build(run, [run.graph.asset(asset_id)]):
        from storyblender.pipeline.materializing import materialize

        materialize(run, [run.graph.asset(asset_id)])
    return run.graph.asset(asset_id)


def candidates_for(run: Run, asset_id: str, words: str) -> list[Asset]:
    """Return a thing as it would be if it were made from what the asset sources offer for it, best first.

    Services are not asked: ``offered_models`` tells what they have. Models of the user's library are put into the
    project, so that the engine can show them.

    Args:
        run: Its sources offer.
        asset_id: The thing.
        words: What is looked for; what the script says of the thing if empty.
    """
    asset, view = run.graph.asset(asset_id), view_for(run, asset_id, words)
    sources = [source for source in run.sources if not isinstance(source, CatalogueSource)]
    found = RulesAssetRetriever(sources).candidates(view, by_meaning=True)
    best = {(recipe.source, recipe.key): recipe for recipe in reversed(found)}
    recipes: list[Recipe] = []
    for recipe in sorted(best.values(), key=lambda recipe: -recipe.score)[:OFFERED]:
        with suppress(InputError):  # it has gone since it was found
            recipes.append(fetched(run, recipe))
    free = asset.model_copy(update={"dimension": None, "decision": None})
    return [free.model_copy(update={"canonical": recipe.canonical()}) for recipe in recipes]


def view_for(run: Run, asset_id: str, words: str) -> AssetRetrieverView:
    """Return what is looked for where a person chooses what a thing is made from.

    Args:
        run: Has the story.
        asset_id: The thing.
        words: What is looked for; what the script says of the thing if empty.
    """
    asset = run.graph.asset(asset_id)
    if not words:
        return asset_retriever_view(run.graph, asset, WORDS_BY_AGE.get(run.graph.age or "today", {}))
    named = asset.model_copy(update={"name": words, "description": words, "tags": (), "kind": None})
    return AssetRetrieverView(asset=named)
