"""Which copy of a picture is seen at a distance."""

from __future__ import annotations

import numpy as np
import pytest

from storyblender.look.far_textures import halvings, shares
from storyblender.look.gbuffer import View


def test_shares_sum_to_one_and_go_from_the_whole_picture_to_its_mean() -> None:
    wanted = np.linspace(-3, 12, 301, dtype=np.float32)
    found = np.stack(shares(wanted))
    assert found.sum(axis=0) == pytest.approx(1) and found.min() >= 0
    assert found[0][wanted <= 0] == pytest.approx(1) and found[-1][wanted >= 7] == pytest.approx(1)
    assert np.abs(np.diff(found, axis=1)).max() < 0.03, "no copy comes or goes at once"
    places = (found * np.arange(len(found))[:, None]).sum(axis=0)
    assert (np.diff(places) >= -1e-6).all()


def test_a_picture_is_halved_more_the_farther_and_the_more_slanted_it_is() -> None:
    view = View(np.zeros(3), np.eye(3), 64, 36, 0.8, 0.45)  # 40 pixels to the metre, a metre away
    middle = np.array([18, 18, 18]), np.array([32, 32, 32])
    normal = np.array([(0, 0, 1), (0, 0, 1), (0.97, 0, 0.243)], np.float32)
    depth = np.array([1, 8, 8], np.float32)
    near, far, slanted = halvings(np.full(3, 40, np.float32), depth, normal, *middle, view)
    assert far - near == pytest.approx(3, abs=0.01) and 0 <= near <= 1
    assert slanted - far == pytest.approx(1, abs=0.1)
