"""Set kit: a street seen across: pavement with people, facades behind, road with cars before, lampposts both sides."""

from __future__ import annotations

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets.drawing import SODIUM, Drawing, SetParams, rectangle
from storyblender.catalog.sets.ground import REACH, Ground
from storyblender.catalog.sets.kit import SetKit, Span

PAVEMENT = (-2.2, 2.8)
ROAD = (-9.6, -2.2)
FAR_PAVEMENT = (-13.2, -9.6)
STREET_LENGTH = 44.0
_WALLS = ("brick_red", "brick_brown", "limewash", "plaster_grey", "stone_light", "brick_yellow", "plaster_rose")


def row_of_facades(
    drawing: Drawing, y: float, yaw: float, *, start: float, end: float, floors: tuple[int, ...], shops: bool = True
) -> None:
    """Close one side of a street with a row of house fronts.

    Args:
        drawing: Receives the houses.
        y: Of the fronts, metres.
        yaw: Degrees; 0 faces -Y.
        start: X of one end of the row.
        end: X that the row reaches at least.
        floors: Numbers of storeys to choose from.
        shops: Whether some houses have a shop.
    """
    rng, first = drawing.rng, int(drawing.rng.integers(len(_WALLS)))
    designs = [
        (
            width,
            float(floors[int(rng.integers(len(floors)))]),
            _WALLS[(first + index) % len(_WALLS)],
            float(rng.integers(1000)),
        )
        for index, width in enumerate((8.4, 9.6, 7.2, 11.0))
    ]
    at, index = start, int(rng.integers(4))
    while at < end:
        width, height, wall, seed = designs[index % 4]
        drawing.piece(
            "facade",
            at + width / 2,
            y,
            yaw=yaw,
            footprint=(width, 0.1),
            width=width,
            floors=height,
            material=wall,
            shop=shops and index % 2 == 0,
            seed=seed,
        )
        at, index = at + width, index + 1


def lay_road(drawing: Ground, *, old: bool) -> None:
    """Lay pavements, kerbs and a road along x, from horizon to horizon.

    Args:
        drawing: Receives the slabs and pieces.
        old: Cobbles instead of asphalt.
    """
    pave, road = ("flagstones", "cobbles") if old else ("paving", "asphalt")
    drawing.slab("ground", rectangle(-REACH, PAVEMENT[0], REACH, REACH), pave, wet=True)
    drawing.slab("ground", rectangle(-REACH, ROAD[0], REACH, ROAD[1]), road, wet=True)
    drawing.slab("ground", rectangle(-REACH, -REACH, REACH, FAR_PAVEMENT[1]), pave, wet=True)
    for y in (PAVEMENT[0], FAR_PAVEMENT[1]):
        drawing.piece("kerb", 0, y, length=2 * STREET_LENGTH)
    if not old:
        drawing.piece("road_marking", 0, (ROAD[0] + ROAD[1]) / 2, length=2 * STREET_LENGTH)


