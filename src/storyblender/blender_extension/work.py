"""Calls to the program are made on a thread of their own, one after the other; Blender's own thread hears what came."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from queue import Empty, SimpleQueue
from typing import Any, NamedTuple

import bpy

from .connection import NotDone

_OFTEN = 0.2
"""Seconds between two looks at what came."""

Finish = Callable[[], None]


class _Task(NamedTuple):
    what: str
    call: Callable[[], Any]
    then: Callable[[Any], None]
    failed: Callable[[str], None]


class Work:
    """What is under way.

    Attributes:
        doing: What the person waits for, in words, in order.
    """

    def __init__(self) -> None:
        self.doing: list[str] = []
        self._waiting = 0
        self._calls: SimpleQueue[_Task] = SimpleQueue()
        self._finished: SimpleQueue[tuple[_Task, Finish]] = SimpleQueue()
        self._thread: threading.Thread | None = None

    def begin(
        self, what: str, call: Callable[[], Any], then: Callable[[Any], None], failed: Callable[[str], None]
    ) -> None:
        """Make a call when those before it are done.

        Args:
            what: What it is, in words; empty for what the person does not wait for.
            call: Made on the thread; it must not touch Blender.
            then: Hears what it returned, on Blender's thread.
            failed: Hears why it was not done, in a sentence, likewise.
        """
        if what:
            self.doing.append(what)
        self._waiting += 1
        self._calls.put(_Task(what, call, then, failed))
        if self._thread is None:
            self._thread = threading.Thread(target=self._run, name="storyblender", daemon=True)
            self._thread.start()
        if not bpy.app.timers.is_registered(self.look):
            bpy.app.timers.register(self.look, first_interval=_OFTEN, persistent=True)

    def look(self) -> float | None:
        """Finish what came meanwhile, and return the seconds until the next look; None if nothing is under way."""
        with suppress(Empty):
            while True:
                task, finish = self._finished.get_nowait()
                self._waiting -= 1
                if task.what:
                    self.doing.remove(task.what)
                finish()
        redraw()
        return _OFTEN if self._waiting else None

    def forget(self) -> None:
        """Hear no more of what is under way."""
        if bpy.app.timers.is_registered(self.look):
            bpy.app.timers.unregister(self.look)

    @property
    def under_way(self) -> bool:
        """Whether anything is."""
        return self._waiting > 0

    def _run(self) -> None:
        while True:
            task = self._calls.get()
            try:
                finish = partial(task.then, task.call())
            except NotDone as error:
                finish = partial(task.failed, str(error))
            except Exception as error:  # noqa: BLE001 - told; the panel goes on
                finish = partial(task.failed, f"this failed, and should not have: {error}")
            self._finished.put((task, finish))


def redraw() -> None:
    """Draw the panel anew, wherever it is shown."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


WORK = Work()
"""All of the extension's."""
