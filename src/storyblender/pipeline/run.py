"""What every stage of a run shares: the project, the engine, the settings, and how to commit and tell."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from datetime import datetime
from functools import cached_property
from pathlib import Path
from threading import Event as Signal
from typing import TYPE_CHECKING, ParamSpec, TypeVar

from storyblender.crew import Crew
from storyblender.errors import Cancelled, InputError, Rejected
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.history import Item, replace
from storyblender.memory.jobs import Look, PackRef
from storyblender.memory.panorama import Panorama
from storyblender.outputs import Outputs
from storyblender.ports import AssetSource, Engine
from storyblender.project import Project
from storyblender.reflection import Outcome, Role, reflect
from storyblender.settings import REMEMBERED, Settings
from storyblender.trace import Event, Listener

if TYPE_CHECKING:
    from storyblender.library.mocap.folders import MotionFolders
    from storyblender.library.pictures import Pictures
    from storyblender.library.shared.shared_library import SharedLibrary
    from storyblender.services.register import ServiceRun

Given = ParamSpec("Given")
View = TypeVar("View")
Draft = TypeVar("Draft")


class Run:
    """One call on one project.

    Args:
        project: The open project; the only place where the graph lives.
        engine: Builds, measures and renders.
        crew: The roles with their policies.
        settings: As the user gave them.
        listener: Hears every event.
        sources: Where assets come from.
        cancelled: Set from any thread to stop the run before its next step or job.
        services: What the run gives the services that it asks; None if it asks none.

    Attributes:
        packs: Scene id to the pack in use, as the staging made them.
        followed: Shots that were not edited and that changed in consequence of an edit, each with what changed.
    """

    def __init__(
        self,
        project: Project,
        engine: Engine,
        crew: Crew,
        settings: Settings,
        listener: Listener,
        sources: Sequence[AssetSource] = (),
        cancelled: Signal | None = None,
        services: ServiceRun | None = None,
    ) -> None:
        self.sources, self.services = sources, services
        self.project, self.crew, self.settings, self.listener = project, crew, settings, listener
        self._engine, self._cancelled = engine, cancelled or Signal()
        self.packs: dict[int, PackRef] = {}
        self.followed: list[str] = []
        self._doing = ""

    def in_front(self) -> Run:
        """Return a run of the same call whose engine is for what a person waits for."""
        parts = self.project, self.engine.front, self.crew, self.settings, self.listener, self.sources, self._cancelled
        return Run(*parts, self.services)

    @property
    def engine(self) -> Engine:
        """The engine, for the next job. Raises Cancelled once the run is cancelled."""
        self._go_on()
        return self._engine

    @cached_property
    def made_in_look(self) -> Look:
        """The look that the project was made in, whatever this run draws."""
        if not (self.project.folder / REMEMBERED).exists():
            return self.settings.look
        return Settings.load(project=self.project.folder).look

    @cached_property
    def panorama(self) -> tuple[Panorama, bytes] | None:
        """The panorama of the settings, and its prepared picture. Raises InputError where it cannot be used."""
        if self.settings.hdri is None:
            return None
        from storyblender.library.panorama_file import read_panorama

        return read_panorama(self.settings.hdri)

    @cached_property
    def library(self) -> SharedLibrary | None:
        """The user's library; None where the settings turn it off."""
        if not self.settings.library:
            return None
        from storyblender.library.shared.shared_library import SharedLibrary

        return SharedLibrary.open()

    @cached_property
    def pictures(self) -> Pictures | None:
        """Surfaces and panoramas of the library and of services; None where there is neither."""
        from storyblender.library.embedder import load_embedder
        from storyblender.library.sources import offered_pictures

        def warn(sentence: str) -> None:
            self.tell(Event(kind="warning", role="environment_designer", message=sentence))

        return offered_pictures(self.settings, load_embedder, self.services, warn)

    @contextmanager
    def without_library(self) -> Iterator[None]:
        """Go on without the library where the block cannot use it, and say so."""
        try:
            yield
        except InputError as error:
            self.library = None
            self.tell(Event(kind="warning", role="library", message=f"{error}; this run goes on without it"))

    @cached_property
    def own_motions(self) -> MotionFolders:
        """The user's folders of motion clips, as they are now."""
        from storyblender.library.mocap.folders import MotionFolders

        return MotionFolders(self.settings.motions)

    @property
    def outputs(self) -> Outputs:
        """What the program wrote into the project."""
        return self.project.outputs

    @property
    def graph(self) -> ContinuityMemoryGraph:
        """The graph as it is committed."""
        return self.project.graph

    def tell(self, event: Event) -> None:
        """Show an event and keep it in the trace."""
        self.project.record(event)
        if event.kind == "follow":
            self.followed.append(f"{event.subject} {event.message}")
        self.listener(event)

    @contextmanager
    def delivering(self, name: str) -> Iterator[Path]:
        """Write a deliverable; if the present one was changed by hand, a dated copy of it is kept beside it.

        Args:
            name: In the project.

        Yields:
            The path to write to; it becomes the file at the end.
        """
        self.copy_aside_if_known(name)
        with self.outputs.writing(name) as part:
            yield part

    def place(self, cached: str, name: str) -> None:
        """Give a cached file its name for people, if it is not there yet; one changed by hand is copied aside.

        Args:
            cached: Name of the file in the cache, as it was written.
            name: Its name for people.
        """
        if self.outputs.digest(name) != self.outputs.digest(cached) or not self.outputs.whole(name):
            self.copy_aside_if_known(name)
            self.outputs.write(name, self.project.path(cached).read_bytes())

    def copy_aside_if_known(self, name: str) -> None:
        """As ``copy_aside``; of a file that this program never wrote under that name nothing is kept."""
        if self.outputs.known(name):
            self.copy_aside(name)

    def copy_aside(self, name: str) -> None:
        """Copy a file that is not as the program wrote it before it is overwritten, and say so."""
        copy = self.outputs.copy_aside(name, datetime.now())
        if copy is not None:
            message = f"was changed by hand; what it was is kept as {self.project.files.name_of(copy)}"
            self.tell(Event(kind="warning", role="project", subject=name, message=message))

    def progress(self, stage: str, step: int, total: int, subject: str = "") -> None:
        """Say how far a stage has come.

        Args:
            stage: Its key, for example ``frames``.
            step: Items that are done.
            total: Items in all.
            subject: What is worked on now, for people.

        Raises:
            Cancelled: The run is cancelled.
        """
        self._go_on()
        self.listener(Event(kind="stage", role=stage, subject=subject, message=self._doing, step=step, total=total))

    @contextmanager
    def doing(self, words: str) -> Iterator[None]:
        """Call the stages in the block something else than usual, because they are gone through a second time.

        Args:
            words: What is done, as people read it beside the progress.
        """
        self._doing, before = words, self._doing
        try:
            yield
        finally:
            self._doing = before

    def commit(self, author: str, reason: str, *items: Item) -> None:
        """Put items into the graph through the Gatekeeper.

        Args:
            author: Name of the role.
            reason: What was done, for the history and the trace.
            items: Take the place of those with the same key; others are added.

        Raises:
            Rejected: The new state cannot be, V(o_new, S_exist) = 0; the graph stays as it was.
        """
        try:
            commit = self.project.commit(replace(self.graph, *items), author, reason)
        except Rejected as error:
            self.tell(Event(kind="reject", role=author, message=reason, details=error.violations))
            raise
        if commit is not None:
            self.tell(Event(kind="commit", role=author, message=reason, turn=commit.revision))

    def reflect(
        self, role: Role[Given, View, Draft], subject: str, *args: Given.args, **kwargs: Given.kwargs
    ) -> Outcome[View, Draft]:
        """Let a role decide (Eq. 1).

        Args:
            role: Of the crew.
            subject: What is being decided, for the trace.
            args: What the role's projection takes.
            kwargs: Likewise.
        """
        return reflect(role, subject, role.project(*args, **kwargs), self.tell)

    def _go_on(self) -> None:
        if self._cancelled.is_set():
            raise Cancelled
