"""What the Concept Artist decides about one object: what to build it from, and how well that fits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from storyblender.catalog.liquids import liquid_color
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.variants import words_of
from storyblender.catalog.registry import ParamValue
from storyblender.catalog.sets import SETS
from storyblender.catalog.sets.places import kit_of
from storyblender.catalog.stand_ins import DEFAULT, STAND_INS
from storyblender.catalog.states import look_in, state_at_first
from storyblender.catalog.writing import CALLS, MOST, SCREENS, WRITING
from storyblender.memory.asset_sheet import Asset, CanonicalAsset
from storyblender.memory.base import Frozen, Vec3, content_hash
from storyblender.memory.graph import ContinuityMemoryGraph
from storyblender.reflection import Critique, Fault

RETRIEVAL_THRESHOLD = 7.0
"""tau of the Retriever: under it the Generator takes over (paper, section 3.3)."""


_PHRASE = 7
"""Words: a longer description is a sentence, not a phrase that names."""


class ModelFile(Frozen):
    """A model in the user's own folder."""

    path: str
    """Relative to the folder of models."""
    name: str
    """Words: from the file's name and its folders."""
    content: str = ""
    """Hash of the file: a model that was changed is another model."""


class AssetRetrieverView(Frozen):
    """The Concept Artist's view: one object, and where else to look for it."""

    asset: Asset
    models: tuple[ModelFile, ...] = ()
    means: dict[str, str] = {}
    """What plain words mean in the place it is first seen in, prop for prop."""
    weather: str = ""
    """In the place it is first seen in, where that is outdoors: umbrellas are up in the rain."""
    state: str = ""
    """The state it is in at first, as far as the story tells: ``open``, ``lit``."""

    @property
    def told(self) -> str:
        """All words that describe its look."""
        return f"{self.phrase} {self.asset.description} {self.weather} {self.state}"

    @property
    def phrase(self) -> str:
        """How the script calls it, with its modifiers where they are known: ``small round table``; an animal may have a
        name of its own, but it is what it is described as.
        """
        name = self.asset.name or self.asset.asset_id.replace("_", " ")
        if self.asset.tags[:1] == ("animal",):
            return self.asset.description or name
        described = self.asset.description.split()
        whole = len(described) <= _PHRASE and self.asset.description.lower().endswith(f" {name.lower()}")
        return self.asset.description if whole else name


def asset_retriever_view(
    graph: ContinuityMemoryGraph, asset: Asset, models: tuple[ModelFile, ...], means: Mapping[str, str]
) -> AssetRetrieverView:
    """Return the Concept Artist's projection of the graph: an asset with what the first place where it is says of it.

    Args:
        graph: With the Director's plan.
        asset: The object.
        models: The user's own models.
        means: What plain words mean in the story's age.
    """
    setup = next((scene.setup for scene in graph.scenes if asset.asset_id in scene.setup.asset_ids), None)
    if setup is None:
        return AssetRetrieverView(asset=asset, models=models)
    changes = [change for shot in graph.shots for change in shot.asset_modifications]
    states = [change.state for change in changes if change.asset_id == asset.asset_id and change.state]
    return AssetRetrieverView(
        asset=asset,
        models=models,
        means={**means, **SETS[kit_of(setup)].meanings},
        weather=setup.weather if setup.scene_type == "outdoor" else "",
        state=state_at_first(states) or ("open" if _is_looked_into(graph, asset.asset_id) else ""),
    )


def _is_looked_into(graph: ContinuityMemoryGraph, asset_id: str) -> bool:
    """Return whether the script tells of a thing inside another: that one is open, so that the thing is seen."""
    told = [(each.kind, each.anchor_asset_id) for scene in graph.scenes for each in scene.setup.relations]
    spots = (spot for shot in graph.shots for spot in shot.thing_spots.values())
    told += [(spot.relation, spot.anchor_id) for spot in spots if spot.anchor_id is not None]
    return ("in", asset_id) in told or ("inside", asset_id) in told


class Recipe(Frozen):
    """What an object becomes: a library entry with parameters, a file, or a stand-in."""

    source: Literal["catalog", "file", "stand_in"]
    key: str
    """Key of ``catalog.props`` or ``catalog.stand_ins``, or the file's path in the folder of models."""
    params: dict[str, ParamValue] = {}
    score: float
    """1 to 10: how well it fits the description."""
    reason: str = ""

    @property
    def dimensions(self) -> Vec3:
        """The size before anything is measured; a file's is unknown and given as a cube of one metre."""
        if self.source == "catalog":
            width, depth, height = (
                float(self.params.get(name, size))
                for name, size in zip(("width", "depth", "height"), PROPS[self.key].size, strict=True)
            )
            return (width, depth, height)
        if self.source == "stand_in":
            return STAND_INS.get(self.key, STAND_INS[DEFAULT]).size
        return (1.0, 1.0, 1.0)

    def written(self, words: str) -> Recipe:
        """Return the recipe with ``words`` lettered on it, if it is a thing that can carry writing."""
        if not words.strip() or self.source != "catalog" or self.key not in WRITING:
            return self
        return self.model_copy(update={"params": {**self.params, "text": words.strip()[:MOST]}})

    def in_state(self, state: str) -> Recipe:
        """Return the recipe of the thing in the state that it is in at first: a candle that is lit later is out."""
        look = look_in(self.key, self.params, state) if self.source == "catalog" and state else None
        return self if look is None or look.key != self.key else self.model_copy(update={"params": look.params})

    def filled_with(self, told: str) -> Recipe:
        """Return the recipe with the drink that its name tells of: a glass of milk is white."""
        color = liquid_color(self.key, told, told=True)
        if self.source != "catalog" or not color or "drink" not in PROPS[self.key].params:
            return self
        return self.model_copy(update={"params": {**self.params, "drink": color}})

    def with_caller(self, told: str) -> Recipe:
        """Return the recipe with a caller's face on its screen, if its description tells of a call."""
        if self.source != "catalog" or self.key not in SCREENS or not CALLS & {*words_of(told)}:
            return self
        return self.model_copy(update={"params": {**self.params, "caller": True}})

    def canonical(self) -> CanonicalAsset:
        """Return the canonical asset as it is known before Blender has built it."""
        return CanonicalAsset(
            source=self.source,
            key=self.key,
            params=self.params,
            dimensions=self.dimensions,
            digest=content_hash(self.source, self.key, dict(self.params)),
            match_score=round(self.score, 2),
        )


class AssetRetrieverCritic:
    """Judges a recipe by how well it fits: the Retriever's is held against its threshold, the Generator's is final."""

    def judge(self, draft: Recipe, view: AssetRetrieverView) -> Critique:
        """Score the draft 1 to 10."""
        if draft.source == "stand_in":
            return Critique(score=10.0)
        if draft.score >= RETRIEVAL_THRESHOLD:
            return Critique(score=draft.score)
        fault = Fault(
            kind="match",
            message=f"{view.phrase!r} is only {draft.score:.1f} of 10 like {draft.key!r}",
            subject=view.asset.asset_id,
            severity=10.0 - draft.score,
        )
        return Critique(score=draft.score, faults=(fault,))
