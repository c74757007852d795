"""The bridge between the server's threads and Blender: bpy is only ever touched on the main thread."""

from __future__ import annotations

import queue
from collections.abc import Callable
from concurrent.futures import Future
from typing import TypeVar

Result = TypeVar("Result")


class MainThread:
    """A queue of calls that ``run`` executes one after the other."""

    def __init__(self) -> None:
        self._calls: queue.SimpleQueue[Callable[[], None] | None] = queue.SimpleQueue()

    def submit(self, call: Callable[[], Result]) -> Future[Result]:
        """Queue a call from any thread; its result or exception arrives in the future."""
        future: Future[Result] = Future()

        def run() -> None:
            try:
                future.set_result(call())
            except BaseException as error:  # noqa: BLE001 - carried to the caller's thread, raised there
                future.set_exception(error)

        self._calls.put(run)
        return future

    def run(self) -> None:
        """Execute queued calls until ``close``."""
        while (call := self._calls.get()) is not None:
            call()

    def close(self) -> None:
        """End ``run`` after the calls queued so far."""
        self._calls.put(None)
