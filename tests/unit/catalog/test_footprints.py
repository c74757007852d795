"""What nobody walks through: walls between their doors, solid pieces at their scale, the piers of an arcade."""

from dataclasses import astuple

import pytest

from storyblender.catalog.footprints import piece_boxes, wall_boxes
from storyblender.catalog.set_plan import Opening, Piece, Wall

ARCADE = Piece(
    node_id="arcade_1",
    part="arcade",
    location=(0, -2, 0),
    solid=False,
    params={"width": 9.0, "height": 3.5, "arches": 3.0, "depth": 0.3},
)


def test_the_piers_of_an_arcade_stand_in_the_way_and_its_arches_do_not() -> None:
    boxes = piece_boxes(ARCADE)
    assert [round(box.x, 2) for box in boxes] == pytest.approx([-4.29, -1.5, 1.5, 4.29], abs=0.01)
    assert all(box.y == -2 and box.height == 3.5 for box in boxes)


def test_a_piece_grows_with_its_scale_and_scenery_is_no_obstacle() -> None:
    rock = Piece(node_id="rock_1", part="rock", location=(1, 2, 0), scale=2.0, footprint=(0.8, 0.6))
    (box,) = piece_boxes(rock)
    assert astuple(box)[:5] == (1, 2, 0, 1.6, 1.2)
    assert piece_boxes(rock.model_copy(update={"solid": False})) == []


def test_a_wall_lies_outside_its_line_and_is_open_where_doors_are() -> None:
    door = Opening(name="door", kind="door", x=1.0, width=1.0, height=2.1)
    window = Opening(name="window", kind="window", x=3.0, sill=0.9, width=1.0, height=1.2)
    wall = Wall(node_id="wall", start=(0, 0), end=(5, 0), height=3, material="m", openings=(window, door))
    left, right = wall_boxes(wall)
    assert (left.x, left.width, right.x, right.width) == (0.5, 1.0, 3.5, 3.0)
    assert left.y == pytest.approx(-wall.thickness / 2)
