"""HTTP with one service: tried again where that helps, bounded in bytes and time, kept away from other hosts.

A key goes to the service's own host only, also where it answers with links or redirects. Plain http, and hosts of the
local network, are only for a service whose own address is there.
"""
# pyright: reportMissingImports=false
# the extra ``services`` is only installed where services are used

from __future__ import annotations

import hashlib
import json
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, NoReturn, TypeVar
from urllib.parse import urljoin, urlsplit

from storyblender import __version__
from storyblender.errors import Cancelled, ServiceFailure
from storyblender.services.answers import pause_asked_for, said_in
from storyblender.services.budget import ServiceBudget
from storyblender.services.hosts import is_near, refuse_address

if TYPE_CHECKING:
    import ssl

    import httpx2
    import tenacity

AGENT: Final = f"StoryBlender/{__version__}"
"""User-Agent: services ask programs to say who they are."""
MOST_ANSWER: Final = 32 << 20
"""Bytes of an answer that is read into memory."""
_CHUNK = 1 << 16
_HOPS = 5
_AGAIN: Final = frozenset((408, 425, 429, 500, 502, 503, 504))
"""Statuses of faults that pass."""
_MEGABYTE = 1e6
_Found = TypeVar("_Found")


@dataclass(frozen=True)
class Patience:
    """How long and how often a service is asked; seconds.

    Attributes:
        tries: Of one request, in all.
        first_pause: After the first try; it doubles with each.
        longest_pause: Between two tries, also where the service asks for more.
        silence: Without a byte.
        answer: For all of an answer.
        download: For all of a file.
    """

    tries: int = 5
    first_pause: float = 1.0
    longest_pause: float = 60.0
    silence: float = 30.0
    answer: float = 120.0
    download: float = 900.0


@dataclass(frozen=True)
class Answer:
    """What a service answered: 200 to 299, or 304 where it was asked whether something has changed."""

    status: int
    headers: Mapping[str, str]
    """By lower-case name."""
    content: bytes
    service: str = ""

    @property
    def json(self) -> Any:
        """The content as JSON. Raises ServiceFailure."""
        try:
            return json.loads(self.content, parse_constant=_no_number)
        except (ValueError, RecursionError) as error:
            raise ServiceFailure(f"{self.service}: its answer is not JSON") from error


@dataclass(frozen=True)
class Downloaded:
    """A file that was downloaded: its size, and SHA-256 in hex."""

    bytes: int
    digest: str


class Missing(ServiceFailure):
    """A service does not have what it was asked for, or has it no more."""


class _Passing(Exception):
    """A fault that may be over when the request is made again.

    Args:
        problem: One clause.
        sent: Whether the service may have done what it was asked.
        pause: Seconds to wait, if it says.
    """

    def __init__(self, problem: str, *, sent: bool = True, pause: float | None = None) -> None:
        super().__init__(problem)
        self.problem, self.sent, self.pause = problem, sent, pause


