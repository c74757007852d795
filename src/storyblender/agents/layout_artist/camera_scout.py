"""Ranks camera places for a shot on the floor plan, without rendering: by cuts, faces, sight lines and room.

Costs are estimates of the points that the Camera Operator's critic would take off its score.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from storyblender.agents.layout_artist.camera_composition import AT_SIDE
from storyblender.agents.layout_artist.camera_crowd import compose_without_crowd
from storyblender.agents.layout_artist.camera_cuts import find_cut_faults
from storyblender.agents.layout_artist.camera_details import held_things
from storyblender.agents.layout_artist.camera_furniture import (
    GRID,
    find_covers,
    find_furniture_in_front,
    share_of_backs,
)
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView, time_share
from storyblender.agents.layout_artist.camera_room import rays, share_outside, void_points
from storyblender.agents.layout_artist.camera_solids import (
    body_boxes,
    contains_person,
    is_anyone_aboard,
    open_vessels,
    solid_boxes,
    top_slab,
)
from storyblender.agents.layout_artist.camera_start import (
    ignored_partner,
    max_face_angle,
    requires_shoulder,
)
from storyblender.agents.layout_artist.camera_visibility import (
    MARGIN,
    OWN_SPACE,
    hidden_share,
    is_face_framed,
    is_in_picture,
    share_of_points_hidden,
)
from storyblender.agents.layout_artist.vehicle_panels import aboard, wild_vehicles
from storyblender.geometry.boxes import Box, distance_to_point
from storyblender.geometry.framing import Figure, head_share, project
from storyblender.geometry.gaps import MAX_FACE_GAP, widest_face_gap
from storyblender.geometry.orbit import Orbit
from storyblender.geometry.sight import find_hidden
from storyblender.memory.shot_sizes import SIZES, TIGHT, WHOLE

_TURNS = (0, 15, -15, 30, -30, 48, -48, 70, -70, 95, -95, 125, -125, 155, -155, 180)
_OVER_TURNS = (0, 8, -8, 16, -16, 28, -28, 40, -40)
"""Degrees to turn around the pivot from the preferred azimuth; an over-the-shoulder leaves little choice."""
_PROFILE_TURNS = (54, -54, 70, -70, 88, -88)
"""Further turns in degrees for an over-the-shoulder whose subject faces away: they show the faces in profile."""
_RISES = (0, 9)
_HIGH_RISES = (0, 9, 19)
_BOAT_RISES = (0, 9, 19, 27)
"""Degrees to rise above the preferred elevation: for one or two people, for three or more, and for people in a boat."""
_NEAR = 0.3
"""Metres a camera needs from boxes."""
_LAP = 0.8
"""Metres from the thing of an insert within which a person's lap or sleeve may be in the picture."""
_AT_BACK = 0.1
"""Metres a camera needs from the person over whose shoulder it looks."""
AT_EDGE = 0.6
"""Widths from the middle of the picture to the head of an over-the-shoulder partner, at most."""
_SHOULDER_IN = 0.3
"""The same for a head of no size: the smaller the head, the less of its shoulder is in the picture."""
LEAST_OVER = 0.2
"""Least height of the partner's head in an over-the-shoulder, as a share of the picture's height."""
_UNSEEN = 0.5
"""Points if a body hides a held thing in a picture of people: a face matters more."""
_SIDE = 55.0
"""Degrees off its front at which a thing counts as seen from the side."""
_AT_HAND = 0.12
"""Metres before a thing in which nothing counts as hiding it: the hand that holds it, the cloth it lies on."""
_MOST = 0.3
"""Share of a person that may be hidden."""
_CUT = 0.04
"""Share of a whole body that the frame may cut."""
_LOOMING = 1.2
"""Points for a head e times as large as the shot size asks for: nobody fills the foreground of a group."""
_LEAVES, _COMES = 1.5, 0.2
"""Points for a moment at which the first person is out of the picture: if they are alone in it, and in a group."""
_FRONT = 0.08
"""Share of the picture that furniture may take in front of its subjects."""
_STANDS, _TAKEN = 0.3, 0.3
"""Metres below which a thing stands on the floor; points for hiding it with a wall, besides 0.5 per cubic metre."""
_COMPANY, _BACK = 1.7, 3.0
"""Metres from the first person within which another counts as their companion; points for a companion's back."""
_TURNED = 2.0
"""Points for an establishing shot that shows all of its people from behind."""
_HEADLESS, _SEEN = 1.2, 0.04
"""Points for a body whose head the frame cuts, if the head is at least that share of the picture's height."""
_APART = 0.5
"""Points for each head's width of empty picture between two people."""
_NO_FACE = 0.6
"""Points for a face turned further away than the kind of shot allows, besides those for every degree."""
_FACED = 3.0
"""Points for a face where the script asks for a back."""
FROM_BEHIND = 100.0
"""Degrees from full face from which a person is seen from behind."""
_LOOKS_DOWN = -0.5
"""Z of the unit vector of a face's look, below which the person bends over something."""
_BACKSIDE = 0.06
"""Share of the picture that backs of furniture may take."""
CLEARED = 0.3
"""Points for hiding a person who has no part in the shot: it breaks continuity a little."""


