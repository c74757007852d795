"""One Blender process and its MCP client, called from ordinary threads.

A tool that fails raises EngineError; a process that dies is started again and the call is repeated, because every
tool is a pure function of its request and of files in the project folder.
"""

from __future__ import annotations

import asyncio
import os
import sys
import threading
from collections.abc import Coroutine, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from storyblender.errors import EngineError

if TYPE_CHECKING:
    from fastmcp import Client
    from fastmcp.client.transports import StdioTransport


class Worker:
    """A supervised worker process.

    Args:
        command: Starts the server; its first word is the program.
        log: Where the process's standard error goes.
        attempts: Starts per call before giving up.
        timeout: Seconds one call may take.
    """

    def __init__(self, command: Sequence[str], log: Path, *, attempts: int = 3, timeout: float = 900) -> None:
        self._command, self._log = command, log
        self._attempts, self._timeout = attempts, timeout
        self._client: Client[StdioTransport] | None = None
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="engine-client", daemon=True)
        self._thread.start()

    def call(self, tool: str, arguments: dict[str, Any]) -> Any:
        """Call a tool and return its structured result.

        Raises:
            EngineError: The tool said no, or the process died ``attempts`` times.
        """
        # Importing the client takes over a second; only work for Blender is worth it, and only on the worker's thread.
        from fastmcp.exceptions import ToolError

        trouble = ""
        for _ in range(self._attempts):
            try:
                return self._wait(self._call(tool, arguments))
            except ToolError as error:
                raise EngineError(f"{tool}: {error}") from error
            except Exception as error:  # noqa: BLE001 - the transport raises many kinds; all mean a lost process
                trouble = f"{type(error).__name__}: {error}"
                self._wait(self._disconnect())
        raise EngineError(f"{tool}: Blender died {self._attempts} times ({trouble})")

    def close(self) -> None:
        """End the process."""
        self._wait(self._disconnect())
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join(timeout=5)

    def _wait(self, work: Coroutine[Any, Any, Any]) -> Any:
        return asyncio.run_coroutine_threadsafe(work, self._loop).result()

    async def _call(self, tool: str, arguments: dict[str, Any]) -> Any:
        if self._client is None:
            from fastmcp import Client

            self._client = Client(self._transport(), timeout=self._timeout)
            await self._client.__aenter__()
        result = await self._client.call_tool(tool, arguments, timeout=self._timeout)
        content = result.structured_content or {}
        return content["result"] if set(content) == {"result"} else content

    async def _disconnect(self) -> None:
        client, self._client = self._client, None
        if client is None:
            return
        try:
            await asyncio.wait_for(client.__aexit__(None, None, None), timeout=10)
        except Exception:  # noqa: BLE001 - the process is gone or going; nothing is left to close
            return

    def _transport(self) -> StdioTransport:
        from fastmcp.client.transports import StdioTransport

        self._log.parent.mkdir(parents=True, exist_ok=True)
        program, *arguments = self._command
        return StdioTransport(program, arguments, env=dict(os.environ), keep_alive=False, log_file=self._log)


def blender_command(root: Path, models: Path | None = None) -> list[str]:
    """Return the command of a Blender worker.

    Args:
        root: The project folder it may write to.
        models: The user's folder of models it may read.
    """
    command = [sys.executable, "-m", "storyblender.blender", "--root", str(root)]
    return command if models is None else [*command, "--models", str(models)]
