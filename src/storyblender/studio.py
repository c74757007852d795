"""Studio: everything a user can do, one method each. Opens the project, wires settings, ports and crew.

The command line calls it, and so will every other surface; it has no terminal in it, only events. Who reads a script
and who binds a board are imported where they work: an edit needs no reader, and its frame does not wait for the binder.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache, partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from storyblender import samples
from storyblender.build_folder import check_build_folder
from storyblender.catalog.garments import GARMENTS
from storyblender.catalog.hair import HAIRSTYLES
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.props import PROPS
from storyblender.catalog.registry import Entry
from storyblender.catalog.sets import SETS
from storyblender.crew import rules_crew
from storyblender.edits import camera_decision, decide_cameras, redo_edit, shots_named, undo_edit
from storyblender.engine.blender_engine import BlenderEngine
from storyblender.engine.worker import Worker
from storyblender.errors import InputError
from storyblender.folder import Folder
from storyblender.inspection import Inspection, inspect
from storyblender.library.embedder import load_embedder
from storyblender.library.sources import asset_sources
from storyblender.look.looks import LOOKS
from storyblender.memory.base import scene_name, shot_name
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Commit
from storyblender.memory.jobs import AssetJob, ExportJob
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.adopting import adopt_earlier_outputs
from storyblender.pipeline.asset_files import assets_to_build
from storyblender.pipeline.compiling import STORY, Compilation, file_of, story_files
from storyblender.pipeline.filming import film, with_cuts_judged
from storyblender.pipeline.packing import pack_scenes
from storyblender.pipeline.retaking import retake_poor_frames
from storyblender.pipeline.reviewing import FrameReview, review_frames
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import damaged_frames, drawn_shots, prune, shoot_frames, shoot_motion
from storyblender.project import Project, read_project_graph
from storyblender.settings import REMEMBERED, Settings
from storyblender.trace import Event, Listener, silent

if TYPE_CHECKING:
    from storyblender.agents.director.reader.reasons import Reason

CATALOGS: dict[str, Mapping[str, Entry]] = {
    "props": PROPS,
    "sets": SETS,
    "garments": GARMENTS,
    "hair": HAIRSTYLES,
    "materials": MATERIALS,
    "motions": MOTIONS,
    "looks": LOOKS,
}


@dataclass(frozen=True)
class Delivery:
    """What a call made.

    Attributes:
        folder: The project.
        files: Names in it, in the order people open them.
        graph: The story as it is now.
        reasons: Which rule read what in the script, if that was asked.
    """

    folder: Path
    files: list[str]
    graph: ContinuityMemoryGraph
    reasons: list[Reason] = field(default_factory=list)


class Studio:
    """The facade.

    Args:
        settings: For every call.
        listener: Hears every event.
        ahead: A Blender worker of the project that is drawn next, which comes up already.
    """

    def __init__(self, settings: Settings, listener: Listener = silent, ahead: Worker | None = None) -> None:
        self._settings, self._listener, self._ahead = settings, listener, ahead

    def plan(
        self, script: Path, folder: Path, reading: Path | None = None, export: Path | None = None, *, why: bool = False
    ) -> Delivery:
        """Read a script into the graph; no Blender.

        Args:
            script: The script.
            folder: The project.
            reading: A corrected reading of the script (see ``docs/reading-file.md``).
            export: Where to write what was understood, for a person to correct.
            why: Whether to say which rule read what, on which words.

        Raises:
            InputError: The script, the reading or the folder cannot be used.
        """
        from storyblender.pipeline.grounding import explain, export_reading, ground

        if export is not None and export.exists():
            raise InputError("is there already", mend="give --write-reading another name, or delete it", path=export)
        with self._open(script, folder) as run:
            ground(run, script, reading)
            if export is not None:
                export_reading(run, script, export)
            reasons = explain(run, script) if why else []
            return Delivery(run.project.folder, ["graph.json"], run.graph, reasons)

    def make(self, script: Path, folder: Path, reading: Path | None = None) -> Delivery:
        """Turn a script into everything; goes on where an earlier run was stopped.

        Args:
            script: The script.
            folder: The project.
            reading: A corrected reading of the script (see ``docs/reading-file.md``).

        Raises:
            InputError: The script, the reading or the folder cannot be used.
            EngineError: Blender failed for good.
        """
        from storyblender.pipeline.grounding import ground
        from storyblender.pipeline.materializing import materialize
        from storyblender.pipeline.staging import stage

        with self._open(script, folder) as run:
            ground(run, script, reading)
            run.project.files.write(REMEMBERED, self._settings.remembered(run.project.folder))
            materialize(run)
            stage(run)
            pack_scenes(run)
            film(run)
            return self._shoot(run, run.graph.shots)

    def render(self, folder: Path, names: Sequence[str], camera: Mapping[str, str | float]) -> Delivery:
        """Draw again what changed, with a changed camera if one is given.

        Args:
            folder: The project.
            names: Shots to draw; all if empty.
            camera: ``size``, ``angle``, ``lens``, ``movement`` for the named shots.

        Raises:
            InputError: No such project or shot, a project that is only planned, or a camera without a shot.
        """
        read_project_graph(folder)
        with self._open_made(folder) as run:
            shots = shots_named(run.graph, names)
            if camera and not names:
                raise InputError("a changed camera needs a shot", mend="name it, e.g. --shot SC010_SH020")
            _refuse_unmade(run)
            if camera:
                run.engine.warm()
                decide_cameras(run, shots, camera_decision(camera))
            _restore_assets(run)
            pack_scenes(run)
            film(run)
            return self._shoot(run, [run.graph.shot(shot.scene_id, shot.shot_id) for shot in shots])

    def undo(self, folder: Path) -> list[Commit]:
        """Take back the last change and what followed from it; the next render draws only what that changes.

        Raises:
            InputError: No such project, or nothing to undo.
        """
        read_project_graph(folder)
        with self._project(folder) as project:
            return undo_edit(project)

    def redo(self, folder: Path) -> list[Commit]:
        """Make the change again that was undone last.

        Raises:
            InputError: No such project, or nothing to redo.
        """
        read_project_graph(folder)
        with self._project(folder) as project:
            return redo_edit(project)

    def check(self, folder: Path) -> Inspection:
        """Inspect a finished project: layout, framing, continuity, collisions, people in frame.

        Raises:
            InputError: No such project, one that is only planned, or one that was stopped before its cameras were set.
        """
        read_project_graph(folder)
        with self._open_made(folder) as run:
            _refuse_unmade(run)
            if any(shot.camera is None for shot in run.graph.shots):
                mend = "run `storyblender render` first: it goes on where it was stopped"
                raise InputError("has shots without a camera yet", mend=mend, path=run.project.folder)
            _restore_assets(run)
            pack_scenes(run)
            reviews = review_frames(run, drawn_shots(run))
            report = inspect(
                with_cuts_judged(run), run.engine, list(run.packs.values()), reviews, partial(run.progress, "check")
            )
            return report.with_story([name for name in story_files(run.graph) if run.outputs.changed(name)])

    def evaluate(self, folder: Path) -> list[FrameReview]:
        """Return what the Frame Critic finds in every frame of a finished project.

        Raises:
            InputError: No such project, or one that is only planned or not finished.
        """
        read_project_graph(folder)
        with self._open_made(folder) as run:
            _refuse_unmade(run)
            _restore_assets(run)
            pack_scenes(run)
            film(run)
            shoot_frames(run, run.graph.shots)
            return list(review_frames(run, run.graph.shots).values())

    def export(self, folder: Path, kinds: Sequence[str]) -> Delivery:
        """Write scenes as glTF or USD, the timeline as EDL or FCPXML.

        Raises:
            InputError: The project has no story.blend yet, or an adapter is missing.
        """
        from storyblender.deliver.timeline import EXTRA_FORMATS, write_extra
        from storyblender.pipeline.delivery import timeline_media

        read_project_graph(folder)
        with self._open_made(folder) as run:
            files: list[str] = []
            for kind in kinds:
                if kind in EXTRA_FORMATS:
                    files.append(f"timeline{EXTRA_FORMATS[kind]}")
                    with run.delivering(files[-1]) as part:
                        write_extra(timeline_media(run), part, kind)
                else:
                    files += self._export_scenes(run, kind)
            return Delivery(run.project.folder, files, run.graph)

    def catalog(self, kind: str = "") -> dict[str, list[Entry]]:
        """Return the entries of one catalogue, or of all.

        Raises:
            InputError: No such catalogue.
        """
        if kind and kind not in CATALOGS:
            raise InputError(f"there is no catalogue {kind!r}", mend=f"it is one of {', '.join(CATALOGS)}")
        return {name: list(entries.values()) for name, entries in CATALOGS.items() if kind in ("", name)}

    def picture(self, key: str, out: Path, kind: str = "") -> None:
        """Render a picture of an entry: a thing alone, clothes and hair on a person, the rest as a frame of a story.

        Args:
            key: Of the entry.
            out: The PNG.
            kind: Its catalogue; the first that has the key if not given.

        Raises:
            InputError: No such catalogue, or nothing in it has that key.
        """
        kinds = [name for name, entries in self.catalog(kind).items() if any(entry.key == key for entry in entries)]
        if not kinds:
            raise InputError(f"nothing in the library is called {key!r}", mend="see `storyblender catalog`")
        story = samples.story_of(kinds[0], key)
        with TemporaryDirectory() as name:
            folder = Path(name) / "sample"
            made = self._portrait(kinds[0], key, folder) if story is None else self._sample(story, key, folder)
            Folder(out.parent).write(out.name, made.read_bytes())

    def _portrait(self, kind: str, key: str, folder: Path) -> Path:
        with BlenderEngine(folder, jobs=1) as engine:
            engine.portrait(AssetJob(asset=samples.asset_of(kind, key)), "picture.png").result()
        return folder / "picture.png"

    def _sample(self, story: ContinuityMemoryGraph, key: str, folder: Path) -> Path:
        """Draw the one shot of a sample story, in the look that it is about."""
        from storyblender.pipeline.materializing import materialize
        from storyblender.pipeline.staging import stage

        settings = Settings.model_validate({"look": key if key in LOOKS else "fast", "jobs": 1})
        with Studio(settings, self._listener)._open(None, folder) as run:
            run.project.commit(story, "user", f"a sample of {key}")
            materialize(run)
            stage(run)
            pack_scenes(run)
            film(run)
            shoot_frames(run, run.graph.shots)
        return folder / "frames" / f"{shot_name(1, 1)}.png"

    @contextmanager
    def _open(self, script: Path | None, folder: Path) -> Iterator[Run]:
        models = self._settings.models
        for models_folder in models if script is not None else ():
            if not models_folder.is_dir():
                mend = "give --models a folder of .glb or .blend files"
                raise InputError("is not a folder", mend=mend, path=models_folder)
        if script is not None:
            from storyblender.screenplay.source import load

            load(script)  # a script that cannot be read is refused before there is a folder
        ahead, self._ahead = self._ahead, None
        jobs, build = self._settings.jobs, self._settings.build
        if build is not None:
            check_build_folder(build, folder.resolve(), take=script is not None)
        with (
            self._project(folder, build) as project,
            BlenderEngine(project.folder, models, jobs, build=build, ahead=ahead) as engine,
        ):
            embedder = cache(load_embedder)
            sources = asset_sources(self._settings, embedder)
            crew = rules_crew(self._settings, embedder, sources)
            run = Run(project, engine, crew, self._settings, self._listener, sources=sources)
            adopt_earlier_outputs(run)
            yield run

    @contextmanager
    def _open_made(self, folder: Path) -> Iterator[Run]:
        """Open a project for its finishing touches, in the look that it was made in."""
        with self._open(None, folder) as run:
            staged = any(scene.lighting is not None for scene in run.graph.scenes)
            if staged and not (folder / REMEMBERED).exists():
                message = f"{REMEMBERED} is missing; look, width and lenses are the defaults"
                run.tell(Event(kind="warning", role="project", subject=folder.name, message=message))
            yield run

    @contextmanager
    def _project(self, folder: Path, build: Path | None = None) -> Iterator[Project]:
        """Open a project, and say what was missing in it."""
        with Project(folder, build) as project:
            for sentence in project.notices:
                self._listener(Event(kind="warning", role="project", subject=folder.name, message=sentence))
            yield project

    def _shoot(self, run: Run, shots: Sequence[ShotContext]) -> Delivery:
        asked = {(shot.scene_id, shot.shot_id) for shot in shots}
        others = [shot for shot in run.graph.shots if (shot.scene_id, shot.shot_id) not in asked]
        shoot_frames(run, [*shots, *damaged_frames(run, others)])
        retake_poor_frames(run, shots)
        story = Compilation(run)
        from storyblender.pipeline.delivery import deliver

        clips = shoot_motion(run, run.graph.shots) if self._settings.animatic else None
        if len(shots) == len(run.graph.shots):
            prune(run, run.graph.shots)
        return Delivery(run.project.folder, deliver(run, clips, story), run.graph)

    def _export_scenes(self, run: Run, kind: str) -> list[str]:
        if not (run.project.folder / STORY).exists():
            raise InputError("has no story.blend yet", mend="run `storyblender make` first", path=run.project.folder)
        jobs = [
            ExportJob(
                story=file_of(run.graph, scene.scene_id),
                scene_id=scene.scene_id,
                format="glb" if kind == "glb" else "usd",
                out=f"export/{scene_name(scene.scene_id)}.{'glb' if kind == 'glb' else 'usdc'}",
            )
            for scene in run.graph.scenes
        ]
        for job in jobs:
            run.copy_aside_if_known(job.out)
        waiting = [run.engine.export_scene(job) for job in jobs]
        files: list[str] = []
        run.progress("export", 0, len(jobs), kind)
        for step, future in enumerate(waiting, start=1):
            files.append(future.result())
            run.outputs.note(files[-1])
            run.progress("export", step, len(jobs), files[-1])
        return files


def _restore_assets(run: Run) -> None:
    """Build assets again whose files are gone or damaged. Who decides on assets is loaded only then."""
    if assets_to_build(run, run.graph.assets):
        from storyblender.pipeline.materializing import materialize

        materialize(run)


def _refuse_unmade(run: Run) -> None:
    scenes = run.graph.scenes
    if not scenes or any(
        scene.layout is None or scene.environment is None or scene.lighting is None for scene in scenes
    ):
        raise InputError(
            "is planned, not made yet", mend="run `storyblender make SCRIPT` first", path=run.project.folder
        )