def draw(params: SetParams, rng: np.random.Generator) -> SetPlan:
    """Plan a street: both rows of houses, the road between, and the things of a street."""
    street = Ground("street", params, rng)
    if params.option("frontier"):
        return _frontier(street)
    x, old = street.half_x, params.period == "past"
    lay_road(street, old=old)
    floors = (2, 3, 3) if old else (3, 4, 4, 5)
    row_of_facades(street, PAVEMENT[1], 0, start=-STREET_LENGTH, end=STREET_LENGTH, floors=floors)
    row_of_facades(street, FAR_PAVEMENT[0], 180, start=-STREET_LENGTH, end=STREET_LENGTH, floors=floors)
    for side in (-1, 1):
        end = side * (STREET_LENGTH + 4)
        street.card("facades", (end, side * 24.0), (end, side * -34.0), -1.0, 16.0)
        street.card("skyline", (end + side * 8, side * 36.0), (end + side * 8, side * -46.0), -1.0, 24.0)
    for index in range(-3, 4):
        for px, py in ((index * 11.0 + 5.5, PAVEMENT[0] + 0.5), (index * 11.0, FAR_PAVEMENT[1] - 0.5)):
            street.furnish("lamppost", px, py, required=abs(index) < 2)
    street.vehicle(-6.2, ROAD[1] - 1.25, 90)
    street.vehicle(8.4, ROAD[0] + 1.3, -90, "#5c2422")
    street.furnish("park_bench", -x + 1.2, PAVEMENT[1] - 0.6, required=False)
    street.furnish("trash_can" if not old else "barrel", x - 1.6, PAVEMENT[1] - 0.5, required=False)
    street.furnish("hydrant" if not old else "crate", 3.1, PAVEMENT[0] + 0.6, required=False)
    for px in (-x * 0.55, x * 0.6):
        street.lamp(
            "shop_window", (px, PAVEMENT[1] - 0.25, 1.8), 60, SODIUM, kind="AREA", size=2.0, target=(px, -2, 0.4)
        )
    street.entrances(back=False)
    street.mark("house_door", 0, PAVEMENT[1] - 0.7, 0, "enter", "exit", "door", "back")
    street.mark("kerb", 1.5, PAVEMENT[0] + 0.5, 0, "kerb", "window")
    street.mark("road", 0, (ROAD[0] + ROAD[1]) / 2, 180, "road")
    return street.finish()


def _frontier(street: Ground) -> SetPlan:
    """Draw the main street of a frontier town: dust between two rows of wooden fronts with their boardwalks."""
    street.slab("ground", rectangle(-REACH, -REACH, REACH, REACH), "dust")
    for y, yaw, walk in ((PAVEMENT[1] + 2.2, 0, (2.6, 5.0)), (FAR_PAVEMENT[0] - 1.0, 180, (-14.4, -12.0))):
        street.slab("patch", rectangle(-STREET_LENGTH, walk[0], STREET_LENGTH, walk[1]), "planks_gray", z=0.02)
        for index in range(-4, 5):
            at = index * 9.2 + (0.0 if yaw else 2.4)
            street.piece("false_front", at, y, yaw=yaw, footprint=(9.0, 0.3), width=9.0, seed=float(index % 4),
                         height=(5.4, 6.6, 4.9, 5.9)[index % 4], doors=index % 3 == 0,
                         material=("planks_gray", "wall_planks", "boards", "limewash")[index % 4])  # fmt: skip
    street.ring("hills", 80, 14)
    x = street.half_x
    street.piece("hitching_rail", -x * 0.45, 2.1, length=3.0, footprint=(3.0, 0.2))
    for prop, px, py, yaw in (
        ("horse", -x * 0.45 - 0.8, 0.9, 180), ("trough", x * 0.5, 2.2, 0), ("barrel", x - 0.6, 2.4, 0),
        ("barrel", x - 1.3, 2.45, 0), ("wagon_wheel", -x + 0.5, 2.5, 20), ("cart", 9.5, -8.5, 80),
        ("crate", -7.5, -11.5, 8),
    ):  # fmt: skip
        street.furnish(prop, px, py, yaw=yaw, required=False)
    street.entrances(back=False)
    street.mark("house_door", 0, PAVEMENT[1] - 0.7, 0, "enter", "exit", "door", "back", "saloon")
    street.mark("rail", -x * 0.45 + 1.9, 1.4, 180, "rail", "window", "kerb")
    street.mark("road", 0, -5.0, 180, "road")
    return street.finish()


KIT = SetKit(
    key="street", name="Street",
    tags=("street", "road", "avenue", "sidewalk", "pavement", "city", "downtown", "town", "boulevard", "intersection",
        "shopfront", "building", "crosswalk"),
    indoor=False, draw=draw, width=Span(10.0, 14.0, 24.0), depth=Span(5.0, 5.2, 5.6), options={"frontier": False},
    has=("house", "building", "shutter", "curtain", "blind", "porch", "hitching rail", "boardwalk", "kerb", "rail"),
)  # fmt: skip
