"""Depth of field against the textbook."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from storyblender.look.optics import SHARP, Lens, stopped_down

LENSES = st.builds(
    Lens,
    length=st.floats(12, 300),
    f_number=st.floats(0.7, 32),
    focus=st.floats(1, 50),
    sensor_width=st.floats(10, 70),
)


@given(LENSES, st.floats(0.5, 1000))
def test_blur_is_the_image_of_a_point_cut_by_the_plane_of_the_sensor(lens: Lens, depth: float) -> None:
    """From the thin lens equation alone: rays through the aperture meet behind or before the sensor."""
    length = lens.length / 1000
    aperture = length / lens.f_number
    sensor, image = (1 / (1 / length - 1 / away) for away in (lens.focus, depth))
    circle = aperture * (sensor - image) / image / (lens.sensor_width / 1000)
    assert float(lens.blur_circle(np.array([depth]))[0]) == pytest.approx(circle, rel=2e-3, abs=1e-6)


@given(LENSES)
def test_what_is_nearer_or_farther_is_told_by_the_sign_and_the_focus_is_sharp(lens: Lens) -> None:
    near, sharp, far, sky = lens.blur_circle(np.array([lens.focus * 0.9, lens.focus, lens.focus * 1.1, 1e4])).tolist()
    assert near < 0 < far < sky and abs(sharp) < 1e-6


@given(LENSES, st.lists(st.floats(1, 30), max_size=4))
def test_stopping_down_never_opens_the_lens_and_leaves_all_sharp(lens: Lens, depths: list[float]) -> None:
    stopped = stopped_down(lens, depths)
    if stopped is not None:
        assert stopped.f_number >= lens.f_number
        assert all(abs(each) <= SHARP / 36 + 1e-9 for each in stopped.blur_circle(np.array(depths)))
    else:
        assert depths and max(abs(lens.blur_circle(np.array(depths)))) > SHARP / 36
    assert stopped is None or stopped.f_number == lens.f_number or math.log2(stopped.f_number) <= 4
