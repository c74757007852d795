import itertools
import math
from dataclasses import replace

from tests.crew import RULES

from storyblender.agents.layout_artist.crowd_places import crowds_of
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.catalog.sets import plan_of
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, LayoutObject, SceneSetup
from storyblender.memory.shot_context import BodyState
from storyblender.reflection import reflect

GUESTS = [f"guest_{number}" for number in range(1, 21)]


def _laid_out() -> dict[str, LayoutObject]:
    people = ["ana", "ben", *GUESTS]
    measures = {
        name: AssetMeasure(
            asset_id=name, digest="", geometry_hash="", dimensions=(1.1, 0.35, 1.75), asset_type="character"
        )
        for name in people
    }
    plan = plan_of(Environment(kit="great_hall", params={"width": 14.0, "depth": 14.0}))
    view = SpatialPlannerView(
        1,
        SceneSetup(asset_ids=tuple(people)),
        measures,
        plan.model_copy(update={"furnishings": ()}),
        states=tuple(BodyState(asset_id=name) for name in people),
        groups=(("ana", "ben"),),
    )
    outcome = reflect(replace(RULES.spatial_planner, threshold=9.9, horizon=3), "SC010", view)
    assert outcome.critique.faults == ()
    return {item.node_id: item for item in outcome.draft.objects}


def test_a_crowd_is_a_group_of_many() -> None:
    assert crowds_of(["ana", "guard_1", "guard_2", *GUESTS]) == [GUESTS]


def test_a_crowd_of_twenty_leaves_the_principals_to_be_seen() -> None:
    at = _laid_out()
    assert all(guest in at for guest in GUESTS)
    for guest, principal in itertools.product(GUESTS, ("ana", "ben")):
        (x, y, _), (px, py, _) = at[guest].location, at[principal].location
        assert math.dist((x, y), (px, py)) > 1.2, f"{guest} crowds {principal}"
        assert not (abs(x - px) < 0.6 and py - 4 < y < py), f"{guest} stands before {principal}"


def test_nobody_of_a_crowd_is_in_another() -> None:
    at = _laid_out()
    for one, other in itertools.combinations(GUESTS, 2):
        assert math.dist(at[one].location[:2], at[other].location[:2]) > 0.35


def test_a_crowd_does_not_stand_in_rows() -> None:
    at = _laid_out()
    assert len({round(at[guest].rotation[2] / 20) for guest in GUESTS}) > 4
