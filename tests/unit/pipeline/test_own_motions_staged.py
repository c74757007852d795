"""A script whose people move as in the user's clips: chosen while the scene is staged, kept, credited, explained."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
from tests.home import SETTINGS
from tests.motion_files import a_person, write_bvh
from tests.stand_in_engine import StandInEngine

from storyblender.geometry.rotations import about_axis
from storyblender.memory.mocap import mocap_file
from storyblender.studio import Studio
from storyblender.trace import Event

SCRIPT = """INT. KITCHEN - DAY

TOM and ANNA stand at the table.

Tom shrugs.

TOM
(angrily)
I told you a hundred times, and you never listen to me.

Anna salutes.
"""


@pytest.fixture
def clips(tmp_path: Path) -> Path:
    folder = tmp_path / "clips"
    folder.mkdir()
    for number, name in enumerate(("shrug_01", "angry_argument_02")):
        moves = a_person(30.0, 2.0, lambda t, n=number: {"head": about_axis(2, np.array(0.5 * np.sin(2 * t + n)))})
        (folder / f"{name}.bvh").write_text(write_bvh(moves))
    (folder / "salute.bvh").write_text("HIERARCHY\nROOT\n")
    (folder / "credits.toml").write_text('author = "Ann Example"\n')
    return folder


def test_actions_are_played_by_clips_that_do_them(tmp_path: Path, clips: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    (tmp_path / "s.fountain").write_text(SCRIPT)
    heard: list[Event] = []
    settings = SETTINGS.model_copy(update={"motions": (clips,)})
    folder = tmp_path / "p"
    Studio(settings, heard.append).make(tmp_path / "s.fountain", folder)
    with Studio(settings).open(folder) as session:
        graph = session.graph
        played = {(cue.asset_id, cue.clip): cue.mocap for shot in graph.shots for cue in shot.cues if cue.mocap}
        assert {*played} == {("tom", "shrug"), ("tom", "talk")}
        assert all((folder / mocap_file(digest or "")).is_file() for digest in played.values())
    assert any("salute.bvh" in event.message for event in heard if event.kind == "warning"), "told, and acted as usual"
    assert any(cue.clip == "salute" for shot in graph.shots for cue in shot.cues)
    assert "shrug_01.bvh" in (folder / "trace.jsonl").read_text()
    assert "Ann Example" in (folder / "credits.md").read_text()
    before = (folder / "graph.json").read_bytes()
    shutil.rmtree(clips)
    with Studio(SETTINGS).open(folder) as session:
        session.render()
    assert (folder / "graph.json").read_bytes() == before, "without the folder it is as it was"


def test_without_clips_nothing_is_otherwise(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    (tmp_path / "s.fountain").write_text(SCRIPT)
    empty = tmp_path / "none"
    empty.mkdir()
    Studio(SETTINGS).make(tmp_path / "s.fountain", tmp_path / "a")
    Studio(SETTINGS.model_copy(update={"motions": (empty,)})).make(tmp_path / "s.fountain", tmp_path / "b")
    one, two = ((tmp_path / name / "graph.json").read_bytes() for name in "ab")
    assert one == two
    assert b"mocap" not in one
