"""Scales the lamps of a light plan so that the stage has about the light level that its recipe asks for."""

from __future__ import annotations

import math

import numpy as np

from storyblender.catalog.set_plan import SetPlan
from storyblender.look.illumination import light_field
from storyblender.look.raster import luminance
from storyblender.memory.base import Color
from storyblender.memory.scene_context import Light, Lighting

_GREY = 0.18
_MEAN_OVER_GEOMETRIC = 1.6
"""Ratio of the mean to the geometric mean of light in pools; the renderer's meter takes the geometric mean."""
_LEAST_SHARE = 0.3
"""Least share of the wanted level that burning lamps give, so that they are seen to burn."""
_AMONG_PEOPLE, _BESIDE = 1.6, 1.2
"""Metres of height below which a lamp burns among people, and metres between them and it."""
_HOTTEST = 8.0
"""Largest multiple of the wanted level that such a lamp gives to a person beside it."""


def scale_lamps_to_level(
    lighting: Lighting, plan: SetPlan, *, all_lights: bool, share: float | None = None
) -> Lighting:
    """Return the plan with its lamps scaled so that grey shows near ``set_luminance`` where people act.

    The renderer's meter then has little to correct, and sky and air keep their brightness.

    Args:
        lighting: The plan of the recipe.
        plan: The set, for its playing area.
        all_lights: Whether window light and ambient light are scaled too; else only practical lamps.
        share: Share of the wanted level that the lamps give; None for what other light leaves.
    """
    size = plan.size
    xs, ys = np.linspace(size.x_negative, size.x, 5), np.linspace(size.y_negative, size.y, 5)
    normals = np.array([(0, 0, 1), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)], np.float32)
    places = np.array([(x, y, z) for x in xs for y in ys for z in (0.02, 1.3)], np.float32)
    positions = np.repeat(places, len(normals), axis=0)[None]
    facing = np.tile(normals, (len(places), 1))[None]

    def level(lights: tuple[Light, ...]) -> float:
        fields = (light_field(light, positions, facing) for light in lights)
        return sum(float(field.amount.mean() * luminance(np.asarray(field.light.color))) for field in fields)

    scaling: tuple[Light, ...] = tuple(light for light in lighting.lights if all_lights or light.role == "practical")
    fixed = tuple(light for light in lighting.lights if light not in scaling)
    ambient = float(luminance(np.asarray(lighting.ambient, np.float32)))
    rest = level(fixed) + (0.0 if all_lights else 0.8 * ambient)
    given = level(scaling) + (0.8 * ambient if all_lights else 0.0)
    if given < 1e-6:
        return lighting
    wanted = lighting.set_luminance / _GREY * _MEAN_OVER_GEOMETRIC
    own = max(wanted - rest, _LEAST_SHARE * wanted) if share is None else share * wanted
    gain = min(own / given, 30.0)
    # Outdoors a lamp is raised for the whole place; a halo raised as much would cover everything.
    air = 1.0 if all_lights else max(gain, 1.0) ** -0.5

    def raised(light: Light) -> Light:
        power = light.power * gain
        if not all_lights and light.location[2] < _AMONG_PEOPLE:  # a fire: people sit near it
            power = min(power, _HOTTEST * wanted * 4 * math.pi**2 * _BESIDE**2)
        return light.model_copy(update={"power": round(power, 3), "glow": round(light.glow * air, 4)})

    lights = tuple(raised(light) if light in scaling else light for light in lighting.lights)
    return lighting.model_copy(
        update={"lights": lights, "ambient": scale_color(lighting.ambient, gain) if all_lights else lighting.ambient}
    )


def scale_color(color: Color, gain: float) -> Color:
    """Return a colour (scene-linear RGB) ``gain`` times as bright."""
    return (color[0] * gain, color[1] * gain, color[2] * gain)
