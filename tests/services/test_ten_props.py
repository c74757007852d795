"""Ten props of one story from Poly Haven, Sketchfab, OpenAI and TRELLIS or Hunyuan3D; killed, and resumed.

TRELLIS lists its jobs, so that one is found whose id got lost; a Hunyuan3D server does not.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.project import read_project_graph
from tests.services.makers import HunyuanWire, TrellisWire, Wire, openai_draws
from tests.services.site import Site, serving
from tests.services.story_with_services import (
    EXPECTED,
    SCRIPT,
    Killer,
    downloads,
    key_of,
    open_sites,
    services_of,
    started,
)

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]

TEN = SCRIPT.replace(
    "are on the desk.",
    "are on the desk.\n\nA theremin stands by the wall. An orrery is on the desk. A samovar is on the desk.\n"
    "A sextant is on the desk. A hookah is on the desk.",
)
MADE = ("hookah", "orrery", "samovar", "sextant", "theremin")


class Workplace:
    """The four services."""

    def __init__(self, haven: Site, fab: Site, makers: Site, wire: Wire) -> None:
        self.sites = (haven, fab, makers)
        self.killed_at = ""
        openai_draws(makers, "")
        self.begins, wire.polls = wire.begin_path, 0
        wire.open()
        address = makers.address
        self.setting = f"{services_of(haven, fab)},openai@{address},{wire.name}@{address}"

    def make(self, script: Path, project: Path, kill_at: int = -1) -> int:
        """Make the story in a process, and return its exit code."""
        killer = Killer(self.sites, kill_at)
        child = started([str(script), "--out", str(project), "--services", self.setting])
        killer.process = child.pid
        said, _ = child.communicate(timeout=600)
        assert child.returncode in (0, -9), said
        self.killed_at = self.killed_at or killer.last
        return child.returncode

    def paid(self) -> Counter[bytes]:
        """Return how often each picture was drawn and each model begun, by what was asked."""
        hits = [hit for hit in self.sites[2].hits if hit.path in ("/images/generations", self.begins)]
        return Counter(hit.body.partition(b'"image_name"')[0] for hit in hits)


@pytest.fixture(params=[TrellisWire, HunyuanWire])
def place(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[Workplace]:
    with open_sites() as (haven, fab), serving() as makers:
        for name, value in key_of(fab).items():
            monkeypatch.setenv(name, value)
        yield Workplace(haven, fab, makers, request.param(makers))


def files_in(project: Path) -> dict[str, str]:
    """Return the keys of the models from outside by the names of the things."""
    made = {asset.name: asset.canonical for asset in read_project_graph(project).assets if asset.canonical is not None}
    return {name: canonical.key for name, canonical in made.items() if canonical.source == "file"}


def test_ten_props_come_from_four_services(place: Workplace, tmp_path: Path) -> None:
    script = tmp_path / "study.fountain"
    script.write_text(TEN)
    assert place.make(script, tmp_path / "p") == 0
    found = files_in(tmp_path / "p")
    assert {name: key for name, key in found.items() if name in EXPECTED} == EXPECTED
    assert [name for name in found if name in MADE] and found.keys() == {*EXPECTED, *MADE}
    assert place.paid().total() == 10
    assert set(place.paid().values()) == {1}


@pytest.mark.parametrize("number", [14, 20, 25, 29])
def test_killed_at_a_request_nothing_is_paid_twice(place: Workplace, tmp_path: Path, number: int) -> None:
    script, project = tmp_path / "study.fountain", tmp_path / "p"
    script.write_text(TEN)
    assert place.make(script, project, number) == -9
    assert place.make(script, project) == 0
    assert set(place.paid().values()) == {1}, "each is asked once, before or after"
    found, ledger = files_in(project), SharedLibrary.open().jobs
    in_doubt = ledger.unfinished()
    assert {name: key for name, key in found.items() if name in EXPECTED} == EXPECTED
    assert all(count <= 2 for count in downloads(*place.sites[:2]).values())
    if place.killed_at in ("/images/generations", HunyuanWire.begin_path):
        assert in_doubt and found.keys() >= {*EXPECTED}, "what nobody knows of is not asked for again by itself"
        for job in in_doubt:
            ledger.ask_again(job.id)
        assert place.make(script, tmp_path / "q") == 0
        found = files_in(tmp_path / "q")
        assert max(place.paid().values()) <= 2, "a person asked for it"
    assert found.keys() == {*EXPECTED, *MADE}
