"""The Camera Operator on a stage of pure numbers: people are boxes, the viewfinder projects and samples them."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from storyblender.agents.layout_artist.camera_operator import RulesCameraOperator, camera_side, operate
from storyblender.agents.layout_artist.camera_operator_critic import CameraOperatorCritic
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, EarlierShot, Moment
from storyblender.agents.layout_artist.camera_start import compose_take
from storyblender.catalog.set_plan import SetPlan, Wall
from storyblender.geometry.boxes import Box, corners, distance_to_point
from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.continuity import do_looks_match, screen_direction, side_of_line
from storyblender.geometry.framing import Figure, Film, project
from storyblender.geometry.orbit import Orbit
from storyblender.memory.measure import CameraView, SubjectView, ViewRequest
from storyblender.memory.scene_context import SceneSize
from storyblender.memory.shot_context import CameraInstruction, Flaw
from storyblender.memory.shot_sizes import SIZES

FILM = Film()


def figure(name: str, x: float, y: float, yaw: float, stature: float = 1.75) -> Figure:
    forward = (math.sin(math.radians(yaw)), -math.cos(math.radians(yaw)), 0.0)
    return Figure(name, (x, y, stature * 0.935), forward, 0.13 * stature, (x, y, 0))


ANNA, TOM, GUARD = figure("anna", -0.6, 0, 90, 1.65), figure("tom", 0.6, 0, -90, 1.85), figure("guard", 2, 1.5, 0)
TALK = {"axis": ("anna", "tom")}


class NumberFinder:
    """A viewfinder without pictures: sample points of boxes, rays against the other boxes."""

    def __init__(self, brief_moments: Sequence[Moment], props: dict[str, Box]) -> None:
        self.moments = {moment.frame: moment for moment in brief_moments}
        self.props, self.looks = props, 0

    def look(self, requests: Sequence[ViewRequest]) -> list[CameraView]:
        self.looks += len(requests)
        return [self._look(request) for request in requests]

    def _look(self, request: ViewRequest) -> CameraView:
        camera = orbit_of(request.pose, FILM)
        figures = self.moments[request.frame].figures
        solids = {f.node_id: Box(f.base[0], f.base[1], 0, 0.4, 0.3, f.face[2] + 0.1) for f in figures} | self.props
        solids = {node: box for node, box in solids.items() if node not in request.hidden_node_ids}
        faces = {f.node_id: f for f in figures if f.node_id in solids}
        wanted = [node for node in solids if node in faces or node in request.focus_ids]
        eye = camera.position
        inside = [
            node
            for node, box in solids.items()
            if box.z < eye[2] < box.top and distance_to_point(box, float(eye[0]), float(eye[1])) < 0.2
        ]
        return CameraView(
            subjects=tuple(self._subject(node, solids, faces.get(node), camera) for node in wanted),
            void=0.0,
            inside=tuple(inside),
            below_floor=float(eye[2]) < 0.08,
        )

    def _subject(self, node: str, solids: dict[str, Box], face: Figure | None, camera: Orbit) -> SubjectView:
        box = solids[node]
        across, up = np.linspace(-0.5, 0.5, 3), np.linspace(0, 1, 25)
        points = np.array(
            [(*box.to_world(u * box.width, v * box.depth), box.z + w * box.height)
             for u in across for v in across for w in up]
        )  # fmt: skip
        screen, depth = project(camera, points)
        framed = ((screen > 0) & (screen < 1)).all(1) & (depth > 0)
        others = [box for name, box in solids.items() if name != node]
        free = _free(camera.position, points, others)
        low, high = screen.min(0).clip(0, 1), screen.max(0).clip(0, 1)
        view = SubjectView(
            node_id=node,
            visible_fraction=float((framed & free).mean()),
            in_frame_fraction=float(framed.mean()),
            box=(low[0], low[1], high[0], high[1]) if framed.any() else None,
            pixels=float(np.prod(high - low)) if framed.any() else 0.0,
        )
        if face is None:
            return view
        centre = np.asarray(face.face)
        ends, near = project(camera, [centre + np.array([0, 0, up * face.head]) for up in (0.0, 0.55, -0.5)])
        way = camera.position - centre
        turned = float(np.dot(face.forward, way) / np.linalg.norm(way))
        shown = float(_free(camera.position, centre[None], others)[0])
        return view.model_copy(
            update={
                "face": tuple(ends[0]) if near[0] > 0 else None,
                "face_visible": shown,
                "head_height": float(ends[2, 1] - ends[1, 1]),
                "head_top": float(ends[1, 1]),
                "face_angle": math.degrees(math.acos(max(-1, min(1, turned)))),
            }
        )


def _free(eye: np.ndarray, points: np.ndarray, boxes: list[Box]) -> np.ndarray:
    """Return which points are seen from the eye past the boxes."""
    share = np.linspace(0.02, 0.97, 60)[:, None, None]
    rays = eye + (points - eye) * share
    cut = np.zeros(rays.shape[:2], bool)
    for box in boxes:
        dx, dy = rays[..., 0] - box.x, rays[..., 1] - box.y
        u, v = box.cos * dx + box.sin * dy, box.cos * dy - box.sin * dx
        within = (np.abs(u) < box.width / 2) & (np.abs(v) < box.depth / 2)
        cut |= within & (rays[..., 2] > box.z) & (rays[..., 2] < box.top)
    return ~cut.any(0)


def view_of(figures=(ANNA, TOM), props=None, moments=None, **more) -> CameraOperatorView:
    fields = {name: more.pop(name) for name in list(more) if name in CameraOperatorView.__dataclass_fields__}
    moments = moments or (Moment(0, tuple(figures)),)
    return CameraOperatorView(1, 1, CameraInstruction(**more), 48, moments, props=props or {}, film=FILM, **fields)


def shoot(view: CameraOperatorView) -> tuple[Orbit, tuple[Flaw, ...], NumberFinder]:
    finder = NumberFinder(view.moments, dict(view.props))
    state = operate(view, finder)
    return orbit_of(state.poses[0], FILM), state.residual, finder


def seen(camera: Orbit, who: Figure) -> np.ndarray:
    return project(camera, who.face)[0][0]


@pytest.mark.parametrize("size", ["EWS", "WS", "FS", "MWS", "MS", "MCU", "CU", "ECU"])
def test_singles_of_every_size_are_right_from_the_start(size: str) -> None:
    camera, residual, finder = shoot(view_of([ANNA], kind="single", size=size, focus_on_ids=("anna",)))
    assert residual == ()
    assert finder.looks <= 3
    chin_to_crown = np.array([[0, 0, 0.55 * ANNA.head], [0, 0, -0.5 * ANNA.head]]) + ANNA.face
    head = project(camera, chin_to_crown)[0][:, 1]
    assert SIZES[size].band[0] < head[1] - head[0] < SIZES[size].band[1]


@pytest.mark.parametrize("side", [1, -1])
def test_a_dialogue_stays_on_its_side_of_the_line(side: int) -> None:
    for kind, focus, over in (
        ("two_shot", ("anna", "tom"), None), ("ots", ("anna",), "tom"), ("ots", ("tom",), "anna"),
        ("single", ("anna",), None), ("single", ("tom",), None), ("reaction", ("anna",), None),
    ):  # fmt: skip
        view = view_of(kind=kind, size="MS", focus_on_ids=focus, over_id=over, side=side, **TALK)
        camera, residual, _ = shoot(view)
        # two people 1.2 m apart: a medium single cannot always leave the partner's arm out
        minor = ("the frame cuts", "anna stands aside", "tom stands aside")
        assert all(flaw.message.startswith(minor) for flaw in residual), (kind, focus, residual)
        assert side_of_line(camera.position, ANNA.face, TOM.face) in (side, 0)


def test_the_side_of_the_first_shot_is_handed_on() -> None:
    view = view_of(kind="two_shot", size="MS", focus_on_ids=("anna", "tom"), **TALK)
    state = operate(view, NumberFinder(view.moments, {}))
    assert camera_side(view, state) == -1, "the audience's side"


def test_reverse_singles_mirror_each_other() -> None:
    first = view_of(kind="single", size="MCU", focus_on_ids=("anna",), side=-1, **TALK)
    state = operate(first, NumberFinder(first.moments, {}))
    cut = EarlierShot(first.instruction, state)
    second = view_of(kind="single", size="MCU", focus_on_ids=("tom",), side=-1, reverse=cut, previous=cut, **TALK)
    one, other = orbit_of(state.poses[0], FILM), shoot(second)[0]
    assert do_looks_match(one, ANNA.forward, other, TOM.forward)
    assert seen(one, ANNA)[0] < 0.5 < seen(other, TOM)[0]
    assert one.azimuth == pytest.approx(-other.azimuth, abs=12)


def test_a_second_shot_of_the_same_size_moves_thirty_degrees() -> None:
    first = view_of([GUARD], kind="action", size="FS", focus_on_ids=("guard",))
    state = operate(first, NumberFinder(first.moments, {}))
    again = replace(first, previous=EarlierShot(first.instruction, state))
    camera, residual, _ = shoot(again)
    assert residual == ()
    turned = abs(camera.azimuth - orbit_of(state.poses[0], FILM).azimuth)
    assert min(turned, 360 - turned) > 25


def test_the_servo_walks_around_what_hides_the_subject() -> None:
    pillar = Box(-0.1, -1.3, 0, 0.6, 0.3, 2.5)
    view = view_of(
        [GUARD, figure("anna", 0, 0, 0)], {"pillar": pillar}, kind="single", size="MS", focus_on_ids=("anna",)
    )
    finder = NumberFinder(view.moments, dict(view.props))
    critic = CameraOperatorCritic(finder)
    straight = compose_take(view, turn=-compose_take(view).camera.azimuth)
    assert "hidden" in {fault.kind for fault in critic.judge(straight, view).faults}
    better = RulesCameraOperator(critic).refine(straight, critic.judge(straight, view), view)
    assert critic.judge(better, view).score > critic.judge(straight, view).score
    assert shoot(view)[1] == ()


@pytest.mark.parametrize(("angle", "low", "high"), [("high angle", 16, 55), ("low angle", -38, -6), ("dutch", -9, 14)])
def test_angles_are_kept(angle: str, low: float, high: float) -> None:
    camera, residual, _ = shoot(view_of([GUARD], kind="single", size="MS", focus_on_ids=("guard",), angle=angle))
    assert residual == ()
    assert low <= camera.elevation <= high
    assert (abs(camera.roll) > 8) == (angle == "dutch")


def test_a_point_of_view_hides_its_owner_and_looks_where_they_look() -> None:
    view = view_of(kind="pov", size="MS", focus_on_ids=("tom",), pov_id="anna")
    state = operate(view, NumberFinder(view.moments, {}))
    assert "anna" in state.hidden_node_ids
    camera = orbit_of(state.poses[0], FILM)
    assert np.linalg.norm(camera.position - ANNA.face) < 0.3
    assert seen(camera, TOM) == pytest.approx([0.5, 0.5], abs=0.05)


def test_an_insert_fills_the_frame_from_above() -> None:
    cup = {"cup": Box(0, 0, 0.75, 0.09, 0.09, 0.12)}
    camera, residual, _ = shoot(view_of([], cup, kind="insert", size="CU", focus_on_ids=("cup",)))
    assert residual == ()
    screen = project(camera, corners(cup["cup"]))[0]
    assert 0.4 < (screen.max(0) - screen.min(0)).max() < 0.75
    assert camera.elevation > 15


@pytest.mark.parametrize("movement", ["static", "pan", "track"])
def test_a_walk_keeps_its_walker_in_the_picture(movement: str) -> None:
    moments = tuple(Moment(frame, (figure("anna", x, 0.5, 90),)) for frame, x in ((0, -2.5), (24, 0.0), (47, 2.5)))
    view = view_of(moments=moments, kind="action", size="FS", focus_on_ids=("anna",), movement=movement)
    state = operate(view, NumberFinder(moments, {}))
    assert len(state.poses) == 2
    for pose, moment in zip(state.poses, (moments[0], moments[-1]), strict=True):
        x, y = seen(orbit_of(pose, FILM), moment.figures[0])
        assert 0.1 < x < 0.9 and 0 < y < 0.6
    camera = orbit_of(state.poses[0], FILM)
    assert (seen(camera, moments[0].figures[0])[0] < 0.5) == (screen_direction(camera, (1, 0, 0)) > 0), "lead room"


def test_a_plain_move_is_centred_on_the_composition() -> None:
    view = view_of([GUARD], kind="single", size="MS", focus_on_ids=("guard",), movement="pan", direction="left")
    state = operate(view, NumberFinder([Moment(0, (GUARD,))], {}))
    first, last = (seen(orbit_of(pose, FILM), GUARD)[0] for pose in state.poses)
    assert first < seen(compose_take(view).camera, GUARD)[0] < last, "panning left, the subject goes from left to right"


def test_walls_in_the_way_are_taken_away_and_only_those() -> None:
    points = ((-2, -2), (2, -2), (2, 2), (-2, 2))
    walls = tuple(
        Wall(node_id=f"wall_{name}", start=start, end=end, height=2.6, material="plaster")
        for name, start, end in zip(("front", "right", "back", "left"), points, (*points[1:], points[0]), strict=True)
    )
    plan = SetPlan(kit="room", indoor=True, size=SceneSize(x=2, x_negative=-2, y=2, y_negative=-2), walls=walls)
    view = view_of(kind="two_shot", size="FS", focus_on_ids=("anna", "tom"), plan=plan, **TALK)
    assert compose_take(view).hidden == ("wall_front",)
    shelf = {"shelf_1": Box(0, -1.8, 0, 1.6, 0.3, 2.0)}
    assert compose_take(replace(view, props=shelf)).hidden == ("wall_front", "shelf_1")
    assert compose_take(replace(view, props=shelf, used=("shelf_1",))).hidden == ("wall_front",), "somebody works at it"
    tight = view_of([figure("anna", 0, 1, 0)], kind="single", size="CU", focus_on_ids=("anna",), lens=50.0, plan=plan)
    assert compose_take(tight).hidden == ()


def test_the_same_brief_gives_the_same_camera() -> None:
    view = view_of(kind="ots", size="MCU", focus_on_ids=("anna",), over_id="tom", **TALK)
    assert operate(view, NumberFinder(view.moments, {})) == operate(view, NumberFinder(view.moments, {}))
