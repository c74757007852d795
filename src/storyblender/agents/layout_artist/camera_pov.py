"""The point of view: the camera at the eyes of a person."""

from __future__ import annotations

import numpy as np

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView
from storyblender.geometry import framing
from storyblender.geometry.orbit import Orbit

_EYES = 50.0
"""Longest lens in mm of a point of view, unless the script asks for a longer one."""
_LOOKED_AT = {"low angle": 0.75, "worm's-eye": 0.9, "high angle": 0.25, "bird's-eye": 0.1}
"""Height, as a share of a thing's, at which it is looked at from an angle; other angles look at its middle."""


def frame_pov(view: CameraOperatorView, lens: float) -> Orbit | None:
    """Return the camera at the eyes of the instruction's ``pov_id``; None if that person is not on stage.

    Args:
        view: The shot.
        lens: Focal length in mm that its size wants.
    """
    eyes = view.story_moment.figure(view.node(view.instruction.pov_id or ""))
    if eyes is None:
        return None
    target = np.asarray(eyes.face) + 3 * np.asarray(eyes.forward)
    if view.people:
        target = np.mean([figure.face for figure in view.people], axis=0)
    elif view.things:
        # A look up or down goes to the tops or the feet of the things, and holds them all.
        share = _LOOKED_AT.get(view.instruction.angle, 0.5)
        target = np.mean([(box.x, box.y, box.z + share * box.height) for box in view.things], axis=0)
    lens = view.instruction.lens or (lens if lens <= _EYES else view.widened(_EYES))
    return framing.frame_point_of_view(view.film, eyes, target, lens)
