"""The Animator stages a small cafe: entrances, seats, speeches, props, continuity; and its critic."""

from __future__ import annotations

import itertools
import math

import pytest

from storyblender.agents.visual_effects_artist import cue_sheet
from storyblender.agents.visual_effects_artist import floor as floor_module
from storyblender.agents.visual_effects_artist.animator import AnimatorDraft, AnimatorView, RulesAnimator, ShotStaging
from storyblender.agents.visual_effects_artist.animator_critic import AnimatorCritic
from storyblender.agents.visual_effects_artist.cue_sheet import LAST_ACTION, LONGEST_EXTRA
from storyblender.agents.visual_effects_artist.floor import Floor
from storyblender.catalog.motions import MOTIONS
from storyblender.catalog.set_plan import Opening, PlanMark, SetPlan, Wall
from storyblender.memory.asset_sheet import Anchor, Asset, CanonicalAsset
from storyblender.memory.base import Vec3
from storyblender.memory.outline import SceneOutline, ScriptLine, ShotOutline, SourceSpan
from storyblender.memory.scene_context import Layout, LayoutObject, SceneSize
from storyblender.memory.shot_context import (
    AssetModification,
    Blocking,
    BodyState,
    CameraInstruction,
    CharacterAction,
    Cue,
    Mark,
    ShotContext,
)

SIZE = SceneSize(x=4, x_negative=-4, y=3.5, y_negative=-3)
DOOR = PlanMark(name="door", location=(-3.6, -1.5, 0), yaw=90, tags=("enter", "exit", "door"))
PLAN = SetPlan(kit="cafe", indoor=True, size=SIZE, marks=(DOOR,))
SEAT = Anchor(kind="seat", name="seat", location=(0, -0.24, 0.45), size=(0.46, 0.42))
TOP = Anchor(kind="top", name="top", location=(0, 0, 0.75), size=(1.1, 0.8))


def _thing(asset_id: str, size: Vec3, *anchors: Anchor) -> Asset:
    canonical = CanonicalAsset(source="catalog", key=asset_id, dimensions=size, anchors=anchors, digest="d")
    return Asset(asset_id=asset_id, asset_type="object", description=asset_id, canonical=canonical)


def _person(asset_id: str, stature: float = 1.75) -> Asset:
    canonical = CanonicalAsset(source="person", key="person", dimensions=(0.5, 0.3, stature), digest="d")
    return Asset(asset_id=asset_id, asset_type="character", description=asset_id, canonical=canonical)


def _at(node_id: str, x: float, y: float, yaw: float = 0.0, z: float = 0.0, asset_id: str = "") -> LayoutObject:
    return LayoutObject(node_id=node_id, asset_id=asset_id or node_id, location=(x, y, z), rotation=(0, 0, yaw))


ASSETS = (
    _thing("chair", (0.46, 0.48, 0.9), SEAT),
    _thing("table", (1.1, 0.8, 0.75), TOP),
    _thing("letter", (0.11, 0.22, 0.01)),
    _thing("cup", (0.08, 0.08, 0.1)),
    _person("rick"),
    _person("ilsa", 1.7),
)
LAYOUT = Layout(
    scene_size=SIZE,
    objects=(
        _at("table", 0, 1.0),
        _at("chair_l", -1.3, 1.0, 90, asset_id="chair"),
        _at("chair_r", 1.3, 1.0, -90, asset_id="chair"),
        _at("cup", 0.3, 1.0, z=0.75),
        _at("rick", -1, -1),
        _at("ilsa", 1, -0.6, -90),
    ),
)


def _do(who: str, motion: str, **fields: object) -> CharacterAction:
    values = {"asset_id": who, "action_description": motion, "motion": motion, **fields}
    return CharacterAction.model_validate(values)


def _shot(shot_id: int, *actions: CharacterAction, seconds: float = 4.0, **fields: object) -> ShotContext:
    values = {
        "scene_id": 1,
        "shot_id": shot_id,
        "on_stage": ("rick", "ilsa"),
        "character_actions": actions,
        "camera_instruction": CameraInstruction(),
        "duration": round(seconds * 24),
        **fields,
    }
    return ShotContext.model_validate(values)


def _view(*shots: ShotContext, lines: dict[int, tuple[ScriptLine, ...]] | None = None) -> AnimatorView:
    outline = SceneOutline(
        scene_id=1,
        scene_description="",
        shots=tuple(ShotOutline(shot_id=k, lines=v) for k, v in (lines or {}).items()),
    )
    return AnimatorView(scene_id=1, layout=LAYOUT, plan=PLAN, assets=ASSETS, shots=shots, outline=outline)


def _end(shot: ShotStaging, who: str) -> Mark:
    return next(b.end for b in shot.blocking if b.end.asset_id == who)


def _start(shot: ShotStaging, who: str) -> Mark:
    return next(b.start for b in shot.blocking if b.start.asset_id == who)


def _cues(shot: ShotStaging, who: str) -> list[str]:
    return [cue.clip for cue in shot.cues if cue.asset_id == who]


