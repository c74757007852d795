"""A server on this machine that speaks the wire of a provider, and answers what a test tells it to."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Protocol


@dataclass(frozen=True)
class Asked:
    """What a request asked for, whatever the wire.

    Attributes:
        form: ``native``, ``tool`` or ``prompted``.
        words: All texts of the request.
        pictures: Each as its media type and base64 data.
    """

    form: str
    words: str
    pictures: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Say:
    """A response.

    Attributes:
        text: The answer.
        end: ``stop``, ``length`` (cut at the limit of tokens) or ``refusal``.
        tokens: In and out.
        calls: Whether a tool that is offered is called.
    """

    text: str
    end: str = "stop"
    tokens: tuple[int, int] = (20, 10)
    calls: bool = True


@dataclass(frozen=True)
class Fail:
    """An error of the service, in the form of the wire; the headers of the request are repeated if it gossips."""

    status: int
    message: str = "no"
    forms: tuple[str, ...] = ("native", "tool", "prompted")
    """What it fails for; the next thing to do is done for other forms."""
    headers: tuple[tuple[str, str], ...] = ()
    pictures: bool = False
    """Whether it fails only for requests with pictures."""


@dataclass(frozen=True)
class Raw:
    """A response that is not of the wire."""

    body: bytes
    kind: str = "application/json"


@dataclass(frozen=True)
class Late:
    """No response for so many seconds."""

    seconds: float


@dataclass(frozen=True)
class Cut:
    """A connection that ends in the middle of the response."""


Act = Say | Fail | Raw | Late | Cut


class Wire(Protocol):
    """How a provider's requests and responses are written."""

    def read(self, body: dict[str, Any]) -> Asked: ...

    def write(self, say: Say, asked: Asked, body: dict[str, Any]) -> tuple[str, bytes]:
        """Return the type and the body of a response."""
        ...

    def error(self, status: int, message: str) -> dict[str, Any]: ...


@dataclass
class Server:
    """A running server.

    Attributes:
        address: Its URL, without a path.
        asked: Every request so far.
        headers: Their headers.
        bodies: Their bodies.
    """

    wire: Wire
    acts: Sequence[Act]
    gossips: bool = False
    address: str = ""
    asked: list[Asked] = field(default_factory=list)
    headers: list[dict[str, str]] = field(default_factory=list)
    bodies: list[dict[str, Any]] = field(default_factory=list)
    arrived: threading.Event = field(default_factory=threading.Event)
    closing: threading.Event = field(default_factory=threading.Event)

    @property
    def forms(self) -> list[str]:
        return [each.form for each in self.asked]

    def act(self, asked: Asked) -> Act:
        """Return what to do about a request: the acts in order, the last for ever."""
        while len(self.acts) > 1:
            act, *rest = self.acts
            if isinstance(act, Fail) and (asked.form not in act.forms or (act.pictures and not asked.pictures)):
                self.acts = rest
                continue
            if not (isinstance(act, Fail) and (len(act.forms) < 3 or act.pictures)):
                self.acts = rest
            return act
        return self.acts[0]


@contextmanager
def serving(wire: Wire, *acts: Act, gossips: bool = False) -> Iterator[Server]:
    """Run a server that does one act a request."""
    server = Server(wire, acts, gossips)

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = json.loads(self.rfile.read(int(self.headers["content-length"])))
            asked = wire.read(body)
            server.asked.append(asked)
            server.bodies.append(body)
            server.headers.append(dict(self.headers))
            server.arrived.set()
            act = server.act(asked)
            if isinstance(act, Late):
                server.closing.wait(act.seconds)
            elif isinstance(act, Cut):
                self._send(200, *wire.write(Say('{"number": 1}'), asked, body), cut=True)
            elif isinstance(act, Raw):
                self._send(200, act.kind, act.body)
            elif isinstance(act, Fail):
                said = act.message + (json.dumps(dict(self.headers)) + self.path if gossips else "")
                error = json.dumps(wire.error(act.status, said)).encode()
                self._send(act.status, "application/json", error, act.headers)
            else:
                self._send(200, *wire.write(act, asked, body))

        def _send(
            self, status: int, kind: str, body: bytes, headers: Sequence[tuple[str, str]] = (), cut: bool = False
        ) -> None:
            self.send_response(status)
            self.send_header("content-type", kind)
            self.send_header("content-length", str(len(body)))
            for name, value in headers:
                self.send_header(name, value)
            self.end_headers()
            self.wfile.write(body[: len(body) // 2] if cut else body)
            self.close_connection = True

        def log_message(self, format: str, *args: object) -> None:
            pass

    http = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    http.daemon_threads = True
    server.address = f"http://127.0.0.1:{http.server_port}"
    threading.Thread(target=http.serve_forever, args=(0.02,), daemon=True).start()
    try:
        yield server
    finally:
        server.closing.set()
        http.shutdown()
        http.server_close()
        time.sleep(0)
