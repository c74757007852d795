"""Whom the script shows from behind is seen from behind, and nobody asks for the face."""

from __future__ import annotations

from dataclasses import replace

import pytest
from test_camera_room import person, view_of

from storyblender.agents.director.camera_phrases import from_behind
from storyblender.agents.layout_artist.camera_operator_view import Moment
from storyblender.agents.layout_artist.camera_scout import scout_takes
from storyblender.agents.layout_artist.camera_start import compose_take
from storyblender.geometry.framing import project


@pytest.mark.parametrize("yaw", [0, 90, 180])
@pytest.mark.parametrize("size", ["FS", "MS"])
def test_a_back_that_the_script_asks_for_is_shown(yaw: int, size: str) -> None:
    anna = person("anna", 0.0, 0.0, yaw)
    wish = {"kind": "action", "size": size, "focus_on_ids": ("anna",)}
    for behind in (False, True):
        view = replace(view_of(anna, in_frame=("anna",), behind=behind, **wish), plan=None)
        turned = anna.turned_from(scout_takes(view)[0].camera.position)
        assert (turned > 120) == behind


@pytest.mark.parametrize(
    ("words", "behind"),
    [
        ("Tom at the window, his back to us.", True),
        ("ANNA, seen from behind.", True),
        ("Her back is turned to the camera as she sings.", True),
        ("A dog jumps out from behind the shed.", False),
        ("He has his back to the wall.", False),
        ("A voice from behind the door.", False),
        ("She comes back to us.", False),
    ],
)
def test_the_words_for_a_back(words: str, behind: bool) -> None:
    assert from_behind(words) == behind


@pytest.mark.parametrize("drop", [0.55, 0.7, 0.9])
def test_who_crouches_has_the_face_in_the_upper_half_of_a_medium_shot(drop: float) -> None:
    up = person("anna", 0.0, 0.0, 0)
    down = replace(up, face=(0.0, 0.0, up.face[2] - drop))
    view = view_of(down, in_frame=("anna",), kind="single", size="MS", focus_on_ids=("anna",))
    view = replace(view, moments=(Moment(0, (up,)), Moment(20, (down,)), Moment(47, (down,))), plan=None)
    (face,), _ = project(compose_take(view).camera, [down.face])
    assert face[1] < 0.5
