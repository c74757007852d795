"""Light under the sky: sun or moon, the dome, lamps after dark, and the air between."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.visual_effects_artist.light_level import metered, scaled
from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    MOST_LIGHTS,
    LightingArrangerView,
    burning_lamps,
    mean_color,
    strongest,
)
from storyblender.catalog.light_recipes import (
    GROUNDS,
    HOURS,
    WEATHERS,
    Air,
    Hour,
    mix,
    open_sky_light,
    sky_of,
    sun_position,
)
from storyblender.catalog.set_plan import SetPlan
from storyblender.look.raster import luminance
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Fog, Light, Lighting

_THICK = 0.01
"""Density per metre from which air counts as fog."""
_SOUP = 0.03
"""Density from which it hides a plane at forty metres."""
_LIT_FOG = 1.4
"""Fog spreads the light of lamps over the whole place."""
_AIRLIGHT = 0.7
"""Share of the fog's own brightness that falls on what stands in it."""
_BY_DAY = 0.03
"""Share of the wanted level that lamps give by day."""
_AFTER_DARK = 0.95
"""Share of burning lamps above which it counts as dark."""
_NIGHT_SHARE, _WALLS = 0.5, 0.26
"""Share of the wanted light level that is ambient after dark; reflectance of an average wall."""
_MOONLIGHT: Color = (0.72, 0.94, 1.5)
"""Moonlight colour, of luminance one."""
_FOG_BLUE: Color = (0.72, 0.88, 1.0)
"""Lit fog at night: grey with a little of the sky's blue."""


def exterior(view: LightingArrangerView) -> Lighting:
    """Return the light plan of a place under the sky; no rain falls into one with a roof, such as a car."""
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
    level = hour.outside * _openness(hour, air)
    open_sky = open_sky_light(sky)
    gray = sum(open_sky) / 3
    bounce = scaled(ground, gray + hour.sun * air.sun * 0.15)
    ambient = mix(mix(open_sky, (gray, gray, gray), 0.35), bounce, 0.3)
    fog = _air(view, hour, sky.horizon, where)
    ambient = scaled(ambient, 0.75)
    if gloom and air.fog > _THICK:  # thick air that glows with lamps lights what stands in it from all sides
        ambient = _brighter(ambient, scaled(fog.color, _AIRLIGHT))
    if hour.lamps > _AFTER_DARK:
        ambient = _moonlit(ambient, level)
    plan = Lighting(
        lights=strongest((sun, *burning_lamps(view, gloom)), MOST_LIGHTS),
        sky=sky,
        ambient=ambient,
        fog=fog,
        rain=0.0 if view.plan.indoor else air.rain,
        face_luminance=round(max(0.15, hour.face * (0.6 + 0.4 * air.level)), 4),
        set_luminance=round(level, 4),
        key_color=_outdoor_key(view, hour),
        fill_color=(0.74, 0.84, 1.0),
        rim_color=hour.sun_color,
        key_fill_ratio=hour.ratio - 0.5 * air.gray,
    )
    # Lamps that burn by day for the gloom of a storm are points of light: they do not light the place, nor its air.
    return metered(plan, view.plan, all_lights=False, share=None if hour.lamps else _BY_DAY)


def _moonlit(ambient: Color, level: float) -> Color:
    """Return the ambient light after dark: enough to make out the place between its lamps, as in films."""
    wanted = _NIGHT_SHARE * level / _WALLS
    here = float(luminance(np.asarray(ambient, np.float32)))
    return (
        ambient if here >= wanted else mix(scaled(ambient, wanted / max(here, 1e-4)), scaled(_MOONLIGHT, wanted), 0.5)
    )


def _brighter(a: Color, b: Color) -> Color:
    """Return whichever colour is the brighter one."""
    return a if sum(a) >= sum(b) else b


def _outdoor_key(view: LightingArrangerView, hour: Hour) -> Color:
    """Return the colour of faces: sunlight softened; at night the lamps, or the moon where there are none."""
    if hour.lamps < _AFTER_DARK:
        return mix(hour.sun_color, (1.0, 0.95, 0.9), 0.6)
    return (1.0, 0.78, 0.52) if burning_lamps(view, 1.0) else (0.7, 0.82, 1.0)


def _sun_azimuth(plan: SetPlan, hour: Hour) -> float:
    """Return the sun's place round the stage: raking along walls that face the audience, else a little behind."""
    built = sum(piece.part == "facade" for piece in plan.pieces) > 3
    if hour.elevation < 10:
        return 118.0 if built else 152.0
    return 58.0 if built else 104.0


def _ground_color(view: LightingArrangerView) -> Color:
    names = [slab.material for slab in view.plan.slabs if slab.role == "ground"]
    names += [str(piece.params["material"]) for piece in view.plan.pieces if piece.part == "terrain"]
    for stem, color in GROUNDS.items():
        if any(stem in name for name in names):
            return color
    return GROUNDS["grass"] if any("forest" in name for name in names) else GROUNDS["stone"]


def _air(view: LightingArrangerView, hour: Hour, horizon: Color, sun: Vec3) -> Fog:
    """Return the air: a thin haze by day, thicker at night and in woods, with the sun's glow in it."""
    air = WEATHERS[view.setup.weather]
    density, start, height = air.fog, air.fog_start, air.fog_height
    if hour.lamps > 0.4:
        density, start = max(density, 0.010 if hour.lamps > _AFTER_DARK else 0.006), min(start, 8.0)
    if view.plan.kit == "forest":
        density, start, height = max(density, 0.009), min(start, 8.0), min(height, 24.0)
    strength = (0.55 if hour.elevation < 10 else 0.22) * hour.sun * air.sun / 3
    length = math.hypot(*sun) or 1.0
    return Fog(
        color=_night_air(view, hour, horizon, air) if hour.lamps > _AFTER_DARK else scaled(horizon, 0.85),
        density=density,
        start=start,
        height=height,
        sun_direction=(sun[0] / length, sun[1] / length, sun[2] / length) if strength > 0.02 else None,
        sun_color=scaled(hour.sun_color, round(strength, 4)) if strength > 0.02 else (0.0, 0.0, 0.0),
    )


def _night_air(view: LightingArrangerView, hour: Hour, horizon: Color, air: Air) -> Color:
    """Return the colour of night air: the sky's, lifted by the town's lamps that shine into it."""
    burning = burning_lamps(view, 1.0)
    tint = mix(horizon, mean_color(burning), 0.12) if burning else horizon
    if air.fog > _THICK:
        tint = mix(scaled(tint, 1 / max(tint)), _FOG_BLUE, 0.6)
    glow = 1.5 if air.fog > _SOUP else 0.9 if air.fog > _THICK else 0.5
    wanted = hour.outside * _openness(hour, air) * glow * (1.0 if burning else 0.75)
    return scaled(tint, wanted / max(float(luminance(np.asarray(tint, np.float32))), 1e-4))


def _openness(hour: Hour, air: Air) -> float:
    """Return the share of the hour's light under a weather: clouds take the sky's, not the lamps'; lit fog adds."""
    night = air.level + (1.0 - air.level) * hour.lamps
    return night * (_LIT_FOG if hour.lamps > _AFTER_DARK and air.fog > _SOUP else 1.0)
