"""A project that stays open, with its lock, its crew, its warm Blender processes and its events.

Calls are made one at a time, from any thread. ``cancel`` may be called meanwhile: the call under way then ends before
its next step or job. The graph and the files are whole at every moment, so the next call goes on from there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import AbstractContextManager, ExitStack, contextmanager
from functools import cached_property
from pathlib import Path
from threading import Event as Signal
from threading import Lock, RLock
from types import TracebackType
from typing import TYPE_CHECKING, Self

from storyblender.crew import Crew
from storyblender.errors import Cancelled, InputError, StoryBlenderError
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.plain_words import names_of
from storyblender.pipeline.adopting import adopt_earlier_outputs
from storyblender.pipeline.filming import film
from storyblender.pipeline.rehearsing import CamerasToMatch
from storyblender.pipeline.run import Run
from storyblender.pipeline.updating import bring_up_to_date
from storyblender.ports import AssetSource, Engine
from storyblender.project import Project
from storyblender.settings import Settings
from storyblender.trace import Event, Listener

if TYPE_CHECKING:
    from storyblender.services.register import ServiceRun

EngineMaker = Callable[[Listener], AbstractContextManager[Engine]]
"""Opens the engine; the listener hears the progress of its jobs."""


class OpenProject:
    """What every call of a session needs. Use as a context manager, which closes it.

    Args:
        project: Open, and so locked; the session closes it.
        make_engine: Opens the engine at the first call that needs it.
        crew: The roles with their policies.
        sources: Where assets come from.
        settings: Of every call.
        listener: Hears every event, on the thread that causes it; one at a time.
        cancelled: Set by ``cancel``, for what a role waits for outside of Blender.
        services: What calls give the services that they ask; None if they ask none.
    """

    def __init__(
        self,
        project: Project,
        make_engine: EngineMaker,
        crew: Crew,
        sources: Sequence[AssetSource],
        settings: Settings,
        listener: Listener,
        cancelled: Signal | None = None,
        services: ServiceRun | None = None,
    ) -> None:
        self._services = services
        self._project, self._crew, self._sources, self._settings = project, crew, sources, settings
        self._make_engine = make_engine
        self._listeners = [listener]
        self._held = ExitStack()
        self._held.enter_context(project)
        self._busy, self._telling = RLock(), Lock()
        self._cancelled = cancelled or Signal()
        self._closed = False
        self._matching: CamerasToMatch | None = None
        for sentence in project.notices:
            self._tell(Event(kind="warning", role="project", subject=project.folder.name, message=sentence))

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self._closed = True
        self._held.__exit__(kind, error, where)

    def close(self) -> None:
        """Cancel the call under way, wait for its end, end Blender and unlock the project."""
        self.cancel()
        with self._busy:
            self.__exit__(None, None, None)

    @property
    def folder(self) -> Path:
        """The project folder."""
        return self._project.folder

    @property
    def graph(self) -> ContinuityMemoryGraph:
        """The story as it is committed."""
        return self._project.graph

    @property
    def revision(self) -> str:
        """The last commit's number, a dot, and its digest; an edit names the one that it was made on."""
        return self._project.version

    @property
    def lens_kit(self) -> tuple[float, ...]:
        """Lenses at hand in mm; empty allows any."""
        return self._settings.lens_kit

    @property
    def made(self) -> bool:
        """Whether every scene is staged; a project that is only planned has nothing to draw."""
        parts = [(scene.layout, scene.environment, scene.lighting) for scene in self.graph.scenes]
        return bool(parts) and all(part is not None for scene in parts for part in scene)

    def listen(self, listener: Listener) -> Callable[[], None]:
        """Let one more listener hear the events; return what ends that."""
        with self._telling:
            self._listeners.append(listener)
        return lambda: self._listeners.remove(listener)

    def warm(self) -> None:
        """Start Blender now, for a preview that is sure to come."""
        with self._alone():
            self._engine.front.warm()

    def cancel(self) -> None:
        """End the call under way, from any thread: it raises Cancelled before its next step or job."""
        self._cancelled.set()
        if "_engine" in self.__dict__:
            self._engine.cancel_waiting()

    @cached_property
    def _engine(self) -> Engine:
        return self._held.enter_context(self._make_engine(self._tell))

    @contextmanager
    def _alone(self) -> Iterator[None]:
        """Wait for the end of the call under way, if it is another thread's."""
        with self._busy:
            if self._closed:
                raise StoryBlenderError("the session is closed", mend="open the project again")
            yield

    @contextmanager
    def _call(self) -> Iterator[Run]:
        """Make one call: alone, told apart from those before it, and ended by ``cancel``."""
        with self._alone():
            self._cancelled.clear()
            first = "_engine" not in self.__dict__
            parts = self._project, self._engine, self._crew, self._settings, self._tell, self._sources
            run = Run(*parts, self._cancelled, self._services)
            if first:
                adopt_earlier_outputs(run)
            try:
                yield run
            except (Cancelled, CancelledError) as error:
                self._tell(Event(kind="cancel", role="session", message=str(Cancelled())))
                if isinstance(error, CancelledError):
                    raise Cancelled from error
                raise

    @contextmanager
    def _filming(self) -> Iterator[Run]:
        """Make one call on a made project, with its packs up to date and all cameras set."""
        with self._call() as run:
            self._refuse_unmade()
            bring_up_to_date(run)
            film(run)
            self._matching = CamerasToMatch(run)
            yield run

    def warn(self, event: Event) -> None:
        """Tell what a source of assets met, and keep it in the trace.

        Args:
            event: A warning.
        """
        self._project.record(event)
        self._tell(event)

    def _tell(self, event: Event) -> None:
        """Tell every listener, in words for people; the trace has kept what the program calls it."""
        if event.message or event.details:
            event = event.in_words_for(names_of(self.graph))
        with self._telling:
            for listener in self._listeners:
                listener(event)

    def _refuse_unmade(self) -> None:
        if not self.made:
            mend = "run `storyblender make SCRIPT` first"
            raise InputError("is planned, not made yet", mend=mend, path=self.folder)
