"""Over fences and carts, into boats: where ways begin and end, and what is too high."""

from __future__ import annotations

import math

from storyblender.agents.visual_effects_artist.animator import AnimatorView, RulesAnimator, ShotStaging
from storyblender.agents.visual_effects_artist.animator_critic import AnimatorCritic
from storyblender.agents.visual_effects_artist.crossings import find_boarding_way, find_crossing, vessel_at
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.agents.visual_effects_artist.stage_state import StageState
from storyblender.catalog.set_plan import PlanMark, SetPlan
from storyblender.memory.asset_sheet import Anchor, Asset, CanonicalAsset
from storyblender.memory.base import Vec3
from storyblender.memory.scene_context import Layout, LayoutObject, SceneSize
from storyblender.memory.shot_context import BodyState, CameraInstruction, CharacterAction, ShotContext

SIZE = SceneSize(x=6, x_negative=-6, y=5, y_negative=-5)
WAY_IN = PlanMark(name="left", location=(-5.5, 0, 0), yaw=90, tags=("enter", "exit"))
WAY_OUT = PlanMark(name="right", location=(5.5, -4, 0), yaw=270, tags=("exit",))
STAIRS = PlanMark(name="stairs", location=(-2, 4, 0), yaw=0, tags=("stairs",))
PLAN = SetPlan(kit="dock", indoor=False, size=SIZE, marks=(WAY_IN, WAY_OUT, STAIRS))
THWART = Anchor(kind="seat", name="rower", location=(0, 0.6, 0.31), size=(1.0, 0.24))
FRONT = Anchor(kind="seat", name="seat", location=(0, -0.24, 0.45), size=(0.46, 0.42))


def _thing(asset_id: str, size: Vec3, *anchors: Anchor) -> Asset:
    canonical = CanonicalAsset(source="catalog", key=asset_id, dimensions=size, anchors=anchors, digest="d")
    return Asset(asset_id=asset_id, asset_type="object", description=asset_id, canonical=canonical)


def _person(asset_id: str) -> Asset:
    canonical = CanonicalAsset(source="person", key="person", dimensions=(0.5, 0.3, 1.75), digest="d")
    return Asset(asset_id=asset_id, asset_type="character", description=asset_id, canonical=canonical)


ASSETS = (
    _thing("fence", (2.0, 0.08, 1.1)),
    _thing("wall", (2.0, 0.3, 2.2)),
    _thing("boat", (1.45, 4.0, 0.77), THWART),
    _thing("chair", (0.46, 0.48, 0.9), FRONT),
    _thing("satchel", (0.32, 0.14, 0.34)),
    _thing("orange", (0.08, 0.08, 0.09)),
    _thing("chest", (0.4, 0.25, 0.2)),
    _thing("stick", (0.04, 0.04, 0.95)),
    _person("pia"),
    _person("dex"),
)
PLACES = {
    "fence": (0, 0, 0),
    "wall": (0, 3, 0),
    "boat": (4, 1.5, 0),
    "chair": (-4, -3, 0),
    "orange": (-5, 4, 0),
    "chest": (2, -3, 0),
    "stick": (-5, 3, 0),
}
PEOPLE = {"pia": (0, -2, 0), "dex": (-2, -2, 0)}
LAYOUT = Layout(
    scene_size=SIZE,
    objects=tuple(
        LayoutObject(node_id=name, asset_id=name, location=place, rotation=(0, 0, 0))
        for name, place in (PLACES | PEOPLE).items()
    ),
)
FLOOR = Floor(LAYOUT, ASSETS, PLAN)


def _do(who: str, motion: str, **fields: object) -> CharacterAction:
    values = {"asset_id": who, "action_description": motion, "motion": motion, **fields}
    return CharacterAction.model_validate(values)


