from storyblender.geometry.continuity import has_new_line

BEFORE = ((0.0, 0.0, 1.6), (2.0, 0.0, 1.6))


def test_who_has_walked_around_another_draws_a_new_line():
    assert not has_new_line(BEFORE, ((0.5, 1.0, 1.6), (2.0, 0.0, 1.2)))
    assert has_new_line(BEFORE, ((1.5, 1.0, 1.6), (2.0, 0.0, 1.2)))
    assert has_new_line(BEFORE, BEFORE[::-1])
