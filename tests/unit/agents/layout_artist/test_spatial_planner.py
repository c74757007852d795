import itertools
import math
from dataclasses import replace

import pytest
from tests.crew import RULES
from tests.every import every

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import layout_violations
from storyblender.agents.layout_artist.spatial_planner import RulesSpatialPlanner, SpatialPlannerCritic
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView, spatial_planner_view
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import SETS, plan_of
from storyblender.memory.asset_sheet import Anchor, Asset
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import (
    Environment,
    Layout,
    LayoutObject,
    Relation,
    SceneContext,
    SceneSetup,
    Spot,
)
from storyblender.memory.shot_context import BodyState, CameraInstruction, CharacterAction, ShotContext
from storyblender.reflection import Outcome, reflect

SEAT = Anchor(kind="seat", location=(0, -0.24, 0.46), size=(0.46, 0.45))
DESK = Anchor(kind="top", location=(0, -0.05, 0.76), size=(1.2, 0.4))
EDGE = Anchor(kind="top", location=(0, 0.22, 1.65), size=(0.8, 0.04))
STOOL = Anchor(kind="seat", location=(0, -0.27, 0.49), direction=(0, 1, 0), size=(0.58, 0.34))
BENCH = tuple(
    Anchor(kind="seat", name=f"seat_{x}", location=(x, -0.21, 0.46), size=(0.5, 0.42)) for x in (-0.5, 0.0, 0.5)
)


def measure(asset_id: str, *size: float, anchors=(), person: bool = False) -> AssetMeasure:
    kind = "character" if person else "object"
    return AssetMeasure(
        asset_id=asset_id,
        digest="",
        geometry_hash="",
        dimensions=(size[0], size[1], size[2]),
        anchors=anchors,
        asset_type=kind,
    )


MEASURES = {
    each.asset_id: each
    for each in (
        *(measure(name, 1.1, 0.35, 1.75, person=True) for name in ("ana", "ben", "cal", "dee")),
        measure("chair", 0.46, 0.52, 0.92, anchors=(SEAT,)),
        measure("table", 1.4, 0.8, 0.75, anchors=(Anchor(kind="top", location=(0, 0, 0.75), size=(1.4, 0.8)),)),
        measure("dresser", 1.2, 0.5, 1.65, anchors=(EDGE, DESK)),
        measure("jewel_box", 0.2, 0.14, 0.1),
        measure("painting", 0.8, 0.05, 0.6),
        measure("cat", 0.2, 0.45, 0.3),
        measure("wardrobe", 1.2, 0.6, 2.0),
        measure("bar", 2.4, 0.6, 1.1),
        measure("bin", 0.5, 0.5, 0.8, anchors=(Anchor(kind="top", location=(0, 0, 0.77), size=(0.3, 0.15)),)),
        measure("stick", 0.1, 0.03, 0.9),
        measure("piano", 1.5, 1.26, 1.26, anchors=(STOOL,)),
        measure("suitcase", 0.68, 0.22, 0.5),
        measure("bench", 1.5, 0.42, 0.46, anchors=BENCH),
    )
}


def plan(kit: str = "plain_room") -> SetPlan:
    bare = plan_of(Environment(kit=kit if kit in SETS else next(iter(SETS))))
    return bare.model_copy(update={"furnishings": ()})


def view_of(pending=(), relations=(), people=(), **more) -> SpatialPlannerView:
    states = tuple(who if isinstance(who, BodyState) else BodyState(asset_id=who) for who in people)
    related = tuple(Relation(asset_id=a, kind=kind, anchor_asset_id=b) for a, kind, b in relations)
    ids = (*pending, *(state.asset_id for state in states))
    return SpatialPlannerView(
        1, SceneSetup(asset_ids=ids, relations=related), MEASURES, plan(), pending=tuple(pending), states=states, **more
    )


def plan_layout(view: SpatialPlannerView) -> Outcome[SpatialPlannerView, Layout]:
    return reflect(replace(RULES.spatial_planner, threshold=9.9, horizon=3), "SC010", view)


