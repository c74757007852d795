"""Light in rooms: windows by day, lamps by night, and the sun's pool on the floor."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from storyblender.agents.visual_effects_artist.light_level import scale_color, scale_lamps_to_level
from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    MOST_LIGHTS,
    LightingArrangerView,
    burning_lamps,
    mean_color,
    strongest_lights,
)
from storyblender.catalog.light_recipes import GROUNDS, HOURS, WEATHERS, Hour, area_watts, mix, sky_of
from storyblender.catalog.set_plan import SetPlan, Wall
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Fog, Light, Lighting


class WindowWall(NamedTuple):
    """A wall with windows, which light the room like one window.

    Attributes:
        wall: The wall.
        centre: Mean centre of the windows, weighted by area; metres in the set.
        inward: Unit vector on the floor, from the wall into the room.
        size: Side of a square with the area of all the windows, metres.
    """

    wall: Wall
    centre: Vec3
    inward: tuple[float, float]
    size: float


def light_interior(view: LightingArrangerView) -> Lighting:
    """Return the light plan of a room."""
    hour, air = HOURS[view.setup.time_of_day], WEATHERS[view.setup.weather]
    openings = list(_find_window_walls(view.plan))
    day = hour.lamps < 0.3
    lamps = burning_lamps(view, 1.0 if not openings else hour.lamps)
    if not lamps and not day:
        lamps = (_make_ceiling_light(view.plan, 0.5, (1.0, 0.8, 0.58)),)
    lights: list[Light] = []
    brightness = sum(hour.horizon) / 3 * air.dim
    for opening in openings:
        lights.append(_make_window_light(opening, luminance=0.25 + 1.5 * brightness, hour=hour, grayness=air.gray))
    if openings and hour.sun * air.sun > 0.4 and hour.elevation < 60:
        lights.append(_make_window_sun(openings, hour, air.sun, from_left=view.sun_from_left))
    if day and openings:
        lights.append(_make_ceiling_light(view.plan, 0.22, mix(hour.horizon, (1.0, 0.96, 0.9), 0.6)))
    elif lamps:
        lights.append(_make_ceiling_light(view.plan, 0.1, (1.0, 0.80, 0.58)))
    warm = mean_color(lamps) if lamps else (1.0, 0.94, 0.86)
    lit_room = not openings and day
    outside = sky_of(hour, view.setup.weather, GROUNDS["stone"])
    plan = Lighting(
        lights=strongest_lights((*lights, *lamps), MOST_LIGHTS),
        sky=outside,
        ambient=mix((0.05, 0.042, 0.034), (0.15, 0.155, 0.16), 1.0 if day and openings else 0.15),
        fog=Fog(color=scale_color(warm, 0.012 if not day else 0.03), density=0.008 if not day else 0.004, start=3.0),
        face_luminance=hour.face if not lit_room else 0.21,
        set_luminance=round((hour.inside if not lit_room else 0.075) * (1.0 if not day else 0.5 + 0.5 * air.level), 4),
        key_color=mix(warm, (1.0, 0.95, 0.88), 0.55) if lamps else mix(hour.sun_color, (1.0, 0.97, 0.93), 0.6),
        fill_color=(0.78, 0.86, 1.0) if day else (0.62, 0.75, 1.0),
        rim_color=hour.sun_color if day else (0.72, 0.83, 1.0) if openings else warm,
        key_fill_ratio=2.8 if day and openings else 3.6,
    )
    return scale_lamps_to_level(plan, view.plan, all_lights=True)


def _find_window_walls(plan: SetPlan) -> Iterator[WindowWall]:
    """Yield every wall of a set that has windows without bars."""
    for wall in plan.walls:
        windows = [opening for opening in wall.openings if opening.kind == "window" and opening.style != "bars"]
        if not windows:
            continue
        span = np.subtract(wall.end, wall.start)
        along = span / np.linalg.norm(span)
        area = sum(window.width * window.height for window in windows)
        x = sum((window.x + window.width / 2) * window.width * window.height for window in windows) / area
        z = (
            wall.base
            + sum((window.sill + window.height / 2) * window.width * window.height for window in windows) / area
        )
        middle = np.add(wall.start, along * x)
        centre = (float(middle[0]), float(middle[1]), float(z))
        yield WindowWall(wall, centre, inward=(-float(along[1]), float(along[0])), size=math.sqrt(area))


def _make_window_light(opening: WindowWall, *, luminance: float, hour: Hour, grayness: float) -> Light:
    """Return the area light of the sky that shines into a room through the windows of a wall.

    Args:
        opening: The wall and its windows.
        luminance: Luminance of a white surface 3 m in front of the windows; 0.7 of it is used by day, 0.35 by night.
        hour: The time of day, which gives the colour.
        grayness: Share of gray in the colour of the sky, 0 in clear weather.
    """
    (x, y, z), inward = opening.centre, opening.inward
    diameter = min(max(opening.size * 1.2, 0.8), 3.4)
    night = hour.lamps > 0.95
    color = (
        (0.40, 0.56, 1.0)
        if night
        else mix(scale_color(hour.horizon, 1 / max(hour.horizon)), (0.8, 0.88, 1.0), 0.4 + 0.3 * grayness)
    )
    return Light(
        name=f"{opening.wall.node_id}_daylight",
        kind="AREA",
        role="set",
        location=(round(x + 0.15 * inward[0], 3), round(y + 0.15 * inward[1], 3), z),
        target=(round(x + 4 * inward[0], 3), round(y + 4 * inward[1], 3), 0.6),
        power=round(area_watts(luminance * (0.35 if night else 0.7), 3.0, diameter), 2),
        color=color,
        size=diameter,
    )


def _make_window_sun(openings: list[WindowWall], hour: Hour, share: float, *, from_left: bool) -> Light:
    """Return the sun light that falls through the largest windows and makes a pool on the floor.

    Args:
        openings: The walls with windows; the front wall counts least.
        hour: The time of day; it gives the sun's elevation, power and colour.
        share: Share of the sun that the weather lets through, 0 to 1.
        from_left: Whether the sun comes from the left, seen from inside the room; else from the right.
    """
    largest = max(openings, key=lambda item: item.size * (0.3 if item.wall.node_id == "wall_front" else 1.0))
    centre, inward = largest.centre, largest.inward
    turn = math.radians(28.0 if from_left else -28.0)
    dx = inward[0] * math.cos(turn) - inward[1] * math.sin(turn)
    dy = inward[0] * math.sin(turn) + inward[1] * math.cos(turn)
    drop = math.tan(math.radians(min(max(hour.elevation, 12.0), 34.0)))
    return Light(
        name="sun",
        kind="SUN",
        role="sun",
        location=(round(centre[0] - 10 * dx, 3), round(centre[1] - 10 * dy, 3), round(centre[2] + 10 * drop, 3)),
        target=centre,
        power=round(hour.sun * share, 3),
        color=hour.sun_color,
        size=1.0,
    )


def _make_ceiling_light(plan: SetPlan, luminance: float, color: Color) -> Light:
    """Return the soft area light under the ceiling that stands for light reflected by ceiling and walls.

    Args:
        plan: The set.
        luminance: Wanted luminance of a white surface that faces the light, 1 m above the floor.
        color: Colour of the light, scene-linear.
    """
    size = plan.size
    ceiling = next((slab.z for slab in plan.slabs if slab.role == "ceiling"), 3.0)
    width = min(size.x - size.x_negative, size.y - size.y_negative)
    diameter = min(max(0.55 * width, 1.6), 6.0)
    middle = ((size.x + size.x_negative) / 2, (size.y + size.y_negative) / 2)
    return Light(
        name="ceiling_bounce",
        kind="AREA",
        role="set",
        location=(*middle, round(ceiling - 0.06, 3)),
        target=(*middle, 0.0),
        power=round(area_watts(luminance, ceiling - 1.0, diameter), 2),
        color=color,
        size=diameter,
    )
