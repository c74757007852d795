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

COLUMNS, WIDTH = 4, 400
"""Pictures across, and pixels of one."""


def sheet_pages(frames: Mapping[str, Path]) -> list[dict[str, Path]]:
    """Return the pictures of each sheet, by shot name in order: as many sheets as it takes."""
    shown = list(frames.items())
    height = _height(shown[0][1], WIDTH) if shown else 0
    most = COLUMNS * max(1, (TALLEST - GAP) // (height + LABEL + GAP))
    return [dict(shown[at : at + most]) for at in range(0, len(shown), most)]


def write_contact_sheet(frames: Mapping[str, Path], part: Path, shows: str = "") -> None:
    """Write one sheet.

    Args:
        frames: Shot name to picture, in order; one of the ``sheet_pages``.
        part: A JPEG.
        shows: Names what it shows, as a comment in the file that ``shown_by`` finds.
    """
    shown = list(frames.items())
    _sheet(shown, COLUMNS, (WIDTH, _height(shown[0][1], WIDTH))).save(part, "JPEG", comment=shows)


def shown_by(sheet: Path) -> str:
    """Return the name of what a sheet shows; empty if it is none of ours."""
    try:
        with Image.open(sheet) as picture:
            comment = picture.info.get("comment", b"")
    except (OSError, ValueError):
        return ""
    return comment.decode(errors="replace") if isinstance(comment, bytes) else ""


def sheet_name(number: int) -> str:
    """Return the name of a sheet's file; the first is number 1."""
    return "contact_sheet.jpg" if number == 1 else f"contact_sheet_{number}.jpg"


def sheets_in(folder: Path) -> list[str]:
    """Return the names of the sheets that there are, in order."""
    return list(takewhile(lambda name: (folder / name).exists(), map(sheet_name, count(1))))


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
