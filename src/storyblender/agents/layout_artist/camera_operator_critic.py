"""Judges a take by what the viewfinder measures: visibility, size, composition, cuts; each fault with its fix.

Fixes are numbers where the geometry gives them (``pan_x`` and ``pan_y`` in heights of the picture, ``dolly`` in steps,
``azimuth``, ``elevation`` and ``roll`` in degrees), else names of the paper's operations (``ops``) to be tried.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from storyblender.agents.layout_artist.camera_composition import fault, find_composition_faults
from storyblender.agents.layout_artist.camera_cuts import find_cut_faults
from storyblender.agents.layout_artist.camera_operator_view import (
    CameraOperatorDraft,
    CameraOperatorView,
    Moment,
    pose_of,
    time_share,
)
from storyblender.agents.layout_artist.camera_room import share_outside, void_points
from storyblender.agents.layout_artist.camera_scout import AT_EDGE, CLEARED, FROM_BEHIND, LEAST_OVER
from storyblender.agents.layout_artist.camera_start import max_face_angle, requires_shoulder
from storyblender.geometry.boxes import corners
from storyblender.geometry.framing import project
from storyblender.geometry.orbit import Orbit
from storyblender.memory.measure import CameraView, SubjectView
from storyblender.memory.shot_sizes import TIGHT, WHOLE
from storyblender.ports import Viewfinder, ViewRequest
from storyblender.reflection import Critique, Fault

_HIDDEN = 0.30
_SEEN = 0.0004
"""Share of the picture from which a person counts as seen."""
_FACE_SHOWN = 0.60
_FOREGROUND = 0.22
_FOREGROUND_OTS = 0.38
_LEFT_OUT = 1.2
"""Most points for a thing that a picture of people does not show."""
_LEAST_DETAIL = 0.02
"""Least share of the picture that the person of an insert's hand or feet fills."""
_BLOCKS = 14.0
"""Points for the whole picture being a body without a head in it."""
_EYE_LINE = 0.4
"""Screen y to which a face is panned."""
_NEAREST = 0.3
"""Metres before the camera from which a subject can be panned to."""
_PASSING = 0.5
"""Factor on the weight of faults outside the story moment, which the board does not show."""
_ARMS = 0.5
"""Metres between the faces of two people who embrace."""
_AROUND = "orbit_left orbit_right"


class CameraOperatorCritic:
    """The Camera Operator's critic. It remembers its looks, so that judging a take again costs nothing.

    Args:
        viewfinder: The engine's viewfinder.
    """

    def __init__(self, viewfinder: Viewfinder) -> None:
        self._viewfinder = viewfinder
        self._seen: dict[tuple[int, int, int, CameraOperatorDraft], CameraView] = {}

    def judge(self, draft: CameraOperatorDraft, view: CameraOperatorView) -> Critique:
        """Score one take.

        Args:
            draft: The take.
            view: Its shot.
        """
        return self.judge_all([draft], view)[0]

    @property
    def looks(self) -> int:
        """Number of looks so far."""
        return len(self._seen)

    def judged(self, view: CameraOperatorView) -> set[CameraOperatorDraft]:
        """Return the takes of a shot that were looked at."""
        return {take for scene, shot, _, take in self._seen if (scene, shot) == (view.scene_id, view.shot_id)}

    def judge_all(self, takes: Sequence[CameraOperatorDraft], view: CameraOperatorView) -> list[Critique]:
        """Return the critiques of several takes of a shot, with one batch of looks.

        Args:
            takes: In any order; those looked at before cost nothing.
            view: Their shot.

        Returns:
            One critique for each take, in the same order.
        """
        moments = moments_to_judge(view, takes)
        wanted = [(take, moment) for take in takes for moment in moments]
        fresh = [pair for pair in dict.fromkeys((take, moment.frame) for take, moment in wanted)
                 if self._key(view, *pair) not in self._seen]  # fmt: skip
        fresh.sort(key=lambda pair: pair[1])
        views = self._viewfinder.look([view_request(view, take, frame) for take, frame in fresh])
        for (take, frame), seen in zip(fresh, views, strict=True):
            self._seen[self._key(view, take, frame)] = seen
        return [
            Critique.of(_find_faults(view, take, [(m, self._seen[self._key(view, take, m.frame)]) for m in moments]))
            for take in takes
        ]

    def seen(self, take: CameraOperatorDraft, view: CameraOperatorView) -> CameraView:
        """Return how a judged take looks at the story moment.

        Args:
            take: One that was judged.
            view: Its shot.
        """
        return self._seen[self._key(view, take, view.story_moment.frame)]

    @staticmethod
    def _key(
        view: CameraOperatorView, take: CameraOperatorDraft, frame: int
    ) -> tuple[int, int, int, CameraOperatorDraft]:
        return view.scene_id, view.shot_id, frame, take


