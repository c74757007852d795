"""What people keep in each sort of room: on its walls, along their feet, and on its tops. Data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from storyblender.catalog.registry import ParamValue


@dataclass(frozen=True)
class Belongings:
    """What is kept in a sort of room, in the order in which it is hung, set down and laid out.

    A word may name the periods it belongs to: ``classic+modern:calendar``.

    Args:
        walls: Keys of ``HUNG``.
        floor: Keys of ``STANDING``.
        tops: Props.
    """

    walls: tuple[str, ...]
    floor: tuple[str, ...]
    tops: tuple[str, ...]


@dataclass(frozen=True)
class Hanging:
    """Something on a wall.

    Args:
        key: The prop, or the set piece.
        sizes: Widths and heights in metres, one of which is drawn.
        middle: Height of its middle above the floor.
        piece: Whether it is a set piece.
        params: Further parameters.
    """

    key: str
    sizes: tuple[tuple[float, float], ...]
    middle: float = 1.58
    piece: bool = False
    params: Mapping[str, ParamValue] = field(default_factory=dict)

    def z(self, height: float) -> float:
        """Return the height of its lower edge."""
        return round(self.middle - height / 2, 3)


def _shelf(load: str, *lengths: float) -> Hanging:
    """Return a shelf with a load, to hang on a wall."""
    return Hanging("wall_shelf", tuple((length, 0.5) for length in lengths), 1.62, True, {"load": load})


HUNG: Final[Mapping[str, Hanging]] = {
    "picture": Hanging("picture", ((0.8, 0.6), (0.5, 0.65), (0.62, 0.46), (1.0, 0.7))),
    "small_picture": Hanging("picture", ((0.42, 0.52), (0.36, 0.3), (0.5, 0.38))),
    "mirror": Hanging("wall_mirror", ((0.6, 0.85), (0.5, 0.7))),
    "clock": Hanging("wall_clock", ((0.36, 0.36),), 1.95),
    "calendar": Hanging("calendar", ((0.32, 0.46),), 1.55),
    "poster": Hanging("poster", ((0.5, 0.72), (0.6, 0.84))),
    "notice_board": Hanging("notice_board", ((1.2, 0.85), (0.9, 0.65))),
    "map": Hanging("wall_map", ((1.2, 0.85),)),
    "books": _shelf("books", 0.9, 1.1),
    "jars": _shelf("jars", 0.9, 1.1),
    "boxes": _shelf("boxes", 1.0, 1.2),
    "bottles": _shelf("bottles", 0.9, 1.1),
    "plates": _shelf("plates", 0.8, 1.0),
    "trinkets": _shelf("trinkets", 0.7, 0.9),
    "pegs": Hanging("peg_rail", ((0.9, 0.16), (0.7, 0.16)), 1.72, True),
}
"""What hangs on walls."""

STANDING: Final[Mapping[str, tuple[str, dict[str, ParamValue]]]] = {
    "bookshelf": ("bookshelf", {}),
    "low_bookshelf": ("bookshelf", {"height": 1.1, "width": 0.8}),
    "cabinet": ("cabinet", {}),
    "dresser": ("dresser", {}),
    "chest": ("chest", {}),
    "chair": ("chair", {}),
    "bench": ("bench", {"width": 1.2}),
    "plant": ("potted_plant", {"width": 0.55, "depth": 0.55, "height": 1.0}),
    "side_table": ("side_table", {"width": 0.45, "depth": 0.4}),
    "hat_stand": ("hat_stand", {}),
    "basket": ("basket", {}),
    "bin": ("trash_can", {"width": 0.3, "depth": 0.3, "height": 0.4}),
    "box": ("cardboard_box", {}),
    "filing_cabinet": ("filing_cabinet", {}),
    "crate": ("crate", {"width": 0.6, "depth": 0.5, "height": 0.5}),
    "barrel": ("barrel", {"width": 0.5, "depth": 0.5, "height": 0.75}),
    "sack": ("sack", {}),
    "bucket": ("bucket", {}),
    "water_cooler": ("water_cooler", {}),
    "store_shelf": ("store_shelf", {}),
    "radiator": ("radiator", {}),
    "washing_basket": ("laundry_basket", {}),
}
"""What stands along walls: prop and parameters."""

SURFACES: Final[Mapping[str, tuple[float, ...]]] = {
    "cabinet": (-0.7, 0.1, 0.8), "dresser": (-0.75, 0.75), "counter": (-0.8, 0.75), "desk": (-0.85, 0.85),
    "dining_table": (0.1,), "side_table": (0.0,), "coffee_table": (0.5,), "nightstand": (-0.4,),
    "workbench": (-0.8, 0.75), "round_table": (0.2,), "filing_cabinet": (0.0,), "chest": (),
}  # fmt: skip
"""Furniture that small things lie on -> where, from its left end (-1) to its right end (1)."""

ROOMS: Final[Mapping[str, Belongings]] = {
    "home": Belongings(
        ("picture", "small_picture", "books", "mirror", "small_picture", "classic+modern:clock", "picture", "trinkets"),
        ("low_bookshelf", "plant", "chair", "cabinet", "side_table", "basket"),
        ("book", "vase", "bowl", "cup", "mantel_clock", "jewel_box"),
    ),
    "bedroom": Belongings(
        ("picture", "small_picture", "mirror", "books", "modern:poster", "pegs", "small_picture", "trinkets"),
        ("dresser", "chair", "washing_basket", "low_bookshelf", "plant", "chest"),
        ("book", "vase", "jewel_box", "hairbrush", "folded_clothes", "cup"),
    ),
    "kitchen": Belongings(
        ("jars", "plates", "classic+modern:clock", "classic+modern:calendar", "pegs", "small_picture", "jars"),
        ("cabinet", "basket", "chair", "classic+modern:bin", "past:barrel", "past:sack", "side_table", "plant"),
        ("bowl", "jar", "teapot", "bread", "pot", "jug", "cutting_board", "basket", "cup", "modern:toaster"),
    ),
    "bathroom": Belongings(
        ("bottles", "mirror", "small_picture", "pegs"),
        ("washing_basket", "side_table", "plant"),
        ("bottle", "folded_clothes", "cup", "jar"),
    ),
    "office": Belongings(
        ("picture", "notice_board", "books", "classic+modern:clock", "map", "classic+modern:calendar", "small_picture",
         "boxes"),
        ("filing_cabinet", "low_bookshelf", "classic+modern:bin", "chair", "plant", "cabinet",
         "classic:hat_stand", "box"),
        ("folder", "book", "cup", "classic+modern:clipboard", "newspaper", "envelope"),
    ),
    "public": Belongings(
        ("notice_board", "classic+modern:poster", "classic+modern:clock", "picture", "map", "classic+modern:calendar"),
        ("bench", "plant", "classic+modern:bin", "chair", "filing_cabinet", "cabinet"),
        ("folder", "cup", "book", "newspaper", "vase"),
    ),
    "tavern": Belongings(
        ("picture", "bottles", "mirror", "small_picture", "classic+modern:poster", "plates", "pegs"),
        ("cabinet", "plant", "chair", "hat_stand", "past:barrel", "crate", "side_table"),
        ("bottle", "glass", "plate", "bowl", "beer_mug", "ashtray"),
    ),
    "shop": Belongings(
        ("boxes", "classic+modern:poster", "jars", "classic+modern:calendar", "small_picture", "boxes"),
        ("store_shelf", "crate", "basket", "box", "sack", "cabinet"),
        ("jar", "folder", "basket", "bottle", "book"),
    ),
    "work": Belongings(
        ("boxes", "pegs", "classic+modern:calendar", "bottles", "boxes", "modern:poster"),
        ("crate", "barrel", "box", "bucket", "sack", "cabinet", "bench"),
        ("toolbox", "tin_can", "hammer", "bottle", "rope", "cloth", "jar"),
    ),
    "farm": Belongings(
        ("pegs", "boxes", "pegs"),
        ("sack", "bucket", "barrel", "crate", "basket", "bench"),
        ("bucket", "rope", "jug"),
    ),
    "rustic": Belongings(
        ("jars", "pegs", "plates", "small_picture", "trinkets"),
        ("chest", "barrel", "basket", "bench", "sack", "bucket"),
        ("jug", "bowl", "bread", "book", "basket"),
    ),
}  # fmt: skip
"""The sorts of rooms."""

ONE: Final = frozenset({"clock", "calendar", "map", "hat_stand", "bin", "notice_board", "mantel_clock", "teapot"})
"""Of these a room has one."""
