"""Runs the server over standard input and output, or over HTTP on this machine only."""

from __future__ import annotations

import asyncio
from pathlib import Path

from fastmcp.server.auth.providers.jwt import StaticTokenVerifier

from storyblender.mcp_server.server import build_server

LOOPBACK = "127.0.0.1"


def serve(folder: Path, port: int | None, token: str) -> None:
    """Serve until the client leaves, or for ever over HTTP; the open project is closed at the end.

    Args:
        folder: Of scripts and projects.
        port: For HTTP; None for standard input and output.
        token: That a client over HTTP must name.
    """
    server, place = build_server(folder)
    try:
        if port is None:
            asyncio.run(server.run_async(transport="stdio", show_banner=False))
        else:
            server.auth = StaticTokenVerifier({token: {"client_id": "agent", "scopes": ["storyboard"]}})
            log = {"log_level": "warning"}
            asyncio.run(
                server.run_async(transport="http", host=LOOPBACK, port=port, show_banner=False, uvicorn_config=log)
            )
    finally:
        place.cancel()
        place.close()
