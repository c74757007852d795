"""Every kit, at every size and period, gives a plan people can act in."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable
from functools import cache

import pytest
from tests.every import every

from storyblender.agents.visual_effects_artist.furniture import prop_size
from storyblender.catalog.footprints import piece_boxes, stage_box
from storyblender.catalog.materials import MATERIALS
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_families import family_of
from storyblender.catalog.registry import ParamValue
from storyblender.catalog.set_plan import Backdrop, SetPlan
from storyblender.catalog.sets import SETS, plan_of
from storyblender.catalog.sets.finishes import FINISHES, finish_of
from storyblender.errors import InputError
from storyblender.geometry.boxes import Box, penetration
from storyblender.memory.scene_context import Environment

PERIODS = ("past", "classic", "modern")
SIZES = ("least", "usual", "most")


@cache
def plans() -> list[tuple[str, SetPlan]]:
    """Return the plans of all kits, at three sizes and in three periods, and with their options."""
    result = []
    for key, kit in SETS.items():
        for size in SIZES:
            for period in PERIODS:
                params = {"width": getattr(kit.width, size), "depth": getattr(kit.depth, size), "period": period}
                result.append((f"{key}-{size}-{period}", plan_of(Environment(kit=key, params=params, seed=3))))
        switched: dict[str, ParamValue] = {name: True for name, default in kit.options.items() if default is False}
        if switched:
            result.append((f"{key}-options", plan_of(Environment(kit=key, params=switched, seed=3))))
    return result


def plans_where(wanted: Callable[[SetPlan], object]) -> Callable[[], list[tuple[str, SetPlan]]]:
    return lambda: [(name, plan) for name, plan in plans() if wanted(plan)]


def is_wide(plan: SetPlan) -> bool:
    """Return False for corridors and carriages, which are narrow by nature."""
    return min(SETS[plan.kit].width.usual, SETS[plan.kit].depth.usual) > 4


def land(plan: SetPlan) -> list[Backdrop]:
    return [card for card in plan.backdrops if card.kind in ("hills", "treeline")]


def boxes(plan: SetPlan, *, required_only: bool = False) -> list[tuple[str, Box]]:
    found = []
    for item in plan.furnishings:
        size = prop_size(item.prop, item.params)
        flat, hung = size[2] <= 0.05, item.location[2] >= 1.6
        if flat or hung or (required_only and not item.required):
            continue
        found.append((item.node_id, Box(*item.location, *size, math.radians(item.yaw))))
    return found + [(piece.node_id, box) for piece in plan.pieces for box in piece_boxes(piece) if box.z < 1.6]


@every("name plan", plans_where(is_wide))
def test_the_middle_is_free(name: str, plan: SetPlan) -> None:
    inside = [node for node, box in boxes(plan) if box.z < 1.5 and penetration(box, stage_box(plan))[0] > 0.05]
    assert not inside


@every("name plan", plans)
def test_required_furniture_does_not_collide(name: str, plan: SetPlan) -> None:
    standing = boxes(plan, required_only=True)
    clashes = [
        (a, b)
        for index, (a, first) in enumerate(standing)
        for b, second in standing[:index]
        if "set_" in a + b
        and penetration(first, second, 0.05)[0] > (0.25 if "chair" in a + b or "stool" in a + b else 0.06)
    ]
    assert not clashes


@every("name plan", plans)
def test_ids_are_unique_and_marks_are_on_stage(name: str, plan: SetPlan) -> None:
    ids = [
        item.node_id
        for part in (plan.walls, plan.slabs, plan.pieces, plan.backdrops, plan.furnishings)
        for item in part
    ]
    assert [node for node, count in Counter(ids).items() if count > 1] == []
    tags = {tag for mark in plan.marks for tag in mark.tags}
    assert {"enter", "exit", "centre"} <= tags
    for mark in plan.marks:
        if "road" not in mark.tags:
            assert plan.size.x_negative <= mark.location[0] <= plan.size.x
            assert plan.size.y_negative <= mark.location[1] <= plan.size.y


@every("name plan", plans_where(lambda plan: plan.indoor))
def test_a_room_is_closed_to_the_void(name: str, plan: SetPlan) -> None:
    assert {wall.node_id for wall in plan.walls} == {"wall_front", "wall_right", "wall_back", "wall_left"}
    roofed = any(item.prop in family_of("car") for item in plan.furnishings)
    assert {slab.role for slab in plan.slabs} >= {"floor", *(() if roofed else ("ceiling",))}
    windows = [wall for wall in plan.walls if any(opening.kind == "window" for opening in wall.openings)]
    assert len(plan.backdrops) >= len(windows)


@every("name plan", plans_where(lambda plan: not plan.indoor))
def test_an_open_place_has_something_all_round(name: str, plan: SetPlan) -> None:
    seen = {round(math.degrees(math.atan2(*_middle(card.corners)))) // 45 for card in plan.backdrops}
    facades = sum(piece.part == "facade" for piece in plan.pieces)
    assert len(seen) >= 6 or facades >= 4


def _middle(corners: tuple[tuple[float, float, float], ...]) -> tuple[float, float]:
    return (corners[0][0] + corners[1][0]) / 2, (corners[0][1] + corners[1][1]) / 2


@every("name plan", plans_where(lambda plan: any(wall.openings for wall in plan.walls)))
def test_openings_lie_in_their_walls_and_apart(name: str, plan: SetPlan) -> None:
    for wall in plan.walls:
        length, at = math.dist(wall.start, wall.end), 0.0
        for opening in wall.openings:
            assert opening.x >= at, f"{opening.name} of {wall.node_id} overlaps its neighbour"
            assert opening.sill + opening.height < wall.height
            at = opening.x + opening.width
        assert at <= length


def test_every_furnishing_is_in_the_catalog() -> None:
    wanted = {item.prop for _, plan in plans() for item in plan.furnishings}
    assert sorted(wanted - set(PROPS)) == []


def test_finishes_name_materials_that_exist() -> None:
    used = {wall.material for _, plan in plans() for wall in plan.walls}
    used |= {wall.dado for _, plan in plans() for wall in plan.walls if wall.dado}
    used |= {slab.material for _, plan in plans() for slab in plan.slabs}
    assert {finish_of(key).material for key in (*used, *FINISHES)} <= set(MATERIALS)


def test_same_environment_same_plan_other_seed_other_plan() -> None:
    wood = Environment(kit="forest", seed=1)
    assert plan_of(wood) == plan_of(wood.model_copy())
    assert plan_of(wood) != plan_of(wood.model_copy(update={"seed": 2}))


def test_a_larger_room_is_larger() -> None:
    small, large = (plan_of(Environment(kit="office", params={"width": width})) for width in (6.0, 9.0))
    assert (large.size.x, small.size.x) == (4.5, 3.0)


@pytest.mark.parametrize("bad", [Environment(kit="nowhere"), Environment(kit="cafe", params={"colour": "red"})])
def test_unknown_kits_and_parameters_are_refused(bad: Environment) -> None:
    with pytest.raises(InputError):
        plan_of(bad)


@every("name plan", plans_where(lambda plan: not plan.indoor and land(plan)))
def test_open_land_runs_out_at_its_ends(name: str, plan: SetPlan) -> None:
    rises = [(card.corners[low][2], card.corners[high]) for card in land(plan) for low, high in ((0, 3), (1, 2))]
    for foot, (x, y, top) in rises:
        meets = sum(math.dist((x, y, top), other) < 1e-6 for _, other in rises)
        assert meets > 1 or top - foot < 0.6, f"a square edge at {x:.0f}, {y:.0f}"


@every("name plan", plans)
def test_no_step_is_so_high_that_people_would_stand_in_it(name: str, plan: SetPlan) -> None:
    assert [slab.node_id for slab in plan.slabs if slab.role == "block" and slab.z > 0.1] == []


@every("name plan", plans_where(lambda plan: plan.indoor))
def test_nothing_stands_in_a_wall(name: str, plan: SetPlan) -> None:
    inside = Box(0, 0, 0, 2 * plan.size.x, plan.size.y - plan.size.y_negative, 9.0)
    poking = {}
    for node, box in boxes(plan):
        x, y = box.x, box.y - (plan.size.y + plan.size.y_negative) / 2
        over = max(abs(x) + box.reach((1, 0)) - inside.width / 2, abs(y) + box.reach((0, 1)) - inside.depth / 2)
        if node.startswith("set_") and over > 0.05 and not (plan.size.y < -plan.size.y_negative and y > 0):
            poking[node] = round(over, 2)
    assert not poking
