"""The engine's client side, without Blender."""

from __future__ import annotations

import sys
import threading
from concurrent.futures import CancelledError
from pathlib import Path
from typing import Any

import pytest

from storyblender.engine.blender_engine import BlenderEngine
from storyblender.engine.worker import ProgressListener, Worker, ignore_progress
from storyblender.errors import EngineError
from storyblender.folder import Folder
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.jobs import AssetJob, PackRef, SceneJob
from storyblender.memory.scene_context import SceneContext, SceneSetup


def test_the_log_holds_one_run_only(tmp_path: Path) -> None:
    log = tmp_path / "build" / "engine.log"
    log.parent.mkdir()
    log.write_text("an earlier run\n" * 1000)
    with BlenderEngine(tmp_path, jobs=1):
        assert log.read_text() == "", "nothing was said in this run yet"


def test_a_worker_that_is_ahead_is_the_one_that_works_and_is_ended(tmp_path: Path) -> None:
    answer = '{"id": %d, "result": {"structuredContent": {"result": 0.5}}}'
    talk = "; ".join(["input()", f"print('{answer % 1}', flush=True)", "input()", "input()", f"print('{answer % 2}')"])
    ahead = Worker([sys.executable, "-uc", f"{talk}; input()"], Folder(tmp_path))
    ahead.start()
    pack = PackRef(scene_id=1, path="build/scenes/SC010-1.blend", starts=())
    with BlenderEngine(tmp_path, jobs=1, ahead=ahead) as engine:
        assert engine.measure_drift(pack).result(30) == 0.5
    with pytest.raises(EngineError, match="stopped"):
        ahead.call("measure_drift", {})


class Builder(Worker):
    """Builds assets in any number of processes, and notes which; each waits until the gate is open."""

    def __init__(self, gate: threading.Event, built: list[str]) -> None:
        self._gate, self._built = gate, built

    def call(self, tool: str, arguments: dict[str, Any], progress: ProgressListener = ignore_progress) -> Any:
        self._built.append(arguments["job"]["asset"]["asset_id"])
        assert self._gate.wait(30)
        return {"asset_id": "thing", "digest": "d", "geometry_hash": "g", "dimensions": (1, 1, 1), "faces": 6}

    def close(self) -> None:
        self._gate.set()


def revolver(asset_id: str) -> AssetJob:
    canonical = CanonicalAsset(source="catalog", key="revolver", dimensions=(0.2, 0.05, 0.1), digest="")
    return AssetJob(asset=Asset(asset_id=asset_id, asset_type="object", description="", canonical=canonical))


def test_two_assets_of_one_recipe_are_built_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    gate, built = threading.Event(), list[str]()
    monkeypatch.setattr("storyblender.engine.blender_engine.blender_worker", lambda *_, **__: Builder(gate, built))
    with BlenderEngine(tmp_path, jobs=2) as engine:
        waiting = [engine.build_asset(revolver(name)) for name in ("gun", "pistol", "gun")]
        gate.set()
        assert len({future.result(30).digest for future in waiting}) == 1
        assert built == ["gun"]
        engine.build_asset(revolver("pistol")).result(30)
        assert built == ["gun", "pistol"], "what is done may be asked for again: its file may be gone"


def test_who_is_cancelled_waits_no_longer_and_the_next_one_gets_what_was_under_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    gate, built = threading.Event(), list[str]()
    monkeypatch.setattr("storyblender.engine.blender_engine.blender_worker", lambda *_, **__: Builder(gate, built))
    with BlenderEngine(tmp_path, jobs=1) as engine:
        first = engine.build_asset(revolver("gun"))
        while not built:
            pass
        engine.cancel_waiting()
        with pytest.raises(CancelledError):
            first.result(30)
        gate.set()
        assert engine.build_asset(revolver("gun")).result(30).digest == "d"
        assert built == ["gun"], "nothing is built twice for that"
        engine.build_asset(revolver("gun")).result(30)
        assert built == ["gun", "gun"], "what somebody got may be asked for again"


def test_what_is_in_front_waits_for_nothing_behind_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    gate, built, ways = threading.Event(), list[str](), list[bool]()

    def worker(*_: Any, gives_way: bool) -> Builder:
        ways.append(gives_way)
        return Builder(gate if gives_way else opened, built)

    opened = threading.Event()
    opened.set()
    monkeypatch.setattr("storyblender.engine.blender_engine.blender_worker", worker)
    with BlenderEngine(tmp_path, jobs=1) as engine:
        front = engine.front
        behind = engine.build_asset(revolver("gun"))
        assert front.build_asset(revolver("pistol")).result(30).digest == "d"
        assert not behind.done() and engine.front is front
        gate.set()
        behind.result(30)
        assert sorted(ways) == [False, True]


def test_a_rehearsal_is_never_an_earlier_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another scene may have been rehearsed in that process since."""
    gate, called = threading.Event(), list[str]()

    class Stager(Builder):
        def call(self, tool: str, arguments: dict[str, Any], progress: ProgressListener = ignore_progress) -> Any:
            called.append(tool)
            assert gate.wait(30)
            return {"scene_id": 1, "path": "a.blend", "starts": []}

    monkeypatch.setattr("storyblender.engine.blender_engine.blender_worker", lambda *_, **__: Stager(gate, called))
    setup = SceneSetup(time_of_day="day", scene_type="indoor", asset_ids=())
    job = SceneJob(scene=SceneContext(scene_id=1, setup=setup), shots=(), assets=())
    with BlenderEngine(tmp_path, jobs=1) as engine:
        first = engine.rehearse(job, [1])
        while not called:
            pass
        engine.cancel_waiting()
        with pytest.raises(CancelledError):
            first.result(30)
        gate.set()
        assert engine.rehearse(job, [1]).result(30).path == "a.blend"
        assert called == ["rehearse", "rehearse"]
