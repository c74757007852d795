"""The command line answers quickly, because it loads nothing that it does not need."""

from __future__ import annotations

import subprocess
import sys

HEAVY = ("numpy", "av", "reportlab", "opentimelineio", "fastmcp", "onnxruntime", "pydantic", "bpy")


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys; from typer.testing import CliRunner; from storyblender.cli import app;"
        "done = CliRunner().invoke(app, ['--help']); assert done.exit_code == 0 and 'undo' in done.stdout;"
        f"print([name for name in {HEAVY!r} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"
