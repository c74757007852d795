"""The slate burnt into the lower edge of a frame: shot, lens and timecode."""

from __future__ import annotations

from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from storyblender.deliver.fonts import font_file
from storyblender.deliver.panel import Panel, timecode


def burn_in(source: Path, panel: Panel, part: Path, first: int = 0) -> None:
    """Write a copy of a frame with its slate on a translucent band.

    Args:
        source: The clean frame; it is never changed.
        panel: What the slate says.
        part: The file to write.
        first: Frame number of the story's start timecode.
    """
    with Image.open(source) as image:
        picture = image.convert("RGB")
    band = max(18, picture.height // 22)
    take = f"  take {panel.shot.take}" if panel.shot.take > 1 or panel.shot.takes else ""
    name, facts = panel.name + take, f"{panel.framing}  {panel.lens:.0f} mm"
    time = f"{timecode(first + panel.start, panel.fps)}  {panel.shot.duration}f"
    font = _fitting(f"{name}  {facts}  {time}", round(band * 0.62), picture.width - band)
    left, right = band / 2, picture.width - band / 2
    y = picture.height - band / 2
    draw = ImageDraw.Draw(picture, "RGBA")
    draw.rectangle((0, picture.height - band, picture.width, picture.height), fill=(0, 0, 0, 150))
    draw.text((left, y), name, font=font, fill="white", anchor="lm")
    between = (left + font.getlength(name) + right - font.getlength(time)) / 2
    draw.text((between, y), facts, font=font, fill="white", anchor="mm")
    draw.text((right, y), time, font=font, fill="white", anchor="rm")
    picture.save(part)


def _fitting(line: str, size: int, room: float) -> ImageFont.FreeTypeFont:
    """Return the font at ``size`` pixels, or smaller so that the line fits into ``room`` pixels."""
    font = ImageFont.truetype(str(font_file()), size)
    wide = font.getlength(line)
    return font if wide <= room else font.font_variant(size=max(1, int(size * room / wide)))
