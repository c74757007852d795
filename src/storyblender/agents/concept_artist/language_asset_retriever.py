"""The Asset Retriever and Generator played by a language model: it chooses among what the asset sources offer.

One request for an object: the candidates by name and by meaning, and the stand-in that the rules would take. If none
fits, the model may give other words, which are searched once. What it then takes under the threshold stands in.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any

from pydantic import Field

from storyblender.agents.asking import Asker, Notes
from storyblender.agents.concept_artist.asset_retriever_view import RETRIEVAL_THRESHOLD, AssetRetrieverView
from storyblender.agents.concept_artist.generator import LIKE, RulesAssetGenerator, prop_recipe
from storyblender.agents.concept_artist.retriever import RulesAssetRetriever
from storyblender.agents.nearest import nearest_entries
from storyblender.agents.vision_critic import SEEN
from storyblender.catalog.props import PROPS
from storyblender.catalog.recipe import HEAD, Recipe
from storyblender.ports import Answerer, AssetSource, Embedder
from storyblender.reflection import Critique

_OFFERED = 10
"""Most candidates in one request."""


class ChoiceNotes(Notes):
    """What an object is made from."""

    choice: int | None = None
    """`number` of the candidate that looks most like the object; leave it out if none does."""
    fit: int = Field(default=1, ge=1, le=10)
    """10: it is this thing. 7: people take it for this thing. Under 7: it only stands in for it."""
    keywords: Annotated[str, Field(max_length=80)] = ""
    """Only if nothing fits: another plain noun for the object, to search with once more."""


@dataclass(frozen=True)
class LanguageAssetRetriever:
    """The Asset Retriever and Generator played by a model.

    Attributes:
        asker: Asks for the choice.
        retriever: Searches the sources.
        generator: Knows a stand-in for everything.
        embedder: Likeness of meaning, where few things have such a name.
    """

    asker: Asker[ChoiceNotes]
    retriever: RulesAssetRetriever
    generator: RulesAssetGenerator
    embedder: Callable[[], Embedder]
    _refused: dict[str, dict[str, str]] = field(default_factory=dict)
    """What a vision critic refused, by asset: what is wrong with it by the recipe's key."""
    _searched: dict[str, str] = field(default_factory=dict)
    """The other words that were searched for, by asset."""

    def propose(self, view: AssetRetrieverView) -> Recipe:
        """Return the model's choice. Raises NoAnswer or AnswerAwaited."""
        self._refused[view.asset.asset_id] = {}
        self._searched.pop(view.asset.asset_id, None)
        return self._choose(view)

    def refine(self, draft: Recipe, critique: Critique, view: AssetRetrieverView) -> Recipe:
        """Return the model's next choice if a vision critic refused the draft; else the draft: all was offered.

        Args:
            draft: The model's choice.
            critique: Its faults.
            view: The object.
        """
        seen = [fault.message for fault in critique.faults if fault.kind == SEEN]
        if not seen:
            return draft
        refused = self._refused.setdefault(view.asset.asset_id, {})
        refused[draft.key] = " ".join(seen)
        return self._choose(view.model_copy(update={"rejected": view.rejected | refused.keys()}))

    def _choose(self, view: AssetRetrieverView) -> Recipe:
        """Return what the model takes of all that is offered, and of what one search for other words adds to it."""
        searched = self._searched.get(view.asset.asset_id, "")
        offered = self._all_offered(view, searched)
        answer = self._asked(view, offered, searched)
        words = " ".join(answer.keywords.split())
        if words and not searched and answer.fit < RETRIEVAL_THRESHOLD:
            self._searched[view.asset.asset_id] = words
            offered = self._all_offered(view, words)
            answer = self._asked(view, offered, words)
        if answer.choice is None:
            return self.generator.propose(view).model_copy(update={"final": True})
        return _chosen(offered[answer.choice - 1], float(answer.fit))

    def _all_offered(self, view: AssetRetrieverView, searched: str) -> list[Recipe]:
        """Return the candidates under other words, if it was searched for any, then those under its own name."""
        found = self._offered(_called(view, searched), view) if searched else []
        keys = {each.key for each in found}
        return [*found, *(each for each in self._offered(view, view) if each.key not in keys)]

    def _offered(self, called: AssetRetrieverView, view: AssetRetrieverView) -> list[Recipe]:
        """Return the candidates for an object, and the stand-in of the rules; ``called`` may have another name."""
        found: dict[str, Recipe] = {}
        for each in self.retriever.candidates(called, by_meaning=True):
            found.setdefault(each.key, each)
        near, stand_in = [*found.values()][:_OFFERED], self.generator.propose(view)
        alike = nearest_entries(PROPS.values(), [called.phrase], self.embedder(), _OFFERED - len(near))
        near += [prop_recipe(view, each.key, LIKE, "alike") for each in alike if each.key not in found]
        near += [] if any(each.key == stand_in.key for each in near) else [stand_in]
        return [each for each in near if each.key not in view.rejected]

    def _asked(self, view: AssetRetrieverView, offered: Sequence[Recipe], searched: str) -> ChoiceNotes:
        """Return the model's choice; ``searched`` are the words of a second search."""

        def wrong(answer: ChoiceNotes) -> Iterator[str]:
            if answer.choice is not None and not 1 <= answer.choice <= len(offered):
                yield f"there is no candidate {answer.choice}; they are numbered 1 to {len(offered)}"
            if answer.choice is None and answer.fit >= RETRIEVAL_THRESHOLD:
                yield f"a fit of {answer.fit} needs a `choice`"

        refused = self._refused.get(view.asset.asset_id, {})
        seen = {"refused": [{"model": key, "because": why} for key, why in refused.items()]} if refused else {}
        return self.asker.ask(view.asset.asset_id, _shown(view, offered, searched) | seen, wrong)


