"""Whose work a model is: its own file, the credits files beside it, and nothing that is not text."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.every import every
from tests.unit.models.model_corpus import glb, square

from storyblender.blender.models.credits import credit_in_gltf, with_files
from storyblender.blender.models.gltf import read_gltf
from storyblender.memory.asset_sheet import NOTE_LENGTH, Credit, Provenance


def test_what_a_gltf_says_is_read(tmp_path: Path) -> None:
    document, data = square()
    extras = {"author": "Ann (https://a.example)", "license": "CC-BY-4.0", "source": "https://s.example/1", "x": 3}
    document["asset"] = {"version": "2.0", "copyright": "2019 Ann", "extras": extras}
    (tmp_path / "a.glb").write_bytes(glb(document, data))
    assert read_gltf(tmp_path / "a.glb", tmp_path).credit == Credit(
        author="Ann (https://a.example)", license="CC-BY-4.0", copyright="2019 Ann", url="https://s.example/1"
    )


@every("asset", [None, 3, [], {"extras": 3}, {"copyright": ["a"]}, {"extras": {"author": {"a": 1}}}])
def test_what_is_no_text_is_no_credit(asset: object) -> None:
    assert credit_in_gltf(asset) == Credit()


def test_a_long_credit_is_one_line_cut_short() -> None:
    author = credit_in_gltf({"extras": {"author": "a\n\x1b[31m" * 1000}}).author
    assert len(author) <= NOTE_LENGTH and author.isprintable()


def test_the_nearest_file_counts_and_the_model_says_the_rest(tmp_path: Path) -> None:
    model = tmp_path / "wood" / "chair.glb"
    model.parent.mkdir()
    (tmp_path / "credits.toml").write_text('author = "Pack"\nlicense = "CC0-1.0"\nurl = "https://p.example"')
    (model.parent / "credits.toml").write_text('author = "Wood"')
    (model.parent / "chair.credits.toml").write_text('license = "CC-BY-4.0"')
    notes: list[str] = []
    said = with_files(Credit(author="File", copyright="2020"), model, tmp_path, notes)
    assert said == Credit(author="Wood", license="CC-BY-4.0", copyright="2020", url="https://p.example")
    assert not notes


@pytest.mark.parametrize("content", [b"author = ", b"\xff\xfe", b"a" * (1 << 17), b"[" * 5000])
def test_a_damaged_file_is_left_out_with_a_note(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "credits.toml").write_bytes(content)
    notes: list[str] = []
    assert with_files(Credit(author="Ann"), tmp_path / "a.glb", tmp_path, notes) == Credit(author="Ann")
    assert len(notes) == 1 and "credits.toml" in notes[0]


def test_a_source_knows_better_than_the_file() -> None:
    known = Provenance(source="museum", file="a.glb", author="Museum")
    assert known.credited(Credit(author="File", license="CC0-1.0")).author == "Museum"
    assert known.credited(Credit(author="File", license="CC0-1.0")).license == "CC0-1.0"
