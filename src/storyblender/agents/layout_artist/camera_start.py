"""The first camera of a shot: computed from faces, the 180-degree line and the instruction, before any rendering."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from storyblender.agents.layout_artist.camera_details import held_things
from storyblender.agents.layout_artist.camera_group import (
    azimuth_towards_audience,
    frame_moving_group,
    group_azimuth,
    keep_group_in_room,
    wrap_degrees,
)
from storyblender.agents.layout_artist.camera_operator_view import (
    TALKS,
    TRAVEL,
    CameraOperatorDraft,
    CameraOperatorView,
    time_share,
)
from storyblender.agents.layout_artist.camera_pov import frame_pov
from storyblender.agents.layout_artist.camera_room import fit_lens_to_room, move_into_room
from storyblender.agents.layout_artist.vehicle_panels import hidden_panels
from storyblender.agents.layout_artist.wild_walls import find_hidden_nodes
from storyblender.geometry import framing
from storyblender.geometry.boxes import corners, distance_to_point
from storyblender.geometry.camera_path import orbit_of
from storyblender.geometry.continuity import JUMP_CUT_DEGREES, mirror_azimuth, side_of_line
from storyblender.geometry.framing import Figure, Film
from storyblender.geometry.moves import ease_in_out, follow_subject, interpolate_cameras, move_camera
from storyblender.geometry.orbit import Orbit, camera_looking_at, camera_turned, orbit, pan, roll
from storyblender.geometry.over_shoulder import frame_over_shoulder, lens_over_shoulder
from storyblender.memory.camera_decision import CameraPosition, FreeCamera
from storyblender.memory.shot_sizes import SIZES, TIGHT, WHOLE

_OFF_BACK = 30.0
"""Most degrees from straight behind, for a back that the script asks for."""
_MASTER_ELEVATION, _INSERT_ELEVATION = 5.0, 30.0
"""Degrees of elevation of establishing shots and of inserts, at least."""
_MASTER_AZIMUTH = 14.0
_SHORTEST = 0.22
"""Least height of the tallest person of an extreme wide establishing shot, as a share of the picture."""
_SHORT, _TALL = 0.26, 0.4
"""Least and largest such height for other establishing shots."""
_HELD = 0.8
"""Share of the picture that holds all people, where they are too far apart to be as large as ``_SHORT``."""
_LARGE = 1.2
"""Metres of extent from which a thing counts as large in an insert."""
_NEAR_THING = 3.5
"""Most metres from the camera to the thing of an insert that a person asked for, unless they chose the lens."""
_COMPANY = 6.0
"""Metres from a large thing within which people belong in a wide picture of it."""
_SQUATS = 0.5
"""Metres that a face is below its upright height when a picture that cuts the body would lose it."""
_SHOULDER_TURN, _LEAVING_TURN = 45.0, 20.0
"""Degrees of turn from which an over-the-shoulder becomes a two-shot; sooner if one of the two walks away."""
_HELD_SPAN, _FARTHER, _RIM = 0.86, 1.3, 0.05
"""Largest share of the picture for faces and held things; largest factor on the camera distance for that,
applied twice; margin that stays free at the edge.
"""
_AHEAD = 3.0
"""Metres to the pivot of a camera that a person placed with a rotation."""
_FITTINGS = 4
"""Most lenses tried: a wider lens changes the composition, and so the room that it needs."""


def compose_take(view: CameraOperatorView, turn: float = 0.0, rise: float = 0.0) -> CameraOperatorDraft:
    """Return the analytic take of a shot, inside the room if the set has one.

    Args:
        view: The shot.
        turn: Degrees around the pivot from the preferred azimuth; the picture is composed again there.
        rise: Degrees above the preferred elevation.
    """
    camera = _compose_camera(view, view.lens, turn, rise)
    kind = view.instruction.kind
    from_above = view.asked.angle == "bird's-eye"
    if view.over is None and kind != "pov":
        if kind not in ("establishing", "insert") and len(view.people) > 1:
            camera = keep_group_in_room(view, camera)
        else:
            widest = "WS" if kind == "insert" or not view.people else view.instruction.size
            # A lens in the instruction is kept: then only the camera moves.
            for _ in range(0 if view.instruction.lens or from_above else _FITTINGS):
                lens = view.widened(fit_lens_to_room(view.plan, camera, widest).lens)
                if lens == camera.lens:
                    break
                camera = _compose_camera(view, lens, turn, rise)
        if (kind == "establishing" or not view.people) and not from_above:
            camera = move_into_room(view.plan, camera)
    if kind != "insert" and held_things(view) and view.over is None and kind not in ("pov", "establishing"):
        camera = _include_held_things(view, camera)
    if view.instruction.angle == "dutch":
        camera = roll(camera, framing.DUTCH_ROLL)
    return take_with_camera(view, camera)


def take_with_camera(view: CameraOperatorView, camera: Orbit) -> CameraOperatorDraft:
    """Return the take around a composition: its camera move, centred on it, and the wild walls it needs.

    Args:
        view: The shot; its instruction names the move.
        camera: As composed for the story moment.
    """
    instruction = view.instruction
    first = last = camera
    span, still = (0.0, 1.0), _holds_all_walks(view)
    if not still and _follows_walk(view, camera):  # composed for the story moment; around it the camera follows
        span, done, travel = *_walk_span(view), np.asarray(view.travel)
        first = follow_subject(camera, instruction.movement, tuple(-done * travel))
        last = follow_subject(camera, instruction.movement, tuple((1 - done) * travel))
    elif not still and instruction.movement != "static":
        direction = instruction.direction
        first, last = (move_camera(camera, instruction.movement, direction, share) for share in (-0.5, 0.5))
    hidden = nodes_in_the_way(view, (first, camera, last))
    if instruction.kind == "pov" and instruction.pov_id is not None:
        hidden.append(view.node(instruction.pov_id))
    return CameraOperatorDraft(camera, first, last, tuple(hidden), span)


def placed_take(view: CameraOperatorView, placed: FreeCamera) -> CameraOperatorDraft:
    """Return the take of a camera that a person placed, with the wild walls it needs.

    Args:
        view: The shot; its instruction may give the lens.
        placed: Where the camera stands, and where it ends if it travels.
    """
    lens = view.instruction.lens or SIZES[view.instruction.size].lens
    first, last = (_placed_camera(end, lens, view.film) for end in (placed.start, placed.end or placed.start))
    middle = interpolate_cameras(first, last, 0.5)
    return CameraOperatorDraft(middle, first, last, tuple(nodes_in_the_way(view, (first, middle, last))))


def nodes_in_the_way(view: CameraOperatorView, cameras: Sequence[Orbit]) -> list[str]:
    """Return the node_ids of walls, things and panels of vehicles between cameras and what has to be visible.

    Args:
        view: The shot.
        cameras: From the start to the end of its move.
    """
    targets, hidden = _sight_targets(view), list[str]()
    if view.plan is not None:
        hidden = find_hidden_nodes(view.plan, view.removable_props, dict.fromkeys(cameras), targets)
    return [*hidden, *hidden_panels(view, cameras, targets)]


def _placed_camera(place: CameraPosition, lens: float, film: Film) -> Orbit:
    """Return a camera where a person placed it, with a lens in mm."""
    size = {"sensor_width": film.sensor_width, "aspect": film.aspect}
    if place.rotation is not None:
        return camera_turned(place.location, place.rotation, lens, _AHEAD, **size)
    assert place.target is not None, "it has one or the other"
    return camera_looking_at(place.location, place.target, lens, roll=place.roll, **size)


def _sight_targets(view: CameraOperatorView) -> list[np.ndarray]:
    """Return (3,) world points that have to be visible at any time: faces and middles of focus things."""
    faces = [
        np.asarray(figure.face)
        for moment in view.moments
        for node in (*view.focus, *view.in_frame)
        if (figure := moment.figure(node)) is not None
    ]
    return faces + [np.array([box.x, box.y, box.z + box.height / 2]) for box in view.things]


def _holds_all_walks(view: CameraOperatorView) -> bool:
    """Return whether the picture holds a group and its walks, so that the camera need not move unless a person asks."""
    still, count = view.asked.movement in (None, "static"), len(view.people)
    return still and 1 < count < len(view.people_over_time)


def _follows_walk(view: CameraOperatorView, camera: Orbit) -> bool:
    """Return whether the camera follows the walker: by instruction, or because the walk would leave the picture."""
    if not view.walks or view.instruction.kind in ("establishing", "pov", "insert"):
        return False
    if view.instruction.movement in ("pan", "track"):
        return True
    if view.instruction.movement != "static" or view.asked.movement is not None:
        return False
    faces = [figure.face for moment in view.moments if (figure := moment.figure(view.walker_id)) is not None]
    screen, depth = framing.project(camera, faces)
    return bool(screen[:, 0].min() < 0.1 or screen[:, 0].max() > 0.9 or depth.min() < 0.5)


def _walk_span(view: CameraOperatorView) -> tuple[tuple[float, float], float]:
    """Return the shares of the shot's time between which the camera follows the walk, and the share walked when drawn.

    The camera stays where the walker stands still before or after the story moment.
    """
    first, drawn, last = (
        moment.figure(view.walker_id) for moment in (view.moments[0], view.story_moment, view.moments[-1])
    )
    share = time_share(view, view.story_moment.frame)
    if first is not None and drawn is not None and last is not None:
        if math.dist(drawn.base[:2], last.base[:2]) < TRAVEL / 2:
            return (0.0, share), 1.0
        if math.dist(drawn.base[:2], first.base[:2]) < TRAVEL / 2:
            return (share, 1.0), 0.0
    return (0.0, 1.0), ease_in_out(share)


def _compose_camera(view: CameraOperatorView, lens: float, turn: float, rise: float) -> Orbit:
    """Return the camera of the story moment for a lens in mm; ``turn`` and ``rise`` in degrees as in `compose_take`."""
    instruction, film, people = view.instruction, view.film, view.people
    elevation = framing.elevation_of(instruction.angle, instruction.size) + rise
    if instruction.kind == "pov" and (pov := frame_pov(view, lens)) is not None:
        return pov
    if instruction.kind == "establishing" or not (people or view.things):
        up = max(elevation, _MASTER_ELEVATION)
        fill = 0.6 if instruction.size == "EWS" else 0.8
        camera = framing.frame_master(film, view.bounds(), _MASTER_AZIMUTH + turn, up, lens, fill)
        return _limit_people_height(view, camera)
    lead = people[0] if people else None
    if lead is None and instruction.size in WHOLE and instruction.kind != "insert" and _has_people_near_things(view):
        azimuth = azimuth_towards_audience(math.degrees(view.things[0].yaw), 50.0) + _MASTER_AZIMUTH + turn
        camera = framing.frame_master(film, view.bounds(), azimuth, max(elevation, _MASTER_ELEVATION), lens, _HELD)
        return _limit_people_height(view, camera)
    if lead is None or (view.things and instruction.kind == "insert"):
        return _frame_things(view, lens, turn, rise)
    if (over := view.over) is not None:
        side = line_side(view, lead, over)
        kit = (lens,) if instruction.lens else view.kit
        lens = lens_over_shoulder(film, lead, over, instruction.size, lens, kit) or lens
        camera = frame_over_shoulder(film, lead, over, instruction.size, side, elevation - 2, lens)
        if abs(turn) > (_LEAVING_TURN if view.in_stride and ignored_partner(view) is not None else _SHOULDER_TURN):
            return framing.frame_group(film, (lead, over), instruction.size, camera.azimuth + turn, elevation, lens)
        return orbit(camera, turn) if turn else camera
    if len(people) > 1:
        around = turn + (180.0 if instruction.behind else 0.0)
        return frame_moving_group(view, lens, group_azimuth(view) + around, elevation)
    tight = instruction.size in TIGHT
    if view.in_stride and not tight:
        return _frame_walk(view, lead, lens, turn, elevation)
    azimuth = _single_azimuth(view, lead) + turn
    shown = lead if tight else view.upright(lead)
    if instruction.size not in WHOLE and shown.face[2] - lead.face[2] > _SQUATS:
        shown = lead
    return framing.frame_single(film, shown, instruction.size, azimuth, elevation, lens)


def _include_held_things(view: CameraOperatorView, camera: Orbit) -> Orbit:
    """Return the camera panned and moved back a little, so that things in people's hands are in the picture."""
    things = np.concatenate([corners(box) for box in held_things(view)])
    heads = [point for each in view.people for point in (each.crown, each.face)]
    points = np.concatenate([np.asarray(heads, float), things])
    for _ in range(2):
        screen, depth = framing.project(camera, points)
        if depth.min() < 0.2:
            return camera
        span = float(np.ptp(screen, axis=0).max())
        if span > _HELD_SPAN:
            camera = replace(camera, distance=camera.distance * min(span / _HELD_SPAN, _FARTHER))
            screen, _ = framing.project(camera, points)
        low, high = screen.min(0), screen.max(0)
        over = np.maximum(high - (1 - _RIM), 0.0) - np.maximum(_RIM - low, 0.0)
        camera = pan(camera, float(over[0]) * camera.aspect, -float(over[1]))
    return camera


