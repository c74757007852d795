"""A run of the command line, watched from outside: what stages took, what processes held, where it was killed."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

EVERY = 0.5
"""Seconds between two looks at the processes."""
MIB = 1024


@dataclass
class Watch:
    """What was seen of one run.

    Attributes:
        seconds: Wall time.
        processor: Seconds of processor that each process took, by its number; what it took last may be missing.
        code: Exit status; negative for the signal that ended it.
        stages: Wall seconds of each stage.
        client: Peak resident memory of the client, MiB.
        workers: Peak resident memory of each Blender process, MiB.
        silence: Longest time between two lines of progress, seconds, and the stage it was in.
    """

    seconds: float = 0.0
    processor: dict[int, float] = field(default_factory=dict)
    code: int = 0
    stages: dict[str, float] = field(default_factory=dict)
    client: float = 0.0
    workers: dict[int, float] = field(default_factory=dict)
    silence: tuple[float, str] = (0.0, "")


def watched(arguments: list[str], kill_at: tuple[str, float] | None = None) -> Watch:
    """Run ``storyblender ARGUMENTS`` and watch it.

    Args:
        arguments: Without ``--json``, which is added.
        kill_at: A stage, and the share of its steps at which the run and its workers are killed.
    """
    watch, start = Watch(), time.perf_counter()
    command = [sys.executable, "-m", "storyblender", *arguments, "--json"]
    run = subprocess.Popen(command, start_new_session=True, stdout=subprocess.PIPE)
    ended = threading.Event()
    sampler = threading.Thread(target=_sample, args=(watch, run.pid, ended), daemon=True)
    sampler.start()
    assert run.stdout is not None
    stage, since = "start", start
    for line in run.stdout:
        event = _stage_event(line)
        now = time.perf_counter()
        watch.stages[stage] = watch.stages.get(stage, 0.0) + now - since
        watch.silence = max(watch.silence, (now - since, stage))
        since = now
        if event is None:
            continue
        stage = str(event["role"])
        if kill_at is not None and stage == kill_at[0] and event.get("step", 0) >= kill_at[1] * event["total"]:
            os.killpg(run.pid, signal.SIGKILL)
            break
    watch.code = run.wait()
    watch.seconds = time.perf_counter() - start
    ended.set()
    sampler.join()
    return watch


def _stage_event(line: bytes) -> dict[str, Any] | None:
    event = json.loads(line).get("event", {})
    return event if event.get("kind") == "stage" and event.get("total") else None


def _sample(watch: Watch, client: int, ended: threading.Event) -> None:
    while not ended.wait(EVERY):
        watch.client = max(watch.client, _peak_memory(client))
        workers = _children(client)
        for worker in workers:
            watch.workers[worker] = max(watch.workers.get(worker, 0.0), _peak_memory(worker))
        for process in (client, *workers):
            watch.processor[process] = max(watch.processor.get(process, 0.0), _processor(process))


def _children(process: int) -> list[int]:
    try:
        tasks = list(Path(f"/proc/{process}/task").iterdir())
        return [int(child) for task in tasks for child in (task / "children").read_text().split()]
    except OSError:
        return []


def _peak_memory(process: int) -> float:
    """Return the most memory that a process has held so far, resident, in MiB; 0 if it is gone."""
    try:
        status = Path(f"/proc/{process}/status").read_text()
    except OSError:
        return 0.0
    lines = (line.split() for line in status.splitlines() if line.startswith("VmHWM"))
    return next((int(line[1]) / MIB for line in lines), 0.0)


def _processor(process: int) -> float:
    """Return the seconds of processor that a process has taken so far; 0 if it is gone."""
    try:
        fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
