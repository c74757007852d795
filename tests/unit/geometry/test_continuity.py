from storyblender.geometry.continuity import walked_around

BEFORE = ((0.0, 0.0, 1.6), (2.0, 0.0, 1.6))


def test_who_has_walked_around_another_draws_a_new_line():
    assert not walked_around(BEFORE, ((0.5, 1.0, 1.6), (2.0, 0.0, 1.2)))
    assert walked_around(BEFORE, ((1.5, 1.0, 1.6), (2.0, 0.0, 1.2)))
    assert walked_around(BEFORE, BEFORE[::-1])