def scout_takes(view: CameraOperatorView) -> list[CameraOperatorDraft]:
    """Return takes from all around the subjects, the cheapest first; a point of view has only one.

    Each take competes with variants that hide people who have no part in the shot and furniture in front of its people.
    """
    if view.instruction.kind == "pov":
        return [compose_without_crowd(view)]
    turns, rises = _TURNS, _HIGH_RISES if len(view.people) > 2 else _RISES
    if view.over is not None:
        turns = _OVER_TURNS if requires_shoulder(view) else (*_OVER_TURNS, *_PROFILE_TURNS)
    takes: dict[CameraOperatorDraft, float] = {}
    for rise in _BOAT_RISES if is_anyone_aboard(view.props.values(), view.people) else rises:
        for turn in turns:
            take = compose_without_crowd(view, turn, rise)
            away = abs(turn) / 240 + rise / 45
            takes.setdefault(take, take_cost(view, take) + away)
            cleared = _without_strangers(view, take)
            for other in (
                cleared,
                with_hidden(cleared, (*find_furniture_in_front(view, take.camera), *find_covers(view))),
            ):
                if other not in takes:
                    takes[other] = take_cost(view, other) + away
    return sorted(takes, key=lambda take: takes[take])


def _without_strangers(view: CameraOperatorView, take: CameraOperatorDraft) -> CameraOperatorDraft:
    """Return the take with every stranger in its picture hidden, and what they carry; wide shots keep everybody."""
    if view.instruction.size in WHOLE:
        return take
    moments = view.moments if take.moves else (view.story_moment,)
    gone: list[str] = []
    strangers = [node for node in view.strangers if node not in aboard(view)]
    for moment in moments:
        camera = take.at(time_share(view, moment.frame))
        for node in strangers:
            figure = moment.figure(node)
            if figure is not None and (is_in_picture(camera, figure) or _is_beside_insert(view, figure)):
                gone.append(node)
    return with_hidden(take, with_carried_things(view, gone))


def with_carried_things(view: CameraOperatorView, people: Iterable[str]) -> list[str]:
    """Return the node_ids of people and, after each, of the things they carry in the shot."""
    return [each for node in people for each in (node, *view.carried.get(node, ()))]


def with_hidden(take: CameraOperatorDraft, nodes: Iterable[str]) -> CameraOperatorDraft:
    """Return the take with further nodes (node_ids) hidden for the whole shot; the given take stays."""
    return replace(take, hidden=tuple(dict.fromkeys((*take.hidden, *nodes))))


