"""Judges the composition of a take: angle, size, headroom, placement; every fault has the numbers that mend it."""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.layout_artist.camera_details import held_things
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorView, Moment
from storyblender.agents.layout_artist.camera_solids import is_anyone_aboard
from storyblender.agents.layout_artist.camera_start import ignored_partner, requires_shoulder
from storyblender.geometry import framing
from storyblender.geometry.framing import Figure
from storyblender.geometry.gaps import MAX_FACE_GAP, widest_face_gap
from storyblender.geometry.orbit import DOLLY, Orbit
from storyblender.memory.measure import CameraView, SubjectView
from storyblender.memory.shot_sizes import SIZES
from storyblender.reflection import Fault

_STRAY = 0.09
"""Most widths or heights of the picture between a face and its place; the same for a thing."""
_THING_STRAY = 0.14
_LEAST_THING, _LEAST_ASKED = 0.55, 0.8
"""Share of the extent that the shot size gives a thing that it has at least; more where a person asked for the size."""
AT_SIDE = 0.08
"""Share of the width at either side in which no face of a group may be: the frame would cut the body."""
_PAST_OTHERS = 24.0
"""Degrees of elevation up to which an eye-level picture may look at several people, past each other."""


_PAST_SIDES = 30.0
"""Degrees of elevation up to which people in a boat may be seen over its side."""
_LEVEL = 3.0
"""Degrees that the horizon may lean from where the angle wants it."""


def fault(kind: str, subject: str, severity: float, message: str, **fix: float | str) -> Fault:
    """Return a camera fault with its fix.

    Args:
        kind: The critic's word for it, such as ``headroom``.
        subject: node_id that it is about, or name of the shot for a cut; empty for the whole picture.
        severity: Points of ten, rounded to thousandths.
        message: Sentence for the user.
        **fix: ``pan_x`` and ``pan_y`` in heights of the picture, ``dolly`` in steps, ``azimuth``, ``elevation`` and
            ``roll`` in degrees; ``ops``: names of operations to try, separated by spaces.
    """
    return Fault(kind=kind, subject=subject, severity=round(severity, 3), message=message, fix=fix)


def find_composition_faults(view: CameraOperatorView, camera: Orbit, moment: Moment, seen: CameraView) -> list[Fault]:
    """Return the faults of size, headroom, placement and angle.

    Args:
        view: The shot.
        camera: The camera.
        moment: The moment that is judged.
        seen: What the viewfinder measured.
    """
    kind = view.instruction.kind
    found = _roll_faults(view, camera)
    if kind not in ("pov", "establishing"):
        found += _angle_faults(view, camera)
    subjects = {subject.node_id: subject for subject in seen.subjects}
    faces = [(moment.figure(node), subjects[node]) for node in view.focus if node in subjects]
    heads = [(figure, subject) for figure, subject in faces if figure is not None and subject.face is not None]
    if kind == "insert" or (not faces and kind not in ("establishing", "pov")):
        return found + _thing_faults(view, camera, [subjects[node] for node in view.focus if node in subjects])
    if not heads or kind in ("establishing", "pov"):
        return found
    over = subjects.get(view.over.node_id) if view.over is not None else None
    after = ignored_partner(view)
    if over is not None and over.face is not None and after is not None and not requires_shoulder(view):
        # A subject and a partner whom they do not face are framed as a group.
        heads.append((after, over))
        over = None
    if over is None or after is None:
        # A subject who walks away from the shoulder may be small.
        found += _size_faults(view, [subject for _, subject in heads])
    if held_things(view) and over is None:
        return found
    if len(heads) == 1 or over is not None:
        figure, subject = heads[0]
        assert figure is not None and subject.face is not None
        found += _placement_faults(view, camera, figure, subject)
    else:
        xs = [subject.face[0] for _, subject in heads if subject.face is not None]
        off = (min(xs) + max(xs)) / 2 - 0.5
        if abs(off) > _STRAY:
            text = f"the group is {off:+.0%} of the width off the middle"
            found.append(fault("placement", heads[0][1].node_id, 0.8 + abs(off), text, pan_x=off * camera.aspect))
        aside = max(AT_SIDE - min(xs), max(xs) - 1 + AT_SIDE)
        if aside > 0:
            text = "the frame cuts the people at its sides"
            found.append(fault("squeezed", heads[0][1].node_id, 1.0 + 10 * aside, text, dolly=-2.0, ops="zoom_out"))
        found += _gap_faults(view, camera, [subject for _, subject in heads])
    bends = any(figure is not None and view.upright(figure) is not figure for figure, _ in heads)
    # The headroom above a bent person is for their full height.
    return found if bends else found + _headroom_faults(view, [subject for _, subject in heads], over)


def _gap_faults(view: CameraOperatorView, camera: Orbit, heads: Sequence[SubjectView]) -> list[Fault]:
    """Return the fault of people too far apart in a picture that is no wide shot."""
    faces = [(subject.face[0], subject.head_height) for subject in heads if subject.face is not None]
    over = widest_face_gap(faces, camera.aspect) - MAX_FACE_GAP
    if over <= 0 or view.instruction.size in ("WS", "EWS"):
        return []
    text = "the middle between the people is empty"
    return [fault("apart", heads[0].node_id, min(0.5 + 0.3 * over, 2.0), text, ops="orbit_left orbit_right")]


