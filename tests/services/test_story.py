"""A story whose props come from services: found, fetched once, credited; killed and resumed; faults are handed over."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event
from tests.services.quick_runs import hurry
from tests.services.site import Cut, Late, Reply, Site
from tests.services.story_with_services import (
    EXPECTED,
    SCRIPT,
    TOKEN,
    Killer,
    bytes_of,
    downloads,
    key_of,
    open_sites,
    services_of,
    started,
)

Sites = tuple[Site, Site]


@pytest.fixture
def sites(monkeypatch: pytest.MonkeyPatch) -> Iterator[Sites]:
    with open_sites() as sites:
        for name, value in key_of(sites[1]).items():
            monkeypatch.setenv(name, value)
        yield sites


@pytest.fixture
def script(tmp_path: Path) -> Path:
    path = tmp_path / "study.fountain"
    path.write_text(SCRIPT)
    return path


def make(script: Path, project: Path, services: str, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Make the story in this process with quick pauses; return the warnings."""
    told: list[Event] = []

    hurry(monkeypatch)
    settings = Settings(width=160, look="fast", animatic=False, jobs=1, services=services)
    Studio(settings, told.append).make(script, project)
    return [event.message for event in told if event.kind == "warning"]


def models_in(graph: ContinuityMemoryGraph) -> dict[str, str]:
    """Return the models from outside by the names of the things."""
    made = {asset.name: asset.canonical for asset in graph.assets if asset.canonical is not None}
    return {name: canonical.key for name, canonical in made.items() if canonical.source == "file"}


def test_five_props_come_from_two_services(
    sites: Sites, script: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    project = tmp_path / "p"
    assert make(script, project, services_of(*sites), monkeypatch) == []
    graph = read_project_graph(project)
    assert models_in(graph) == EXPECTED
    credits = (project / "credits.md").read_text()
    assert credits.endswith("\nPowered by [Poly Haven](https://polyhaven.com).\n")
    for told in (
        "Rico Cilliers, Greg Zaal",
        "CC0-1.0",
        "A. Maker",
        "CC-BY-4.0",
        "<https://polyhaven.com/a/ArmChair_01>",
    ):
        assert told in credits
    assert set(downloads(*sites).values()) == {1} and len(downloads(*sites)) == 3 * 3 + 2
    asked = len(sites[0].hits) + len(sites[1].hits)

    make(script, project, services_of(*sites), monkeypatch)
    assert len(sites[0].hits) + len(sites[1].hits) == asked, "a finished project asks nothing"
    assert read_project_graph(project) == graph

    make(script, tmp_path / "q", services_of(*sites), monkeypatch)
    assert models_in(read_project_graph(tmp_path / "q")) == EXPECTED
    assert set(downloads(*sites).values()) == {1}, "another project takes them from the library"

    library = Path(os.environ["STORYBLENDER_LIBRARY"])
    everything = dict(bytes_of(tmp_path, library))
    assert len(everything) > 50 and not [path for path, content in everything.items() if TOKEN.encode() in content]


def test_nothing_is_asked_without_services(
    sites: Sites, script: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    make(script, tmp_path / "p", "", monkeypatch)
    assert not models_in(read_project_graph(tmp_path / "p")) and not sites[0].hits and not sites[1].hits
    assert not (Path(os.environ["STORYBLENDER_LIBRARY"]) / "answers").exists()


ASSETS, CHAIR = "/assets", "/dl/1k/ArmChair_01/scene.bin"
SEARCH, GUITAR = "/search", "/archives/aaaabbbbccccdddd0000111122223333.zip"
FAULTS = {
    "the list fails": (ASSETS, Reply(status=500), {"armchair", "vase", "suitcase"}),
    "the list is a web page": (ASSETS, Reply(b"<html>", kind="text/html"), {"armchair", "vase", "suitcase"}),
    "a file is cut": (CHAIR, Cut(), {"armchair"}),
    "a file does not come": (CHAIR, Late(2), {"armchair"}),
    "a file is another": (CHAIR, Reply(b"evil"), {"armchair"}),
    "the search has too many requests": (SEARCH, Reply(status=429), {"guitar", "typewriter"}),
    "the archive is none": (GUITAR, Reply(b"PK"), {"guitar"}),
}


@pytest.mark.slow
@pytest.mark.parametrize(("where", "fault", "missing"), FAULTS.values(), ids=FAULTS.keys())
def test_what_a_service_cannot_give_comes_from_elsewhere(
    sites: Sites,
    script: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    where: str,
    fault: Reply,
    missing: set[str],
) -> None:
    site = next(each for each in sites if where in each.pages)
    good, site.pages[where] = site.pages[where], fault
    warnings = make(script, tmp_path / "p", services_of(*sites), monkeypatch)
    graph = read_project_graph(tmp_path / "p")
    assert models_in(graph) == {name: key for name, key in EXPECTED.items() if name not in missing}
    assert all(asset.canonical is not None for asset in graph.assets)
    assert [sentence for sentence in warnings if "poly" in sentence or "sketchfab" in sentence]
    assert TOKEN not in str(warnings)
    site.pages[where] = good


def test_both_services_may_be_away(script: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    warnings = make(script, tmp_path / "p", "poly_haven@http://127.0.0.1:1,sketchfab@http://127.0.0.1:2", monkeypatch)
    assert not models_in(read_project_graph(tmp_path / "p"))
    told = [sentence for sentence in warnings if "cannot be reached" in sentence]
    assert sorted(sentence.partition(":")[0] for sentence in told) == ["poly haven", "sketchfab"], "each is told once"
    trace = [json.loads(line) for line in (tmp_path / "p" / "trace.jsonl").read_text().splitlines()]
    kept = [event["message"] for event in trace if "cannot be reached" in event.get("message", "")]
    assert len(kept) == 2


def work_of(path: str) -> str:
    """Return the id of the work that a downloaded file is of."""
    return path.removeprefix("/dl/1k/").removeprefix("/archives/").partition("/")[0]


@pytest.mark.slow
@pytest.mark.parametrize("number", [1, 2, 4, 6, 8, 11, 13, 16])
def test_a_run_that_is_killed_goes_on_without_asking_twice(
    sites: Sites, script: Path, tmp_path: Path, number: int
) -> None:
    project = tmp_path / "p"
    killer = Killer(sites, number)
    words = [str(script), "--out", str(project), "--services", services_of(*sites)]
    child = started(words)
    killer.process = child.pid
    child.communicate(timeout=300)
    assert child.returncode == -9
    again = started(words)
    said, _ = again.communicate(timeout=300)
    assert again.returncode == 0, said
    assert models_in(read_project_graph(project)) == EXPECTED
    twice = {path for path, count in downloads(*sites).items() if count > 1}
    assert all(count <= 2 for count in downloads(*sites).values())
    assert {*map(work_of, twice)} <= {work_of(killer.last)}, "only the work that was under way is fetched anew"