@dataclass
class Web:
    """HTTP with one service. Several threads may use it.

    Attributes:
        service: Its name, for messages.
        address: URL of its API.
        headers: With the key; sent to the host of the address only.
        budget: Of the run; every byte counts.
        patience: How long and how often it is asked.
        cancelled: Set when the run is cancelled.
    """

    service: str
    address: str
    headers: Mapping[str, str] = field(default_factory=dict, repr=False)
    budget: ServiceBudget = field(default_factory=ServiceBudget)
    patience: Patience = field(default_factory=Patience)
    cancelled: threading.Event = field(default_factory=threading.Event)

    def get(self, path: str, params: Mapping[str, Any] | None = None, *, headers: Mapping[str, str] = {}) -> Answer:
        """Ask for something that may be asked for twice.

        Args:
            path: Below the address, or a whole URL.
            params: Of the query.
            headers: Further ones, with no key in them.

        Raises:
            ServiceFailure: It failed for good.
            Cancelled: The run was cancelled.
        """
        return self._again(lambda: self._ask("GET", path, params=params, headers=headers))

    def post(self, path: str, body: Any = None, *, paid: bool = False, **more: Any) -> Answer:
        """Ask for something to be done.

        Args:
            path: Below the address.
            body: Sent as JSON, if not None.
            paid: Whether it costs money: then it is sent again only where the service surely did nothing.
            more: ``content``, ``data``, ``files`` or ``headers`` of the request, as httpx has them.

        Raises:
            ServiceFailure: It failed for good; ``uncertain`` if it may have been done all the same.
            Cancelled: The run was cancelled; a paid request was not sent then.
        """
        if body is not None:
            more["json"] = body
        return self._again(lambda: self._ask("POST", path, to_the_end=paid, **more), paid=paid)

    def download(self, url: str, part: Path, *, most: int, md5: str = "") -> Downloaded:
        """Download a file; a try that failed leaves nothing of use in it.

        Args:
            url: Where it is.
            part: Where to write it.
            most: Bytes.
            md5: Of the file, if the service says.

        Raises:
            ServiceFailure: It failed for good, or is larger than ``most``.
            Cancelled: The run was cancelled.
        """
        return self._again(lambda: self._download(url, part, most, md5.lower()))

    def picture(self, url: str) -> bytes:
        """Return the file of a small picture that a person waits for; it is given up sooner than other requests.

        Args:
            url: Where it is; empty where there is none.

        Raises:
            ServiceFailure: There is none, or it cannot be had soon.
            Cancelled: The run was cancelled.
        """
        if not url:
            raise Missing(f"{self.service}: it has no picture of that")
        return self.soon.get(url).content

    @cached_property
    def soon(self) -> Web:
        """The same service for a person who waits: asked once, for a few seconds, whatever ends beside it."""
        usual = self.patience
        soon = replace(usual, tries=1, silence=min(usual.silence, 5), answer=min(usual.answer, 10))
        return replace(self, patience=soon, cancelled=threading.Event())

    def _again(self, attempt: Callable[[], _Found], *, paid: bool = False) -> _Found:
        """Try until it succeeds or fails for good."""
        from tenacity import Retrying, retry_if_exception, stop_after_attempt

        def passes(error: BaseException) -> bool:
            return isinstance(error, _Passing) and not (paid and error.sent)

        tries = Retrying(
            stop=stop_after_attempt(self.patience.tries),
            retry=retry_if_exception(passes),
            wait=self._pause,
            sleep=self._sleep,
            reraise=True,
        )
        try:
            return tries(attempt)
        except _Passing as fault:
            self._fail(fault.problem, uncertain=paid and fault.sent)
        except ServiceFailure as failure:
            if failure.problem.startswith(f"{self.service}: "):
                raise
            problem = f"{self.service}: {failure.problem}"
            raise type(failure)(problem, mend=failure.mend, uncertain=failure.uncertain) from failure

    def _pause(self, state: tenacity.RetryCallState) -> float:
        """Return the seconds to wait before the next try; what the service asks for counts if it is not too long."""
        fault = state.outcome.exception() if state.outcome is not None else None
        asked = fault.pause if isinstance(fault, _Passing) else None
        growing = self.patience.first_pause * 2 ** (state.attempt_number - 1)
        return asked if asked is not None else min(growing, self.patience.longest_pause)

    def _sleep(self, seconds: float) -> None:
        if self.cancelled.wait(seconds):
            raise Cancelled

    def _fail(self, problem: str, *, mend: str = "", uncertain: bool = False) -> NoReturn:
        raise ServiceFailure(f"{self.service}: {problem}", mend=mend, uncertain=uncertain)

    @cached_property
    def _client(self) -> httpx2.Client:
        import httpx2

        silence = self.patience.silence
        near = is_near(urlsplit(self.address).hostname or "")
        agent = {"user-agent": AGENT, "accept-encoding": "gzip"}
        return httpx2.Client(timeout=httpx2.Timeout(silence), headers=agent, trust_env=not near, verify=_trusted())

    def _ask(self, method: str, path: str, *, to_the_end: bool = False, **more: Any) -> Answer:
        """Make a request once and read its answer; what costs is waited for to the end."""
        whole = path if "://" in path else self.address.rstrip("/") + "/" + path.lstrip("/")
        deadline = time.monotonic() + self.patience.answer
        with self._opened(method, whole, **more) as response:
            try:
                content = b"".join(self._chunks(response, MOST_ANSWER, deadline, to_the_end))
            except ServiceFailure as error:
                raise ServiceFailure(error.problem, mend=error.mend, uncertain=True) from error
            return Answer(response.status_code, dict(response.headers), content, self.service)

    def _download(self, url: str, part: Path, most: int, md5: str) -> Downloaded:
        """Download a file once."""
        sha256, check, size = hashlib.sha256(), hashlib.md5(usedforsecurity=False), 0
        deadline = time.monotonic() + self.patience.download
        with self._opened("GET", url) as response, part.open("wb") as file:
            if "html" in response.headers.get("content-type", ""):
                raise ServiceFailure("a web page came in place of a file")
            for chunk in self._chunks(response, most, deadline):
                for digest in (sha256, check):
                    digest.update(chunk)
                size += file.write(chunk)
        if md5 and check.hexdigest() != md5:
            raise _Passing("a file came damaged")
        return Downloaded(size, sha256.hexdigest())

    @contextmanager
    def _opened(self, method: str, url: str, **more: Any) -> Iterator[httpx2.Response]:
        """Open the answer to a request, after redirects; faults of all layers become ours."""
        import httpx2

        try:
            for _ in range(_HOPS):
                if self.cancelled.is_set():
                    raise Cancelled
                refuse_address(url, self.address)
                with self._client.stream(method, url, **self._with_key(url, more)) as response:
                    if not response.has_redirect_location or method != "GET":
                        self._check(response)
                        yield response
                        return
                    url, more = urljoin(url, response.headers["location"]), {**more, "params": None}
            raise ServiceFailure("it redirects without end")
        except (httpx2.ConnectError, httpx2.ConnectTimeout, httpx2.PoolTimeout) as error:
            raise _Passing("it cannot be reached", sent=False) from error
        except httpx2.TimeoutException as error:
            raise _Passing("it does not answer") from error
        except (httpx2.DecodingError, httpx2.UnsupportedProtocol, httpx2.InvalidURL, ValueError) as error:
            raise ServiceFailure("its answer cannot be read", uncertain=True) from error
        except httpx2.HTTPError as error:
            raise _Passing("the connection ended before the answer did") from error

    def _with_key(self, url: str, more: dict[str, Any]) -> dict[str, Any]:
        """Return the parts of a request, with the key if it goes to the service's own host."""
        ours = urlsplit(url)[:2] == urlsplit(self.address)[:2]
        return {**more, "headers": {**(self.headers if ours else {}), **(more.get("headers") or {})}}

    def _check(self, response: httpx2.Response) -> None:
        """Raise what a status means, if it is not that of an answer."""
        status = response.status_code
        if 200 <= status < 300 or status == 304:
            if response.headers.get("content-encoding", "identity").lower() not in ("gzip", "identity"):
                raise ServiceFailure("its answer is packed in a way that was not asked for")
            return
        if status in _AGAIN:
            pause = pause_asked_for(response.headers.get("retry-after", ""))
            if pause is not None and pause > self.patience.longest_pause:
                raise ServiceFailure(f"it asks to wait for {pause / 60:.0f} minutes", uncertain=status >= 500)
            problem = "it has too many requests" if status == 429 else f"it answers with an error ({status})"
            raise _Passing(problem, sent=status != 429, pause=pause)
        if status in (401, 403):
            keyed = any(name.lower() in response.request.headers for name in self.headers)
            problem = f"it refuses the {'key or the ' * keyed}request ({status})"
            raise ServiceFailure(problem, mend="look at its key" if keyed else "")
        if status in (404, 410):
            raise Missing("it does not have that")
        reasons = {402: "its account has no credit left"}
        said = said_in(b"".join(self._chunks(response, _CHUNK, time.monotonic() + self.patience.silence)))
        for secret in self.headers.values():
            said = said.replace(secret.split()[-1], "…") if secret.strip() else said
        raise ServiceFailure(reasons.get(status, f"it refuses the request ({status})") + (f": {said}" if said else ""))

    def _chunks(
        self, response: httpx2.Response, most: int, deadline: float, to_the_end: bool = False
    ) -> Iterator[bytes]:
        """Yield an answer piece by piece, within its limits."""
        told = response.headers.get("content-length", "")
        if told.isdecimal():
            if len(told) > 18 or int(told) > most:
                raise ServiceFailure(f"its answer is larger than {most / _MEGABYTE:.0f} MB")
            self.budget.ask("megabytes", int(told) / _MEGABYTE)
        size = 0
        for chunk in response.iter_bytes():
            size += len(chunk)
            if size > most:
                raise ServiceFailure(f"its answer is larger than {most / _MEGABYTE:.0f} MB")
            self.budget.spend("megabytes", len(chunk) / _MEGABYTE)
            if self.cancelled.is_set() and not to_the_end:
                raise Cancelled
            if time.monotonic() > deadline:
                raise _Passing("its answer takes too long")
            yield chunk


@cache
def _trusted() -> ssl.SSLContext:
    """Return the certificates that are trusted; reading them takes long enough to do it once."""
    import httpx2

    return httpx2.create_ssl_context()


def _no_number(text: str) -> NoReturn:
    raise ValueError(f"{text} is no number")
