"""Cameras corrupted by seed, and the operations that a naive correction draws."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.camera_servo import count_faults
from benchmarks.corrupted_cameras import CORRUPTIONS, corrupted_camera
from tests.every import every

from storyblender.geometry.orbit import Orbit, camera_around
from storyblender.reflection import Critique, Fault

CAMERAS = [
    camera_around((1.0, -2.0, 1.5), azimuth, elevation, distance, lens)
    for azimuth in (-120.0, 0.0, 50.0)
    for elevation in (-10.0, 5.0, 30.0)
    for distance, lens in ((1.0, 85.0), (5.0, 28.0))
]
CHANGES = {"orbited": "azimuth", "panned": "pivot", "zoomed": "distance", "raised": "elevation", "rolled": "roll"}
"""What each corruption changes; everything else stays."""


def state(camera: Orbit) -> dict[str, object]:
    names = ("azimuth", "elevation", "roll", "distance", "lens", "sensor_width", "aspect", "pivot")
    return {name: pytest.approx(getattr(camera, name), abs=1e-6) for name in names}


@every("kind seed", [(kind, seed) for kind in CORRUPTIONS for seed in range(8)])
def test_a_corruption_changes_its_own_part_of_a_camera_and_is_drawn_by_seed(kind: str, seed: int) -> None:
    for camera in CAMERAS:
        broken = corrupted_camera(camera, kind, seed)
        assert broken == corrupted_camera(camera, kind, seed) != corrupted_camera(camera, kind, seed + 1)
        changed = {name for name, value in state(camera).items() if getattr(broken, name) != value}
        assert changed == ({CHANGES[kind]} if kind in CHANGES else {*CHANGES.values()})
        moved = np.subtract(broken.pivot, camera.pivot)
        assert kind == "all at once" or abs(moved @ camera.axes[:, 2]) < 1e-9, "a pan stays in the picture"


def test_faults_are_counted_by_row() -> None:
    told = (Fault(kind="cropped", message=""), Fault(kind="beheaded", message=""), Fault(kind="jump", message=""))
    assert count_faults(Critique.of(told)) == {"cut off": 2, "other": 1}
