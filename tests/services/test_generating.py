"""Three things that no library has: drawn, examined, made and used again; or a stand-in and one sentence."""

from __future__ import annotations

import base64
import io
import json
import zlib
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from threading import Event as Signal
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from storyblender.agents.concept_artist.reference_picture import with_picture_critic
from storyblender.crew import Crew, rules_crew
from storyblender.errors import Cancelled
from storyblender.folder import Folder
from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.library.sources import asset_sources, service_run
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.jobs import FETCHED, AssetJob
from storyblender.memory.measure import AssetMeasure
from storyblender.pipeline.materializing import materialize
from storyblender.pipeline.run import Run
from storyblender.reflection import reflect
from storyblender.settings import Settings
from storyblender.trace import Event
from tests.services.makers import SECRET, HunyuanWire, MeshyWire, TrellisWire, openai_draws
from tests.services.site import QUICK, Reply, Site, said, serving

THINGS = ("zoetrope", "orrery", "theremin")


class Unlike:
    """An embedder that finds no text like another."""

    def embed(self, texts: Sequence[str]) -> NDArray[np.float32]:
        return np.array([_vector(text) for text in texts], np.float32)


@cache
def _vector(text: str) -> NDArray[np.float64]:
    vector = np.random.default_rng(zlib.crc32(text.encode())).normal(size=256)
    return vector / np.linalg.norm(vector)


@pytest.fixture
def site() -> Iterator[Site]:
    with serving() as site:
        openai_draws(site, "")
        HunyuanWire(site).open()
        yield site


def settings_of(site: Site, services: str = "openai@{0},hunyuan3d@{0}", **more: Any) -> Settings:
    return Settings(services=services.format(site.address), **more)


def built(job: AssetJob) -> Future[AssetMeasure]:
    """Measure every thing as a cube."""
    done: Future[AssetMeasure] = Future()
    name = job.asset.asset_id
    done.set_result(AssetMeasure(asset_id=name, dimensions=(1, 1, 1), faces=6, digest="d", geometry_hash="g"))
    return done


def made(
    folder: Path,
    settings: Settings,
    told: list[Event] | None = None,
    crew: Callable[[Crew], Crew] = lambda crew: crew,
    heard: Callable[[Event, Signal], None] = lambda event, cancelled: None,
) -> ContinuityMemoryGraph:
    """Materialize a story with the three things in a project folder."""
    events, cancelled = told if told is not None else [], Signal()
    kept: list[Asset] = []

    def tell(event: Event) -> None:
        events.append(event)
        heard(event, cancelled)

    def progress(stage: str, step: int, total: int, subject: str = "") -> None:
        if cancelled.is_set():
            raise Cancelled
        tell(Event(kind="stage", role=stage, subject=subject, step=step, total=total))

    services = service_run(settings, cancelled)
    if services is not None:
        services = replace(services, patience=replace(QUICK, silence=10, answer=20, download=20))
    sources = asset_sources(settings, Unlike, services, lambda sentence: tell(warning(sentence)))
    run = SimpleNamespace(
        graph=ContinuityMemoryGraph(
            title="Story",
            assets=tuple(
                Asset(asset_id=name, asset_type="object", description=f"a {name}", name=name) for name in THINGS
            ),
        ),
        settings=settings,
        services=services,
        library=None,
        engine=SimpleNamespace(build_asset=built),
        outputs=SimpleNamespace(note=lambda name: None),
        tell=tell,
        progress=progress,
        crew=crew(rules_crew(settings, Unlike, sources)),
        sources=sources,
        project=SimpleNamespace(files=Folder(folder)),
        reflect=lambda role, subject, *given: reflect(role, subject, role.project(*given), tell),
        commit=lambda author, reason, *items: kept.extend(items),
    )
    materialize(cast(Run, run))
    return ContinuityMemoryGraph(assets=tuple(kept))


def warning(sentence: str) -> Event:
    return Event(kind="warning", role="asset_retriever", message=sentence)


