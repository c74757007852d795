"""Fixtures: parts of a set that a character can stand at, such as doors, windows, corners and stairs. Pure."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from storyblender.catalog.inflection import noun_key
from storyblender.catalog.openings import openings_of
from storyblender.catalog.props.variants import words_of
from storyblender.catalog.set_plan import SetPlan
from storyblender.geometry.boxes import Box, yaw_along

FixtureKind = Literal["door", "window", "wall", "corner", "piece", "mark"]

_MEANINGS: dict[str, FixtureKind] = {
    **dict.fromkeys(("door", "doorway", "entrance", "exit", "threshold", "doorframe", "gate", "gateway"), "door"),
    **dict.fromkeys(("window", "windowsill", "sill", "windowpane", "pane"), "window"),
    "wall": "wall",
    "corner": "corner",
}
_SAME: dict[str, tuple[str, ...]] = {
    "staircase": ("stairs",), "stair": ("stairs",), "step": ("stairs",), "pillar": ("column",), "post": ("column",),
    "rail": ("railing", "parapet"), "railing": ("parapet",), "curtain": ("drape",), "boulder": ("rock",),
    "bush": ("hedge",), "altar": ("table",), "quay": ("quay_edge",), "pier": ("quay_edge",),
}  # fmt: skip
_SCATTERED = 6
"""Pieces of one sort above which they are growth, fencing or lighting, and nobody means one of them."""
_UNDERFOOT = frozenset(
    {"terrain", "runway_paint", "road_marking", "parking_bays", "court_lines", "paint_spots", "ice_cracks"}
)
"""Pieces that are the ground itself."""
_IN_CORNER = 0.55
"""Metres from both walls to a person who stands in a corner."""
_AT_WALL = 0.5
"""Metres beyond the playing area to which what stands or hangs at its edge belongs to it."""
_TALL = 2.0
_MARK = 0.02
"""Width in metres of the box of a named place without geometry."""


@dataclass(frozen=True)
class Fixture:
    """A part of a set that the script can refer to.

    Attributes:
        name: Id of the opening, wall, piece or mark.
        kind: Type of the fixture.
        box: Extent of the fixture; its front faces a person in front of it.
        tags: Synonyms; ``enter`` marks an entrance.
    """

    name: str
    kind: FixtureKind
    box: Box
    tags: tuple[str, ...] = ()


def fixtures_called(plan: SetPlan, name: str | None) -> list[Fixture]:
    """Return the fixtures of a set that a name from the script may mean, the best match first.

    Args:
        plan: The set.
        name: An id or words: ``doorway``, ``kitchen_window``, ``the back wall``.
    """
    exact = [fixture for fixture in fixtures_of(plan) if fixture.kind == "piece" and fixture.name == name]
    if exact:
        return exact
    words = [noun_key(word) for word in words_of((name or "").replace("_", " "))]
    if not words:
        return []
    last = words[-1]
    kind = _MEANINGS.get(last)
    found = [fixture for fixture in fixtures_of(plan) if fixture.kind == kind]
    if not found:
        wanted = {last, *_SAME.get(last, ())}
        found = [fixture for fixture in fixtures_of(plan) if wanted & {*fixture.tags}]
        found.sort(key=lambda fixture: fixture.kind == "mark")
    told = {*words}
    return sorted(found, key=lambda fixture: -len(told & {*fixture.tags, *fixture.name.split("_")}))


def parts_of(plan: SetPlan) -> tuple[str, ...]:
    """Return the words for the parts of a set at which a thing can be: ``door``, ``window``, ``bar``."""
    pieces = named_pieces(plan)[0]
    kinds = [fixture.kind for fixture in fixtures_of(plan) if fixture.kind not in ("piece", "mark")]
    return (*dict.fromkeys(kinds), *(word for piece in pieces for word in {piece: 0, piece.split()[-1]: 0}))


def is_part_called(word: str, parts: Sequence[str]) -> bool:
    """Return whether a word means one of the parts of a set.

    Args:
        word: ``doorway``.
        parts: As ``parts_of`` names them.
    """
    last = noun_key(word)
    return bool({_MEANINGS.get(last, last), *_SAME.get(last, ())} & {*parts})


def named_pieces(plan: SetPlan) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the names of the pieces of a set that a script may mean, in words, each once.

    Args:
        plan: The set.

    Returns:
        Those of the playing area and its walls, and those that stand beyond it.
    """
    counts = Counter(piece.part for piece in plan.pieces)
    shown = [piece for piece in plan.pieces if counts[piece.part] <= _SCATTERED and piece.part not in _UNDERFOOT]
    size = plan.size
    near = {
        piece.part
        for piece in shown
        if size.x_negative - _AT_WALL < piece.location[0] < size.x + _AT_WALL
        and size.y_negative - _AT_WALL < piece.location[1] < size.y + _AT_WALL
    }
    names = [*dict.fromkeys(piece.part for piece in shown)]
    inside, beyond = ([name.replace("_", " ") for name in names if (name in near) == here] for here in (True, False))
    return tuple(inside), tuple(beyond)


def fixtures_of(plan: SetPlan) -> Iterator[Fixture]:
    """Yield the walls, openings, corners, pieces and marks of a set."""
    for wall in plan.walls:
        if not wall.missing:
            yield _wall(wall.node_id, wall.start, wall.end, wall.height)
        for place in openings_of(wall):
            kind = "window" if place.opening.kind == "window" else "door"
            box = Box(*place.location, *place.size, place.yaw)
            if place.opening.style != "open":
                yield Fixture(place.opening.name, kind, box, (kind, *place.opening.name.split("_")))
    if plan.indoor:
        yield from _corners(plan)
    for piece in plan.pieces:
        width, depth = (size * piece.scale for size in piece.footprint or (_MARK, _MARK))
        height = float(piece.params.get("tall", _TALL))
        box = Box(*piece.location, width, depth, height, math.radians(piece.yaw))
        tags = (piece.part, *(noun_key(word) for word in piece.part.split("_")))
        yield Fixture(piece.node_id, "piece", box, tags)
    for mark in plan.marks:
        box = Box(*mark.location, _MARK, _MARK, 0.0, math.radians(mark.yaw))
        yield Fixture(mark.name, "mark", box, (mark.name, *mark.tags))


def _wall(name: str, start: tuple[float, float], end: tuple[float, float], height: float) -> Fixture:
    """Return a wall as a fixture, tagged with its side of the room."""
    length = math.dist(start, end)
    along = ((end[0] - start[0]) / length, (end[1] - start[1]) / length)
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    box = Box(*middle, 0.0, length, _MARK, height, yaw_along(-along[1], along[0]))
    sides = {(0, 1): "right", (0, -1): "left", (1, 0): "front", (-1, 0): "back"}
    side = sides.get((round(along[0]), round(along[1])), "side")
    return Fixture(name, "wall", box, ("wall", side))


def _corners(plan: SetPlan) -> Iterator[Fixture]:
    """Yield the two back corners of the room, as seen from the audience."""
    size = plan.size
    for side, x in (("left", size.x_negative + _IN_CORNER), ("right", size.x - _IN_CORNER)):
        y = size.y - _IN_CORNER
        yaw = yaw_along((size.x + size.x_negative) / 2 - x, (size.y + size.y_negative) / 2 - y)
        yield Fixture(f"{side}_corner", "corner", Box(x, y, 0.0, _MARK, _MARK, 0.0, yaw), ("corner", side))
