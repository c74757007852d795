"""A finished project, made once without Blender for all the tests that look at one or change a copy of it."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.home import SCRIPT, SETTINGS
from tests.no_retakes import no_retakes  # noqa: F401
from tests.stand_in_engine import StandInEngine

from storyblender.session import Session
from storyblender.studio import Studio


@pytest.fixture(scope="session")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the script ``home.fountain`` and its finished project ``p``."""
    folder = tmp_path_factory.mktemp("made")
    (folder / "home.fountain").write_text(SCRIPT)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
        patch.setenv("STORYBLENDER_LIBRARY", str(folder / "library"))
        Studio(SETTINGS).make(folder / "home.fountain", folder / "p")
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a copy of the project, with its script beside it."""
    monkeypatch.setattr("storyblender.studio.BlenderEngine", StandInEngine)
    shutil.copy(made / "home.fountain", tmp_path)
    return Path(shutil.copytree(made / "p", tmp_path / "p"))


@pytest.fixture
def session(folder: Path) -> Iterator[Session]:
    with Studio(SETTINGS).open(folder) as session:
        yield session
