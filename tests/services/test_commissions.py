"""The ledger of paid work, killed at every step: what was paid for is asked once, and what is in doubt is said."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import pytest

from storyblender.errors import ServiceFailure
from storyblender.library.commissions import Commissions, Wanted
from storyblender.library.shared.entries import LibraryEntry
from storyblender.library.shared.jobs import Job
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.services import meshy
from storyblender.services.budget import ServiceBudget
from storyblender.services.making import JobState, ModelMaker
from storyblender.services.openai import OpenAIImages
from storyblender.services.web import Web
from tests.services.makers import SECRET, WIRES, MeshyWire, Wire, openai_draws, picture
from tests.services.paying import STEPS, pay
from tests.services.site import QUICK, Cut, Hit, Reply, Site, said, serving

PATIENT = replace(QUICK, silence=10, answer=20)


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        openai_draws(site, "")
        yield site


def pay_in_a_process(site: Site, kind: str, step: str = "") -> str:
    """Have a thing made in a process of its own, which dies at a step, and return what it says."""
    reads, writes = os.pipe()
    process = os.fork()
    if not process:
        os.write(writes, pay(site.address, kind, step).encode())
        os._exit(0)
    os.close(writes)
    with os.fdopen(reads, "rb") as pipe:
        heard = pipe.read().decode()
    _, status = os.waitpid(process, 0)
    assert (os.WTERMSIG(status), heard) == (9, "") if step else status == 0
    return heard


DOUBT = {"after begin 1": "picture", "after draw 1": "picture", "after begin 2": "model", "after send 2": "model"}
"""Steps after which nobody here knows whether what costs was done, and what that is about."""


@pytest.mark.parametrize("kind", ["trellis", "hunyuan3d"])
@pytest.mark.parametrize("step", STEPS)
def test_killed_at_a_step_nothing_is_paid_twice(site: Site, kind: str, step: str) -> None:
    wire = WIRES[kind](site)
    wire.open()
    assert not pay_in_a_process(site, kind, step)
    said_then = pay_in_a_process(site, kind)
    drawn, begun = site.count("/images"), site.count(wire.begin_path)
    assert drawn <= 1
    assert begun <= 1
    if DOUBT.get(step) == "picture" or (DOUBT.get(step) == "model" and kind == "hunyuan3d"):
        assert said_then.startswith(f"no {DOUBT[step]}: "), said_then
        assert "--ask-again" in said_then
        assert pay_in_a_process(site, kind) == said_then, "it is said every time"
    else:
        assert said_then.startswith("made "), "where the service lists its jobs, the lost one is found"
        assert (drawn, begun) == (1, 1)
        assert pay_in_a_process(site, kind).startswith("made ")
        assert (site.count("/images"), site.count(wire.begin_path)) == (1, 1), "the library has it"
        assert not SharedLibrary.open().jobs.unfinished()


@pytest.mark.parametrize("kind", ["trellis", "hunyuan3d", "meshy"])
@pytest.mark.parametrize("slow", ["/images", "begin", "neither"])
def test_processes_that_want_the_same_at_the_same_moment_share_one_job(site: Site, kind: str, slow: str) -> None:
    wire = WIRES[kind](site)
    wire.open()
    for path in [path for path in site.pages if slow in path or (slow == "begin" and path == wire.begin_path)]:
        site.pages[path] = slowly(site.pages[path])
    reads, writes = os.pipe()
    processes = []
    for _ in range(2):
        processes.append(os.fork())
        if not processes[-1]:
            break
    if 0 in processes:
        os.write(writes, f"{pay(site.address, kind)}\n".encode())
        os._exit(0)
    os.close(writes)
    with os.fdopen(reads, "rb") as pipe:
        heard = pipe.read().decode().splitlines()
    assert [os.waitpid(process, 0)[1] for process in processes] == [0, 0]
    assert heard[0].startswith("made ") and heard[0] == heard[1], heard
    assert site.count("/images") == 1
    assert len(wire.jobs) == 1
    assert not SharedLibrary.open().jobs.unfinished()


def test_waiting_for_another_process_ends_with_the_minutes(site: Site) -> None:
    commissions, draws, _ = commissions_of(site, MeshyWire(site), minutes=0.02)
    busy, others, _ = commissions_of(site, MeshyWire(site))
    with busy._alone("picture", others.maker, "a samovar"):
        (found,) = commissions.pictures(draws, [Wanted("samovar", "a samovar")]).values()
    assert isinstance(found, ServiceFailure) and "minutes" in str(found)
    assert site.count("/images") == 0
    assert isinstance(drawn_by(commissions, draws), LibraryEntry), "now that the other has ended"


def slowly(page: Any) -> Callable[[Hit], Reply]:
    def answer(hit: Hit) -> Reply:
        time.sleep(0.4)
        return page(hit) if callable(page) else page

    return answer


def commissions_of(
    site: Site, wire: Wire, dollars: float = 5, minutes: float = 30
) -> tuple[Commissions, OpenAIImages, ModelMaker]:
    budget = ServiceBudget({"dollars": dollars, "minutes": minutes})
    draws = OpenAIImages(Web("openai", site.address, {"authorization": SECRET}, budget, PATIENT))
    maker = wire.adapter(Web(wire.name, site.address, {"authorization": f"Bearer {SECRET}"}, budget, PATIENT))
    return Commissions(SharedLibrary.open(), budget), draws, maker


def drawn_by(commissions: Commissions, draws: OpenAIImages, prompt: str = "a samovar") -> LibraryEntry:
    (found,) = commissions.pictures(draws, [Wanted("samovar", prompt)]).values()
    assert isinstance(found, LibraryEntry), found
    return found


def test_pictures_are_drawn_at_the_same_time_and_each_once(site: Site) -> None:
    commissions, draws, _ = commissions_of(site, MeshyWire(site))
    wanted = [Wanted(name, f"a {name}") for name in ("samovar", "sextant", "samovar", "astrolabe")]
    made = commissions.pictures(draws, wanted)
    assert list(sorted(made)) == ["a astrolabe", "a samovar", "a sextant"]
    assert site.count("/images") == 3
    again = commissions.pictures(draws, wanted)
    assert again == made
    assert site.count("/images") == 3


def test_one_picture_that_fails_leaves_the_others(site: Site) -> None:
    commissions, draws, _ = commissions_of(site, MeshyWire(site))
    good = site.pages["/images/generations"]
    refusal = said({"error": {"code": "moderation_blocked", "message": "no"}}, 400)
    site.pages["/images/generations"] = lambda hit: refusal if "gun" in hit.json["prompt"] else good(hit)  # type: ignore[operator]
    made = commissions.pictures(draws, [Wanted("gun", "a gun"), Wanted("samovar", "a samovar")])
    assert isinstance(made["a gun"], ServiceFailure)
    assert isinstance(made["a samovar"], LibraryEntry)
    site.pages["/images/generations"] = good
    assert isinstance(drawn_by(commissions, draws, "a gun"), LibraryEntry), (
        "a refusal costs nothing and may be tried again"
    )


def test_a_limit_is_kept_to_the_cent(site: Site) -> None:
    commissions, draws, _ = commissions_of(site, MeshyWire(site), dollars=0.1)
    made = commissions.pictures(draws, [Wanted("thing", f"thing {number}") for number in range(5)])
    failures = [each for each in made.values() if isinstance(each, ServiceFailure)]
    assert (len(made) - len(failures), site.count("/images")) == (2, 2), "a picture is $0.042"
    assert all("limit of 0.1 dollars" in str(each) for each in failures)


@pytest.fixture
def wire(site: Site) -> MeshyWire:
    wire = MeshyWire(site)
    wire.open()
    return wire


def test_a_cut_answer_is_looked_for_at_once(site: Site, wire: MeshyWire) -> None:
    commissions, draws, maker = commissions_of(site, wire)
    entry, good = drawn_by(commissions, draws), site.pages[wire.begin_path]

    def cut(hit: object) -> object:
        answer = good(hit)  # type: ignore[operator]
        return Cut(answer, 0.3) if hit.method == "POST" else answer  # type: ignore[attr-defined]

    site.pages[wire.begin_path] = cut  # type: ignore[assignment]
    job = commissions.model(maker, entry)
    assert isinstance(job, Job)
    assert (job.state, job.remote_id) == ("submitted", "meshy-1")
    assert len(wire.jobs) == 1


def test_what_never_arrived_is_begun_once_that_is_sure(
    site: Site, wire: MeshyWire, monkeypatch: pytest.MonkeyPatch
) -> None:
    commissions, draws, maker = commissions_of(site, wire)
    entry, good = drawn_by(commissions, draws), site.pages[wire.begin_path]
    site.pages[wire.begin_path] = lambda hit: Cut(share=-1) if hit.method == "POST" else good(hit)  # type: ignore[operator]
    with pytest.raises(ServiceFailure, match="--ask-again"):
        commissions.model(maker, entry)
    with pytest.raises(ServiceFailure, match="not known"):
        commissions.model(maker, entry)
    site.pages[wire.begin_path] = good
    monkeypatch.setattr(meshy, "SETTLED", 0.0)
    job = commissions.model(maker, entry)
    assert isinstance(job, Job)
    assert job.state == "submitted"
    assert len(wire.jobs) == 1


def test_a_job_that_failed_may_be_asked_again_and_one_that_ended_is_closed(site: Site, wire: MeshyWire) -> None:
    commissions, draws, maker = commissions_of(site, wire)
    entry = drawn_by(commissions, draws)
    wire.failure, wire.polls = "the picture shows nothing", 0
    job = commissions.model(maker, entry)
    assert isinstance(job, Job)
    assert commissions.look(maker, job, Wanted("samovar", "")) == JobState("failed", 100, "the picture shows nothing")
    wire.failure = ""
    again = commissions.model(maker, entry)
    assert isinstance(again, Job)
    assert again.remote_id != job.remote_id
    assert isinstance(commissions.look(maker, again, Wanted("samovar", "")), LibraryEntry)
    assert not SharedLibrary.open().jobs.unfinished()


def test_a_model_that_is_none_ends_its_job(site: Site, wire: MeshyWire) -> None:
    commissions, draws, maker = commissions_of(site, wire)
    wire.file, wire.polls = b"#!/bin/sh", 0
    job = commissions.model(maker, drawn_by(commissions, draws))
    assert isinstance(job, Job)
    state = commissions.look(maker, job, Wanted("samovar", ""))
    assert isinstance(state, JobState)
    assert (state.status, "no model" in state.reason) == ("failed", True)


def test_a_job_that_cannot_be_looked_at_goes_on(site: Site, wire: MeshyWire) -> None:
    commissions, draws, maker = commissions_of(site, wire)
    job = commissions.model(maker, drawn_by(commissions, draws))
    assert isinstance(job, Job)
    page = site.pages[wire.poll_path(job.remote_id)]
    site.pages[wire.poll_path(job.remote_id)] = Reply(status=503)
    with pytest.raises(ServiceFailure):
        commissions.look(maker, job, Wanted("samovar", ""))
    site.pages[wire.poll_path(job.remote_id)] = page
    assert commissions.model(maker, drawn_by(commissions, draws)) == job, "it is not begun again"


@pytest.mark.parametrize("page", [None, Reply(status=400), Reply(status=503)], ids=["works on", "gone", "fails"])
def test_a_job_of_yesterday_has_ended(site: Site, wire: MeshyWire, page: Reply | None) -> None:
    commissions, draws, maker = commissions_of(site, wire)
    wire.polls = 99
    job = commissions.model(maker, drawn_by(commissions, draws))
    assert isinstance(job, Job)
    if page is not None:
        site.pages[wire.poll_path(job.remote_id)] = page
    old = job.model_copy(update={"began": time.time() - 25 * 3600})
    state = commissions.look(maker, old, Wanted("samovar", ""))
    assert isinstance(state, JobState)
    assert (state.status, "within a day" in state.reason) == ("failed", True)


def test_what_is_kept_says_of_what_and_under_which_terms(site: Site, wire: MeshyWire) -> None:
    commissions, draws, maker = commissions_of(site, wire)
    wire.polls, library = 0, SharedLibrary.open()
    entry = drawn_by(commissions, draws, "a “brass” samovar")
    job = commissions.model(maker, entry)
    assert isinstance(job, Job)
    made = commissions.look(maker, job, Wanted("samovar", "a “brass” samovar"))
    assert isinstance(made, LibraryEntry)
    folder = library.path_of(made).parent
    assert {path.name for path in folder.iterdir()} == {"model.glb", "credits.toml", "prompt.txt"}
    assert (folder / "prompt.txt").read_text().strip() == "a “brass” samovar"
    assert (made.credit.author, made.credit.license) == ("meshy (meshy-6)", "Meshy terms of use")
    assert (entry.kind, made.kind, made.source, made.source_id) == ("image", "model", "meshy", "meshy-1")
    secret = SECRET.encode()
    for path in library.files.root.rglob("*"):
        assert path.is_dir() or secret not in path.read_bytes(), path
    assert library.path_of(entry).read_bytes().startswith(picture()[:8])
