"""Only a browser that was given the key, on the studio's own page, gets anything."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import PlainTextResponse
from starlette.routing import Route, WebSocketRoute
from starlette.testclient import TestClient
from starlette.websockets import WebSocket, WebSocketDisconnect

from storyblender.web_studio.access import PROGRAMS, Door

ORIGIN, TOKEN, KEY = "http://127.0.0.1:8123", "key", "program's key"


async def secret(request: Request) -> PlainTextResponse:
    return PlainTextResponse("secret")


async def wire(socket: WebSocket) -> None:
    await socket.accept()
    await socket.send_text("secret")
    await socket.close()


@pytest.fixture
def visitor() -> Iterator[TestClient]:
    ways = [Route(path, secret, methods=["GET", "POST"]) for path in ("/", PROGRAMS)]
    inside = Starlette(routes=[*ways, WebSocketRoute("/wire", wire), WebSocketRoute(PROGRAMS, wire)])
    with TestClient(Door(inside, TOKEN, ORIGIN, KEY), base_url=ORIGIN) as client:
        yield client


def test_one_more_browser_is_let_in_by_a_fresh_key_once_and_the_first_one_stays(visitor: TestClient) -> None:
    enter(visitor)
    door = visitor.app
    assert isinstance(door, Door)
    unused, fresh = door.admit(), door.admit()
    second = TestClient(door, base_url=ORIGIN)
    assert second.get(f"/?token={unused}").status_code == 403, "only the last one opens"
    assert second.get(f"/?token={fresh}").text == "secret" and second.get("/").text == "secret"
    assert TestClient(door, base_url=ORIGIN).get(f"/?token={fresh}").status_code == 403
    assert visitor.get("/").text == "secret"


def enter(visitor: TestClient) -> None:
    assert visitor.get(f"/?token={TOKEN}").text == "secret"


def hears(visitor: TestClient, **headers: str) -> str:
    with visitor.websocket_connect("ws://127.0.0.1:8123/wire", headers=headers) as socket:
        return socket.receive_text()


def test_the_key_opens_once_and_leaves_the_address(visitor: TestClient) -> None:
    enter(visitor)
    assert visitor.get("/").text == "secret"
    visitor.cookies.clear()
    again = visitor.get(f"/?token={TOKEN}")
    assert again.status_code == 403 and "storyblender studio" in again.text


@pytest.mark.parametrize("address", ["/", "/?token=wrong", "/?token=", "/nowhere"])
def test_without_the_key_nothing_is_answered(visitor: TestClient, address: str) -> None:
    assert visitor.get(address).status_code == 403


@pytest.mark.parametrize("cookie", ["", "storyblender_studio=guessed", "storyblender_studio=", 'a="', "\x00"])
def test_a_guessed_cookie_opens_nothing(visitor: TestClient, cookie: str) -> None:
    assert visitor.get("/", headers={"cookie": cookie}).status_code == 403


def test_another_page_and_another_host_are_refused(visitor: TestClient) -> None:
    enter(visitor)
    assert visitor.post("/", headers={"origin": "http://elsewhere.example"}).status_code == 403
    assert visitor.get("/", headers={"origin": "null"}).status_code == 403
    assert visitor.get("/", headers={"host": "rebound.example:8123"}).status_code == 403
    assert visitor.post("/").status_code == 403, "a change without an origin comes from no page"
    assert visitor.post("/", headers={"origin": ORIGIN}).text == "secret"


@pytest.mark.parametrize("headers", [{}, {"origin": "http://elsewhere.example"}, {"origin": ORIGIN, "host": "x"}])
def test_the_wire_is_for_the_page_alone(visitor: TestClient, headers: dict[str, str]) -> None:
    with pytest.raises(WebSocketDisconnect):
        hears(visitor, origin=ORIGIN)
    enter(visitor)
    assert hears(visitor, origin=ORIGIN) == "secret"
    with pytest.raises(WebSocketDisconnect):
        hears(visitor, **headers)


def test_every_answer_forbids_foreign_content(visitor: TestClient) -> None:
    for answer in (visitor.get("/"), visitor.get(f"/?token={TOKEN}")):
        policy = answer.headers["content-security-policy"]
        assert "default-src 'none'" in policy and "frame-ancestors 'none'" in policy and "http:" not in policy
    cookie = TestClient(visitor.app, base_url=ORIGIN, follow_redirects=False)
    assert cookie.get("/").headers["x-content-type-options"] == "nosniff"


def test_a_program_makes_calls_with_its_own_key_and_nothing_else(visitor: TestClient) -> None:
    key = {"authorization": f"Bearer {KEY}"}
    assert visitor.post(PROGRAMS, headers=key).text == "secret"
    assert visitor.get("/", headers=key).status_code == 403, "pictures and the page are for the browser"
    assert visitor.get(PROGRAMS, headers=key).status_code == 403
    with (
        pytest.raises(WebSocketDisconnect),
        visitor.websocket_connect(f"ws://127.0.0.1:8123{PROGRAMS}", headers=key) as socket,
    ):
        socket.receive_text()


@pytest.mark.parametrize(
    "headers",
    [
        {},
        {"authorization": f"Bearer {TOKEN}"},
        {"authorization": "Bearer "},
        {"authorization": KEY},
        {"authorization": "Bearer \u00e9"},
        {"authorization": f"Bearer {KEY}", "origin": ORIGIN},
        {"authorization": f"Bearer {KEY}", "origin": "http://elsewhere.example"},
        {"authorization": f"Bearer {KEY}", "host": "rebound.example:8123"},
    ],
)
def test_a_program_without_the_key_and_every_page_is_refused(visitor: TestClient, headers: dict[str, str]) -> None:
    encoded = {name: value.encode("latin-1") for name, value in headers.items()}
    assert visitor.post(PROGRAMS, headers=encoded).status_code == 403
    enter(visitor)
    assert visitor.post(PROGRAMS, headers=encoded).status_code == 403, "the page's cookie is of no use there"
