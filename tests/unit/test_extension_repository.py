"""The Blender extension is written as Blender's own tools want it."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
import tomllib
import zipfile
from importlib.util import find_spec
from pathlib import Path

import pytest
from typer.testing import CliRunner

import storyblender
from storyblender.cli import app
from storyblender.extension_repository import INDEX, MANIFEST, extension_zip, write_repository

SOURCE = Path(storyblender.__file__).parent / "blender_extension"


def blender_tool(*words: str | Path) -> str:
    """Run Blender's command line for extensions, which comes with bpy."""
    spec = find_spec("bpy")
    assert spec is not None and spec.submodule_search_locations
    [tool] = Path(spec.submodule_search_locations[0]).glob("*/scripts/addons_core/bl_pkg/cli/blender_ext.py")
    command = [sys.executable, str(tool), *map(str, words)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_repository(tmp_path)
    return tmp_path


def test_blender_accepts_the_zip_and_lists_the_repository_in_the_same_way(folder: Path) -> None:
    [archive] = folder.glob("*.zip")
    blender_tool("validate", archive)
    written = json.loads((folder / INDEX).read_text())
    blender_tool("server-generate", "--repo-dir", folder)
    assert json.loads((folder / INDEX).read_text()) == written


def test_the_same_extension_is_the_same_zip_with_all_of_it_in_it(folder: Path) -> None:
    [archive] = folder.glob("*.zip")
    assert archive.read_bytes() == extension_zip() == extension_zip()
    with zipfile.ZipFile(archive) as packed:
        assert set(packed.namelist()) == {MANIFEST, *(path.name for path in SOURCE.glob("*.py"))}


def test_the_manifest_says_what_it_needs_and_why() -> None:
    manifest = tomllib.loads((SOURCE / MANIFEST).read_text())
    assert manifest["version"] == storyblender.__version__, "a release raises both"
    assert manifest["blender_version_min"] == "4.5.0" and manifest["license"] == ["SPDX:GPL-3.0-or-later"]
    assert set(manifest["permissions"]) == {"network", "files"}


def test_it_imports_only_what_every_blender_has() -> None:
    roots = {"__future__", "blf", "bpy", *sys.stdlib_module_names}
    for path in SOURCE.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) and not node.level else []
            assert {name.split(".")[0] for name in names} <= roots, path.name


def test_the_command_says_how_to_install_it(tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["blender-extension", str(tmp_path / "new")])
    assert done.exit_code == 0, done.output
    assert (tmp_path / "new" / INDEX).as_uri() in done.stdout and "Program" in done.stdout
    told = CliRunner().invoke(app, ["blender-extension", str(tmp_path / "new"), "--json"])
    assert json.loads(told.stdout)["files"][1] == INDEX
