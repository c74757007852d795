"""The looks a frame can have. Adding one is adding an entry (docs/add-a-look.md)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from storyblender.look.grade import AGX_CONTRAST

LightSource = Literal["cycles", "numpy", "final"]
"""cycles: path-traced at low resolution, full-size texture; numpy: deferred lamps; final: path-traced, full size."""
Style = Literal["color", "pencil"]


@dataclass(frozen=True)
class Look:
    """One way to draw a frame.

    Attributes:
        key: Name in settings and requests.
        name: For people.
        tags: Other words for it.
        light: Where illumination comes from.
        style: Colour picture or graphite drawing.
        ink: Darkness of the lines, 0 (none) to 1.
        contrast: AgX look of the colour configuration.
        supersample: Size of the G-buffer over the size of the picture.
        light_step: Pixels of the picture for one pixel of light; 1, 2 or 4.
        samples: Paths a pixel, where light is path-traced.
        bounces: Path length.
    """

    key: str
    name: str
    tags: tuple[str, ...]
    light: LightSource
    style: Style = "color"
    ink: float = 0.88
    contrast: str = AGX_CONTRAST
    supersample: int = 2
    light_step: int = 2
    samples: int = 6
    bounces: int = 3


_ALL = (
    Look("board", "Board", ("storyboard", "default", "inked", "colour"), light="cycles", light_step=4, samples=4),
    Look("fast", "Fast board", ("draft", "quick", "preview"), light="numpy"),
    Look("pencil", "Pencil", ("graphite", "sketch", "drawing", "black and white"), light="numpy", style="pencil"),
    Look(
        "render", "Render", ("final", "photographic", "no lines"),
        light="final", ink=0.0, light_step=1, samples=24, bounces=4,
    ),
)  # fmt: skip

LOOKS: Mapping[str, Look] = MappingProxyType({look.key: look for look in _ALL})
"""Every look by key, in the order they are offered."""