def _stage(*actions: CharacterAction, stay: bool = True, **fields: object) -> ShotStaging:
    values = {
        "scene_id": 1, "shot_id": 1, "on_stage": ("pia", "dex"), "character_actions": actions,
        "camera_instruction": CameraInstruction(), "duration": 192, **fields,
    }  # fmt: skip
    shot = ShotContext.model_validate(values)
    before, after = (shot.model_copy(update={"shot_id": n, "character_actions": (), "states": ()}) for n in (0, 2))
    after = after.model_copy(update={"on_stage": ("dex",)})
    shots = (before, shot) if stay else (before, shot, after)
    view = AnimatorView(scene_id=1, layout=LAYOUT, plan=PLAN, assets=ASSETS, shots=shots)
    draft = RulesAnimator().propose(view)
    assert AnimatorCritic().judge(draft, view).faults == ()
    return draft.shots[1]


def test_one_gets_over_a_fence_but_not_over_a_wall() -> None:
    way = find_crossing(FLOOR, FLOOR.things["fence"], (0.4, -2.0), 1.0)
    assert way is not None
    assert way.near[1] < -0.3 < 0.3 < way.far[1]
    assert way.near[0] == way.far[0], "straight over it"
    assert find_crossing(FLOOR, FLOOR.things["wall"], (0.0, 2.0), 1.0) is None


def test_who_jumps_over_a_fence_goes_there_and_ends_behind_it() -> None:
    shot = _stage(_do("pia", "run"), _do("pia", "jump", target_id="fence"))
    assert [cue.clip for cue in shot.cues if cue.asset_id == "pia" and cue.mark] == ["run", "jump"]
    assert shot.blocking[0].end.location[1] > 0.3


def test_a_chair_is_no_vessel_and_a_boat_is() -> None:
    assert vessel_at(FLOOR, (4.0, 1.5)) is FLOOR.things["boat"]
    assert vessel_at(FLOOR, (-4.0, -3.0)) is None
    way = find_boarding_way(FLOOR, FLOOR.things["boat"], (4.0, 1.5), (0.0, 1.5), 1.0)
    assert way is not None
    assert way.near[0] < 4 - 0.72, "over the side one comes from"


def test_one_comes_aboard_a_boat_that_lies_a_step_off_the_quay() -> None:
    moored = LayoutObject(node_id="boat", asset_id="boat", location=(0, 6.21, 0), rotation=(0, 0, 90))
    floor = Floor(Layout(scene_size=SIZE, objects=(moored,)), ASSETS, PLAN)
    way = find_boarding_way(floor, floor.things["boat"], (0.0, 6.21), (0.0, 0.0), 1.0)
    assert way is not None
    assert floor.inside(way.near)
    assert way.near[1] > 4.5


def test_who_could_not_walk_to_a_seat_is_on_it_when_the_next_shot_begins() -> None:
    stage = StageState(FLOOR, ASSETS, LAYOUT.objects)
    pia, seat = stage.people["pia"], FLOOR.seats("chair")[0]
    pia.present, stage.next_places["pia"] = True, ((2.0, 2.0), 0.0)
    stage.sit_by_cut(pia, seat)
    stage.end_shot(["pia"])
    assert pia.place == seat.edge


def test_one_climbs_into_the_boat_sits_and_climbs_out_again() -> None:
    shot = _stage(_do("pia", "jump", target_id="boat"), _do("pia", "walk", target_id="dex"), duration=400)
    clips = [cue.clip for cue in shot.cues if cue.asset_id == "pia" and cue.clip not in ("look", "turn")]
    assert clips[:6] == ["walk", "climb", "sit", "rise", "climb", "walk"]
    assert vessel_at(FLOOR, shot.blocking[0].end.location[:2]) is None


def test_what_is_thrown_is_caught_by_who_catches_it() -> None:
    held = BodyState(asset_id="dex", held=("satchel",))
    shot = _stage(_do("dex", "throw", prop_id="satchel"), _do("pia", "catch", prop_id="satchel"), states=(held,))
    throw, caught = (next(cue for cue in shot.cues if cue.clip == clip) for clip in ("throw", "catch"))
    assert (throw.target_id, caught.asset_id, caught.start) == ("pia", "pia", throw.start)
    assert shot.blocking[0].end.held == (("R", "satchel"),)


def test_what_one_takes_comes_out_of_the_bag_one_holds() -> None:
    held = BodyState(asset_id="pia", held=("satchel", "orange"))
    shot = _stage(_do("pia", "take", prop_id="orange"), states=(held,))
    (take,) = (cue for cue in shot.cues if cue.clip == "take")
    assert take.target_id == "satchel"
    assert shot.blocking[0].start.held == (("R", "satchel"),)
    assert shot.blocking[0].end.held == (("L", "orange"), ("R", "satchel"))


