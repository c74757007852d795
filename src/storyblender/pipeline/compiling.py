"""``story.blend`` from the packs: whole the first time, afterwards only the scenes that changed are put in anew."""

from __future__ import annotations

from concurrent.futures import Future
from contextlib import suppress

from storyblender import __version__
from storyblender.errors import InputError
from storyblender.memory.base import Frozen, content_hash
from storyblender.memory.jobs import GEOMETRY_VERSION, StoryJob
from storyblender.pipeline.run import Run

STORY = "story.blend"
RECORD = "build/story.json"


class StoryRecord(Frozen):
    """What the file on disk was compiled from."""

    common: str
    """Hash of what all scenes share."""
    scenes: dict[int, str]
    """Scene id and the hash of everything that its part of the file depends on."""


class Compilation:
    """The .blend of a run under way.

    Args:
        run: With the frames drawn: the file holds the lights that they were solved with.
    """

    def __init__(self, run: Run) -> None:
        self._outputs, job = run.outputs, _story_job(run)
        self._fresh, former = _record_of(job), run.outputs.read(RECORD, StoryRecord.model_validate_json)
        changed = None
        if former is not None and former.common == self._fresh.common and run.outputs.whole(STORY):
            changed = tuple(key for key, digest in self._fresh.scenes.items() if former.scenes.get(key) != digest)
        self._compiled: Future[str] | None = None
        if changed != ():
            run.copy_aside(STORY)
            self._compiled = run.engine.compile_story(job.model_copy(update={"changed": changed}))
            self._compiled.add_done_callback(self._note)

    def _note(self, compiled: Future[str]) -> None:
        """Note the file as soon as it is there: if the run is killed from here on, nobody takes it for changed."""
        if not compiled.cancelled() and compiled.exception() is None:
            with suppress(InputError, OSError):  # ``finish`` says it
                self._outputs.note(STORY)

    def finish(self) -> None:
        """Wait for the file.

        Raises:
            EngineError: Blender failed for good.
        """
        if self._compiled is not None:
            self._compiled.result()
            if not self._outputs.whole(STORY):
                self._outputs.note(STORY)
            self._outputs.write(RECORD, self._fresh.model_dump_json())


def _story_job(run: Run) -> StoryJob:
    graph = run.graph
    return StoryJob(
        format=graph.format,
        outline=graph.outline,
        assets=graph.assets,
        scenes=graph.scenes,
        shots=graph.shots,
        packs=tuple(run.packs[scene.scene_id] for scene in graph.scenes if scene.scene_id in run.packs),
        out=STORY,
    )


def _record_of(job: StoryJob) -> StoryRecord:
    plain = job.model_dump(mode="json")
    scenes: dict[int, str] = {}
    for pack in job.packs:
        of_scene = [[part for part in plain[name] if part["scene_id"] == pack.scene_id] for name in ("scenes", "shots")]
        scenes[pack.scene_id] = content_hash(pack, list(of_scene))
    common = [plain[name] for name in ("format", "outline", "assets")]
    return StoryRecord(common=content_hash(__version__, GEOMETRY_VERSION, common, list(scenes)), scenes=scenes)
