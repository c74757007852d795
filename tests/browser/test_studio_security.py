"""The real server: nothing for those without the key, from another page or host, or out of the project's folder."""

from __future__ import annotations

import base64
import http.client
import json
import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from urllib.parse import urlsplit

import pytest

from tests.browser.conftest import RunningStudio

PLACES = ("/", "/frames/SC010_SH010.png", "/files/board.pdf", "/files/story.blend", "/static/studio.js", "/wire")


class Visitor:
    """Somebody who talks to the server without a browser.

    Attributes:
        host: Of the server, with its port.
        cookie: That a browser with the key would have.
    """

    def __init__(self, address: str) -> None:
        self.host, self.cookie = urlsplit(address).netloc, ""
        status, headers, _ = self.get(f"/?{urlsplit(address).query}")
        assert status == 303
        self.cookie = headers["set-cookie"].partition(";")[0]

    def get(self, path: str, **headers: str) -> tuple[int, http.client.HTTPMessage, bytes]:
        link = http.client.HTTPConnection(self.host, timeout=30)
        link.request("GET", path, headers=headers)
        answer = link.getresponse()
        return answer.status, answer.headers, answer.read()

    def joins(self, **headers: str) -> str:
        """Ask for the wire; return the first line of the answer."""
        name, _, port = self.host.partition(":")
        with socket.create_connection((name, int(port)), timeout=30) as link:
            told = {"Host": self.host, "Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
                    "Sec-WebSocket-Key": base64.b64encode(os.urandom(16)).decode(), **headers}  # fmt: skip
            lines = "".join(f"{name}: {value}\r\n" for name, value in told.items())
            link.sendall(f"GET /wire HTTP/1.1\r\n{lines}\r\n".encode())
            return link.recv(200).partition(b"\r\n")[0].decode()


@pytest.fixture(scope="module")
def visitor(studio: RunningStudio) -> Iterator[Visitor]:
    yield Visitor(studio.address)


@pytest.mark.parametrize("path", PLACES)
def test_without_the_key_there_is_nothing(visitor: Visitor, path: str) -> None:
    assert visitor.get(path)[0] == 403
    assert visitor.get(path, Cookie="storyblender_studio=guessed.0")[0] == 403


def test_the_key_works_once(visitor: Visitor, studio: RunningStudio) -> None:
    assert visitor.get(f"/?{urlsplit(studio.address).query}")[0] == 403


def test_one_more_browser_is_let_in_by_a_fresh_key_once(visitor: Visitor, studio: RunningStudio) -> None:
    command = [sys.executable, "-m", "storyblender", "studio", str(studio.folder / "two_cups.storyboard"), "--link"]
    address = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout.strip()
    assert urlsplit(address).netloc == visitor.host and address != studio.address
    second = Visitor(address)
    assert second.cookie != visitor.cookie
    for known in (visitor, second):
        assert known.get("/", Cookie=known.cookie)[0] == 200
    assert visitor.get(f"/?{urlsplit(address).query}")[0] == 403


@pytest.mark.parametrize("path", ["/", "/files/board.pdf"])
def test_another_page_or_host_gets_nothing_even_with_the_cookie(visitor: Visitor, path: str) -> None:
    assert visitor.get(path, Cookie=visitor.cookie)[0] == 200
    assert visitor.get(path, Cookie=visitor.cookie, Origin="http://elsewhere.example")[0] == 403
    assert visitor.get(path, Cookie=visitor.cookie, Host="rebound.example")[0] == 403


@pytest.mark.parametrize(
    "path",
    [
        "/files/graph.json", "/files/.studio.json", "/files/../two_cups.fountain", "/files/..%2f..%2fetc%2fpasswd",
        "/files/export/..%2fgraph.json", "/files//etc/passwd", "/frames/..%2fgraph.png", "/static/..%2faccess.py",
        "/takes/..%2fgraph.png", "/moments/..%2f..%2fgraph.glb",
    ],
)  # fmt: skip
def test_no_other_file_leaves_the_project(visitor: Visitor, path: str) -> None:
    status, _, body = visitor.get(path, Cookie=visitor.cookie)
    assert status == 404 and b"root:" not in body and b"INT. KITCHEN" not in body


def test_the_wire_is_for_the_page_alone(visitor: Visitor) -> None:
    own = f"http://{visitor.host}"
    assert " 101 " in f"{visitor.joins(Cookie=visitor.cookie, Origin=own)} "
    for headers in (
        {"Origin": own},
        {"Cookie": visitor.cookie},
        {"Cookie": visitor.cookie, "Origin": "http://elsewhere.example"},
        {"Cookie": visitor.cookie, "Origin": own, "Host": "rebound.example"},
    ):
        assert " 101 " not in f"{visitor.joins(**headers)} ", headers


def test_a_program_without_its_key_is_refused_and_too_large_a_call_too(visitor: Visitor, studio: RunningStudio) -> None:
    told = json.loads((studio.folder / "two_cups.storyboard" / ".studio.json").read_text("utf-8"))

    def says(words: bytes, key: str) -> int:
        link = http.client.HTTPConnection(visitor.host, timeout=60)
        try:
            link.request("POST", "/calls", words, {"Authorization": f"Bearer {key}"})
            return link.getresponse().status
        except (BrokenPipeError, ConnectionResetError):  # it hung up before all was said
            return 413

    call = json.dumps({"id": 1, "call": "places"}).encode()
    assert says(call, told["key"]) == 200 and says(call, "guessed") == 403
    assert says(b" " * 6_000_000, told["key"]) == 413
    assert says(call, told["key"]) == 200, "and it goes on"


def test_every_answer_forbids_what_is_foreign(visitor: Visitor) -> None:
    policy = visitor.get("/", Cookie=visitor.cookie)[1]["content-security-policy"]
    assert "default-src 'none'" in policy and "frame-ancestors 'none'" in policy