def moments_to_judge(view: CameraOperatorView, takes: Sequence[CameraOperatorDraft]) -> list[Moment]:
    """Return the story moment; all moments of the shot if the subject walks or a take's camera moves.

    Args:
        view: The shot.
        takes: Takes to judge.
    """
    if view.walks or any(take.moves for take in takes):
        return list(view.moments)
    return [view.story_moment]


def view_request(view: CameraOperatorView, take: CameraOperatorDraft, frame: int) -> ViewRequest:
    """Return the look at a take.

    Args:
        view: The shot.
        take: The take.
        frame: Counted from the shot's start.
    """
    return ViewRequest(
        scene_id=view.scene_id,
        shot_id=view.shot_id,
        frame=frame,
        pose=pose_of(take.at(time_share(view, frame)), frame),
        sensor_width=view.film.sensor_width,
        hidden_node_ids=take.hidden,
        focus_ids=view.focus or view.named,
    )


def _find_faults(
    view: CameraOperatorView, take: CameraOperatorDraft, looks: Sequence[tuple[Moment, CameraView]]
) -> tuple[Fault, ...]:
    """Return a take's faults: composition at the story moment, visibility at all moments, and cuts."""
    told: list[Fault] = []
    main = view.story_moment
    for moment, seen in sorted(looks, key=lambda pair: pair[0] is not main):
        camera = take.at(time_share(view, moment.frame))
        found = _visibility_faults(view, camera, moment, seen)
        if moment is not main:
            found = [
                each.model_copy(update={"severity": _PASSING * each.severity})
                for each in found
                if each.kind != "face_away"
            ]
        found += [*_camera_place_faults(seen), *_void_faults(_void_share(view, take, camera, seen))]
        if moment is main:
            found += [*find_composition_faults(view, camera, moment, seen), *_surrounding_faults(view, seen)]
        known = {(fault.kind, fault.subject) for fault in told}
        told += [fault for fault in found if (fault.kind, fault.subject) not in known]
    told += find_cut_faults(view, take)
    for node in view.strangers:
        if node in take.hidden:
            told.append(fault("cleared", node, CLEARED, f"{node} stands aside for this picture"))
    return tuple(told)


def _visibility_faults(view: CameraOperatorView, camera: Orbit, moment: Moment, seen: CameraView) -> list[Fault]:
    """Return the faults of what is visible at a moment: focus, faces, and other people who belong in the picture."""
    found: list[Fault] = _detail_faults(view, seen)
    faces: dict[str, list[Fault]] = {}
    kind, size = view.instruction.kind, view.instruction.size
    subjects = {subject.node_id: subject for subject in seen.subjects}
    for node in view.focus:
        subject = subjects.get(node)
        if subject is None:
            continue
        is_person = moment.figure(node) is not None
        shows_face = subject.face is not None and all(0 < value < 1 for value in subject.face)
        if subject.in_frame_fraction < 0.02 and not shows_face:
            text = f"{node} is not in the picture"
            weight = 5.0 if is_person or not view.people else _LEFT_OUT
            found.append(fault("out_of_frame", node, weight, text, **_way_back(view, camera, moment, node, -4.0)))
            continue
        hidden = 1 - subject.visible_fraction / max(subject.in_frame_fraction, 1e-6)
        if hidden > _HIDDEN and subject.in_frame_fraction >= 0.02:
            text = f"{node} is {hidden:.0%} hidden"
            weight = 1 + 4 * (hidden - _HIDDEN)
            weight = weight if is_person or not view.people else min(weight, _LEFT_OUT)
            found.append(fault("hidden", node, weight, text, ops=f"{_AROUND} orbit_up"))
        whole = size in WHOLE if is_person else kind == "insert"
        if whole and kind != "establishing" and subject.in_frame_fraction < 0.96:
            cut = 1 - subject.in_frame_fraction
            found.append(fault("cropped", node, 0.5 + 2 * cut, f"{node} is cut off", ops="zoom_out pan_down pan_up"))
        if is_person and kind != "establishing":
            faces[node] = _face_faults(view, camera, moment, subject)
    for node, faults in faces.items():
        # In an embrace one visible face is enough.
        held = [other for other in faces if other != node and _is_embrace(moment, node, other)]
        found += [] if any(not faces[other] for other in held) else faults
    over_node = view.node(view.instruction.over_id or "")
    for node in () if size in TIGHT else view.in_frame:
        other = subjects.get(node)
        if other is not None and other.visible_fraction < 0.05 and node not in (*view.focus, over_node):
            found.append(fault("missing", node, 1.0, f"{node} belongs in the picture", ops=f"zoom_out {_AROUND}"))
    if view.over is not None and (over := subjects.get(view.over.node_id)) is not None:
        found += _shoulder_faults(view, over)
    return found


