"""What pictures would suit a place: the surfaces of its set by their material, its sky by hour and weather. Pure."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from storyblender.catalog.light_recipes import HOURS
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.decided import is_ground
from storyblender.memory.scene_context import SceneSetup
from storyblender.memory.vocabulary import TimeOfDay, Weather

Words = frozenset[str]
_FAMILIES = tuple(
    tuple(line.split())
    for line in (
        "wood dado wooden plank planks board boards floorboards parquet timber deck",
        "brick bricks",
        "cobbles cobble cobblestone cobblestones sett setts",
        "paving pavement flagstone flagstones pavers slabs",
        "stone stones masonry",
        "rock rocks cliff",
        "plaster stucco limewash plastered",
        "concrete cement",
        "asphalt tarmac",
        "grass lawn meadow",
        "forest woodland",
        "gravel pebbles",
        "dirt dust mud soil earth",
        "sand sandy dune",
        "snow snowy",
        "tile tiles tiled",
        "carpet rug",
        "lino linoleum vinyl",
        "marble",
        "wallpaper paper",
    )
)
"""Words of one material, the usual one first: a picture must be called by one that its finish is called by."""
_HUES = frozenset(("red", "green", "blue", "rose", "teal", "mint", "ochre", "yellow", "terracotta", "black"))
"""Colours that a finish is chosen for; shades of white, grey and brown differ less than pictures do."""
_ON_WALLS, _ON_FLOORS = frozenset(("wall", "walls", "facade")), frozenset(("floor", "ground", "terrain", "road"))
_NEVER = frozenset(("roof", "roofing", "ceiling", "fabric", "bark", "leaves", "fur", "leather"))
_OUTSIDE = frozenset(("outdoor", "outdoors", "outside", "nature", "urban", "skies"))
_NOT_BY_DAY = frozenset(
    ("indoor", "interior", "studio", "night", "moon", "moonlit", "sunrise", "sunset", "dusk", "dawn")
)
_TIMES: dict[TimeOfDay, Words] = {
    "morning": frozenset(("morning",)), "afternoon": frozenset(("afternoon",)),
    "day": frozenset(("day", "midday", "noon", "morning", "afternoon")), "noon": frozenset(("midday", "noon", "day")),
}  # fmt: skip
_CLEAR: dict[Weather, str] = {"clear": "clear sunny blue sky"}
_CLOUDED = "overcast grey cloudy sky"
_WORD = re.compile(r"[a-z]+")


@dataclass(frozen=True)
class PictureWish:
    """What a picture is wanted of.

    Attributes:
        phrase: In words, for its likeness.
        fits: Tells by the words of a picture whether it can be that at all.
    """

    phrase: str
    fits: Callable[[Words], bool]


def wall_wish(plan: SetPlan) -> PictureWish | None:
    """Return what walls would be made of; None where they are of several materials, or of none that has pictures."""
    fronts = [piece for piece in plan.pieces if piece.part == "facade"]
    walls = [wall for wall in plan.walls if not wall.missing]
    materials = {wall.material for wall in walls} | {str(front.params.get("material", "brick")) for front in fronts}
    if len(materials) != 1 or any(wall.dado for wall in walls):
        return None
    return _surface_wish(materials.pop(), "wall", _ON_FLOORS - _ON_WALLS, _ON_WALLS)


def ground_wish(plan: SetPlan) -> PictureWish | None:
    """Return what the floor or the ground would be made of; None where it is of several materials."""
    slabs = [slab for slab in plan.slabs if is_ground(slab, plan)]
    terrain = [str(piece.params.get("material", "grass")) for piece in plan.pieces if piece.part == "terrain"]
    materials = {*(slab.material for slab in slabs), *terrain}
    if len(materials) != 1:
        return None
    return _surface_wish(materials.pop(), "floor" if plan.indoor else "ground", _ON_WALLS, _ON_FLOORS)


def sky_wish(setup: SceneSetup, plan: SetPlan) -> PictureWish | None:
    """Return what panorama would light a place; None indoors and where lamps burn for the hour.

    Args:
        setup: Of the scene, as decided.
        plan: Its set.
    """
    if plan.indoor or HOURS[setup.time_of_day].lamps or setup.time_of_day not in _TIMES:
        return None
    times, clear = _TIMES[setup.time_of_day], setup.weather in _CLEAR

    def fits(words: Words) -> bool:
        grey = "overcast" in words or ("cloudy" in words and "partly" not in words)
        in_weather = not grey and bool(words & {"clear", "sunny", "partly"}) if clear else grey
        return bool(words & _OUTSIDE) and not words & _NOT_BY_DAY and bool(words & times or not clear) and in_weather

    air = _CLEAR.get(setup.weather, _CLOUDED)
    return PictureWish(f"{SETS[plan.kit].name.lower()}, {setup.place.lower()}, {setup.time_of_day}, {air}", fits)


def _surface_wish(finish: str, use: str, others: Words, own: Words) -> PictureWish | None:
    """Return what a finish would be as pictures; None for one of no material that has any.

    Args:
        finish: As a plan names it: ``boards_dark``.
        use: What is made of it.
        others: Words for what it is not used on.
        own: Words for what it is used on, which count for more.
    """
    said = frozenset(_WORD.findall(finish))
    family = next((words for words in _FAMILIES if said.intersection(words)), None)
    if family is None:
        return None
    hues = said & _HUES

    def fits(words: Words) -> bool:
        elsewhere = words & others and not words & own
        return not words.isdisjoint(family) and hues <= words and not elsewhere and not words & _NEVER

    names = dict.fromkeys((*finish.split("_"), family[0], use))
    return PictureWish(" ".join(name for name in names if name != "dado"), fits)
