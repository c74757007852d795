"""A model is a character's if it is called like them, never by an accidental noun."""

from __future__ import annotations

import pytest

from storyblender.library.file_names import character_file
from storyblender.memory.asset_sheet import Asset


@pytest.mark.parametrize(
    ("name", "files", "found"),
    [
        ("ANNA", ["chairs/red.glb", "anna.glb"], "anna.glb"),
        ("ANNA", ["cast/Anna01.glb"], "cast/Anna01.glb"),
        ("OLD KNIGHT", ["knight.glb", "old_knight.glb"], "old_knight.glb"),
        ("ANNA", ["annabel.glb", "anna_chair.glb"], ""),
        ("TABLE", ["table.glb"], ""),
        ("TABLE", ["table.glb", "cast/table.glb"], "cast/table.glb"),
    ],
)
def test_a_model_that_is_called_like_a_character(name: str, files: list[str], found: str) -> None:
    asset = Asset(asset_id=name.lower().replace(" ", "_"), asset_type="character", description="", name=name)
    assert character_file(asset, files) == found
