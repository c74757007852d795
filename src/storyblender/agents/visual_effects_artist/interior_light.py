"""Light in rooms: windows by day, lamps by night, and the sun's pool on the floor."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from storyblender.agents.visual_effects_artist.light_level import metered, scaled
from storyblender.agents.visual_effects_artist.lighting_view import (
    MOST_LIGHTS,
    LightingView,
    burning_lamps,
    mean_color,
    strongest,
)
from storyblender.catalog.light_recipes import GROUNDS, HOURS, WEATHERS, Hour, area_watts, mix, sky_of
from storyblender.catalog.set_plan import SetPlan, Wall
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Fog, Light, Lighting


def interior(view: LightingView) -> Lighting:
    """Return the light plan of a room."""
    hour, air = HOURS[view.setup.time_of_day], WEATHERS[view.setup.weather]
    openings = list(_window_walls(view.plan))
    day = hour.lamps < 0.3
    lamps = burning_lamps(view, 1.0 if not openings else hour.lamps)
    if not lamps and not day:
        lamps = (_ceiling_wash(view.plan, 0.5, (1.0, 0.8, 0.58)),)
    lights: list[Light] = []
    brightness = sum(hour.horizon) / 3 * air.dim
    for wall, centre, inward, size in openings:
        lights.append(
            _window_light(wall, centre, inward, size, level=0.25 + 1.5 * brightness, hour=hour, grey=air.gray)
        )
    if openings and hour.sun * air.sun > 0.4 and hour.elevation < 60:
        lights.append(_sun_through(openings, hour, air.sun, view.environment.seed))
    if day and openings:
        lights.append(_ceiling_wash(view.plan, 0.22, mix(hour.horizon, (1.0, 0.96, 0.9), 0.6)))
    elif lamps:
        lights.append(_ceiling_wash(view.plan, 0.1, (1.0, 0.80, 0.58)))
    warm = mean_color(lamps) if lamps else (1.0, 0.94, 0.86)
    lit_room = not openings and day
    outside = sky_of(hour, view.setup.weather, GROUNDS["stone"])
    plan = Lighting(
        lights=strongest((*lights, *lamps), MOST_LIGHTS),
        sky=outside,
        ambient=mix((0.05, 0.042, 0.034), (0.15, 0.155, 0.16), 1.0 if day and openings else 0.15),
        fog=Fog(color=scaled(warm, 0.012 if not day else 0.03), density=0.008 if not day else 0.004, start=3.0),
        face_luminance=hour.face if not lit_room else 0.21,
        set_luminance=round((hour.inside if not lit_room else 0.075) * (1.0 if not day else 0.5 + 0.5 * air.level), 4),
        key_color=mix(warm, (1.0, 0.95, 0.88), 0.55) if lamps else mix(hour.sun_color, (1.0, 0.97, 0.93), 0.6),
        fill_color=(0.78, 0.86, 1.0) if day else (0.62, 0.75, 1.0),
        rim_color=hour.sun_color if day else (0.72, 0.83, 1.0) if openings else warm,
        key_fill_ratio=2.8 if day and openings else 3.6,
    )
    return metered(plan, view.plan, all_lights=True)


def _window_walls(plan: SetPlan) -> Iterator[tuple[Wall, Vec3, tuple[float, float], float]]:
    """Yield each wall with windows: the middle of its windows, the way into the room, the size of the opening."""
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
        yield wall, (float(middle[0]), float(middle[1]), float(z)), (-float(along[1]), float(along[0])), math.sqrt(area)


def _window_light(
    wall: Wall, centre: Vec3, inward: tuple[float, float], size: float, *, level: float, hour: Hour, grey: float
) -> Light:
    x, y, z = centre
    diameter = min(max(size * 1.2, 0.8), 3.4)
    night = hour.lamps > 0.95
    color = (
        (0.40, 0.56, 1.0)
        if night
        else mix(scaled(hour.horizon, 1 / max(hour.horizon)), (0.8, 0.88, 1.0), 0.4 + 0.3 * grey)
    )
    return Light(
        name=f"{wall.node_id}_daylight",
        kind="AREA",
        role="set",
        location=(round(x + 0.15 * inward[0], 3), round(y + 0.15 * inward[1], 3), z),
        target=(round(x + 4 * inward[0], 3), round(y + 4 * inward[1], 3), 0.6),
        power=round(area_watts(level * (0.35 if night else 0.7), 3.0, diameter), 2),
        color=color,
        size=diameter,
    )


def _sun_through(
    openings: list[tuple[Wall, Vec3, tuple[float, float], float]], hour: Hour, share: float, seed: int
) -> Light:
    """Return a sun that falls through the largest windows: a pool of light on the floor."""
    _, centre, inward, _ = max(openings, key=lambda item: item[3] * (0.3 if item[0].node_id == "wall_front" else 1.0))
    turn = math.radians(28.0 if seed % 2 else -28.0)
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


def _ceiling_wash(plan: SetPlan, level: float, color: Color) -> Light:
    """Return the soft light that a room's ceiling and walls throw back."""
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
        power=round(area_watts(level, ceiling - 1.0, diameter), 2),
        color=color,
        size=diameter,
    )
