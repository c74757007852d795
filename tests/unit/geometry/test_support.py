from storyblender.geometry.relations import StandingSurface
from storyblender.geometry.support import OpenTop, Taken, choose_perch

DESK = OpenTop(StandingSurface(0, -0.05, 0.76, 1.2, 0.4))
MIRROR_EDGE = OpenTop(StandingSurface(0, 0.22, 1.65, 0.8, 0.04))
DRAWER = OpenTop(StandingSurface(0.4, 0, 0.2, 0.3, 0.4), clearance=0.05)
JEWEL_BOX = (0.2, 0.14, 0.1)


def test_the_desk_is_chosen_not_the_mirrors_edge() -> None:
    chosen = choose_perch([MIRROR_EDGE, DRAWER, DESK], JEWEL_BOX, wish=(0, 0.22))
    assert chosen is not None
    assert chosen.surface == DESK.surface
    assert chosen.coverage == 1


def test_low_shelves_are_left_to_flat_things() -> None:
    assert choose_perch([DRAWER], JEWEL_BOX) is None
    assert choose_perch([DRAWER], (0.2, 0.2, 0.03)) is not None


def test_a_taken_place_is_avoided_by_the_shortest_way() -> None:
    lamp = Taken(0, -0.05, 0.76, 0.2, 0.2)
    chosen = choose_perch([DESK], JEWEL_BOX, wish=(0.02, -0.05), taken=[lamp])
    assert chosen is not None
    assert abs(chosen.x) >= 0.21
    assert abs(chosen.x) < 0.3


def test_a_long_thing_is_turned_where_only_that_fits() -> None:
    board = OpenTop(StandingSurface(0, 0, 0.7, 0.3, 0.9))
    chosen = choose_perch([board], (0.8, 0.2, 0.1))
    assert chosen is not None
    assert chosen.turned
    assert choose_perch([board], (1.4, 0.2, 0.1)) is None


def test_a_full_surface_holds_no_more() -> None:
    tray = OpenTop(StandingSurface(0, 0, 0.7, 0.3, 0.3))
    assert choose_perch([tray], (0.2, 0.2, 0.1), taken=[Taken(0, 0, 0.7, 0.2, 0.2)]) is None