def things_of(graph: ContinuityMemoryGraph) -> dict[str, Asset]:
    return {asset.asset_id: asset for asset in graph.assets if asset.asset_id in THINGS}


def sources_of(graph: ContinuityMemoryGraph) -> list[str]:
    return sorted(asset.canonical.source for asset in things_of(graph).values() if asset.canonical)


def warnings_in(told: list[Event], word: str) -> list[str]:
    return [event.message for event in told if event.kind == "warning" and word in event.message]


def test_three_things_are_drawn_and_made_and_come_into_the_story(site: Site, tmp_path: Path) -> None:
    told: list[Event] = []
    graph = made(tmp_path / "p", settings_of(site), told)
    assert len(things_of(graph)) == 3
    for name, thing in things_of(graph).items():
        canonical = thing.canonical
        assert canonical is not None and canonical.provenance is not None
        assert (canonical.source, canonical.match_score, thing.image_prompt) == ("file", 8.0, "")
        assert canonical.key.startswith("hunyuan3d/")
        assert (tmp_path / "p" / FETCHED / canonical.key).is_file()
        assert canonical.provenance.source == "hunyuan3d"
        assert "Tencent Hunyuan" in canonical.provenance.license
        assert name in (tmp_path / "p" / FETCHED / canonical.key).with_name("prompt.txt").read_text()
    assert (site.count("/images"), site.count("/send")) == (3, 3)
    assert not warnings_in(told, "stands in")
    steps = [event.subject for event in told if event.kind == "stage" and event.role == "generate"]
    assert any(step.startswith("zoetrope: hunyuan3d, ") for step in steps), steps


def test_another_story_has_them_from_the_library(site: Site, tmp_path: Path) -> None:
    first = made(tmp_path / "p", settings_of(site))
    told = {name: (thing.canonical and thing.canonical.params["told"]) for name, thing in things_of(first).items()}
    assert set(told.values()) == {True}, "what is made has no size of its own"
    sizes = {name: thing.dimension for name, thing in things_of(first).items()}
    stand_ins = things_of(made(tmp_path / "none", Settings(library=False)))
    assert sizes == {name: thing.dimension for name, thing in stand_ins.items()}
    count = len(site.hits)
    keys = {name: thing.canonical and thing.canonical.key for name, thing in things_of(first).items()}
    for number, settings in enumerate((settings_of(site), Settings(), settings_of(site, library=False))):
        other = made(tmp_path / str(number), settings)
        assert {name: thing.canonical and thing.canonical.key for name, thing in things_of(other).items()} == keys
        assert {name: thing.dimension for name, thing in things_of(other).items()} == sizes
    assert len(site.hits) == count, "nothing is asked for again"


def test_the_same_answers_make_the_same_graph(site: Site, tmp_path: Path) -> None:
    settings = settings_of(site, library=False)
    assert made(tmp_path / "p", settings) == made(tmp_path / "q", settings)
    assert (site.count("/images"), site.count("/send")) == (3, 3)


def test_without_services_nothing_is_asked(site: Site, tmp_path: Path) -> None:
    graph = made(tmp_path, Settings())
    assert "file" not in sources_of(graph)
    assert all(thing.image_prompt for thing in things_of(graph).values())
    assert not site.hits


def test_one_kind_of_service_alone_makes_nothing(site: Site, tmp_path: Path) -> None:
    for number, services in enumerate(("openai@{0}", "hunyuan3d@{0}")):
        made(tmp_path / str(number), settings_of(site, services))
    made(tmp_path / "free", settings_of(site, licences="free"))
    assert not site.hits


def test_a_maker_that_fails_hands_over(site: Site, tmp_path: Path) -> None:
    site.pages["/send"] = Reply(status=400)
    TrellisWire(site).open()
    told: list[Event] = []
    graph = made(tmp_path / "p", settings_of(site, "openai@{0},hunyuan3d@{0},trellis@{0}"), told)
    assert {thing.canonical and thing.canonical.key.partition("/")[0] for thing in things_of(graph).values()} == {
        "trellis"
    }
    assert len([event for event in told if event.kind == "handover" and "trellis takes over" in event.message]) == 3
    assert not warnings_in(told, "nothing was made")


