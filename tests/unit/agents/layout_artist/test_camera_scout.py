"""What the scout knows of the floor plan: piers, strangers, crowds; and how heads stand over shoulders."""

from dataclasses import replace

import numpy as np
import pytest
from test_camera_operator import ANNA, FILM, GUARD, TOM, NumberFinder, figure, shoot, view_of

from storyblender.agents.layout_artist.camera_composition import AT_SIDE
from storyblender.agents.layout_artist.camera_cuts import find_cut_faults
from storyblender.agents.layout_artist.camera_operator import operate
from storyblender.agents.layout_artist.camera_operator_critic import CameraOperatorCritic
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, EarlierShot, Moment
from storyblender.agents.layout_artist.camera_scout import CLEARED, scout_takes, take_cost
from storyblender.agents.layout_artist.camera_solids import contains_person, open_vessels, solid_boxes
from storyblender.agents.layout_artist.camera_start import compose_take
from storyblender.agents.layout_artist.camera_visibility import hidden_share
from storyblender.catalog.footprints import piece_boxes
from storyblender.catalog.set_plan import Piece, SetPlan, Slab
from storyblender.geometry.boxes import Box
from storyblender.geometry.camera_path import camera_at
from storyblender.geometry.framing import frame_group, head_share, project
from storyblender.geometry.orbit import pan
from storyblender.geometry.over_shoulder import frame_over_shoulder
from storyblender.memory.scene_context import SceneSize

ARCADE = Piece(
    node_id="arcade_1",
    part="arcade",
    location=(0, -2, 0),
    solid=False,
    params={"width": 9.0, "height": 3.5, "arches": 3.0, "depth": 0.3},
)
PLAN = SetPlan(kit="yard", indoor=False, size=SceneSize(x=6, x_negative=-6, y=6, y_negative=-6), pieces=(ARCADE,))


def test_a_stage_is_a_solid() -> None:
    corners = ((0, 0), (4, 0), (4, 2), (0, 2))
    block = Slab(node_id="stage", role="block", polygon=corners, z=1, thickness=1, material="m")
    (box,) = solid_boxes({}, PLAN.model_copy(update={"pieces": (), "slabs": (block,)}), ())
    assert (box.x, box.y, box.z, box.width, box.depth, box.top) == (2, 1, 0, 4, 2, 1)


def test_who_sits_in_a_boat_is_seen_over_its_side_and_who_sits_on_a_chair_is_seen_as_before() -> None:
    rower = figure("anna", 0.2, 0, 0, 1.3)
    boat, chair = Box(0, 0, 0, 3.4, 1.5, 0.75), Box(0.2, 0, 0, 0.5, 0.5, 0.9)
    assert contains_person(boat, rower) and not contains_person(chair, rower)
    assert open_vessels([chair], rower) == [chair] and len(open_vessels([boat], rower)) == 4
    view = view_of([rower], kind="action", size="FS", focus_on_ids=("anna",), props={"boat": boat})
    level, high = compose_take(view), compose_take(view, 0, 19)
    assert high.camera.elevation > level.camera.elevation + 15
    sides = open_vessels([boat], rower)
    assert hidden_share(high.camera, rower, sides) < hidden_share(level.camera, rower, sides)
    assert high in scout_takes(view), "the scout goes up for her"
    ashore = replace(view, props={})
    assert high not in scout_takes(ashore)


def test_a_camera_does_not_look_into_a_pier() -> None:
    view = view_of([figure("anna", 1.5, -1, 0)], kind="single", size="FS", focus_on_ids=("anna",), plan=PLAN)
    best = scout_takes(view)[0]
    assert hidden_share(best.camera, view.people[0], piece_boxes(ARCADE)) < 0.3
    straight = next(
        take for take in (compose_take(view, turn) for turn in range(-40, 41, 5)) if abs(take.camera.azimuth) < 6
    )
    assert hidden_share(straight.camera, view.people[0], piece_boxes(ARCADE)) > 0.5


def test_a_stranger_stands_aside_in_a_tight_shot_with_what_he_carries_and_stays_in_a_wide_one() -> None:
    behind = figure("guard", 0, 1.0, 0)
    people = {"figures": (ANNA, TOM, behind), "focus_on_ids": ("anna", "tom"), "carried": {"guard": ("lamp",)}}
    tight = view_of(kind="two_shot", size="MS", **people)
    assert {"guard", "lamp"} <= set(scout_takes(tight)[0].hidden)
    assert not any("guard" in take.hidden for take in scout_takes(view_of(kind="two_shot", size="WS", **people)))


