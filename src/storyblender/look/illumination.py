"""Numpy lights: how much every lamp gives to every pixel (formulas checked against Cycles, notes 1.1).

Illumination here is irradiance / pi: the luminance a white diffuse surface would show. Picture = albedo * illumination.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from storyblender.look.gbuffer import GBuffer
from storyblender.look.irradiance import irradiance_at
from storyblender.look.raster import LUMA, Image, dot, luminance, stacked
from storyblender.look.surface import Surface
from storyblender.memory.scene_context import Light, Lighting, Sky

_BOUNCE = 0.55
"""Share of the mean outgoing light that comes back from all sides as first bounce (fitted to Cycles, 3 bounces)."""
SKY_STOPS = (-1.0, -0.03, 0.0, 0.22, 1.0)
"""Sines of elevation of the sky's colours: ground, ground, horizon, midway, zenith."""


@dataclass(frozen=True)
class LightField:
    """One lamp over the picture.

    Attributes:
        light: The lamp.
        amount: (h, w) illumination at the lamp's power, before its colour.
    """

    light: Light
    amount: Image

    def scaled(self, gain: float) -> LightField:
        """Return the same lamp ``gain`` times as strong; exact, light is linear."""
        return LightField(self.light.model_copy(update={"power": self.light.power * gain}), self.amount * gain)

    def shadowed(self, visibility: Image) -> LightField:
        """Return the lamp with what it does not reach taken away."""
        return replace(self, amount=self.amount * visibility)


def direction_of(light: Light) -> NDArray[np.float64]:
    """Return the unit vector along which the lamp shines."""
    along = np.asarray(light.target, float) - np.asarray(light.location, float)
    length = np.linalg.norm(along)
    return along / length if length > 1e-9 else np.array([0.0, 0.0, -1.0])


def light_field(light: Light, positions: Image, normal: Image) -> LightField:
    """Return what the lamp gives to every pixel, as if nothing were in between.

    Args:
        light: The lamp.
        positions: (h, w, 3) world, metres.
        normal: (h, w, 3) world, unit.
    """
    aim = direction_of(light).astype(np.float32)
    if light.kind == "SUN":
        return LightField(light, np.clip(-dot(normal, aim), 0, 1) * np.float32(light.power / math.pi))
    toward = np.asarray(light.location, np.float32) - positions
    squared = dot(toward, toward)
    nearness = 1 / np.sqrt(squared)
    facing = np.maximum(dot(normal, toward), 0) * nearness
    amount = facing * np.float32(light.power / (4 * math.pi**2)) / (squared + np.float32((light.size / 2) ** 2))
    if light.kind == "AREA":
        amount *= np.maximum(-4 * dot(toward, aim), 0) * nearness
    elif light.kind == "SPOT":
        edge = math.cos(math.radians(light.cone / 2))
        amount *= np.clip((-dot(toward, aim) * nearness - edge) / max(1e-3, (1 - edge) * light.blend), 0, 1)
    return LightField(light, amount)


def ambient_light(plan: Lighting, roofed: float, normal: Image, openness: Image) -> Image:
    """Return the (h, w, 3) light from all sides; none in the corners.

    Under the sky a level surface gets the plan's ambient light and an upright one half of it, the rest from the
    ground; with a panorama each normal gets what the panorama gives it. Under a roof it comes from everywhere, a little
    more from above.

    Args:
        plan: Ambient light and sky.
        roofed: 0 under the open sky to 1 in a closed room.
        normal: (h, w, 3) world, unit.
        openness: (h, w) ambient occlusion.
    """
    open_share, roof = np.float32(1 - roofed), roof_light(plan, roofed, normal)
    if plan.panorama is not None:
        around = irradiance_at(plan.panorama.irradiance, normal) * open_share + roof
        return stacked([openness * around[..., band] for band in range(3)])
    ambient, ground = np.asarray(plan.ambient, np.float32), np.asarray(plan.sky.ground, np.float32)
    up = (1 + normal[..., 2]) / 2
    outdoors = ((low + (high - low) * up) * open_share for low, high in zip(ground, ambient, strict=True))
    return stacked([openness * (light + roof[..., band]) for band, light in enumerate(outdoors)])


