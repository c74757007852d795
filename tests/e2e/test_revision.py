"""A changed script over a finished project: what a person set stays, untouched scenes keep their pictures."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.project import read_project_graph
from tests.e2e.conftest import SCRIPT, SMALL, made, storyblender

pytestmark = [pytest.mark.blender, pytest.mark.slow, pytest.mark.timeout(1500)]

GARDEN = """
EXT. GARDEN - NIGHT

Tom sits on the bench. Ada comes through the gate.

TOM
It is late.
"""


def frames(project: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in (project / "frames").glob("SC*.png")}


def test_a_changed_script_keeps_cameras_and_pictures(tmp_path: Path) -> None:
    script, project = tmp_path / "cups.fountain", tmp_path / "p"
    script.write_text(SCRIPT + GARDEN)
    arguments = [script, "--out", project, *SMALL, "--no-animatic"]
    made(arguments)
    assert storyblender("edit", project, "SC010_SH020", "--size", "CU", "--quiet").returncode == 0
    before, graph = frames(project), read_project_graph(project)

    script.write_text((SCRIPT + GARDEN).replace("Two Cups", "Three Cups"))
    made(arguments)
    assert frames(project) == before
    titled = read_project_graph(project)
    assert titled.title == "Three Cups" and titled.scenes == graph.scenes
    assert [shot.camera for shot in titled.shots] == [shot.camera for shot in graph.shots]

    script.write_text((SCRIPT + GARDEN).replace("It is late.", "It is much too late."))
    made(arguments)
    changed = frames(project)
    assert {name for name in before if changed.get(name) != before[name]} <= {n for n in before if "SC020" in n}
    kept = next(shot for shot in read_project_graph(project).shots if shot.camera_decision)
    assert kept.camera_instruction.size == "CU"

    for _ in range(2):
        assert storyblender("undo", project).returncode == 0
    assert read_project_graph(project) == graph
    assert storyblender("render", project, "--quiet").returncode == 0
    assert frames(project) == before
