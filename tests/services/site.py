"""A web site on this machine that answers what a test tells it to, well or badly."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import parse_qs, urlsplit

from storyblender.services.web import Patience

QUICK = Patience(tries=3, first_pause=0.01, longest_pause=0.2, silence=0.5, answer=2.0, download=2.0)
"""Pauses that a test can wait for."""


@dataclass(frozen=True)
class Hit:
    """A request that came.

    Attributes:
        method: ``GET`` or ``POST``.
        path: Without the query.
        query: Its values by name.
        headers: By lower-case name.
        body: All of it.
    """

    method: str
    path: str
    query: dict[str, str]
    headers: dict[str, str]
    body: bytes

    @property
    def json(self) -> Any:
        return json.loads(self.body)


@dataclass(frozen=True)
class Reply:
    """An answer."""

    body: bytes = b""
    status: int = 200
    kind: str = "application/octet-stream"
    headers: Mapping[str, str] = field(default_factory=dict)
    told: bool = True
    """Whether its length is told before."""


@dataclass(frozen=True)
class Late:
    """No answer for so many seconds, then this one."""

    seconds: float
    reply: Reply = Reply()


@dataclass(frozen=True)
class Cut:
    """A connection that ends in the middle of an answer, or before it."""

    reply: Reply = Reply(b"x" * 1000)
    share: float = 0.5
    """Of the body; a negative one sends nothing at all."""


@dataclass(frozen=True)
class Endless:
    """A body that never ends, a piece every so many seconds."""

    every: float = 0.0
    piece: bytes = b"x" * 65536
    kind: str = "application/octet-stream"


Act = Reply | Late | Cut | Endless
Page = Act | Sequence[Act] | Callable[[Hit], Act]


def said(value: Any, status: int = 200, **headers: str) -> Reply:
    """Return an answer in JSON."""
    return Reply(json.dumps(value).encode(), status, "application/json", headers)


def moved(to: str) -> Reply:
    """Return a redirect."""
    return Reply(status=302, headers={"location": to})


@dataclass
class Site:
    """A running site.

    Attributes:
        pages: Path -> what to do: an act, acts in order of which the last is for ever, or a function of the request.
        hits: Every request so far.
    """

    pages: dict[str, Page] = field(default_factory=dict)
    hits: list[Hit] = field(default_factory=list)
    address: str = ""
    closing: threading.Event = field(default_factory=threading.Event)
    _lock: threading.Lock = field(default_factory=threading.Lock)

    def count(self, start: str = "/") -> int:
        """Return how many requests came for paths that begin so."""
        return sum(hit.path.startswith(start) for hit in self.hits)

    def act(self, hit: Hit) -> Act:
        with self._lock:
            self.hits.append(hit)
            page = self.pages.get(hit.path, Reply(b"no", 404, "text/plain"))
            if callable(page):
                return page(hit)
            if not isinstance(page, Sequence):
                return page
            if len(page) > 1:
                self.pages[hit.path] = page[1:]
            return page[0]


@contextmanager
def serving(pages: Mapping[str, Page] | None = None) -> Iterator[Site]:
    """Run a site; more pages may be added while it runs."""
    site = Site(dict(pages or {}))

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self._serve()

        def do_POST(self) -> None:
            self._serve()

        def _serve(self) -> None:
            parts = urlsplit(self.path)
            query = {name: values[-1] for name, values in parse_qs(parts.query).items()}
            headers = {name.lower(): value for name, value in self.headers.items()}
            body = self.rfile.read(int(self.headers.get("content-length") or 0))
            self.close_connection = True
            with suppress(ConnectionError):
                self._do(site.act(Hit(self.command, parts.path, query, headers, body)))

        def _do(self, act: Act) -> None:
            if isinstance(act, Late):
                site.closing.wait(act.seconds)
                self._do(act.reply)
            elif isinstance(act, Endless):
                self._begin(200, act.kind, {})
                while not site.closing.wait(act.every):
                    self.wfile.write(act.piece)
            elif isinstance(act, Cut):
                if act.share >= 0:
                    self._begin(act.reply.status, act.reply.kind, {"content-length": str(len(act.reply.body))})
                    self.wfile.write(act.reply.body[: int(len(act.reply.body) * act.share)])
            else:
                length = {"content-length": str(len(act.body))} if act.told else {}
                self._begin(act.status, act.kind, {**length, **act.headers})
                self.wfile.write(act.body)

        def _begin(self, status: int, kind: str, headers: Mapping[str, str]) -> None:
            self.send_response(status)
            self.send_header("content-type", kind)
            for name, value in headers.items():
                self.send_header(name, value)
            self.end_headers()

        def log_message(self, format: str, *args: object) -> None:
            pass

    http = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    http.daemon_threads = True
    site.address = f"http://127.0.0.1:{http.server_port}"
    threading.Thread(target=http.serve_forever, args=(0.02,), daemon=True).start()
    try:
        yield site
    finally:
        site.closing.set()
        http.shutdown()
        http.server_close()
