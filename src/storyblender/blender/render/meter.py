"""A light meter: how much light falls on what surrounds the stage, and the gain that brings it to the set's level.

It measures what falls on surfaces, not what leaves them: dark wood must stay dark (notes: sets and light, 1.2). It
stands where the scene is played, never at the camera, so every shot of a scene gets the same gain.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import bpy
import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

from storyblender.look.illumination import LightField, ambient_light, direction_of, light_field, total
from storyblender.look.raster import LUMA, luminance
from storyblender.memory.base import Color, Vec3
from storyblender.memory.scene_context import Fog, Light, Lighting, Sky

_STATIONS: tuple[Vec3, ...] = ((0, 0, 1.5), (1.3, 1.0, 1.5), (-1.3, 1.0, 1.5), (1.3, -1.0, 1.5), (-1.3, -1.0, 1.5))
"""Where the meter stands: round the middle of the playing area, at eye level."""
_RAYS = 70
_STEEPEST = 0.6
"""Sine of the elevation up to which the meter looks: cameras seldom look higher or lower."""
_REFLECTANCE = 0.26
"""Of the walls, floors and clothes of an average set; one number for all, so that dark sets stay dark."""
_REACH = 60.0
_GAIN = (0.1, 8.0)
_FITTING = 0.35
_MILKY = 2.0
"""Fog is never brighter than this many times the level of the set: a brighter veil looks like milk, not like air."""
_SOOTY, _DENSE = 1.4, 0.03
"""Fog this dense, per metre, is never darker than this many times the level of the set: it is lit air, not smoke."""
_FEWEST_HITS = 20


@dataclass(frozen=True)
class SetLight:
    """The light of a set, brought to its level.

    Attributes:
        plan: Set lamps, ambient light, sky and fog scaled so that an average surface reaches ``set_luminance``.
        roofed: 0 under the open sky to 1 in a closed room: the share of ambient light that no sky gives, and that a
            path tracer would therefore miss.
    """

    plan: Lighting
    roofed: float


def balanced(scene: bpy.types.Scene, lighting: Lighting) -> SetLight:
    """Measure the light that falls round the stage and bring it to the plan's level.

    Args:
        scene: The context's scene, with its set; people are looked through.
        lighting: The plan as designed.
    """
    roofed = _roofed(scene)
    points = list(_surroundings(scene))
    if len(points) < _FEWEST_HITS:
        return SetLight(lighting, roofed)
    positions = np.array([[p for p, _ in points]], np.float32)
    normal = np.array([[n for _, n in points]], np.float32)
    fields = [light_field(light, positions, normal) for light in lighting.lights]
    ambient = ambient_light(lighting, roofed, normal, np.ones(normal.shape[:2], np.float32))
    strong = 0.02 * luminance(total(fields, ambient))
    reaching = [field.shadowed(_reached(scene, field, positions, strong)) for field in fields]
    # The square of the mean root stands between the mean, which one lamp can rule, and the geometric mean, which a
    # shaded street side would: that one burns everything in the sun.
    level = _REFLECTANCE * float(np.sqrt(luminance(total(reaching, ambient))).mean()) ** 2
    return SetLight(scaled(lighting, float(np.clip(lighting.set_luminance / level, *_GAIN))), roofed)


def reach_of(scene: bpy.types.Scene, light: Light, points: Sequence[Vec3]) -> float:
    """Return the share of points that a lamp reaches, 0 to 1; people are looked through.

    Args:
        scene: Scene whose objects stand in the way.
        light: The lamp; world, metres.
        points: World, metres; at least one.
    """
    depsgraph = scene.view_layers[0].depsgraph
    reached = 0
    for point in points:
        toward, distance = _toward(light, Vector(point))
        reached += not _first_hit(scene, depsgraph, Vector(point), toward, distance - _FITTING)[0]
    return reached / len(points)


def scaled(lighting: Lighting, gain: float) -> Lighting:
    """Return the plan with everything that lights the set ``gain`` times as bright."""

    def times(color: Color, by: float = gain) -> Color:
        return (color[0] * by, color[1] * by, color[2] * by)

    sky, fog = lighting.sky, lighting.fog
    veil = _veil(fog, lighting.set_luminance, gain) if fog else gain
    return lighting.model_copy(
        update={
            "lights": tuple(light.model_copy(update={"power": light.power * gain}) for light in lighting.lights),
            "ambient": times(lighting.ambient),
            "sky": Sky(zenith=times(sky.zenith), horizon=times(sky.horizon), ground=times(sky.ground)),
            "panorama": lighting.panorama and lighting.panorama.scaled(gain),
            "fog": fog
            and fog.model_copy(update={"color": times(fog.color, veil), "sun_color": times(fog.sun_color, veil)}),
        }
    )


def _veil(fog: Fog, level: float, gain: float) -> float:
    """Return the factor on the fog's colour: the set's gain, held between soot and milk."""
    unit = level / max(float(LUMA @ np.asarray(fog.color)), 1e-6)
    return min(max(gain, _SOOTY * unit if fog.density > _DENSE else 0.0), _MILKY * unit)


def _surroundings(scene: bpy.types.Scene) -> Iterator[tuple[Vector, Vector]]:
    """Yield points of the set, with their normals, as seen from the stations."""
    depsgraph = scene.view_layers[0].depsgraph
    for station in _STATIONS:
        for index in range(_RAYS):
            height = _STEEPEST * (2 * (index + 0.5) / _RAYS - 1)
            flat, angle = math.sqrt(1 - height * height), index * 2.399963
            direction = Vector((flat * math.cos(angle), flat * math.sin(angle), height))
            hit, place, normal = _first_hit(scene, depsgraph, Vector(station), direction, _REACH)
            if hit:
                toward = normal if normal.dot(direction) < 0 else -normal
                yield place + toward * 0.01, toward


def _reached(scene: bpy.types.Scene, field: LightField, positions: NDArray, strong: NDArray) -> NDArray[np.float32]:
    """Return 0 where something stands between lamp and point, else 1; weak light is not worth a ray."""
    lit = np.ones(field.amount.shape, np.float32)
    for column in np.flatnonzero(field.amount[0] > strong[0]):
        lit[0, column] = reach_of(scene, field.light, [positions[0, column].tolist()])
    return lit


def _roofed(scene: bpy.types.Scene) -> float:
    """Return the share of steep upward looks from the stations that end at something."""
    depsgraph = scene.view_layers[0].depsgraph
    looks = [(x, y, 1.0) for x in (-0.6, 0.0, 0.6) for y in (-0.6, 0.0, 0.6)]
    hits = [
        _first_hit(scene, depsgraph, Vector(station), Vector(look).normalized(), _REACH)[0]
        for station in _STATIONS
        for look in looks
    ]
    return sum(hits) / len(hits)


def _toward(light: Light, start: Vector) -> tuple[Vector, float]:
    if light.kind == "SUN":
        return -Vector(direction_of(light).tolist()), 300.0
    way = Vector(light.location) - start
    return way.normalized(), way.length


def _first_hit(
    scene: bpy.types.Scene, depsgraph: bpy.types.Depsgraph, start: Vector, direction: Vector, reach: float
) -> tuple[bool, Vector, Vector]:
    """Cast a ray that goes through people and backdrops."""
    for _ in range(6):
        if reach <= 0.02:
            break
        hit, place, normal, _, obj, _ = scene.ray_cast(depsgraph, start, direction, distance=reach)
        if not hit:
            break
        if obj.get("kind") != "character":
            return True, place, normal
        step = (place - start).length + 0.01
        start, reach = place + direction * 0.01, reach - step
    return False, start, direction