def _stage(*shots: ShotContext, **fields: object) -> tuple[ShotStaging, ...]:
    view = _view(*shots, **fields)  # type: ignore[arg-type]
    draft = RulesAnimator().propose(view)
    faults = AnimatorCritic().judge(draft, view).faults
    assert faults == (), [fault.message for fault in faults]
    return draft.shots


def test_the_end_of_a_shot_is_the_start_of_the_next() -> None:
    shots = _stage(
        _shot(1, _do("rick", "walk", target_id="ilsa")),
        _shot(2, _do("rick", "sit", target_id="chair"), seconds=6),
        _shot(3, _do("ilsa", "sit", target_id="chair"), seconds=6),
    )
    for before, after in itertools.pairwise(shots):
        for who in ("rick", "ilsa"):
            assert _end(before, who) == _start(after, who)


def test_people_who_talk_stand_at_a_talking_distance() -> None:
    (shot,) = _stage(_shot(1, _do("rick", "walk", target_id="ilsa")))
    rick, ilsa = _end(shot, "rick"), _end(shot, "ilsa")
    assert 1.0 <= math.dist(rick.location, ilsa.location) <= 1.4
    aside = math.degrees(math.atan2(abs(ilsa.location[1] - rick.location[1]), abs(ilsa.location[0] - rick.location[0])))
    assert aside <= 50, "one would hide the other"


def test_two_sitters_take_two_seats_and_walk_there_first() -> None:
    (shot,) = _stage(_shot(1, _do("rick", "sit", target_id="chair"), _do("ilsa", "sit", target_id="chair"), seconds=6))
    ends = [_end(shot, who) for who in ("rick", "ilsa")]
    assert [end.posture for end in ends] == ["sit", "sit"]
    assert len({end.support_id for end in ends}) == 2
    assert _cues(shot, "rick")[:2] == ["walk", "sit"]


def test_whoever_the_script_finds_sitting_sits_from_the_first_frame() -> None:
    state = BodyState(asset_id="ilsa", posture="sit", support_id="chair", held=("letter",))
    (shot,) = _stage(_shot(1, states=(state,)))
    start = _start(shot, "ilsa")
    assert start.posture == "sit"
    assert start.held == (("R", "letter"),)
    assert shot.prop_states[0].held_by == "ilsa"


def test_entrances_come_from_the_door_and_start_nearer_where_the_shot_is_short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cue_sheet, "LONGEST_EXTRA", 3.5)
    alone = _shot(1, on_stage=("ilsa",))
    enters = _shot(2, _do("rick", "walk", target_id="ilsa"), seconds=5)
    _, shot = _stage(alone, enters)
    assert math.dist(_start(shot, "rick").location, DOOR.location) < 0.5
    _, short = _stage(alone, enters.model_copy(update={"duration": 8}))
    assert math.dist(_start(short, "rick").location, DOOR.location) > 0.3
    assert short.flaws
    assert short.duration <= 8 + 24 * 3.5
    walk = next(cue for cue in short.cues if cue.clip == "walk")
    assert walk.duration is not None, "who is short of time hurries"
    assert walk.start + walk.duration <= short.duration


def test_what_is_done_on_the_spot_ends_with_the_shot() -> None:
    talks = tuple(_do(who, "talk", target_id="ilsa" if who == "rick" else "rick") for who in ("rick", "ilsa") * 4)
    (shot,) = _stage(_shot(1, *talks, seconds=2))
    assert shot.duration <= 2 * 24 + 24 * (LONGEST_EXTRA + LAST_ACTION)
    assert max(cue.start + (cue.duration or 0) for cue in shot.cues if cue.start < shot.duration) <= shot.duration


def test_who_will_play_a_guitar_holds_it_from_the_first_frame() -> None:
    guitar = _thing("guitar", (0.34, 0.12, 1.0))
    shots = (
        _shot(1),
        _shot(2, states=(BodyState(asset_id="rick"),)),
        _shot(3, _do("rick", "play_piano", prop_id="guitar")),
    )
    layout = LAYOUT.model_copy(update={"objects": (*LAYOUT.objects, _at("guitar", 0, 1.0, z=0.75))})
    view = _view(*shots).model_copy(update={"assets": (*ASSETS, guitar), "layout": layout})
    staged = RulesAnimator().propose(view).shots
    for shot in staged:
        assert _start(shot, "rick").held == (("R", "guitar"),)
        assert _end(shot, "rick").held == (("R", "guitar"),)
    assert "pick_up" not in _cues(staged[2], "rick")
    taken = (_shot(1, _do("rick", "pick_up", prop_id="guitar"), seconds=6), shots[2].model_copy(update={"shot_id": 2}))
    first, _ = RulesAnimator().propose(view.model_copy(update={"shots": taken})).shots
    assert _start(first, "rick").held == (), "the script says when it is taken up"


