"""What is looked for among the asset sources, and what they offer: an object becomes what its recipe says."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from storyblender.catalog.props import PROPS
from storyblender.catalog.props.variants import words_of
from storyblender.catalog.registry import ParamValue
from storyblender.catalog.stand_ins import DEFAULT, STAND_INS
from storyblender.catalog.states import state_look
from storyblender.catalog.writing import CALL_WORDS, MAX_LETTERS, SCREENS, WRITING
from storyblender.memory.asset_sheet import (
    AdoptedModel,
    Asset,
    AssetDecision,
    AssetDimension,
    CanonicalAsset,
    ModelPose,
    Provenance,
)
from storyblender.memory.base import Frozen, Vec3, content_hash
from storyblender.memory.vocabulary import ThingState

EXACT, HEAD, LEAST = 10.0, 8.5, 1.0
"""Match scores: the name itself, its head noun, nothing alike. From ``HEAD`` on nothing is looked for by meaning."""
_PHRASE = 7
"""Words: a longer description is a sentence, not a phrase that names."""


class AssetQuery(Frozen):
    """An object of the story, with all that the story says of its look."""

    asset: Asset
    means: dict[str, str] = {}
    """What plain words mean in the place it is first seen in, prop for prop."""
    weather: str = ""
    """In the place it is first seen in, where that is outdoors: umbrellas are up in the rain."""
    state: ThingState | Literal[""] = ""
    """The state it is in at first, as far as the story tells: ``open``, ``lit``."""

    @property
    def kind(self) -> str:
        """What kind of thing it is, such as ``prop``, ``animal`` or ``vehicle``; empty where it is not known."""
        return next(iter(self.asset.tags), "")

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


class Recipe(Frozen):
    """What an object becomes: a library entry with parameters, a file, or a stand-in."""

    source: Literal["catalog", "file", "stand_in"]
    key: str
    """Key of ``catalog.props`` or ``catalog.stand_ins``, or the file's path in its folder of models."""
    params: dict[str, ParamValue] = {}
    score: float
    """1 to 10: how well it fits the description."""
    reason: str = ""
    """Why it fits, for people."""
    provenance: Provenance | None = None
    """Of what a source other than the built-in library offers."""
    by_meaning: bool = Field(default=False, exclude_if=lambda value: not value)
    """Whether it has not the object's name, but one that means nearly the same."""
    final: bool = Field(default=False, exclude_if=lambda value: not value)
    """Whether all that there is was weighed: it stands in for the thing, however little it is like it."""

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
        return self.model_copy(update={"params": {**self.params, "text": words.strip()[:MAX_LETTERS]}})

    def in_state(self, state: ThingState | Literal[""]) -> Recipe:
        """Return the recipe of the thing in the state that it is in at first: a candle that is lit later is out."""
        look = state_look(self.key, self.params, state) if self.source == "catalog" and state else None
        return self if look is None or look.key != self.key else self.model_copy(update={"params": look.params})

    def filled_with(self, color: str) -> Recipe:
        """Return the recipe with a drink of a hex colour, if it is a thing that is drunk from: a glass of milk."""
        if self.source != "catalog" or not color or "drink" not in PROPS[self.key].params:
            return self
        return self.model_copy(update={"params": {**self.params, "drink": color}})

    def with_caller(self, told: str) -> Recipe:
        """Return the recipe with a caller's face on its screen, if its description tells of a call."""
        if self.source != "catalog" or self.key not in SCREENS or not CALL_WORDS & {*words_of(told)}:
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
            provenance=self.provenance,
        )


def made_from(asset: Asset, decision: AssetDecision) -> Asset:
    """Return an asset that is to be built from what a person decided, in the size that the library has it.

    Args:
        asset: As it is.
        decision: What it is made from.
    """
    if decision.file:
        sides = {side: size for side in AssetDimension.model_fields if (size := decision.params.get(side)) is not None}
        told = AssetDimension.model_validate(sides) if sides else None
        update = {"decision": decision, "canonical": None, "dimension": told, "image_prompt": ""}
        return asset.model_copy(update=update)
    if decision.adopted is not None:
        return _adopted(asset, decision, decision.adopted)
    recipe = Recipe(source="catalog", key=decision.prop, params=decision.params, score=EXACT)
    width = AssetDimension(width=recipe.dimensions[0])
    made = {"decision": decision, "kind": decision.prop, "canonical": recipe.canonical(), "dimension": width}
    made["image_prompt"] = ""
    return asset.model_copy(update=made)


def _adopted(asset: Asset, decision: AssetDecision, model: AdoptedModel) -> Asset:
    """Return an asset that is to be built from a model from Blender, as large as it is there and as it stands there."""
    recipe = Recipe(
        source="file",
        key=model.file,
        params={"content": model.content, "told": True, **ModelPose(front="front", top="top").params},
        score=EXACT,
        provenance=Provenance(source="blender", file=model.file),
    )
    canonical = recipe.canonical().model_copy(update={"dimensions": model.size})
    height = AssetDimension(height=model.size[2]) if model.size[2] > 0.01 else AssetDimension(width=max(model.size[:2]))
    made = {"decision": decision, "kind": decision.prop, "canonical": canonical, "dimension": height}
    return asset.model_copy(update={**made, "image_prompt": ""})