def test_sending_somebody_away_costs_a_little() -> None:
    view = view_of((ANNA, GUARD), kind="single", size="MS", focus_on_ids=("anna",))
    take = scout_takes(view)[0]
    kept = replace(take, hidden=())
    away = replace(take, hidden=("guard",))
    assert take_cost(view, away) == pytest.approx(take_cost(view, kept) + CLEARED)
    assert "guard" not in take.hidden, "who is not in the picture need not go"


def test_a_full_shot_that_cuts_the_feet_costs() -> None:
    view = view_of((ANNA, TOM), kind="action", size="FS", focus_on_ids=("anna", "tom"))
    whole = compose_take(view)
    cut = replace(whole, camera=pan(whole.camera, 0.0, 0.15))
    assert project(cut.camera, ANNA.base)[0][0, 1] > 1 > project(whole.camera, ANNA.base)[0][0, 1]
    assert take_cost(view, cut) > take_cost(view, whole) + 0.5


def test_nobody_walks_into_the_camera_and_one_of_several_may_leave_the_picture() -> None:
    wish = {"kind": "two_shot", "size": "MS", "focus_on_ids": ("anna", "tom")}
    still = view_of(moments=tuple(Moment(frame, (ANNA, TOM)) for frame in (0, 20, 40)), **wish)
    take = compose_take(still)
    x, y, _ = take.camera.position
    prices = []
    for there in (figure("anna", float(x), float(y), 0), figure("anna", 30.0, 0.0, 0)):
        moments = (*still.moments[:2], Moment(40, (there, TOM)))
        prices.append(take_cost(replace(still, moments=moments), take) - take_cost(still, take))
    assert prices[0] > 4 and 0 < prices[1] < 0.5


def test_three_people_in_a_row_are_seen_past_each_other() -> None:
    crowd = [figure("a", 0, 0, 0), figure("b", 0.3, 0.9, 0), figure("c", -0.2, 1.8, 0)]
    _, residual, finder = shoot(view_of(crowd, kind="group", size="MWS", focus_on_ids=("a", "b", "c")))
    assert not [flaw for flaw in residual if flaw.kind in ("hidden", "face_hidden", "out_of_frame", "face_out")]
    assert finder.looks <= 20


def test_a_standing_partner_keeps_the_head_over_whose_shoulder_we_look() -> None:
    sitting, standing = figure("anna", 0, 0, 90, 1.3), figure("tom", 1.1, 0, -90, 1.8)
    camera = frame_over_shoulder(FILM, sitting, standing, "MS", 1.0, 0.0, 50.0)
    crown = project(camera, standing.crown)[0][0, 1]
    assert -0.15 < crown < 0.05, "and the sitting one goes no lower than that asks for"
    face = project(camera, sitting.face)[0][0]
    assert 0.2 < face[1] < 0.6


def test_a_script_that_asks_for_a_shoulder_gets_it_even_if_the_subject_walks_away() -> None:
    away = figure("anna", -0.6, 0, -90, 1.65)
    for explicit, over in ((True, True), (False, False)):
        view = view_of((away, TOM), kind="ots", size="MS", focus_on_ids=("anna",), over_id="tom", explicit=explicit)
        seen = project(compose_take(view).camera, TOM.face)
        assert (0 < seen[0][0, 0] < 1 and seen[1][0] > 0) == over


def test_who_is_looked_after_is_no_back_where_a_side_shows_more() -> None:
    away = figure("anna", -0.6, 0, -90, 1.65)
    view = view_of((away, TOM), kind="ots", size="MS", focus_on_ids=("anna",), over_id="tom", explicit=True)
    camera, residual, _ = shoot(view)
    assert away.turned_from(camera.position) < 120 < away.turned_from(compose_take(view).camera.position)
    assert all(AT_SIDE < x < 1 - AT_SIDE for x in project(camera, [away.face, TOM.face])[0][:, 0]), "both are shown"
    assert not [flaw for flaw in residual if flaw.kind in ("placement", "no_shoulder", "squeezed")]
    back = [
        flaw.kind
        for flaw in CameraOperatorCritic(NumberFinder(view.moments, {})).judge(compose_take(view), view).faults
    ]
    assert "face_away" in back


