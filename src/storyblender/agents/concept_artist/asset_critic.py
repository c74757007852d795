"""A vision critic of assets: it looks at what an object is to be made from (paper, appendix: examination of assets).

It is asked about what was not found by its name, likenesses of meaning and stand-ins, and about models of services and
of the user's library, whose names come from other people.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Literal

from storyblender.agents.asking import Asker
from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView
from storyblender.agents.side_views import portrait
from storyblender.agents.vision_critic import VisionCritic, critic_notes
from storyblender.catalog.recipe import HEAD, Recipe
from storyblender.memory.request import Picture
from storyblender.ports import Answerer
from storyblender.reflection import Critic, Critique, Role

_HORIZON = 3
"""Most further candidates of one policy: each is a picture."""
OWN_MODELS = "models"
"""Source of the user's own folders, whose names are their own words."""
_PLAIN = 4.0
"""Score of a plain shape beside what was looked at."""
AssetCriticNotes = critic_notes(Literal["take_another", "take_plain_shape"])


@dataclass(frozen=True)
class AssetCritic:
    """The critic of fits by name, and a vision critic for what has not that name.

    Attributes:
        names: Judges how well words fit.
        eyes: Judges as ``names``, and looks.
    """

    names: Critic[AssetRetrieverView, Recipe]
    eyes: VisionCritic[AssetRetrieverView, Recipe]
    _looked: set[str] = field(default_factory=set)
    """Ids of the objects for which something was looked at."""

    def judge(self, draft: Recipe, view: AssetRetrieverView) -> Critique:
        """Return the critique of a recipe.

        Once something was looked at for an object, names count no more: a model may know that the thing of that name is
        not what is meant. A plain shape is never looked at; it is better than what tells another story only.

        Args:
            draft: Recipe with the score of its fit.
            view: The object that it is for.
        """
        asset_id, plain = view.asset.asset_id, draft.source == "stand_in"
        if plain and not draft.final and asset_id in self._looked:
            return Critique(score=_PLAIN)
        known = draft.provenance is None or draft.provenance.source == OWN_MODELS
        named = draft.score >= HEAD and not draft.final and not draft.by_meaning and known
        if plain or (named and asset_id not in self._looked):
            return self.names.judge(draft, view)
        self._looked.add(asset_id)
        return self.eyes.judge(draft, view)


def with_asset_critic(
    answerer: Answerer, role: Role[..., AssetRetrieverView, Recipe]
) -> Role[..., AssetRetrieverView, Recipe]:
    """Return the Asset Retriever with a vision critic beside its own.

    Args:
        answerer: The model, or a person in its place.
        role: With the policies that choose.
    """
    eyes = VisionCritic(
        engine=role.critic,
        asker=Asker(answerer, "asset_critic", AssetCriticNotes),
        subject=lambda view: view.asset.asset_id,
        show=_shown,
        pictures=_pictures,
        ids=lambda view: (view.asset.asset_id,),
    )
    return replace(role, critic=AssetCritic(role.critic, eyes), horizon=max(role.horizon, _HORIZON))


def _shown(draft: Recipe, view: AssetRetrieverView) -> dict[str, Any]:
    """Return what the critic is told; not what the model is called, which would say what to see."""
    told = {
        "object": view.asset.name or view.asset.asset_id,
        "description": view.asset.description,
        "kind": view.kind,
        "in_a_hand": "handled" in view.asset.tags,
        "state": view.state,
        "place": view.place,
        "lines": view.lines,
    }
    return {name: value for name, value in told.items() if value}


def _pictures(draft: Recipe, view: AssetRetrieverView) -> tuple[Picture, ...]:
    """Return the portrait of what the object would be made from. Raises NoAnswer."""
    made = view.asset.model_copy(update={"canonical": draft.canonical()})
    return (portrait(view.draw(made), "candidate"),)
