"""What a scene tries when its layout cannot be solved: less dressing, a larger set, people further apart.

The Spatial Planner's own reflection mends what can be moved. What still stands in something else then has no room: the
loop of this module gives it room, a step at a time, and keeps the best of all that it tried.
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
from storyblender.reflection import Outcome

Tried = TypeVar("Tried")

_AROUND = 2.2
"""Metres around a fault within which dressing gives way at first."""
_EVERYWHERE = 99.0
_IN_VAIN = 2
"""Steps without any gain after which more room is not what the scene lacks."""
_ON_IT = 1.0
"""Metres from the middle of furniture to what stands on it."""


@dataclass(frozen=True)
class Room:
    """One step of the loop.

    Attributes:
        grown: Width and depth of the set, times what was designed.
        shed: Metres around the faults within which dressing that nobody needs is left out; 0 keeps all.
        apart: Distances between people who stand together, times the usual.
    """

    grown: float = 1.0
    shed: float = 0.0
    apart: float = 1.0


ROOMS = (
    Room(),
    Room(shed=_AROUND),
    Room(grown=1.2, shed=_AROUND),
    Room(grown=1.45, shed=_EVERYWHERE, apart=1.15),
    Room(grown=1.8, shed=_EVERYWHERE, apart=1.3),
)
"""The steps of the loop, from the set as designed to the largest and barest."""


@dataclass(frozen=True)
class Fitted(Generic[Tried]):
    """What the loop ended with.

    Attributes:
        tried: What the step made.
        room: The step.
        outcome: Of the Spatial Planner's reflection.
    """

    tried: Tried
    room: Room
    outcome: Outcome[SpatialPlannerView, Layout]


def until_it_fits(
    stage: Callable[[Room, Collection[Vec2]], tuple[Tried, Outcome[SpatialPlannerView, Layout]]],
    rooms: Iterable[Room] = ROOMS,
    threshold: float = 8.0,
) -> Fitted[Tried]:
    """Stage a scene with more and more room until its layout is solved; else return the best of all.

    Args:
        stage: Dresses and lays out the scene with so much room, given where the last layout had its faults.
        rooms: Steps to try, in order; at least one.
        threshold: Score of a layout that is solved.
    """
    best: Fitted[Tried] | None = None
    faulty: tuple[Vec2, ...] = ()
    in_vain = 0
    for room in rooms:
        tried, outcome = stage(room, faulty)
        in_vain += 1
        if best is None or outcome.critique.score > best.outcome.critique.score:
            best, in_vain = Fitted(tried, room, outcome), 0
        if outcome.critique.score >= threshold or in_vain == _IN_VAIN:
            break
        subjects = {fault.subject for fault in outcome.critique.faults}
        spots = tuple(item.location[:2] for item in outcome.draft.objects if item.node_id in subjects)
        faulty = tuple(dict.fromkeys((*faulty, *spots)))
    if best is None:
        raise ValueError("there is no step to try")
    return best


def larger(environment: Environment, grown: float) -> Environment:
    """Return a larger variant of a set, as large as its kit can be at most; what is no larger is the same."""
    if grown <= 1.0:
        return environment
    kit, size = SETS[environment.kit], plan_of(environment).size
    wide, deep = grown * (size.x - size.x_negative), grown * (size.y - size.y_negative)
    params = {"width": round(kit.width.clamp(wide), 1), "depth": round(kit.depth.clamp(deep), 1)}
    return environment.model_copy(update={"params": environment.params | params})


def without_dressing(
    objects: tuple[LayoutObject, ...], plan: SetPlan, spots: Collection[Vec2], reach: float
) -> tuple[LayoutObject, ...]:
    """Return the furniture of a set without the dressing near some spots, and without what stood on that.

    Args:
        objects: As the Set Dresser placed them.
        plan: Of the set: it knows what is needed.
        spots: Floor points of the faults.
        reach: Metres around them.
    """
    optional = {item.node_id for item in plan.furnishings if not item.required}
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
