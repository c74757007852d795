"""Makers of models over real sockets, each in its own wire format: good answers, bad ones and none."""

from __future__ import annotations

import base64
import io
import time
import zipfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from storyblender.errors import ServiceFailure
from storyblender.services.budget import ServiceBudget
from storyblender.services.making import Busy, ModelMaker, Unusable
from storyblender.services.meshy import SETTLED, MeshyModels, MeshyMotions, MeshyRigs
from storyblender.services.web import Patience, Web
from tests.services.makers import SECRET, SECRET_KEY, WIRES, MeshyWire, TencentWire, Wire, model, picture
from tests.services.site import QUICK, Cut, Endless, Late, Reply, Site, said, serving


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        yield site


PATIENT = replace(QUICK, silence=10, answer=20, download=20)
HASTY = replace(QUICK, tries=2, silence=0.3, answer=0.6, download=0.6)
"""For what never answers; else the machine may be slow."""


def web_of(site: Site, service: str = "shop", budget: ServiceBudget | None = None, patience: Patience = PATIENT) -> Web:
    headers = {"authorization": f"Bearer {SECRET}"}
    return Web(service, site.address, headers, budget or ServiceBudget(), patience=patience)


@pytest.fixture(params=WIRES.values(), ids=WIRES.keys())
def wire(request: pytest.FixtureRequest, site: Site) -> Wire:
    wire = request.param(site)
    wire.open()
    return wire


@pytest.fixture
def maker(wire: Wire) -> ModelMaker:
    return wire.adapter(web_of(wire.site, wire.name))


def finished(maker: ModelMaker, job: str) -> None:
    for _ in range(20):
        if maker.poll(job).status == "done":
            return
    pytest.fail("it never ends")


def test_a_picture_becomes_a_model(wire: Wire, maker: ModelMaker, tmp_path: Path) -> None:
    job = maker.begin(picture(), "mark1")
    assert maker.poll(job).status in ("waiting", "working")
    assert maker.poll(job).status == "done"
    assert (tmp_path / maker.fetch(job, tmp_path)).read_bytes() == wire.begun[job]["file"]


UNKNOWN = {
    "error": Reply(status=500),
    "gateway": Reply(status=504),
    "cut before the answer": Cut(share=-1),
    "cut in the answer": Cut(),
    "no JSON": Reply(b"<p>ok</p>"),
    "another form": said([1, 2]),
    "no id": said({"result": 7, "uid": None, "request_id": "../..", "Response": {"JobId": ""}}),
}
NEVER = {"silence": Late(5), "endless": Endless(0.05)}


@pytest.mark.parametrize("name", [*UNKNOWN, *NEVER])
def test_what_may_have_been_begun_is_not_begun_again(wire: Wire, name: str) -> None:
    maker = wire.adapter(web_of(wire.site, wire.name, patience=HASTY if name in NEVER else PATIENT))
    wire.site.pages[wire.begin_path] = {**UNKNOWN, **NEVER}[name]
    with pytest.raises(ServiceFailure, match=f"^{wire.name}: ") as told:
        maker.begin(picture(), "mark1")
    assert told.value.uncertain
    assert wire.site.count() == 1


def test_too_many_requests_pass(wire: Wire, maker: ModelMaker) -> None:
    good = wire.site.pages[wire.begin_path]
    acts = iter([Reply(status=429, headers={"retry-after": "0"}), Reply(status=429)])
    wire.site.pages[wire.begin_path] = lambda hit: next(acts, None) or good(hit)  # type: ignore[operator]
    assert maker.begin(picture(), "mark1") in wire.jobs
    assert len(wire.jobs) == 1


@pytest.mark.parametrize("status", [400, 401, 402, 403, 413, 422])
def test_a_refusal_is_known_to_be_one(wire: Wire, maker: ModelMaker, status: int) -> None:
    wire.site.pages[wire.begin_path] = said({"message": f"no, {SECRET}"}, status)
    with pytest.raises(ServiceFailure) as told:
        maker.begin(picture(), "mark1")
    assert not told.value.uncertain
    assert SECRET not in str(told.value)
    assert wire.site.count() == 1


def test_no_credit_is_said_so(wire: Wire, maker: ModelMaker) -> None:
    empty = {"Response": {"Error": {"Code": "ResourceInsufficient.ChargeResourceExhaust", "Message": "empty"}}}
    wire.site.pages[wire.begin_path] = said(empty) if isinstance(wire, TencentWire) else said({"message": "no"}, 402)
    with pytest.raises(ServiceFailure, match="no credit left") as told:
        maker.begin(picture(), "mark1")
    assert not told.value.uncertain


