import pytest
from tests.every import every

from storyblender.catalog.fixtures import fixtures_called
from storyblender.catalog.sets import SETS, plan_of
from storyblender.memory.scene_context import Environment

KITCHEN = plan_of(Environment(kit="kitchen"))


@pytest.mark.parametrize(
    ("name", "kind"),
    [("doorway", "door"), ("kitchen_window", "window"), ("the back wall", "wall"), ("left_corner", "corner")],
)
def test_parts_of_a_room_are_found_by_their_names(name: str, kind: str) -> None:
    assert fixtures_called(KITCHEN, name)[0].kind == kind


def test_the_side_that_is_told_counts() -> None:
    size = KITCHEN.size
    assert fixtures_called(KITCHEN, "right corner")[0].box.x > 0.7 * size.x
    assert fixtures_called(KITCHEN, "back wall")[0].box.y > 0.9 * size.y


@every("kit", SETS)
def test_a_piece_is_found_by_its_id(kit: str) -> None:
    plan = plan_of(Environment(kit=kit))
    for piece in plan.pieces:
        assert [fixture.name for fixture in fixtures_called(plan, piece.node_id)] == [piece.node_id]


def test_what_is_no_part_of_the_set_is_not_found() -> None:
    assert fixtures_called(KITCHEN, "submarine") == []
    assert fixtures_called(KITCHEN, None) == []


@every("kit", [key for key, kit in SETS.items() if kit.indoor])
def test_every_wall_faces_its_room(kit: str) -> None:
    plan = plan_of(Environment(kit=kit))
    middle = (plan.size.x + plan.size.x_negative) / 2, (plan.size.y + plan.size.y_negative) / 2
    for wall in fixtures_called(plan, "wall"):
        assert wall.box.to_local(*middle)[1] < 0.0
