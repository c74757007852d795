"""One project, any number of browsers: calls are done in their order, and every browser hears what changed."""

from __future__ import annotations

import asyncio
import logging
import threading
from collections.abc import Callable, Collection, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path
from typing import Any

from storyblender.errors import InputError, StoryBlenderError
from storyblender.memory.plain_words import names_of, plain
from storyblender.session import Session
from storyblender.trace import Event
from storyblender.web_studio.calls import Calls
from storyblender.web_studio.drawer import Drawer
from storyblender.web_studio.messages import (
    Answer,
    Call,
    News,
    PlainCall,
)
from storyblender.web_studio.uploads import Uploads
from storyblender.workplace.workplace import Workplace

_LOG = logging.getLogger(__name__)
_TOLD = ("stage", "propose", "score", "refine", "accept", "handover", "warning", "follow")
"""Kinds of events that the page shows as the crew at work."""


class Hub:
    """What the browsers talk to. Calls are made on one thread of their own, so the wire stays free.

    Args:
        folder: Of scripts and projects; nothing outside it is read or written.
        opened: Hears which project is open now; None where there is none.
    """

    def __init__(self, folder: Path, opened: Callable[[Path | None], None] = lambda _: None) -> None:
        self.place = Workplace(folder, self._hear, opened)
        self._calls = ThreadPoolExecutor(1, "calls")
        self._browsers: set[asyncio.Queue[News]] = set()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._drawer: Drawer | None = None
        self.previews: dict[str, Path] = {}
        self.takes: dict[str, Path] = {}
        self.begun: Callable[[], dict[str, Any]] | None = None
        """Makes the story from its script, as it was begun last for the open project."""
        self.invite: Callable[[], str] | None = None
        """Returns an address whose key lets one more browser in; None where nothing is served."""
        self.uploads = Uploads()
        self._does = Calls(self)

    def join(self) -> asyncio.Queue[News]:
        """Return the news for one more browser, from now on."""
        self._loop = asyncio.get_running_loop()
        news: asyncio.Queue[News] = asyncio.Queue()
        self._browsers.add(news)
        return news

    def leave(self, news: asyncio.Queue[News]) -> None:
        """Forget a browser."""
        self._browsers.discard(news)

    async def answer(self, call: Call) -> Answer:
        """Make one call; what cannot be done is an answer, never an exception. Only a cancel overtakes other calls."""
        if isinstance(call, PlainCall) and call.call == "cancel":
            return await asyncio.to_thread(self._said, call.id, self.place.cancel)
        return await asyncio.get_running_loop().run_in_executor(
            self._calls, self._said_in_turn, call.id, self._does.handler(call)
        )

    def open(self, project: str) -> None:
        """Open a project, and draw what is not up to date. Raises InputError, ProjectLocked."""
        self.stop_drawing()
        self.begun = None
        try:
            self.place.open(project)
        finally:
            if self.place.is_open:
                self.begin_drawing(self.place.session)

    def begin(self, script: str) -> None:
        """Open the project that was made from a script of the folder; where there is none, make it.

        Raises:
            InputError: No such script.
            ProjectLocked: Another program has the project open.
        """
        project = self.place.project_of(script)
        if project in self.place.names()[1]:
            self.open(project)
        else:
            self.place.make(script, {})
            self.followed()

    def close(self) -> None:
        """End the work under way and close the project."""
        self.place.cancel()
        self.stop_drawing()
        self.place.close()
        self._calls.shutdown()
        self.uploads.forget()

    def _said_in_turn(self, number: int, call: Callable[[], Any]) -> Answer:
        try:
            return self._said(number, call)
        finally:
            if self._drawer is not None:
                self._drawer.go_on()

    def _said(self, number: int, call: Callable[[], Any]) -> Answer:
        try:
            return Answer(id=number, ok=True, value=call())
        except StoryBlenderError as error:
            return Answer(id=number, ok=False, error=self._worded(str(error)))
        except Exception:  # noqa: BLE001 - logged; the page goes on
            _LOG.exception("a call of the page failed")
            return Answer(id=number, ok=False, error="this failed, and should not have; the terminal says more")

    def _worded(self, sentence: str) -> str:
        """Return a sentence with the names of people and things in place of ids: the page shows no ids to type."""
        return plain(sentence, names_of(self.place.session.graph)) if self.place.is_open else sentence

    def followed(self) -> dict[str, Any]:
        """Return how far the work is that has just begun; the browsers hear of it until it ends."""
        threading.Thread(target=self._follow_work, name="work", daemon=True).start()
        return self.place.status.model_dump()

    def _follow_work(self) -> None:
        """Tell the browsers how far the work is until it ends."""
        while True:
            status = self.place.wait(0.5)
            self.tell(News(news="status", status=status))
            if not status.busy:
                break
        if not status.error or status.work.startswith("write "):
            self.begin_drawing(self.place.session)
        self.tell(News(news="board", revision=self.place.session.revision))

    @property
    def stale(self) -> frozenset[str]:
        """Names of the shots whose frames do not show the story as it is."""
        return self._drawer.stale if self._drawer is not None else frozenset()

    def draw(self, stale: Collection[str], first: str) -> None:
        """Draw shots, as soon as there is nothing to be edited.

        Args:
            stale: Those that show something else now.
            first: The one that a person looks at; may be empty.
        """
        if self._drawer is not None:
            for name in stale:
                self.previews.pop(name, None)
            self._drawer.draw(stale, first)

    def drawn_now(self, name: str) -> None:
        """Hear that a call drew the frame of a shot, and tell all browsers."""
        if self._drawer is not None:
            self._drawer.is_drawn(name)
        self.frames_drawn([name])

    def look_at(self, name: str) -> None:
        """Hear which shot a browser shows large: its preview is drawn before those of others."""
        if self._drawer is not None:
            self._drawer.look_at(name)

    def begin_drawing(self, session: Session) -> None:
        """Draw what is not up to date, and from now on what edits make stale."""
        self.previews, self.takes = {}, {}
        heard = (self._previewed, self.frames_drawn, self._failed, self._saved)
        self._drawer = Drawer(session, *heard) if session.made else None
        if self._drawer is not None:
            self._drawer.find_stale()

    def stop_drawing(self) -> None:
        """End drawing until it is begun again."""
        if self._drawer is not None:
            self._drawer.close()
            self._drawer = None

    def pause_drawing(self) -> None:
        """End the drawing under way, so that a call need not wait; it goes on at the end of the call."""
        if self._drawer is not None:
            self._drawer.pause()

    def refuse_busy(self) -> None:
        """Refuse a call while long work is under way. Raises InputError."""
        if self.place.status.busy:
            raise InputError(f"work is under way: {self.place.status.work}", mend="wait for it, or stop it")

    def _previewed(self, pictures: Mapping[str, Path]) -> None:
        self.previews |= pictures
        self.tell(News(news="frames", shots=tuple(pictures), revision=self.place.session.revision))

    def frames_drawn(self, names: Collection[str]) -> None:
        """Tell all browsers that frames are new."""
        self.tell(News(news="frames", shots=tuple(names), revision=self.place.session.revision))

    def _saved(self) -> None:
        self.tell(News(news="blender"))

    def _failed(self, why: str) -> None:
        self.tell(News(news="event", event=Event(kind="warning", role="frames", message=why)))

    def _hear(self, event: Event) -> None:
        if event.kind in _TOLD:
            self.tell(News(news="event", event=event.model_copy(update={"draft": "", "view": ""})))

    def tell(self, news: News) -> None:
        """Tell all browsers, from any thread."""
        for queue in list(self._browsers):
            assert self._loop is not None, "a browser joined in it"
            with suppress(RuntimeError):  # the loop ends with the server, and a thread may still have something to say
                self._loop.call_soon_threadsafe(queue.put_nowait, news)