def test_who_opens_the_door_and_walks_in_comes_from_it() -> None:
    opening = Opening(name="door_1", kind="door", x=1.55, width=0.9, height=2.0)
    wall = Wall(node_id="left", start=(-4, 0.5), end=(-4, -3), height=2.6, material="plaster", openings=(opening,))
    plan = PLAN.model_copy(update={"walls": (wall,)})
    shots = (
        _shot(1, on_stage=("ilsa",)),
        _shot(2, _do("rick", "open", target_id="door"), _do("rick", "walk"), seconds=6),
        _shot(3, _do("rick", "open", target_id="door"), seconds=8),
    )
    view = _view(*shots).model_copy(update={"plan": plan})
    _, enters, opens = RulesAnimator().propose(view).shots
    assert math.dist(_start(enters, "rick").location, DOOR.location) < 0.1
    assert "open" not in _cues(enters, "rick"), "the door swings for who comes in"
    cue = next(cue for cue in opens.cues if cue.clip == "open")
    assert cue.target_id == "door_1"
    handle = (-4 + 0.05, 0.5 - 1.55 - 0.9 + 0.08)
    assert math.dist(_end(opens, "rick").location[:2], handle) < 0.75


def test_who_picks_up_or_puts_down_stands_near_and_faces_it() -> None:
    for action in (_do("rick", "pick_up", prop_id="cup"), _do("ilsa", "pick_up", prop_id="cup")):
        (shot,) = _stage(_shot(1, action, seconds=6))
        end = _end(shot, action.asset_id)
        assert math.dist(end.location[:2], (0.3, 1.0)) < 0.76
        toward = math.degrees(math.atan2(0.3 - end.location[0], end.location[1] - 1.0))
        assert abs((toward - end.yaw + 180) % 360 - 180) < 60


def test_who_leaves_walks_to_the_door() -> None:
    shots = _stage(_shot(1, _do("rick", "walk"), seconds=6), _shot(2, on_stage=("ilsa",)))
    assert math.dist(_end(shots[0], "rick").location, DOOR.location) < 0.6
    assert [b.start.asset_id for b in shots[1].blocking] == ["ilsa"]


def test_speeches_are_timed_over_the_shot_and_heard() -> None:
    span = SourceSpan(start=0, end=1)
    lines = (
        ScriptLine(kind="dialogue", text="word " * 10, span=span, speaker="rick"),
        ScriptLine(kind="dialogue", text="word " * 5, span=span, speaker="ilsa"),
    )
    talk = (
        _do("rick", "talk", target_id="ilsa", line_index=0, mood="angry"),
        _do("ilsa", "talk", target_id="rick", line_index=1),
    )
    (shot,) = _stage(_shot(1, *talk, seconds=7), lines={1: lines})
    first, second = (cue for cue in shot.cues if cue.clip == "talk")
    assert first.mood == "angry"
    assert first.duration == pytest.approx(4.4 * 24, abs=2)
    assert second.start >= first.start + (first.duration or 0) - 1
    listening = next(cue for cue in shot.cues if cue.clip == "listen" and cue.asset_id == "ilsa")
    assert listening.target_id == "rick"
    assert abs(listening.start - first.start) < 12


def test_a_prop_goes_from_hand_to_hand_to_table() -> None:
    states = (BodyState(asset_id="rick", held=("letter",)), BodyState(asset_id="ilsa"))
    given, put, after = _stage(
        _shot(1, _do("rick", "give", target_id="ilsa", prop_id="letter"), states=states, seconds=5),
        _shot(2, _do("ilsa", "put_down", target_id="table", prop_id="letter"), seconds=6),
        _shot(3),
    )
    assert _end(given, "ilsa").held == (("R", "letter"),)
    assert _end(given, "rick").held == ()
    assert _end(put, "ilsa").held == ()
    (state,) = after.prop_states
    assert state.location is not None
    assert state.location[2] == pytest.approx(0.75)
    assert state.held_by is None


def test_what_is_put_down_for_somebody_at_a_table_is_before_them_on_it_not_on_their_chair() -> None:
    chair = _thing("chair", (0.46, 0.48, 0.9), SEAT, Anchor(kind="top", location=(0, 0, 0.45), size=(0.42, 0.4)))
    objects = tuple(
        each if each.node_id != "chair_l" else each.model_copy(update={"location": (-0.75, 1.0, 0.0)})
        for each in LAYOUT.objects
    )
    view = _view(
        _shot(1, _do("rick", "put_down", prop_id="letter", target_id="letter"), seconds=6, states=(
            BodyState(asset_id="rick", held=("letter",)),
            BodyState(asset_id="ilsa", posture="sit", support_id="chair_l"),
        )),
        _shot(2, _do("ilsa", "pick_up", prop_id="letter")),
    )  # fmt: skip
    view = view.model_copy(
        update={
            "assets": (chair, *(each for each in ASSETS if each.asset_id != "chair")),
            "layout": LAYOUT.model_copy(update={"objects": objects}),
        }
    )
    put, taken = RulesAnimator().propose(view).shots
    (state,) = taken.prop_states
    assert state.location is not None
    assert state.location[2] == pytest.approx(0.75), "on the table, not on the chair"
    sitter = _end(put, "ilsa").location
    assert 0.2 < state.location[0] - sitter[0] < 0.5, "before her"
    assert abs(state.location[1] - sitter[1]) < 0.25
    assert _end(taken, "ilsa").held == (("R", "letter"),)


