"""The Dimension Estimator played by a language model: the surest dimension of every asset of a call, in one request.

Models of the user are shown from three sides; the answer gives one dimension, the model's proportions the others.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from typing import Any, Final

from pydantic import Field

from storyblender.agents.asking import Asker, LanguagePolicy, Notes
from storyblender.agents.layout_artist.dimension_estimator import (
    DimensionEstimatorCritic,
    DimensionEstimatorView,
    RulesDimensionEstimator,
    Side,
    fit_to_room,
)
from storyblender.agents.side_views import side_sheet
from storyblender.catalog.props import PROPS
from storyblender.catalog.props.prop_names import prop_of
from storyblender.errors import NoAnswer
from storyblender.memory.asset_sheet import Asset, AssetDimension
from storyblender.memory.base import Identifier
from storyblender.memory.measure import AssetViews
from storyblender.ports import Answerer, Embedder
from storyblender.reflection import Policy

Dimensions = dict[str, AssetDimension]
_SHEET: Final = {"front: width, height": "front", "top: width, depth": "top", "left: depth, height": "left"}
"""Sides on the picture of a model by their labels (paper, appendix: prompt of the Dimension Estimator)."""
_PICTURES = 16
"""Most pictures in a request; further models are known by their proportions only."""


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
        pictures=lambda view: tuple(side_sheet(views, _SHEET, name) for name, views in _drawn(view).items()),
        settled=lambda view: None if _open(view) else rules.propose(view),
    )


def _open(view: DimensionEstimatorView) -> dict[str, Asset]:
    """Return the assets by id whose size the script does not state; models of the user as large as their files are."""
    return {
        each.asset_id: _measured(each, view)
        for each in view.assets
        if each.stated_size.measure is None and ((look := each.decided_look) is None or look.stature is None)
    }


def _measured(asset: Asset, view: DimensionEstimatorView) -> Asset:
    """Return an asset with the dimensions of its model, if it is one of the user that can be drawn."""
    made, views = asset.canonical, _views(asset, view)
    if made is None or views is None:
        return asset
    return asset.model_copy(update={"canonical": made.model_copy(update={"dimensions": views.dimensions})})


def _views(asset: Asset, view: DimensionEstimatorView) -> AssetViews | None:
    """Return pictures of an asset, if it is a model of the user that can be drawn."""
    if asset.canonical is None or asset.canonical.source != "file":
        return None
    try:
        return view.draw(asset)
    except NoAnswer:
        return None


def _drawn(view: DimensionEstimatorView) -> dict[str, AssetViews]:
    """Return the pictures of the models of the user, by asset id."""
    wanted = _open(view)
    found = ((each.asset_id, _views(each, view)) for each in view.assets if each.asset_id in wanted)
    return dict(itertools.islice(((name, views) for name, views in found if views is not None), _PICTURES))


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
        each.id: fit_to_room(_dimension(each, wanted[each.id]), wanted[each.id], view.rooms.get(each.id))
        for each in answer.sizes
    }


def _dimension(size: SizeNotes, asset: Asset) -> AssetDimension:
    """Return the size of an asset; of a model of the user by the longer of width and depth, whichever was answered.

    The engine takes the longer for either, because it does not know which side of a file is the front.
    """
    made = asset.canonical
    if size.side == "height" or made is None or made.source != "file":
        return AssetDimension(**{size.side: size.metres})
    width, depth, _ = made.dimensions
    answered = width if size.side == "width" else depth
    longer = "width" if width >= depth else "depth"
    return AssetDimension(**{longer: round(size.metres * max(width, depth) / max(answered, 1e-6), 3)})


def _shown(view: DimensionEstimatorView, usual: Dimensions) -> dict[str, Any]:
    """Return what the model is shown of the assets; ``usual`` are the sizes of the rules in metres."""
    drawn = _drawn(view)
    return {
        "assets": [_shown_asset(asset, usual[name], view, name in drawn) for name, asset in _open(view).items()],
    }


def _shown_asset(asset: Asset, usual: AssetDimension, view: DimensionEstimatorView, drawn: bool) -> dict[str, Any]:
    made, look, room = asset.canonical, asset.decided_look, view.rooms.get(asset.asset_id)
    told: dict[str, Any] = {"id": asset.asset_id, "is": asset.name, "description": asset.description}
    if look is not None:
        told |= {"person": True, "gender": look.gender, "age": look.age, "species": look.species}
    elif made is not None:
        told |= {"model": made.key, "shape": [round(side, 3) for side in made.dimensions]}
    told |= {
        "said_to_be": asset.stated_size.word,
        "toy": asset.stated_size.toy,
        "in_a_hand": "handled" in asset.tags,
        "picture": asset.asset_id if drawn else None,
        "room": [round(side, 1) for side in room] if room is not None else None,
    }
    shown = {name: value for name, value in told.items() if value}
    unknown = made is not None and made.source == "file" and prop_of(asset) not in PROPS
    return shown if unknown else shown | {"usual": usual.model_dump(exclude_none=True)}
