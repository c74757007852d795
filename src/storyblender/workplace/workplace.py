"""The folder that agents and the page work in: one project is open at a time, and long work runs beside."""

from __future__ import annotations

import threading
from collections.abc import Callable
from pathlib import Path

from storyblender.deliver.panel import Panel, panels
from storyblender.errors import InputError, StoryBlenderError
from storyblender.folder import Folder
from storyblender.history_files import GRAPH
from storyblender.library.texture_file import surfaces_in
from storyblender.project import read_project_graph
from storyblender.results import Delivery
from storyblender.session import Session
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event, Listener, silent
from storyblender.workplace.values import WARNINGS, Status, warning_of

SCRIPTS = (".fountain", ".fdx", ".txt", ".md")
PANORAMAS = (".hdr", ".exr")
_MOST_PICTURES = 200
"""Surfaces of the folder that are listed."""
_PROJECT = ".storyboard"
_REVISIONS = "build/revisions"


class Workplace:
    """Scripts and projects of one folder; nothing outside it is read or written.

    Args:
        root: The folder.
        listener: Hears every event of the work, on the thread that causes it.
        opened: Hears which project is open now; None where there is none.
    """

    def __init__(
        self, root: Path, listener: Listener = silent, opened: Callable[[Path | None], None] = lambda _: None
    ) -> None:
        self._files, self._listener, self._opened = Folder(root.resolve()), listener, opened
        self._session: Session | None = None
        self._thread: threading.Thread | None = None
        self._state = threading.Lock()
        self._status = Status(
            busy=False, work="", film=False, stage="", step=0, total=0, error="", warnings=(), files=()
        )  # fmt: skip

    @property
    def session(self) -> Session:
        """The open project. Raises InputError if there is none."""
        if self._session is None:
            raise InputError("no project is open", mend="call open_project or make first")
        return self._session

    @property
    def is_open(self) -> bool:
        """Whether a project is open."""
        return self._session is not None

    @property
    def status(self) -> Status:
        """How far the work is."""
        with self._state:
            return self._status

    def names(self) -> tuple[list[str], list[str]]:
        """Return the scripts and the projects of the folder, by name."""
        root = self._files.root
        scripts = [path.name for path in root.iterdir() if path.suffix in SCRIPTS and path.is_file()]
        projects = [path.name for path in root.iterdir() if path.suffix == _PROJECT and path.is_dir()]
        return sorted(scripts), sorted(projects)

    def panoramas(self) -> list[str]:
        """Return the panoramas of the folder, by name."""
        root = self._files.root
        return sorted(path.name for path in root.iterdir() if path.suffix.lower() in PANORAMAS and path.is_file())

    def panorama(self, name: str) -> Path:
        """Return a panorama of the folder by its name. Raises InputError."""
        if name not in self.panoramas():
            mend = "put the .hdr or .exr file beside the project"
            raise InputError(f"there is no panorama {name!r} here", mend=mend)
        return self._files.path(name)

    def surfaces(self) -> list[str]:
        """Return the colour pictures of surfaces in the folder, and in the folders in it but for projects, by name."""
        root = self._files.root
        folders = [each for each in root.iterdir() if each.is_dir()]
        inner = [each for each in folders if each.suffix != _PROJECT and not (each / GRAPH).exists()]
        own = [each for each in inner if not each.is_symlink() and not each.name.startswith(".")]
        found = (file for folder in (root, *own) for file in surfaces_in(folder, root))
        return sorted(file.relative_to(root).as_posix() for file in found)[:_MOST_PICTURES]

    def surface(self, name: str) -> Path:
        """Return the colour picture of a surface of the folder by its name. Raises InputError."""
        if name not in self.surfaces():
            mend = "name its colour picture oak_diff.jpg, or put it in a folder `textures`, beside the project"
            raise InputError(f"there is no surface {name!r} here", mend=mend)
        return self._files.path(name)

    def write_script(self, name: str, text: str) -> Path:
        """Write a script into the folder; one that is there with other words is refused.

        Args:
            name: File name with its ending.
            text: Of the script.

        Raises:
            InputError: The name is no name of a script here, or is taken.
        """
        path = self._script(name)
        if path.exists() and path.read_text(encoding="utf-8") != text:
            raise InputError("is there already, with other words", mend="give it another name", path=path.name)
        return self._files.write(name, text)

    def revision(self, name: str, text: str | None) -> Path:
        """Return a revised script of the open project.

        Args:
            name: File name with its ending.
            text: Its words, kept in the project's own folder of what it builds from; None for a script of the folder.

        Raises:
            InputError: No project is open, or the name is no name of a script here.
        """
        path = self._script(name)
        if text is not None:
            return Folder(self.session.folder).write(f"{_REVISIONS}/{name}", text)
        if not path.is_file():
            raise InputError("there is no such script here", mend="check the name, or drop the file in", path=name)
        return path

    def project_of(self, script: str) -> str:
        """Return the name of the project that a script is made into. Raises InputError: it is no name of a script."""
        return f"{self._script(script).stem}{_PROJECT}"

    @property
    def script_of_open_project(self) -> str:
        """File name of the script that the open project was made from. Raises InputError if it is not here."""
        project = self.session.folder.name
        found = [script for script in self.names()[0] if self.project_of(script) == project]
        if not found:
            mend = "put the script back beside it, or make it with `storyblender make SCRIPT --out FOLDER`"
            raise InputError("its script is not in this folder", mend=mend, path=project)
        return found[0]

    @property
    def settings_made_with(self) -> dict[str, object]:
        """The settings that the open project remembers and that a person chooses as it is made."""
        made_with = Settings.load(project=self.session.folder)
        return {"look": made_with.look, "animatic": made_with.animatic, "crew": made_with.crew}

    def open(self, project: str) -> Session:
        """Open a finished or planned project of the folder; the one open before is closed.

        Raises:
            InputError: No such project, or work is under way.
            ProjectLocked: Another program has it open.
        """
        self._refuse_busy()
        folder = self._files.path(project)
        read_project_graph(folder)
        self.close()
        return self._hold(Studio(Settings.load(project=folder), self._hear).open(folder))

    def make(self, script: str, settings: dict[str, object]) -> None:
        """Begin to turn a script of the folder into a storyboard; ``status`` says how far it is.

        Args:
            script: File name.
            settings: As on the command line.

        Raises:
            InputError: No such script, a setting that cannot be, or work is under way.
        """
        self._refuse_busy()
        path = self._script(script)
        folder = self._files.path(self.project_of(script))
        studio = Studio(Settings.load(path, folder, **settings), self._hear)
        self.close()
        session = self._hold(studio.start(path, folder))
        self.begin(f"make {script}", lambda: session.make(path))

    def make_of(self, script: str, text: str, settings: dict[str, object]) -> None:
        """Write a script into the folder and begin to make it; one that cannot be read is not left there.

        Args:
            script: File name.
            text: Its words.
            settings: As on the command line.

        Raises:
            InputError: As ``write_script`` and ``make``.
        """
        new = script not in self.names()[0]
        self.write_script(script, text)
        try:
            self.make(script, settings)
        except InputError:
            if new:
                self._files.delete(script)
            raise

    def begin(self, work: str, call: Callable[[], Delivery]) -> None:
        """Run a long call beside the conversation. Raises InputError if one is under way.

        Args:
            work: What it is, in words.
            call: Returns what it made.
        """
        self._refuse_busy()
        with self._state:
            film = self.session.makes_film
            self._status = Status(
                busy=True, work=work, film=film, stage="", step=0, total=0, error="", warnings=(), files=()
            )

        def run() -> None:
            error, files = "", tuple[str, ...]()
            try:
                files = tuple(call().files)
            except StoryBlenderError as problem:
                error = str(problem)
            finally:
                with self._state:
                    self._status = self._status.model_copy(update={"busy": False, "error": error, "files": files})

        self._thread = threading.Thread(target=run, name=work, daemon=True)
        self._thread.start()

    def wait(self, seconds: float) -> Status:
        """Return the status when the work has ended, or after some seconds."""
        if self._thread is not None:
            self._thread.join(seconds)
        return self.status

    def cancel(self) -> Status:
        """End the work under way before its next step; what is finished is kept."""
        if self._session is not None and self.status.busy:
            self._session.cancel()
        return self.wait(60)

    def panels(self) -> tuple[Panel, ...]:
        """Return every shot of the open project, with those that are omitted."""
        return tuple(panels(self.session.graph, with_omitted=True))

    def panel(self, shot: str) -> Panel:
        """Return a shot of the open project by its name. Raises InputError."""
        found = next((panel for panel in self.panels() if panel.name == shot.upper()), None)
        if found is None:
            raise InputError(f"there is no shot {shot!r}", mend="open_project lists the shots")
        return found

    def close(self) -> None:
        """Close the open project, if there is one."""
        if self._session is not None:
            self._opened(None)
            self._session.close()
            self._session = None

    def _hold(self, session: Session) -> Session:
        self._session = session
        self._opened(session.folder)
        return session

    def _script(self, name: str) -> Path:
        path = self._files.path(name)
        if path.suffix not in SCRIPTS or path.name != name:
            raise InputError(f"{name!r} is no name of a script here", mend=f"it ends in {', '.join(SCRIPTS)}")
        return path

    def _refuse_busy(self) -> None:
        if self.status.busy:
            raise InputError(f"work is under way: {self.status.work}", mend="wait for it with status, or cancel it")

    def _hear(self, event: Event) -> None:
        with self._state:
            update: dict[str, object] = {}
            if event.kind == "stage":
                update = {"stage": event.role, "step": event.step or 0, "total": event.total or 0}
            elif event.kind == "warning" and len(self._status.warnings) < WARNINGS:
                update = {"warnings": (*self._status.warnings, warning_of(event))}
            self._status = self._status.model_copy(update=update)
        self._listener(event)
