"""kill -9 at any moment, then the same command again: the same storyboard as an undisturbed run."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from storyblender.project import read_project_graph
from tests.e2e.conftest import SMALL, made

pytestmark = [pytest.mark.blender, pytest.mark.timeout(1500)]


def kill_at(files: int, folder: Path, arguments: list[str]) -> bool:
    """Start a run in a process group of its own and kill the whole group once its project has that many files.

    Returns:
        False if it had ended by then.
    """
    command = [sys.executable, "-m", "storyblender", "make", *arguments]
    run = subprocess.Popen(command, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while run.poll() is None and count(folder) < files:
        time.sleep(0.05)
    alive = run.poll() is None
    if alive:
        os.killpg(run.pid, signal.SIGKILL)
    run.wait()
    return alive


def count(folder: Path) -> int:
    """Return how many files there are, without those of the moving frames, which this run makes none of."""
    return sum(len(files) for path, _, files in os.walk(folder) if "motion" not in Path(path).parts)


def same(first: Path, second: Path) -> None:
    assert read_project_graph(first) == read_project_graph(second)
    frames = sorted((first / "frames").glob("SC*.png"))
    assert frames
    for frame in frames:
        assert frame.read_bytes() == (second / "frames" / frame.name).read_bytes(), frame.name


@pytest.mark.parametrize(
    "kills",
    [pytest.param(2, id="two"), pytest.param(10, id="ten", marks=pytest.mark.slow)],
)
def test_a_killed_run_goes_on_to_the_same_result(script: Path, untouched: Path, tmp_path: Path, kills: int) -> None:
    broken = tmp_path / "broken"
    arguments = [str(script), *SMALL, "--no-animatic", "--out", str(broken)]
    moments = random.Random(kills)
    shares = sorted(moments.uniform(0.05, 0.75) for _ in range(kills))
    killed = sum(kill_at(round(share * count(untouched)), broken, arguments) for share in shares)
    assert killed >= 1
    made(arguments)
    same(untouched, broken)