def solved(view: SpatialPlannerView) -> dict[str, LayoutObject]:
    outcome = plan_layout(view)
    assert outcome.critique.faults == ()
    return {item.node_id: item for item in outcome.draft.objects}


def forward(item: LayoutObject) -> tuple[float, float]:
    yaw = math.radians(item.rotation[2])
    return math.sin(yaw), -math.cos(yaw)


@every("kit", SETS)
def test_every_set_takes_people_and_things_without_a_fault(kit: str) -> None:
    view = view_of(["table", "jewel_box", "painting"], [("jewel_box", "on", "table")], ["ana", "ben", "cal"])
    view = SpatialPlannerView(**{**view.__dict__, "plan": plan(kit), "groups": (("ana", "ben"),)})
    assert plan_layout(view).critique.faults == ()


def test_who_bears_the_name_of_a_trade_begins_at_its_mark() -> None:
    measures = MEASURES | {"judge_okoro": measure("judge_okoro", 1.1, 0.35, 1.75, person=True)}
    view = view_of(people=["judge_okoro", "ana"])
    at = solved(SpatialPlannerView(**{**view.__dict__, "plan": plan("courtroom"), "measures": measures}))
    bench = next(mark for mark in plan("courtroom").marks if "judge" in mark.tags)
    assert math.dist(at["judge_okoro"].location, bench.location) < 0.3
    assert math.dist(at["ana"].location, bench.location) > 0.5


def test_two_who_talk_face_each_other_at_talking_distance_open_to_the_audience() -> None:
    at = solved(view_of(people=["ana", "ben"]))
    ana, ben = at["ana"], at["ben"]
    apart = math.dist(ana.location, ben.location)
    assert 1.0 <= apart <= 1.4
    assert abs(ana.location[0] - ben.location[0]) > 0.8, "side by side for the audience"
    way = [(b - a) / apart for a, b in zip(ana.location, ben.location, strict=True)]
    assert forward(ana)[0] * way[0] + forward(ana)[1] * way[1] > math.cos(math.radians(45))
    assert forward(ana)[1] < -0.1 and forward(ben)[1] < -0.1, "cheated towards the audience"


def test_a_group_is_open_to_the_audience_and_nobody_hides_another() -> None:
    at = solved(view_of(people=["ana", "ben", "cal"], groups=(("ana", "ben"), ("ben", "cal"))))
    xs = sorted(at[name].location[0] for name in ("ana", "ben", "cal"))
    assert all(right - left > 0.35 for left, right in itertools.pairwise(xs))


def test_the_jewel_box_is_on_the_desk_not_on_the_mirror() -> None:
    at = solved(view_of(["dresser", "jewel_box"], [("jewel_box", "on", "dresser")]))
    assert at["jewel_box"].location[2] == pytest.approx(0.76)
    assert at["jewel_box"].relationship == "on_top_of"


def test_whoever_sits_is_at_the_seats_front_edge_with_its_yaw() -> None:
    at = solved(view_of(["chair"], people=[BodyState(asset_id="ana", posture="sit", support_id="chair"), "ben"]))
    chair, ana = at["chair"], at["ana"]
    assert ana.anchor_asset_id == "chair"
    assert ana.location[2] == pytest.approx(0.46)
    assert math.dist(ana.location[:2], chair.location[:2]) == pytest.approx(0.24, abs=0.01)
    assert ana.rotation[2] == pytest.approx(chair.rotation[2], abs=0.2)


def test_relations_decide_sides() -> None:
    at = solved(view_of(["table", "cat", "wardrobe"], [("cat", "under", "table"), ("wardrobe", "left_of", "table")]))
    assert math.dist(at["cat"].location[:2], at["table"].location[:2]) < 0.3
    assert at["cat"].location[2] == 0
    assert at["wardrobe"].location[0] < at["table"].location[0]