def test_who_leaves_for_what_is_beyond_the_set_goes_out_on_its_side() -> None:
    plane = _thing("plane", (20.0, 15.0, 5.0))
    layout = LAYOUT.model_copy(update={"objects": (_at("plane", 2, 24.0), *LAYOUT.objects)})
    far = PlanMark(name="back", location=(3.4, 3.0, 0), yaw=0, tags=("exit",))
    view = _view(_shot(1, _do("rick", "walk", target_id="plane"), seconds=6), _shot(2, on_stage=("ilsa",)))
    plan = PLAN.model_copy(update={"marks": (DOOR, far)})
    view = view.model_copy(update={"assets": (plane, *ASSETS), "layout": layout, "plan": plan})
    assert _end(RulesAnimator().propose(view).shots[0], "rick").location[:2] == (3.4, 3.0)


def test_two_who_leave_in_the_open_for_a_plane_walk_side_by_side_towards_it() -> None:
    plane = _thing("plane", (20.0, 15.0, 5.0))
    layout = LAYOUT.model_copy(update={"objects": (_at("plane", 2, 24.0), *LAYOUT.objects)})
    both = [_do(who, "walk", target_id="plane") for who in ("rick", "ilsa")]
    view = _view(_shot(1, *both, seconds=6), _shot(2, on_stage=()))
    plan = PLAN.model_copy(update={"indoor": False})
    view = view.model_copy(update={"assets": (plane, *ASSETS), "layout": layout, "plan": plan})
    draft = RulesAnimator().propose(view)
    assert AnimatorCritic().judge(draft, view).faults == ()
    rick, ilsa = (_end(draft.shots[0], who).location for who in ("rick", "ilsa"))
    assert math.dist(rick, ilsa) > 1.0
    assert min(rick[1] + 1.0, ilsa[1] + 0.6) > 3.0, "a few metres on"


BENCH = _thing(
    "bench",
    (1.8, 0.42, 0.46),
    Anchor(kind="seat", name="seat", location=(0, -0.21, 0.46), size=(1.8, 0.42)),
    Anchor(kind="top", location=(0, 0, 0.46), size=(1.8, 0.4)),
)


def _on_bench(*shots: ShotContext) -> tuple[ShotStaging, ...]:
    layout = LAYOUT.model_copy(update={"objects": (_at("bench", 0, 3.0), *LAYOUT.objects)})
    return (
        RulesAnimator().propose(_view(*shots).model_copy(update={"assets": (BENCH, *ASSETS), "layout": layout})).shots
    )


@pytest.mark.parametrize("stage", [True, False])
def test_what_is_put_down_on_a_seat_is_beside_who_sits_there(stage: bool) -> None:
    both = {"posture": "sit", "support_id": "bench"}
    states = (BodyState(asset_id="rick", held=("letter",), **both), BodyState(asset_id="ilsa", **both))
    put, after = _on_bench(
        _shot(1, _do("rick", "put_down", prop_id="letter", target_id="letter"), states=states[: 1 + stage]),
        _shot(2),
    )
    (spot,) = (state.location for state in after.prop_states)
    assert spot is not None and spot[2] == pytest.approx(0.46), "on the bench"
    sitters = [_end(put, "rick").location[0]] + [_end(put, "ilsa").location[0]] * stage
    assert all(abs(spot[0] - x) > 0.25 for x in sitters), "under nobody"
    assert not stage or min(sitters) < spot[0] < max(sitters), "between them"


@pytest.mark.parametrize(("x", "hand"), [(0.3, "L"), (-0.3, "R")])
def test_what_lies_on_the_left_is_taken_with_the_left_hand(x: float, hand: str) -> None:
    states = (BodyState(asset_id="rick", posture="sit", support_id="bench"),)
    seat = _end(_on_bench(_shot(1, states=states))[0], "rick").location
    objects = (_at("bench", 0, 3.0), _at("cup", seat[0] + x, seat[1] + 0.2, z=0.46), _at("rick", -1, -1))
    view = _view(_shot(1, _do("rick", "pick_up", prop_id="cup"), states=states))
    layout = LAYOUT.model_copy(update={"objects": objects})
    (shot,) = RulesAnimator().propose(view.model_copy(update={"assets": (BENCH, *ASSETS), "layout": layout})).shots
    assert _end(shot, "rick").location == seat and _end(shot, "rick").held == ((hand, "cup"),)


def test_a_bag_is_put_down_before_both_hands_are_wanted() -> None:
    bag = _thing("bag", (0.6, 0.2, 0.45))
    ring = _thing("ring", (0.02, 0.01, 0.03))
    states = (BodyState(asset_id="rick", held=("bag", "ring")),)
    view = _view(_shot(1, _do("rick", "dress", prop_id="ring"), states=states), _shot(2))
    worn, after = RulesAnimator().propose(view.model_copy(update={"assets": (bag, ring, *ASSETS)})).shots
    assert [clip for clip in _cues(worn, "rick") if clip != "look"] == ["put_down", "dress"]
    assert _end(worn, "rick").held == ()
    state = {each.asset_id: each for each in after.prop_states}
    assert state["bag"].location is not None and state["bag"].location[2] == 0.0
    assert not state["ring"].visible, "on the finger, too small to see"


