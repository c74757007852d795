"""The worker client and the pool over the real MCP wire: answers, refusals, crashes, spread of work."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from storyblender.engine.pool import WorkerPool
from storyblender.engine.worker import Worker
from storyblender.errors import EngineError
from storyblender.folder import Folder

SERVER = [sys.executable, str(Path(__file__).with_name("frail_server.py"))]


@pytest.fixture
def worker(tmp_path: Path) -> Iterator[Worker]:
    worker = Worker(SERVER, Folder(tmp_path), attempts=3, timeout=30)
    yield worker
    worker.close()


def test_answers_are_structured(worker: Worker) -> None:
    assert worker.call("add", {"a": 2, "b": 3}) == 5
    assert worker.call("describe", {"name": "rick"})["name"] == "rick"


def test_a_refusal_is_an_error_and_not_repeated(worker: Worker) -> None:
    first = worker.call("describe", {"name": ""})["pid"]
    with pytest.raises(EngineError, match="the wall is in the way"):
        worker.call("refuse", {})
    assert worker.call("describe", {"name": ""})["pid"] == first


def test_bad_arguments_name_the_field(worker: Worker) -> None:
    with pytest.raises(EngineError, match="b"):
        worker.call("add", {"a": 2})


def test_a_crash_is_survived(worker: Worker, tmp_path: Path) -> None:
    assert worker.call("die", {"marker": str(tmp_path / "lives"), "times": 2}) == "alive after 2"


def test_a_call_that_always_crashes_is_given_up(worker: Worker, tmp_path: Path) -> None:
    with pytest.raises(EngineError, match="died 3 times"):
        worker.call("die", {"marker": str(tmp_path / "lives"), "times": 9})
    assert worker.call("add", {"a": 1, "b": 1}) == 2


def test_the_pool_uses_all_workers_and_returns_every_result(tmp_path: Path) -> None:
    pool = WorkerPool(lambda: Worker(SERVER, Folder(tmp_path), timeout=30), size=2)
    try:
        futures = [pool.submit("describe", {"name": str(index)}, dict) for index in range(12)]
        failing = pool.submit("refuse", {}, int)
        results = [future.result(timeout=60) for future in futures]
        assert [result["name"] for result in results] == [str(index) for index in range(12)]
        assert len({result["pid"] for result in results}) <= 2
        with pytest.raises(EngineError):
            failing.result(timeout=60)
    finally:
        pool.close()