def _detail_faults(view: CameraOperatorView, seen: CameraView) -> list[Fault]:
    """Return the fault of an insert of a hand or of feet that something hides: little of their person is seen."""
    if view.detail is None or not view.named:
        return []
    node = view.named[0]
    pixels = sum(subject.pixels for subject in seen.subjects if subject.node_id == node)
    if pixels >= _LEAST_DETAIL:
        return []
    text = f"the part of {node} that the insert is about is hidden"
    return [fault("hidden", node, 4.0, text, ops=f"{_AROUND} orbit_up orbit_down")]


def _way_back(
    view: CameraOperatorView, camera: Orbit, moment: Moment, node: str, steps: float | None = None
) -> dict[str, float | str]:
    """Return the fix that brings a subject into the picture: panned by numbers if it is the only one.

    Args:
        view: The shot.
        camera: The camera at the moment.
        moment: Everybody's place.
        node: node_id of the person or thing.
        steps: Steps of the dolly where other subjects must stay in the picture.
    """
    figure, box = moment.figure(node), view.props.get(node)
    place = figure.face if figure is not None else corners(box).mean(0) if box is not None else None
    others = [each for each in view.focus if each != node and moment.figure(each) is not None]
    if place is not None and not others:
        screen, depth = project(camera, [place])
        if depth[0] > _NEAREST:
            (x, y), nearness = screen[0], float(depth[0]) / camera.distance
            up = _EYE_LINE if figure is not None else 0.5
            return {"pan_x": float(x - 0.5) * camera.aspect * nearness, "pan_y": float(up - y) * nearness}
    return {"ops": "zoom_out"} if steps is None else {"ops": "zoom_out", "dolly": steps}


def _shoulder_faults(view: CameraOperatorView, over: SubjectView) -> list[Fault]:
    """Return the faults of an over-the-shoulder partner: in front of the subject, at the side, with a head."""
    aside = over.face is not None and abs(over.face[0] - 0.5) > AT_EDGE
    far = requires_shoulder(view) and over.head_height < LEAST_OVER
    front = view.asked.over_id is not None and over.face_angle < FROM_BEHIND
    if over.pixels < 0.02 or aside or far or front:
        return [fault("no_shoulder", over.node_id, 1.5, "the shoulder is not in the picture", ops=_AROUND)]
    if over.face is None or over.face[1] < 0:
        text = f"the frame takes the head off {over.node_id}"
        return [fault("beheaded", over.node_id, 1.5, text, ops="orbit_up pan_up")]
    return []


def _is_embrace(moment: Moment, one: str, other: str) -> bool:
    """Return whether the faces of two people (node_ids) are as close as in an embrace."""
    first, second = moment.figure(one), moment.figure(other)
    return first is not None and second is not None and math.dist(first.face, second.face) < _ARMS


def _face_faults(view: CameraOperatorView, camera: Orbit, moment: Moment, subject: SubjectView) -> list[Fault]:
    """Return the faults of a focus face: out of the picture, turned away or hidden."""
    node = subject.node_id
    limit = max_face_angle(view)
    if subject.face is None or not (0.02 < subject.face[0] < 0.98 and -0.02 < subject.face[1] < 0.98):
        text = f"the face of {node} is out of the picture"
        return [fault("face_out", node, 4.0, text, **_way_back(view, camera, moment, node))]
    found: list[Fault] = []
    if subject.face_angle > limit:
        over = (subject.face_angle - limit) / 45
        text = f"the face of {node} is turned {subject.face_angle:.0f} degrees away"
        found.append(fault("face_away", node, min(0.6 + 1.5 * over, 2.5), text, ops=_AROUND))
    elif subject.face_visible < _FACE_SHOWN and subject.face_angle < 100 and view.instruction.size != "ECU":
        short = _FACE_SHOWN - subject.face_visible
        ops = f"{_AROUND} orbit_up"
        found.append(fault("face_hidden", node, 1 + 3 * short, f"the face of {node} is hidden", ops=ops))
    return found


