"""The Asset Generator without an external service: picks stand-ins for things missing from the library.

Omega calls it when the Retriever found nothing that fits. It takes the nearest prop of the catalog: by the
noun's kind, by the head of the phrase, by word similarity; and falls back to a plain shape if nothing is near. A
language crew with an image-to-3D provider replaces this policy; this one always succeeds, so no run stops for want
of a model.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView
from storyblender.catalog.kinds import near_kind
from storyblender.catalog.props import PROPS, PropEntry
from storyblender.catalog.props.phrases import noun_words
from storyblender.catalog.props.prop_names import prop_named
from storyblender.catalog.props.variants import read_variant
from storyblender.catalog.recipe import Recipe
from storyblender.catalog.stand_ins import DEFAULT, STAND_INS, StandIn, guess_class
from storyblender.ports import Embedder
from storyblender.reflection import Critique

CLOSE, LIKE, PLAIN = 6.0, 4.5, 3.0
"""Match scores: a prop of a close kind, a prop similar in meaning, a plain shape. None is an exact match."""
ALIKE = 0.5
"""Least cosine similarity for a prop as stand-in; creatures and vehicles always take the nearest prop."""
SURE = 0.5
"""Least cosine similarity for choosing a class of plain shapes."""
_OF_KIND: dict[str, str] = {"set_piece": "furnishing", "vehicle": "vehicle", "animal": "creature"}
"""Kind of thing -> its class where nothing else is known; everything else is a small thing."""


class RulesAssetGenerator:
    """The policy that builds a stand-in for a thing that the library does not have.

    Args:
        embedder: Sentence embeddings, for words that no table lists.
    """

    def __init__(self, embedder: Callable[[], Embedder]) -> None:
        self._load = embedder

    def propose(self, view: AssetRetrieverView) -> Recipe:
        """Return the nearest prop of the catalog, or a plain shape of the class that the thing's description names."""
        words, kind = noun_words(view.phrase), view.kind
        found = near_kind(words)
        if found is not None and found[0] not in view.rejected:
            return prop_recipe(view, found[0], CLOSE, f"of a kind with {found[1]!r}")
        head = prop_named(" ".join(words))
        if head is not None and head.key not in view.rejected:
            return prop_recipe(view, head.key, CLOSE, f"a kind of {head.name}")
        if view.asset.writing.strip():
            return prop_recipe(view, "letter" if kind == "prop" else "poster", PLAIN, "it bears writing")
        return self._by_meaning(view, kind) or _plain(view, *self._class(view, kind))

    def refine(self, draft: Recipe, critique: Critique, view: AssetRetrieverView) -> Recipe:
        """Return the draft, or a plain shape if a critic who looked at it says that one tells less of another story.

        Args:
            draft: The stand-in that was proposed.
            critique: Its faults.
            view: The object.
        """
        plain = any("take_plain_shape" in str(fault.fix.get("ops", "")) for fault in critique.faults)
        return _shape(*self._class(view, view.kind)) if plain else draft

    def _by_meaning(self, view: AssetRetrieverView, kind: str) -> Recipe | None:
        """Return the prop of the thing's kind whose name is closest in meaning, or None if none is close enough."""
        entries, vectors = self._props
        query = self._model.embed([" ".join(noun_words(view.phrase)) or view.phrase])[0]
        likeness = vectors @ query - [
            2.0 * (key in view.rejected or not _suitable(PROPS[key], kind)) for key, _ in entries
        ]
        best = int(np.argmax(likeness))
        (key, name), cosine = entries[best], float(likeness[best])
        if cosine < ALIKE and kind not in ("animal", "vehicle"):
            return None
        return prop_recipe(view, key, LIKE, f"like {name!r} ({cosine:.2f})")

    def _class(self, view: AssetRetrieverView, kind: str) -> tuple[StandIn, str]:
        """Return the class of things that an object is of, and why."""
        known = guess_class(view.phrase)
        if known is not None:
            return known, f"a kind of {known.name}"
        query = self._model.embed([view.phrase])[0]
        words, vectors = self._words
        likeness = vectors @ query - [not _suits(STAND_INS[key], kind) for key, _ in words]
        best = int(np.argmax(likeness))
        cosine = float(likeness[best])
        key = words[best][0] if cosine >= SURE else _OF_KIND.get(kind, DEFAULT)
        reason = f"like {words[best][1]!r} ({cosine:.2f})" if cosine >= SURE else "nothing is known about it"
        return STAND_INS[key], reason

    @cached_property
    def _model(self) -> Embedder:
        return self._load()

    @cached_property
    def _props(self) -> tuple[list[tuple[str, str]], np.ndarray]:
        names = [(entry.key, name) for entry in PROPS.values() for name in (entry.name, *entry.tags)]
        return names, self._model.embed([name for _, name in names])

    @cached_property
    def _words(self) -> tuple[list[tuple[str, str]], np.ndarray]:
        words = [(entry.key, tag) for entry in STAND_INS.values() for tag in entry.tags]
        return words, self._model.embed([tag for _, tag in words])


def prop_recipe(view: AssetRetrieverView, key: str, score: float, reason: str) -> Recipe:
    """Return a catalog prop in the colour, material and state that the script gives.

    Args:
        view: The object.
        key: Of the prop.
        score: How well it fits, 1 to 10.
        reason: Why, for people.
    """
    params = read_variant(PROPS[key], view.told)
    return Recipe(source="catalog", key=key, params=params, score=score, reason=reason)


def _plain(view: AssetRetrieverView, entry: StandIn, reason: str) -> Recipe:
    """Return the recipe for a class of things: its prop, or its plain shape."""
    if entry.prop is not None and entry.prop not in view.rejected:
        return prop_recipe(view, entry.prop, PLAIN, reason)
    return _shape(entry, reason)


def _shape(entry: StandIn, reason: str) -> Recipe:
    """Return the plain shape with the typical size of a class of things."""
    return Recipe(source="stand_in", key=entry.key, score=PLAIN, reason=reason)


def _suitable(entry: PropEntry, kind: str) -> bool:
    """Tell whether a prop can stand in for one of the script's kinds of things: no lion for a dandelion clock."""
    match kind:
        case "animal" | "vehicle":
            return entry.category == kind
        case "prop":
            return entry.holdable or entry.placement == "surface"
        case _:
            return entry.category != "animal"


def _suits(entry: StandIn, kind: str) -> bool:
    """Tell whether a class is one of the script's kinds of things: a banana is like a monkey, but it is no animal."""
    match kind:
        case "prop":
            return entry.holdable
        case "set_piece":
            return entry.key in ("furnishing", "appliance", "machine", "pillar", "monument", "building", "barrier")
        case "vehicle":
            return entry.key in ("vehicle", "large_vehicle", "craft")
        case "animal":
            return entry.key in ("creature", "small_creature")
    return True
