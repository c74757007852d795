import math

import pytest

from storyblender.geometry.boxes import Box
from storyblender.geometry.relations import LayoutThing, PlayingArea, StandingSurface, remedy, violations

ROOM = PlayingArea(-5, 5, -5, 5)


def thing(
    name: str, x: float, y: float, z: float = 0.0, yaw: float = 0.0, size=(0.5, 0.5, 1.0), **asked
) -> LayoutThing:
    return LayoutThing(name, Box(x, y, z, *size, math.radians(yaw)), **asked)


def kinds(things: list[LayoutThing]) -> list[str]:
    return [violation.kind for violation in violations(things, ROOM)]


BROKEN = {
    "direction": thing("a", 2, 0, yaw=90, anchor="b", direction="facing"),
    "relationship": thing("a", -2, 0, anchor="b", relationship="on_the_right_of"),
    "contact": thing("a", 2, 0, anchor="b", relationship="on_the_right_of", contact=True),
    "no_contact": thing("a", 0.52, 0, anchor="b", relationship="on_the_right_of", contact=False),
    "support": thing("a", 0, 0, 1.3, size=(0.2, 0.2, 0.2), anchor="b", relationship="on_top_of"),
    "overhang": thing("a", 0.4, 0, 1.0, size=(0.2, 0.2, 0.2), anchor="b", relationship="on_top_of"),
    "floor": thing("a", 2, 0, 0.4),
    "bounds": thing("a", 4.9, 0),
    "penetration": thing("a", 0.3, 0.1),
}


@pytest.mark.parametrize("kind", BROKEN)
def test_each_broken_constraint_is_named_and_its_remedy_mends_it(kind: str) -> None:
    broken = BROKEN[kind].copy()
    things = [thing("b", 0, 0), broken]
    found = violations(things, ROOM)
    assert [violation.kind for violation in found] == [kind]
    move = remedy(found[0], things, ROOM)
    broken.box.x += move.get("move_x", 0)
    broken.box.y += move.get("move_y", 0)
    broken.box.z += move.get("move_z", 0)
    broken.box.turn_to(broken.box.yaw + math.radians(move.get("turn", 0)))
    assert kinds(things) == []


@pytest.mark.parametrize(
    ("direction", "yaw"), [("facing", -90), ("facing_away", 90), ("left_side_facing", 180), ("right_side_facing", 0)]
)
def test_directions_mean_the_things_own_sides(direction: str, yaw: float) -> None:
    """Seen from -Y, ``a`` stands to the right of ``b``; turned to -X it faces it."""
    assert kinds([thing("b", 0, 0), thing("a", 2, 0, yaw=yaw, anchor="b", direction=direction)]) == []
    assert kinds([thing("b", 0, 0), thing("a", 2, 0, yaw=yaw + 180, anchor="b", direction=direction)]) == ["direction"]


def test_behind_is_away_from_the_audience() -> None:
    assert kinds([thing("b", 0, 0), thing("a", 0.3, 2, anchor="b", relationship="behind")]) == []
    assert kinds([thing("b", 0, 0), thing("a", 0.3, -2, anchor="b", relationship="in_front_of")]) == []


def test_whoever_rides_may_overlap_only_what_carries_it() -> None:
    seated = thing("a", 0, -0.2, 0.45, anchor="b")
    assert kinds([thing("b", 0, 0), seated]) == []
    assert kinds([thing("b", 0, 0), seated, thing("c", 0, -0.5)]) == ["penetration"]


def test_a_jewel_box_stands_on_the_desk_not_on_the_mirror() -> None:
    dresser = thing("dresser", 0, 2, size=(1.2, 0.5, 1.65))
    desk = StandingSurface(0, -0.05, 0.76, 1.2, 0.4)
    box = thing("box", 0.3, 1.95, 0.76, size=(0.2, 0.14, 0.1), anchor="dresser", relationship="on_top_of", surface=desk)
    assert kinds([dresser, box]) == []
    assert kinds([dresser, thing("box", 0.3, 1.95, 1.65, size=(0.2, 0.14, 0.1), anchor="dresser",
                                 relationship="on_top_of", surface=desk)]) == ["support"]  # fmt: skip


def test_a_lane_holds_for_things_but_not_for_people() -> None:
    lane = [Box(0, 0, 0.05, 0.7, 3, 1.8)]
    assert [v.kind for v in violations([thing("a", 0.2, 0)], ROOM, lane)] == ["lane"]
    assert violations([thing("a", 0.2, 0, walks=True)], ROOM, lane) == []
    assert violations([thing("rug", 0.2, 0, size=(2, 2, 0.02))], ROOM, lane) == []
