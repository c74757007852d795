"""Pictures of things for requests: their sides on one labelled sheet, or one portrait."""

from __future__ import annotations

import io
from collections.abc import Mapping

from storyblender.errors import NoAnswer
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import content_hash
from storyblender.memory.measure import AssetViews
from storyblender.memory.request import Picture

_TILE, _GAP, _LABEL = 256, 8, 26
"""Pixels of a side, between two of them, and of the line with its label."""
_PAPER, _INK = "#ffffff", "#000000"


def nothing_drawn(asset: Asset) -> AssetViews:
    """Refuse to draw: there is no engine. Raises NoAnswer."""
    raise NoAnswer(f"there is no picture of {asset.asset_id}")


def side_sheet(views: AssetViews, labels: Mapping[str, str], name: str, columns: int = 3) -> Picture:
    """Return one picture with some sides of a thing, each with its label above it.

    Args:
        views: Of the thing.
        labels: Label to side, in the order from left to right and down.
        name: Of the picture.
        columns: Sides in a row.
    """
    from PIL import Image, ImageDraw, ImageFont

    from storyblender.look.viewfinder_picture import as_png

    rows, high = -(-len(labels) // columns), _TILE + _LABEL + _GAP
    sheet = Image.new("RGB", (columns * (_TILE + _GAP) + _GAP, rows * high + _GAP), _PAPER)
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(18)
    for index, (label, side) in enumerate(labels.items()):
        x, y = _GAP + index % columns * (_TILE + _GAP), _GAP + index // columns * high
        draw.text((x + 2, y + _LABEL / 2), label, font=font, fill=_INK, anchor="lm")
        with Image.open(io.BytesIO(views.pictures[side])) as image:
            sheet.paste(image.convert("RGB").resize((_TILE, _TILE), Image.Resampling.LANCZOS), (x, y + _LABEL))
    return Picture(name=name, png=as_png(sheet), drawn_from=content_hash(views.digest, dict(labels), columns))


def portrait(views: AssetViews, name: str) -> Picture:
    """Return the picture of a thing seen from before it, a little from its left and from above.

    Args:
        views: Of the thing.
        name: Of the picture.
    """
    return Picture(name=name, png=views.pictures["portrait"], drawn_from=content_hash(views.digest, "portrait"))