def language_asset_retriever(
    answerer: Answerer, embedder: Callable[[], Embedder], sources: Sequence[AssetSource]
) -> LanguageAssetRetriever:
    """Return the Asset Retriever played by a model.

    Args:
        answerer: The model, or a person in its place.
        embedder: Likeness of meaning.
        sources: Where assets come from.
    """
    asker = Asker(answerer, "asset_retriever", ChoiceNotes)
    return LanguageAssetRetriever(asker, RulesAssetRetriever(sources), RulesAssetGenerator(embedder), embedder)


def _called(view: AssetRetrieverView, words: str) -> AssetRetrieverView:
    """Return the view of the object under another name."""
    told = f"{words}, {view.asset.description}" if view.kind == "animal" else view.asset.description
    return view.model_copy(update={"asset": view.asset.model_copy(update={"name": words, "description": told})})


def _chosen(recipe: Recipe, fit: float) -> Recipe:
    """Return the candidate that was chosen, with the model's score."""
    if fit < RETRIEVAL_THRESHOLD:
        return recipe.model_copy(update={"score": fit, "reason": "nearest of all", "final": True})
    chosen = {"score": fit, "reason": "chosen among all that is offered", "by_meaning": recipe.score < HEAD}
    return recipe.model_copy(update=chosen)


def _shown(view: AssetRetrieverView, offered: Sequence[Recipe], searched: str) -> dict[str, Any]:
    """Return what the model is shown of an object and its candidates; sizes are metres."""
    told = {
        "object": view.asset.name or view.asset.asset_id,
        "description": view.asset.description,
        "kind": view.kind,
        "in_a_hand": "handled" in view.asset.tags,
        "writing": view.asset.writing,
        "state": view.state,
        "place": view.place,
        "lines": view.lines,
        "also_searched_for": searched,
        "candidates": [_shown_candidate(number, each) for number, each in enumerate(offered, start=1)],
    }
    return {name: value for name, value in told.items() if value}


def _shown_candidate(number: int, recipe: Recipe) -> dict[str, Any]:
    if recipe.source == "file":
        told = recipe.provenance
        by = {"author": told.author} if told is not None and told.author else {}
        return {"number": number, "a_model_of_the_user": recipe.key, **by}
    entry = PROPS.get(recipe.key)
    if recipe.source == "stand_in" or entry is None:
        return {"number": number, "a_plain_shape_for": recipe.key.replace("_", " "), "size": recipe.dimensions}
    looks = entry.description or ", ".join(entry.tags[:5])
    told = {"is": entry.name, "looks": looks, "category": entry.category, "size": recipe.dimensions}
    return {"number": number, **told}
