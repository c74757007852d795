"""A story whose props come from loopback Poly Haven and Sketchfab, to frames and to a .blend that credits them."""

from __future__ import annotations

import hashlib
import os
from pathlib import Path

import pytest

from storyblender.project import read_project_graph
from tests.e2e.conftest import SMALL, made
from tests.services.story_with_services import (
    EXPECTED,
    SCRIPT,
    TOKEN,
    bytes_of,
    downloads,
    key_of,
    open_sites,
    services_of,
)

pytestmark = [pytest.mark.blender, pytest.mark.slow, pytest.mark.timeout(900)]
bpy = pytest.importorskip("bpy")


def frames_of(project: Path) -> dict[str, str]:
    """Return the digests of the frames by name."""
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in (project / "frames").glob("*.png")}


def test_props_of_services_are_in_the_frames_and_credited(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    script, project = tmp_path / "study.fountain", tmp_path / "p"
    script.write_text(SCRIPT)
    with open_sites() as sites:
        for name, value in key_of(sites[1]).items():
            monkeypatch.setenv(name, value)
        arguments = [script, "--out", project, "--services", services_of(*sites), *SMALL, "--no-animatic"]
        made(arguments)
        asked = len(sites[0].hits) + len(sites[1].hits)
        frames = {
            path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in (project / "frames").glob("*.png")
        }
        made(arguments)
        assert len(sites[0].hits) + len(sites[1].hits) == asked, "a finished project asks nothing"
        assert set(downloads(*sites).values()) == {1}
    graph = read_project_graph(project)
    models = {asset.name: asset for asset in graph.assets if asset.canonical and asset.canonical.source == "file"}
    assert {name: asset.canonical and asset.canonical.key for name, asset in models.items()} == EXPECTED
    assert len(frames) == len(graph.cut) and frames == frames_of(project)
    chair = models["armchair"].canonical
    assert chair is not None and 0.8 < chair.dimensions[2] < 1.2, "a chair is as high as a chair"
    credits = (project / "credits.md").read_text()
    assert "CC-BY-4.0" in credits and "Rico Cilliers" in credits
    library = Path(os.environ["STORYBLENDER_LIBRARY"])
    assert not [path for path, content in bytes_of(project, library) if TOKEN.encode() in content]

    bpy.ops.wm.open_mainfile(filepath=str(project / "story.blend"))
    marked = {each.name: each.asset_data for each in bpy.data.collections if each.asset_data is not None}
    guitar = next(data for name, data in marked.items() if "guitar" in name)
    assert (guitar.author, guitar.license) == ("A. Maker", "CC-BY-4.0")
    things = bpy.data.scenes["SC010"].objects
    shown = {obj.get("asset_id") for obj in things if obj.type == "MESH"}
    assert {asset.asset_id for asset in models.values()} <= shown
