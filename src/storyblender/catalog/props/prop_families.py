"""Families of props that can replace each other: the script's table may be any table of the set."""

from __future__ import annotations

from storyblender.catalog.props.prop_names import prop_named

FAMILIES: tuple[frozenset[str], ...] = tuple(
    frozenset(line.split())
    for line in (
        "round_table dining_table side_table coffee_table",
        "desk workbench school_desk",
        "chair office_chair stool rocking_chair deck_chair",
        "armchair rocking_chair",
        "sofa booth carriage_seat",
        "bench pew",
        "bed hospital_bed bunk_bed",
        "nightstand side_table",
        "wardrobe cabinet dresser locker bookshelf",
        "bar_counter counter",
        "piano grand_piano",
        "stove wood_stove",
        "table_lamp bankers_lamp candle_holder lantern candelabra candle",
        "floor_lamp candelabra",
        "pendant_lamp chandelier paper_lantern",
        "wall_clock",
        "picture wall_map notice_board",
        "television",
        "fireplace",
        "car van taxi truck police_car",
        "cart wagon carriage",
        "shopping_cart",
        "store_shelf",
        "crate barrel chest cardboard_box",
        "market_stall",
        "log",
        "throne",
    )
)


def family_of(prop: str) -> frozenset[str]:
    """Return a prop together with all props that can replace it."""
    return frozenset({prop}).union(*(family for family in FAMILIES if prop in family))


def props_named(name: str) -> frozenset[str]:
    """Return the props that a name from the script may mean: ``counter`` is any counter, also a bar's."""
    entry = prop_named(name.replace("_", " "))
    return frozenset() if entry is None else family_of(entry.key)
