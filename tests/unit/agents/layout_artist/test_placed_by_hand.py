"""Placing things by hand: what they drop onto, what goes with them, what they stand in."""

from __future__ import annotations

import math
import random

from tests.every import every

from storyblender.agents.layout_artist.placed_by_hand import Stand, obstructions, place_by_hand, riders_of
from storyblender.catalog.sets import plan_of
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, Layout, LayoutObject
from storyblender.memory.scene_decision import ThingPlace

PLAN = plan_of(Environment(kit="kitchen", params={"width": 8.0, "depth": 7.0}))
SIZES = {"desk": (1.6, 0.8, 0.75), "cup": (0.1, 0.1, 0.1), "tray": (0.4, 0.3, 0.03), "chair": (0.5, 0.5, 0.9),
         "clock": (0.3, 0.05, 0.3), "rug": (3.0, 2.0, 0.01), "bed": (2.0, 1.6, 0.5)}  # fmt: skip
TOPS = {"desk": 0.75, "tray": 0.03}


def measure(name: str) -> AssetMeasure:
    width, depth, _ = SIZES[name]
    anchors = [Anchor(kind="top", location=(0, 0, TOPS[name]), size=(width, depth))] if name in TOPS else []
    anchors += [Anchor(kind="seat", location=(0, -0.2, 0.45), size=(0.45, 0.4))] if name == "chair" else []
    return AssetMeasure(asset_id=name, digest="", geometry_hash="", dimensions=SIZES[name], anchors=tuple(anchors))


def thing(name: str, x: float, y: float, z: float = 0.0, yaw: float = 0.0, on: str | None = None) -> LayoutObject:
    relation = {"anchor_asset_id": on, "relationship": "on_top_of", "contact": True} if on else {}
    return LayoutObject(node_id=name, asset_id=name, location=(x, y, z), rotation=(0, 0, yaw), **relation)


STAND = Stand({name: measure(name) for name in SIZES}, PLAN, {"desk": "floor", "chair": "floor", "bed": "floor",
                                                              "rug": "floor", "clock": "wall"})  # fmt: skip
LAYOUT = Layout(
    scene_size=PLAN.size,
    objects=(
        thing("rug", 0, 0), thing("desk", 0, 0.5, yaw=10), thing("tray", 0.2, 0.6, 0.75, 25, on="desk"),
        thing("cup", 0.25, 0.62, 0.78, on="tray"), thing("chair", 2.5, 0),
    ),
)  # fmt: skip


def at(layout: Layout, name: str) -> LayoutObject:
    return next(item for item in layout.objects if item.node_id == name)


def test_all_that_is_on_it_keeps_its_place_on_it() -> None:
    assert riders_of(LAYOUT, "desk", STAND) == ["tray", "cup"] and riders_of(LAYOUT, "rug", STAND) == []
    chance = random.Random(3)
    for _ in range(50):
        place = ThingPlace(location=(chance.uniform(-3, 3), chance.uniform(-3, 3)), rotation=chance.uniform(-360, 360))
        moved = place_by_hand(LAYOUT, {"desk": place}, STAND)
        desk = at(moved, "desk")
        assert desk.location[:2] == place.location and desk.rotation[2] == place.rotation
        for name in ("tray", "cup"):
            apart = [math.dist(at(each, name).location, at(each, "desk").location) for each in (LAYOUT, moved)]
            turned = [at(each, name).rotation[2] - at(each, "desk").rotation[2] for each in (LAYOUT, moved)]
            assert abs(apart[0] - apart[1]) < 1e-6 and abs(turned[0] - turned[1]) < 1e-6
        back = place_by_hand(moved, {"desk": ThingPlace(location=(0, 0.5), rotation=10)}, STAND)
        assert back == LAYOUT


@every(
    "name x y height on",
    [
        ("cup", 0.0, 0.4, 0.75, "desk"),
        ("cup", 0.2, 0.6, 0.78, "tray"),
        ("cup", 2.0, 2.0, 0.0, None),
        ("chair", 0.0, 0.4, 0.0, None),
        ("tray", 0.0, 0.5, 0.75, "desk"),
        ("bed", 0.0, 0.5, 0.0, None),
    ],
)
def test_it_drops_onto_what_is_below(name: str, x: float, y: float, height: float, on: str | None) -> None:
    layout = LAYOUT if name != "bed" else LAYOUT.model_copy(update={"objects": (*LAYOUT.objects, thing("bed", 3, 3))})
    put = at(place_by_hand(layout, {name: ThingPlace(location=(x, y))}, STAND), name)
    assert (put.location, put.anchor_asset_id) == ((x, y, height), on)
    told = at(place_by_hand(layout, {name: ThingPlace(location=(x, y), height=1.1)}, STAND), name)
    assert told.location == (x, y, 1.1)


def test_turned_alone_it_stays_where_it_is_and_is_again_what_it_was() -> None:
    turned = place_by_hand(LAYOUT, {"tray": ThingPlace(rotation=90)}, STAND)
    assert at(turned, "tray") == at(LAYOUT, "tray").model_copy(update={"rotation": (0, 0, 90)})
    assert place_by_hand(turned, {"tray": ThingPlace(rotation=25)}, STAND) == LAYOUT


def test_things_placed_on_things_that_are_placed_find_them_in_any_order() -> None:
    places = {"cup": ThingPlace(location=(2.0, 2.0)), "desk": ThingPlace(location=(2.0, 2.0), rotation=0)}
    one, other = (place_by_hand(LAYOUT, each, STAND) for each in (places, dict(reversed(places.items()))))
    assert at(one, "cup").location == at(other, "cup").location == (2.0, 2.0, 0.75)
    assert place_by_hand(one, places, STAND) == one


def test_what_it_stands_in_is_told_but_not_what_belongs_together() -> None:
    def told(name: str, place: ThingPlace) -> list[str]:
        return [flaw.message for flaw in obstructions(place_by_hand(LAYOUT, {name: place}, STAND), [name], STAND)]

    assert not told("desk", ThingPlace(location=(0, 0.5))), "a rug below and things on top are in nobody's way"
    assert not told("chair", ThingPlace(location=(0, 0.0))), "a seat goes under its table"
    assert any("deep in desk" in each for each in told("chair", ThingPlace(location=(0, 0.5))))
    wall = told("chair", ThingPlace(location=(PLAN.size.x, 0)))
    assert any("wall" in each for each in wall) and any("outside the room" in each for each in wall)
