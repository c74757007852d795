"""The slate burnt into a frame: shot, lens and time under the picture's lower edge."""

from __future__ import annotations

from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from storyblender.deliver.fonts import font_file
from storyblender.deliver.panel import Panel, timecode


def burn_in(source: Path, panel: Panel, out: Path) -> None:
    """Write a copy of a frame with its slate on a translucent band.

    Args:
        source: The clean frame; it is never changed.
        panel: What the slate says.
        out: The copy.
    """
    with Image.open(source) as image:
        picture = image.convert("RGB")
    band = max(18, picture.height // 22)
    font = ImageFont.truetype(str(font_file()), round(band * 0.62))
    draw = ImageDraw.Draw(picture, "RGBA")
    draw.rectangle((0, picture.height - band, picture.width, picture.height), fill=(0, 0, 0, 150))
    y = picture.height - band / 2
    draw.text((band * 0.5, y), panel.name, font=font, fill="white", anchor="lm")
    facts = f"{panel.framing}  {panel.lens:.0f} mm"
    draw.text((picture.width / 2, y), facts, font=font, fill="white", anchor="mm")
    time = f"{timecode(panel.start, panel.fps)}  {panel.shot.duration}f"
    draw.text((picture.width - band * 0.5, y), time, font=font, fill="white", anchor="rm")
    picture.save(out)
