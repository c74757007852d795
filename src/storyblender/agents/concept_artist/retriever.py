"""The Asset Retriever: chooses what a thing is made from among all that the asset sources offer."""

from __future__ import annotations

from collections.abc import Sequence

from storyblender.agents.concept_artist.asset_retriever_view import AssetRetrieverView
from storyblender.catalog.recipe import EXACT, HEAD, LEAST, Recipe
from storyblender.ports import AssetSource
from storyblender.reflection import Critique

_NOTHING = Recipe(source="catalog", key="gift", score=LEAST, reason="nothing is like it")


class RulesAssetRetriever:
    """The policy that takes the candidate with the highest score.

    Args:
        sources: Where assets come from; of equal candidates that of the earlier source is taken.
    """

    def __init__(self, sources: Sequence[AssetSource]) -> None:
        self._sources = sources

    def propose(self, view: AssetRetrieverView) -> Recipe:
        """Return the best match, whatever its score."""
        return self.search(view, 1)[0]

    def refine(self, draft: Recipe, critique: Critique, view: AssetRetrieverView) -> Recipe:
        """Return the next best match after ``draft``; no source grows by asking again.

        Args:
            draft: The match so far.
            critique: Not used.
            view: The object.
        """
        ranked = self.search(view, 6)
        place = next((i for i, recipe in enumerate(ranked) if recipe.key == draft.key), -1)
        return ranked[min(place + 1, len(ranked) - 1)]

    def search(self, view: AssetRetrieverView, count: int) -> tuple[Recipe, ...]:
        """Return the ``count`` best matches of all sources, best first; by meaning only where no name fits well.

        Args:
            view: The object.
            count: Most matches to return; if nothing is found, one with the lowest score is returned.
        """
        found = self.candidates(view, by_meaning=False, enough=count == 1)
        if all(recipe.score < HEAD for recipe in found):
            found = self.candidates(view, by_meaning=True)
        return tuple(found[:count]) or (_NOTHING,)

    def candidates(self, view: AssetRetrieverView, *, by_meaning: bool, enough: bool = False) -> list[Recipe]:
        """Return all that the sources offer, best first, without what could not be built or fetched.

        Args:
            view: The object, and the keys of recipes that were rejected for it.
            by_meaning: Also return what is only similar in meaning.
            enough: Ask no further source once one has the thing itself, which no other can better.
        """
        offered: list[Recipe] = []
        for source in self._sources:
            found = source.search(view, by_meaning=by_meaning)
            offered += [recipe for recipe in found if recipe.key not in view.rejected]
            if enough and any(recipe.score >= EXACT for recipe in offered):
                break
        return sorted(offered, key=lambda each: -each.score)
