"""What a lamp sees: Workbench depth from its place, fitted to what the camera sees: close shots get fine shadows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import ExitStack

import bpy
import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

from storyblender.blender.render.lamps import FACE_ROLES
from storyblender.blender.render.passes import flat_workbench
from storyblender.blender.render.session import RenderSession, changed, temporary_camera
from storyblender.look.illumination import direction_of
from storyblender.look.raster import Image
from storyblender.look.shadow import ShadowMap
from storyblender.look.surface import Surface
from storyblender.memory.scene_context import Light

_SIZE = 768
_SUN_SIZE = 1280
_SUN_REACH = 70.0
"""Metres from the eye within which the sun's shadow is drawn."""
_SUN_BACK = 150.0
"""Metres up the ray from which the sun looks."""
_OWN_FITTING = 0.3
"""Metres round a lamp that cast no shadow: its shade, bulb and pole."""
_WIDEST = math.tan(math.radians(70))
_SHADELESS = frozenset({int(Surface.CARD), int(Surface.EMISSIVE), int(Surface.GLASS), int(Surface.NO_INK)})


def render_shadow_map(
    session: RenderSession, light: Light, receivers: NDArray[np.float32], eye: Image, fineness: float = 1.0
) -> ShadowMap:
    """Return the shadow map of a lamp.

    Args:
        session: The frame.
        light: Any kind.
        receivers: (n, 3) world positions the camera sees and the lamp faces; the map is fitted to them.
        eye: (3,) camera position.
        fineness: Factor on the pixels across the map.
    """
    if light.kind == "SUN":
        return _sun_map(session, light, receivers, eye, round(_SUN_SIZE * fineness))
    aim = receivers.mean(axis=0) - np.asarray(light.location) if light.kind == "POINT" else direction_of(light)
    axes = np.array(Vector(aim).to_track_quat("-Z", "Y").to_matrix())
    local = (receivers - np.asarray(light.location)) @ axes
    ahead = local[local[:, 2] < -0.2]
    needed = np.abs(ahead[:, :2] / ahead[:, 2:]) if len(ahead) else np.ones((1, 2))
    half = min(float(np.percentile(needed.max(axis=1), 99.5)) * 1.1 + 0.02, _WIDEST)
    if light.kind == "SPOT":
        half = min(half, math.tan(math.radians(min(light.cone / 2, 70))) * 1.02)
    matrix = _placed(axes, np.asarray(light.location))
    near = _OWN_FITTING if light.role not in FACE_ROLES else 0.1
    size = round(_SIZE * fineness)
    depth = _depth(session, light, matrix, size, type="PERSP", angle=2 * math.atan(half), clip_start=near)
    return ShadowMap(np.asarray(light.location, float), axes, half, False, depth)


def _sun_map(session: RenderSession, light: Light, receivers: NDArray[np.float32], eye: Image, size: int) -> ShadowMap:
    direction = direction_of(light)
    axes = np.array(Vector(direction).to_track_quat("-Z", "Y").to_matrix())
    close = receivers[np.linalg.norm(receivers - eye, axis=1) < _SUN_REACH]
    flat = (close if len(close) else receivers) @ axes[:, :2]
    low, high = np.percentile(flat, 0.5, axis=0), np.percentile(flat, 99.5, axis=0)
    half = float((high - low).max() / 2 * 1.05 + 0.1)
    center = axes[:, :2] @ ((low + high) / 2) + axes[:, 2] * float((receivers @ axes[:, 2]).max() + _SUN_BACK)
    depth = _depth(
        session, light, _placed(axes, center), size,
        type="ORTHO", ortho_scale=2 * half, clip_start=0.1, clip_end=_SUN_BACK + 400.0,
    )  # fmt: skip
    return ShadowMap(center, axes, half, True, depth)


def _placed(axes: NDArray, location: NDArray) -> NDArray:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = axes, location
    return matrix


def _depth(session: RenderSession, light: Light, matrix: NDArray, size: int, **camera: object) -> NDArray[np.float32]:
    scene = session.scene
    with ExitStack() as stack:
        stack.enter_context(flat_workbench(scene))
        stack.enter_context(changed(scene.display.shading, {"light": "FLAT", "color_type": "SINGLE"}))
        for obj in _not_casting(session.visible_objects(), light):
            stack.enter_context(changed(obj, {"hide_render": True}))
        for wall in session.hidden_objects if light.role not in FACE_ROLES else ():
            stack.enter_context(changed(wall, {"hide_render": False}))
        stack.enter_context(temporary_camera(scene, matrix, **camera))
        channels = session.exr(size, size, depth=True)
    return np.where(channels["Combined.A"] > 0.5, channels["Depth.Z"], np.float32(1e6)).astype(np.float32)


def _not_casting(objects: Sequence[bpy.types.Object], light: Light) -> list[bpy.types.Object]:
    if light.role in FACE_ROLES:
        return [obj for obj in objects if obj.get("kind") != "character"]
    return [obj for obj in objects if int(obj.get("surface", Surface.PROP)) in _SHADELESS]
