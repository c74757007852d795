"""The slate: on copies only, and legible in any shape of frame."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from PIL import Image, ImageDraw

from storyblender.deliver import slate
from storyblender.deliver.panel import panels
from storyblender.memory.graph import ContinuityMemoryGraph


def test_slate_darkens_only_the_foot_of_a_copy(
    graph: ContinuityMemoryGraph, frames: dict[str, Path], tmp_path: Path
) -> None:
    clean = frames["SC010_SH020"]
    slate.burn_in(clean, panels(graph)[1], tmp_path / "slate.png")
    with Image.open(clean) as before, Image.open(tmp_path / "slate.png") as after:
        assert before.getpixel((5, 5)) == after.getpixel((5, 5))
        assert before.getpixel((70, 88)) != after.getpixel((70, 88))


def test_the_words_of_a_slate_keep_apart_in_an_upright_frame(
    graph: ContinuityMemoryGraph, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    spans: list[tuple[float, float]] = []
    draw = ImageDraw.ImageDraw.text

    def text(self: ImageDraw.ImageDraw, xy: tuple[float, float], words: str, **style: Any) -> None:
        spans.append(self.textbbox(xy, words, font=style["font"], anchor=style["anchor"])[::2])
        draw(self, xy, words, **style)

    monkeypatch.setattr(ImageDraw.ImageDraw, "text", text)
    Image.new("RGB", (180, 320)).save(tmp_path / "upright.png")
    slate.burn_in(tmp_path / "upright.png", panels(graph)[1], tmp_path / "slate.png")
    (start, name), (left, right), (time, end) = spans
    assert 0 <= start < name < left < right < time < end <= 180
