"""A client of the Model Context Protocol made of the standard library: JSON-RPC in HTTP requests, and nothing else."""

from __future__ import annotations

import json
import time
import urllib.error
import urllib.request
from itertools import count
from typing import Any

WAIT = 120.0
"""Seconds for one answer."""


class RawClient:
    """Speaks the streamable HTTP transport.

    Args:
        port: Of a server on this machine.
        token: That it names; None for none.
    """

    def __init__(self, port: int, token: str | None) -> None:
        self.session: str | None = None
        self._address, self._token, self._ids = f"http://127.0.0.1:{port}/mcp", token, count(1)

    def begin(self) -> dict[str, Any]:
        """Shake hands; return what the server says of itself. The server may still be starting."""
        hello = {
            "protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "by hand", "version": "1"},
        }  # fmt: skip
        for _ in range(300):
            try:
                answer = self.ask("initialize", hello)
                break
            except urllib.error.HTTPError:
                raise
            except OSError:
                time.sleep(0.2)
        else:
            raise TimeoutError("the server does not listen")
        self._post({"jsonrpc": "2.0", "method": "notifications/initialized"})
        return answer

    def ask(self, method: str, params: dict[str, Any] | None = None) -> dict[str, Any]:
        """Return the result of a request.

        Args:
            method: Such as ``tools/list``.
            params: Of the method.

        Raises:
            urllib.error.HTTPError: The server refuses the request.
            RuntimeError: The answer is an error.
        """
        number = next(self._ids)
        body = self._post({"jsonrpc": "2.0", "id": number, "method": method, "params": params or {}})
        for message in messages(body):
            if message.get("id") == number:
                if "error" in message:
                    raise RuntimeError(message["error"])
                return message["result"]
        raise RuntimeError(f"no answer to {method}: {body[:200]!r}")

    def _post(self, message: dict[str, Any]) -> bytes:
        headers = {"Content-Type": "application/json", "Accept": "application/json, text/event-stream"}
        headers |= {"Authorization": f"Bearer {self._token}"} if self._token else {}
        headers |= {"Mcp-Session-Id": self.session} if self.session else {}
        request = urllib.request.Request(self._address, json.dumps(message).encode(), headers)
        with urllib.request.urlopen(request, timeout=WAIT) as answer:
            self.session = answer.headers.get("Mcp-Session-Id") or self.session
            return answer.read()


def messages(body: bytes) -> list[dict[str, Any]]:
    """Return the JSON-RPC messages of a body: one as JSON, or several as server-sent events."""
    text = body.decode("utf-8")
    if text.lstrip().startswith("{"):
        return [json.loads(text)]
    events = text.replace("\r\n", "\n").split("\n\n")
    data = ("\n".join(line[5:].strip() for line in event.split("\n") if line.startswith("data:")) for event in events)
    return [json.loads(each) for each in data if each]