def test_what_is_given_is_fetched_first_and_things_are_worked_at_in_profile() -> None:
    (shot,) = _stage(_shot(1, _do("rick", "give", target_id="ilsa", prop_id="cup"), seconds=8))
    assert [clip for clip in _cues(shot, "rick") if clip in ("pick_up", "give")] == ["pick_up", "give"]
    at_cup = next(cue.mark for cue in shot.cues if cue.asset_id == "rick" and cue.clip == "walk")
    assert at_cup is not None and 60 < at_cup.yaw % 360 < 300 and _end(shot, "ilsa").held == (("R", "cup"),)


def test_nobody_goes_all_round_a_long_table_for_a_better_place_at_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(floor_module, "BACK", 3.0)
    view = _view()
    wall = _thing("counter", (5.0, 0.5, 1.0))
    layout = LAYOUT.model_copy(update={"objects": (_at("counter", 0.0, 1.0),)})
    floor = Floor(layout, (wall,), view.plan)
    spot = floor.spot_around((0.0, 1.1), (0.0, 0.3), 1.0, (), 0.75)
    assert spot is not None and spot[1] < 1.0, "on the near side, though back to the audience"


def test_who_is_nearly_there_still_comes_close_and_need_not_bow_to_reach() -> None:
    floor = Floor(LAYOUT.model_copy(update={"objects": ()}), (), PLAN)
    point, reach = (0.0, 0.0), 0.62
    spot = floor.spot_around(point, (1.2, 0.0), 1.0, (), reach)
    assert spot is not None and math.dist(spot, point) < 0.8 * reach


def test_nothing_is_put_before_the_hand_that_holds_something() -> None:
    states = (
        BodyState(asset_id="rick", held=("letter",)),
        BodyState(asset_id="ilsa", posture="sit", support_id="chair_l", held=("cup",)),
    )
    shot = _shot(1, _do("rick", "put_down", prop_id="letter", target_id="table"), states=states, seconds=6)
    chairs = tuple(
        each if each.node_id != "chair_l" else each.model_copy(update={"location": (-0.75, 1.0, 0.0)})
        for each in LAYOUT.objects
    )
    view = _view(shot, _shot(2)).model_copy(update={"layout": LAYOUT.model_copy(update={"objects": chairs})})
    put, after = RulesAnimator().propose(view).shots
    spot = next(state.location for state in after.prop_states if state.asset_id == "letter")
    assert spot is not None and spot[1] - _end(put, "ilsa").location[1] > -0.12, "not on her right, where the cup is"


def test_nothing_is_put_down_in_a_flowerpot() -> None:
    pot = _thing("pot", (0.4, 0.4, 1.1), Anchor(kind="top", location=(0, 0, 0.6), size=(0.2, 0.2)))
    states = (BodyState(asset_id="rick", held=("letter",)),)
    view = _view(_shot(1, _do("rick", "put_down", prop_id="letter", target_id="letter"), states=states), _shot(2))
    layout = LAYOUT.model_copy(update={"objects": (_at("pot", -1, -0.4), *LAYOUT.objects)})
    after = RulesAnimator().propose(view.model_copy(update={"assets": (pot, *ASSETS), "layout": layout})).shots[1]
    (state,) = after.prop_states
    assert state.location is not None
    assert state.location[2] == pytest.approx(0.75), "on the table, though the pot is nearer"


def test_what_comes_out_of_a_pocket_is_not_seen_lying_about_before() -> None:
    brought = AssetModification(asset_id="cup", modification_type="add")
    before, after = _stage(
        _shot(1), _shot(2, _do("rick", "take", prop_id="cup"), asset_modifications=(brought,), seconds=5)
    )
    assert [state.visible for state in before.prop_states] == [False]
    assert _end(after, "rick").held == (("R", "cup"),)
    assert "pick_up" not in _cues(after, "rick"), "not from the table"
    (state,) = after.prop_states
    assert state.visible and state.held_by == "rick" and state.hand is None, "on him, in no hand"
    assert [cue.target_id for cue in after.cues if cue.clip == "take"] == ["rick"], "his hand goes for it"


def test_what_somebody_enters_with_is_not_seen_lying_about_before() -> None:
    holding = (BodyState(asset_id="rick", held=("cup",)),)
    before, after = _stage(_shot(1), _shot(2, states=holding))
    assert [state.visible for state in before.prop_states] == [False]
    assert _end(after, "rick").held == (("R", "cup"),)


def test_what_somebody_looked_at_before_it_is_in_a_hand_lies_there_until_then() -> None:
    looks = CameraInstruction(description="cup", focus_on_ids=("cup",), kind="insert", size="CU")
    before, _ = _stage(
        _shot(1, camera_instruction=looks), _shot(2, states=(BodyState(asset_id="rick", held=("cup",)),))
    )
    assert before.prop_states == ()


