"""The camera of a shot at any of its frames: its stored poses, eased from one to the next."""

from __future__ import annotations

import itertools

from storyblender.geometry.framing import Film
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
