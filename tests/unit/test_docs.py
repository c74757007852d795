"""What the documents promise is there: commands, options, files of the project."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import typer

from storyblender.cli import app

ROOT = Path(__file__).parents[2]
DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
ROOMS = tuple(path.name for path in (ROOT / "src" / "storyblender").iterdir() if path.is_dir())


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_every_command_and_option_exists(document: Path) -> None:
    commands = typer.main.get_command(app).commands  # pyright: ignore[reportAttributeAccessIssue]
    for name, rest in re.findall(r"(?:^|[`/])storyblender (\w+)([^`\n#]*)", document.read_text("utf-8"), re.MULTILINE):
        options = {option for parameter in commands[name].params for option in parameter.opts}
        assert set(re.findall(r"(?<!\S)--[a-z-]+", rest)) <= options, f"{name}{rest}"


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_every_file_named_exists(document: Path) -> None:
    text = document.read_text("utf-8")
    named = re.findall(r"`((?:[\w-]+/)+[\w.-]*)`", text) + re.findall(r"\]\(([\w./-]+)\)", text)
    for name in named:
        places = (ROOT, ROOT / "src" / "storyblender", ROOT / "src" / "storyblender" / "blender", document.parent)
        if name.split("/")[0] in (*ROOMS, "src", "tests", "docs", "render"):
            assert any((place / name).exists() for place in places), name


def test_every_setting_named_in_the_readme_exists() -> None:
    from storyblender.settings import Settings

    text = (ROOT / "README.md").read_text("utf-8")
    passage = text[text.index("A `storyblender.toml`") : text.index("and more")]
    assert set(re.findall(r"`(\w+)`", passage)) <= set(Settings.model_fields)
