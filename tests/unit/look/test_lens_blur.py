"""Blur on painted cards at known depths: each property is seen in the pixels."""

import numpy as np
import pytest
from numpy.typing import NDArray

from storyblender.look.lens_blur import blurred, blurred_frame, diffused, disc_blur
from storyblender.look.optics import Lens

SIZE = (120, 160)
NEAR, MIDDLE, FAR = 1.0, 2.2, 12.0
RED, GREEN = np.array([1.0, 0, 0], np.float32), np.array([0, 1.0, 0], np.float32)
CARD = np.s_[:, 40:80]


def stage(card: float, behind: float) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return a green backdrop with fine stripes and a plain red card before it, and their depths."""
    picture = np.full((*SIZE, 3), GREEN, np.float32)
    picture[::2] *= np.float32(0.5)
    depth = np.full(SIZE, behind, np.float32)
    picture[CARD], depth[CARD] = RED, card
    return picture, depth


def seen(card: float, behind: float, focus: float, f_number: float = 2.0) -> NDArray[np.float32]:
    picture, depth = stage(card, behind)
    return blurred_frame(picture, None, depth, Lens(85, f_number, focus), 1)[0]


@pytest.mark.parametrize("radius", [0.7, 1.2, 3.7, 5.2, 7.4, 15.0, 30.0])
def test_a_point_becomes_a_disc_of_its_radius_with_all_its_light(radius: float) -> None:
    point = np.zeros((160, 160, 1), np.float32)
    point[80, 80] = 1
    disc = disc_blur(point, radius)[..., 0]
    rows, columns = np.mgrid[:160, :160]
    away = np.hypot(rows - 80, columns - 80)
    assert disc.sum() == pytest.approx(1, abs=1e-4)
    spread = np.sqrt((disc * away**2).sum() * 2)  # of a disc the mean square distance is half its radius squared
    assert spread == pytest.approx(radius, abs=0.3 + 0.06 * radius)


def test_what_is_in_focus_stays_and_nothing_bleeds_between_it_and_a_blurred_background() -> None:
    picture, _ = stage(MIDDLE, FAR)
    out = seen(MIDDLE, FAR, MIDDLE)
    assert np.array_equal(out[CARD], picture[CARD])
    assert out[:, :40, 0].max() < 1e-3 and out[:, 80:, 0].max() < 1e-3
    assert np.ptp(out[40:80, 100:140, 1]) < 0.05 < np.ptp(picture[40:80, 100:140, 1])


def test_a_blurred_foreground_spreads_over_a_sharp_background_and_is_seen_through_at_its_edge() -> None:
    picture, _ = stage(NEAR, MIDDLE)
    out = seen(NEAR, MIDDLE, MIDDLE)
    middle = out[60]
    assert 0.05 < middle[38, 0] < 0.5 < middle[43, 0] < 1
    assert np.array_equal(out[:, 140:], picture[:, 140:])
    assert (out.sum(axis=2)[:, 40:80] > 0.45).all()  # nothing dark where the background is guessed


def test_a_slope_has_no_cracks() -> None:
    flat = np.ones((*SIZE, 1), np.float32)
    radius = np.tile(np.linspace(-20, 20, SIZE[1], dtype=np.float32), (SIZE[0], 1))
    assert np.abs(blurred(flat, radius) - 1).max() < 1e-3


def test_a_closed_aperture_costs_nothing_and_lines_go_with_the_nearer_surface() -> None:
    picture, depth = stage(MIDDLE, FAR)
    assert blurred_frame(picture, None, depth, Lens(85, 64, 5.0), 1)[0] is not None
    flat = np.full(SIZE, 5.0, np.float32)
    assert blurred_frame(picture, None, flat, Lens(85, 2, 5.0), 1)[0] is picture
    lines = np.zeros(SIZE, np.float32)
    lines[:, 39], lines[:, 120] = 1, 1  # the outer half of the card's outline, and a line on the backdrop
    out = blurred_frame(picture, lines, depth, Lens(85, 2, MIDDLE), 1)[1]
    assert out is not None and out[60, 39] > 0.99 and out[60, 120] < 0.3


def test_a_patch_with_room_round_it_is_as_in_the_whole_picture() -> None:
    picture, depth = stage(MIDDLE, FAR)
    radius = Lens(50, 4.0, MIDDLE).blur_circle(depth) * np.float32(80)
    whole, part = blurred(picture, radius), blurred(picture[20:100], radius[20:100])
    assert np.abs(whole[44:76] - part[24:56]).max() < 1e-3


def test_soft_focus_glows_round_what_is_bright_and_keeps_its_edges() -> None:
    dark = np.zeros((*SIZE, 3), np.uint8)
    dark[40:80, 60:100] = 230
    soft = diffused(dark).astype(int)
    assert soft[60, 58].min() > 20 and soft[60, 10].max() == 0
    assert soft[60, 60].min() - soft[60, 59].max() > 80
