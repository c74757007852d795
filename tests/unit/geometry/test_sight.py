from storyblender.geometry.boxes import Box
from storyblender.geometry.sight import find_hidden

WALL = Box(0, 2, 0, 1, 0.2, 2, 0.0)


def test_a_box_hides_what_is_behind_it_and_nothing_else() -> None:
    points = [(0, 4, 1), (0, 1, 1), (2, 4, 1), (0, 4, 5)]
    assert list(find_hidden([WALL], (0, 0, 1), points)) == [True, False, False, False]
    assert list(find_hidden([], (0, 0, 1), points)) == [False] * 4


def test_a_turned_box_hides_where_it_is_turned_to() -> None:
    turned = Box(0, 2, 0, 1, 0.2, 2, 1.5708)
    assert list(find_hidden([turned], (0, 0, 1), [(0.6, 4, 1)])) == [False]
    assert list(find_hidden([WALL], (0, 0, 1), [(0.6, 4, 1)])) == [True]


def test_what_somebody_leans_at_does_not_hide_them() -> None:
    eye, back = (0, 0, 1), (0, 1.95, 1)
    assert find_hidden([WALL], eye, [back], spare=0.0)[0]
    assert not find_hidden([WALL], eye, [back], spare=0.3)[0]
    assert find_hidden([WALL], eye, [(0, 2.6, 1)], spare=0.3)[0]
