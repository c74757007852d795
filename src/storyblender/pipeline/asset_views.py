"""Pictures of assets, for the roles and critics that look; drawn when one of them asks, and once in a run."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, get_args

from storyblender.catalog.recipe import LEAST, Recipe
from storyblender.errors import EngineError, InputError, NoAnswer
from storyblender.memory.asset_sheet import Asset, ModelSide
from storyblender.memory.jobs import AssetJob
from storyblender.memory.measure import AssetViews
from storyblender.pipeline.fetching import fetched
from storyblender.pipeline.run import Run

VIEWS: Final = "build/views"
"""Folder of the pictures."""
_PICTURES: Final = (*get_args(ModelSide), "portrait")


def asset_views(run: Run) -> Callable[[Asset], AssetViews]:
    """Return what draws an object from its six sides and as a portrait.

    Args:
        run: Its engine draws.

    Returns:
        A function of an asset with its canonical, which need not be built; it raises NoAnswer where the engine fails,
        so that rules decide.
    """
    known: dict[str, AssetViews | NoAnswer] = {}

    def draw(asset: Asset) -> AssetViews:
        job = AssetJob(asset=_readable(run, asset))
        if job.digest not in known:
            known[job.digest] = _drawn(run, job)
        found = known[job.digest]
        if isinstance(found, NoAnswer):
            raise found
        return found

    return draw


def _readable(run: Run, asset: Asset) -> Asset:
    """Return an object whose model the engine can read; one that a source only offers is fetched. Raises NoAnswer."""
    made = asset.canonical
    if made is None or made.source != "file" or "content" in made.params:
        return asset
    offered = Recipe(
        source="file", key=made.key, params=made.params, score=made.match_score or LEAST, provenance=made.provenance
    )
    try:
        return asset.model_copy(update={"canonical": fetched(run, offered).canonical()})
    except InputError as error:
        raise NoAnswer(f"{asset.asset_id} cannot be drawn: {error}") from error


def _drawn(run: Run, job: AssetJob) -> AssetViews | NoAnswer:
    """Return the pictures of an object, or why there are none."""
    folder = f"{VIEWS}/{job.digest}"
    try:
        dimensions = run.engine.draw_sides(job, folder).result()
    except EngineError as error:
        return NoAnswer(f"{job.asset.asset_id} cannot be drawn: {error}")
    run.outputs.note(folder)
    pictures = {name: run.project.path(f"{folder}/{name}.png").read_bytes() for name in _PICTURES}
    return AssetViews(digest=job.digest, dimensions=dimensions, pictures=pictures)
