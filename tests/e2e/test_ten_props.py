"""Ten props from Poly Haven, Sketchfab, an image model and Hunyuan3D, to frames and credits."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import pytest
from PIL import Image

from storyblender.project import read_project_graph
from tests.services.makers import SECRET, HunyuanWire, openai_draws
from tests.services.site import Site, serving
from tests.services.story_with_services import EXPECTED, TOKEN, bytes_of, key_of, open_sites

pytestmark = [pytest.mark.blender, pytest.mark.slow, pytest.mark.timeout(1800)]
MADE = ("barograph", "orrery", "sextant", "theremin", "planchette")
SCRIPT = """Title: The Collector

INT. STUDY - NIGHT

ADA (60, blue cardigan) sits in an armchair. A guitar leans on the wall. A suitcase stands by the door.
A typewriter and a vase are on the desk. A barograph stands on the shelf. An orrery stands beside the window.

ADA
Nobody plays it any more.

BEN (30) enters. He puts a sextant on the desk and looks at the theremin beside the armchair.

BEN
And the planchette?

ADA
On the table.

A planchette lies on the table. Ben takes it.
"""


@contextmanager
def open_services() -> Iterator[tuple[tuple[Site, Site, Site], dict[str, str], str]]:
    """Run all services; yield their sites, the keys in the environment, and the setting that names them."""
    with open_sites() as (haven, fab), serving() as maker:
        openai_draws(maker, "")
        HunyuanWire(maker).open()
        host = maker.address.removeprefix("http://").replace(".", "_").replace(":", "_")
        keys = {**key_of(fab), f"STORYBLENDER_KEY_{host}": SECRET}
        names = {"poly_haven": haven, "sketchfab": fab, "openai": maker, "hunyuan3d": maker}
        yield (haven, fab, maker), keys, ",".join(f"{name}@{site.address}" for name, site in names.items())


@pytest.fixture
def script(tmp_path: Path) -> Path:
    path = tmp_path / "collector.fountain"
    path.write_text(SCRIPT)
    return path


def make(words: list[str], keys: Mapping[str, str]) -> None:
    """Make the story in a process of its own."""
    command = [sys.executable, "-m", "storyblender", "make", *words, "--quiet", "--no-animatic"]
    ran = subprocess.run(command, capture_output=True, env={**os.environ, **keys}, timeout=1500, check=False)
    assert ran.returncode == 0, ran.stderr


def sources_of(project: Path) -> dict[str, str]:
    """Return the first folder of every model from outside, by the name of its thing."""
    made = {asset.name: asset.canonical for asset in read_project_graph(project).assets if asset.canonical is not None}
    return {name: each.key.partition("/")[0] for name, each in made.items() if each.source == "file"}


def paid(maker: Site) -> dict[str, int]:
    """Return how often each picture and each model was ordered."""
    ordered = [hit for hit in maker.hits if hit.method == "POST"]
    return Counter(str(hit.json.get("prompt") or hit.json["image"][:2000]) for hit in ordered)


WANTED = {name: key.partition("/")[0] for name, key in EXPECTED.items()} | dict.fromkeys(MADE, "hunyuan3d")


def test_ten_props_from_outside_are_in_the_frames_and_the_credits(script: Path, tmp_path: Path) -> None:
    project = tmp_path / "p"
    with open_services() as ((haven, fab, maker), keys, services):
        words = [str(script), "--out", str(project), "--services", services, "--look", "fast", "--width", "480"]
        make(words, keys)
        assert sources_of(project) == WANTED
        assert set(paid(maker).values()) == {1} and len(paid(maker)) == 2 * len(MADE)
        frames = sorted((project / "frames").glob("SC*.png"))
        shots = read_project_graph(project).shots
        assert len(frames) == len(shots) > 2
        for frame in frames:
            with Image.open(frame) as picture:
                assert len(set(picture.convert("L").resize((48, 27)).getdata())) > 20, "a frame shows something"
        credits = (project / "credits.md").read_text()
        assert "CC0-1.0" in credits and "CC-BY-4.0" in credits and credits.count("Tencent Hunyuan") == len(MADE)
        everything = dict(bytes_of(tmp_path, Path(os.environ["STORYBLENDER_LIBRARY"])))
        secrets = (TOKEN.encode(), SECRET.encode())
        assert not [path for path, content in everything.items() if any(secret in content for secret in secrets)]
        asked = [len(site.hits) for site in (haven, fab, maker)]
        make(words, keys)
        assert [len(site.hits) for site in (haven, fab, maker)] == asked, "a finished project asks nothing"
