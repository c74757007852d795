"""A user's panorama in the light plan of an exterior by day: turned to the plan's sun, as bright as the plan's sky."""

from __future__ import annotations

import math

import numpy as np

from storyblender.agents.visual_effects_artist.lighting_arranger_view import LightingArrangerView
from storyblender.catalog.light_recipes import HOURS, mean_sky_luminance
from storyblender.look.illumination import direction_of
from storyblender.look.irradiance import mean_irradiance, turned
from storyblender.look.raster import luminance
from storyblender.memory.base import Color
from storyblender.memory.panorama import PanoramaLight
from storyblender.memory.scene_context import Light, Sky


def panorama_light(view: LightingArrangerView, sky: Sky, ambient: Color, sun: Light) -> PanoramaLight | None:
    """Return the offered panorama as it lights a place; None in rooms and where lamps burn for the hour.

    Args:
        view: Offers the panorama.
        sky: The dome that it takes the place of: where light is traced, both have the same mean.
        ambient: The plan's; where light is not traced, the panorama gives as much, taken over all normals.
        sun: The plan's; the panorama is turned about Z so that its own is below or above it.
    """
    offered = view.panorama
    if offered is None or view.plan.indoor or HOURS[view.setup.time_of_day].lamps:
        return None
    coefficients = np.array(offered.irradiance)
    own = max(float(luminance(mean_irradiance(coefficients).astype(np.float32))), 1e-9)
    level = float(luminance((np.asarray(ambient, np.float32) + np.asarray(sky.ground, np.float32)) / 2))
    yaw = 0.0
    if offered.sun is not None:
        toward = -direction_of(sun)
        yaw = math.degrees(math.atan2(toward[1], toward[0]) - math.atan2(offered.sun[1], offered.sun[0]))
        yaw = round((yaw + 180) % 360 - 180, 3)
    finished = turned(coefficients, yaw) * (level / own)
    return PanoramaLight(
        digest=offered.provenance.digest,
        yaw=yaw,
        strength=float(f"{mean_sky_luminance(sky) / own:.6g}"),
        irradiance=tuple((round(red, 6), round(green, 6), round(blue, 6)) for red, green, blue in finished.tolist()),
    )