def test_an_image_model_that_fails_hands_over(site: Site, tmp_path: Path) -> None:
    good = site.pages["/images/generations"]
    refusal = said({"error": {"code": "moderation_blocked", "message": "no"}}, 400)
    site.pages["/images/generations"] = lambda hit: refusal if "orrery" in hit.json["prompt"] else good(hit)  # type: ignore[operator]
    told: list[Event] = []
    graph = made(tmp_path / "p", settings_of(site), told)
    assert sources_of(graph).count("file") == 2
    assert things_of(graph)["orrery"].image_prompt, "a person can paste it elsewhere"
    (warning,) = warnings_in(told, "nothing was made for the orrery")
    assert "stands in" in warning


def test_every_fault_of_everything_is_a_stand_in_and_one_sentence(site: Site, tmp_path: Path) -> None:
    wire = HunyuanWire(site)
    wire.open()
    good = dict(site.pages)
    faults: dict[str, dict[str, Any]] = {
        "no picture": {"/images/generations": Reply(status=402)},
        "garbage": {"/images/generations": Reply(b"garbage")},
        "no job": {"/send": Reply(status=403)},
        "a lost job": {"/send": Reply(status=500)},
    }
    for name, pages in faults.items():
        site.pages = {**good, **pages}
        told: list[Event] = []
        graph = made(tmp_path / name, settings_of(site, library=False), told)
        assert "file" not in sources_of(graph), name
        assert len(warnings_in(told, "nothing was made for the ")) == 1, name


def test_a_limit_that_is_reached_is_one_warning(site: Site, tmp_path: Path) -> None:
    wire = HunyuanWire(site)
    wire.polls = 10_000
    wire.open()
    told: list[Event] = []
    graph = made(tmp_path / "p", settings_of(site, service_limits={"minutes": 0.02}), told)
    assert "file" not in sources_of(graph)
    (warning,) = warnings_in(told, "nothing was made")
    assert "limit of 0.02 minutes" in warning
    assert len(SharedLibrary.open().jobs.unfinished()) == 1, "it works on one at a time"


