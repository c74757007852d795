"""Camera objects from camera states: lens, aperture and eased keys on the scene's timeline."""

from __future__ import annotations

import bpy
from mathutils import Matrix

from storyblender.blender.tags import tag
from storyblender.geometry.camera_path import camera_at, focus_at
from storyblender.geometry.framing import Film
from storyblender.memory.base import shot_name
from storyblender.memory.shot_context import CameraState, ShotContext

KEY_EVERY = 4
"""Frames between the keys of a move: the eased path is kept, and an artist can still edit it."""


def make_camera(
    scene: bpy.types.Scene, collection: bpy.types.Collection, shot: ShotContext, start: int
) -> bpy.types.Object:
    """Create and link the camera of a shot.

    Args:
        scene: The scene; it need not be evaluated, because matrices are written directly.
        collection: Receives the camera.
        shot: A shot with a solved camera.
        start: First frame of the shot on the scene's timeline.
    """
    state = shot.camera
    assert state is not None, "the Camera Operator comes before the camera"
    name = shot_name(shot.scene_id, shot.shot_id)
    data = bpy.data.cameras.new(name)
    data.sensor_width = state.sensor_width
    data.sensor_fit = "HORIZONTAL"
    data.clip_start, data.clip_end = 0.05, 1000.0
    data.dof.use_dof, data.dof.aperture_fstop = bool(state.focus), state.f_number
    camera = bpy.data.objects.new(name, data)
    camera.rotation_mode = "QUATERNION"
    tag(camera, kind="camera", node_id=name.lower())
    collection.objects.link(camera)
    _key(camera, state, shot.duration, start)
    # A new action is played only when the timeline moves: until then the camera stands where it was set last.
    _set(camera, state, scene.frame_current - start)
    return camera


def _key(camera: bpy.types.Object, state: CameraState, duration: int, start: int) -> None:
    """Key the camera's move and focus, or set them once if they do not change."""
    _set(camera, state, 0)
    moves, pulls = len(state.poses) > 1, bool(state.focus) and len(state.poses) + len(state.focus) > 2
    last = max(duration - 1, 1)
    for frame in [*range(0, last, KEY_EVERY), last] if moves or pulls else ():
        _set(camera, state, frame)
        if moves:
            camera.keyframe_insert("location", frame=start + frame)
            camera.keyframe_insert("rotation_quaternion", frame=start + frame)
            camera.data.keyframe_insert("lens", frame=start + frame)
        if pulls:
            camera.data.keyframe_insert("dof.focus_distance", frame=start + frame)


def _set(camera: bpy.types.Object, state: CameraState, frame: float) -> None:
    """Set pose, lens and focus distance of a camera at a frame of its shot."""
    film = Film(state.sensor_width)
    orbit, focus = camera_at(state, frame, film), focus_at(state, frame, film)
    world = Matrix(orbit.world.tolist())
    location, rotation, _ = world.decompose()
    if camera.rotation_quaternion.dot(rotation) < 0:
        rotation.negate()
    camera.location, camera.rotation_quaternion = location, rotation
    camera.matrix_world = world
    camera.data.lens = orbit.lens
    camera.data.dof.focus_distance = orbit.distance if focus is None else focus
