"""The light plan of a place outdoors: sun or moon, sky, lamps after dark, and the air."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.visual_effects_artist.light_level import scale_color, scale_lamps_to_level
from storyblender.agents.visual_effects_artist.lighting_arranger_view import (
    MOST_LIGHTS,
    LightingArrangerView,
    burning_lamps,
    mean_color,
    strongest_lights,
)
from storyblender.agents.visual_effects_artist.panorama_light import panorama_light
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

_FOGGY = 0.01
"""Density per metre from which air counts as fog."""
_DENSE = 0.03
"""Density per metre from which fog hides what is 40 m away."""
_LIT_FOG = 1.4
"""Factor on the light level where fog spreads the light of lamps."""
_AIRLIGHT = 0.7
"""Share of the fog's brightness that falls on things in it."""
_BY_DAY = 0.03
"""Share of the wanted level that lamps give by day."""
_AFTER_DARK = 0.95
"""Share of burning lamps from which it counts as dark."""
_NIGHT_SHARE, _WALLS = 0.5, 0.26
"""Share of the wanted light level that is ambient after dark; reflectance of an average wall."""
_MOONLIGHT: Color = (0.72, 0.94, 1.5)
"""Moonlight colour, of luminance one."""
_FOG_BLUE: Color = (0.72, 0.88, 1.0)
"""Lit fog at night: grey with a little of the sky's blue."""


def light_exterior(view: LightingArrangerView) -> Lighting:
    """Return the light plan of a place outdoors, or in a vehicle outdoors, in which no rain falls."""
    hour, weather = HOURS[view.setup.time_of_day], view.setup.weather
    air, ground = WEATHERS[weather], _ground_color(view)
    sky = sky_of(hour, weather, ground)
    side = 1.0 if view.sun_from_left else -1.0
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
    level = hour.outside * _light_share(hour, air)
    open_sky = open_sky_light(sky)
    gray = sum(open_sky) / 3
    bounce = scale_color(ground, gray + hour.sun * air.sun * 0.15)
    ambient = mix(mix(open_sky, (gray, gray, gray), 0.35), bounce, 0.3)
    fog = _make_air(view, hour, sky.horizon, where)
    ambient = scale_color(ambient, 0.75)
    if gloom and air.fog > _FOGGY:  # thick air that glows with lamps lights what stands in it from all sides
        ambient = _brighter(ambient, scale_color(fog.color, _AIRLIGHT))
    if hour.lamps > _AFTER_DARK:
        ambient = _add_moonlight(ambient, level)
    plan = Lighting(
        lights=strongest_lights((sun, *burning_lamps(view, gloom)), MOST_LIGHTS),
        sky=sky,
        panorama=panorama_light(view, sky, ambient, sun),
        ambient=ambient,
        fog=fog,
        rain=0.0 if view.plan.indoor else air.rain,
        face_luminance=round(max(0.15, hour.face * (0.6 + 0.4 * air.level)), 4),
        set_luminance=round(level, 4),
        key_color=_key_color(view, hour),
        fill_color=(0.74, 0.84, 1.0),
        rim_color=hour.sun_color,
        key_fill_ratio=hour.ratio - 0.5 * air.gray,
    )
    # Lamps that burn by day for the gloom of a storm are points of light: they do not light the place, nor its air.
    return scale_lamps_to_level(plan, view.plan, all_lights=False, share=None if hour.lamps else _BY_DAY)


def _add_moonlight(ambient: Color, level: float) -> Color:
    """Return the ambient light after dark, raised so that the place can be made out between its lamps."""
    wanted = _NIGHT_SHARE * level / _WALLS
    here = float(luminance(np.asarray(ambient, np.float32)))
    return (
        ambient
        if here >= wanted
        else mix(scale_color(ambient, wanted / max(here, 1e-4)), scale_color(_MOONLIGHT, wanted), 0.5)
    )


def _brighter(a: Color, b: Color) -> Color:
    """Return whichever colour is the brighter one."""
    return a if sum(a) >= sum(b) else b


def _key_color(view: LightingArrangerView, hour: Hour) -> Color:
    """Return the colour of the key light: softened sunlight; at night the lamps', or the moon's if there are none."""
    if hour.lamps < _AFTER_DARK:
        return mix(hour.sun_color, (1.0, 0.95, 0.9), 0.6)
    return (1.0, 0.78, 0.52) if burning_lamps(view, 1.0) else (0.7, 0.82, 1.0)


def _sun_azimuth(plan: SetPlan, hour: Hour) -> float:
    """Return the sun's azimuth in degrees: along facades that face the audience, else a little behind the stage."""
    built = sum(piece.part == "facade" for piece in plan.pieces) > 3
    if hour.elevation < 10:
        return 118.0 if built else 152.0
    return 58.0 if built else 104.0


def _ground_color(view: LightingArrangerView) -> Color:
    """Return the colour of the ground's material."""
    names = [slab.material for slab in view.plan.slabs if slab.role == "ground"]
    names += [str(piece.params["material"]) for piece in view.plan.pieces if piece.part == "terrain"]
    for stem, color in GROUNDS.items():
        if any(stem in name for name in names):
            return color
    return GROUNDS["grass"] if any("forest" in name for name in names) else GROUNDS["stone"]


def _make_air(view: LightingArrangerView, hour: Hour, horizon: Color, sun: Vec3) -> Fog:
    """Return the fog: a thin haze by day, thicker at night and in woods, with the sun's glow in it."""
    air = WEATHERS[view.setup.weather]
    density, start, height = air.fog, air.fog_start, air.fog_height
    if hour.lamps > 0.4:
        density, start = max(density, 0.010 if hour.lamps > _AFTER_DARK else 0.006), min(start, 8.0)
    if view.plan.kit == "forest":
        density, start, height = max(density, 0.009), min(start, 8.0), min(height, 24.0)
    strength = (0.55 if hour.elevation < 10 else 0.22) * hour.sun * air.sun / 3
    length = math.hypot(*sun) or 1.0
    return Fog(
        color=_night_air_color(view, hour, horizon, air) if hour.lamps > _AFTER_DARK else scale_color(horizon, 0.85),
        density=density,
        start=start,
        height=height,
        sun_direction=(sun[0] / length, sun[1] / length, sun[2] / length) if strength > 0.02 else None,
        sun_color=scale_color(hour.sun_color, round(strength, 4)) if strength > 0.02 else (0.0, 0.0, 0.0),
    )


def _night_air_color(view: LightingArrangerView, hour: Hour, horizon: Color, air: Air) -> Color:
    """Return the colour of night air: the sky's, lifted by the lamps that shine into it."""
    burning = burning_lamps(view, 1.0)
    tint = mix(horizon, mean_color(burning), 0.12) if burning else horizon
    if air.fog > _FOGGY:
        tint = mix(scale_color(tint, 1 / max(tint)), _FOG_BLUE, 0.6)
    glow = 1.5 if air.fog > _DENSE else 0.9 if air.fog > _FOGGY else 0.5
    wanted = hour.outside * _light_share(hour, air) * glow * (1.0 if burning else 0.75)
    return scale_color(tint, wanted / max(float(luminance(np.asarray(tint, np.float32))), 1e-4))


def _light_share(hour: Hour, air: Air) -> float:
    """Return the share of the hour's light under a weather: clouds dim the sky, not the lamps; lit fog adds."""
    night = air.level + (1.0 - air.level) * hour.lamps
    return night * (_LIT_FOG if hour.lamps > _AFTER_DARK and air.fog > _DENSE else 1.0)
