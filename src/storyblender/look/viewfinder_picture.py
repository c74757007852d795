"""The viewfinder's picture as the paper's Camera Operator sees it: more than the frame, the subjects outlined in red.

The frame is a black border, what lies outside of it is dimmed, so that an operator sees what a pan would bring in
(paper, appendix: prompt of the Camera Operator).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from io import BytesIO

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFilter, ImageFont

MARGIN = 1.25
"""Width of the picture over the width of the frame in it."""
_DIM = 0.45
"""Share of its brightness that what is outside the frame keeps."""
_RED, _BLACK, _WHITE = (255, 20, 20), (0, 0, 0), (255, 255, 255)
_COLUMNS = 2
_GAP = 6
"""Pixels between the pictures of a sheet."""

Pixels = NDArray[np.uint8]
Mask = NDArray[np.bool_]


def annotated(picture: Pixels, subjects: Iterable[Mask]) -> Pixels:
    """Return a picture with its subjects outlined in red, the frame drawn in, and all outside of it dimmed.

    Args:
        picture: (h, w, 3) sRGB, ``MARGIN`` times as wide and as high as the frame in its middle.
        subjects: (h, w) each, true where one subject is seen.
    """
    drawn = picture.copy()
    for mask in subjects:
        drawn[_outline(mask)] = _RED
    height, width = drawn.shape[:2]
    left, top, right, bottom = frame_in(width, height)
    inside = drawn[top:bottom, left:right].copy()
    drawn = (drawn * _DIM).astype(np.uint8)
    drawn[top:bottom, left:right] = inside
    image = Image.fromarray(drawn)
    pen = ImageDraw.Draw(image)
    pen.rectangle((left - 3, top - 3, right + 2, bottom + 2), outline=_WHITE)
    pen.rectangle((left - 2, top - 2, right + 1, bottom + 1), outline=_BLACK, width=2)
    return np.asarray(image)


def frame_in(width: int, height: int) -> tuple[int, int, int, int]:
    """Return left, top, right and bottom of the frame in a picture, in pixels."""
    across, down = round(width / MARGIN), round(height / MARGIN)
    left, top = (width - across) // 2, (height - down) // 2
    return left, top, left + across, top + down


def numbered_sheet(pictures: Sequence[bytes]) -> bytes:
    """Return pictures of one size beside and below each other, each with its number from 1 in its upper left corner.

    Args:
        pictures: PNG.

    Returns:
        PNG.
    """
    images = [Image.open(BytesIO(each)).convert("RGB") for each in pictures]
    width, height = images[0].size
    columns = min(_COLUMNS, len(images))
    rows = -(-len(images) // columns)
    sheet = Image.new("RGB", (columns * (width + _GAP) - _GAP, rows * (height + _GAP) - _GAP), _WHITE)
    pen, font = ImageDraw.Draw(sheet), ImageFont.load_default(height / 9)
    for number, image in enumerate(images):
        x, y = (number % columns) * (width + _GAP), (number // columns) * (height + _GAP)
        sheet.paste(image, (x, y))
        plate = (x, y, x + height // 7, y + height // 7)
        pen.rectangle(plate, fill=_WHITE)
        pen.text(((plate[0] + plate[2]) / 2, (plate[1] + plate[3]) / 2), str(number + 1), _BLACK, font, anchor="mm")
    return as_png(sheet)


def as_png(picture: Pixels | Image.Image) -> bytes:
    """Return a picture, sRGB, as PNG of 256 colours, a quarter as large: recordings keep every picture."""
    image = picture if isinstance(picture, Image.Image) else Image.fromarray(picture)
    file = BytesIO()
    image.quantize(256, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(file, format="PNG")
    return file.getvalue()


def _outline(mask: Mask) -> Mask:
    """Return the pixels around a mask, two wide."""
    grown = np.asarray(Image.fromarray(mask).convert("L").filter(ImageFilter.MaxFilter(5))) > 0
    return grown & ~mask