def test_what_has_no_room_beside_a_thing_stands_elsewhere() -> None:
    by_the_wall = LayoutObject(
        node_id="wardrobe", asset_id="wardrobe", location=(plan().size.x - 0.7, 0, 0), fixed=True
    )
    view = view_of(["boat"], [("boat", "right_of", "wardrobe")], dressed=(by_the_wall,))
    view = replace(view, measures={**MEASURES, "boat": measure("boat", 2.5, 1.0, 0.8)})
    outcome = plan_layout(view)
    assert outcome.critique.faults == ()
    boat = next(item for item in outcome.draft.objects if item.asset_id == "boat")
    assert boat.anchor_asset_id is None


def test_behind_the_bar_is_at_its_own_back() -> None:
    counter = LayoutObject(node_id="bar", asset_id="bar", location=(-1.2, 0, 0), rotation=(0, 0, 90), fixed=True)
    at = solved(view_of(dressed=(counter,), relations=[("ana", "behind", "bar")], people=["ana", "ben"]))
    assert at["ana"].location[0] < -1.5
    assert at["bar"] == counter


def test_a_picture_hangs_on_a_wall_facing_the_room() -> None:
    view = view_of(["painting"], placements={"painting": "wall"})
    painting, size = solved(view)["painting"], view.plan.size
    x, y, z = painting.location
    assert z > 0.9
    assert min(abs(x - size.x), abs(x - size.x_negative), abs(y - size.y), abs(y - size.y_negative)) < 0.1
    assert forward(painting)[0] * x + forward(painting)[1] * y < 0


def test_what_is_held_or_dressed_is_not_placed_again() -> None:
    table = LayoutObject(node_id="set_table", asset_id="table", location=(0, 1, 0), fixed=True)
    layout = plan_layout(view_of(dressed=(table,), people=["ana"])).draft
    assert [item.node_id for item in layout.objects] == ["set_table", "ana"]


def test_an_earlier_scenes_furniture_stays_where_it_was() -> None:
    first = plan_layout(view_of(["table", "wardrobe"], people=["ana", "ben"])).draft
    again = solved(view_of(["table", "wardrobe"], people=["ana", "cal"], reference=first))
    for item in first.objects:
        if item.asset_id in ("table", "wardrobe"):
            assert again[item.node_id].location == pytest.approx(item.location, abs=1e-3)


def test_what_lay_on_a_table_that_is_gone_is_laid_anew() -> None:
    first = plan_layout(view_of(["table", "jewel_box"], people=["ana"])).draft
    on_table = [
        item.model_copy(update={"anchor_asset_id": "table"}) if item.asset_id == "jewel_box" else item
        for item in first.objects
    ]
    first = first.model_copy(update={"objects": tuple(on_table)})
    again = solved(view_of(["jewel_box"], people=["ana"], reference=first))
    assert again["jewel_box"].anchor_asset_id != "table"
    assert {item.anchor_asset_id for item in again.values()} <= {None, *again}


def test_the_same_brief_gives_the_same_layout() -> None:
    view = view_of(["table", "jewel_box", "wardrobe"], people=["ana", "ben", "cal"], groups=(("ana", "cal"),))
    assert plan_layout(view).draft == plan_layout(view).draft


def test_every_fault_is_found_and_refine_mends_it() -> None:
    view = view_of(["table", "wardrobe"], people=["ana"])
    good = RulesSpatialPlanner().propose(view)
    items = {item.node_id: item for item in good.objects}
    x, y, _ = items["table"].location
    items["wardrobe"] = items["wardrobe"].model_copy(update={"location": (x + 0.2, y, 0.4)})
    broken = Layout(scene_size=good.scene_size, objects=tuple(items.values()))
    faults = layout_violations(broken, MEASURES, view.plan)
    assert {"penetration", "floor"} <= {fault.kind for fault in faults}
    assert all(fault.fix for fault in faults)
    critic = SpatialPlannerCritic()
    mended = RulesSpatialPlanner().refine(broken, critic.judge(broken, view), view)
    assert critic.judge(mended, view).faults == ()