def ignored_partner(view: CameraOperatorView) -> Figure | None:
    """Return the over-the-shoulder partner if the subject does not look at them, so that the partner sees a back."""
    over = view.over
    return over if over is not None and view.people[0].turned_from(over.face) >= TALKS else None


def requires_shoulder(view: CameraOperatorView) -> bool:
    """Return whether the partner's shoulder must be in the picture, rather than a view of both from the side."""
    return view.over is not None and (ignored_partner(view) is None or view.in_stride or bool(view.asked.over_id))


def max_face_angle(view: CameraOperatorView) -> float:
    """Return the degrees by which a focus face may be turned away from the camera: more on a walk and from behind."""
    if view.instruction.behind:
        return 180.0
    if view.in_stride:
        return 150.0 if ignored_partner(view) is None else 180.0
    if view.over is not None and view.instruction.explicit:
        return framing.FACE_ANGLE["two_shot"]
    return framing.FACE_ANGLE.get(view.instruction.kind, 108.0)


def _limit_people_height(view: CameraOperatorView, camera: Orbit) -> Orbit:
    """Move a master camera so that its nearest person is large enough to be recognised, but not too large."""
    shown = {*view.focus, *view.in_frame}
    people = [figure for figure in view.story_moment.figures if figure.node_id in shown]
    if not people:
        return camera
    tall = max(figure.crown[2] - figure.base[2] for figure in people)
    _, depth = framing.project(camera, [figure.face for figure in people])
    size, nearest = view.instruction.size, float(depth.min())
    least, most = (
        framing.distance_for(tall, share, camera.tangent) for share in (_TALL, _SHORTEST if size == "EWS" else _SHORT)
    )
    if nearest < least:
        return replace(camera, distance=camera.distance + least - nearest)
    if nearest <= most:
        return camera
    points = [point for figure in people for point in (figure.base, figure.crown)]
    held = framing.frame_master(view.film, points, camera.azimuth, camera.elevation, camera.lens, _HELD)
    if held.distance >= most:
        return held
    middle = np.mean([(*figure.face[:2], (figure.face[2] + figure.base[2]) / 2) for figure in people], axis=0)
    near = view.film.look(middle, camera.azimuth, camera.elevation, max(most, 2.0), camera.lens)
    return framing.place_on_screen(near, middle, 0.5, 0.6)


