"""The Spatial Planner: wishes from the script, then the solver, then the geometric critic (paper, appendix).

The rules propose where everything is wished and let the solver make it valid; ``refine`` applies the critic's exact
fixes and solves again. Geometry is never asked of a model: a language policy proposes wishes in the same way.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from storyblender.agents.layout_artist.layout_stage import Stage
from storyblender.agents.layout_artist.layout_things import laid_out, layout_violations, room_of, thing_of, walls_of
from storyblender.agents.layout_artist.object_places import place_objects
from storyblender.agents.layout_artist.people_places import place_people
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.geometry.boxes import Box
from storyblender.geometry.lanes import find_walkway, lane_boxes
from storyblender.geometry.relations import Room, Thing, Violation, may_overlap_anchor
from storyblender.geometry.solver import solve
from storyblender.memory.base import Vec2, content_hash
from storyblender.memory.scene_context import Layout
from storyblender.reflection import Critique, Fault

_REACH = 0.55
"""Metres before a target where somebody must be able to stand."""
_SQUEEZE = 0.5
"""Metres that a person gets through, behind a bar for example; lanes are wider."""
_RESERVED = (0.6, 0.5)


@dataclass(frozen=True)
class RulesSpatialPlanner:
    """The Spatial Planner without a model."""

    def propose(self, view: SpatialPlannerView) -> Layout:
        """Return a solved layout of the scene at its start."""
        stage = Stage(view)
        place_objects(stage)
        place_people(stage)
        place_objects(stage, beside_people=True)
        return _solved(stage, view)

    def refine(self, draft: Layout, critique: Critique, view: SpatialPlannerView) -> Layout:
        """Apply the critic's exact fixes, then solve again from there."""
        moved = {item.node_id: item for item in draft.objects}
        for fault in critique.faults:
            item = moved.get(fault.subject)
            if item is None or item.fixed:
                continue
            move = [float(fault.fix.get(f"move_{axis}", 0.0)) for axis in "xyz"]
            x, y, z = (value + step for value, step in zip(item.location, move, strict=True))
            rx, ry, rz = item.rotation
            turned = (rx, ry, rz + float(fault.fix.get("turn", 0.0)))
            moved[fault.subject] = item.model_copy(update={"location": (x, y, z), "rotation": turned})
        stage = Stage(view)
        for item in moved.values():
            if item.node_id not in stage.things:
                stage.put(item, fixed=item.fixed)
        return _solved(stage, view)


def _solved(stage: Stage, view: SpatialPlannerView) -> Layout:
    """Solve the stage twice: once as wished as far as that can be, then with the walkways this leaves kept free."""
    things = [*stage.things.values(), *stage.walls]
    seed = int(content_hash("layout", view.scene_id, view.seed)[:8], 16)
    solution = solve(things, stage.room, keep_free=_reserved(stage), seed=seed)
    if solution.residual:
        freed = [_let_go(thing, solution.residual) for thing in solution.things]
        without = solve(freed, stage.room, keep_free=_reserved(stage), seed=seed)
        solution = without if len(without.residual) < len(solution.residual) else solution
    lanes = [*_reserved(stage), *_walkways(stage, solution.things)]
    if lanes:
        with_lanes = solve(solution.things, stage.room, keep_free=lanes, seed=seed)
        if len(with_lanes.residual) <= len(solution.residual):
            solution = with_lanes
    known = {item.node_id: item for item in view.dressed}
    objects = [
        known.get(thing.name) or laid_out(thing, stage.assets[thing.name])
        for thing in solution.things
        if thing.name in stage.assets
    ]
    return Layout(scene_size=view.plan.size, objects=tuple(objects))


def _let_go(thing: Thing, residual: Sequence[Violation]) -> Thing:
    """Return a thing without its place beside another where there is no room for it: a van across an alley."""
    freed = thing.copy()
    unmet = any(violation.subject == thing.name for violation in residual)
    if unmet and not (thing.fixed or thing.walks or may_overlap_anchor(thing) or thing.relationship == "on_top_of"):
        freed.anchor = freed.relationship = freed.contact = freed.direction = None
    return freed


def _reserved(stage: Stage) -> list[Box]:
    """Return the floor before everything that somebody will go to."""
    volumes = []
    for asset_id in stage.view.targets:
        target = stage.find(asset_id)
        if target is not None and target.box.z < 0.1 and not target.walks and target.fixed:
            x, y = target.box.to_world(0.0, -target.box.depth / 2 - 0.1 - _RESERVED[1] / 2)
            volumes.append(Box(x, y, 0.05, *_RESERVED, 1.8, target.box.yaw))
    return volumes


def ways_of(view: SpatialPlannerView, layout: Layout) -> list[Box]:
    """Return the floor of a finished layout that stays free: before what people go to, and on their ways there."""
    stage = Stage(view)
    for item in layout.objects:
        if item.node_id not in stage.things:
            stage.put(item, fixed=item.fixed)
    return [*_reserved(stage), *_walkways(stage, list(stage.things.values()))]


def _walkways(stage: Stage, things: Sequence[Thing]) -> list[Box]:
    """Return the lanes from a door to everybody, and from the people to what they will go to."""
    people = [thing for thing in things if thing.walks and not may_overlap_anchor(thing)]
    if not people:
        return []
    spots = [(person.box.x, person.box.y) for person in people]
    doors = _doors(stage.view)
    trips = [(door, spots[0]) for door in doors[:2]]
    trips += [(doors[0], spot) for spot in spots[1:] if doors and not _is_open(doors, spot, things, stage.room)]
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
    """Return the places where people enter the set."""
    return [(mark.location[0], mark.location[1]) for mark in view.plan.marks if "enter" in mark.tags]


def _is_open(doors: Sequence[Vec2], spot: Vec2, things: Sequence[Thing], room: Room) -> bool:
    """Return whether somebody can walk to a place from any door."""
    return any(find_walkway(door, spot, things, room, width=_SQUEEZE) is not None for door in doors)


@dataclass(frozen=True)
class SpatialPlannerCritic:
    """R of the Spatial Planner: the geometric checks, and everybody reachable from the doors."""

    def judge(self, draft: Layout, view: SpatialPlannerView) -> Critique:
        """Score ten less the severities of what is wrong."""
        faults = layout_violations(draft, view.measures, view.plan)
        return Critique.of((*faults, *_unreachable(draft, view), *_missing(draft, view)))


def _unreachable(draft: Layout, view: SpatialPlannerView) -> list[Fault]:
    things = [thing for item in draft.objects if (thing := thing_of(item, view.measures, view.plan)) is not None]
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
        if not _is_open(doors, (person.box.x, person.box.y), things, room)
    ]


def _missing(draft: Layout, view: SpatialPlannerView) -> list[Fault]:
    present = {item.asset_id for item in draft.objects}
    wanted = [*view.pending, *(state.asset_id for state in view.states)]
    return [
        Fault(kind="missing", subject=asset_id, severity=3.0, message=f"{asset_id} has no place")
        for asset_id in wanted
        if asset_id not in present
    ]
