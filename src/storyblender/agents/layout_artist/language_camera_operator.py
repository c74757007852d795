"""The Camera Operator played by a language model: the paper's visual servo (section 3.4; appendix).

First it chooses among views from all around the subjects, then it names operations, one request a turn. The viewfinder
gives numbers, not pictures: the box of every subject, faces, what covers them, and what the critic minds.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, Literal

from pydantic import Field

from storyblender.agents.asking import Asker, Notes
from storyblender.agents.layout_artist.camera_operator import (
    OPERATIONS,
    CameraRole,
    Operator,
    RulesCameraOperator,
    apply_numbers,
    numbers_of,
    with_other_camera,
)
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.geometry.orbit import Orbit
from storyblender.memory.base import shot_name
from storyblender.memory.measure import CameraView, SubjectView
from storyblender.memory.shot_sizes import SIZES
from storyblender.ports import Answerer, Viewfinder
from storyblender.reflection import Critique

Operation = Literal[
    "orbit_left", "orbit_right", "orbit_up", "orbit_down", "pan_left", "pan_right", "pan_up", "pan_down",
    "zoom_in", "zoom_out", "roll_left", "roll_right",
]  # fmt: skip
"""The keys of ``OPERATIONS``."""

_VIEWS = 6
"""Views to choose from; each is a look through the viewfinder."""
_APART = (25.0, 15.0)
"""Degrees of azimuth or of elevation between two of them."""
_VISIBLE = 0.002
"""Share of the picture from which a person besides the subjects is listed."""


class CameraNotes(Notes):
    """What the Camera Operator does next."""

    view: int | None = None
    """`number` of the view to start from; only where `views` are given."""
    operations: Annotated[tuple[Operation, ...], Field(max_length=6)] = ()
    """Steps to take from there, in order; none if the picture is right."""


@dataclass(frozen=True)
class LanguageCameraOperator:
    """The Camera Operator played by a model, for one shot.

    Attributes:
        asker: Asks for views and operations.
        rules: Knows the views from all around, and the critic with the looks so far.
    """

    asker: Asker[CameraNotes]
    rules: RulesCameraOperator
    _takes: list[tuple[CameraOperatorDraft, Critique]] = field(default_factory=list)
    """The takes so far, with what the critic said of them."""
    _tried: list[dict[str, Any]] = field(default_factory=list)
    """Operations of each turn, with the score that they led to."""

    def propose(self, view: CameraOperatorView) -> CameraOperatorDraft:
        """Return the view that the model chose, with its first operations. Raises NoAnswer or AnswerAwaited."""
        views = _spread(self.rules.ranked_takes(view))
        if len(views) == 1:
            return views[0]
        critiques = self.rules.critic.judge_all(views, view)
        shown = [
            {"number": number, **self._shown(take, critique, view)}
            for number, (take, critique) in enumerate(zip(views, critiques, strict=True), start=1)
        ]

        def wrong(answer: CameraNotes) -> Iterator[str]:
            if answer.view is None or not 1 <= answer.view <= len(views):
                yield f"choose a `view` from 1 to {len(views)}"

        answer = self._asked(view, {"views": shown}, wrong)
        return _moved(views[(answer.view or 1) - 1], answer.operations, view)

    def refine(self, draft: CameraOperatorDraft, critique: Critique, view: CameraOperatorView) -> CameraOperatorDraft:
        """Return the best take so far with the critic's numbers if they help, else after the model's next operations.

        Args:
            draft: The latest take.
            critique: Its faults.
            view: The shot.
        """
        if len(_spread(self.rules.ranked_takes(view))) == 1:
            return draft
        if self._tried and "score" not in self._tried[-1]:
            self._tried[-1]["score"] = round(critique.score, 1)
        self._takes.append((draft, critique))
        best, judged = max(self._takes, key=lambda pair: pair[1].score)
        for take, found in ((draft, critique), (best, judged)):
            mended = _with_numbers(take, found, view)
            if self.rules.critic.judge(mended, view).score > judged.score:
                return mended
        answer = self._asked(view, {"now": self._shown(best, judged, view), "tried": self._tried}, lambda answer: ())
        if answer.operations:
            self._tried.append({"operations": answer.operations})
        return _moved(best, answer.operations, view)

    def _asked(self, view: CameraOperatorView, shown: dict[str, Any], wrong: Any) -> CameraNotes:
        return self.asker.ask(shot_name(view.scene_id, view.shot_id), {"shot": _shown_shot(view), **shown}, wrong)

    def _shown(self, take: CameraOperatorDraft, critique: Critique, view: CameraOperatorView) -> dict[str, Any]:
        """Return how a judged take looks at the story moment, as the model is shown it."""
        return {
            "score": round(critique.score, 1),
            "faults": [
                {"is": fault.message, "try": str(fault.fix.get("ops", "")).split()} for fault in critique.faults
            ],
            "camera": _shown_camera(take.camera),
            **_shown_look(self.rules.critic.seen(take, view), view),
        }  # fmt: skip


def language_operator(answerer: Answerer, operator: Operator) -> Operator:
    """Return a builder of Camera Operators played by a model, who hand over to the rules of another.

    Args:
        answerer: The model, or a person in its place.
        operator: Builds the Camera Operator of rules, for one shot.
    """

    def build(viewfinder: Viewfinder) -> CameraRole:
        role = operator(viewfinder)
        rules = next(each for each in role.policies if isinstance(each, RulesCameraOperator))
        policy = LanguageCameraOperator(Asker(answerer, "camera_operator", CameraNotes), rules)
        return replace(role, policies=(policy, *role.policies))

    return build


def _spread(takes: Sequence[CameraOperatorDraft]) -> list[CameraOperatorDraft]:
    """Return the cheapest takes that look from clearly different sides; ``takes`` are sorted, the cheapest first."""
    chosen: list[CameraOperatorDraft] = []
    for take in takes:
        if len(chosen) < _VIEWS and all(_differ(take.camera, other.camera) for other in chosen):
            chosen.append(take)
    return chosen


def _differ(one: Orbit, other: Orbit) -> bool:
    """Return whether two cameras look from clearly different sides."""
    turn = abs((one.azimuth - other.azimuth + 180) % 360 - 180)
    return turn >= _APART[0] or abs(one.elevation - other.elevation) >= _APART[1]


def _moved(take: CameraOperatorDraft, operations: Iterable[Operation], view: CameraOperatorView) -> CameraOperatorDraft:
    """Return a take after some operations."""
    camera = take.camera
    for name in operations:
        camera = OPERATIONS[name](camera)
    return take if camera == take.camera else with_other_camera(view, take, camera)


def _with_numbers(take: CameraOperatorDraft, critique: Critique, view: CameraOperatorView) -> CameraOperatorDraft:
    """Return a take with the numbers of all faults that have nothing else to try."""
    camera = take.camera
    for fault in critique.faults:
        if not fault.fix.get("ops"):
            camera = apply_numbers(camera, numbers_of(fault))
    return take if camera == take.camera else with_other_camera(view, take, camera)


def _shown_shot(view: CameraOperatorView) -> dict[str, Any]:
    """Return what the shot is to show."""
    wanted = view.instruction
    told: dict[str, Any] = {
        "lines": view.lines,
        "kind": wanted.kind,
        "size": wanted.size,
        "angle": wanted.angle,
        "movement": wanted.movement,
        "direction": wanted.direction,
        "subjects": view.focus or view.named,
        "detail": wanted.detail,
        "over_the_shoulder_of": view.over.node_id if view.over is not None else None,
        "should_also_be_seen": view.in_frame,
        "script_orders": wanted.order,
        "head_height_wanted": SIZES[wanted.size].band if view.people else None,
    }
    if view.previous is not None:
        before = view.previous.instruction
        told["shot_before"] = {"kind": before.kind, "size": before.size, "subjects": before.focus_on_ids}
    return {name: value for name, value in told.items() if value}


def _shown_camera(camera: Orbit) -> dict[str, float]:
    """Return where a camera stands: degrees, metres, mm."""
    return {
        "azimuth": round(camera.azimuth),
        "elevation": round(camera.elevation),
        "roll": round(camera.roll),
        "distance": round(camera.distance, 1),
        "lens": round(camera.lens),
    }


def _shown_look(seen: CameraView, view: CameraOperatorView) -> dict[str, Any]:
    """Return what a look shows of the subjects, and of others who are in the picture."""
    main = {*(view.focus or view.named), view.node(view.instruction.over_id or "")}
    others = (each for each in seen.subjects if each.node_id not in main and each.pixels > _VISIBLE)
    return {
        "subjects": [_shown_subject(each) for each in seen.subjects if each.node_id in main],
        "others": [_shown_subject(each) for each in others],
        "in_front_of_subjects": round(seen.foreground, 2),
        "empty": round(seen.void, 2),
    }


def _shown_subject(each: SubjectView) -> dict[str, Any]:
    """Return how one subject appears; shares of the picture from its upper left corner."""
    covered = 1 - each.visible_fraction / each.in_frame_fraction if each.in_frame_fraction > 0 else 0.0
    told: dict[str, Any] = {
        "id": each.node_id,
        "box": [round(side, 2) for side in each.box] if each.box is not None else None,
        "share_in_frame": round(each.in_frame_fraction, 2),
        "covered": round(max(covered, 0.0), 2),
    }
    if each.face is not None:
        told |= {
            "face_at": [round(side, 2) for side in each.face],
            "face_turned_away": round(each.face_angle),
            "face_visible": round(each.face_visible, 2),
            "head_height": round(each.head_height, 2),
            "headroom": round(each.head_top, 2) if each.head_top is not None else None,
        }
    return {name: value for name, value in told.items() if value is not None}
