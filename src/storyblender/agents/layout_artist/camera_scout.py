"""Weighs places for the camera on the floor plan, before any look: line, faces, sight, room, who else is in frame."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from storyblender.agents.layout_artist.camera_composition import AT_SIDE
from storyblender.agents.layout_artist.camera_cuts import cuts
from storyblender.agents.layout_artist.camera_details import at_hand
from storyblender.agents.layout_artist.camera_furniture import GRID, backs, covers, in_the_way
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView, share_of
from storyblender.agents.layout_artist.camera_room import outside, rays, void_points
from storyblender.agents.layout_artist.camera_solids import aboard, body, holds, lidded, opened, solids
from storyblender.agents.layout_artist.camera_start import face_limit, looks_after, start, wants_shoulder
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.framing import Figure, head_share, project
from storyblender.geometry.gaps import MAX_FACE_GAP, widest_face_gap
from storyblender.geometry.orbit import Floats, Orbit
from storyblender.geometry.sight import find_hidden
from storyblender.memory.shot_sizes import SIZES, TIGHT, WHOLE

_TURNS = (0, 15, -15, 30, -30, 48, -48, 70, -70, 95, -95, 125, -125, 155, -155, 180)
_OVER_TURNS = (0, 8, -8, 16, -16, 28, -28, 40, -40)
"""Degrees to go round from the preferred azimuth; over a shoulder there is little choice."""
_PROFILE_TURNS = (54, -54, 70, -70, 88, -88)
"""Degrees to go further round over the shoulder of somebody who sees a back: to where faces are in profile."""
_RISES = (0, 9)
_HIGH_RISES = (0, 9, 19)
_BOAT_RISES = (0, 9, 19, 27)
"""Degrees to go up; three people or more are seen past each other from higher, and so is who sits in a boat."""
_NEAR = 0.3
"""Metres a camera needs from things."""
_LAP = 0.8
"""Metres from somebody within which an insert may show a part of them that the spots of their body do not tell."""
_AT_BACK = 0.1
"""Metres it needs from the one over whose shoulder it looks."""
AT_EDGE = 0.6
"""Widths from the middle of the picture at which the middle of that one's head still leaves a shoulder in it."""
_SHOULDER_IN = 0.3
"""The same for a head of no size: the smaller the head, the less of a shoulder there is beside it."""
LEAST_OVER = 0.2
"""Share of the picture's height from which that head is one that we look past, and not somebody in the background."""
_UNSEEN = 0.5
"""Points lost if a body hides a thing in a picture of a person: a face matters more."""
_SIDE = 55.0
"""Degrees off its front at which a thing counts as seen from the side."""
_MARGIN = 0.03
_SHOULDER = 0.17
"""Metres from the middle of a body to its side."""
_KNEE = 0.35
"""Share of a height below which a table or a stool may hide somebody."""
_OWN = 0.3
"""Metres before a body that are its own: its chair, the pillar it leans at."""
_AT_HAND = 0.12
"""Metres before a thing in an insert that are its own: the hand that holds it, the cloth it lies on."""
_MOST = 0.3
"""Share of somebody that may be hidden."""
_CUT = 0.04
"""Share of a whole body that the frame may take off."""
_LOOMING = 1.2
"""Points for a head that is e times as large as the size wants: nobody fills the foreground of a group."""
_LEAVES, _COMES = 1.5, 0.2
"""Points for a moment at which the first person is out of the picture: who is alone in it, and one of several."""
_FRONT = 0.08
"""Share of the picture that a table or a counter may take before them."""
_STANDS, _TAKEN = 0.3, 0.3
"""Metres below which a thing stands on the floor; points for taking it away with a wall, and half a point a m3."""
_COMPANY, _BACK = 1.7, 3.0
"""Metres from the first person within which who is seen takes part in the picture; points for such a one's back."""
_TURNED = 2.0
"""Points for an establishing shot that shows all of its people from behind; who walks into a place may show a back."""
_HEADLESS, _SEEN = 1.2, 0.04
"""Points for a body without its head, from heads of that share of the picture's height."""
_APART = 0.5
"""Points for each head of empty middle between two people."""
_NO_FACE = 0.6
"""Points for a face turned further away than the kind of shot allows, besides those for every degree."""
_FACED = 3.0
"""Points for a face where the script asks for a back."""
_FROM_BEHIND = 100.0
"""Degrees from full face from which somebody is seen from behind."""
_LOOKS_DOWN = -0.5
"""Height of the way a face looks, of one, under which its owner bends over something."""
_BACKSIDE = 0.06
"""Share of the picture that backs of furniture may take."""
CLEARED = 0.3
"""Points for sending somebody out of the picture who has no part in it: continuity minds a little."""


