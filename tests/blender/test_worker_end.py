"""How the worker ends: when its client is gone, at once and for good."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest


def test_a_worker_whose_client_does_not_listen_any_more_ends(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "storyblender.blender", "--root", str(tmp_path)]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe) as worker:
        assert worker.stdin is not None and worker.stdout is not None
        worker.stdout.close()
        worker.stdin.write(json.dumps({"jsonrpc": "2.0", "id": 1, "method": "tools/list"}).encode() + b"\n")
        worker.stdin.flush()
        try:
            assert worker.wait(timeout=60) == 1
        finally:
            worker.kill()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device that is always full")
def test_a_worker_whose_log_is_on_a_full_disk_answers_and_ends(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "storyblender.blender", "--root", str(tmp_path)]
    pack = {"scene_id": 1, "path": "none.blend", "starts": []}
    call = {"name": "measure_drift", "arguments": {"pack": pack}}
    pipe = subprocess.PIPE
    with (
        Path("/dev/full").open("wb") as full,
        subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=full) as worker,
    ):
        assert worker.stdin is not None and worker.stdout is not None
        try:
            for number in (1, 2):
                request = {"jsonrpc": "2.0", "id": number, "method": "tools/call", "params": call}
                worker.stdin.write(json.dumps(request).encode() + b"\n")
                worker.stdin.flush()
                assert json.loads(worker.stdout.readline())["result"]["isError"]
            worker.stdin.close()
            assert worker.wait(timeout=60) == 0
        finally:
            worker.kill()


CLIENT = """
import subprocess, sys
worker = subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
worker.stdin.write(b'{"jsonrpc": "2.0", "id": 1, "method": "ping"}\\n')
worker.stdin.flush()
worker.stdout.readline()
print(worker.pid, flush=True)
sys.stdin.read()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the system ends the worker")
def test_a_worker_that_hangs_ends_with_its_client(tmp_path: Path) -> None:
    command = [sys.executable, "-c", CLIENT, sys.executable, "-m", "storyblender.blender", "--root", str(tmp_path)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as client:
        assert client.stdout is not None
        worker = int(client.stdout.readline())
        os.kill(worker, signal.SIGSTOP)  # nothing in it runs any more, as in a call that never returns
        client.kill()
    deadline = time.monotonic() + 30
    while alive(worker) and time.monotonic() < deadline:
        time.sleep(0.1)
    assert not alive(worker)


def alive(process: int) -> bool:
    """Return whether a process runs; one that has ended and waits for its parent to ask does not."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(") ")[2][:1] != "Z"
    except OSError:
        return False
