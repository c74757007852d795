"""The Camera Operator played by a language model: the paper's visual servo (section 3.4; appendix).

First it chooses among views from all around the subjects, then it names operations, one request a turn. It sees the
viewfinder's pictures, and beside them numbers: boxes of the subjects, faces, what covers them, and what critics mind.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, Any

from pydantic import Field

from storyblender.agents.asking import Asker, Notes
from storyblender.agents.layout_artist.camera_operator import (
    CAMERA_HORIZON,
    MODEL_HORIZON,
    OPERATIONS,
    CameraRole,
    Operator,
    RulesCameraOperator,
    apply_numbers,
    numbers_of,
    with_other_camera,
)
from storyblender.agents.layout_artist.camera_operator_critic import view_request
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.agents.layout_artist.camera_words import Operation, shown_camera, shown_look, shown_shot
from storyblender.geometry.orbit import Orbit
from storyblender.look.viewfinder_picture import numbered_sheet
from storyblender.memory.base import content_hash, shot_name
from storyblender.memory.request import Picture
from storyblender.ports import Answerer, Viewfinder
from storyblender.reflection import Critique

_VIEWS = 6
"""Views to choose from; each is a look through the viewfinder."""
_APART = (25.0, 15.0)
"""Degrees of azimuth or of elevation between two of them."""


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
        viewfinder: Draws what is shown.
    """

    asker: Asker[CameraNotes]
    rules: RulesCameraOperator
    viewfinder: Viewfinder
    _takes: list[tuple[CameraOperatorDraft, Critique]] = field(default_factory=list)
    """The takes so far, with what the critic said of them."""
    _tried: list[dict[str, Any]] = field(default_factory=list)
    """Operations of each turn, with the score that they led to."""

    def propose(self, view: CameraOperatorView) -> CameraOperatorDraft:
        """Return the view that the model chose, with its first operations and the critic's numbers if they help.

        Raises:
            NoAnswer: The model is silent.
            AnswerAwaited: The answer has to come from outside first.
        """
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

        answer = self._asked(view, {"views": shown}, (self._sheet(views, view),), wrong)
        chosen = _moved(views[(answer.view or 1) - 1], answer.operations, view)
        return self._mended([chosen], chosen, view) or chosen

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
        if (mended := self._mended([draft, best], best, view)) is not None:
            return mended
        now = {"now": self._shown(best, judged, view), "tried": self._tried}
        answer = self._asked(view, now, self._previews([best], view))
        if answer.operations:
            self._tried.append({"operations": answer.operations})
        return _moved(best, answer.operations, view)

    def _mended(
        self, takes: Iterable[CameraOperatorDraft], best: CameraOperatorDraft, view: CameraOperatorView
    ) -> CameraOperatorDraft | None:
        """Return the first take that is better than the best one with the numbers of the engine's critic applied."""
        judge = self.rules.critic.judge
        mended = (_with_numbers(take, judge(take, view), view) for take in takes)
        least = judge(best, view).score
        return next((take for take in mended if judge(take, view).score > least), None)

    def _asked(
        self,
        view: CameraOperatorView,
        shown: dict[str, Any],
        pictures: tuple[Picture, ...],
        wrong: Callable[[CameraNotes], Iterable[str]] = lambda answer: (),
    ) -> CameraNotes:
        told = {"shot": shown_shot(view), **shown}
        return self.asker.ask(shot_name(view.scene_id, view.shot_id), told, wrong, pictures=pictures)

    def _previews(self, takes: Sequence[CameraOperatorDraft], view: CameraOperatorView) -> tuple[Picture, ...]:
        """Return how takes look at the story moment."""
        frame = view.story_moment.frame
        return tuple(self.viewfinder.preview([view_request(view, take, frame) for take in takes]))

    def _sheet(self, takes: Sequence[CameraOperatorDraft], view: CameraOperatorView) -> Picture:
        """Return how takes look at the story moment, as one picture with their numbers."""
        previews = self._previews(takes, view)
        sheet = numbered_sheet([each.png for each in previews])
        return Picture(name="views", png=sheet, drawn_from=content_hash(*(each.digest for each in previews)))

    def _shown(self, take: CameraOperatorDraft, critique: Critique, view: CameraOperatorView) -> dict[str, Any]:
        """Return how a judged take looks at the story moment, as the model is shown it."""
        return {
            "score": round(critique.score, 1),
            "faults": [
                {"is": fault.message, "try": str(fault.fix.get("ops", "")).split()} for fault in critique.faults
            ],
            "camera": shown_camera(take.camera),
            **shown_look(self.rules.critic.seen(take, view), view),
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
        policy = LanguageCameraOperator(Asker(answerer, "camera_operator", CameraNotes), rules, viewfinder)
        horizon = MODEL_HORIZON if role.horizon == CAMERA_HORIZON else role.horizon
        return replace(role, policies=(policy, *role.policies), horizon=horizon)

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
