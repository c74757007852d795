"""Clients that are not ours drive a whole session: make, status, look, edit, undo, export; HTTP asks for a token."""

from __future__ import annotations

import asyncio
import os
import socket
import subprocess
import sys
import urllib.error
from collections.abc import Awaitable, Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

from tests.e2e.raw_mcp import RawClient

pytestmark = pytest.mark.blender

TOKEN = "open sesame"
SCRIPT = """INT. BAR - NIGHT

ANNA (30, red coat) sits at a table. BEN comes in.

BEN
You came.

ANNA
I said I would.
"""
Call = Callable[..., Awaitable[Any]]
"""Calls a tool by its name and arguments: its structured answer, else its pictures as media type and data."""


async def whole_session(call: Call) -> dict[str, Any]:
    """Work as an agent would, and return what it was told."""
    told: dict[str, Any] = {}

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


def was_whole(told: dict[str, Any]) -> None:
    """Check what a whole session was told."""
    assert told["picture"][0] == "image/png"
    assert told["other"] != told["picture"], "the edit is seen"
    assert told["again"] == told["picture"], "undo brings the very picture back"
    assert told["checked"]["rows"]
    assert any(name.endswith(".glb") for name in told["exported"]["files"])


async def over_pipes(folder: Path) -> dict[str, Any]:
    """Work over standard input and output with the reference client."""
    arguments = ["-m", "storyblender", "mcp", str(folder)]
    server = StdioServerParameters(command=sys.executable, args=arguments, env=dict(os.environ))
    async with stdio_client(server) as (read, write), ClientSession(read, write) as client:
        await client.initialize()

        async def call(name: str, **arguments: Any) -> Any:
            answer = await client.call_tool(name, arguments)
            assert not answer.is_error, answer.content
            return answer.structured_content or [(each.mime_type, each.data) for each in answer.content]  # type: ignore[union-attr]

        return await whole_session(call)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of stories: what one client has made, another finds there."""
    return tmp_path_factory.mktemp("stories")


def test_a_whole_session_over_pipes(folder: Path) -> None:
    was_whole(asyncio.run(over_pipes(folder)))


@pytest.fixture
def port(folder: Path) -> Iterator[int]:
    """Run a server for the folder over HTTP, and return its port."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        number = free.getsockname()[1]
    command = [sys.executable, "-m", "storyblender", "mcp", str(folder), "--http", str(number)]
    with subprocess.Popen(command, env={**os.environ, "STORYBLENDER_TOKEN": TOKEN}, stderr=subprocess.PIPE) as server:
        try:
            yield number
        finally:
            server.terminate()


def test_a_whole_session_over_http_with_the_token_and_none_without(port: int) -> None:
    client = RawClient(port, TOKEN)
    assert client.begin()["capabilities"]["tools"] is not None
    offered = {tool["name"] for tool in client.ask("tools/list")["tools"]}

    async def call(name: str, **arguments: Any) -> Any:
        assert name in offered
        answer = client.ask("tools/call", {"name": name, "arguments": arguments})
        assert not answer.get("isError"), answer["content"]
        return answer.get("structuredContent") or [(each["mimeType"], each["data"]) for each in answer["content"]]

    was_whole(asyncio.run(whole_session(call)))
    for token in (None, "guess", TOKEN.upper(), TOKEN[:-1]):
        intruder = RawClient(port, token)
        for session in (None, client.session):
            intruder.session = session
            for method, params in (("initialize", {}), ("tools/call", {"name": "story", "arguments": {}})):
                with pytest.raises(urllib.error.HTTPError) as refused:
                    intruder.ask(method, params)
                assert refused.value.code == 401, (token, method)
                assert TOKEN not in str(refused.value.headers) + refused.value.read().decode("utf-8", "replace")
    assert client.ask("tools/call", {"name": "story", "arguments": {}})["structuredContent"]["shots"], "it still serves"