def take_cost(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Return about how many points (of ten) the critic would take off a take, from boxes and faces alone.

    Args:
        view: The shot.
        take: What it hides is not in the way, but costs a little.
    """
    points = sum(fault.severity for fault in find_cut_faults(view, take)) + _camera_place_cost(view, take)
    if view.plan is not None:
        points += void_points(share_outside(view.plan, take.camera, take.hidden))
    points += CLEARED * sum(node in take.hidden for node in view.strangers)
    gone = [box for node, box in view.props.items() if node in take.hidden and box.z < _STANDS]
    points += sum(min(_TAKEN + 0.5 * box.width * box.depth * box.height, 2.0) for box in gone)
    return (
        points
        + _people_cost(view, take)
        + _things_cost(view, take)
        + _leaving_cost(view, take)
        + _foreground_cost(view, take)
    )


def _foreground_cost(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh what is in front of the subjects in the picture; its middle third counts twice.

    In an establishing shot without people only the set counts, such as the houses across the street.
    """
    kind, things = view.instruction.kind, [(box.x, box.y, box.z + box.height / 2) for box in view.things]
    shown = [figure.face for figure in view.people] or things
    if (not shown and kind != "establishing") or view.over is not None or kind in ("pov", "insert"):
        return 0.0
    camera, (columns, rows) = take.camera, GRID
    deep = max(float(project(camera, shown or [camera.pivot])[1].mean()), 0.5) - OWN_SPACE
    spots = camera.position + rays(camera, columns, rows) * deep
    own = () if view.people else view.focus
    boxes = solid_boxes(
        dict(view.props) if shown else {}, view.plan, (*take.hidden, *view.vessels, *wild_vehicles(view), *own)
    )
    taken = find_hidden(boxes, camera.position, spots).reshape(rows, columns).mean(0)
    third = columns // 3
    share = (taken.sum() + taken[third : columns - third].sum()) / (2 * columns - 2 * third)
    return 8.0 * (
        max(0.0, float(share) - _FRONT) + max(0.0, share_of_backs(view, take, deep + 2 * OWN_SPACE) - _BACKSIDE)
    )


def _leaving_cost(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh the moments at which the first person is out of the picture; in a group they may come and go."""
    points, price = 0.0, _COMES if len(view.people) > 1 else _LEAVES
    for moment in view.moments if view.focus and view.instruction.kind != "establishing" else ():
        figure = moment.figure(view.focus[0])
        if figure is not None:
            points += price * (not is_face_framed(take.at(time_share(view, moment.frame)), figure))
    return points


def _things_cost(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh focus things that are out of the picture, hidden, or seen from behind in an insert."""
    if not view.things or view.instruction.kind == "establishing":
        return 0.0
    middles = [(box.x, box.y, box.z + box.height / 2) for box in view.things]
    screen, depth = project(take.camera, middles)
    framed, points = (depth > 0.1) & ((screen > MARGIN) & (screen < 1 - MARGIN)).all(1), 0.0
    if view.instruction.kind == "insert":
        spots = [(box.x, box.y, box.top) for box in view.things]
        figures, boxes = view.story_moment.figures, _solid_boxes(view, take.hidden)
        bodies = [box for figure in figures if figure.node_id not in take.hidden for box in body_boxes(figure)]
        around = [box for box in [*bodies, *boxes] if any(_is_near_box(box, *spot, near=0.0) for spot in spots)]
        # A box that contains the thing (a hand beside the hip is in the chair's box) would hide it from everywhere:
        # only its top counts, such as a table's. A boat has none.
        tops = [top_slab(box) for box in around if not any(contains_person(box, figure) for figure in figures)]
        boxes = [*(box for box in [*bodies, *boxes] if box not in around), *tops]
        framed &= ~find_hidden(boxes, take.camera.position, spots, _AT_HAND)
    elif held_things(view):
        boxes = [
            box
            for figure in view.story_moment.figures
            if figure.node_id not in take.hidden
            for box in body_boxes(figure)
        ]
        small = np.array([box in held_things(view) for box in view.things])
        points += _UNSEEN * float((framed & small & find_hidden(boxes, take.camera.position, middles, _AT_HAND)).sum())
    lost = 1.6 if view.people and view.instruction.explicit else 1.0 if view.people else 2.5
    return points + lost * float((~framed).sum()) + _thing_side_cost(view, take.camera)


def _thing_side_cost(view: CameraOperatorView, camera: Orbit) -> float:
    """Weigh an insert that shows the side or the back of its thing, such as a screen or a clock."""
    if view.instruction.kind != "insert" or view.detail is not None or not view.things:
        return 0.0
    around = abs(math.remainder(camera.azimuth - math.degrees(view.things[0].yaw), 360.0))
    return _BACK * max(0.0, around - _SIDE) / (180.0 - _SIDE)


def _camera_place_cost(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh a camera that is below the floor, in a thing or in a person."""
    points = 0.0
    passing = [figure for moment in view.moments for figure in moment.figures]
    there = [figure for figure in passing if figure.node_id not in take.hidden]
    for camera in dict.fromkeys((take.start, take.end)):
        x, y, z = (float(value) for value in camera.position)
        points += 5.0 * (z < 0.12)
        points += 5.0 * any(_is_near_box(box, x, y, z) for box in _solid_boxes(view, take.hidden))
        for each in there:
            near = _AT_BACK if view.over is not None and each.node_id == view.over.node_id else _NEAR
            points += 5.0 * any(_is_near_box(box, x, y, z, near) for box in body_boxes(each))
    return points


def _is_near_box(box: Box, x: float, y: float, z: float, near: float = _NEAR) -> bool:
    """Return whether a world point (metres) is in a box or less than ``near`` metres from it."""
    return box.z - near < z < box.top + near and distance_to_point(box, x, y) <= near


def _solid_boxes(view: CameraOperatorView, hidden: Sequence[str]) -> list[Box]:
    """Return the boxes of the set and of the things that a camera must not be in, without those the shot is about."""
    own = with_carried_things(view, view.named) if view.detail is not None else view.focus
    return solid_boxes(dict(view.props), view.plan, (*hidden, *own, *wild_vehicles(view)))


def _people_cost(view: CameraOperatorView, take: CameraOperatorDraft) -> float:
    """Weigh faces turned away, people hidden or out of the picture, and people who have no part in the shot."""
    moment = view.story_moment
    camera, instruction, points = take.camera, view.instruction, 0.0
    there = [figure for figure in moment.figures if figure.node_id not in take.hidden]
    solid = solid_boxes(dict(view.props), view.plan, (*take.hidden, *wild_vehicles(view)))
    wanted = SIZES[instruction.size].head
    points += _gap_cost(view, camera)
    bodies = {figure.node_id: body_boxes(figure) for figure in there}
    for figure in there:
        others = [box for other in there if other is not figure for box in bodies[other.node_id]]
        if figure.node_id in view.focus and instruction.kind != "establishing":
            points += _subject_cost(view, camera, figure, [*others, *open_vessels(solid, figure)])
        elif figure is view.over:
            (near,), _ = project(camera, [figure.face])
            head = head_share(camera, figure)
            aside = abs(float(near[0]) - 0.5) > min(AT_EDGE, _SHOULDER_IN + 0.5 * head)
            front = view.asked.over_id is not None and figure.turned_from(camera.position) < FROM_BEHIND
            points += 1.5 * (aside or front or (requires_shoulder(view) and head < LEAST_OVER))
        elif figure.node_id in view.in_frame and instruction.size not in TIGHT:
            whole = is_face_framed(camera, figure) and project(camera, figure.crown)[0][0, 1] > 0
            points += 0.8 * (not whole or hidden_share(camera, figure, [*others, *solid]) > _MOST)
            if instruction.kind == "establishing":
                points += _cropped_body_cost(camera, figure)
                points += 0.0 if view.in_stride else _TURNED * _share_from_behind(camera, figure) / len(view.in_frame)
            points += (
                _LOOMING * max(0.0, math.log(head_share(camera, figure) / wanted) - 0.5) * is_in_picture(camera, figure)
            )
        elif figure.node_id in view.strangers and view.focus and instruction.size not in WHOLE:
            points += 0.9 * (is_in_picture(camera, figure) and hidden_share(camera, figure, solid) < 1)
        elif figure.node_id in view.strangers and instruction.kind not in ("establishing", "insert"):
            points += _companion_back_cost(view, camera, figure) + _cut_head_cost(camera, figure)
    return points


def _gap_cost(view: CameraOperatorView, camera: Orbit) -> float:
    """Weigh an empty middle between people far apart: a camera along their line brings them together."""
    people = view.people if view.instruction.size not in ("WS", "EWS") and view.over is None else ()
    if len(people) < 2 or view.instruction.kind in ("establishing", "pov", "insert"):
        return 0.0
    across = project(camera, [figure.face for figure in people])[0][:, 0]
    gap = widest_face_gap([(float(x), head_share(camera, each)) for x, each in zip(across, people, strict=True)],
                       camera.aspect)  # fmt: skip
    return min(_APART * max(0.0, gap - MAX_FACE_GAP), 2.0)


def _cut_head_cost(camera: Orbit, figure: Figure) -> float:
    """Weigh a stranger whose head the frame cuts."""
    (crown, face), depth = project(camera, [figure.crown, figure.face])
    if depth.min() < 0.1 or head_share(camera, figure) < _SEEN or not is_in_picture(camera, figure):
        return 0.0
    return _HEADLESS * bool(crown[1] < 0 or face[1] > 1)


def _companion_back_cost(view: CameraOperatorView, camera: Orbit, figure: Figure) -> float:
    """Weigh the back of a stranger who is close to the first person: the audience takes them for part of the shot."""
    near = view.people and math.dist(figure.base[:2], view.people[0].base[:2]) < _COMPANY
    if not near or not is_in_picture(camera, figure):
        return 0.0
    return _BACK * _share_from_behind(camera, figure)


def _share_from_behind(camera: Orbit, figure: Figure) -> float:
    """Return how far a person is seen from behind: 0 up to a little more than profile, 1 for the back."""
    return max(0.0, figure.turned_from(camera.position) - FROM_BEHIND) / (180.0 - FROM_BEHIND)


def _subject_cost(view: CameraOperatorView, camera: Orbit, figure: Figure, boxes: Sequence[Box]) -> float:
    """Weigh one of the focus people: face, place in the picture, size and what hides them."""
    lead = figure.node_id == view.people[0].node_id if view.people else True
    weight = 1.0 if lead else 0.6
    # A subject who walks away from their over-the-shoulder partner may show their back.
    leaves = ignored_partner(view) is not None and view.in_stride
    limit = min(max_face_angle(view), math.inf if leaves or view.instruction.behind else 75.0)
    turned = figure.turned_from(camera.position)
    points = weight * (2.0 * max(0.0, (turned - limit) / 60) + _NO_FACE * (turned > max_face_angle(view)))
    if view.instruction.behind:
        points += weight * _FACED * (1 - _share_from_behind(camera, figure))
    else:
        points += weight * _bent_back_cost(camera, figure)
    if not is_face_framed(camera, figure):
        return points + 3.0
    x = float(project(camera, [figure.face])[0][0, 0])
    points += len(view.people) > 1 and not AT_SIDE < x < 1 - AT_SIDE
    share = hidden_share(camera, figure, boxes)
    points += weight * (
        2.5 * share_of_points_hidden(camera, [figure.face], boxes) + (1 + 4 * (share - _MOST)) * (share > _MOST)
    )
    points += _cropped_body_cost(camera, figure) * (view.instruction.size in WHOLE)
    off = math.log(head_share(camera, figure) / SIZES[view.instruction.size].head)
    return points + 0.8 * max(0.0, -off - 0.5) * lead + _LOOMING * max(0.0, off - 0.35)


def _bent_back_cost(camera: Orbit, figure: Figure) -> float:
    """Weigh the backside of a bending person: a face that looks down is turned away by as much in front as behind."""
    if figure.forward[2] > _LOOKS_DOWN:
        return 0.0
    around = abs(math.remainder(camera.azimuth - figure.yaw, 360.0))
    return _BACK * max(0.0, around - FROM_BEHIND) / (180.0 - FROM_BEHIND)


def _cropped_body_cost(camera: Orbit, figure: Figure) -> float:
    """Weigh what the frame cuts of a body that should be whole."""
    (_, top), (_, bottom) = project(camera, [figure.crown, figure.base])[0]
    cut = (max(float(bottom) - 1, 0.0) + max(-float(top), 0.0)) / max(float(bottom - top), 1e-3)
    return (0.5 + 2 * cut) * (cut > _CUT)


def _is_beside_insert(view: CameraOperatorView, figure: Figure) -> bool:
    """Return whether a person is so near the thing of an insert that a lap or a sleeve may be in the picture."""
    near = (math.dist((box.x, box.y), figure.base[:2]) < _LAP for box in view.things)
    return view.instruction.kind == "insert" and any(near)
