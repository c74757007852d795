"""One Blender process, spoken to as an MCP server over its standard input and output.

A tool that fails raises EngineError; a process that dies, hangs or talks nonsense is started again and the call is
repeated, because every tool is a pure function of its request and of files in the project folder. The client is written
out here and in ``wire``: the SDKs cost two seconds of processor to import, in every command (measured); the tests hold
it against one of them.
"""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from io import FileIO
from pathlib import Path
from typing import Any

from storyblender.engine.wire import LONGEST, PROTOCOL, Lost, Refused, answer_in, progress_in, request_line, value_in
from storyblender.errors import EngineError, InputError
from storyblender.folder import Folder

LOG = "build/engine.log"
"""Blender's words, in the project folder."""
_PARTING = 5.0
"""Seconds that a process which closed its output may take to end by itself."""
ProgressListener = Callable[[int, int], None]
"""Hears how many steps of a job are done, and how many there are."""


def ignore_progress(step: int, total: int) -> None:
    """A progress listener that ignores everything."""


class Worker:
    """A supervised worker process.

    Args:
        command: Starts the server; its first word is the program.
        files: The folder with the log, where the process's standard error goes.
        attempts: Starts per call before giving up.
        timeout: Seconds that one attempt at a call may take, from the start of the process to the end of the answer.
    """

    def __init__(self, command: Sequence[str], files: Folder, *, attempts: int = 3, timeout: float = 900) -> None:
        self._command, self._files = command, files
        self._attempts, self._timeout = attempts, timeout
        self._process: subprocess.Popen[bytes] | None = None
        self._greeted = self._closed = False
        self._sent = 0

    def start(self) -> None:
        """Start the process, if it does not run, without waiting until it can take a call."""
        if self._process is None:
            with _log_of(self._files) as log:
                self._process = subprocess.Popen(
                    self._command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log
                )
            if self._closed:  # meanwhile, from another thread
                self._end()

    def call(self, tool: str, arguments: dict[str, Any], progress: ProgressListener = ignore_progress) -> Any:
        """Call a tool and return its structured result.

        Args:
            tool: Its name.
            arguments: JSON-ready.
            progress: Hears the steps that are done; again from the first if the process had to be restarted.

        Raises:
            EngineError: The tool said no, the process died ``attempts`` times, or the worker was closed.
        """
        trouble: Exception | None = None
        for _ in range(self._attempts):
            if self._closed:
                raise EngineError("Blender was stopped", job=tool)
            try:
                return value_in(self._request("tools/call", {"name": tool, "arguments": arguments}, progress))
            except Refused as error:
                raise EngineError(str(error), job=tool) from error
            except (Lost, OSError) as error:
                trouble = error
                self._end()
        raise EngineError(f"Blender died {self._attempts} times ({trouble})", job=tool)

    def close(self) -> None:
        """End the process, from any thread; a call under way fails. Nothing is left half-written: tools rename."""
        self._closed = True
        self._end()

    def _end(self) -> None:
        process, self._process, self._greeted = self._process, None, False
        if process is not None:
            process.kill()
            process.wait()

    def _request(
        self, method: str, parameters: dict[str, Any], progress: ProgressListener = ignore_progress
    ) -> dict[str, Any]:
        """Initialize the server on the first request, send the request and return the answer, within the timeout."""
        self.start()
        process, late = self._process, threading.Event()
        if process is None:
            raise Lost("stopped")

        def stop() -> None:
            late.set()
            process.kill()  # a blocked read or write then ends with the pipe

        alarm = threading.Timer(self._timeout, stop)
        alarm.daemon = True
        alarm.start()
        try:
            if not self._greeted:
                client = {"name": "storyblender", "version": "1"}
                greeting = {"protocolVersion": PROTOCOL, "capabilities": {}, "clientInfo": client}
                self._exchange(process, "initialize", greeting)
                _send(process, {"method": "notifications/initialized"})
                self._greeted = True
            return self._exchange(process, method, parameters, progress)
        except (Lost, OSError) as error:
            if late.is_set():
                raise Lost(f"no answer within {self._timeout:g} s") from error
            raise
        finally:
            alarm.cancel()

    def _exchange(
        self,
        process: subprocess.Popen[bytes],
        method: str,
        parameters: dict[str, Any],
        progress: ProgressListener = ignore_progress,
    ) -> dict[str, Any]:
        """Send a request and wait for its answer; of what else the server says only its progress is heard."""
        assert process.stdout is not None, "started with pipes"
        self._sent += 1
        if method == "tools/call":
            parameters = {**parameters, "_meta": {"progressToken": self._sent}}
        _send(process, {"id": self._sent, "method": method, "params": parameters})
        while line := process.stdout.readline(LONGEST + 1):
            result = answer_in(line, self._sent)
            if result is not None:
                return result
            if (done := progress_in(line, self._sent)) is not None:
                progress(*done)
        try:
            raise Lost(f"exit {process.wait(_PARTING)}")
        except subprocess.TimeoutExpired as error:
            raise Lost("it closed its output") from error


def blender_worker(
    root: Path, models: Sequence[Path] = (), build: Path | None = None, *, gives_way: bool = False
) -> Worker:
    """Return a Blender worker, not started yet.

    Args:
        root: The project folder it may write to.
        models: The user's folders of models, which it may read.
        build: Where names below ``build/`` lie instead.
        gives_way: Whether it takes only the processor time that others leave.
    """
    files = Folder(root, build)
    command = [sys.executable, "-m", "storyblender.blender", "--root", str(files.root)]
    for folder in models:
        command += ["--models", str(folder)]
    command += ["--build", str(build)] if build is not None else []
    command += ["--give-way"] if gives_way else []
    return Worker(command, files)


def _log_of(files: Folder) -> FileIO:
    """Return the log file; where it cannot be opened (full disk), the worker runs without one."""
    try:
        return files.log(LOG)
    except InputError as error:
        if not isinstance(error.__cause__, OSError):
            raise
        return FileIO(os.devnull, "wb")


def _send(process: subprocess.Popen[bytes], message: dict[str, Any]) -> None:
    assert process.stdin is not None, "started with pipes"
    process.stdin.write(request_line(message))
    process.stdin.flush()
