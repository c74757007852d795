"""Furniture in a picture: what a crew moves out of the camera's way, and backs of things that nobody wants to see."""

from __future__ import annotations

import numpy as np

from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.agents.layout_artist.camera_room import rays
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.framing import project
from storyblender.geometry.orbit import Orbit
from storyblender.geometry.sight import find_hidden

GRID = (15, 8)
"""Columns and rows of the rays that look for what stands before everybody."""
_ON = 0.05
"""Metres between a top and the foot of what stands on it."""
_THEIRS = 0.7
"""Metres from somebody of the picture within which a thing is theirs: their table is not moved."""
_NEARER, _TAKES, _WORTH = 0.7, 0.015, 0.05
"""Share of the way to the people up to which a thing stands before them; shares of the picture that one such thing
takes, and all of them, before anything is moved."""
_ABOVE = 0.4
"""Metres above a thing within which an object hides it: a table top, not a lamp at the ceiling."""
_FURNITURE = 0.3
"""Cubic metres from which a thing has a back."""


def in_the_way(view: CameraOperatorView, camera: Orbit) -> list[str]:
    """Return the node_ids of the furniture that stands before the people of a picture, and of what stands on it.

    Not what is theirs, what somebody uses or sits on; nothing where the shot shows a place.
    """
    people = view.people
    if not people or not view.removable_props or view.instruction.kind in ("establishing", "pov", "insert"):
        return []
    deep = float(project(camera, [figure.face for figure in people])[1].mean())
    _, depths = project(camera, [(box.x, box.y, box.z + box.height / 2) for box in view.removable_props.values()])
    near = [
        pair for pair, depth in zip(view.removable_props.items(), depths, strict=True) if 0 < depth < _NEARER * deep
    ]
    near = [(node, box) for node, box in near if not _is_theirs(view, box)]
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


def covers(view: CameraOperatorView) -> list[str]:
    """Return the node_ids that contain or cover the thing of an insert: the drawer's desk, the cup on the letter."""
    if view.instruction.kind != "insert" or view.detail is not None:
        return []
    found: list[str] = []
    for thing in view.things:
        for node, box in view.removable_props.items():
            over = box.top > thing.top + _ON and box.z < thing.top + _ABOVE
            if over and distance_to_point(box, thing.x, thing.y) <= 0:
                found += [node, *(each for each, other in view.props.items() if _on_it(each, other, box, view))]
    return list(dict.fromkeys(found))


def _on_it(node: str, thing: Box, box: Box, view: CameraOperatorView) -> bool:
    return node in view.removable_props and _stands_on(thing, box)


def _is_theirs(view: CameraOperatorView, box: Box) -> bool:
    return min(distance_to_point(box, *figure.base[:2]) for figure in view.people) < _THEIRS


def _stands_on(thing: Box, box: Box) -> bool:
    return abs(thing.z - box.top) < _ON and distance_to_point(box, thing.x, thing.y) <= 0


def backs(view: CameraOperatorView, take: CameraOperatorDraft, deep: float) -> float:
    """Return the share of the picture that shows the backs of furniture: bare boards that stood at a wall.

    Args:
        view: The shot.
        take: The camera, and what it hides.
        deep: Metres from the camera up to which it counts.
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