def test_a_job_that_was_paid_for_is_not_given_to_another(
    site: Site, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wire = MeshyWire(site)
    wire.open()
    host = site.address.removeprefix("http://").replace(".", "_").replace(":", "_")
    monkeypatch.setenv(f"STORYBLENDER_KEY_{host}", SECRET)
    for number in (1, 2, 3):
        site.pages[f"/v1/image-to-3d/meshy-{number}"] = Reply(status=503)
    site.pages[wire.begin_path] = [said({"result": f"meshy-{number}"}, 202) for number in (1, 2, 3)]
    told: list[Event] = []
    graph = made(tmp_path, settings_of(site, "openai@{0},meshy@{0},hunyuan3d@{0}"), told)
    assert "file" not in sources_of(graph)
    assert site.count("/send") == 0, "it is paid for already"
    (text,) = warnings_in(told, "nothing was made for the zoetrope, the orrery and the theremin")
    assert "goes on there" in text
    assert len(SharedLibrary.open().jobs.unfinished()) == 3


def test_a_run_that_was_cancelled_goes_on_with_its_jobs(site: Site, tmp_path: Path) -> None:
    wire = HunyuanWire(site)
    wire.polls = 10_000
    wire.open()

    def stop(event: Event, cancelled: Signal) -> None:
        if event.role == "generate" and "hunyuan3d" in event.subject:
            cancelled.set()

    with pytest.raises(Cancelled):
        made(tmp_path / "p", settings_of(site), heard=stop)
    (job,) = SharedLibrary.open().jobs.unfinished()
    wire.jobs[job.remote_id] = wire.polls = 0
    assert sources_of(made(tmp_path / "p", settings_of(site))) == ["file"] * 3
    assert (site.count("/images"), site.count("/send")) == (3, 3)


class Examiner:
    """Gives the pictures of a thing scores, one after the other."""

    def __init__(self, scores: dict[str, list[float]]) -> None:
        self._scores = scores

    def answer(self, request: Any) -> str:
        assert request.pictures[0].png.startswith(b"\x89PNG")
        score = self._scores[request.subject].pop(0)
        faults = [] if score >= 8 else [{"message": f"the {request.subject} has no handle, {score}"}]
        return json.dumps({"score": score, "faults": faults})


def examined(crew: Crew, examiner: Examiner) -> Crew:
    return replace(crew, reference_picture=with_picture_critic(examiner, crew.reference_picture))


def test_pictures_are_examined_and_drawn_again_three_times_at_most(site: Site, tmp_path: Path) -> None:
    scores = {"zoetrope": [9.0], "orrery": [6.0, 8.5], "theremin": [3.0, 5.0, 7.0, 9.0]}
    told: list[Event] = []
    graph = made(tmp_path, settings_of(site), told, partial(examined, examiner=Examiner(scores)))
    things = things_of(graph)
    assert {name: thing.canonical and thing.canonical.source == "file" for name, thing in things.items()} == {
        "zoetrope": True,
        "orrery": True,
        "theremin": False,
    }
    assert [things[name].canonical.match_score for name in ("zoetrope", "orrery")] == [9.0, 8.5]  # type: ignore[union-attr]
    assert (site.count("/images"), site.count("/send")) == (1 + 2 + 3, 2)
    assert scores["theremin"] == [9.0], "a fourth one is not drawn"
    prompts = [hit.json["prompt"] for hit in site.hits if hit.path == "/images/generations"]
    assert sum("the orrery has no handle" in prompt for prompt in prompts) == 1
    (warning,) = warnings_in(told, "nothing was made for the theremin")
    assert "7 of 10" in warning


def test_an_empty_picture_is_not_paid_for_twice_over(site: Site, tmp_path: Path) -> None:
    out = io.BytesIO()
    Image.new("RGB", (256, 256), "white").save(out, "PNG")
    empty = said({"data": [{"b64_json": base64.b64encode(out.getvalue()).decode()}]})
    site.pages["/images/generations"] = empty
    told: list[Event] = []
    assert "file" not in sources_of(made(tmp_path / "p", settings_of(site), told))
    assert site.count("/send") == 0, "no model is made of nothing"


def test_no_key_is_in_any_file_or_message(site: Site, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    host = site.address.removeprefix("http://").replace(".", "_").replace(":", "_")
    names = (f"STORYBLENDER_KEY_{host}", "OPENAI_API_KEY", "MESHY_API_KEY")
    secrets = {name: f"sk-secret-{number}-of-ours" for number, name in enumerate(names)}
    for name, secret in secrets.items():
        monkeypatch.setenv(name, secret)
    told: list[Event] = []
    refusal = said({"error": {"message": f"bad key {secrets[f'STORYBLENDER_KEY_{host}']}"}}, 400)
    good = site.pages["/images/generations"]
    site.pages["/images/generations"] = lambda hit: refusal if "orrery" in hit.json["prompt"] else good(hit)  # type: ignore[operator]
    made(tmp_path / "p", settings_of(site), told)
    assert any(hit.headers.get("authorization", "").endswith("sk-secret-0-of-ours") for hit in site.hits)
    assert not any("sk-secret-1" in str(hit.headers) for hit in site.hits), "a provider's key is for its own servers"
    texts = [event.model_dump_json().encode() for event in told]
    roots = (tmp_path, SharedLibrary.open().files.root)
    texts += [path.read_bytes() for root in roots for path in root.rglob("*") if path.is_file()]
    assert len(texts) > 50
    assert not [text for text in texts if b"sk-secret" in text]


def test_meshy_at_an_address_of_ones_own_is_asked_without_its_key(site: Site, tmp_path: Path) -> None:
    MeshyWire(site).open()
    told: list[Event] = []
    graph = made(tmp_path / "p", settings_of(site, "openai@{0},meshy@{0}"), told)
    assert "file" not in sources_of(graph), "the wire refuses without a key"
