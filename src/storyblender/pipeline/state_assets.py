"""Things in the states that shots bring them to: built beside the thing itself, and shown from that moment on."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from storyblender.catalog.states import StateLook, look_in
from storyblender.memory.asset_sheet import Asset, AssetDimension
from storyblender.memory.jobs import AssetInState, AssetJob, SceneJob
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.asset_files import files_whole, note_asset
from storyblender.pipeline.run import Run


def assets_in_states(assets: Sequence[Asset], shots: Sequence[ShotContext]) -> tuple[AssetInState, ...]:
    """Return how things look in the states that shots bring them to, each once.

    Args:
        assets: Of the scene.
        shots: Of the scene.
    """
    built = {asset.asset_id: asset for asset in assets if asset.asset_type == "object"}
    found: dict[tuple[str, str], AssetInState] = {}
    for change in (change for shot in shots for change in shot.asset_modifications):
        asset = built.get(change.asset_id)
        if asset is None or asset.canonical is None or asset.canonical.source != "catalog":
            continue
        look = look_in(asset.canonical.key, asset.canonical.params, change.state)
        if look is not None:
            there = AssetInState(state=change.state, asset=_looking(asset, look), added=look.added)
            found[change.asset_id, change.state] = there
    return tuple(found.values())


def build_states(run: Run, jobs: Iterable[SceneJob]) -> None:
    """Build what is not built yet of the things in their states."""
    wanted = {each.asset.canonical.digest: each.asset for job in jobs for each in job.in_states if each.asset.canonical}
    missing = [asset for asset in wanted.values() if not files_whole(run, asset)]
    waiting = [(asset, run.engine.build_asset(AssetJob(asset=asset))) for asset in missing]
    for asset, future in waiting:
        future.result()
        note_asset(run, asset)


def _looking(asset: Asset, look: StateLook) -> Asset:
    """Return an asset that is made as a look says; pieces, flames and smoke are as wide as the thing is large."""
    canonical = asset.canonical
    assert canonical is not None, "only what is built changes its state"
    dimension = asset.dimension
    if look.key != canonical.key:
        dimension = AssetDimension(width=max(0.25, max(canonical.dimensions) * (0.7 if look.added else 1.1)))
    made = canonical.model_copy(update={"key": look.key, "params": look.params, "digest": ""})
    changed = asset.model_copy(update={"canonical": made, "dimension": dimension})
    digest = AssetJob(asset=changed).digest
    return changed.model_copy(update={"canonical": made.model_copy(update={"digest": digest})})
