"""The Asset Generator, without a service: a labelled stand-in of plausible shape and size.

Omega hands over to it where the Retriever found nothing that fits. With an image-to-3D provider a language crew puts
its own policy here; this one always ends, so a run never stops for want of a model.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from storyblender.agents.concept_artist.recipe import AssetRequest, Recipe
from storyblender.catalog.stand_ins import DEFAULT, STAND_INS, guess_class
from storyblender.ports import Embedder
from storyblender.reflection import Critique

SURE = 0.5
"""Least cosine for a class to be taken by likeness of meaning."""
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
        known = guess_class(view.phrase)
        if known is not None:
            return Recipe(source="stand_in", key=known.key, score=HONEST, reason=f"a kind of {known.name}")
        query = self._model.embed([view.phrase])[0]
        words, vectors = self._words
        best = int(np.argmax(vectors @ query))
        cosine = float(vectors[best] @ query)
        key = words[best][0] if cosine >= SURE else DEFAULT
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
