"""One small storyboard, made once for the tests that look at the result."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest
from typer.testing import CliRunner

from storyblender.cli import app

SCRIPT = """Title: Two Cups

INT. KITCHEN - DAY

ADA (60, grey hair in a bun, blue cardigan) sits at the table with a cup. TOM (25, brown jacket) stands by the window.

ADA
You came back.

TOM
I said I would.

Tom walks to the table.
"""

SMALL = ["--look", "fast", "--width", "320", "--quiet"]


def storyblender(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Run the command line in a process of its own, as a user does."""
    command = [sys.executable, "-m", "storyblender", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)


def typed(*words: str | Path) -> None:
    """Run a command that needs no Blender in this process, which starts at once."""
    done = CliRunner().invoke(app, [*map(str, words), "--quiet"])
    assert done.exit_code == 0, done.output[-2000:]


def made(arguments: Sequence[str | Path]) -> None:
    done = storyblender("make", *arguments)
    assert done.returncode == 0, done.stderr[-3000:]


@pytest.fixture(scope="session")
def script(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("script") / "two_cups.fountain"
    path.write_text(SCRIPT, encoding="utf-8")
    path.with_name("storyblender.toml").write_text("animatic_width = 160\n", encoding="utf-8")
    return path


@pytest.fixture(scope="session")
def untouched(script: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project as it was made; no test changes it."""
    folder = tmp_path_factory.mktemp("made") / "two_cups.storyboard"
    made([script, "--out", folder, *SMALL])
    return folder


@pytest.fixture(scope="module")
def project(untouched: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of it for the tests of a file, which may change it."""
    folder = tmp_path_factory.mktemp("copy") / untouched.name
    shutil.copytree(untouched, folder)
    return folder
