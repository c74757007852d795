"""The command line answers quickly, because it loads nothing that it does not need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from storyblender.cli import app

HEAVY = ("numpy", "av", "reportlab", "opentimelineio", "fastmcp", "onnxruntime", "pydantic", "bpy")


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys; from typer.testing import CliRunner; from storyblender.cli import app;"
        "done = CliRunner().invoke(app, ['--help']); assert done.exit_code == 0 and 'undo' in done.stdout;"
        f"print([name for name in {HEAVY!r} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"


class Starter:
    """A worker of which only start and end are of interest."""

    def __init__(self) -> None:
        self.told: list[str] = []

    def start(self) -> None:
        self.told.append("start")

    def close(self) -> None:
        self.told.append("close")


def test_blender_comes_up_first_for_a_project_and_never_outlives_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    worker = Starter()
    monkeypatch.setattr("storyblender.engine.worker.blender_worker", lambda root: worker)
    assert CliRunner().invoke(app, ["check", str(tmp_path)]).exit_code == 2
    assert worker.told == [], "no project, no Blender"
    (tmp_path / "graph.json").write_text("{}")
    assert CliRunner().invoke(app, ["undo", str(tmp_path)]).exit_code == 2
    assert worker.told == [], "taking back draws nothing"
    for mistake in (["--look", "nope"], ["--lens", "long"], ["--nonsense"]):
        assert CliRunner().invoke(app, ["render", str(tmp_path), *mistake]).exit_code == 2
        assert worker.told == ["start", "close"], mistake
        worker.told.clear()
