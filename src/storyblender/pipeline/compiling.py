"""``story.blend`` from the packs: whole the first time, afterwards only the scenes that changed are put in anew.

A long story is a .blend for each sequence of scenes, which both workers compile side by side, and a ``story.blend``
that links them.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from concurrent.futures import Future
from contextlib import suppress

from storyblender import __version__
from storyblender.errors import InputError
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Frozen, content_hash
from storyblender.memory.coverage import as_filmed, is_beside
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import GEOMETRY_VERSION, Cut, CutJob, PackRef, SequenceFile, StoryJob
from storyblender.pipeline.run import Run

STORY = "story.blend"
SEQUENCES = "story"
"""Folder of the sequences' files."""
STORY_VERSION = 5
"""Raised when the same packs are compiled otherwise: the files of old projects are then compiled anew."""
MOST_SCENES = 40
"""In one file; a story of more has a file a sequence. A scene takes 15 to 45 MB of a worker (measured)."""
SEQUENCE = 20
"""Scenes in the file of a sequence."""

_NOT_SHOWN = ("locked", "decided_duration", "blocking_decision", "motion_by_hand", "stale", "notes", "approved",
              "omitted", "shot_order")  # fmt: skip
"""Fields of the graph that make no difference to a .blend."""


class StoryRecord(Frozen):
    """What a file on disk was compiled from."""

    common: str
    """Hash of what all scenes share."""
    scenes: dict[int, str]
    """Scene id and the hash of everything that its part of the file depends on."""
    cut: str = ""
    """Hash of the order of its film; empty for all shots in the order of the script."""


class Compilation:
    """The .blend of a run under way, with those of its sequences.

    Args:
        run: With the frames drawn: the file holds the lights that they were solved with.
    """

    def __init__(self, run: Run) -> None:
        self._run = run
        packs = [run.packs[scene.scene_id] for scene in run.graph.scenes if scene.scene_id in run.packs]
        sequences = sequences_of([pack.scene_id for pack in packs])
        run.outputs.keep_only(f"{SEQUENCES}/", [sequence.path for sequence in sequences])
        if sequences:
            jobs = [_story_job(run, packs, sequence) for sequence in sequences]
            self._files = [_File(run, job.out, _record_of(job), _compiler(run, job)) for job in jobs]
            self._files.append(_cut(run, packs, sequences))
        else:
            job = _story_job(run, packs, None)
            self._files = [_File(run, STORY, _record_of(job), _compiler(run, job))]

    def finish(self) -> None:
        """Wait for the files.

        Raises:
            EngineError: Blender failed for good.
        """
        for step, file in enumerate(self._files):
            if len(self._files) > 1:
                self._run.progress("story", step, len(self._files), file.name)
            file.finish()
        if len(self._files) > 1:
            self._run.progress("story", len(self._files), len(self._files))


def sequences_of(scene_ids: Sequence[int]) -> tuple[SequenceFile, ...]:
    """Return the files of a story's sequences, in order; none where all scenes are in ``story.blend`` itself."""
    if len(scene_ids) <= MOST_SCENES:
        return ()
    runs = [tuple(scene_ids[first : first + SEQUENCE]) for first in range(0, len(scene_ids), SEQUENCE)]
    return tuple(
        SequenceFile(path=f"{SEQUENCES}/SEQ{10 * number:03d}.blend", scene_ids=run)
        for number, run in enumerate(runs, start=1)
    )


def file_of(graph: ContinuityMemoryGraph, scene_id: int) -> str:
    """Return the name in the project of the .blend that holds a scene.

    Args:
        graph: The story.
        scene_id: The scene.
    """
    return next((each.path for each in _sequences(graph) if scene_id in each.scene_ids), STORY)


def story_files(graph: ContinuityMemoryGraph) -> tuple[str, ...]:
    """Return ``story.blend`` and the files of the sequences."""
    return STORY, *(sequence.path for sequence in _sequences(graph))


def record_name(name: str) -> str:
    """Return the name of the record that says what a .blend was compiled from."""
    return f"build/{name.removesuffix('.blend')}.json"


def _sequences(graph: ContinuityMemoryGraph) -> tuple[SequenceFile, ...]:
    return sequences_of([scene.scene_id for scene in graph.scenes if scene.layout is not None])


