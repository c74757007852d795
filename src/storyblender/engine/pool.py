"""A pool of workers behind one queue. Jobs of one scene prefer the worker that has its pack open."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any, TypeVar

from storyblender.engine.worker import Worker

Result = TypeVar("Result")


class WorkerPool:
    """Runs tool calls on ``size`` Blender processes, started on first use.

    Args:
        make_worker: Starts nothing yet; the process comes with the first call.
        size: Processes; 0 takes one per processor, two at most.
    """

    def __init__(self, make_worker: Callable[[], Worker], size: int = 0) -> None:
        self.size = size or min(2, os.cpu_count() or 1)
        self._pending: list[tuple[str, Callable[[Worker], None]]] = []
        self._condition = threading.Condition()
        self._closing = False
        self._threads = [
            threading.Thread(target=self._serve, args=(make_worker,), name=f"blender-{index}", daemon=True)
            for index in range(self.size)
        ]
        for thread in self._threads:
            thread.start()

    def submit(
        self, tool: str, arguments: dict[str, Any], read: Callable[[Any], Result], *, affinity: str = ""
    ) -> Future[Result]:
        """Queue a call.

        Args:
            tool: Name of the worker's tool.
            arguments: JSON-ready arguments.
            read: Turns the structured answer into the result.
            affinity: Calls with equal affinity go to the same worker while it has others to choose from.
        """
        future: Future[Result] = Future()

        def run(worker: Worker) -> None:
            if not future.set_running_or_notify_cancel():
                return
            try:
                future.set_result(read(worker.call(tool, arguments)))
            except BaseException as error:  # noqa: BLE001 - carried to whoever waits for the future
                future.set_exception(error)

        with self._condition:
            self._pending.append((affinity, run))
            self._condition.notify()
        return future

    def close(self) -> None:
        """End the workers; jobs not begun are dropped."""
        with self._condition:
            self._closing = True
            self._pending.clear()
            self._condition.notify_all()
        for thread in self._threads:
            thread.join(timeout=30)

    def _serve(self, make_worker: Callable[[], Worker]) -> None:
        worker = make_worker()
        last = ""
        while True:
            with self._condition:
                self._condition.wait_for(lambda: self._pending or self._closing)
                if self._closing:
                    break
                index = next((i for i, (affinity, _) in enumerate(self._pending) if affinity == last), 0)
                last, run = self._pending.pop(index)
            run(worker)
        worker.close()
