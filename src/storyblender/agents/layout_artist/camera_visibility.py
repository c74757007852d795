"""What a camera sees of people, computed from boxes and figures without rendering."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from storyblender.geometry.boxes import Box
from storyblender.geometry.framing import Figure, project
from storyblender.geometry.orbit import Floats, Orbit
from storyblender.geometry.sight import find_hidden

MARGIN = 0.03
"""Margin of the picture, as a share of its width and height."""
_SHOULDER = 0.17
"""Metres from the middle of a body to its side."""
_KNEE = 0.35
"""Share of a person's height below which furniture may hide them."""
OWN_SPACE = 0.3
"""Metres before a body in which nothing counts as hiding it: its chair, the pillar it leans at."""


def is_face_framed(camera: Orbit, figure: Figure) -> bool:
    """Return whether a person's face is in the picture, inside its margin.

    Args:
        camera: World camera.
        figure: The person at the same moment.
    """
    screen, depth = project(camera, [figure.face])
    return bool(depth[0] > 0.1 and ((screen > MARGIN) & (screen < 1 - MARGIN)).all())


def hidden_share(camera: Orbit, figure: Figure, boxes: Sequence[Box]) -> float:
    """Return the share of a person's points in the picture that boxes hide; 1 if none of them is in the picture.

    Args:
        camera: World camera.
        figure: The person at the same moment.
        boxes: What may hide the person, world metres; without the person's own body.
    """
    spots = _body_points(camera, figure)
    screen, depth = project(camera, spots)
    framed = ((screen > 0) & (screen < 1)).all(1) & (depth > 0.1)
    return share_of_points_hidden(camera, spots[framed], boxes) if framed.any() else 1.0


def share_of_points_hidden(camera: Orbit, spots: ArrayLike, boxes: Sequence[Box]) -> float:
    """Return the share of points that boxes hide from the camera.

    Args:
        camera: World camera.
        spots: (n, 3) world metres, n at least 1.
        boxes: What may hide them, world metres; what is within ``OWN_SPACE`` before a point does not.
    """
    return float(find_hidden(boxes, camera.position, spots, OWN_SPACE).mean())


def _body_points(camera: Orbit, figure: Figure) -> Floats:
    """Return (21, 3) world points down the middle and both sides of a body to its knees, as the camera sees it."""
    height = figure.crown[2] - figure.base[2]
    column = np.linspace(figure.crown, (*figure.face[:2], figure.base[2] + _KNEE * height), 7)
    aside = camera.axes[:, 0] * _SHOULDER
    return np.concatenate([column - aside, column, column + aside])


def is_in_picture(camera: Orbit, figure: Figure) -> bool:
    """Return whether any point of a person is in the picture, margin included.

    Args:
        camera: World camera.
        figure: The person at the same moment; counts from the crown to the knees.
    """
    screen, depth = project(camera, _body_points(camera, figure))
    return bool((((screen > -MARGIN) & (screen < 1 + MARGIN)).all(1) & (depth > 0.1)).any())
