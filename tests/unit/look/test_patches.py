"""Ground that varies over metres."""

import numpy as np
from traced_frame import FLOOR, gbuffer

from storyblender.look.patches import ground_patches

FRAME = gbuffer(96, 54)


def test_ground_varies_and_nothing_else_does():
    factors = ground_patches(FRAME, FRAME.positions())[..., 0]
    ground = factors[FRAME.ids == FLOOR]
    assert 0.08 < ground.std() < 0.4
    assert abs(ground.mean() - 1) < 0.2
    assert (factors[FRAME.ids != FLOOR] == 1).all()


def test_a_place_looks_the_same_from_everywhere():
    places = FRAME.positions()
    first, again = ground_patches(FRAME, places), ground_patches(FRAME, places[:, ::-1])
    level = (FRAME.ids == FLOOR) & (FRAME.ids == FLOOR)[:, ::-1]
    assert np.allclose(first[level], again[:, ::-1][level])
