"""Light under the sky: sun or moon, the dome, lamps after dark, and the air between."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.visual_effects_artist.light_level import metered, scaled
from storyblender.agents.visual_effects_artist.lighting_view import (
    MOST_LIGHTS,
    LightingView,
    burning_lamps,
    mean_color,
    strongest,
)
from storyblender.catalog.light_recipes import GROUNDS, HOURS, WEATHERS, Hour, mix, open_sky_light, sky_of, sun_position
from storyblender.catalog.set_plan import SetPlan
from storyblender.look.raster import luminance
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Fog, Light, Lighting


def exterior(view: LightingView) -> Lighting:
    """Return the light plan of a place under the sky."""
    hour, weather = HOURS[view.setup.time_of_day], view.setup.weather
    air, ground = WEATHERS[weather], _ground_color(view)
    sky = sky_of(hour, weather, ground)
    side = 1.0 if view.environment.seed % 2 else -1.0
    azimuth = side * _sun_azimuth(view.plan, hour)
    where = sun_position(hour.elevation, azimuth)
    sun = Light(
        name="sun",
        kind="SUN",
        role="sun",
        location=where,
        target=(0.0, 0.0, 0.0),
        power=round(hour.sun * air.sun, 4),
        color=mix(hour.sun_color, (1.0, 1.0, 1.0), 0.7 * air.gray),
        size=1.0 + 12 * air.gray,
    )
    gloom = hour.lamps if air.level > 0.7 else max(hour.lamps, 0.5)
    level = hour.outside * air.level
    open_sky = open_sky_light(sky)
    gray = sum(open_sky) / 3
    bounce = scaled(ground, gray + hour.sun * air.sun * 0.15)
    ambient = mix(mix(open_sky, (gray, gray, gray), 0.35), bounce, 0.3)
    plan = Lighting(
        lights=strongest((sun, *burning_lamps(view, gloom)), MOST_LIGHTS),
        sky=sky,
        ambient=scaled(ambient, 0.75),
        fog=_air(view, hour, sky.horizon, where),
        rain=air.rain,
        face_luminance=round(max(0.15, hour.face * (0.6 + 0.4 * air.level)), 4),
        set_luminance=round(level, 4),
        key_color=_outdoor_key(view, hour),
        fill_color=(0.74, 0.84, 1.0),
        rim_color=hour.sun_color,
        key_fill_ratio=hour.ratio - 0.5 * air.gray,
    )
    return metered(plan, view.plan, all_lights=False)


def _outdoor_key(view: LightingView, hour: Hour) -> Color:
    """Return the colour of faces: sunlight softened; at night the lamps, or the moon where there are none."""
    if hour.lamps < 0.95:
        return mix(hour.sun_color, (1.0, 0.95, 0.9), 0.6)
    return (1.0, 0.78, 0.52) if burning_lamps(view, 1.0) else (0.7, 0.82, 1.0)


def _sun_azimuth(plan: SetPlan, hour: Hour) -> float:
    """Return the sun's place round the stage: raking along walls that face the audience, else a little behind."""
    built = sum(piece.part == "facade" for piece in plan.pieces) > 3
    if hour.elevation < 10:
        return 118.0 if built else 152.0
    return 58.0 if built else 104.0


def _ground_color(view: LightingView) -> Color:
    names = [slab.material for slab in view.plan.slabs if slab.role == "ground"]
    names += [str(piece.params["material"]) for piece in view.plan.pieces if piece.part == "terrain"]
    for stem, color in GROUNDS.items():
        if any(stem in name for name in names):
            return color
    return GROUNDS["grass"] if any("forest" in name for name in names) else GROUNDS["stone"]


def _air(view: LightingView, hour: Hour, horizon: Color, sun: Vec3) -> Fog:
    """Return the air: a thin haze by day, thicker at night and in woods, with the sun's glow in it."""
    air = WEATHERS[view.setup.weather]
    density, start, height = air.fog, air.fog_start, air.fog_height
    if hour.lamps > 0.4:
        density, start = max(density, 0.010 if hour.lamps > 0.95 else 0.006), min(start, 8.0)
    if view.plan.kit == "forest":
        density, start, height = max(density, 0.009), min(start, 8.0), min(height, 24.0)
    strength = (0.55 if hour.elevation < 10 else 0.22) * hour.sun * air.sun / 3
    length = math.hypot(*sun) or 1.0
    return Fog(
        color=_night_air(view, hour, horizon, air.level) if hour.lamps > 0.95 else scaled(horizon, 0.85),
        density=density,
        start=start,
        height=height,
        sun_direction=(sun[0] / length, sun[1] / length, sun[2] / length) if strength > 0.02 else None,
        sun_color=scaled(hour.sun_color, round(strength, 4)) if strength > 0.02 else (0.0, 0.0, 0.0),
    )


def _night_air(view: LightingView, hour: Hour, horizon: Color, level: float) -> Color:
    """Return the colour of night air: the sky's, lifted by the town's lamps that shine into it."""
    burning = burning_lamps(view, 1.0)
    thick = view.setup.weather in ("fog", "rain", "storm", "snow")
    tint = mix(horizon, mean_color(burning), 0.12) if burning else horizon
    wanted = hour.outside * level * ((2.4 if thick else 0.8) if burning else 0.6)
    return scaled(tint, wanted / max(float(luminance(np.asarray(tint, np.float32))), 1e-4))
