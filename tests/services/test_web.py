"""Requests to a service over real sockets: what passes is tried again, what does not fails in one sentence."""

from __future__ import annotations

import gzip
import hashlib
import threading
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from storyblender.errors import Cancelled, ServiceFailure
from storyblender.services.budget import ServiceBudget
from storyblender.services.web import Web
from tests.services.site import QUICK, Cut, Endless, Late, Reply, Site, moved, said, serving

SECRET = "sk-very-secret-1234"
FILE = bytes(range(256)) * 400
GOOD = Reply(FILE)
ANSWER = {"good": True}


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        yield site


@pytest.fixture
def web(site: Site) -> Web:
    return Web("shop", site.address, {"authorization": f"Token {SECRET}"}, patience=QUICK)


PASSING = {
    "too many requests": Reply(status=429, headers={"retry-after": "0"}),
    "too many requests, no pause told": Reply(status=429),
    "a server error": Reply(status=500),
    "bad gateway": Reply(status=502),
    "unavailable": Reply(status=503, headers={"retry-after": "0.1"}),
    "cut in the middle": Cut(),
    "cut before the answer": Cut(share=-1),
    "no answer": Late(3),
    "an odd pause": Reply(status=503, headers={"retry-after": "soon"}),
}


@pytest.mark.parametrize("fault", PASSING.values(), ids=PASSING.keys())
def test_a_fault_that_passes_is_tried_again(site: Site, web: Web, fault: Reply) -> None:
    site.pages["/a"] = [fault, fault, said(ANSWER)]
    assert web.get("/a").json == ANSWER
    assert site.count("/a") == 3


@pytest.mark.parametrize("fault", PASSING.values(), ids=PASSING.keys())
def test_a_fault_that_stays_is_one_sentence(site: Site, web: Web, fault: Reply) -> None:
    site.pages["/a"] = fault
    with pytest.raises(ServiceFailure, match=r"^shop: ") as failure:
        web.get("/a")
    assert site.count("/a") == QUICK.tries and "\n" not in str(failure.value)


FINAL = {
    "not there": Reply(status=404),
    "key refused": Reply(status=401),
    "no credit": Reply(status=402),
    "bad request": said({"error": {"message": "no such style"}}, 400),
    "a pause of hours": Reply(status=429, headers={"retry-after": "7200"}),
    "redirects in a circle": moved("/a"),
    "redirect to a file": moved("file:///etc/passwd"),
    "redirect to another scheme": moved("ftp://example.org/a"),
    "redirect to the local network": moved("https://192.168.0.1/a"),
    "redirect to this computer": moved("https://localhost:1/a"),
    "redirect to plain http elsewhere": moved("http://example.org/a"),
    "redirect to cloud metadata": moved("http://169.254.169.254/latest/meta-data"),
    "redirect with a password": moved("https://me:secret@example.org/a"),
    "redirect to nonsense": moved("https://[::1/a"),
    "an answer packed unasked": Reply(b"abc", headers={"content-encoding": "zstd"}),
    "damaged gzip": Reply(b"abc", headers={"content-encoding": "gzip"}),
}


@pytest.mark.parametrize("fault", FINAL.values(), ids=FINAL.keys())
def test_a_fault_that_cannot_pass_is_not_tried_again(site: Site, web: Web, fault: Reply) -> None:
    site.pages["/a"] = fault
    with pytest.raises(ServiceFailure, match=r"^shop: "):
        web.get("/a")
    assert {hit.path for hit in site.hits} == {"/a"} and len(site.hits) <= 5


@pytest.mark.parametrize("content", [b"<html>", b"", b"\xff\xfe", b"[" * 100_000, b'{"a": NaN}', b"9" * 5000])
def test_what_is_no_json_is_said(site: Site, web: Web, content: bytes) -> None:
    site.pages["/a"] = Reply(content)
    with pytest.raises(ServiceFailure, match="not JSON"):
        _ = web.get("/a").json


def test_a_refusal_says_why_and_never_the_key(site: Site, web: Web) -> None:
    site.pages["/a"] = lambda hit: said({"detail": f"no style\n{hit.headers['authorization']}"}, 422)
    with pytest.raises(ServiceFailure, match="no style") as failure:
        web.get("/a")
    assert SECRET not in str(failure.value) and SECRET not in repr(web)


def test_only_the_service_itself_can_refuse_the_key(site: Site, web: Web, tmp_path: Path) -> None:
    site.pages["/a"] = Reply(status=403)
    with pytest.raises(ServiceFailure, match="look at its key"):
        web.get("/a")
    with serving({"/file": Reply(status=403)}) as other, pytest.raises(ServiceFailure, match=r"refuses the request"):
        web.download(f"{other.address}/file", tmp_path / "part", most=10)


