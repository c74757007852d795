"""Contact sheets: every frame small, as a director looks them over; a long story has several."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import count, takewhile
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from storyblender.deliver.fonts import font_file

GAP, LABEL = 6, 20
"""Pixels between pictures, and under each for its name."""
TALLEST = 4000
"""Pixels down at most, unless a single row is taller: a screen shows it, and a JPEG ends at 65,500."""


def write_contact_sheets(frames: Mapping[str, Path], out: Path, columns: int = 4, width: int = 400) -> list[Path]:
    """Write as many sheets as it takes, and delete those that a longer story had.

    Args:
        frames: Shot name to picture, in order.
        out: The first sheet, ``.jpg`` or ``.png``; the second is ``contact_sheet_2.jpg`` and so on.
        columns: Pictures across.
        width: Pixels of one picture.

    Returns:
        The sheets, in order.
    """
    shown = list(frames.items())
    height = _height(shown[0][1], width) if shown else 0
    rows = max(1, (TALLEST - GAP) // (height + LABEL + GAP))
    pages = [shown[at : at + rows * columns] for at in range(0, len(shown), rows * columns)]
    sheets = [_sheet_path(out, number) for number in range(1, len(pages) + 1)]
    for path, page in zip(sheets, pages, strict=True):
        _sheet(page, columns, (width, height)).save(path)
    for stale in sheets_beside(out)[len(sheets) :]:
        stale.unlink()
    return sheets


def sheets_beside(first: Path) -> list[Path]:
    """Return the sheets that there are, in order.

    Args:
        first: The first of them.
    """
    return list(takewhile(Path.exists, (_sheet_path(first, number) for number in count(1))))


def _sheet_path(out: Path, number: int) -> Path:
    return out if number == 1 else out.with_stem(f"{out.stem}_{number}")


def _height(picture: Path, width: int) -> int:
    with Image.open(picture) as first:
        return max(1, round(width * first.height / first.width))


def _sheet(shown: Sequence[tuple[str, Path]], columns: int, size: tuple[int, int]) -> Image.Image:
    width, height = size
    rows = -(-len(shown) // columns)
    sheet = Image.new("RGB", (columns * (width + GAP) + GAP, rows * (height + LABEL + GAP) + GAP), "#17171b")
    font = ImageFont.truetype(str(font_file()), 13)
    draw = ImageDraw.Draw(sheet)
    for index, (name, path) in enumerate(shown):
        x, y = GAP + index % columns * (width + GAP), GAP + index // columns * (height + LABEL + GAP)
        with Image.open(path) as image:
            image.draft("RGB", size)  # a JPEG need not be read larger than it is shown
            sheet.paste(image.convert("RGB").resize(size, Image.Resampling.LANCZOS), (x, y))
        draw.text((x + 2, y + height + LABEL / 2), name, font=font, fill="#9a9aa6", anchor="lm")
    return sheet