def test_who_walks_off_is_seen_from_behind_past_who_looks_after_them() -> None:
    steps = tuple(Moment(20 * n, (TOM, figure("anna", -0.6 - 1.2 * n, 0.1, -90, 1.65))) for n in range(3))
    wish = {"kind": "ots", "size": "MS", "focus_on_ids": ("anna",), "over_id": "tom", "explicit": True}
    view = replace(view_of(moments=steps, **wish), duration=41)
    assert view.in_stride
    camera = scout_takes(view)[0].camera
    walker = view.people[0]
    assert walker.turned_from(camera.position) > 120
    screen, depth = project(camera, [walker.face, TOM.face])
    assert ((screen > 0) & (screen < 1)).all() and depth[1] < depth[0], "past him"
    faults = CameraOperatorCritic(NumberFinder(steps, {})).judge(scout_takes(view)[0], view).faults
    assert "size" not in [each.kind for each in faults], "who goes may be small beside who stays"


@pytest.mark.parametrize(("stature", "low"), [(0.85, False), (1.4, True)])
def test_who_squats_after_a_walk_is_in_a_medium_shot_and_who_bends_is_low_in_it(stature: float, low: bool) -> None:
    steps = tuple(Moment(20 * n, (figure("tom", x, 0, 90, tall),)) for n, (x, tall) in enumerate(
        ((-2.0, 1.75), (0.0, stature), (0.0, stature))))  # fmt: skip
    view = replace(view_of(moments=steps, kind="action", size="MS", focus_on_ids=("tom",)), duration=41)
    (_, y), *_ = project(compose_take(view).camera, [view.people[0].face])[0]
    assert (y > 0.35) == low and y < 0.8


def test_who_bends_is_not_taken_from_behind() -> None:
    bent = replace(figure("tom", 0, 0, 0, 1.1), forward=(0.0, -0.5, -0.85))
    view = view_of([bent], kind="action", size="MS", focus_on_ids=("tom",))
    assert abs(scout_takes(view)[0].camera.azimuth) < 110
    before, behind = (compose_take(view, turn - compose_take(view).camera.azimuth) for turn in (0.0, 180.0))
    assert take_cost(view, behind) > take_cost(view, before) + 1.0


def test_whoever_is_in_a_boat_may_be_looked_down_on() -> None:
    rower, friend = figure("anna", 0.4, 0, -90, 1.3), figure("tom", -0.4, 0, 90, 1.3)
    view = view_of([rower, friend], kind="action", size="MWS", focus_on_ids=("anna", "tom"))
    boat = replace(view, props={"boat": Box(0, 0, 0, 3.4, 1.5, 0.75)})
    for here, minded in ((view, True), (boat, False)):
        take = compose_take(here, 0, 27)
        faults = CameraOperatorCritic(NumberFinder(here.moments, {})).judge(take, here).faults
        assert ("angle" in [fault.kind for fault in faults]) == minded
        assert (take in scout_takes(here)) != minded


def test_a_group_is_held_wherever_one_of_it_walks() -> None:
    moments = tuple(Moment(index * 10, (TOM, figure("anna", x, 0.4, 90))) for index, x in enumerate((-2.2, -1.4, -0.6)))
    view = view_of(moments=moments, kind="action", size="FS", focus_on_ids=("tom", "anna"), movement="pan")
    state = operate(replace(view, duration=21), NumberFinder(moments, {}))
    assert len(state.poses) == 1, "the camera waits"
    camera = scout_takes(view)[0].camera
    for moment in moments:
        screen, _ = project(camera, [face.face for face in moment.figures])
        assert ((screen > 0) & (screen < 1)).all()


def test_nobody_of_a_deep_group_is_behind_the_camera() -> None:
    row = [figure("a", 0, -4, 0), figure("b", 0.2, 0, 0), figure("c", 0, 4, 0)]
    camera = frame_group(FILM, row, "MS", 0.0, 0.0, 18.0)
    assert project(camera, [each.face for each in row])[1].min() > 0.5
    assert np.abs(camera.position).max() < 30


def test_the_camera_of_a_frame_is_between_its_poses() -> None:
    view = view_of([GUARD], kind="single", size="MS", focus_on_ids=("guard",), movement="pan", direction="left")
    state = compose_take(view).state(49, 4.0, 10.0, ())
    first, last = state.poses
    assert camera_at(state, 0, FILM).rotation == pytest.approx(first.rotation)
    assert camera_at(state, 48, FILM).rotation == pytest.approx(last.rotation)
    middle = np.asarray(camera_at(state, 24, FILM).rotation)
    assert abs(middle @ first.rotation) == pytest.approx(abs(middle @ last.rotation))