def test_whoever_has_no_place_is_named() -> None:
    view = view_of(people=["ana"])
    empty = Layout(scene_size=view.plan.size)
    assert [(fault.kind, fault.subject) for fault in SpatialPlannerCritic().judge(empty, view).faults] == [
        ("missing", "ana")
    ]


def test_luggage_stands_on_the_floor_beside_who_takes_it() -> None:
    view = view_of(["table", "suitcase"], people=["ana", "ben"], handlers={"suitcase": ("cal", "ana")})
    at = solved(SpatialPlannerView(**{**view.__dict__, "placements": {"suitcase": "surface"}}))
    assert at["suitcase"].location[2] == 0
    assert math.dist(at["suitcase"].location, at["ana"].location) < 1.2
    alone = view_of(["table", "suitcase"], people=["ana"], handlers={"suitcase": ("cal",)})
    at = solved(SpatialPlannerView(**{**alone.__dict__, "placements": {"suitcase": "surface"}}))
    assert at["suitcase"].location[2] == 0, "nor on a table when its owner is still to come"


def test_what_somebody_takes_lies_within_their_reach() -> None:
    tables = tuple(
        LayoutObject(node_id=f"table_{index}", asset_id="table", location=(x, 1.6, 0), fixed=True)
        for index, x in enumerate((-1.6, 1.6))
    )
    for x, near in ((-1.6, "table_0"), (1.6, "table_1")):
        chair = LayoutObject(node_id="chair", asset_id="chair", location=(x, 0.7, 0), rotation=(0, 0, 180), fixed=True)
        sitter = BodyState(asset_id="ana", posture="sit", support_id="chair")
        view = view_of(["jewel_box"], people=[sitter], dressed=(*tables, chair), handlers={"jewel_box": ("ana",)})
        at = solved(SpatialPlannerView(**{**view.__dict__, "placements": {"jewel_box": "surface"}}))
        assert at["jewel_box"].anchor_asset_id == near
        assert math.dist(at["jewel_box"].location[:2], at["ana"].location[:2]) < 0.7


def test_a_thing_on_a_bench_leaves_seats_next_to_each_other() -> None:
    bench = LayoutObject(node_id="bench", asset_id="bench", location=(0, 1.5, 0), fixed=True)
    sitters = [BodyState(asset_id=name, posture="sit", support_id="bench") for name in ("ana", "ben")]
    at = solved(view_of(["jewel_box"], [("jewel_box", "on", "bench")], sitters, dressed=(bench,)))
    ana, ben, box = (at[name].location for name in ("ana", "ben", "jewel_box"))
    assert math.dist(ana, ben) == pytest.approx(0.5, abs=0.02)
    assert min(math.dist(box[:2], ana[:2]), math.dist(box[:2], ben[:2])) > 0.4


def test_who_stands_with_somebody_stands_at_their_shoulder() -> None:
    relations = [("ana", "at", "bar"), ("ben", "next_to", "ana"), ("cal", "next_to", "ana")]
    counter = LayoutObject(node_id="bar", asset_id="bar", location=(-1.2, 1.5, 0), rotation=(0, 0, 90), fixed=True)
    at = solved(view_of(dressed=(counter,), relations=relations, people=["ana", "ben", "cal", "dee"]))
    for name in ("ben", "cal"):
        assert math.dist(at[name].location, at["ana"].location) < 1.3


def test_two_at_a_bar_stand_side_by_side_before_it() -> None:
    counter = LayoutObject(node_id="bar", asset_id="bar", location=(0, 1.6, 0), fixed=True)
    at = solved(
        view_of(dressed=(counter,), relations=[("ana", "at", "bar"), ("ben", "at", "bar")], people=["ana", "ben"])
    )
    assert all(at[name].location[1] < 1.3 for name in ("ana", "ben"))
    assert math.dist(at["ana"].location, at["ben"].location) == pytest.approx(0.8, abs=0.15)