def _camera_place_faults(seen: CameraView) -> list[Fault]:
    """Return the faults of a camera inside a thing or below the floor."""
    found = [
        fault("inside", node, 5.0, f"the camera is in {node}", ops="zoom_in zoom_out orbit_left orbit_right")
        for node in seen.inside
    ]
    if seen.below_floor:
        found.append(fault("below_floor", "", 5.0, "the camera is below the floor", ops="orbit_up"))
    return found


def _void_share(view: CameraOperatorView, take: CameraOperatorDraft, camera: Orbit, seen: CameraView) -> float:
    """Return the share of the picture that is empty or beyond the walls of the room."""
    return seen.void if view.plan is None else max(seen.void, share_outside(view.plan, camera, take.hidden))


def _void_faults(share: float) -> list[Fault]:
    if not (points := void_points(share)):
        return []
    text = f"{share:.0%} of the picture shows nothing"
    return [fault("void", "", points, text, ops="orbit_left orbit_right orbit_down zoom_in")]


def _surrounding_faults(view: CameraOperatorView, seen: CameraView) -> list[Fault]:
    """Return the faults of an empty picture, of things in the foreground, and of people besides the focus."""
    found: list[Fault] = []
    kind = view.instruction.kind
    allowed = _FOREGROUND_OTS if view.over is not None else _FOREGROUND
    # An establishing shot without subjects may have anything in its foreground.
    if seen.foreground > allowed and kind != "pov" and view.named:
        text = f"{seen.foreground:.0%} of the picture is in front of the subject"
        ops = "zoom_in zoom_out orbit_left orbit_right orbit_up"
        found.append(fault("foreground", "", 0.5 + 4 * (seen.foreground - allowed), text, ops=ops))
    own = {*(view.focus or view.named), *((view.over.node_id,) if view.over is not None else ())}
    covered = sum(subject.pixels for subject in seen.subjects if subject.node_id in own)
    if own and covered < 0.003 and kind not in ("establishing", "pov") and view.instruction.size != "EWS":
        found.append(fault("empty", "", 3.0, "there is nothing to look at", ops="zoom_in"))
    if kind == "establishing" and seen.subjects and max(subject.visible_fraction for subject in seen.subjects) < 0.3:
        found.append(fault("empty", "", 3.0, "nobody of the scene is seen", ops=f"{_AROUND} orbit_up zoom_in"))
    if kind != "pov":
        main = set() if kind == "establishing" else own
        found += _bystander_faults(view, seen, main)
    return found


def _bystander_faults(view: CameraOperatorView, seen: CameraView, own: set[str]) -> list[Fault]:
    """Return the faults of people besides the focus (``own``): cut by the frame, or with no part in the shot."""
    found: list[Fault] = []
    largest = max((subject.pixels for subject in seen.subjects if subject.node_id in own), default=0.0)
    for subject in seen.subjects:
        if subject.node_id in own or subject.box is None or subject.pixels < _SEEN:
            continue
        steals = subject.pixels > max(1.2 * largest, 0.1)
        if subject.node_id in view.strangers and (steals or view.instruction.size not in WHOLE):
            text = f"{subject.node_id} {'steals the picture' if steals else 'has no part in the picture'}"
            found.append(fault("stranger", subject.node_id, 1.0, text, ops=f"{_AROUND} zoom_in"))
        if subject.face is None or subject.pixels < 0.004 or view.instruction.kind == "insert":
            continue
        top = _top_to_show(view, subject)
        if subject.pixels > 0.012 and (top < 0 or subject.face[1] > 1):
            text = f"the frame takes the head off {subject.node_id}"
            ops = f"{_AROUND} zoom_in zoom_out"
            weight = min(1.0 + _BLOCKS * max(0.0, subject.pixels - 0.04), 3.0)
            found.append(fault("beheaded", subject.node_id, weight, text, pan_y=max(0.04 - top, 0.0), ops=ops))
        left, _, right, _ = subject.box
        if (left < 0.004) != (right > 0.996) or (left < 0.004 and right > 0.996):
            x = right if left < 0.004 else 1 - left
            away = x + 0.02 if left < 0.004 else -(x + 0.02)
            text = f"the frame cuts {subject.node_id}"
            found.append(fault("bystander", subject.node_id, 0.4 + min(3 * subject.pixels, 0.8), text,
                                azimuth=math.copysign(8, -away), ops=_AROUND))  # fmt: skip
    return found


def _top_to_show(view: CameraOperatorView, subject: SubjectView) -> float:
    """Return the screen y of a bystander that must be in the picture: the crown, in a tight shot the face."""
    assert subject.face is not None
    crown = subject.head_top if view.instruction.size not in TIGHT else None
    return subject.face[1] if crown is None else crown
