"""Every surface the built-in library knows: colour, pattern, tile size, gloss. Data only.

One small tileable picture per material serves Cycles, Workbench and glTF alike (notes: sets and light, section 3).
"""

from __future__ import annotations

from typing import Literal

from storyblender.catalog.registry import Catalog
from storyblender.memory.base import Color, Frozen, Identifier

PatternKey = Literal[
    "", "wood", "planks", "parquet", "brick", "speckle", "checker", "paving", "slabs", "grass", "bark", "weave",
    "leaves", "stripes", "persian", "shingles", "corrugated", "book_spines", "water", "newsprint", "facade",
    "skyline", "treeline", "hills", "sea", "stars", "gradient", "map", "clock_face", "screen",
]  # fmt: skip


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
    wet: bool = False
    """Puddles: roughness varies over the world."""
    grain: bool = False
    """The pattern runs along a direction: boards and bars turn it to their length."""


def hex_color(code: str) -> Color:
    """Return the scene-linear colour of an sRGB hex code such as ``#c8a064``."""
    digits = code.lstrip("#")
    display = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    red, green, blue = (v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in display)
    return (red, green, blue)


def _entry(key: str, color: str, accent: str = "#1a1612", tags: str = "", **fields: object) -> MaterialEntry:
    return MaterialEntry(
        key=key,
        name=key.replace("_", " "),
        tags=tuple(tags.split()),
        color=hex_color(color),
        accent=hex_color(accent),
        **fields,  # pyright: ignore[reportArgumentType]
    )


def _wood(key: str, color: str, tags: str, roughness: float = 0.42) -> MaterialEntry:
    return _entry(key, color, tags=f"wood timber {tags}", pattern="wood", tile=0.9, roughness=roughness, grain=True)


def _cloth(key: str, color: str, tags: str, roughness: float = 0.95, **params: float) -> MaterialEntry:
    return _entry(
        key,
        color,
        tags=f"fabric cloth {tags}",
        pattern="weave",
        params=params,
        tile=0.4,
        pixels=128,
        roughness=roughness,
    )


def _card(key: str, color: str, accent: str, pattern: PatternKey, tags: str) -> MaterialEntry:
    return _entry(key, color, accent, tags, pattern=pattern, pixels=512, roughness=1.0, emission=0.7)