def test_who_leans_on_a_stick_by_the_table_is_by_the_table() -> None:
    leaning = BodyState(asset_id="ana", posture="lean", support_id="stick")
    table = LayoutObject(node_id="table", asset_id="table", location=(-1.6, 1.2, 0), fixed=True)
    view = view_of(["stick"], [("ana", "next_to", "table")], [leaning, "ben"], dressed=(table,))
    at = solved(SpatialPlannerView(**{**view.__dict__, "placements": {"stick": "surface"}}))
    assert at["ana"].anchor_asset_id == "table"


def test_who_is_by_a_thing_outside_the_playing_area_stands_at_its_edge_with_their_company() -> None:
    ship = LayoutObject(node_id="ship", asset_id="ship", location=(1.0, 5.5, 0), rotation=(0, 0, 95), fixed=True)
    view = view_of((), [("ana", "next_to", "ship")], ["ana", "ben"], dressed=(ship,), companions={"ben": "ana"})
    at = solved(replace(view, measures={**MEASURES, "ship": measure("ship", 4.0, 9.0, 5.0)}))
    assert at["ana"].location[1] > 1.0 and abs(at["ana"].location[0] - 1.0) < 2.5
    assert math.dist(at["ana"].location, at["ben"].location) < 1.3


def test_who_is_at_a_part_of_the_set_stands_there() -> None:
    at = solved(view_of((), [("ana", "at", "window"), ("ben", "at", "corner")], ["ana", "ben"]))
    assert {"ana", "ben"} <= at.keys()


def test_companions_of_the_first_actions_stand_together() -> None:
    people = [
        Asset(asset_id=each, asset_type="character", description="", name=each.title())
        for each in ("ana", "ben", "cal")
    ]
    action = CharacterAction(asset_id="ana", action_description="stands", motion="idle", company=("ben",))
    camera = CameraInstruction(focus_on_ids=("ana",))
    shot = ShotContext(
        scene_id=1, shot_id=1, on_stage=("ana", "ben", "cal"), character_actions=(action,), camera_instruction=camera
    )
    graph = ContinuityMemoryGraph(
        assets=tuple(people), scenes=(SceneContext(scene_id=1, setup=SceneSetup()),), shots=(shot,)
    )
    assert spatial_planner_view(graph, 1, plan()).companions == {"ben": "ana"}


def test_the_lid_of_a_bin_is_no_table() -> None:
    bin_ = LayoutObject(node_id="bin", asset_id="bin", location=(0.9, 1.6, 0), fixed=True)
    view = view_of(["jewel_box"], people=["ana"], dressed=(bin_,))
    assert (
        solved(SpatialPlannerView(**{**view.__dict__, "placements": {"jewel_box": "surface"}}))["jewel_box"].location[2]
        == 0
    )


def test_who_finds_a_bench_full_takes_the_nearest_other_seat() -> None:
    bench = LayoutObject(node_id="bench", asset_id="bench", location=(0, 1.5, 0), fixed=True)
    chairs = tuple(
        LayoutObject(node_id=f"chair_{index}", asset_id="chair", location=(x, 1.5, 0), fixed=True)
        for index, x in enumerate((-2, 1.4))
    )
    sitters = [BodyState(asset_id=name, posture="sit", support_id="bench") for name in ("ana", "ben", "cal", "dee")]
    at = solved(view_of(people=sitters, dressed=(*chairs, bench)))
    assert [at[name].anchor_asset_id for name in ("ana", "ben", "cal", "dee")] == ["bench"] * 3 + ["chair_1"]


def test_who_does_not_play_the_piano_stands_at_its_end_and_not_behind_its_stool() -> None:
    at = solved(view_of(["piano"], [("ana", "at", "piano")], ["ana"]))
    x, y = (a - b for a, b in zip(at["ana"].location[:2], at["piano"].location[:2], strict=True))
    ahead = forward(at["piano"])
    across = abs(x * ahead[1] - y * ahead[0])
    assert across > 0.75 + 0.2, "beside it, within reach of the lid"


