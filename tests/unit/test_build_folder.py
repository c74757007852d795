"""``build/`` on another disk: used where the user names it, and never because a project says so."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.stage import SETTINGS, Stage

from storyblender.build_folder import MARK, check_build_folder
from storyblender.errors import InputError
from storyblender.settings import REMEMBERED, Settings
from storyblender.studio import Studio

SCRIPT = "INT. ROOM - DAY\n\nANNA waits.\n"


def test_a_folder_named_beside_the_script_takes_the_place_of_build_and_is_remembered(tmp_path: Path) -> None:
    script = tmp_path / "s.fountain"
    script.write_text(SCRIPT)
    (tmp_path / "storyblender.toml").write_text('build = "disk/film"\n')
    settings = Settings.load(script)
    Studio(settings).plan(script, tmp_path / "p")
    assert (tmp_path / "disk" / "film" / MARK).read_text() == str(tmp_path / "p")
    (tmp_path / "p" / REMEMBERED).write_text(settings.remembered(tmp_path / "p"))
    assert Settings.load(project=tmp_path / "p").build == tmp_path / "disk" / "film"


def test_a_project_is_drawn_there_and_again_only_what_is_damaged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage, build = Stage(tmp_path / "p", monkeypatch), tmp_path / "disk"
    check_build_folder(build, stage.folder, take=True)
    settings = SETTINGS.model_copy(update={"build": build})
    Studio(settings).render(stage.folder)
    assert stage.engine.calls["render_frame"] == 3 and not list((stage.folder / "build").glob("*"))
    next((build / "frames").glob("*.png")).unlink()
    Studio(settings).render(stage.folder)
    assert stage.engine.calls == {"render_frame": 1}


@pytest.mark.parametrize("content", [None, "empty", "mine", "of another"])
def test_a_project_cannot_name_a_folder_that_is_not_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, content: str | None
) -> None:
    stage, build = Stage(tmp_path / "p", monkeypatch), tmp_path / "home"
    if content is not None:
        build.mkdir()
    if content == "mine":
        (build / "letter.txt").write_text("mine")
    if content == "of another":
        (build / MARK).write_text(str(tmp_path))
    before = {path: path.read_text() for path in build.rglob("*")}
    (stage.folder / REMEMBERED).write_text(json.dumps({"build": str(build)}))
    with pytest.raises(InputError, match=r"is not the build folder of this project.*storyblender.toml"):
        Studio(Settings.load(project=stage.folder)).render(stage.folder)
    assert build.exists() == (content is not None) and {path: path.read_text() for path in build.rglob("*")} == before


@pytest.mark.parametrize("content", ["mine", "of another"])
def test_nor_does_a_user_give_away_a_folder_in_use(tmp_path: Path, content: str) -> None:
    (tmp_path / (MARK if content == "of another" else "letter.txt")).write_text(str(tmp_path))
    with pytest.raises(InputError, match="is not the build folder of this project"):
        check_build_folder(tmp_path, Path("/another.storyboard"), take=True)
    (tmp_path / MARK).write_text("/a project that is gone")
    check_build_folder(tmp_path, Path("/another.storyboard"), take=True)
