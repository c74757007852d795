"""Who may talk to the studio: a browser on this machine that was given the token, from the studio's own page."""

from __future__ import annotations

import hashlib
import hmac
import secrets
from http.cookies import CookieError, SimpleCookie
from typing import Any

from starlette.datastructures import Headers, MutableHeaders, QueryParams
from starlette.responses import PlainTextResponse, RedirectResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocketClose

COOKIE = "storyblender_studio"
PROGRAMS = "/calls"
"""Where programs make calls; the page has the wire."""
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' blob: data:; "
    "media-src 'self'; connect-src 'self' blob:; font-src 'self'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'"
)
"""Nothing is loaded from elsewhere, no inline script runs, no other page may frame the studio. Styles may be inline."""
_HEADERS = {
    "Content-Security-Policy": POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
}
_NO_ENTRY = (
    "open the address that `storyblender studio` printed: its key works once; for another browser run "
    "`storyblender studio DIR --link`, or choose `Another browser` on its page"
)
_NO_KEY = "programs name the key that is in .studio.json of the open project"


class Door:
    """Lets a request through if it names this machine, comes from the studio's page and has the session's cookie.

    Programs have a key of their own, for calls alone; what comes from any page does not pass with it.

    The token opens the door once: the page's first address carries it, and is answered with a cookie and the same
    address without it. A second use is refused, so an address left in a history opens nothing.

    Args:
        app: Behind the door.
        token: In the first address.
        origin: Of the page, such as ``http://127.0.0.1:8765``.
        key: Of programs; it also signs the passes of browsers.
    """

    def __init__(self, app: ASGIApp, token: str, origin: str, key: str) -> None:
        self._app, self._origin, self._host, self._key = app, origin, origin.partition("//")[2], key
        self._token: str | None = token

    def admit(self) -> str:
        """Return a new token for one more browser; the one before it opens nothing any more, used or not."""
        self._token = secrets.token_urlsafe(24)
        return self._token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request, or refuse it."""
        if scope["type"] not in ("http", "websocket"):
            await self._app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        if headers.get("host") != self._host:
            await _refuse(scope, receive, send, "this address is not the studio's")
        elif scope["path"] == PROGRAMS:
            allowed = self._is_program(scope, headers)
            await (
                self._app(scope, receive, _with_headers(send)) if allowed else _refuse(scope, receive, send, _NO_KEY)
            )
        elif not self._is_own(scope, headers.get("origin")):
            await _refuse(scope, receive, send, "this address is not the studio's")
        elif (token := QueryParams(scope["query_string"]).get("token")) is not None and scope["type"] == "http":
            await self._enter(token)(scope, receive, _with_headers(send))
        elif not self._is_pass(_cookie(headers)):
            await _refuse(scope, receive, send, _NO_ENTRY)
        else:
            await self._app(scope, receive, _with_headers(send))

    def _is_own(self, scope: Scope, origin: str | None) -> bool:
        """Return whether a request comes from the page; a plain look at a page or a picture has no origin."""
        if origin is None:
            return scope["type"] == "http" and scope["method"] in ("GET", "HEAD")
        return origin == self._origin

    def _is_program(self, scope: Scope, headers: Headers) -> bool:
        """Return whether a request is a program's: it names the key, and no page, which a browser always does."""
        if scope["type"] != "http" or scope["method"] != "POST" or "origin" in headers:
            return False
        named = headers.get("authorization", "")
        return secrets.compare_digest(named.encode(), f"Bearer {self._key}".encode())

    def _enter(self, token: str) -> PlainTextResponse | RedirectResponse:
        if self._token is None or not secrets.compare_digest(token.encode(), self._token.encode()):
            return PlainTextResponse(_NO_ENTRY, 403)
        self._token = None
        answer = RedirectResponse("/", 303)
        answer.set_cookie(COOKIE, self._signed(secrets.token_urlsafe(24)), httponly=True, samesite="strict", path="/")
        return answer

    def _signed(self, number: str) -> str:
        """Return a pass: a random number, and its signature with the key."""
        signature = hmac.new(self._key.encode(), number.encode(), hashlib.sha256).hexdigest()
        return f"{number}.{signature}"

    def _is_pass(self, told: str) -> bool:
        """Return whether a cookie is a pass; that of a studio which was killed holds for the next one with its key."""
        number, _, _ = told.rpartition(".")
        return bool(number) and secrets.compare_digest(told.encode(), self._signed(number).encode())


def _cookie(headers: Headers) -> str:
    try:
        found = SimpleCookie(headers.get("cookie", "")).get(COOKIE)
    except CookieError:
        return ""
    return found.value if found is not None else ""


async def _refuse(scope: Scope, receive: Receive, send: Send, why: str) -> None:
    answer: Any = WebSocketClose(1008, why) if scope["type"] == "websocket" else PlainTextResponse(why, 403)
    await answer(scope, receive, _with_headers(send))


def _with_headers(send: Send) -> Send:
    """Return a ``send`` that adds the security headers to every answer."""

    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            MutableHeaders(scope=message).update(_HEADERS)
        await send(message)

    return sending
