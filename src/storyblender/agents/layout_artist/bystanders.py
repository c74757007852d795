"""Places the people of the background: figures on free seats and in small groups, out of the story's way.

The figures are built once and shared; nobody speaks to them and the camera does not look for them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from storyblender.agents.layout_artist.crowd_places import is_public_seat
from storyblender.agents.layout_artist.layout_stage import LayoutStage
from storyblender.agents.layout_artist.people_seats import free_seats
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.catalog.bystanders import BYSTANDER, VARIANTS
from storyblender.geometry.boxes import Box, yaw_along
from storyblender.geometry.relations import LayoutThing
from storyblender.memory.asset_sheet import Asset
from storyblender.memory.base import Vec2
from storyblender.memory.measure import AssetMeasure
from storyblender.memory.scene_context import Layout, LayoutObject
from storyblender.memory.vocabulary import Crowd

_SITTING = 0.6
"""Share of the figures that sit if there are seats."""
_OWN_TABLE = 2.2
"""Metres from a person of the story within which seats stay free."""
_LANE = 1.0
"""Metres on either side of the line from a person of the story to the audience that stay free."""
_NEAR, _APART = 2.0, 0.3
"""Metres from the story's people to the nearest group; metres between a group and everything else."""
_GROUPS = (2, 3, 2, 1, 3)
_RADIUS = {1: 0.0, 2: 0.42, 3: 0.55}
"""Metres from the middle of a group to its members, by their number."""
_GRID = 0.4
_CROWDS: dict[Crowd, int] = {"busy": 12, "full": 16}
_LARGE_AREA, _LARGE_EXTRA = 80.0, 8
"""Square metres above which a place holds more people, and how many more."""


@dataclass(frozen=True)
class Bystander:
    """One figure of the background.

    Attributes:
        posture: ``stand`` or ``sit``.
        variant: Number of the figure's look.
        location: World metres: floor point, or the middle of the seat's front edge.
        yaw: Radians.
        seat: node_id of the seat; None for a standing figure.
    """

    posture: str
    variant: int
    location: tuple[float, float, float]
    yaw: float
    seat: str | None = None


def crowd_size(crowd: Crowd | None, area: float) -> int:
    """Return the number of people in a place, those of the story included; 0 if the script wants no crowd.

    Args:
        crowd: How full the script says the place is; None if it does not say.
        area: Square metres of floor.
    """
    return _CROWDS[crowd] + (_LARGE_EXTRA if area > _LARGE_AREA else 0) if crowd else 0


def place_bystanders(view: SpatialPlannerView, layout: Layout, count: int, lanes: Sequence[Box]) -> list[Bystander]:
    """Return the figures of the background: as many as wanted, or as find room.

    Args:
        view: The scene.
        layout: Its layout, with everybody and everything of the story.
        count: Number of figures wanted.
        lanes: Boxes of the floor that stay free for walks.
    """
    stage = LayoutStage(view)
    for item in layout.objects:
        if item.node_id not in stage.things:
            stage.add_object(item, fixed=item.fixed)
    people = [(thing.box.x, thing.box.y) for thing in stage.things.values() if thing.walks]
    people = people or [stage.middle]
    seated = _choose_seats(stage, people, round(_SITTING * count), set(view.targets))
    for number, lane in enumerate(lanes):
        stage.add(LayoutThing(f"lane_{number}", lane, fixed=True), "")
    return [*seated, *_place_standing_groups(stage, people, count - len(seated))]


def _choose_seats(stage: LayoutStage, people: Sequence[Vec2], most: int, wanted: set[str]) -> list[Bystander]:
    """Return at most ``most`` seated figures, those nearest to the story's people first; not on ``wanted`` assets."""
    open_to_all: list[tuple[float, Bystander]] = []
    for name, anchor in free_seats(stage):
        base = stage.things[name].box
        x, y = base.to_world(*anchor.location[:2])
        away = min(math.dist((x, y), each) for each in people)
        if (
            not is_public_seat(stage, name)
            or stage.assets[name] in wanted
            or away < _OWN_TABLE
            or _blocks_view((x, y), people)
        ):
            continue
        yaw = base.yaw + yaw_along(*anchor.direction[:2])
        spot = (x, y, base.z + anchor.location[2])
        open_to_all.append((away, Bystander("sit", 0, spot, yaw, name)))
    chosen = sorted(open_to_all, key=lambda each: (round(each[0], 2), each[1].seat or ""))[:most]
    return [
        Bystander("sit", index % VARIANTS, each.location, each.yaw, each.seat) for index, (_, each) in enumerate(chosen)
    ]


def _place_standing_groups(stage: LayoutStage, people: Sequence[Vec2], count: int) -> list[Bystander]:
    """Return ``count`` standing figures in groups of one to three; fewer if there is no room."""
    x0, x1, y0, y1 = stage.room
    grid = [(x, y) for x in np.arange(x0 + 0.5, x1 - 0.4, _GRID) for y in np.arange(y0 + 0.5, y1 - 0.4, _GRID)]
    found: list[Bystander] = []
    turn = 0
    while len(found) < count:
        size = min(_GROUPS[turn % len(_GROUPS)], count - len(found))
        points = np.array([point for point in grid if not _blocks_view(point, people, _RADIUS[size])])
        if not len(points):
            break
        away = np.min([np.hypot(points[:, 0] - x, points[:, 1] - y) for x, y in people], axis=0)
        fits = (stage.clearance(points) > _RADIUS[size] + _APART) & (away > _NEAR + _RADIUS[size])
        if not fits.any():
            if size == 1:
                break
            turn = 3  # no room for this size: try a single figure
            continue
        cost = away + 0.9 * np.abs(np.sin(1.7 * turn + 2.1 * points[:, 0])) + np.where(fits, 0.0, 1e6)
        x, y = (float(value) for value in points[int(np.argmin(np.round(cost, 4)))])
        for index in range(size):
            angle = 0.9 * turn + 2 * math.pi * index / size
            px, py = x + _RADIUS[size] * math.cos(angle), y + _RADIUS[size] * math.sin(angle)
            yaw = yaw_along(x - px, y - py) if size > 1 else yaw_along(people[0][0] - px, people[0][1] - py)
            found.append(Bystander("stand", len(found) % VARIANTS, (px, py, 0.0), yaw))
            box = Box(px, py, 0.0, 0.5, 0.4, 1.7, yaw)
            stage.add(LayoutThing(f"bystander_{len(found)}", box, fixed=True), "")
        turn += 1
    return found


def _blocks_view(point: Vec2, people: Sequence[Vec2], radius: float = 0.0) -> bool:
    """Return whether a group of a radius in metres stands between the story's people and the audience."""
    return any(abs(point[0] - x) < _LANE + radius and point[1] - radius < y - 0.3 for x, y in people)


def bystander_objects(
    found: Sequence[Bystander], assets: Sequence[Asset], measures: Mapping[str, AssetMeasure]
) -> tuple[LayoutObject, ...]:
    """Return the figures as objects of a layout.

    Args:
        found: The figures.
        assets: Asset of each figure, in the same order.
        measures: Measures of these assets; a sitter is placed by its seat anchor.
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
