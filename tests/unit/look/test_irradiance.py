"""Irradiance from a panorama against what brute force sums."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.panoramas import sky

from storyblender.look.irradiance import (
    irradiance_at,
    irradiance_of,
    mean_irradiance,
    panorama_directions,
    solid_angles,
    turned,
)

_PLACES = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda place: np.linalg.norm(place) > 0.1)


def _unit(place: tuple[float, float, float]) -> np.ndarray:
    return np.array(place) / np.linalg.norm(place)


def _brute_force(picture: np.ndarray, normal: np.ndarray) -> np.ndarray:
    height, width = picture.shape[:2]
    facing = np.maximum(panorama_directions(height, width) @ normal, 0) * solid_angles(height, width)
    return (picture * facing[..., None]).sum(axis=(0, 1)) / np.pi


def _at(coefficients: np.ndarray, normal: np.ndarray) -> np.ndarray:
    return irradiance_at(coefficients.tolist(), normal[None, None].astype(np.float32))[0, 0]


@settings(max_examples=60, deadline=None)
@given(place=_PLACES, lobe=_PLACES, sharpness=st.floats(0, 2), color=st.tuples(*[st.floats(0, 4)] * 3))
def test_a_smooth_sky_gives_every_normal_what_brute_force_sums(place, lobe, sharpness, color) -> None:
    toward = panorama_directions(48, 96)
    glow = np.exp(sharpness * (toward @ _unit(lobe) - 1))[..., None]
    picture = (0.2 + glow * np.array(color)).astype(np.float32)
    coefficients, normal = irradiance_of(picture), _unit(place)
    expected = _brute_force(picture, normal)
    # Nine coefficients keep 98 % of a distant point's irradiance in the mean (section 3.2); a smooth lobe's far better.
    assert _at(coefficients, normal) == pytest.approx(expected, rel=0.03, abs=0.01)


@given(place=_PLACES, color=st.tuples(*[st.floats(0, 10)] * 3))
def test_an_even_panorama_gives_every_normal_its_own_colour(place, color) -> None:
    coefficients = irradiance_of(np.broadcast_to(np.array(color, np.float32), (32, 64, 3)))
    assert _at(coefficients, _unit(place)) == pytest.approx(color, rel=2e-3, abs=1e-4)
    assert mean_irradiance(coefficients) == pytest.approx(color, rel=1e-4, abs=1e-6)


@given(place=_PLACES, yaw=st.floats(-180, 180))
def test_a_turned_panorama_lights_a_turned_surface_as_before(place, yaw) -> None:
    coefficients, normal, angle = irradiance_of(sky(64, sun=None)), _unit(place), np.radians(yaw)
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    assert _at(turned(coefficients, yaw), turn @ normal) == pytest.approx(_at(coefficients, normal), abs=1e-3)


def test_rolling_the_picture_is_turning_it() -> None:
    picture = sky(64, sun=None)
    # The azimuth falls from left to right: a quarter turn counter-clockwise moves the picture a quarter to the left.
    assert irradiance_of(np.roll(picture, -16, axis=1)) == pytest.approx(turned(irradiance_of(picture), 90), abs=1e-3)


def test_the_pixels_of_a_panorama_are_the_whole_sphere() -> None:
    assert solid_angles(32, 64).sum() * 64 == pytest.approx(4 * np.pi)
    assert np.linalg.norm(panorama_directions(32, 64), axis=-1) == pytest.approx(1)
