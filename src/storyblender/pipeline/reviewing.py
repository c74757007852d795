"""Runs the Frame Critic: every drawn frame is judged against its lines, and the review is kept next to it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

import numpy as np
from PIL import Image

from storyblender.agents.frame_critic.critic import FrameCritic, Verdict, verdict_of
from storyblender.agents.frame_critic.frame_view import FrameView, things_to_see
from storyblender.catalog.fixtures import fixtures_called
from storyblender.catalog.sets import plan_of
from storyblender.look.picture_measure import PictureMeasure, measure_picture
from storyblender.memory.base import Digest, Frozen, content_hash, shot_name
from storyblender.memory.coverage import filmed
from storyblender.memory.measure import SubjectView
from storyblender.memory.shot_context import ShotContext
from storyblender.pipeline.run import Run
from storyblender.pipeline.shooting import frame_picture
from storyblender.pipeline.sighting import ShotSight, Sighting, nodes_of
from storyblender.reflection import Critique, Fault

_NOT_JUDGED = {"lights", "blocking", "cues", "camera", "camera_retake", "locked", "decided_duration",
               "blocking_decision", "motion_by_hand", "stale", "notes", "approved", "omitted"}  # fmt: skip
"""Fields of a shot that the Frame Critic does not see, or sees in the picture."""
CRITIC_VERSION = 7
"""Raised with every change of the critic's rules: kept reviews are then redone."""


class FrameReview(Frozen):
    """The Frame Critic's judgement of one frame."""

    shot: str
    judged: Digest
    """Hash of the judged inputs."""
    score: float
    """Score from 1 to 10."""
    faults: tuple[Fault, ...] = ()
    seen: tuple[SubjectView, ...] = ()
    """How the people and things of the shot are in the picture."""

    @property
    def lost(self) -> float:
        """Points that the faults cost in all: of two frames of the lowest score one may still be better."""
        return sum(fault.severity for fault in self.faults)

    @property
    def verdict(self) -> Verdict:
        """``pass``, ``fix`` or ``reject``."""
        return verdict_of(self.score)


def review_frames(run: Run, shots: Collection[ShotContext]) -> dict[str, FrameReview]:
    """Judge the frames of some shots; unchanged frames keep their reviews.

    Args:
        run: The run, with packs and frames.
        shots: Drawn shots with a camera.

    Returns:
        The reviews by shot name, in the order of the shots.
    """
    found: dict[str, FrameReview] = {}
    waiting: dict[int, list[ShotContext]] = {}
    for shot in shots:
        known = run.outputs.read(_record(run, shot), FrameReview.model_validate_json)
        if known is not None and known.judged == _judged(run, shot):
            found[known.shot] = known
        else:
            waiting.setdefault(shot.scene_id, []).append(shot)
    for shot, sight in _sights(run, waiting):
        critique = judge_frame(run, shot, sight, _measured(run, shot))
        review = _review(shot, sight, critique, _judged(run, shot))
        run.outputs.write(_record(run, shot), review.model_dump_json())
        found[review.shot] = review
    names = (shot_name(shot.scene_id, shot.shot_id) for shot in shots)
    return {name: found[name] for name in names}


def foresee_frames(run: Run, shots: Collection[ShotContext]) -> dict[str, FrameReview]:
    """Judge frames that are not drawn yet, by what their cameras see: a drawn frame has these faults at least.

    Args:
        run: The run, with packs.
        shots: Shots with a camera.

    Returns:
        The reviews by shot name; they are not kept.
    """
    waiting: dict[int, list[ShotContext]] = {}
    for shot in shots:
        waiting.setdefault(shot.scene_id, []).append(shot)
    reviews = (_review(shot, sight, judge_frame(run, shot, sight, None), "") for shot, sight in _sights(run, waiting))
    return {review.shot: review for review in reviews}


def _sights(run: Run, shots: Mapping[int, Sequence[ShotContext]]) -> Iterator[tuple[ShotContext, ShotSight]]:
    """Yield shots with what their cameras see, scene by scene; all scenes are looked at side by side."""
    asked = {
        scene_id: Sighting(run.graph, run.engine, run.packs[scene_id], {shot.shot_id for shot in scene_shots})
        for scene_id, scene_shots in shots.items()
    }
    for scene_id, scene_shots in shots.items():
        sights = asked[scene_id].seen()
        for shot in scene_shots:
            yield shot, sights[shot_name(shot.scene_id, shot.shot_id)]


def _review(shot: ShotContext, sight: ShotSight, critique: Critique, judged: str) -> FrameReview:
    name, score = shot_name(shot.scene_id, shot.shot_id), round(critique.score, 2)
    return FrameReview(shot=name, judged=judged, score=score, faults=critique.faults, seen=sight.view.subjects)


def judge_frame(run: Run, shot: ShotContext, sight: ShotSight, picture: PictureMeasure | None) -> Critique:
    """Judge one frame.

    Args:
        run: The run, with the story and its pictures.
        shot: The shot to judge.
        sight: The measured view of its camera.
        picture: Measurements of its pixels; None if it is not drawn yet.
    """
    name, shot = shot_name(shot.scene_id, shot.shot_id), filmed(run.graph, shot)
    assets = {asset.asset_id: asset for asset in run.graph.assets}
    nodes, environment = nodes_of(run.graph, shot.scene_id), run.graph.scene(shot.scene_id).environment
    plan = plan_of(environment) if environment is not None else None
    asked = [thing for thing in things_to_see(shot) if thing not in nodes and thing in assets]
    built = frozenset(thing for thing in asked if plan is not None and fixtures_called(plan, assets[thing].name))
    return FrameCritic().judge(
        FrameView(
            shot=shot,
            seen=sight.view,
            people=frozenset(figure.node_id for figure in sight.figures),
            picture=picture,
            assets=assets,
            nodes=nodes,
            staged=tuple(flaw for flaw in run.packs[shot.scene_id].problems if flaw.shot == name),
            built=built,
            aspect=run.graph.format.aspect,
            played=run.packs[shot.scene_id].played(shot.shot_id),
        )
    )


def kept_reviews(run: Run, shots: Collection[ShotContext]) -> Mapping[str, FrameReview]:
    """Return the kept reviews of the current frames, by shot name.

    Args:
        run: With the packs.
        shots: Those whose reviews are wanted; a shot without one is left out.
    """
    known = (run.outputs.read(_record(run, shot), FrameReview.model_validate_json) for shot in shots)
    return {review.shot: review for review in known if review is not None}


def _measured(run: Run, shot: ShotContext) -> PictureMeasure:
    with Image.open(run.project.path(frame_picture(run, shot))) as picture:
        return measure_picture(np.asarray(picture.convert("RGB")))


def _record(run: Run, shot: ShotContext) -> str:
    return f"{frame_picture(run, shot)}.review.json"


def _judged(run: Run, shot: ShotContext) -> str:
    told = filmed(run.graph, shot).model_dump(mode="json", exclude=_NOT_JUDGED)
    return content_hash(CRITIC_VERSION, told, frame_picture(run, shot))