def _has_people_near_things(view: CameraOperatorView) -> bool:
    """Return whether people are near the focus things, so that one picture holds them all."""
    people = [figure for figure in view.story_moment.figures if figure.node_id in view.in_frame]
    near = (distance_to_point(box, *figure.base[:2]) < _COMPANY for figure in people for box in view.things)
    return bool(people) and any(near)


def _frame_things(view: CameraOperatorView, lens: float, turn: float, rise: float) -> Orbit:
    """Frame things: from above if they lie on a table, level if they hang or are high; from the front."""
    points = np.concatenate([corners(box) for box in view.things])
    box = view.things[0]
    high = points[:, 2].mean() > 1.25 or box.height > 1.2
    angle = framing.ELEVATION[view.instruction.angle]
    elevation = (max(angle, 4.0) if high else max(angle, _INSERT_ELEVATION)) + rise
    azimuth = azimuth_towards_audience(math.degrees(box.yaw), 50.0) + 12.0 + turn
    extent = float(np.ptp(points, axis=0).max())
    wide = SIZES[view.instruction.size].fill_large if extent >= _LARGE else None
    fill = wide or SIZES[view.instruction.size].fill
    camera = framing.frame_insert(view.film, points, azimuth, elevation, lens, fill)
    if view.asked.kind == "insert" and view.instruction.lens is None and camera.distance > _NEAR_THING:
        lens = view.widened(lens * _NEAR_THING / camera.distance)
    return framing.frame_insert(view.film, points, azimuth, elevation, lens, fill)