def test_who_takes_somebody_lays_a_hand_on_them() -> None:
    shot = _stage(_do("pia", "take", target_id="dex"))
    assert [cue.clip for cue in shot.cues if cue.asset_id == "pia"][-1] == "touch"


def test_who_leaves_by_what_is_at_hand_goes_on_out_of_the_scene() -> None:
    shot = _stage(
        _do("pia", "walk", target_id="fence"), _do("pia", "walk", target_id="fence"), stay=False, duration=400
    )
    end = shot.blocking[0].end.location[:2]
    assert min(math.dist(end, mark.location[:2]) for mark in (WAY_IN, WAY_OUT)) < 0.5


def test_a_box_is_opened_where_it_stands_and_things_come_out_of_it() -> None:
    shot = _stage(_do("pia", "open", prop_id="chest"), _do("pia", "take", prop_id="orange"), duration=400)
    clips = [(cue.clip, cue.target_id) for cue in shot.cues if cue.asset_id == "pia" and cue.clip in ("open", "take")]
    assert clips == [("open", None), ("take", "chest")]
    assert shot.blocking[0].end.held == (("R", "orange"),)


def test_who_leans_on_a_stick_holds_it() -> None:
    leans = BodyState(asset_id="pia", posture="lean", support_id="stick")
    start = _stage(states=(leans,)).blocking[0].start
    assert (start.posture, start.held) == ("stand", (("R", "stick"),))


def test_somebody_is_meant_where_nobody_is_named() -> None:
    shot = _stage(_do("pia", "shake_hands"))
    (shake,) = (cue for cue in shot.cues if cue.clip == "shake_hands")
    assert shake.target_id == "dex"


def test_one_kneels_beside_who_has_fallen_and_touches_them() -> None:
    shot = _stage(_do("dex", "fall"), _do("pia", "touch", target_id="dex"), duration=400)
    assert [cue.clip for cue in shot.cues if cue.asset_id == "pia"][-2:] == ["kneel", "touch"]
    pia, dex = shot.blocking[0].end, shot.blocking[1].end
    assert math.dist(pia.location, dex.location) > 0.7, "beside the breast, not at the feet"


def test_two_turn_to_each_other_before_something_changes_hands() -> None:
    held = BodyState(asset_id="pia", held=("satchel",))
    shot = _stage(_do("pia", "give", target_id="dex", prop_id="satchel"), states=(held,))
    give = next(cue for cue in shot.cues if cue.clip == "give")
    turns = [cue for cue in shot.cues if cue.clip == "turn" and cue.asset_id == "dex"]
    assert all(cue.start + (cue.duration or 20) <= give.start for cue in turns)
    assert turns, "dex faced away"


def test_who_comes_up_the_stairs_begins_there_and_who_goes_up_ends_there() -> None:
    comes = ShotContext(
        scene_id=1, shot_id=1, on_stage=("pia",), character_actions=(_do("pia", "climb"),), duration=192,
        camera_instruction=CameraInstruction(),
    )  # fmt: skip
    goes = comes.model_copy(update={"shot_id": 2})
    view = AnimatorView(scene_id=1, layout=LAYOUT, plan=PLAN, assets=ASSETS, shots=(comes, goes))
    first, second = RulesAnimator().propose(view).shots
    assert math.dist(first.blocking[0].start.location, STAIRS.location) < 0.3
    assert math.dist(first.blocking[0].end.location, STAIRS.location) > 1.0
    assert math.dist(second.blocking[0].end.location, STAIRS.location) < 0.3
    assert {cue.clip for cue in (*first.cues, *second.cues)} <= {"walk", "turn"}


def test_what_one_eats_far_from_where_it_lay_is_in_hand_from_the_start() -> None:
    shot = _stage(_do("pia", "eat", prop_id="orange"))
    assert shot.blocking[0].start.held == (("R", "orange"),)
    assert "walk" not in [cue.clip for cue in shot.cues if cue.asset_id == "pia"]
