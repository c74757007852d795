"""Panels of vehicles are hidden for a near camera that they would stop from seeing what is inside, and only then."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.agents.layout_artist.vehicle_panels import find_hidden_panels, panel_boxes
from storyblender.geometry.boxes import Box
from storyblender.geometry.orbit import Orbit, camera_looking_at
from storyblender.memory.asset_sheet import Anchor

FACE, FEET = np.array([0.4, -0.4, 1.2]), np.array([0.4, -0.9, 0.35])
_ANCHORS = (
    Anchor(kind="panel", name="roof", location=(0.0, 0.3, 1.43), size=(1.4, 1.4), clearance=0.12),
    Anchor(kind="panel", name="door_driver", location=(0.85, -0.4, 0.27), size=(0.2, 1.1), clearance=0.67),
    Anchor(kind="panel", name="post_windscreen_left", location=(0.78, -0.9, 0.94), size=(0.28, 0.5), clearance=0.5),
    Anchor(kind="part", name="mirror", location=(0.0, -0.3, 1.3), size=(0.24, 0.05), clearance=0.09),
    Anchor(kind="seat", name="driver", location=(0.4, -0.4, 0.47)),
)
PANELS = panel_boxes("car", (0.0, 0.0, 0.0), 0.0, _ANCHORS)


def _camera(eye: tuple[float, float, float], target: np.ndarray) -> Orbit:
    return camera_looking_at(eye, tuple(float(v) for v in target), 50.0)


def _hidden(eye: tuple[float, float, float], target: np.ndarray, *subjects: Box) -> set[str]:
    return {*find_hidden_panels(PANELS, [_camera(eye, target)], [target], subjects)}


def test_only_panels_and_parts_can_be_hidden() -> None:
    assert {*PANELS} == {"car_roof", "car_door_driver", "car_post_windscreen_left", "car_mirror"}


@pytest.mark.parametrize(
    ("eye", "target", "gone"),
    [
        ((3.0, -0.4, 1.2), FACE, set()),
        ((3.0, -0.9, 0.6), FEET, {"car_door_driver"}),
        ((0.4, -0.2, 3.0), FACE, {"car_roof"}),
        ((1.6, -1.6, 1.25), FACE, {"car_post_windscreen_left"}),
        ((12.0, -11.0, 6.0), FACE, set()),
    ],
)  # fmt: skip
def test_what_is_in_the_way_is_hidden(eye: tuple[float, float, float], target: np.ndarray, gone: set[str]) -> None:
    assert _hidden(eye, target) == gone


def test_what_the_shot_is_about_stays() -> None:
    mirror = PANELS["car_mirror"]
    eye, target = (0.0, 0.5, 1.305), np.array([0.0, -1.0, 1.305])
    assert _hidden(eye, target) == {"car_mirror"}
    assert _hidden(eye, target, mirror) == set()


def test_panels_turn_with_their_vehicle() -> None:
    turned = panel_boxes("car", (5.0, 1.0, 0.0), 90.0, _ANCHORS)["car_door_driver"]
    assert (turned.x, turned.y) == (pytest.approx(5.4), pytest.approx(1.85))


def test_an_open_door_is_beside_the_vehicle() -> None:
    shut, ajar = PANELS["car_door_driver"], panel_boxes("car", (0.0, 0.0, 0.0), 0.0, _ANCHORS, ("driver",))
    swung = ajar["car_door_driver"]
    assert swung.x > shut.x + 0.3 and swung.y < shut.y and swung.yaw == pytest.approx(-np.radians(62))
    hinge = swung.to_world(0.0, -swung.depth / 2)
    assert hinge == pytest.approx((shut.x, shut.y - shut.depth / 2), abs=0.01)
