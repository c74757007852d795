"""Dressing that a set got beyond its plan is not in the way of the scene that is laid out in it."""

from __future__ import annotations

import pytest

from storyblender.agents.layout_artist.cleared_action import clear_action
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.catalog.props import PROPS
from storyblender.catalog.sets import plan_of
from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec2
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, Layout, LayoutObject, SceneSetup, SceneSize
from storyblender.memory.shot_context import BodyState

PLAN = plan_of(Environment(kit="parking_lot")).model_copy(update={"furnishings": ()})


def measure(asset_id: str, key: str) -> AssetMeasure:
    person = key == "person"
    size = (0.5, 0.3, 1.7) if person else PROPS[key].size
    top = () if person else (Anchor(kind="top", location=(0, 0, size[2]), size=size[:2]),)
    sort = "character" if person else "object"
    return AssetMeasure(
        asset_id=asset_id, digest="", geometry_hash="", dimensions=size, anchors=top, asset_type=sort
    )  # fmt: skip


@pytest.mark.parametrize(
    ("fence", "stays"),
    [((0.0, 0.0), False), ((2.0, -3.0), False), ((-6.0, 3.0), True), ((0.0, 3.5), True)],
    ids=["between two who talk", "between one of them and the car", "aside", "behind them"],
)
def test_what_was_added_is_not_across_the_action(fence: Vec2, stays: bool) -> None:
    places = {"ann": (-2.0, 0.0), "tom": (2.0, 0.0), "rover": (2.0, -5.5), "set_fence": fence}
    kinds = {"ann": "person", "tom": "person", "rover": "car", "set_fence": "fence_panel"}
    objects = tuple(
        LayoutObject(
            node_id="set_added_fence_panel_1" if name == "set_fence" else name, asset_id=name, location=(*place, 0.0)
        )
        for name, place in places.items()
    )
    view = SpatialPlannerView(
        scene_id=1,
        setup=SceneSetup(asset_ids=("ann", "tom", "rover")),
        measures={name: measure(name, key) for name, key in kinds.items()},
        plan=PLAN,
        groups=(("ann", "tom"),),
        states=(BodyState(asset_id="ann"), BodyState(asset_id="tom", looking_at="rover")),
    )
    size = SceneSize(x=8, x_negative=-8, y=8, y_negative=-8)
    found = clear_action(view, Layout(scene_size=size, objects=objects))
    assert {item.asset_id for item in found.objects} == ({*places} if stays else {*places} - {"set_fence"})
