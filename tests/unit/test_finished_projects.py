"""What the studio says about a finished project of which something is missing; Blender is stood in for."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from tests.stand_in_engine import StandInEngine

from storyblender import studio
from storyblender.errors import InputError
from storyblender.settings import REMEMBERED, Settings
from storyblender.studio import Studio
from storyblender.trace import Event

RELEASED = Path(__file__).parents[1] / "data" / "projects" / "schema-1"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(studio, "BlenderEngine", StandInEngine)
    return shutil.copytree(RELEASED, tmp_path / "p")


def warnings(folder: Path) -> list[str]:
    told: list[Event] = []
    Studio(Settings.load(project=folder), told.append).check(folder)
    return [event.message for event in told if event.kind == "warning"]


def test_missing_settings_are_said(folder: Path) -> None:
    assert not warnings(folder)
    (folder / REMEMBERED).unlink()
    assert warnings(folder) == ["settings.json is missing; look, width and lenses are the defaults"]


def test_what_is_rebuilt_is_said(folder: Path) -> None:
    (folder / "history" / "HEAD").unlink()
    assert warnings(folder) == ["history/HEAD was missing; the project is at its last change, number 28"]
    assert not warnings(folder)


@pytest.mark.parametrize("field", ["lighting", "layout", "environment"])
def test_a_scene_without_its_staging_is_not_made_yet(folder: Path, field: str) -> None:
    body = json.loads((folder / "graph.json").read_text())
    body["scenes"][1][field] = None
    (folder / "graph.json").write_text(json.dumps(body))
    for command in (lambda made: made.render(folder), lambda made: made.check(folder)):
        with pytest.raises(InputError, match=r"is planned, not made yet; run `storyblender make SCRIPT` first"):
            command(Studio(Settings.load(project=folder)))