def scouted(view: CameraOperatorView) -> list[CameraOperatorDraft]:
    """Return compositions from all around, the most promising first; a point of view has only one.

    Where people show who have no part in a shot that is not about the place, the same take without them competes; so
    it does without the furniture that stands before the people.
    """
    if view.instruction.kind == "pov":
        return [start(view)]
    turns, rises = _TURNS, _HIGH_RISES if len(view.people) > 2 else _RISES
    if view.over is not None:
        turns = _OVER_TURNS if wants_shoulder(view) else (*_OVER_TURNS, *_PROFILE_TURNS)
    takes: dict[CameraOperatorDraft, float] = {}
    for rise in _BOAT_RISES if aboard(view.props.values(), view.people) else rises:
        for turn in turns:
            take = start(view, turn, rise)
            away = abs(turn) / 240 + rise / 45
            takes.setdefault(take, cost(view, take) + away)
            cleared = _cleared(view, take)
            for other in (cleared, without(cleared, (*in_the_way(view, take.camera), *covers(view)))):
                if other not in takes:
                    takes[other] = cost(view, other) + away
    return sorted(takes, key=lambda take: takes[take])


def _cleared(view: CameraOperatorView, take: CameraOperatorDraft) -> CameraOperatorDraft:
    """Return the take without the strangers whom it would show, and without what they carry."""
    if view.instruction.size in WHOLE:
        return take
    moments = view.moments if take.moves else (view.drawn,)
    gone: list[str] = []
    for moment in moments:
        camera = take.at(share_of(view, moment.frame))
        for node in view.strangers:
            figure = moment.figure(node)
            if figure is not None and (_inside(camera, figure) or _beside(view, figure)):
                gone.append(node)
    return without(take, belongings(view, gone))


def belongings(view: CameraOperatorView, people: Iterable[str]) -> list[str]:
    """Return the node_ids of people and of what they carry."""
    return [each for node in people for each in (node, *view.carried.get(node, ()))]


def without(take: CameraOperatorDraft, nodes: Iterable[str]) -> CameraOperatorDraft:
    """Return the take with more hidden."""
    return replace(take, hidden=tuple(dict.fromkeys((*take.hidden, *nodes))))


