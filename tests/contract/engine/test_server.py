"""The worker's own MCP server, spoken to by another's client: what is listed can be called, and errors are answers."""

from __future__ import annotations

import asyncio
import io
import json
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any, TypeVar

import pytest
from fastmcp import Client
from fastmcp.client.transports import StdioTransport
from fastmcp.exceptions import ToolError

from storyblender.blender.server import serve
from storyblender.engine.worker import Worker
from storyblender.folder import Folder

Result = TypeVar("Result")
SERVER = str(Path(__file__).with_name("small_server.py"))


def with_client(work: Callable[[Client[StdioTransport]], Awaitable[Result]]) -> Result:
    async def run() -> Result:
        async with Client(StdioTransport(sys.executable, [SERVER]), timeout=30) as client:
            return await work(client)

    return asyncio.run(run())


def test_tools_are_listed_with_their_arguments() -> None:
    async def work(client: Client[StdioTransport]) -> list[Any]:
        return await client.list_tools()

    tools = {tool.name: tool for tool in with_client(work)}
    assert set(tools) == {"scale", "refuse", "count"}
    assert tools["scale"].description == "Multiply a size."
    assert set(tools["scale"].input_schema["properties"]) == {"size", "factor"}


def test_a_call_gives_structure_models_are_read_and_what_a_tool_prints_is_not_on_the_wire() -> None:
    async def work(client: Client[StdioTransport]) -> Any:
        return await client.call_tool("scale", {"size": {"width": 2, "height": 3}, "factor": 2})

    assert with_client(work).structured_content == {"result": {"width": 4.0, "height": 6.0}}


@pytest.mark.parametrize(
    ("tool", "arguments", "words"),
    [("refuse", {}, "wall"), ("scale", {"factor": 2}, "size"), ("scale", {"size": {}, "factor": 2}, "width")],
)
def test_a_failure_is_an_answer_and_the_server_lives_on(tool: str, arguments: dict[str, Any], words: str) -> None:
    async def work(client: Client[StdioTransport]) -> Any:
        with pytest.raises(ToolError, match=words):
            await client.call_tool(tool, arguments)
        return await client.call_tool("scale", {"size": {"width": 1, "height": 1}, "factor": 1})

    assert with_client(work).structured_content["result"]["width"] == 1


def test_a_client_of_another_sdk_hears_the_progress_of_its_call() -> None:
    heard: list[tuple[float, float | None]] = []

    async def hear(step: float, total: float | None, _words: str | None) -> None:
        heard.append((step, total))

    async def work(client: Client[StdioTransport]) -> Any:
        return await client.call_tool("count", {"steps": 3}, progress_handler=hear)

    assert with_client(work).structured_content == {"result": 3}
    assert heard == [(1, 3), (2, 3), (3, 3)]


def test_our_client_hears_it_too(tmp_path: Path) -> None:
    heard: list[tuple[int, int]] = []
    worker = Worker([sys.executable, SERVER], Folder(tmp_path), timeout=30)
    try:
        assert worker.call("count", {"steps": 2}, lambda step, total: heard.append((step, total))) == 2
        assert worker.call("count", {"steps": 2}) == 2
    finally:
        worker.close()
    assert heard == [(1, 2), (2, 2)]


def test_nonsense_is_refused_and_notifications_want_no_answer() -> None:
    lines = [
        b"no message\n",
        b'{"jsonrpc": "2.0", "method": "notifications/initialized"}\n',
        b'{"jsonrpc": "2.0", "id": 1, "method": "ping"}\n',
        b'{"jsonrpc": "2.0", "id": 2, "method": "dance"}\n',
        b'{"jsonrpc": "2.0", "id": 3, "method": "tools/call", "params": {"name": "fly"}}\n',
    ]
    out = io.BytesIO()
    serve([], lines, out)
    answers = [json.loads(line) for line in out.getvalue().splitlines()]
    assert [answer["id"] for answer in answers] == [None, 1, 2, 3]
    assert answers[1]["result"] == {} and all("error" in answers[index] for index in (0, 2, 3))