def test_who_goes_without_an_end_and_then_embraces_somebody_goes_to_them() -> None:
    (shot,) = _stage(_shot(1, _do("rick", "walk"), _do("rick", "hug", target_id="ilsa"), seconds=6))
    walks = [cue.mark for cue in shot.cues if cue.asset_id == "rick" and cue.clip == "walk"]
    assert walks[0] is not None and math.dist(walks[0].location[:2], _start(shot, "ilsa").location[:2]) < 1.5


def test_who_has_no_place_of_their_own_comes_to_whom_they_speak_to_and_faces_them() -> None:
    objects = tuple(each for each in LAYOUT.objects if each.node_id != "rick")
    view = _view(_shot(1, _do("rick", "walk"), _do("rick", "talk", target_id="ilsa"), seconds=6))
    view = view.model_copy(update={"layout": LAYOUT.model_copy(update={"objects": objects})})
    (shot,) = RulesAnimator().propose(view).shots
    rick, ilsa = _end(shot, "rick"), _end(shot, "ilsa")
    assert 1.0 <= math.dist(rick.location, ilsa.location) <= 1.4
    assert _off(rick, ilsa) < 60


def test_who_speaks_while_they_arrive_turns_to_whom_they_address() -> None:
    (shot,) = _stage(_shot(1, _do("rick", "walk", target_id="cup"), _do("rick", "talk", target_id="ilsa"), seconds=8))
    rick, ilsa = _end(shot, "rick"), _end(shot, "ilsa")
    assert _cues(shot, "rick")[-1] in ("talk", "turn")
    assert _off(rick, ilsa) < 60


def _off(one: Mark, other: Mark) -> float:
    """Degrees between where somebody faces and where somebody else is."""
    way = floor_module.facing(one.location[:2], other.location[:2])
    return abs((math.degrees(way) - one.yaw + 180) % 360 - 180)


def test_who_only_leaves_does_not_come_in_first() -> None:
    going, _ = _stage(_shot(1, _do("rick", "walk")), _shot(2, on_stage=("ilsa",)))
    assert _start(going, "rick").location[:2] == (-1, -1)
    assert math.dist(_end(going, "rick").location[:2], DOOR.location[:2]) < 1.5
    coming, _ = _stage(_shot(1, _do("rick", "walk")), _shot(2))
    assert math.dist(_start(coming, "rick").location[:2], DOOR.location[:2]) < 1.5


def test_a_thing_with_a_grip_is_held_however_large_it_is() -> None:
    grip = Anchor(kind="grip", name="grip", location=(0, 0, 0.1), size=(0.1, 0.1))
    umbrella = _thing("cup", (1.0, 1.0, 0.9), grip)
    view = _view(_shot(1, states=(BodyState(asset_id="rick", held=("cup",)),)))
    assets = (*(asset for asset in ASSETS if asset.asset_id != "cup"), umbrella)
    (shot,) = RulesAnimator().propose(view.model_copy(update={"assets": assets})).shots
    assert _end(shot, "rick").held == (("R", "cup"),)


def test_nobody_holds_a_table() -> None:
    (shot,) = _stage(_shot(1, states=(BodyState(asset_id="rick", held=("table",)),)))
    assert _end(shot, "rick").held == ()


def test_what_no_pocket_holds_is_in_hand_when_it_is_brought_out() -> None:
    brought = AssetModification(asset_id="cup", modification_type="add")
    view = _view(_shot(1, _do("rick", "take", prop_id="cup"), asset_modifications=(brought,), seconds=5))
    assets = (*(asset for asset in ASSETS if asset.asset_id != "cup"), _thing("cup", (0.2, 0.4, 0.5)))
    (shot,) = RulesAnimator().propose(view.model_copy(update={"assets": assets})).shots
    assert shot.prop_states[0].hand == "R" and _cues(shot, "rick") == []


def test_drinking_walks_to_the_cup_and_picks_it_up() -> None:
    (shot,) = _stage(_shot(1, _do("rick", "drink", prop_id="cup"), seconds=6))
    assert [clip for clip in _cues(shot, "rick") if clip != "look"] == ["walk", "pick_up", "drink"]
    assert _end(shot, "rick").held == (("R", "cup"),)


def test_every_cue_is_a_clip_and_every_motion_can_be_staged() -> None:
    for word in MOTIONS:
        for target in (None, "ilsa", "table", "chair"):
            view = _view(_shot(1, _do("rick", word, target_id=target)))
            (shot,) = RulesAnimator().propose(view).shots
            assert all(cue.clip in MOTIONS for cue in shot.cues), word
            assert shot.duration <= 96 + 24 * (LONGEST_EXTRA + LAST_ACTION)


def test_same_scene_same_staging() -> None:
    view = _view(_shot(1, _do("rick", "walk", target_id="table"), _do("ilsa", "look", target_id="rick")))
    assert RulesAnimator().propose(view) == RulesAnimator().propose(view)


def test_locked_blocking_is_kept_and_carried_on() -> None:
    mine = Mark(asset_id="rick", location=(2.0, -2.0, 0.0), yaw=10.0)
    locked = _shot(1, blocking=(Blocking(start=mine, end=mine),), locked=("blocking",), on_stage=("rick",))
    shots = _stage(locked, _shot(2, on_stage=("rick",)))
    assert _start(shots[1], "rick").location == mine.location


