"""Things that people have, and things of inserts: what is framed with whom, and what goes that covers them."""

from __future__ import annotations

import math

from storyblender.agents.layout_artist.camera_furniture import find_covers
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment
from storyblender.agents.layout_artist.camera_scene import _handling_cues
from storyblender.agents.layout_artist.camera_scout import scout_takes
from storyblender.agents.layout_artist.camera_start import compose_take
from storyblender.geometry.boxes import Box, corners
from storyblender.geometry.framing import Figure, project
from storyblender.memory.shot_context import CameraInstruction, Cue, ShotContext


def _person(name: str, x: float, face: float = 1.6) -> Figure:
    return Figure(name, (x, 0.0, face), (0.0, -1.0, 0.0), 0.23, (x, 0.0, 0.0))


def _view_of(people: tuple[Figure, ...], props: dict[str, Box], **camera: object) -> CameraOperatorView:
    moments = tuple(Moment(frame, people) for frame in (0, 12, 24))
    return CameraOperatorView(1, 1, CameraInstruction.model_validate(camera), 24, moments, props=props)


def test_a_thing_is_with_who_took_it_until_it_is_laid_down() -> None:
    took = Cue(asset_id="ann", clip="pick_up", start=5, prop_id="letter")
    reads = Cue(asset_id="ann", clip="read", start=20, prop_id="letter")
    lays = Cue(asset_id="ann", clip="put_down", start=40, prop_id="letter")
    shot = ShotContext(
        scene_id=1, shot_id=1, cues=(took, reads, lays), camera_instruction=CameraInstruction(size="MS")
    )  # fmt: skip
    assert _handling_cues(shot, 0) == []
    assert _handling_cues(shot, 30) == [took], "what is done with it does not take it out of the hand"
    assert _handling_cues(shot, 50) == []


def test_an_ordered_close_shot_of_two_holds_both_heads_tall_and_small() -> None:
    people = (_person("ann", 0.0), _person("child", 0.6, 1.1))
    for explicit in (True, False):
        view = _view_of(people, {}, size="MCU", kind="action", explicit=explicit, focus_on_ids=("ann", "child"))
        assert view.focus == (("ann", "child") if explicit else ("ann",))
    view = _view_of(people, {}, size="CU", kind="action", explicit=True, focus_on_ids=("ann", "child"))
    ends = [point for each in people for point in (each.crown, (*each.face[:2], each.face[2] - 0.1))]
    screen, _ = project(compose_take(view).camera, ends)
    assert screen.min() > 0 and screen.max() < 1


def test_a_close_shot_of_somebody_with_a_thing_in_hand_holds_both() -> None:
    watch = Box(0.2, -0.25, 1.15, 0.06, 0.06, 0.06)
    view = _view_of((_person("ann", 0.0),), {"watch": watch}, size="CU", kind="single", focus_on_ids=("watch", "ann"))
    screen, _ = project(compose_take(view).camera, [*corners(watch), view.people[0].face])
    assert screen.min() > 0 and screen.max() < 1


def test_the_insert_of_a_thing_in_a_desk_may_do_without_the_desk_and_shows_its_front() -> None:
    desk, screen = Box(0.0, 0.0, 0.0, 1.6, 0.8, 0.76), Box(0.3, 0.0, 0.1, 0.34, 0.3, 0.23)
    view = _view_of((), {"desk": desk, "laptop": screen}, size="CU", kind="insert", focus_on_ids=("laptop",))
    assert find_covers(view) == ["desk"]
    takes = scout_takes(view)
    first = takes[0]
    assert any("desk" in take.hidden for take in takes)
    assert abs(math.remainder(first.camera.azimuth - math.degrees(screen.yaw), 360)) < 60