MATERIALS: Catalog[MaterialEntry] = Catalog(
    "material",
    (
        _wood("wood", "#8a5a34", "oak brown furniture"),
        _wood("wood_dark", "#4b2d1c", "walnut mahogany antique"),
        _wood("wood_light", "#b98a58", "pine birch"),
        _wood("wood_red", "#6d2f1e", "cherry mahogany piano"),
        _wood("wood_gray", "#857d72", "weathered driftwood old", 0.85),
        _wood("wood_black", "#1d1917", "ebony lacquer", 0.2),
        _entry(
            "planks", "#80552f", "#2a1a10", "wood floor boards", pattern="planks", tile=1.2, roughness=0.4, grain=True
        ),
        _entry(
            "planks_gray",
            "#8b8378",
            "#3a352f",
            "wood deck barn wharf",
            pattern="planks",
            tile=1.2,
            roughness=0.85,
            grain=True,
        ),
        _entry("parquet", "#93673d", "#3a2514", "wood floor herringbone", pattern="parquet", tile=0.96, roughness=0.3),
        _entry("wall_planks", "#9a7a52", "#4a3420", "panelling cabin saloon", pattern="planks", tile=1.0, grain=True),
        _entry("shingles", "#6a4a38", "#2b1f18", "roof tiles slate", pattern="shingles", tile=1.0, roughness=0.9),
        _entry("brick", "#8c4a35", "#a79b8b", "wall masonry red", pattern="brick", tile=1.1, roughness=0.85),
        _entry("brick_gray", "#77706a", "#a19a91", "wall masonry warehouse", pattern="brick", tile=1.1, roughness=0.85),
        _entry(
            "stone",
            "#8d867a",
            "#5e574d",
            "wall castle blocks",
            pattern="brick",
            params={"rows": 5, "columns": 2},
            tile=2.2,
            roughness=0.9,
        ),
        _entry(
            "rock",
            "#76706a",
            tags="boulder cliff",
            pattern="speckle",
            params={"amount": 0.6, "roughness": 1.6},
            tile=1.5,
            roughness=0.95,
        ),
        _entry(
            "marble",
            "#cfc8bd",
            tags="stone polished hall",
            pattern="speckle",
            params={"amount": 0.25, "roughness": 1.9},
            tile=2.0,
            roughness=0.15,
        ),
        _entry(
            "plaster",
            "#b9ab92",
            tags="wall painted stucco",
            pattern="speckle",
            params={"amount": 0.16, "roughness": 1.5},
            tile=3.0,
            roughness=0.9,
        ),
        _entry(
            "plaster_white",
            "#d6d1c5",
            tags="wall painted ceiling",
            pattern="speckle",
            params={"amount": 0.1, "roughness": 1.5},
            tile=3.0,
            roughness=0.9,
        ),
        _entry(
            "wallpaper",
            "#8d8a6a",
            "#767354",
            "wall striped",
            pattern="stripes",
            params={"count": 12},
            tile=1.2,
            roughness=0.9,
        ),
        _entry(
            "tile",
            "#c9c2b2",
            "#5a6468",
            "floor checker bathroom kitchen cafe",
            pattern="checker",
            tile=1.2,
            roughness=0.28,
        ),
        _entry(
            "wall_tile",
            "#cfd3d0",
            "#8f9694",
            "bathroom hospital kitchen metro white",
            pattern="brick",
            params={"rows": 8, "columns": 4, "variation": 0.1},
            tile=0.8,
            roughness=0.2,
        ),
        _entry(
            "linoleum",
            "#8e9484",
            tags="floor office hospital",
            pattern="speckle",
            params={"amount": 0.12, "roughness": 0.6},
            tile=1.5,
            roughness=0.35,
        ),
        _entry("paving", "#8a867e", "#4c4945", "street square pavement", pattern="paving", tile=1.6, roughness=0.8),
        _entry(
            "cobbles",
            "#66625d",
            "#2f2c2a",
            "street old town",
            pattern="paving",
            params={"count": 9, "jitter": 0.35},
            tile=1.4,
            roughness=0.7,
        ),
        _entry(
            "asphalt",
            "#3f3f40",
            tags="street road tarmac",
            pattern="speckle",
            params={"amount": 0.5, "roughness": 0.6},
            tile=2.0,
            roughness=0.9,
        ),
        _entry(
            "asphalt_wet",
            "#2c2d30",
            tags="street road rain night",
            pattern="speckle",
            params={"amount": 0.5, "roughness": 0.6},
            tile=2.0,
            roughness=0.3,
            wet=True,
        ),
        _entry(
            "concrete",
            "#8f8d88",
            "#5d5b57",
            "wall floor warehouse airport",
            pattern="slabs",
            tile=5.0,
            pixels=512,
            roughness=0.85,
        ),
        _entry(
            "dirt",
            "#6f5a42",
            tags="earth ground path field",
            pattern="speckle",
            params={"amount": 0.55, "roughness": 1.1},
            tile=3.0,
            roughness=1.0,
        ),
        _entry(
            "sand",
            "#c3a878",
            tags="beach desert ground",
            pattern="speckle",
            params={"amount": 0.22, "roughness": 1.0},
            tile=2.5,
            roughness=1.0,
        ),
        _entry(
            "snow",
            "#dfe5ea",
            tags="ground winter",
            pattern="speckle",
            params={"amount": 0.1, "roughness": 1.7},
            tile=3.0,
            roughness=0.8,
        ),
        _entry("grass", "#4c5a28", "#6a5a38", "ground lawn meadow", pattern="grass", tile=3.0, roughness=1.0),
        _entry("forest_floor", "#4a4327", "#33401f", "ground leaves moss", pattern="grass", tile=3.0, roughness=1.0),
        _entry("water", "#1f3b45", "#4d7480", "lake river sea pool", pattern="water", tile=4.0, roughness=0.08),
        _entry("bark", "#5a4632", "#2a2018", "tree trunk", pattern="bark", tile=1.0, roughness=0.95, grain=True),
        _entry(
            "birch_bark", "#cfc9bb", "#2c2824", "tree trunk white", pattern="bark", tile=1.0, roughness=0.9, grain=True
        ),
        _entry(
            "leaves",
            "#4a6a2c",
            "#24381a",
            "foliage tree bush hedge",
            pattern="leaves",
            tile=0.8,
            pixels=128,
            roughness=0.9,
        ),
        _entry(
            "leaves_dark",
            "#2c4a2a",
            "#16281a",
            "foliage pine fir",
            pattern="leaves",
            tile=0.8,
            pixels=128,
            roughness=0.9,
        ),
        _entry(
            "leaves_autumn",
            "#a8662a",
            "#5e3a18",
            "foliage autumn fall",
            pattern="leaves",
            tile=0.8,
            pixels=128,
            roughness=0.9,
        ),
        _cloth("fabric", "#7d7a70", "upholstery gray"),
        _cloth("fabric_red", "#8a2f2a", "upholstery velvet curtain"),
        _cloth("fabric_green", "#3f5a44", "upholstery billiard"),
        _cloth("fabric_blue", "#34506e", "upholstery"),
        _cloth("linen", "#ddd5c3", "sheet tablecloth white bed"),
        _cloth("canvas", "#a39068", "tent sail sack burlap", 1.0, threads=20),
        _entry(
            "leather",
            "#5c3620",
            tags="upholstery brown",
            pattern="speckle",
            params={"amount": 0.25, "roughness": 1.0},
            tile=0.5,
            pixels=128,
            roughness=0.45,
        ),
        _entry(
            "leather_black",
            "#211e1c",
            tags="upholstery",
            pattern="speckle",
            params={"amount": 0.25, "roughness": 1.0},
            tile=0.5,
            pixels=128,
            roughness=0.4,
        ),
        _entry("rug", "#7a2b26", "#c2a26a", "carpet persian oriental", pattern="persian", tile=1.0, roughness=1.0),
        _entry(
            "carpet",
            "#5b5f63",
            tags="floor office hotel",
            pattern="speckle",
            params={"amount": 0.22, "roughness": 0.4},
            tile=1.0,
            roughness=1.0,
        ),
        _entry("thatch", "#a58b52", "#5f4d2a", "straw hay roof", pattern="bark", tile=1.0, roughness=1.0, grain=True),
        _entry("paper", "#e6dfcb", tags="letter page", roughness=0.9),
        _entry("newsprint", "#cfc8b6", "#3a3734", "newspaper", pattern="newsprint", tile=0.4, roughness=0.95),
        _entry(
            "cardboard",
            "#a98558",
            tags="box carton",
            pattern="speckle",
            params={"amount": 0.12, "roughness": 1.4},
            tile=0.6,
            pixels=128,
            roughness=0.9,
        ),
        _entry("porcelain", "#e4e1d8", tags="ceramic cup plate sink", roughness=0.2),
        _entry("clay", "#a0583a", tags="terracotta pot", roughness=0.85),
        _entry("plastic", "#c9c6bd", tags="appliance", roughness=0.4),
        _entry("plastic_black", "#1b1c1e", tags="telephone bakelite rubber", roughness=0.35),
        _entry("rubber", "#191919", tags="tyre", roughness=0.85),
        _entry("paint", "#5a6a62", tags="lacquer enamel car", roughness=0.25),
        _entry("enamel", "#dcdcd6", tags="stove fridge bath white", roughness=0.22),
        _entry("wax", "#e5d9b8", tags="candle", roughness=0.5),
        _entry("glass", "#7f979c", tags="window bottle", roughness=0.06),
        _entry("glass_dark", "#141b22", tags="window car night", roughness=0.08),
        _entry("glass_green", "#1f4a30", tags="bottle wine", roughness=0.08),
        _entry("glass_amber", "#6d3a12", tags="bottle whisky beer", roughness=0.08),
        _entry("mirror", "#9fb0b8", tags="looking glass", metallic=0.9, roughness=0.05),
        _entry("steel", "#8d9196", tags="metal iron knife", metallic=0.8, roughness=0.3),
        _entry("iron", "#2e2f31", tags="metal cast black", metallic=0.5, roughness=0.5),
        _entry("chrome", "#c4c9cd", tags="metal shiny", metallic=0.9, roughness=0.12),
        _entry("brass", "#b08a3e", tags="metal gold handle", metallic=0.8, roughness=0.28),
        _entry("copper", "#a45c36", tags="metal pot", metallic=0.8, roughness=0.3),
        _entry("silver", "#c9c9c5", tags="metal cutlery jewel", metallic=0.9, roughness=0.2),
        _entry("gold", "#c99a34", tags="metal jewel crown ring", metallic=0.9, roughness=0.22),
        _entry(
            "rust",
            "#6a4230",
            tags="metal old iron",
            pattern="speckle",
            params={"amount": 0.7, "roughness": 1.4},
            tile=1.0,
            roughness=0.95,
        ),
        _entry(
            "sheet_metal",
            "#83888b",
            "#5b6063",
            "corrugated hangar shed",
            pattern="corrugated",
            tile=1.0,
            metallic=0.4,
            roughness=0.45,
        ),
        _entry("lamp_warm", "#ffd9a0", tags="light bulb shade glow", emission=3.0),
        _entry("lamp_cool", "#e6f0ff", tags="light tube neon glow", emission=3.0),
        _entry("lampshade", "#e2c690", tags="light shade parchment", emission=0.8, roughness=0.9),
        _entry("flame", "#ffb347", tags="fire candle campfire", emission=6.0),
        _entry("ember", "#c8401a", tags="fire coal", emission=2.0),
        _entry("neon_red", "#ff3040", tags="sign light", emission=4.0),
        _entry("neon_blue", "#40a0ff", tags="sign light", emission=4.0),
        _entry(
            "screen", "#9fb8c8", "#1d2a34", "television computer monitor", pattern="screen", emission=0.8, roughness=0.2
        ),
        _entry("screen_off", "#15181a", tags="television computer monitor off", roughness=0.12),
        _entry("clock_face", "#e8e0cc", "#1a1816", "clock dial", pattern="clock_face", roughness=0.5),
        _entry("map", "#c9b98c", "#4a6a70", "atlas globe world chart", pattern="map", roughness=0.8),
        _entry("picture", "#7a6f52", "#3d4f4a", "painting landscape", pattern="hills", roughness=0.6),
        _entry("book_spines", "#6a3a2a", "#c2a05a", "books shelf", pattern="book_spines", tile=0.8, roughness=0.8),
        _card("card_skyline", "#2b3448", "#ffca7a", "skyline", "backdrop city window night"),
        _card("card_treeline", "#8fa0a0", "#2c3a2c", "treeline", "backdrop forest"),
        _card("card_hills", "#a9b8c0", "#4f6350", "hills", "backdrop mountains country"),
        _card("card_sea", "#9fb6c4", "#2f5566", "sea", "backdrop ocean coast"),
        _card("card_facades", "#5a5048", "#ffca7a", "facade", "backdrop street houses windows"),
        _card("card_stars", "#0a0e1a", "#dfe6ff", "stars", "backdrop space night"),
        _card("card_plain", "#8a96a0", "#b9c2c8", "gradient", "backdrop sky"),
        _entry(
            "facade",
            "#7a6a58",
            "#ffca7a",
            "building wall windows",
            pattern="facade",
            params={"columns": 6, "rows": 8},
            tile=20.0,
            roughness=0.85,
            emission=0.5,
        ),
    ),
)
"""In the order they are listed to people."""