def _draft(*blockings: Blocking, cues: tuple[Cue, ...] = ()) -> AnimatorDraft:
    return AnimatorDraft(shots=(ShotStaging(shot_id=1, blocking=blockings, cues=cues, duration=48),))


def _stand(who: str, x: float, y: float) -> Blocking:
    mark = Mark(asset_id=who, location=(x, y, 0.0), yaw=0.0)
    return Blocking(start=mark, end=mark)


@pytest.mark.parametrize(
    ("blockings", "kind"),
    [
        ((_stand("rick", 0.0, 1.0),), "inside"),
        ((_stand("rick", -1.0, -1.0), _stand("ilsa", -1.1, -1.0)), "overlap"),
        ((_stand("rick", 9.0, 0.0),), "off_set"),
    ],
)
def test_the_critic_finds_bad_places_and_the_policy_mends_them(blockings: tuple[Blocking, ...], kind: str) -> None:
    view, draft = _view(_shot(1)), _draft(*blockings)
    critique = AnimatorCritic().judge(draft, view)
    assert [fault.kind for fault in critique.faults] == [kind]
    mended = RulesAnimator().refine(draft, critique, view)
    assert AnimatorCritic().judge(mended, view).faults == ()


def test_the_critic_never_accepts_a_motion_that_does_not_exist() -> None:
    draft = _draft(cues=(Cue(asset_id="rick", clip="stroll", start=0),))
    critique = AnimatorCritic().judge(draft, _view(_shot(1)))
    assert [fault.kind for fault in critique.faults] == ["vocabulary"] and critique.score == 1


def test_the_critic_finds_a_seat_that_is_not_there_and_a_way_that_is_none() -> None:
    ghost = Mark(asset_id="rick", location=(2.0, -2.0, 0.0), yaw=0.0, posture="sit", support_id="sofa")
    critique = AnimatorCritic().judge(_draft(Blocking(start=ghost, end=ghost)), _view(_shot(1)))
    assert [fault.kind for fault in critique.faults] == ["support"]
    inside = Mark(asset_id="rick", location=(0.0, 1.0, 0.0), yaw=0.0)
    outside = Mark(asset_id="rick", location=(-1.0, -1.0, 0.0), yaw=0.0)
    walk = Cue(asset_id="rick", clip="walk", start=0, mark=inside)
    critique = AnimatorCritic().judge(_draft(Blocking(start=outside, end=outside), cues=(walk,)), _view(_shot(1)))
    assert "no_way" in [fault.kind for fault in critique.faults]


def test_who_sits_in_a_part_of_the_set_has_a_seat_of_the_set() -> None:
    (shot,) = _stage(_shot(1, states=(BodyState(asset_id="rick", posture="sit", support_id="jury_box"),)))
    assert _start(shot, "rick").support_id in ("chair_l", "chair_r")


def test_nobody_sits_on_what_lies_on_a_table() -> None:
    (shot,) = _stage(_shot(1, states=(BodyState(asset_id="rick", posture="sit", support_id="cup"),)))
    assert _start(shot, "rick").support_id in ("chair_l", "chair_r")


def test_what_somebody_only_is_at_is_not_in_their_hand() -> None:
    at_it, with_it = _do("rick", "idle", target_id="letter"), _do("rick", "idle", prop_id="letter")
    (there,), (holding,) = _stage(_shot(1, at_it)), _stage(_shot(1, with_it))
    assert "letter" not in dict(_start(there, "rick").held).values()
    assert "letter" in dict(_start(holding, "rick").held).values()


@pytest.mark.parametrize(("letter", "place"), [(0.0, 0.6), (0.6, 0.0)])
def test_nobody_sits_on_what_lies_on_a_seat(letter: float, place: float) -> None:
    objects = (_at("bench", 0, 3.0), _at("letter", letter, 3.0, z=0.46), *LAYOUT.objects)
    states = (BodyState(asset_id="rick", posture="sit", support_id="bench"),)
    view = _view(_shot(1, _do("ilsa", "sit", target_id="rick"), states=states))
    layout = LAYOUT.model_copy(update={"objects": objects})
    (shot,) = RulesAnimator().propose(view.model_copy(update={"assets": (BENCH, *ASSETS), "layout": layout})).shots
    assert _end(shot, "rick").location[0] == pytest.approx(-0.6)
    assert _end(shot, "ilsa").location[0] == pytest.approx(place)


def test_who_opens_what_stands_far_off_goes_there() -> None:
    chest = _thing("chest", (0.5, 0.3, 0.3))
    layout = LAYOUT.model_copy(update={"objects": (_at("chest", 3.3, 2.4), *LAYOUT.objects)})
    view = _view(_shot(1, _do("rick", "open", prop_id="chest", target_id="chest")))
    (shot,) = RulesAnimator().propose(view.model_copy(update={"assets": (chest, *ASSETS), "layout": layout})).shots
    assert [clip for clip in _cues(shot, "rick") if clip not in ("look", "turn")] == ["walk", "open"]
    assert not _end(shot, "rick").held