@pytest.mark.parametrize(("x", "aside"), [(0.5, True), (2.5, False)])
def test_who_sits_beside_the_thing_of_an_insert_may_stand_aside_for_it(x: float, aside: bool) -> None:
    ring = Box(0, 0, 0.45, 0.03, 0.03, 0.03)
    sitter = figure("tom", x, 0, 0, 1.3)
    view = view_of([sitter], {"ring": ring}, kind="insert", size="CU", focus_on_ids=("ring",))
    assert any(take.hidden == ("tom",) for take in scout_takes(view)) == aside


@pytest.mark.parametrize("steps", [(-3.0, 0.0, 0.0), (0.0, 0.0, 3.0), (-3.0, -1.5, 0.0)], ids=["over", "to come", "on"])
def test_a_camera_goes_with_a_walk_when_it_is_walked(steps: tuple[float, ...]) -> None:
    moments = tuple(Moment(24 * n, (figure("anna", x, 0, 90),)) for n, x in enumerate(steps))
    view = view_of(moments=moments, kind="action", size="FS", focus_on_ids=("anna",), movement="track")
    view = replace(view, duration=49)
    taken = compose_take(view)
    state = taken.state(view.duration, 5.6, 10.0, ())
    at = [project(camera_at(state, moment.frame, FILM), [moment.figures[0].face])[0][0] for moment in moments]
    assert np.ptp(np.array(at), axis=0).max() < 0.02, "she stays where she is in the picture"
    assert np.allclose(at[1], project(taken.camera, [moments[1].figures[0].face])[0][0], atol=0.01), "as composed"


def test_who_is_there_by_chance_keeps_the_head() -> None:
    child = figure("tam", 0, 0, 0, 1.1)
    view = view_of([child], kind="action", size="FS", focus_on_ids=("tam",))
    take = compose_take(view)
    for stature, minded in ((1.1, False), (1.95, True)):
        by = replace(view, moments=(Moment(0, (child, figure("maren", -0.5, -0.3, 0, stature))),))
        assert (take_cost(by, take) > take_cost(view, take) + 1.0) == minded


def test_a_wide_and_a_medium_of_the_same_two_from_the_same_place_are_one_picture_where_heads_are_alike() -> None:
    pair = figure("anna", -0.4, 0, 90), figure("tom", 0.4, 0, -90)
    wide = view_of(pair, kind="action", size="FS", focus_on_ids=("anna", "tom"))
    first = compose_take(wide)
    near = view_of(pair, kind="two_shot", size="MS", focus_on_ids=("tom", "anna"))
    weights = []
    for back in (1.0, 1.9, 2.6):
        camera = replace(first.camera, distance=first.camera.distance / back)
        before = EarlierShot(wide.instruction, first.state(48, 4.0, 10.0, ()), wide.subjects(wide.moments[-1]))
        found = find_cut_faults(replace(near, previous=before), CameraOperatorDraft(camera, camera, camera))
        weights.append(sum(fault.severity for fault in found if fault.kind == "jump"))
    assert weights[0] > 1.2 > weights[1] > 0 == weights[2]


def test_a_place_shows_the_faces_of_those_who_talk_in_it() -> None:
    talk = figure("anna", 0, -0.6, 180), figure("tom", 0, 0.6, 0)
    view = replace(view_of(talk, kind="establishing", size="WS"), in_frame=("anna", "tom"))
    best = scout_takes(view)[0]
    assert all(one.turned_from(best.camera.position) < 115 for one in talk)
    assert talk[0].turned_from(compose_take(view).camera.position) > 150, "the audience's side shows a back"


def test_who_walks_into_a_place_may_show_it_a_back() -> None:
    still = [Moment(frame, (figure("anna", 0, 0, 180),)) for frame in (0, 20, 40)]
    walk = [Moment(frame, (figure("anna", 0, y, 180),)) for frame, y in ((0, -1.5), (20, 0), (40, 1.5))]
    wish = {"kind": "establishing", "size": "WS", "focus_on_ids": ("anna",)}
    stands, walks = (
        replace(view_of(moments=tuple(steps), **wish), in_frame=("anna",), duration=41) for steps in (still, walk)
    )
    behind = compose_take(walks)
    assert walks.in_stride and walks.people[0].turned_from(behind.camera.position) > 150
    assert take_cost(stands, behind) > take_cost(walks, behind) + 1


