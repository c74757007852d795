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
    made = Settings(look="pencil", lens_kit=(35.0, 75.0), jobs=2)
    (tmp_path / REMEMBERED).write_text(made.remembered(tmp_path))
    again = Settings.load(project=tmp_path, animatic=False)
    assert again == Settings(look="pencil", lens_kit=(35.0, 75.0), animatic=False)
    assert Settings.load(project=tmp_path, look="fast").look == "fast"
    assert Settings.load(project=tmp_path / "older") == Settings()


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("lens_kit = [35, -3]", r"storyblender.toml:1: setting 'lens_kit.1' cannot be -3; it should be greater"),
        ("[thresholds]\nbaker = 3", r"'thresholds.baker' cannot be 'baker'; it should be 'director'"),
        ("[horizons]\nanimator = 0", r"'horizons.animator' cannot be 0"),
        ("colour = 1", r"storyblender.toml:1: there is no setting 'colour'; it is one of look, "),
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


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("a = " + "[" * 5000, "nested too deeply"),
        ("a = " + "{b = " * 5000, "nested too deeply"),
        ("fps = nan", "toml:1: setting 'fps' cannot be nan"),
        ("\nfps = 1e999", "toml:2: setting 'fps' cannot be inf"),
        ("aspect = nan", "toml:1: setting 'aspect' cannot be nan"),
        ("sensor_width = -inf", "'sensor_width' cannot be -inf"),
        ("[thresholds]\nanimator = nan", r"toml:2: setting 'thresholds.animator' cannot be nan"),
        (f"seed = {'9' * 5000}", "a number has thousands of digits"),
        (f"seed = {2**64}", "'seed' cannot be 18446744073709551616; it should be less than 4294967296"),
        ("width = 7680\naspect = 0.4", "a picture 7680 wide at this aspect is 19200 high, and 7680 is the most"),
        ("start_timecode = '1:00'", "toml:1: setting 'start_timecode' cannot be '1:00'; it should be hours, minutes"),
        ("start_timecode = '01:00:00:24'", "ends in frame 24, and there are 24 frames a second"),
        (f"look = '{'x' * 5000}'", r"'look' cannot be 'xxx.{1,60}xxx'; it should be"),
        (f"shots_per_scene = [{'1,' * 5000}]", r"'shots_per_scene' cannot be \[1, 1, 1, 1, 1, 1, \.\.\.\]"),
        ("# a note\n\nfps = 24\ncolour = 1", "storyblender.toml:4: there is no setting 'colour'"),
        ("fps = 24\nlook = ", r"toml:2: cannot be read as settings \(Invalid value\); mend or delete it"),
        ("look = \\", r"toml:1: cannot be read as settings"),
        ("\n" * 2**21, "far too long"),
        ("lens_kit = 35", "'lens_kit' cannot be 35; it should be a valid list"),
    ],
    ids=lambda value: value[:24],
)
def test_whatever_stands_in_the_file_is_answered_with_a_sentence(tmp_path: Path, text: str, says: str) -> None:
    (tmp_path / "storyblender.toml").write_text(text)
    with pytest.raises(InputError, match=says) as caught:
        Settings.load(tmp_path / "a.fountain")
    assert len(str(caught.value)) < 500 and "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"[" * 100_000, "nested too deeply"),
        (b'{"a":' * 100_000, "nested too deeply"),
        (b'{\n"fps": NaN}', "settings.json:2: setting 'fps' cannot be nan"),
        (b'{"seed": ' + b"9" * 5000 + b"}", "thousands of digits"),
        (b'{"look": \xff}', "not UTF-8 text"),
        (b'{\n"look": }', r"settings.json:2: cannot be read as settings \(Expecting value\)"),
        (b"", "cannot be read as settings"),
    ],
    ids=lambda value: str(value[:16]),
)
def test_remembered_settings_are_read_with_the_same_care(tmp_path: Path, content: bytes, says: str) -> None:
    (tmp_path / REMEMBERED).write_bytes(content)
    with pytest.raises(InputError, match=says):
        Settings.load(project=tmp_path)


def test_a_file_from_an_editor_that_marks_its_bytes_is_read(tmp_path: Path) -> None:
    (tmp_path / "storyblender.toml").write_bytes(b"\xef\xbb\xbffps = 25\r\n")
    assert Settings.load(tmp_path / "a.fountain").fps == 25


def test_a_folder_of_models_lies_beside_the_file_that_names_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir("/")
    (tmp_path / "storyblender.toml").write_text("models = 'things/glb'")
    assert Settings.load(tmp_path / "a.fountain").models == (tmp_path / "things" / "glb",)
    assert Settings.load(tmp_path / "a.fountain", models=Path("mine")).models == (Path("mine"),), (
        "typed where one stands"
    )
    (tmp_path / "storyblender.toml").write_text("models = ['a', '/b']")
    assert Settings.load(tmp_path / "a.fountain").models == (tmp_path / "a", Path("/b")), "in the order of preference"
    (tmp_path / "storyblender.toml").write_text("models = 3")
    with pytest.raises(InputError, match="'models' cannot be 3"):
        Settings.load(tmp_path / "a.fountain")


def test_a_project_remembers_its_folder_of_models_where_it_is_moved_with_it(tmp_path: Path) -> None:
    project, near, far = (tmp_path / name for name in ("work/a.storyboard", "work/models", "elsewhere/models"))
    for folder in (project, near, far):
        folder.mkdir(parents=True)
    (project / REMEMBERED).write_text(Settings(models=(far, near)).remembered(project))
    moved = (tmp_path / "work").rename(tmp_path / "moved")
    again = Settings.load(project=moved / "a.storyboard").models
    assert [folder.resolve() for folder in again] == [far, moved / "models"]


def test_make_takes_the_folder_of_models_that_the_project_was_made_with(tmp_path: Path) -> None:
    script, project = tmp_path / "a.fountain", tmp_path / "a.storyboard"
    project.mkdir()
    kept, other = tmp_path / "models", tmp_path / "other"
    (project / REMEMBERED).write_text(Settings(models=(kept,), look="pencil").remembered(project))
    again = Settings.load(script, project)
    assert [folder.resolve() for folder in again.models] == [kept] and again.look == Settings().look
    assert Settings.load(script, project, models=other).models == (other,)
    (tmp_path / "storyblender.toml").write_text("models = 'other'")
    assert Settings.load(script, project).models == (other,)
