"""People of the background stand and sit where there is room, and never in the story's way."""

from __future__ import annotations

import math

import pytest

from storyblender.agents.layout_artist.bystanders import bystander_objects, crowd_size, place_bystanders
from storyblender.agents.layout_artist.spatial_planner import RulesSpatialPlanner, free_floor_of
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView, measures_of, props_of
from storyblender.agents.visual_effects_artist.furniture import dressing_asset
from storyblender.agents.visual_effects_artist.set_dresser import RulesSetDresser, SetDresserView
from storyblender.catalog.bystanders import BYSTANDER
from storyblender.catalog.sets import plan_of
from storyblender.geometry.boxes import Box, penetration
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, SceneSetup
from storyblender.memory.shot_context import BodyState


def view_of(kit: str) -> SpatialPlannerView:
    plan = plan_of(Environment(kit=kit, seed=2))
    dressing = RulesSetDresser().propose(SetDresserView(SceneSetup(place=kit.upper()), plan))
    measures = measures_of(dressing.assets)
    seat = Anchor(kind="seat", location=(0.0, -0.2, 0.46), size=(0.44, 0.44))
    for name in [name for name in measures if name.startswith("set_chair")]:
        measures[name] = measures[name].model_copy(update={"anchors": (seat,)})
    for name in ("ada", "tom"):
        measures[name] = AssetMeasure(
            asset_id=name, digest="", geometry_hash="", dimensions=(0.5, 0.4, 1.7), asset_type="character"
        )
    states = tuple(BodyState(asset_id=name) for name in ("ada", "tom"))
    return SpatialPlannerView(
        1,
        SceneSetup(place=kit.upper()),
        measures,
        plan,
        dressing.objects,
        states=states,
        groups=(("ada", "tom"),),
        props=props_of(dressing.assets),
    )


def test_a_full_place_and_a_large_one_hold_more_people() -> None:
    sizes = [crowd_size(crowd, area) for crowd, area in ((None, 120), ("busy", 60), ("full", 60), ("full", 120))]
    assert sizes[0] == 0 < 12 <= sizes[1] < sizes[2] < sizes[3] <= 40


@pytest.mark.parametrize("kit", ["cafe", "bar", "square", "street", "lobby", "park"])
def test_a_crowd_finds_room_and_leaves_the_story_its_own(kit: str) -> None:
    scene = view_of(kit)
    layout = RulesSpatialPlanner().propose(scene)
    people = [item.location for item in layout.objects if item.asset_id in ("ada", "tom")]
    lanes = free_floor_of(scene, layout)
    found = place_bystanders(scene, layout, 14, lanes)
    assert len(found) >= 8
    for each in found:
        x, y, _ = each.location
        assert min(math.dist((x, y), person[:2]) for person in people) >= 1.4
        assert not any(abs(x - px) < 0.8 and y < py - 0.5 for px, py, _ in people)
    standing = [Box(*each.location, 0.4, 0.3, 1.7, each.yaw) for each in found if each.posture == "stand"]
    for index, own in enumerate(standing):
        assert all(penetration(own, other)[0] <= 0.03 for other in (*standing[:index], *lanes))


def test_nobody_is_put_where_there_is_no_room() -> None:
    scene = view_of("elevator")
    assert len(place_bystanders(scene, RulesSpatialPlanner().propose(scene), 20, [])) < 6


def test_figures_are_few_and_their_copies_many() -> None:
    scene = view_of("cafe")
    layout = RulesSpatialPlanner().propose(scene)
    found = place_bystanders(scene, layout, 20, [])
    assets = [dressing_asset("background_figure", {"posture": each.posture, "variant": each.variant}) for each in found]
    objects = bystander_objects(found, assets, measures_of(assets))
    assert len({asset.asset_id for asset in assets}) <= 12 < len(objects)
    assert all(item.node_id.startswith(BYSTANDER) and item.fixed for item in objects)
    assert any(item.anchor_asset_id for item in objects)
