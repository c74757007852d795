"""A layout that cannot be solved gets room, a step at a time."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from itertools import pairwise

import pytest
from tests.crew import RULES

from storyblender.agents.layout_artist.room_steps import (
    ROOM_STEPS,
    FittedScene,
    RoomStep,
    drop_dressing,
    enlarge_set,
    find_fitting_room,
)
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView, measures_of
from storyblender.agents.visual_effects_artist.set_dresser import RulesSetDresser, SetDresserView
from storyblender.catalog.sets import SETS, plan_of
from storyblender.memory.base import Vec2
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Environment, Layout, LayoutObject, SceneSetup, SceneSize
from storyblender.memory.shot_context import BodyState
from storyblender.reflection import Critique, Fault, Outcome, reflect

EMPTY = Layout(scene_size=SceneSize(x=2, x_negative=-2, y=2, y_negative=-2))


VIEW = SpatialPlannerView(1, SceneSetup(), {}, plan_of(Environment(kit="closet")))


def outcome(score: float) -> Outcome[SpatialPlannerView, Layout]:
    fault = Fault(kind="penetration", subject="sofa", message="in the wall", severity=10 - score)
    item = LayoutObject(node_id="sofa", asset_id="sofa", location=(1.0, 0.5, 0.0))
    draft = EMPTY.model_copy(update={"objects": (item,)})
    return Outcome(VIEW, draft, Critique(score=score, faults=(fault,) if score < 10 else ()), 0, False)


def tried(scores: list[float]) -> tuple[FittedScene[int], list[Collection[Vec2]]]:
    told: list[Collection[Vec2]] = []

    def stage(room: RoomStep, faulty: Collection[Vec2]) -> tuple[int, Outcome[SpatialPlannerView, Layout]]:
        told.append(faulty)
        return len(told), outcome(scores[len(told) - 1])

    return find_fitting_room(stage, ROOM_STEPS[: len(scores)]), told


def test_a_layout_that_is_solved_is_tried_once() -> None:
    fitted, told = tried([10, 10])
    assert fitted.tried == 1 and len(told) == 1 and fitted.room == RoomStep()


def test_the_loop_ends_with_the_first_step_that_solves_it_and_knows_where_it_was_wrong() -> None:
    fitted, told = tried([4, 7, 9, 10])
    assert fitted.tried == 3 and len(told) == 3
    assert [list(each) for each in told] == [[], [(1.0, 0.5)], [(1.0, 0.5)]]


def test_where_nothing_solves_it_the_best_stays() -> None:
    assert tried([4, 7, 5, 6])[0].tried == 2
    assert len(tried([7, 7, 7, 10])[1]) == 3  # more room is not what it lacks


def test_each_step_gives_at_least_as_much_room_as_the_one_before() -> None:
    for before, after in pairwise(ROOM_STEPS):
        assert (after.set_scale, after.clear_radius, after.distance_scale) > (
            before.set_scale,
            before.clear_radius,
            before.distance_scale,
        )
        assert (
            after.set_scale >= before.set_scale
            and after.clear_radius >= before.clear_radius
            and after.distance_scale >= before.distance_scale
        )


@pytest.mark.parametrize("kit", ["kitchen", "closet", "street"])
def test_a_set_grows_to_what_its_kit_can_be(kit: str) -> None:
    usual = Environment(kit=kit)
    assert enlarge_set(usual, 1.0) is usual
    sizes = [plan_of(enlarge_set(usual, set_scale)).size.x for set_scale in (1.0, 1.2, 1.8, 50.0)]
    assert sizes == sorted(sizes) and sizes[0] < sizes[-1] <= SETS[kit].width.most / 2 + 0.01


def test_only_dressing_gives_way_and_nothing_is_left_in_the_air() -> None:
    plan = plan_of(Environment(kit="kitchen", seed=3))
    objects = RulesSetDresser().propose(SetDresserView(SceneSetup(place="KITCHEN"), plan)).objects
    kept = drop_dressing(objects, plan, [(0.0, 0.0)], 99.0)
    assert {item.node_id for item in kept} == {item.node_id for item in plan.furnishings if item.required}
    assert drop_dressing(objects, plan, [], 99.0) == objects


def test_a_company_too_many_for_a_small_room_finds_place_in_a_larger_one() -> None:
    people = [f"guest {number}".replace(" ", "") for number in "abcdef"]
    known = {
        name: AssetMeasure(
            asset_id=name, digest="", geometry_hash="", dimensions=(0.5, 0.4, 1.7), asset_type="character"
        )
        for name in people
    }
    known |= {
        name: AssetMeasure(asset_id=name, digest="", geometry_hash="", dimensions=(1.4, 0.9, 1.2))
        for name in ("trunk", "stove")
    }
    states = tuple(BodyState(asset_id=name) for name in people)

    def stage(room: RoomStep, faulty: Collection[Vec2]) -> tuple[float, Outcome[SpatialPlannerView, Layout]]:
        plan = plan_of(enlarge_set(Environment(kit="closet", seed=1), room.set_scale))
        dressing = RulesSetDresser().propose(SetDresserView(SceneSetup(place="CLOSET"), plan, people=6))
        standing = drop_dressing(dressing.objects, plan, faulty, room.clear_radius)
        view = SpatialPlannerView(
            1, SceneSetup(place="CLOSET"), measures_of(dressing.assets) | known, plan, standing,
            pending=("trunk", "stove"), states=states, distance_scale=room.distance_scale,
        )  # fmt: skip
        return plan.size.x, reflect(replace(RULES.spatial_planner, horizon=1), "SC010", view)

    first = stage(ROOM_STEPS[0], [])
    fitted = find_fitting_room(stage)
    assert first[1].critique.score < 8 <= fitted.outcome.critique.score
    assert fitted.tried > first[0]
    assert not [fault for fault in fitted.outcome.critique.faults if fault.kind == "penetration"]
