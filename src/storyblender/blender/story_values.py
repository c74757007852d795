"""What a story's .blend carries as values, so that a person's changes in it can be found again."""

from __future__ import annotations

import hashlib
import math
import shutil
from collections.abc import Iterator, Sequence
from tempfile import TemporaryDirectory

import bpy
import numpy as np
from mathutils import Euler, Quaternion
from pydantic import ValidationError

from storyblender.blender.cut import TEXT, cut_values, keep_values
from storyblender.blender.motion.posing import posing_of
from storyblender.blender.surface_values import is_solid, materials_of, shape_of, surface_values
from storyblender.memory.blend_values import (
    BlendReading,
    BlendValues,
    CameraValues,
    CurveValues,
    LampValues,
    NodeValues,
    PoseValues,
    SceneValues,
    StripValues,
    Vector,
)

ORIGIN = "compiled_as"
"""Custom property of an object: the name that it was compiled with."""
_KINDS = ("character", "prop", "set", "light", "camera")
_PLACES = ("location", "rotation_euler", "rotation_quaternion", "rotation_axis_angle", "scale")
_DIGITS = 5


def write_values(version: str) -> None:
    """Write what the open file holds into a text block of it, and on every object the name that it was compiled with.

    Args:
        version: Of the project.
    """
    for scene in _story_scenes():
        for obj in scene.objects:
            obj[ORIGIN] = obj.name
    keep_values(read_values(version))


def read_file(path: str) -> BlendReading:
    """Open a story's file, without its scripts, and return what it was compiled as and what it is now.

    Args:
        path: Of the .blend.
    """
    with TemporaryDirectory(prefix="storyblender_") as folder:  # a file that links others is read without them
        apart = shutil.copy(path, folder)
        bpy.ops.wm.open_mainfile(filepath=apart, load_ui=False, use_scripts=False)
    text, compiled = bpy.data.texts.get(TEXT), None
    if text is not None:
        try:
            compiled = BlendValues.model_validate_json(text.as_string())
        except ValidationError:
            compiled = None
    return BlendReading(compiled=compiled, saved=read_values(compiled.version if compiled else ""))


def read_values(version: str) -> BlendValues:
    """Return what the open file holds.

    Args:
        version: Of the project that it was compiled from.
    """
    scenes = sorted(_story_scenes(), key=lambda scene: scene.name)
    return BlendValues(
        version=version,
        scenes=tuple(_scene_values(scene) for scene in scenes),
        surfaces={material.name: surface_values(material) for material in bpy.data.materials if material.users},
        cut=cut_values(),
    )


def _story_scenes() -> list[bpy.types.Scene]:
    return [scene for scene in bpy.data.scenes if "scene_id" in scene]


def _scene_values(scene: bpy.types.Scene) -> SceneValues:
    shown = [obj for obj in scene.objects if not _is_part(obj)]
    return SceneValues(
        name=scene.name,
        nodes=tuple(_node_values(obj) for obj in sorted(shown, key=lambda obj: obj.name)),
        markers={marker.name: marker.frame for marker in scene.timeline_markers},
        end=scene.frame_end,
        bound={marker.name: marker.camera.name for marker in scene.timeline_markers if marker.camera is not None},
    )


def _is_part(obj: bpy.types.Object) -> bool:
    """Return whether an object belongs to the one that it hangs on: a garment, a door of a car."""
    return obj.parent is not None and ORIGIN in obj and obj.get("kind") == obj.parent.get("kind")


def _node_values(obj: bpy.types.Object) -> NodeValues:
    location, rotation, scale = obj.matrix_basis.decompose()
    curves = list(_curves(obj))
    kind = str(obj.get("kind", ""))
    return NodeValues(
        name=obj.name,
        kind=kind if kind in _KINDS else "",
        node_id=str(obj.get("node_id", "")),
        asset_id=str(obj.get("asset_id", "")),
        origin=str(obj.get(ORIGIN, "")),
        animated=any(curve.data_path in _PLACES for curve in curves),
        location=_rounded(location),
        rotation=_rounded([math.degrees(angle) for angle in rotation.to_euler("XYZ")]),
        scale=_rounded(scale),
        strips=tuple(_strips(obj)),
        action=_own_action(obj),
        posing=posing_of(obj) if obj.type == "ARMATURE" or obj.constraints else "",
        camera=_camera_values(obj) if obj.type == "CAMERA" else None,
        lamp=_lamp_values(obj.data) if obj.type == "LIGHT" else None,
        materials=materials_of(obj),
        shape=shape_of(obj),
        solid=is_solid(obj),
    )


