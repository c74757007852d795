"""The files of the assets in ``assets/``: which are missing or damaged, so that they are built again."""

from __future__ import annotations

from collections.abc import Iterable

from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import ASSETS, asset_suffixes
from storyblender.pipeline.run import Run


def assets_to_build(run: Run, assets: Iterable[Asset]) -> list[Asset]:
    """Return those of the assets that are not built yet, or whose files are not as they were built.

    Args:
        run: Its project has the files.
        assets: In any state.
    """
    return [
        asset
        for asset in assets
        if asset.canonical is None or not asset.canonical.geometry_hash or not files_whole(run, asset)
    ]


def files_whole(run: Run, asset: Asset) -> bool:
    """Return whether all files of an asset are there as they were built.

    Args:
        run: Its project has the files.
        asset: With ``canonical`` decided.
    """
    return all(run.outputs.whole(name) for name in _names(asset))


def note_asset(run: Run, asset: Asset) -> None:
    """Note the files of an asset that was just built.

    Args:
        run: Its project has the files.
        asset: With ``canonical`` decided.
    """
    for name in _names(asset):
        run.outputs.note(name)


def _names(asset: Asset) -> list[str]:
    assert asset.canonical is not None, "only what is built has files"
    return [f"{ASSETS}/{asset.canonical.digest}{suffix}" for suffix in (*asset_suffixes(asset), ".json")]