def test_who_sits_opposite_somebody_takes_the_seat_they_look_at() -> None:
    facing_each_other = (
        LayoutObject(node_id="bench_1", asset_id="bench", location=(-0.9, 0, 0), rotation=(0, 0, 90), fixed=True),
        LayoutObject(node_id="bench_2", asset_id="bench", location=(0.9, 0, 0), rotation=(0, 0, -90), fixed=True),
    )
    people = [BodyState(asset_id="ben", posture="sit"), BodyState(asset_id="ana", posture="sit")]
    at = solved(view_of(relations=[("ben", "facing", "ana")], people=people, dressed=facing_each_other))
    assert {at["ana"].anchor_asset_id, at["ben"].anchor_asset_id} == {"bench_1", "bench_2"}


def court(**fields: object) -> SpatialPlannerView:
    people = {
        name: measure(name, 1.1, 0.35, 1.75, person=True) for name in ("judge_ito", "juror_1", "juror_2", "bo", "eve")
    }
    chair = measure("set_chair", 0.46, 0.52, 0.92, anchors=(SEAT,))
    pew = measure("set_pew", 1.8, 0.58, 0.94, anchors=BENCH)
    seats = {"chair": chair, "pew": pew, "armchair": chair}
    court = plan_of(Environment(kit="courtroom"))
    dressed = tuple(
        LayoutObject(
            node_id=item.node_id,
            asset_id=seats[item.prop].asset_id,
            location=item.location,
            rotation=(0, 0, item.yaw),
            fixed=True,
        )
        for item in court.furnishings
        if item.prop in seats
    )
    measures = people | {"set_chair": chair, "set_pew": pew}
    setup = SceneSetup(scene_type="indoor", place="courtroom", asset_ids=tuple(people))
    return SpatialPlannerView(scene_id=1, setup=setup, measures=measures, plan=court, dressed=dressed, **fields)  # type: ignore[arg-type]


def test_whom_a_later_shot_finds_in_court_is_at_the_place_of_their_office() -> None:
    layout = RulesSpatialPlanner().propose(
        court(
            states=(BodyState(asset_id="judge_ito", support_id="bench", posture="sit"),),
            found_later=(
                BodyState(asset_id="juror_1", support_id="jury_box", posture="sit"),
                BodyState(asset_id="juror_2", support_id="jury_box", posture="sit"),
                BodyState(asset_id="bo", posture="stand"),
                BodyState(asset_id="eve", support_id="bench", posture="sit"),
            ),
            resting_places={"bo": "dock"},
        )
    )
    at = {item.asset_id: item.location for item in layout.objects}
    marks = {mark.name: mark.location for mark in plan_of(Environment(kit="courtroom")).marks}
    assert at["judge_ito"][1] > marks["judges_bench"][1]
    assert at["juror_1"] != at["juror_2"]
    assert min(at["juror_1"][0], at["juror_2"][0]) > marks["jury"][0]
    assert math.dist(at["bo"], marks["dock"]) < 0.3
    assert at["eve"][1] < marks["gallery"][1]


def test_who_comes_in_later_has_no_place_yet_and_who_is_found_there_has() -> None:
    def shot(number: int, stage: tuple[str, ...], *actions: CharacterAction) -> ShotContext:
        return ShotContext(
            scene_id=1,
            shot_id=number,
            on_stage=stage,
            states=tuple(BodyState(asset_id=each) for each in stage),
            character_actions=actions,
            camera_instruction=CameraInstruction(),
        )

    walk = CharacterAction(asset_id="cal", action_description="Cal runs in.", motion="run")
    waits = CharacterAction(
        asset_id="ben", action_description="Ben waits at the door.", motion="idle", target_id="door"
    )
    graph = ContinuityMemoryGraph(
        scenes=(SceneContext(scene_id=1, setup=SceneSetup(scene_type="indoor", asset_ids=("ana", "ben", "cal"))),),
        shots=(shot(1, ("ana",)), shot(2, ("ana", "ben"), waits), shot(3, ("ana", "ben", "cal"), walk)),
    )
    view = spatial_planner_view(graph, 1, plan())
    assert [state.asset_id for state in view.found_later] == ["ben"]
    assert view.resting_places == {"ben": "door"}


