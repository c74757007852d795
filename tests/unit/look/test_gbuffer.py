import numpy as np
import pytest
from traced_frame import view

from storyblender.look.gbuffer import same_view
from storyblender.look.raster import Window, any_of, windows_round
from storyblender.look.relight import upsample_by_depth

WINDOW = Window(6, 10, 40, 60)


def test_a_part_of_a_view_sees_the_same_rays():
    whole = view()
    part = whole.cropped(WINDOW)
    assert (part.height, part.width) == WINDOW.shape
    assert part.rays() == pytest.approx(whole.rays()[WINDOW.cut], abs=1e-6)
    column, row, _ = part.project(np.array([0.3, 4.0, 1.5]))
    across, down, _ = whole.project(np.array([0.3, 4.0, 1.5]))
    assert (column + WINDOW.left, row + WINDOW.top) == pytest.approx((across, down))
    assert whole.cropped(whole.whole).shift == pytest.approx(whole.shift) and same_view(
        whole, whole.cropped(whole.whole)
    )
    assert not same_view(whole, part)


def test_bodies_beside_and_behind_are_missed():
    corners = np.array([[x, y, z] for x in (-0.2, 0.2) for y in (-0.2, 0.2) for z in (-0.2, 0.2)])
    places = np.array([(0, 4, 1.6), (9, 4, 1.6), (0, -4, 1.6), (0, 4, 9), (2.1, 4, 1.6)])
    assert view().misses(corners + places[:, None]).tolist() == [False, True, True, True, False]


def test_the_rim_of_a_window_is_kept_at_the_edge_of_the_picture():
    assert Window(0, 10, 40, 96).inner(3, 54, 96) == Window(0, 13, 37, 96)
    assert Window(3, 5, 20, 30).enlarged(2) == Window(6, 10, 40, 60)
    assert Window(8, 12, 20, 30).within(Window(6, 10, 40, 60)) == Window(2, 2, 14, 20)


def test_light_of_one_depth_stays_on_it():
    low_depth = np.repeat(np.array([[2.0, 2.0, 8.0, 8.0]], np.float32), 4, axis=0)
    light = np.where(low_depth < 4, 1.0, 0.0).astype(np.float32)[None]
    depth = np.repeat(np.repeat(low_depth, 2, axis=0), 2, axis=1)
    high = upsample_by_depth(light, low_depth, depth)[0]
    assert high.shape == depth.shape
    assert high[depth < 4] == pytest.approx(1, abs=1e-3) and high[depth > 4] == pytest.approx(0, abs=1e-3)


def test_windows_lie_round_what_is_set_and_part_where_it_lies_apart():
    mask = np.zeros((60, 100), bool)
    mask[5:10, 10:14] = mask[8:20, 12:16] = True
    mask[40:44, 70:80] = True
    assert windows_round(mask, 2) == [Window(3, 8, 22, 18), Window(38, 68, 46, 82)]
    assert windows_round(mask, 2, gap=90) == [Window(3, 8, 46, 82)]
    assert windows_round(np.zeros((4, 4), bool), 2) == []
    assert windows_round(np.ones((4, 6), bool), 2) == [Window(0, 0, 4, 6)]


def test_a_block_is_set_where_one_of_its_pixels_is():
    mask = np.zeros((4, 6), bool)
    mask[1, 2] = True
    assert any_of(mask, 2).tolist() == [[False, True, False], [False, False, False]]