def test_a_job_that_failed_says_why(wire: Wire, maker: ModelMaker) -> None:
    job = maker.begin(picture(), "mark1")
    wire.failure = "the picture shows nothing"
    maker.poll(job)
    state = maker.poll(job)
    assert (state.status, state.reason) == ("failed", "the picture shows nothing")


@pytest.mark.parametrize("act", [Reply(status=500), Reply(status=429), Cut(), Cut(share=-1)], ids=str)
def test_a_look_at_a_job_is_tried_again(wire: Wire, maker: ModelMaker, act: Reply) -> None:
    job = maker.begin(picture(), "mark1")
    path = wire.poll_path(job)
    good, acts = wire.site.pages[path], iter([act])
    wire.site.pages[path] = lambda hit: next(acts, None) or good(hit)  # type: ignore[operator]
    assert maker.poll(job).status == "working"


@pytest.mark.parametrize("act", [Reply(status=500), Reply(b"{", kind="application/json"), said(["?"])], ids=str)
def test_a_look_that_fails_tells_nothing_of_the_job(wire: Wire, maker: ModelMaker, act: Reply) -> None:
    job = maker.begin(picture(), "mark1")
    wire.site.pages[wire.poll_path(job)] = act
    with pytest.raises(ServiceFailure, match=f"^{wire.name}: "):
        maker.poll(job)


NO_MODELS = {
    "text": b"this is no model",
    "empty": b"",
    "half": model()[:200],
    "other files": model(linked="../../../etc/passwd"),
    "a file by address": model(linked="http://127.0.0.1:9/a.png"),
    "a script": b"#!/bin/sh\necho\n" + b" " * 40,
    "a .blend": b"BLENDER-v405" + bytes(100),
}


@pytest.mark.parametrize("file", NO_MODELS.values(), ids=NO_MODELS.keys())
def test_what_is_no_model_is_refused(wire: Wire, maker: ModelMaker, file: bytes, tmp_path: Path) -> None:
    wire.file = file or b"\n"
    job = maker.begin(picture(), "mark1")
    finished(maker, job)
    with pytest.raises(Unusable):
        maker.fetch(job, tmp_path)


def test_a_model_that_is_too_large_is_given_up(wire: Wire, tmp_path: Path) -> None:
    maker = wire.adapter(web_of(wire.site, wire.name, ServiceBudget({"megabytes": 0.05})))
    wire.file = model() + bytes(200_000)
    job = maker.begin(picture(), "mark1")
    with pytest.raises(ServiceFailure, match="megabytes for services"):
        finished(maker, job)
        maker.fetch(job, tmp_path)


def test_a_cut_download_is_tried_again(site: Site, tmp_path: Path) -> None:
    wire = MeshyWire(site)
    wire.open()
    maker = wire.adapter(web_of(site))
    job = maker.begin(picture(), "mark1")
    finished(maker, job)
    file = Reply(wire.begun[job]["file"])
    site.pages[f"/files/{job}.glb"] = [Cut(file), Reply(status=503), file]
    assert (tmp_path / maker.fetch(job, tmp_path)).read_bytes() == file.body


def test_keys_go_to_the_service_only(site: Site, tmp_path: Path) -> None:
    for kind in (MeshyWire, TencentWire):
        site.hits.clear()
        wire = kind(site)
        wire.open()
        maker = wire.adapter(web_of(site))
        job = maker.begin(picture(), "mark1")
        finished(maker, job)
        maker.fetch(job, tmp_path)
        assert SECRET_KEY.encode() not in b"".join(str(hit).encode() for hit in site.hits), "it signs, and is not sent"


def test_meshy_finds_the_job_whose_id_got_lost(site: Site) -> None:
    wire = MeshyWire(site)
    wire.open()
    maker, began = wire.adapter(web_of(site)), time.time()
    assert maker.lost_job("", began - 2 * SETTLED, ()) == "", "nothing was begun"
    assert maker.lost_job("", began, ()) is None, "it may still be on its way"
    first = maker.begin(picture(), "")
    assert maker.lost_job("", began, ()) == first
    assert maker.lost_job("", began - 2 * SETTLED, (first,)) == "", "it is another one's"
    maker.begin(picture(), "")
    assert maker.lost_job("", began, ()) is None, "it can be either"


def test_trellis_finds_the_job_by_the_name_of_its_picture(site: Site) -> None:
    wire = WIRES["trellis"](site)
    wire.open()
    maker = wire.adapter(web_of(site))
    jobs = [maker.begin(picture(), mark) for mark in ("mark1", "mark2")]
    assert [maker.lost_job(mark, 0, ()) for mark in ("mark1", "mark2", "mark3")] == [*jobs, ""]