def _strips(obj: bpy.types.Object) -> Iterator[StripValues]:
    data = obj.animation_data
    for strip in (strip for track in data.nla_tracks for strip in track.strips) if data else ():
        curves = _of_slot(strip.action, strip.action_slot)
        yield StripValues(
            name=strip.name, start=strip.frame_start, end=strip.frame_end, curves=_curve_values(curves)
        )  # fmt: skip


def _own_action(obj: bpy.types.Object) -> CurveValues | None:
    """Return the keys of an object's own action; those that hide it in a shot are the program's."""
    data = obj.animation_data
    curves = _of_slot(data.action, data.action_slot) if data else []
    curves = [curve for curve in curves if not curve.data_path.startswith("hide_")]
    return _curve_values(curves) if curves else None


def _curves(obj: bpy.types.Object) -> Iterator[bpy.types.FCurve]:
    """Yield all curves that move an object."""
    data = obj.animation_data
    if data is not None:
        yield from _of_slot(data.action, data.action_slot)
        for strip in (strip for track in data.nla_tracks for strip in track.strips):
            yield from _of_slot(strip.action, strip.action_slot)


def _of_slot(action: bpy.types.Action | None, slot: bpy.types.ActionSlot | None) -> list[bpy.types.FCurve]:
    if action is None or slot is None:
        return []
    bags = (strip.channelbag(slot) for layer in action.layers for strip in layer.strips)
    return [curve for bag in bags if bag is not None for curve in bag.fcurves]


def _curve_values(curves: Sequence[bpy.types.FCurve]) -> CurveValues:
    frames, values, count = hashlib.sha256(), hashlib.sha256(), 0
    for curve in sorted(curves, key=lambda curve: (curve.data_path, curve.array_index)):
        points = np.empty(2 * len(curve.keyframe_points), np.float32)
        curve.keyframe_points.foreach_get("co", points)
        count += len(curve.keyframe_points)
        frames.update(f"{curve.data_path}[{curve.array_index}]".encode() + np.round(points[::2], 2).tobytes())
        values.update((np.round(points[1::2], 4) + 0.0).tobytes())
    return CurveValues(keys=count, frames=frames.hexdigest()[:16], values=values.hexdigest()[:16])


def _camera_values(camera: bpy.types.Object) -> CameraValues:
    curves = [*_curves(camera), *_curves(camera.data)]
    moves = [curve for curve in curves if curve.data_path in (*_PLACES, "lens")]
    keyed = sorted({round(point.co.x) for curve in moves for point in curve.keyframe_points})
    frames = [keyed[0], keyed[-1]] if len(keyed) > 1 else keyed or [0]
    dof = camera.data.dof
    return CameraValues(
        poses=tuple(_pose(camera, moves, frame) for frame in frames),
        between=tuple(keyed[1:-1]),
        path=_curve_values(moves).values if keyed else "",
        f_number=round(dof.aperture_fstop, 3),
        blurs=dof.use_dof,
    )


def _lamp_values(lamp: bpy.types.Light) -> LampValues:
    size = {"AREA": "size", "SUN": "angle"}.get(lamp.type, "shadow_soft_size")
    degrees = lamp.type == "SUN"
    return LampValues(
        kind=lamp.type,
        power=round(lamp.energy, 4),
        color=_rounded(lamp.color),
        size=round(math.degrees(getattr(lamp, size)) if degrees else getattr(lamp, size), 4),
        cone=round(math.degrees(lamp.spot_size), 3) if lamp.type == "SPOT" else 60.0,
    )


def _pose(camera: bpy.types.Object, curves: Sequence[bpy.types.FCurve], frame: int) -> PoseValues:
    """Return where a camera is at a frame: as keyed, and as it rests where nothing is keyed."""

    def channel(path: str, rest: Sequence[float]) -> list[float]:
        keyed = {curve.array_index: curve.evaluate(frame) for curve in curves if curve.data_path == path}
        return [keyed.get(index, value) for index, value in enumerate(rest)]

    if camera.rotation_mode == "QUATERNION":
        rotation = Quaternion(channel("rotation_quaternion", camera.rotation_quaternion)).normalized()
    else:
        order = camera.rotation_mode if camera.rotation_mode != "AXIS_ANGLE" else "XYZ"
        rotation = Euler(channel("rotation_euler", camera.rotation_euler), order).to_quaternion()
    if rotation.w < 0:
        rotation.negate()
    [lens] = channel("lens", [camera.data.lens])
    w, x, y, z = (round(part, 6) for part in rotation)
    return PoseValues(
        frame=frame, location=_rounded(channel("location", camera.location)), rotation=(w, x, y, z), lens=round(lens, 3)
    )


def _rounded(values: Sequence[float]) -> Vector:
    x, y, z = (round(float(value), _DIGITS) + 0.0 for value in values)
    return x, y, z
