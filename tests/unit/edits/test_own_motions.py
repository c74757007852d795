"""Motions of the user's own by hand: named like any motion, kept in the project, taken back with undo."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.motion_files import a_person, write_bvh
from tests.unit.conftest import SETTINGS

from storyblender.agents.vocabulary import vocabulary
from storyblender.edits.words import edits_of, motion_edit
from storyblender.errors import InputError
from storyblender.geometry.rotations import about_axis
from storyblender.memory.mocap import MocapClip, mocap_file
from storyblender.memory.shot_context import Cue
from storyblender.session import Session
from storyblender.studio import Studio

SHOT = "SC010_SH020"


@pytest.fixture
def clips(tmp_path: Path) -> Path:
    folder = tmp_path / "clips"
    folder.mkdir()
    waves = a_person(30.0, 3.0, lambda t: {"upper_arm.R": about_axis(1, np.array(1.2 * np.sin(2 * t)))})
    (folder / "frantic_signal_03.bvh").write_text(write_bvh(waves))
    strides = a_person(
        30.0, 3.0, lambda t: {"place": np.array([0.0, -8.0 * t, 0.0]), "head": about_axis(2, np.array(t))}
    )
    (folder / "long_march.bvh").write_text(write_bvh(strides))
    endless = a_person(30.0, 3.0, lambda t: {"place": np.array([0.0, -90.0 * t, 0.0])})
    (folder / "endless.bvh").write_text(write_bvh(endless))
    (folder / "broken.bvh").write_text("HIERARCHY\n")
    (folder / "credits.toml").write_text('author = "Ann"\nlicense = "CC-BY-4.0"\n')
    return folder


@pytest.fixture
def session(folder: Path, clips: Path) -> Iterator[Session]:
    with Studio(SETTINGS.model_copy(update={"motions": (clips,)})).open(folder) as session:
        yield session


def does(person: str, **motions: dict[str, Any] | None) -> dict[str, Any]:
    return {"kind": "blocking", "shot": SHOT, "person": person, "marks": {"motions": motions}}


def apply(session: Session, *edits: dict[str, Any]) -> None:
    session.draw(session.apply(edits_of(list(edits))))


def own(session: Session) -> list[Cue]:
    return [cue for cue in session.graph.shot(1, 2).cues if cue.mocap is not None]


def test_a_clip_is_added_by_its_name_and_taken_back(session: Session, clips: Path) -> None:
    before = (session.folder / "graph.json").read_bytes()
    apply(session, does("tom", frantic_signal={"at": 1.0, "target": "anna"}))
    [cue] = own(session)
    assert (cue.asset_id, cue.target_id) == ("tom", "anna")
    assert cue.start >= 24
    assert (session.folder / mocap_file(cue.mocap or "")).is_file()
    assert "CC-BY-4.0" in (session.folder / "credits.md").read_text()
    shutil.rmtree(clips)
    apply(session, does("tom", frantic_signal_03={"at": 2.0}))
    assert own(session)[0].start >= 48, "the project has it, without the folder"
    assert own(session)[0].mocap == cue.mocap
    apply(session, does("tom", frantic_signal_03=None))
    assert not own(session)
    for _ in range(3):
        session.undo()
    assert (session.folder / "graph.json").read_bytes() == before


def test_a_clip_without_room_is_played_on_the_spot_and_told(session: Session) -> None:
    apply(session, does("tom", long_march={}))
    [cue] = own(session)
    assert cue.mark is None
    assert any("no room" in flaw.message for flaw in session.graph.shot(1, 2).flaws)


@pytest.mark.parametrize(
    ("motions", "said"),
    [
        ({"broken": {}}, "cannot be used"),
        ({"endless": {}}, "travels"),
        ({"no_such_clip": {}}, "no motion"),
        ({"frantic": {"mocap": {"digest": "a" * 32, "name": "x", "seconds": 1,
                                "provenance": {"source": "motions", "file": "x"}}}}, "there is no mocap/"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused_in_a_sentence(motions: dict[str, Any], said: str, session: Session) -> None:
    before = session.revision
    with pytest.raises(InputError, match=said):
        apply(session, does("tom", **motions))
    assert session.revision == before


def test_a_digest_is_never_a_path() -> None:
    with pytest.raises(ValueError, match="digest"):
        MocapClip.model_validate(
            {"digest": "../../etc/passwd", "name": "x", "seconds": 1, "provenance": {"source": "motions", "file": "x"}}
        )


def test_the_command_line_says_the_same(session: Session) -> None:
    session.apply([motion_edit(SHOT, "tom", "Frantic Signal", {"at": 1.0})])
    marks = session.graph.shot(1, 2).blocking_decision
    assert marks is not None
    [motion] = marks.people["tom"].motions.values()
    assert motion is not None and motion.mocap is not None
    assert "frantic_signal_03.bvh" in motion.words


def test_clips_are_offered_with_the_motions_of_the_catalogue_and_marked(session: Session, clips: Path) -> None:
    offered = session.own_motions
    assert offered["long_march"] == "long march (yours, long_march.bvh)"
    apply(session, does("tom", frantic_signal_03={}))
    (clips / "frantic_signal_03.bvh").unlink()
    assert "in this project" in session.own_motions["frantic_signal_03"]
    assert vocabulary(session.own_motions)["own_motions"]["frantic_signal_03"]
