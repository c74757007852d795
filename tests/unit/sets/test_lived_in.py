"""Rooms where people live have things on their walls and tops, and nothing of it is in anybody's way."""

from __future__ import annotations

import math
from itertools import product

from tests.every import every

from storyblender.agents.visual_effects_artist.furniture import prop_size
from storyblender.agents.visual_effects_artist.set_dresser import RulesSetDresser, SetDresserView
from storyblender.catalog.footprints import piece_boxes, stage_box
from storyblender.catalog.props import PROPS
from storyblender.catalog.set_plan import Furnishing, SetPlan
from storyblender.catalog.sets import SETS, plan_of
from storyblender.catalog.sets.belongings import HUNG, ONE, ROOMS, STANDING, SURFACES
from storyblender.catalog.sets.lived_in import lived_in
from storyblender.geometry.boxes import Box, penetration
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.scene_context import Environment, SceneSetup

LIVED_IN = [key for key, kit in SETS.items() if kit.room]


def plan(key: str, period: str = "classic", seed: int = 3, size: str = "usual") -> SetPlan:
    kit = SETS[key]
    params = {"period": period, "width": getattr(kit.width, size), "depth": getattr(kit.depth, size)}
    return plan_of(Environment(kit=key, params=params, seed=seed))


def kept(of: SetPlan) -> list[Furnishing]:
    return [item for item in of.furnishings if "_kept_" in item.node_id]


def box(item: Furnishing) -> Box:
    return Box(*item.location, *prop_size(item.prop, item.params), math.radians(item.yaw))


def test_every_word_of_the_belongings_is_known() -> None:
    for room in ROOMS.values():
        walls, floor, tops = ({word.rpartition(":")[2] for word in words} for words in vars(room).values())
        assert walls <= set(HUNG) and floor <= set(STANDING) and tops <= set(PROPS)
    assert {prop for prop, _ in STANDING.values()} | set(SURFACES) <= set(PROPS)
    assert {*HUNG, *STANDING, *PROPS} >= ONE


@every("key size", product(LIVED_IN, ("least", "usual")))
def test_what_is_kept_stands_in_nothing_and_in_nobodys_way(key: str, size: str) -> None:
    room = plan(key, size=size)
    others = [(item.node_id, box(item)) for item in room.furnishings if item.prop not in ("curtain", "rug")]
    others += [(piece.node_id, each) for piece in room.pieces for each in piece_boxes(piece)]
    stage = stage_box(room)
    for item in kept(room):
        assert not item.required
        own = box(item)
        clashes = [node for node, other in others if node != item.node_id and penetration(own, other, 0.01)[0] > 0.06]
        assert not clashes, item.node_id
        assert own.z > 0.2 or penetration(own, stage)[0] <= 0.0


@every("key", LIVED_IN)
def test_nothing_hangs_over_a_door_or_a_window(key: str) -> None:
    room = plan(key)
    hung = [(item.node_id, box(item)) for item in kept(room) if PROPS[item.prop].placement == "wall"]
    for wall in room.walls:
        length = math.dist(wall.start, wall.end)
        along = ((wall.end[0] - wall.start[0]) / length, (wall.end[1] - wall.start[1]) / length)
        for node, own in hung:
            dx, dy = own.x - wall.start[0], own.y - wall.start[1]
            if abs(-dx * along[1] + dy * along[0]) > 0.2:
                continue
            at, half = dx * along[0] + dy * along[1], own.width / 2
            for hole in wall.openings:
                beside = at + half <= hole.x or at - half >= hole.x + hole.width
                assert beside or own.z >= hole.sill + hole.height or own.top <= hole.sill, node


def test_a_kitchen_is_lived_in_and_an_empty_cell_is_not() -> None:
    assert len(kept(plan("kitchen"))) >= 5
    assert not kept(plan("interrogation"))


def test_the_same_seed_keeps_the_same_things_and_another_seed_others() -> None:
    assert plan("living_room", seed=5) == plan("living_room", seed=5)
    assert kept(plan("living_room", seed=5)) != kept(plan("living_room", seed=6))


def test_before_electric_light_nobody_keeps_a_clock_on_the_wall_or_a_calendar() -> None:
    things = {item.prop for seed in range(6) for item in kept(plan("kitchen", "past", seed))}
    assert not things & {"wall_clock", "calendar", "toaster"}


def test_a_sort_of_room_that_nobody_knows_stays_as_it_is() -> None:
    bare = plan("interrogation")
    assert lived_in(bare, "", "classic", 1) is bare


def test_a_thing_of_the_script_takes_no_place_of_what_lies_about() -> None:
    room = plan("kitchen")
    loose = [item.prop for item in room.furnishings if item.loose]
    fixed = {item.prop for item in room.furnishings if not item.loose}
    prop = next(prop for prop in loose if prop not in fixed)
    own = Asset(asset_id=prop, asset_type="object", name=prop.replace("_", " "), description="Of the script.")
    dressing = RulesSetDresser().propose(SetDresserView(SceneSetup(place="KITCHEN"), room, (own,)))
    assert dressing.pending == (prop,)
