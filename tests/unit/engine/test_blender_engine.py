"""The engine's client side, without Blender."""

from __future__ import annotations

from pathlib import Path

from storyblender.engine.blender_engine import BlenderEngine


def test_the_log_holds_one_run_only(tmp_path: Path) -> None:
    log = tmp_path / "build" / "engine.log"
    log.parent.mkdir()
    log.write_text("an earlier run\n" * 1000)
    with BlenderEngine(tmp_path, jobs=1):
        assert not log.exists(), "nothing was said in this run yet"
