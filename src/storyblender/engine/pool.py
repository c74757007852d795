"""A pool of workers behind one queue. A worker is started when all others are busy, so a single job starts one only."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any, TypeVar

from storyblender.engine.worker import ProgressListener, Worker, ignore_progress
from storyblender.errors import EngineError

Result = TypeVar("Result")


class _Job:
    """A call in the queue."""

    def __init__(self, affinity: str, work: Callable[[Worker], Any]) -> None:
        self.affinity, self._work = affinity, work
        self.future: Future[Any] = Future()
        self._result: Any = None
        self._error: BaseException | None = None

    def run(self, worker: Worker) -> None:
        try:
            self._result = self._work(worker)
        except BaseException as error:  # noqa: BLE001 - re-raised where the future is awaited
            self._error = error

    def tell(self) -> None:
        """Give the result to who waits; only once the worker rests, so that the next call of the scene finds it."""
        if self._error is not None:
            self.future.set_exception(self._error)
        else:
            self.future.set_result(self._result)


class WorkerPool:
    """Runs tool calls on ``size`` Blender processes at most.

    Args:
        make_worker: Starts nothing yet; the process comes with the first call.
        size: Processes; 0 takes one per processor, two at most.
        ahead: A worker that was made before and is the first of them.
    """

    def __init__(self, make_worker: Callable[[], Worker], size: int = 0, ahead: Worker | None = None) -> None:
        self.size = size or min(2, os.cpu_count() or 1)
        self._make_worker = make_worker
        self._workers: list[Worker] = []
        self._resting: dict[Worker, str] = {}
        """Workers without a job, and the affinity of their last one."""
        self._pending: list[_Job] = []
        self._condition = threading.Condition()
        self._closing = False
        if ahead is not None:
            self._hire(ahead)

    def warm(self) -> None:
        """Start a first process now; it comes up while the caller prepares the first job."""
        with self._condition:
            if not self._workers:
                worker = self._make_worker()
                worker.start()
                self._hire(worker)

    def submit(
        self,
        tool: str,
        arguments: dict[str, Any],
        read: Callable[[Any], Result],
        *,
        affinity: str = "",
        progress: ProgressListener = ignore_progress,
    ) -> Future[Result]:
        """Queue a call.

        Args:
            tool: Name of the worker's tool.
            arguments: JSON-ready arguments.
            read: Turns the structured answer into the result.
            affinity: A call goes to the worker that had the last one of equal affinity, if that one rests.
            progress: Hears the steps of the call that are done, and their total, on the worker's thread.

        Raises:
            EngineError: The pool is closed.
        """

        def work(worker: Worker) -> Result:
            answer = worker.call(tool, arguments, progress)
            try:
                return read(answer)
            except (TypeError, ValueError) as error:
                raise EngineError(f"Blender's answer cannot be read ({error})", job=tool) from error

        job = _Job(affinity, work)
        with self._condition:
            if self._closing:
                raise EngineError("Blender was stopped", job=tool)
            self._pending.append(job)
            if len(self._pending) > len(self._resting) and len(self._workers) < self.size:
                self._hire(self._make_worker())
            self._condition.notify_all()
        return job.future

    def cancel_waiting(self) -> None:
        """Cancel the jobs not begun."""
        with self._condition:
            waiting, self._pending = self._pending, []
        for job in waiting:
            job.future.cancel()

    def close(self) -> None:
        """End the workers; jobs not begun are cancelled."""
        with self._condition:
            self._closing = True
            self._condition.notify_all()
        self.cancel_waiting()
        for worker in self._workers:
            worker.close()

    def _hire(self, worker: Worker) -> None:
        self._workers.append(worker)
        self._resting[worker] = ""
        threading.Thread(target=self._serve, args=(worker,), name="blender", daemon=True).start()

    def _serve(self, worker: Worker) -> None:
        while True:
            with self._condition:
                self._condition.wait_for(lambda: self._closing or self._choice(worker) is not None)
                choice = self._choice(worker)
                if choice is None or self._closing:
                    return
                job = self._pending.pop(choice)
                del self._resting[worker]
            job.run(worker)
            with self._condition:
                self._resting[worker] = job.affinity
                self._condition.notify_all()
            job.tell()

    def _choice(self, worker: Worker) -> int | None:
        """Index of the job that a resting worker takes: one of its scene, or one that no other resting worker has."""
        own = self._resting[worker]
        others = {last for other, last in self._resting.items() if other is not worker and last}
        same = (index for index, job in enumerate(self._pending) if job.affinity and job.affinity == own)
        free = (index for index, job in enumerate(self._pending) if job.affinity not in others)
        return next(same, next(free, None))