def cost(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Return about how many points the critic would take off, from boxes and faces alone."""
    points = sum(fault.severity for fault in cuts(view, take)) + _position(view, take)
    if view.plan is not None:
        points += void_points(outside(view.plan, take.camera, take.hidden))
    points += CLEARED * sum(node in take.hidden for node in view.strangers)
    gone = [box for node, box in view.props.items() if node in take.hidden and box.z < _STANDS]
    points += sum(min(_TAKEN + 0.5 * box.width * box.depth * box.height, 2.0) for box in gone)
    return points + _people(view, take) + _things(view, take) + _kept(view, take) + _before(view, take)


def _before(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh what stands in the picture nearer than its people are, or its things; the middle third counts twice.

    What a picture of people is about counts as well, as the back of a piano does, unless they are in it. In a place
    that is shown for itself only the set counts, as the houses across the street do.
    """
    kind, things = view.instruction.kind, [(box.x, box.y, box.z + box.height / 2) for box in view.things]
    shown = [figure.face for figure in view.people] or things
    if (not shown and kind != "establishing") or view.over is not None or kind in ("pov", "insert"):
        return 0.0
    camera, (columns, rows) = take.camera, GRID
    deep = max(float(project(camera, shown or [camera.pivot])[1].mean()), 0.5) - _OWN
    spots = camera.position + rays(camera, columns, rows) * deep
    own = () if view.people else view.focus
    boxes = solids(dict(view.props) if shown else {}, view.plan, (*take.hidden, *view.vessels, *own))
    taken = find_hidden(boxes, camera.position, spots).reshape(rows, columns).mean(0)
    third = columns // 3
    share = (taken.sum() + taken[third : columns - third].sum()) / (2 * columns - 2 * third)
    return 8.0 * (max(0.0, float(share) - _FRONT) + max(0.0, backs(view, take, deep + 2 * _OWN) - _BACKSIDE))


def _kept(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh moments of the shot at which its first person has left the picture; one of several may come and go."""
    points, price = 0.0, _COMES if len(view.people) > 1 else _LEAVES
    for moment in view.moments if view.focus and view.instruction.kind != "establishing" else ():
        figure = moment.figure(view.focus[0])
        if figure is not None:
            points += price * (not _framed(take.at(share_of(view, moment.frame)), figure))
    return points


def _framed(camera: Orbit, figure: Figure) -> bool:
    screen, depth = project(camera, [figure.face])
    return bool(depth[0] > 0.1 and ((screen > _MARGIN) & (screen < 1 - _MARGIN)).all())


def _things(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh focus things that are out of the picture."""
    if not view.things or view.instruction.kind == "establishing":
        return 0.0
    middles = [(box.x, box.y, box.z + box.height / 2) for box in view.things]
    screen, depth = project(take.camera, middles)
    framed, points = (depth > 0.1) & ((screen > _MARGIN) & (screen < 1 - _MARGIN)).all(1), 0.0
    if view.instruction.kind == "insert":
        spots = [(box.x, box.y, box.top) for box in view.things]
        figures, boxes = view.drawn.figures, _solids(view, take.hidden)
        bodies = [box for figure in figures if figure.node_id not in take.hidden for box in body(figure)]
        around = [box for box in [*bodies, *boxes] if any(_meets(box, *spot, near=0.0) for spot in spots)]
        # What it lies in, as a hand by the hip lies in the box of a chair, would hide it from everywhere: only its top
        # does, as the top of a table does. A boat has none.
        tops = [lidded(box) for box in around if not any(holds(box, figure) for figure in figures)]
        boxes = [*(box for box in [*bodies, *boxes] if box not in around), *tops]
        framed &= ~find_hidden(boxes, take.camera.position, spots, _AT_HAND)
    elif at_hand(view):
        boxes = [box for figure in view.drawn.figures if figure.node_id not in take.hidden for box in body(figure)]
        small = np.array([box in at_hand(view) for box in view.things])
        points += _UNSEEN * float((framed & small & find_hidden(boxes, take.camera.position, middles, _AT_HAND)).sum())
    lost = 1.6 if view.people and view.instruction.explicit else 1.0 if view.people else 2.5
    return points + lost * float((~framed).sum()) + _wrong_side(view, take.camera)


def _wrong_side(view: CameraOperatorView, camera: Orbit) -> float:
    """Score an insert that shows the side or the back of its thing, such as a screen or a clock."""
    if view.instruction.kind != "insert" or view.detail is not None or not view.things:
        return 0.0
    around = abs(math.remainder(camera.azimuth - math.degrees(view.things[0].yaw), 360.0))
    return _BACK * max(0.0, around - _SIDE) / (180.0 - _SIDE)


def _position(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh a camera in the floor, in a thing or in somebody."""
    points = 0.0
    passing = [figure for moment in view.moments for figure in moment.figures]
    there = [figure for figure in passing if figure.node_id not in take.hidden]
    for camera in dict.fromkeys((take.start, take.end)):
        x, y, z = (float(value) for value in camera.position)
        points += 5.0 * (z < 0.12)
        points += 5.0 * any(_meets(box, x, y, z) for box in _solids(view, take.hidden))
        for each in there:
            near = _AT_BACK if view.over is not None and each.node_id == view.over.node_id else _NEAR
            points += 5.0 * any(_meets(box, x, y, z, near) for box in body(each))
    return points


def _meets(box: Box, x: float, y: float, z: float, near: float = _NEAR) -> bool:
    return box.z - near < z < box.top + near and distance_to_point(box, x, y) <= near


def _solids(view: CameraOperatorView, hidden: Sequence[str]) -> list[Box]:
    own = belongings(view, view.named) if view.detail is not None else view.focus
    return solids(dict(view.props), view.plan, (*hidden, *own))


def _people(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh faces turned away, people hidden or out of the picture, and people who have no part in it."""
    moment = view.drawn
    camera, instruction, points = take.camera, view.instruction, 0.0
    there = [figure for figure in moment.figures if figure.node_id not in take.hidden]
    solid = solids(dict(view.props), view.plan, take.hidden)
    wanted = SIZES[instruction.size].head
    points += _gap(view, camera)
    bodies = {figure.node_id: body(figure) for figure in there}
    for figure in there:
        others = [box for other in there if other is not figure for box in bodies[other.node_id]]
        if figure.node_id in view.focus and instruction.kind != "establishing":
            points += _subject(view, camera, figure, [*others, *opened(solid, figure)])
        elif figure is view.over:
            (near,), _ = project(camera, [figure.face])
            head = head_share(camera, figure)
            aside = abs(float(near[0]) - 0.5) > min(AT_EDGE, _SHOULDER_IN + 0.5 * head)
            points += 1.5 * (aside or (wants_shoulder(view) and head < LEAST_OVER))
        elif figure.node_id in view.in_frame and instruction.size not in TIGHT:
            whole = _framed(camera, figure) and project(camera, figure.crown)[0][0, 1] > 0
            points += 0.8 * (not whole or hidden_share(camera, figure, [*others, *solid]) > _MOST)
            if instruction.kind == "establishing":
                points += _cut_off(camera, figure)
                points += 0.0 if view.in_stride else _TURNED * _behind(camera, figure) / len(view.in_frame)
            points += _LOOMING * max(0.0, math.log(head_share(camera, figure) / wanted) - 0.5) * _inside(camera, figure)
        elif figure.node_id in view.strangers and view.focus and instruction.size not in WHOLE:
            points += 0.9 * (_inside(camera, figure) and hidden_share(camera, figure, solid) < 1)
        elif figure.node_id in view.strangers and instruction.kind not in ("establishing", "insert"):
            points += _back(view, camera, figure) + _beheaded(camera, figure)
    return points


def _gap(view: CameraOperatorView, camera: Orbit) -> float:
    """Penalise an empty middle between people far apart: a camera along their line brings them together."""
    people = view.people if view.instruction.size not in ("WS", "EWS") and view.over is None else ()
    if len(people) < 2 or view.instruction.kind in ("establishing", "pov", "insert"):
        return 0.0
    across = project(camera, [figure.face for figure in people])[0][:, 0]
    gap = widest_face_gap([(float(x), head_share(camera, each)) for x, each in zip(across, people, strict=True)],
                       camera.aspect)  # fmt: skip
    return min(_APART * max(0.0, gap - MAX_FACE_GAP), 2.0)


def _beheaded(camera: Orbit, figure: Figure) -> float:
    """Weigh somebody who is there by chance and whose head the frame takes off."""
    (crown, face), depth = project(camera, [figure.crown, figure.face])
    if depth.min() < 0.1 or head_share(camera, figure) < _SEEN or not _inside(camera, figure):
        return 0.0
    return _HEADLESS * bool(crown[1] < 0 or face[1] > 1)


def _back(view: CameraOperatorView, camera: Orbit, figure: Figure) -> float:
    """Weigh the back of somebody beside the first person: who is that near takes part, and has a face."""
    near = view.people and math.dist(figure.base[:2], view.people[0].base[:2]) < _COMPANY
    if not near or not _inside(camera, figure):
        return 0.0
    return _BACK * _behind(camera, figure)


def _behind(camera: Orbit, figure: Figure) -> float:
    """Return how far somebody is seen from behind: 0 up to a little more than profile, 1 for the back."""
    return max(0.0, figure.turned_from(camera.position) - _FROM_BEHIND) / (180.0 - _FROM_BEHIND)


def _subject(view: CameraOperatorView, camera: Orbit, figure: Figure, boxes: Sequence[Box]) -> float:
    """Weigh one of the people whom the shot is about."""
    lead = figure.node_id == view.people[0].node_id if view.people else True
    weight = 1.0 if lead else 0.6
    # Who walks off from the one over whose shoulder they are seen may show their back.
    leaves = looks_after(view) is not None and view.in_stride
    limit = min(face_limit(view), math.inf if leaves or view.instruction.behind else 75.0)
    turned = figure.turned_from(camera.position)
    points = weight * (2.0 * max(0.0, (turned - limit) / 60) + _NO_FACE * (turned > face_limit(view)))
    if view.instruction.behind:
        points += weight * _FACED * (1 - _behind(camera, figure))
    else:
        points += weight * _bent_from_behind(camera, figure)
    if not _framed(camera, figure):
        return points + 3.0
    x = float(project(camera, [figure.face])[0][0, 0])
    points += len(view.people) > 1 and not AT_SIDE < x < 1 - AT_SIDE
    share = hidden_share(camera, figure, boxes)
    points += weight * (2.5 * _covered(camera, [figure.face], boxes) + (1 + 4 * (share - _MOST)) * (share > _MOST))
    points += _cut_off(camera, figure) * (view.instruction.size in WHOLE)
    off = math.log(head_share(camera, figure) / SIZES[view.instruction.size].head)
    return points + 0.8 * max(0.0, -off - 0.5) * lead + _LOOMING * max(0.0, off - 0.35)


def _bent_from_behind(camera: Orbit, figure: Figure) -> float:
    """Weigh the seat of somebody who bends: a face that looks down is as far away from behind as from before."""
    if figure.forward[2] > _LOOKS_DOWN:
        return 0.0
    around = abs(math.remainder(camera.azimuth - figure.yaw, 360.0))
    return _BACK * max(0.0, around - _FROM_BEHIND) / (180.0 - _FROM_BEHIND)


def _cut_off(camera: Orbit, figure: Figure) -> float:
    """Weigh what the frame takes off a body that should be whole."""
    (_, top), (_, bottom) = project(camera, [figure.crown, figure.base])[0]
    cut = (max(float(bottom) - 1, 0.0) + max(-float(top), 0.0)) / max(float(bottom - top), 1e-3)
    return (0.5 + 2 * cut) * (cut > _CUT)


def hidden_share(camera: Orbit, figure: Figure, boxes: Sequence[Box]) -> float:
    """Return the share of somebody's body in the picture that boxes hide; 1 if nothing of it is in the picture."""
    spots = _body_spots(camera, figure)
    screen, depth = project(camera, spots)
    framed = ((screen > 0) & (screen < 1)).all(1) & (depth > 0.1)
    return _covered(camera, spots[framed], boxes) if framed.any() else 1.0


def _covered(camera: Orbit, spots: ArrayLike, boxes: Sequence[Box]) -> float:
    """Return the share of points that boxes hide from the camera."""
    return float(find_hidden(boxes, camera.position, spots, _OWN).mean())


def _body_spots(camera: Orbit, figure: Figure) -> Floats:
    """Return points down the middle and both sides of a body to its knees, as the camera sees it."""
    height = figure.crown[2] - figure.base[2]
    column = np.linspace(figure.crown, (*figure.face[:2], figure.base[2] + _KNEE * height), 7)
    aside = camera.axes[:, 0] * _SHOULDER
    return np.concatenate([column - aside, column, column + aside])


def _beside(view: CameraOperatorView, figure: Figure) -> bool:
    """Return whether somebody is so near the thing of an insert that a lap or a sleeve may show."""
    near = (math.dist((box.x, box.y), figure.base[:2]) < _LAP for box in view.things)
    return view.instruction.kind == "insert" and any(near)


def _inside(camera: Orbit, figure: Figure) -> bool:
    """Return whether anything of somebody is in the picture, however small."""
    screen, depth = project(camera, _body_spots(camera, figure))
    return bool((((screen > -_MARGIN) & (screen < 1 + _MARGIN)).all(1) & (depth > 0.1)).any())