def _thing_faults(view: CameraOperatorView, camera: Orbit, subjects: Sequence[SubjectView]) -> list[Fault]:
    """Return the faults of a focus thing: off the middle, or too small or large for the shot size."""
    boxes = [subject.box for subject in subjects if subject.box is not None]
    if not boxes or not view.things:
        return []
    left, top = min(box[0] for box in boxes), min(box[1] for box in boxes)
    right, bottom = max(box[2] for box in boxes), max(box[3] for box in boxes)
    x, y, node = (left + right) / 2 - 0.5, (top + bottom) / 2 - 0.5, subjects[0].node_id
    found = []
    if max(abs(x), abs(y)) > _THING_STRAY:
        text = f"{node} is off the middle by {x:+.0%} of the width and {y:+.0%} of the height"
        found.append(fault("placement", node, 0.8 + 2 * max(abs(x), abs(y)), text, pan_x=x * camera.aspect, pan_y=-y))
    wanted = SIZES[view.instruction.size].fill
    extent = max(right - left, bottom - top)
    least = _LEAST_ASKED if view.asked.size is not None else _LEAST_THING
    if not least * wanted < extent < min(1.7 * wanted, 0.97):
        steps = math.log(wanted / max(extent, 0.01), DOLLY)
        text = f"{node} fills {extent:.0%} of the picture, {view.instruction.size} wants {wanted:.0%}"
        found.append(fault("size", node, min(0.5 + 0.2 * abs(steps), 3.0), text, dolly=steps))
    return found


def _angle_faults(view: CameraOperatorView, camera: Orbit) -> list[Fault]:
    """Return the fault of an elevation outside the band of the instruction's angle."""
    low, high = framing.ELEVATION_BAND[view.instruction.angle]
    if view.things and not view.people:
        high = max(high, 45.0)
    if view.instruction.angle == "eye-level" and (view.over is not None or len(view.people) > 2):
        high = max(high, _PAST_OTHERS)
    if is_anyone_aboard(view.props.values(), view.people):
        high = max(high, _PAST_SIDES)
    elevation = camera.elevation
    if low <= elevation <= high:
        return []
    by = (low - elevation) if elevation < low else (high - elevation)
    text = f"{elevation:.0f} degrees is not {view.instruction.angle}"
    return [fault("angle", "", min(0.4 + abs(by) / 25, 1.5), text, elevation=by + math.copysign(2, by))]


def _roll_faults(view: CameraOperatorView, camera: Orbit) -> list[Fault]:
    """Return the fault of a horizon that leans, or of a dutch angle that leans too little or too far.

    A camera that a person placed leans as they placed it.
    """
    wanted = math.copysign(framing.DUTCH_ROLL, camera.roll) if view.instruction.angle == "dutch" else 0.0
    off = wanted - camera.roll
    if abs(off) <= (_LEVEL if wanted == 0 else abs(wanted) / 2) or view.asked.placed is not None:
        return []
    text = f"the horizon leans by {camera.roll:.0f} degrees, {view.instruction.angle} wants {wanted:.0f}"
    return [fault("roll", "", min(0.8 + abs(off) / 20, 2.5), text, roll=off)]


def _size_faults(view: CameraOperatorView, heads: Sequence[SubjectView]) -> list[Fault]:
    """Return the fault of heads too small or too large for the shot size."""
    scale = SIZES[view.instruction.size]
    low, high = scale.band
    if len(heads) > 1 or held_things(view):
        low *= 0.5
    largest = max(subject.head_height for subject in heads)
    if low <= largest <= high or largest <= 0:
        return []
    steps = math.log(scale.head / largest, DOLLY)
    text = f"the head fills {largest:.0%} of the height, {view.instruction.size} wants {scale.head:.0%}"
    return [fault("size", heads[0].node_id, min(0.5 + 0.25 * abs(steps), 3.0), text, dolly=steps)]


def _placement_faults(view: CameraOperatorView, camera: Orbit, figure: Figure, subject: SubjectView) -> list[Fault]:
    """Return the fault of a lone face off its place: lead room, or the half beside the shoulder."""
    assert subject.face is not None
    wanted = framing.lead_room_x(camera, figure)
    if view.over is not None:
        wanted = 0.5 + math.copysign(0.13, subject.face[0] - 0.5)
    off = subject.face[0] - wanted
    if abs(off) <= _STRAY:
        return []
    text = f"the face of {subject.node_id} is {off:+.0%} of the width off its place"
    return [fault("placement", subject.node_id, 0.5 + 2 * abs(off), text, pan_x=off * camera.aspect)]


def _headroom_faults(view: CameraOperatorView, heads: Sequence[SubjectView], over: SubjectView | None) -> list[Fault]:
    """Return the fault of a crown too high or too low; the near head of an over-the-shoulder may need more air."""
    tops = [subject.head_top for subject in heads if subject.head_top is not None]
    if not tops or view.instruction.size in ("ECU", "EWS"):
        return []
    crown, top = SIZES[view.instruction.size].crown, min(tops)
    if len(heads) > 1:
        # A group may be taken from further away than its size says, with more air above it.
        crown = max(crown, framing.crown_screen_y(max(subject.head_height for subject in heads)))
    if over is not None and over.head_top is not None and over.head_top < top:
        top = max(over.head_top, min(crown, top))
    low = -0.04 if view.instruction.size == "CU" else 0.01
    high = crown + (0.24 if len(heads) > 1 or view.instruction.size == "WS" else 0.14)
    if low <= top <= high:
        return []
    off = crown - top
    text = f"headroom is {top:.0%} of the height"
    return [fault("headroom", heads[0].node_id, 0.5 + 2 * abs(off), text, pan_y=off)]
