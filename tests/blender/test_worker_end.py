"""How the worker ends: when its client is gone, at once and for good."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path


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
