"""People and things to look at, one by one: small pictures and glTF, each made once; and what else a thing could be."""

from __future__ import annotations

from pathlib import Path
from typing import Final, Literal

from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView, asset_retriever_view
from storyblender.agents.concept_artist.retriever import RulesAssetRetriever
from storyblender.catalog.meanings import WORDS_BY_AGE
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import AssetJob
from storyblender.pipeline.asset_files import assets_to_build
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
    job = AssetJob(asset=asset)
    name = f"{SHOWN}/{job.digest}.{kind}"
    if not run.outputs.whole(name):
        make = run.engine.portrait if kind == "png" else run.engine.write_asset
        make(job, name).result()
        run.outputs.note(name)
    return run.project.path(name)


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

    Args:
        run: Its sources offer.
        asset_id: The thing.
        words: What is looked for; what the script says of the thing if empty.
    """
    asset = run.graph.asset(asset_id)
    view = asset_retriever_view(run.graph, asset, WORDS_BY_AGE.get(run.graph.age or "today", {}))
    if words:
        named = asset.model_copy(update={"name": words, "description": words, "tags": (), "kind": None})
        view = AssetRetrieverView(asset=named)
    found = RulesAssetRetriever(run.sources).candidates(view, by_meaning=True)
    best = {(recipe.source, recipe.key): recipe for recipe in reversed(found)}
    recipes = sorted(best.values(), key=lambda recipe: -recipe.score)[:OFFERED]
    free = asset.model_copy(update={"dimension": None, "decision": None})
    return [free.model_copy(update={"canonical": recipe.canonical()}) for recipe in recipes]
