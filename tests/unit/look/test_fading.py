"""Repeated patterns fade where pixels cannot tell them."""

import numpy as np

from storyblender.catalog.materials import MATERIALS
from storyblender.look.fading import fade_repeats
from storyblender.look.gbuffer import View

WIDE = View(np.zeros(3), np.eye(3), 64, 36, 0.8, 0.45)
BRICK, PLASTER = 1, 2


def contrast(depth, material=BRICK, normal=(0.0, 0.0, 1.0), view=WIDE):
    """Return what is left of a checkered wall's contrast, 0 to 1."""
    shape = (view.height, view.width)
    checkered = np.indices(shape).sum(axis=0) % 2 * 0.4 + 0.1
    albedo = np.repeat(checkered[..., None], 3, axis=2).astype(np.float16)
    fade_repeats(
        albedo,
        np.full(shape, material, np.uint16),
        np.full(shape, depth, np.float32),
        np.broadcast_to(np.float16(normal), (*shape, 3)),
        view,
        np.float32([0, 0.1, 0]),
        np.full((3, 3), 0.3, np.float32),
    )
    assert abs(albedo.mean() - 0.3) < 0.01
    return float(np.ptp(albedo) / 0.4)


def test_a_brick_wall_is_whole_near_by_and_nearly_plain_far_off():
    near, farther, far = (contrast(depth) for depth in (0.4, 0.8, 20.0))
    assert near > 0.99
    assert 0.2 < farther < 0.9
    assert 0.05 < far < 0.2


def test_what_does_not_repeat_stays_as_it_is():
    assert contrast(20.0, PLASTER) > 0.99


def test_a_pattern_seen_at_a_slant_fades_sooner():
    assert contrast(0.6, normal=(0.0, 0.97, 0.24)) < contrast(0.6) - 0.1


def test_more_pixels_show_more_of_it():
    fine = View(WIDE.eye, WIDE.axes, 128, 72, WIDE.half_width, WIDE.half_height)
    assert contrast(0.9, view=fine) > contrast(0.9) + 0.1


def test_the_catalog_knows_how_far_one_brick_is_from_the_next():
    assert abs(MATERIALS["brick"].repeat - 1.1 / 12) < 1e-6
    assert MATERIALS["stone"].repeat == 2.2 / 5, "its own number of courses"
    assert MATERIALS["sand"].repeat == MATERIALS["glass"].repeat == 0
