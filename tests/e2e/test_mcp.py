"""A client that is not ours drives a whole session: make, look, edit, undo, export; and HTTP asks for a token."""

from __future__ import annotations

import asyncio
import os
import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path
from typing import Any

import pytest
from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

pytestmark = pytest.mark.blender

SCRIPT = """INT. BAR - NIGHT

ANNA (30, red coat) sits at a table. BEN comes in.

BEN
You came.

ANNA
I said I would.
"""


async def session_with(folder: Path) -> dict[str, Any]:
    """Work as an agent would, and return what it was told."""
    arguments = ["-m", "storyblender", "mcp", str(folder)]
    server = StdioServerParameters(command=sys.executable, args=arguments, env=dict(os.environ))
    told: dict[str, Any] = {}
    async with stdio_client(server) as (read, write), ClientSession(read, write) as client:
        await client.initialize()

        async def call(name: str, **arguments: Any) -> Any:
            answer = await client.call_tool(name, arguments)
            assert not answer.is_error, answer.content
            return answer.structured_content or answer.content

        async def finished() -> dict[str, Any]:
            while (status := await call("status", wait_seconds=20))["busy"]:
                pass
            assert not status["error"], status
            return status

        await call("make", script="bar.fountain", text=SCRIPT, look="fast", width=320)
        told["made"] = await finished()
        story = await call("story")
        shot = story["shots"][0]["shot"]
        [told["picture"]] = await call("look", shot=shot, width=160)
        told["before"] = await call("describe_shot", shot=shot)
        size = "ECU" if told["before"]["size"] != "ECU" else "WS"
        edits = [{"kind": "camera", "shot": shot, "decision": {"size": size}}]
        told["edited"] = await call("edit", edits=edits, revision=story["revision"])
        [told["other"]] = await call("look", shot=shot, width=160)
        await call("undo")
        await call("render", shots=[shot])
        await finished()
        [told["again"]] = await call("look", shot=shot, width=160)
        told["checked"] = await call("check")
        await call("export", kinds=["glb"])
        told["exported"] = await finished()
    return told


def test_another_client_makes_looks_edits_undoes_and_exports(tmp_path: Path) -> None:
    told = asyncio.run(session_with(tmp_path))
    assert told["picture"].mime_type == "image/png"
    assert told["other"].data != told["picture"].data, "the edit is seen"
    assert told["again"].data == told["picture"].data, "undo brings the very picture back"
    assert told["checked"]["rows"]
    assert any(name.endswith(".glb") for name in told["exported"]["files"])


def test_over_http_nobody_comes_in_without_the_token(tmp_path: Path) -> None:
    port, environment = "18765", {**os.environ, "STORYBLENDER_TOKEN": "open sesame"}
    command = [sys.executable, "-m", "storyblender", "mcp", str(tmp_path), "--http", port]
    with subprocess.Popen(command, env=environment, stderr=subprocess.PIPE) as server:
        try:
            codes = [status_of(port, token) for token in (None, "guess", "open sesame")]
        finally:
            server.terminate()
    assert codes[:2] == [401, 401] and codes[2] != 401


def status_of(port: str, token: str | None) -> int:
    """Return the HTTP status that a request gets; waits until the server listens."""
    headers = {"Authorization": f"Bearer {token}"} if token else {}
    headers |= {"Content-Type": "application/json", "Accept": "application/json, text/event-stream"}
    request = urllib.request.Request(f"http://127.0.0.1:{port}/mcp", data=b"{}", headers=headers)
    for _ in range(300):
        try:
            with urllib.request.urlopen(request, timeout=10) as answer:
                return answer.status
        except urllib.error.HTTPError as error:
            return error.code
        except OSError:
            time.sleep(0.2)
    raise TimeoutError("the server does not listen")
