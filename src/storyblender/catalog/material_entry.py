"""What the catalog knows of one surface, and how its colours are written. Data only."""

from __future__ import annotations

from typing import Literal

from storyblender.memory.base import Color, Frozen, Identifier

PatternKey = Literal[
    "", "wood", "planks", "parquet", "brick", "speckle", "checker", "paving", "slabs", "grass", "bark", "weave",
    "leaves", "stripes", "persian", "shingles", "corrugated", "book_spines", "water", "newsprint", "facade",
    "skyline", "treeline", "hills", "sea", "stars", "gradient", "map", "clock_face", "screen",
]  # fmt: skip

_REPEATS: dict[PatternKey, tuple[str, float]] = {
    "planks": ("count", 6),
    "parquet": ("count", 4),
    "brick": ("rows", 12),
    "checker": ("count", 4),
    "paving": ("count", 4),
    "shingles": ("count", 6),
    "corrugated": ("count", 12),
    "stripes": ("count", 8),
    "weave": ("threads", 32),
}
"""Patterns that repeat within their picture: the parameter that says how often, and its default."""


class MaterialEntry(Frozen):
    """One material of the built-in library."""

    key: Identifier
    name: str
    tags: tuple[str, ...] = ()
    color: Color = (0.5, 0.5, 0.5)
    """Mean colour; replaced where a prop or a set asks for another one."""
    accent: Color = (0.1, 0.1, 0.1)
    """Second colour of the pattern: mortar, gaps, the other tile, lit windows."""
    pattern: PatternKey = ""
    params: dict[str, float] = {}
    """Named arguments of the pattern in ``look.patterns``."""
    tile: float = 1.0
    """Metres that one picture covers."""
    pixels: int = 256
    """Rows and columns of the picture; a power of two."""
    roughness: float = 0.7
    metallic: float = 0.0
    emission: float = 0.0
    gas: bool = False
    """It glows and reflects nothing: a flame beside its own lamp stays the colour of fire."""
    wet: bool = False
    """Puddles: roughness varies over the world."""
    grain: bool = False
    """The pattern runs along a direction: boards and bars turn it to their length."""
    patchy: float = 0.0
    """How much ground of it varies over metres, 0 to 1: damp, worn and grown places."""

    @property
    def repeat(self) -> float:
        """Metres from one board, course or tile to the next; 0 where nothing repeats so."""
        parameter, default = _REPEATS.get(self.pattern, ("", 0.0))
        return self.tile / self.params.get(parameter, default) if parameter else 0.0


def hex_color(code: str) -> Color:
    """Return the scene-linear colour of an sRGB hex code such as ``#c8a064``."""
    digits = code.lstrip("#")
    display = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    red, green, blue = (v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in display)
    return (red, green, blue)


def hex_code(color: Color) -> str:
    """Return the sRGB hex code of a scene-linear colour; the reverse of ``hex_color``, clipped at one."""
    linear = (min(max(v, 0.0), 1.0) for v in color)
    display = (v * 12.92 if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055 for v in linear)
    return "#" + "".join(f"{round(v * 255):02x}" for v in display)


def painted(key: str, color: str, accent: str = "#1a1612", tags: str = "", **fields: object) -> MaterialEntry:
    """Return a material from hex colours.

    Args:
        key: snake_case key; its words are the display name too.
        color: sRGB hex code of the mean colour.
        accent: sRGB hex code of the pattern's second colour.
        tags: Words for the material, separated by spaces.
        fields: Further fields of the MaterialEntry.
    """
    return MaterialEntry(
        key=key,
        name=key.replace("_", " "),
        tags=tuple(tags.split()),
        color=hex_color(color),
        accent=hex_color(accent),
        **fields,  # pyright: ignore[reportArgumentType]
    )


def wooden(key: str, color: str, tags: str, roughness: float = 0.42) -> MaterialEntry:
    """Return a polished wood.

    Args:
        key: snake_case key.
        color: sRGB hex code.
        tags: Words besides ``wood`` and ``timber``, separated by spaces.
        roughness: 0 for a mirror to 1 for matte.
    """
    return painted(key, color, tags=f"wood timber {tags}", pattern="wood", tile=0.9, roughness=roughness, grain=True)


def woven(key: str, color: str, tags: str, roughness: float = 0.95, **params: float) -> MaterialEntry:
    """Return a cloth.

    Args:
        key: snake_case key.
        color: sRGB hex code.
        tags: Words besides ``fabric`` and ``cloth``, separated by spaces.
        roughness: 0 for a mirror to 1 for matte.
        params: Arguments of the weave pattern: ``threads`` across the picture.
    """
    return painted(
        key,
        color,
        tags=f"fabric cloth {tags}",
        pattern="weave",
        params=params,
        tile=0.4,
        pixels=128,
        roughness=roughness,
    )


def card(key: str, color: str, accent: str, pattern: PatternKey, tags: str) -> MaterialEntry:
    """Return a glowing backdrop card.

    Args:
        key: snake_case key.
        color: sRGB hex code of the mean colour.
        accent: sRGB hex code of the pattern's second colour.
        pattern: Picture on the card, such as ``skyline``.
        tags: Words for the material, separated by spaces.
    """
    return painted(key, color, accent, tags, pattern=pattern, pixels=512, roughness=1.0, emission=0.7)
