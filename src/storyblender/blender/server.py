"""The MCP server: a closed set of typed tools over lines of JSON. No tool runs code.

Blender is only touched on the main thread, which serves: calls are handled one after the other. The protocol is
implemented here because the SDKs cost a second and a half of processor time to import, at every start of a worker
(measured); in the tests an SDK's client lists and calls the tools.
"""

from __future__ import annotations

import json
import os
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import cached_property
from inspect import getdoc, signature
from typing import Any, BinaryIO, get_type_hints

from pydantic import BaseModel, ConfigDict, create_model
from pydantic_core import to_jsonable_python

from storyblender import __version__
from storyblender.blender.progress import Progress

PROTOCOLS = ("2024-11-05", "2025-03-26", "2025-06-18", "2025-11-25")
"""Supported versions of the Model Context Protocol; other clients are offered the newest."""
PARSE_ERROR, INVALID_REQUEST, METHOD_NOT_FOUND, INVALID_PARAMS = -32700, -32600, -32601, -32602
LONGEST = 1 << 28
"""Bytes of the longest request that is read; the .blend of a feature needs some ten million."""
_QUOTED = 80
"""Characters quoted from a client in an error."""


class Tool:
    """A function that a client may call by name.

    Args:
        function: Fully typed, without defaults. Its docstring, arguments and all, is the description for clients.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        self.name, self._function = function.__name__, function

    @cached_property
    def _arguments(self) -> type[BaseModel]:
        """A model that validates the arguments."""
        types = get_type_hints(self._function)
        fields: dict[str, Any] = {name: (types[name], ...) for name in signature(self._function).parameters}
        return create_model(self.name, __config__=ConfigDict(extra="forbid"), **fields)

    def describe(self) -> dict[str, Any]:
        """Return the tool's entry in the protocol's list."""
        words = getdoc(self._function) or ""
        return {"name": self.name, "description": words, "inputSchema": self._arguments.model_json_schema()}

    def call(self, arguments: dict[str, Any]) -> dict[str, Any]:
        """Return the protocol's result of a call; failures become results too, so that the worker stays alive."""
        try:
            checked = self._arguments.model_validate(arguments)
            value = to_jsonable_python(self._function(**dict(checked)))
            text = json.dumps(value, ensure_ascii=False)
        except Exception as error:  # noqa: BLE001 - sent to the client and logged
            with suppress(OSError):  # a log on a full disk
                traceback.print_exc(file=sys.stderr)
            return {"content": [{"type": "text", "text": str(error)}], "isError": True}
        return {"content": [{"type": "text", "text": text}], "structuredContent": {"result": value}, "isError": False}


def claim_standard_output() -> BinaryIO:
    """Return standard output for messages; from now on prints of Blender or tools go to standard error."""
    wire = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    return wire


def serve(
    functions: Sequence[Callable[..., Any]],
    requests: Iterable[bytes],
    answers: BinaryIO,
    progress: Progress | None = None,
) -> None:
    """Answer requests until there are no more.

    Args:
        functions: Functions that may be called.
        requests: Messages, one a line.
        answers: Receives the answers, one a line.
        progress: Receives the progress of the functions; by default it goes to ``answers``.
    """
    progress = progress or Progress(answers)
    tools = {tool.name: tool for tool in map(Tool, functions)}
    for line in requests:
        answer = _answer(tools, line, progress)
        if answer is not None:
            answers.write(json.dumps({"jsonrpc": "2.0", **answer}).encode() + b"\n")
            answers.flush()


def read_lines(stream: BinaryIO, longest: int = LONGEST) -> Iterator[bytes]:
    """Yield the lines of a stream, an empty one for each that has more than ``longest`` bytes."""
    while line := stream.readline(longest + 1):
        if len(line) <= longest:
            yield line
            continue
        while line and not line.endswith(b"\n"):
            line = stream.readline(longest)
        yield b""


def _answer(tools: dict[str, Tool], line: bytes, progress: Progress) -> dict[str, Any] | None:
    """Return the answer to a line, whatever it contains; None for a notification."""
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        return _error_answer(None, PARSE_ERROR, "not JSON")
    if not isinstance(message, dict):
        return _error_answer(None, INVALID_REQUEST, "a message is an object")
    if "id" not in message:
        return None
    number, method, parameters = message["id"], message.get("method"), message.get("params")
    if not isinstance(number, str | int) or isinstance(number, bool):
        return _error_answer(None, INVALID_REQUEST, "an id is a string or a whole number")
    if parameters is None:
        parameters = {}
    if not isinstance(parameters, dict):
        return _error_answer(number, INVALID_PARAMS, "params are an object")
    match method:
        case "initialize":
            result = _initialize_result(str(parameters.get("protocolVersion")))
        case "ping":
            result = {}
        case "tools/list":
            result = {"tools": [tool.describe() for tool in tools.values()]}
        case "tools/call":
            name, arguments = parameters.get("name"), parameters.get("arguments")
            tool = tools.get(name) if isinstance(name, str) else None
            if tool is None:
                return _error_answer(number, INVALID_PARAMS, f"no tool {repr(name)[:_QUOTED]}")
            if arguments is not None and not isinstance(arguments, dict):
                return _error_answer(number, INVALID_PARAMS, "arguments are an object")
            progress.token = _progress_token(parameters)
            result = tool.call(arguments or {})
        case _:
            return _error_answer(number, METHOD_NOT_FOUND, f"no method {repr(method)[:_QUOTED]}")
    return {"id": number, "result": result}


def _progress_token(parameters: dict[str, Any]) -> str | int | None:
    """Return the client's token for the progress of a request; None if it did not ask for progress."""
    about = parameters.get("_meta")
    token = about.get("progressToken") if isinstance(about, dict) else None
    return token if isinstance(token, str | int) and not isinstance(token, bool) else None


def _error_answer(number: str | int | None, code: int, words: str) -> dict[str, Any]:
    """Return an error of the protocol."""
    return {"id": number, "error": {"code": code, "message": words}}


def _initialize_result(protocol: str) -> dict[str, Any]:
    """Return the result of ``initialize``."""
    return {
        "protocolVersion": protocol if protocol in PROTOCOLS else PROTOCOLS[-1],
        "capabilities": {"tools": {}},
        "serverInfo": {"name": "storyblender-engine", "version": __version__},
    }
