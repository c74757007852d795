"""Spatial Drift Error (paper, section 4.4): how far static objects move between consecutive shots of a scene."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np
from mathutils import Vector


def spatial_drift(scene: bpy.types.Scene, frames: Sequence[int]) -> float:
    """Return the Spatial Drift Error in metres: the mean distance that the box corners of static objects move between
    shots.

    Static objects are set pieces other than door leaves, and props without motion of their own, measured on the built
    scene.

    Args:
        scene: The packed scene, in the window.
        frames: One timeline frame of every shot, in order.
    """
    static = [obj for obj in scene.objects if obj.get("kind") in ("prop", "set") and not _handled(obj)]
    if len(frames) < 2 or not static:
        return 0.0
    places = []
    for frame in frames:
        scene.frame_set(frame)
        places.append(np.array([[obj.matrix_world @ Vector(corner) for corner in obj.bound_box] for obj in static]))
    steps = np.linalg.norm(np.diff(np.array(places), axis=0), axis=-1)
    return float(steps.mean())


def _handled(obj: bpy.types.Object) -> bool:
    """Return whether an object is a door leaf or has baked motion."""
    return "swing" in obj or (obj.animation_data is not None and bool(obj.animation_data.nla_tracks))
