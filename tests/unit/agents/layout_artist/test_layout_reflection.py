"""Layouts with errors put into them, mended by the critic's numbers."""

from __future__ import annotations

import math

from benchmarks.corrupted_layouts import corrupted_layouts, free_things, put, worded
from benchmarks.layout_reflection import ERRORS, TURNS, Naive, errors_by_turn, physical
from benchmarks.staged_scenes import StagedScene
from tests.every import every
from tests.unit.agents.layout_artist.test_spatial_planner import MEASURES, view_of

from storyblender.agents.layout_artist.layout_things import layout_violations
from storyblender.agents.layout_artist.spatial_planner import RulesSpatialPlanner, SpatialPlannerCritic
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.memory.scene_context import Layout
from storyblender.memory.shot_context import BodyState

TALK = view_of(
    ["table", "wardrobe", "suitcase", "jewel_box"], [("jewel_box", "on", "table")], ["ana", "ben", "cal"],
    groups=(("ana", "ben", "cal"),),
)  # fmt: skip
SEATED = view_of(["piano", "bar", "dresser"], [], [BodyState(asset_id="ana", posture="sit", support_id="piano"), "ben"])


def staged(view: SpatialPlannerView) -> StagedScene:
    return StagedScene("scene", view, RulesSpatialPlanner().propose(view))


def faults_of(layout: Layout, view: SpatialPlannerView) -> list[tuple[str, str]]:
    return [(fault.kind, fault.subject) for fault in SpatialPlannerCritic().judge(layout, view).faults]


@every("broken", lambda: corrupted_layouts([staged(TALK), staged(SEATED)], 24))
def test_one_turn_of_the_critics_numbers_leaves_no_error(broken) -> None:
    first, second, *later = errors_by_turn(broken, physical)
    assert first.total()
    assert not any(turn[error] for turn in (second, *later) for error in ERRORS), second


def test_words_without_numbers_leave_errors() -> None:
    broken = corrupted_layouts([staged(TALK), staged(SEATED)], 12)
    last = [errors_by_turn(each, Naive(each.seed))[TURNS - 1] for each in broken]
    assert sum(each.total() for each in last) > 0


@every("view", [TALK, SEATED])
def test_a_layout_in_the_papers_words_is_as_valid_as_before(view) -> None:
    scene = staged(view)
    said = worded(scene.layout, view)
    assert layout_violations(said, MEASURES, view.plan) == ()
    assert all(item.anchor_asset_id for item in free_things(said, view))


def test_who_slides_off_their_seat_is_brought_back() -> None:
    layout = staged(SEATED).layout
    sitter = next(item for item in layout.objects if item.asset_id == "ana")
    x, y, z = sitter.location
    for moved in ((x + 1.0, y, z), (x, y, z + 0.4)):
        off = put(layout, "ana", moved)
        assert ("contact", "ana") in faults_of(off, SEATED)
        mended = RulesSpatialPlanner().refine(off, SpatialPlannerCritic().judge(off, SEATED), SEATED)
        assert faults_of(mended, SEATED) == []
        again = next(item for item in mended.objects if item.asset_id == "ana")
        assert math.dist(again.location, sitter.location) < 0.1
    turned = put(layout, "ana", sitter.location, sitter.rotation[2] + 180)
    assert ("direction", "ana") in faults_of(turned, SEATED)


def test_a_thing_in_the_air_by_a_wall_hangs_only_if_its_kind_hangs() -> None:
    view = view_of(["wardrobe"])
    layout = RulesSpatialPlanner().propose(view)
    item = layout.objects[0]
    lifted = put(layout, item.node_id, (0.0, view.plan.size.y - 0.35, 0.8), 0.0)
    known = SpatialPlannerView(**{**view.__dict__, "placements": {"wardrobe": "floor"}})
    assert faults_of(lifted, view) == []
    assert faults_of(lifted, known) == [("floor", item.node_id)]
