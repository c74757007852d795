"""Pictures of a surface that a person chose for a set: which scenes show them, how they go again, what is kept."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.stand_in_engine import StandInEngine
from tests.textures import write_surface

from storyblender.catalog.sets import plan_of
from storyblender.edits.words import edits_of
from storyblender.errors import InputError
from storyblender.memory.scene_context import Environment
from storyblender.project import read_project_graph
from storyblender.session import Session
from storyblender.settings import Settings
from storyblender.studio import Studio

SCRIPT = """INT. KITCHEN - DAY

ANN (40) waits.

EXT. MEADOW - DAY

ANN waits.

INT. KITCHEN - NIGHT

ANN waits.
"""


@pytest.fixture
def session(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Session:
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    script, project = tmp_path / "a.fountain", tmp_path / "a.storyboard"
    script.write_text(SCRIPT)
    studio = Studio(Settings.model_validate({"width": 160, "look": "fast", "animatic": False}))
    studio.make(script, project)
    return studio.open(project)


def decide(session: Session, scene: str, **decision: object) -> None:
    edit = {"kind": "set", "scene": scene, "decision": decision}
    session.draw(session.apply(edits_of([edit])))


def sets(session: Session) -> list[Environment]:
    return [scene.environment for scene in session.graph.scenes if scene.environment is not None]


def test_every_scene_of_the_place_shows_it_until_something_else_is_decided(session: Session, tmp_path: Path) -> None:
    plain = session.graph
    texture = session.take_in_texture(write_surface(tmp_path / "oak"), 1.5)
    decide(session, "SC010", wall_texture=texture.model_dump())
    kitchen, meadow, night = sets(session)
    assert kitchen.wall_texture == night.wall_texture == texture and not meadow.textures
    walls = plan_of(kitchen).walls
    assert all(wall.texture == texture and wall.dado is None for wall in walls)
    assert session.graph.shots == plain.shots or all(shot.camera for shot in session.graph.shots)
    assert all((session.folder / name).is_file() for name in texture.files)
    credits = (session.folder / "credits.md").read_text()
    assert "walls" in credits and "Ann Joiner" in credits and "CC0" in credits
    assert session.graph.scene(1).set_decision.words == "wall texture oak_boards_diff_1k.png"  # pyright: ignore
    decide(session, "SC030", walls="brick")
    assert [each.wall_texture for each in sets(session)] == [None] * 3
    assert not (session.folder / "credits.md").exists()
    session.undo()
    assert sets(session)[0].wall_texture == texture
    session.undo()
    assert session.graph.scenes == plain.scenes
    assert read_project_graph(session.folder) == session.graph


def test_none_takes_it_off_and_a_finish_stays_under_it(session: Session, tmp_path: Path) -> None:
    texture = session.take_in_texture(write_surface(tmp_path / "oak"))
    decide(session, "SC020", ground="gravel")
    decide(session, "SC020", ground_texture=texture.model_dump())
    assert sets(session)[1].ground_texture == texture and sets(session)[1].ground == "gravel"
    decide(session, "SC020", ground_texture="none")
    assert sets(session)[1].ground_texture is None and sets(session)[1].ground == "gravel"


def test_a_set_without_walls_is_refused(session: Session, tmp_path: Path) -> None:
    texture = session.take_in_texture(write_surface(tmp_path / "oak"))
    with pytest.raises(InputError, match="has no walls"):
        decide(session, "SC020", wall_texture=texture.model_dump())


def test_a_picture_that_is_gone_is_named_and_can_be_taken_in_again(session: Session, tmp_path: Path) -> None:
    folder = write_surface(tmp_path / "oak")
    texture = session.take_in_texture(folder)
    decide(session, "SC010", ground_texture=texture.model_dump())
    (session.folder / texture.files[0]).unlink()
    with pytest.raises(InputError, match="this picture of a surface is gone"):
        session.render()
    session.take_in_texture(folder)
    session.render()


def test_without_one_no_file_mentions_it(session: Session) -> None:
    for name in ("graph.json", "trace.jsonl", "drafts.jsonl", "settings.json"):
        assert "texture" not in (session.folder / name).read_text()
