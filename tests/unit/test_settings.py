"""Settings: defaults, the file beside the script, the command line."""

from __future__ import annotations

from pathlib import Path

import pytest

from storyblender.errors import InputError
from storyblender.settings import REMEMBERED, Settings


def test_the_command_line_wins_over_the_file_over_the_defaults(tmp_path: Path) -> None:
    (tmp_path / "storyblender.toml").write_text('look = "pencil"\nfps = 25\n')
    settings = Settings.load(tmp_path / "a.fountain", look="fast", seed=None)
    assert (settings.look, settings.fps, settings.seed) == ("fast", 25, 0)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("look = ", "cannot be read as settings"),
        ('look = "oil"', "'look'"),
        ("fps = 1000", "'fps'"),
        ("colour = 1", "'colour'"),
    ],
)
def test_bad_settings_are_one_clear_error(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "storyblender.toml").write_text(text)
    with pytest.raises(InputError, match=words):
        Settings.load(tmp_path / "a.fountain")


def test_a_project_remembers_its_settings(tmp_path: Path) -> None:
    made = Settings(look="pencil", lens_kit=(35.0, 75.0), jobs=2, models=tmp_path)
    (tmp_path / REMEMBERED).write_text(made.remembered())
    again = Settings.load(project=tmp_path, animatic=False)
    assert again == Settings(look="pencil", lens_kit=(35.0, 75.0), animatic=False)
    assert Settings.load(project=tmp_path, look="fast").look == "fast"
    assert Settings.load(project=tmp_path / "older") == Settings()


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("lens_kit = [35, -3]", r"storyblender.toml: setting 'lens_kit.1' cannot be -3; it should be greater"),
        ("[thresholds]\nbaker = 3", r"'thresholds.baker' cannot be 'baker'; it should be 'asset_retriever'"),
        ("[horizons]\nanimator = 0", r"'horizons.animator' cannot be 0"),
        ("colour = 1", r"storyblender.toml: there is no setting 'colour'; it is one of look, "),
    ],
)
def test_an_error_names_the_file_and_what_may_stand_there(tmp_path: Path, text: str, says: str) -> None:
    (tmp_path / "storyblender.toml").write_text(text)
    with pytest.raises(InputError, match=says):
        Settings.load(tmp_path / "a.fountain")
    with pytest.raises(InputError, match=r"^setting 'fps' cannot be 0"):
        Settings.load(tmp_path / "b" / "a.fountain", fps=0)


@pytest.mark.parametrize(("said", "ratio"), [("16:9", 16 / 9), ("9:16", 9 / 16), ("2.39:1", 2.39), ("1.85", 1.85)])
def test_an_aspect_is_read_as_people_write_it(tmp_path: Path, said: str, ratio: float) -> None:
    assert Settings.load(aspect=said).aspect == pytest.approx(ratio)
    (tmp_path / "storyblender.toml").write_text(f'aspect = "{said}"')
    assert Settings.load(tmp_path / "a.fountain").aspect == pytest.approx(ratio)


@pytest.mark.parametrize("said", ["16:0", "wide", "16:", "9:1:2"])
def test_an_aspect_that_is_none_is_refused(said: str) -> None:
    with pytest.raises(InputError, match="'aspect' cannot be"):
        Settings.load(aspect=said)
