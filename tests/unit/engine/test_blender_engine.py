"""The engine's client side, without Blender."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from storyblender.engine.blender_engine import BlenderEngine
from storyblender.engine.worker import Worker
from storyblender.errors import EngineError
from storyblender.memory.jobs import PackRef, SceneJob
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
    ahead = Worker([sys.executable, "-uc", f"{talk}; input()"], tmp_path / "build" / "engine.log")
    ahead.start()
    pack = PackRef(scene_id=1, path="build/scenes/SC010-1.blend", starts=())
    with BlenderEngine(tmp_path, jobs=1, ahead=ahead) as engine:
        assert engine.measure_drift(pack).result(30) == 0.5
    with pytest.raises(EngineError, match="stopped"):
        ahead.call("measure_drift", {})


def test_a_pack_that_is_there_is_looked_up_without_blender(tmp_path: Path) -> None:
    job = SceneJob(scene=SceneContext(scene_id=3, setup=SceneSetup()), shots=(), assets=())
    reference = PackRef(scene_id=3, path=job.out, starts=((1, 1),))
    for name, content in ((job.out, "a pack"), (job.record, reference.model_dump_json())):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(content)
    with BlenderEngine(tmp_path, jobs=1) as engine:
        assert engine.pack_scene(job).result(0) == reference
    assert not (tmp_path / "build" / "engine.log").exists(), "Blender was started"
