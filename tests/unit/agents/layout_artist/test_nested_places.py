"""Things told to be in, on, under, over or fixed to others are there in the layout, and the layout is valid."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import product

import pytest
from tests.crew import RULES
from tests.every import every

from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.catalog.props import PROPS
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import plan_of
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, LayoutObject, SceneSetup, Spot
from storyblender.memory.shot_context import BodyState
from storyblender.reflection import reflect

HOLDERS = ("bucket", "bathtub", "chest", "cardboard_box", "cabinet", "fridge", "washing_machine", "wardrobe")
TABLES = ("desk", "dining_table", "counter", "bed")
SMALL = ("key", "cup", "spider", "letter", "ball")
PLAN = plan_of(Environment(kit="room")).model_copy(update={"furnishings": ()})


def _measure(key: str) -> AssetMeasure:
    size = PROPS[key].size
    top = Anchor(kind="top", location=(0, 0, size[2]), size=size[:2])
    pointed = key in (*SMALL, "tree", "pine", "dead_tree", "lamppost")
    anchors = () if pointed else (top,)
    return AssetMeasure(asset_id=key, digest="", geometry_hash="", dimensions=size, anchors=anchors)


def laid_out(told: Mapping[str, Spot], *others: str, plan: SetPlan = PLAN) -> dict[str, LayoutObject]:
    """Return the valid layout of things with their spots, in a room where Ann stands."""
    things = (*others, *told)
    person = AssetMeasure(
        asset_id="ann", digest="", geometry_hash="", dimensions=(0.5, 0.3, 1.7), asset_type="character"
    )
    view = SpatialPlannerView(
        scene_id=1,
        setup=SceneSetup(asset_ids=(*things, "ann")),
        measures={**{key: _measure(key) for key in things}, "ann": person},
        plan=plan,
        pending=things,
        states=(BodyState(asset_id="ann"),),
        placements={key: PROPS[key].placement for key in things},
        props={key: key for key in things},
        scripted_spots=told,
    )
    outcome = reflect(RULES.spatial_planner, "SC010", view)
    assert outcome.critique.faults == ()
    return {item.asset_id: item for item in outcome.draft.objects}


def local(item: LayoutObject, anchor: LayoutObject) -> tuple[float, float, float]:
    """Return where a thing is in the frame of another."""
    yaw = math.radians(anchor.rotation[2])
    x, y = item.location[0] - anchor.location[0], item.location[1] - anchor.location[1]
    return (
        x * math.cos(yaw) + y * math.sin(yaw),
        y * math.cos(yaw) - x * math.sin(yaw),
        item.location[2] - anchor.location[2],
    )


@every("thing holder relation", product(SMALL, HOLDERS, ("in", "inside")))
def test_what_is_in_a_hollow_thing_is_between_its_bottom_and_its_rim(thing: str, holder: str, relation: str) -> None:
    at = laid_out({thing: Spot(relation=relation, anchor_id=holder)}, holder)
    x, y, z = local(at[thing], at[holder])
    width, depth, height = PROPS[holder].size
    assert abs(x) <= width / 2 and abs(y) <= depth / 2 + 1e-6 and 0 < z < height


@every("thing table", product(SMALL, TABLES))
def test_what_is_on_a_table_touches_its_top(thing: str, table: str) -> None:
    at = laid_out({thing: Spot(relation="on", anchor_id=table)}, table)
    x, y, z = local(at[thing], at[table])
    width, depth, height = PROPS[table].size
    assert abs(x) <= width / 2 and abs(y) <= depth / 2 and z == pytest.approx(height, abs=0.02)


@every("thing table", product(SMALL, TABLES))
def test_what_is_under_a_table_is_on_the_floor_below_it_towards_its_front(thing: str, table: str) -> None:
    at = laid_out({thing: Spot(relation="under", anchor_id=table)}, table)
    x, y, z = local(at[thing], at[table])
    assert abs(x) < PROPS[table].size[0] / 2 and -PROPS[table].size[1] / 2 < y < 0 and z == pytest.approx(0, abs=1e-3)


def test_what_is_under_a_thing_on_a_table_is_on_the_table() -> None:
    told = {"cup": Spot(relation="on", anchor_id="desk"), "letter": Spot(relation="under", anchor_id="cup")}
    at = laid_out(told, "desk")
    assert at["letter"].location[2] == pytest.approx(at["cup"].location[2], abs=0.02)


@pytest.mark.parametrize("relation", ["under", "on"])
def test_a_flat_thing_under_somebody_is_at_their_feet(relation: str) -> None:
    at = laid_out({"puddle": Spot(relation=relation, anchor_id="ann")})
    assert math.dist(at["puddle"].location[:2], at["ann"].location[:2]) < 0.05


@pytest.mark.parametrize("thing", ["rifle", "picture", "wall_clock", "banner"])
@pytest.mark.parametrize("anchor", [None, "wall"])
def test_what_hangs_on_a_wall_at_a_height_is_there_or_as_high_as_the_room_lets_it(
    thing: str, anchor: str | None
) -> None:
    at = laid_out({thing: Spot(relation="against", anchor_id=anchor, height=1.6)})
    tall = min(wall.height for wall in PLAN.walls)
    assert at[thing].location[2] == pytest.approx(min(1.6, tall - PROPS[thing].size[2]), abs=0.01)
    x, y = at[thing].location[:2]
    edges = (PLAN.size.x - x, x - PLAN.size.x_negative, PLAN.size.y - y)
    assert min(edges) <= min(PROPS[thing].size[:2]) / 2 + 0.05, "it hangs flat"


def test_what_is_in_the_air_by_another_is_at_its_height() -> None:
    at = laid_out({"ball": Spot(relation="in_front_of", anchor_id="desk", height=1.5)}, "desk")
    assert at["ball"].location[2] == pytest.approx(1.5)


def test_what_hangs_from_ceilings_does_so_beside_its_anchor_too() -> None:
    at = laid_out({"ceiling_fan": Spot(relation="next_to", anchor_id="desk")}, "desk")
    slab = next(slab.z for slab in PLAN.slabs if slab.role == "ceiling")
    assert at["ceiling_fan"].location[2] + PROPS["ceiling_fan"].size[2] == pytest.approx(slab, abs=0.01)


def test_what_is_on_the_sill_is_in_the_window_at_its_height() -> None:
    window = next((wall, hole) for wall in PLAN.walls for hole in wall.openings if hole.kind == "window")
    at = laid_out({"cup": Spot(relation="on", anchor_id="window")})
    assert at["cup"].location[2] == pytest.approx(window[1].sill, abs=0.01)


@pytest.mark.parametrize("relation", ["behind", "next_to", "left_of"])
@pytest.mark.parametrize("thing", ["door", "picture", "window"])
def test_what_belongs_on_a_wall_is_on_one_beside_its_anchor_too(thing: str, relation: str) -> None:
    x, y, _ = laid_out({thing: Spot(relation=relation, anchor_id="desk")}, "desk")[thing].location
    assert min(PLAN.size.x - x, x - PLAN.size.x_negative, PLAN.size.y - y) < 0.12


@pytest.mark.parametrize("opening", ["door", "window"])
@pytest.mark.parametrize("as_thing", [False, True])
def test_a_house_behind_a_window_is_outside_in_front_of_it(opening: str, as_thing: bool) -> None:
    told = {"house": Spot(relation="behind", anchor_id=opening, distance=8.0)}
    at = laid_out({**({opening: Spot(relation="against")} if as_thing else {}), **told})
    x, y, _ = at["house"].location
    assert max(abs(x) - PLAN.size.x, abs(y) - PLAN.size.y) > 5.0


TREE_PLAN = plan_of(Environment(kit="open_ground")).model_copy(update={"furnishings": (), "pieces": ()})


@pytest.mark.parametrize("tree", ["tree", "pine", "dead_tree"])
@pytest.mark.parametrize("height", [None, 3.0])
def test_what_is_in_a_tree_is_up_at_its_trunk_and_holds_what_is_in_it(tree: str, height: float | None) -> None:
    told = {
        "nest_box": Spot(relation="in", anchor_id=tree, height=height),
        "ball": Spot(relation="inside", anchor_id="nest_box"),
    }
    found = laid_out(told, tree, plan=TREE_PLAN)
    box, trunk, ball = found["nest_box"], found[tree], found["ball"]
    assert box.location[2] == pytest.approx(height or 0.36 * PROPS[tree].size[2], abs=0.02)
    assert math.dist(box.location[:2], trunk.location[:2]) < 0.5
    assert box.location[1] < trunk.location[1], "on the side of the audience"
    assert 0.0 < ball.location[2] - box.location[2] < PROPS["nest_box"].size[2]


def test_what_is_on_a_tall_thing_without_a_level_top_is_up_there() -> None:
    found = laid_out({"lantern": Spot(relation="on", anchor_id="lamppost")}, "lamppost", plan=TREE_PLAN)
    assert found["lantern"].location[2] > 1.3


@pytest.mark.parametrize(("lamp", "table"), [("lamppost", None), ("table_lamp", "desk")])
def test_what_is_too_large_to_be_under_a_thing_is_on_the_floor_beside_it(lamp: str, table: str | None) -> None:
    told = {"bench": Spot(relation="under", anchor_id=lamp)}
    at = laid_out({**({lamp: Spot(relation="on", anchor_id=table)} if table else {}), **told}, table or lamp)
    x, y, _ = local(at["bench"], at[table or lamp])
    reach = [(PROPS["bench"].size[axis] + PROPS[table or lamp].size[axis]) / 2 for axis in (0, 1)]
    assert at["bench"].location[2] == pytest.approx(0, abs=1e-3)
    assert reach[0] <= abs(x) + 0.01 < reach[0] + 1 or reach[1] <= abs(y) + 0.01 < reach[1] + 1
