"""The Dimension Estimator played by a language model: the surest dimension of every asset of a call, in one request."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from pydantic import Field

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.layout_artist.dimension_estimator import (
    DimensionEstimatorCritic,
    DimensionEstimatorView,
    RulesDimensionEstimator,
    Side,
    fit_to_room,
)
from storyblender.memory.asset_sheet import Asset, AssetDimension
from storyblender.memory.base import Identifier
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Policy

Dimensions = dict[str, AssetDimension]


class SizeNotes(Notes):
    """How large one asset really is."""

    id: Identifier
    side: Side
    """The one dimension you are surest of."""
    metres: float = Field(gt=0, le=60)


class DimensionNotes(Notes):
    """Sizes of assets; one that is left out keeps its `usual` size."""

    sizes: tuple[SizeNotes, ...] = ()


def language_dimension_estimator(
    answerer: Answerer, embedder: Callable[[], Embedder]
) -> Policy[DimensionEstimatorView, Dimensions]:
    """Return the Dimension Estimator played by a model; what the script measures is never asked about.

    Args:
        answerer: The model, or a person in its place.
        embedder: Not used: there is no long vocabulary to choose from.
    """
    rules = RulesDimensionEstimator()
    return LanguagePolicy(
        Asker(answerer, "dimension_estimator", DimensionNotes),
        show=lambda view: _shown(view, rules.propose(view)),
        draft_of=lambda answer, view: rules.propose(view) | _sized(answer, view),
        check=_wrong,
        subject=lambda view: "assets",
        mend=rules.refine,
        settled=lambda view: None if _open(view) else rules.propose(view),
    )


def _open(view: DimensionEstimatorView) -> dict[str, Asset]:
    """Return the assets by id whose size the script does not state."""
    return {
        each.asset_id: each
        for each in view.assets
        if each.stated_size.measure is None and (each.look is None or each.look.stature is None)
    }


def _wrong(answer: DimensionNotes, view: DimensionEstimatorView) -> Iterator[str]:
    """Yield assets that do not exist or are sized twice, and what the critic minds."""
    wanted, given = _open(view), [each.id for each in answer.sizes]
    for name in dict.fromkeys(given):
        if name not in wanted:
            yield f"{name!r} is not in `assets`; leave it out"
        if given.count(name) > 1:
            yield f"{name} has {given.count(name)} sizes; give the one you are surest of"
    stated = {each.id: AssetDimension(**{each.side: each.metres}) for each in answer.sizes}
    chosen = tuple(asset for name, asset in wanted.items() if name in stated)
    judged = DimensionEstimatorCritic().judge(stated, DimensionEstimatorView(chosen))
    yield from (fault.message for fault in judged.faults)


def _sized(answer: DimensionNotes, view: DimensionEstimatorView) -> Dimensions:
    """Return the sizes of the answer, none larger than the room."""
    wanted = _open(view)
    return {
        each.id: fit_to_room(AssetDimension(**{each.side: each.metres}), wanted[each.id], view.rooms.get(each.id))
        for each in answer.sizes
    }


def _shown(view: DimensionEstimatorView, usual: Dimensions) -> dict[str, Any]:
    """Return what the model is shown of the assets; ``usual`` are the sizes of the rules in metres."""
    return {
        "assets": [_shown_asset(asset, usual[name], view) for name, asset in _open(view).items()],
    }


def _shown_asset(asset: Asset, usual: AssetDimension, view: DimensionEstimatorView) -> dict[str, Any]:
    made, look, room = asset.canonical, asset.look, view.rooms.get(asset.asset_id)
    told: dict[str, Any] = {"id": asset.asset_id, "is": asset.name, "description": asset.description}
    if look is not None:
        told |= {"person": True, "gender": look.gender, "age": look.age, "species": look.species}
    elif made is not None:
        told |= {"model": made.key, "shape": [round(side, 3) for side in made.dimensions]}
    told |= {
        "said_to_be": asset.stated_size.word,
        "toy": asset.stated_size.toy,
        "in_a_hand": "handled" in asset.tags,
        "room": [round(side, 1) for side in room] if room is not None else None,
    }
    shown = {name: value for name, value in told.items() if value}
    return shown | {"usual": usual.model_dump(exclude_none=True)}
