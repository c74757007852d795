"""One Blender process, spoken to as an MCP server over its standard input and output.

A tool that fails raises EngineError; a process that dies is started again and the call is repeated, because every
tool is a pure function of its request and of files in the project folder. The client is written out here: the SDKs
cost two seconds of processor to import, in every command (measured); the tests hold it against one of them.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from storyblender.errors import EngineError

PROTOCOL = "2025-06-18"
"""Version of the Model Context Protocol."""
LOG = "build/engine.log"
"""Blender's words, in the project folder."""


class _Lost(Exception):
    """The process is gone, or says what is no message."""


class _Refused(Exception):
    """The server answered with an error."""


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
        self._process: subprocess.Popen[bytes] | None = None
        self._greeted = self._closed = False
        self._sent = 0

    def start(self) -> None:
        """Start the process, if it does not run, without waiting until it can take a call."""
        if self._process is None:
            self._log.parent.mkdir(parents=True, exist_ok=True)
            with self._log.open("ab") as log:
                self._process = subprocess.Popen(
                    self._command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log
                )
            if self._closed:  # meanwhile, from another thread
                self._end()

    def call(self, tool: str, arguments: dict[str, Any]) -> Any:
        """Call a tool and return its structured result.

        Raises:
            EngineError: The tool said no, the process died ``attempts`` times, or the worker was closed.
        """
        trouble: Exception | None = None
        for _ in range(self._attempts):
            if self._closed:
                raise EngineError(f"{tool}: Blender was stopped")
            try:
                result = self._request("tools/call", {"name": tool, "arguments": arguments})
            except _Refused as error:
                raise EngineError(f"{tool}: {error}") from error
            except (_Lost, OSError) as error:
                trouble = error
                self._end()
                continue
            if result.get("isError"):
                raise EngineError(f"{tool}: {' '.join(part.get('text', '') for part in result['content'])}")
            content = result.get("structuredContent") or {}
            return content["result"] if set(content) == {"result"} else content
        raise EngineError(f"{tool}: Blender died {self._attempts} times ({trouble})")

    def close(self) -> None:
        """End the process, from any thread; a call under way fails. Nothing is left half-written: tools rename."""
        self._closed = True
        self._end()

    def _end(self) -> None:
        process, self._process, self._greeted = self._process, None, False
        if process is not None:
            process.kill()
            process.wait()

    def _request(self, method: str, parameters: dict[str, Any]) -> dict[str, Any]:
        self.start()
        if not self._greeted:
            client = {"name": "storyblender", "version": "1"}
            self._exchange("initialize", {"protocolVersion": PROTOCOL, "capabilities": {}, "clientInfo": client})
            self._send({"method": "notifications/initialized"})
            self._greeted = True
        return self._exchange(method, parameters)

    def _exchange(self, method: str, parameters: dict[str, Any]) -> dict[str, Any]:
        """Send a request and wait for its answer; whatever else the server says meanwhile is passed over."""
        process = self._process
        if process is None or process.stdout is None:
            raise _Lost("stopped")
        self._sent += 1
        self._send({"id": self._sent, "method": method, "params": parameters})
        alarm = threading.Timer(self._timeout, process.kill)
        alarm.daemon = True
        alarm.start()
        try:
            while line := process.stdout.readline():
                message = _read(line)
                if message.get("id") == self._sent and "method" not in message:
                    if "error" in message:
                        raise _Refused(message["error"].get("message", "refused"))
                    return message["result"]
        finally:
            alarm.cancel()
        raise _Lost(f"exit {process.wait()}")

    def _send(self, message: dict[str, Any]) -> None:
        process = self._process
        if process is None or process.stdin is None:
            raise _Lost("stopped")
        process.stdin.write(json.dumps({"jsonrpc": "2.0", **message}).encode() + b"\n")
        process.stdin.flush()


def blender_worker(root: Path, models: Path | None = None) -> Worker:
    """Return a Blender worker, not started yet.

    Args:
        root: The project folder it may write to.
        models: The user's folder of models it may read.
    """
    root = root.resolve()
    command = [sys.executable, "-m", "storyblender.blender", "--root", str(root)]
    return Worker(command if models is None else [*command, "--models", str(models)], root / LOG)


def _read(line: bytes) -> dict[str, Any]:
    try:
        return json.loads(line)
    except ValueError as error:
        raise _Lost(f"no message: {line[:80]!r}") from error
