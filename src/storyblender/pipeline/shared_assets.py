"""What the user's library has of the things of a story, and what it is given: model files and built geometry."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from concurrent.futures import Future
from contextlib import suppress
from pathlib import PurePosixPath
from time import time

from storyblender.catalog.props import PROPS
from storyblender.errors import InputError
from storyblender.library.shared.built_geometry import key_of
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.library.shared.uses import Use, UseOrigin
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.jobs import FETCHED, AssetJob
from storyblender.memory.measure import AssetMeasure
from storyblender.model_content import content_of
from storyblender.pipeline.run import Run

_OWN = ("models", "blender")
"""Sources of models whose files are the user's: in their folders, or made in Blender."""


class SharedBuilding:
    """Builds assets, or takes them from the user's library as they were built for another story.

    Args:
        run: Its engine builds.
    """

    def __init__(self, run: Run) -> None:
        self._run, self._began = run, time()
        self._taken: dict[str, AssetMeasure] = {}
        self._asked: dict[str, AssetJob] = {}
        self._first = {
            asset.canonical.digest: asset.asset_id
            for asset in reversed(run.graph.assets)
            if asset.canonical is not None and asset.canonical.geometry_hash
        }
        """Digest of built geometry to the first thing of the story that has it."""

    def prepare(self, assets: Iterable[Asset]) -> None:
        """Take what the library has of things that are to be built, and put back files of their models."""
        library, jobs = self._run.library, [AssetJob(asset=asset) for asset in assets]
        if library is not None and jobs:
            with self._run.without_library():
                for job in jobs:
                    _put_back(self._run, library, job.asset)
                self._taken = library.geometry.take(jobs, self._run.project.files)

    def build(self, asset: Asset) -> Future[AssetMeasure]:
        """Return the measure of an asset, once it is built."""
        job = AssetJob(asset=asset)
        self._asked.setdefault(job.digest, job)
        self._first.setdefault(job.digest, asset.asset_id)
        if (measure := self._taken.get(job.digest)) is None:
            return self._run.engine.build_asset(job)
        future: Future[AssetMeasure] = Future()
        future.set_result(measure.model_copy(update={"asset_id": asset.asset_id}))
        return future

    def give(self, assets: Sequence[Asset]) -> None:
        """Give the library what was built, and note what the story uses.

        Args:
            assets: As they are now, built.
        """
        self.give_geometry(assets)
        library = self._run.library
        if library is not None and assets:
            with self._run.without_library():
                library.uses.note(str(self._run.project.folder), [self._use(library, asset) for asset in assets])

    def give_geometry(self, assets: Sequence[Asset]) -> None:
        """Give the library what was built.

        Args:
            assets: As they are now, built.
        """
        library = self._run.library
        if library is not None:
            built = {asset.canonical.digest for asset in assets if asset.canonical is not None}
            kept = [job for digest, job in self._asked.items() if digest in built and digest not in self._taken]
            with self._run.without_library():
                library.geometry.give(kept, self._run.project.files)

    def _use(self, library: SharedLibrary, asset: Asset) -> Use:
        made, job = asset.canonical, AssetJob(asset=asset)
        assert made is not None, "it is built"
        provenance = made.provenance
        ours = provenance is None or provenance.source in _OWN
        entry = None if provenance is None or ours else library.by_main(provenance.digest)
        origin: UseOrigin = "built"
        if self._first.get(job.digest, asset.asset_id) != asset.asset_id:
            origin = "same"
        elif job.digest in self._taken:
            origin = "geometry"
        elif entry is not None:
            origin = "fetched" if library.has_since(entry) >= self._began else "library"
        return Use(
            asset=asset.asset_id,
            model=key_of(job) or job.digest,
            name=asset.name or asset.asset_id,
            category=_category(asset, entry.category if entry is not None else ""),
            origin=origin,
            entry=entry.digest if entry is not None else "",
        )


def count_places(run: Run) -> None:
    """Note in the user's library in how many places the things and people of the story are."""
    if run.library is None:
        return
    placed = [
        {node.asset_id for node in scene.layout.objects} | {*scene.setup.asset_ids}
        for scene in run.graph.scenes
        if scene.layout is not None
    ]
    with run.without_library():
        run.library.uses.count_places(str(run.project.folder), Counter(each for scene in placed for each in scene))


def _put_back(run: Run, library: SharedLibrary, asset: Asset) -> None:
    """Put the files of a fetched model that are gone from the project, or damaged, back from the library."""
    made, files = asset.canonical, run.project.files
    if made is None or made.source != "file" or made.provenance is None or made.provenance.source in _OWN:
        return
    if _is_there(run, made.key, str(made.params.get("content", ""))):
        return
    entry = library.by_main(made.provenance.digest)
    parts = PurePosixPath(made.key).parts
    if entry is not None and made.key.endswith(f"/{entry.main}"):
        folder = PurePosixPath(*parts[: -len(PurePosixPath(entry.main).parts)])
        with suppress(InputError):  # the engine says what is missing
            library.put_into(entry, files, f"{FETCHED}/{folder}")


def _is_there(run: Run, key: str, content: str) -> bool:
    try:
        return content_of(run.project.path(FETCHED, key), run.project.path(FETCHED)) == content
    except (OSError, InputError):
        return False


def _category(asset: Asset, told: str) -> str:
    """Return what sort of thing an asset is, for figures."""
    if asset.asset_type == "character":
        return "characters"
    made = asset.canonical
    entry = PROPS.get(made.key if made is not None and made.source == "catalog" else asset.kind or "")
    return told or (entry.category if entry is not None else "") or "other things"