def test_nobody_stands_between_a_thing_and_the_wall_it_stands_against() -> None:
    room = plan()
    back = LayoutObject(node_id="bar", asset_id="bar", location=(0, room.size.y - 0.3, 0), fixed=True)
    view = view_of(relations=[("ana", "behind", "bar")], people=["ana", "ben"], dressed=(back,))
    at = solved(view)
    assert at["ana"].location[1] < room.size.y - 0.6 or abs(at["ana"].location[0]) > 1.2, "before it or at its end"
    assert math.dist(at["ana"].location[:2], back.location[:2]) < 2.2


def test_nothing_lies_where_somebody_lies_on_the_bed() -> None:
    bed = measure(
        "bed", 1.5, 2.0, 0.56, anchors=(
            Anchor(kind="bed", location=(0, 0, 0.56), size=(1.4, 1.9)),
            Anchor(kind="top", location=(0, 0, 0.56), size=(1.5, 2.0)),
        ),
    )  # fmt: skip
    sleeper = BodyState(asset_id="ana", posture="lie", support_id="bed")
    view = view_of(["bed", "cat"], [("cat", "on", "bed")], [sleeper])
    for states in (view.states, ()):
        at = solved(SpatialPlannerView(**{**view.__dict__, "measures": MEASURES | {"bed": bed}, "states": states}))
        x, y = (a - b for a, b in zip(at["cat"].location[:2], at["bed"].location[:2], strict=True))
        aside = abs(
            x * math.cos(math.radians(at["bed"].rotation[2])) + y * math.sin(math.radians(at["bed"].rotation[2]))
        )
        assert (aside > 0.33) == bool(states)


def test_a_place_before_furniture_has_a_backdrop_and_one_before_a_bare_wall_has_none() -> None:
    shelf = LayoutObject(node_id="wardrobe", asset_id="wardrobe", location=(1.6, 2.0, 0), fixed=True)
    bare = plan().model_copy(update={"walls": tuple(w.model_copy(update={"openings": ()}) for w in plan().walls)})
    view = view_of(people=["ana", "ben"], dressed=(shelf,))
    stage = LayoutStage(SpatialPlannerView(**{**view.__dict__, "plan": bare}))
    assert stage.backdrop(1.6, 0.0) > 0.3
    assert stage.backdrop(-1.6, 0.0) < 0.15
    assert stage.backdrop(1.6, 2.4) == 0.0, "it is before them there"


def test_who_sits_at_a_table_sits_on_the_chair_beside_it_and_faces_it() -> None:
    sitter = BodyState(asset_id="ana", posture="sit", spot=Spot(relation="at", anchor_id="table"))
    at = solved(view_of(["table", "chair"], [("chair", "next_to", "table"), ("ana", "at", "table")], [sitter]))
    ahead, to_table = forward(at["ana"]), [at["table"].location[i] - at["ana"].location[i] for i in (0, 1)]
    assert at["ana"].anchor_asset_id == "chair"
    assert ahead[0] * to_table[0] + ahead[1] * to_table[1] > 0.7 * math.hypot(*to_table)


def test_who_sits_at_a_table_takes_a_seat_nearby_rather_than_its_edge() -> None:
    table = LayoutObject(node_id="table", asset_id="table", location=(0, 1.5, 0), fixed=True)
    chair = LayoutObject(node_id="chair", asset_id="chair", location=(1.6, 0.9, 0), rotation=(0, 0, 30), fixed=True)
    sitter = BodyState(asset_id="ana", posture="sit", spot=Spot(relation="at", anchor_id="table"))
    at = solved(view_of(relations=[("ana", "at", "table")], people=[sitter], dressed=(table, chair)))
    assert at["ana"].anchor_asset_id == "chair"
