"""The pool: a worker more only when all are busy, and a scene's jobs stay with the worker that has it open."""

from __future__ import annotations

import threading
from typing import Any

import pytest

from storyblender.engine.pool import WorkerPool
from storyblender.engine.worker import ProgressListener, Worker, ignore_progress
from storyblender.errors import EngineError
from storyblender.memory.measure import AssetMeasure


class Idler(Worker):
    """Answers with its number, once ``gate`` is open."""

    made: list[Idler]
    gate: threading.Event

    def __init__(self) -> None:
        self.number, self.begun = len(self.made), False
        self.made.append(self)

    def start(self) -> None:
        self.begun = True

    def call(self, tool: str, arguments: dict[str, Any], progress: ProgressListener = ignore_progress) -> Any:
        if tool == "fail":
            raise EngineError("no")
        assert self.gate.wait(10)
        return self.number

    def close(self) -> None:
        self.gate.set()


@pytest.fixture
def pool() -> WorkerPool:
    Idler.made, Idler.gate = [], threading.Event()
    return WorkerPool(Idler, size=2)


def test_nothing_is_made_until_it_is_needed_and_then_one_only(pool: WorkerPool) -> None:
    assert not Idler.made
    pool.warm()
    pool.warm()
    assert [worker.begun for worker in Idler.made] == [True]
    Idler.gate.set()
    assert [pool.submit("go", {}, int).result(10) for _ in range(5)] == [0] * 5
    assert len(Idler.made) == 1
    pool.close()


def test_a_second_one_comes_when_the_first_is_busy_and_never_a_third(pool: WorkerPool) -> None:
    waiting = [pool.submit("go", {}, int) for _ in range(6)]
    assert len(Idler.made) == 2
    Idler.gate.set()
    assert {future.result(10) for future in waiting} <= {0, 1}
    pool.close()


def test_a_scene_stays_with_its_worker(pool: WorkerPool) -> None:
    first = pool.submit("go", {}, int, affinity="scene1")
    second = pool.submit("go", {}, int, affinity="scene2")
    Idler.gate.set()
    home = {"scene1": first.result(10), "scene2": second.result(10)}
    for scene in ("scene2", "scene2", "scene1", "scene2", "scene1"):
        if len(set(home.values())) == 2:
            assert pool.submit("go", {}, int, affinity=scene).result(10) == home[scene]
    pool.close()


def test_a_failure_is_carried_and_the_worker_goes_on(pool: WorkerPool) -> None:
    Idler.gate.set()
    with pytest.raises(EngineError, match="no"):
        pool.submit("fail", {}, int).result(10)
    assert pool.submit("go", {}, int).result(10) == 0
    pool.close()


def test_what_is_not_begun_is_dropped_at_the_end(pool: WorkerPool) -> None:
    waiting = [pool.submit("go", {}, int) for _ in range(5)]
    pool.close()
    assert sum(future.cancelled() for future in waiting) >= 3
    with pytest.raises(EngineError, match="stopped"):
        pool.submit("go", {}, int)


def test_an_answer_that_cannot_be_read_is_an_engine_error(pool: WorkerPool) -> None:
    Idler.gate.set()
    with pytest.raises(EngineError, match="go: Blender's answer cannot be read"):
        pool.submit("go", {}, AssetMeasure.model_validate).result(10)
    assert pool.submit("go", {}, int).result(10) == 0
    pool.close()


def test_cancelled_jobs_never_begin_and_the_pool_goes_on(pool: WorkerPool) -> None:
    jobs = [pool.submit("go", {}, int) for _ in range(8)]
    while len(pool._pending) > 6:  # until both workers have begun one
        threading.Event().wait(0.01)
    pool.cancel_waiting()
    Idler.gate.set()
    assert sum(job.cancelled() for job in jobs) == 6
    assert {job.result(10) for job in jobs if not job.cancelled()} == {0, 1}
    assert pool.submit("go", {}, int).result(10) in (0, 1)
    pool.close()
