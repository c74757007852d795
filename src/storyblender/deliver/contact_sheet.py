"""A contact sheet: every frame small on one picture, as a director looks them over."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from storyblender.deliver.fonts import font_file


def write_contact_sheet(frames: Mapping[str, Path], out: Path, columns: int = 4, width: int = 400) -> None:
    """Write the sheet.

    Args:
        frames: Shot name to picture, in order.
        out: ``.jpg`` or ``.png``.
        columns: Pictures across.
        width: Pixels of one picture.
    """
    if not frames:
        return
    with Image.open(next(iter(frames.values()))) as first:
        height = round(width * first.height / first.width)
    label = 20
    rows = -(-len(frames) // columns)
    sheet = Image.new("RGB", (columns * (width + 6) + 6, rows * (height + label + 6) + 6), "#17171b")
    font = ImageFont.truetype(str(font_file()), 13)
    draw = ImageDraw.Draw(sheet)
    for index, (name, path) in enumerate(frames.items()):
        x, y = 6 + index % columns * (width + 6), 6 + index // columns * (height + label + 6)
        with Image.open(path) as image:
            image.draft("RGB", (width, height))  # a JPEG need not be read larger than it is shown
            sheet.paste(image.convert("RGB").resize((width, height), Image.Resampling.LANCZOS), (x, y))
        draw.text((x + 2, y + height + label / 2), name, font=font, fill="#9a9aa6", anchor="lm")
    sheet.save(out)
