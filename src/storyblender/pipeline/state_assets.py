"""Things in the states that shots bring them to: built beside the thing itself, and shown from that moment on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from storyblender.catalog.states import StateLook, state_looks
from storyblender.memory.asset_sheet import Asset, AssetDimension
from storyblender.memory.jobs import AssetInState, AssetJob, SceneJob
from storyblender.memory.shot_context import ShotContext
from storyblender.memory.thing_states import Condition
from storyblender.pipeline.asset_files import files_whole, note_asset
from storyblender.pipeline.run import Run
from storyblender.pipeline.shared_assets import SharedBuilding


def assets_in_states(
    assets: Sequence[Asset], shots: Sequence[ShotContext], found: Mapping[str, Condition] = {}
) -> tuple[AssetInState, ...]:
    """Return how things look in the states that shots bring them to, each once.

    Args:
        assets: Of the scene.
        shots: Of the scene.
        found: States in which things are as the scene opens.
    """
    built = {asset.asset_id: asset for asset in assets if asset.asset_type == "object"}
    looks: dict[tuple[str, Condition], tuple[AssetInState, ...]] = {}
    for asset_id, condition in _conditions(shots, found):
        asset = built.get(asset_id)
        if asset is None or asset.canonical is None or asset.canonical.source != "catalog":
            continue
        made = asset.canonical
        told = state_looks(made.key, made.params, condition, made.dimensions, asset.liquid)
        looks[asset_id, condition] = tuple(
            AssetInState(
                condition=condition,
                asset=_looking(asset, look),
                added=look.added,
                location=look.location,
                lying=look.lying,
            )
            for look in told
        )
    return tuple(each for parts in looks.values() for each in parts)


def build_states(run: Run, jobs: Iterable[SceneJob]) -> None:
    """Build what is not built yet of the things in their states.

    Args:
        run: Its engine builds.
        jobs: The scenes; the things are in their ``in_states``.

    Raises:
        EngineError: A thing cannot be built.
    """
    wanted = {each.asset.canonical.digest: each.asset for job in jobs for each in job.in_states if each.asset.canonical}
    missing = [asset for asset in wanted.values() if not files_whole(run, asset)]
    if not missing:
        return
    building = SharedBuilding(run)
    building.prepare(missing)
    waiting = [(asset, building.build(asset)) for asset in missing]
    for asset, future in waiting:
        future.result()
        note_asset(run, asset)
    building.give_geometry(missing)


def _conditions(shots: Sequence[ShotContext], found: Mapping[str, Condition]) -> Iterator[tuple[str, Condition]]:
    """Yield every condition that things are in during a scene."""
    now: dict[str, Condition] = dict(found)
    yield from now.items()
    for change in (change for shot in shots for change in shot.asset_modifications if change.state):
        before = now.get(change.asset_id, Condition())
        now[change.asset_id] = before.after(change.state, change.writing, change.doors)
        yield change.asset_id, now[change.asset_id]


def _looking(asset: Asset, look: StateLook) -> Asset:
    """Return an asset that is made as a look says."""
    canonical = asset.canonical
    assert canonical is not None, "only what is built changes its state"
    dimension = asset.dimension
    if look.key != canonical.key:
        dimension = None if look.width is None else AssetDimension(width=look.width)
    made = canonical.model_copy(update={"key": look.key, "params": look.params, "digest": ""})
    changed = asset.model_copy(update={"canonical": made, "dimension": dimension})
    digest = AssetJob(asset=changed).digest
    return changed.model_copy(update={"canonical": made.model_copy(update={"digest": digest})})
