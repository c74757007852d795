"""What the documents promise is there: commands, options, files of the project."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
import typer

from storyblender.cli import app
from storyblender.settings import Settings

ROOT = Path(__file__).parents[2]
DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
ROOMS = tuple(path.name for path in (ROOT / "src" / "storyblender").iterdir() if path.is_dir())


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_every_command_and_option_exists(document: Path) -> None:
    commands = typer.main.get_command(app).commands  # pyright: ignore[reportAttributeAccessIssue]
    for name, rest in re.findall(
        r"(?:^|[`/])storyblender (\w[\w-]*)([^`\n#]*)", document.read_text("utf-8"), re.MULTILINE
    ):
        command = commands[name]
        if hasattr(command, "commands"):
            command = command.commands[rest.split()[0]]
        options = {option for parameter in command.params for option in parameter.opts}
        assert set(re.findall(r"(?<!\S)--[a-z-]+", rest)) <= options, f"{name}{rest}"


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_every_file_named_exists(document: Path) -> None:
    text = document.read_text("utf-8")
    named = re.findall(r"`((?:[\w-]+/)+[\w.-]*)`", text) + re.findall(r"\]\(([\w./-]+)\)", text)
    for name in named:
        places = (ROOT, ROOT / "src" / "storyblender", ROOT / "src" / "storyblender" / "blender", document.parent)
        if name.split("/")[0] in (*ROOMS, "src", "tests", "docs", "render"):
            assert any((place / name).exists() for place in places), name


def told_settings() -> dict[str, dict[str, str]]:
    """The table of docs/settings.md, row by row."""
    lines = (ROOT / "docs" / "settings.md").read_text("utf-8").split("\n## Looks")[0].splitlines()
    rows = [re.split(r"\s*\|\s*", line)[1:-1] for line in lines if line.startswith("| `")]
    return {row[0].strip("`"): dict(zip(("flag", "default", "may be", "does"), row[1:], strict=True)) for row in rows}


def test_every_setting_has_its_row_with_its_true_default() -> None:
    told, fields = told_settings(), Settings.model_fields
    assert told.keys() == fields.keys()
    for name, row in told.items():
        default = fields[name].default
        shown = {"aspect": round(Settings().aspect, 3), "lens_kit": [], "models": [], "motions": []}.get(name, default)
        assert row["default"] == (f"`{json.dumps(shown)}`" if default is not None else "none"), name


def test_every_setting_says_what_it_may_be() -> None:
    told, schema = told_settings(), Settings.model_json_schema()["properties"]
    for name, about in schema.items():
        inner = about.get("items") or about.get("additionalProperties") or about
        most = inner.get("maximum", inner.get("exclusiveMaximum", 0) - 1)
        bounds = f"{inner['minimum']} to {most}" if "minimum" in inner else ""
        choices = [
            f"`{json.dumps(choice)}`"
            for choice in about.get("enum", [about[key] for key in ("const",) if key in about])
        ]
        for part in (bounds, *choices, *(str(about[key]) for key in ("multipleOf", "maxItems") if key in about)):
            assert part in told[name]["may be"], name
        for role in about.get("propertyNames", {}).get("enum", []):
            assert f"`{role}`" in (ROOT / "docs" / "settings.md").read_text("utf-8")


def test_every_flag_of_a_setting_is_told() -> None:
    commands = typer.main.get_command(app).commands  # pyright: ignore[reportAttributeAccessIssue]
    flags = {
        parameter.name: parameter.opts[0] for parameter in commands["make"].params if parameter.opts[0][:2] == "--"
    }
    for name, row in told_settings().items():
        assert row["flag"] == (f"`{flags[name]}`" if name in flags else ""), name


def test_the_example_of_a_settings_file_is_one(tmp_path: Path) -> None:
    for number, example in enumerate(
        re.findall(r"```toml\n(.*?)```", (ROOT / "docs" / "settings.md").read_text("utf-8"), re.DOTALL)
    ):
        (tmp_path / "storyblender.toml").write_text(example)
        assert Settings.load(tmp_path / "film.fountain") != Settings(), number