def _frame_walk(view: CameraOperatorView, figure: Figure, lens: float, turn: float, elevation: float) -> Orbit:
    """Frame a walk from the side and a little ahead, on the audience's side."""
    heading = math.degrees(math.atan2(view.travel[0], -view.travel[1]))
    sides = [heading + 62.0, heading - 62.0]
    azimuth = min(sides, key=lambda angle: abs(wrap_degrees(angle))) + turn
    return framing.frame_single(view.film, figure, view.instruction.size, azimuth, elevation, lens)


def _single_azimuth(view: CameraOperatorView, figure: Figure) -> float:
    """Return the azimuth in degrees for one person: mirrors the reverse shot, else keeps the line and does not jump."""
    if view.instruction.behind:
        return azimuth_towards_audience(figure.yaw + 180.0, _OFF_BACK)
    if (matched := _reverse_azimuth(view, figure)) is not None:
        return matched
    size = view.instruction.size
    off = SIZES[size].off_face
    choices = [figure.yaw + off, figure.yaw - off]
    if view.instruction.kind == "action" and size in (*WHOLE, "MWS"):
        choices.insert(0, azimuth_towards_audience(figure.yaw, 55.0))
    choices += [figure.yaw, figure.yaw + 65.0, figure.yaw - 65.0]
    return min(choices, key=lambda angle: (_azimuth_cost(view, figure, angle), choices.index(angle)))


