"""The vision critic of the layout: looks at the plan of a scene, beside the critic who measures.

Overlaps, walls, contact and the ways from the doors are measured. It says whether the scene can be played there.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any, Literal

from storyblender.agents.asking import Asker
from storyblender.agents.layout_artist.language_spatial_planner import shown_scene
from storyblender.agents.layout_artist.plan_picture import plan_picture
from storyblender.agents.layout_artist.spatial_planner_view import SpatialPlannerView
from storyblender.agents.vision_critic import VisionCritic, critic_notes
from storyblender.memory.base import scene_name
from storyblender.memory.scene_context import Layout
from storyblender.ports import Answerer
from storyblender.reflection import Role, Subject

LayoutCriticNotes = critic_notes(
    Literal["nearer", "farther", "turn_to_it", "turn_away", "other_side", "into_the_open", "to_the_wall"]
)
"""What the vision critic of the layout says; the operations are about a thing and its anchor."""


def with_layout_critic(
    answerer: Answerer, role: Role[Subject, SpatialPlannerView, Layout]
) -> Role[Subject, SpatialPlannerView, Layout]:
    """Return a Spatial Planner whose layouts a vision critic judges too; its score counts if it is the lower.

    A scene without people and things of the script is left to the critic who measures.

    Args:
        answerer: The model, or a person in its place.
        role: The Spatial Planner.
    """

    def show(layout: Layout, view: SpatialPlannerView) -> Mapping[str, Any]:
        known = [fault.message for fault in role.critic.judge(layout, view).faults]
        told = {name: value for name, value in shown_scene(view).items() if name in _TOLD}
        return told | ({"already_known": known} if known else {})

    critic = VisionCritic(
        role.critic,
        Asker(answerer, "layout_critic", LayoutCriticNotes),
        subject=lambda view: scene_name(view.scene_id),
        show=show,
        pictures=lambda layout, view: (plan_picture(layout, view),),
        ids=_ids,
        wanted=lambda view: bool(view.states or view.found_later or view.pending),
        threshold=role.threshold,
    )
    return replace(role, critic=critic)


_TOLD = ("place", "story", "room", "things", "people", "in_conversation")


def _ids(view: SpatialPlannerView) -> Collection[str]:
    """Return the ids that a fault may name: people and things that the Spatial Planner places."""
    people = (state.asset_id for state in (*view.states, *view.found_later))
    return tuple(dict.fromkeys((*people, *view.pending)))
