import importlib.util
import math
from pathlib import Path

import pytest

from storyblender.geometry.boxes import Box
from storyblender.geometry.lanes import WALKWAY_WIDTH, find_walkway, lane_boxes
from storyblender.geometry.relations import LayoutThing, PlayingArea, violations
from storyblender.geometry.solver import solve

SPEC = importlib.util.spec_from_file_location(
    "layout_solver", Path(__file__).parents[3] / "benchmarks" / "layout_solver.py"
)
assert SPEC is not None and SPEC.loader is not None
bench = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(bench)

ROOM = PlayingArea(-4, 4, -4, 4)


@pytest.mark.parametrize("seed", range(7000, 7020))
def test_random_rooms_are_solved(seed: int) -> None:
    things, room = bench.random_room(seed)
    solution = solve(bench.thrown_about(things, seed), room, seed=seed)
    assert solution.solved
    assert violations(solution.things, room) == []


def test_the_same_seed_gives_the_same_layout() -> None:
    things, room = bench.random_room(7100)
    thrown = bench.thrown_about(things, 7100)
    first, second = (solve(thrown, room, seed=3) for _ in range(2))
    assert [thing.box for thing in first.things] == [thing.box for thing in second.things]


def test_the_input_is_not_changed() -> None:
    things, room = bench.random_room(7101)
    thrown = bench.thrown_about(things, 7101)
    before = [thing.box.copy() for thing in thrown]
    solve(thrown, room)
    assert [thing.box for thing in thrown] == before


def test_a_contradiction_is_reported_not_hidden() -> None:
    a = LayoutThing("a", Box(1, 0, 0, 0.5, 0.5, 1), "b", "on_the_left_of")
    b = LayoutThing("b", Box(0, 0, 0, 0.5, 0.5, 1), "a", "on_the_left_of")
    solution = solve([a, b], ROOM)
    assert not solution.solved
    assert {violation.subject for violation in solution.residual} <= {"a", "b"}


def test_fixed_things_stay_and_the_others_leave_them() -> None:
    piano = LayoutThing("piano", Box(0, 0, 0, 1.5, 1.4, 1.0), fixed=True)
    chair = LayoutThing("chair", Box(0.2, 0.1, 0, 0.5, 0.5, 0.9))
    solution = solve([piano, chair], ROOM)
    assert solution.solved
    assert solution.things[0].box == piano.box


def test_who_sits_in_what_is_fixed_outside_stays_in_it() -> None:
    boat = LayoutThing("boat", Box(0, 5.2, 0, 4.0, 1.5, 0.7), fixed=True)
    rower = LayoutThing("rower", Box(0.3, 5.2, 0.2, 0.42, 0.3, 0.8), anchor="boat", walks=True)
    stray = LayoutThing("stray", Box(2, 5.2, 0, 0.5, 0.4, 1.7), walks=True)
    solution = solve([boat, rower, stray], ROOM)
    assert solution.solved
    assert [thing.box.y > 4 for thing in solution.things] == [True, True, False]


def test_what_stands_on_a_table_moves_and_turns_with_it() -> None:
    table = LayoutThing("table", Box(5, 0, 0, 1.2, 0.8, 0.75))
    cup = LayoutThing("cup", Box(5.3, 0.1, 0.75, 0.1, 0.1, 0.1), "table", "on_top_of")
    solved = solve([table, cup], ROOM).things
    assert solved[0].box.x < 3.5
    assert solved[1].box.x - solved[0].box.x == pytest.approx(0.3)


def test_a_blocked_walkway_is_opened_for_people() -> None:
    shelf = LayoutThing("shelf", Box(0, 2.1, 0, 0.5, 3.8, 2), fixed=True)
    crates = [LayoutThing(f"crate_{i}", Box(0, -3.6 + 0.9 * i, 0, 0.8, 0.8, 0.8)) for i in range(4)]
    things = [shelf, *crates]
    assert find_walkway((-3, -2), (3, -2), things, ROOM) is None
    opened = find_walkway((-3, -2), (3, -2), things, ROOM, around_fixed_only=True)
    assert opened is not None
    solution = solve(things, ROOM, keep_free=lane_boxes(opened))
    assert solution.solved
    walked = find_walkway((-3, -2), (3, -2), solution.things, ROOM)
    assert walked is not None
    assert all(
        math.dist(point, (thing.box.x, thing.box.y)) > WALKWAY_WIDTH / 2
        for point in walked[1:-1]
        for thing in solution.things
    )