def roof_light(plan: Lighting, roofed: float, normal: Image) -> Image:
    """Return the part of the ambient light that no sky gives; a path tracer is given it, as nothing else would.

    Args:
        plan: Ambient light.
        roofed: 0 under the open sky to 1 in a closed room.
        normal: (h, w, 3) world, unit.
    """
    level = 0.75 + 0.25 * normal[..., 2]
    return stacked([level * (np.float32(band) * np.float32(roofed)) for band in plan.ambient])


def bounce_light(albedo: Image, direct: Image, solid: NDArray[np.bool_], openness: Image) -> Image:
    """Return the first bounce, taken as even over the picture: the mean light that leaves the surfaces in it.

    Args:
        albedo: (h, w, 3) linear reflectance.
        direct: (h, w, 3) illumination before the bounce.
        solid: (h, w) False where the sky shows.
        openness: (h, w) ambient occlusion: the open share, 0 to 1.
    """
    if not solid.any():
        return np.zeros_like(direct)
    leaving = np.minimum(albedo * direct, 4.0)[solid].mean(axis=0)
    return openness[..., None] * (leaving * np.float32(_BOUNCE))


def soft_foliage(normal: Image, gbuffer: GBuffer) -> Image:
    """Return the normals with those of leaves turned up and to the eye: light comes through leaves and round them.

    Args:
        normal: (h, w, 3) world, unit.
        gbuffer: Of the same size; says where leaves are.
    """
    leaves = gbuffer.surface == Surface.FOLIAGE
    if not leaves.any():
        return normal
    turned = normal[leaves] + np.array([0, 0, 0.7], np.float32) + 0.4 * gbuffer.view.axes[:, 2].astype(np.float32)
    result = normal.copy()
    result[leaves] = turned / np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-3)
    return result


def total(fields: Sequence[LightField], ambient: Image) -> Image:
    """Sum lamps and (h, w, 3) ambient light, all of one size, to (h, w, 3) illumination."""
    result = np.copy(ambient, order="K")
    for field in fields:
        for band, part in enumerate(field.light.color):
            result[..., band] += field.amount * np.float32(part)
    return result


def power_for(luminance_wanted: float, distance: float, color: Sequence[float], albedo: float = 0.4) -> float:
    """Return the watts of a SPOT or POINT that show a facing surface at a luminance (notes 1.1, a = mixed skin).

    Args:
        luminance_wanted: Scene-linear.
        distance: Metres from the lamp to the surface.
        color: (3,) of the lamp, scene-linear.
        albedo: Reflectance of the surface.
    """
    brightness = 0.8 * float(np.dot(LUMA, np.asarray(color, np.float32)))
    return luminance_wanted * 4 * math.pi**2 * distance**2 / (albedo * max(brightness, 1e-3))


def sky_colors(sky: Sky) -> NDArray[np.float32]:
    """Return (5, 3) the sky's colours at ``SKY_STOPS``; Cycles' world is made of the same."""
    ground, horizon, zenith = (np.asarray(color, np.float32) for color in (sky.ground, sky.horizon, sky.zenith))
    return np.stack([ground, ground, horizon, (horizon + zenith) / 2, zenith])


def sky_light(sky: Sky, rays: Image) -> Image:
    """Return the (h, w, 3) colours of the sky along (h, w, 3) world rays of any length, scene-linear."""
    height = rays[..., 2] / np.sqrt(dot(rays, rays))
    colors = sky_colors(sky)
    return stacked([np.interp(height, SKY_STOPS, colors[:, band]).astype(np.float32) for band in range(3)])


def strength(field: LightField, albedo: Image) -> float:
    """Return the mean luminance the lamp adds to the picture; used to choose which lamps get shadows.

    Args:
        field: The lamp over the picture.
        albedo: (h, w, 3) linear reflectance, of the same size.
    """
    return float((field.amount * luminance(albedo)).mean() * np.dot(LUMA, np.asarray(field.light.color, np.float32)))
