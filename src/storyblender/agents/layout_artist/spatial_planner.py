"""The Spatial Planner without a model: wished places from the script, then the solver, then the geometric critic.

``refine`` applies the critic's exact fixes and solves again (paper, appendix).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.layout_things import (
    is_seated,
    layout_object_of,
    layout_violations,
    off_seats,
    room_of,
    thing_of,
    walls_of,
)
from storyblender.agents.layout_artist.object_places import place_objects
from storyblender.agents.layout_artist.people_places import place_people
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.geometry.boxes import Box
from storyblender.geometry.lanes import find_walkway, lane_boxes
from storyblender.geometry.relations import LayoutThing, PlayingArea, Violation, may_overlap_anchor
from storyblender.geometry.solver import solve
from storyblender.memory.base import Vec2, content_hash
from storyblender.memory.scene_context import Layout
from storyblender.reflection import Critique, Fault

_REACH = 0.55
"""Metres in front of a target at which a person must be able to stand."""
_SQUEEZE = 0.5
"""Least width in metres of a way for a person, such as behind a bar; lanes are wider."""
_SITTER = 1e4
"""Mass of a sitter while a draft is mended: others are pushed away from them, not they off their seat."""
_RESERVED = (0.6, 0.5)
"""Width and depth in metres of the floor kept free in front of a target."""


@dataclass(frozen=True)
class RulesSpatialPlanner:
    """The Spatial Planner without a model."""

    def propose(self, view: SpatialPlannerView) -> Layout:
        """Return a solved layout of the scene at its start."""
        stage = LayoutStage(view)
        place_objects(stage)
        place_people(stage)
        place_objects(stage, beside_people=True)
        return _solve_layout(stage, view)

    def refine(self, draft: Layout, critique: Critique, view: SpatialPlannerView) -> Layout:
        """Apply the critic's exact fixes to the draft, then solve it again.

        Args:
            draft: The layout.
            critique: Its faults, with ``move_x``, ``move_y``, ``move_z`` (metres) and ``turn`` (degrees) as fixes.
            view: The scene.
        """
        mended = _moved(draft, critique.faults)
        mended = _moved(mended, off_seats(mended, view.measures))
        stage = LayoutStage(view)
        for item in mended.objects:
            if item.node_id not in stage.things:
                stage.add_object(item, fixed=item.fixed)
                if is_seated(item) and item.node_id in stage.things:
                    stage.things[item.node_id].mass = _SITTER
        return _solve_layout(stage, view, mending=True)


def _moved(layout: Layout, faults: Iterable[Fault]) -> Layout:
    """Return a layout with the fixes of faults applied to what may be moved."""
    moved = {item.node_id: item for item in layout.objects}
    for fault in faults:
        item = moved.get(fault.subject)
        if item is None or item.fixed:
            continue
        move = [float(fault.fix.get(f"move_{axis}", 0.0)) for axis in "xyz"]
        x, y, z = (value + step for value, step in zip(item.location, move, strict=True))
        rx, ry, rz = item.rotation
        turned = (rx, ry, rz + float(fault.fix.get("turn", 0.0)))
        moved[fault.subject] = item.model_copy(update={"location": (x, y, z), "rotation": turned})
    return layout.model_copy(update={"objects": tuple(moved.values())})


def _solve_layout(stage: LayoutStage, view: SpatialPlannerView, *, mending: bool = False) -> Layout:
    """Solve the stage as wished, then again with the walkways kept free; return the better layout."""
    things = [*stage.things.values(), *stage.walls]
    seed = int(content_hash("layout", view.scene_id, view.seed + view.staging)[:8], 16)
    solution = solve(things, stage.room, keep_free=_reserved_floor(stage), seed=seed, mending=mending)
    if solution.residual:
        freed = [_without_relation(thing, solution.residual) for thing in solution.things]
        without = solve(freed, stage.room, keep_free=_reserved_floor(stage), seed=seed, mending=mending)
        solution = without if len(without.residual) < len(solution.residual) else solution
    lanes = [*_reserved_floor(stage), *_walkways(stage, solution.things)]
    if lanes:
        with_lanes = solve(solution.things, stage.room, keep_free=lanes, seed=seed, mending=mending)
        if len(with_lanes.residual) <= len(solution.residual):
            solution = with_lanes
    known = {item.node_id: item for item in view.dressed}
    objects = [
        known.get(thing.name) or layout_object_of(thing, stage.assets[thing.name])
        for thing in solution.things
        if thing.name in stage.assets
    ]
    return Layout(scene_size=view.plan.size, objects=tuple(objects))


def _without_relation(thing: LayoutThing, residual: Sequence[Violation]) -> LayoutThing:
    """Return a thing without its place beside another, if a violation says there is no room for it."""
    freed = thing.copy()
    unmet = any(violation.subject == thing.name for violation in residual)
    if unmet and not (thing.fixed or thing.walks or may_overlap_anchor(thing) or thing.relationship == "on_top_of"):
        freed.anchor = freed.relationship = freed.contact = freed.direction = None
    return freed


def _reserved_floor(stage: LayoutStage) -> list[Box]:
    """Return boxes of the floor in front of every fixed thing that people will go to."""
    volumes = []
    for asset_id in stage.view.targets:
        target = stage.find(asset_id)
        if target is not None and target.box.z < 0.1 and not target.walks and target.fixed:
            x, y = target.box.to_world(0.0, -target.box.depth / 2 - 0.1 - _RESERVED[1] / 2)
            volumes.append(Box(x, y, 0.05, *_RESERVED, 1.8, target.box.yaw))
    return volumes


def free_floor_of(view: SpatialPlannerView, layout: Layout) -> list[Box]:
    """Return boxes of the floor of a finished layout that stay free: in front of people's targets, and on their ways.

    Args:
        view: The scene.
        layout: Its layout.
    """
    stage = LayoutStage(view)
    for item in layout.objects:
        if item.node_id not in stage.things:
            stage.add_object(item, fixed=item.fixed)
    return [*_reserved_floor(stage), *_walkways(stage, list(stage.things.values()))]


def _walkways(stage: LayoutStage, things: Sequence[LayoutThing]) -> list[Box]:
    """Return boxes of the lanes from a door to everybody, and from the people to their targets."""
    people = [thing for thing in things if thing.walks and not may_overlap_anchor(thing)]
    if not people:
        return []
    spots = [(person.box.x, person.box.y) for person in people]
    doors = _doors(stage.view)
    trips = [(door, spots[0]) for door in doors[:2]]
    trips += [(doors[0], spot) for spot in spots[1:] if doors and not _is_reachable(doors, spot, things, stage.room)]
    by_name = {thing.name: thing for thing in things}
    for asset_id in stage.view.targets[:4]:
        target = stage.find(asset_id)
        target = by_name.get(target.name) if target is not None else None
        if target is not None and not target.walks and target.relationship != "on_top_of":
            trips.append((target.box.to_world(0.0, -target.box.depth / 2 - _REACH), spots[0]))
    volumes: list[Box] = []
    for start, end in trips:
        points = find_walkway(start, end, things, stage.room) or find_walkway(
            start, end, things, stage.room, around_fixed_only=True
        )
        volumes += lane_boxes(points) if points is not None and math.dist(start, end) > 0.8 else []
    return volumes


def _doors(view: SpatialPlannerView) -> list[tuple[float, float]]:
    """Return the floor points where people enter the set."""
    return [(mark.location[0], mark.location[1]) for mark in view.plan.marks if "enter" in mark.tags]


def _is_reachable(doors: Sequence[Vec2], spot: Vec2, things: Sequence[LayoutThing], room: PlayingArea) -> bool:
    """Return whether a person can walk to a floor point from any door."""
    return any(find_walkway(door, spot, things, room, width=_SQUEEZE) is not None for door in doors)


@dataclass(frozen=True)
class SpatialPlannerCritic:
    """The Spatial Planner's critic: the geometric checks, and everybody reachable from the doors."""

    def judge(self, draft: Layout, view: SpatialPlannerView) -> Critique:
        """Return the critique of a layout: geometric faults with exact fixes, people cut off, things without a place.

        Args:
            draft: The layout.
            view: The scene.
        """
        faults = layout_violations(draft, view.measures, view.plan, view.placements)
        return Critique.of((*faults, *_find_unreachable(draft, view), *_find_missing(draft, view)))


def _find_unreachable(draft: Layout, view: SpatialPlannerView) -> list[Fault]:
    """Return a fault for each person whom no walk from a door reaches."""
    seen = (thing_of(item, view.measures, view.plan, view.placements) for item in draft.objects)
    things = [thing for thing in seen if thing is not None]
    things += walls_of(view.plan)
    doors, room = _doors(view), room_of(draft.scene_size)
    return [
        Fault(
            kind="walkway",
            subject=person.name,
            severity=2.1,
            message=f"nobody can walk from a door to {person.name}: there is no way {_SQUEEZE} m wide",
        )
        for person in things
        if doors and person.walks and not may_overlap_anchor(person)
        if not _is_reachable(doors, (person.box.x, person.box.y), things, room)
    ]


def _find_missing(draft: Layout, view: SpatialPlannerView) -> list[Fault]:
    """Return a fault for each pending thing or person that the layout lacks."""
    present = {item.asset_id for item in draft.objects}
    wanted = [*view.pending, *(state.asset_id for state in view.states)]
    return [
        Fault(kind="missing", subject=asset_id, severity=3.0, message=f"{asset_id} has no place")
        for asset_id in wanted
        if asset_id not in present
    ]
