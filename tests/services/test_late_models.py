"""A model that a run did not wait for is taken by the next, which pays nothing."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.memory.asset_sheet import Asset
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from storyblender.trace import Event
from tests.services.makers import HunyuanWire, openai_draws
from tests.services.quick_runs import hurry
from tests.services.site import Site, serving

SCRIPT = """INT. WORKSHOP - DAY

ADA (30, green coat) stands beside the table. An orrery is on the table.

ADA
It still turns.
"""


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch) -> Iterator[Site]:
    hurry(monkeypatch)
    with serving() as site:
        openai_draws(site, "")
        yield site


def make(site: Site, folder: Path, minutes: float = 0.02) -> list[Event]:
    script, told = folder / "workshop.fountain", list[Event]()
    script.write_text(SCRIPT)
    services = f"openai@{site.address},hunyuan3d@{site.address}"
    limits = {"minutes": minutes}
    settings = Settings(width=160, look="fast", animatic=False, jobs=1, services=services, service_limits=limits)
    Studio(settings, told.append).make(script, folder / "p")
    return told


def orrery(folder: Path) -> Asset:
    return read_project_graph(folder / "p").asset("orrery")


def test_the_next_make_takes_what_a_limit_cut_short(site: Site, tmp_path: Path) -> None:
    wire = HunyuanWire(site)
    wire.polls = 10_000
    wire.open()
    make(site, tmp_path)
    stand_in = orrery(tmp_path)
    assert stand_in.image_prompt and stand_in.canonical and stand_in.canonical.source == "stand_in"
    make(site, tmp_path)
    assert orrery(tmp_path) == stand_in, "it works on, and is not waited for"
    (job,) = SharedLibrary.open().jobs.unfinished()
    wire.jobs[job.remote_id] = 0
    told = make(site, tmp_path)
    made = orrery(tmp_path)
    assert made.canonical and made.canonical.key.startswith("hunyuan3d/") and made.canonical.geometry_hash
    assert not made.image_prompt
    assert any(event.kind == "accept" and "earlier run" in event.message for event in told)
    assert (site.count("/images"), site.count("/send")) == (1, 1), "nothing is paid for again"
    assert not any(scene.stale for scene in read_project_graph(tmp_path / "p").scenes)
