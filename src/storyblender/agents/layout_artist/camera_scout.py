"""Weighs places for the camera on the floor plan, before any look: line, faces, sight, room, who else is in frame."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from storyblender.agents.layout_artist.camera_brief import TIGHT, CameraBrief, Take
from storyblender.agents.layout_artist.camera_cuts import cuts
from storyblender.agents.layout_artist.camera_room import outside
from storyblender.agents.layout_artist.camera_start import shoulder, start
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.framing import FACE_ANGLE, SCALES, Figure, project
from storyblender.geometry.orbit import Floats, Orbit

_TURNS = (0, 15, -15, 30, -30, 48, -48, 70, -70, 95, -95, 125, -125, 155, -155, 180)
_OVER_TURNS = (0, 8, -8, 16, -16, 28, -28, 40, -40)
"""Degrees to go round from the preferred azimuth; over a shoulder there is little choice."""
_RISES = (0, 9)
_BODY = 0.24
"""Metres: radius of a person who stands in the way."""
_NEAR = 0.3
"""Metres a camera needs from things."""
_MARGIN = 0.03


def scouted(brief: CameraBrief) -> list[Take]:
    """Return compositions from all around, the most promising first; a point of view has only one."""
    if brief.instruction.kind == "pov":
        return [start(brief)]
    turns = _OVER_TURNS if shoulder(brief) is not None else _TURNS
    takes: dict[Take, float] = {}
    for rise in _RISES:
        for turn in turns:
            take = start(brief, turn, rise)
            takes.setdefault(take, cost(brief, take) + abs(turn) / 240 + rise / 45)
    return sorted(takes, key=lambda take: takes[take])


def cost(brief: CameraBrief, take: Take) -> float:
    """Return about how many points the critic would take off, from boxes and faces alone."""
    points = sum(fault.severity for fault in cuts(brief, take)) + _position(brief, take)
    if brief.plan is not None:
        points += min(8 * outside(brief.plan, take.camera, take.hidden), 5.0)
    return points + _people(brief, take) + _things(brief, take) + _kept(brief, take)


def _kept(brief: CameraBrief, take: Take) -> float:
    """Weigh moments of the shot at which its first person has left the picture."""
    points = 0.0
    for moment in brief.moments if brief.focus and brief.instruction.kind != "establishing" else ():
        figure = moment.figure(brief.focus[0])
        if figure is not None:
            share = min(moment.frame / max(brief.duration - 1, 1), 1.0)
            points += 1.5 * (not _framed(take.at(share), figure))
    return points


def _framed(camera: Orbit, figure: Figure) -> bool:
    screen, depth = project(camera, [figure.face])
    return bool(depth[0] > 0.1 and ((screen > _MARGIN) & (screen < 1 - _MARGIN)).all())


def _things(brief: CameraBrief, take: Take) -> float:
    """Weigh focus things that are out of the picture."""
    if not brief.things or brief.instruction.kind == "establishing":
        return 0.0
    screen, depth = project(take.camera, [(box.x, box.y, box.z + box.height / 2) for box in brief.things])
    framed = (depth > 0.1) & ((screen > _MARGIN) & (screen < 1 - _MARGIN)).all(1)
    return (1.0 if brief.people else 2.5) * float((~framed).sum())


def _position(brief: CameraBrief, take: Take) -> float:
    """Weigh a camera in the floor, in a thing or in somebody."""
    points = 0.0
    for camera in dict.fromkeys((take.start, take.end)):
        x, y, z = (float(value) for value in camera.position)
        points += 5.0 * (z < 0.12)
        points += 5.0 * any(_meets(box, x, y, z) for box in _solids(brief, take.hidden))
        points += 5.0 * any(_meets(_body(figure), x, y, z) for figure in brief.moments[0].figures)
    return points


def _meets(box: Box, x: float, y: float, z: float) -> bool:
    return box.z - _NEAR < z < box.top + _NEAR and distance_to_point(box, x, y) < _NEAR


def _solids(brief: CameraBrief, hidden: Sequence[str]) -> list[Box]:
    things = [box for node, box in brief.props.items() if node not in hidden and node not in brief.focus]
    for piece in brief.plan.pieces if brief.plan is not None else ():
        if piece.solid and piece.footprint is not None and piece.node_id not in hidden:
            width, depth = (size * piece.scale for size in piece.footprint)
            things.append(Box(*piece.location, width, depth, 4.0, math.radians(piece.yaw)))
    return things


def _body(figure: Figure) -> Box:
    x, y, _ = figure.face
    low = figure.base[2]
    return Box(x, y, low, 2 * _BODY, 2 * _BODY, figure.crown[2] - low)


def _people(brief: CameraBrief, take: Take) -> float:
    """Weigh faces turned away, hidden or out of the picture, and people who have no part in it."""
    moment = brief.moments[0] if brief.walks else brief.moments[len(brief.moments) // 2]
    camera, kind = take.camera, brief.instruction.kind
    eye, limit = camera.position, FACE_ANGLE.get(kind, 108.0)
    solids, points, lead = _solids(brief, take.hidden), 0.0, True
    over = brief.node(brief.instruction.over_id or "")
    for figure in moment.figures:
        framed = _framed(camera, figure)
        others = [_body(other) for other in moment.figures if other is not figure]
        if figure.node_id in brief.focus and kind != "establishing":
            weight = 1.0 if figure.node_id == brief.focus[0] else 0.6
            turned = figure.turned_from(eye)
            points += weight * 2.0 * max(0.0, (turned - min(limit, 75.0)) / 60)
            points += 0.0 if framed else 3.0
            points += weight * 2.0 * (not _sees(eye, figure, [*others, *solids]))
            away = max(float(project(camera, [figure.face])[1][0]), 0.1)
            share = figure.head / away / (2 * camera.tangent)
            points += 0.8 * max(0.0, math.log(SCALES[brief.instruction.size].head / max(share, 1e-3)) - 0.5) * lead
            lead = False
        elif figure.node_id in brief.in_frame and brief.instruction.size not in TIGHT:
            points += 0.8 * (not framed or not _sees(eye, figure, [*others, *solids]))
        elif figure.node_id != over and brief.focus and _shows(brief, take, figure, solids):
            points += 0.9
    return points


def _shows(brief: CameraBrief, take: Take, figure: Figure, solids: Iterable[Box]) -> bool:
    """Return whether somebody who has no part in the shot is seen at a size that counts."""
    body = np.linspace(figure.crown, (*figure.face[:2], figure.base[2] + 0.5), 5)
    wide = take.camera.axes[:, 0] * _BODY
    screen, depth = project(take.camera, np.concatenate([body - wide, body, body + wide]))
    if depth.min() < 0.1 or figure.head / float(depth.min()) / (2 * take.camera.tangent) < 0.02:
        return False
    return bool(((screen > 0) & (screen < 1)).all(1).any()) and _sees(take.camera.position, figure, solids)


def _sees(eye: Floats, figure: Figure, boxes: Iterable[Box]) -> bool:
    """Return whether the way from the eye to a face is free."""
    face = np.asarray(figure.face)
    shares = np.linspace(0.03, 0.97, 24)[:, None]
    spots = eye + (face - eye) * shares
    for box in boxes:
        dx, dy = spots[:, 0] - box.x, spots[:, 1] - box.y
        u, v = box.cos * dx + box.sin * dy, box.cos * dy - box.sin * dx
        within = (np.abs(u) < box.width / 2) & (np.abs(v) < box.depth / 2)
        if bool((within & (spots[:, 2] > box.z) & (spots[:, 2] < box.top)).any()):
            return False
    return True
