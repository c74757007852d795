"""Furniture in a picture: what may be hidden in front of the subjects, and backs that nobody wants to see."""

from __future__ import annotations

import numpy as np

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.agents.layout_artist.camera_room import rays
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.framing import project
from storyblender.geometry.orbit import Orbit
from storyblender.geometry.sight import find_hidden

GRID = (15, 8)
"""Columns and rows of the rays sampled over a picture."""
_ON = 0.05
"""Most metres between a top and the foot of a thing on it."""
_THEIRS = 0.7
"""Metres from a subject within which furniture is theirs and stays."""
_NEARER, _TAKES, _WORTH = 0.7, 0.015, 0.05
"""Share of the distance to the people up to which a thing is in front of them; least share of the picture of one such
thing, and of all of them, for anything to be hidden.
"""
_ABOVE = 0.4
"""Metres above a thing within which an object covers it: a table top, not a ceiling lamp."""
_FURNITURE = 0.3
"""Cubic metres from which a thing has a back."""


def find_furniture_in_front(view: CameraOperatorView, camera: Orbit) -> list[str]:
    """Return the node_ids of furniture in front of the subjects, and of what stands on it; empty for a shot of a place.

    Args:
        view: The shot.
        camera: The camera.
    """
    people = view.people
    if not people or not view.removable_props or view.instruction.kind in ("establishing", "pov", "insert"):
        return []
    deep = float(project(camera, [figure.face for figure in people])[1].mean())
    _, depths = project(camera, [(box.x, box.y, box.z + box.height / 2) for box in view.removable_props.values()])
    near = [
        pair for pair, depth in zip(view.removable_props.items(), depths, strict=True) if 0 < depth < _NEARER * deep
    ]
    near = [(node, box) for node, box in near if not _belongs_to_subject(view, box)]
    if not near:
        return []
    spots = camera.position + rays(camera, *GRID) * deep
    if float(find_hidden([box for _, box in near], camera.position, spots).mean()) < _WORTH:
        return []
    gone: list[str] = []
    for node, box in near:
        if float(find_hidden([box], camera.position, spots).mean()) > _TAKES:
            gone += [node, *(other for other, each in view.props.items() if _stands_on(each, box))]
    return gone


def find_covers(view: CameraOperatorView) -> list[str]:
    """Return the node_ids of things that contain or cover the thing of an insert: its desk, the cup on the letter."""
    if view.instruction.kind != "insert" or view.detail is not None:
        return []
    found: list[str] = []
    for thing in view.things:
        for node, box in view.removable_props.items():
            over = box.top > thing.top + _ON and box.z < thing.top + _ABOVE
            if over and distance_to_point(box, thing.x, thing.y) <= 0:
                found += [node, *(each for each, other in view.removable_props.items() if _stands_on(other, box))]
    return list(dict.fromkeys(found))


def _belongs_to_subject(view: CameraOperatorView, box: Box) -> bool:
    """Return whether furniture is close to a focus person."""
    return min(distance_to_point(box, *figure.base[:2]) for figure in view.people) < _THEIRS


def _stands_on(thing: Box, box: Box) -> bool:
    """Return whether a thing stands on a box."""
    return abs(thing.z - box.top) < _ON and distance_to_point(box, thing.x, thing.y) <= 0


def share_of_backs(view: CameraOperatorView, take: CameraOperatorDraft, deep: float) -> float:
    """Return the share of the picture that shows backs of furniture, such as bare boards that stood at a wall.

    Args:
        view: The shot.
        take: The camera and what it hides.
        deep: Most metres from the camera.
    """
    camera, behind = take.camera, list[Box]()
    eye_x, eye_y = float(camera.position[0]), float(camera.position[1])
    for node, box in view.props.items():
        if box.width * box.depth * box.height < _FURNITURE or node in take.hidden:
            continue
        x, y = box.to_local(eye_x, eye_y)
        if y > max(box.depth, abs(x)) / 2:
            behind.append(box)
    if not behind:
        return 0.0
    return float(np.mean(find_hidden(behind, camera.position, camera.position + rays(camera, *GRID) * deep)))
