"""The MCP server: a closed set of typed tools on one line of messages. No tool runs code.

Blender is only ever touched on the thread that serves, the main one: calls are taken one after the other. The protocol
is written out here because the SDKs cost a second and a half of processor to import, at every start of a worker
(measured); the tests let an SDK's client list and call the tools.
"""

from __future__ import annotations

import json
import os
import sys
import traceback
from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from inspect import signature
from typing import Any, BinaryIO, get_type_hints

from pydantic import BaseModel, ConfigDict, create_model
from pydantic_core import to_jsonable_python

from storyblender import __version__

PROTOCOLS = ("2024-11-05", "2025-03-26", "2025-06-18", "2025-11-25")
"""Versions of the Model Context Protocol that are spoken; to a client of any other the newest is offered."""
METHOD_NOT_FOUND, INVALID_PARAMS, PARSE_ERROR = -32601, -32602, -32700


class Tool:
    """A function that a client may call by name.

    Args:
        function: Fully typed, without defaults. A client reads the first line of its documentation.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        self.name, self._function = function.__name__, function

    @cached_property
    def _arguments(self) -> type[BaseModel]:
        types = get_type_hints(self._function)
        fields: dict[str, Any] = {name: (types[name], ...) for name in signature(self._function).parameters}
        return create_model(self.name, __config__=ConfigDict(extra="forbid"), **fields)

    def described(self) -> dict[str, Any]:
        """Return the tool as the protocol lists it."""
        words = (self._function.__doc__ or "").partition("\n")[0]
        return {"name": self.name, "description": words, "inputSchema": self._arguments.model_json_schema()}

    def called(self, arguments: dict[str, Any]) -> dict[str, Any]:
        """Return the answer as the protocol words it. Whatever goes wrong is an answer too: the worker lives on."""
        try:
            checked = self._arguments.model_validate(arguments)
            value = to_jsonable_python(self._function(**dict(checked)))
        except Exception as error:  # noqa: BLE001 - carried to the client, and told in the log
            traceback.print_exc(file=sys.stderr)
            return {"content": [{"type": "text", "text": str(error)}], "isError": True}
        text = json.dumps(value, ensure_ascii=False)
        return {"content": [{"type": "text", "text": text}], "structuredContent": {"result": value}, "isError": False}


def take_wire() -> BinaryIO:
    """Take standard output for messages; what Blender or a tool prints goes to standard error from here on."""
    wire = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    return wire


def serve(functions: Sequence[Callable[..., Any]], requests: Iterable[bytes], answers: BinaryIO) -> None:
    """Answer requests until there are no more.

    Args:
        functions: What may be called.
        requests: One message a line.
        answers: Where the answers go, one a line.
    """
    tools = {tool.name: tool for tool in map(Tool, functions)}
    for line in requests:
        answer = _answer(tools, line)
        if answer is not None:
            answers.write(json.dumps({"jsonrpc": "2.0", **answer}).encode() + b"\n")
            answers.flush()


def _answer(tools: dict[str, Tool], line: bytes) -> dict[str, Any] | None:
    """Return the answer to a message; None to a notification, which wants none."""
    try:
        message = json.loads(line)
    except ValueError:
        return {"id": None, "error": {"code": PARSE_ERROR, "message": "not JSON"}}
    if "id" not in message:
        return None
    method, parameters = message.get("method"), message.get("params") or {}
    match method:
        case "initialize":
            result = _welcome(str(parameters.get("protocolVersion")))
        case "ping":
            result = {}
        case "tools/list":
            result = {"tools": [tool.described() for tool in tools.values()]}
        case "tools/call":
            name = parameters.get("name")
            if name not in tools:
                return {"id": message["id"], "error": {"code": INVALID_PARAMS, "message": f"no tool {name!r}"}}
            result = tools[name].called(parameters.get("arguments") or {})
        case _:
            return {"id": message["id"], "error": {"code": METHOD_NOT_FOUND, "message": f"no method {method!r}"}}
    return {"id": message["id"], "result": result}


def _welcome(protocol: str) -> dict[str, Any]:
    return {
        "protocolVersion": protocol if protocol in PROTOCOLS else PROTOCOLS[-1],
        "capabilities": {"tools": {}},
        "serverInfo": {"name": "storyblender-engine", "version": __version__},
    }