def test_meshy_says_what_is_left(site: Site) -> None:
    wire = MeshyWire(site)
    wire.open()
    assert MeshyModels(web_of(site)).balance() == 1000


def test_a_task_that_is_gone_has_failed(site: Site) -> None:
    assert MeshyModels(web_of(site)).poll("task-1").status == "failed"


def test_meshy_rigs_and_moves(site: Site, tmp_path: Path) -> None:
    rigged, moving = model(b"rigged"), model(b"moving")
    site.pages |= {
        "/v1/rigging": said({"result": "rig-1"}, 202),
        "/v1/rigging/rig-1": said(
            {"status": "SUCCEEDED", "progress": 100, "result": {"rigged_character_glb_url": f"{site.address}/rigged"}}
        ),
        "/v1/animations": said({"result": "motion-1"}, 202),
        "/v1/animations/motion-1": said(
            {"status": "SUCCEEDED", "progress": 100, "result": {"animation_glb_url": f"{site.address}/moving"}}
        ),
        "/rigged": Reply(rigged),
        "/moving": Reply(moving),
    }
    rigs, motions = MeshyRigs(web_of(site), 1.8), MeshyMotions(web_of(site))
    rig = rigs.begin(model(), "")
    asked = site.hits[-1].json
    assert asked["height_meters"] == 1.8
    assert base64.b64decode(asked["model_url"].partition(",")[2]) == model()
    assert rigs.poll(rig).status == "done"
    assert (tmp_path / rigs.fetch(rig, tmp_path)).read_bytes() == rigged
    motion = motions.begin(rig, 92, "")
    assert site.hits[-1].json == {"rig_task_id": "rig-1", "action_id": 92}
    assert (tmp_path / motions.fetch(motion, tmp_path)).read_bytes() == moving
    assert rigs.lost_job("", 0, ()) is None


def tencent(site: Site, answer: dict[str, object]) -> ModelMaker:
    site.pages["/"] = said({"Response": answer})
    return TencentWire(site).adapter(web_of(site))


def test_tencent_refuses_in_an_answer_of_200(site: Site) -> None:
    refused = {
        "OperationDenied.ImageIllegalDetected": "moderation",
        "AuthFailure.SignatureFailure": "key",
        "ResourceUnavailable.InArrears": "credit",
        "InvalidParameterValue": "request",
    }
    for code, said_of_it in refused.items():
        maker = tencent(site, {"Error": {"Code": code, "Message": "no"}})
        with pytest.raises(ServiceFailure, match=said_of_it) as told:
            maker.begin(picture(), "")
        assert not told.value.uncertain
    with pytest.raises(Busy):
        tencent(site, {"Error": {"Code": "RequestLimitExceeded.JobNumExceed", "Message": "no"}}).begin(picture(), "")


def archive(*names: str) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as opened:
        for name in names:
            opened.writestr(name, b"v 0 0 0")
    return out.getvalue()


def test_tencent_gives_an_archive_where_it_has_no_glb(site: Site, tmp_path: Path) -> None:
    done = {"Status": "DONE", "ResultFile3Ds": [{"Type": "OBJ", "Url": f"{site.address}/a.zip"}]}
    maker = tencent(site, done)
    site.pages["/a.zip"] = Reply(archive("a.obj", "run.sh"))
    (tmp_path / "good").mkdir()
    assert maker.fetch("job-1", tmp_path / "good") == "a.obj"
    assert [path.name for path in (tmp_path / "good").iterdir()] == ["a.obj"], "scripts stay in the archive"
    bad = {"out": archive("../../x.obj"), "none": archive("a.txt"), "text": b"no"}
    for name, data in bad.items():
        (tmp_path / name).mkdir()
        site.pages["/a.zip"] = Reply(data)
        with pytest.raises(Unusable):
            maker.fetch("job-1", tmp_path / name)
    assert not list(tmp_path.parent.rglob("x.obj"))


def test_waiting_for_a_slow_service_is_bounded(site: Site) -> None:
    wire = WIRES["hunyuan3d"](site)
    wire.open()
    job = wire.adapter(web_of(site)).begin(picture(), "")
    site.pages[wire.poll_path(job)] = Late(30)
    start = time.monotonic()
    with pytest.raises(ServiceFailure, match="does not answer"):
        wire.adapter(web_of(site, patience=HASTY)).poll(job)
    assert time.monotonic() - start < 10
