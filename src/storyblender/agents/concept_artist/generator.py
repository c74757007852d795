"""The Asset Generator, without a service: a labelled stand-in of plausible shape and size.

Omega hands over to it where the Retriever found nothing that fits. With an image-to-3D provider a language crew puts
its own policy here; this one always ends, so a run never stops for want of a model.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from storyblender.agents.concept_artist.recipe import AssetRequest, Recipe
from storyblender.catalog.stand_ins import DEFAULT, STAND_INS, StandIn, guess_class
from storyblender.ports import Embedder
from storyblender.reflection import Critique

SURE = 0.5
"""Least cosine for a class to be taken by likeness of meaning."""
_OF_KIND: dict[str, str] = {"set_piece": "furnishing", "vehicle": "vehicle", "animal": "creature"}
"""Kind of thing -> its class where nothing else is known; everything else is a small thing."""
HONEST = 3.0
"""Match score of every stand-in: it is labelled, and it is not the thing."""


class Generator:
    """The policy that makes something of a thing that the library does not have.

    Args:
        embedder: Likeness of meaning, for words that no class lists.
    """

    def __init__(self, embedder: Callable[[], Embedder]) -> None:
        self._load = embedder

    def propose(self, view: AssetRequest) -> Recipe:
        """Return a stand-in of the class that the thing's words or their meaning say."""
        kind = next(iter(view.asset.tags), "")
        moving = [entry for entry in STAND_INS.values() if _suits(entry, kind)] if kind in ("vehicle", "animal") else []
        known = guess_class(view.phrase, moving)
        if known is not None:
            return Recipe(source="stand_in", key=known.key, score=HONEST, reason=f"a kind of {known.name}")
        query = self._model.embed([view.phrase])[0]
        words, vectors = self._words
        likeness = vectors @ query - [not _suits(STAND_INS[key], kind) for key, _ in words]
        best = int(np.argmax(likeness))
        cosine = float(likeness[best])
        key = words[best][0] if cosine >= SURE else _OF_KIND.get(kind, DEFAULT)
        reason = f"like {words[best][1]!r} ({cosine:.2f})" if cosine >= SURE else "nothing is known about it"
        return Recipe(source="stand_in", key=key, score=HONEST, reason=reason)

    def refine(self, draft: Recipe, critique: Critique, view: AssetRequest) -> Recipe:
        """Return the draft: a stand-in cannot be improved by criticism."""
        return draft

    @cached_property
    def _model(self) -> Embedder:
        return self._load()

    @cached_property
    def _words(self) -> tuple[list[tuple[str, str]], np.ndarray]:
        words = [(entry.key, tag) for entry in STAND_INS.values() for tag in entry.tags]
        return words, self._model.embed([tag for _, tag in words])


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