def _azimuth_cost(view: CameraOperatorView, figure: Figure, azimuth: float) -> float:
    """Weigh an azimuth: across the line 4, a jump cut 2, away from the audience up to 1, a flat full face 0.4."""
    cost = abs(wrap_degrees(azimuth)) / 180
    way = np.array([math.sin(math.radians(azimuth)), -math.cos(math.radians(azimuth))])
    if (axis := view.axis) is not None and view.side:
        position = np.asarray(figure.face)[:2] + 2 * way
        cost += 4.0 * (side_of_line(position, axis[0].face, axis[1].face) == -view.side)
    if (before := view.previous) is not None and view.size_steps(before.instruction.size) < 2:
        same = set(before.instruction.focus_on_ids) == set(view.instruction.focus_on_ids)
        last = orbit_of(before.state.poses[-1], view.film)
        cost += 2.0 * (same and abs(wrap_degrees(last.azimuth - azimuth)) < JUMP_CUT_DEGREES)
    return cost + 0.4 * (abs(wrap_degrees(azimuth - figure.yaw)) < 15)


def _reverse_azimuth(view: CameraOperatorView, figure: Figure) -> float | None:
    """Return the azimuth that mirrors the partner's single, if this shot is its reverse; else None."""
    if view.reverse is None or view.axis is None or view.instruction.kind not in ("single", "reaction", "ots"):
        return None
    first, second = view.axis
    if figure.node_id not in (first.node_id, second.node_id):
        return None
    partner = orbit_of(view.reverse.state.poses[0], view.film)
    azimuth = mirror_azimuth(partner.azimuth, first.face, second.face)
    return azimuth if abs(wrap_degrees(azimuth - figure.yaw)) < 75 else None


def line_side(view: CameraOperatorView, focus: Figure, over: Figure) -> float:
    """Return the side of the line between two people on which the camera stays: the scene's, else the audience's.

    Args:
        view: The shot, with the side that the scene has used so far.
        focus: The subject.
        over: The partner, at the start of the line.

    Returns:
        1.0 for the left of the line from ``over`` to ``focus`` as seen from above, -1.0 for its right.
    """
    if (axis := view.axis) is not None and view.side:
        return view.side if over.node_id == axis[0].node_id else -view.side
    ahead = np.subtract(focus.face, over.face)
    return 1.0 if ahead[0] < 0 else -1.0
