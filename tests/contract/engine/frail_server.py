"""An MCP server over stdio that fails on request: the engine's client is tested against the real wire."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from fastmcp import FastMCP

server: FastMCP = FastMCP("frail")


@server.tool
async def add(a: int, b: int) -> int:
    return a + b


@server.tool
async def describe(name: str) -> dict[str, str]:
    return {"name": name, "pid": str(os.getpid())}


@server.tool
async def refuse() -> int:
    raise ValueError("the wall is in the way")


@server.tool
async def die(marker: str, times: int) -> str:
    """Die ``times`` times, then answer; the marker file counts over the lives."""
    path = Path(marker)
    lives = len(path.read_text()) if path.exists() else 0
    if lives < times:
        path.write_text("x" * (lives + 1))
        os._exit(139)
    return f"alive after {lives}"


if __name__ == "__main__":
    sys.stderr.write("started\n")
    server.run(show_banner=False)
