"""The vision critic of light: looks at shots of the lit scene, beside the critic who computes (paper, section 3.4).

It says whether the light tells what the scene is about, and names operations of a closed list, which code applies.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any

from storyblender.agents.asking import Asker
from storyblender.agents.story_lines import story_lines
from storyblender.agents.vision_critic import VisionCritic, critic_notes
from storyblender.agents.visual_effects_artist.language_lighting_arranger import (
    known_lights,
    people_at_first,
    shown_levels,
    subject_of,
)
from storyblender.agents.visual_effects_artist.light_operations import LightOperation
from storyblender.agents.visual_effects_artist.lighting_arranger_view import LightingArrangerView
from storyblender.memory.scene_context import Lighting
from storyblender.ports import Answerer
from storyblender.reflection import Role, Subject

LightCriticNotes = critic_notes(LightOperation)
"""What the vision critic of light says."""


def with_light_critic(
    answerer: Answerer, role: Role[Subject, LightingArrangerView, Lighting]
) -> Role[Subject, LightingArrangerView, Lighting]:
    """Return a Lighting Arranger whose plans a vision critic judges too; its score counts if it is the lower.

    Args:
        answerer: The model, or a person in its place.
        role: The Lighting Arranger.
    """

    def show(plan: Lighting, view: LightingArrangerView) -> Mapping[str, Any]:
        known = [fault.message for fault in role.critic.judge(plan, view).faults]
        return _shown(plan, view) | ({"already_known": known} if known else {})

    critic = VisionCritic(
        role.critic,
        Asker(answerer, "light_critic", LightCriticNotes),
        subject=subject_of,
        show=show,
        pictures=lambda plan, view: view.draw(plan),
        ids=_ids,
        threshold=role.threshold,
    )
    return replace(role, critic=critic)


def _shown(plan: Lighting, view: LightingArrangerView) -> dict[str, Any]:
    """Return what the critic is told: what the light has to tell, its levels, and the lights that may be named."""
    shown: dict[str, Any] = {
        "place": view.setup.place,
        "indoors": view.plan.indoor,
        "hour": view.setup.time_of_day,
        "weather": view.setup.weather,
        "asked_for": list(view.setup.light),
        "story": story_lines(view.outline),
        "light": shown_levels(plan),
        "lights": [light.name for light in plan.lights],
        "people": [*people_at_first(view)],
    }
    if view.change is not None:
        shown["change"] = {"in_shot": view.shot_id, **view.change.model_dump(exclude_defaults=True)}
    return {name: value for name, value in shown.items() if value not in ("", [])}


def _ids(view: LightingArrangerView) -> Collection[str]:
    """Return the ids that a fault may name: lights and people."""
    return (*sorted(known_lights(view)), *people_at_first(view))
