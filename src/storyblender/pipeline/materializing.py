"""Canonical asset materialization: every entity of the sheet becomes measured geometry (paper, section 3.3)."""

from __future__ import annotations

from concurrent.futures import Future

from storyblender.catalog.props import PROPS
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.jobs import AssetJob
from storyblender.memory.measure import AssetMeasure
from storyblender.pipeline.run import Run


def materialize(run: Run) -> None:
    """Decide, size, build and measure every asset that is not built yet; one commit for all of them."""
    missing = [asset for asset in run.graph.assets if asset.canonical is None or not asset.canonical.geometry_hash]
    if not missing:
        return
    waiting: list[tuple[Asset, Future[AssetMeasure]]] = []
    for asset in missing:
        decided = _decided(run, asset)
        waiting.append((decided, run.engine.build_asset(AssetJob(asset=decided))))
    built: list[Asset] = []
    for step, (asset, future) in enumerate(waiting):
        run.progress("materialize", step, len(waiting), asset.asset_id)
        built.append(_measured(asset, future.result()))
    run.progress("materialize", len(waiting), len(waiting))
    run.commit("asset_formatter", f"{len(built)} assets built", *built)


def _decided(run: Run, asset: Asset) -> Asset:
    """What it is made from and how large it is."""
    if asset.canonical is None:
        asset = asset.model_copy(update={"canonical": decide(run, asset)})
    if asset.dimension is None:
        asset = asset.model_copy(update={"dimension": estimate(run.graph, asset)})
    return asset


def _measured(asset: Asset, measure: AssetMeasure) -> Asset:
    canonical = asset.canonical
    assert canonical is not None, "decided before it is built"
    return asset.model_copy(
        update={
            "canonical": CanonicalAsset(
                source=canonical.source,
                key=canonical.key,
                params=canonical.params,
                match_score=canonical.match_score,
                dimensions=measure.dimensions,
                anchors=measure.anchors,
                digest=measure.digest,
                geometry_hash=measure.geometry_hash,
            )
        }
    )


def decide(run, asset):
    if asset.asset_type=="character":
        return CanonicalAsset(source="person",key="person",dimensions=(.5,.4,1.7),digest="")
    words=asset.asset_id.split("_")
    best=max(PROPS.values(),key=lambda e: sum((w==e.key)*3+(w in e.key.split("_"))*2+(w in " ".join(e.tags).split()) for w in words[-1:])+.5*(words[-1] in e.key))
    return CanonicalAsset(source="catalog",key=best.key,dimensions=best.size,digest="")


def estimate(graph, asset):
    return None
