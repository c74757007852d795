"""A picture of any entry: of a thing alone, and of what takes a story to show."""

from __future__ import annotations

from pathlib import Path

import pytest
from PIL import Image, ImageStat
from typer.testing import CliRunner

from storyblender.cli import app

pytestmark = pytest.mark.blender


@pytest.mark.parametrize(("kind", "key"), [("materials", "brick"), ("motions", "nod")])
def test_a_picture_of_an_entry(tmp_path: Path, kind: str, key: str) -> None:
    path = tmp_path / "new" / "picture.png"
    done = CliRunner().invoke(app, ["catalog", kind, "--picture", key, "--out", str(path)])
    assert done.exit_code == 0, done.output
    with Image.open(path) as picture:
        assert ImageStat.Stat(picture.convert("L")).stddev[0] > 10


def test_a_picture_of_nothing_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "picture.png"
    for words in (["nowhere", "--picture", "brick"], ["sets", "--picture", "brick"], ["--picture", "nobody"]):
        assert CliRunner().invoke(app, ["catalog", *words, "--out", str(path)]).exit_code == 2
    assert not path.exists()
