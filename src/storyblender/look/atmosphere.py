"""Air: fog with height, halos round lamps, rain. Added in linear light after rendering, the same in every look."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from storyblender.look.raster import LUMA, Image, blur, dot, luminance, stacked
from storyblender.memory.scene_context import Fog, Light

_REACH = 400.0
"""Metres of air at most."""
_HALO = 0.10
_HALO_LIMIT = 0.35
"""A halo adds at most this much luminance: more turned frames into soup (notes 1.8)."""
_HALO_WIDTH = 1.6
"""Metres beyond which a halo fades faster than physics has it: the far tails of many lamps only add up to haze."""
_QUARTER = np.float32(math.pi / 2)
_RAIN_LAYERS = ((2.5, 40, 120, 0.5), (6.0, 160, 60, 0.4), (14.0, 420, 28, 0.3))
"""Distance in metres, streaks, length in pixels at 540 rows, strength."""
_RAIN_SLANT = 0.1


_NARROW = 60.0
"""Degrees: a spot narrower than this is seen as a beam."""
_BEAM_REACH, _BEAM_STEPS, _BEAM_MOUTH = 7.0, 32, 0.03
"""Metres of a beam that are seen, samples along a ray, and square metres that soften its mouth."""


def transmittance(fog: Fog | None, depth: Image, rays: Image, eye: NDArray[np.float64]) -> Image:
    """Return the share, 0 to 1, of light that comes through the air from every pixel.

    Args:
        fog: The air; None is clear.
        depth: (h, w) metres along the camera axis.
        rays: (h, w, 3) world, scaled to depth 1.
        eye: (3,) camera position.
    """
    if fog is None:
        return np.ones(depth.shape, np.float32)
    length = np.sqrt(dot(rays, rays))
    distance = np.minimum(depth * length, _REACH)
    climb = rays[..., 2] / length * distance / fog.height
    flat = np.abs(climb) < 1e-3
    thinning = np.where(flat, 1.0, (1 - np.exp(-np.clip(climb, -30, 30))) / np.where(flat, 1.0, climb))
    at_eye = math.exp(-float(np.clip(eye[2] / fog.height, -5, 30)))
    thickness = fog.density * at_eye * np.maximum(0, distance - fog.start) * np.clip(thinning, 0, 8)
    return np.exp(-np.clip(thickness, 0, 30)).astype(np.float32)


def veil(fog: Fog | None, rays: Image) -> Image:
    """Return the (h, w, 3) colour of endless fog; towards the sun it is brighter (cosine to the sixth).

    Args:
        fog: The air; None is clear, and its colour black.
        rays: (h, w, 3) world, of any length.
    """
    if fog is None:
        return np.zeros(rays.shape, np.float32)
    color = np.asarray(fog.color, np.float32)
    if fog.sun_direction is None:
        return np.broadcast_to(color, rays.shape)
    toward = np.asarray(fog.sun_direction, np.float32)
    cosine = dot(rays, toward / np.linalg.norm(toward)) / np.sqrt(dot(rays, rays))
    lobe = np.clip(cosine, 0, 1) ** 6
    return stacked([level + lobe * np.float32(sun) for level, sun in zip(color, fog.sun_color, strict=True)])


def add_fog(picture: Image, fog: Fog | None, through: Image, rays: Image) -> Image:
    """Veil the picture by what ``transmittance`` says comes through.

    Args:
        picture: (h, w, 3) linear.
        fog: The air; None is clear.
        through: (h, w) share, 0 to 1, of light that comes through.
        rays: (h, w, 3) world, of any length.
    """
    if fog is None:
        return picture
    return picture * through[..., None] + veil(fog, rays) * (1 - through[..., None])


def add_halos(picture: Image, lights: Sequence[Light], depth: Image, rays: Image, eye: NDArray[np.float64]) -> Image:
    """Add the glow of every lamp in the air between it and the eye, and the beams of narrow ones.

    A lamp that shines to all sides is a closed form (single scatter of a point light); a beam is summed along the ray.

    Args:
        picture: (h, w, 3) linear.
        lights: Lamps; those without glow, and the sun, add nothing.
        depth: (h, w) metres along the camera axis.
        rays: (h, w, 3) world, scaled to depth 1.
        eye: (3,) camera position, world metres.
    """
    glowing = [light for light in lights if light.glow > 0 and light.kind != "SUN"]
    if not glowing:
        return picture
    length = np.sqrt(dot(rays, rays))
    distance = np.minimum(depth * length, _REACH)
    result = np.copy(picture, order="K")
    for light in glowing:
        from_light = (eye - np.asarray(light.location)).astype(np.float32)
        along = dot(rays, from_light) / length
        aside = np.sqrt(np.maximum(float(from_light @ from_light) - along * along, 0.0036) + 0.05)
        # The angle under which the ray is seen from the lamp: the difference of two arcs in one, of 0 to 180 degrees.
        angle = _QUARTER - np.arctan((aside * aside + (distance + along) * along) / (distance * aside))
        scatter = angle / aside / (1 + (aside / _HALO_WIDTH) ** 2)
        if light.kind == "SPOT" and light.cone < _NARROW:
            scatter = _beam(light, from_light, rays / length[..., None], distance)
        share = 0.6 if light.kind == "SPOT" else 1.0
        color = np.asarray(light.color, np.float32)
        amount = _HALO * share * light.glow * light.power / (16 * math.pi**2) * scatter
        amount = np.minimum(amount, _HALO_LIMIT / max(float(LUMA @ color), 1e-3))
        for band in range(3):
            result[..., band] += amount * color[band]
    return result


def _beam(light: Light, from_light: NDArray[np.float32], rays: Image, distance: Image) -> Image:
    """Return the light that the air throws back along each ray out of the cone of a lamp.

    Args:
        light: A spot.
        from_light: From the lamp to the eye, metres.
        rays: (h, w, 3) of length 1.
        distance: Metres along each ray to what is seen.
    """
    aim = np.subtract(light.target, light.location).astype(np.float32)
    aim /= max(float(np.linalg.norm(aim)), 1e-6)
    edge = math.cos(math.radians(light.cone / 2))
    nearest = -dot(rays, from_light)
    aside = np.sqrt(np.maximum(float(from_light @ from_light) - nearest * nearest, 0) + _BEAM_MOUTH)
    ends = (np.clip(nearest + reach, 0, distance) for reach in (-_BEAM_REACH, _BEAM_REACH))
    first, last = (np.arctan((end - nearest) / aside) for end in ends)
    across = [np.float32(from_light @ aim), dot(rays, aim)]
    found = np.zeros_like(distance)
    for step in range(_BEAM_STEPS):  # at equal angles as seen from the lamp, where the light falls off with the square
        at = nearest + aside * np.tan(first + (last - first) * ((step + 0.5) / _BEAM_STEPS))
        apart = at * at - 2 * at * nearest + float(from_light @ from_light)
        cosine = (across[0] + at * across[1]) / np.sqrt(np.maximum(apart, 1e-4))
        found += np.clip((cosine - edge) / (1 - edge), 0, 1)
    return found * (last - first) / (_BEAM_STEPS * aside)


def add_rain(picture: Image, depth: Image, rain: float, seed: int) -> Image:
    """Draw streaks in three depths of air, hidden by what is nearer, lit by the light around them.

    Args:
        picture: Linear, exposed.
        depth: Metres, at the picture's size.
        rain: 0 none, 1 downpour.
        seed: Where the streaks fall.
    """
    if rain <= 0:
        return picture
    height, width = depth.shape
    random = np.random.default_rng(seed)
    streaks = np.zeros((height, width), np.float32)
    for distance, count, reach, strength in _RAIN_LAYERS:
        number = round(count * rain * width / 960)
        left, top = random.uniform(-20, width + 20, number), random.uniform(-reach, height, number)
        span = reach * height / 540 * random.uniform(0.6, 1.3, number)
        power = strength * random.uniform(0.5, 1, number)
        steps = np.arange(math.ceil(reach * height / 540 * 1.3))
        rows = (top[:, None] + steps).astype(int)
        columns = (left[:, None] + steps * _RAIN_SLANT).astype(int)
        drawn = (steps < span[:, None]) & (rows >= 0) & (rows < height) & (columns >= 0) & (columns < width)
        rows, columns, power = rows[drawn], columns[drawn], np.broadcast_to(power[:, None], drawn.shape)[drawn]
        free = depth[rows, columns] > distance
        np.maximum.at(streaks, (rows[free], columns[free]), power[free].astype(np.float32))
    around = blur(luminance(picture), max(1, round(14 * height / 540)))
    return picture + (streaks * (0.55 * around + 0.012))[..., None] * np.array([0.8, 0.9, 1.0], np.float32)
