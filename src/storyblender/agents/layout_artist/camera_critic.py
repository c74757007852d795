"""The vision critic of the camera: looks at the take's preview, beside the critic who measures.

It says whether the picture shows what the shot is about, and may name operations of the Camera Operator's list.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any

from storyblender.agents.asking import Asker
from storyblender.agents.layout_artist.camera_operator import (
    CAMERA_HORIZON,
    MODEL_HORIZON,
    CameraRole,
    Operator,
)
from storyblender.agents.layout_artist.camera_operator_critic import (
    moments_to_judge,
    view_request,
)
from storyblender.agents.layout_artist.camera_operator_view import CameraOperatorDraft, CameraOperatorView
from storyblender.agents.layout_artist.camera_words import Operation, shown_camera, shown_shot
from storyblender.agents.vision_critic import VisionCritic, critic_notes
from storyblender.memory.base import shot_name
from storyblender.memory.request import Picture
from storyblender.ports import Answerer, Viewfinder

CameraCriticNotes = critic_notes(Operation)
"""What the vision critic of the camera says."""


def with_camera_critic(answerer: Answerer, operator: Operator) -> Operator:
    """Return a builder of Camera Operators whose takes a vision critic judges too; its score counts if it is the lower.

    A camera that a person placed is left to the engine's critic.

    Args:
        answerer: The model, or a person in its place.
        operator: Builds a Camera Operator for one shot.
    """

    def build(viewfinder: Viewfinder) -> CameraRole:
        role = operator(viewfinder)

        def show(take: CameraOperatorDraft, view: CameraOperatorView) -> Mapping[str, Any]:
            known = [fault.message for fault in role.critic.judge(take, view).faults]
            told = {"shot": shown_shot(view), "camera": shown_camera(take.camera)}
            return told | ({"already_known": known} if known else {})

        critic = VisionCritic(
            role.critic,
            Asker(answerer, "camera_critic", CameraCriticNotes),
            subject=lambda view: shot_name(view.scene_id, view.shot_id),
            show=show,
            pictures=lambda take, view: _pictures(viewfinder, take, view),
            ids=_ids,
            wanted=lambda view: view.asked.placed is None,
            threshold=role.threshold,
        )
        horizon = MODEL_HORIZON if role.horizon == CAMERA_HORIZON else role.horizon
        return replace(role, critic=critic, horizon=horizon)

    return build


def _pictures(viewfinder: Viewfinder, take: CameraOperatorDraft, view: CameraOperatorView) -> tuple[Picture, ...]:
    """Return the preview of the story moment; of start, story moment and end where people walk or the camera moves."""
    frames = [moment.frame for moment in moments_to_judge(view, [take])]
    return tuple(
        picture.model_copy(update={"name": f"frame_{frame}"})
        for frame, picture in zip(
            frames, viewfinder.preview([view_request(view, take, frame) for frame in frames]), strict=True
        )
    )


def _ids(view: CameraOperatorView) -> Collection[str]:
    """Return the ids that a fault may name: subjects, other people, things."""
    people = (figure.node_id for figure in view.story_moment.figures)
    return tuple(dict.fromkeys((*view.named, *people, *view.props)))