class _File:
    """One .blend, compiled where it is not up to date.

    Args:
        run: The run.
        name: Of the file.
        fresh: What it should be compiled from.
        compiled: Begins to compile it: whole, or the given scenes anew.
    """

    def __init__(
        self, run: Run, name: str, fresh: StoryRecord, compiled: Callable[[tuple[int, ...] | None], Future[str]]
    ) -> None:
        self.name, self._outputs, self._fresh = name, run.outputs, fresh
        self._record = record_name(name)
        former, changed = run.outputs.read(self._record, StoryRecord.model_validate_json), None
        if former is not None and former.common == fresh.common and run.outputs.whole(name):
            changed = tuple(key for key, digest in fresh.scenes.items() if former.scenes.get(key) != digest)
        self._compiled: Future[str] | None = None
        if changed != () or former is None or former.cut != fresh.cut:
            run.copy_aside(name)
            self._compiled = compiled(changed)
            self._compiled.add_done_callback(self._note)

    def _note(self, compiled: Future[str]) -> None:
        """Record the file as soon as it exists, so that after a kill it does not count as changed by hand."""
        if not compiled.cancelled() and compiled.exception() is None:
            with suppress(InputError, OSError):  # ``finish`` says it
                self._outputs.note(self.name)

    def finish(self) -> None:
        """Wait for the file."""
        if self._compiled is not None:
            self._compiled.result()
            if not self._outputs.whole(self.name):
                self._outputs.note(self.name)
            self._outputs.write(self._record, self._fresh.model_dump_json())


def _compiler(run: Run, job: StoryJob) -> Callable[[tuple[int, ...] | None], Future[str]]:
    return lambda changed: run.engine.compile_story(
        job.model_copy(
            update={
                "changed": changed,
                "former": run.project.files.state(job.out),
                "version": run.project.version,
            }
        )
    )


def _story_job(run: Run, packs: Sequence[PackRef], sequence: SequenceFile | None) -> StoryJob:
    """Return what compiles the story, or one sequence with the assets that it shows."""
    graph = as_filmed(run.graph)
    ids = {pack.scene_id for pack in packs} if sequence is None else set(sequence.scene_ids)
    assets: tuple[Asset, ...] = graph.assets
    if sequence is not None:
        shown = {asset.asset_id for scene_id in sequence.scene_ids for asset in graph.assets_of(scene_id)}
        assets = tuple(asset for asset in graph.assets if asset.asset_id in shown)
    return StoryJob(
        format=graph.format,
        outline=tuple(outline for outline in graph.outline if outline.scene_id in ids),
        assets=assets,
        scenes=tuple(scene for scene in graph.scenes if scene.scene_id in ids),
        shots=tuple(shot for shot in graph.shots if shot.scene_id in ids),
        packs=tuple(pack for pack in packs if pack.scene_id in ids),
        cut=_film_of(graph, ids),
        paints=graph.paints,
        beside=_beside(run.graph, ids),
        out=STORY if sequence is None else sequence.path,
    )


def _film_of(graph: ContinuityMemoryGraph, scenes: Collection[int]) -> Cut:
    """Return the film of some scenes; empty where it is all their shots in the order of the script."""
    shots = [(shot.scene_id, shot.shot_id) for shot in graph.shots if shot.scene_id in scenes]
    film = [(shot.scene_id, shot.shot_id) for shot in graph.cut if shot.scene_id in scenes]
    return () if film == shots else tuple(film)


def _beside(graph: ContinuityMemoryGraph, scenes: Collection[int]) -> Cut:
    """Return the shots of some scenes that are other cameras on the time of another shot."""
    return tuple((shot.scene_id, shot.shot_id) for shot in graph.shots if shot.scene_id in scenes and is_beside(shot))


def _cut(run: Run, packs: Sequence[PackRef], sequences: tuple[SequenceFile, ...]) -> _File:
    graph = as_filmed(run.graph)
    job = CutJob(
        format=graph.format,
        assets=graph.assets,
        shots=graph.shots,
        packs=tuple(packs),
        cut=_film_of(graph, {pack.scene_id for pack in packs}),
        paints=graph.paints,
        sequences=sequences,
        out=STORY,
    )
    lengths = [[shot.scene_id, shot.shot_id, shot.duration] for shot in graph.cut]
    plain = job.model_dump(
        mode="json", include={"format", "assets", "sequences", "paints"}, exclude={"assets": {"__all__": {"locked"}}}
    )
    record = StoryRecord(common=content_hash(__version__, STORY_VERSION, plain, list(lengths)), scenes={})

    def compiled(_: tuple[int, ...] | None) -> Future[str]:
        update = {"former": run.project.files.state(STORY), "version": run.project.version}
        return run.engine.compile_cut(job.model_copy(update=update))

    return _File(run, STORY, record, compiled)


def _record_of(job: StoryJob) -> StoryRecord:
    plain = job.model_dump(mode="json")
    for name in ("assets", "scenes", "shots"):  # a lock changes nothing in the file
        plain[name] = [{key: value for key, value in part.items() if key not in _NOT_SHOWN} for part in plain[name]]
    scenes: dict[int, str] = {}
    for pack in job.packs:
        of_scene = [[part for part in plain[name] if part["scene_id"] == pack.scene_id] for name in ("scenes", "shots")]
        scenes[pack.scene_id] = content_hash(pack, list(of_scene))
    common = [plain[name] for name in ("format", "outline", "assets", "paints") if name in plain]
    versions = [GEOMETRY_VERSION, STORY_VERSION]
    cut = content_hash([list(key) for key in job.cut]) if job.cut else ""
    return StoryRecord(common=content_hash(__version__, list(versions), common, list(scenes)), scenes=scenes, cut=cut)
