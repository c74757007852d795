"""Three things that no library has, drawn by OpenAI's wire and made by Hunyuan3D's, from the script to frames."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from storyblender.library.shared.shared_library import SharedLibrary
from storyblender.project import read_project_graph
from tests.e2e.conftest import SMALL, storyblender
from tests.services.makers import HunyuanWire, openai_draws
from tests.services.site import Act, Hit, Site, serving

pytestmark = [pytest.mark.blender, pytest.mark.slow, pytest.mark.timeout(900)]
pytest.importorskip("bpy")

SCRIPT = """INT. WORKSHOP - DAY

ADA (30, green coat) stands beside the table. An orrery is on the table. A samovar is on the table.
A theremin stands by the wall.

ADA
It still turns.
"""
THINGS = {"orrery", "samovar", "theremin"}
SECRET = "sk-a-secret-of-ours"


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch) -> Iterator[Site]:
    with serving() as site:
        openai_draws(site, "")
        HunyuanWire(site).open()
        host = site.address.removeprefix("http://").replace(".", "_").replace(":", "_")
        monkeypatch.setenv(f"STORYBLENDER_KEY_{host}", SECRET)
        yield site


def killed_at_a_look(site: Site, words: list[str | Path]) -> None:
    """Run ``make`` in a process of its own, and kill it at the first look at a job."""
    process = subprocess.Popen([sys.executable, "-m", "storyblender", *map(str, words)], stderr=subprocess.DEVNULL)
    good = site.pages["/send"]

    def send(hit: Hit) -> Act:
        act = good(hit)  # type: ignore[operator]
        path = next(path for path in site.pages if path.startswith("/status/"))
        look = site.pages[path]

        def die(hit: Hit) -> Act:
            os.kill(process.pid, signal.SIGKILL)
            site.pages[path] = look
            return look(hit)  # type: ignore[operator, return-value]

        site.pages[path] = die
        site.pages["/send"] = good
        return act

    site.pages["/send"] = send
    assert process.wait(600) == -9


def test_three_things_are_made_and_seen_in_the_frames(site: Site, tmp_path: Path) -> None:
    script, project = tmp_path / "workshop.fountain", tmp_path / "p"
    script.write_text(SCRIPT)
    services = f"openai@{site.address},hunyuan3d@{site.address}"
    words = ["make", script, "--out", project, *SMALL, "--no-animatic", "--services", services]
    killed_at_a_look(site, words)
    assert len(SharedLibrary.open().jobs.unfinished()) == 1
    done = storyblender(*words)
    assert done.returncode == 0, done.stderr[-3000:]
    assert (site.count("/images"), site.count("/send")) == (3, 3), "nothing is paid twice"
    graph = read_project_graph(project)
    made = {asset.asset_id: asset.canonical for asset in graph.assets if asset.canonical and asset.canonical.provenance}
    assert made.keys() == THINGS
    for canonical in made.values():
        assert canonical.key.startswith("hunyuan3d/")
        assert canonical.geometry_hash
        assert min(canonical.dimensions) > 0.02
    frames = sorted((project / "frames").glob("*.png"))
    assert frames
    with Image.open(frames[0]) as image:
        assert np.asarray(image.convert("L")).std() > 10, "there is something to see"
    credits = (project / "credits.md").read_text()
    assert all(name in credits for name in ("hunyuan3d", "Tencent Hunyuan community license"))
    for folder in (tmp_path, SharedLibrary.open().files.root):
        for path in folder.rglob("*"):
            assert path.is_dir() or SECRET.encode() not in path.read_bytes(), path
