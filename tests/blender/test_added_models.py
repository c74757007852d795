"""A model is read before it is added to the library."""

from __future__ import annotations

import json
from pathlib import Path

from tests.model_files import box_gltf, glb_of
from typer.testing import CliRunner

from storyblender.cli import app
from storyblender.library.shared.shared_library import SharedLibrary


def test_only_models_that_can_be_read_are_added(tmp_path: Path) -> None:
    (tmp_path / "crate.glb").write_bytes(glb_of(box_gltf((1, 1, 1))))
    words = ["library", "add", str(tmp_path), "--no-picture", "--json"]
    (tmp_path / "letter.fbx").write_text("this is no model")
    refused = CliRunner().invoke(app, words)
    assert refused.exit_code == 2 and not SharedLibrary.open().find()
    told = json.loads(refused.stdout.splitlines()[-1])
    assert told["error"].startswith(f"{tmp_path / 'letter.fbx'}: the model cannot be used")
    (tmp_path / "letter.fbx").unlink()
    assert CliRunner().invoke(app, words).exit_code == 0
    assert [entry.name for entry in SharedLibrary.open().find()] == ["crate"]
