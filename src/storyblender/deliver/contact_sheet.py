"""Contact sheets: every frame as a thumbnail; a long story has several sheets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import count, takewhile
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from storyblender.deliver.fonts import font_file

GAP, LABEL = 6, 20
"""Pixels between pictures, and of the caption under each."""
TALLEST = 4000
"""Greatest height in pixels, unless a single row is taller; a JPEG may have 65,500."""

COLUMNS, WIDTH = 4, 400
"""Pictures in a row, and the width of each in pixels."""


def sheet_pages(frames: Mapping[str, Path]) -> list[dict[str, Path]]:
    """Split the frames, shot name to picture, into sheets that are not too tall."""
    shown = list(frames.items())
    height = _height(shown[0][1], WIDTH) if shown else 0
    most = COLUMNS * max(1, (TALLEST - GAP) // (height + LABEL + GAP))
    return [dict(shown[at : at + most]) for at in range(0, len(shown), most)]


def write_contact_sheet(frames: Mapping[str, Path], part: Path, shows: str = "") -> None:
    """Write one sheet.

    Args:
        frames: Shot name to picture, in order; one of the ``sheet_pages``.
        part: A JPEG.
        shows: Digest of the frames, stored as the JPEG comment; ``shown_by`` reads it.
    """
    shown = list(frames.items())
    _sheet(shown, COLUMNS, (WIDTH, _height(shown[0][1], WIDTH))).save(part, "JPEG", comment=shows)


def shown_by(sheet: Path) -> str:
    """Return the digest of the frames that a sheet shows; empty if the file is no sheet of this program."""
    try:
        with Image.open(sheet) as picture:
            comment = picture.info.get("comment", b"")
    except (OSError, ValueError):
        return ""
    return comment.decode(errors="replace") if isinstance(comment, bytes) else ""


def sheet_name(number: int) -> str:
    """Return the file name of a sheet; ``number`` counts from 1."""
    return "contact_sheet.jpg" if number == 1 else f"contact_sheet_{number}.jpg"


def sheets_in(folder: Path) -> list[str]:
    """Return the file names of the sheets in a project folder, in order."""
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
