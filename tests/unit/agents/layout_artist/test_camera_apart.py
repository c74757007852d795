"""Two who are far apart are seen along their line, or one of them alone; never at the sides of an empty middle."""

from __future__ import annotations

from dataclasses import replace

import pytest
from test_camera_room import person, view_of

from storyblender.agents.layout_artist.camera_scout import scout_takes
from storyblender.geometry.framing import head_share, project
from storyblender.geometry.gaps import MAX_FACE_GAP, widest_face_gap


@pytest.mark.parametrize("apart", [1.2, 2.0, 2.5])
def test_two_who_are_apart_are_near_each_other_in_the_picture(apart: float) -> None:
    pair = person("anna", -apart / 2, 0.0, 90), person("tom", apart / 2, 0.0, -90)
    wish = {"kind": "action", "size": "MS", "focus_on_ids": ("anna", "tom")}
    view = replace(view_of(*pair, in_frame=("anna", "tom"), **wish), plan=None)
    camera = scout_takes(view)[0].camera
    across = project(camera, [each.face for each in pair])[0][:, 0]
    faces = [(float(x), head_share(camera, each)) for x, each in zip(across, pair, strict=True)]
    assert widest_face_gap(faces, camera.aspect) < MAX_FACE_GAP + 1.5


@pytest.mark.parametrize(
    ("kind", "explicit", "held"), [("two_shot", False, 1), ("action", False, 1), ("action", True, 2)]
)
def test_who_is_too_far_off_for_the_size_is_left_out_unless_the_script_orders_it(
    kind: str, explicit: bool, held: int
) -> None:
    pair = person("anna", -2.0, 0.0, 90), person("tom", 2.0, 0.0, -90)
    wish = {"kind": kind, "size": "MS", "focus_on_ids": ("anna", "tom"), "explicit": explicit}
    assert len(view_of(*pair, in_frame=("anna", "tom"), **wish).people) == held