def test_the_last_act_of_a_full_shot_is_in_it() -> None:
    walks = tuple(_do("rick", "walk", distance=step) for step in (3.0, -3.0, 3.0))
    (shot,) = _stage(_shot(1, *walks, _do("ilsa", "hug", target_id="rick"), seconds=1))
    hug = next(cue for cue in shot.cues if cue.clip == "hug")
    assert hug.start + 24 < shot.duration


def test_a_sack_is_put_on_the_floor_where_nothing_else_is_said() -> None:
    sack = _thing("sack", (0.45, 0.4, 0.6))
    states = (BodyState(asset_id="rick", held=("sack", "cup")),)
    downs = (_do("rick", "put_down", prop_id="sack"), _do("rick", "put_down", prop_id="cup"))
    layout = LAYOUT.model_copy(update={"objects": (_at("table", -1, 0.0), *LAYOUT.objects[1:])})
    view = _view(_shot(1, *downs, states=states, seconds=9), _shot(2))
    _, after = RulesAnimator().propose(view.model_copy(update={"assets": (sack, *ASSETS), "layout": layout})).shots
    heights = {state.asset_id: state.location[2] for state in after.prop_states if state.location}
    assert heights == {"sack": 0.0, "cup": 0.75}


def test_nothing_is_put_on_a_table_that_nobody_comes_to() -> None:
    """A table behind a wall of chests is near, and out of reach."""
    wall = _thing("wall", (8.0, 0.3, 1.2))
    layout = LAYOUT.model_copy(update={"objects": (_at("table", 0, 1.0), _at("wall", 0, 0.2), *LAYOUT.objects[4:])})
    states = (BodyState(asset_id="rick", held=("letter",)),)
    view = _view(_shot(1, _do("rick", "put_down", prop_id="letter"), states=states), _shot(2))
    _, after = RulesAnimator().propose(view.model_copy(update={"assets": (wall, *ASSETS), "layout": layout})).shots
    assert [state.location[2] for state in after.prop_states if state.location] == [0.0]


def test_who_has_only_turned_where_they_stand_is_elsewhere_from_the_start_rather_than_acting_far_off(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(floor_module.Floor, "path", lambda *_: None)
    acts = (_do("rick", "look", target_id="ilsa"), _do("rick", "touch", target_id="ilsa"))
    (shot,) = _stage(_shot(1, _do("rick", "wave"), *acts))
    assert math.dist(_start(shot, "rick").location, _start(shot, "ilsa").location) < 0.8
    assert _start(shot, "rick").location == _end(shot, "rick").location


def test_who_sits_puts_something_down_with_the_hand_on_that_side() -> None:
    """It goes between the two, to the left, and is in that hand from the beginning."""
    rick, ilsa = ({"asset_id": who, "posture": "sit", "support_id": "bench"} for who in ("rick", "ilsa"))
    states = (BodyState.model_validate({**rick, "held": ("letter",)}), BodyState.model_validate(ilsa))
    (put,) = _on_bench(_shot(1, _do("rick", "put_down", prop_id="letter", target_id="letter"), states=states))
    assert _end(put, "ilsa").location[0] > _end(put, "rick").location[0]
    assert _start(put, "rick").held == (("L", "letter"),)


def test_nobody_sits_down_where_somebody_stands() -> None:
    objects = (_at("bench", 0, 3.0), *LAYOUT.objects[:-2], _at("rick", -0.6, -1), _at("ilsa", -0.6, 2.5))
    view = _view(_shot(1, _do("rick", "sit", target_id="bench")))
    layout = LAYOUT.model_copy(update={"objects": objects})
    (shot,) = RulesAnimator().propose(view.model_copy(update={"assets": (BENCH, *ASSETS), "layout": layout})).shots
    assert _end(shot, "rick").posture == "sit"
    assert _end(shot, "rick").location[0] == pytest.approx(0.0), "not the nearest place, where she stands"


@pytest.mark.parametrize(("held", "clip"), [((), "slam"), (("letter",), "hammer"), (("letter", "cup"), "drum")])
def test_who_hits_a_thing_hits_nobody(held: tuple[str, ...], clip: str) -> None:
    states = (BodyState(asset_id="rick", held=held), BodyState(asset_id="ilsa"))
    (shot,) = _stage(_shot(1, _do("rick", "hit", target_id="table"), states=states))
    assert clip in _cues(shot, "rick") and "hit" not in _cues(shot, "rick")


@pytest.mark.parametrize("motion", ["pull", "bow", "recoil", "dance", "bend"])
def test_who_stays_seated_does_in_their_seat_what_people_do_standing(motion: str) -> None:
    seated = BodyState(asset_id="rick", posture="sit", support_id="chair_l")
    states = (seated, BodyState(asset_id="ilsa"))
    (shot,) = _stage(_shot(1, _do("rick", motion), states=states, end_states=states))
    assert all(not MOTIONS[clip].before or "sit" in MOTIONS[clip].before for clip in _cues(shot, "rick"))
    assert _end(shot, "rick").posture == "sit"
