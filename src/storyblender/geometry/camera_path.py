"""The camera of a shot at any of its frames: its stored poses, eased from one to the next."""

from __future__ import annotations

import itertools

from storyblender.geometry.framing import Film, project
from storyblender.geometry.moves import ease_in_out, interpolate_cameras
from storyblender.geometry.orbit import Orbit
from storyblender.memory.shot_context import CameraPose, CameraState


def orbit_of(pose: CameraPose, film: Film) -> Orbit:
    """Return a stored pose as a camera.

    Args:
        pose: As the graph has it.
        film: Sensor and aspect of the project.
    """
    return Orbit(pose.pivot, pose.rotation, pose.distance, pose.lens, film.sensor_width, film.aspect)


def camera_at(state: CameraState, frame: float, film: Film) -> Orbit:
    """Return the camera of a shot at a frame, eased between its poses; before the first and after the last it rests.

    Args:
        state: The camera, with at least one pose.
        frame: Counted from the start of the shot.
        film: Sensor and aspect of the project.
    """
    if frame <= state.poses[0].frame:
        return orbit_of(state.poses[0], film)
    for before, after in itertools.pairwise(state.poses):
        if frame <= after.frame:
            share = (frame - before.frame) / max(1, after.frame - before.frame)
            return interpolate_cameras(orbit_of(before, film), orbit_of(after, film), ease_in_out(share))
    return orbit_of(state.poses[-1], film)


def retimed(camera: CameraState, before: int, after: int) -> CameraState:
    """Return a camera whose move, and whose rack focus, end with a shot of another length.

    Args:
        camera: As it is.
        before: Frames of the shot as it was.
        after: Frames of the shot now.
    """
    share = max(after - 1, 1) / max(before - 1, 1)
    keys = {
        field: tuple(key.model_copy(update={"frame": round(key.frame * share)}) for key in getattr(camera, field))
        for field in ("poses", "focus")
    }
    return camera.model_copy(update=keys)


def focus_at(state: CameraState, frame: float, film: Film) -> float | None:
    """Return the depth in metres that is sharp at a frame of a shot; None where everything is.

    It follows its subject, and is eased during a rack from one to another.

    Args:
        state: The camera.
        frame: Counted from the start of the shot.
        film: Sensor and aspect of the project.
    """
    if not state.focus:
        return None
    depths = project(camera_at(state, frame, film), [key.point for key in state.focus])[1]
    keys = list(zip(state.focus, depths.tolist(), strict=True))
    if frame <= state.focus[0].frame:
        return keys[0][1]
    for (before, start), (after, end) in itertools.pairwise(keys):
        if frame <= after.frame:
            share = (frame - before.frame) / max(1, after.frame - before.frame)
            return start + (end - start) * (share if before.node_id == after.node_id else ease_in_out(share))
    return keys[-1][1]
