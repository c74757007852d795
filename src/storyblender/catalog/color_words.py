"""Names a colour by the nearest of two dozen common words."""

from __future__ import annotations

from typing import Final

from storyblender.catalog.material_entry import hex_color
from storyblender.memory.base import Color

COLOR_WORDS: Final = {
    "black": "#141416", "charcoal": "#38393d", "grey": "#808286", "light grey": "#bcbec0", "white": "#f0efec",
    "cream": "#e8dec4", "beige": "#c4b18c", "tan": "#a5815a", "brown": "#6b4a30", "dark brown": "#38261a",
    "rust": "#9a4a26", "orange": "#cc6a2c", "yellow": "#d8b23c", "gold": "#b8923c", "olive": "#62643a",
    "green": "#3f7048", "dark green": "#20402c", "teal": "#2b6a70", "light blue": "#8db0cc", "blue": "#34609c",
    "navy": "#1d2a47", "purple": "#5a4078", "pink": "#d79aa6", "red": "#a8242a", "dark red": "#561820",
}  # fmt: skip
"""Hex code by word."""


def color_word(color: Color) -> str:
    """Return the nearest of two dozen common words for a scene-linear colour."""
    here = _seen(color)

    def distance(word: str) -> float:
        return sum((a - b) ** 2 for a, b in zip(here, _seen(hex_color(COLOR_WORDS[word])), strict=True))

    return min(COLOR_WORDS, key=distance)


def _seen(color: Color) -> tuple[float, float, float]:
    """Return lightness and two differences of hue of a scene-linear colour; equal distances look about equally far."""
    red, green, blue = (max(channel, 0.0) ** (1 / 2.2) for channel in color)
    return 0.3 * red + 0.59 * green + 0.11 * blue, 0.9 * (red - green), 0.6 * (0.5 * (red + green) - blue)