def test_the_key_goes_to_no_other_host(site: Site, web: Web, tmp_path: Path) -> None:
    with serving({"/file": GOOD}) as other:
        site.pages["/a"] = moved(f"{other.address}/file")
        web.get("/a")
        web.download(f"{other.address}/file", tmp_path / "part", most=10**6)
        assert "authorization" in site.hits[0].headers
        assert len(other.hits) == 2 and all("authorization" not in hit.headers for hit in other.hits)
    assert all(hit.headers["user-agent"].startswith("StoryBlender/") for hit in site.hits)


def test_a_file_is_downloaded_whole_with_its_digests(site: Site, web: Web, tmp_path: Path) -> None:
    site.pages["/file"] = [Cut(GOOD), Reply(FILE[:-1]), GOOD]
    found = web.download(
        f"{site.address}/file", tmp_path / "part", most=10**6, md5=hashlib.md5(FILE, usedforsecurity=False).hexdigest()
    )
    assert (tmp_path / "part").read_bytes() == FILE
    assert (found.bytes, found.digest) == (len(FILE), hashlib.sha256(FILE).hexdigest())


@pytest.mark.parametrize(
    "body",
    [
        Reply(b"x" * 2000), Reply(b"x" * 2000, told=False), Endless(), Endless(0.05, b"x"),
        Reply(gzip.compress(b"x" * 10**6), headers={"content-encoding": "gzip"}, told=False),
        Reply(headers={"content-length": "9" * 30}), Reply(b"<html>", kind="text/html; charset=utf-8"),
    ],
    ids=["too large", "too large, untold", "endless", "endless and slow", "a bomb", "an odd length", "a web page"],
)  # fmt: skip
def test_a_download_is_bounded(site: Site, web: Web, body: Reply, tmp_path: Path) -> None:
    web.patience = replace(QUICK, download=0.3)
    site.pages["/file"] = body
    begun = time.monotonic()
    with pytest.raises(ServiceFailure, match=r"^shop: "):
        web.download(f"{site.address}/file", tmp_path / "part", most=1000)
    part = tmp_path / "part"
    assert time.monotonic() - begun < 3 and (not part.exists() or part.stat().st_size <= 1000)


def test_an_answer_is_bounded_in_time(site: Site, web: Web) -> None:
    web.patience = replace(QUICK, answer=0.3, tries=1)
    site.pages["/a"] = Endless(0.05, b"x")
    with pytest.raises(ServiceFailure, match="takes too long"):
        web.get("/a")


def test_downloads_count_and_end_at_the_budget(site: Site, web: Web, tmp_path: Path) -> None:
    web.budget = ServiceBudget({"megabytes": 0.25})
    site.pages["/file"] = GOOD
    for _ in range(2):
        web.download(f"{site.address}/file", tmp_path / "part", most=10**6)
    with pytest.raises(ServiceFailure, match=r"0\.25 megabytes"):
        web.download(f"{site.address}/file", tmp_path / "part", most=10**6)
    assert web.budget.spent("megabytes") == pytest.approx(2 * len(FILE) / 1e6)


UNSURE = {"a server error": Reply(status=500), "cut": Cut(), "cut before": Cut(share=-1), "no answer": Late(3)}


@pytest.mark.parametrize("fault", UNSURE.values(), ids=UNSURE.keys())
def test_what_may_have_been_paid_is_not_sent_again(site: Site, web: Web, fault: Reply) -> None:
    site.pages["/make"] = [fault, said(ANSWER)]
    with pytest.raises(ServiceFailure) as failure:
        web.post("/make", {"prompt": "a chair"}, paid=True)
    assert failure.value.uncertain and site.count("/make") == 1


def test_what_was_surely_not_done_is_sent_again(site: Site, web: Web) -> None:
    site.pages["/make"] = [Reply(status=429), said(ANSWER)]
    assert web.post("/make", {"prompt": "a chair"}, paid=True).json == ANSWER
    assert site.hits[0].json == {"prompt": "a chair"}


def test_a_service_that_is_not_there_is_said_and_is_certain(site: Site) -> None:
    web = Web("shop", "http://127.0.0.1:1", patience=QUICK)
    with pytest.raises(ServiceFailure, match="cannot be reached") as failure:
        web.post("/make", {}, paid=True)
    assert not failure.value.uncertain


@pytest.mark.parametrize("fault", [Reply(status=503), Endless(0.02, b"x")], ids=["in a pause", "in a body"])
def test_a_cancelled_call_ends_at_once(site: Site, web: Web, fault: Reply) -> None:
    web.patience = replace(QUICK, first_pause=30, longest_pause=30, answer=30)
    site.pages["/a"] = fault
    threading.Timer(0.2, web.cancelled.set).start()
    begun = time.monotonic()
    with pytest.raises(Cancelled):
        web.get("/a")
    assert time.monotonic() - begun < 2


def test_a_public_service_is_never_asked_by_http() -> None:
    with pytest.raises(ServiceFailure, match="not https"):
        Web("shop", "https://example.org", patience=QUICK).get("http://example.org/a")
