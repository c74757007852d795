"""Makes room for a scene whose layout cannot be solved: less dressing, a larger set, people further apart.

The Spatial Planner's reflection moves things; if they still intersect, this loop gives the scene more room step by
step and keeps the best result.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from typing import Generic, TypeVar

from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.catalog.set_plan import SetPlan
from storyblender.catalog.sets import SETS, plan_of
from storyblender.memory.base import Vec2
from storyblender.memory.scene_context import Environment, Layout, LayoutObject
from storyblender.reflection import SEEN, Critique, Outcome

Tried = TypeVar("Tried")

_AROUND = 2.2
"""Metres around a fault within which dressing is left out at first."""
_EVERYWHERE = 99.0
_IN_VAIN = 2
"""Steps without any gain after which the loop stops."""
_ON_IT = 1.0
"""Metres from the middle of furniture within which a thing stands on it."""


@dataclass(frozen=True)
class RoomStep:
    """One step of the loop.

    Attributes:
        set_scale: Factor on the width and depth of the set as designed.
        clear_radius: Metres around the faults within which optional dressing is left out; 0 keeps all.
        distance_scale: Factor on distances between people who stand together.
    """

    set_scale: float = 1.0
    clear_radius: float = 0.0
    distance_scale: float = 1.0


ROOM_STEPS = (
    RoomStep(),
    RoomStep(clear_radius=_AROUND),
    RoomStep(set_scale=1.2, clear_radius=_AROUND),
    RoomStep(set_scale=1.45, clear_radius=_EVERYWHERE, distance_scale=1.15),
    RoomStep(set_scale=1.8, clear_radius=_EVERYWHERE, distance_scale=1.3),
)
"""The steps of the loop, from the set as designed to the largest and barest."""


@dataclass(frozen=True)
class FittedScene(Generic[Tried]):
    """The result of the loop.

    Attributes:
        tried: What the step's staging returned.
        room: The step.
        outcome: Outcome of the Spatial Planner's reflection.
    """

    tried: Tried
    room: RoomStep
    outcome: Outcome[SpatialPlannerView, Layout]


def find_fitting_room(
    stage: Callable[[RoomStep, Collection[Vec2]], tuple[Tried, Outcome[SpatialPlannerView, Layout]]],
    rooms: Iterable[RoomStep] = ROOM_STEPS,
    threshold: float = 8.0,
) -> FittedScene[Tried]:
    """Stage a scene with more and more room until its layout is solved; return the best try.

    Args:
        stage: Dresses and lays out the scene for a step, given the floor points of the faults so far.
        rooms: Steps to try, in order.
        threshold: Score from which a layout counts as solved.

    Raises:
        ValueError: If there is no step.
    """
    best: FittedScene[Tried] | None = None
    faulty: tuple[Vec2, ...] = ()
    in_vain = 0
    for room in rooms:
        tried, outcome = stage(room, faulty)
        in_vain += 1
        if best is None or outcome.critique.score > best.outcome.critique.score:
            best, in_vain = FittedScene(tried, room, outcome), 0
        computed = tuple(fault for fault in outcome.critique.faults if fault.kind != SEEN)  # taste needs no larger set
        if Critique.of(computed).score >= threshold or in_vain == _IN_VAIN:
            break
        subjects = {fault.subject for fault in computed}
        spots = tuple(item.location[:2] for item in outcome.draft.objects if item.node_id in subjects)
        faulty = tuple(dict.fromkeys((*faulty, *spots)))
    if best is None:
        raise ValueError("there is no step to try")
    return best


def enlarge_set(environment: Environment, set_scale: float) -> Environment:
    """Return a larger set, within the limits of its kit.

    Args:
        environment: As designed.
        set_scale: Factor on its width and depth; up to 1 the set stays as it is.
    """
    if set_scale <= 1.0:
        return environment
    kit, size = SETS[environment.kit], plan_of(environment).size
    wide, deep = set_scale * (size.x - size.x_negative), set_scale * (size.y - size.y_negative)
    params = {"width": round(kit.width.clamp(wide), 1), "depth": round(kit.depth.clamp(deep), 1)}
    return environment.model_copy(update={"params": environment.params | params})


def drop_dressing(
    objects: tuple[LayoutObject, ...], plan: SetPlan, spots: Collection[Vec2], reach: float
) -> tuple[LayoutObject, ...]:
    """Return the furniture of a set without the optional dressing near some floor points, and without what stood on it.

    Args:
        objects: Furniture as the Set Dresser placed it.
        plan: The set; it knows which furniture is required. All other furniture of the set is optional.
        spots: Floor points of the faults.
        reach: Metres around them.
    """
    required = {item.node_id for item in plan.furnishings if item.required}
    optional = {item.node_id for item in objects if item.node_id.startswith("set_")} - required
    near = {
        item.node_id
        for item in objects
        if item.node_id in optional and any(math.dist(item.location[:2], spot) < reach for spot in spots)
    }
    gone = [item.location for item in objects if item.node_id in near]
    return tuple(
        item
        for item in objects
        if item.node_id not in near
        and not (
            item.node_id in optional
            and any(item.location[2] > z + 0.2 and math.dist(item.location[:2], (x, y)) < _ON_IT for x, y, z in gone)
        )
    )