def test_a_place_without_people_is_where_it_plays_and_not_behind_its_houses() -> None:
    row = [
        Piece(node_id=f"house_{n}", part="facade", location=(0, y, 0), yaw=yaw, solid=True, footprint=(60.0, 0.1))
        for n, (y, yaw) in enumerate(((2.8, 0.0), (-13.0, 180.0)))
    ]
    area = SceneSize(x=9, x_negative=-9, y=2.8, y_negative=-2.8)
    street = SetPlan(kit="street", indoor=False, size=area, pieces=tuple(row))
    lamps = {f"lamp_{x}": Box(x, -1.7, 0, 0.3, 0.3, 4.5) for x in range(-40, 41, 8)}
    view = view_of((), kind="establishing", size="EWS", plan=street, props=lamps)
    best = scout_takes(view)[0].camera
    assert best.distance < 25 and -13 < best.position[1] < 2.8
    assert take_cost(view, compose_take(view)) > take_cost(view, scout_takes(view)[0]) + 3, (
        "straight on, a house is before it"
    )


def test_a_close_picture_of_things_is_about_the_first_and_what_is_by_it() -> None:
    things = {
        "valve": Box(0, 0, 1, 0.2, 0.2, 0.2),
        "key": Box(0.4, 0, 1, 0.1, 0.1, 0.1),
        "bag": Box(5, 0, 0, 0.4, 0.4, 0.4),
    }
    close = view_of((), kind="action", size="CU", focus_on_ids=("valve", "key", "bag"), props=things)
    assert close.focus == ("valve", "key")
    assert replace(close, instruction=close.instruction.model_copy(update={"size": "FS"})).focus == tuple(things)


def test_who_stands_over_somebody_keeps_the_head() -> None:
    kneels, stands = figure("anna", 0, 0, 20, 1.1), figure("tom", 0.7, 0.2, -30, 1.8)
    view = view_of((kneels, stands), kind="action", size="FS", focus_on_ids=("anna",))
    assert view.focus == ("anna", "tom")
    assert project(scout_takes(view)[0].camera, stands.crown)[0][0, 1] > 0
    for other in ({"kind": "single"}, {"size": "MS"}):
        assert view_of(
            (kneels, stands), **{"kind": "action", "size": "FS", "focus_on_ids": ("anna",)} | other
        ).focus == ("anna",)


def test_a_place_shown_by_a_thing_shows_the_thing_and_no_counter_before_it() -> None:
    props = {"stove": Box(0, 1, 0, 0.6, 0.6, 1.0), "counter": Box(0, -1.2, 0, 2.4, 0.6, 1.1)}
    view = view_of((), kind="establishing", size="WS", focus_on_ids=("stove",), props=props)
    assert take_cost(view, compose_take(view)) > take_cost(view, scout_takes(view)[0]) + 1


def test_the_camera_stands_behind_the_shoulder_that_is_asked_for() -> None:
    steps = tuple(Moment(20 * n, (TOM, figure("anna", -0.9 - 1.2 * n, 0.1, -90, 1.65))) for n in range(3))
    wish = {"kind": "ots", "size": "MS", "focus_on_ids": ("anna",), "over_id": "tom", "explicit": True}
    view = replace(view_of(moments=steps, **wish), duration=41)
    best = scout_takes(view)[0]
    head = head_share(best.camera, TOM)
    assert 0.25 < head < 0.6 and TOM.turned_from(best.camera.position) > 120
    assert head / head_share(best.camera, view.people[0]) < 4, "nobody is dwarfed"
    far = compose_take(view, 88.0)
    assert take_cost(view, far) > take_cost(view, best) + 1.0
    assert "no_shoulder" in [
        each.kind for each in CameraOperatorCritic(NumberFinder(steps, {})).judge(far, view).faults
    ]


def test_the_back_of_a_cheek_is_no_face() -> None:
    view = view_of([GUARD], kind="action", size="FS", focus_on_ids=("guard",))
    prices = {}
    for turn in range(0, 180, 5):
        take = compose_take(view, float(turn))
        prices[GUARD.turned_from(take.camera.position)] = take_cost(view, take)
    last = max(angle for angle in prices if angle <= 108)
    first = min(angle for angle in prices if angle > 108)
    assert prices[first] - prices[last] > 0.6


def test_a_partner_too_far_away_is_no_shoulder_unless_the_script_asks_for_it() -> None:
    away = figure("tom", 0.6 + 3.5, 0, -90, 1.8)
    wish = {"kind": "ots", "size": "MCU", "focus_on_ids": ("anna",), "over_id": "tom"}
    near, far = view_of((ANNA, TOM), **wish), view_of((ANNA, away), **wish)
    assert near.over == TOM and far.over is None and view_of((ANNA, away), explicit=True, **wish).over == away
    finder = NumberFinder(far.moments, {})
    critique = CameraOperatorCritic(finder).judge(scout_takes(far)[0], far)
    assert not {"size", "no_shoulder", "placement"} & {each.kind for each in critique.faults}, "a good single"
