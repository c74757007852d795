"""Studio: wires settings, crew and Blender, and opens projects as sessions.

``open`` returns a session for many calls; the other methods on a project open one for a single call, as the command
line does. There is no terminal in it, only events. What reads a script and what writes the board are imported where
they are used: an edit needs no reader, and its frame does not wait for the board.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Event as Signal
from typing import TYPE_CHECKING

from storyblender import samples
from storyblender.build_folder import check_build_folder
from storyblender.catalog.garments import GARMENTS
from storyblender.catalog.hair import HAIRSTYLES
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.props import PROPS
from storyblender.catalog.recipe import EXACT, Recipe
from storyblender.catalog.registry import Entry
from storyblender.catalog.sets import SETS
from storyblender.crew import rules_crew
from storyblender.edits.dispatcher import Applied
from storyblender.engine.blender_engine import BlenderEngine
from storyblender.engine.worker import Worker
from storyblender.errors import EngineError, InputError
from storyblender.folder import Folder
from storyblender.inspection import Inspection
from storyblender.library.embedder import load_embedder
from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.library.sources import asset_sources, service_run
from storyblender.look.looks import LOOKS
from storyblender.memory.base import shot_name
from storyblender.memory.edits import Edit
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Commit
from storyblender.memory.jobs import GIVEN, AssetJob
from storyblender.pipeline.library_pictures import check_readable, picture_job
from storyblender.pipeline.reviewing import FrameReview
from storyblender.project import Project, read_project_graph
from storyblender.results import Delivery
from storyblender.session import Session
from storyblender.settings import Settings
from storyblender.trace import Event, Listener, silent

if TYPE_CHECKING:
    from storyblender.library.shared.adding import Work
    from storyblender.pipeline.estimating import Expected

CATALOGS: dict[str, Mapping[str, Entry]] = {
    "props": PROPS,
    "sets": SETS,
    "garments": GARMENTS,
    "hair": HAIRSTYLES,
    "materials": MATERIALS,
    "motions": MOTIONS,
    "looks": LOOKS,
}


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
            InputError: The script, the reading or the folder cannot be used, or ``export`` exists already.
        """
        with self.start(script, folder) as session:
            return session.plan(script, reading, export, why=why)

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
        with self.start(script, folder) as session:
            return session.make(script, reading)

    def estimate(self, script: Path, reading: Path | None = None) -> Expected:
        """Return what the things of a script would be made from, and what that takes; nothing is fetched or made.

        The script is read by the rules, whoever else the crew has: a language model would have to be asked.

        Args:
            script: The script.
            reading: A corrected reading of the script.

        Raises:
            InputError: The script or the reading cannot be used.
        """
        settings = self._settings.model_copy(update={"crew": "rules", "build": None})
        with (
            TemporaryDirectory() as room,
            Studio(settings, self._listener).start(script, Path(room) / "plan") as session,
        ):
            session.plan(script, reading, why=False)
            return session.estimate()

    def start(self, script: Path, folder: Path) -> Session:
        """Open the project of a script, a new one if there is none, for as many calls as you like.

        Args:
            script: One that cannot be read is refused before there is a folder.
            folder: The project; made if it does not exist.

        Raises:
            InputError: The script or the folder cannot be used.
            ProjectLocked: Another session has it open.
        """
        return self._open(script, folder)

    def open(self, folder: Path) -> Session:
        """Open a project for as many calls as you like; it is locked until the session is closed.

        Raises:
            InputError: No such project.
            ProjectLocked: Another session has it open.
        """
        read_project_graph(folder)
        return self._open(None, folder)

    def render(self, folder: Path, names: Sequence[str] = ()) -> Delivery:
        """Open a project for one call of ``Session.render``.

        Args:
            folder: The project.
            names: Shots to draw, such as ``SC010_SH020``; all if empty.

        Raises:
            InputError: No such project, no such shot, or a project that is only planned.
            ProjectLocked: Another session has it open.
            EngineError: Blender failed for good.
        """
        with self.open(folder) as session:
            return session.render(names)

    def edit(
        self, folder: Path, edits: Sequence[Edit], revision: str | None = None, *, draw: bool = True
    ) -> tuple[Applied, Delivery | None]:
        """Open a project, apply a batch of edits, and draw what they made stale.

        Args:
            folder: The project.
            edits: In order; one undo takes all of them back.
            revision: What they were made on, as ``Session.revision`` was then; None for the present one.
            draw: Whether to draw at once; a later ``render`` does as well.

        Raises:
            InputError: No such project, or an edit that cannot be.
            StaleEdit: What they touch has changed since that revision.
        """
        with self.open(folder) as session:
            applied = session.apply(edits, revision)
            return applied, session.draw(applied) if draw else None

    def make_person(self, folder: Path, name: str) -> str:
        """Open a project for one call of ``Session.make_person``."""
        with self.open(folder) as session:
            return session.make_person(name)

    def expect_person(self, folder: Path, name: str) -> Expected:
        """Open a project for one call of ``Session.expect_person``."""
        with self.open(folder) as session:
            return session.expect_person(name)

    def instruct(
        self, folder: Path, words: str, revision: str | None = None, *, draw: bool = True
    ) -> tuple[Applied, Delivery | None]:
        """Open a project, turn words into edits, apply them, and draw what they made stale.

        Args:
            folder: The project.
            words: Shots or scenes, a colon, and what is wanted.
            revision: What they were said of; None for the present one.
            draw: Whether to draw at once.

        Raises:
            InputError: No such project, or words that are not understood.
            StaleEdit: What they touch has changed since that revision.
        """
        with self.open(folder) as session:
            applied = session.instruct(words, revision)
            return applied, session.draw(applied) if draw else None

    def undo(self, folder: Path) -> list[Commit]:
        """Open a project for one call of ``Session.undo``."""
        with self.open(folder) as session:
            return session.undo()

    def redo(self, folder: Path) -> list[Commit]:
        """Open a project for one call of ``Session.redo``."""
        with self.open(folder) as session:
            return session.redo()

    def check(self, folder: Path) -> Inspection:
        """Open a project for one call of ``Session.check``."""
        with self.open(folder) as session:
            return session.check()

    def evaluate(self, folder: Path) -> list[FrameReview]:
        """Open a project for one call of ``Session.evaluate``."""
        with self.open(folder) as session:
            return session.evaluate()

    def export(self, folder: Path, kinds: Sequence[str]) -> Delivery:
        """Open a project for one call of ``Session.export``.

        Args:
            folder: The project.
            kinds: ``glb``, ``usd``, ``edl`` or ``fcpxml``.

        Raises:
            InputError: No such project, no story.blend in it yet, or an adapter is missing.
            ProjectLocked: Another session has it open.
            EngineError: Blender failed for good.
        """
        with self.open(folder) as session:
            return session.export(kinds)

    def print_board(self, folder: Path) -> Delivery:
        """Open a project for one call of ``Session.print_board``, with the layout of the settings.

        Raises:
            InputError: No such project, or one that is only planned.
            ProjectLocked: Another session has it open.
            EngineError: Blender failed for good.
        """
        with self.open(folder) as session:
            return session.print_board(session.board_layout)

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

    def check_readable(self, works: Sequence[Work]) -> None:
        """Have each model and panorama read, before it is added to the user's library.

        Raises:
            InputError: One cannot be read.
        """
        for top in dict.fromkeys(work.top for work in works):
            paths = [work.path for work in works if work.top == top]
            with TemporaryDirectory() as name, BlenderEngine(Path(name), [top.resolve()], jobs=1) as engine:
                check_readable(engine, paths, top)

    def draw_entry(self, library: SharedLibrary, entry: LibraryEntry) -> Path:
        """Return the picture of a model of the user's library, drawn if it is not there yet.

        Args:
            library: Has the entry.
            entry: A model.

        Raises:
            InputError: It is no model.
            EngineError: It cannot be read.
        """
        if entry.kind not in ("model", "character"):
            raise InputError(f"no picture is made of a {entry.kind}", mend="name a model")
        picture = library.thumbnail_of(entry)
        if not picture.is_file():
            folder = library.bundle_of(entry)
            job = picture_job(entry, Recipe(source="file", key=entry.main, score=EXACT))
            with TemporaryDirectory() as name, BlenderEngine(Path(name), [folder], jobs=1) as engine:
                engine.portrait(job, "picture.png").result()
                library.files.write(library.files.name_of(picture), (Path(name) / "picture.png").read_bytes())
        return picture

    def draw_entries(self, library: SharedLibrary, entries: Sequence[LibraryEntry]) -> None:
        """Draw the pictures of models; of one that cannot be drawn a warning is told.

        Args:
            library: Has the entries.
            entries: Others than models are left out.
        """
        for entry in entries:
            try:
                if entry.kind == "model":
                    self.draw_entry(library, entry)
            except EngineError as error:
                self._listener(Event(kind="warning", role="library", subject=entry.name, message=error.problem))

    def _portrait(self, kind: str, key: str, folder: Path) -> Path:
        with BlenderEngine(folder, jobs=1) as engine:
            engine.portrait(AssetJob(asset=samples.asset_of(kind, key)), "picture.png").result()
        return folder / "picture.png"

    def _sample(self, story: ContinuityMemoryGraph, key: str, folder: Path) -> Path:
        """Draw the one shot of a sample story, in the look that it is about."""
        settings = Settings.model_validate({"look": key if key in LOOKS else "fast", "jobs": 1})
        with Studio(settings, self._listener)._open(None, folder) as session:
            session.draw_sample(story, f"a sample of {key}")
        return folder / "frames" / f"{shot_name(1, 1)}.png"

    def _open(self, script: Path | None, folder: Path) -> Session:
        settings, models, build = self._settings, self._settings.models, self._settings.build
        for models_folder in models if script is not None else ():
            if not models_folder.is_dir():
                mend = "give --models a folder with 3D models, such as .glb, .blend, .obj or .usdz files"
                raise InputError("is not a folder", mend=mend, path=models_folder)
        for motions_folder in settings.motions if script is not None else ():
            if not motions_folder.is_dir():
                mend = "give --motions a folder of .bvh or .fbx files"
                raise InputError("is not a folder", mend=mend, path=motions_folder)
        if script is not None:
            from storyblender.screenplay.source import load

            load(script)  # a script that cannot be read is refused before there is a folder
            if settings.hdri is not None:
                from storyblender.library.panorama_file import read_panorama

                read_panorama(settings.hdri)
        ahead, self._ahead = self._ahead, None
        if build is not None:
            check_build_folder(build, folder.resolve(), take=script is not None)

        def engine(listener: Listener) -> BlenderEngine:
            return BlenderEngine(folder, models, settings.jobs, build=build, ahead=ahead, listener=listener)

        def warn(sentence: str) -> None:
            session.warn(Event(kind="warning", role="asset_retriever", message=sentence))

        cancelled = Signal()
        services = service_run(settings, cancelled)
        with_own = settings.model_copy(update={"models": (*models, folder / GIVEN)})
        sources = asset_sources(with_own, load_embedder, services, warn)
        crew = rules_crew(settings, load_embedder, sources)
        if settings.language_roles:
            from storyblender.language.answerers import answerers
            from storyblender.language_crew import language_crew

            by_role = answerers(settings.crew, folder, settings.limits, cancelled, self._listener)
            crew = language_crew(crew, by_role, load_embedder, sources)
        session = Session(Project(folder, build), engine, crew, sources, settings, self._listener, cancelled, services)
        return session
