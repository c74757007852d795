"""Stands a told crowd in a scene that is laid out: figures on free seats and in small groups, out of the story's way.

The figures are built once and shared; nobody speaks to them and the camera does not seek them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from storyblender.agents.layout_artist.crowd_places import for_anybody
from storyblender.agents.layout_artist.layout_stage import Stage
from storyblender.agents.layout_artist.people_seats import free_seats
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.catalog.bystanders import BYSTANDER, VARIANTS
from storyblender.geometry.boxes import Box, yaw_along
from storyblender.geometry.relations import Thing
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec2
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Layout, LayoutObject

_SITTING = 0.6
_OWN_TABLE = 2.2
"""Metres from one of the story's people within which seats stay free."""
_LANE = 1.0
"""Metres to either side of the line from one of them to the audience that stay free, unless far behind them."""
_NEAR, _APART = 2.0, 0.3
"""Metres from the story's people to the nearest group; metres between a group and everything else."""
_GROUPS = (2, 3, 2, 1, 3)
_RADIUS = {1: 0.0, 2: 0.42, 3: 0.55}
"""Metres from the middle of a group to its members, by their number."""
_GRID = 0.4


@dataclass(frozen=True)
class Bystander:
    """One figure: which it is and where it is.

    Attributes:
        posture: ``stand`` or ``sit``.
        variant: Which person.
        location: Floor point below it; of a sitter, the front edge of the seat at sitting height.
        yaw: Radians.
        seat: node_id of the seat.
    """

    posture: str
    variant: int
    location: tuple[float, float, float]
    yaw: float
    seat: str | None = None


def bystanders(view: SpatialPlannerView, layout: Layout, count: int, lanes: Sequence[Box]) -> list[Bystander]:
    """Return where the people of the background are: as many as told, or as find room.

    Args:
        view: Of the scene.
        layout: With everybody and everything of the story in place.
        count: How many are told.
        lanes: Floor that stays free for ways.
    """
    stage = Stage(view)
    for item in layout.objects:
        if item.node_id not in stage.things:
            stage.put(item, fixed=item.fixed)
    people = [(thing.box.x, thing.box.y) for thing in stage.things.values() if thing.walks]
    people = people or [stage.middle]
    seated = _seated(stage, people, round(_SITTING * count), set(view.targets))
    for number, lane in enumerate(lanes):
        stage.add(Thing(f"lane_{number}", lane, fixed=True), "")
    return [*seated, *_standing(stage, people, count - len(seated))]


def _seated(stage: Stage, people: Sequence[Vec2], most: int, wanted: set[str]) -> list[Bystander]:
    """Return the seated figures: on free seats, those nearest to the story's people first."""
    open_to_all: list[tuple[float, Bystander]] = []
    for name, anchor in free_seats(stage):
        base = stage.things[name].box
        x, y = base.to_world(*anchor.location[:2])
        away = min(math.dist((x, y), each) for each in people)
        if (
            not for_anybody(stage, name)
            or stage.assets[name] in wanted
            or away < _OWN_TABLE
            or _in_view((x, y), people)
        ):
            continue
        yaw = base.yaw + yaw_along(*anchor.direction[:2])
        spot = (x, y, base.z + anchor.location[2])
        open_to_all.append((away, Bystander("sit", 0, spot, yaw, name)))
    chosen = sorted(open_to_all, key=lambda each: (round(each[0], 2), each[1].seat or ""))[:most]
    return [
        Bystander("sit", index % VARIANTS, each.location, each.yaw, each.seat) for index, (_, each) in enumerate(chosen)
    ]


def _standing(stage: Stage, people: Sequence[Vec2], count: int) -> list[Bystander]:
    """Return the standing figures, in groups of one to three where there is room."""
    x0, x1, y0, y1 = stage.room
    grid = [(x, y) for x in np.arange(x0 + 0.5, x1 - 0.4, _GRID) for y in np.arange(y0 + 0.5, y1 - 0.4, _GRID)]
    found: list[Bystander] = []
    turn = 0
    while len(found) < count:
        size = min(_GROUPS[turn % len(_GROUPS)], count - len(found))
        points = np.array([point for point in grid if not _in_view(point, people, _RADIUS[size])])
        if not len(points):
            break
        away = np.min([np.hypot(points[:, 0] - x, points[:, 1] - y) for x, y in people], axis=0)
        fits = (stage.clearance(points) > _RADIUS[size] + _APART) & (away > _NEAR + _RADIUS[size])
        if not fits.any():
            if size == 1:
                break
            turn = 3  # where three do not stand, one may
            continue
        cost = away + 0.9 * np.abs(np.sin(1.7 * turn + 2.1 * points[:, 0])) + np.where(fits, 0.0, 1e6)
        x, y = (float(value) for value in points[int(np.argmin(np.round(cost, 4)))])
        for index in range(size):
            angle = 0.9 * turn + 2 * math.pi * index / size
            px, py = x + _RADIUS[size] * math.cos(angle), y + _RADIUS[size] * math.sin(angle)
            yaw = yaw_along(x - px, y - py) if size > 1 else yaw_along(people[0][0] - px, people[0][1] - py)
            found.append(Bystander("stand", len(found) % VARIANTS, (px, py, 0.0), yaw))
            box = Box(px, py, 0.0, 0.5, 0.4, 1.7, yaw)
            stage.add(Thing(f"bystander_{len(found)}", box, fixed=True), "")
        turn += 1
    return found


def _in_view(point: Vec2, people: Sequence[Vec2], radius: float = 0.0) -> bool:
    """Return whether a group of that radius stands between the story's people and the audience."""
    return any(abs(point[0] - x) < _LANE + radius and point[1] - radius < y - 0.3 for x, y in people)


def placed(
    found: Sequence[Bystander], assets: Sequence[Asset], measures: Mapping[str, AssetMeasure]
) -> tuple[LayoutObject, ...]:
    """Return the figures as objects of a layout.

    Args:
        found: Where they are.
        assets: The figure that each of them is.
        measures: Of the figures: a sitter is placed by the seat anchor below.
    """
    objects: list[LayoutObject] = []
    for number, (each, asset) in enumerate(zip(found, assets, strict=True)):
        x, y, z = each.location
        if each.seat is not None:
            seat = next(iter(measures[asset.asset_id].anchors), None)
            at = seat.location if seat is not None else (0.0, 0.0, z)
            cos, sin = math.cos(each.yaw), math.sin(each.yaw)
            x, y, z = x - at[0] * cos + at[1] * sin, y - at[0] * sin - at[1] * cos, z - at[2]
        objects.append(
            LayoutObject(
                node_id=f"{BYSTANDER}_{number}",
                asset_id=asset.asset_id,
                location=(round(x, 3), round(y, 3), round(max(z, 0.0), 3)),
                rotation=(0.0, 0.0, round(math.degrees(each.yaw), 2)),
                anchor_asset_id=each.seat,
                fixed=True,
            )
        )
    return tuple(objects)
